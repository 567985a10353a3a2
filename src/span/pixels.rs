//! The pixels of a span: the values that the kernels interpolate, and how a pixel is tested and shaded.

use core::hint::black_box;
use core::marker::PhantomData;

use embedded_graphics::geometry::Point;

use super::scale::Scale;
use super::shading::Shading;
use crate::canvas::{Cells, DepthBuffer, DepthTest, LinearDepth, Storage};
use crate::num::wide::STEPS_INDEX;
use crate::shade::{Fragment, Lanes, Varyings};

/// The interpolated numbers of a shader, one `i32` in each lane.
pub(super) type Numbers<S> = <Count<S> as Lanes>::Of<i32>;

/// The scale of each number that a shader interpolates.
pub(super) type Scales<S> = <Count<S> as Lanes>::Of<Scale>;

/// How many numbers a shader interpolates, as a type.
pub(super) type Count<S> = <<S as Shading>::Varyings as Varyings>::Lanes;

/// The values of a shader that are the same at all pixels of a primitive.
pub(super) type FaceOf<S> = <<S as Shading>::Varyings as Varyings>::Face;

/// How the depths of a primitive are moved.
pub(super) type BiasOf<S> = <<S as Shading>::Test as DepthTest>::Bias;

/// Interpolants at the first pixel of a span, and their change from one pixel to the next.
///
/// `q` is 1/w (or depth under a parallel projection), scaled so that the greatest `q` in the primitive has bit 30 set.
/// Each `p` is varying · q · 2^-bits (see [`Scale`]), so |p| is at most q/2, apart from rounding.
#[derive(Clone)]
pub(crate) struct Span<L: Lanes> {
    pub q: u32,
    pub p: L::Of<i32>,
    pub dq: i32,
    pub dp: L::Of<i32>,
    /// The right shift that turns `q` into a pixel's 16-bit depth: 15 to 47. With a shift of 31 or more, the depth is 0
    /// in the linear format.
    pub down: u32,
    /// The number of pixels.
    pub count: usize,
}

impl<L: Lanes> Span<L> {
    /// A copy of the span that the compiler has to read from memory.
    ///
    /// A loop over pixels takes all registers of a small core. Without this copy, the compiler keeps earlier values in
    /// some of these registers, and loads steps from the stack at every pixel.
    #[inline(always)]
    pub(super) fn reloaded(&self) -> Self {
        black_box(self).clone()
    }
}

/// Keeps the compiler from unrolling the loop that calls this function. The call takes no instruction.
///
/// A loop over pixels takes all registers of a small core. An unrolled loop would need more registers. It would load
/// the steps from the stack, which costs more than the branches that unrolling saves.
#[inline]
pub(super) fn rolled() {
    black_box(());
}

/// Tests and shades the pixels of a span, one by one.
pub(super) struct Pixels<S: Shading, O, D> {
    pub(super) shading: S,
    pub(super) face: FaceOf<S>,
    pub(super) bias: BiasOf<S>,
    /// The current pixel; at first, the pixel before the span.
    pub(super) point: Point,
    /// The current pixel's depth, in linear steps.
    pub(super) depth: u32,
    /// The current pixel's depth in the format of the depth buffer.
    pub(super) code: u32,
    pub(super) canvas: PhantomData<(O, D)>,
}

impl<S: Shading, O: Storage<S::Color>, D: DepthBuffer> Pixels<S, O, D> {
    /// Moves to the next pixel, where 1/w is `q`, and returns whether this pixel is visible.
    #[inline]
    pub(super) fn visible(&mut self, depth: &Option<&mut u16>, q: u32, down: u32) -> bool {
        self.point.x += 1;
        self.depth = LinearDepth::encode(q, down);
        if !D::IS_KEPT {
            return true;
        }
        self.code = S::Test::depth::<D>(self.bias, q, down);
        !S::Test::TESTS
            || depth
                .as_deref()
                .is_none_or(|stored| S::Test::passes(self.code, *stored))
    }

    /// Whether kernels skip hidden pixels at the start of a span. The loop for this steps an index, the other loop steps
    /// two addresses.
    pub(super) const SKIPS: bool = D::IS_KEPT && S::Test::TESTS && STEPS_INDEX && !cfg!(for_size);

    /// Whether a span is long enough to be skipped, if its first pixel is hidden: to call [`skip`](Self::skip) takes as
    /// long as to step over four to twelve pixels.
    #[inline]
    pub(super) fn is_long(cells: &Cells<'_, S::Color, O, D>) -> bool {
        // Hidden from the compiler, so that it makes no second loop for short spans, with other registers.
        black_box(cells.len()) >= 16
    }

    /// Skips the hidden pixels at the start of a span, and returns their number. The current pixel must be the first; 1/w
    /// is `q` there, and changes by `dq`.
    #[inline]
    pub(super) fn skip(
        &mut self,
        cells: &Cells<'_, S::Color, O, D>,
        q: u32,
        (dq, down): (i32, u32),
    ) -> usize {
        let hidden = hidden::<D, S::Test>(self.bias, cells.depths(), q, dq, down).max(1);
        // `visible` has moved to the first pixel.
        self.point.x = self.point.x.wrapping_add((hidden as u32).cast_signed() - 1);
        hidden
    }

    /// Shades the current pixel, after [`visible`](Self::visible) returned `true`.
    #[inline]
    pub(super) fn shade(
        &self,
        (color, depth): (&mut O::Cell, Option<&mut u16>),
        numbers: Numbers<S>,
    ) {
        let at = Fragment {
            point: self.point,
            depth: self.depth as u16,
        };
        let varyings = S::Varyings::join(numbers, self.face);
        let below = || O::load(*color);
        if let Some(new) = self.shading.color(&at, varyings, below) {
            *color = O::store(new);
            if S::Test::WRITES
                && let Some(depth) = depth
            {
                *depth = self.code as u16;
            }
        }
    }
}

/// How many pixels at the start of a span are hidden. Only 1/w is stepped here, and four pixels are tested in a row, so a
/// hidden pixel takes 6 instructions on Cortex-M4.
#[cold]
#[inline(never)]
fn hidden<D: DepthBuffer, Z: DepthTest>(
    bias: Z::Bias,
    depths: &[u16],
    mut q: u32,
    dq: i32,
    down: u32,
) -> usize {
    let mut hidden = 0;
    let (fours, rest) = depths.as_chunks::<4>();
    for four in fours {
        for stored in four {
            if Z::passes(Z::depth::<D>(bias, q, down), *stored) {
                return hidden;
            }
            q = q.wrapping_add_signed(dq);
            hidden += 1;
        }
    }
    for stored in rest {
        rolled();
        if Z::passes(Z::depth::<D>(bias, q, down), *stored) {
            break;
        }
        q = q.wrapping_add_signed(dq);
        hidden += 1;
    }
    hidden
}
