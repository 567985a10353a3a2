//! Projections: from eye space to the picture.

use core::marker::PhantomData;

use super::Aspect;
use crate::interpolate::{Interpolate, Linear};
use crate::linear::block;
use crate::number::Unit;
use crate::{Angle, Error, Matrix4, Scalar, Vec3};

mod sealed {
    pub trait Sealed {}
}

/// The two kinds of projection: [`Perspective`] and [`Parallel`].
pub trait Kind: sealed::Sealed + Copy + core::fmt::Debug {
    /// Whether the picture shrinks with distance.
    const PERSPECTIVE: bool;

    /// The way attributes are interpolated when a draw call asks for `I`.
    type Mode<I: Interpolate>: Interpolate;
}

/// Lines of sight meet in the eye: what is far is small.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Perspective;

/// Lines of sight are parallel: what is far keeps its size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parallel;

impl sealed::Sealed for Perspective {}
impl sealed::Sealed for Parallel {}

impl Kind for Perspective {
    const PERSPECTIVE: bool = true;
    type Mode<I: Interpolate> = I;
}

impl Kind for Parallel {
    const PERSPECTIVE: bool = false;
    type Mode<I: Interpolate> = Linear;
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
    /// A row of numbers with an exponent each.
    fn new(entries: [(i64, i32); 4]) -> Self {
        let (values, exp) = block::join(entries);
        let (m, exp) = block::normalise(values, exp);
        Self { m, exp }
    }

    /// A coefficient as a number with exponent.
    fn real(&self, i: usize) -> (i64, i32) {
        (self.m[i].into(), self.exp)
    }
}

/// What of eye space comes into the picture, and where.
///
/// Eye space is right-handed: x to the right, y up, and the view down −z. `near` and `far` are distances ahead of the
/// eye. A projection takes its frustum or box to normalised device coordinates, ±1 from edge to edge.
///
/// Coefficients have 30 bits, whatever their size.
///
/// ```
/// use fixel::prelude::*;
/// let lens = Projection::perspective(Angle::from_degrees(60), (320, 240), fx!(0.1), fx!(100))?;
/// let plan = Projection::orthographic(fx!(-4), fx!(4), fx!(-3), fx!(3), fx!(0), fx!(10))?;
/// assert!(Projection::perspective(Angle::from_degrees(60), (320, 240), fx!(0), fx!(100)).is_err());
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Projection<K> {
    /// Normalised device coordinates x and y, times w: −z for a perspective, else 1.
    pub(crate) rows: [Row; 2],
    pub(crate) near: Scalar,
    pub(crate) far: Scalar,
    kind: PhantomData<K>,
}

const ZERO: (i64, i32) = (0, 0);
const TWO: i64 = 2 << 16;

fn bits(value: Scalar) -> i64 {
    value.to_bits().into()
}

/// The product of two numbers with exponent, of 30 bits each.
fn product((a, a_exp): (i64, i32), (b, b_exp): (i64, i32)) -> (i64, i32) {
    let ([a], a_exp) = block::normalise([a], a_exp);
    let ([b], b_exp) = block::normalise([b], b_exp);
    (i64::from(a) * i64::from(b), a_exp + b_exp)
}

/// The quotient of two numbers with exponent.
fn quotient((a, a_exp): (i64, i32), (b, b_exp): (i64, i32)) -> (i64, i32) {
    let (q, exp) = block::ratio(a, b);
    (q, exp + a_exp - b_exp)
}

fn negated((value, exp): (i64, i32)) -> (i64, i32) {
    (-value, exp)
}

fn sum((a, a_exp): (i64, i32), (b, b_exp): (i64, i32)) -> (i64, i32) {
    let ([sum], exp) = block::add(([a], a_exp), ([b], b_exp));
    (sum, exp)
}

/// A number with exponent to the nearest [`Scalar`]; saturates.
fn scalar((value, exp): (i64, i32)) -> Scalar {
    Scalar::from_bits(block::fixed(value, exp, 16))
}

fn check_far(near: Scalar, far: Scalar) -> Result<(), Error> {
    if far > near {
        Ok(())
    } else {
        Err(Error::Far { near, far })
    }
}

