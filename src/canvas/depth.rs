//! The depth buffer, or its absence, and how it encodes a depth in 16 bits.

use crate::num::wide::normalize;
use crate::sealed::Sealed;

/// A canvas's depth buffer: [`NoDepth`], or 16 bits per pixel in the format [`LinearDepth`], [`FloatDepth`] or
/// [`WideFloatDepth`]. Sealed.
///
/// A fragment is drawn if it is at least as near as the stored depth. Therefore, if two fragments have the same depth,
/// the later fragment is visible. A depth of 65535 is the near plane, and a depth of 0 is infinitely far.
///
#[cfg_attr(doc, doc = include_str!("../guide/diagrams/depth.svg"))]
///
/// Depths have one of three formats. In every format, a nearer depth is a greater number, so the depth test is the same
/// comparison in all of them. The formats differ in cost, and in the ratio far/near that they resolve. A step is the
/// distance in space between two surfaces with consecutive stored depths. The table lists the greatest step at the far
/// plane, in percent of the far plane's distance. "None" means that every depth at the far plane is stored as 0.
///
/// | far / near | [`LinearDepth`] | [`FloatDepth`] | [`WideFloatDepth`] |
/// |---:|---:|---:|---:|
/// | 100 | 0.15 % | 0.024 % | 0.049 % |
/// | 500 | 0.76 % | 0.024 % | 0.049 % |
/// | 1,000 | 1.5 % | 0.024 % | 0.049 % |
/// | 10,000 | 15 % | 0.024 % | 0.049 % |
/// | 65,536 | none | 0.024 % | 0.049 % |
/// | 1,000,000 | none | none | 0.049 % |
///
/// Surfaces that are closer together than a step may have equal depths. The surface that is drawn later is then
/// visible, even if it is the farther one. Therefore, use [`LinearDepth`] up to a ratio of 500, [`FloatDepth`] up to
/// 65,536, and [`WideFloatDepth`] beyond: see [Depth](crate::guide::concepts#depth).
///
/// Under a parallel projection, depth falls linearly with the distance, so use [`LinearDepth`]. Shaders see the same
/// linear [`Fragment::depth`](crate::Fragment::depth) with every format.
///
/// Use the trait as the bound of code that draws with any depth buffer, or with none:
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// use fixel::canvas::DepthBuffer;
///
/// fn draw<D: DepthBuffer>(canvas: &mut Canvas<'_, Gray8, Native, D>) {
///     canvas.clear(Gray8::new(0));
/// }
///
/// let (mut pixels, mut depths) = ([Gray8::new(9); 4], [7; 4]);
/// draw(&mut Canvas::new(&mut pixels, 2, 2)?);
/// draw(&mut Canvas::new(&mut pixels, 2, 2)?.with_depth(&mut depths)?);
/// assert_eq!(depths, [0; 4]);
/// # Ok::<(), Error>(())
/// ```
#[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
pub trait DepthBuffer: Sealed {
    /// Whether the canvas keeps depths, to be tested and stored.
    #[doc(hidden)]
    const IS_KEPT: bool = true;

    /// Encodes the depth `q` · 2^-`down` in 16 bits, rounded down. A nearer depth has a greater code.
    ///
    /// The near plane has a depth of 2^16, and infinity has a depth of 0. `q` has 31 bits; `down` is at least 15.
    #[doc(hidden)]
    fn encode(q: u32, down: u32) -> u32;

    /// Iterates over the stored depths of pixels. If no depths are kept, the iterator returns `None` for every pixel,
    /// without end.
    #[doc(hidden)]
    #[inline]
    fn each(depths: &mut [u16]) -> impl Iterator<Item = Option<&mut u16>> {
        depths.iter_mut().map(Some)
    }
}

/// No depth buffer: later fragments cover earlier fragments.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::canvas::{Canvas, Native, NoDepth};
/// let mut pixels = [Gray8::new(0); 4];
/// let canvas: Canvas<Gray8, Native, NoDepth> = Canvas::new(&mut pixels, 2, 2)?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NoDepth {}

/// Depth in equal steps of 1/w, where w is the distance: the stored number is floor(65535 · near / w). The default.
///
/// `LinearDepth` is the finest format at distances up to 8 · near, and the coarsest at 16 · near and beyond. At a
/// distance w, a step is w / (65535 · near) of this distance. Keep the far plane at most 500 times as far away as the
/// near plane: see [the rule](crate::guide::concepts#depth).
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::canvas::{Canvas, LinearDepth, Native};
/// let (mut pixels, mut depths) = ([Gray8::new(0); 4], [0; 4]);
/// let canvas: Canvas<Gray8, Native, LinearDepth> =
///     Canvas::new(&mut pixels, 2, 2)?.with_depth(&mut depths)?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LinearDepth {}

