//! Lines in perspective: where parallel lines meet, how equal steps shrink, and what lies halfway.
//!
//! The [first page](crate::guide::mathematics) of this chapter says where the axes x, y and z point, and defines the
//! letters *n* and *f*.
//!
//! # Lines
//!
//! **The image of a line is a line.** The eye and a line that does not pass through it span a plane. All lines of sight
//! to points of the line lie in that plane, and that plane cuts the near plane in a line.
//!
//! For what follows, a line is *P* + *t* *v*, with a point *P*, a direction *v* and a number *t*.
//!
//! **Lines parallel to the picture keep their slope.** If *v<sub>z</sub>* = 0, then *z* is *P<sub>z</sub>* all along
//! the line. Both coordinates are multiplied by the same number, −*n*/*P<sub>z</sub>*, and the image keeps the slope
//! *v<sub>y</sub>*/*v<sub>x</sub>*.
//!
//! **Parallel lines of any other direction meet in one vanishing point.** As *t* grows, *P* no longer matters:
//!
#![doc = formula!(
    {prime(x) = -n frac(P[x] + t v[x])(P[z] + t v[z]) to -n frac(v[x])(v[z])}
    {prime(y) to -n frac(v[y])(v[z])}
)]
//!
//! The vanishing point is also the image of the point *v* (or of −*v*, if *v* points backward), because the line of
//! sight to a vanishing point is parallel to the lines that meet there.
//! [`Projection::vanishing_point`](crate::Projection::vanishing_point) computes the vanishing point.
//!
//! ```
//! use fixel::prelude::*;
//! use fixel::Window;
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
#![doc = include_str!("../diagrams/rails.svg")]
//!
//! The rails have the direction −z. The crossties are parallel to x and stay level.
//!
//! ```
//! use fixel::{fx, textbook::speed, vec3};
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
#![doc = include_str!("../diagrams/vanishing_points.svg")]
//!
//! ```
//! use fixel::prelude::*;
//! use fixel::Window;
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
#![doc = include_str!("../diagrams/foreshortening.svg")]
//!
//! The point at *t* is a mean of the segment's ends, with the weights 1 − *t* and *t*. Its distance *w* is the mean of
//! *w*₀ and *w*₁ with the same weights. The point's image is *nx*/*w*; at the ends, *nx* = *wx*′:
//!
#![doc = formula!(
    {prime(x) = frac((1 - t) n x[0] + t n x[1])((1 - t) w[0] + t w[1])}
    {= frac((1 - t) w[0] prime(x[0]) + t w[1] prime(x[1]))((1 - t) w[0] + t w[1])}
)]
//!
//! So *x*′ is a mean of the images of the ends. The weight of the second image is *q*:
//!
#![doc = formula!(
    {q = frac(t w[1])(w[0] + t (w[1] - w[0]))}
    {frac(q)(1 - q) = frac(t)(1 - t) dot frac(w[1])(w[0])}
)]
//!
//! The last equation stays true if you exchange *t* with *q*, and *w*₀ with *w*₁. Therefore
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
//! The derivation uses only that *w* and *wx*′ are linear in space. Therefore the result also holds after any matrix,
//! if *w* is the fourth homogeneous coordinate. Textbooks write *f* for the fraction on the screen and *g* for the
//! fraction in space:
//!
#![doc = formula!({g = frac(f)(fun lerp (w[1] / w[0], 1, f))} {a = fun lerp (a[0], a[1], g)})]
//!
//! [`Segment`](crate::textbook::Segment) computes all of these values:
//!
//! ```
//! use fixel::{Fraction, fx, textbook::Segment};
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
//! division on purpose; [a formula](crate::guide::modes#affine) gives its error.
//!
//! </div>
//!
//! Tests: `accuracy/formulas/segment.rs`.
//!
//! Next page: [An edge](crate::guide::mathematics::triangles#an-edge).
