//! From similar triangles to the pixel: the mathematics of a picture in perspective.
//!
//! With this page you can work out by hand where a point of your scene lands on the screen, where parallel lines meet,
//! and why a texture bends if depth is interpolated the wrong way. You can also say where the errors of fixed point
//! come from, and how large they are. You need to know vectors and matrices, but nothing about graphics. Each step
//! states a claim, derives it, and checks numbers with the call that computes them.
//!
//! 1. [A point](#a-point): similar triangles
//! 2. [A matrix](#a-matrix): homogeneous coordinates and pseudo-depth
//! 3. [A window](#a-window): field of view, aspect ratio, pixels
//! 4. [Lines](#lines): slopes, vanishing points, speed
//! 5. [A segment](#a-segment): foreshortening
//! 6. [A triangle](#a-triangle): one reciprocal per pixel
//! 7. [Fixed point](#fixed-point): formats and errors
//! 8. [A camera](#a-camera): look-at, the inverse, the order of transforms
//! 9. [Parallel views](#parallel-views): orthographic, axonometric, oblique
//! 10. [Time](#time): turns that do not drift
//!
//! The axes are right-handed: x points to the right, and y points up. The eye is at the origin and looks along −z. The
//! numbers *n* and *f* are the distances of the near and the far plane, both above zero. Each step ends with the names
//! of the tests that check its claim, mostly with random numbers. The files of these tests are in the repository's
//! folder `tests`.
//!
//! # A point
//!
//! **The point (*x*, *y*, *z*) has this image on the near plane:**
//!
#![doc = formula!({prime(x) = -frac(n x)(z)} {prime(y) = -frac(n y)(z)})]
//!
#![doc = diagram!("similar_triangles")]
//!
//! The eye, the point and its image lie on one straight line. The small triangle and the large one share the angle at
//! the eye, and both have a right angle. Their sides are in proportion: *y*′ is to *n* as *y* is to −*z*. The same
//! holds for *x*.
//!
//! At *z* = 0 the line of sight is parallel to the near plane and never meets it. Behind the eye, *z* is positive and
//! the signs of *x*′ and *y*′ flip: the image would be upside down, with left and right exchanged. In both cases,
//! [`Projection::image`](crate::Projection::image) returns `None`.
//!
//! For practice, let *n* = 2, and take a cube whose corners have *x* = ±1, *y* = ±1, and *z* = −3 (front) or −5 (back).
//! The images of the front corners are at ±2/3, and the images of the back corners are at ±2/5:
//!
#![doc = diagram!("practice_cube")]
//!
//! ```
//! use fixel::prelude::*;
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
//! of eye space has *w* = 1. If the last row of the matrix is (0 0 −1 0), the result has *w* = −*z*, the distance
//! ahead of the eye.
//!
//! The visible part of the near plane is a window, from *l* to *r* in x and from *b* to *t* in y. In normalized device
//! coordinates (ndc), the window reaches from −1 to 1 along both axes. The image above is *x*′ = *nx*/*w*, so *nx* =
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
//! proportions: with *n* = 2 and *f* = 10, half of its range is used up at a distance of 3⅓. The distance itself is not
//! suitable as a depth, because along a line on the screen, 1/*w* changes evenly, but *w* does not
//! ([below](#a-segment)). A depth buffer of fixel stores 65535 *n*/*w*, which is also linear in 1/*w*, and needs no far
//! plane.
//!
#![doc = diagram!("pseudo_depth")]
//!
//! ```
//! use fixel::prelude::*;
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
//! The matrix with these *A* and *B*, and with *n* in the first two rows in place of the window, is the perspective
//! transform *P*. It squeezes the frustum into a box as wide as the window, and leaves both planes in place. A point at
//! the distance *w* moves to the distance *n* + *f* − *nf*/*w*.
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
//! To check the third row: scaling gives −2(*n*+*f*)/(*f*−*n*) and −2*nf*/(*f*−*n*); moving adds (*f*+*n*)/(*f*−*n*) to
//! the first number, because the last row of *P* has −1 in the third column. The results are *A* and *B*.
//!
//! ```
//! use fixel::{Matrix4, prelude::*};
//!
//! let inner = Matrix4::perspective_transform(fx!(2), fx!(10));
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
//! at (−⅔, −⅔), inside the window. A triangle with such a corner would reach to the mirrored point, across the wrong
//! part of the picture. No test of screen positions can detect this. Clip first, while *w* still has its sign, then
//! divide. Draw calls work in this order.
//!
//! ```
//! use fixel::prelude::*;
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
#![doc = diagram!("field_of_view")]
//!
//! In the right triangle between the eye, the middle of the window and its upper edge, the side opposite half the field
//! of view is *t*, and the adjacent side is *n*. The second line of formulas solves the first line for the aspect ratio
//! and the angle. A window need not be centered: [`Projection::frustum`](crate::Projection::frustum) accepts any
//! window, for one half of a stereo pair or for one of several panels. The matrix of an off-center window also has
//! entries in the third column.
//!
//! ```
//! use fixel::prelude::*;
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
//! use embedded_graphics::pixelcolor::Gray8;
//! use fixel::prelude::*;
//!
//! // The practice cube's front corner, in a picture of 240x240 pixels.
//! let projection = Projection::frustum(Window::centered(fx!(2), fx!(2)), fx!(2), fx!(10))?;
//! let mut pixels = vec![Gray8::new(0); 240 * 240];
//! let canvas = Canvas::new(&mut pixels, 240, 240)?;
//! let at = canvas.project(&DrawOptions::new(), &projection, vec3!(1, 1, -3)).unwrap();
//! assert_eq!([at.x, at.y].map(f64::from), [200.0, 40.0]); // 120 · (1 ± ⅔)
//! let at = canvas.project(&DrawOptions::new(), &projection, vec3!(1, 1, -7)).unwrap();
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
//! # Lines
//!
//! **The image of a line is a line.** The eye and a line that does not pass through it span a plane. All lines of
//! sight to the line lie in that plane, and the plane cuts the near plane in a line.
//!
//! For what follows, a line is *P* + *t* *v*, with a point *P*, a direction *v* and a number *t*.
//!
//! **Lines parallel to the picture keep their slope.** If *v<sub>z</sub>* = 0, then *z* is *P<sub>z</sub>* all along
//! the line. Both coordinates are multiplied by the same number, −*n*/*P<sub>z</sub>*, and the image keeps the slope
//! *v<sub>y</sub>*/*v<sub>x</sub>*.
//!
//! **All lines of any other direction meet in one vanishing point.** As *t* grows, *P* no longer matters:
//!
#![doc = formula!(
    {prime(x) = -n frac(P[x] + t v[x])(P[z] + t v[z]) to -n frac(v[x])(v[z])}
    {prime(y) to -n frac(v[y])(v[z])}
)]
//!
//! The vanishing point is also the image of the point *v* itself, or of −*v* if *v* points backward: the line of sight
//! to a vanishing point is parallel to the lines that meet there.
//! [`Projection::vanishing_point`](crate::Projection::vanishing_point) computes the vanishing point.
//!
//! ```
//! use fixel::prelude::*;
//!
//! let projection = Projection::frustum(Window::centered(fx!(2), fx!(2)), fx!(2), fx!(10))?;
//! assert_eq!(projection.vanishing_point(vec3!(1, 0, -4)), Some([fx!(0.5), fx!(0)]));
//! assert_eq!(projection.vanishing_point(vec3!(1, 2, 0)), None);
//! assert_eq!(projection.image(vec3!(0, 0, -4)), Some([fx!(0), fx!(0)]));
//! assert_eq!(projection.image(vec3!(1, 2, -4)), Some([fx!(0.5), fx!(1)])); // the slope stays 2
//! // The image of (3, −1, −2) + 1000 · (1, 0, −4) is nearly there.
//! let [x, y] = projection.image(vec3!(1003, -1, -4002)).unwrap().map(f64::from);
//! assert!((x - 0.5).abs() < 0.002 && y.abs() < 0.001);
//! # Ok::<(), Error>(())
//! ```
//!
//! **Steps of equal length shrink toward the vanishing point.** The derivative of *x*′ is the speed of the image on the
//! near plane. The quotient rule leaves a numerator without *t*, so the speed falls with the square of the distance:
//!
#![doc = formula!(
    {frac(partial prime(x))(partial t) = -n frac(v[x] (P[z] + t v[z]) - (P[x] + t v[x]) v[z])((P[z] + t v[z])^2)}
    {= -n frac(v[x] P[z] - P[x] v[z])((P[z] + t v[z])^2)}
)]
//!
#![doc = diagram!("rails")]
//!
//! The rails have the direction −z. The sleepers are parallel to x and stay level.
//!
//! ```
//! use fixel::{fx, vec3, view::speed};
//!
//! // A train on these rails: at four times the distance, a sixteenth of the speed.
//! let (track, ahead) = (vec3!(0, -1, -1), vec3!(0, 0, -1));
//! assert_eq!(speed(fx!(1), track, ahead, fx!(0)), Some([fx!(0), fx!(1)]));
//! assert_eq!(speed(fx!(1), track, ahead, fx!(3)), Some([fx!(0), fx!(0.0625)]));
//! ```
//!
//! **A box has one vanishing point for each of its axes that is not parallel to the picture**: one if it faces the eye,
//! two if it is turned, and three if it is also tilted. This is what one-, two- and three-point perspective means.
//!
#![doc = diagram!("vanishing_points")]
//!
//! ```
//! use fixel::prelude::*;
//!
//! let projection = Projection::frustum(Window::centered(fx!(2), fx!(2)), fx!(2), fx!(10))?;
//! let points = |turn: Transform| {
//!     let axes = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| turn.direction(axis));
//!     axes.iter().filter(|axis| projection.vanishing_point(**axis).is_some()).count()
//! };
//! let turned = Transform::rotate_y(deg!(-40));
//! assert_eq!(points(Transform::IDENTITY), 1);
//! assert_eq!(points(turned), 2);
//! assert_eq!(points(Transform::rotate_x(deg!(30)) * turned), 3);
//! # Ok::<(), Error>(())
//! ```
//!
//! Tests: lines and slopes in `accuracy/formulas/camera.rs`, vanishing points in `accuracy/formulas/projection.rs`, one
//! to three vanishing points in `accuracy/formulas/pictures.rs`, speeds in `accuracy/formulas/segment.rs`.
//!
//! # A segment
//!
//! **Halfway along the picture of a segment is not halfway along the segment.** Let *w*₀ and *w*₁ be the distances of
//! the segment's ends ahead of the eye. Here *w* is −*z*; books with a *z* axis that points ahead write *z* in place of
//! *w*. Let *t* be the fraction of the way along the segment, and *q* the fraction of the way along its picture.
//!
#![doc = diagram!("foreshortening")]
//!
//! The point at *t* is a mean of the segment's ends, with the weights 1 − *t* and *t*. The point's distance *w* is the
//! same mean of *w*₀ and *w*₁. The point's image is *nx*/*w*, and at the ends *nx* = *wx*′:
//!
#![doc = formula!(
    {prime(x) = frac((1 - t) n x[0] + t n x[1])((1 - t) w[0] + t w[1])}
    {= frac((1 - t) w[0] prime(x[0]) + t w[1] prime(x[1]))((1 - t) w[0] + t w[1])}
)]
//!
//! This is a mean of the images of the ends. The weight of the second image is *q*:
//!
#![doc = formula!(
    {q = frac(t w[1])(w[0] + t (w[1] - w[0]))}
    {frac(q)(1 - q) = frac(t)(1 - t) dot frac(w[1])(w[0])}
)]
//!
//! To solve the last equation for *t*, exchange the distances:
//!
#![doc = formula!({t = frac(q w[0])(w[1] - q (w[1] - w[0]))})]
//!
//! Put this into *w* = *w*₀ + *t* (*w*₁ − *w*₀). In the numerator, everything except *w*₀ *w*₁ cancels. Therefore
//! **1/*w* is linear on the screen**:
//!
#![doc = formula!(
    {w = frac(w[0] w[1])(w[1] - q (w[1] - w[0]))}
    {frac(1)(w) = frac(1 - q)(w[0]) + frac(q)(w[1])}
    {= frac(1)(w[0]) + q (frac(1)(w[1]) - frac(1)(w[0]))}
)]
//!
//! An attribute *a*, such as a texture coordinate or a color, is linear in space: *a* = (1 − *t*) *a*₀ + *t* *a*₁. The
//! same substitution shows that ***a*/*w* is linear on the screen**, and *a* is the quotient of two linear functions.
//! With lerp(*u*, *v*, *q*) = *u* + *q* (*v* − *u*):
//!
#![doc = formula!({a = frac(fun lerp (a[0] / w[0], a[1] / w[1], q))(fun lerp (1 / w[0], 1 / w[1], q))})]
//!
//! The derivation uses only that *w* and *wx*′ are linear in space. Therefore the result holds for the fourth
//! homogeneous coordinate after any matrix. Textbooks write *f* for the fraction on the screen and *g* for the fraction
//! in space:
//!
#![doc = formula!({g = frac(f)(fun lerp (w[1] / w[0], 1, f))} {a = fun lerp (a[0], a[1], g)})]
//!
//! [`Segment`](crate::view::Segment) computes all of these values:
//!
//! ```
//! use fixel::{Fraction, fx, view::Segment};
//!
//! let segment = Segment::new(fx!(1), fx!(4)).unwrap();
//! let (half, fifth) = (Fraction::ONE / 2, Fraction::ONE / 5);
//! assert_eq!(segment.distance(half), Some(fx!(1.6)));
//! assert_eq!(segment.in_space(half), Some(fifth)); // t of q
//! assert_eq!(segment.on_screen(fifth), Some(half)); // q of t
//! assert_eq!(segment.attribute(fx!(10), fx!(20), half), Some(fx!(12))); // 10 + ⅕ · 10
//! // The other form: g = f / lerp(w₁/w₀, 1, f), with f = ½.
//! let g: f64 = 0.5 / (4.0 + 0.5 * (1.0 - 4.0));
//! assert_eq!(10.0 + g * (20.0 - 10.0), 12.0);
//! ```
//!
//! <div class="warning">
//!
//! **Interpolating z.** Take the segment of the program above, from distance 1 to distance 4. If *z* were linear on the
//! screen, the middle of the segment's picture would show the distance 2.5. The true distance there is 1.6. A depth
//! test would let the wrong surface win, and a texture that is interpolated in this way bends along the diagonal of
//! each square. Interpolate 1/*w* and *a*/*w*, and divide last. The mode [`Affine`](crate::mode::Affine) skips the
//! division on purpose; [its error](crate::guide::modes#affine) has a formula.
//!
//! </div>
//!
//! Tests: `accuracy/formulas/segment.rs`.
//!
//! # A triangle
//!
//! **Across a triangle, too, 1/*w* and *a*/*w* are linear on the screen.** This holds for every attribute *a* that is
//! linear across the triangle in space: position, texture coordinates, color, normal, light.
//!
//! The triangle lies in a plane *k* · (*x*, *y*, *z*) = *c*. If *c* were 0, the eye would be in the plane, and the
//! triangle would not be seen. On the near plane, *x* = *x*′*w*/*n*, *y* = *y*′*w*/*n* and *z* = −*w*. Substitute these
//! values, and divide by *c* *w*:
//!
#![doc = formula!({frac(1)(w) = frac(k[x] prime(x) + k[y] prime(y) - n k[z])(c n)})]
//!
//! On the plane, the attribute is *a* = *g* · (*x*, *y*, *z*) + *d*. Divided by *w*, the first term is linear in *x*′
//! and *y*′ by the same substitution, and *d*/*w* is linear because 1/*w* is linear.
//!
//! The value of a linear function at a point is the mean of its values at the corners, weighted with the point's
//! barycentric coordinates on the screen. These coordinates are proportional to the areas of the triangles opposite the
//! corners, and *α* + *β* + *γ* = 1. Hence
//!
#![doc = formula!({a = frac
    (var "α" a[0] / w[0] + var "β" a[1] / w[1] + var "γ" a[2] / w[2])
    (var "α" / w[0] + var "β" / w[1] + var "γ" / w[2])
})]
//!
#![doc = diagram!("weights")]
//!
//! Along a row of pixels, a linear function changes by the same amount from pixel to pixel. A renderer adds this amount
//! to 1/*w* and to each *a*/*w*. **One reciprocal per pixel** then serves all attributes.
//!
//! ```
//! use embedded_graphics::pixelcolor::{Gray8, GrayColor, Rgb888, RgbColor};
//! use fixel::mode::{Affine, Mode, Newton};
//! use fixel::prelude::*;
//!
//! // At distances 1, 2 and 4. The images (−½, −½), (½, −½) and (0, 1) have the mean (0, 0).
//! let corners = [vec3!(-0.5, -0.5, -1), vec3!(1, -1, -2), vec3!(0, 4, -4)];
//! let colors = [Rgb888::BLACK, Rgb888::BLACK, Rgb888::new(252, 252, 252)];
//! let mesh = Mesh::new(&corners, &[[0, 1, 2]])?.with_colors(&colors, None)?;
//! let projection = Projection::perspective(deg!(90), (1, 1), fx!(0.5), fx!(10))?;
//!
//! fn middle(mode: impl Mode, mesh: &Mesh, projection: &Projection) -> Result<u8, Error> {
//!     let mut pixels = [Gray8::BLACK; 65 * 65];
//!     let options = DrawOptions::new().with_mode(mode);
//!     let mut canvas = Canvas::new(&mut pixels, 65, 65)?;
//!     canvas.draw_with(&options, mesh, projection, &Gouraud::new());
//!     Ok(pixels[32 * 65 + 32].luma())
//! }
//! // At (0, 0), all weights are ⅓: (252/4) / (1 + ½ + ¼) = 36. Without w it would be 252/3.
//! assert_eq!(middle(Newton, &mesh, &projection)?, 36);
//! assert_eq!(middle(Affine, &mesh, &projection)?, 84);
//! # Ok::<(), Error>(())
//! ```
//!
//! Tests: `accuracy/formulas/triangle.rs`; other attributes, and triangles of all shapes, in `accuracy/varyings.rs`.
//!
//! # Fixed point
//!
//! **A fixed-point number is an integer whose unit is a power of two.** The unit bounds the rounding error, and the
//! number of bits bounds the range. Each quantity has the format that its range needs; [`num`](crate::num) lists all of
//! them:
//!
//! | quantity | bits | unit |
//! |---|---|---|
//! | coordinates, distances | 32 | 2⁻¹⁶ |
//! | position on the screen | 32 | 2⁻⁸ pixel |
//! | matrix of a transform | 30 and a sign each | 2 to a power that its nine entries share |
//! | *Q* = 1/*w* in a triangle | 31 | at most 2⁻³⁰ of its value at the nearest corner |
//! | *P* = *a*/*w* in a triangle | 30 and a sign | a power of two for which \|*P*\| ≤ *Q*/2 |
//!
//! **The entries of a matrix share an exponent** (block floating point): they differ in size from scene to scene, but
//! not much within a scene. A product of two mantissas has 60 bits, and 64 bits hold the sum of three products. The
//! example rotates a point by a thousandth of a degree: first by a matrix whose entries share an exponent, then by one
//! whose entries have the fixed unit 2⁻¹⁶:
//!
//! ```
//! use fixel::prelude::*;
//!
//! let turn = Transform::rotate_z(deg!(0.001));
//! let y = turn.point(vec3!(10000, 0, 0)).y;
//! assert_eq!(format!("{y:.4}"), "0.1745"); // 10000 · sin 0.001°
//! // The same in units of 2⁻¹⁶: the sine is rounded to one unit.
//! let [_, y, ..] = turn.to_matrix().homogeneous(vec3!(10000, 0, 0));
//! assert_eq!(format!("{y:.4}"), "0.1526");
//! ```
//!
//! **A Newton step squares the error of a reciprocal.** Let *r* be a guess for 1/*Q*, and *e* = 1 − *Qr* its relative
//! error. Then
//!
#![doc = formula!({prime(r) = r (2 - Q r) = r (1 + e)} {1 - Q prime(r) = 1 - (1 - e) (1 + e) = e^2})]
//!
//! From one pixel to the next, *Q* changes by a small fraction δ of its value. The reciprocal of the last pixel is a
//! guess with an error of δ, and one step (two products) reduces the error to δ². The mode
//! [`Newton`](crate::mode::Newton) takes its guess from the line through the last two reciprocals instead. This guess
//! has an error of about 2δ², and the step reduces the error to 4δ⁴.
//!
//! ```
//! use fixel::num::reciprocal;
//!
//! // 1/w at two pixels; δ is 1/64. Reciprocals are in units of 2⁻⁶¹.
//! let (last, q) = (3 << 29, (3 << 29) + (3 << 23));
//! let error = |r: f64| 1.0 - f64::from(q) * r / 2_f64.powi(61);
//! let guess = f64::from(reciprocal(last));
//! let step = guess * (1.0 + error(guess));
//! assert!((error(guess) + 1.0 / 64.0).abs() < 1e-9);
//! assert!((error(step) - 1.0 / 4096.0).abs() < 1e-9);
//! ```
//!
//! **A straight piece needs a reciprocal only at its ends.** Let *a* = *P*/*Q* along a row, where *P* and *Q* are
//! linear, and let a dot over a letter mean its change per pixel. Differentiate *aQ* = *P* twice:
//!
#![doc = formula!(
    {dotted(a) Q + a dotted(Q) = dotted(P)}
    {twice_dotted(a) Q + 2 dotted(a) dotted(Q) = 0}
    {|twice_dotted(a)| = 2 |dotted(a)| var "δ"}
)]
//!
//! The error of a chord over *L* pixels is at most |*ȧ*| δ *L*²/4, an eighth of *L*² times the second derivative. The
//! mode [`Fast`](crate::mode::Fast) uses the longest pieces that keep this error below your tolerance.
//!
#![doc = diagram!("pieces")]
//!
//! ```
//! use fixel::{Fraction, fx, view::Segment};
//!
//! // A wall from distance 1 to 2 shows 256 texels on 320 pixels. The last 16 pixels are one piece.
//! let wall = Segment::new(fx!(1), fx!(2)).unwrap();
//! let texel = |pixel: f64| {
//!     let there = wall.in_space(Fraction::try_from(pixel / 320.0).unwrap());
//!     256.0 * f64::from(there.unwrap())
//! };
//! let error = (texel(304.0) + texel(320.0)) / 2.0 - texel(312.0);
//! // At the far end, 1/w falls by 1/320 of itself a pixel, and the texture advances 1.6 texels.
//! let bound = 1.6 / 320.0 * 16.0 * 16.0 / 4.0;
//! assert!(0.9 * bound < error && error < bound, "{error} of {bound}");
//! ```
//!
//! [Choosing a mode](crate::guide::modes#the-interpolants-and-their-rounding) adds up the rounding errors of each
//! mode.
//!
//! Tests, beside the code: exact reciprocals in `src/num/reciprocal.rs`, a Newton step in `src/num/wide/divide.rs`,
//! pieces in `src/span/pieces.rs`. All modes are compared with a model in `f64` in `accuracy/promises.rs`.
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
#![doc = diagram!("look_at")]
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
//! parallel lines stay parallel. It is translate · scale, the product [above](#a-matrix) without *P*:
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
#![doc = diagram!("parallel")]
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
//!
//! # Time
//!
//! **A motion that repeats once a second is *f*(*t*) = sin 2π*t***, with *t* in seconds. A rate of *m* turns per minute
//! is
//!
#![doc = formula!({frac(2 var "π" m)(60 dot 1000)})]
//!
//! radians per millisecond: 0.00105 for ten turns per minute.
//!
#![doc = diagram!("sine")]
//!
//! An [`Angle`](crate::Angle) counts units of 2⁻³² of a turn in 32 bits, which wrap at a whole turn. A program can
//! compute an angle from the time since the start (absolute), or add a step for each frame (incremental). If the
//! program adds rounded steps, the rounding errors add up: 16 ms at ten turns per minute are 11,453,246.12 units, so
//! each frame loses 0.12 of a unit. [`Rate::angle_at`](crate::Rate::angle_at) is absolute: it multiplies rate and time
//! as integers, drops whole turns, and rounds once. [`Spin`](crate::Spin) is incremental: it adds exact fractions of a
//! turn, and rounds only the result. Both give the same bits at any time, for frames of any length.
//!
//! ```
//! use fixel::{Angle, Fraction, Rate, deg};
//!
//! assert_eq!(Rate::hertz(1).angle_at(250).sin(), Fraction::ONE); // sin 2πt at a quarter
//! let rate = Rate::rpm(10);
//! let radians = f64::from(rate.angle_at(1).to_bits()) / 2_f64.powi(32) * std::f64::consts::TAU;
//! assert!((radians - 0.001_047_2).abs() < 1e-8);
//! assert_eq!(rate.angle_at(1_500), deg!(90));
//! assert_eq!(rate.angle_at(30 * 24 * 3_600_000 + 1_500), deg!(90)); // 30 days later
//!
//! let (mut spin, mut rounded) = (rate.spin(), Angle::ZERO);
//! for _ in 0..375 * 600 { // an hour: 600 turns of 375 frames of 16 ms
//!     spin.advance(16);
//!     rounded += rate.angle_at(16);
//! }
//! assert_eq!(spin.angle(), Angle::ZERO);
//! assert_eq!(rounded, -Angle::from_bits(27_600)); // and growing
//! ```
//!
//! Tests: `accuracy/formulas/time.rs`.
