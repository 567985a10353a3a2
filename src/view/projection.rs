//! Projections: from eye space to the picture.

use core::marker::PhantomData;

use crate::num::block::{self, BlockFloat};
use crate::span::Interpolate;
use crate::{Error, Matrix4, Scalar};

mod parallel;
mod perspective;
#[cfg(test)]
mod tests;

mod sealed {
    pub trait Sealed {}
}

/// The two kinds of projection: [`Perspective`] and [`Parallel`].
///
/// ```
/// use fixel::prelude::*;
/// use fixel::view::ProjectionKind;
///
/// /// Works for both.
/// fn depth_of_view<K: ProjectionKind>(projection: &Projection<K>) -> Scalar {
///     projection.far() - projection.near()
/// }
/// ```
pub trait ProjectionKind: sealed::Sealed + Copy + core::fmt::Debug {
    /// Whether the picture shrinks with distance.
    const PERSPECTIVE: bool;

    /// The way attributes are interpolated when a draw call asks for `I`.
    type Mode<I: Interpolate>: Interpolate;

    /// That way, of the one asked for.
    fn mode<I: Interpolate>(mode: I) -> Self::Mode<I>;
}

/// Lines of sight meet in the eye: what is far is small.
///
/// ```
/// use fixel::{Angle, Projection, fx, view::Perspective};
/// let projection: Projection<Perspective> =
///     Projection::perspective(Angle::from_degrees(60), (4, 3), fx!(0.1), fx!(100))?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Perspective;

/// Lines of sight are parallel: what is far keeps its size.
///
/// ```
/// use fixel::{Projection, fx, view::Parallel};
/// let plan: Projection<Parallel> =
///     Projection::orthographic(fx!(-4), fx!(4), fx!(-3), fx!(3), fx!(0), fx!(100))?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parallel;

impl sealed::Sealed for Perspective {}
impl sealed::Sealed for Parallel {}

impl ProjectionKind for Perspective {
    const PERSPECTIVE: bool = true;
    type Mode<I: Interpolate> = I;

    fn mode<I: Interpolate>(mode: I) -> I {
        mode
    }
}

impl ProjectionKind for Parallel {
    const PERSPECTIVE: bool = false;
    type Mode<I: Interpolate> = I::Parallel;

    fn mode<I: Interpolate>(mode: I) -> I::Parallel {
        mode.parallel()
    }
}

/// A row of a projection matrix: coefficients of eye space's x, y, z and 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Row {
    /// Mantissas, below 2^30 in magnitude.
    pub(crate) m: [i32; 4],
    /// Values are mantissas · 2^-exp.
    pub(crate) exp: i32,
}

impl Row {
    /// A row of its numbers.
    fn new(entries: [BlockFloat; 4]) -> Self {
        let mut m = [0; 4];
        let exp = block::normalize(&mut m, &entries);
        Self { m, exp }
    }

    /// A coefficient as a number.
    fn real(&self, i: usize) -> BlockFloat {
        BlockFloat::new(self.m[i].into(), self.exp)
    }
}

/// What of eye space comes into the picture, and where.
///
/// Eye space is right-handed: x to the right, y up, and the view down −z. `near` and `far` are
/// distances ahead of the eye. A projection takes its frustum or box to normalized device
/// coordinates, ±1 from edge to edge.
///
/// Coefficients have 30 bits, whatever their size.
///
/// ```
/// use fixel::prelude::*;
/// let projection = Projection::perspective(Angle::from_degrees(60), (320, 240), fx!(0.1), fx!(100))?;
/// let plan = Projection::orthographic(fx!(-4), fx!(4), fx!(-3), fx!(3), fx!(0), fx!(10))?;
/// assert!(Projection::perspective(Angle::from_degrees(60), (4, 3), fx!(0), fx!(100)).is_err());
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Projection<K = Perspective> {
    /// Normalized device coordinates x and y, times w: −z for a perspective, else 1.
    pub(crate) rows: [Row; 2],
    pub(crate) near: Scalar,
    pub(crate) far: Scalar,
    kind: PhantomData<K>,
}

