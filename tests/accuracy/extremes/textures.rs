//! Texture coordinates of ±32,000 texels, and textures that are smaller than a pixel.
//!
//! An attribute keeps 30 bits of its largest value in the triangle. For 32,000 texels, the resolution is therefore
//! 1/16,384 texel, and bounds are 125 times as large as for 256 texels. `Fast` keeps only 16 of these bits, which is a
//! resolution of 1/2 texel, and adds its tolerance.

use super::scene::{Random, TriangleView, worst};
use super::table::{Cases, picture};
use super::verdict::Verdict;

/// Triangles in which a texture coordinate goes from −`most` to `most`, at many slopes.
fn wide(most: i32) -> Verdict {
    let view = TriangleView::ROOM;
    let mut random = Random(9);
    let ends = [-most, most].map(|texel| texel << 16);
    worst((0..80).map(|step: usize| {
        let corner = |random: &mut Random| {
            let at = [random.between(-70., 70.), random.between(-50., 50.)];
            view.at(at, random.between(1., 4.))
        };
        let corners = [0; 3].map(|_| corner(&mut random));
        let pick = |bit: usize| ends[step >> bit & 1];
        let texels = [[pick(0), pick(3)], [pick(1), pick(4)], [pick(2), pick(5)]];
        view.scene(corners, texels).judge()
    }))
}

/// Whole textures within a few pixels, at the distance `w`.
fn tiny(w: f64) -> Verdict {
    let view = TriangleView {
        far: 32_767.,
        focal: 60.,
        ..TriangleView::ROOM
    };
    let mut random = Random(10);
    worst((0..300).map(|_| {
        let [x, y] = [random.between(-40., 40.), random.between(-30., 30.)];
        let mut corner = || {
            let at = [x + random.between(-2., 2.), y + random.between(-2., 2.)];
            view.at(at, w * random.between(0.7, 1.))
        };
        view.scene([corner(), corner(), corner()], super::scene::ONCE)
            .judge()
    }))
}

/// The ground below a camera with hardly any roll. Along a row, 1/w changes by 2⁻²⁸ to 2⁻²¹ of its value per pixel,
/// while the texture coordinate changes by many texels, up to 1000 in all. Rows that are drawn straight must be within
/// the bounds.
fn level() -> Verdict {
    let view = TriangleView {
        far: 32_767.,
        ..TriangleView::ROOM
    };
    let mut random = Random(15);
    worst((0..80).map(|_| {
        let roll = 2_f64.powf(random.between(-28., -21.));
        let corner = |[x, y]: [f64; 2]| view.at([x, y], 4000. / (1. + roll * x + 0.01 * y));
        let corners = [[-47., 31.], [45., 29.], [3., -33.]].map(corner);
        let texels = [random.between(100., 1000.) as i32 * 32_768; 2];
        let [u, v] = texels;
        view.scene(corners, [[-u, v], [u, 0], [0, -v]]).judge()
    }))
}

pub static CASES: Cases = Cases::new(|| {
    vec![
        picture("texture coordinates of ±256 texels", wide(256)),
        picture("texture coordinates of ±4,000 texels", wide(4000)),
        picture("texture coordinates of ±32,000 texels", wide(32_000)),
        picture(
            "texture coordinates of ±500 texels along level rows",
            level(),
        ),
        picture("texture of 256 texels in 4 pixels, 100 away", tiny(100.)),
        picture(
            "texture of 256 texels in 4 pixels, 32,000 away",
            tiny(32_000.),
        ),
    ]
});

#[test]
fn errors_of_textures_of_any_range_are_within_their_bounds() {
    assert_eq!(CASES.len(), 6);
}
