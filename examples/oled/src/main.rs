//! A spinning model on a real display controller: the SSD0323 of a Stellaris LM3S6965 evaluation
//! board, a Cortex-M3 with 64 KiB of RAM, and its OLED of 128x64 pixels in 16 grays.
//!
//! ```sh
//! cargo run --config .cargo/oled.toml --release -p oled --target thumbv7m-none-eabi
//! ```
//!
//! runs it on the board that QEMU emulates. Where QEMU has a desktop to draw on (Debian:
//! qemu-system-gui) a window opens with the panel, each pixel 4x4; elsewhere QEMU says where a VNC
//! viewer finds it. The model turns for six seconds and then keeps its last pose, which the terminal
//! says. Ctrl-C or closing the window ends it.
//!
//! Each frame is drawn in bands of 16 rows, in 2 KiB of grays and 4 KiB of depths; a band is a
//! [`Canvas`](fixel::Canvas) with text of embedded-graphics over the model, and it shows itself on
//! the panel's `DrawTarget`. `board` has the chip's registers, `ssd0323` the controller's commands.
//!
//! ```sh
//! cargo run --release -p oled
//! ```
//!
//! draws the last frame on your computer, whole, into oled.png as QEMU's window shows it; `--frame`
//! draws another one. `.ci/oled` compares that picture with QEMU's, pixel by pixel.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[path = "../../common/mod.rs"]
mod common;

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
