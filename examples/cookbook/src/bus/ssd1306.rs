//! A model of a panel of 128x64 pixels in black and white with an SSD1306.

use std::ops::RangeInclusive;

use super::Run;

/// The contents of the controller's registers and memory.
pub struct Panel {
    is_on: bool,
    columns: RangeInclusive<u8>,
    pages: RangeInclusive<u8>,
    /// The place of the next byte.
    column: u8,
    page: u8,
    is_horizontal: bool,
    /// The bytes in memory. A byte has 8 pixels of a column, with the topmost pixel in the least significant bit;
    /// `None` before the byte is written.
    memory: [[Option<u8>; 128]; 8],
}

impl Default for Panel {
    fn default() -> Self {
        Self {
            is_on: false,
            columns: 0..=127,
            pages: 0..=7,
            column: 0,
            page: 0,
            is_horizontal: false,
            memory: [[None; 128]; 8],
        }
    }
}

impl Panel {
    /// Executes commands and stores data. Panics at bytes that the data sheet does not allow in the panel's state.
    pub fn read(&mut self, runs: &[Run]) {
        for Run { is_data, bytes, .. } in runs {
            if *is_data {
                for &byte in bytes {
                    self.write(byte);
                }
            } else {
                self.execute(bytes);
            }
        }
    }

    /// Executes commands. The arguments of a command follow with D/C low, too.
    fn execute(&mut self, mut bytes: &[u8]) {
        while let [command, rest @ ..] = bytes {
            bytes = match (command, rest) {
                (0x20, [mode, rest @ ..]) => {
                    self.is_horizontal = *mode == 0;
                    rest
                }
                (0x21, &[first, last, ref rest @ ..]) => {
                    (self.columns, self.column) = (first..=last, first);
                    rest
                }
                (0x22, &[first, last, ref rest @ ..]) => {
                    (self.pages, self.page) = (first..=last, first);
                    rest
                }
                (0xaf, rest) => {
                    self.is_on = true;
                    rest
                }
                (0xae, rest) => {
                    self.is_on = false;
                    rest
                }
                // Contrast, charge pump, clock, lines, pins and voltages have an argument. Scroll, start line,
                // directions and inversion have none. None of these commands changes the memory.
                (0x81 | 0x8d | 0xa8 | 0xd3 | 0xd5 | 0xd9 | 0xda | 0xdb, [_, rest @ ..])
                | (0x2e | 0x40..=0x7f | 0xa0 | 0xa1 | 0xa4 | 0xa6 | 0xc0 | 0xc8, rest) => rest,
                (command, rest) => panic!("command {command:#04x} with {rest:02x?}"),
            };
        }
    }

    /// Stores a byte. In horizontal mode, the next byte goes to the next column, after the last column to the next
    /// page, and after the last page to the start of the window.
    fn write(&mut self, byte: u8) {
        assert!(self.is_horizontal, "the other modes are not modeled");
        self.memory[usize::from(self.page)][usize::from(self.column)] = Some(byte);
        let next = |at: u8, window: &RangeInclusive<u8>| {
            if at == *window.end() {
                *window.start()
            } else {
                at + 1
            }
        };
        self.column = next(self.column, &self.columns);
        if self.column == *self.columns.start() {
            self.page = next(self.page, &self.pages);
        }
    }

    /// Returns whether each pixel is lit, row by row. Panics if the panel is off or a pixel was never written.
    pub fn picture(&self) -> Vec<bool> {
        assert!(self.is_on, "the panel is off");
        (0..64 * 128)
            .map(|at| {
                let (row, column) = (at / 128, at % 128);
                let rows = self.memory[row / 8][column].expect("each byte was written");
                rows >> (row % 8) & 1 == 1
            })
            .collect()
    }
}