/// Depth in floating point, with 4 bits of exponent and 12 of mantissa, for a ratio far/near of up to 65,536.
///
/// A step is 2⁻¹³ to 2⁻¹² of the distance (0.012 to 0.024 %) everywhere in the range, because each doubling of the
/// distance lowers the stored depth by 4096. If a surface is at least 65,536 times as far away as the near plane, its
/// depth is stored as 0.
///
/// Within one triangle, 1/distance is interpolated with an error of at most 2⁻²⁴ of its largest value. In tests, the
/// depth is off by at most half a step at pixels up to 3,000 times as far away as the triangle's near end.
///
/// On Cortex-M4, a tested fragment takes 7 to 9 instructions more than with [`LinearDepth`]. In the default mode,
/// drawing the benchmark's floor, cube and sphere takes 12 to 26 % more instructions. On Cortex-M0+, which has no
/// instruction that counts leading zeros, a fragment takes 9 to 19 instructions more, and these scenes 18 to 32 % more.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::canvas::{Canvas, FloatDepth};
/// let (mut pixels, mut depths) = ([Gray8::new(0); 4], [0; 4]);
/// let mut canvas = Canvas::new(&mut pixels, 2, 2)?.with_depth_format::<FloatDepth>(&mut depths)?;
/// canvas.clear(Gray8::new(0));
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FloatDepth {}

/// Depth in floating point, with 5 bits of exponent and 11 of mantissa, for every ratio far/near that a
/// [`Projection`](crate::Projection) accepts.
///
/// A step is 2⁻¹² to 2⁻¹¹ of the distance (0.024 to 0.049 %), up to a distance of 2³² · near. These steps are twice as
/// coarse as the steps of [`FloatDepth`], at the same cost.
///
/// Within one triangle, 1/distance is interpolated with an error of at most 2⁻²⁴ of its largest value. In tests, the
/// depth is off by at most half a step at pixels up to 6,000 times as far away as the triangle's near end.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::canvas::{Canvas, WideFloatDepth};
/// let (mut pixels, mut depths) = ([Gray8::new(0); 4], [0; 4]);
/// let mut canvas = Canvas::new(&mut pixels, 2, 2)?.with_depth_format::<WideFloatDepth>(&mut depths)?;
/// canvas.clear(Gray8::new(0));
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum WideFloatDepth {}

impl Sealed for NoDepth {}
impl Sealed for LinearDepth {}
impl Sealed for FloatDepth {}
impl Sealed for WideFloatDepth {}

impl DepthBuffer for NoDepth {
    const IS_KEPT: bool = false;

    #[inline]
    fn encode(q: u32, down: u32) -> u32 {
        LinearDepth::encode(q, down)
    }

    #[inline]
    fn each(_: &mut [u16]) -> impl Iterator<Item = Option<&mut u16>> {
        // This is an iterator over a slice, because a loop over two zipped slices has only one check for the end.
        const ANY: &[()] = &[(); usize::MAX];
        ANY.iter().map(|()| None)
    }
}

impl DepthBuffer for LinearDepth {
    #[inline]
    fn encode(q: u32, down: u32) -> u32 {
        // `q` has 31 bits, so a shift by 31 already makes it 0.
        q >> down.min(31)
    }
}

impl DepthBuffer for FloatDepth {
    #[inline]
    fn encode(q: u32, down: u32) -> u32 {
        float::<4>(q, down)
    }
}

impl WideFloatDepth {
    /// The least depth of a code, as a number q that means the depth q · 2^-`down`; limited to at most 2^31 - 1.
    pub(crate) fn decode(code: u32, down: u32) -> u32 {
        // The depth is (2^11 + m) · 2^(e - 11), where m is the code's mantissa, and e is its exponent minus 16 (see
        // `float`).
        let (exponent, mantissa) = (code >> 11, code & 0x7ff | 1 << 11);
        let up = (exponent + down).cast_signed() - 27;
        if up > 19 {
            return i32::MAX.cast_unsigned();
        }
        if up < 0 {
            return mantissa >> up.unsigned_abs().min(31);
        }
        mantissa << up
    }
}

impl DepthBuffer for WideFloatDepth {
    #[inline]
    fn encode(q: u32, down: u32) -> u32 {
        float::<5>(q, down)
    }
}

