//! Draws each program that the page printed, and compares its picture with the page's: see programs.mjs.
#![allow(dead_code)] // of the project's scenes

mod lighthouse;
mod scenes;
mod world;

use std::convert::Infallible;
use std::process::ExitCode;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Size};
use embedded_graphics::pixelcolor::raw::RawData;
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb555, Rgb565, Rgb888, RgbColor,
};

/// A display.
struct Display<C> {
    size: Size,
    pixels: Vec<C>,
}

impl<C> OriginDimensions for Display<C> {
    fn size(&self) -> Size {
        self.size
    }
}

impl<C: PixelColor> DrawTarget for Display<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, color) in pixels {
            self.pixels[(at.y * self.size.width as i32 + at.x) as usize] = color;
        }
        Ok(())
    }
}

/// FNV-1a of red, green and blue.
fn hash<C: Into<Rgb888> + Copy>(pixels: &[C]) -> u32 {
    let bytes = pixels.iter().flat_map(|&color| {
        let color: Rgb888 = color.into();
        [color.r(), color.g(), color.b()]
    });
    bytes.fold(0x811c_9dc5, |hash, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    })
}

/// Draws a program's picture to a display.
fn drawn<C: PixelColor + From<C::Raw>>(
    size: Size,
    draw: impl Fn(&mut Display<C>) -> Result<(), fixel::Error>,
) -> Result<Vec<C>, fixel::Error> {
    let black = C::Raw::from_u32(0).into();
    let pixels = vec![black; (size.width * size.height) as usize];
    let mut display = Display { size, pixels };
    draw(&mut display).map(|()| display.pixels)
}

macro_rules! programs {
    ($($name:ident $Color:ident $width:literal $height:literal $wanted:literal $about:literal;)+) => {
        $(mod $name;)+

        fn main() -> ExitCode {
            let mut wrong = 0;
            $(match drawn::<$Color>(Size::new($width, $height), $name::draw) {
                Ok(pixels) if hash(&pixels) == $wanted => {}
                Ok(_) => {
                    println!("src/{}.rs draws another picture than the page: {}", stringify!($name), $about);
                    wrong += 1;
                }
                Err(error) => {
                    println!("src/{}.rs, {}: {error}", stringify!($name), $about);
                    wrong += 1;
                }
            })+
            println!("{} printed programs draw what the page draws, {wrong} do not", [$($wanted),+].len() - wrong);
            ExitCode::from(u8::from(wrong > 0))
        }
    };
}

include!("list.rs");
