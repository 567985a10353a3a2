//! Cameras: the position of the eye and its direction of view.

use crate::error::Error;
use crate::math::{Transform, Vec3};
use crate::num::block::{self, BlockFloat};
use crate::num::rsqrt as unit;
use crate::num::{Angle, Scalar};

/// A camera: the rigid transform from world space to eye space, or a [mirrored](Camera::mirrored) one.
///
#[cfg_attr(doc, doc = include_str!("../guide/diagrams/look_at.svg"))]
///
/// In eye space, the eye is at the origin and looks down −z; x points to the right, and y points up. In the diagram,
/// these axes are *i*, *j* and *k*. [Mathematics](crate::guide::mathematics::camera#a-camera) derives this transform and
/// its inverse.
///
/// ```
/// use fixel::prelude::*;
/// let camera = Camera::look_at(vec3!(0, 0, 5), Vec3::ZERO, Vec3::Y)?;
/// assert_eq!(camera.view().point(Vec3::ZERO), vec3!(0, 0, -5));
/// // The same camera, placed by a transform.
/// assert_eq!(camera, Camera::at_pose(Transform::translate(vec3!(0, 0, 5))));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Camera {
    view: Transform,
}

/// The tilt that foreshortens all three axes equally: atan(1/√2), 35.26 degrees.
const ISOMETRIC_TILT: Angle = Angle::from_bits(420_720_557);

impl Camera {
    /// Makes a camera at `eye` that shows `target` in the middle of the picture, with `up` pointing upward.
    ///
    /// The axes of eye space are the unit vectors k along eye − target, i along up × k, and j = k × i. `up` may have
    /// any length, and need not be orthogonal to the view direction.
    ///
    /// The components of k have an error of at most 1.5 · 2⁻²⁸. For i and j, add 2⁻²⁸ / sin α to this bound, where α is
    /// the angle between `up` and the view direction.
    ///
    /// # Errors
    ///
    /// [`Error::NoDirection`] if eye and target are equal, or if `up` is zero, or so nearly parallel to the view
    /// direction that rounding errors would decide the roll. An angle between the two below 1.9e-7 radians (0.04
    /// seconds of arc) is always refused; an angle above 8e-6 radians is never refused.
    pub fn look_at(eye: Vec3, target: Vec3, up: Vec3) -> Result<Self, Error> {
        /// Two vectors count as parallel if every component of their cross product is below this limit. The largest
        /// mantissa of each vector is from 2^29 to 2^30. So the product of the lengths is at least 2^58, and the limit
        /// is at most 2^-19 of this product.
        const PARALLEL: i64 = 1 << 39;
        let back = target.way_to(eye);
        let Some(k) = unit::unit(back) else {
            return Err(Error::NoDirection {
                of: "eye",
                given: eye,
                needed: "it must differ from the target, to give the camera a direction to look in",
            });
        };
        let mantissas = |v: [i64; 3]| {
            let mut mantissas = [0; 3];
            block::normalize(&mut mantissas, &v.map(|v| BlockFloat::new(v, 0)));
            mantissas
        };
        let side = unit::cross(mantissas(up.to_bits().map(i64::from)), mantissas(back));
        let is_parallel = side.iter().all(|v| v.abs() < PARALLEL);
        let (false, Some(i)) = (is_parallel, unit::unit(side)) else {
            return Err(Error::NoDirection {
                of: "up",
                given: up,
                needed: "it must not be zero or parallel to the line of sight",
            });
        };
        let j = unit::cross(k, i).map(|v| (v + (1 << 29)) >> 30);
        let rotation = Transform::from_linear(&[i.map(i64::from), j, k.map(i64::from)], 30);
        Ok(Self {
            view: rotation * Transform::translate(-eye),
        })
    }

    /// Makes a camera with the position and the rotation of `pose`, a transform from eye space to world space. A camera
    /// with the pose of a model looks along the model's −z.
    ///
    /// `pose` must be rigid, that is, a product of rotations and translations; any other transform distorts the
    /// picture. For a pose that also scales, write `Camera::from_view(pose.inverse()?)`.
    #[must_use]
    pub fn at_pose(pose: Transform) -> Self {
        Self::from_view(pose.inverse_rigid())
    }

