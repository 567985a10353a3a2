//! Wide lines. The pixels of a line are compared with exact integers, and the shares of anti-aliased lines with f64.

use crate::bands::{CASES, Point, SIZE, counts, drawn, modeled, point};
use crate::lines;
use embedded_graphics::pixelcolor::{Gray8, GrayColor, Rgb565, RgbColor};
use fixel::canvas::{Add, Blending, Opacity, TestAndWrite};
use fixel::mode::Newton;
use fixel::num::Subpixel;
use fixel::prelude::*;
use fixel::shade::Translucent;
use fixel::view::{AsMvp, Perspective};
use fixel::{Drawn, Thing};
use rand::Rng;
use support::counter::{at_subpixel, pixel_projection};
use support::random::{Random, cases, within};
use support::recorder::Seen;
use support::reference::blending::over;
use support::reference::coverage::{Bounds, center, picture};
use support::reference::lines::share;

/// The pixels of edges drawn in bands of `rows` rows.
fn edges<B: Blending<Gray8>>(
    rows: u32,
    options: &DrawOptions<Newton, TestAndWrite, B>,
    edges: impl Thing<Gray8>,
    mvp: &impl AsMvp,
) -> Vec<Seen<1>> {
    drawn(rows, &|frame, recorder| {
        frame.draw_with(options, edges, mvp, recorder)
    })
}

/// A mesh of one edge.
fn line<'a>(ends: &'a [Vec3; 2], edge: &'a [[u16; 2]; 1]) -> Mesh<'a> {
    Mesh::new(ends, &[]).unwrap().with_edges(edge).unwrap()
}

/// Whether a pixel belongs to the wide line between two snapped ends. `half` of the width is in units of 1/256 pixel.
/// Along the longer axis, the pixel's center must lie between the ends, where the smaller end is included and the
/// greater end is not. Across, the center must lie at most `half` from the line, and less than `half` if it is above
/// the line or left of it. The result is computed in exact integers.
///
/// A line of width 1 is a hairline.
fn on_line([a, b]: [Point; 2], half: i64, pixel: [i32; 2]) -> bool {
    if half == 128 {
        return lines::on_line([a, b], false, pixel);
    }
    let [dx, dy] = [0, 1].map(|i| i64::from(b[i]) - i64::from(a[i]));
    let major = usize::from(dy.abs() > dx.abs());
    let minor = 1 - major;
    let (a, b) = if a[major] <= b[major] { (a, b) } else { (b, a) };
    let [along, across] = [major, minor].map(|axis| i64::from(pixel[axis]) * 256 + 128);
    let [start, end, from, to] = [a[major], b[major], a[minor], b[minor]].map(i64::from);
    if along < start || along >= end {
        return false;
    }
    let length = end - start;
    // The distance between the center and the line across, times the line's length.
    let distance = (across - from) * length - (along - start) * (to - from);
    -half * length < distance && distance <= half * length
}

/// A position ahead of the eye.
fn ahead(random: &mut Random) -> Vec3 {
    let ranges = [-5 << 16..5 << 16, -3 << 16..3 << 16, -20 << 16..-1 << 15];
    Vec3::from_bits(within(random, ranges))
}

/// Compares the depths and values of a smooth line with the depths and values of a plain line. The plain line has one
/// pixel in each step along the longer axis.
///
/// The two lines have different spans, so they have different rounding errors. For each line, the error is at most 2^21
/// · 34 · 1.5 / (2^30 / 128) + 4 units, or 16.7. The derivation is as in `lines_in_perspective_are_the_models`, where
/// ends can be farther apart. The rounding error of a depth is less than one step.
fn check_values(smooth: &[Seen<1>], [a, b]: [Point; 2], plain: &[Seen<1>]) {
    const UNITS: u32 = 33;
    let major = usize::from(a[0].abs_diff(b[0]) < a[1].abs_diff(b[1]));
    for plain in plain {
        let step = plain.pixel[major];
        for seen in smooth.iter().filter(|seen| seen.pixel[major] == step) {
            let apart = seen.values[0].abs_diff(plain.values[0]);
            assert!(apart <= UNITS, "{seen:?} beside {plain:?}");
            assert!(
                seen.depth.abs_diff(plain.depth) <= 1,
                "{seen:?} beside {plain:?}"
            );
        }
    }
}

