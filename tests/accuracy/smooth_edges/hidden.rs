//! Hidden edges change nothing.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use rand::Rng;
use rand::seq::IndexedRandom;
use support::counter::BOTH_SIDES;
use support::random::{cases, sampled};

use super::{BALL, BOX, CREASES_OF_BOX, Frame, GROUND, Noise, OF_BALL, OF_RING, RING, angle};

/// Draws before and after smoothing on a canvas of 64x48 pixels over this pattern; returns both pictures.
fn before_and_after<K: ProjectionKind>(
    draw: &dyn Fn(&mut Frame<'_, Rgb888>),
    smooth: (&DrawOptions, &Mesh, &Outline, &Mvp<K>),
) -> [Vec<Rgb888>; 2] {
    let (options, mesh, outline, mvp) = smooth;
    let mut colors = vec![Rgb888::BLACK; (64 * 48) as usize];
    let mut depths = vec![0; colors.len()];
    let canvas = Canvas::new(&mut colors, 64, 48).unwrap();
    let mut canvas = canvas.with_depth(&mut depths).unwrap();
    draw(&mut canvas);
    let before = canvas.pixels().collect();
    canvas.smooth_edges(options, mesh, outline, mvp);
    [before, canvas.pixels().collect()]
}

/// The wall is 2 away, and every point of the bodies is at least 2.97 away: 1/2 − 1/2.97 = 0.163 of the depths' range
/// lies between them. The bias is two units and at most twice the range of depths of a face. No face is deeper than its
/// body, which is 0.66 deep: 2 · (1/2.97 − 1/3.63) = 0.122 of the range.
#[test]
fn a_wall_in_front_keeps_its_pixels() {
    let [mut hidden, mut smoothed] = [0; 2];
    let projection = Projection::perspective(deg!(50), (4, 3), fx!(1), fx!(20)).unwrap();
    let options = DrawOptions::new();
    cases(sampled(2000), |random| {
        let bodies: [(&Mesh, &Outline); 3] = [
            (&BOX, &CREASES_OF_BOX),
            (&RING, &OF_RING),
            (&BALL, &OF_BALL),
        ];
        let &(mesh, outline) = bodies.choose(random).unwrap();
        let scalar = |number: f64| Scalar::try_from(number).unwrap();
        let [x, y] = [1.5, 1.].map(|reach| random.random_range(-reach..reach));
        let model = Transform::translate(Vec3::new(
            scalar(x),
            scalar(y),
            scalar(-random.random_range(3.3..4.7)),
        )) * Transform::rotate_x(angle(random))
            * Transform::rotate_y(angle(random))
            * Transform::scale(fx!(0.25));
        let mvp = projection * model;
        // The wall's border has any slope.
        let wall = projection
            * Transform::translate(vec3!(0, 0, -2))
            * Transform::rotate_z(angle(random))
            * Transform::translate(vec3!(3, 0, 0))
            * Transform::rotate_x(deg!(90))
            * Transform::scale(fx!(3));
        let draw = |with_wall: bool| {
            move |canvas: &mut Frame<'_, Rgb888>| {
                canvas.draw_with(&options, mesh, &mvp, &Noise(1));
                if with_wall {
                    canvas.draw_with(&BOTH_SIDES, &GROUND, &wall, &Noise(2));
                }
            }
        };
        let [before, after] = before_and_after(&draw(true), (&options, mesh, outline, &mvp));
        let [bare, bare_after] = before_and_after(&draw(false), (&options, mesh, outline, &mvp));
        for at in 0..before.len() {
            let is_wall = before[at] != bare[at];
            if is_wall {
                assert_eq!(before[at], after[at], "a pixel of the wall has changed");
                hidden += u32::from(bare[at] != bare_after[at]);
            } else {
                // Away from the wall, the wall changes nothing.
                let around = [at.wrapping_sub(64), at.wrapping_sub(1), at + 1, at + 64];
                let is_beside = around.iter().any(|&at| before.get(at) != bare.get(at));
                assert!(is_beside || after[at] == bare_after[at]);
                smoothed += u32::from(before[at] != after[at]);
            }
        }
    });
    assert!(hidden > 2000 && smoothed > 2000, "{hidden} and {smoothed}");
}
