//! Anti-aliased lines.

use core::cell::Cell;
use core::ops::Range;

use embedded_graphics::geometry::Point;

use super::block::Block;
use super::edge::first_center;
use super::line::Course;
use super::scissor::meet;
use super::{ClippedVertex, Rasterizer, Scissor, point};
use crate::num::block::BlockFloat;
use crate::num::rsqrt::unit;
use crate::num::wide::product;

/// The share of each pixel that a line covers; by default, none.
///
/// ```text
///  share = half + ½ − distance, from 0 to 1        The distance leads from the pixel's center to the nearest point of
///                                                  the line between its ends, so the ends are round.
///        ╭──────────────────╮ ½
///      ╭─┼──────────────────┼─╮ half
///      │ a ─ ─ ─ ─ ─ ─ ─ ─ b  │      `across` is the distance from the line through both ends,
///      ╰─┼──────────────────┼─╯      `along` is the distance from a, along this line.
///        ╰──────────────────╯
/// ```
///
/// `direction` has an error of at most 1.3 · 2⁻²⁶, which moves a line by less than 2⁻¹² pixel at a distance of 4096
/// pixels in each direction. The distance of a pixel from the line is √(`across`² + e²), where e is how far the pixel
/// lies beyond an end (0 between the ends). `across`, e and the root are each cut to 2⁻¹⁰ pixel; the three cuts add an
/// error of (1 + √2) · 2⁻¹⁰. Beyond an end, `along` adds an error of 2⁻¹¹. Rounding the share to 256ths adds 2⁻⁹. In
/// all, the error is at most 1.3/256.
#[derive(Clone, Copy, Debug, Default)]
pub struct Coverage {
    /// The vector of length one from a toward b, in units of 2⁻²⁵.
    direction: [i32; 2],
    /// The distance from the line at the center of pixel (0, 0), in units of 2⁻²⁵ pixel, modulo 128 pixels. A pixel
    /// that is drawn is at most 36 pixels away from the line.
    across: i32,
    /// The distance from a along the line: `along` at the center of pixel (0, 0), `end` at b, in units of 2⁻¹⁷ pixel.
    /// The screen's 4096 pixels take 30 bits.
    along: i32,
    end: i32,
    /// Half the width plus half a pixel, in units of 2⁻¹⁰ pixel.
    reach: u32,
}

impl Coverage {
    fn new([a, b]: [[i32; 2]; 2], half: i32) -> Self {
        let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
        // A line without length is a disc, whatever its direction.
        let [x, y, _] = unit([dx.into(), dy.into(), 0]).unwrap_or([1 << 30, 0, 0]);
        let [ux, uy] = [x, y].map(|of_30_bits| (of_30_bits + (1 << 4)) >> 5);
        let [to_x, to_y] = [128 - a[0], 128 - a[1]];
        // Positions have 8 fraction bits.
        let dot =
            |[x, y]: [i32; 2], [u, v]: [i32; 2]| ((product(x, u) + product(y, v)) >> 8) as i32;
        let way = [ux >> 8, uy >> 8];
        Self {
            direction: [ux, uy],
            across: dot([to_x, to_y], [-uy, ux]),
            along: dot([to_x, to_y], way),
            end: dot([dx, dy], way),
            reach: ((half + 128) << 2).cast_unsigned(),
        }
    }

    /// The share of a pixel that is covered, in 256ths, rounded to nearest.
    #[inline]
    pub(crate) fn at(&self, pixel: Point) -> u32 {
        let ([ux, uy], Point { x, y }) = (self.direction, pixel);
        let dot = |u: i32, v: i32| x.wrapping_mul(u).wrapping_add(y.wrapping_mul(v));
        let across = self.across.wrapping_add(dot(-uy, ux));
        let along = self.along.wrapping_add(dot(ux >> 8, uy >> 8));
        let across = across.unsigned_abs() >> 15;
        // How far the pixel lies beyond one end or the other; 0 between the ends.
        let beyond = along
            .wrapping_neg()
            .max(along.wrapping_sub(self.end))
            .max(0);
        let beyond = beyond.cast_unsigned() >> 7;
        if across >= self.reach || beyond >= self.reach {
            return 0;
        }
        let distance = if beyond == 0 {
            across
        } else {
            // `across` and `beyond` are below 33 · 2^10, and so below 2^16.
            (across * across + beyond * beyond).isqrt()
        };
        let coverage = self.reach.saturating_sub(distance).min(1 << 10);
        (coverage + 2) >> 2
    }
}

