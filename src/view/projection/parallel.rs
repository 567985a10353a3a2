//! Parallel projections: what is far keeps its size.

use core::marker::PhantomData;

use super::{Parallel, Projection, Row, bits, check_far, extent, number};
use crate::num::Unit;
use crate::num::block::BlockFloat;
use crate::{Angle, Error, Scalar};

impl Projection<Parallel> {
    /// A parallel projection of a box, along −z.
    ///
    /// `near` may be 0 or below: there is no eye to be in the way.
    ///
    /// # Errors
    ///
    /// [`Error::Far`] unless `near` < `far`; [`Error::EmptyFrustum`] unless `left` < `right` and
    /// `bottom` < `top`.
    pub fn orthographic(
        left: Scalar,
        right: Scalar,
        bottom: Scalar,
        top: Scalar,
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        Self::sheared([BlockFloat::ZERO; 2], [left, right, bottom, top], near, far)
    }

    /// An oblique projection: the near plane appears as it is, and what lies behind it moves by
    /// `ratio` times its distance from it in the direction of `angle`, counter-clockwise from the
    /// right.
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
        let shear = |part: Unit| BlockFloat::new(bits(ratio) * i64::from(part.to_bits()), 46);
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
        shear: [BlockFloat; 2],
        [left, right, bottom, top]: [Scalar; 4],
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        check_far(near, far)?;
        let row = |low, high, shear: BlockFloat| -> Result<_, Error> {
            let (size, middle) = extent(low, high)?;
            let size = BlockFloat::new(size, 16);
            let scale = BlockFloat::new(2, 0).over(size);
            let slope = scale.times(shear).negated();
            let offset = BlockFloat::new(-middle, 16)
                .over(size)
                .plus(slope.times(number(near)));
            Ok((scale, slope, offset))
        };
        let (x, x_slope, x_offset) = row(left, right, shear[0])?;
        let (y, y_slope, y_offset) = row(bottom, top, shear[1])?;
        Ok(Self {
            rows: [
                Row::new([x, BlockFloat::ZERO, x_slope, x_offset]),
                Row::new([BlockFloat::ZERO, y, y_slope, y_offset]),
            ],
            near,
            far,
            kind: PhantomData,
        })
    }
}
