//! Colors by height.

use embedded_graphics::pixelcolor::Rgb888;

use super::ramp::Ramp;
use super::{Fragment, PixelFormat, Precise, Shader};
use crate::error::{Error, check_above};
use crate::mesh::Primitive;
use crate::num::Scalar;

/// A height is converted to a share of the way from bottom to top, with this many fraction bits.
const BITS: u32 = 12;

/// Colors by the height (y) in model space, for a sky or for terrain: one color up to a low height, another color above
/// a high height, and a proportional mixture between the two heights.
///
#[cfg_attr(doc, doc = page_picture!("gradient", "A ball that is blue at the bottom and pale yellow at the top"))]
/// The color is computed at the vertices and interpolated in correct perspective. The color at a vertex has an error of
/// at most 1/60 step in a 6-bit channel, or 1/15 step in an 8-bit channel.
///
/// Draw a sky before everything else, from inside, with a [camera that stays in the sky's center](crate::Camera::sky),
/// and without a depth test:
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::pixelcolor::{Gray4, GrayColor, Rgb888, RgbColor};
/// use fixel::{prelude::*, shade::Gradient, canvas::NoTest};
/// static DOME: Mesh = shape!(sphere(12, 8));
/// let projection = Projection::perspective(deg!(90), (1, 1), fx!(0.5), fx!(100))?;
/// let camera = Camera::look_at(vec3!(5, 2, 30), vec3!(5, 2, 0), Vec3::Y)?;
/// let mut pixels = [Gray4::BLACK; 8 * 12];
/// let mut canvas = Canvas::new(&mut pixels, 8, 12)?;
/// let sky = Gradient::new((fx!(0), Rgb888::WHITE), (fx!(0.6), Rgb888::new(68, 68, 68)))?;
/// let behind = DrawOptions::new().with_cull(Cull::Front).with_depth_test(NoTest);
/// let far = Transform::scale(fx!(10));
/// canvas.draw_with(&behind, &DOME, &(projection * camera.sky() * far), &sky);
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "65554556", "76656677", "88776778", "A998999A", "BBBBABBC", "EEEDEDEE",
///     "FFFFFFFF", "FFFFFFFF", "FFFFFFFF", "FFFFFFFF", "FFFFFFFF", "FFFFFFFF",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gradient<C: PixelFormat> {
    bottom: i32,
    ramp: Ramp,
    /// The color's levels at the bottom.
    low: [i32; 3],
    change: [i32; 3],
    color: core::marker::PhantomData<C>,
}

impl<C: PixelFormat> Gradient<C> {
    /// A gradient with the color `low` up to the height `bottom`, and the color `high` above the height `top`. Heights
    /// are in the model's units.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] if `top` is not above `bottom`.
    pub fn new(
        (bottom, low): (Scalar, Rgb888),
        (top, high): (Scalar, Rgb888),
    ) -> Result<Self, Error> {
        let ramp = Ramp::new(check_above("top of the gradient", top, bottom)?, BITS);
        let (low, [r, g, b]) = (
            Precise::<C>::of_rgb(low).levels(),
            Precise::<C>::of_rgb(high).levels(),
        );
        Ok(Self {
            bottom: bottom.to_bits(),
            ramp,
            low,
            change: [r - low[0], g - low[1], b - low[2]],
            color: core::marker::PhantomData,
        })
    }

    /// The color's levels at a height.
    fn levels(&self, height: Scalar) -> [i32; 3] {
        let above = i64::from(height.to_bits()) - i64::from(self.bottom);
        let share = self.ramp.share(above).clamp(0, 1 << BITS) as i32;
        // A change has 24 bits. The upper 18 of these bits are multiplied by a share of 13 bits.
        let part = |change: i32| ((change >> 6) * share) >> (BITS - 6);
        let ([r, g, b], [x, y, z]) = (self.low, self.change);
        [r + part(x), g + part(y), b + part(z)]
    }
}

impl<C: PixelFormat> Shader for Gradient<C> {
    type Color = Precise<C>;
    type Varyings = Precise<C>;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        primitive.corners(|corner| {
            let levels = self.levels(corner.position().y);
            Precise::from_levels(levels)
        })
    }

    #[inline]
    fn shade(&self, _: &Fragment, color: Precise<C>) -> Option<Precise<C>> {
        Some(color)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fx;
    use crate::random::cases;
    use core::ops::Bound::{Excluded, Unbounded};
    use embedded_graphics::pixelcolor::{Gray8, Rgb565, RgbColor};
    use rand::Rng;

    fn compare<C: PixelFormat>(heights: [i32; 3], colors: [[u8; 3]; 2]) {
        let [bottom, top, _] = heights.map(Scalar::from_bits);
        let [low, high] = colors.map(|[r, g, b]| Rgb888::new(r, g, b));
        let made = Gradient::<C>::new((bottom, low), (top, high));
        let Ok(gradient) = made else {
            assert!(top <= bottom);
            return;
        };
        assert!(top > bottom);
        let [bottom, top, height] = heights.map(f64::from);
        let share = ((height - bottom) / (top - bottom)).clamp(0., 1.);
        let (low, high) = (
            Precise::<C>::of_rgb(low).levels(),
            Precise::<C>::of_rgb(high).levels(),
        );
        for ((found, (a, b)), most) in gradient
            .levels(Scalar::from_bits(heights[2]))
            .into_iter()
            .zip(low.into_iter().zip(high))
            .zip(C::MAX_STEPS)
        {
            let (a, b) = (f64::from(a), f64::from(b));
            let exact = a + (b - a) * share;
            // The share is cut to 12 fraction bits, the change to 18 of its 24 bits, and their product to whole units.
            let allowed = (b - a).abs() / 4096. + 64. + 1.;
            let documented = 65_536. / if most < 64 { 60. } else { 15. };
            assert!(allowed <= documented);
            assert!(
                (f64::from(found) - exact).abs() <= allowed,
                "{found}, not {exact}"
            );
        }
    }

    #[test]
    fn levels_follow_the_height() {
        cases(256, |random| {
            let heights = random.random::<[i32; 3]>();
            let cut = random.random_range(0..28);
            let colors = random.random::<[[u8; 3]; 2]>();
            compare::<Rgb888>(heights, colors);
            compare::<Rgb565>(heights.map(|height| height >> cut), colors);
            compare::<Gray8>(heights.map(|height| height >> cut), colors);
        });
    }

    #[test]
    fn heights_in_the_wrong_order_are_refused() {
        let (low, high) = (fx!(2), fx!(2));
        let made = Gradient::<Rgb565>::new((low, Rgb888::RED), (high, Rgb888::BLUE));
        let error = Error::OutOfRange {
            of: "top of the gradient",
            given: high,
            range: (Excluded(low), Unbounded),
        };
        assert_eq!(made, Err(error));
    }
}
