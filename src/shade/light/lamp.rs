//! Lights that come from one place or direction.

use super::adapters::share;
use super::{Lighting, Shiny, SurfacePoint, Viewer, brightness};
use crate::error::Error;
use crate::math::Direction;
use crate::num::Scalar;

/// A light from one place or direction: [`Light`](super::Light),
/// [`PointLight`](super::PointLight) or [`SpotLight`](super::SpotLight). A lamp can make
/// highlights.
pub trait Lamp: Lighting {
    /// The direction from a point toward the light, and the strength of the light at the point: 65,536 is full
    /// brightness. Where no light reaches the point, the strength is 0, and the direction may be [`Direction::NONE`].
    fn ray(&self, point: &SurfacePoint) -> (Direction, i32);

    /// The light on a matte surface, in units of 2⁻¹⁶, by Lambert's law: the strength of the light at a point, times
    /// the cosine of the angle between the normal and the direction toward the light.
    #[inline]
    fn diffuse(&self, point: &SurfacePoint) -> i32 {
        let (toward, light) = self.ray(point);
        share(light, point.normal.dot(toward).to_bits().max(0) >> 14)
    }

    /// The light that comes from all sides, in units of 2⁻¹⁶.
    #[inline]
    fn ambient(&self) -> i32 {
        0
    }

    /// Adds a white highlight (Blinn–Phong) as the `viewer` sees it. The highlight's brightness is `strength` ·
    /// (n·h)^`exponent` times the strength of the light at the point, where n is the normal, and h is the direction
    /// halfway between the directions toward the light and toward the viewer.
    ///
    /// An exponent of 8 makes a wide highlight; an exponent of 100 makes a small one. Highlights are computed at the
    /// corners and interpolated, so a mesh must be fine enough to show them. Highlights take one of the eight
    /// [varyings](crate::shade::Varyings) that a shader may have.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] if `strength` is not between 0 and 1.
    ///
    #[cfg_attr(doc, doc = page_picture!("shiny", "A ring with highlights"))]
    /// ```
    /// use embedded_graphics::mock_display::MockDisplay;
    /// use embedded_graphics::pixelcolor::{Gray4, GrayColor, Rgb888, RgbColor};
    /// use fixel::prelude::*;
    /// static BALL: Mesh = shape!(sphere(24, 16));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::front(Vec3::ZERO, fx!(1));
    /// let sun = Light::new(vec3!(1, 1, 2), fx!(0.2), fx!(0.4))?;
    /// let sun = sun.shiny(Viewer::of(&mvp), 30, fx!(0.8))?;
    /// let mut pixels = [Gray4::BLACK; 144];
    /// let mut canvas = Canvas::new(&mut pixels, 12, 12)?;
    /// canvas.draw(&BALL, &mvp, &Flat::rgb(Rgb888::WHITE).lit(sun));
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "000067780000",
    ///     "005678989700",
    ///     "045779899970",
    ///     "056789BBA990",
    ///     "35677ABDA987",
    ///     "346789BCB997",
    ///     "3456788A9977",
    ///     "345577888876",
    ///     "034556676760",
    ///     "033455666550",
    ///     "003334454400",
    ///     "000033330000",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    fn shiny(self, viewer: Viewer, exponent: u8, strength: Scalar) -> Result<Shiny<Self>, Error> {
        Ok(Shiny {
            lamp: self,
            viewer,
            exponent,
            strength: brightness(strength)?,
        })
    }
}
