//! A draw call's shader, blending, mode and canvas, behind the interface that the rasterizer calls.

use core::hint::black_box;
use core::marker::PhantomData;
use core::ops::Range;

use embedded_graphics::geometry::Point;

use super::interpolator::Interpolator;
use super::mode::Mode;
use super::pixels::{BiasOf, Count, FaceOf, Numbers, Pixels, Span, rolled};
use super::plan::Plan;
use super::scale::Scale;
use super::setup::{Planes, SPAN, Setup, Varying, unpaired};
use super::shading::Shading;
use crate::canvas::{Canvas, DepthBuffer, DepthTest, Storage, WideFloatDepth};
use crate::mesh::Primitive;
use crate::raster::{Blitter, Coloring, Columns, DepthShift, Patch, Rows};
use crate::shade::{Lanes, MOST_VARYINGS, Varyings};
use crate::view::ProjectionKind;

/// The [`Blitter`] of a canvas with shading `S` in mode `M` under a projection of kind `K`.
pub(crate) struct Blit<'b, 'c, S: Shading, O: Storage<S::Color>, D, K, M> {
    canvas: &'b mut Canvas<'c, S::Color, O, D>,
    shading: S,
    bias: BiasOf<S>,
    interpolator: Interpolator<Count<S>, K, M>,
    /// The values of the shader that are the same at all pixels of the current primitive.
    face: FaceOf<S>,
}

