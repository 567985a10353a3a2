//! Fixed point: number formats, and the errors that they cause.
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
//! **The entries of a matrix share an exponent** (block floating point): the entries differ in size from scene to
//! scene, but not much within a scene. A product of two mantissas has 60 bits, and 64 bits hold the sum of three
//! products. The example rotates a point by a thousandth of a degree: first by a matrix whose entries share an
//! exponent, then by one whose entries have the fixed unit 2⁻¹⁶:
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
//! From one pixel to the next, *Q* changes by a small fraction δ of its value. The reciprocal at the previous pixel is
//! a guess with a relative error of δ, and one step (two products) reduces the error to δ². The mode
//! [`Newton`](crate::mode::Newton) takes its guess from the line through the previous two reciprocals instead. This
//! guess has an error of about 2δ², and the step reduces the error to 4δ⁴.
//!
//! ```
//! // 1/w at two pixels; δ is 1/64. Reciprocals are in units of 2⁻⁶¹.
//! let (last, q) = (3_u32 << 29, (3_u32 << 29) + (3 << 23));
//! let error = |r: f64| 1.0 - f64::from(q) * r / 2_f64.powi(61);
//! let guess = (2_f64.powi(61) / f64::from(last)).floor();
//! let step = guess * (1.0 + error(guess));
//! assert!((error(guess) + 1.0 / 64.0).abs() < 1e-9);
//! assert!((error(step) - 1.0 / 4096.0).abs() < 1e-9);
//! ```
//!
//! **If straight pieces replace a curve, only the ends of the pieces need reciprocals.** The curve along a row is *a* =
//! *P*/*Q*, where *P* and *Q* are linear. Let a dot over a letter mean its change per pixel. Differentiate *aQ* = *P*
//! twice:
//!
#![doc = formula!(
    {dotted(a) Q + a dotted(Q) = dotted(P)}
    {twice_dotted(a) Q + 2 dotted(a) dotted(Q) = 0}
    {|twice_dotted(a)| = 2 |dotted(a)| var "δ"}
)]
//!
//! A straight piece over *L* pixels is a chord of the curve. Its error is at most |*ȧ*| δ *L*²/4, an eighth of *L*²
//! times the second derivative. The mode [`Fast`](crate::mode::Fast) uses the longest pieces that keep this error below
//! your tolerance.
//!
#![doc = include_str!("../diagrams/pieces.svg")]
//!
//! ```
//! use fixel::{Fraction, fx, textbook::Segment};
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
//! The page [Choosing a mode](crate::guide::modes#the-interpolants-and-their-rounding) adds up the rounding errors of
//! each mode.
//!
//! Unit tests: exact reciprocals in `src/num/reciprocal.rs`, a Newton step in `src/num/wide/divide.rs`, pieces in
//! `src/span/pieces.rs`. All modes are compared with a model in `f64` in `accuracy/promises.rs`.
#![cfg_attr(doc, doc = include_str!("../tables.html"))]
