//! Perspective projections: distant objects look smaller.

use core::ops::Bound::Excluded;

use super::{Perspective, Projection, ProjectionRow, bits};
use crate::error::{Error, check_above, check_angle};
use crate::math::Vec3;
use crate::num::block::{self, BlockFloat};
use crate::num::{Angle, Scalar};
use crate::view::{Aspect, Window};

fn check_planes(near: Scalar, far: Scalar) -> Result<(), Error> {
    check_above("distance of the near plane", near, Scalar::ZERO)?;
    check_above("distance of the far plane", far, near)?;
    Ok(())
}

impl Projection<Perspective> {
    fn from_scales(x: BlockFloat, y: BlockFloat, near: Scalar, far: Scalar) -> Self {
        // The rows are written out, because `ProjectionRow::new` would make a program with a perspective projection 100
        // bytes larger.
        let row = |m, exp| ProjectionRow {
            m,
            exp,
            offset_exp: 0,
        };
        let ((x, x_exp), (y, y_exp)) = (x.rounded(), y.rounded());
        let rows = [row([x, 0, 0, 0], x_exp), row([0, y, 0, 0], y_exp)];
        Self::of_rows(rows, near, far)
    }

    /// Makes a symmetric perspective from the vertical field of view and the aspect ratio of the picture.
    ///
    /// The aspect ratio is given as a size in pixels, such as `(320, 240)` or a
    /// [`Size`](embedded_graphics::geometry::Size), or as a number, such as `fx!(1.5)`.
    ///
    /// The projection's [`Window`] lies on the near plane, with top = near · tan(fov / 2) and right = top · aspect. It
    /// is centered on the line of sight.
    ///
    /// For a canvas with a depth buffer, let `far` be at most 500 · `near`: see [the rule for
    /// depths](crate::guide::concepts#depth).
    ///
    /// # Errors
    ///
    /// [`Error::Angle`] unless 0 < `fov` < 180°; [`Error::OutOfRange`] unless width and height are above 0 and
    /// 0 < `near` < `far`.
    pub fn perspective(
        fov: Angle,
        aspect: impl Into<Aspect>,
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        let range = (Excluded(Angle::ZERO), Excluded(Angle::HALF));
        check_angle("field of view", fov, range)?;
        let (width, height) = aspect.into().checked()?;
        check_planes(near, far)?;
        let (sine, cosine) = fov.half_wide();
        let y = BlockFloat::new(cosine, 0).over(BlockFloat::new(sine, 0));
        let x = y
            .times(BlockFloat::new(height, 0))
            .over(BlockFloat::new(width, 0));
        Ok(Self::from_scales(x, y, near, far))
    }

    /// Makes a symmetric perspective from its focal length in pixels: an object whose width equals its distance from
    /// the eye is `pixels` wide in a picture of `size` pixels.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] unless `pixels`, width and height are above 0 and 0 < `near` < `far`.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let projection = Projection::from_focal_length(fx!(200), (320, 240), fx!(0.25), fx!(100))?;
    /// assert_eq!(projection.to_matrix().rows()[0][0], fx!(1.25));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn from_focal_length(
        pixels: Scalar,
        size: (u32, u32),
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        check_above("focal length", pixels, Scalar::ZERO)?;
        let (width, height) = Aspect::from(size).checked()?;
        check_planes(near, far)?;
        let scale = |size| BlockFloat::new(2 * bits(pixels), 0).over(BlockFloat::new(size, 0));
        Ok(Self::from_scales(scale(width), scale(height), near, far))
    }

    /// Makes a perspective from its window on the near plane; the window need not be centered.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] unless 0 < `near` < `far` and the window's left < right and bottom < top.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// let window = Window { left: fx!(-1), right: fx!(2), bottom: fx!(-1), top: fx!(1) };
    /// let projection = Projection::frustum(window, fx!(2), fx!(10))?;
    /// assert_eq!(projection.window(), window);
    /// assert_eq!(projection.aspect(), fx!(1.5));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn frustum(window: Window, near: Scalar, far: Scalar) -> Result<Self, Error> {
        check_planes(near, far)?;
        let (width, height) = window.checked()?;
        let axis = |low, high, size| {
            let size = BlockFloat::new(size, 0);
            let [double, middle] = [2 * bits(near), bits(low) + bits(high)]
                .map(|number| BlockFloat::new(number, 0).over(size));
            [double, middle, BlockFloat::ZERO]
        };
        let x = axis(window.left, window.right, width);
        let y = axis(window.bottom, window.top, height);
        Ok(Self::of_axes([x, y], near, far))
    }

    /// Returns the vertical field of view, 2·atan((top − bottom) / (2·near)).
    ///
    /// If the window is not centered, the result is the field of view of a centered window of the same height.
    #[must_use]
    pub fn fov(&self) -> Angle {
        let BlockFloat { value, exp } = self.rows[1].coefficient(1);
        // The tangent of half the angle is 1 / scale.
        Angle::atan2_bits(
            block::shift(1, exp.max(0)),
            block::shift(value, (-exp).max(0)),
        ) * 2
    }

    /// Returns the vanishing point of all lines with the direction (x, y, z). It lies on the near plane, at (−n·x/z,
    /// −n·y/z), where n is the distance of the near plane. Components are rounded to nearest (half away from zero).
    ///
    /// `None` if the direction is parallel to the picture, because such lines stay parallel in the picture, or if the
    /// point is beyond ±32768.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let projection = Projection::perspective(deg!(90), (1, 1), fx!(2), fx!(9))?;
    /// assert_eq!(projection.vanishing_point(vec3!(1, 0, -4)), Some([fx!(0.5), fx!(0)]));
    /// assert_eq!(projection.vanishing_point(vec3!(1, 1, 0)), None);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn vanishing_point(&self, direction: Vec3) -> Option<[Scalar; 2]> {
        let at = |v| block::divide(bits(self.near) * bits(v), -bits(direction.z));
        Some([at(direction.x)?, at(direction.y)?].map(Scalar::from_bits))
    }

    /// Projects the point (x, y, z) of eye space onto the near plane: the result is (−n·x/z, −n·y/z), where n is the
    /// distance of the near plane. Components are rounded to nearest (half away from zero).
    ///
    /// `None` if the point is not ahead of the eye, or if the image is beyond ±32768.
    #[must_use]
    pub fn image(&self, point: Vec3) -> Option<[Scalar; 2]> {
        if point.z < Scalar::ZERO {
            self.vanishing_point(point)
        } else {
            None
        }
    }
}
