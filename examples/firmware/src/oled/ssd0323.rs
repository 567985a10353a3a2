//! The SSD0323, a display controller with 16 grays and two pixels in a byte.

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::{Gray4, GrayColor};
use embedded_graphics::primitives::{PointsIter, Rectangle};

use super::board::Oled;

const WIDTH: usize = 128;
const HEIGHT: usize = 64;

/// Commands that prepare the controller for the board's panel, an OSRAM Pictiva. QEMU's panel ignores most of the
/// commands, but a real panel needs them.
const READY: [&[u8]; 16] = [
    &[0xae],       // display off
    &[0x81, 50],   // contrast, at most 127
    &[0x85],       // half of the current range
    &[0xa0, 0x52], // odd and even rows wired to opposite sides, from below; left pixel in the high nibble; row by row
    &[0xa1, 0],    // first line
    &[0xa2, 76],   // offset of the lines, which the order of rows needs
    &[0xa4],       // show the memory
    &[0xa8, 63],   // number of rows, minus 1
    &[0xb1, 0x22], // clocks of reset and pre-charge
    &[0xb2, 70],   // clocks of a row
    &[0xb3, 0xf1], // fastest oscillator, halved
    &[0xbf, 0x0d], // voltage of dark segments
    &[0xbe, 0x02], // voltage of idle rows
    &[0xbc, 0x10], // voltage of pre-charge
    // Pulse widths of the grays, in about equal steps.
    &[0xb8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76],
    &[0xad, 0x03], // voltage converter on
];
const COLUMNS: u8 = 0x15;
const ROWS: u8 = 0x75;
const ON: u8 = 0xaf;

/// The panel.
///
/// A byte has two pixels, and the controller's memory cannot be read. So the driver keeps a copy of the picture, which
/// takes 4 KiB.
pub struct Ssd0323 {
    wires: Oled,
    shown: [[u8; WIDTH / 2]; HEIGHT],
}

impl Ssd0323 {
    /// Sets up the controller, and switches the panel on with all pixels black.
    pub fn new(wires: Oled) -> Self {
        let mut panel = Self {
            wires,
            shown: [[0; WIDTH / 2]; HEIGHT],
        };
        for command in READY {
            panel.wires.command(command);
        }
        panel.send(&panel.bounding_box());
        panel.wires.command(&[ON]);
        panel
    }

    /// Stores a pixel in the copy. Pixels outside the panel are ignored.
    fn keep(&mut self, point: Point, color: Gray4) {
        let Ok(x) = usize::try_from(point.x) else {
            return;
        };
        let row = usize::try_from(point.y)
            .ok()
            .and_then(|y| self.shown.get_mut(y));
        if let Some(byte) = row.and_then(|row| row.get_mut(x / 2)) {
            *byte = match x % 2 {
                0 => *byte & 0x0f | color.luma() << 4,
                _ => *byte & 0xf0 | color.luma(),
            };
        }
    }

    /// Sends an area of the stored picture. The area is enlarged to whole bytes.
    fn send(&mut self, area: &Rectangle) {
        let area = area.intersection(&self.bounding_box());
        let Some(end) = area.bottom_right() else {
            return;
        };
        // The area lies on the panel, so all numbers are between 0 and 127.
        let [left, right] = [area.top_left.x, end.x].map(|x| x.cast_unsigned() as u8 / 2);
        let [top, bottom] = [area.top_left.y, end.y].map(|y| y.cast_unsigned() as u8);
        self.wires.command(&[COLUMNS, left, right]);
        self.wires.command(&[ROWS, top, bottom]);
        for row in &self.shown[top.into()..=bottom.into()] {
            self.wires.data(&row[left.into()..=right.into()]);
        }
    }
}

impl OriginDimensions for Ssd0323 {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT as u32)
    }
}

impl DrawTarget for Ssd0323 {
    type Color = Gray4;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Gray4>>,
    {
        for Pixel(point, color) in pixels {
            self.keep(point, color);
            self.send(&Rectangle::new(point, Size::new(1, 1)));
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Gray4>,
    {
        for (point, color) in area.points().zip(colors) {
            self.keep(point, color);
        }
        self.send(area);
        Ok(())
    }
}
