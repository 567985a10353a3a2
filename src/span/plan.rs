//! How the pixels of a triangle or a span are computed, and how a draw call decides it.
//!
//! Notation, for values along a row of pixels: f is an attribute, q is 1/w, and p is f · q. f′, q′ and p′ are their
//! changes from one pixel to the next, and δ = |q′| / q. q is scaled so that its greatest value in a triangle has bit
//! 30 set.
//!
//! The plan of a triangle is found in this order:
//!
//! 1. Under a parallel projection and in mode [`Affine`](super::Affine), nothing is divided: the triangle's spans are
//!    straight.
//! 2. If the triangle's attributes are affine (linear on the screen) within the mode's tolerance
//!    ([`Policy::affine_within`]), the triangle's spans are straight, too. The inequality stands at
//!    `Attribute::is_affine` in setup.rs.
//! 3. The mode chooses ([`Policy::of_triangle`]), and may choose again for each span ([`Policy::of_span`]).

use super::pixels::Span;
use super::setup::Planes;
use crate::shade::{Lanes, Tolerance};

/// How the pixels of a triangle or a span are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Plan {
    /// For a triangle with small planes: attributes are linear, and a row is a single span.
    Small,
    /// Attributes are linear along the span. In a draw call that may divide attributes by w elsewhere, the attributes
    /// along this span are interpolated multiplied by 4.
    Straight,
    /// Attributes are linear along the span, but each attribute has its own scale, which is undone at each pixel.
    Scaled,
    /// For triangles only: each span of the triangle has its own plan.
    BySpan,
    /// One Newton step per pixel.
    Newton,
    /// Straight pieces. A piece has 2^n pixels, where n is this number.
    Pieces(u32),
    /// One division per pixel.
    Divide,
    /// One division per pixel, of interpolants that are computed for that pixel alone, without steps.
    Anew,
}

/// The decisions of a mode.
pub(crate) trait Policy: Copy {
    /// The plan for attributes that are not affine. Where this plan is not possible, the mode divides at each pixel.
    /// For attributes that are not affine, a program contains code for these two cases only.
    ///
    /// With [`Straight`](Plan::Straight), nothing is ever divided. With [`Divide`](Plan::Divide) or
    /// [`Anew`](Plan::Anew), all attributes are divided. With `Divide`, all triangles, even small ones, have wide
    /// planes (see [`Gradient`](super::gradient::Gradient)) and are drawn in the same way.
    const BEST: Plan;

    /// The greatest error that an attribute may have, in units of the attribute, if a triangle is drawn without
    /// divisions. With 0, no triangle is drawn without divisions.
    #[inline]
    fn affine_within(self, _tolerance: Tolerance) -> u32 {
        0
    }

    /// The plan for a triangle that is not affine.
    #[inline]
    fn of_triangle<L: Lanes>(self, _planes: &Planes<L>) -> Plan {
        Self::BEST
    }

    /// The plan for a span, if the plan of its triangle is [`BEST`](Self::BEST) or [`BySpan`](Plan::BySpan). This
    /// function may scale the span for its plan.
    #[inline(always)]
    fn of_span<L: Lanes>(
        self,
        of_triangle: Plan,
        _planes: &Planes<L>,
        _span: &mut Span<L>,
    ) -> Plan {
        of_triangle
    }
}
