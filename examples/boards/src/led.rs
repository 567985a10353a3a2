//! What the LED on the board says: it follows a pattern of 16 bits, which begins again after its last bit.

use embedded_hal::digital::OutputPin;

/// A slow blink: the program draws frames.
pub const RUNS: u16 = 0x00ff;
/// Two short blinks and a pause: there is no model that could be drawn.
pub const NO_MODEL: u16 = 0b101;
/// Three short blinks and a pause: the program has panicked.
pub const PANIC: u16 = 0b10101;

/// The time of a bit. The first bit of a pattern is its lowest.
pub const STEP_MS: u32 = 200;

/// Switches the LED on or off: to the bit of the pattern whose time is `now_ms`.
pub fn show(led: &mut impl OutputPin, pattern: u16, now_ms: u64) {
    let step = now_ms / u64::from(STEP_MS) % u64::from(u16::BITS);
    // The pins of these chips return no errors.
    led.set_state((pattern >> step & 1 == 1).into()).ok();
}