/// Half of a random width of a line, in units of 1/256 pixel. The width is often one pixel or a few pixels.
fn half(random: &mut Random) -> i32 {
    match random.random_range(0..3) {
        0 => random.random_range(128..=8192),
        1 => 128,
        _ => random.random_range(128..600),
    }
}

/// The style of a line, from half of its width in units of 1/256 pixel.
fn width(half: i32) -> LineStyle {
    LineStyle::wide(Scalar::from_bits(half << 9)).unwrap()
}

fn perspective() -> Projection<Perspective> {
    Projection::from_focal_length(fx!(40), SIZE, fx!(0.25), fx!(32)).unwrap()
}

/// A wide line draws exactly the model's pixels, once each, from either end, in bands and in a frame. Each pixel has
/// the values of the thin line beside it. A line of width 1 is the same as a thin line.
#[test]
fn wide_lines_are_the_models() {
    cases(CASES, |random| {
        let (ends, half) = ([point(random, SIZE), point(random, SIZE)], half(random));
        let rows = random.random_range(1..40);
        let mvp = pixel_projection(SIZE);
        let positions = ends.map(at_subpixel);
        let width = width(half);
        let model = modeled(&|pixel| on_line(ends, half.into(), pixel));
        let mut first = None;
        for edge in [[[0, 1]], [[1, 0]]] {
            let mesh = line(&positions, &edge);
            let options = DrawOptions::new();
            let wide = edges(SIZE.1, &options, mesh.edges(width), &mvp);
            assert_eq!(
                picture(&counts(&wide), SIZE.0),
                picture(&model, SIZE.0),
                "{ends:?}, {half}"
            );
            let bands = edges(rows, &options, mesh.edges(width), &mvp);
            assert_eq!(bands, wide, "{ends:?}, {half}, {rows}");
            let thin = edges(SIZE.1, &options, mesh.edges(LineStyle::HAIRLINE), &mvp);
            if half == 128 {
                assert_eq!(thin, wide, "{ends:?}");
            }
            let [dx, dy] = [0, 1].map(|axis| ends[0][axis].abs_diff(ends[1][axis]));
            let major = usize::from(dy > dx);
            for thin in thin {
                let mut run = wide
                    .iter()
                    .filter(|seen| seen.pixel[major] == thin.pixel[major]);
                assert!(
                    run.all(|seen| (seen.values, seen.depth) == (thin.values, thin.depth)),
                    "{ends:?}, {half}: beside {thin:?}"
                );
            }
            assert_eq!(
                first.get_or_insert(wide.len()),
                &wide.len(),
                "{ends:?}, {half}"
            );
        }
    });
}

