//! Projections: from eye space to the picture.

use core::marker::PhantomData;

use super::{Viewport, Window};
use crate::math::{Matrix4, Vec3};
use crate::num::Scalar;
use crate::num::block::{self, BlockFloat};
use crate::sealed::Sealed;

mod parallel;
mod perspective;
#[cfg(test)]
mod tests;

/// The two kinds of projection: [`Perspective`] and [`Parallel`].
///
/// ```
/// use fixel::prelude::*;
/// use fixel::view::ProjectionKind;
///
/// /// Works for both kinds.
/// fn depth_of_view<K: ProjectionKind>(projection: &Projection<K>) -> Scalar {
///     projection.far() - projection.near()
/// }
/// ```
pub trait ProjectionKind: Sealed + Copy + core::fmt::Debug {
    /// Whether objects shrink with distance.
    const PERSPECTIVE: bool;
}

/// The kind of projection with lines of sight that meet in the eye: distant objects look smaller.
///
/// ```
/// use fixel::{Projection, deg, fx, view::Perspective};
/// let projection: Projection<Perspective> =
///     Projection::perspective(deg!(60), (4, 3), fx!(0.5), fx!(50))?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Perspective;

/// The kind of projection with parallel lines of sight: distant objects keep their size.
///
/// ```
/// use fixel::{Projection, Window, fx, view::Parallel};
/// let plan: Projection<Parallel> =
///     Projection::orthographic(Window::centered(fx!(8), fx!(6)), fx!(0), fx!(100))?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Parallel;

impl Sealed for Perspective {}
impl Sealed for Parallel {}

impl ProjectionKind for Perspective {
    const PERSPECTIVE: bool = true;
}

impl ProjectionKind for Parallel {
    const PERSPECTIVE: bool = false;
}

/// A row of a projection matrix: coefficients of eye space's x, y, z and 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct ProjectionRow {
    /// The mantissas of the coefficients, below 2^30 in magnitude.
    pub(crate) m: [i32; 4],
    /// The exponent of the first three coefficients, which are mantissas · 2^-exp.
    pub(crate) exp: i32,
    /// The exponent of the last coefficient. If a window is far from the line of sight, the last coefficient is much
    /// greater than the other three, which would lose bits if they shared its exponent.
    pub(crate) offset_exp: i32,
}

impl ProjectionRow {
    /// Makes a row from its coefficients, each rounded once.
    fn new(entries: [BlockFloat; 3], offset: BlockFloat) -> Self {
        let mut linear = [0; 3];
        let exp = block::normalize(&mut linear, &entries);
        let (offset, offset_exp) = offset.rounded();
        let [x, y, z] = linear;
        Self {
            m: [x, y, z, offset],
            exp,
            offset_exp,
        }
    }

    /// Returns the coefficient of x, y, z or 1: `i` is its index, from 0 to 3.
    fn coefficient(&self, i: usize) -> BlockFloat {
        let exp = if i < 3 { self.exp } else { self.offset_exp };
        BlockFloat::new(self.m[i].into(), exp)
    }
}

/// The part of eye space that is visible, and how it maps to the picture.
///
#[cfg_attr(doc, doc = include_str!("../guide/diagrams/eye.svg"))]
///
/// Eye space is right-handed: x points to the right, y points up, and the eye looks down −z. `near` and `far` are
/// distances ahead of the eye. A projection maps its frustum or box to normalized device coordinates, ±1 from edge to
/// edge.
///
/// [Mathematics](crate::guide::mathematics::projection#a-matrix) derives the matrix from similar triangles.
///
/// The coefficients of the matrix have 30 significant bits, whatever their size. There is one exception. With an
/// off-center window, or in an oblique projection, x or y of the picture also depends on z. Of its two coefficients,
/// the smaller one can then have fewer bits.
///
/// ```
/// use fixel::prelude::*;
/// use fixel::Window;
/// let projection = Projection::perspective(deg!(60), (320, 240), fx!(0.5), fx!(50))?;
/// let plan = Projection::orthographic(Window::centered(fx!(8), fx!(6)), fx!(0), fx!(10))?;
/// assert!(Projection::perspective(deg!(60), (4, 3), fx!(0), fx!(100)).is_err());
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Projection<K = Perspective> {
    /// The rows for x and y of normalized device coordinates, times w. In perspective, w is −z; otherwise, w is 1.
    pub(crate) rows: [ProjectionRow; 2],
    pub(crate) near: Scalar,
    pub(crate) far: Scalar,
    /// The factor of a distance in the first coordinate of [`ClipPosition`](crate::pipeline::ClipPosition), as a
    /// mantissa and its exponent. It is kept, because a division in each draw call would take long.
    pub(crate) of_distance: (i32, i32),
    kind: PhantomData<K>,
}