    /// Makes a camera from its transform from world space to eye space.
    #[must_use]
    pub const fn from_view(view: Transform) -> Self {
        Self { view }
    }

    /// Returns the transform from world space to eye space.
    #[must_use]
    pub const fn view(&self) -> Transform {
        self.view
    }

    /// Returns the transform from eye space to world space, which places the camera.
    #[must_use]
    pub fn pose(&self) -> Transform {
        self.view.inverse_rigid()
    }

    /// Returns the camera with which to draw a sky: it looks in the same direction as `self`, but from the origin of
    /// the world. So a mesh around the origin seems infinitely far away, however the camera moves. Draw the mesh first,
    /// with [`NoTest`](crate::canvas::NoTest), so that it is behind everything; it must lie between the near and the
    /// far plane.
    ///
    /// A dome is a sphere seen from inside, drawn with [`Cull::Front`](crate::Cull::Front). Color the dome by height
    /// with [`Gradient`](crate::shade::Gradient), or draw it with [`Textured`](crate::Textured) and a panorama. A sky
    /// box is a cube seen from inside, with a texture for each side. The cookbook shows
    /// [both](crate::guide::cookbook::light).
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let camera = Camera::look_at(vec3!(7, 2, 9), vec3!(7, 2, 0), Vec3::Y)?;
    /// assert_eq!(camera.sky(), Camera::look_at(Vec3::ZERO, vec3!(0, 0, -1), Vec3::Y)?);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn sky(&self) -> Self {
        let mut view = Transform::IDENTITY;
        (view.linear, view.linear_exp) = (self.view.linear, self.view.linear_exp);
        view.is_mirror = self.view.is_mirror;
        Self { view }
    }

    /// Returns the camera that shows what a mirror shows: the mirror image of the world, in the plane through `point` at
    /// right angles to `normal`.
    ///
    /// Draw the scene twice: with the mirrored camera in the mirror's pixels, and with `self` everywhere. The
    /// [cookbook](crate::guide::cookbook::surfaces#a-mirror) shows how. Nothing else changes. Faces keep their
    /// outsides, so leave [culling](crate::Cull) as it is. Keep the lights, too: the world itself does not move, so its
    /// mirror image is lit like the world. Highlights appear where the [mirrored camera](crate::Viewer::of) sees them.
    /// Things behind the mirror would appear in front of it, so leave them out.
    ///
    /// # Errors
    ///
    /// [`Error::NoDirection`] if `normal` is zero.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let camera = Camera::look_at(vec3!(0, 3, 5), Vec3::ZERO, Vec3::Y)?;
    /// let below = camera.mirrored(vec3!(0, 1, 0), Vec3::Y)?; // in water at a height of 1
    /// assert_eq!(below.view().point(vec3!(7, 4, 2)), camera.view().point(vec3!(7, -2, 2)));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn mirrored(&self, point: Vec3, normal: Vec3) -> Result<Self, Error> {
        Ok(Self {
            view: self.view * Transform::mirror(point, normal)?,
        })
    }

    /// Makes a camera that looks at `target` from a `distance`. The camera starts in front of the target, on the side
    /// of +z. It then turns to the right by `turn` and rises by `tilt`.
    ///
    /// With an orthographic projection, the view is trimetric: the three axes are foreshortened differently, except at
    /// angles that make two of them equal.
    ///
    /// Any values are allowed. At a distance of 0, the eye is at the target. At a negative distance, the eye is beyond
    /// the target, so the target is behind the eye. A tilt above 90 degrees shows the world upside down, seen from the
    /// back.
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

    /// Makes a [trimetric](Self::trimetric) camera turned by 45°: x and z are foreshortened equally, and
    /// y by the cosine of `tilt`.
    #[must_use]
    pub fn dimetric(target: Vec3, distance: Scalar, tilt: Angle) -> Self {
        Self::trimetric(target, distance, Angle::from_degrees(45), tilt)
    }

    /// Makes a [dimetric](Self::dimetric) camera raised by atan(1/√2) ≈ 35.26°: all axes are
    /// foreshortened by √(2/3).
    #[must_use]
    pub fn isometric(target: Vec3, distance: Scalar) -> Self {
        Self::dimetric(target, distance, ISOMETRIC_TILT)
    }

    /// Makes a camera in front of `target` that looks along −z: [`trimetric`](Self::trimetric) without turn and tilt.
    #[must_use]
    pub fn front(target: Vec3, distance: Scalar) -> Self {
        Self::trimetric(target, distance, Angle::ZERO, Angle::ZERO)
    }

    /// Makes a camera to the right of `target` that looks along −x: [`trimetric`](Self::trimetric) with a turn of 90°.
    #[must_use]
    pub fn side(target: Vec3, distance: Scalar) -> Self {
        Self::trimetric(target, distance, Angle::QUARTER, Angle::ZERO)
    }

    /// Makes a camera above `target` that looks along −y: [`trimetric`](Self::trimetric) with a tilt of 90°. In the
    /// picture, −z points upward.
    #[must_use]
    pub fn top(target: Vec3, distance: Scalar) -> Self {
        Self::trimetric(target, distance, Angle::ZERO, Angle::QUARTER)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Random, cases};
    use crate::{fx, vec3};
    use rand::Rng;

    fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
        core::array::from_fn(|i| a[i] - b[i])
    }

    fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
    }

    fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    fn length(v: [f64; 3]) -> f64 {
        dot(v, v).sqrt()
    }

    fn real(v: [i32; 3]) -> [f64; 3] {
        v.map(|v| f64::from(v) / 65_536.0)
    }

    fn points(random: &mut Random) -> [i32; 3] {
        let cut = random.random_range(0..32);
        random.random::<[i32; 3]>().map(|v| v >> cut)
    }

    /// Whether an error refuses this vector by this name.
    fn refuses(error: Error, name: &str, vector: Vec3) -> bool {
        matches!(error, Error::NoDirection { of, given, .. } if of == name && given == vector)
    }

    #[test]
    fn look_at_is_good_to_28_bits() {
        cases(256, |random| {
            let eye = points(random);
            let target = points(random);
            let up = points(random);
            let [at, to, above] = [eye, target, up].map(Vec3::from_bits);
            let camera = Camera::look_at(at, to, above);
            let (e, u) = (real(eye), real(up));
            let back = sub(e, real(target));
            let sine = length(cross(u, back)) / (length(u) * length(back));
            match camera {
                Err(Error::NoDirection { of: "eye", .. }) => assert_eq!(eye, target),
                Err(error) => {
                    assert!(refuses(error, "up", above), "{error}");
                    // The cross product is shorter than √3 · 2^39, and the product of the lengths is at least 2^58.
                    // Rounding adds an error.
                    assert!(up == [0; 3] || sine < 8e-6, "{sine}");
                }
                Ok(camera) => {
                    assert!(sine > 1.9e-7, "{sine}");
                    let k = back.map(|v| v / length(back));
                    let side = cross(u, k);
                    let i = side.map(|v| v / length(side));
                    let j = cross(k, i);
                    let view = camera.view();
                    let (unit, scale) = (f64::from(-28).exp2(), f64::from(-view.linear_exp).exp2());
                    for (row, (axis, noise)) in view.linear.iter().zip([
                        // The operands have 30 bits; a small sine magnifies the operands' error.
                        (i, unit / sine),
                        (j, unit / sine),
                        (k, 0.0),
                    ]) {
                        for (m, v) in row.iter().zip(axis) {
                            let error = (f64::from(*m) * scale - v).abs();
                            assert!(error <= 1.5 * unit + noise, "{error:e}");
                        }
                    }
                    let origin = view.point(at);
                    // The translation is accurate to 30 bits of the largest coordinate.
                    let slack = 1.0 + length(e) * 65_536.0 * f64::from(-28).exp2();
                    for v in origin.to_bits() {
                        assert!(f64::from(v).abs() <= slack, "{origin:?}");
                    }
                }
            }
        });
    }

    #[test]
    fn a_pose_comes_back() {
        let turn = Transform::rotate_y(Angle::from_degrees(30));
        let camera = Camera::at_pose(Transform::translate(Vec3::from_ints(1, 2, 3)) * turn);
        let ahead = camera.pose().point(-Vec3::Z);
        // `ahead` is one unit of length in front of the camera: at −sin 30° in x and −cos 30° in z from it. The error
        // is at most 2^-16, the smallest step of a `Scalar`.
        let expected = [1.0 - 0.5, 2.0, 3.0 - 0.75_f64.sqrt()].map(|v| v * 65_536.0);
        for (found, expected) in ahead.to_bits().into_iter().zip(expected) {
            assert!((f64::from(found) - expected).abs() <= 1.0, "{ahead:?}");
        }
    }

    /// A sky has the camera's rotation and its mirror image, but not its place.
    #[test]
    fn a_sky_mirrors_as_its_camera_does() {
        let place = Transform::translate(vec3!(7, -2, 9));
        let turn =
            Transform::rotate_y(Angle::from_degrees(30)) * Transform::rotate_x(Angle::QUARTER);
        for factors in [
            vec3!(1, 1, 1),
            vec3!(-1, 1, 1),
            vec3!(1, -1, 1),
            vec3!(1, 1, -1),
            vec3!(-1, -1, 1),
            vec3!(-1, -1, -1),
        ] {
            let rotation = Transform::scale_axes(factors) * turn;
            let is_mirror = (factors.x * factors.y * factors.z).to_bits() < 0;
            assert_eq!(rotation.is_mirror, is_mirror);
            let sky = Camera::from_view(rotation);
            let camera = Camera::from_view(rotation * place);
            assert_eq!(camera.sky(), sky, "{factors:?}");
            assert_eq!(sky.sky(), sky, "{factors:?}");
            let posed = Camera::at_pose(place * rotation.inverse_rigid());
            assert_eq!(posed.sky(), sky, "{factors:?}");
            assert_eq!(camera.pose().is_mirror, is_mirror, "{factors:?}");
        }
    }

    #[test]
    fn useless_cameras_are_refused() {
        let (eye, target) = (Vec3::from_ints(1, 2, 3), Vec3::from_ints(4, 6, 8));
        let error = Camera::look_at(eye, eye, Vec3::Y).unwrap_err();
        assert_eq!(
            std::format!("{error}"),
            "eye is (1, 2, 3): it must differ from the target, to give the camera a direction to look in"
        );
        for up in [Vec3::ZERO, target - eye, (eye - target) * fx!(0.3)] {
            let error = Camera::look_at(eye, target, up).unwrap_err();
            assert!(refuses(error, "up", up), "{error}");
        }
        // The angles between the vectors are 6e-8 and 1.5e-5 radians.
        let ahead = Vec3::from_bits([0, 0, -(1 << 30)]);
        for (aside, is_refused) in [(1 << 6, true), (1 << 14, false)] {
            let up = Vec3::from_bits([aside, 0, -(1 << 30)]);
            assert_eq!(Camera::look_at(Vec3::ZERO, ahead, up).is_err(), is_refused);
        }
        // The angles are 1.8e-7 and 2.2e-7 radians. Here, both vectors are √3 times as long as their largest component.
        let most = (1 << 30) - 1000;
        let diagonal = Vec3::from_bits([most; 3]);
        for (aside, is_refused) in [(418, true), (515, false)] {
            let up = Vec3::from_bits([most, most, most + aside]);
            let refused = Camera::look_at(diagonal, Vec3::ZERO, up).is_err();
            assert_eq!(refused, is_refused, "{aside}");
        }
        let aside = target - eye + Vec3::from_bits([6, 0, 0]);
        assert!(Camera::look_at(eye, target, aside).is_ok());
    }
}