fn bits(value: Scalar) -> i64 {
    value.to_bits().into()
}

fn number(value: Scalar) -> BlockFloat {
    BlockFloat::new(bits(value), 16)
}

/// A number to the nearest [`Scalar`]; saturates.
fn scalar(number: BlockFloat) -> Scalar {
    Scalar::from_bits(block::fixed(number.value, number.exp, 16))
}

fn check_far(near: Scalar, far: Scalar) -> Result<(), Error> {
    if far > near {
        Ok(())
    } else {
        Err(Error::Far { near, far })
    }
}

/// Size and sum of a pair of edges, in units of 2^-16: 33 bits.
fn extent(low: Scalar, high: Scalar) -> Result<(i64, i64), Error> {
    if low < high {
        Ok((bits(high) - bits(low), bits(high) + bits(low)))
    } else {
        Err(Error::EmptyFrustum { low, high })
    }
}

impl<K: ProjectionKind> Projection<K> {
    /// The distance of the near plane.
    #[must_use]
    pub const fn near(&self) -> Scalar {
        self.near
    }

    /// The distance of the far plane.
    #[must_use]
    pub const fn far(&self) -> Scalar {
        self.far
    }

    /// The left edge of the window on the near plane; to 2⁻³⁰ of the largest of the four,
    /// saturated.
    #[must_use]
    pub fn left(&self) -> Scalar {
        self.edge(0, -1)
    }

    /// The right edge of the window on the near plane, as [`left`](Self::left).
    #[must_use]
    pub fn right(&self) -> Scalar {
        self.edge(0, 1)
    }

    /// The bottom edge of the window on the near plane, as [`left`](Self::left).
    #[must_use]
    pub fn bottom(&self) -> Scalar {
        self.edge(1, -1)
    }

    /// The top edge of the window on the near plane, as [`left`](Self::left).
    #[must_use]
    pub fn top(&self) -> Scalar {
        self.edge(1, 1)
    }

    /// Where on the near plane, at z = −n, the numerator a·x + c·z + d is ±w.
    fn edge(&self, axis: usize, sign: i64) -> Scalar {
        let row = &self.rows[axis];
        let near = number(self.near);
        let w = if K::PERSPECTIVE {
            near
        } else {
            BlockFloat::new(1, 0)
        };
        let moved = row.real(2).times(near).plus(row.real(3).negated());
        let edge = BlockFloat::new(sign * w.value, w.exp).plus(moved);
        scalar(edge.over(row.real(axis)))
    }

    /// Width to height of the window, (right − left) / (top − bottom); saturated.
    #[must_use]
    pub fn aspect(&self) -> Scalar {
        scalar(self.rows[1].real(1).over(self.rows[0].real(0)))
    }

    /// The projection as a matrix to homogeneous clip coordinates: entries are rounded to 2⁻¹⁶ and
    /// saturate.
    ///
    /// Depth goes from −1 at the near plane to 1 at the far plane.
    #[must_use]
    pub fn to_matrix(&self) -> Matrix4 {
        let [x, y] =
            [0, 1].map(|axis: usize| [0, 1, 2, 3].map(|i| scalar(self.rows[axis].real(i))));
        let (near, far) = (bits(self.near), bits(self.far));
        let depth = BlockFloat::new(far - near, 16);
        let middle = BlockFloat::new(-(far + near), 16).over(depth);
        let (zero, one) = (Scalar::ZERO, Scalar::ONE);
        if K::PERSPECTIVE {
            let offset = BlockFloat::new(-2 * near, 16)
                .times(number(self.far))
                .over(depth);
            let z = [zero, zero, scalar(middle), scalar(offset)];
            Matrix4::new([x, y, z, [zero, zero, -one, zero]])
        } else {
            let z = [
                zero,
                zero,
                scalar(BlockFloat::new(-2, 0).over(depth)),
                scalar(middle),
            ];
            Matrix4::new([x, y, z, [zero, zero, zero, one]])
        }
    }
}
