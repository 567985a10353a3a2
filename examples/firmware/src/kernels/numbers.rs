//! Measures conversions of a sensor's floats.

use core::hint::black_box;

use fixel::prelude::*;
use micromath::Quaternion;

use super::ticks::Stopwatch;

const CALLS: u32 = 256;

/// Measures conversions, and prints the cost of each.
pub fn measure(watch: &mut Stopwatch) -> Result<(), Error> {
    let mut each = |name, call: fn() -> Result<(), Error>| {
        // A call that does nothing takes the time of the loop.
        let loops = time(watch, || black_box(Ok(())))?;
        let ticks = time(watch, call)?;
        watch.print(name, "number", CALLS, ticks - loops);
        Ok::<_, Error>(())
    };
    each("scalar-from-f32", || {
        let number = Scalar::try_from(black_box(-1.234_567_f32))?;
        black_box(number);
        Ok(())
    })?;
    each("scalar-to-f32", || {
        black_box(f32::from(black_box(fx!(-1.234_567))));
        Ok(())
    })?;
    each("angle-from-degrees", || {
        black_box(Angle::try_from_degrees(black_box(-123.456_7_f32))?);
        Ok(())
    })?;
    each("angle-from-radians", || {
        black_box(Angle::try_from_radians(black_box(-2.345_678_f32))?);
        Ok(())
    })?;
    each("transform-from-quaternion", || {
        let turn = Quaternion::new(0.182_57, -0.365_15, 0.547_72, 0.730_3);
        black_box(&Transform::try_from(black_box(turn))?);
        Ok(())
    })?;
    each("transform-rotate", || {
        let (axis, angle) = black_box((vec3!(1, 2, 3), deg!(40)));
        black_box(&Transform::rotate(axis, angle)?);
        Ok(())
    })
}

/// Returns the ticks of many calls.
fn time(watch: &mut Stopwatch, call: impl Fn() -> Result<(), Error>) -> Result<u64, Error> {
    watch.time(|| (0..CALLS).try_for_each(|_| call()))
}
