//! Projection: where a point of the scene lands on the screen, by similar triangles, by a matrix, and in pixels.
//!
//! The [first page](crate::guide::mathematics) of this chapter says where the axes x, y and z point, and defines the
//! letters *n* and *f*.
//!
//! # A point
//!
//! **The point (*x*, *y*, *z*) has this image on the near plane:**
//!
#![doc = formula!({prime(x) = -frac(n x)(z)} {prime(y) = -frac(n y)(z)})]
//!
#![doc = include_str!("../diagrams/similar_triangles.svg")]
//!
//! The eye, the point and its image lie on one straight line. In the diagram, the small triangle and the large one
//! share the angle at the eye, and both have a right angle. Their sides are in proportion: *y*′ is to *n* as *y* is to
//! −*z*. The same holds for *x*.
//!
//! At *z* = 0 the line of sight is parallel to the near plane and never meets it. Behind the eye, *z* is positive and
//! the signs of *x*′ and *y*′ flip: the image would be upside down, with left and right exchanged. In both cases,
//! [`Projection::image`](crate::Projection::image) returns `None`.
//!
//! For practice, let *n* = 2, and take a cube whose corners have *x* = ±1, *y* = ±1, and *z* = −3 (front) or −5 (back).
//! The images of the front corners are at ±2/3, and the images of the back corners are at ±2/5:
//!
#![doc = include_str!("../diagrams/practice_cube.svg")]
//!
//! ```
//! use fixel::prelude::*;
//! use fixel::Window;
//!
//! let projection = Projection::frustum(Window::centered(fx!(2), fx!(2)), fx!(2), fx!(10))?;
//! for (x, y) in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
//!     let times = |size: Scalar| Some([size * Scalar::from(x), size * Scalar::from(y)]);
//!     assert_eq!(projection.image(Vec3::from_ints(x, y, -3)), times(fx!(0.666667)));
//!     assert_eq!(projection.image(Vec3::from_ints(x, y, -5)), times(fx!(0.4)));
//!     assert_eq!(projection.image(Vec3::from_ints(x, y, 0)), None);
//!     assert_eq!(projection.image(Vec3::from_ints(x, y, 3)), None); // behind the eye
//! }
//! # Ok::<(), Error>(())
//! ```
//!
//! Tests: `accuracy/formulas/projection.rs`; the cube in pixels in `accuracy/formulas/pictures.rs`.
//!
//! # A matrix
//!
//! **A 4×4 matrix and one division project any point, and give it a depth.**
//!
//! A matrix cannot divide by *z*, but it can put the divisor into a fourth coordinate. Four numbers (*x*, *y*, *z*,
//! *w*) with *w* > 0 stand for the point (*x*/*w*, *y*/*w*, *z*/*w*); they are called homogeneous coordinates. A point
//! of eye space has *w* = 1. If the last row of the matrix is (0 0 −1 0), the result has *w* = −*z*, the distance ahead
//! of the eye.
//!
//! The visible part of the near plane is a window, from *l* to *r* in x and from *b* to *t* in y. In normalized device
//! coordinates (ndc), the window reaches from −1 to 1 along both axes. A point's image is *x*′ = *nx*/*w*, so *nx* =
//! *wx*′. This gives:
//!
#![doc = formula!(
    {x[ndc] = frac(2 prime(x) - (r + l))(r - l)}
    {w x[ndc] = frac(2 n)(r - l) x + frac(r + l)(r - l) z}
)]
//!
//! The second formula is the first row of the matrix. The second row is the same for *y*. The third row computes a
//! depth from *z* alone: *wz*<sub>ndc</sub> = *Az* + *B*. Two conditions determine *A* and *B*. The near plane, where
//! *z* = −*n* and *w* = *n*, maps to −1, and the far plane maps to 1:
//!
#![doc = formula!({-A n + B = -n} {-A f + B = f})]
//!
//! Subtract the second equation from the first, then insert *A* into the first:
//!
#![doc = formula!({A = -frac(f + n)(f - n)} {B = A n - n = -frac(2 f n)(f - n)})]
//!
#![doc = formula!({M = matrix(
    [frac(2 n)(r - l)] [0]                [frac(r + l)(r - l)] [0];
    [0]                [frac(2 n)(t - b)] [frac(t + b)(t - b)] [0];
    [0]                [0]                [A]                  [B];
    [0]                [0]                [-1]                 [0]
)})]
//!
//! The depth is −*A* + *B*/*w*. It is called pseudo-depth, because it keeps the order of distances but not their
//! proportions: with *n* = 2 and *f* = 10, half of the range of pseudo-depth is used up at a distance of 3⅓. The
//! distance itself is not suitable as a depth, because along a line on the screen, 1/*w* changes evenly, but *w* does
//! not ([A segment](crate::guide::mathematics::lines#a-segment)). A depth buffer of fixel stores 65535 *n*/*w*, which
//! is also linear in 1/*w*, and needs no far plane.
//!
#![doc = include_str!("../diagrams/pseudo_depth.svg")]
//!
//! ```
//! use fixel::prelude::*;
//! use fixel::Window;
//!
//! let window = Window::centered(fx!(2), fx!(2));
//! let matrix = Projection::frustum(window, fx!(2), fx!(10))?.to_matrix();
//! assert_eq!(matrix.rows()[2], [fx!(0), fx!(0), fx!(-1.5), fx!(-5)]); // A and B
//! assert_eq!(matrix.homogeneous(vec3!(1, 1, -5)), [fx!(2), fx!(2), fx!(2.5), fx!(5)]);
//! assert_eq!(matrix.project(vec3!(1, 1, -5)), Some(vec3!(0.4, 0.4, 0.5))); // divided by w
//! assert_eq!(matrix.project(vec3!(0, 0, -2)).unwrap().z, fx!(-1)); // the near plane
//! assert_eq!(matrix.project(vec3!(0, 0, -10)).unwrap().z, fx!(1)); // the far plane
//! # Ok::<(), Error>(())
//! ```
//!
//! **The same matrix is a product of three matrices.** Look for *A* and *B* that leave the depths of the near and the
//! far plane as they are: (*Az* + *B*)/(−*z*) = *z* at *z* = −*n* and at *z* = −*f*.
//!
#![doc = formula!({-A n + B = -n^2} {-A f + B = -f^2} {A = n + f} {B = n f})]
//!
//! The perspective transform *P* is the matrix with these *A* and *B*, and with *n* in its first two rows instead of
//! the terms with the window. It squeezes the frustum (the visible space between the near and the far plane) into a box
//! as wide as the window, and leaves both planes in place. A point at the distance *w* moves to the distance *n* + *f*
//! − *nf*/*w*.
//!
#![doc = formula!({P = matrix(
    [n] [0] [0]     [0];
    [0] [n] [0]     [0];
    [0] [0] [n + f] [n f];
    [0] [0] [-1]    [0]
)})]
//!
//! What remains is to scale the box to a size of 2, and to move its middle to the origin. *M* is translate · scale ·
//! *P*, with
//!
#![doc = formula!(
    {fun scale (frac(2)(r - l), frac(2)(t - b), -frac(2)(f - n))}
    {fun translate (-frac(r + l)(r - l), -frac(t + b)(t - b), -frac(f + n)(f - n))}
)]
//!
//! To check the third row: scaling turns *n* + *f* and *nf* into −2(*n*+*f*)/(*f*−*n*) and −2*nf*/(*f*−*n*); moving
//! adds (*f*+*n*)/(*f*−*n*) to the first number, because the last row of *P* has −1 in the third column. The results
//! are *A* and *B*.
//!
//! ```
//! use fixel::{Window, Matrix4, prelude::*, textbook::perspective_transform};
//!
//! let inner = perspective_transform(fx!(2), fx!(10));
//! assert_eq!(inner.project(vec3!(1, 1, -5)), Some(vec3!(0.4, 0.4, -8))); // 12 − 20/5
//! for z in [-2, -10] {
//!     let depth = inner.project(Vec3::from_ints(0, 0, z)).unwrap().z;
//!     assert_eq!(depth, Scalar::from(z)); // both planes stay
//! }
//! let [middle, scale] = [vec3!(0, 0, -1.5), vec3!(1, 1, -0.25)];
//! let window = Window::centered(fx!(2), fx!(2));
//! let matrix = Projection::frustum(window, fx!(2), fx!(10))?.to_matrix();
//! assert_eq!(Matrix4::translate(middle) * Matrix4::scale(scale) * inner, matrix);
//! # Ok::<(), Error>(())
//! ```
//!
//! <div class="warning">
//!
//! **Clipping after the division.** The point (1, 1, 3) lies behind the eye. Its *w* is −3, and a division would put it
//! at (−⅔, −⅔), inside the window. A triangle with a corner behind the eye would reach to this mirrored point, across
//! the wrong part of the picture. No test of screen positions can detect this. Clip first, while *w* still has its
//! sign, then divide ([A clip](crate::guide::mathematics::clipping#a-clip)). fixel's draw calls work in this order.
//!
//! ```
//! use fixel::prelude::*;
//! use fixel::Window;
//!
//! let window = Window::centered(fx!(2), fx!(2));
//! let matrix = Projection::frustum(window, fx!(2), fx!(10))?.to_matrix();
//! assert_eq!(matrix.homogeneous(vec3!(1, 1, 3))[3], fx!(-3));
//! assert_eq!(matrix.project(vec3!(1, 1, 3)), None);
//! # Ok::<(), Error>(())
//! ```
//!
//! </div>
//!
//! Tests: `accuracy/formulas/projection.rs`; points behind the eye in `accuracy/clipping.rs`.
//!
//! # A window
//!
//! **A vertical field of view and an aspect ratio are equivalent to a centered window.**
//!
#![doc = formula!({t = n fun tan frac(fov)(2)} {r = t dot aspect} {b = -t} {l = -r})]
//!
#![doc = formula!({aspect = frac(r - l)(t - b)} {fov = 2 fun atan frac(t - b)(2 n)})]
//!
#![doc = include_str!("../diagrams/field_of_view.svg")]
//!
//! The eye, the middle of the window and the middle of its upper edge are the corners of a right triangle. The side
//! opposite half the field of view is *t*, and the adjacent side is *n*. The second line of formulas solves the first
//! line for the aspect ratio and the angle. A window need not be centered:
//! [`Projection::frustum`](crate::Projection::frustum) accepts any window, for one half of a stereo pair or for one of
//! several panels. If the window is off center, the first two entries of the matrix's third column are not both 0.
//!
//! ```
//! use fixel::prelude::*;
//! use fixel::Window;
//!
//! let projection = Projection::perspective(deg!(60), fx!(1.5), fx!(2), fx!(10))?;
//! let Window { left, right, bottom, top } = projection.window();
//! let digits = [top, right, bottom, left].map(|edge| format!("{edge:.4}"));
//! assert_eq!(digits, ["1.1547", "1.7321", "-1.1547", "-1.7321"]);
//!
//! let back = Projection::frustum(Window::centered(fx!(6), fx!(4)), fx!(2), fx!(10))?;
//! assert_eq!((back.fov(), back.aspect()), (deg!(90), fx!(1.5))); // 2 · atan(4/4), 6/4
//! # Ok::<(), Error>(())
//! ```
//!
//! **The viewport turns normalized device coordinates into pixels.** In a viewport of *W* by *H* pixels, rows are
//! counted downward:
//!
#![doc = formula!({column = frac(W)(2) (1 + x[ndc])} {row = frac(H)(2) (1 - y[ndc])})]
//!
//! ```
//! use fixel::prelude::*;
//! use fixel::Window;
//!
//! // The practice cube's front corner, in a picture of 240x240 pixels.
//! let projection = Projection::frustum(Window::centered(fx!(2), fx!(2)), fx!(2), fx!(10))?;
//! let screen = Viewport::new(0, 0, 240, 240)?;
//! let at = screen.project(vec3!(1, 1, -3), &projection).unwrap();
//! assert_eq!([at.x, at.y].map(f64::from), [200.0, 40.0]); // 120 · (1 ± ⅔)
//! let at = screen.project(vec3!(1, 1, -7), &projection).unwrap();
//! assert_eq!(f64::from(at.x), 39_497.0 / 256.0); // 120 · (1 + 2/7), to 1/256 pixel
//! # Ok::<(), Error>(())
//! ```
//!
//! <div class="warning">
//!
//! **Whole pixels for corners.** A corner that is rounded to whole pixels moves by up to half a pixel, and the edges
//! and the texture move with the corner. A slowly turning model then jitters. Keep a fraction (8 bits in fixel), and
//! test coverage at the centers of pixels, half a pixel from their edges.
//!
//! </div>
//!
//! Tests: `accuracy/formulas/projection.rs`; viewports in `accuracy/formulas/camera.rs`.
//!
//! # Parallel views
//!
//! **An orthographic projection only scales and moves.** It maps a box to −1…1 along each axis and leaves *w* at 1, so
//! parallel lines stay parallel. Its matrix is translate · scale, the product in [A matrix](#a-matrix) without *P*:
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
//! use fixel::Window;
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
//! In an isometric view, the images of the three unit vectors are equally long, so their *k* are equal. The three
//! numbers *k* are the components of the unit vector toward the viewer. So each is 1/√3, and each length is √(2/3),
//! about 0.816. The camera is turned by 45° and raised by 35.26°, the angle whose sine is 1/√3. In a dimetric view, two
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
//! **An oblique view leaves the front undistorted.** The image of a point at a depth *d* behind the front moves by
//! ρ*d*, in a direction at the angle φ to the x axis:
//!
#![doc = formula!({prime(x) = x + var "ρ" d fun cos var "φ"} {prime(y) = y + var "ρ" d fun sin var "φ"})]
//!
//! An edge of length one that points straight back has an image of length ρ. In a cavalier projection ρ is 1; in a
//! cabinet projection it is ½.
//!
#![doc = include_str!("../diagrams/parallel.svg")]
//!
//! ```
//! use fixel::prelude::*;
//! use fixel::Window;
//!
//! // The window is ±1, like normalized device coordinates. Depth runs at 30° to the right, from the near plane.
//! let window = Window::centered(fx!(2), fx!(2));
//! let edge = |ratio| -> Result<f64, Error> {
//!     let view = Projection::oblique(deg!(30), ratio, fx!(1), window, fx!(1), fx!(9))?;
//!     let at = |z| view.to_matrix().project(Vec3::new(fx!(0), fx!(0), z)).unwrap();
//!     let edge = at(fx!(-2)) - at(fx!(-1));
//!     Ok(f64::from(edge.x).hypot(edge.y.into()))
//! };
//! assert!((edge(fx!(1))? - 1.0).abs() < 1e-4);
//! assert!((edge(fx!(0.5))? - 0.5).abs() < 1e-4);
//! # Ok::<(), Error>(())
//! ```
//!
//! Tests: axonometric views in `accuracy/formulas/camera.rs`, other parallel views in
//! `accuracy/formulas/projection.rs`.
//!
//! # A chain
//!
//! **A chain of transforms is read from right to left**: viewport · projection · camera · model · point. Factors do not
//! commute: a model that is turned and then moved is not in the same place as a model that is moved and then turned.
//!
//! ```
//! use embedded_graphics::pixelcolor::Gray8;
//! use fixel::prelude::*;
//! use fixel::Window;
//!
//! // (1, 0, 0) is turned to (0, 1, 0), moved to (2, 1, 0), and seen at (2, 1, −5).
//! let camera = Camera::look_at(vec3!(0, 0, 5), Vec3::ZERO, Vec3::Y)?;
//! let projection = Projection::frustum(Window::centered(fx!(2), fx!(2)), fx!(2), fx!(10))?;
//! let [turn, shift] = [Transform::rotate_z(deg!(90)), Transform::translate(vec3!(2, 0, 0))];
//! let screen = Viewport::new(0, 0, 240, 240)?;
//! let place = |model| {
//!     let mvp = projection * camera * model;
//!     let at = screen.project(Vec3::X, &mvp).unwrap();
//!     [at.x, at.y].map(f64::from)
//! };
//! assert_eq!(place(shift * turn), [216.0, 72.0]); // 120 · (1 + ⅘) and 120 · (1 − ⅖)
//! assert_eq!(place(turn * shift), [120.0, -24.0]); // at (0, 3, 0): above the picture
//! # Ok::<(), Error>(())
//! ```
//!
//! Tests: `accuracy/formulas/camera.rs`.
//!
//! Next page: [A clip](crate::guide::mathematics::clipping#a-clip).
