//! Attributes of a drawn triangle.

use std::array::from_fn;

use embedded_graphics::pixelcolor::Gray8;
use fixel::mode::Exact;
use fixel::prelude::*;
use rand::Rng;

use support::random::cases;
use support::recorder::{Probe, record};

const SIZE: u32 = 64;

/// Twice the signed area, with y down: negative for counter-clockwise corners.
fn area(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

#[test]
fn attributes_over_z_are_linear_on_screen() {
    cases(256, |random| {
        // Corners are whole pixels from the middle, and distances are sixteenths. The coordinates in space are products
        // of these numbers and 1/64. The coordinates are exact in space and on the screen, so rounding moves no vertex.
        let screen: [[i32; 2]; 3] = from_fn(|_| from_fn(|_| random.random_range(-32..32)));
        let z: [i32; 3] = from_fn(|_| random.random_range(16..256));
        let values: [i32; 3] = from_fn(|_| random.random_range(-1_000_000..1_000_000));
        // x = sx·z/64 and y = −sy·z/64, in units of 2^-16. z is in units of 2^-4, and 2^(16 − 4 − 6) is 64.
        let positions: [Vec3; 3] = from_fn(|i| {
            Vec3::from_bits([
                screen[i][0] * z[i] * 64,
                -screen[i][1] * z[i] * 64,
                -z[i] * 4096,
            ])
        });
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
        let size = (SIZE, SIZE);
        let projection = Projection::from_focal_length(fx!(64), size, fx!(0.5), fx!(100)).unwrap();
        let mut pixels = vec![Gray8::new(0); (SIZE * SIZE) as usize];
        let mut canvas = Canvas::new(&mut pixels, SIZE, SIZE).unwrap();
        let both_sides = DrawOptions::new().with_cull(Cull::Nothing).with_mode(Exact);
        // Look up each vertex's value by the index of its position.
        let value = |corner: &Corner<'_>| {
            let positions = corner.primitive().positions();
            let at = positions.iter().position(|p| *p == corner.position());
            [values[at.unwrap()]]
        };
        let mvp = projection * Transform::IDENTITY;
        let probe = Probe {
            values: &value,
            color: None::<Gray8>,
        };
        let seen = record(probe, |recorder| {
            canvas.draw_with(&both_sides, &mesh, &mvp, recorder);
        });

        let corners = screen.map(|[x, y]| [f64::from(x) + 32.0, f64::from(y) + 32.0]);
        let whole = area(corners[0], corners[1], corners[2]);
        for seen in seen.seen {
            let [found] = seen.values;
            let p = seen.pixel.map(|at| f64::from(at) + 0.5);
            let opposite = |i: usize| area(corners[(i + 1) % 3], corners[(i + 2) % 3], p);
            let weights = [0, 1, 2].map(|i| opposite(i) / whole);
            let sum = |of: fn(f64, f64) -> f64| {
                (0..3)
                    .map(|i| weights[i] * of(f64::from(values[i]), f64::from(z[i])))
                    .sum::<f64>()
            };
            let expected = sum(|value, z| value / z) / sum(|_, z| 1.0 / z);
            // Values are rounded down. A million has 20 bits, and the reciprocal has 30.
            let error = (f64::from(found) + 0.5 - expected).abs();
            assert!(error <= 1.0, "{found} is not {expected}");
        }
    });
}