fn bits(value: Scalar) -> i64 {
    value.to_bits().into()
}

fn number(value: Scalar) -> BlockFloat {
    BlockFloat::new(bits(value), 16)
}

/// Rounds to the nearest [`Scalar`]; saturates.
fn scalar(number: BlockFloat) -> Scalar {
    Scalar::from_bits(block::fixed(number.value, number.exp, 16))
}

impl<K: ProjectionKind> Projection<K> {
    /// Makes a projection from three coefficients for x and three for y: the factor, the slope along z, and the offset.
    fn of_axes(axes: [[BlockFloat; 3]; 2], near: Scalar, far: Scalar) -> Self {
        let [[x, x_slope, x_offset], [y, y_slope, y_offset]] = axes;
        let rows = [
            ProjectionRow::new([x, BlockFloat::ZERO, x_slope], x_offset),
            ProjectionRow::new([BlockFloat::ZERO, y, y_slope], y_offset),
        ];
        Self::of_rows(rows, near, far)
    }

    /// Makes a projection from its rows.
    fn of_rows(rows: [ProjectionRow; 2], near: Scalar, far: Scalar) -> Self {
        let (nearest, length) = if K::PERSPECTIVE {
            // t = w / near · (1 + 2^-16), slightly above 1 at the near plane: the greatest 1/t is 1 − 2^-16, which
            // leaves room for rounding below a depth of 65536.
            ((1 << 16) + 1, bits(near))
        } else {
            // t = (far − distance) / (far − near) · (1 − 2^-16), slightly below 1 at the near plane.
            ((1 << 16) - 1, bits(far) - bits(near))
        };
        let of_distance = BlockFloat::new(nearest, 0).over(BlockFloat::new(length, 0));
        Self {
            rows,
            near,
            far,
            of_distance: of_distance.rounded(),
            kind: PhantomData,
        }
    }

    /// Returns the distance of the near plane.
    #[must_use]
    pub const fn near(&self) -> Scalar {
        self.near
    }

    /// Returns the distance of the far plane.
    #[must_use]
    pub const fn far(&self) -> Scalar {
        self.far
    }

    /// Returns the window on the near plane.
    ///
    /// Each edge has an error of at most 2⁻²⁹ of the largest edge, before it is rounded to the nearest 2⁻¹⁶; it
    /// saturates. In perspective and under an oblique projection, `near` counts as an edge in this bound. Under an
    /// oblique projection, the bound is also multiplied by 1 + |ratio|, where ratio is the argument of
    /// [`oblique`](Projection::oblique). In perspective, let m be the distance from the line of sight to the middle of
    /// the window: if m exceeds `near`, the bound is also multiplied by m / `near`.
    #[must_use]
    pub fn window(&self) -> Window {
        Window {
            left: self.edge(0, -1),
            right: self.edge(0, 1),
            bottom: self.edge(1, -1),
            top: self.edge(1, 1),
        }
    }

