//! The channels of a color that are interpolated.

use super::Varyings;
use super::format::luma;
use crate::sealed::{Sealed, sealed};

/// The channels of a color that are worth interpolating, because they differ: three, or one for gray.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, Rgb565};
/// use fixel::shade::{Channels, PixelFormat};
/// let gray = <Gray8 as PixelFormat>::Channels::first([7, 7, 7]);
/// let color = <Rgb565 as PixelFormat>::Channels::first([1, 2, 3]);
/// assert_eq!((gray, color), ([7], [1, 2, 3]));
/// ```
pub trait Channels: Varyings + Default + Sealed {
    /// Whether all channels are equal.
    #[doc(hidden)]
    const IS_GRAY: bool;

    /// Those of three channels that differ.
    fn first(channels: [i32; 3]) -> Self;

    /// All three channels; those that are not used are 0.
    fn all(self) -> [i32; 3];

    /// The channels of an RGB color, or its luma.
    #[doc(hidden)]
    fn of_rgb(channels: [i32; 3]) -> Self;
}

sealed!([i32; 3], [i32; 1]);

impl Channels for [i32; 3] {
    const IS_GRAY: bool = false;

    #[inline]
    fn first(channels: [i32; 3]) -> Self {
        channels
    }

    #[inline]
    fn all(self) -> [i32; 3] {
        self
    }

    #[inline]
    fn of_rgb(channels: [i32; 3]) -> Self {
        channels
    }
}

impl Channels for [i32; 1] {
    const IS_GRAY: bool = true;

    #[inline]
    fn first([channel, ..]: [i32; 3]) -> Self {
        [channel]
    }

    #[inline]
    fn all(self) -> [i32; 3] {
        [self[0], 0, 0]
    }

    #[inline]
    fn of_rgb(channels: [i32; 3]) -> Self {
        [luma(channels)]
    }
}
