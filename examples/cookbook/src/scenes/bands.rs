//! A frame in bands: the memory holds a few rows, which are drawn and sent before the next rows.

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor, WebColors};
use fixel::prelude::*;

/// The number of pixels of a band. 8 rows of 320 take 10 KiB, with depths; a whole frame takes 300 KiB.
const BAND: u32 = 320 * 8;

static BALL: Mesh = shape!(sphere(32, 24));
/// Stripes in four colors between white stripes, and white caps.
static STRIPES: [[Rgb565; 8]; 16] = {
    let colors = [
        Rgb565::RED,
        Rgb565::CSS_ORANGE,
        Rgb565::CSS_DODGER_BLUE,
        Rgb565::CSS_SEA_GREEN,
    ];
    let mut texels = [[Rgb565::WHITE; 8]; 16];
    let mut at = 0;
    while at < 4 * 14 {
        texels[1 + at / 4][2 * (at % 4)] = colors[at % 4];
        at += 1;
    }
    texels
};

/// Here the display is a canvas, too, but a band can be sent to any `DrawTarget`.
pub fn draw(display: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let frame = display.frame_size();
    let projection = Projection::perspective(deg!(40), frame, fx!(0.5), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(0, 1.2, 3.3), Vec3::ZERO, Vec3::Y)?;
    let mvp = view * Transform::rotate_z(deg!(-35)) * Transform::rotate_x(deg!(35));
    let sun = Light::new(vec3!(-2, 3, 3), fx!(0.35), fx!(0.65))?;

    // Collect the visible triangles once a frame. On a chip, the list and the memory are statics.
    let mut list = DrawList::<900, 900>::new();
    let triangles = list.prepare(&DrawOptions::new(), frame, &BALL, &mvp)?;
    let shader = Textured::new(&STRIPES).lit(sun);

    let Size { width, height } = frame;
    let (mut colors, mut depths) = ([Rgb565::BLACK; BAND as usize], [0; BAND as usize]);
    let rows = BAND / width;
    for first_row in (0..height).step_by(rows as usize) {
        let pixels = (width * rows.min(height - first_row)) as usize;
        let band = Canvas::band(&mut colors[..pixels], width, height, first_row)?;
        let mut band = band.with_depth(&mut depths[..pixels])?;
        // Each band has its own background, so that you can see the bands.
        let light = (first_row * 200 / height) as u8;
        band.clear(Rgb888::new(40 + light, 110 + light / 2, 190).into());
        band.draw_prepared(&triangles, &shader)?;
        band.show(display)?;
    }
    Ok(())
}
