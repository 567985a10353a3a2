//! Cameras: where the eye is, and which way it looks.

use crate::linear::{block, unit};
use crate::{Angle, Error, Scalar, Transform, Vec3};

/// An eye in the world: the rigid transform from world space to eye space.
///
/// In eye space the eye is at the origin and looks down −z, x is to the right and y up.
///
/// ```
/// use fixel::prelude::*;
/// let camera = Camera::look_at(vec3!(0, 0, 5), Vec3::ZERO, Vec3::Y)?;
/// assert_eq!(camera.view().point(Vec3::ZERO), vec3!(0, 0, -5));
/// // The same camera, put where it is by a move.
/// assert_eq!(camera, Camera::at_pose(Transform::translate(vec3!(0, 0, 5))));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Camera {
    view: Transform,
}

/// The tilt at which the three axes are foreshortened alike: atan(1/√2), 35.26 degrees.
const ISOMETRIC_TILT: Angle = Angle::from_bits(420_720_557);

impl Camera {
    /// A camera at `eye` that has `target` in the middle of its picture, and `up` upwards.
    ///
    /// With k = (eye − target)/‖·‖, i = up × k/‖·‖ and j = k × i, these are the axes of eye space. `up` need not be
    /// orthogonal to the line of sight, nor of length one.
    ///
    /// # Errors
    ///
    /// [`Error::EyeAtTarget`] if the two are the same; [`Error::UpAlongView`] if `up` is zero, or parallel to the line of sight
    /// to 1e-6 radians (0.2 seconds of arc), where the roll would be noise.
    pub fn look_at(eye: Vec3, target: Vec3, up: Vec3) -> Result<Self, Error> {
        /// Mantissas' largest component is from 2^29 to 2^30, so that this is 2^-20 or less of a product of lengths.
        const PARALLEL: i64 = 1 << 39;
        let (eye_bits, target_bits) = (eye.to_bits(), target.to_bits());
        let back = [0, 1, 2].map(|i| i64::from(eye_bits[i]) - i64::from(target_bits[i]));
        let k = unit::unit(back).ok_or(Error::EyeAtTarget)?;
        let (up, _) = block::normalise(up.to_bits().map(i64::from), 0);
        let (back, _) = block::normalise(back, 0);
        let side = unit::cross(up, back);
        if side.iter().all(|v| v.abs() < PARALLEL) {
            return Err(Error::UpAlongView);
        }
        let i = unit::unit(side).ok_or(Error::UpAlongView)?;
        let j = unit::cross(k, i).map(|v| (v + (1 << 29)) >> 30);
        Ok(Self {
            view: Transform::of_pose([i.map(i64::from), j, k.map(i64::from)], eye),
        })
    }

    /// A camera placed in the world as a model is, by composed moves: the inverse of `pose`, which must be rigid.
    #[must_use]
    pub fn at_pose(pose: Transform) -> Self {
        Self {
            view: pose.inverse_rigid(),
        }
    }

    /// A camera of its transform from world to eye space.
    #[must_use]
    pub const fn from_view(view: Transform) -> Self {
        Self { view }
    }

    /// The transform from world to eye space.
    #[must_use]
    pub const fn view(&self) -> Transform {
        self.view
    }

    /// The transform from eye to world space, which places the camera.
    #[must_use]
    pub fn pose(&self) -> Transform {
        self.view.inverse_rigid()
    }

    /// A camera about `target` at a `distance`: from the front, turned by `turn` to the right and raised by `tilt`.
    ///
    /// With an orthographic projection and angles that are all different, this is a trimetric view.
    #[must_use]
    pub fn trimetric(target: Vec3, distance: Scalar, turn: Angle, tilt: Angle) -> Self {
        let back = Vec3::new(Scalar::ZERO, Scalar::ZERO, -distance);
        Self {
            view: Transform::translate(back)
                * Transform::rotate_x(tilt)
                * Transform::rotate_y(-turn)
                * Transform::translate(-target),
        }
    }

    /// [`trimetric`](Self::trimetric), turned by 45°: x and z are foreshortened alike, and y by the cosine of `tilt`.
    #[must_use]
    pub fn dimetric(target: Vec3, distance: Scalar, tilt: Angle) -> Self {
        Self::trimetric(target, distance, Angle::from_degrees(45), tilt)
    }

    /// [`dimetric`](Self::dimetric), raised by atan(1/√2) ≈ 35.26°: all axes are foreshortened by √(2/3).
    #[must_use]
    pub fn isometric(target: Vec3, distance: Scalar) -> Self {
        Self::dimetric(target, distance, ISOMETRIC_TILT)
    }

    /// From the front: down −z.
    #[must_use]
    pub fn front(target: Vec3, distance: Scalar) -> Self {
        Self::trimetric(target, distance, Angle::ZERO, Angle::ZERO)
    }

    /// From the right side: down −x.
    #[must_use]
    pub fn side(target: Vec3, distance: Scalar) -> Self {
        Self::trimetric(target, distance, Angle::QUARTER, Angle::ZERO)
    }

    /// From the top: down −y, with −z upwards in the picture.
    #[must_use]
    pub fn top(target: Vec3, distance: Scalar) -> Self {
        Self::trimetric(target, distance, Angle::ZERO, Angle::QUARTER)
    }
}
