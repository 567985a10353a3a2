//! The rasterizer: it finds the pixels of primitives, row by row, and passes them on to a [`Blitter`].

use core::hint::black_box;
use core::ops::Range;

use super::block::Block;
use super::edge::first_center;
use super::polygon::{FanTriangle, Polygon, vertices};
use super::triangle::scan_convert;
use super::{
    Blitter, ClippedVertex, Coloring, Columns, Cull, DepthShift, Patch, Scissor, ScreenVertex,
    Triangle,
};
use crate::mesh::{Indices, Placement, Primitive};

/// The most rows that [`Rows::draw`] receives at once. This is enough for all rows of a small triangle, and takes 256
/// bytes of stack.
pub(super) const ROWS: i32 = 64;

/// The second half of a draw call, from primitives on the screen to rows of pixels: the present primitive, the pixels
/// that may be drawn, and the blitter that draws them.
pub(crate) struct Rasterizer<'r> {
    blitter: &'r mut dyn Blitter,
    pub(crate) primitive: Primitive<'r>,
    pub(super) scissor: &'r Scissor,
    pub(super) coloring: Coloring,
    /// Memory for the rows of a triangle.
    block: [Columns; ROWS as usize],
    /// How many primitives were drawn.
    pub(crate) drawn: u32,
    /// How many of them were clipped.
    pub(crate) clipped: u32,
}

impl<'r> Rasterizer<'r> {
    /// Begins a draw call. The first primitive is a placeholder, until [`next_primitive`](Self::next_primitive).
    #[inline]
    pub(crate) fn new(
        blitter: &'r mut dyn Blitter,
        shift: DepthShift,
        placement: &'r Placement<'r>,
        scissor: &'r Scissor,
    ) -> Self {
        Self {
            coloring: blitter.begin(shift),
            blitter,
            primitive: placement.primitive(Indices::of_face(0, [0; 3]), 0),
            scissor,
            block: if cfg!(for_size) {
                [[0; 2]; ROWS as usize]
            } else {
                // Zeros that the compiler knows would be cleared by a function that stores word by word.
                [black_box([0; 2]); ROWS as usize]
            },
            drawn: 0,
            clipped: 0,
        }
    }

    /// The next primitive comes from the draw list's entry at this address.
    #[inline]
    pub(crate) const fn next_entry(&mut self, entry: usize) {
        self.primitive.entry = entry;
    }

    /// Moves on to another primitive of the mesh. `area` is twice its area on the screen; shaders ask for its sign.
    #[inline]
    const fn next_primitive(&mut self, indices: Indices, area: i64) {
        self.primitive.indices = indices;
        self.primitive.area = (area >> 32) as i32;
    }

    /// Draws a triangle that is inside all planes; `area` is twice its area on the screen.
    #[cfg_attr(not(for_size), inline(never))] // so that the loop over faces, half of them rejected, has its registers
    pub(crate) fn draw_whole(&mut self, indices: Indices, corners: [&ScreenVertex; 3], area: i64) {
        // Borrowed, because a move would copy the triangle.
        if let Some(triangle) = &Triangle::new(corners, None, area, self.scissor) {
            self.next_primitive(indices, area);
            self.triangle(triangle, None);
            self.drawn += 1;
        }
    }

    /// Draws what remains of a triangle after clipping, unless it is culled.
    ///
    /// The outline is drawn as a fan of triangles. Rounding may fold the fan. Triangles that turned over are left out
    /// then, and of each other triangle only the pixels that no triangle before it has: see [`Polygon`].
    #[inline(never)]
    pub(crate) fn draw_clipped(
        &mut self,
        indices: Indices,
        outline: &[ClippedVertex],
        cull: Cull,
    ) -> u32 {
        let Some(polygon) = &Polygon::new(outline, cull) else {
            return u32::from(!outline.is_empty());
        };
        self.next_primitive(indices, polygon.area);
        let mut drawn = 0; // or 1, as a number from the start: a condition takes an instruction more
        for (at, (corners, area)) in polygon.triangles().enumerate() {
            if !polygon.winds_as(area) {
                continue;
            }
            let [a, b, c] = corners;
            let places = [a.barycentric, b.barycentric, c.barycentric];
            let triangle = Triangle::new(vertices(corners), Some(&places), area, self.scissor);
            if let Some(triangle) = &triangle {
                let part = FanTriangle { fan: polygon, at };
                self.triangle(triangle, polygon.is_folded.then_some(&part));
                drawn = 1;
            }
        }
        self.drawn += drawn;
        self.clipped += drawn;
        0
    }

