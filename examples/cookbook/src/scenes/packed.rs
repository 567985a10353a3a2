//! A picture with full contrast and error diffusion, for a black and white panel of 128x64 pixels.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888};
use embedded_graphics::{prelude::*, primitives::Rectangle, text::Text};
use fixel::canvas::{Contrast, ErrorDiffusion};
use fixel::prelude::*;
use fixel::texture::Raw;

const SIZE: (u32, u32) = (128, 64);
static ISLAND: Mesh = include_mesh!("../../../assets/lighthouse.obj");
// With a crease of 180 degrees, no edge is a crease, and the outline has only silhouettes.
static SILHOUETTES: Outline = include_outline!("../../../assets/lighthouse.obj", crease = 180);
const PIXELS: &[u8] = include_bytes!("../../../assets/lighthouse.rgb565");
static SKIN: Raw<Rgb565> = Raw::checked(Raw::new(PIXELS, 128, 128));

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>, ms: u64) -> Result<(), Error> {
    let (width, height) = SIZE;
    let (mut grays, mut depths) = ([Gray8::new(0); 128 * 64], [0; 128 * 64]);
    let mut gray = Canvas::new(&mut grays, width, height)?.with_depth(&mut depths)?;
    let projection = Projection::perspective(deg!(37), SIZE, fx!(1), fx!(50))?;
    let camera = Camera::look_at(vec3!(2.4, 3.1, 8.4), vec3!(-0.7, 1.5, 0), Vec3::Y)?;
    let turn = Rate::millihertz(250).angle_at(ms);
    let view = projection * camera * fixel::Transform::rotate_y(turn);
    let light = Light::new(vec3!(-1, 1, 1), fx!(1), fx!(0.2))?;
    let skin = Textured::new(SKIN).converted().lit(light);
    gray.draw(&ISLAND, &view, &skin);
    // Surfaces without light are black, like the sky. The white lines separate them.
    let contrast = Contrast::of(&gray, 4);
    let white = Flat::rgb(Rgb888::new(255, 255, 255));
    let outline = ISLAND.outline(&SILHOUETTES, LineStyle::HAIRLINE);
    gray.draw(outline, &view, &white);

    // The middle of this picture shows the panel, with a square for each pixel of the panel.
    canvas.clear(Rgb565::new(3, 6, 4));
    let frame = canvas.frame_size();
    let side = (frame.width / width).min(frame.height / height).max(1);
    let corner = (frame.saturating_sub(Size::new(width, height) * side)) / 2;
    let mut errors = [0; SIZE.0 as usize];
    let mut diffusion = ErrorDiffusion::new(&mut errors);
    let style = MonoTextStyle::new(&FONT_6X10, BinaryColor::On);
    // Draw one page of an SSD1306 at a time: 8 rows, packed into a byte for each column.
    let (mut shown, mut page) = ([BinaryColor::Off; 128 * 8], [0_u8; 128]);
    for (first_row, grays) in (0..).step_by(8).zip(grays.chunks_mut(128 * 8)) {
        let gray = Canvas::band(grays, width, height, first_row)?;
        let mut panel = Canvas::band(&mut shown, width, height, first_row)?;
        let Ok(()) = gray.show_diffused(&mut panel, contrast, &mut diffusion);
        Text::new("LIGHTHOUSE", Point::new(2, 9), style).draw(&mut panel)?;
        let bytes = page.iter_mut().zip(panel.pages());
        bytes.for_each(|(byte, rows)| *byte = rows);
        for at in panel.bounding_box().points() {
            let is_on = page[at.x.cast_unsigned() as usize] >> (at.y % 8) & 1 == 1;
            let at = Point::zero() + corner + at * side.cast_signed();
            let square = Rectangle::new(at, Size::new_equal(side));
            let color = Rgb888::new(160, 235, 255).into();
            canvas.fill_solid(&square, if is_on { color } else { Rgb565::BLACK })?;
        }
    }
    Ok(())
}