/// An anti-aliased line, white on black, is the model's line. Every pixel's share has an error of at most 1.3/256, so
/// its level has an error of at most 1.3 steps plus half a step. The line is the same from either end and in bands. On
/// Rgb565, shares are rounded to 32nds, which adds an error of 1/64 of 31 or 63 steps.
///
/// Each pixel with a share above 0 is drawn once. A pixel beside a plain line has the values of the plain line's pixel
/// there. A pixel beyond the ends has the values of the end.
#[test]
fn smooth_lines_are_the_models() {
    cases(CASES, |random| {
        let (ends, half) = ([point(random, SIZE), point(random, SIZE)], half(random));
        let rows = random.random_range(1..40);
        let mvp = pixel_projection(SIZE);
        let positions = ends.map(at_subpixel);
        let mesh = line(&positions, &[[0, 1]]);
        let width = width(half);
        let options = DrawOptions::new();
        let gray = |rows: u32, mesh: &Mesh<'_>| {
            let mut colors = vec![Gray8::BLACK; (SIZE.0 * SIZE.1) as usize];
            for (first, rows) in (0..)
                .step_by(rows as usize)
                .zip(colors.chunks_mut((rows * SIZE.0) as usize))
            {
                let mut band = Canvas::band(rows, SIZE.0, SIZE.1, first).unwrap();
                band.draw_with(
                    &options,
                    mesh.edges(width.smooth()),
                    &mvp,
                    &Flat::new(Gray8::WHITE),
                );
            }
            colors
        };
        let found = gray(SIZE.1, &mesh);
        assert_eq!(&gray(rows, &mesh), &found, "bands");
        let turned = [[1, 0]];
        assert_eq!(
            &gray(SIZE.1, &mesh.with_edges(&turned).unwrap()),
            &found,
            "the other direction"
        );

        let mut colors = vec![Rgb565::BLACK; (SIZE.0 * SIZE.1) as usize];
        let mut canvas = Canvas::new(&mut colors, SIZE.0, SIZE.1).unwrap();
        canvas.draw_with(
            &options,
            mesh.edges(width.smooth()),
            &mvp,
            &Flat::new(Rgb565::WHITE),
        );

        let float = |[x, y]: Point| [x, y].map(|at| f64::from(at) / 256.);
        let (screen, pixels) = (ends.map(float), f64::from(half) / 128.);
        for ((pixel, gray), color) in Bounds::new(SIZE.0, SIZE.1)
            .pixels()
            .zip(&found)
            .zip(&colors)
        {
            let share = share(screen, pixels, center(pixel));
            let room = |steps: f64, extra: f64| steps * (1.3 / 256. + extra) + 0.5;
            let level = f64::from(gray.luma());
            assert!(
                (level - share * 255.).abs() <= room(255., 0.),
                "{pixel:?}: {level} instead of {}",
                share * 255.
            );
            for (level, steps) in [(color.r(), 31.), (color.g(), 63.), (color.b(), 31.)] {
                let level = f64::from(level);
                assert!(
                    (level - share * steps).abs() <= room(steps, 1. / 64.),
                    "{pixel:?}: {level} instead of {}",
                    share * steps
                );
            }
        }

        let smooth = edges(SIZE.1, &options, mesh.edges(width.smooth()), &mvp);
        check_values(
            &smooth,
            ends,
            &edges(SIZE.1, &options, mesh.edges(LineStyle::HAIRLINE), &mvp),
        );
        assert!(
            counts(&smooth).iter().all(|&count| count <= 1),
            "{ends:?}, {half}"
        );
        for seen in smooth.iter().filter(|seen| {
            let major =
                usize::from(ends[0][0].abs_diff(ends[1][0]) < ends[0][1].abs_diff(ends[1][1]));
            let at = seen.pixel[major] * 256 + 128;
            at < ends[0][major].min(ends[1][major]) || at > ends[0][major].max(ends[1][major])
        }) {
            assert!(
                positions.iter().any(|end| seen.values == [end.x.to_bits()]),
                "beyond the ends: {seen:?}"
            );
        }
    });
}

/// In perspective, wide and smooth lines have the same bits in bands as in a frame.
#[test]
fn bands_of_lines_in_perspective_equal_the_frame() {
    cases(CASES, |random| {
        let positions = [ahead(random), ahead(random)];
        let width = width(random.random_range(128..=8192));
        let rows = random.random_range(1..40);
        let mesh = line(&positions, &[[0, 1]]);
        let mvp = perspective();
        let options = DrawOptions::new();
        let wide = |rows| edges(rows, &options, mesh.edges(width), &mvp);
        assert_eq!(wide(rows), wide(SIZE.1), "{positions:?}, {width:?}, {rows}");
        let smooth = |rows| edges(rows, &options, mesh.edges(width.smooth()), &mvp);
        assert_eq!(
            smooth(rows),
            smooth(SIZE.1),
            "{positions:?}, {width:?}, {rows}"
        );
    });
}

