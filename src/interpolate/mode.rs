//! The interpolation modes: how attributes are recovered along a run.

use super::reciprocal::reciprocal;
use super::run::{Pixels, Run, Scale, Steps};

/// A way to recover the attributes along a run of pixels.
///
/// The one seam at which speed is traded for accuracy. An implementation walks the run, asks
/// [`Pixels::visible`] of each pixel first, and recovers the attributes of those that are. It must
/// depend on nothing but the run, so that every band and every target draws the same.
///
/// ```
/// use fixel::interpolate::{Exact, Interpolate, Pixels, Run, Steps};
/// use fixel::{Pass};
///
/// /// Every other pixel, exactly.
/// #[derive(Clone, Copy)]
/// struct Sparse;
///
/// impl Interpolate for Sparse {
///     const PERSPECTIVE: bool = true;
///
///     fn run<T, const N: usize>(
///         &self,
///         run: Run<N>,
///         steps: &Steps<N>,
///         cells: impl ExactSizeIterator<Item = T>,
///         pixels: &mut impl Pixels<T, N>,
///     ) {
///         struct Half<'a, P>(&'a mut P, bool);
///         impl<T, const N: usize, P: Pixels<T, N>> Pixels<T, N> for Half<'_, P> {
///             fn visible(&mut self, pixel: &T, q: u32) -> bool {
///                 self.1 = !self.1;
///                 self.0.visible(pixel, q) && self.1
///             }
///             fn shade(&mut self, pixel: T, q: u32, varyings: [i32; N]) {
///                 self.0.shade(pixel, q, varyings);
///             }
///         }
///         Exact.run(run, steps, cells, &mut Half(pixels, false));
///     }
/// }
/// let pass = Pass::new().mode(Sparse);
/// ```
pub trait Interpolate: Copy {
    /// Whether attributes are divided by 1/w; otherwise [`Run::p`] carries them alone, times 2³⁰.
    const PERSPECTIVE: bool;

    /// Draws the pixels of `cells` from `run` on.
    fn run<T, const N: usize>(
        &self,
        run: Run<N>,
        steps: &Steps<N>,
        cells: impl ExactSizeIterator<Item = T>,
        pixels: &mut impl Pixels<T, N>,
    );
}

/// Perspective-correct at every pixel, by the exact [`reciprocal`] of 1/w.
///
/// No pixel depends on one before it. Given the run's values, an attribute is rounded down to its
/// unit; the reciprocal adds less than 2⁻³⁰ of it.
///
/// ```
/// use fixel::{Pass, interpolate::Exact};
/// let default: Pass<Exact> = Pass::new();
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Exact;

impl Interpolate for Exact {
    const PERSPECTIVE: bool = true;

    #[inline]
    fn run<T, const N: usize>(
        &self,
        mut run: Run<N>,
        steps: &Steps<N>,
        cells: impl ExactSizeIterator<Item = T>,
        pixels: &mut impl Pixels<T, N>,
    ) {
        for cell in cells {
            if pixels.visible(&cell, run.q) {
                pixels.shade(cell, run.q, divide(&run, &steps.scale));
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
    let r = i64::from(reciprocal((run.q << up) >> 1).cast_signed());
    let mut varyings = [0; N];
    for ((value, p), scale) in varyings.iter_mut().zip(run.p).zip(scale) {
        // p' = p << up is at most half of q' = q << up, so below 2^31, and r = 2^62 / q': p' · r is
        // p/q in units of 2^-62, and its upper half p/q in units of 2^-30.
        let fraction = ((i64::from(p << up) * r) >> 32) as i32;
        *value = scale.restore(fraction);
    }
    varyings
}

/// Linear on the screen: exact under a parallel projection, which always takes this mode.
///
/// Under perspective it bends textures; [`Exact`] does not.
///
/// ```
/// use fixel::{Pass, interpolate::Affine};
/// // Right for what faces the eye, and faster.
/// let hud = Pass::new().mode(Affine);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Affine;

impl Interpolate for Affine {
    const PERSPECTIVE: bool = false;

    #[inline]
    fn run<T, const N: usize>(
        &self,
        mut run: Run<N>,
        steps: &Steps<N>,
        cells: impl ExactSizeIterator<Item = T>,
        pixels: &mut impl Pixels<T, N>,
    ) {
        for cell in cells {
            if pixels.visible(&cell, run.q) {
                let mut varyings = [0; N];
                for ((value, p), scale) in varyings.iter_mut().zip(run.p).zip(steps.scale) {
                    *value = scale.restore(p);
                }
                pixels.shade(cell, run.q, varyings);
            }
            run.step(steps);
        }
    }
}