fn check_planes(near: Scalar, far: Scalar) -> Result<(), Error> {
    if near > Scalar::ZERO {
        check_far(near, far)
    } else {
        Err(Error::Near { near })
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

impl Projection<Perspective> {
    fn of_scales(x: (i64, i32), y: (i64, i32), near: Scalar, far: Scalar) -> Self {
        Self {
            rows: [
                Row::new([x, ZERO, ZERO, ZERO]),
                Row::new([ZERO, y, ZERO, ZERO]),
            ],
            near,
            far,
            kind: PhantomData,
        }
    }

    /// A symmetric perspective: `fov` is the vertical field of view, `aspect` width to height.
    ///
    /// top = near · tan(fov / 2), right = top · aspect.
    ///
    /// # Errors
    ///
    /// [`Error::FieldOfView`] unless 0 < `fov` < 180°; [`Error::Aspect`] unless width and height are above 0;
    /// [`Error::Near`] unless 0 < `near`; [`Error::Far`] unless `near` < `far`.
    pub fn perspective(
        fov: Angle,
        aspect: impl Into<Aspect>,
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        if fov == Angle::ZERO || fov.to_bits() >= Angle::HALF.to_bits() {
            return Err(Error::FieldOfView { angle: fov });
        }
        let (width, height) = aspect.into().checked()?;
        check_planes(near, far)?;
        let half = fov.half_wide();
        let cotangent = quotient((half.1, 0), (half.0, 0));
        let narrowed = product(cotangent, (height, 0));
        Ok(Self::of_scales(
            quotient(narrowed, (width, 0)),
            cotangent,
            near,
            far,
        ))
    }

    /// A symmetric perspective by its focal length: a thing as wide as it is far is so many `pixels` wide
    /// in a picture of `size` pixels.
    ///
    /// # Errors
    ///
    /// [`Error::FocalLength`] unless 0 < `pixels`; [`Error::Aspect`] unless width and height are above 0;
    /// [`Error::Near`] unless 0 < `near`; [`Error::Far`] unless `near` < `far`.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let lens = Projection::from_focal_length(fx!(200), (320, 240), fx!(0.25), fx!(100))?;
    /// assert_eq!(lens.matrix().rows()[0][0], fx!(1.25));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn from_focal_length(
        pixels: Scalar,
        size: (u32, u32),
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        if pixels <= Scalar::ZERO {
            return Err(Error::FocalLength { pixels });
        }
        let (width, height) = Aspect::from(size).checked()?;
        check_planes(near, far)?;
        let scale = |size| quotient((2 * bits(pixels), 0), (size, 0));
        Ok(Self::of_scales(scale(width), scale(height), near, far))
    }

    /// A perspective whose window on the near plane has the given edges; it may lie off the centre.
    ///
    /// # Errors
    ///
    /// [`Error::Near`] unless 0 < `near`; [`Error::Far`] unless `near` < `far`; [`Error::EmptyFrustum`] unless
    /// `left` < `right` and `bottom` < `top`.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let lens = Projection::frustum(fx!(-1), fx!(2), fx!(-1), fx!(1), fx!(2), fx!(10))?;
    /// assert_eq!((lens.left(), lens.right()), (fx!(-1), fx!(2)));
    /// assert_eq!(lens.aspect(), fx!(1.5));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn frustum(
        left: Scalar,
        right: Scalar,
        bottom: Scalar,
        top: Scalar,
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        check_planes(near, far)?;
        let (width, across) = extent(left, right)?;
        let (height, up) = extent(bottom, top)?;
        let ratio = |value, size| quotient((value, 0), (size, 0));
        let double = 2 * bits(near);
        Ok(Self {
            rows: [
                Row::new([ratio(double, width), ZERO, ratio(across, width), ZERO]),
                Row::new([ZERO, ratio(double, height), ratio(up, height), ZERO]),
            ],
            near,
            far,
            kind: PhantomData,
        })
    }

    /// The vertical field of view, 2·atan((top − bottom) / (2·near)); for a window off the centre, that of
    /// one of the same height about the centre.
    #[must_use]
    pub fn fov(&self) -> Angle {
        let (scale, exp) = self.rows[1].real(1);
        // The tangent of half of it is 1 / scale.
        Angle::of_point(
            block::shift(1, exp.max(0)),
            block::shift(scale, (-exp).max(0)),
        ) * 2
    }

    /// Where on the near plane all lines of a direction vanish: (−n·x/z, −n·y/z), rounded to nearest.
    ///
    /// `None` for a direction parallel to the picture, whose lines stay parallel there, and if the point
    /// is beyond ±32768.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let lens = Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(2), fx!(9))?;
    /// assert_eq!(lens.vanishing_point(vec3!(1, 0, -4)), Some([fx!(0.5), fx!(0)]));
    /// assert_eq!(lens.vanishing_point(vec3!(1, 1, 0)), None);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn vanishing_point(&self, direction: Vec3) -> Option<[Scalar; 2]> {
        let at = |v| on_plane(self.near, v, direction.z);
        Some([at(direction.x)?, at(direction.y)?])
    }

    /// Where on the near plane a point of eye space appears: (−n·x/z, −n·y/z), rounded to nearest.
    ///
    /// `None` for a point that is not ahead of the eye, where the formula divides by zero or mirrors,
    /// and if the image is beyond ±32768.
    #[must_use]
    pub fn image(&self, point: Vec3) -> Option<[Scalar; 2]> {
        if point.z < Scalar::ZERO {
            self.vanishing_point(point)
        } else {
            None
        }
    }
}

/// −near · value / z, rounded to nearest, half away from zero.
fn on_plane(near: Scalar, value: Scalar, z: Scalar) -> Option<Scalar> {
    let (top, bottom) = (bits(near) * bits(value), -bits(z));
    if bottom == 0 {
        return None;
    }
    // Below 2^62 and 2^32.
    let half = bottom.abs() / 2 * top.signum();
    i32::try_from((top + half) / bottom)
        .ok()
        .map(Scalar::from_bits)
}

