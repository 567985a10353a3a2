//! Measures costs on a microcontroller: of the inner loops (a pixel in each mode, and the set-up of a triangle), and of
//! frames. For each measured scene, the cost of a frame is the mean over its eight poses.
//!
//! `cargo run --profile speed -p firmware --bin kernels --target thumbv7em-none-eabi` runs the program under QEMU,
//! which counts instructions. On a chip, the program counts the core's cycles. The first line says whether it counts
//! instructions or cycles, and how many are in a tick. Then there is a line for each kernel, with its units (pixels or
//! triangles), the ticks that they took, and the instructions or cycles of `each`. Last, there is a line for each
//! scene, with its frames and the instructions or cycles of `each`. `--profile size` instead of `--profile speed`
//! optimizes for size.
//!
//! The cost of a pixel is the difference between two drawings of a triangle that covers a frame of 64 rows.
//! `unit=pixel` compares frames of 16 and 48 columns. These lie within one span, so only the inner loop is measured.
//! `unit=long-pixel` compares 48 and 240 columns. Its cost includes 1/64 of the cost of starting a span, because a span
//! has 64 pixels. The cost of a triangle is the difference between two prepared lists with different numbers of the
//! same triangle. For `rows-of-64`, it is the cost of a whole sphere with rows of 64 vertices, divided by the number of
//! its triangles.
//!
//! Pixels are RGB565 in the processor's byte order. Textures have 64x64 texels and are drawn without a filter. Only
//! draw calls are measured. `depth-pass` and `depth-fail` have a depth buffer that lets all pixels pass or no pixel.
//! The other kernels have no depth buffer. `texture` in the name of a kernel or a scene means a texture with a size
//! that is known at run time. Other textures are rows, with the size in their type.
//!
//! On the host, `kernels SCENE` draws the poses of a scene, so that `.ci/host` can count instructions. `kernels
//! painter` compares the painter's order with a depth buffer. `kernels painter SCENE depth` and `kernels painter SCENE
//! sorted` only draw, with a depth buffer or in the painter's order.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;
#[cfg(target_os = "none")]
mod bounds;
#[cfg(target_os = "none")]
mod calls;
#[path = "../../../common/mod.rs"]
mod common;
#[cfg(target_os = "none")]
mod everyday;
#[cfg(target_os = "none")]
mod frames;
#[cfg(not(target_os = "none"))]
mod host;
#[cfg(target_os = "none")]
mod lights;
#[cfg(target_os = "none")]
mod mono;
#[cfg(target_os = "none")]
mod numbers;
#[cfg(not(target_os = "none"))]
mod painter;
#[cfg(target_os = "none")]
mod pieces;
#[cfg(target_os = "none")]
mod rows;
#[cfg(target_os = "none")]
mod setup;
#[cfg(target_os = "none")]
mod silhouettes;
#[cfg(target_os = "none")]
mod skins;
#[cfg(target_os = "none")]
mod ticks;
#[cfg(target_os = "none")]
mod wall;
#[cfg(target_os = "none")]
mod words;

#[cfg(not(target_os = "none"))]
fn main() -> Result<(), fixel::Error> {
    host::main()
}

#[cfg(target_os = "none")]
mod firmware {
    use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
    use fixel::canvas::{Add, Multiply, Opacity};
    use fixel::mode::{Affine, Compact, Exact, Fast, Newton};
    use fixel::prelude::*;
    use fixel::shade::Gradient;
    use fixel::texture::{Argb4444, Mipmap};
    use semihosting::println;

    use super::board::{self, Clock};
    use super::bounds;
    use super::calls;
    use super::common::scenes::CHECKER;
    use super::everyday;
    use super::frames::Frame;
    use super::lights;
    use super::mono;
    use super::numbers;
    use super::pieces;
    use super::rows;
    use super::setup::{self, Kind};
    use super::silhouettes;
    use super::skins;
    use super::ticks::Stopwatch;

    use super::wall::{self, Bench, Depths};
    use super::words;

    /// White with half opacity.
    static SMOKE: [[Argb4444; 64]; 64] = [[Argb4444::new(8, 15, 15, 15); 64]; 64];

    /// All levels of a mipmap of one color.
    static LEVELS: [Rgb565; Mipmap::<Rgb565>::len(64, 64)] =
        [Rgb565::new(11, 18, 26); Mipmap::<Rgb565>::len(64, 64)];

