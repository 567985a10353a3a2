//! A spinning model on a real display controller: the SSD0323 of a Stellaris LM3S6965 evaluation
//! board, a Cortex-M3 with 64 KiB of RAM, and its OLED of 128x64 pixels in 16 grays.
//!
//! This command runs it on the board that QEMU emulates:
//!
//! ```sh
//! cargo run --config .cargo/oled.toml --profile speed -p firmware --bin oled --target thumbv7m-none-eabi
//! ```
//!
//! If QEMU has a desktop to draw on (Debian: qemu-system-gui), it opens a window with the panel, in which a pixel takes
//! 4x4 pixels. Otherwise it prints an address for a VNC viewer. The model turns for six seconds and then stays in its
//! last pose, which the terminal reports. Ctrl-C or closing the window ends the program.
//!
//! Each frame is drawn in bands of 16 rows, in 2 KiB of grays and 4 KiB of depths. A band is a
//! [`Canvas`](fixel::Canvas), with text by embedded-graphics over the model; the program copies it to the panel, which
//! is a `DrawTarget`. `board` has the chip's registers, and `ssd0323` the controller's commands.
//!
//! This command draws the last frame in one piece on your computer, and writes it to oled.png as QEMU's window shows
//! it:
//!
//! ```sh
//! cargo run --release -p firmware --bin oled
//! ```
//!
//! `--frame` selects another frame. `.ci/oled` compares this picture with QEMU's, pixel by pixel.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[path = "../../../common/gyroscope.rs"]
mod gyroscope;

#[cfg(target_os = "none")]
mod board;
#[cfg(target_os = "none")]
mod firmware;
#[cfg(target_os = "none")]
mod ssd0323;

#[cfg(not(target_os = "none"))]
mod host;

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    match host::run() {
        Ok(()) => std::process::ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            std::process::ExitCode::FAILURE
        }
    }
}
