//! Long straight edges, compared with the exact share of each pixel.

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::prelude::*;
use rand::Rng;
use rand::seq::IndexedRandom;
use support::counter::{BOTH_SIDES, at_subpixel, pixel_projection};
use support::random::{Random, cases, sampled};
use support::reference::coverage::{Bounds, area2_f64, share_beside};
use support::spread::Spread;

/// A triangle, one side of which is a long line through the frame; its other sides are far outside the frame. Returns
/// its corners in 24.8; the line goes from the first to the second.
fn long_edge(random: &mut Random, size: (u32, u32)) -> [[i32; 2]; 3] {
    let middle = [size.0, size.1].map(|side| f64::from(side) / 2.);
    let turn = random.random_range(0.0..std::f64::consts::TAU);
    let (sin, cos) = match random.random_range(0..4) {
        0 => *[(0., 1.), (1., 0.), (0., -1.), (-1., 0.)]
            .choose(random)
            .unwrap(),
        1 => {
            let diagonal = std::f64::consts::FRAC_1_SQRT_2;
            *[(1., 1.), (1., -1.), (-1., 1.), (-1., -1.)]
                .choose(random)
                .map(|(sin, cos)| (sin * diagonal, cos * diagonal))
                .as_ref()
                .unwrap()
        }
        _ => turn.sin_cos(),
    };
    let through = middle.map(|middle| middle + random.random_range(-0.9..0.9) * middle);
    // Whole numbers of quarter pixels make lines through pixel centers.
    let grain = *[1., 64., 128.].choose(random).unwrap();
    let at = |along: f64, aside: f64| {
        let place = [
            through[0] + along * cos - aside * sin,
            through[1] + along * sin + aside * cos,
        ];
        place.map(|x| ((x * 256. / grain).round() * grain) as i32)
    };
    let [before, after] = [(); 2].map(|()| random.random_range(200.0..1990.));
    [at(-before, 0.), at(after, 0.), at(0., 1500.)]
}

const WIDE: (u32, u32) = (72, 56);

/// Smooths a long edge between two colors, on a canvas with or without depth, where the triangle's depth changes by up
/// to the whole range. Returns the pixels' shares of the triangle, and the exact shares.
fn smoothed_edge(random: &mut Random, has_depth: bool) -> Vec<[f64; 2]> {
    let corners = long_edge(random, WIDE);
    let positions = corners.map(|corner| {
        let [x, y, _] = at_subpixel(corner).to_bits();
        Vec3::from_bits([x, y, random.random_range(-65_000..65_000)])
    });
    let faces = [[0, 1, 2]];
    let mesh = Mesh::new(&positions, &faces).unwrap();
    let mut room = [[0; 4]; 3];
    let outline = Outline::build(&mesh, deg!(180), &mut room).unwrap();
    let mvp = pixel_projection(WIDE);
    let white = Flat::new(Gray8::WHITE);
    let mut colors = vec![Gray8::BLACK; (WIDE.0 * WIDE.1) as usize];
    let mut depths = vec![0; colors.len()];
    let mut canvas = Canvas::new(&mut colors, WIDE.0, WIDE.1).unwrap();
    if has_depth {
        let mut canvas = canvas.with_depth(&mut depths).unwrap();
        canvas.draw_with(&BOTH_SIDES, &mesh, &mvp, &white);
        canvas.smooth_edges(&BOTH_SIDES, &mesh, &outline, &mvp);
    } else {
        canvas.draw_with(&BOTH_SIDES, &mesh, &mvp, &white);
        canvas.smooth_edges(&BOTH_SIDES, &mesh, &outline, &mvp);
    }
    let [a, b, c] = corners.map(|corner| corner.map(|x| f64::from(x) / 256.));
    let is_turned = area2_f64(&[a, b, c]) < 0.;
    let line = if is_turned { [b, a] } else { [a, b] };
    let pixels = Bounds::new(WIDE.0, WIDE.1).pixels();
    // A pixel at the frame's border has no neighbor on the other side of the edge.
    let is_inner = |[x, y]: [i32; 2]| {
        let [right, bottom] = [WIDE.0, WIDE.1].map(|side| side.cast_signed() - 1);
        (1..right).contains(&x) && (1..bottom).contains(&y)
    };
    pixels
        .zip(&colors)
        .filter(|(pixel, _)| is_inner(*pixel))
        .map(|(pixel, color)| [f64::from(color.luma()) / 255., share_beside(line, pixel)])
        .collect()
}

/// Each pixel of a long edge is within 3/256 of the exact share, plus half a step of `Gray8`. In 256ths of a pixel:
///
/// - The distance between the edge and a center is rounded down, and the reciprocal of the edge's length, too. The
///   distance is too small by up to 1 + 2⁻¹⁰ · 256, so one pixel's share is too large by up to 1.25, and its neighbor's
///   share is too small by the same amount.
/// - The slope s is rounded down by up to 1. The area u²/(2s), where u = (1 + s)/2 − d, changes by up to 1/8 of that.
/// - The slope's reciprocal is too small by a part of up to s/2¹⁶ ≤ 2⁻⁸, so the area, at most 128, by up to 0.5.
/// - The area is rounded down, by up to 1.
///
/// The sum is between −2.9 and 1.3. Measured: 1.97, with half a step. No depth must hide a part of an edge.
#[test]
fn long_edges_have_the_exact_shares() {
    let allowed = 3. / 256. + 0.5 / 255.;
    for has_depth in [false, true] {
        let mut spread = Spread::default();
        cases(sampled(8000), |random| {
            let shares = smoothed_edge(random, has_depth);
            for (at, [share, exact]) in shares.into_iter().enumerate() {
                let error = (share - exact).abs();
                assert!(error <= allowed, "share {share}, not {exact}");
                if exact > 0. && exact < 1. {
                    spread.add(error * 256., at);
                }
            }
        });
        println!("{}", spread.line("shares beside long edges", "256ths"));
    }
}
