//! One scene on four panels: black and white, 16 grays, 256 grays, a palette of 8 colors.

use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, PixelColor, Rgb565};
use embedded_graphics::{pixelcolor::raw::RawU16, prelude::*, primitives::Rectangle};
use fixel::canvas::ColorIndex;
use fixel::prelude::*;

const SIZE: Size = Size::new(64, 32);
const PIXELS: usize = 64 * 32;
static RING: Mesh = shape!(torus(fx!(0.45), 32, 16));
#[rustfmt::skip]
const GLOW: [u16; 8] = [0x0003, 0x2888, 0x590a, 0x9109, 0xc9c6, 0xeb44, 0xfd45, 0xff71];

/// Draws the scene in a panel's colors, and shows it in a quarter of the picture.
fn show<C: PixelColor + Default>(
    canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>,
    place: Size,
    panel: Canvas<'_, C>,
    shader: &impl ShaderFor<C>,
    color_of: impl Fn(C) -> Rgb565,
) -> Result<(), Error> {
    let view = Projection::perspective(deg!(35), SIZE, fx!(0.5), fx!(20))?
        * Camera::look_at(vec3!(0, 2.8, 3.4), Vec3::ZERO, Vec3::Y)?;
    let mut depths = [0; PIXELS];
    let mut panel = panel.with_depth(&mut depths)?;
    panel.clear(C::default());
    panel.draw(&RING, &view, shader);

    let quarter = canvas.frame_size() / 2;
    let side = (quarter.width / 64).min(quarter.height / 32).max(1);
    let corner = place.component_mul(quarter) + quarter.saturating_sub(SIZE * side) / 2;
    for (at, pixel) in panel.bounding_box().points().zip(panel.pixels()) {
        let at = Point::zero() + corner + at * side.cast_signed();
        canvas.fill_solid(&Rectangle::new(at, Size::new_equal(side)), color_of(pixel))?;
    }
    Ok(())
}

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let sun = Light::new(vec3!(-2, 3, 1), fx!(0.06), fx!(0.94))?;
    let clay = Flat::new(Gray8::new(255)).lit(sun);
    canvas.clear(Rgb565::new(5, 10, 6));
    // Black and white, with ordered dithering; 16 grays.
    let (mut bits, mut halves) = ([BinaryColor::Off; PIXELS], [Gray4::new(0); PIXELS]);
    let panel = Canvas::new(&mut bits, 64, 32)?;
    let binary = clay.converted::<BinaryColor>();
    show(canvas, Size::new(0, 0), panel, &binary, Rgb565::from)?;
    let panel = Canvas::new(&mut halves, 64, 32)?;
    let gray = clay.converted::<Gray4>();
    show(canvas, Size::new(1, 0), panel, &gray, Rgb565::from)?;
    // 256 grays; the index of a color.
    let (mut grays, mut indices) = ([Gray8::new(0); PIXELS], [ColorIndex(0); PIXELS]);
    let panel = Canvas::new(&mut grays, 64, 32)?;
    show(canvas, Size::new(0, 1), panel, &clay, Rgb565::from)?;
    let panel = Canvas::new(&mut indices, 64, 32)?;
    let color = |ColorIndex(index)| RawU16::new(GLOW[usize::from(index)]).into();
    let glow = clay.map(|at, gray| Some(ColorIndex(gray.finish(at.point).luma() / 32)));
    show(canvas, Size::new(1, 1), panel, &glow, color)
}
