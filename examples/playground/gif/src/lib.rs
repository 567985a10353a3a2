//! Writes an animated GIF in a browser: a module of its own, which the page loads when someone saves one. Each file gets
//! a new instance.
//!
//! The page calls `begin`, writes a frame's pixels into the memory and calls `add` for each frame, and then takes the
//! file: `file` and `file_size`.

use std::sync::{Mutex, MutexGuard, PoisonError};

use gif::{Encoder, EncodingError, Frame, Repeat};

/// From 1, the best choice of colors, to 30, the fastest.
const SPEED: i32 = 10;

struct Animation {
    size: [u16; 2],
    /// A frame's red, green, blue and opacity.
    pixels: Vec<u8>,
    encoder: Option<Encoder<Vec<u8>>>,
    file: Vec<u8>,
}

/// A browser calls one function at a time, so no one waits for the lock.
static ANIMATION: Mutex<Animation> = Mutex::new(Animation {
    size: [0; 2],
    pixels: Vec::new(),
    encoder: None,
    file: Vec::new(),
});

fn animation() -> MutexGuard<'static, Animation> {
    ANIMATION.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Animation {
    fn begin(&mut self, width: u16, height: u16) -> Result<(), EncodingError> {
        let mut encoder = Encoder::new(Vec::new(), width, height, &[])?;
        encoder.set_repeat(Repeat::Infinite)?;
        self.encoder = Some(encoder);
        self.size = [width, height];
        self.pixels = vec![0; usize::from(width) * usize::from(height) * 4];
        Ok(())
    }

    fn add(&mut self, delay: u16) -> Result<(), EncodingError> {
        let [width, height] = self.size;
        // The colors of a frame with at most 256 are exact.
        let mut frame = Frame::from_rgba_speed(width, height, &mut self.pixels, SPEED);
        frame.delay = delay;
        match &mut self.encoder {
            Some(encoder) => encoder.write_frame(&frame),
            None => Ok(()),
        }
    }

    fn end(&mut self) -> Result<(), EncodingError> {
        if let Some(encoder) = self.encoder.take() {
            self.file = encoder.into_inner()?;
        }
        Ok(())
    }
}

/// Begins a file of frames of this size. Returns the memory of a frame's pixels, in bytes of red, green, blue and
/// opacity; null if there is none.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn begin(width: u16, height: u16) -> *mut u8 {
    let mut animation = animation();
    match animation.begin(width, height) {
        Ok(()) => animation.pixels.as_mut_ptr(),
        Err(_) => std::ptr::null_mut(),
    }
}

/// Adds the frame whose pixels are in the memory; `delay` is how long to show it, in hundredths of a second. Returns
/// false if there is not enough memory.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn add(delay: u16) -> bool {
    animation().add(delay).is_ok()
}

/// Ends the file, and returns it.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn file() -> *const u8 {
    let mut animation = animation();
    match animation.end() {
        Ok(()) => animation.file.as_ptr(),
        Err(_) => std::ptr::null(),
    }
}

/// How many bytes it has.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn file_size() -> usize {
    animation().file.len()
}
