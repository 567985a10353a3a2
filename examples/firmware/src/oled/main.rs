//! A spinning model on a real display controller: the SSD0323 of a Stellaris LM3S6965 evaluation board. The board has a
//! Cortex-M3 with 64 KiB of RAM, and an OLED of 128x64 pixels in 16 grays.
//!
//! This command runs the program on the board that QEMU emulates:
//!
//! ```sh
//! cargo run --config .cargo/oled.toml --profile speed -p firmware --bin oled --target thumbv7m-none-eabi
//! ```
//!
//! If QEMU can open windows (Debian: qemu-system-gui), it shows the panel in a window, with 4x4 pixels for each pixel
//! of the panel. Otherwise, it prints an address for a VNC viewer. The model turns for six seconds, and then stays in
//! its last pose, which the terminal reports. Ctrl-C or closing the window ends the program.
//!
//! Each frame is drawn in bands of 16 rows, with 2 KiB of grays and 4 KiB of depths. A band is a
//! [`Canvas`](fixel::Canvas), with text by embedded-graphics over the model. The program copies the band to the panel,
//! which is a `DrawTarget`. `board` has the chip's registers, and `ssd0323` has the controller's commands.
//!
//! This command draws the last frame as a whole on your computer, and writes it to oled.png as it looks in QEMU's
//! window:
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