impl Projection<Parallel> {
    /// A parallel projection of a box, along −z.
    ///
    /// `near` may be 0 or below: there is no eye to be in the way.
    ///
    /// # Errors
    ///
    /// [`Error::Far`] unless `near` < `far`; [`Error::EmptyFrustum`] unless `left` < `right` and `bottom` < `top`.
    pub fn orthographic(
        left: Scalar,
        right: Scalar,
        bottom: Scalar,
        top: Scalar,
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        Self::sheared([ZERO; 2], [left, right, bottom, top], near, far)
    }

    /// An oblique projection: the near plane appears as it is, and what lies behind it moves by `ratio` times its distance from
    /// it in the direction of `angle`, counter-clockwise from the right.
    ///
    /// # Errors
    ///
    /// As for [`orthographic`](Self::orthographic).
    #[allow(clippy::too_many_arguments)] // the box, and two
    pub fn oblique(
        angle: Angle,
        ratio: Scalar,
        left: Scalar,
        right: Scalar,
        bottom: Scalar,
        top: Scalar,
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        let (sin, cos) = angle.sin_cos();
        let shear = |part: Unit| (bits(ratio) * i64::from(part.to_bits()), 46);
        Self::sheared(
            [shear(cos), shear(sin)],
            [left, right, bottom, top],
            near,
            far,
        )
    }

    /// An [oblique](Self::oblique) projection in which depth keeps its full length.
    ///
    /// # Errors
    ///
    /// As for [`orthographic`](Self::orthographic).
    pub fn cavalier(
        angle: Angle,
        left: Scalar,
        right: Scalar,
        bottom: Scalar,
        top: Scalar,
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        Self::oblique(angle, Scalar::ONE, left, right, bottom, top, near, far)
    }

    /// An [oblique](Self::oblique) projection in which depth has half its length.
    ///
    /// # Errors
    ///
    /// As for [`orthographic`](Self::orthographic).
    pub fn cabinet(
        angle: Angle,
        left: Scalar,
        right: Scalar,
        bottom: Scalar,
        top: Scalar,
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        let half = Scalar::from_bits(1 << 15);
        Self::oblique(angle, half, left, right, bottom, top, near, far)
    }

    /// A box's projection in which a point at a distance d appears moved by `shear` · (d − near).
    fn sheared(
        shear: [(i64, i32); 2],
        [left, right, bottom, top]: [Scalar; 4],
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        check_far(near, far)?;
        let row = |low, high, shear| {
            let (size, middle) = extent(low, high)?;
            let scale = quotient((TWO, 0), (size, 0));
            let slope = negated(product(scale, shear));
            let offset = sum(
                quotient((-middle, 0), (size, 0)),
                product(slope, (bits(near), 16)),
            );
            Ok((scale, slope, offset))
        };
        let (x, x_slope, x_offset) = row(left, right, shear[0])?;
        let (y, y_slope, y_offset) = row(bottom, top, shear[1])?;
        Ok(Self {
            rows: [
                Row::new([x, ZERO, x_slope, x_offset]),
                Row::new([ZERO, y, y_slope, y_offset]),
            ],
            near,
            far,
            kind: PhantomData,
        })
    }
}

impl<K: Kind> Projection<K> {
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

    /// The left edge of the window on the near plane; to 2⁻³⁰ of the largest of the four, saturated.
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
        let near = (bits(self.near), 16);
        let w = if K::PERSPECTIVE { near } else { (1, 0) };
        let moved = sum(product(row.real(2), near), negated(row.real(3)));
        scalar(quotient(sum((sign * w.0, w.1), moved), row.real(axis)))
    }

    /// Width to height of the window, (right − left) / (top − bottom); saturated.
    #[must_use]
    pub fn aspect(&self) -> Scalar {
        scalar(quotient(self.rows[1].real(1), self.rows[0].real(0)))
    }

    /// The projection as a matrix to homogeneous clip coordinates: entries are rounded to 2⁻¹⁶ and saturate.
    ///
    /// Depth goes from −1 at the near plane to 1 at the far plane.
    #[must_use]
    pub fn matrix(&self) -> Matrix4 {
        let [x, y] =
            [0, 1].map(|axis: usize| [0, 1, 2, 3].map(|i| scalar(self.rows[axis].real(i))));
        let (near, far) = (bits(self.near), bits(self.far));
        let depth = (far - near, 16);
        let middle = quotient((-(far + near), 16), depth);
        let (zero, one) = (Scalar::ZERO, Scalar::ONE);
        if K::PERSPECTIVE {
            let offset = quotient(product((-2 * near, 16), (far, 16)), depth);
            let z = [zero, zero, scalar(middle), scalar(offset)];
            Matrix4::new([x, y, z, [zero, zero, -one, zero]])
        } else {
            let z = [zero, zero, scalar(quotient((-2, 0), depth)), scalar(middle)];
            Matrix4::new([x, y, z, [zero, zero, zero, one]])
        }
    }
}
