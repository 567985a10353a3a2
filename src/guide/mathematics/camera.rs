//! The camera: from world space to the space before the eye.
//!
//! The [first page](crate::guide::mathematics) names the axes and the letters *n* and *f*.
//!
//! # A camera
//!
//! **A camera is the rigid transform that brings the eye to the origin and the target onto −z.** Its axes in the world
//! are
//!
#![doc = formula!(
    {k = frac(eye - target)(|eye - target|)}
    {i = frac(up times k)(|up times k|)}
    {j = k times i}
)]
//!
#![doc = include_str!("../diagrams/look_at.svg")]
//!
//! The vector *k* points backward, because the eye looks along −z. The vector *i* is orthogonal to *up* and *k*, and
//! *j* lies in the plane of *up* and *k*, on the side of *up*. The part of *up* along *k* drops out of the cross
//! product, so *up* need not be orthogonal to *k*. The three vectors are orthonormal. A matrix *R* with the rows *i*,
//! *j* and *k* maps these axes to x, y and z, and the view is *R* · translate(−eye). If the eye is at the target, or
//! *up* is parallel to *k*, there is no such view, and [`Camera::look_at`](crate::Camera::look_at) returns an error.
//!
//! ```
//! use fixel::prelude::*;
//!
//! let eye = vec3!(3, 0, 4);
//! let camera = Camera::look_at(eye, Vec3::ZERO, Vec3::Y)?;
//! assert_eq!(camera.view().point(eye), Vec3::ZERO);
//! assert_eq!(camera.view().point(Vec3::ZERO), vec3!(0, 0, -5));
//! // The x components of i = (0.8, 0, −0.6), j = (0, 1, 0) and k = (0.6, 0, 0.8).
//! assert_eq!(camera.view().direction(Vec3::X), vec3!(0.8, 0, 0.6));
//! let leaning = Camera::look_at(eye, Vec3::ZERO, vec3!(3, 1, 4))?; // up = y + 5k
//! assert_eq!(leaning.view().direction(Vec3::X), vec3!(0.8, 0, 0.6));
//! assert!(Camera::look_at(eye, eye, Vec3::Y).is_err());
//! assert!(Camera::look_at(eye, Vec3::ZERO, eye).is_err());
//! # Ok::<(), Error>(())
//! ```
//!
//! **The inverse of a rigid transform is a transpose and an opposite move.** The rows of a rotation *R* are
//! orthonormal, so *RR*<sup>T</sup> is the identity. Undo the moves in reverse order:
//!
#![doc = formula!({(fun translate (p) dot R)^{-1}} {= R^T dot fun translate (-p)})]
//!
//! **A camera can be placed like a model**, by a product of moves. This product is its pose. The view is the inverse of
//! the pose: the product of the inverse moves, in reverse order. [`Camera::at_pose`](crate::Camera::at_pose) inverts a
//! pose.
//!
//! ```
//! use fixel::prelude::*;
//!
//! // The camera above by two moves, and their inverses in reverse order.
//! let eye = vec3!(3, 0, 4);
//! let turn = Angle::atan2(fx!(3), fx!(4));
//! let pose = Transform::translate(eye) * Transform::rotate_y(turn);
//! let undone = Transform::rotate_y(-turn) * Transform::translate(-eye);
//! for view in [Camera::at_pose(pose).view(), pose.inverse_rigid(), undone] {
//!     assert_eq!(view.point(Vec3::ZERO), vec3!(0, 0, -5));
//! }
//! assert_eq!((pose * pose.inverse_rigid()).point(vec3!(7, 8, 9)), vec3!(7, 8, 9));
//! assert_eq!(Camera::from_view(pose).view().point(Vec3::ZERO), eye); // not inverted
//! ```
//!
//! <div class="warning">
//!
//! **A camera that is not inverted.** A pose places the eye in the world; a view moves the world in front of the eye.
//! The last line of the program above uses the pose as the view ([`Camera::from_view`](crate::Camera::from_view)). This
//! puts the target at (3, 0, 4), behind the eye. You notice this mistake when the scene moves with the camera instead
//! of against it.
//!
//! </div>
//!
//! Tests: `accuracy/formulas/camera.rs`.
//!
//! Next page: [A point](crate::guide::mathematics::projection#a-point).
