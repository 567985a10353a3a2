//! The planes of a primitive, its plan, and the first values of its spans.

use core::marker::PhantomData;

use embedded_graphics::geometry::Point;

use super::interpolant::Interpolant;
use super::mode::Mode;
use super::newton::FRACTION;
use super::pixels::Span;
use super::plan::Plan;
use super::scale::WHOLE;
use super::setup::{Planes, Setup, Varying};
use crate::raster::Patch;
use crate::shade::{Lanes, Tolerance};
use crate::view::ProjectionKind;

/// Tolerances are clamped to this number, so that four times a tolerance takes 31 bits. No varying that is drawn
/// affinely is as great as this number.
const MOST_TOLERANCE: u32 = (1 << 29) - 1;
const _: () = assert!(4 * MOST_TOLERANCE <= i32::MAX.cast_unsigned());

/// The data that the spans of a primitive share. The types of shader and canvas do not appear here, so one copy of this
/// code serves all shaders with the same number of interpolated numbers.
pub(super) struct Interpolator<L: Lanes, K, M> {
    pub(super) mode: M,
    pub(super) planes: Planes<L>,
    pub(super) plan: Plan,
    kind: PhantomData<K>,
}

impl<L: Lanes, K: ProjectionKind, M: Mode> Interpolator<L, K, M> {
    /// Whether varyings are divided by w.
    pub(super) const OVER_W: bool = K::PERSPECTIVE && !matches!(M::KERNEL, Plan::Straight);

    /// The plan for varyings that are not linear on the screen.
    pub(super) const KERNEL: Plan = if Self::OVER_W && L::COUNT > 0 {
        M::KERNEL
    } else {
        Plan::Straight
    };

    /// Whether the mode uses wide planes only.
    const ONLY_WIDE: bool = matches!(M::KERNEL, Plan::Divide);

    /// Whether a mode takes the same path for all varyings, linear or not.
    const IS_UNIFORM: bool = matches!(M::KERNEL, Plan::Divide | Plan::PerPixel);

    /// Whether a plan may be [`Plan::Straight`].
    pub(super) const HAS_STRAIGHT: bool = L::COUNT == 0 || !Self::IS_UNIFORM;

    /// Whether a plan may be [`Plan::Small`].
    pub(super) const HAS_SMALL: bool = Self::HAS_STRAIGHT && !Self::ONLY_WIDE;

    /// Whether a plan may be [`Plan::SmallOverW`].
    pub(super) const HAS_SMALL_OVER_W: bool = matches!(Self::KERNEL, Plan::Newton);

    const LEAST_BITS: u32 = match M::KERNEL {
        Plan::Newton if Self::OVER_W => FRACTION,
        _ if Self::OVER_W || Self::IS_UNIFORM => 1,
        _ => WHOLE,
    };

    #[inline(never)]
    pub(super) fn new(mode: M, tolerance: fn(usize) -> Tolerance, pairs: bool) -> Self {
        let mut lanes = L::splat(0);
        for (lane, number) in lanes.as_mut().iter_mut().enumerate() {
            *number = lane;
        }
        Self {
            mode,
            planes: Planes {
                setup: Setup::new([!Self::OVER_W, pairs], Self::LEAST_BITS),
                // The varyings are built in place. If a loop built them, they would be copied into `planes` afterwards.
                varyings: L::map(&lanes, |&lane| {
                    let [small, large] = mode.affine_within(tolerance(lane));
                    Varying {
                        tolerance: [small.min(MOST_TOLERANCE), large.min(MOST_TOLERANCE)],
                        ..Varying::UNSET
                    }
                }),
            },
            plan: Self::KERNEL,
            kind: PhantomData,
        }
    }

    /// Sets the values of the varyings at a primitive's corners.
    #[inline]
    pub(super) fn set_corners(&mut self, [a, b, c]: [L::Of<i32>; 3]) {
        let corners = L::zip(&L::zip(&a, &b, |a, b| [*a, *b]), &c, |[a, b], c| {
            [*a, *b, *c]
        });
        let varyings = self.planes.varyings.as_mut().iter_mut();
        for (varying, corners) in varyings.zip(corners.as_ref()) {
            varying.corners = *corners;
        }
    }

    /// Sets up the interpolants over a patch of the primitive.
    #[inline(never)]
    pub(super) fn set_up(&mut self, patch: &Patch<'_>) {
        let Planes { setup, varyings } = &mut self.planes;
        if Self::ONLY_WIDE {
            setup.set_up_wide(varyings.as_mut(), patch);
            return;
        }
        if L::COUNT == 0 && patch.is_point() {
            setup.set_up_point(patch);
            self.plan = Plan::Small;
            return;
        }
        self.plan = setup.set_up(varyings.as_mut(), patch);
        if Self::KERNEL == Plan::Straight || self.plan != Plan::BySpan {
            return;
        }
        self.plan = self.mode.of_triangle(&self.planes);
        if Self::KERNEL == Plan::PerPixel && self.plan == Plan::PerPixel {
            let Planes { setup, varyings } = &mut self.planes;
            // Depths keep the plane that they have in all modes but `Compact`.
            let mut q = setup.q;
            setup.set_up_wide(varyings.as_mut(), patch);
            q.wide = setup.q.wide;
            setup.q = q;
        }
    }

    /// The span that begins at a pixel, and its plan.
    #[inline(never)]
    pub(super) fn span_at(&self, [x, y]: [i32; 2], count: usize) -> (Span<L>, Plan) {
        // A canvas has at most 2048 columns and rows, so the masks change nothing. With these two masks, the compiler
        // leaves out the same masks in each plane.
        let (x, y) = (x & 0x7fff, y & 0x7fff);
        let at = |interpolant: &Interpolant| {
            if Self::ONLY_WIDE {
                interpolant.wide.at(x, y)
            } else {
                interpolant.at(x, y)
            }
        };
        let Planes { setup, varyings } = &self.planes;
        let mut span = Span {
            q: at(&setup.q).cast_unsigned(),
            p: L::map(varyings, |p: &Varying| at(&p.interpolant)),
            dq: setup.q.step,
            dp: L::map(varyings, |p: &Varying| p.interpolant.step),
            down: setup.down,
            count,
        };
        let is_chosen_again = match self.plan {
            Plan::BySpan | Plan::Newton | Plan::Pieces(_) => Self::KERNEL != Plan::Straight,
            // Otherwise, spans are drawn elsewhere.
            Plan::SmallOverW => Self::HAS_SMALL_OVER_W && cfg!(for_size),
            _ => false,
        };
        let plan = if is_chosen_again {
            self.mode.of_span(self.plan, &self.planes, &mut span)
        } else {
            self.plan
        };
        (span, plan)
    }

    /// The interpolants of a pixel, computed without steps from other pixels: q with 31 bits, and each p.
    pub(super) fn recomputed(&self, Point { x, y }: Point) -> (u32, L::Of<i32>) {
        let at = [x, y];
        let (q, up) = self.planes.setup.precise_q(at);
        let p = L::map(&self.planes.varyings, |p: &Varying| {
            p.interpolant.wide.precise(at, up)
        });
        (q, p)
    }
}
