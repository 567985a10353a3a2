//! Light in a color.

use super::{Illumination, Lighting, Rgb, SurfacePoint};

/// A light in a color; see [`Lighting::colored`].
///
#[cfg_attr(doc, doc = page_picture!("colored", "A ball between a red and a blue lamp"))]
/// ```
/// use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
/// use fixel::prelude::*;
/// use fixel::shade::Lighting;
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb888::BLACK; 1];
/// let evening = Light::new(Vec3::Y, fx!(0), fx!(0.5))?.colored(Rgb888::new(255, 128, 0));
/// Canvas::new(&mut pixels, 1, 1)?.draw(&SQUARE, &mvp, &Flat::rgb(Rgb888::WHITE).lit(evening));
/// assert_eq!(pixels, [Rgb888::new(128, 64, 0)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Colored<L> {
    pub(super) light: L,
    /// Red, green and blue, in units of 2⁻¹⁶.
    pub(super) color: [i32; 3],
}

impl<L: Lighting> Lighting for Colored<L> {
    type Diffuse = Rgb;
    type Specular = L::Specular;

    const READS_POSITION: bool = L::READS_POSITION;
    const READS_FACE: bool = L::READS_FACE;

    #[inline]
    fn at(&self, point: &SurfacePoint) -> Illumination {
        let light = self.light.at(point);
        let [r, g, b] = light.diffuse;
        let [red, green, blue] = self.color;
        Illumination {
            diffuse: [share(r, red), share(g, green), share(b, blue)],
            ..light
        }
    }
}

/// The product of two numbers in units of 2⁻¹⁶, the second at most 1; rounded down.
#[inline]
pub(super) fn share(light: i32, part: i32) -> i32 {
    ((i64::from(light) * i64::from(part)) >> 16) as i32
}
