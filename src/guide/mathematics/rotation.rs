//! Rotation: turns about any axis, quaternions, and turns that do not drift.
//!
//! The [first page](crate::guide::mathematics) of this chapter says where the axes x, y and z point.
//!
//! # A turn
//!
//! **Rodrigues' formula turns a vector *v* by an angle θ about an axis *u* of length one:**
//!
#![doc = formula!(
    {prime(v) = fun cos var "θ" v + fun sin var "θ" (u times v) + (1 - fun cos var "θ") (u dot v) u}
)]
//!
//! Split *v* into two parts. The part *p* = (*u* · *v*) *u* lies along the axis and stays as it is. The rest, *r* = *v*
//! − *p*, is at right angles to the axis. The vector *b* = *u* × *v* is as long as *r*, and is at right angles to the
//! axis and to *r*. Seen from the tip of the axis, *b* is *r* after a quarter of a turn counter-clockwise. So *r* turns
//! in the plane of *r* and *b*:
//!
#![doc = include_str!("../diagrams/turn.svg")]
//!
#![doc = formula!(
    {prime(v) = p + fun cos var "θ" r + fun sin var "θ" b}
    {p = (u dot v) u} {r = v - p} {b = u times v}
)]
//!
//! Insert *p* and *r*, and collect the terms with *v*. The result is Rodrigues' formula.
//!
//! By hand: the axis (3, 0, 4) has the length 5, so *u* = (0.6, 0, 0.8). For *v* = (5, 5, 0), *u* · *v* = 3. Then *p* =
//! (1.8, 0, 2.4), *r* = (3.2, 5, −2.4) and *b* = (−4, 4, 3). The result always has the length of *v*, √50:
//!
//! | θ | *v*′ | x | y | z |
//! |---:|---|---:|---:|---:|
//! | 0° | *p* + *r* | 5.0 | 5.0 | 0.0 |
//! | 90° | *p* + *b* | −2.2 | 4.0 | 5.4 |
//! | 180° | *p* − *r* | −1.4 | −5.0 | 4.8 |
//! | 270° | *p* − *b* | 5.8 | −4.0 | −0.6 |
//!
//! **The matrix of a turn** has the turned axes of the model as its columns. With *c* = cos θ, *s* = sin θ, *k* = 1 −
//! *c* and *u* = (*x*, *y*, *z*):
//!
#![doc = formula!({R = matrix(
    [c + k x^2]   [k x y - s z] [k x z + s y];
    [k x y + s z] [c + k y^2]   [k y z - s x];
    [k x z - s y] [k y z + s x] [c + k z^2]
)})]
//!
//! ```
//! use fixel::prelude::*;
//!
//! let turned = |degrees| Transform::rotate(vec3!(3, 0, 4), Angle::from_degrees(degrees));
//! assert_eq!(turned(90)?.point(vec3!(5, 5, 0)), vec3!(-2.2, 4, 5.4));
//! assert_eq!(turned(180)?.point(vec3!(5, 5, 0)), vec3!(-1.4, -5, 4.8));
//! // A third of a turn about (1, 1, 1): c = −½, k = 1.5, s = √¾, and x² = ⅓.
//! let third = Transform::rotate(vec3!(1, 1, 1), deg!(120))?.to_matrix();
//! let [zero, one] = [fx!(0), fx!(1)];
//! assert_eq!(third.rows()[0], [zero, zero, one, zero]);
//! assert_eq!(third.rows()[1], [one, zero, zero, zero]);
//! assert_eq!(third.rows()[2], [zero, one, zero, zero]);
//! # Ok::<(), Error>(())
//! ```
//!
//! Tests: `accuracy/formulas/rotation.rs`.
//!
//! # A quaternion
//!
//! **A quaternion of length one stores a turn in four numbers, and a product of quaternions is one turn after
//! another.** A quaternion has a number *w* and a vector *g* = (*x*, *y*, *z*). Quaternions are multiplied by this
//! rule:
//!
#![doc = formula!({(w[1], g[1]) (w[2], g[2]) = (w[1] w[2] - g[1] dot g[2], w[1] g[2] + w[2] g[1] + g[1] times g[2])})]
//!
//! The turn by θ about *u* uses the cosine *c* and the sine *s* of **half the angle**. Write *v* as a quaternion with
//! the number 0. Multiply it by *q* from the left, and by the conjugate of *q* from the right:
//!
#![doc = formula!({q = (c, s u)} {q^{*} = (c, -s u)} {(0, prime(v)) = q (0, v) q^{*}})]
//!
//! To see that *v*′ is the turned vector, multiply. The first product, *q* (0, *v*), is (−*s* *u* · *v*, *c* *v* + *s*
//! *u* × *v*). In the second product, the number is zero, because *u* × *v* is at right angles to *u*. The vector is
//!
#![doc = formula!({prime(v) = s^2 (u dot v) u + c^2 v + 2 c s (u times v) - s^2 (u times v) times u})]
//!
//! and (*u* × *v*) × *u* = *v* − (*u* · *v*) *u*, the part of *v* at right angles to *u*. So
//!
#![doc = formula!({prime(v) = (c^2 - s^2) v + 2 c s (u times v) + 2 s^2 (u dot v) u})]
//!
//! The identities for double angles are *c*² − *s*² = cos θ, 2*cs* = sin θ and 2*s*² = 1 − cos θ. With them, the last
//! formula becomes Rodrigues' formula. The quaternion stands on both sides of *v*, so each side contributes half the
//! angle. In −*q*, the two signs cancel: *q* and −*q* are the same turn.
//!
//! **The product *q*₂*q*₁ turns by *q*₁ first.** The conjugate of a product is the product of the conjugates in reverse
//! order, so (*q*₂*q*₁) *v* (*q*₂*q*₁)\* = *q*₂ (*q*₁ *v* *q*₁\*) *q*₂\*.
//!
//! By hand: a quarter turn about x, and then a quarter turn about y. The sine and the cosine of half of 90° are equal,
//! so *q*₁ = (1, 1, 0, 0)/√2 and *q*₂ = (1, 0, 1, 0)/√2, with *w* first. By the rule, *q*₂*q*₁ = (1, 1, 1, −1)/2: the
//! last number comes from y × x = −z. The product's *w* is ½, the cosine of half its angle. So half the angle is 60°,
//! and the two quarter turns are **a third of a turn about (1, 1, −1)**.
//!
//! ```
//! use fixel::prelude::*;
//!
//! let one_after_another = Transform::rotate_y(deg!(90)) * Transform::rotate_x(deg!(90));
//! // Here w is last. The length does not matter: the crate divides by it.
//! let product = Transform::from_quaternion([fx!(1), fx!(1), fx!(-1), fx!(1)])?;
//! let opposite = Transform::from_quaternion([fx!(-1), fx!(-1), fx!(1), fx!(-1)])?;
//! let third = Transform::rotate(vec3!(1, 1, -1), deg!(120))?;
//! for turn in [one_after_another, product, opposite, third] {
//!     assert_eq!(turn.point(vec3!(1, 2, 3)), vec3!(2, -3, -1));
//! }
//! # Ok::<(), Error>(())
//! ```
//!
//! A product of quaternions takes 16 multiplications, and a product of matrices takes 27. To turn many points, make the
//! matrix first: a point then takes 9 multiplications. Rounding makes a quaternion longer or shorter, and a division by
//! its length repairs it. [`Transform::rotate`](crate::Transform::rotate) makes its matrix from |*a*| *q* = (|*a*| *c*,
//! *s* *a*), so the axis *a* may have any length. It does not scale the axis to length one, because the rounded axis
//! would stretch a model. If a matrix is multiplied by turns again and again, rounding makes its columns lose their
//! right angles; [`Transform::renormalized`](crate::Transform::renormalized) repairs them.
//!
//! Tests: `accuracy/formulas/rotation.rs`.
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
#![doc = include_str!("../diagrams/sine.svg")]
//!
//! An [`Angle`](crate::Angle) counts units of 2⁻³² of a turn in 32 bits, which wrap at a whole turn. A program can
//! compute an angle from the time since the start (absolute), or add a step for each frame (incremental). If the
//! program adds rounded steps, the rounding errors add up: 16 ms at ten turns per minute are 11,453,246.12 units, so
//! each frame loses 0.12 of a unit. [`Rate::angle_at`](crate::Rate::angle_at) is absolute: it multiplies rate and time
//! as integers, drops whole turns, and rounds once. So its result is equally exact at any time, for frames of any
//! length.
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
//! let mut sum = Angle::ZERO;
//! for _ in 0..375 * 600 { // an hour: 600 turns of 375 frames of 16 ms
//!     sum += rate.angle_at(16);
//! }
//! assert_eq!(rate.angle_at(3_600_000), Angle::ZERO);
//! assert_eq!(sum, -Angle::from_bits(27_600)); // 0.002 degrees, and growing
//! ```
//!
//! Tests: `accuracy/formulas/time.rs`.
//!
//! Next page: [A camera](crate::guide::mathematics::camera#a-camera).
#![cfg_attr(doc, doc = include_str!("../tables.html"))]
