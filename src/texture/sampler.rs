//! What a texture is to a shader: texels by whole numbers, endlessly repeated.

use embedded_graphics::pixelcolor::PixelColor;

/// Texels by column and row, repeated in both directions, of a size that is a power of two.
///
/// Implemented for references to [`Texture`](crate::Texture), [`Palette`](crate::Palette) and
/// plain rows of texels, for texels that are read at run time:
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb888;
/// use fixel::texture::Sampler;
/// let rows: Vec<[Rgb888; 256]> = (0..=255).map(|y| [Rgb888::new(y, 0, 0); 256]).collect();
/// let image: &[[Rgb888; 256]; 256] = rows.as_slice().try_into().unwrap();
/// assert_eq!(image.texel(0, 3), Rgb888::new(3, 0, 0));
/// assert_eq!(image.texel(-1, -1), Rgb888::new(255, 0, 0));
/// ```
///
/// Another size does not compile:
///
/// ```compile_fail
/// use fixel::texture::Sampler;
/// use embedded_graphics::pixelcolor::Gray8;
/// let image = [[Gray8::new(0); 100]; 64];
/// let _ = (&image).texel(0, 0);
/// ```
pub trait Sampler: Copy {
    /// The texels' colour.
    type Color: PixelColor;

    /// The width is 2 to this power; at most 15.
    fn width_log2(&self) -> u32;

    /// The height is 2 to this power; at most 15.
    fn height_log2(&self) -> u32;

    /// The texel of column `u` and row `v`, (0, 0) being the top left one, each taken modulo the size.
    fn texel(&self, u: i32, v: i32) -> Self::Color;
}

/// Largest width and height of a texture, in texels.
pub const MAX_TEXTURE_SIZE: usize = 1 << 15;

/// The exponent of a width or height, checked while compiling.
pub(super) const fn log2(size: usize) -> u32 {
    assert!(
        size.is_power_of_two() && size <= MAX_TEXTURE_SIZE,
        "the width and the height of a texture must be powers of two, at most 32768"
    );
    size.ilog2()
}

/// The entry at column `u` and row `v`, modulo the size; a mask, which shows the compiler that
/// the indices are in range.
#[inline]
pub(super) fn wrapped<T: Copy, const W: usize, const H: usize>(
    rows: &[[T; W]; H],
    u: i32,
    v: i32,
) -> T {
    const { (log2(W), log2(H)) };
    let (u, v) = (u.cast_unsigned() as usize, v.cast_unsigned() as usize);
    rows[v & (H - 1)][u & (W - 1)]
}

impl<C: PixelColor, const W: usize, const H: usize> Sampler for &[[C; W]; H] {
    type Color = C;

    #[inline]
    fn width_log2(&self) -> u32 {
        const { log2(W) }
    }

    #[inline]
    fn height_log2(&self) -> u32 {
        const { log2(H) }
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        wrapped(self, u, v)
    }
}