/// Draws an anti-aliased line: each pixel that the line may cover, once. The blitter's shading reads from `coverage`
/// how much of each pixel is covered.
pub(crate) fn smooth_line(
    raster: &mut Rasterizer<'_>,
    [mut a, mut b]: [&ClippedVertex; 2],
    half: i32,
    coverage: &Cell<Coverage>,
) {
    // The ends are sorted from top to bottom, so that the direction of the line has no influence.
    let ([ax, ay], [bx, by]) = (a.vertex.screen, b.vertex.screen);
    if (ay, ax) > (by, bx) {
        (a, b) = (b, a);
    }
    let ends = [a.vertex.screen, b.vertex.screen];
    coverage.set(Coverage::new(ends, half));
    let strip = Strip::new(ends, half);
    let bounds = Scissor {
        columns: meet(&strip.bounds.columns, &raster.scissor.columns),
        rows: meet(&strip.bounds.rows, &raster.scissor.rows),
    };

    // Along the longer axis, varyings and depth keep the values of an end beyond that end.
    let is_steep = ax.abs_diff(bx) < ay.abs_diff(by);
    let major = |end: &ClippedVertex| {
        let [x, y] = end.vertex.screen;
        if is_steep { y } else { x }
    };
    let (low, high) = if major(a) <= major(b) { (a, b) } else { (b, a) };
    let steps = first_center(major(low))..first_center(major(high));
    let part = |steps: Range<i32>| {
        let Scissor { columns, rows } = bounds.clone();
        if is_steep {
            let rows = meet(&rows, &steps);
            Scissor { columns, rows }
        } else {
            let columns = meet(&columns, &steps);
            Scissor { columns, rows }
        }
    };
    for (end, beyond) in [(low, i32::MIN..steps.start), (high, steps.end..i32::MAX)] {
        let part = part(beyond);
        if !part.is_empty() {
            let places = [end.barycentric; 3];
            strip.draw(point::set_up(raster, &end.vertex, Some(&places)), &part);
        }
    }
    let part = part(steps);
    if !part.is_empty()
        && let Some(course) = Course::new(raster, [low, high])
    {
        strip.draw(course.block, &part);
    }
}

/// The pixels that a line may cover: a strip around the line, as long as the line's bounding box. The strip may be a
/// little too wide, because the shading leaves out pixels that are not covered.
struct Strip {
    bounds: Scissor,
    /// Where the line crosses the centers of row 0 (`middle`), how far the crossing moves from row to row (`slope`),
    /// and how far the strip reaches to either side of the crossing (`extent`), in units of 2⁻¹⁶ pixel.
    middle: i64,
    slope: i64,
    extent: i64,
}

impl Strip {
    /// The strip of a line. Its first end must not be below its second end.
    fn new([[ax, ay], [bx, by]]: [[i32; 2]; 2], half: i32) -> Self {
        let reach = half + 128;
        let pixels = |least: i32, most: i32| (least - reach) >> 8..((most + reach) >> 8) + 1;
        let bounds = Scissor {
            columns: pixels(ax.min(bx), ax.max(bx)),
            rows: pixels(ay, by),
        };
        let length = |side: i32| BlockFloat::new(side.into(), 0);
        // A level line takes all columns of its rows.
        let (slope, extent) = if ay == by {
            (0, 1 << 40)
        } else {
            let slope = length(bx - ax).over(length(by - ay)).at(16);
            // √(1 + s²) is at most 1 + (√2 - 1) s for s up to 1, and √2 - 1 is below 27/64; the same holds with 1 and s
            // exchanged. The slope is at most 2^20. The slope has a relative error of 1.3 · 2^-30 within 66 rows, or an
            // error of 2^-17 within 4096 rows. A quarter of a pixel is more than both of these errors.
            let (one, size) = (1 << 16, slope.abs());
            let across = size.max(one) + ((size.min(one) * 27) >> 6);
            (slope, ((i64::from(reach) * across) >> 8) + (1 << 14))
        };
        Self {
            bounds,
            middle: (i64::from(ax) << 8) + ((slope * i64::from(128 - ay)) >> 8),
            slope,
            extent,
        }
    }

