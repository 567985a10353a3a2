//! Texts about what went wrong, on a display of any size.

use core::fmt::{self, Write};
use core::panic::PanicInfo;

use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X13};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::text::{Baseline, Text};
use fixel::canvas::{Canvas, DepthBuffer, Storage};
use heapless::String;

/// A text in lines that fit on the display. What does not fit is left out.
pub struct Report {
    size: (u32, u32),
    lines: String<512>,
    /// The characters in the last line.
    column: u32,
}

impl Report {
    /// An empty report for a display of this size.
    #[must_use]
    pub const fn new(size: (u32, u32)) -> Self {
        Self {
            size,
            lines: String::new(),
            column: 0,
        }
    }

    /// The text of a panic: what went wrong, and then where, because a small display has no room for both.
    #[must_use]
    pub fn of(info: &PanicInfo, size: (u32, u32)) -> Self {
        let mut report = Self::new(size);
        // A report returns no errors.
        write!(report, "{}", info.message()).ok();
        if let Some(location) = info.location() {
            let file = location.file().rsplit(['/', '\\']).next();
            write!(report, "\n{}:{}", file.unwrap_or_default(), location.line()).ok();
        }
        report
    }

    /// The corner of the first line. A round display shows lines from here on.
    const fn corner(&self) -> (u32, u32) {
        (self.size.0 / 20, self.size.1 * 3 / 10)
    }

    /// Draws the text on a frame, or on a band of it.
    #[inline(never)] // a program draws its messages, too
    pub fn draw<O: Storage<Rgb565>, D: DepthBuffer>(&self, canvas: &mut Canvas<'_, Rgb565, O, D>) {
        let (left, top) = self.corner();
        let corner = Point::new(left.cast_signed(), top.cast_signed());
        let style = MonoTextStyle::new(&FONT_6X13, Rgb565::WHITE);
        canvas.clear(Rgb565::BLACK);
        canvas.overlay(&Text::with_baseline(
            &self.lines,
            corner,
            style,
            Baseline::Top,
        ));
    }
}

impl Write for Report {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let columns = (self.size.0 - 2 * self.corner().0) / FONT_6X13.character_size.width;
        for character in text.chars() {
            if self.column == columns && character != '\n' {
                self.lines.push('\n').ok();
                self.column = 0;
            }
            self.lines.push(character).ok();
            self.column = if character == '\n' {
                0
            } else {
                self.column + 1
            };
        }
        Ok(())
    }
}
