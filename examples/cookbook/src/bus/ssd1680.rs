//! A model of electronic paper with an SSD1680 or SSD1675: 122x250 pixels in black and white.

use super::mipi::Command;

/// The number of bytes in a row of memory. A row has 122 pixels on the glass, and 6 pixels that are not on the glass.
const STRIDE: usize = 16;
const ROWS: usize = 250;

/// A memory of the controller. A byte has 8 pixels side by side, with the leftmost in the most significant bit.
type Memory = [[u8; STRIDE]; ROWS];

/// The contents of the controller's registers and memories, and the picture on the paper.
pub struct Panel {
    /// Two memories: the picture to show, and the picture that a quick refresh assumes to be on the paper.
    new: Memory,
    old: Memory,
    /// The first and the last column of bytes, and the first and the last row.
    columns: (usize, usize),
    rows: (usize, usize),
    at: (usize, usize),
    /// The code of the steps that the next activation takes.
    update: u8,
    /// Whether the waveforms drive all pixels, instead of only the pixels that differ.
    is_full: bool,
    /// The picture on the paper: white (1) before the first refresh.
    pub paper: Memory,
    /// For each refresh so far: whether it was a full refresh, and the number of pixels that changed their color.
    pub refreshes: Vec<(bool, u32)>,
}

impl Default for Panel {
    fn default() -> Self {
        Self {
            new: [[0; STRIDE]; ROWS],
            old: [[0; STRIDE]; ROWS],
            columns: (0, 0),
            rows: (0, 0),
            at: (0, 0),
            update: 0,
            is_full: true,
            paper: [[0xff; STRIDE]; ROWS],
            refreshes: vec![],
        }
    }
}

impl Panel {
    /// Executes commands. Panics at a command that the data sheet does not allow in the panel's state.
    pub fn read(&mut self, commands: &[Command]) {
        for Command { code, data, .. } in commands {
            match (code, data.as_slice()) {
                (0x11, &[mode]) => assert_eq!(mode, 0b011, "x, then y, both upward"),
                (0x44, &[first, last]) => self.columns = (first.into(), last.into()),
                (0x45, &[a, b, c, d]) => {
                    let row = |low, high| usize::from(u16::from_le_bytes([low, high]));
                    self.rows = (row(a, b), row(c, d));
                }
                (0x4e, &[column]) => self.at.0 = column.into(),
                (0x4f, &[low, high]) => self.at.1 = u16::from_le_bytes([low, high]).into(),
                (0x24, data) => {
                    self.at = write(&mut self.new, self.at, [self.columns, self.rows], data);
                }
                (0x26, data) => {
                    self.at = write(&mut self.old, self.at, [self.columns, self.rows], data);
                }
                // The table of waveforms. In a full refresh, pixels that stay black or white (the first and the fourth
                // group of seven bytes) are driven, too.
                (0x32, table) => self.is_full = table[0] != 0,
                (0x22, &[update]) => self.update = update,
                (0x20, []) if self.update & 0b100 != 0 => self.refresh(),
                // These commands have no effect in the model: an activation that only starts or stops the voltages;
                // SWRESET; settings of voltages, borders and timing.
                (0x20 | 0x12, []) | (0x01 | 0x03 | 0x04 | 0x0f | 0x2c | 0x3a | 0x3b | 0x3c, _) => {}
                (code, data) => panic!("command {code:#04x} with {data:02x?}"),
            }
        }
    }

    /// A full refresh shows the new picture. A quick refresh drives only the pixels that differ between the two
    /// memories.
    fn refresh(&mut self) {
        let mut changed = 0;
        for row in 0..ROWS {
            for column in 0..STRIDE {
                let (new, old) = (self.new[row][column], self.old[row][column]);
                let paper = &mut self.paper[row][column];
                let driven = if self.is_full { 0xff } else { new ^ old };
                let shown = *paper & !driven | new & driven;
                changed += (*paper ^ shown).count_ones();
                *paper = shown;
            }
        }
        self.refreshes.push((self.is_full, changed));
    }
}

/// Writes bytes from a place on, row by row within a window. Returns the place of the next byte.
fn write(
    memory: &mut Memory,
    (mut column, mut row): (usize, usize),
    [columns, rows]: [(usize, usize); 2],
    data: &[u8],
) -> (usize, usize) {
    for &byte in data {
        memory[row][column] = byte;
        column += 1;
        if column > columns.1 {
            column = columns.0;
            row += 1;
        }
        if row > rows.1 {
            row = rows.0;
        }
    }
    (column, row)
}
