//! Error diffusion.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::Dimensions;
use embedded_graphics::pixelcolor::{Gray8, GrayColor};

use super::canvas::Canvas;
use super::contrast::Contrast;
use super::storage::Storage;
use crate::shade::PixelFormat;

/// Memory for an error diffusion (Floyd and Steinberg, 1976), for [`Canvas::show_diffused`].
///
/// The memory carries errors from row to row, and from band to band. Make a new `ErrorDiffusion` for each frame, and
/// show the frame's bands with it from top to bottom.
#[derive(Debug)]
pub struct ErrorDiffusion<'e> {
    /// The errors of the columns, in 16ths of a step of [`Gray8`]. From `column` on, the errors are for this row; up to
    /// `column` − 2, they are for the next row.
    errors: &'e mut [i16],
    column: usize,
    /// The error that this column receives from the column on its left.
    right: i32,
    /// The errors that the next row has received so far: in the previous column, and in this column.
    below: i32,
    below_right: i32,
}

impl<O: Storage<Gray8>, D> Canvas<'_, Gray8, O, D> {
    /// Shows a gray canvas on a display with fewer grays by error diffusion, in one call of
    /// [`fill_contiguous`](DrawTarget::fill_contiguous).
    ///
    /// Each pixel gets the display's nearest gray. Later pixels make up for the difference, which is at most half a
    /// step of the display's grays: 7/16 of it are added to the pixel on the right; 3/16, 5/16 and 1/16 to the pixels
    /// below on the left, directly below, and below on the right. At the left and right sides of the frame, some of
    /// these pixels would be outside the frame; the pixel directly below gets their parts. The mean brightness
    /// therefore stays the same, except where it would exceed white or fall below black. Details are finer than with
    /// ordered dithering, but if the picture moves, the dots change from frame to frame.
    ///
    /// Bands that are shown from top to bottom give the same picture as the whole frame. The display may be another
    /// canvas that holds the whole frame or the same rows. The display must consume every color that is sent to it.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{BinaryColor, Gray8};
    /// use fixel::{prelude::*, canvas::{Contrast, ErrorDiffusion}};
    /// let mut grays = [64; 64].map(Gray8::new);
    /// let gray = Canvas::new(&mut grays, 16, 4)?;
    /// let mut shown = [BinaryColor::Off; 64];
    /// let mut panel = Canvas::new(&mut shown, 16, 4)?;
    /// let mut errors = [0; 16];
    /// let mut diffusion = ErrorDiffusion::new(&mut errors);
    /// let Ok(()) = gray.show_diffused(&mut panel, Contrast::default(), &mut diffusion);
    /// let on = panel.pixels().filter(|pixel| pixel.is_on()).count();
    /// assert_eq!(on, 16); // a quarter
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The display's own errors.
    pub fn show_diffused<T: DrawTarget<Color: PixelFormat<Channels = i32>>>(
        &self,
        display: &mut T,
        contrast: Contrast,
        diffusion: &mut ErrorDiffusion<'_>,
    ) -> Result<(), T::Error> {
        let last = self.frame_size().width as usize - 1;
        let colors = self
            .pixels()
            .map(|gray| diffusion.color(contrast.stretch(gray), last));
        display.fill_contiguous(&self.bounding_box(), colors)
    }
}

impl<'e> ErrorDiffusion<'e> {
    /// Starts the error diffusion of a frame. `errors` needs one element per column. If `errors` is shorter, the
    /// columns beyond its end pass errors only to the right. The previous contents of `errors` do not matter.
    #[must_use]
    pub fn new(errors: &'e mut [i16]) -> Self {
        errors.fill(0);
        Self {
            errors,
            column: 0,
            right: 0,
            below: 0,
            below_right: 0,
        }
    }

