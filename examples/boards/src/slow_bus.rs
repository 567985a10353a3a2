//! A bus of two pins that the program sets itself.

use core::convert::Infallible;

use embedded_hal::digital::OutputPin;
use embedded_hal::spi::{ErrorType, SpiBus};

/// Sends the bytes that set up a display, while the chip's own bus already rests with the mode and the words for the
/// frames. A display without CS counts every edge of the clock from its reset on, and a chip's bus makes some when it
/// is set up.
pub struct SlowBus<CLOCK, DATA> {
    /// The clock. A display reads a bit when the clock rises.
    pub clock: CLOCK,
    /// The data.
    pub data: DATA,
    /// Whether the clock rests high (mode 3) or low (mode 0).
    pub rests_high: bool,
}

impl<CLOCK: OutputPin<Error = Infallible>, DATA> SlowBus<CLOCK, DATA> {
    /// Puts the clock to its level between bytes. Do this before you reset the display.
    pub fn rest(&mut self) {
        let Ok(()) = self.clock.set_state(self.rests_high.into());
    }
}

impl<CLOCK, DATA> ErrorType for SlowBus<CLOCK, DATA> {
    type Error = Infallible;
}

impl<CLOCK, DATA> SpiBus for SlowBus<CLOCK, DATA>
where
    CLOCK: OutputPin<Error = Infallible>,
    DATA: OutputPin<Error = Infallible>,
{
    #[inline(never)] // a driver calls it for each command
    fn write(&mut self, bytes: &[u8]) -> Result<(), Infallible> {
        for byte in bytes {
            for bit in (0..8).rev() {
                self.clock.set_low()?;
                self.data.set_state((byte >> bit & 1 == 1).into())?;
                self.clock.set_high()?;
            }
            if !self.rests_high {
                self.clock.set_low()?;
            }
        }
        Ok(())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }

    /// Reads nothing: a display has no line back.
    fn read(&mut self, _: &mut [u8]) -> Result<(), Infallible> {
        Ok(())
    }

    fn transfer(&mut self, _: &mut [u8], bytes: &[u8]) -> Result<(), Infallible> {
        self.write(bytes)
    }

    fn transfer_in_place(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        self.write(bytes)
    }
}
