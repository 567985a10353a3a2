//! The output of shaders: colors, in full precision or not, with or without an opacity.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::PixelColor;

use super::format::fraction;
use super::{Channels, Illumination, PixelFormat, Precise, Shader};

/// The output of a [`Shader`] for a pixel: a color of the canvas, a [`Precise`] color, or either of these with an
/// opacity ([`Translucent`]).
///
/// [`lit`](Self::lit) and [`map`](Self::map) change the color in full precision, and leave the opacity as it is.
/// [Adapters](crate::shade), such as light and fog, call these methods. A color that no adapter changes is stored
/// unchanged.
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*};
/// use fixel::shade::{Illumination, Output, Translucent};
/// let glass = Translucent { color: Gray8::new(55), opacity: 9 };
/// let lit = glass.lit(Illumination::white(32_768));
/// assert_eq!((lit.color.finish(Point::zero()), lit.opacity), (Gray8::new(28), 9));
/// ```
pub trait Output: Copy {
    /// The color of the canvas.
    type Color: PixelColor;

    /// The type of this output in full precision, and in the color format `D`.
    type With<D: PixelFormat>: Output<Color = D>;

    /// Whether the output hides the color on the canvas.
    #[doc(hidden)]
    const IS_OPAQUE: bool = true;

    /// Whether the output is the canvas's color itself.
    #[doc(hidden)]
    const IS_PLAIN: bool = false;

    /// This output under a light.
    #[must_use]
    #[inline]
    fn lit<D: Channels, S: Channels>(self, light: Illumination<D, S>) -> Self::With<Self::Color>
    where
        Self::Color: PixelFormat,
    {
        self.map(|color| color.lit(light))
    }

    /// Applies a function to the color in full precision.
    #[must_use]
    fn map<D: PixelFormat>(
        self,
        f: impl FnOnce(Precise<Self::Color>) -> Precise<D>,
    ) -> Self::With<D>
    where
        Self::Color: PixelFormat;

    /// The color as a canvas stores it at a pixel of the frame, without its opacity: rounded, or dithered if the format
    /// is coarse.
    #[must_use]
    fn finish(self, at: Point) -> Self::Color;

    /// The share, in 255ths, of the canvas's color that this color covers.
    #[must_use]
    #[inline]
    fn opacity(self) -> u8 {
        255
    }

    /// The new color of a pixel; `below` returns the old color.
    #[doc(hidden)]
    #[inline]
    fn onto(self, below: impl FnOnce() -> Self::Color, at: Point) -> Self::Color {
        let _ = below;
        self.finish(at)
    }

    /// The new color of a pixel that has the color `below`. The output covers `share`/65,536 of the pixel, or less if
    /// it is translucent.
    #[doc(hidden)]
    #[inline]
    fn cover(self, below: Self::Color, share: i32, at: Point) -> Self::Color
    where
        Self::Color: PixelFormat,
    {
        self.map(|color| color).cover(below, share, at)
    }

    /// The color, and the share of the canvas's color that it covers, from 0 to 65,536.
    #[doc(hidden)]
    #[inline]
    fn parts(self) -> (Precise<Self::Color>, i32)
    where
        Self::Color: PixelFormat,
    {
        self.map(|color| color).parts()
    }
}

/// The color of the canvases that a shader can draw on.
pub type ColorOf<S> = <<S as Shader>::Color as Output>::Color;

/// The type of a shader's output in full precision. An adapter around the shader returns this type.
pub type PreciseOf<S> = <<S as Shader>::Color as Output>::With<ColorOf<S>>;

impl<C: PixelColor> Output for C {
    type Color = C;
    type With<D: PixelFormat> = Precise<D>;

    const IS_PLAIN: bool = true;

    #[inline]
    fn lit<D: Channels, S: Channels>(self, light: Illumination<D, S>) -> Precise<C>
    where
        C: PixelFormat,
    {
        // The products are exact, because the steps have no fraction.
        Precise::of_products(self.steps(), light.diffuse.rgb()).glossed(light.specular)
    }

    #[inline]
    fn map<D: PixelFormat>(self, f: impl FnOnce(Precise<C>) -> Precise<D>) -> Precise<D>
    where
        C: PixelFormat,
    {
        f(self.into())
    }

    #[inline]
    fn finish(self, _: Point) -> C {
        self
    }

    #[inline]
    fn cover(self, below: C, share: i32, at: Point) -> C
    where
        C: PixelFormat,
    {
        below.covered(self, share, at)
    }
}

impl<C: PixelFormat> Output for Precise<C> {
    type Color = C;
    type With<D: PixelFormat> = Precise<D>;

    #[inline]
    fn map<D: PixelFormat>(self, f: impl FnOnce(Self) -> Precise<D>) -> Precise<D> {
        f(self)
    }

    #[inline]
    fn finish(self, at: Point) -> C {
        Self::finish(self, at)
    }

