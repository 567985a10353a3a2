//! How a primitive is interpolated: its planes, and the kernel that draws its spans.

use core::marker::PhantomData;

use super::gradient::Gradient;
use super::mode::{DEEP, Derivatives, Kernel, Policy, WHOLE};
use super::newton::tangent;
use super::pixels::Span;
use super::scale::Scale;
use super::setup::{Attribute, Interpolation, Setup};
use crate::raster::{DepthShift, Patch};
use crate::shade::{Lanes, Tolerance};
use crate::view::ProjectionKind;

/// Upper clamp of a tolerance: four times this takes 31 bits, and no attribute that is drawn affinely is as great.
const MOST_TOLERANCE: u32 = (1 << 29) - 1;
const _: () = assert!(4 * MOST_TOLERANCE <= i32::MAX.cast_unsigned());

/// The data that the spans of a primitive share, whatever its shader and canvas: one copy of this code serves all
/// shaders with the same number of interpolated numbers.
pub(super) struct Interpolator<L: Lanes, K, M> {
    mode: M,
    pub(super) setup: Setup,
    pub(super) attributes: L::Of<Attribute>,
    pub(super) derivatives: Derivatives<L>,
    /// The kernel of all spans; `None` if the mode chooses span by span.
    kernel: Option<Kernel>,
    kind: PhantomData<K>,
}

impl<L: Lanes, K: ProjectionKind, M: Policy> Interpolator<L, K, M> {
    /// Whether attributes are divided by w.
    pub(super) const OVER_W: bool = K::PERSPECTIVE && M::DIVIDES;

    /// The least number of bits of a scale.
    const LEAST_BITS: u32 = match (Self::OVER_W, K::PERSPECTIVE) {
        (true, _) => M::LEAST_BITS,
        (false, true) => WHOLE,
        (false, false) => M::LEAST_PARALLEL_BITS,
    };

    #[inline(never)]
    pub(super) fn new(
        mode: M,
        tolerances: &L::Of<Tolerance>,
        pairs: bool,
        shift: DepthShift,
    ) -> Self {
        let attributes = L::map(tolerances, |tolerance| Attribute {
            tolerance: mode.affine_within(*tolerance).min(MOST_TOLERANCE),
            ..Attribute::UNSET
        });
        let interpolation = match (Self::OVER_W, pairs) {
            (false, _) => Interpolation::Linear,
            (true, false) => Interpolation::Perspective,
            (true, true) => Interpolation::Paired,
        };
        Self {
            mode,
            setup: Setup::new(interpolation, Self::LEAST_BITS, shift),
            attributes,
            derivatives: Derivatives {
                q: 0,
                p: L::splat(0),
                scales: L::splat(Scale::UNSET),
                least: 0,
            },
            kernel: None,
            kind: PhantomData,
        }
    }

    /// Sets the attributes of a primitive: their values at its corners.
    #[inline]
    pub(super) fn start(&mut self, [a, b, c]: [L::Of<i32>; 3]) {
        let corners = L::zip(&L::zip(&a, &b, |a, b| [*a, *b]), &c, |[a, b], c| {
            [*a, *b, *c]
        });
        let attributes = self.attributes.as_mut().iter_mut();
        for (attribute, corners) in attributes.zip(corners.as_ref()) {
            attribute.corners = *corners;
        }
    }

    /// Lays the interpolants over a patch of the primitive.
    #[inline(never)]
    pub(super) fn set_up(&mut self, patch: &Patch<'_>) {
        if M::IS_COMPACT {
            self.setup.lay_wide(self.attributes.as_mut(), patch);
        } else {
            self.setup.lay(self.attributes.as_mut(), patch);
        }
        self.derivatives = Derivatives {
            q: self.setup.q.step,
            p: L::map(&self.attributes, |p| p.gradient.step),
            scales: L::map(&self.attributes, |p| p.scale),
            least: self.setup.least,
        };
        if L::COUNT == 0 || M::IS_COMPACT {
            return;
        }
        let is_precise = Self::OVER_W && M::IS_PRECISE && self.setup.least < DEEP;
        self.kernel = if is_precise {
            // Depths keep the plane that they have in all modes.
            let mut q = self.setup.q;
            self.setup.lay_wide(self.attributes.as_mut(), patch);
            q.wide = self.setup.q.wide;
            self.setup.q = q;
            Some(Kernel::DivideAnew)
        } else if !Self::OVER_W {
            let is_whole = L::all(&self.derivatives.scales, |scale| scale.bits() == WHOLE);
            let is_whole = Self::LEAST_BITS == WHOLE && is_whole;
            Some(if is_whole {
                Kernel::Straight
            } else {
                Kernel::Scaled
            })
        } else if self.setup.is_affine {
            Some(Kernel::Straight)
        } else {
            self.mode.of_triangle(&self.derivatives)
        };
    }

    /// Whether all spans are straight, and begin at small planes.
    #[inline(always)]
    pub(super) fn is_small(&self) -> bool {
        let is_straight = L::COUNT == 0 || self.kernel == Some(Kernel::Straight);
        !M::IS_COMPACT && is_straight && self.setup.is_small
    }

    /// The span that begins at a pixel, with a kernel to draw it.
    #[inline(never)]
    pub(super) fn begin(&self, [x, y]: [i32; 2], count: usize) -> (Span<L>, Kernel) {
        // A canvas has fewer columns and rows. Masked here, they need no mask in each plane.
        let (x, y) = (x & 0x7fff, y & 0x7fff);
        let at = |gradient: &Gradient| {
            if M::IS_COMPACT {
                gradient.wide.at(x, y)
            } else {
                gradient.at(x, y)
            }
        };
        let mut span = Span {
            q: at(&self.setup.q).cast_unsigned(),
            p: L::map(&self.attributes, |p: &Attribute| at(&p.gradient)),
            dq: self.derivatives.q,
            dp: self.derivatives.p,
            down: self.setup.down,
            count,
        };
        if L::COUNT == 0 {
            return (span, Kernel::Straight);
        }
        if M::IS_COMPACT {
            return (span, Kernel::Divide);
        }
        if let Some(
            kernel @ (Kernel::Straight | Kernel::Scaled | Kernel::Divide | Kernel::DivideAnew),
        ) = self.kernel
        {
            return (span, kernel);
        }
        let kernel = self.mode.of_span(self.kernel, &mut span, &self.derivatives);
        if kernel == Kernel::Tangent {
            tangent(&mut span);
            return (span, Kernel::Straight);
        }
        (span, kernel)
    }

    /// The interpolants of a pixel that is `x` pixels right of another, without a step: q with 31 bits, and each p.
    pub(super) fn anew(&self, [first, y]: [i32; 2], x: i32) -> (u32, L::Of<i32>) {
        let at = [first + x, y];
        let (q, up) = self.setup.precise_q(at);
        let p = L::map(&self.attributes, |p: &Attribute| {
            p.gradient.wide.precise(at, up)
        });
        (q, p)
    }
}
