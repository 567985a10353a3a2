//! A model of panels with the command set of MIPI DCS: ST7789, ILI9341, GC9A01, ILI9488.

use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::{Rgb565, Rgb666, Rgb888};

/// A command byte and the data bytes that follow it.
pub struct Command {
    /// The command byte.
    pub code: u8,
    /// Its data.
    pub data: Vec<u8>,
    /// The time at which the first byte of data began, in units of the time that the bus takes for a byte.
    pub start: u64,
}

/// The contents of a controller's registers and memory.
#[allow(clippy::struct_excessive_bools)] // one for each bit of the registers
pub struct Panel {
    /// The width and height of the memory if columns and rows are not exchanged.
    size: (u16, u16),
    is_awake: bool,
    is_on: bool,
    bits_per_pixel: u8,
    is_exchanged: bool,
    /// Whether the glass has blue where the controller has red, so that the program must exchange red and blue.
    is_blue_first: bool,
    /// The first and the last column of the window. Both belong to the window.
    columns: (u16, u16),
    rows: (u16, u16),
    /// The raw bits of each pixel, as they were sent; `None` for a pixel that was never sent.
    memory: Vec<Option<u32>>,
}

impl Panel {
    /// Returns a sleeping panel with a memory of this size.
    pub fn new(width: u16, height: u16) -> Self {
        Self {
            size: (width, height),
            is_awake: false,
            is_on: false,
            bits_per_pixel: 0,
            is_exchanged: false,
            is_blue_first: false,
            columns: (0, 0),
            rows: (0, 0),
            memory: vec![None; usize::from(width) * usize::from(height)],
        }
    }

    /// Returns the same panel, with a glass that has blue where the controller has red.
    #[must_use]
    pub fn with_blue_first(self) -> Self {
        Self {
            is_blue_first: true,
            ..self
        }
    }

    /// Executes commands. Panics at a command that the data sheets do not allow in the panel's state.
    pub fn read(&mut self, commands: &[Command]) {
        for Command { code, data, .. } in commands {
            match (code, data.as_slice()) {
                // SWRESET keeps the memory.
                (0x01, []) => (self.is_awake, self.is_on) = (false, false),
                (0x11, []) => self.is_awake = true,
                (0x29, []) => self.is_on = true,
                // NORON, INVOFF, INVON, TEOFF, TEON and the manufacturers' registers (voltages, timing, gamma) change
                // only the display, not the memory.
                (0x13 | 0x20 | 0x21 | 0x34, []) | (0x35, [_]) | (0x60.., _) => {}
                // MADCTL: bit 5 exchanges rows and columns. Bits 7 and 6 mirror rows and columns, so that the host
                // counts from the upper left corner of the rotated panel. Bit 3 exchanges red and blue.
                (0x36, &[mode]) => {
                    let is_blue_first = mode & 0b1000 != 0;
                    assert_eq!(
                        is_blue_first, self.is_blue_first,
                        "red and blue are exchanged"
                    );
                    self.is_exchanged = mode & 0b10_0000 != 0;
                }
                // COLMOD: bits 2 to 0 give the pixel format on the bus.
                (0x3a, &[format]) => {
                    self.bits_per_pixel = match format & 0b111 {
                        0b101 => 16,
                        0b110 => 18,
                        other => panic!("pixel format {other:#b}"),
                    };
                }
                (0x2a, data) => self.columns = window(data, self.size().0),
                (0x2b, data) => self.rows = window(data, self.size().1),
                (0x2c, data) => self.write(data),
                (code, data) => panic!("command {code:#04x} with {data:02x?}"),
            }
        }
    }

    /// The numbers of columns and rows, as the host counts them.
    fn size(&self) -> (u16, u16) {
        let (width, height) = self.size;
        if self.is_exchanged {
            (height, width)
        } else {
            (width, height)
        }
    }

    /// RAMWR: the pointer starts at the upper left corner of the window and moves right. After the last pixel of a row,
    /// it goes to the next row, and after the last row to the start of the window. A pixel of 16 bits has two bytes,
    /// with red in the upper five bits of the first byte. A pixel of 18 bits has three bytes, and uses the upper six
    /// bits of each byte.
    fn write(&mut self, data: &[u8]) {
        let bytes = match self.bits_per_pixel {
            16 => 2,
            18 => 3,
            other => panic!("{other} bits a pixel"),
        };
        assert!(data.len().is_multiple_of(bytes), "part of a pixel");
        let width = usize::from(self.size().0);
        let (mut column, mut row) = (self.columns.0, self.rows.0);
        for pixel in data.chunks_exact(bytes) {
            let color = match *pixel {
                [upper, lower] => u32::from(upper) << 8 | u32::from(lower),
                [red, green, blue] => [red, green, blue]
                    .iter()
                    .fold(0, |color, level| color << 6 | u32::from(level >> 2)),
                _ => unreachable!("a chunk has two or three bytes"),
            };
            self.memory[usize::from(row) * width + usize::from(column)] = Some(color);
            column += 1;
            if column > self.columns.1 {
                column = self.columns.0;
                row += 1;
            }
            if row > self.rows.1 {
                row = self.rows.0;
            }
        }
    }

    /// Returns the raw bits of the pixels, row by row from the upper left corner; `None` for a pixel that was never
    /// written. Panics if the panel is dark.
    pub fn pixels(&self) -> &[Option<u32>] {
        assert!(self.is_awake && self.is_on, "the panel is dark");
        &self.memory
    }

    /// Returns the raw bits of the `width` x `height` pixels at the upper left corner. Panics if the panel is dark, if
    /// one of these pixels was never written, or if another pixel was written.
    pub fn picture(&self, (width, height): (u32, u32)) -> Vec<u32> {
        let columns = u32::from(self.size().0);
        let mut picture = vec![];
        for (at, pixel) in (0..).zip(self.pixels()) {
            let (column, row) = (at % columns, at / columns);
            let is_inside = column < width && row < height;
            assert_eq!(pixel.is_some(), is_inside, "({column}, {row}) was written");
            picture.extend(pixel);
        }
        picture
    }

    /// Returns the color that the raw bits of a pixel mean.
    pub fn color(&self, raw: u32) -> Rgb888 {
        if self.bits_per_pixel == 16 {
            return Rgb565::from(RawU16::new(raw as u16)).into();
        }
        let [red, green, blue] = [12, 6, 0].map(|bit| (raw >> bit & 0x3f) as u8);
        Rgb666::new(red, green, blue).into()
    }
}

/// Reads the first and the last column or row of a window. Each number has two bytes, the more significant byte first.
fn window(data: &[u8], size: u16) -> (u16, u16) {
    let &[a, b, c, d] = data else {
        panic!("a window takes four bytes, not {data:02x?}");
    };
    let window = (u16::from_be_bytes([a, b]), u16::from_be_bytes([c, d]));
    assert!(
        window.0 <= window.1 && window.1 < size,
        "{window:?} of {size}"
    );
    window
}