    #[inline]
    fn cover(self, below: C, share: i32, at: Point) -> C {
        let below = Self::from(below);
        below.mix(self, share).finish(at)
    }

    #[inline]
    fn parts(self) -> (Self, i32) {
        (self, 1 << 16)
    }
}

/// A color with an opacity, which is the share of the canvas's color that this color covers: from 0 (nothing) to 255
/// (everything).
///
/// [Masked textures](crate::Textured::masked) and [`Argb4444`](crate::texture::Argb4444) have translucent colors. A
/// shader of your own may return translucent colors, too. Draw opaque surfaces first. Then draw translucent surfaces
/// from back to front, with the depth test [`TestOnly`](crate::canvas::TestOnly), so that they hide nothing that is
/// drawn later.
///
/// For colors of 15 and 16 bits that are not [`Precise`], the covered share is rounded to 1/32, so the error is at most
/// 1.1 steps in a 5-bit channel and 1.7 steps in a 6-bit channel. For other colors, the error is at most half a step.
/// An opacity of 0 keeps the color on the canvas, and 255 replaces it.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4};
/// use fixel::{Window, prelude::*, shade::Translucent};
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray4::new(0); 16];
/// let mut canvas = Canvas::new(&mut pixels, 8, 2)?;
/// // Invisible on the left, opaque on the right. Colors of 4 bits are dithered.
/// let curtain = Flat::new(Gray4::new(15))
///     .map(|at, color| Some(Translucent { color, opacity: at.point.x as u8 * 36 }));
/// canvas.draw(&SQUARE, &mvp, &curtain);
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["02468BCF", "02569ADF"]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Translucent<C> {
    /// The color.
    pub color: C,
    /// The share of this color in the mixture with the color on the canvas, in units of 1/255.
    pub opacity: u8,
}

impl<C> Translucent<C> {
    /// The same color, with its opacity multiplied by `opacity`/255 and rounded to nearest. Use this method for a
    /// sprite that fades away.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::Gray8;
    /// use fixel::shade::Translucent;
    /// let leaf = Translucent { color: Gray8::new(9), opacity: 200 };
    /// assert_eq!(leaf.faded(128).opacity, 100);
    /// ```
    #[must_use]
    #[inline]
    pub fn faded(self, opacity: u8) -> Self {
        // The product divided by 255, rounded to nearest. The result is exact for all products of two 8-bit numbers.
        let product = u32::from(self.opacity) * u32::from(opacity) + 128;
        Self {
            color: self.color,
            opacity: ((product + (product >> 8)) >> 8) as u8,
        }
    }

    /// The opacity times `most`, in units of 1/65,536.
    #[inline]
    fn share(&self, most: i32) -> i32 {
        // The product of 16 bits and 15 bits fits into 32 bits.
        let share = fraction(self.opacity);
        if most == 1 << 16 {
            share
        } else {
            (share >> 1).wrapping_mul(most >> 1) >> 14
        }
    }
}

impl<O: Output<Color: PixelFormat>> Output for Translucent<O> {
    type Color = O::Color;
    type With<D: PixelFormat> = Translucent<O::With<D>>;

    const IS_OPAQUE: bool = false;

    #[inline]
    fn lit<D: Channels, S: Channels>(self, light: Illumination<D, S>) -> Self::With<O::Color> {
        Translucent {
            color: self.color.lit(light),
            opacity: self.opacity,
        }
    }

    #[inline]
    fn map<D: PixelFormat>(self, f: impl FnOnce(Precise<O::Color>) -> Precise<D>) -> Self::With<D> {
        Translucent {
            color: self.color.map(f),
            opacity: self.opacity,
        }
    }

    #[inline]
    fn finish(self, at: Point) -> O::Color {
        self.color.finish(at)
    }

    #[inline]
    fn opacity(self) -> u8 {
        self.faded(self.color.opacity()).opacity
    }

    #[inline]
    fn onto(self, below: impl FnOnce() -> O::Color, at: Point) -> O::Color {
        self.color.cover(below(), self.share(1 << 16), at)
    }

    #[inline]
    fn cover(self, below: O::Color, share: i32, at: Point) -> O::Color {
        self.color.cover(below, self.share(share), at)
    }

    #[inline]
    fn parts(self) -> (Precise<O::Color>, i32) {
        let (color, share) = self.color.parts();
        (color, self.share(share))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::pixelcolor::Gray8;

    #[test]
    fn opacities_multiply_to_the_nearest_255th() {
        for a in 0..=255_u8 {
            for b in 0..=255_u8 {
                let color = Gray8::new(1);
                let faded = Translucent { color, opacity: a }.faded(b);
                let exact = f64::from(a) * f64::from(b) / 255.;
                assert!((f64::from(faded.opacity) - exact).abs() <= 0.5, "{a} {b}");
            }
        }
    }
}
