//! Contrast: the grays of a frame spread from black to white.

use embedded_graphics::pixelcolor::{Gray8, GrayColor};

use super::canvas::Canvas;
use super::storage::Storage;

/// Makes one gray black and a lighter gray white, and spreads the grays between them evenly.
///
/// Use it for displays with few grays. For example, a scene of only dark grays would become noise on a display that
/// shows only black and white. The default contrast changes no gray.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::{prelude::*, canvas::Contrast};
/// let mut grays = [40, 80, 120, 60].map(Gray8::new);
/// let canvas = Canvas::new(&mut grays, 2, 2)?;
/// let contrast = Contrast::of(&canvas, 0);
/// assert_eq!(contrast, Contrast::new(40, 120));
/// let stretched = [20, 40, 80, 120].map(|gray| contrast.stretch(Gray8::new(gray)));
/// assert_eq!(stretched, [0, 0, 128, 255].map(Gray8::new));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Contrast {
    black: u8,
    white: u8,
}

impl Default for Contrast {
    fn default() -> Self {
        Self::new(0, 255)
    }
}

impl Contrast {
    /// Grays up to `black` become black (0), and grays of `white` and above become white (255). If `white` is not
    /// lighter than `black`, all grays above `black` become white.
    #[must_use]
    pub const fn new(black: u8, white: u8) -> Self {
        Self { black, white }
    }

    /// The contrast that turns the darkest gray of the rows in memory into black, and the lightest into white. This
    /// function ignores the darkest `ignored`/256 of the pixels, and as many of the lightest, so that a single
    /// highlight does not set the contrast.
    ///
    /// All bands of a frame need the same contrast, for example the contrast of the previous frame. The function uses 1
    /// KiB of stack.
    #[must_use]
    pub fn of<O: Storage<Gray8>, D>(canvas: &Canvas<'_, Gray8, O, D>, ignored: u8) -> Self {
        let mut counts = [0_u32; 256];
        for gray in canvas.pixels() {
            counts[usize::from(gray.luma())] += 1;
        }
        // A frame has at most 2^22 pixels.
        let most = (canvas.pixels().len() as u32 * u32::from(ignored)) >> 8;
        Self {
            black: end(counts.iter(), most),
            white: 255 - end(counts.iter().rev(), most),
        }
    }

    /// The lightest gray that becomes black.
    #[must_use]
    pub const fn black(self) -> u8 {
        self.black
    }

    /// The darkest gray that becomes white.
    #[must_use]
    pub const fn white(self) -> u8 {
        self.white
    }

    /// The new value of a gray, rounded to nearest.
    #[must_use]
    #[inline]
    pub fn stretch(self, gray: Gray8) -> Gray8 {
        let above = u32::from(gray.luma().saturating_sub(self.black));
        // The range is 0 only if all grays above `black` become white.
        let range = u32::from(self.white.saturating_sub(self.black));
        let stretched = (above * 255 + range / 2).checked_div(range);
        let white = if above > 0 { 255 } else { 0 };
        Gray8::new(stretched.unwrap_or(white).min(255) as u8)
    }
}

/// The index of the first entry at which the sum of the counts exceeds `most`.
fn end<'c>(counts: impl Iterator<Item = &'c u32>, most: u32) -> u8 {
    let mut sum = 0;
    let reached = |&count: &u32| {
        sum += count;
        sum > most
    };
    counts.map(reached).take_while(|reached| !reached).count() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_gray_is_stretched_to_the_nearest_step() {
        for black in 0..=255_u8 {
            for white in 0..=255_u8 {
                for gray in (0..=255_u8).step_by(5) {
                    let found = Contrast::new(black, white).stretch(Gray8::new(gray)).luma();
                    let [black, white, gray] = [black, white, gray].map(f64::from);
                    let exact = if black < white {
                        ((gray - black) / (white - black) * 255.).clamp(0., 255.)
                    } else {
                        f64::from(u8::from(gray > black)) * 255.
                    };
                    assert!(
                        (f64::from(found) - exact).abs() <= 0.5,
                        "{black} {white} {gray}"
                    );
                }
            }
        }
    }

    #[test]
    fn contrast_ignores_the_darkest_and_the_brightest_pixels() {
        let mut grays: std::vec::Vec<Gray8> = (0..=255).map(|i| Gray8::new(i / 2 + 50)).collect();
        let canvas = Canvas::new(&mut grays, 16, 16).unwrap();
        assert_eq!(Contrast::of(&canvas, 0), Contrast::new(50, 177));
        assert_eq!(Contrast::of(&canvas, 1), Contrast::new(50, 177));
        assert_eq!(Contrast::of(&canvas, 2), Contrast::new(51, 176));
        assert_eq!(Contrast::of(&canvas, 255), Contrast::new(177, 50));
    }
}
