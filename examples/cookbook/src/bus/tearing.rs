//! Models when a panel reads its memory, and what it shows if the memory is written in this time.

use std::convert::Infallible;

use embedded_hal::digital::{ErrorType, InputPin};

use super::Wires;
use super::mipi::Command;

/// A panel's TE output (tearing effect). The output is high while the panel reads no row of its memory.
///
/// The panel reads its rows one after the other. A scan has [`Scan::LINES`] lines, and takes as long as the bus takes
/// for [`Scan::PERIOD`] bytes: there are 60 scans a second on a bus of 62.5 MHz. In the first [`Scan::BLANK`] lines,
/// the panel pauses, like an ST7789 after a reset.
pub struct Scan(pub Wires);

impl Scan {
    /// The duration of a scan, in units of the time that the bus takes for a byte.
    pub const PERIOD: u64 = 62_500_000 / 8 / 60;
    /// The number of lines of a scan. All lines take the same time.
    pub const LINES: u64 = 320 + Self::BLANK;
    /// The number of lines at the start of a scan in which the panel reads no row.
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

/// A pin that a program reads in place of [`Scan`]. With this pin, the program does not wait for the panel. Time passes
/// only for drawing, 1.1 ms per frame.
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

/// Returns the picture that a panel of `side` x `side` pixels shows in a scan of its memory, while `commands` write
/// whole frames of 16 bits a pixel. Each pixel has the color that was last written before the pixel was read.
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
