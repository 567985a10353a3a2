//! The legend: rows below a plot that explain its marks and lines.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{INK, LABEL};
use crate::Result;

/// A mark on the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    Circle,
    Square,
    Triangle,
    Diamond,
    Wedge,
    Plus,
    Cross,
    /// A piece of a solid line.
    Line,
    /// A piece of a dashed line.
    Dashes,
    /// The range of errors, drawn below a mark.
    Reach,
}

impl Mark {
    /// The marks of points.
    pub const POINTS: [Self; 7] = [
        Self::Circle,
        Self::Square,
        Self::Triangle,
        Self::Diamond,
        Self::Wedge,
        Self::Plus,
        Self::Cross,
    ];

    /// Draws the mark around a point on the paper.
    pub fn draw<DB: DrawingBackend>(
        self,
        paper: &DrawingArea<DB, Shift>,
        (x, y): (i32, i32),
        color: RGBColor,
    ) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        // A white rim separates overlapping marks.
        let polygon = |points: &[(i32, i32)]| {
            let mut points: Vec<_> = points.iter().map(|(dx, dy)| (x + dx, y + dy)).collect();
            paper.draw(&Polygon::new(points.clone(), color.filled()))?;
            points.extend_from_within(..1);
            paper.draw(&PathElement::new(points, WHITE.stroke_width(2)))
        };
        let lines = |lines: &[[(i32, i32); 2]], width: u32| {
            lines.iter().try_for_each(|line| {
                let line = line.map(|(dx, dy)| (x + dx, y + dy));
                paper.draw(&PathElement::new(line, color.stroke_width(width)))
            })
        };
        match self {
            Self::Circle => {
                paper.draw(&Circle::new((x, y), 10, WHITE.filled()))?;
                paper.draw(&Circle::new((x, y), 8, color.filled()))?;
            }
            Self::Square => polygon(&[(-8, -8), (8, -8), (8, 8), (-8, 8)])?,
            Self::Triangle => polygon(&[(0, -10), (10, 8), (-10, 8)])?,
            Self::Diamond => polygon(&[(0, -11), (10, 0), (0, 11), (-10, 0)])?,
            Self::Wedge => polygon(&[(0, 10), (10, -8), (-10, -8)])?,
            Self::Plus => lines(&[[(-10, 0), (10, 0)], [(0, -10), (0, 10)]], 5)?,
            Self::Cross => lines(&[[(-8, -8), (8, 8)], [(-8, 8), (8, -8)]], 5)?,
            Self::Line => lines(&[[(-18, 0), (18, 0)]], 3)?,
            Self::Dashes => lines(
                &[[(-18, 0), (-9, 0)], [(-4, 0), (4, 0)], [(9, 0), (18, 0)]],
                2,
            )?,
            Self::Reach => lines(
                &[[(0, -10), (0, 10)], [(-6, 2), (6, 2)], [(-6, 10), (6, 10)]],
                2,
            )?,
        }
        Ok(())
    }
}

/// Writes entries in rows. An entry is a mark with its meaning, and a row has as many entries as fit.
pub fn draw<DB: DrawingBackend>(
    paper: &DrawingArea<DB, Shift>,
    rows: &[Vec<(Mark, RGBColor, String)>],
) -> Result<()>
where
    DB::ErrorType: 'static,
{
    let style = TextStyle::from(LABEL.into_font())
        .color(&INK)
        .pos(Pos::new(HPos::Left, VPos::Center));
    for (row, entries) in (0..).zip(rows) {
        let (mut x, y) = (40, 26 + 38 * row);
        for (mark, color, word) in entries {
            mark.draw(paper, (x, y), *color)?;
            paper.draw_text(word, &style, (x + 27, y))?;
            let (width, _) = paper.estimate_text_size(word, &style)?;
            x += 27 + width.cast_signed() + 54;
        }
    }
    Ok(())
}