/// In perspective, too, the pixels of a smooth line beside a plain line have the depths and values of the plain line.
#[test]
fn smooth_lines_have_the_values_of_plain_ones() {
    cases(CASES, |random| {
        let positions = [ahead(random), ahead(random)];
        let smooth = width(random.random_range(128..600)).smooth();
        let mesh = line(&positions, &[[0, 1]]);
        let mvp = perspective();
        let plain = DrawOptions::new();
        let canvas_ends = |mvp: &Projection<_>| {
            let screen = Viewport::new(0, 0, SIZE.0, SIZE.1).unwrap();
            let end = |at: usize| {
                screen
                    .project(positions[at], mvp)
                    .map(|at| [at.x, at.y].map(Subpixel::to_bits))
            };
            Some([end(0)?, end(1)?])
        };
        // Skip lines with clipped ends, because only the crate knows where the new ends are on the screen.
        let Some(ends) = canvas_ends(&mvp) else {
            return;
        };
        let thin = edges(SIZE.1, &plain, mesh.edges(LineStyle::HAIRLINE), &mvp);
        check_values(
            &edges(SIZE.1, &plain, mesh.edges(smooth), &mvp),
            ends,
            &thin,
        );
        // Blending changes neither depths nor values.
        let glass = plain.with_blending(Opacity(random.random()));
        check_values(
            &edges(SIZE.1, &glass, mesh.edges(smooth), &mvp),
            ends,
            &thin,
        );
        let light = plain.with_blending(Add);
        check_values(
            &edges(SIZE.1, &light, mesh.edges(smooth), &mvp),
            ends,
            &thin,
        );
    });
}

/// An outline of width 1 is the thin outline. A smooth outline covers the same pixels, and a wide outline has more
/// pixels.
#[test]
fn wide_outlines_widen_the_thin_outline() {
    static CAN: Mesh = shape!(cylinder(16));
    static RIMS: Outline = outline!(CAN, deg!(30));
    let projection = Projection::perspective(deg!(60), SIZE, fx!(0.5), fx!(32)).unwrap();
    let camera = Camera::look_at(vec3!(1, 2, 3), Vec3::ZERO, Vec3::Y).unwrap();
    let mvp = projection * camera;
    let thin = drawn(SIZE.1, &|frame, recorder| {
        frame.draw(CAN.outline(&RIMS, LineStyle::HAIRLINE), &mvp, recorder)
    });
    let wide = |width| {
        let wide = LineStyle::wide(width).unwrap();
        drawn(SIZE.1, &|frame, recorder| {
            frame.draw(CAN.outline(&RIMS, wide), &mvp, recorder)
        })
    };
    assert_eq!(wide(fx!(1)), thin);
    // The center of each pixel of a plain line is within half a pixel of the line, so a smooth line draws it, too.
    let smooth = LineStyle::HAIRLINE.smooth();
    let smooth = drawn(SIZE.1, &|frame, recorder| {
        frame.draw(CAN.outline(&RIMS, smooth), &mvp, recorder)
    });
    let smooth = counts(&smooth);
    assert!(
        counts(&thin)
            .iter()
            .zip(smooth)
            .all(|(&thin, smooth)| thin == 0 || smooth > 0)
    );
    let pixels = |seen: &[Seen<1>]| counts(seen).iter().filter(|&&count| count > 0).count();
    let (one, three) = (pixels(&thin), pixels(&wide(fx!(3))));
    assert!(
        one > 60 && three > 2 * one,
        "{one} pixels at width 1, {three} at width 3"
    );
}

