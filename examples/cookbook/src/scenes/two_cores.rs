//! Two cores draw one frame: each draws every other band, without a lock.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;

const ROWS: u32 = 16; // of a band

static BALL: Mesh = shape!(sphere(16, 12));
static ROD: Mesh = shape!(cylinder(8));

/// The scene: a double helix. Each core sees only its bands of it.
fn helix(band: &mut Canvas<'_, Rgb565, Native, LinearDepth>, view: Mvp, sun: Light) {
    let color = |red, green, blue| Flat::rgb(Rgb888::new(red, green, blue)).lit(sun);
    let (rose, blue) = (color(255, 90, 110), color(80, 160, 255));
    let gray = color(220, 220, 210);
    for step in -11..=11_i16 {
        let place = view
            * Transform::translate(vec3!(0.42, 0, 0) * Scalar::from(step))
            * Transform::rotate_x(Angle::from_degrees(28 * i32::from(step)));
        for (height, color) in [(fx!(1), &rose), (fx!(-1), &blue)] {
            let end = Transform::translate(Vec3::Y * height) * Transform::scale(fx!(0.24));
            band.draw(&BALL, &(place * end), color);
        }
        let rod = place * Transform::scale_axes(vec3!(0.07, 1, 0.07));
        band.draw(&ROD, &rod, &gray);
    }
}

pub fn draw(display: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = display.frame_size();
    let projection = Projection::perspective(deg!(35), size, fx!(0.5), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(-2, 1.5, 6.5), vec3!(0, 0, 0), Vec3::Y)?;
    let sun = Light::new(vec3!(-2, 2, 3), fx!(0.3), fx!(0.7))?;

    // Colors for a frame, and depths for a band on each core: 170 KiB.
    let mut colors = vec![Rgb565::BLACK; (size.width * size.height) as usize];
    let bands = colors.chunks_mut((size.width * ROWS) as usize);
    let (even, odd): (Vec<_>, Vec<_>) = (0..).zip(bands).partition(|(band, _)| band % 2 == 0);
    let core = |bands: Vec<(u32, &mut [Rgb565])>, background| -> Result<(), Error> {
        let mut depths = vec![0; (size.width * ROWS) as usize];
        for (number, colors) in bands {
            let depths = &mut depths[..colors.len()];
            let band = Canvas::band(colors, size.width, size.height, number * ROWS)?;
            let mut band = band.with_depth(depths)?;
            band.clear(background); // a color for each core, so that you see its bands
            helix(&mut band, view, sun);
        }
        Ok(())
    };
    // A thread stands in for the second core.
    std::thread::scope(|cores| {
        let second = cores.spawn(|| core(odd, Rgb565::new(5, 14, 11)));
        core(even, Rgb565::new(3, 8, 9))?;
        second.join().expect("drawing never panics")
    })?;
    Ok(Canvas::new(&mut colors, size.width, size.height)?.show(display)?)
}
