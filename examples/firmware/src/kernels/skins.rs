//! Measures textures with a size that is known at run time, for comparison with rows, which have the size in their
//! type.

use core::hint::black_box;

use embedded_graphics::pixelcolor::raw::LittleEndian;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::mode::{Affine, Fast, Mode, Newton};
use fixel::prelude::*;
use fixel::texture::{Argb1555, Indexed, Raw};

use super::common::scenes::{self, CHECKER};
use super::frames::{Frame, Posed};
use super::ticks::Stopwatch;
use super::wall::{Bench, Depths};

/// Bytes of texels: each byte is an index, or each pair of bytes is a color with the low byte first.
static BYTES: [u8; 2 * 64 * 64] = [0x41; 2 * 64 * 64];

/// Colors for the indices.
static COLORS: [Rgb565; 256] = [Rgb565::BLUE; 256];

/// Texels without holes.
static LEAVES: [Argb1555; 64 * 64] = [Argb1555::new(3, 20, 5); 64 * 64];

/// Prints the costs of the floor and of the cube. [`Frame::measure`] draws the same scenes with rows.
pub fn frames(frame: &mut Frame, watch: &mut Stopwatch) -> Result<(), Error> {
    frames_in(frame, watch, "newton", Newton::default())?;
    frames_in(frame, watch, "fast", Fast::within(fx!(0.25)))
}

fn frames_in<M: Mode>(
    frame: &mut Frame,
    watch: &mut Stopwatch,
    mode_name: &str,
    mode: M,
) -> Result<(), Error> {
    // `black_box` hides the size from the compiler.
    let texture = black_box(Texture::new(CHECKER.as_flattened(), 64, 64)?);
    let options = DrawOptions::new().with_mode(mode);
    let skin = Textured::new(texture);
    for thing in [
        ("floor-texture", &scenes::FLOOR, scenes::floor_mvp as Posed),
        ("cube-texture", &scenes::CUBE, scenes::cube_mvp),
    ] {
        frame.mesh(watch, (mode_name, &options), thing, &skin, true)?;
    }
    Ok(())
}

/// Prints the costs of pixels.
pub fn kernels(bench: &mut Bench) -> Result<(), Error> {
    let texture = black_box(Texture::new(CHECKER.as_flattened(), 64, 64)?);
    let skin = Textured::new(texture);
    bench.kernel("affine-texture", Affine, &skin, Depths::None)?;
    bench.kernel("newton-texture", Newton::default(), &skin, Depths::None)?;
    bench.kernel(
        "newton-texture-depth-pass",
        Newton::default(),
        &skin,
        Depths::Far,
    )?;
    bench.kernel(
        "affine-texture-clamped",
        Affine,
        &skin.clamped(),
        Depths::None,
    )?;
    bench.kernel(
        "affine-texture-bilinear",
        Affine,
        &skin.bilinear(),
        Depths::None,
    )?;

    let indices = black_box(Texture::new(&BYTES[..64 * 64], 64, 64)?);
    let indexed = Textured::new(Indexed {
        indices,
        colors: &COLORS,
    });
    bench.kernel("affine-texture-indexed", Affine, &indexed, Depths::None)?;

    let raw = black_box(Raw::<Rgb565, LittleEndian>::new(&BYTES, 64, 64)?);
    bench.kernel(
        "affine-texture-raw",
        Affine,
        &Textured::new(raw),
        Depths::None,
    )?;

    let leaves = black_box(Texture::new(&LEAVES, 64, 64)?);
    bench.kernel(
        "affine-texture-argb1555",
        Affine,
        &Textured::new(leaves),
        Depths::None,
    )?;
    Ok(())
}