/// Draws lines in a way of its own.
type Draw<'d> = &'d dyn Fn(&mut Canvas<'_, Gray8>) -> Drawn;

/// A smooth line mixes the background with the blended color by the share of each pixel. The color may have an opacity,
/// and the draw call, too.
#[test]
fn blended_lines_are_the_models() {
    let mut partly = 0;
    cases(CASES, |random| {
        let (ends, half) = ([point(random, SIZE), point(random, SIZE)], half(random));
        let [above, below, opacity, second]: [u8; 4] = random.random();
        let positions = ends.map(at_subpixel);
        let (mesh, width) = (line(&positions, &[[0, 1]]), width(half));
        let (screen, pixels) = (
            ends.map(|end: Point| end.map(|at| f64::from(at) / 256.)),
            f64::from(half) / 128.,
        );
        let plain = Flat::new(Gray8::new(above));
        let glass = plain.map(|_, color| Some(Translucent { color, opacity }));
        let options = DrawOptions::new();
        let by_call = options.with_blending(Opacity(second));
        let lines = mesh.edges(width.smooth());
        let mvp = pixel_projection(SIZE);
        let [first, second] = [opacity, second].map(|opacity| f64::from(opacity) / 255.);
        let drawings: [(&str, Draw<'_>, f64); 3] = [
            (
                "a draw call's opacity",
                &|canvas| canvas.draw_with(&by_call, lines, &mvp, &plain),
                second,
            ),
            (
                "a color's opacity",
                &|canvas| canvas.draw_with(&options, lines, &mvp, &glass),
                first,
            ),
            (
                "both opacities",
                &|canvas| canvas.draw_with(&by_call, lines, &mvp, &glass),
                first * second,
            ),
        ];
        for (what, draw, opacity) in drawings {
            let mut colors = vec![Gray8::new(below); (SIZE.0 * SIZE.1) as usize];
            let mut canvas = Canvas::new(&mut colors, SIZE.0, SIZE.1).unwrap();
            draw(&mut canvas);
            for (pixel, color) in Bounds::new(SIZE.0, SIZE.1).pixels().zip(&colors) {
                let share = share(screen, pixels, center(pixel));
                let [above, below] = [above, below].map(f64::from);
                let exact = over(over(above, below, opacity), below, share);
                // The product of both opacities has an error of 4 · 2^-16, and the share has an error of 1.3/256. Both
                // errors are multiplied by the difference of the colors. Two roundings add a step.
                let room = (above - below).abs() * (4. / 65_536. + 1.3 / 256.) + 1.;
                assert!(
                    (f64::from(color.luma()) - exact).abs() <= room,
                    "{what}, {pixel:?}: {color:?} instead of {exact}"
                );
                partly += u32::from(share > 0. && share < 1.);
            }
        }
    });
    assert!(partly > 30 * CASES, "{partly}");
}

/// A line beside the canvas can have pixels in the canvas. If it has pixels there, the bounds of its mesh, widened by
/// the line's reach, must be in view.
#[test]
fn lines_that_reach_into_a_band_are_in_view() {
    let (mut has_pixels, mut beside) = (0, 0);
    cases(CASES, |random| {
        let [a, b] = [0, 1].map(|_| within(random, [-12_000..35_000, -12_000..22_000]));
        // A line of up to ten pixels, beside the picture or in it.
        let ends = [a, [a[0] + b[0] / 20, a[1] + b[1] / 20]].map(at_subpixel);
        let first = random.random_range(0..30);
        let line = line(&ends, &[[0, 1]]);
        let width = width(half(random));
        let mut colors = [Gray8::BLACK; 10 * SIZE.0 as usize];
        let mut band = Canvas::band(&mut colors, SIZE.0, SIZE.1, first).unwrap();
        let (mvp, pen, thin) = (
            pixel_projection(SIZE),
            Flat::new(Gray8::WHITE),
            DrawOptions::new(),
        );
        band.draw(line.edges(width), &mvp, &pen);
        band.draw(line.edges(width.smooth()), &mvp, &pen);
        let is_drawn = band.pixels().any(|pixel| pixel != Gray8::BLACK);
        let bounds = line.bounds();
        if is_drawn {
            // In this projection, a unit is a pixel. A smooth line reaches half a pixel farther than half its width.
            let reach = (width.width() + fx!(1)) / 2;
            let reach = Vec3::new(reach, reach, fx!(0));
            let (least, most) = (bounds.least - reach, bounds.most + reach);
            let reached = bounds.with(least).with(most);
            assert!(band.is_in_view(&thin, &reached, &mvp), "{ends:?} {width:?}");
            has_pixels += 1;
            beside += u32::from(!band.is_in_view(&thin, &bounds, &mvp));
        }
    });
    assert!(
        beside > 5 && has_pixels > beside,
        "{beside} of {has_pixels}"
    );
}
