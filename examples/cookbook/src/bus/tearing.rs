//! When a panel reads its memory, and what it shows while the memory is written.

use std::convert::Infallible;

use embedded_hal::digital::{ErrorType, InputPin};

use super::Wires;
use super::mipi::Command;

/// A panel's output for the tearing effect: high while the panel reads no row from its memory.
///
/// The panel reads its rows in turn, [`Scan::LINES`] lines in [`Scan::PERIOD`] times of a byte: 60 times a second on a
/// bus of 62.5 MHz. The first [`Scan::BLANK`] lines are the pause, as ST7789 does it after a reset.
pub struct Scan(pub Wires);

impl Scan {
    /// The time of a scan.
    pub const PERIOD: u64 = 62_500_000 / 8 / 60;
    /// Lines of a scan, each as long as the others.
    pub const LINES: u64 = 320 + Self::BLANK;
    /// Lines at its beginning in which no row is read.
    pub const BLANK: u64 = 24;

    /// Returns the time at which the panel reads a row of a frame.
    pub fn time(frame: u64, row: u64) -> u64 {
        frame * Self::PERIOD + (Self::BLANK + row) * Self::PERIOD / Self::LINES
    }
}

impl ErrorType for Scan {
    type Error = Infallible;
}

impl InputPin for Scan {
    fn is_high(&mut self) -> Result<bool, Infallible> {
        self.0.wait(8); // about a microsecond
        let now = self.0.now() % Self::PERIOD;
        Ok(now < Self::time(0, 0))
    }

    fn is_low(&mut self) -> Result<bool, Infallible> {
        Ok(!self.is_high()?)
    }
}

/// A pin that a program reads in place of [`Scan`], and that lets it wait for nothing but the 1.1 ms in which it draws.
pub struct Ignored(pub Wires);

impl ErrorType for Ignored {
    type Error = Infallible;
}

impl InputPin for Ignored {
    fn is_high(&mut self) -> Result<bool, Infallible> {
        self.0.wait(9000);
        Ok(false)
    }

    fn is_low(&mut self) -> Result<bool, Infallible> {
        Ok(false)
    }
}

/// Returns what a panel of `side` x `side` pixels shows in a scan of its memory, while `commands` write whole frames of
/// 16 bits a pixel: for each pixel, the color that was the last to be written before it was read.
pub fn scanned(commands: &[Command], scan: u64, side: u32) -> Vec<Option<u16>> {
    let frames = commands.iter().filter(|command| command.code == 0x2c);
    let frames: Vec<_> = frames.collect();
    let pixels = 0..u64::from(side * side);
    let color = |at: u64| {
        let now = Scan::time(scan, at / u64::from(side));
        let written = |frame: &&&Command| frame.start + 2 * at + 2 <= now;
        let frame = frames.iter().rev().find(written)?;
        let bytes = frame.data.get(2 * at as usize..)?.first_chunk()?;
        Some(u16::from_be_bytes(*bytes))
    };
    pixels.map(color).collect()
}
