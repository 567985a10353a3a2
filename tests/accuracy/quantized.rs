//! Attributes stored in 8 and 16 bits, compared with the same attributes before rounding.

use std::cell::RefCell;

use embedded_graphics::pixelcolor::Gray8;
use fixel::mesh::flash::{Small, normals_of_8, quantized_8, quantized_16};
use fixel::prelude::*;
use rand::Rng;

use support::random::{Random, cases};
use support::recorder::Probe;

/// Three normals and three texture coordinates.
type Attributes = ([Vec3; 3], [Vec2; 3]);

/// The attributes that a shader sees.
fn seen(normals: &[Vec3; 3], uvs: Small<'_, Vec2>) -> Attributes {
    let positions = [vec3!(-1, -1, -2), vec3!(1, -1, -2), vec3!(0, 1, -2)];
    let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
    let normals = normals_of_8::<3>(normals);
    let normals = Small::normals(&normals);
    let mesh = mesh.with_quantized_attributes((&normals, &[]), (&uvs, &[]));
    let projection = Projection::perspective(deg!(60), (4, 3), fx!(0.1), fx!(100)).unwrap();
    let mut pixels = [Gray8::new(0); 12];
    let mut canvas = Canvas::new(&mut pixels, 4, 3).unwrap();
    let corners = RefCell::new(Vec::new());
    let probe = Probe::<_, Gray8> {
        values: &|corner| {
            corners.borrow_mut().push((corner.normal(), corner.uv()));
            [0; 1]
        },
        color: None,
    };
    canvas.draw(&mesh, &projection, &probe);
    let corners: [(Vec3, Vec2); 3] = corners.into_inner().try_into().unwrap();
    (
        corners.map(|corner| corner.0),
        corners.map(|corner| corner.1),
    )
}

fn bits(random: &mut Random) -> i32 {
    match random.random_range(0..3) {
        0 => i32::MIN,
        1 => i32::MAX,
        _ => random.random::<i32>() >> random.random_range(0..32),
    }
}

/// The angle between two vectors in degrees, from its sine and cosine.
fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let cross = [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ];
    let dot: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
    cross
        .iter()
        .map(|x| x * x)
        .sum::<f64>()
        .sqrt()
        .atan2(dot)
        .to_degrees()
}

#[test]
fn errors_of_rounded_attributes_are_within_the_bounds() {
    cases(256, |random| {
        let normals = [(); 3].map(|()| Vec3::from_bits([(); 3].map(|()| bits(random))));
        let uvs = [(); 3].map(|()| Vec2::from_bits([(); 2].map(|()| bits(random))));
        let (bytes, grid) = quantized_8::<3>(&uvs);
        let of_8 = seen(&normals, Small::uvs_of_8(&bytes, grid));
        let (words, grid) = quantized_16::<3>(&uvs);
        let of_16 = seen(&normals, Small::uvs_of_16(&words, grid));
        assert_eq!(of_8.0, of_16.0);

        for (normal, got) in normals.iter().zip(of_8.0) {
            let [a, b] = [*normal, got].map(|v| v.to_bits().map(f64::from));
            if *normal == Vec3::ZERO {
                assert_eq!(got, Vec3::ZERO);
                continue;
            }
            // The largest component of a stored normal is 127. Each other component has an error of at most half a
            // unit.
            let bound = (0.5_f64.sqrt() / 127.).asin().to_degrees();
            let error = angle(a, b);
            assert!(
                error <= bound + 1e-9,
                "{normal:?} becomes {got:?}: {error} degrees"
            );
        }
        for (got, most) in [(of_8.1, 255.), (of_16.1, 65_535.)] {
            for axis in 0..2 {
                let [exact, got] =
                    [uvs, got].map(|uvs| uvs.map(|uv| f64::from(uv.to_bits()[axis])));
                let range = exact.into_iter().fold(f64::MIN, f64::max)
                    - exact.into_iter().fold(f64::MAX, f64::min);
                // The step is rounded up to a whole unit of 2^-20, and each coordinate is rounded to the nearest step.
                let bound = range / most / 2. + 0.5;
                for (exact, got) in exact.iter().zip(got) {
                    assert!((exact - got).abs() <= bound, "{exact} becomes {got}");
                }
            }
        }
    });
}