    /// Draws a part of the bounding box.
    fn draw(&self, mut block: Block<'_>, part: &Scissor) {
        let [first, end] = [part.columns.start, part.columns.end].map(i64::from);
        let mut middle = self.middle + self.slope * i64::from(part.rows.start);
        for row in part.rows.clone() {
            // Columns whose centers lie between both sides of the strip.
            let column = |at: i64| ((at + (1 << 15)) >> 16).clamp(first, end) as i32;
            let columns = column(middle - self.extent)..column(middle + self.extent);
            if !columns.is_empty() {
                block.draw_alone(row, &columns);
            }
            middle += self.slope;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::picture::{Picture, clipped};
    use crate::{LineStyle, Scalar, fx};

    /// The share of each pixel that a line covers, in sixteenths, as a hexadecimal digit; f also means a whole pixel. A
    /// dot is a pixel without a share. The line's ends are in quarters of a pixel.
    fn shares(width: Scalar, ends: [[i32; 2]; 2]) -> std::vec::Vec<std::string::String> {
        let coverage = Cell::default();
        let mut picture = Picture::new(12, 7);
        let scissor = picture.scissor();
        let [from, to] = ends.map(|end| clipped(end.map(|at| at * 64)));
        let half = LineStyle::wide(width).unwrap().half();
        picture.draw(&scissor, |raster| {
            smooth_line(raster, [&from, &to], half, &coverage);
        });
        let drawn = picture.text();
        let share = |y: i32, x: i32, ink: char| {
            let share = coverage.get().at(Point::new(x, y));
            assert!(ink != '!', "{x} {y} is drawn twice");
            assert!(ink != '.' || share == 0, "{x} {y} is left out: {share}");
            match share {
                0 => '.',
                256 => 'f',
                _ => char::from_digit(share >> 4, 16).unwrap(),
            }
        };
        let row = |(y, inks): (i32, &std::string::String)| {
            let pixels = (0..).zip(inks.chars());
            pixels.map(|(x, ink)| share(y, x, ink)).collect()
        };
        (0..).zip(&drawn).map(row).collect()
    }

    #[test]
    fn shares_of_thin_and_wide_lines() {
        let thin = shares(fx!(1), [[6, 6], [38, 16]]);
        let expected = [
            "............",
            ".fb61.......",
            ".05afc72....",
            ".....49ed8..",
            "........38..",
            "............",
            "............",
        ];
        assert_eq!(thin, expected);
        let wide = shares(fx!(3), [[10, 10], [22, 16]]);
        let expected = [
            "..0.........",
            ".9fa3.......",
            "0ffffa3.....",
            ".9ffffe.....",
            "..3affe.....",
            "....383.....",
            "............",
        ];
        assert_eq!(wide, expected);
        // A line along pixel centers is sharp, and a line without length is a point.
        let level = shares(fx!(1), [[6, 6], [38, 6]]);
        assert_eq!(level[1], ".fffffffff..");
        assert_eq!([&level[0], &level[2]], ["............"; 2]);
        let point = shares(fx!(1), [[8, 8], [8, 8]]);
        let expected = [
            "............",
            ".44.........",
            ".44.........",
            "............",
        ];
        assert_eq!(point[..4], expected);
    }

    /// Draws each line from either end. The ends lie inside the scissor, at its borders, and beyond them.
    #[test]
    fn no_covered_pixel_is_left_out() {
        let places = [-70, -40, -3, 0, 2, 7, 15, 22, 31, 49, 70];
        for [a, b] in places.map(|a| places.map(|b| [a, b])).concat() {
            for [c, d] in places.map(|c| places.map(|d| [c, d])).concat() {
                for width in [fx!(1), fx!(7.3)] {
                    let from = shares(width, [[a, b], [c, d]]);
                    assert_eq!(from, shares(width, [[c, d], [a, b]]));
                }
            }
        }
    }
}
