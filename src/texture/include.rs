//! Textures from files, converted at compile time.

use super::Image;
use super::pixel::{Pixel, byte, index, write_indices};
use super::sampler::{self, Grid, exponents};
use super::{Palette, PaletteArray, Texture, TextureArray};
use crate::Error;
use crate::message;

/// A file that a macro has read.
///
/// A trait's functions cannot run at compile time, but its constants can depend on types. So the macro declares a
/// type for the file, the compiler infers the color's type from the place of the macro, and a constant of the two
/// holds the converted pixels.
pub trait File {
    /// The file's name, for errors.
    const PATH: &'static str;
    /// Its picture, whose size a texture may have.
    const IMAGE: Image<'static>;
}

/// A color, and the `N` pixels of file `F` in it.
#[diagnostic::on_unimplemented(
    message = "an image file cannot become a texture of `{Self}`",
    label = "`{Self}` is not a color of embedded-graphics",
    note = "write a color of embedded-graphics, such as `Texture<Rgb565>` or `Texture<Gray8>`"
)]
pub trait Convert<F: File, const N: usize>: Copy + 'static {
    /// The pixels, row by row.
    const TEXELS: &'static [Self; N];
    /// The color table.
    const COLORS: &'static [Self; 256];
}

/// A texture that can be created from file `F` with `N` pixels.
#[diagnostic::on_unimplemented(
    message = "an image file cannot become a `{Self}`",
    label = "expected a texture in a color of embedded-graphics",
    note = "write the type as `Texture<Rgb565>`, `TextureArray<Rgb565, WIDTH, HEIGHT>`, `Palette<Rgb565>` or `PaletteArray<Rgb565, WIDTH, HEIGHT>`"
)]
pub trait FromFile<F: File, const N: usize>: Sized {
    /// The texture.
    const VALUE: Self;
}

/// The indices of the pixels of file `F`.
struct Indices<F, const N: usize>(core::marker::PhantomData<F>);

impl<F: File, const N: usize> Indices<F, N> {
    const ALL: &'static [u8; N] = &{
        let mut indices = [0; N];
        write_indices!(indices[..N] = F::IMAGE);
        indices
    };
}

/// Entries, row by row, as a grid of the picture's size.
const fn grid<F: File, T: Copy>(entries: &[T]) -> Grid<'_, T> {
    let image = F::IMAGE;
    message::checked(Grid::new(entries, image.width, image.height), F::PATH)
}

/// Entries, row by row, as an array of rows; the picture must have the size `W` x `H`.
const fn rows<F: File, T: Copy, const W: usize, const H: usize>(entries: &[T]) -> [[T; W]; H] {
    let image = F::IMAGE;
    if image.width as usize != W || image.height as usize != H {
        message::wrong_size(F::PATH, [image.width, image.height], [W, H]);
    }
    sampler::rows(entries)
}

impl<F: File, C: Convert<F, N>, const N: usize> FromFile<F, N> for Texture<'static, C> {
    const VALUE: Self = Texture::of(grid::<F, C>(C::TEXELS));
}

impl<F: File, C: Convert<F, N>, const N: usize, const W: usize, const H: usize> FromFile<F, N>
    for TextureArray<C, W, H>
{
    const VALUE: Self = TextureArray::from_texels(rows::<F, C, W, H>(C::TEXELS));
}

impl<F: File, C: Convert<F, N>, const N: usize> FromFile<F, N> for Palette<'static, C> {
    const VALUE: Self = Palette::of(grid::<F, u8>(Indices::<F, N>::ALL), C::COLORS);
}

impl<F: File, C: Convert<F, N>, const N: usize, const W: usize, const H: usize> FromFile<F, N>
    for PaletteArray<C, W, H>
{
    const VALUE: Self =
        PaletteArray::from_rows(rows::<F, u8, W, H>(Indices::<F, N>::ALL), *C::COLORS);
}

