//! From a primitive on the screen to runs of pixels.

mod edge;
mod fan;
mod line;
mod point;
mod rows;
mod triangle;

use core::ops::Range;

use embedded_graphics::geometry::Point;

use crate::geometry::Projected;
use crate::interpolate::{Interpolate, Pixels, Plane, RUN, Run, Slope, Steps, Weighted};
use crate::shade::{Fragment, Sample};
use crate::target::{Canvas, DepthBuffer, Storage};
use crate::view::Viewport;

pub(crate) use fan::{Fan, Part};
pub(crate) use line::line;
pub(crate) use point::point;
use rows::Rows;
pub(crate) use triangle::Triangle;
use triangle::area;

/// The part of the canvas that may be drawn into; nothing outside is.
#[derive(Clone, Debug)]
pub(crate) struct Window {
    pub(crate) columns: Range<i32>,
    pub(crate) rows: Range<i32>,
}

impl Window {
    /// Where a viewport and `rows` of a frame so wide meet.
    pub(crate) fn new(viewport: &Viewport, width: u32, rows: &Range<u32>) -> Self {
        let [across, down] = viewport.pixels();
        let meet = |a: Range<i32>, start: u32, end: u32| {
            a.start.max(start.cast_signed())..a.end.min(end.cast_signed())
        };
        Self {
            columns: meet(across, 0, width),
            rows: meet(down, rows.start, rows.end),
        }
    }
}

/// The interpolants of a primitive: the plane of 1/w (or depth), and those of the attributes over w.
struct Planes<const N: usize> {
    slope: Slope,
    q: Plane,
    p: [Plane; N],
    /// What a column adds, and how the attributes are scaled.
    steps: Steps<N>,
}

impl<const N: usize> Planes<N> {
    /// Nothing to interpolate.
    const EVEN: Self = Self {
        slope: Slope::NONE,
        q: Plane::NONE,
        p: [Plane::NONE; N],
        steps: Steps::EVEN,
    };

    /// The planes through corners that come with their interpolants of depth, their attributes, and
    /// how a plane is laid through the values of so many corners.
    #[inline]
    fn new<I: Interpolate, const CORNERS: usize>(
        slope: Slope,
        q: [u32; CORNERS],
        varyings: &[[i32; N]; CORNERS],
        plane: impl Fn(&Slope, [i32; CORNERS]) -> Plane,
    ) -> Self {
        let weights = if I::PERSPECTIVE {
            q
        } else {
            [1 << 30; CORNERS]
        };
        let weighted = Weighted::new(varyings, weights);
        let q = plane(&slope, q.map(u32::cast_signed));
        let p = weighted.p.map(|p| plane(&slope, p));
        let step = |plane: &Plane| slope.value(plane.dx());
        let steps = Steps {
            q: step(&q),
            p: p.each_ref().map(step),
            scale: weighted.scale,
        };
        Self { slope, q, p, steps }
    }

    /// The interpolants at a pixel, counted from the slope's origin.
    #[inline]
    fn at(&self, x: i32, y: i32) -> Run<N> {
        let value = |plane: &Plane| self.slope.value(plane.at(x, y));
        Run {
            q: value(&self.q).cast_unsigned(),
            p: self.p.each_ref().map(value),
        }
    }
}

/// Whether pixels of a primitive differ in anything but their place, so that there is something to interpolate.
const fn varies<F: Fragment<N>, D: DepthBuffer, const N: usize>() -> bool {
    N > 0 || D::IS_KEPT || F::READS_DEPTH
}

/// The least 1/w: what the steps of a run may take from it and add to attributes over w is less than
/// a thirty-second, which [`Weighted`](crate::interpolate::Weighted) leaves room for.
///
/// It only ever lifts a corner more than half a million times as far as the nearest one.
const LEAST_WEIGHT: u32 = 1 << 11;

/// Draws `columns` of `row`, which lie within the canvas, in runs.
///
/// `start` is the pixel, counted from the slope's origin, where the interpolants begin. The `planes`
/// are not looked at if there is nothing to interpolate.
///
/// A function of its own, so that the loop over pixels has the registers to itself.
#[inline(never)]
fn span<I, F, O, D, const N: usize>(
    canvas: &mut Canvas<'_, F::Color, O, D>,
    (row, columns): (i32, Range<i32>),
    planes: &Planes<N>,
    [mut x, y]: [i32; 2],
    (fragment, depth_shift): (&F, u32),
) where
    I: Interpolate,
    F: Fragment<N>,
    O: Storage<F::Color>,
    D: DepthBuffer,
{
    let mut start = columns.start;
    while start < columns.end {
        let (end, run, steps) = if varies::<F, D, N>() {
            let end = columns.end.min(start + RUN.cast_signed());
            (end, planes.at(x, y), &planes.steps)
        } else {
            (columns.end, Run::EVEN, &Steps::EVEN)
        };
        let mut shader = Shader {
            fragment,
            depth_shift,
            // The first pixel is looked at after one step.
            point: Point::new(start - 1, row),
            depth: 0,
        };
        let cells = canvas.run(
            row.cast_unsigned(),
            start.cast_unsigned()..end.cast_unsigned(),
        );
        let cells = cells.map(|(color, depth)| Cell::<F::Color, O, D> { color, depth });
        I::run(run, steps, cells, &mut shader);
        x += end - start;
        start = end;
    }
}

/// The corners' interpolants of depth with one exponent: their own, and the common one.
#[inline]
fn align<const CORNERS: usize>(corners: &[Projected; CORNERS]) -> ([u32; CORNERS], u8) {
    let exponent = corners
        .iter()
        .fold(0, |most, corner| corner.exponent.max(most));
    let q = corners.map(|corner| {
        let down = u32::from(exponent - corner.exponent);
        corner.q.checked_shr(down).unwrap_or(0).max(LEAST_WEIGHT)
    });
    (q, exponent)
}

/// One pixel in memory.
struct Cell<'c, 'd, C, O: Storage<C>, D: DepthBuffer + 'd> {
    color: &'c mut O::Cell,
    depth: D::Cell<'d>,
}

/// Tests and colours the pixels of a run with a fragment.
struct Shader<'f, F> {
    fragment: &'f F,
    depth_shift: u32,
    point: Point,
    depth: u32,
}

impl<'d, F, O, D, const N: usize> Pixels<Cell<'_, 'd, F::Color, O, D>, N> for Shader<'_, F>
where
    F: Fragment<N>,
    O: Storage<F::Color>,
    D: DepthBuffer + 'd,
{
    #[inline]
    fn visible(&mut self, cell: &Cell<'_, 'd, F::Color, O, D>, q: u32) -> bool {
        self.point.x += 1;
        // 31 bits shifted down by 15 or more.
        self.depth = q >> self.depth_shift;
        D::passes(&cell.depth, self.depth)
    }

    #[inline]
    fn shade(&mut self, cell: Cell<'_, 'd, F::Color, O, D>, _: u32, varyings: [i32; N]) {
        let depth = self.depth as u16;
        let sample = Sample {
            point: self.point,
            depth,
        };
        if let Some(color) = self.fragment.shade(&sample, varyings) {
            *cell.color = O::store(color);
            D::store(cell.depth, depth);
        }
    }
}
