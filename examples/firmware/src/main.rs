//! The measured scenes on a microcontroller, in whole frames and in bands. The pictures have the same pixels as on the
//! host.
//!
//! `cargo run --profile speed -p firmware --target thumbv7em-none-eabi` runs the program under QEMU. The command needs
//! QEMU with the Arm and RISC-V boards, and `ld.lld`. Other targets are thumbv6m-none-eabi, thumbv7m-none-eabi,
//! thumbv8m.base-none-eabi, thumbv8m.main-none-eabi and riscv32imc-unknown-none-elf.
//!
//! The program first prints the number of instructions in a tick. For each mode, scene and layout, it then prints the
//! number of pixels that the models cover, the ticks of the draw calls, and a checksum of the picture. `simulator
//! --mode MODE --scene NAME --crc` prints the host's checksum. Mode fast has a tolerance of a quarter of a texel.
//!
//! For some of the scenes, the program then prints checksums of pictures that must be the same (`same`): in bands of
//! any height, drawn twice with or without clearing, and with the triangles in reverse order. At the end, the program
//! checks the bits of rotations, which must be the host's.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod bench;
#[cfg(target_os = "none")]
mod board;
#[cfg(target_os = "none")]
#[path = "../../common/mod.rs"]
mod common;
#[cfg(target_os = "none")]
mod nested;
#[cfg(target_os = "none")]
mod same;
#[cfg(target_os = "none")]
mod scene;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("firmware runs on a microcontroller: add --target thumbv7em-none-eabi");
}

#[cfg(target_os = "none")]
mod firmware {
    use crc32fast::Hasher;
    use fixel::mode::{Affine, Exact, Fast, Mode, Newton};
    use fixel::prelude::*;
    use semihosting::println;

    use super::bench::{Bench, Figures, Layout};
    use super::board::{self, Clock};
    use super::common::rotations;
    use super::same::Way;
    use super::scene::Scene;

    fn run() -> Result<(), Error> {
        let mut clock = Clock::take().expect("taken once");
        println!(
            "tick={} instructions",
            board::instructions_per_tick(&mut clock)
        );
        let mut bench = Bench::new(clock);
        run_mode(&mut bench, "exact", Exact)?;
        run_mode(&mut bench, "newton", Newton::default())?;
        run_mode(&mut bench, "fast", Fast::within(fx!(0.25)))?;
        run_mode(&mut bench, "affine", Affine)?;
        for way in Way::all() {
            let (name, crc) = (way.scene.name(), bench.checksum(way)?);
            println!("same scene={name} mode=newton way={way} crc={crc:08x}");
        }
        let mut bits = Hasher::new();
        for entry in rotations::entries() {
            bits.update(&entry.to_le_bytes());
        }
        assert_eq!(bits.finalize(), rotations::CRC, "the bits of rotations");
        Ok(())
    }

    /// Measures all scenes and layouts in one mode.
    fn run_mode<I: Mode>(bench: &mut Bench, mode_name: &str, mode: I) -> Result<(), Error> {
        let options = DrawOptions::new().with_mode(mode);
        for scene in Scene::ALL {
            for layout in Layout::ALL {
                let (name, layout_name) = (scene.name(), layout.name());
                let case = format_args!("scene={name} mode={mode_name} layout={layout_name}");
                let Figures {
                    pixels,
                    triangles,
                    ticks,
                    stack,
                    crc,
                } = bench.measure(scene, &options, layout)?;
                println!(
                    "{case} pixels={pixels} triangles={triangles} ticks={ticks} crc={crc:08x}"
                );
                println!("{case} stack={stack}");
            }
        }
        Ok(())
    }

    #[board::entry]
    fn main() -> ! {
        board::exit(run())
    }
}
