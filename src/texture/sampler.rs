//! The interface between a texture and its shader: texels by column and row.

use crate::error::Error;
use crate::error::ok;
use crate::message;

/// A source of texels, by column and row. The texels repeat in both directions.
///
/// Width and height are powers of two.
///
/// A reference to rows of texels is a sampler. It is the fastest sampler, because the size of the rows is part of the
/// type. [`Texture`](super::Texture), [`Indexed`](super::Indexed), [`Raw`](super::Raw) and [`Mipmap`](super::Mipmap)
/// are samplers themselves. References to these types are not samplers, because a loop over pixels would read the
/// texture's fields again at each pixel: the compiler cannot know that writing a pixel does not change them. Your own
/// sampler can compute its texels:
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::{prelude::*, texture::Sampler};
///
/// /// Squares of 8x8 texels.
/// #[derive(Clone, Copy)]
/// struct Checkers;
///
/// impl Sampler for Checkers {
///     type Color = Gray8;
///
///     fn size_log2(&self) -> [u32; 2] {
///         [4, 4]
///     }
///
///     fn texel(&self, u: i32, v: i32) -> Gray8 {
///         Gray8::new(if (u ^ v) & 8 == 0 { 30 } else { 220 })
///     }
/// }
///
/// let shader = Textured::new(Checkers).bilinear();
/// static ROWS: [[Gray8; 2]; 1] = [[Gray8::new(1), Gray8::new(2)]];
/// assert_eq!((&ROWS).texel(1, -7), Gray8::new(2)); // the rows repeat
/// # let _ = shader;
/// ```
///
/// Rows do not compile if their number or length is not a power of two. The compiler's error then names a size that
/// compiles:
///
/// ```compile_fail
/// use fixel::texture::Sampler;
/// use embedded_graphics::pixelcolor::Gray8;
/// let image = [[Gray8::new(0); 100]; 64];
/// let _ = (&image).texel(0, 0);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a texture",
    label = "not a texture",
    note = "textures are `Texture`, `Indexed`, `Raw` and `Mipmap`, without `&`, and references to rows of texels, \
            `&[[Rgb565; 64]; 64]`; for a slice of texels, write `Texture::new(&texels, width, height)?`"
)]
pub trait Sampler: Copy {
    /// A texel: a color, a [`Translucent`](crate::shade::Translucent) color, [`Argb4444`](super::Argb4444) or
    /// [`Argb1555`](super::Argb1555).
    type Color: Copy;

    /// The base-2 logarithms of width and height; each is at most 15.
    fn size_log2(&self) -> [u32; 2];

    /// The texel in column `u` and row `v`, both modulo the size; (0, 0) is the top left texel.
    fn texel(&self, u: i32, v: i32) -> Self::Color;

    /// A texel of a mipmap level. The width and height of the level are the texture's width and height divided by
    /// 2^`level`. In the last level, the shorter side has one texel.
    ///
    /// A texel of a level replaces several texels of level 0; by default, this function returns the first of them.
    #[inline]
    fn texel_at(&self, level: u32, u: i32, v: i32) -> Self::Color {
        self.texel(u.wrapping_shl(level), v.wrapping_shl(level))
    }
}

/// Largest width and height of a texture, in texels.
pub(super) const MAX_SIZE: usize = 1 << 15;

/// The base-2 logarithm of a width or height. `of` is the name of the size in the error.
pub(super) const fn exponent(of: &'static str, given: u32) -> Result<u32, Error> {
    let max = MAX_SIZE as u32;
    if given.is_power_of_two() && given <= max {
        Ok(given.ilog2())
    } else {
        Err(Error::PowerOfTwo { of, given, max })
    }
}

/// The base-2 logarithms of a width and a height.
pub(super) const fn exponents(width: u32, height: u32) -> Result<[u32; 2], Error> {
    let width_log2 = ok!(exponent("width", width));
    Ok([width_log2, ok!(exponent("height", height))])
}

/// The base-2 logarithms of a width and a height that are part of a type, checked at compile time.
pub(super) const fn size_log2(width: usize, height: usize) -> [u32; 2] {
    /// A size that does not fit into 32 bits is too large anyway.
    const fn given(size: usize) -> u32 {
        if size > MAX_SIZE {
            u32::MAX
        } else {
            size as u32
        }
    }
    message::checked(exponents(given(width), given(height)), "texture")
}

impl<C: Copy, const W: usize, const H: usize> Sampler for &[[C; W]; H] {
    type Color = C;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        const { size_log2(W, H) }
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        const { size_log2(W, H) };
        let (u, v) = (u.cast_unsigned() as usize, v.cast_unsigned() as usize);
        // The masks show the compiler that the indices are in range.
        self[v & (H - 1)][u & (W - 1)]
    }
}
