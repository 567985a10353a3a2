//! Time: turns that do not drift.
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
