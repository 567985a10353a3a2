//! A corridor of eight triangles: in mode `Affine` on the left, in the default mode on the right.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor, raw::RawU16};
use embedded_graphics::{Drawable, geometry::Point, text::Text};
use fixel::{Window, mode::Affine, prelude::*};

/// A floor, 2 units wide and 16 long. The texture repeats twice on each unit.
static FLOOR: Mesh = {
    #[rustfmt::skip]
    const CORNERS: [Vec3; 4] =
        [vec3!(-1, -1, 0), vec3!(1, -1, 0), vec3!(1, -1, -16), vec3!(-1, -1, -16)];
    const UVS: [Vec2; 4] = [vec2!(0, 32), vec2!(4, 32), vec2!(4, 0), vec2!(0, 0)];
    Mesh::checked(Mesh::checked(Mesh::new(&CORNERS, &[[0, 1, 2], [0, 2, 3]])).with_uvs(&UVS, None))
};

/// For floor, ceiling and walls: the angle about the line of sight, the size of a stone in texels, and the stone's
/// colors.
static SIDES: [(Angle, [usize; 2], [u16; 2]); 4] = [
    (deg!(0), [8, 8], [0xef3a, 0x2a4f]),
    (deg!(180), [8, 16], [0xac4a, 0x9388]),
    (deg!(90), [4, 8], [0xcb08, 0xaa46]),
    (deg!(270), [4, 8], [0xcb08, 0xaa46]),
];

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>, ms: u64) -> Result<(), Error> {
    let size = canvas.frame_size();
    let middle = size.width.cast_signed() / 2;
    let aspect = Scalar::try_from(size.width)? / Scalar::try_from(size.height)?;
    // Each half of the picture has its own window. The windows meet at the line of sight.
    let whole = Window::centered(aspect * fx!(0.38), fx!(0.38));
    let (mut left, mut right) = (whole, whole);
    (left.right, right.left) = (fx!(0), fx!(0));
    let left = Projection::frustum(left, fx!(0.25), fx!(20))?;
    let right = Projection::frustum(right, fx!(0.25), fx!(20))?;
    let half = |x| Viewport::new(x, 0, size.width / 2, size.height);
    let newton = DrawOptions::new().with_viewport(half(middle)?);
    let affine = DrawOptions::new().with_viewport(half(0)?).with_mode(Affine);
    // Each second, a step of one unit. The stones repeat on each unit, so the walk can begin again.
    let step = Scalar::from((ms % 1000) as i16) / 1000;
    let eye = vec3!(0.2, 0, -0.2) - Vec3::Z * step;
    let camera = Camera::look_at(eye, vec3!(0, -0.1, -9), vec3!(0.15, 1, 0))?;
    for &(angle, [width, height], colors) in &SIDES {
        let texels: [[Rgb565; 16]; 16] = core::array::from_fn(|row| {
            core::array::from_fn(|column| match [column % width, row % height] {
                [0, _] | [_, 0] => Rgb565::new(9, 18, 9),
                _ => RawU16::new(colors[(column / width + row / height) % 2]).into(),
            })
        });
        let (turn, stones) = (Transform::rotate_z(angle), Textured::new(&texels));
        canvas.draw_with(&affine, &FLOOR, &(left * camera * turn), &stones);
        canvas.draw_with(&newton, &FLOOR, &(right * camera * turn), &stones);
    }
    let white = MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE);
    Text::new("Affine", Point::new(5, 12), white).draw(canvas)?;
    Text::new("Newton", Point::new(middle + 5, 12), white).draw(canvas)?;
    Ok(())
}
