//! The camera: from world space to eye space.
//!
//! The [first page](crate::guide::mathematics) of this chapter says where the axes x, y and z point.
//!
//! # A camera
//!
//! **A camera is the rigid transform that brings the eye to the origin and the target onto −z.** In the world, the
//! camera has these axes:
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
//! **To invert a rigid transform, transpose its rotation, and reverse its move.** The rows of a rotation *R* are
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
//! let inverse = pose.inverse().unwrap(); // of any transform that has one
//! for view in [Camera::at_pose(pose).view(), inverse, undone] {
//!     assert_eq!(view.point(Vec3::ZERO), vec3!(0, 0, -5));
//! }
//! assert_eq!((pose * inverse).point(vec3!(7, 8, 9)), vec3!(7, 8, 9));
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
//! # A mirror
//!
//! **A shadow moves a point along the light until the point is on a plane. A mirror moves the point along the plane's
//! normal to the plane, and then as far again.** Let *q* be a point of the plane, and *n* its normal, of any length. A
//! step of *t* times a direction *d* changes *n* · (*p* − *q*) by *t* (*n* · *d*). On the plane, *n* · (*p* − *q*) is
//! 0, so *t* = −*n* · (*p* − *q*) / (*n* · *d*). For the shadow, *d* is the direction *l* to the light; for the mirror
//! image, *d* is *n* itself:
//!
#![doc = formula!(
    {shadow = p - frac(n dot (p - q))(n dot l) l}
    {image = p - 2 frac(n dot (p - q))(n dot n) n}
)]
//!
//! Both maps are affine. With the identity matrix *I*, the shadow's matrix is *I* − *l* *n*<sup>T</sup> / (*n* · *l*),
//! with the determinant 0. So a shadow has no inverse. The mirror's matrix is *I* − 2 *n* *n*<sup>T</sup> / (*n* ·
//! *n*), with the determinant −1. A mirror is its own inverse.
//!
//! By hand: the ground has *q* = 0 and *n* = (0, 1, 0), and the sun is in the direction *l* = (1, 2, 0). For *p* = (5,
//! 3, 7), *n* · *p* is 3, and *n* · *l* is 2. The shadow is (5, 3, 7) − 1.5 (1, 2, 0) = (3.5, 0, 7), and the mirror
//! image is (5, −3, 7).
//!
//! ```
//! use fixel::prelude::*;
//!
//! let p = vec3!(5, 3, 7);
//! let shadow = Transform::shadow(Vec3::ZERO, Vec3::Y, vec3!(1, 2, 0))?;
//! assert_eq!(shadow.point(p), vec3!(3.5, 0, 7));
//! assert_eq!(shadow.inverse(), None);
//! let camera = Camera::look_at(vec3!(0, 2, 9), Vec3::ZERO, Vec3::Y)?;
//! let mirrored = camera.mirrored(Vec3::ZERO, Vec3::Y)?;
//! assert_eq!(mirrored.view().point(p), camera.view().point(vec3!(5, -3, 7)));
//! assert_eq!(mirrored.pose().point(Vec3::ZERO), vec3!(0, -2, 9)); // the mirror image of the eye
//! # Ok::<(), Error>(())
//! ```
//!
//! **Mirror the camera, not the model.** Either way, the points have the same places on the screen. But light is
//! computed where the points are in the world. A mirrored model is below the ground, and the sun lights the wrong side
//! of it. [`Camera::mirrored`](crate::Camera::mirrored) leaves the world as it is.
//!
//! Tests: `accuracy/formulas/camera.rs`, `accuracy/formulas/plane.rs` and `exact/mirrors.rs`.
//!
//! Next page: [A point](crate::guide::mathematics::projection#a-point).
