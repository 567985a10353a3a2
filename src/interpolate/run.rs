//! A run of pixels: the values at its start, and the steps.

/// Pixels that are stepped over before the values are found afresh.
///
/// A step is rounded to half a unit of 2⁻³⁰, so a run adds at most 32 units.
pub(crate) const RUN: u32 = 64;

/// Interpolants of a short run of pixels: their values at the first and what to add per pixel.
///
/// `q` is 1/w (or, under a parallel projection, depth), scaled so that its largest value in the
/// triangle has bit 30 set. `p[i]` is attribute · q · 2^-[`bits`](Self::bits)`[i]`, so that
/// |p| ≤ q/2 but for rounding.
#[derive(Clone, Copy, Debug)]
pub struct Run<const N: usize> {
    /// 1/w or depth at the first pixel.
    pub q: u32,
    /// Its step per pixel.
    pub dq: i32,
    /// Attributes over w at the first pixel.
    pub p: [i32; N],
    /// Their steps per pixel.
    pub dp: [i32; N],
    /// By how many bits each attribute was shifted down, 1 to 32.
    pub bits: [u32; N],
}

impl<const N: usize> Run<N> {
    /// Goes on to the next pixel.
    ///
    /// Values wrap: a step beyond `i32` belongs to a sliver one pixel wide, whose next pixel is
    /// never looked at.
    #[inline]
    pub fn step(&mut self) {
        self.q = self.q.wrapping_add_signed(self.dq);
        for (p, dp) in self.p.iter_mut().zip(self.dp) {
            *p = p.wrapping_add(dp);
        }
    }
}

/// What is to be done with the pixels of a run, each of which is a `T`.
pub trait Pixels<T, const N: usize> {
    /// Whether the next pixel is visible at depth `q` (see [`Run::q`]); called once per pixel, in order.
    fn visible(&mut self, pixel: &T, q: u32) -> bool;

    /// Colours the pixel that was last found visible.
    fn shade(&mut self, pixel: T, q: u32, varyings: [i32; N]);
}

/// The attributes of a primitive's corners, weighted by their 1/w and scaled to fit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weighted<const N: usize, const CORNERS: usize> {
    /// Attribute · weight · 2^-bits, per attribute and corner.
    pub(crate) p: [[i32; CORNERS]; N],
    /// How far each attribute was shifted down, 1 to 32.
    pub(crate) bits: [u32; N],
}

impl<const N: usize, const CORNERS: usize> Weighted<N, CORNERS> {
    /// Weights below 2³¹, one per corner.
    #[inline]
    pub(crate) fn new(attributes: &[[i32; N]; CORNERS], weights: [u32; CORNERS]) -> Self {
        let mut weighted = Self {
            p: [[0; CORNERS]; N],
            bits: [1; N],
        };
        for (i, (p, bits)) in weighted.p.iter_mut().zip(&mut weighted.bits).enumerate() {
            let values = attributes.map(|corner| corner.get(i).copied().unwrap_or(0));
            let size = values
                .iter()
                .fold(0, |all, value| all | value.unsigned_abs());
            *bits = (33 - size.leading_zeros()).min(32);
            for ((p, value), weight) in p.iter_mut().zip(values).zip(weights) {
                let product = i64::from(value) * i64::from(weight);
                // |value| ≤ 2^(bits-1), so the quotient is at most half the weight; the half makes it the nearest.
                *p = ((product + (1 << *bits >> 1)) >> *bits) as i32;
            }
        }
        weighted
    }
}
