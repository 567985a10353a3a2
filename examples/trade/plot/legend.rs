//! What marks and lines mean: a row under a plot.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{FONT, INK};
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
    /// A piece of a line, whole.
    Line,
    /// The same, dashed.
    Dashes,
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

    /// Draws it about a place on the paper.
    pub fn draw<DB: DrawingBackend>(
        self,
        paper: &DrawingArea<DB, Shift>,
        (x, y): (i32, i32),
        color: RGBColor,
    ) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        let polygon = |points: &[(i32, i32)]| {
            let points: Vec<_> = points.iter().map(|(dx, dy)| (x + dx, y + dy)).collect();
            paper.draw(&Polygon::new(points, color.filled()))
        };
        let lines = |lines: &[[(i32, i32); 2]]| {
            lines.iter().try_for_each(|line| {
                let line = line.map(|(dx, dy)| (x + dx, y + dy));
                paper.draw(&PathElement::new(line, color.stroke_width(2)))
            })
        };
        match self {
            Self::Circle => paper.draw(&Circle::new((x, y), 5, color.filled())),
            Self::Square => polygon(&[(-5, -5), (5, -5), (5, 5), (-5, 5)]),
            Self::Triangle => polygon(&[(0, -6), (6, 5), (-6, 5)]),
            Self::Diamond => polygon(&[(0, -7), (6, 0), (0, 7), (-6, 0)]),
            Self::Wedge => polygon(&[(0, 6), (6, -5), (-6, -5)]),
            Self::Plus => lines(&[[(-6, 0), (6, 0)], [(0, -6), (0, 6)]]),
            Self::Cross => lines(&[[(-5, -5), (5, 5)], [(-5, 5), (5, -5)]]),
            Self::Line => lines(&[[(-11, 0), (11, 0)]]),
            Self::Dashes => lines(&[[(-11, 0), (-5, 0)], [(-3, 0), (3, 0)], [(5, 0), (11, 0)]]),
        }?;
        Ok(())
    }
}

/// Writes entries in rows, each a mark and a word, as many in a row as have room.
pub fn draw<DB: DrawingBackend>(
    paper: &DrawingArea<DB, Shift>,
    rows: &[Vec<(Mark, RGBColor, String)>],
) -> Result<()>
where
    DB::ErrorType: 'static,
{
    let style = TextStyle::from((FONT, 15).into_font())
        .color(&INK)
        .pos(Pos::new(HPos::Left, VPos::Center));
    for (row, entries) in (0..).zip(rows) {
        let (mut x, y) = (24, 12 + 24 * row);
        for (mark, color, word) in entries {
            mark.draw(paper, (x, y), *color)?;
            paper.draw_text(word, &style, (x + 17, y))?;
            let (width, _) = paper.estimate_text_size(word, &style)?;
            x += 17 + width.cast_signed() + 34;
        }
    }
    Ok(())
}
