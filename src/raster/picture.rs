//! A blitter that draws characters, for pictures of the covered pixels.

use core::ops::Range;
use std::string::String;
use std::vec::Vec;

use super::{Barycentric, Blitter, ClippedVertex, Patch, Scissor, ScreenVertex};
use crate::mesh::Primitive;

/// Rows of characters: `.` where nothing was drawn, `!` where something was drawn twice.
pub(crate) struct Picture {
    rows: Vec<Vec<char>>,
    /// What pixels are drawn as.
    pub(crate) ink: char,
    /// The most pixels of a span.
    pub(crate) longest: i32,
    /// The places of the last patch.
    pub(crate) screen: [[i32; 2]; 3],
    /// Each span with the column and the row that it begins from the patch's first place.
    pub(crate) spans: Vec<(i32, Range<i32>, [i32; 2])>,
}

impl Picture {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        Self {
            rows: std::vec![std::vec!['.'; width]; height],
            ink: '#',
            longest: i32::MAX,
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

    pub(crate) fn text(&self) -> Vec<String> {
        self.rows.iter().map(|row| row.iter().collect()).collect()
    }

    #[track_caller]
    pub(crate) fn assert(&self, expected: &[&str]) {
        assert!(self.text() == expected, "{:#?}", self.text());
    }
}

impl Blitter for Picture {
    fn primitive(&mut self, _: &Primitive<'_>) {}

    fn set_up(&mut self, patch: &Patch<'_>) -> i32 {
        self.screen = *patch.screen;
        self.longest
    }

    fn span(&mut self, row: i32, columns: Range<i32>, x: i32, y: i32) {
        assert!(columns.end - columns.start <= self.longest);
        for column in columns.clone() {
            let [at_row, at_column] = [row, column].map(|at| usize::try_from(at).unwrap());
            let pixel = &mut self.rows[at_row][at_column];
            *pixel = if *pixel == '.' { self.ink } else { '!' };
        }
        self.spans.push((row, columns, [x, y]));
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

/// The same as a corner that clipping made.
pub(crate) const fn clipped(screen: [i32; 2]) -> ClippedVertex {
    ClippedVertex {
        vertex: vertex(screen),
        barycentric: Barycentric([0; 2]),
    }
}
