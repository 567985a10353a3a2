//! A blitter that draws characters, for pictures of the covered pixels.

use core::ops::Range;
use std::string::String;
use std::vec::Vec;

use super::{
    Barycentric, Blitter, ClippedVertex, Coloring, Columns, DepthShift, Patch, Rasterizer, Rows,
    Scissor, ScreenVertex,
};
use crate::Transform;
use crate::mesh::{Mesh, Placement, Primitive};

/// Rows of characters: `.` where nothing was drawn, `!` where something was drawn twice.
pub(crate) struct Picture {
    rows: Vec<Vec<char>>,
    pub(crate) blends: bool,
    /// The character that pixels are drawn as.
    pub(crate) ink: char,
    /// The screen positions of the last patch's vertices.
    pub(crate) screen: [[i32; 2]; 3],
    /// The rows and columns of all spans.
    pub(crate) spans: Vec<(i32, Range<i32>)>,
}

impl Picture {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        Self {
            rows: std::vec![std::vec!['.'; width]; height],
            blends: false,
            ink: '#',
            screen: [[0; 2]; 3],
            spans: Vec::new(),
        }
    }

    /// The scissor of the whole picture.
    pub(crate) fn scissor(&self) -> Scissor {
        let length = |count: usize| i32::try_from(count).unwrap();
        Scissor {
            columns: 0..length(self.rows[0].len()),
            rows: 0..length(self.rows.len()),
        }
    }

    /// Calls `draw` with a rasterizer that draws to this picture.
    pub(crate) fn draw<R>(
        &mut self,
        scissor: &Scissor,
        draw: impl FnOnce(&mut Rasterizer<'_>) -> R,
    ) -> R {
        let mesh = Mesh::new(&[], &[]).unwrap();
        let placement = Placement::new(&mesh, &Transform::IDENTITY, Transform::IDENTITY);
        draw(&mut Rasterizer::new(
            self,
            DepthShift(15),
            &placement,
            scissor,
        ))
    }

    pub(crate) fn text(&self) -> Vec<String> {
        self.rows.iter().map(|row| row.iter().collect()).collect()
    }

    #[track_caller]
    pub(crate) fn assert(&self, expected: &[&str]) {
        assert!(self.text() == expected, "{:#?}", self.text());
    }
}

impl Blitter for Picture {
    fn begin(&mut self, _: DepthShift) -> Coloring {
        Coloring {
            varies: true,
            blends: self.blends,
        }
    }

    fn set_up(&mut self, _: &Primitive<'_>, patch: &Patch<'_>) -> &mut dyn Rows {
        self.screen = ScreenVertex::screens(patch.vertices);
        self
    }
}

impl Rows for Picture {
    fn draw(&mut self, first: i32, columns: &[Columns]) {
        for (row, [start, end]) in (first..).zip(columns.iter().map(|ends| ends.map(i32::from))) {
            for column in start..end {
                let [at_row, at_column] = [row, column].map(|at| usize::try_from(at).unwrap());
                let pixel = &mut self.rows[at_row][at_column];
                *pixel = if *pixel == '.' { self.ink } else { '!' };
            }
            if start < end {
                self.spans.push((row, start..end));
            }
        }
    }
}

/// A vertex at a place in 256ths of a pixel.
pub(crate) const fn vertex(screen: [i32; 2]) -> ScreenVertex {
    ScreenVertex {
        screen,
        q: 1 << 30,
        outcode: 0,
        ..ScreenVertex::UNSET
    }
}

/// The same vertex, in the form of a corner that clipping made.
pub(crate) const fn clipped(screen: [i32; 2]) -> ClippedVertex {
    ClippedVertex {
        vertex: vertex(screen),
        barycentric: Barycentric([0; 2]),
    }
}
