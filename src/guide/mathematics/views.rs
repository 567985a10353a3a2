//! Views: cameras, their inverse, and projections with parallel lines of sight.
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
//! **A chain of transforms is read from right to left**: viewport · projection · camera · model · point. Factors do not
//! commute: a model that is turned and then moved is not in the same place as a model that is moved and then turned.
//!
//! ```
//! use embedded_graphics::pixelcolor::Gray8;
//! use fixel::prelude::*;
//!
//! // (1, 0, 0) is turned to (0, 1, 0), moved to (2, 1, 0), and seen at (2, 1, −5).
//! let camera = Camera::look_at(vec3!(0, 0, 5), Vec3::ZERO, Vec3::Y)?;
//! let projection = Projection::frustum(Window::centered(fx!(2), fx!(2)), fx!(2), fx!(10))?;
//! let [turn, shift] = [Transform::rotate_z(deg!(90)), Transform::translate(vec3!(2, 0, 0))];
//! let mut pixels = vec![Gray8::new(0); 240 * 240];
//! let canvas = Canvas::new(&mut pixels, 240, 240)?;
//! let place = |model| {
//!     let mvp = projection * camera * model;
//!     let at = canvas.project(&DrawOptions::new(), &mvp, Vec3::X).unwrap();
//!     [at.x, at.y].map(f64::from)
//! };
//! assert_eq!(place(shift * turn), [216.0, 72.0]); // 120 · (1 + ⅘) and 120 · (1 − ⅖)
//! assert_eq!(place(turn * shift), [120.0, -24.0]); // at (0, 3, 0): above the picture
//! # Ok::<(), Error>(())
//! ```
//!
//! Tests: `accuracy/formulas/camera.rs`.
//!
//! # Parallel views
//!
//! **An orthographic projection only scales and moves.** It maps a box to −1…1 along each axis and leaves *w* at 1, so
//! parallel lines stay parallel. It is translate · scale, the product of [A matrix](crate::guide::mathematics::perspective#a-matrix) without *P*:
//!
#![doc = formula!({matrix(
    [frac(2)(r - l)] [0]              [0]               [-frac(r + l)(r - l)];
    [0]              [frac(2)(t - b)] [0]               [-frac(t + b)(t - b)];
    [0]              [0]              [-frac(2)(f - n)] [-frac(f + n)(f - n)];
    [0]              [0]              [0]               [1]
)})]
//!
//! ```
//! use fixel::prelude::*;
//!
//! let window = Window { left: fx!(-3), right: fx!(5), bottom: fx!(-1), top: fx!(1) };
//! let plan = Projection::orthographic(window, fx!(2), fx!(10))?.to_matrix();
//! assert_eq!(plan.project(vec3!(-3, -1, -2)), Some(vec3!(-1, -1, -1)));
//! assert_eq!(plan.project(vec3!(5, 1, -10)), Some(vec3!(1, 1, 1)));
//! # Ok::<(), Error>(())
//! ```
//!
//! **An axonometric view is orthographic, from a direction that shows three sides of a box.** A unit vector along an
//! axis of the world has the components *i*, *j* and *k* in the axes of the camera, and the picture shows the first
//! two. The squares of the three components add up to 1, so the image of the vector has the
//!
#![doc = formula!({length = sqrt(i^2 + j^2) = sqrt(1 - k^2)})]
//!
//! In an isometric view, the images of all three axes have the same length, so the axes have the same *k*. The three
//! numbers *k* are the components of the camera's back axis, a unit vector. So each is 1/√3, and each length is √(2/3),
//! about 0.816. The camera is turned by 45° and raised by 35.26°, the angle with the sine 1/√3. In a dimetric view, two
//! of the three lengths are equal. In a trimetric view, all three lengths differ. A view along an axis shows the front,
//! a side or the top.
//!
//! ```
//! use fixel::prelude::*;
//!
//! let isometric = Camera::isometric(Vec3::ZERO, fx!(10));
//! for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
//!     let [x, y, _] = isometric.view().direction(axis).to_bits().map(|v| f64::from(v) / 65536.0);
//!     assert!((x.hypot(y) - (2.0_f64 / 3.0).sqrt()).abs() < 1e-5);
//! }
//! ```
//!
//! **An oblique view leaves the front undistorted.** A point at a depth *d* behind the front moves by ρ*d* in the
//! direction of an angle φ:
//!
#![doc = formula!({prime(x) = x + var "ρ" d fun cos var "φ"} {prime(y) = y + var "ρ" d fun sin var "φ"})]
//!
//! An edge of length one that points straight back has an image of length ρ: 1 in a cavalier projection, ½ in a cabinet
//! projection.
//!
#![doc = include_str!("../diagrams/parallel.svg")]
//!
//! ```
//! use fixel::prelude::*;
//!
//! // The window is ±1, like normalized device coordinates. Depth runs at 30° to the right.
//! let window = Window::centered(fx!(2), fx!(2));
//! let edge = |projection: Projection<fixel::view::Parallel>| {
//!     let at = |z| projection.to_matrix().project(Vec3::new(fx!(0), fx!(0), z)).unwrap();
//!     let edge = at(fx!(-2)) - at(fx!(-1));
//!     f64::from(edge.x).hypot(edge.y.into())
//! };
//! assert!((edge(Projection::cavalier(deg!(30), window, fx!(1), fx!(9))?) - 1.0).abs() < 1e-4);
//! assert!((edge(Projection::cabinet(deg!(30), window, fx!(1), fx!(9))?) - 0.5).abs() < 1e-4);
//! # Ok::<(), Error>(())
//! ```
//!
//! Tests: axonometric views in `accuracy/formulas/camera.rs`, other parallel views in
//! `accuracy/formulas/projection.rs`.