// With 16 bits for 32 octaves, a logarithm would be the finest code: the approximation log2(1 + m) ≈ m + 0.344 m (1 −
// m) gives steps of 0.036 % instead of 0.049 %. But per textured fragment, a logarithm takes 23 instructions more than
// `LinearDepth` on Cortex-M4, where a float takes 7 more. On Cortex-M0+, a logarithm takes 24 instructions more, and a
// float takes 13 more. Surfaces that are 1 % apart do not need a logarithm.
/// Encodes a depth as a float with `EXPONENT` bits of exponent and 16 − `EXPONENT` bits of mantissa.
///
/// Let the depth be 2^e · 1.m, where m stands for the mantissa's bits. The greatest exponent code stands for e = 15,
/// because the near plane is 2^16 and depths are below it. So the least exponent that is stored is e = 16 − 2^EXPONENT.
#[inline]
fn float<const EXPONENT: u32>(q: u32, down: u32) -> u32 {
    let mantissa = 16 - EXPONENT;
    // Let zeros be the number of leading zeros of q. Shifted left by zeros, q is the mantissa in 32 bits, and e = 31 −
    // zeros − down. So the exponent's code is e − (16 − 2^EXPONENT) = 15 + 2^EXPONENT − zeros − down. The mantissa
    // keeps its top bit, which adds 1 to this code, and `normalize` adds another 1, so the bias is 2 less.
    let bias = 13 + (1 << EXPONENT);
    let exponent = u32::wrapping_sub(bias, down) << mantissa;
    let (normal, exponent) = normalize(q, exponent, mantissa);
    let code = (normal >> (31 - mantissa)).wrapping_add(exponent);
    // A depth below the least exponent gives a negative code, and is stored as 0.
    code.cast_signed().max(0).cast_unsigned()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest shift that the tests use; it reaches beyond the range of the wide format.
    const MOST_DOWN: u32 = 63;

    /// Checks, for every code at every shift, the least depth that has this code, and the depth just below. So codes
    /// rise with 1/w, and a value of 1/w has the same code in triangles of any scale.
    fn codes_rise<F: DepthBuffer, const EXPONENT: u32>() {
        let mantissa = 16 - EXPONENT;
        for code in 0..=0xffff_u32 {
            // The least depth of a code is (2^mantissa + m) · 2^(e - mantissa).
            let least = u128::from((1 << mantissa) + (code & ((1 << mantissa) - 1)));
            let e = (code >> mantissa).cast_signed() + 16 - (1 << EXPONENT);
            for down in 15..=MOST_DOWN {
                let up = e - mantissa.cast_signed() + down.cast_signed();
                let q = u32::try_from(up).ok().map(|up| least << up);
                let q = q.and_then(|q| u32::try_from(q).ok());
                let Some(q) = q.filter(|q| q >> 31 == 0) else {
                    continue;
                };
                assert_eq!(F::encode(q, down), code, "{q} >> {down}");
                // If q has fewer bits than a mantissa, the code of q − 1 may be lower by two.
                if q > 1 << mantissa {
                    let before = code.saturating_sub(1);
                    assert_eq!(F::encode(q - 1, down), before, "{q} - 1 >> {down}");
                }
            }
        }
        assert_eq!(F::encode((1 << 31) - 1, 15), 0xffff);
    }

    #[test]
    fn float_codes_rise_with_the_interpolant() {
        codes_rise::<FloatDepth, 4>();
    }

    #[test]
    fn wide_float_codes_rise_with_the_interpolant() {
        codes_rise::<WideFloatDepth, 5>();
    }

    /// A decoded depth is the least depth of its code. Depths that are greater than any number of 31 bits saturate.
    #[test]
    fn decoding_is_the_inverse_of_encoding() {
        for code in (1 << 11)..=0xffff {
            for down in 15..=47 {
                let q = WideFloatDepth::decode(code, down);
                if q == i32::MAX.cast_unsigned() {
                    assert!(WideFloatDepth::encode(q, down) <= code);
                } else if q >> 11 > 0 {
                    assert_eq!(WideFloatDepth::encode(q, down), code);
                    assert!(WideFloatDepth::encode(q - 1, down) < code);
                }
            }
        }
        assert_eq!(WideFloatDepth::decode(0, 15), 0);
    }

    /// Depths below 1 in the narrow formats, and below 2^-16 in the wide format, are encoded as infinitely far at every
    /// shift.
    #[test]
    fn depths_below_the_range_are_zero() {
        for down in 15..=MOST_DOWN {
            for q in [0, 1, 2, 1 << 14, (1 << 31) - 1] {
                let depth = f64::from(q) / 2_f64.powi(down.cast_signed());
                if depth < 1. {
                    assert_eq!(LinearDepth::encode(q, down), 0, "{q} >> {down}");
                    assert_eq!(FloatDepth::encode(q, down), 0, "{q} >> {down}");
                }
                if depth < 1. / 65_536. {
                    assert_eq!(WideFloatDepth::encode(q, down), 0, "{q} >> {down}");
                }
            }
        }
    }

    /// No input panics, not even numbers that no canvas produces.
    #[test]
    fn no_number_panics() {
        for q in [0, 1, 1 << 31, u32::MAX] {
            for down in [0, 14, 32, 1 << 20, u32::MAX] {
                let _ = LinearDepth::encode(q, down);
                let _ = FloatDepth::encode(q, down);
                let _ = WideFloatDepth::encode(q, down);
            }
        }
    }
}
