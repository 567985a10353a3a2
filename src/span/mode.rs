//! The interpolation modes: how attributes are recovered along a run.

use super::affine::Linear;
use super::run::{Cells, Pixels, Run, Scale, Steps};
use super::tolerance::Tolerance;
use crate::num::reciprocal;
use crate::num::wide::product;

/// A way to recover the attributes along a run of pixels.
///
/// The one seam at which speed is traded for accuracy. An implementation walks the run, asks
/// [`Pixels::visible`] of each pixel first, and recovers the attributes of those that are. It must
/// depend on nothing but the run, so that every band and every target draws the same.
///
/// ```
/// use fixel::mode::{Affine, Cells, Exact, Interpolate, Pixels, Run, Steps};
/// use fixel::{DrawOptions};
///
/// /// Every other pixel, exactly.
/// #[derive(Clone, Copy)]
/// struct Sparse;
///
/// impl Interpolate for Sparse {
///     const PERSPECTIVE: bool = true;
///     type Parallel = Affine;
///     type Plan = ();
///
///     fn parallel(self) -> Affine {
///         Affine
///     }
///
///     fn plan<const N: usize>(&self, _: &Steps<N>) {}
///
///     fn run<T, const N: usize>(
///         &self,
///         plan: (),
///         run: Run<N>,
///         steps: &Steps<N>,
///         cells: impl Cells<T>,
///         pixels: &mut impl Pixels<T, N>,
///     ) {
///         struct Half<'a, P>(&'a mut P, bool);
///         impl<T, const N: usize, P: Pixels<T, N>> Pixels<T, N> for Half<'_, P> {
///             fn visible(&mut self, pixel: &T, q: u32, down: u32) -> bool {
///                 self.1 = !self.1;
///                 self.0.visible(pixel, q, down) && self.1
///             }
///             fn shade(&mut self, pixel: T, varyings: [i32; N]) {
///                 self.0.shade(pixel, varyings);
///             }
///         }
///         Exact.run(plan, run, steps, cells, &mut Half(pixels, false));
///     }
/// }
/// let pass = DrawOptions::new().mode(Sparse);
/// ```
pub trait Interpolate: Copy {
    /// Whether attributes are divided by 1/w; otherwise [`Run::p`] carries them alone, as parts of 2³⁰ that
    /// [`Scale::restore`] makes attributes of.
    const PERSPECTIVE: bool;

    /// The least [`Scale::bits`] that attributes are given: with b bits an interpolant's unit is 2^(b − 30) of
    /// the attribute's where 1/w is greatest. More bits than an attribute has lose accuracy, which may
    /// spare a mode the work of scaling; they are not asked for where 1/w changes fourfold in a triangle.
    const LEAST_BITS: u32 = 1;

    /// The mode under a parallel projection, where attributes themselves are linear on the screen.
    type Parallel: Interpolate;

    /// That mode.
    fn parallel(self) -> Self::Parallel;

    /// By how many of its units an attribute may be off where that spares all division, given how many its
    /// shader allows ([`TOLERANCES`](crate::Shader::TOLERANCES)); 0, as it is unless a mode says otherwise, is never.
    ///
    /// Triangles that change so little in depth that no attribute is off by more are drawn like those of a parallel
    /// projection: their runs have [`Steps::is_affine`] set, and [`Run::p`] carries attributes alone, times 4.
    #[inline]
    fn affine_within(&self, tolerance: Tolerance) -> u32 {
        let _ = tolerance;
        0
    }

    /// What is decided once for a triangle.
    type Plan: Copy + Default;

    /// Decides how a triangle is to be interpolated: what is the same for all of its runs.
    fn plan<const N: usize>(&self, steps: &Steps<N>) -> Self::Plan;

    /// Draws the pixels of `cells` from `run` on.
    fn run<T, const N: usize>(
        &self,
        plan: Self::Plan,
        run: Run<N>,
        steps: &Steps<N>,
        cells: impl Cells<T>,
        pixels: &mut impl Pixels<T, N>,
    );
}

/// Perspective-correct at every pixel, by the exact [`reciprocal`] of 1/w.
///
/// No pixel depends on one before it. Given the run's values, an attribute is rounded down to its
/// unit; the reciprocal adds less than 2⁻³⁰ of it.
///
/// ```
/// use fixel::{DrawOptions, interpolate::Exact};
/// let pass = DrawOptions::new().mode(Exact);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Exact;

impl Interpolate for Exact {
    const PERSPECTIVE: bool = true;
    type Parallel = Linear;
    type Plan = ();

    #[inline]
    fn parallel(self) -> Linear {
        Linear
    }

    #[inline]
    fn plan<const N: usize>(&self, _: &Steps<N>) {}

    #[inline]
    fn run<T, const N: usize>(
        &self,
        (): (),
        mut run: Run<N>,
        steps: &Steps<N>,
        mut cells: impl Cells<T>,
        pixels: &mut impl Pixels<T, N>,
    ) {
        for cell in cells.first(usize::MAX) {
            if pixels.visible(&cell, run.q, steps.depth) {
                pixels.shade(cell, divide(&run, &steps.scale));
            }
            run.step(steps);
        }
    }
}

/// The attributes at the run's present pixel: p / q · 2^bits, rounded down.
#[inline]
fn divide<const N: usize>(run: &Run<N>, scale: &[Scale; N]) -> [i32; N] {
    let up = (run.q | 1).leading_zeros();
    // Of 31 bits, so the product is one of signed numbers.
    let r = reciprocal((run.q << up) >> 1).cast_signed();
    let mut varyings = [0; N];
    for ((value, p), scale) in varyings.iter_mut().zip(run.p).zip(scale) {
        // p' = p << up is at most half of q' = q << up, so below 2^31, and r = 2^62 / q': p' · r is
        // p/q in units of 2^-62, and its upper half p/q in units of 2^-30.
        let fraction = (product(p << up, r) >> 32) as i32;
        *value = scale.restore(fraction);
    }
    varyings
}
