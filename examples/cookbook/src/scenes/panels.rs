//! One scene on four panels: black and white, 4 grays, a palette of 8 colors, 16 bits of color.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray8, PixelColor, Rgb565, raw::RawU16};
use embedded_graphics::{prelude::*, text::Text};
use fixel::{canvas::ColorIndex, prelude::*, texture::Raw};

static ISLAND: Mesh = include_mesh!("../../../assets/lighthouse.obj");
const PIXELS: &[u8] = include_bytes!("../../../assets/lighthouse.rgb565");
static SKIN: Raw<Rgb565> = Raw::checked(Raw::new(PIXELS, 128, 128));
/// The palette of the third panel, from dark to bright.
#[rustfmt::skip]
const GLOW: [u16; 8] = [0x0003, 0x2888, 0x590a, 0x9109, 0xc9c6, 0xeb44, 0xfd45, 0xff71];
const BAND: u32 = 76 * 64; // pixels of a band: 20 KiB

/// Draws the scene in the colors of a panel. Shows it in a column of the picture, with a caption.
fn show<C: PixelColor + Default>(
    canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>,
    (column, caption): (i32, &str),
    shader: &impl ShaderFor<C>,
    color_of: impl Fn(C) -> Rgb565,
) -> Result<(), Error> {
    let frame = canvas.frame_size();
    let size = Size::new(frame.width / 4, frame.height).saturating_sub(Size::new(4, 16));
    let projection = Projection::perspective(deg!(55), size, fx!(1), fx!(50))?;
    let camera = Camera::look_at(vec3!(2, 3.6, 7), vec3!(-0.25, 2.1, 0), Vec3::Y)?;
    let corner = Point::new(2 + column * frame.width.cast_signed() / 4, 2);
    let (mut colors, mut depths) = ([C::default(); BAND as usize], [0; BAND as usize]);
    let rows = BAND / size.width;
    for first_row in (0..size.height).step_by(rows as usize) {
        let pixels = (size.width * rows.min(size.height - first_row)) as usize;
        let band = Canvas::band(&mut colors[..pixels], size.width, size.height, first_row)?;
        let mut band = band.with_depth(&mut depths[..pixels])?;
        band.clear(C::default());
        band.draw(&ISLAND, &(projection * camera), shader);
        for (at, pixel) in band.bounding_box().points().zip(band.pixels()) {
            Pixel(corner + at, color_of(pixel)).draw(canvas)?;
        }
    }
    let style = MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE);
    let below = Point::new(0, size.height.cast_signed() + 10);
    Text::new(caption, corner + below, style).draw(canvas)?;
    Ok(())
}

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    canvas.clear(Rgb565::new(5, 10, 6));
    let sun = Light::new(vec3!(-1, 1, 1), fx!(0.5), fx!(0.7))?;
    let skin = Textured::new(SKIN).lit(sun);
    let white = skin.converted::<BinaryColor>(); // with ordered dithering
    show(canvas, (0, "1 bit"), &white, Rgb565::from)?;
    let gray = skin.converted::<Gray2>();
    show(canvas, (1, "4 grays"), &gray, Rgb565::from)?;
    let color = |ColorIndex(index)| RawU16::new(GLOW[usize::from(index)]).into();
    let gray = skin.converted::<Gray8>();
    let glow = gray.map(|at, gray| Some(ColorIndex(gray.finish(at.point).luma() / 32)));
    show(canvas, (2, "8 colors"), &glow, color)?;
    show(canvas, (3, "16 bits"), &skin, |color| color)
}