/// The picture of a file, if its size is allowed for a texture.
///
/// # Panics
///
/// If the file or its size is not valid; the message names the file.
#[must_use]
pub const fn checked(image: Result<Image<'static>, Error>, path: &str) -> Image<'static> {
    let image = message::checked(image, path);
    message::checked(exponents(image.width, image.height), path);
    image
}

/// The number of pixels of a picture.
#[must_use]
pub const fn len(image: Image<'static>) -> usize {
    image.width as usize * image.height as usize
}

/// A texture from a BMP file, converted at compile time and stored in flash.
///
/// The expected type decides the result: a [`Texture`]; a [`TextureArray`] of the file's size; or, for a file with a
/// color table, a [`Palette`] or a [`PaletteArray`]. The color may be any of embedded-graphics';
/// [`ImageColor`](crate::texture::ImageColor) describes how it is rounded. Only the texels are stored in flash, not
/// the file.
///
/// The path is relative to the source file, as for [`include_bytes!`]. [`Image`] lists the supported formats; width
/// and height must be powers of two. A mistake in the file stops compilation with an error that names the file, for
/// example "skin.bmp: width is 100: it must be a power of two, at most 32768".
///
/// ```standalone_crate
/// use embedded_graphics::pixelcolor::{Gray8, Rgb565};
/// use fixel::prelude::*;
/// static SKIN: Texture<Rgb565> = include_bmp!("samples/brick.bmp");
/// assert_eq!((SKIN.width(), SKIN.height()), (8, 4));
///
/// // In another color; with the size in the type; with its color table.
/// static GRAY: Texture<Gray8> = include_bmp!("samples/brick.bmp");
/// static FAST: TextureArray<Rgb565, 8, 4> = include_bmp!("samples/brick.bmp");
/// static TILES: Palette<Rgb565> = include_bmp!("samples/tiles.bmp");
/// assert_eq!(FAST.as_texture(), SKIN);
/// assert_eq!((GRAY.texels().len(), TILES.indices().len()), (32, 8));
/// ```
///
/// A file without a color table cannot become a palette, and a file cannot become an array of another size:
///
/// ```compile_fail
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// static TILES: Palette<Rgb565> = include_bmp!("samples/brick.bmp");
/// ```
/// ```compile_fail
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// static FAST: TextureArray<Rgb565, 4, 8> = include_bmp!("samples/brick.bmp");
/// ```
///
/// # Compile time
///
/// A picture of 256x256 pixels adds about three seconds to the first build; incremental builds keep the result. The
/// compiler stops the evaluation of a constant after two million steps unless the crate allows
/// `long_running_const_eval`. Up to 512x512 pixels stay below this limit.
#[macro_export]
macro_rules! include_bmp {
    ($path:expr $(,)?) => {
        $crate::__include_image!(from_bmp, $path)
    };
}

/// A texture from a TGA file, converted at compile time: see [`include_bmp!`].
///
/// ```standalone_crate
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// static SKIN: Texture<Rgb565> = include_tga!("samples/brick.tga");
/// static SAME: Texture<Rgb565> = include_bmp!("samples/brick.bmp");
/// assert_eq!(SKIN, SAME);
/// ```
#[macro_export]
macro_rules! include_tga {
    ($path:expr $(,)?) => {
        $crate::__include_image!(from_tga, $path)
    };
}

/// The part that the macros for files share; `$read` is the constructor of [`Image`].
#[doc(hidden)]
#[macro_export]
macro_rules! __include_image {
    ($read:ident, $path:expr) => {{
        struct File;
        impl $crate::texture::include::File for File {
            const PATH: &'static str = $path;
            const IMAGE: $crate::texture::Image<'static> = $crate::texture::include::checked(
                $crate::texture::Image::$read(::core::include_bytes!($path)),
                $path,
            );
        }
        <_ as $crate::texture::include::FromFile<
            File,
            { $crate::texture::include::len(<File as $crate::texture::include::File>::IMAGE) },
        >>::VALUE
    }};
}
