//! Two cores draw a frame together: each core draws every other band, without a lock.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_graphics::{Drawable, geometry::Point, text::Text};
use fixel::prelude::*;

const ROWS: u32 = 16; // of a band
const STYLE: MonoTextStyle<Rgb565> = MonoTextStyle::new(&FONT_6X10, Rgb565::new(21, 42, 21));
static BALL: Mesh = shape!(sphere(16, 12));
static ROD: Mesh = shape!(cylinder(8));

/// A double helix. Each core draws it in its own bands.
fn helix(band: &mut Canvas<'_, Rgb565, Native, LinearDepth>, view: Mvp, sun: Light) {
    let color = |(red, green, blue)| Flat::rgb(Rgb888::new(red, green, blue)).lit(sun);
    let [rose, blue, gray] = [(255, 90, 110), (80, 160, 255), (220, 220, 210)].map(color);
    for step in -11..=11 {
        let place = view
            * Transform::translate(vec3!(0.42, 0, 0) * step)
            * Transform::rotate_x(Angle::from_degrees(28 * step));
        for (end, color) in [(Vec3::Y, &rose), (-Vec3::Y, &blue)] {
            let end = Transform::translate(end) * Transform::scale(fx!(0.24));
            band.draw(&BALL, &(place * end), color);
        }
        let thin = Transform::scale_axes(vec3!(0.07, 1, 0.07));
        band.draw(&ROD, &(place * thin), &gray);
    }
}

pub fn draw(display: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = display.frame_size();
    let projection = Projection::perspective(deg!(35), size, fx!(0.5), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(-2, 1.5, 6.5), vec3!(0, 0, 0), Vec3::Y)?;
    let sun = Light::new(vec3!(-2, 2, 3), fx!(0.3), fx!(0.7))?;
    // The colors of a frame, and the depths of a band for each core, take 170 KiB.
    let mut colors = vec![Rgb565::BLACK; (size.width * size.height) as usize];
    let bands = colors.chunks_mut((size.width * ROWS) as usize);
    let (even, odd): (Vec<_>, Vec<_>) = (0..).zip(bands).partition(|(band, _)| band % 2 == 0);
    let core = |bands: Vec<(u32, &mut [Rgb565])>, name, background| -> Result<(), Error> {
        let mut depths = vec![0; (size.width * ROWS) as usize];
        for (number, colors) in bands {
            let (rows_above, depths) = (number * ROWS, &mut depths[..colors.len()]);
            let band = Canvas::band(colors, size.width, size.height, rows_above)?;
            let mut band = band.with_depth(depths)?;
            band.clear(background); // a color and a name for each core, so that you see its bands
            let at = Point::new(3, 11 + rows_above.cast_signed());
            Text::new(name, at, STYLE).draw(&mut band)?;
            helix(&mut band, view, sun);
        }
        Ok(())
    };
    // A thread takes the place of the second core.
    std::thread::scope(|cores| {
        let second = cores.spawn(|| core(odd, "core 1", Rgb565::new(11, 12, 9)));
        core(even, "core 0", Rgb565::new(2, 17, 11))?;
        second.join().expect("drawing never panics")
    })?;
    Ok(Canvas::new(&mut colors, size.width, size.height)?.show(display)?)
}
