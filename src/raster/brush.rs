//! What a draw call paints with: a shader, a mode and a canvas, behind one interface.

use core::ops::Range;

use embedded_graphics::geometry::Point;

use super::Triangle;
use super::planes::{Attribute, Planes};
use crate::shade::{Fragment, Shader};
use crate::span::{self, Interpolate, Pixels, RUN};
use crate::target::{Canvas, Cells, DepthBuffer, Storage, linear};
use crate::{
    mesh::{Corner, Face},
    pipeline::DepthShift,
};

/// The part of a draw call that depends on what is painted, and on what.
///
/// All else, from the mesh's indices to rows of pixels, calls it through a `dyn`: it exists once in
/// a program, however many shaders and canvases there are. A call costs a few instructions an
/// element and a span.
pub(crate) trait Brush {
    /// Goes to another element of the mesh.
    fn element(&mut self, face: &Face<'_>);

    /// Gets ready for a triangle on the screen, all or a part of the element; gives the most columns that it paints
    /// at a time.
    fn triangle(&mut self, triangle: &Triangle<'_>) -> i32;

    /// Paints `columns` of `row`, which lie within the canvas, and are no more than it said.
    ///
    /// Interpolants begin `x` columns and `y` rows from the pixel that corner 0 of the triangle lies in.
    fn span(&mut self, row: i32, columns: Range<i32>, x: i32, y: i32);
}

/// More than any attribute that is drawn affinely may have, and four times it takes 31 bits.
const MOST_TOLERANCE: u32 = (1 << 29) - 1;

/// Pixels that are coloured without looking for the end of the span, where nothing varies between them.
const BLOCK: usize = 16;

/// The [`Brush`] of a shader `F` in mode `I`.
pub(crate) struct Paint<
    'p,
    'c,
    I: Interpolate,
    F: Shader<N>,
    O: Storage<F::Color>,
    D,
    const N: usize,
> {
    canvas: &'p mut Canvas<'c, F::Color, O, D>,
    /// As it was made ready for the draw call, and for the present element.
    shader: F,
    current: F,
    planes: Planes<[Attribute; N]>,
    depth_shift: DepthShift,
    /// By how much the present triangle's 1/w are shifted down to be depths.
    down: u32,
    mode: I,
    plan: I::Plan,
}

impl<'p, 'c, I, F, O, D, const N: usize> Paint<'p, 'c, I, F, O, D, N>
where
    I: Interpolate,
    F: Shader<N>,
    O: Storage<F::Color>,
    D: DepthBuffer,
{
    /// Whether pixels of a primitive differ in anything but their place, so that there is something to interpolate.
    const VARIES: bool = N > 0 || D::IS_KEPT || F::READS_DEPTH;

    #[inline]
    pub(crate) fn new(
        mode: I,
        canvas: &'p mut Canvas<'c, F::Color, O, D>,
        shader: F,
        depth_shift: DepthShift,
    ) -> Self {
        let mut planes = Planes::<[Attribute; N]>::NONE;
        for (p, tolerance) in planes.p.iter_mut().zip(F::TOLERANCES) {
            p.tolerance = mode.affine_within(tolerance).min(MOST_TOLERANCE);
        }
        Self {
            canvas,
            shader,
            current: shader,
            planes,
            depth_shift,
            down: 0,
            mode,
            plan: I::Plan::default(),
        }
    }
}

impl<I, F, O, D, const N: usize> Brush for Paint<'_, '_, I, F, O, D, N>
where
    I: Interpolate,
    F: Shader<N>,
    O: Storage<F::Color>,
    D: DepthBuffer,
{
    fn element(&mut self, face: &Face<'_>) {
        let mut varyings = [[0; N]; 3];
        for (corner, varyings) in varyings.iter_mut().enumerate() {
            *varyings = self.shader.varyings(&Corner { face, corner });
        }
        if face.element.face.is_some() {
            self.current = self.shader.face(&mut varyings, face);
        }
        let [first, second, third] = &varyings;
        let varyings = first.iter().zip(second).zip(third);
        for (p, ((&first, &second), &third)) in self.planes.p.iter_mut().zip(varyings) {
            p.corners = [first, second, third];
        }
    }

    fn triangle(&mut self, triangle: &Triangle<'_>) -> i32 {
        if !Self::VARIES {
            return i32::MAX;
        }
        let planes: &mut Planes = &mut self.planes;
        let exponent = planes.lay(triangle, I::PERSPECTIVE, I::LEAST_BITS);
        self.down = self.depth_shift.of(exponent);
        self.plan = self.mode.plan(&self.planes.steps(self.down));
        RUN.cast_signed()
    }

    fn span(&mut self, row: i32, columns: Range<i32>, x: i32, y: i32) {
        let mut shader = PixelSink {
            shader: &self.current,
            // The first pixel is looked at after one step.
            point: Point::new(columns.start - 1, row),
            depth: 0,
            stored: 0,
        };
        let columns = columns.start.cast_unsigned()..columns.end.cast_unsigned();
        let Some(cells) = self.canvas.run(row.cast_unsigned(), columns) else {
            return;
        };
        if Self::VARIES {
            let (run, steps) = (self.planes.run(x, y), self.planes.steps(self.down));
            self.mode.run(self.plan, run, &steps, cells, &mut shader);
        } else {
            let mut cells = cells;
            while cells.len() >= BLOCK {
                shader.cover::<O, D, N>(cells.first(BLOCK));
            }
            shader.cover::<O, D, N>(cells.first(BLOCK));
        }
    }
}

/// One pixel in memory.
struct Cell<'c, C, O: Storage<C>, D: DepthBuffer + 'c> {
    color: &'c mut O::Cell,
    depth: D::Cell<'c>,
}

impl<'c, C, O: Storage<C>, D: DepthBuffer + 'c> span::Cells<Cell<'c, C, O, D>>
    for Cells<'c, C, O, D>
{
    #[inline]
    fn count(&self) -> usize {
        self.len()
    }

    #[inline]
    fn first(&mut self, count: usize) -> impl Iterator<Item = Cell<'c, C, O, D>> {
        self.first(count)
            .map(|(color, depth)| Cell { color, depth })
    }
}

/// Tests and colours the pixels of a run with a shader.
struct PixelSink<'f, F> {
    shader: &'f F,
    point: Point,
    /// The pixel's depth in linear steps, and as it is stored.
    depth: u32,
    stored: u32,
}