    /// The direction in eye space from the scene toward a viewer infinitely far away, scaled so that z is 1; `None` in
    /// a perspective projection.
    pub(crate) fn line_of_sight(&self) -> Option<Vec3> {
        if K::PERSPECTIVE {
            return None;
        }
        let [x, y] = [0, 1].map(|axis| scalar(self.shear(axis).negated()));
        Some(Vec3::new(x, y, Scalar::ONE))
    }

    /// The width and height of a pixel in eye space; in perspective, these are the sizes at a distance of 1.
    pub(crate) fn pixel(&self, viewport: &Viewport) -> [BlockFloat; 2] {
        let [width, height] = [viewport.width, viewport.height];
        [(0, width), (1, height)].map(|(axis, size): (usize, u32)| {
            let size = BlockFloat::new(size.into(), 0);
            BlockFloat::new(2, 0).over(self.rows[axis].coefficient(axis).times(size))
        })
    }

    /// The point of the near plane that is seen at normalized device coordinates `x` and `y`, and the direction of the
    /// line of sight there; both in eye space.
    pub(crate) fn sight(&self, x: BlockFloat, y: BlockFloat) -> [[BlockFloat; 3]; 2] {
        let (w, ahead) = (self.nearest_w(), number(self.near).negated());
        let [x, y] = [(0, x), (1, y)].map(|(axis, at)| self.on_near_plane(axis, at.times(w)));
        let direction = if K::PERSPECTIVE {
            [x, y, ahead]
        } else {
            [self.shear(0), self.shear(1), BlockFloat::new(-1, 0)]
        };
        [[x, y, ahead], direction]
    }

    /// The change of x or y in eye space along a line of sight of a parallel projection, for each unit along −z. On
    /// such a line, x and y of clip space do not change.
    fn shear(&self, axis: usize) -> BlockFloat {
        let row = &self.rows[axis];
        row.coefficient(2).over(row.coefficient(axis))
    }

    /// The homogeneous coordinate w of the points on the near plane.
    fn nearest_w(&self) -> BlockFloat {
        if K::PERSPECTIVE {
            number(self.near)
        } else {
            BlockFloat::new(1, 0)
        }
    }

    /// Returns the x or y at which a·x + c·z + d = `to` on the near plane, where z = −`near`; a, c and d are the
    /// coefficients of the row.
    fn on_near_plane(&self, axis: usize, to: BlockFloat) -> BlockFloat {
        let row = &self.rows[axis];
        let moved = row
            .coefficient(2)
            .times(number(self.near))
            .plus(row.coefficient(3).negated());
        let sum = to.plus(moved);
        // A sum of zero has an exponent that is too large for `over`.
        if sum.value == 0 {
            return BlockFloat::ZERO;
        }
        sum.over(row.coefficient(axis))
    }

    /// Returns the x or y of an edge of the window, where normalized device coordinates are −1 or 1, the `sign`.
    fn edge(&self, axis: usize, sign: i64) -> Scalar {
        let w = self.nearest_w();
        scalar(self.on_near_plane(axis, BlockFloat::new(sign * w.value, w.exp)))
    }

    /// Returns the window's width divided by its height, rounded to the nearest 2⁻¹⁶; saturates.
    #[must_use]
    pub fn aspect(&self) -> Scalar {
        let [x, y] = &self.rows;
        scalar(y.coefficient(1).over(x.coefficient(0)))
    }

    /// Returns the matrix from eye space to homogeneous clip coordinates: entries are rounded to the
    /// nearest 2⁻¹⁶ and saturate.
    ///
    /// Depth is −1 at the near plane and 1 at the far plane.
    #[must_use]
    pub fn to_matrix(&self) -> Matrix4 {
        let [x, y] =
            [0, 1].map(|axis: usize| [0, 1, 2, 3].map(|i| scalar(self.rows[axis].coefficient(i))));
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
            let scale = scalar(BlockFloat::new(-2, 0).over(depth));
            let z = [zero, zero, scale, scalar(middle)];
            Matrix4::new([x, y, z, [zero, zero, zero, one]])
        }
    }
}