    fn run() -> Result<(), Error> {
        let mut watch = Stopwatch::new(Clock::take().expect("taken once"));
        println!("{}", watch.tick());
        for (name, kind) in [
            ("setup-no-pixel", Kind::Missing),
            ("setup-one-pixel", Kind::Covering),
        ] {
            let (triangles, ticks) = setup::measure(&mut watch, kind)?;
            watch.print(name, "triangle", triangles, ticks);
        }

        let (tests, ticks) = bounds::measure(&mut watch)?;
        watch.print("in-view", "test", tests, ticks);
        numbers::measure(&mut watch)?;
        lights::measure(&mut watch)?;
        words::measure(&mut watch)?;
        mono::measure(&mut watch)?;

        let mut frame = Frame::take();
        calls::measure(&mut watch, &mut frame)?;
        everyday::measure(&mut watch, &mut frame)?;
        silhouettes::measure(&mut watch, &mut frame)?;
        rows::measure(&mut watch, &mut frame)?;
        frame.measure(&mut watch, "exact", Exact)?;
        frame.measure(&mut watch, "newton", Newton::default())?;
        frame.measure(&mut watch, "fast", Fast::within(fx!(0.25)))?;
        frame.measure(&mut watch, "affine", Affine)?;
        frame.measure(&mut watch, "compact", Compact)?;
        skins::frames(&mut frame, &mut watch)?;

        // With a tolerance of half a texel, each piece of this wall has 16 pixels.
        let fast = Fast::within(fx!(0.5));
        let mut bench = Bench::new(watch);
        let length = pieces::length(&mut bench, fast)?;
        assert_eq!(length, Some(16), "pixels in a piece");

        let (skin, flat) = (Textured::new(&CHECKER), Flat::new(Rgb565::RED));
        bench.kernel("flat", Newton::default(), &flat, Depths::None)?;
        let (low, high) = (Rgb888::new(20, 40, 200), Rgb888::new(120, 200, 255));
        let sky = Gradient::<Rgb565>::new((fx!(-1), low), (fx!(1), high))?;
        bench.kernel("gradient", Newton::default(), &sky, Depths::None)?;
        bench.kernel("affine", Affine, &skin, Depths::None)?;
        bench.kernel("fast-16", fast, &skin, Depths::None)?;
        bench.kernel("newton", Newton::default(), &skin, Depths::None)?;
        bench.kernel("newton-depth-pass", Newton::default(), &skin, Depths::Far)?;
        bench.kernel("newton-depth-fail", Newton::default(), &skin, Depths::Near)?;
        bench.kernel("narrow", Fast::NARROW, &skin, Depths::None)?;
        bench.kernel("narrow-depth-pass", Fast::NARROW, &skin, Depths::Far)?;
        bench.kernel("narrow-depth-fail", Fast::NARROW, &skin, Depths::Near)?;
        bench.kernel("exact", Exact, &skin, Depths::None)?;

        // No texel has this color.
        let cut_out = skin.cut_out(Rgb565::MAGENTA);
        bench.kernel("affine-cut-out", Affine, &cut_out, Depths::None)?;
        bench.kernel("newton-cut-out", Newton::default(), &cut_out, Depths::None)?;
        // The mipmap is made for a frame of a quarter of the size, so that no pixel shows level 0, which would not be
        // blended.
        let projection = wall::mvp(240)?.projection();
        let levels = Mipmap::new(&LEVELS, 64, 64)?;
        let levels = Textured::new(levels).mipmapped(&projection, (60, 16))?;
        bench.kernel("affine-mipmap", Affine, &levels, Depths::None)?;
        bench.kernel("affine-bilinear", Affine, &skin.bilinear(), Depths::None)?;
        bench.kernel(
            "affine-mipmap-bilinear",
            Affine,
            &levels.bilinear(),
            Depths::None,
        )?;
        bench.kernel(
            "affine-trilinear",
            Affine,
            &levels.trilinear(),
            Depths::None,
        )?;
        let glass = DrawOptions::new().with_blending(Opacity(100));
        bench.blended("flat-opacity", glass, &flat, Depths::None)?;
        let affine = DrawOptions::new().with_mode(Affine);
        let glass = affine.with_blending(Opacity(100));
        bench.blended("affine-opacity", glass, &skin, Depths::None)?;
        let alpha = affine;
        bench.blended(
            "affine-argb4444",
            alpha,
            &Textured::new(&SMOKE),
            Depths::None,
        )?;
        bench.blended("affine-add", affine.with_blending(Add), &skin, Depths::None)?;
        let shadow = affine.with_blending(Multiply);
        bench.blended("affine-multiply", shadow, &skin, Depths::None)?;
        let linear = Fog::linear(Rgb565::WHITE, fx!(0.5), fx!(3))?;
        let thick = Fog::exponential(Rgb565::WHITE, fx!(0.25))?;
        bench.kernel("affine-fog", Affine, &skin.in_fog(linear), Depths::None)?;
        bench.kernel(
            "newton-fog",
            Newton::default(),
            &skin.in_fog(linear),
            Depths::None,
        )?;
        bench.kernel(
            "newton-fog-exponential",
            Newton::default(),
            &skin.in_fog(thick),
            Depths::None,
        )?;
        skins::kernels(&mut bench)?;
        Ok(())
    }

    #[board::entry]
    fn main() -> ! {
        board::exit(run())
    }
}