impl<F> PixelSink<'_, F> {
    /// Colours pixels between which nothing varies.
    #[inline]
    fn cover<'c, O, D, const N: usize>(
        &mut self,
        cells: impl Iterator<Item = (&'c mut O::Cell, D::Cell<'c>)>,
    ) where
        F: Shader<N>,
        O: Storage<F::Color, Cell: 'c>,
        D: DepthBuffer + 'c,
    {
        for (color, depth) in cells {
            let cell = Cell::<F::Color, O, D> { color, depth };
            if self.visible(&cell, 0, 0) {
                self.shade(cell, [0; N]);
            }
        }
    }
}

impl<'c, F, O, D, const N: usize> Pixels<Cell<'c, F::Color, O, D>, N> for PixelSink<'_, F>
where
    F: Shader<N>,
    O: Storage<F::Color>,
    D: DepthBuffer + 'c,
{
    #[inline]
    fn visible(&mut self, cell: &Cell<'c, F::Color, O, D>, q: u32, down: u32) -> bool {
        self.point.x += 1;
        self.depth = linear(q, down);
        self.stored = D::encode(q, down);
        D::passes(&cell.depth, self.stored)
    }

    #[inline]
    fn shade(&mut self, cell: Cell<'c, F::Color, O, D>, varyings: [i32; N]) {
        let sample = Fragment {
            point: self.point,
            depth: self.depth as u16,
        };
        if let Some(color) = self.shader.shade(&sample, varyings) {
            *cell.color = O::store(color);
            D::store(cell.depth, self.stored as u16);
        }
    }
}
