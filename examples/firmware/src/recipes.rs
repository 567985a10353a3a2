//! The cookbook's scenes on a microcontroller. The pictures have the same pixels as on the host.
//!
//! `cargo run --profile speed -p firmware --bin recipes --target thumbv7em-none-eabi` prints a checksum of each
//! picture, the number of instructions that drew it, and the bytes of RAM that a program with this recipe needs.
//! `cargo run -p cookbook -- --crc` prints the host's checksums. One scene is missing: it starts a thread.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod board;
#[cfg(target_os = "none")]
#[path = "../../cookbook/src/scenes/mod.rs"]
mod scenes;
#[cfg(target_os = "none")]
#[path = "../../common/stack.rs"]
mod stack;
#[cfg(target_os = "none")]
#[path = "../../common/world/mod.rs"]
mod world;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("recipes runs on a microcontroller: add --target thumbv7em-none-eabi");
}

#[cfg(target_os = "none")]
mod firmware {
    use crc32fast::Hasher;
    use embedded_graphics::pixelcolor::raw::ToBytes;
    use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    use fixel::mode::Newton;
    use fixel::prelude::*;
    use semihosting::println;
    use static_cell::ConstStaticCell;

    use super::board::{self, Clock};
    use super::scenes::{Draw, Frame, SCENES};
    use super::{stack, world};

    const WIDTH: u32 = 320;
    const HEIGHT: u32 = 240;
    const PIXELS: usize = (WIDTH * HEIGHT) as usize;
    static COLORS: ConstStaticCell<[Rgb565; PIXELS]> =
        ConstStaticCell::new([Rgb565::BLACK; PIXELS]);
    static DEPTHS: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);

    /// The scenes to which the canvas is a display. They draw in memory of their own, which is on the stack.
    const SHOWN: [&str; 4] = ["bands", "packed", "panels", "terrain"];

    /// The little world at the moment that the cookbook shows.
    fn draw_world(canvas: &mut Frame<'_>) -> Result<(), Error> {
        world::draw(
            canvas,
            Newton::default(),
            Angle::from_bits(u32::MAX / 64 * 13),
        )
    }

    fn run() -> Result<(), Error> {
        let (colors, depths) = (COLORS.take(), DEPTHS.take());
        let mut clock = Clock::take().expect("taken once");
        let tick = board::instructions_per_tick(&mut clock);
        for &(name, draw) in SCENES.iter().chain(&[("world", draw_world as Draw)]) {
            colors.fill(Rgb565::BLACK);
            depths.fill(0);
            let mut canvas = Canvas::new(&mut *colors, WIDTH, HEIGHT)?.with_depth(depths)?;
            let ((drawn, ticks), stack) = stack::deepest(|| clock.time(|| draw(&mut canvas)));
            drawn?;
            let mut hasher = Hasher::new();
            for color in canvas.pixels() {
                hasher.update(&color.to_be_bytes());
            }
            let (crc, instructions) = (hasher.finalize(), ticks * tick);
            // A scene that leaves all depths equal works without a depth buffer.
            let has_depth = depths.iter().any(|&depth| depth != depths[0]);
            let buffers = if SHOWN.contains(&name) {
                0
            } else {
                size_of_val(colors) + usize::from(has_depth) * size_of_val(depths)
            };
            let ram = buffers + stack;
            println!("recipe {name} crc={crc:08x} instructions={instructions} RAM={ram}");
        }
        Ok(())
    }

    #[board::entry]
    fn main() -> ! {
        board::exit(run())
    }
}
