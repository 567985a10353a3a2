//! The output of shaders: colors, with or without an opacity.

use embedded_graphics::pixelcolor::PixelColor;

use super::Shader;

/// The output of a [`Shader`] for a pixel: a color, or a [`Translucent`] color.
///
/// Adapters change its color with [`map`](Self::map) and leave the opacity as it is.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
/// use fixel::shade::{Source, Translucent};
/// fn inverted<C: Source<Color = Gray8>>(source: C) -> C {
///     source.map(|color| Gray8::new(255 - color.luma()))
/// }
/// assert_eq!(inverted(Gray8::new(55)), Gray8::new(200));
/// let glass = Translucent { color: Gray8::new(55), opacity: 9 };
/// assert_eq!(inverted(glass), Translucent { color: Gray8::new(200), opacity: 9 });
/// ```
pub trait Source: Copy {
    /// The color of the canvas.
    type Color: PixelColor;

    /// The same source with another color.
    type With<D: PixelColor>: Source<Color = D>;

    /// Applies a function to the color.
    #[must_use]
    fn map(self, f: impl FnOnce(Self::Color) -> Self::Color) -> Self;

    /// Converts the color.
    #[must_use]
    fn convert<D: PixelColor>(self, f: impl FnOnce(Self::Color) -> D) -> Self::With<D>;
}

/// The color of the canvas that a shader is for.
pub type ColorOf<S> = <<S as Shader>::Color as Source>::Color;

impl<C: PixelColor> Source for C {
    type Color = C;
    type With<D: PixelColor> = D;

    #[inline]
    fn map(self, f: impl FnOnce(C) -> C) -> C {
        f(self)
    }

    #[inline]
    fn convert<D: PixelColor>(self, f: impl FnOnce(C) -> D) -> D {
        f(self)
    }
}

/// A color with an opacity, by which it covers the color on the canvas: from 0 (not at all) to 255 (wholly).
///
/// [Masked textures](crate::Textured::masked) and [`Argb4444`](crate::texture::Argb4444) have such colors, and so may a
/// shader of your own. Draw them with the blending [`Alpha`](crate::canvas::Alpha).
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4};
/// use fixel::{prelude::*, shade::Translucent, canvas::Alpha};
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray4::new(0); 16];
/// let mut canvas = Canvas::new(&mut pixels, 8, 2)?;
/// // Invisible on the left, opaque on the right. Colors of 4 bits are dithered.
/// let curtain = Flat::new(Gray4::new(15))
///     .map(|at, color| Some(Translucent { color, opacity: at.point.x as u8 * 36 }));
/// canvas.draw_with(&DrawOptions::new().with_blending(Alpha), &SQUARE, &mvp, &curtain);
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
    /// The color's share of the result, in 255ths; the color on the canvas has the rest.
    pub opacity: u8,
}

impl<C> Translucent<C> {
    /// The same color with its opacity multiplied by another one, where 255 is 1, and rounded to nearest. Use it for a
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
        // p/255, rounded: exact for products of 8 bits.
        let product = u32::from(self.opacity) * u32::from(opacity) + 128;
        Self {
            color: self.color,
            opacity: ((product + (product >> 8)) >> 8) as u8,
        }
    }
}

impl<C: PixelColor> Source for Translucent<C> {
    type Color = C;
    type With<D: PixelColor> = Translucent<D>;

    #[inline]
    fn map(self, f: impl FnOnce(C) -> C) -> Self {
        self.convert(f)
    }

    #[inline]
    fn convert<D: PixelColor>(self, f: impl FnOnce(C) -> D) -> Translucent<D> {
        Translucent {
            color: f(self.color),
            opacity: self.opacity,
        }
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
