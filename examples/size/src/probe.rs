//! What the size probes have in common: a model, memory, time, and how deep the stack went.
//!
//! Every probe links all of the model and the texture, the baseline too, so that what a probe has
//! beyond the baseline is code of the library and of the few lines that call it.

// The baseline has no use for what is drawn.
#![allow(dead_code)]

use core::hint::black_box;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::prelude::*;

/// Width of the picture in pixels.
pub const WIDTH: u32 = 160;
/// Height of the picture in pixels.
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
pub static SKIN: TextureArray<Rgb565, 2, 2> =
    TextureArray::rgb565(&[0xff, 0xff, 0xf8, 0x00, 0xf8, 0x00, 0xff, 0xff]);

/// Before the eye, and so near that the near plane of [`projection`](fn@projection) cuts it: clipping runs.
pub const PLACE: Vec3 = vec3!(0, 0, -1.5);

/// The projection of the probes.
pub fn projection() -> Result<Projection<fixel::view::Perspective>, Error> {
    Projection::perspective(Angle::from_degrees(60), (WIDTH, HEIGHT), fx!(1), fx!(100))
}

/// A turn every 5 seconds, or nearly so: `now_ms` in units of 2^-32 of a turn.
pub fn angle(now_ms: u64) -> Angle {
    Angle::from_bits((now_ms as u32).wrapping_mul(858_993))
}

/// Frames of one second, by the probe's `draw`: it is given pixels, depths and milliseconds.
fn frames(pixels: &mut [Rgb565], depths: &mut [u16]) {
    const FRAMES: u64 = 4;
    for frame in 0..FRAMES {
        // Nothing can be worked out while compiling that is known at run time only.
        let now_ms = black_box(frame * 250);
        black_box((&MODEL, &SKIN));
        if super::draw(pixels, depths, now_ms).is_err() {
            // Constant numbers, which the constructors accept.
            #[allow(clippy::empty_loop)] // `.ci/sizes` ends a program that does not end
            loop {}
        }
        black_box((&*pixels, &*depths));
    }
}

/// What a probe does on the host: the same frames, for the compiler to see.
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
#[path = "../../common/stack.rs"]
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

    /// Prints a number, without the formatting of core, which can panic.
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