impl<'b, 'c, S, O, D, K, M> Blit<'b, 'c, S, O, D, K, M>
where
    S: Shading,
    O: Storage<S::Color>,
    D: DepthBuffer,
    K: ProjectionKind,
    M: Mode,
{
    /// Whether the shader interpolates any numbers.
    const INTERPOLATES: bool = Count::<S>::COUNT > 0;

    /// Whether pixels differ in more than their position.
    const VARIES: bool =
        Self::INTERPOLATES || D::IS_KEPT && (S::Test::TESTS || S::Test::WRITES) || S::READS_DEPTH;

    /// Whether varyings are divided by w.
    const OVER_W: bool = Interpolator::<Count<S>, K, M>::OVER_W;

    const HAS_SMALL: bool = Interpolator::<Count<S>, K, M>::HAS_SMALL;

    /// Whether rows with [`Plan::SmallOverW`] have a loop of their own. In a build for size, they are drawn as spans.
    const HAS_SMALL_OVER_W: bool =
        Interpolator::<Count<S>, K, M>::HAS_SMALL_OVER_W && !cfg!(for_size);

    /// Whether small triangles carry two varyings in one number.
    const PAIRS: bool = S::Varyings::PAIRS && Self::HAS_SMALL;

    #[inline]
    pub(crate) fn new(mode: M, canvas: &'b mut Canvas<'c, S::Color, O, D>, shading: S) -> Self {
        const {
            assert!(
                Count::<S>::COUNT <= MOST_VARYINGS,
                "a shader has at most eight interpolated numbers"
            );
        }
        Self {
            canvas,
            shading,
            bias: BiasOf::<S>::default(),
            interpolator: Interpolator::new(mode, S::Varyings::tolerance, Self::PAIRS),
            face: FaceOf::<S>::default(),
        }
    }

    /// The pixels of a row, from `column` on. [`Pixels`] starts one pixel before that column, because it moves on
    /// before it draws.
    #[inline(always)]
    fn pixels(&self, row: i32, column: i32) -> Pixels<S, O, D> {
        Pixels {
            shading: self.shading,
            face: self.face,
            bias: self.bias,
            point: Point::new(column - 1, row),
            depth: 0,
            code: 0,
            canvas: PhantomData,
        }
    }

    /// Draws rows of pixels that differ only in their position.
    #[inline(always)]
    #[allow(clippy::explicit_counter_loop, clippy::explicit_iter_loop)] // zip and `into_iter` are calls without LTO
    fn solid_rows(&mut self, first: i32, rows: &[Columns]) {
        let mut pixels = self.pixels(first, 0);
        let mut memory = self.canvas.memory();
        let (mut row, mut begin) = (first, memory.begin(first.cast_unsigned()));
        for &[start, end] in rows.iter() {
            let columns = i32::from(start).cast_unsigned()..i32::from(end).cast_unsigned();
            pixels.point = Point::new(i32::from(start) - 1, row);
            if let Some(cells) = memory.reborrow().cells_from(begin, columns) {
                pixels.solid(cells, Count::<S>::splat(0));
            }
            row += 1;
            begin = begin.wrapping_add(memory.width);
        }
    }

    /// Draws rows of a small triangle without varyings. The numbers that all rows share are few, so they stay in
    /// registers.
    #[inline(always)]
    #[allow(clippy::explicit_counter_loop, clippy::explicit_iter_loop)] // zip and `into_iter` are calls without LTO
    fn small_flat_rows(&mut self, first: i32, rows: &[Columns]) {
        let (shading, face, bias) = (self.shading, self.face, self.bias);
        let Setup { q, down, .. } = &self.interpolator.planes.setup;
        let (step, next_row, down) = (q.step, q.row, *down);
        let mut q = q.small_at(0, first);
        let mut memory = self.canvas.memory();
        let (mut row, mut begin) = (first, memory.begin(first.cast_unsigned()));
        for &[start, end] in rows.iter() {
            let (x, columns) = (
                i32::from(start),
                i32::from(start).cast_unsigned()..i32::from(end).cast_unsigned(),
            );
            let pixels = Pixels {
                shading,
                face,
                bias,
                point: Point::new(x - 1, row),
                depth: 0,
                code: 0,
                canvas: PhantomData,
            };
            if let Some(cells) = memory.reborrow().cells_from(begin, columns) {
                let span = Span {
                    q: q.wrapping_add(step.wrapping_mul(x)).cast_unsigned(),
                    p: Count::<S>::splat(0),
                    dq: step,
                    dp: Count::<S>::splat(0),
                    down,
                    count: cells.len(),
                };
                pixels.straight::<true>(span, cells, |_, _, p| *p);
            }
            row += 1;
            q = q.wrapping_add(next_row);
            begin = begin.wrapping_add(memory.width);
        }
    }

    /// Draws rows of a small triangle: with linear varyings or, if `DIVIDES`, with varyings over w.
    #[inline(always)]
    fn small_rows<const DIVIDES: bool>(&mut self, first: i32, rows: &[Columns]) {
        let mut rest = (self, first, rows.iter());
        // Keeps `rest` in memory, because a loop over pixels takes all registers of a small core. The compiler would
        // rather keep `rest` in registers between rows. After this line, the compiler must assume that `rolled` changes
        // `rest`.
        black_box(&mut rest);
        loop {
            rolled();
            let (blit, next, rows) = &mut rest;
            let Some(&[start, end]) = rows.next() else {
                return;
            };
            let row = *next;
            *next += 1;
            let columns = i32::from(start)..i32::from(end);
            if columns.start >= columns.end {
                continue;
            }
            let (x, y) = (columns.start, row);
            let pixels = blit.pixels(row, x);
            let Planes { setup, varyings } = &blit.interpolator.planes;
            let mut span = Span::<Count<S>> {
                q: if Self::PAIRS && !DIVIDES {
                    setup.q.at(x, y)
                } else {
                    setup.q.small_at(x, y)
                }
                .cast_unsigned(),
                p: Count::<S>::map(varyings, |p: &Varying| p.interpolant.small_at(x, y)),
                dq: setup.q.step,
                dp: Count::<S>::map(varyings, |p: &Varying| p.interpolant.step),
                down: setup.down,
                count: columns.len(),
            };
            match (span.p.as_mut(), span.dp.as_mut()) {
                // The first number also holds the third varying, so the third number is not used. If it is 0, the
                // compiler drops it.
                ([.., p], [.., dp]) if Self::PAIRS && !DIVIDES => (*p, *dp) = (0, 0),
                _ => {}
            }
            if let Some(cells) = blit.canvas.cells(row, columns) {
                if !DIVIDES {
                    pixels.straight::<true>(span, cells, Self::restored_small);
                    continue;
                }
                let Interpolator { mode, planes, .. } = &blit.interpolator;
                match mode.of_span(Plan::SmallOverW, planes, &mut span) {
                    Plan::Straight => pixels.straight::<true>(span, cells, Self::restored),
                    Plan::Newton => pixels.newton(span, cells),
                    _ => pixels.divide(&span, cells, Count::<S>::splat(Scale::AFFINE)),
                }
            }
        }
    }

    /// Draws rows of any triangle.
    #[inline(always)]
    #[allow(clippy::explicit_counter_loop, clippy::explicit_iter_loop)] // zip and `into_iter` are calls without LTO
    fn any_rows(&mut self, first: i32, rows: &[Columns]) {
        let mut row = first;
        for &[start, end] in rows.iter() {
            let (mut start, end) = (i32::from(start), i32::from(end));
            while start < end {
                let stop = end.min(start + SPAN);
                self.any_span(row, start..stop);
                start = stop;
            }
            row += 1;
        }
    }

    /// Draws at most [`SPAN`] pixels of any triangle.
    #[inline(never)]
    fn any_span(&mut self, row: i32, columns: Range<i32>) {
        let at = [columns.start, row];
        // Borrowed, because a move would copy the span.
        let count = (columns.end - columns.start).cast_unsigned() as usize;
        let (span, plan) = &self.interpolator.span_at(at, count);
        let mut pixels = self.pixels(row, columns.start);
        let Planes { setup, varyings } = &self.interpolator.planes;
        if S::Test::IS_BIASED {
            pixels.bias = S::Test::shifted(self.bias, span.down.wrapping_sub(setup.down));
        }
        let scales = Count::<S>::map(varyings, |p: &Varying| p.scale);
        let interpolator = &self.interpolator;
        let Some(cells) = self.canvas.cells(row, columns) else {
            return;
        };
        // The right half of each pattern is matched with a constant. So the compiler leaves out each kernel that the
        // mode does not use under this projection.
        match (*plan, Interpolator::<Count<S>, K, M>::KERNEL) {
            _ if !Self::INTERPOLATES => {
                pixels.straight::<true>(span.reloaded(), cells, Self::restored);
            }
            (Plan::Straight, Plan::Pieces(_)) => {
                pixels.straight::<false>(span.reloaded(), cells, Self::restored);
            }
            (Plan::Straight, _) if Interpolator::<Count<S>, K, M>::HAS_STRAIGHT => {
                pixels.straight::<true>(span.reloaded(), cells, Self::restored);
            }
            (_, Plan::Straight) => pixels.scaled(span, cells, scales),
            (Plan::Newton, Plan::Newton) => pixels.newton(span.reloaded(), cells),
            (Plan::Pieces(length), Plan::Pieces(_)) => pixels.pieces(span, cells, scales, length),
            (Plan::PerPixel, Plan::PerPixel) => {
                pixels
                    .divide_per_pixel(span, cells, scales, |pixel| interpolator.recomputed(pixel));
            }
            (_, Plan::Divide | Plan::PerPixel) => pixels.divide(span, cells, scales),
            _ => pixels.divide_apart(span, cells, scales),
        }
    }

    /// Turns the interpolants of a small triangle into varyings, without a division.
    #[inline(always)]
    fn restored_small(at: Point, q: u32, p: &Numbers<S>) -> Numbers<S> {
        let mut numbers = *p;
        match numbers.as_mut() {
            [first, second, third] if Self::PAIRS => {
                [*first, *second, *third] = unpaired(*first, *second);
                numbers
            }
            _ => Self::restored(at, q, p),
        }
    }

    /// Turns interpolants into varyings, without a division.
    #[inline(always)]
    fn restored(_: Point, _: u32, p: &Numbers<S>) -> Numbers<S> {
        if Self::OVER_W {
            Count::<S>::map(p, |p: &i32| *p >> Scale::AFFINE_UP)
        } else {
            *p
        }
    }
}