    /// The color that the display shows for the next pixel. `last` is the last column of each row.
    fn color<C: PixelFormat<Channels = i32>>(&mut self, gray: Gray8, last: usize) -> C {
        /// White, in 16ths of a step of [`Gray8`].
        const WHITE: i32 = 255 * 16;
        let [most, ..] = C::MAX_STEPS;
        // A color type of the user may have black as its only color, and then has no steps.
        let half = (WHITE / 2).checked_div(most).unwrap_or(WHITE / 2);
        let at = self.column;
        let is_last = at >= last;
        let before = self.errors.get(at).copied().unwrap_or_default();
        let wanted = i32::from(gray.luma()) * 16 + i32::from(before) + self.right;
        let steps = (wanted * most + WHITE / 2)
            .div_euclid(WHITE)
            .min(most)
            .max(0);
        // The gray is exact for 1, 3, 15 and 255 steps, because these numbers divide 255. Otherwise, the gray is
        // rounded.
        let shown = (steps * WHITE + most / 2)
            .checked_div(most)
            .unwrap_or_default();
        // Apart from rounding, the error exceeds half a step only where the gray should be darker than black or lighter
        // than white. The excess is dropped. If the excess were kept, it would pile up at the right border, which
        // receives more than it passes on, and would smear into darker rows.
        let error = (wanted - shown).max(-half).min(half);

        let (right, left, below) = ((error * 7) >> 4, (error * 3) >> 4, (error * 5) >> 4);
        let beyond = error - right - left - below;
        let left = if at > 0 {
            self.keep(at - 1, self.below + left);
            0
        } else {
            left
        };
        let below = self.below_right + below + left;
        if is_last {
            self.keep(at, below + right + beyond);
            (self.column, self.right, self.below, self.below_right) = (0, 0, 0, 0);
        } else {
            (self.column, self.right, self.below, self.below_right) =
                (at + 1, right, below, beyond);
        }
        // Not `[steps; 3]`, which is a loop in a build for size.
        C::from_steps([steps, steps, steps])
    }

    /// Stores the error of a column of the next row. The error is at most 2,040, half of a step from black to white.
    /// Only a frame of a single column reaches this bound, because this column keeps all of its error. With more
    /// columns, the error is at most 14/16 of the bound, plus 3 for rounding.
    fn keep(&mut self, column: usize, error: i32) {
        if let Some(kept) = self.errors.get_mut(column) {
            *kept = error as i16;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::pixelcolor::PixelColor;

    /// A program's own gray, with `MOST` + 1 values.
    #[derive(Clone, Copy, Debug, PartialEq)]
    struct Gray<const MOST: i32>(i32);

    impl<const MOST: i32> PixelColor for Gray<MOST> {
        type Raw = ();
    }

    impl<const MOST: i32> PixelFormat for Gray<MOST> {
        const MAX_STEPS: [i32; 3] = [MOST; 3];
        type Channels = i32;

        fn steps(self) -> [i32; 3] {
            [self.0; 3]
        }

        fn from_steps([steps, ..]: [i32; 3]) -> Self {
            Self(steps)
        }
    }

    /// Shows 64 x 64 pixels of one gray. Returns the first pixel that is shown, and the mean of all pixels.
    fn shown<const MOST: i32>(gray: u8) -> (i32, f64) {
        let mut errors = [0; 64];
        let mut diffusion = ErrorDiffusion::new(&mut errors);
        let mut steps = (0..64 * 64).map(|_| diffusion.color::<Gray<MOST>>(Gray8::new(gray), 63).0);
        let first = steps.next().unwrap();
        let sum: i32 = first + steps.sum::<i32>();
        (first, f64::from(sum) / 4096.)
    }

    fn check<const MOST: i32>() {
        for gray in 0..=255 {
            let exact = f64::from(gray) / 255. * f64::from(MOST);
            let (first, mean) = shown::<MOST>(gray);
            assert!(
                (f64::from(first) - exact).abs() <= 0.5,
                "{gray} of {MOST}: {first}"
            );
            assert!((mean - exact).abs() < 0.05, "{gray} of {MOST}: {mean}");
        }
    }

    /// The test includes numbers of grays that do not divide 255.
    #[test]
    fn each_pixel_gets_the_nearest_gray() {
        check::<1>();
        check::<3>();
        check::<7>();
        check::<15>();
        check::<31>();
        check::<63>();
        check::<127>();
        check::<255>();
        assert_eq!(shown::<0>(200), (0, 0.));
    }
}
