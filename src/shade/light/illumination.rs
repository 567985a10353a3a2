//! An amount of light, and which parts of it are interpolated.

use super::FULL;
use crate::sealed::{Sealed, sealed};
use crate::shade::{Channels, PixelFormat, Varyings};

/// The light at a point of a surface, in units of 2⁻¹⁶ of full brightness.
///
/// A light may exceed full brightness up to a thousand times, and be below 0, which takes away light of another one. A
/// surface limits the sum of its lights to the range from 0 to full brightness.
///
/// ```
/// use fixel::shade::Illumination;
/// let half = Illumination::white(32_768);
/// assert_eq!((half.diffuse, half.specular), ([32_768; 3], None));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Illumination {
    /// Red, green and blue, by which the surface's color is multiplied. On a gray canvas, only the first is used.
    pub diffuse: [i32; 3],
    /// The white of a highlight, which is added to the surface's color.
    pub specular: Option<i32>,
}

impl Illumination {
    /// White light without a highlight.
    #[must_use]
    #[inline]
    pub const fn white(brightness: i32) -> Self {
        Self {
            diffuse: [brightness; 3],
            specular: None,
        }
    }

    /// The sum of two amounts of light, which saturates.
    #[must_use]
    #[inline]
    pub const fn plus(self, other: Self) -> Self {
        let ([r, g, b], [x, y, z]) = (self.diffuse, other.diffuse);
        Self {
            diffuse: [
                r.saturating_add(x),
                g.saturating_add(y),
                b.saturating_add(z),
            ],
            specular: match (self.specular, other.specular) {
                (Some(a), Some(b)) => Some(a.saturating_add(b)),
                (one, None) | (None, one) => one,
            },
        }
    }
}

/// The light, limited to the range from darkness to full brightness.
#[inline]
fn limited(light: i32) -> i32 {
    light.clamp(0, FULL)
}

/// The color of a light, as a type: [`White`] or [`Rgb`]. Sealed.
///
/// White light takes one varying, colored light one for each channel of the canvas.
#[doc(hidden)]
pub trait Tint: Sealed {
    /// The color of this light and another one together.
    type Or<T: Tint>: Tint;

    /// The varyings on a canvas of color `C`.
    #[doc(hidden)]
    type Channels<C: PixelFormat>: Varyings + Default;

    #[doc(hidden)]
    fn pack<C: PixelFormat>(diffuse: [i32; 3]) -> Self::Channels<C>;

    #[doc(hidden)]
    fn unpack<C: PixelFormat>(channels: Self::Channels<C>) -> [i32; 3];
}

/// Light without color, as a [`Lighting::Diffuse`](super::Lighting::Diffuse).
///
/// ```
/// use fixel::prelude::*;
/// use fixel::shade::{Lighting, White};
/// fn is_white<L: Lighting<Diffuse = White>>(_: &L) {}
/// is_white(&Light::new(Vec3::Y, fx!(0.2), fx!(0.8))?);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum White {}

/// Light with a color, as a [`Lighting::Diffuse`](super::Lighting::Diffuse).
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
/// use fixel::prelude::*;
/// use fixel::shade::{Lighting, Rgb};
/// fn has_color<L: Lighting<Diffuse = Rgb>>(_: &L) {}
/// has_color(&Light::new(Vec3::Y, fx!(0.2), fx!(0.8))?.colored(Rgb888::YELLOW));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rgb {}

sealed!(White, Rgb, Matte, Glossy);

impl Tint for White {
    type Or<T: Tint> = T;
    type Channels<C: PixelFormat> = [i32; 1];

    #[inline]
    fn pack<C: PixelFormat>([light, ..]: [i32; 3]) -> [i32; 1] {
        [limited(light)]
    }

    #[inline]
    fn unpack<C: PixelFormat>([light]: [i32; 1]) -> [i32; 3] {
        [light; 3]
    }
}

impl Tint for Rgb {
    type Or<T: Tint> = Self;
    type Channels<C: PixelFormat> = C::Channels;

    #[inline]
    fn pack<C: PixelFormat>([r, g, b]: [i32; 3]) -> C::Channels {
        C::Channels::of_rgb([limited(r), limited(g), limited(b)])
    }

    #[inline]
    fn unpack<C: PixelFormat>(channels: C::Channels) -> [i32; 3] {
        channels.all()
    }
}

/// Whether a light makes highlights, as a type: [`Matte`] or [`Glossy`]. Sealed.
///
/// Highlights take one more varying.
#[doc(hidden)]
pub trait Gloss: Sealed {
    /// The highlights of this light and another one together.
    type Or<G: Gloss>: Gloss;

    #[doc(hidden)]
    type Channels: Varyings + Default;

    #[doc(hidden)]
    fn pack(specular: Option<i32>) -> Self::Channels;

    #[doc(hidden)]
    fn unpack(channels: Self::Channels) -> Option<i32>;
}

/// Light without highlights, as a [`Lighting::Specular`](super::Lighting::Specular).
///
/// ```
/// use fixel::prelude::*;
/// use fixel::shade::{Lighting, Matte};
/// fn is_matte<L: Lighting<Specular = Matte>>(_: &L) {}
/// is_matte(&Light::new(Vec3::Y, fx!(0.2), fx!(0.8))?);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Matte {}

/// Light with highlights, as a [`Lighting::Specular`](super::Lighting::Specular).
///
/// ```
/// use fixel::prelude::*;
/// use fixel::shade::{Glossy, Lamp, Lighting, Viewer};
/// fn is_glossy<L: Lighting<Specular = Glossy>>(_: &L) {}
/// let sun = Light::new(Vec3::Y, fx!(0.2), fx!(0.8))?;
/// is_glossy(&sun.shiny(Viewer::at(vec3!(0, 2, 5)), 20, fx!(0.5))?);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Glossy {}

impl Gloss for Matte {
    type Or<G: Gloss> = G;
    type Channels = ();

    #[inline]
    fn pack(_: Option<i32>) {}

    #[inline]
    fn unpack((): ()) -> Option<i32> {
        None
    }
}

impl Gloss for Glossy {
    type Or<G: Gloss> = Self;
    type Channels = [i32; 1];

    #[inline]
    fn pack(specular: Option<i32>) -> [i32; 1] {
        [limited(specular.unwrap_or_default())]
    }

    #[inline]
    fn unpack([specular]: [i32; 1]) -> Option<i32> {
        Some(specular)
    }
}