impl<S, O, D, K, M> Blitter for Blit<'_, '_, S, O, D, K, M>
where
    S: Shading,
    O: Storage<S::Color>,
    D: DepthBuffer,
    K: ProjectionKind,
    M: Mode,
{
    fn begin(&mut self, shift: DepthShift) -> Coloring {
        self.interpolator.planes.setup.shift = shift;
        Coloring {
            varies: Self::VARIES,
            blends: S::READS_COLOR,
        }
    }

    fn set_up(&mut self, primitive: &Primitive<'_>, patch: &Patch<'_>) -> &mut dyn Rows {
        let [a, b, c] = self.shading.varyings(primitive);
        let ((a, face), (b, _), (c, _)) = (a.split(), b.split(), c.split());
        self.face = face;
        if Self::VARIES {
            self.interpolator.set_corners([a, b, c]);
            self.interpolator.set_up(patch);
            if S::Test::IS_BIASED {
                let setup = &self.interpolator.planes.setup;
                let beside = WideFloatDepth::decode(primitive.slope_beside.into(), setup.down);
                self.bias = self.shading.test().bias(setup.steepness().max(beside));
            }
        }
        self
    }
}

impl<S, O, D, K, M> Rows for Blit<'_, '_, S, O, D, K, M>
where
    S: Shading,
    O: Storage<S::Color>,
    D: DepthBuffer,
    K: ProjectionKind,
    M: Mode,
{
    fn draw(&mut self, first: i32, rows: &[Columns]) {
        // The condition is a bare constant, without a negation, so that the branch that is not taken is not even
        // compiled.
        if Self::VARIES {
            if Self::HAS_SMALL && self.interpolator.plan == Plan::Small {
                if Self::INTERPOLATES || cfg!(for_size) {
                    self.small_rows::<false>(first, rows);
                } else {
                    self.small_flat_rows(first, rows);
                }
            } else if Self::HAS_SMALL_OVER_W && self.interpolator.plan == Plan::SmallOverW {
                self.small_rows::<true>(first, rows);
            } else {
                self.any_rows(first, rows);
            }
        } else {
            self.solid_rows(first, rows);
        }
    }
}
