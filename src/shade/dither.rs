//! Ordered dithering.

use embedded_graphics::geometry::Point;

/// The 8x8 matrix of Bayer (1973): each number from 0 to 63 once, with consecutive numbers far apart.
///
/// Each number is built from bits: those of x ^ y and of y, interleaved and in reverse order.
static BAYER: [[u8; 8]; 8] = bayer();

const fn bayer() -> [[u8; 8]; 8] {
    let mut matrix = [[0; 8]; 8];
    let mut y = 0;
    while y < 8 {
        let mut x = 0;
        while x < 8 {
            let (odd, even) = (x ^ y, y);
            let mut bit = 0;
            while bit < 3 {
                // The lowest bits, which change from pixel to pixel, count most.
                let pair = ((odd >> bit) & 1) << 1 | (even >> bit) & 1;
                matrix[y][x] |= (pair << (4 - 2 * bit)) as u8;
                bit += 1;
            }
            x += 1;
        }
        y += 1;
    }
    matrix
}

/// The number to add to a level, in units of 2⁻¹⁶ step, before it is cut to whole steps: (m + ½)/64 of a step, where
/// m is the matrix at this pixel. It lies between 512 and 65,024; its mean is half a step.
///
/// A whole step keeps its value even with an error of up to 511 units in either direction.
#[inline]
pub(super) fn threshold(at: Point) -> i32 {
    let (x, y) = (at.x.cast_unsigned() & 7, at.y.cast_unsigned() & 7);
    i32::from(BAYER[y as usize][x as usize]) * 1024 + 512
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_matrix_is_the_one_bayer_published() {
        // The first two rows of the 8x8 matrix, which follows from Bayer's printed 4x4 matrix by doubling.
        assert_eq!(BAYER[0], [0, 32, 8, 40, 2, 34, 10, 42]);
        assert_eq!(BAYER[1], [48, 16, 56, 24, 50, 18, 58, 26]);
        let mut all: std::vec::Vec<u8> = BAYER.as_flattened().into();
        all.sort_unstable();
        assert!(all.into_iter().eq(0..64));
    }

    #[test]
    fn thresholds_repeat_left_of_and_above_the_frame() {
        assert_eq!(threshold(Point::new(-8, -1)), threshold(Point::new(0, 7)));
    }
}
