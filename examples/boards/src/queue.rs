//! The bands on their way to the Pico's display, for one core or for two.
//!
//! DMA sends one band after the other, and an interrupt of core 0 starts the next. So the bus does not wait for the
//! processor as long as a finished band is in the queue.

use core::cell::RefCell;

use cortex_m::asm::{sev, wfe};
use cortex_m::peripheral::NVIC;
use critical_section::Mutex;
use hal::pac::{self, interrupt};
use hal::{Timer, sio};
use heapless::{Deque, Vec};
use rp2040_hal as hal;
#[cfg(not(feature = "model"))]
use {
    crate::pico::HEIGHT,
    crate::scene::{Memory, Scene},
    embedded_graphics::pixelcolor::Rgb565,
    fixel::canvas::{Canvas, Words},
};

use crate::panel::Controller;
use crate::pico::{self, BANDS, BANDS_OF_FRAME, Band, ROWS, Sender, WIDTH};

/// The bands, and their way to the display.
struct Queue {
    sender: Sender,
    finished: Deque<Band, BANDS>,
    free: Vec<Band, BANDS>,
    /// The frame and the number in it of the band that comes into the queue next.
    next: (u32, u32),
    /// The frames that were begun, and the time of the last.
    begun: u32,
    now_ms: u64,
}

static QUEUE: Mutex<RefCell<Option<Queue>>> = Mutex::new(RefCell::new(None));

/// Waits until `f` of the queue returns something.
fn wait_for<T>(mut f: impl FnMut(&mut Queue) -> Option<T>) -> T {
    loop {
        let found = critical_section::with(|cs| QUEUE.borrow_ref_mut(cs).as_mut().and_then(&mut f));
        if let Some(found) = found {
            // The other core may wait for what has changed.
            sev();
            return found;
        }
        wfe();
    }
}

/// What a core draws: frames from the first one on, and bands of each.
#[derive(Clone, Copy)]
pub struct Share {
    first_frame: u32,
    frame_step: u32,
    first_band: u32,
    band_step: usize,
}

impl Share {
    /// All bands of all frames.
    pub const WHOLE: Self = Self {
        first_frame: 0,
        frame_step: 1,
        first_band: 0,
        band_step: 1,
    };

    /// Every other band of all frames, for a scene that takes longer to draw than to prepare: each of the two cores
    /// prepares every frame.
    #[must_use]
    pub const fn bands(core: u32) -> Self {
        Self {
            first_band: core,
            band_step: 2,
            ..Self::WHOLE
        }
    }

    /// Every other frame, for a scene that takes long to prepare: one core does so while the bands of the other one's
    /// frame are sent.
    #[must_use]
    pub const fn frames(core: u32) -> Self {
        Self {
            first_frame: core,
            frame_step: 2,
            ..Self::WHOLE
        }
    }
}

/// Draws a core's share of the scene for ever.
///
/// # Panics
///
/// The memory is too short for the scene.
#[cfg(not(feature = "model"))]
pub fn animate(share: Share, timer: Timer, memory: &mut Memory) -> ! {
    let scene = Scene::new(WIDTH, HEIGHT).unwrap();
    repeat(share, timer, |frame| {
        let moment = scene.at(frame.now_ms, memory).unwrap();
        frame.draw(|pixels, first_row| {
            let canvas = Canvas::<Rgb565, Words>::band(pixels, WIDTH, HEIGHT, first_row);
            moment.draw(&mut canvas.unwrap());
        });
    })
}

/// Draws a core's share of frames for ever.
pub fn repeat(share: Share, timer: Timer, mut draw: impl FnMut(Frame)) -> ! {
    let mut number = share.first_frame;
    loop {
        let now_ms = begin(number, timer);
        draw(Frame {
            now_ms,
            number,
            share,
        });
        number = number.wrapping_add(share.frame_step);
    }
}

/// A frame that is to be drawn.
pub struct Frame {
    /// Its time.
    pub now_ms: u64,
    number: u32,
    share: Share,
}

impl Frame {
    /// Draws a core's share of the frame: gives pixels and first row of each band to `draw`, and sends the band.
    pub fn draw(self, mut draw: impl FnMut(&mut [u16], u32)) {
        for number in (self.share.first_band..BANDS_OF_FRAME).step_by(self.share.band_step) {
            let band = wait_for(|queue| queue.free.pop());
            draw(band, number * ROWS);
            send((self.number, number), band);
        }
    }
}

/// The time of a frame, which is the same on both cores. They begin frames in their order.
fn begin(frame: u32, timer: Timer) -> u64 {
    wait_for(|queue| {
        if queue.begun == frame {
            queue.now_ms = timer.get_counter().ticks() / 1000;
            queue.begun = frame.wrapping_add(1);
        }
        (queue.begun == frame.wrapping_add(1)).then_some(queue.now_ms)
    })
}

/// Puts a band into the queue once all bands before it are there. `at` is its frame, and its number in the frame.
fn send(at: (u32, u32), band: Band) {
    let mut band = Some(band);
    wait_for(|queue| {
        if queue.next != at {
            return None;
        }
        let (frame, number) = at;
        queue.next = if number + 1 < BANDS_OF_FRAME {
            (frame, number + 1)
        } else {
            (frame.wrapping_add(1), 0)
        };
        queue.finished.push_back(band.take()?).ok()?;
        queue.start_next();
        Some(())
    });
}

impl Queue {
    /// Starts the next band, if there is one and nothing is being sent.
    fn start_next(&mut self) {
        self.sender.start(|| self.finished.pop_front());
    }
}

/// A band was sent.
#[interrupt]
fn DMA_IRQ_0() {
    critical_section::with(|cs| {
        let mut queue = QUEUE.borrow_ref_mut(cs);
        let Some(queue) = queue.as_mut() else { return };
        if let Some(band) = queue.sender.sent() {
            queue.free.push(band).ok();
        }
        queue.start_next();
    });
    sev();
}

/// What a program has besides the queue.
pub struct Rest {
    /// Counts microseconds.
    pub timer: Timer,
    /// For the second core.
    pub psm: pac::PSM,
    /// For the second core.
    pub ppb: pac::PPB,
    /// For the second core.
    pub fifo: sio::SioFifo,
}

/// Sets up the board, with an ST7789, and the queue. May be called once.
pub fn start() -> Option<Rest> {
    start_with(Controller::St7789, WIDTH)
}

/// The same for a display with another controller or fewer columns.
#[inline] // leaves out the code for other controllers
pub fn start_with(controller: Controller, width: u32) -> Option<Rest> {
    let board = pico::set_up_with(pac::Peripherals::take()?, controller, width)?;
    let queue = Queue {
        sender: board.sender,
        finished: Deque::new(),
        free: board.bands,
        next: (0, 0),
        begun: 0,
        now_ms: 0,
    };
    critical_section::with(|cs| QUEUE.borrow_ref_mut(cs).replace(queue));
    // SAFETY: the program does not rely on this interrupt's not being enabled.
    #[allow(unsafe_code)]
    unsafe {
        NVIC::unmask(pac::Interrupt::DMA_IRQ_0);
    }
    Some(Rest {
        timer: board.timer,
        psm: board.psm,
        ppb: board.ppb,
        fifo: board.fifo,
    })
}
