//! Levels as surfaces interpolate them: raised by half a step, so that cutting rounds.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::Rgb888;

use super::levels::{HALF, dimmed, each};
use super::{Channels, Illumination, Lanes, Levels, Tolerance, Varyings};

/// The levels of a color between black and white, raised by half a step: from 2^15 to the number of steps and a half.
#[derive(Clone, Copy, Debug)]
pub struct Raised<C: Levels>(C::Channels);

impl<C: Levels> Raised<C> {
    #[inline]
    pub(super) fn new(color: Rgb888) -> Self {
        Self::of_levels(C::levels(color))
    }

    #[inline]
    pub(super) fn of_levels(levels: [i32; 3]) -> Self {
        Self(C::Channels::first(each(levels, |level| {
            level.wrapping_add(HALF)
        })))
    }

    /// All three channels; those that are not used are 0.
    #[inline]
    pub(super) fn all(self) -> [i32; 3] {
        self.0.all()
    }

    /// The color at a pixel of the frame.
    #[inline]
    pub(super) fn color(self, at: Point) -> C {
        C::from_raised(self.all(), at)
    }

    /// The color under a light.
    #[inline]
    pub(super) fn lit(self, light: Illumination, at: Point) -> C {
        let levels = each(self.all(), |level| level.wrapping_sub(HALF));
        C::from_levels(dimmed::<C>(levels, light), at)
    }
}

impl<C: Levels> Varyings for Raised<C> {
    type Lanes = <C::Channels as Varyings>::Lanes;
    type Face = <C::Channels as Varyings>::Face;

    const PAIRS: bool =
        Self::Lanes::COUNT == 3 && C::MAX_STEPS[0] < 1 << 5 && C::MAX_STEPS[2] < 1 << 5;

    #[inline]
    fn tolerances() -> <Self::Lanes as Lanes>::Of<Tolerance> {
        C::Channels::tolerances()
    }

    #[inline]
    fn split(self) -> (<Self::Lanes as Lanes>::Of<i32>, Self::Face) {
        self.0.split()
    }

    #[inline]
    fn join(numbers: <Self::Lanes as Lanes>::Of<i32>, face: Self::Face) -> Self {
        Self(C::Channels::join(numbers, face))
    }
}
