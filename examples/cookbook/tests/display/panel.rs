//! A model of a panel with an ST7789 or ILI9341, and wires that record what is sent to it.
//!
//! The driver gets a bus and pins that record every byte with the level of the D/C line (low: command, high: data).
//! [`Panel::read`] then interprets the bytes as the controllers' data sheets specify. It uses no code of the driver or
//! of this crate.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::convert::Infallible;
use std::rc::Rc;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{self, OutputPin};
use embedded_hal::spi::{self, Operation, SpiDevice};

/// Both ends of the wires, shared with the code that connected them.
#[derive(Clone, Default)]
pub struct Wires(Rc<RefCell<Record>>);

#[derive(Default)]
struct Record {
    data: bool,
    commands: Vec<Command>,
}

/// A command byte and the data bytes that follow it.
pub struct Command {
    pub code: u8,
    pub data: Vec<u8>,
}

impl Wires {
    /// Takes everything that was sent since the last call.
    pub fn take(&self) -> Vec<Command> {
        std::mem::take(&mut self.0.borrow_mut().commands)
    }
}

impl spi::ErrorType for Wires {
    type Error = Infallible;
}

impl SpiDevice for Wires {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let record = &mut *self.0.borrow_mut();
        for operation in operations {
            let Operation::Write(bytes) = operation else {
                panic!("the panel has no line to read from");
            };
            if record.data {
                let command = record
                    .commands
                    .last_mut()
                    .expect("data bytes follow a command");
                command.data.extend_from_slice(bytes);
            } else {
                record
                    .commands
                    .extend(bytes.iter().map(|&code| Command { code, data: vec![] }));
            }
        }
        Ok(())
    }
}

/// The D/C line.
impl digital::ErrorType for Wires {
    type Error = Infallible;
}

impl OutputPin for Wires {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().data = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().data = true;
        Ok(())
    }
}

/// A delay that returns at once, because the record has no times.
pub struct NoDelay;

impl DelayNs for NoDelay {
    fn delay_ns(&mut self, _: u32) {}
}

/// Width and height of the controllers' memory while columns and rows are not exchanged.
const MEMORY: (u16, u16) = (240, 320);

/// The contents of a controller's registers and memory.
#[derive(Default)]
pub struct Panel {
    awake: bool,
    on: bool,
    bits_per_pixel: u8,
    exchanged: bool,
    /// The window's first and last column, both inclusive.
    columns: (u16, u16),
    rows: (u16, u16),
    /// The pixels written so far: column, row, RGB565.
    memory: BTreeMap<(u16, u16), u16>,
}

impl Panel {
    /// Executes commands; panics at a command that the data sheets do not allow here.
    pub fn read(&mut self, commands: &[Command]) {
        for Command { code, data } in commands {
            match (code, data.as_slice()) {
                // SWRESET.
                (0x01, []) => *self = Self::default(),
                (0x11, []) => self.awake = true,
                (0x29, []) => self.on = true,
                // NORON, INVOFF, INVON, and the ILI9341's inversion control change only the display, not the memory.
                (0x13 | 0x20 | 0x21, []) | (0xb4, &[0]) => {}
                // MADCTL: bit 5 exchanges rows and columns, and bits 7 and 6 mirror them, so that the host counts from
                // the upper left corner of the rotated panel. Bit 3 puts blue before red.
                (0x36, &[mode]) => {
                    assert_eq!(mode & 0b1000, 0, "blue and red are exchanged");
                    self.exchanged = mode & 0b10_0000 != 0;
                }
                // COLMOD: bits 2 to 0 give the pixel format on the bus.
                (0x3a, &[format]) => {
                    self.bits_per_pixel = match format & 0b111 {
                        0b011 => 12,
                        0b101 => 16,
                        0b110 => 18,
                        other => panic!("unknown pixel format: {other:#b}"),
                    };
                }
                (0x2a, data) => self.columns = window(data, self.size().0),
                (0x2b, data) => self.rows = window(data, self.size().1),
                (0x2c, data) => self.write(data),
                (code, data) => panic!("command {code:#04x} with {data:02x?}"),
            }
        }
    }

    /// Columns and rows as the host counts them.
    fn size(&self) -> (u16, u16) {
        let (columns, rows) = MEMORY;
        if self.exchanged {
            (rows, columns)
        } else {
            MEMORY
        }
    }

    /// RAMWR: the pointer starts at the window's upper left corner and moves right. At the end of a row it goes to the
    /// start of the next one, and at the end of the window back to the window's start. Red is in the upper five bits of
    /// the first byte.
    fn write(&mut self, data: &[u8]) {
        assert_eq!(self.bits_per_pixel, 16);
        let (mut column, mut row) = (self.columns.0, self.rows.0);
        assert!(data.len().is_multiple_of(2), "half a pixel");
        for pixel in data.chunks_exact(2) {
            let color = u16::from(pixel[0]) << 8 | u16::from(pixel[1]);
            self.memory.insert((column, row), color);
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

    /// The `width` x `height` pixels from the upper left corner. Panics if the panel is dark, if one of these pixels
    /// was never written, or if a pixel outside them was.
    pub fn picture(&self, (width, height): (u32, u32)) -> Vec<u16> {
        assert!(self.awake && self.on, "the panel is dark");
        let picture: Vec<_> = (0..height)
            .flat_map(|row| (0..width).map(move |column| (column, row)))
            .map(|(column, row)| {
                let at = (u16::try_from(column).unwrap(), u16::try_from(row).unwrap());
                *self
                    .memory
                    .get(&at)
                    .unwrap_or_else(|| panic!("{at:?} was not written"))
            })
            .collect();
        assert_eq!(
            picture.len(),
            self.memory.len(),
            "written outside the picture"
        );
        picture
    }
}

/// The first and the last column or row, each in two bytes, the more significant one first.
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