    /// Moves on to an edge or a point that will be drawn, and counts it. For an outline's edge, `slope_beside` is how
    /// steep the faces beside it are.
    #[inline]
    pub(crate) fn next_thin(&mut self, indices: Indices, slope_beside: u16, is_clipped: bool) {
        self.primitive.slope_beside = slope_beside;
        self.next_primitive(indices, 0);
        self.drawn += 1;
        self.clipped += u32::from(is_clipped);
    }

    /// Whether a line or point may have pixels in the scissor. The line or point lies between the positions a and b, in
    /// units of 1/256 row, and reaches up to `reach` rows beyond them.
    #[inline]
    pub(crate) fn meets(&self, [a, b]: [i32; 2], reach: i32) -> bool {
        let rows = &self.scissor.rows;
        (a.min(b) >> 8) - reach < rows.end && (a.max(b) >> 8) + reach >= rows.start
    }

    /// Sets up the interpolants of the present primitive over a patch.
    #[inline]
    pub(super) fn set_up(&mut self, patch: &Patch<'_>) -> Block<'_> {
        Block::new(self.blitter.set_up(&self.primitive, patch), &mut self.block)
    }

    /// Fills a triangle inside the scissor; with `part`, only the pixels that `part` selects.
    ///
    /// A center on a left or top edge belongs to the triangle. A center on a right or bottom edge does not.
    #[cfg_attr(for_size, inline(never))]
    pub(super) fn triangle(&mut self, triangle: &Triangle<'_>, part: Option<&FanTriangle<'_>>) {
        let block = &mut self.block;
        let Range { start, end } = triangle.rows;
        let (mut first, mut rows) = (start, scan_convert(block, start, triangle));
        // Many slivers cover no pixel center. For such a sliver, no interpolant is set up.
        while !rows.iter().copied().any(has_pixels) {
            first += ROWS;
            if first >= end {
                return;
            }
            rows = scan_convert(block, first, triangle);
        }
        let blit = self.blitter.set_up(&self.primitive, &triangle.patch);
        loop {
            match part {
                None => blit.draw(first, rows),
                Some(part) => part.rows(blit, first, rows),
            }
            first += ROWS;
            if first >= end {
                return;
            }
            rows = scan_convert(block, first, triangle);
        }
    }

    /// Draws two triangles that form an upright rectangle inside the scissor. The triangle `half` is the first of them,
    /// but its interpolants are set up over the whole rectangle. So at the fourth corner, no interpolant may have a
    /// value beyond its values at the other three corners.
    ///
    /// The rectangle has the pixels of both halves. An interpolant has the same greatest error as in a half, because
    /// this error depends only on the width and the height of the triangle.
    #[inline(never)]
    pub(crate) fn draw_rectangle(&mut self, indices: Indices, half: &Triangle<'_>) {
        self.next_primitive(indices, half.patch.area);
        self.drawn += 2;
        let blit = self.blitter.set_up(&self.primitive, &half.patch);
        let [[ax, _], [bx, _], [cx, _]] = ScreenVertex::screens(half.patch.vertices);
        let [start, end] = [ax.min(bx).min(cx), ax.max(bx).max(cx)].map(first_center);
        let scissor = &self.scissor.columns;
        let columns = [start.max(scissor.start) as i16, end.min(scissor.end) as i16];
        let mut row = half.rows.start;
        while row < half.rows.end {
            let next = half.rows.end.min(row + ROWS);
            let count = (next - row).cast_unsigned() as usize;
            let block = self.block.get_mut(..count).unwrap_or_default();
            for of_row in &mut *block {
                *of_row = columns;
            }
            blit.draw(row, block);
            row = next;
        }
    }
}

/// Whether a row has a pixel.
fn has_pixels([start, end]: Columns) -> bool {
    black_box(()); // so that the loop over rows is not unrolled: most triangles have a pixel in the first row or two
    start < end
}
