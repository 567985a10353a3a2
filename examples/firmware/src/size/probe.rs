//! The parts that all size probes share: a model, memory, time, and a report of the depth of the stack.
//!
//! Every probe, including the baseline, links the whole model and the texture. So the code that a probe has and the
//! baseline lacks is code of the library, or the few lines that call the library.

// The baseline does not use the parts for drawing.
#![allow(dead_code)]

use core::hint::black_box;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;

/// The width of the picture in pixels.
pub const WIDTH: u32 = 160;
/// The height of the picture in pixels.
pub const HEIGHT: u32 = 120;
const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// A ball with all attributes that a mesh can have.
pub static MODEL: Mesh = Mesh::checked(BALL.with_colors(&COLORS, None));
static BALL: Mesh = shape!(sphere(16, 8));
static COLORS: [Rgb888; 17 * 9] = {
    let mut colors = [Rgb888::new(0, 0, 0); 17 * 9];
    let mut at = 0;
    while at < colors.len() {
        #[allow(clippy::cast_possible_truncation)] // below 153
        let level = at as u8;
        colors[at] = Rgb888::new(level, 255 - level, 128);
        at += 1;
    }
    colors
};

/// A texture.
pub static SKIN: [[Rgb565; 2]; 2] = [[Rgb565::WHITE, Rgb565::RED], [Rgb565::RED, Rgb565::WHITE]];

/// A position in front of the eye. The position is so close that the near plane of [`projection`](fn@projection) cuts
/// the model, and clipping runs.
pub const PLACE: Vec3 = vec3!(0, 0, -1.5);

/// The projection of the probes.
pub fn projection() -> Result<Projection<fixel::view::Perspective>, Error> {
    Projection::perspective(Angle::from_degrees(60), (WIDTH, HEIGHT), fx!(1), fx!(100))
}

/// The angle at a time: about one turn in 5 seconds.
pub fn angle(now_ms: u64) -> Angle {
    Angle::from_bits((now_ms as u32).wrapping_mul(858_993))
}

/// Draws the frames of one second with the probe's `draw`, which gets pixels, depths and milliseconds.
fn frames(pixels: &mut [Rgb565], depths: &mut [u16]) {
    const FRAMES: u64 = 4;
    for frame in 0..FRAMES {
        // Hide run-time values from the compiler, so that it cannot compute with them at compile time.
        let now_ms = black_box(frame * 250);
        black_box((&MODEL, &SKIN));
        if super::draw(pixels, depths, now_ms).is_err() {
            // This never happens: the numbers are constant, and the constructors accept them.
            #[allow(clippy::empty_loop)] // `.ci/sizes` stops a program that does not end
            loop {}
        }
        black_box((&*pixels, &*depths));
    }
}

/// The probe on the host. The host draws the same frames, so that the compiler checks the code.
#[cfg(not(target_os = "none"))]
pub fn host() {
    let mut pixels = vec![Rgb565::new(0, 0, 0); PIXELS];
    frames(&mut pixels, &mut vec![0; PIXELS]);
    let drawn = pixels
        .iter()
        .filter(|&&p| p != Rgb565::new(0, 0, 0))
        .count();
    println!("{drawn} pixels drawn; a size probe is for microcontrollers: see .ci/sizes");
}

#[cfg(target_os = "none")]
#[path = "../../../common/stack.rs"]
mod stack;

#[cfg(target_os = "none")]
mod board {
    use cortex_m_rt::entry;
    use embedded_graphics::pixelcolor::Rgb565;
    use panic_never as _;
    use semihosting::io::{self, Write};
    use semihosting::process;

    use super::{PIXELS, stack};

    #[entry]
    fn main() -> ! {
        static mut COLOR: [Rgb565; PIXELS] = [Rgb565::new(0, 0, 0); PIXELS];
        static mut DEPTH: [u16; PIXELS] = [0; PIXELS];
        let ((), stack) = stack::deepest(|| super::frames(COLOR, DEPTH));
        report(stack);
        process::exit(0)
    }

    /// Prints a number without the formatting of `core`, which can panic.
    fn report(mut number: usize) {
        let mut line = *b"stack=0000000\n";
        for digit in line[6..13].iter_mut().rev() {
            *digit += (number % 10) as u8;
            number /= 10;
        }
        if let Ok(mut console) = io::stdout() {
            let _ = console.write(&line);
        }
    }
}
