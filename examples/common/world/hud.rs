//! The heads-up display: a compass, a map and two gauges. embedded-graphics draws them.

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::primitives::{Line, Primitive, PrimitiveStyle, Rectangle};
use embedded_graphics::text::{Alignment, Baseline, Text, TextStyleBuilder};
use fixel::prelude::*;

use super::map::{MAP, SIDE};

const INK: Rgb565 = Rgb565::new(30, 54, 22);
const SHADE: Rgb565 = Rgb565::new(3, 5, 6);

/// Panels with fewer rows than this show no compass and no names.
pub const LOW: u32 = 96;

/// The rows at the frame's top that the compass takes, with its needle.
pub const COMPASS: u32 = 16;

/// The state of the viewer that the display shows.
pub struct Status {
    /// The viewer's place on the map.
    pub place: Vec3,
    /// The direction of view, clockwise from north.
    pub heading: Angle,
    /// Health and lamp oil, in 256ths.
    pub gauges: [u32; 2],
}

impl Status {
    /// Draws everything for which there is room. A low panel has no compass.
    ///
    /// `size` is the size of the frame. A band does not know this size, because its bounding box contains only the
    /// band.
    pub fn draw<T: DrawTarget<Color = Rgb565>>(
        &self,
        target: &mut T,
        size: Size,
    ) -> Result<(), T::Error> {
        if size.height >= LOW {
            self.compass(target, size)?;
        }
        self.gauges(target, size)?;
        self.map(target, size)
    }

    /// The compass: a strip that spans half a turn, and turns with the viewer.
    pub(super) fn compass<T: DrawTarget<Color = Rgb565>>(
        &self,
        target: &mut T,
        size: Size,
    ) -> Result<(), T::Error> {
        let (middle, wide) = (size.width.cast_signed() / 2, size.width.cast_signed() / 4);
        let strip = Rectangle::new(Point::new(middle - wide, 2), Size::new(size.width / 2, 11));
        strip
            .into_styled(PrimitiveStyle::with_fill(SHADE))
            .draw(target)?;
        let style = MonoTextStyle::new(&FONT_6X10, INK);
        let centered = TextStyleBuilder::new()
            .alignment(Alignment::Center)
            .baseline(Baseline::Top)
            .build();
        for step in 0..16_u32 {
            // The angle from −½ to ½ turn, in units of 2^-32.
            let from_here = (Angle::from_bits(step << 28) - self.heading)
                .to_bits()
                .cast_signed();
            let x = ((i64::from(from_here) * i64::from(4 * wide)) >> 32) as i32;
            if x.abs() > wide - 4 {
                continue;
            }
            let name = ["N", "E", "S", "W"][step as usize / 4];
            if step % 4 == 0 {
                Text::with_text_style(name, Point::new(middle + x, 3), style, centered)
                    .draw(target)?;
            } else {
                let tick = Line::new(Point::new(middle + x, 8), Point::new(middle + x, 10));
                tick.into_styled(PrimitiveStyle::with_stroke(INK, 1))
                    .draw(target)?;
            }
        }
        let needle = Line::new(Point::new(middle, 13), Point::new(middle, 15));
        needle
            .into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 1))
            .draw(target)
    }

    /// Health and lamp oil, at the bottom left.
    fn gauges<T: DrawTarget<Color = Rgb565>>(
        &self,
        target: &mut T,
        size: Size,
    ) -> Result<(), T::Error> {
        /// A heart and a drop. Each row has eight pixels.
        const ICONS: [[u8; 7]; 2] = [
            [
                0b0110_1100,
                0b1111_1110,
                0b1111_1110,
                0b0111_1100,
                0b0011_1000,
                0b0001_0000,
                0,
            ],
            [
                0b0001_0000,
                0b0011_0000,
                0b0011_1000,
                0b0111_1000,
                0b0111_1100,
                0b0111_1100,
                0b0011_1000,
            ],
        ];
        let colors = [Rgb565::new(28, 12, 8), Rgb565::new(31, 44, 8)];
        let mut corner = Point::new(4, size.height.cast_signed() - 22);
        for ((icon, color), value) in ICONS.iter().zip(colors).zip(self.gauges) {
            let pixels = icon.iter().zip(0..).flat_map(|(row, y)| {
                (0..8)
                    .filter(move |x| row << x & 0x80 != 0)
                    .map(move |x| embedded_graphics::Pixel(corner + Point::new(x, y), color))
            });
            target.draw_iter(pixels)?;
            let wide = size.width / 5;
            let bar = Rectangle::new(corner + Point::new(11, 0), Size::new(wide, 6));
            bar.into_styled(PrimitiveStyle::with_fill(SHADE))
                .draw(target)?;
            let level = Rectangle::new(
                bar.top_left + Point::new(1, 1),
                Size::new((wide - 2) * value / 256, 4),
            );
            level
                .into_styled(PrimitiveStyle::with_fill(color))
                .draw(target)?;
            corner.y += 10;
        }
        Ok(())
    }

    /// The map with the viewer, at the bottom right.
    fn map<T: DrawTarget<Color = Rgb565>>(
        &self,
        target: &mut T,
        size: Size,
    ) -> Result<(), T::Error> {
        let scale = (size.width / 160).max(1);
        let side = SIDE as u32 * scale;
        let corner = Point::new(0, 0) + size - Size::new(side + 4, side + 4);
        let frame = Rectangle::new(corner - Point::new(1, 1), Size::new(side + 2, side + 2));
        frame
            .into_styled(PrimitiveStyle::with_stroke(INK, 1))
            .draw(target)?;
        let cells = (0..side * side).map(|at| {
            let (column, row) = ((at % side / scale) as usize, (at / side / scale) as usize);
            match MAP[row][column] {
                b'~' => Rgb565::new(6, 20, 20),
                b'#' | b'M' | b'%' | b'G' => Rgb565::new(20, 36, 17),
                b'H' => Rgb565::new(22, 24, 9),
                b',' | b'o' => Rgb565::new(12, 22, 9),
                b'L' => Rgb565::new(31, 52, 12),
                b'T' | b'C' | b'b' | b'h' => Rgb565::new(2, 14, 4),
                b' ' | b't' | b'c' => SHADE,
                _ => Rgb565::new(5, 18, 5),
            }
        });
        target.fill_contiguous(&Rectangle::new(corner, Size::new(side, side)), cells)?;
        let on_map = |place: Vec3| {
            let pixels = |at: Scalar| (at * Scalar::from(scale as u8)).floor();
            corner + Point::new(pixels(place.x), pixels(place.z))
        };
        let (sin, cos) = self.heading.sin_cos();
        let ahead = Vec3::new(fx!(3) * sin, fx!(0), fx!(-3) * cos);
        let sight = Line::new(on_map(self.place), on_map(self.place + ahead));
        sight
            .into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 1))
            .draw(target)?;
        let dot = Rectangle::with_center(on_map(self.place), Size::new(scale + 1, scale + 1));
        dot.into_styled(PrimitiveStyle::with_fill(Rgb565::WHITE))
            .draw(target)
    }
}
