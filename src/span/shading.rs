//! How a draw call tests and colors a pixel: by a shader, a blending and a depth test.

use core::cell::Cell;

use crate::canvas::{Blending, DepthTest};
use crate::mesh::Primitive;
use crate::raster::Coverage;
use crate::shade::{ColorOf, Fragment, Output, PixelFormat, Shader, Varyings};

/// The rules by which a draw call tests and colors a pixel: a [`Shader`], a [`Blending`], a [`DepthTest`] and, for
/// [`Smooth`] lines, the share of the pixel that the line covers.
pub trait Shading: Copy {
    /// The color of the canvas.
    type Color;

    /// See [`Shader::Varyings`].
    type Varyings: Varyings;

    type Test: DepthTest;

    /// See [`Shader::READS_DEPTH`].
    const READS_DEPTH: bool;

    /// Whether [`color`](Self::color) reads the color on the canvas.
    const READS_COLOR: bool;

    fn test(&self) -> Self::Test;

    /// See [`Shader::varyings`].
    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3];

    /// A pixel's new color, where `below` is the color on the canvas; `None` keeps the pixel's color and depth.
    fn color(
        &self,
        at: &Fragment,
        varyings: Self::Varyings,
        below: impl FnOnce() -> Self::Color,
    ) -> Option<Self::Color>;
}

/// A shader, a blending and a depth test.
#[derive(Clone, Copy)]
pub struct Plain<S, B, Z> {
    pub(crate) shader: S,
    pub(crate) blending: B,
    pub(crate) test: Z,
}

impl<S, B, Z> From<(Self, &Cell<Coverage>)> for Plain<S, B, Z> {
    #[inline]
    fn from((plain, _): (Self, &Cell<Coverage>)) -> Self {
        plain
    }
}

impl<S: Shader, B: Blending<ColorOf<S>>, Z: DepthTest> Shading for Plain<S, B, Z> {
    type Color = ColorOf<S>;
    type Varyings = S::Varyings;
    type Test = Z;

    const READS_DEPTH: bool = S::READS_DEPTH;
    const READS_COLOR: bool = B::READS || !S::Color::IS_OPAQUE;

    #[inline]
    fn test(&self) -> Z {
        self.test
    }

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.shader.varyings(primitive)
    }

    #[inline]
    fn color(
        &self,
        at: &Fragment,
        varyings: S::Varyings,
        below: impl FnOnce() -> ColorOf<S>,
    ) -> Option<ColorOf<S>> {
        let source = self.shader.shade(at, varyings)?;
        Some(self.blending.blend(source, below, at.point))
    }
}

/// Whether each varying of a rectangle lies on one plane; `halves` are the triangles abc and cbd. If so, no varying has
/// a value at d beyond its values at a, b and c.
#[inline]
pub(crate) fn is_plane<P: Shading>(shading: &P, halves: [&Primitive<'_>; 2]) -> bool {
    // Values of a face cannot be compared, but most shaders have none.
    if size_of::<<P::Varyings as Varyings>::Face>() > 0 {
        return false;
    }
    let [one, other] = halves.map(|half| shading.varyings(half).map(|corner| corner.split().0));
    let ([a, b, c], [same_c, same_b, d]) = (&one, &other);
    let (b, c) = (
        b.as_ref().iter().zip(same_b.as_ref()),
        c.as_ref().iter().zip(same_c.as_ref()),
    );
    let mut corners = a.as_ref().iter().zip(d.as_ref()).zip(b.zip(c));
    corners.all(|((a, d), ((b, same_b), (c, same_c)))| {
        b == same_b && c == same_c && (a == b && c == d || a == c && b == d)
    })
}

/// A shader, a blending and a depth test for anti-aliased lines. The color covers the color on the canvas in proportion
/// to the share of the pixel that the current line covers.
#[derive(Clone, Copy)]
pub struct Smooth<'l, S, B, Z> {
    plain: Plain<S, B, Z>,
    /// The rasterizer sets the coverage for each line.
    coverage: &'l Cell<Coverage>,
}

impl<'l, S, B, Z> From<(Plain<S, B, Z>, &'l Cell<Coverage>)> for Smooth<'l, S, B, Z> {
    #[inline]
    fn from((plain, coverage): (Plain<S, B, Z>, &'l Cell<Coverage>)) -> Self {
        Self { plain, coverage }
    }
}

impl<S, B, Z> Shading for Smooth<'_, S, B, Z>
where
    S: Shader,
    ColorOf<S>: PixelFormat,
    B: Blending<ColorOf<S>>,
    Z: DepthTest,
{
    type Color = ColorOf<S>;
    type Varyings = S::Varyings;
    type Test = Z;

    const READS_DEPTH: bool = S::READS_DEPTH;
    const READS_COLOR: bool = true;

    #[inline]
    fn test(&self) -> Z {
        self.plain.test
    }

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.plain.shader.varyings(primitive)
    }

    #[inline]
    fn color(
        &self,
        at: &Fragment,
        varyings: S::Varyings,
        below: impl FnOnce() -> ColorOf<S>,
    ) -> Option<ColorOf<S>> {
        let coverage = self.coverage.get().at(at.point);
        if coverage == 0 {
            return None;
        }
        let source = self.plain.shader.shade(at, varyings)?;
        let below = below();
        let color = self.plain.blending.blend(source, || below, at.point);
        Some(below.covered(color, (coverage << 8).cast_signed(), at.point))
    }
}
