//! Numbers of every magnitude. The ends of a format, and small numbers on a grid, are frequent.

use arbitrary::{Result, Unstructured};
use fixel::prelude::*;

/// The bits of a number of any magnitude.
pub fn bits(u: &mut Unstructured<'_>) -> Result<i32> {
    const ENDS: [i32; 9] = [
        0,
        1,
        -1,
        1 << 16,
        -(1 << 16),
        i32::MAX,
        i32::MIN,
        i32::MAX - 1,
        i32::MIN + 1,
    ];
    Ok(match u.int_in_range(0..=7)? {
        0 => u.arbitrary()?,
        1 => u.arbitrary::<i32>()? >> u.int_in_range(0..=31)?,
        2 => *u.choose(&ENDS)?,
        // Multiples of 1/16 within ±8, in 16.16, so that some numbers are equal and some points are collinear.
        3 => i32::from(u.arbitrary::<i8>()?) << 12,
        _ => i32::from(u.arbitrary::<i16>()?) << 4,
    })
}

pub fn scalar(u: &mut Unstructured<'_>) -> Result<Scalar> {
    bits(u).map(Scalar::from_bits)
}

/// The absolute value of a number. The value is rarely 0.
pub fn size(u: &mut Unstructured<'_>) -> Result<Scalar> {
    Ok(scalar(u)?.abs())
}

/// The bits of a number within ±8, in 16.16.
fn small(u: &mut Unstructured<'_>) -> Result<i32> {
    Ok(i32::from(u.arbitrary::<i16>()?) << 4)
}

/// A vector, mostly near the origin.
pub fn vector(u: &mut Unstructured<'_>) -> Result<Vec3> {
    Ok(Vec3::from_bits(if u.ratio(1, 8)? {
        [bits(u)?, bits(u)?, bits(u)?]
    } else {
        [small(u)?, small(u)?, small(u)?]
    }))
}

/// Scale factors, mostly multiples of 1/32 between −4 and 4.
pub fn factors(u: &mut Unstructured<'_>) -> Result<Vec3> {
    if u.ratio(1, 8)? {
        return vector(u);
    }
    let [x, y, z] = u.arbitrary::<[i8; 3]>()?;
    Ok(Vec3::from_bits([x, y, z].map(|x| i32::from(x) << 11)))
}

pub fn tex_coords(u: &mut Unstructured<'_>) -> Result<Vec2> {
    // A texture coordinate has 20 fraction bits, so these bits mean a sixteenth of their value in 16.16. Some
    // coordinates are therefore within one or two repeats.
    Ok(Vec2::from_bits([bits(u)?, bits(u)?]))
}

pub fn angle(u: &mut Unstructured<'_>) -> Result<Angle> {
    Ok(if u.arbitrary()? {
        Angle::from_bits(u.arbitrary()?)
    } else {
        // The angles are multiples of 1/32 turn. Right angles are among them.
        Angle::from_bits(u32::from(u.arbitrary::<u8>()?) << 27)
    })
}

/// A list of up to `most` values.
pub fn list<T>(
    u: &mut Unstructured<'_>,
    most: usize,
    one: impl Fn(&mut Unstructured<'_>) -> Result<T>,
) -> Result<Vec<T>> {
    let count = u.int_in_range(0..=most)?;
    few(u, count, one)
}

/// A list of a few values.
pub fn few<T>(
    u: &mut Unstructured<'_>,
    count: usize,
    one: impl Fn(&mut Unstructured<'_>) -> Result<T>,
) -> Result<Vec<T>> {
    (0..count).map(|_| one(u)).collect()
}

/// A value, or `None`.
pub fn option<T>(
    u: &mut Unstructured<'_>,
    one: impl FnOnce(&mut Unstructured<'_>) -> Result<T>,
) -> Result<Option<T>> {
    if u.arbitrary()? {
        one(u).map(Some)
    } else {
        Ok(None)
    }
}
