//! Dot products, and the rows of matrices that are multiplied by many positions.

use super::IS_NARROW;
use super::product::{of_halves, product};

/// Returns the dot product, which must fit in 64 bits: mantissas of 30 bits times numbers of 31 bits do.
#[inline]
pub(crate) fn dot(a: &[i32; 3], b: &[i32; 3]) -> i64 {
    if IS_NARROW {
        narrow_dot(a, b)
    } else {
        product(a[0], b[0]) + product(a[1], b[1]) + product(a[2], b[2])
    }
}

/// Out of line, because a copy would be longer than the call.
#[inline(never)]
fn narrow_dot(a: &[i32; 3], b: &[i32; 3]) -> i64 {
    a.iter().zip(b).map(|(&a, &b)| of_halves(a, b)).sum()
}

/// A row of coefficients of at most 2^29, for dot products with many positions.
#[cfg(not(narrow_core))]
pub(crate) type Row = WholeRow;
#[cfg(narrow_core)]
pub(crate) type Row = CutRow;

/// A row of coefficients, without any preparation.
#[cfg(any(test, not(narrow_core)))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct WholeRow([i32; 3]);

#[cfg(any(test, not(narrow_core)))]
impl WholeRow {
    #[inline]
    pub(crate) const fn new(row: [i32; 3]) -> Self {
        Self(row)
    }

    /// The coefficients.
    #[inline]
    pub(crate) const fn whole(&self) -> [i32; 3] {
        self.0
    }

    /// Returns the dot products of three rows with a position, added to `sums`.
    #[inline]
    pub(crate) fn add_dots(
        [a, b, c]: &[Self; 3],
        position: &[i32; 3],
        [x, y, z]: [i64; 3],
    ) -> [i64; 3] {
        [
            x + dot(&a.0, position),
            y + dot(&b.0, position),
            z + dot(&c.0, position),
        ]
    }
}

/// A row that also stores each coefficient as the sum of three parts, in units of 2^20, 2^10 and 1. A part is at most
/// 2^9.
///
/// The product of a part and a number of at most 2^20 takes 30 bits, and the sum of three of these products takes 31.
/// So a dot product takes nine short products in place of twelve, without carries between them.
#[cfg(any(test, narrow_core))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct CutRow {
    whole: [i32; 3],
    parts: [[i32; 3]; 3],
}

/// The greatest coordinate that a [`CutRow`] multiplies by its parts: 16 in model space.
#[cfg(any(test, narrow_core))]
const SMALL: i32 = 1 << 20;

#[cfg(any(test, narrow_core))]
impl CutRow {
    #[inline]
    pub(crate) fn new(whole: [i32; 3]) -> Self {
        let rounded = |a: i32, bits: u32| (a + (1 << bits >> 1)) >> bits;
        let upper = whole.map(|a| rounded(a, 20));
        let middle = whole.map(|a| rounded(a - (rounded(a, 20) << 20), 10));
        let lower = whole.map(|a| a - (rounded(a, 10) << 10));
        Self {
            whole,
            parts: [upper, middle, lower],
        }
    }

    /// The coefficients.
    #[cfg(narrow_core)]
    #[inline]
    pub(crate) const fn whole(&self) -> [i32; 3] {
        self.whole
    }

    /// Returns the dot products of three rows with a position, added to `sums`.
    #[inline]
    pub(crate) fn add_dots([a, b, c]: &[Self; 3], position: &[i32; 3], sums: [i64; 3]) -> [i64; 3] {
        let raised = |x: i32| x.wrapping_add(SMALL).cast_unsigned();
        let [x, y, z] = *position;
        let dots = if raised(x) | raised(y) | raised(z) < 2 * SMALL.cast_unsigned() {
            [a, b, c].map(|row| row.small_dot(x, y, z))
        } else {
            // This case uses a copy, so that the other case does not need the position in memory.
            let position = [x, y, z];
            [a, b, c].map(|row| narrow_dot(&row.whole, &position))
        };
        [sums[0] + dots[0], sums[1] + dots[1], sums[2] + dots[2]]
    }

    /// This function is out of line, so that its numbers stay in registers.
    #[inline(never)]
    fn small_dot(&self, x: i32, y: i32, z: i32) -> i64 {
        let [upper, middle, lower] = &self.parts;
        let sum = |[a, b, c]: &[i32; 3]| i64::from(a * x + b * y + c * z);
        (sum(upper) << 20) + (sum(middle) << 10) + sum(lower)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use rand::Rng;

    /// Tests coefficients and positions at the ends of the range that a cut row multiplies by its parts, and beyond
    /// this range.
    #[test]
    fn cut_rows_are_exact_at_the_ends() {
        let parts = [
            1,
            511,
            512,
            513,
            1 << 19,
            (1 << 19) - 1,
            (1 << 29) - 1,
            1 << 29,
        ];
        for a in parts.into_iter().flat_map(|a| [a, -a]) {
            let row = CutRow::new([a, -a, a]);
            assert!(
                row.parts
                    .as_flattened()
                    .iter()
                    .all(|part| part.abs() <= 1 << 9),
                "{a}"
            );
            for x in [
                SMALL - 1,
                SMALL,
                -SMALL,
                -SMALL - 1,
                i32::MAX,
                i32::MIN,
                0,
                1,
            ] {
                for position in [[x; 3], [x, !x, x]] {
                    let exact =
                        WholeRow::add_dots(&[WholeRow::new([a, -a, a]); 3], &position, [3, -4, 5]);
                    assert_eq!(
                        CutRow::add_dots(&[row; 3], &position, [3, -4, 5]),
                        exact,
                        "{a} · {position:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn narrow_dot_products_are_exact() {
        cases(256, |random| {
            let a = [(); 3].map(|()| random.random_range(-(1 << 29)..=1 << 29));
            let b = random.random::<[i32; 3]>();
            let exact: i64 = a
                .iter()
                .zip(b)
                .map(|(&a, b)| i64::from(a) * i64::from(b))
                .sum();
            assert_eq!(narrow_dot(&a, &b), exact);
            assert_eq!(dot(&a, &b), exact);
        });
    }

    #[test]
    fn dot_products_of_cut_rows_are_exact() {
        cases(256, |random| {
            let rows =
                [(); 3].map(|()| [(); 3].map(|()| random.random_range(-(1 << 29)..=1 << 29)));
            let position = random.random::<[i32; 3]>();
            let down = random.random_range(0..32);
            let position = position.map(|x| x >> down);
            let exact = WholeRow::add_dots(&rows.map(WholeRow::new), &position, [0; 3]);
            assert_eq!(
                CutRow::add_dots(&rows.map(CutRow::new), &position, [0; 3]),
                exact
            );
        });
    }
}
