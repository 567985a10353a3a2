//! Parallel projections: distant objects keep their size.

use super::{Parallel, Projection, bits, number};
use crate::error::{Error, check_above};
use crate::num::block::BlockFloat;
use crate::num::{Angle, Fraction, Scalar};
use crate::view::Window;

impl Projection<Parallel> {
    /// Makes a parallel projection of a box, along −z.
    ///
    /// `near` may be 0 or negative, so the box may extend behind the eye.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] unless `near` < `far` and the window's left < right and bottom < top.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// let plan = Projection::orthographic(Window::centered(fx!(8), fx!(6)), fx!(-5), fx!(5))?;
    /// assert_eq!(plan.to_matrix().project(vec3!(4, 0, 0)), Some(vec3!(1, 0, 0)));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn orthographic(window: Window, near: Scalar, far: Scalar) -> Result<Self, Error> {
        Self::sheared([BlockFloat::ZERO; 2], near, window, near, far)
    }

    /// Makes an oblique projection. In the plane at the distance `plane`, nothing is shifted: the picture shows the
    /// part inside the window. A point behind this plane is shifted in the picture by `ratio` times its distance from
    /// the plane; a point in front of the plane is shifted the other way.
    ///
    /// The direction of the shift is `angle`, counter-clockwise from the right. `plane` may equal `near`. With a ratio
    /// of 1, edges that point straight back keep their length (a *cavalier* projection); with ½, they are half as long
    /// (a *cabinet* projection).
    ///
    /// # Errors
    ///
    /// The errors of [`orthographic`](Self::orthographic).
    ///
    /// ```
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// let window = Window::centered(fx!(4), fx!(4));
    /// let oblique = Projection::oblique(deg!(0), fx!(0.5), fx!(5), window, fx!(1), fx!(10))?;
    /// let across = |point| oblique.to_matrix().project(point).map(|at| at.x);
    /// assert_eq!(across(vec3!(2, 0, -5)), Some(fx!(1))); // the window's edge, in the plane
    /// assert_eq!(across(vec3!(0, 0, -7)), Some(fx!(0.5))); // two behind it: one to the right
    /// # Ok::<(), Error>(())
    /// ```
    pub fn oblique(
        angle: Angle,
        ratio: Scalar,
        plane: Scalar,
        window: Window,
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        let (sin, cos) = angle.sin_cos();
        let shear = |part: Fraction| BlockFloat::new(bits(ratio) * i64::from(part.to_bits()), 46);
        Self::sheared([shear(cos), shear(sin)], plane, window, near, far)
    }

    /// Makes the projection of a box in which a point at distance d moves by `shear` · (d − `plane`).
    fn sheared(
        shear: [BlockFloat; 2],
        plane: Scalar,
        window: Window,
        near: Scalar,
        far: Scalar,
    ) -> Result<Self, Error> {
        check_above("distance of the far plane", far, near)?;
        let (width, height) = window.checked()?;
        let row = |low, high, size, shear: BlockFloat| {
            let size = BlockFloat::new(size, 16);
            let scale = BlockFloat::new(2, 0).over(size);
            let slope = scale.times(shear).negated();
            let offset = BlockFloat::new(-(bits(low) + bits(high)), 16)
                .over(size)
                .plus(slope.times(number(plane)));
            [scale, slope, offset]
        };
        let x = row(window.left, window.right, width, shear[0]);
        let y = row(window.bottom, window.top, height, shear[1]);
        Ok(Self::of_axes([x, y], near, far))
    }
}
