//! One picture, however it is drawn: again, in bands, or with its triangles in another order.
//!
//! Firmware draws the same in bands and compares with the host: `examples/firmware`, `.ci/run`.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::BigEndian;
use fixel::interpolate::{Affine, Exact, Fast, Interpolate, Newton};
use fixel::prelude::*;
use fixel::target::Depth;
use fixel::view::Perspective;

use crate::scene::Random;

const SIZE: (u32, u32) = (320, 240);

static SKIN: Texture<Rgb565, 2, 2> =
    Texture::rgb565(&[0xff, 0xff, 0x00, 0x1f, 0x07, 0xe0, 0xf8, 0x00]);
static RING: Mesh = shape!(torus(fx!(0.4), 24, 12));
static BALL: Mesh = shape!(sphere(16, 12));
static FLOOR: Mesh = shape!(plane(8, 8));

/// Rings before and behind a ball, over a floor that reaches behind the eye. No two are in one place.
fn models() -> [(&'static Mesh<'static>, Transform); 4] {
    let at = |x: Scalar, y: Scalar, z: Scalar| Transform::translate(Vec3::new(x, y, z));
    let tilt = |degrees: i32| Transform::rotate_x(Angle::from_degrees(degrees));
    [
        (&RING, at(fx!(-0.3), fx!(0.2), fx!(-3)) * tilt(70)),
        (&BALL, at(fx!(0.2), fx!(0.3), fx!(-5.5)) * tilt(10)),
        (&RING, at(fx!(1), fx!(0.5), fx!(-8)) * tilt(-60)),
        (
            &FLOOR,
            at(fx!(0), fx!(-2), fx!(0)) * Transform::scale(fx!(20)),
        ),
    ]
}

type Target<'a> = Canvas<'a, Rgb565, BigEndian, Depth<'a>>;

/// A frame in bands of so many rows: the checksum of its colours and depths.
fn crc(rows: u32, mut draw: impl FnMut(&mut Target<'_>, &Projection<Perspective>)) -> u32 {
    let lens = Projection::from_focal_length(fx!(200), SIZE, fx!(0.25), fx!(100)).unwrap();
    let mut sum = crc32fast::Hasher::new();
    let mut all_depths = Vec::new();
    for first in (0..SIZE.1).step_by(rows as usize) {
        let pixels = (SIZE.0 * rows.min(SIZE.1 - first)) as usize;
        // What was there before must not show.
        let (mut color, mut depth) = (vec![[9; 2]; pixels], vec![7; pixels]);
        let band = Canvas::big_endian_band(&mut color, SIZE.0, SIZE.1, first).unwrap();
        let mut band = band.with_depth(&mut depth).unwrap();
        band.clear(Rgb565::new(1, 2, 3));
        draw(&mut band, &lens);
        sum.update(band.bytes());
        all_depths.extend(depth.iter().flat_map(|depth| depth.to_le_bytes()));
    }
    sum.update(&all_depths);
    sum.finalize()
}

fn frame<I: Interpolate>(mode: I, rows: u32) -> u32 {
    let pass = Pass::new().mode(mode);
    crc(rows, |band, lens| {
        for (mesh, place) in models() {
            band.draw_with(&pass, mesh, &(*lens * place), &Textured::new(&SKIN));
        }
    })
}

/// Twice, and in bands of any height; what they all are is what the other modes are next to.
fn bands<I: Interpolate>(mode: I) {
    let whole = frame(mode, SIZE.1);
    for rows in [1, 7, 16, 240] {
        assert_eq!(frame(mode, rows), whole, "bands of {rows}");
    }
}

#[test]
fn bands_are_the_frame() {
    bands(Newton);
    bands(Exact);
    bands(Fast::within(fx!(0.25)));
    bands(Affine);
}

/// The same order every time, and another than before.
fn shuffled<T>(list: &mut [T], random: &mut Random) {
    for i in (1..list.len()).rev() {
        list.swap(i, random.below(i + 1));
    }
}

/// The models in another order, and the triangles of each: depth decides what shows. Of two triangles in one place, at
/// one depth, the last would show: that is not for depth to decide, and here there are none.
#[test]
fn order_does_not_show() {
    let draw = |rows: u32, parts: &[(Vec<[u16; 3]>, &Mesh<'static>, Transform)]| {
        crc(rows, |band, lens| {
            for (faces, mesh, place) in parts {
                let positions: Vec<_> = mesh.positions().iter().collect();
                let mesh = Mesh::new(&positions, faces).unwrap();
                band.draw(&mesh, &(*lens * *place), &NormalView::new());
            }
        })
    };
    let mut parts = models().map(|(mesh, place)| (mesh.faces().to_vec(), mesh, place));
    let whole = draw(SIZE.1, &parts);
    let mut random = Random(12);
    for rows in [1, 7, 16, 240] {
        shuffled(&mut parts, &mut random);
        for (faces, ..) in &mut parts {
            shuffled(faces, &mut random);
        }
        assert_eq!(draw(rows, &parts), whole, "bands of {rows}");
    }
}
