//! Modes that do not divide.

use super::mode::Interpolate;
use super::run::{Cells, Pixels, Run, Scale, Steps, rolled};

/// Linear on the screen, which is right under a parallel projection.
///
/// Under perspective it bends textures, as no other mode does: right for what faces the eye, is small, or
/// is far off for its size. An attribute is off by up to 37 of its units besides (a texture coordinate by
/// a two-thousandth of a texel).
///
/// ```
/// use fixel::{DrawOptions, interpolate::Affine};
/// let hud = DrawOptions::new().mode(Affine);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Affine;

/// Linear on the screen, to the unit: what [`Exact`](super::Exact) is under a parallel projection.
///
/// ```
/// use fixel::{DrawOptions, interpolate::Linear};
/// let plan = DrawOptions::new().mode(Linear);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Linear;

/// Bits at which an interpolant's unit is an attribute's.
const WHOLE: u32 = 30;

impl Interpolate for Affine {
    const PERSPECTIVE: bool = false;
    const LEAST_BITS: u32 = WHOLE;
    type Parallel = Self;
    /// Whether all attributes are interpolated in their own units.
    type Plan = bool;

    #[inline]
    fn parallel(self) -> Self {
        self
    }

    #[inline]
    fn plan<const N: usize>(&self, steps: &Steps<N>) -> bool {
        steps.scale.iter().all(|scale| scale.bits() == WHOLE)
    }

    #[inline]
    fn run<T, const N: usize>(
        &self,
        is_whole: bool,
        run: Run<N>,
        steps: &Steps<N>,
        cells: impl Cells<T>,
        pixels: &mut impl Pixels<T, N>,
    ) {
        if is_whole {
            walk(run, steps.q, steps.p, steps.depth, cells, pixels, |p| p);
        } else {
            Linear.run((), run, steps, cells, pixels);
        }
    }
}

impl Interpolate for Linear {
    const PERSPECTIVE: bool = false;
    type Parallel = Self;
    type Plan = ();

    #[inline]
    fn parallel(self) -> Self {
        self
    }

    #[inline]
    fn plan<const N: usize>(&self, _: &Steps<N>) {}

    #[inline]
    fn run<T, const N: usize>(
        &self,
        (): (),
        run: Run<N>,
        steps: &Steps<N>,
        cells: impl Cells<T>,
        pixels: &mut impl Pixels<T, N>,
    ) {
        walk(
            run,
            steps.q,
            steps.p,
            steps.depth,
            cells,
            pixels,
            |mut p| {
                for (p, scale) in p.iter_mut().zip(steps.scale) {
                    *p = scale.restore(*p);
                }
                p
            },
        );
    }
}

/// Draws a run of attributes that are their interpolants shifted up, as in a triangle that is [affine](Steps::is_affine).
#[inline]
pub(super) fn straight<T, const N: usize>(
    run: Run<N>,
    dq: i32,
    dp: [i32; N],
    down: u32,
    cells: impl Cells<T>,
    pixels: &mut impl Pixels<T, N>,
) {
    let restore = |p: [i32; N]| p.map(|p| p >> Scale::AFFINE_UP);
    walk(run, dq, dp, down, cells, pixels, restore);
}

/// Draws a run of attributes that `restore` makes of their interpolants.
#[inline]
fn walk<T, const N: usize>(
    mut run: Run<N>,
    dq: i32,
    dp: [i32; N],
    down: u32,
    mut cells: impl Cells<T>,
    pixels: &mut impl Pixels<T, N>,
    restore: impl Fn([i32; N]) -> [i32; N],
) {
    for cell in cells.first(usize::MAX) {
        rolled();
        if pixels.visible(&cell, run.q, down) {
            pixels.shade(cell, restore(run.p));
        }
        run.q = run.q.wrapping_add_signed(dq);
        for (p, step) in run.p.iter_mut().zip(dp) {
            *p = p.wrapping_add(step);
        }
    }
}
