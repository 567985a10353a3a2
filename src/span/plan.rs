//! How the pixels of a triangle or a span are computed, and how a draw call decides it.
//!
//! Notation, for values along a row of pixels: f is a varying, q is 1/w, and p is f · q. f′, q′ and p′ are their
//! changes from one pixel to the next, and δ = |q′| / q. q is scaled so that its greatest value in a triangle has bit
//! 30 set.
//!
//! The plan of a triangle is found in this order:
//!
//! 1. Under a parallel projection and in mode [`Affine`](super::Affine), nothing is divided: the triangle's spans are
//!    straight.
//! 2. If the triangle's varyings are affine (linear on the screen) within the mode's tolerance
//!    ([`Mode::affine_within`](super::Mode::affine_within)), the triangle's spans are straight, too. The inequality stands at
//!    `Varying::is_affine` in setup.rs.
//! 3. The mode chooses ([`Mode::of_triangle`](super::Mode::of_triangle)), and may choose again for each span ([`Mode::of_span`](super::Mode::of_span)).

/// How the pixels of a triangle or a span are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Plan {
    /// For a triangle with small planes: varyings are linear, and a row is a single span.
    Small,
    /// For a triangle with small planes: varyings are divided by w, and a row is a single span. Depending on how 1/w
    /// changes from pixel to pixel, all rows are straight, or have one Newton step or one division per pixel.
    SmallOverW,
    /// Varyings are linear along the span. In a draw call that may divide varyings by w elsewhere, the varyings along
    /// this span are interpolated multiplied by 4.
    Straight,
    /// Varyings are linear along the span, but each varying has its own scale, which is undone at each pixel.
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
    PerPixel,
}
