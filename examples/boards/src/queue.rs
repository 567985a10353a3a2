//! The bands on their way to the display of a Pico or Pico 2, for one core or for two.
//!
//! DMA sends one band after the other, and an interrupt of core 0 starts the next. So the bus does not wait for the
//! processor as long as a finished band is in the queue.

use core::cell::RefCell;

use cortex_m::asm::{sev, wfe};
use cortex_m::peripheral::NVIC;
use critical_section::Mutex;
use embedded_graphics::pixelcolor::Rgb565;
use fixel::Error;
use fixel::canvas::{Canvas, LinearDepth, Words};
use flash_model::Module;
use hal::multicore::{Multicore, Stack};
use hal::pac::{self, interrupt};
use hal::sio;
use heapless::Vec;

use crate::led;
use crate::panel::widen;
use crate::pico::{
    self, BANDS, BANDS_OF_FRAME, Band, HEIGHT, MODULE, Output, ROWS, Sender, Timer, WIDTH, hal,
};
use crate::scene::{Memory, Scene};

/// A frame, and the number in it of a band.
type At = (u32, u32);

/// The bands, and their way to the display.
struct Queue {
    sender: Sender,
    finished: Vec<(At, Band), BANDS>,
    free: Vec<Band, BANDS>,
    /// The band that a core gets next, and the one that is sent next.
    to_draw: At,
    to_send: At,
    bands_of_frame: u32,
    /// The frames that were begun, and the time of the last.
    begun: u32,
    now_ms: u64,
    /// The LED on the board, and its pattern.
    led: Output,
    pattern: u16,
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
pub fn animate(share: Share, timer: Timer, memory: &mut Memory) -> ! {
    let scene = Scene::new(WIDTH, HEIGHT).unwrap();
    let mut frame = share.first_frame;
    loop {
        let moment = scene.at(begin(frame, timer), memory).unwrap();
        for number in (share.first_band..BANDS_OF_FRAME).step_by(share.band_step) {
            let at = (frame, number);
            let band = wait_for(|queue| {
                if queue.to_draw == at {
                    queue.take()
                } else {
                    None
                }
            });
            let canvas = Canvas::<Rgb565, Words>::band(&mut band[..], WIDTH, HEIGHT, number * ROWS);
            moment.draw(&mut canvas.unwrap());
            send(at, band);
        }
        frame = frame.wrapping_add(share.frame_step);
    }
}

/// The time of a frame, which is the same on both cores. They begin frames in their order.
fn begin(frame: u32, timer: Timer) -> u64 {
    wait_for(|queue| {
        queue.begin(frame, timer);
        (queue.begun == frame.wrapping_add(1)).then_some(queue.now_ms)
    })
}

/// Gives the LED another pattern.
pub fn set_pattern(pattern: u16) {
    wait_for(|queue| {
        queue.pattern = pattern;
        Some(())
    });
}

/// Draws bands of a module's frames for ever, with depths: on each core, the next band that no core draws yet. `draw`
/// gets the time of the frame, and the band.
///
/// # Panics
///
/// There are fewer depths than pixels.
pub fn animate_with_depth(
    module: &Module,
    timer: Timer,
    depths: &mut [u16],
    draw: impl Fn(u64, &mut Canvas<'_, Rgb565, Words, LinearDepth>) -> Result<(), Error>,
) -> ! {
    let ((width, height), rows) = (module.size(), pico::rows_for(module));
    let pixels = (width * rows) as usize;
    loop {
        let (at, now_ms, band) = next(timer);
        let canvas = Canvas::<Rgb565, Words>::band(&mut band[..pixels], width, height, at.1 * rows);
        let canvas = canvas.and_then(|canvas| canvas.with_depth(&mut depths[..pixels]));
        draw(now_ms, &mut canvas.unwrap()).unwrap();
        if module.bytes_of_pixel() == 3 {
            widen(band);
        }
        send(at, band);
    }
}

/// The next band that no core draws yet: its frame and its number, the time of the frame, and memory to draw into.
fn next(timer: Timer) -> (At, u64, Band) {
    wait_for(|queue| {
        let at = queue.to_draw;
        let band = queue.take()?;
        queue.begin(at.0, timer);
        Some((at, queue.now_ms, band))
    })
}

/// Puts a band into the queue. It is sent once all bands before it were.
fn send(at: At, band: Band) {
    let mut band = Some(band);
    wait_for(|queue| {
        queue.finished.push((at, band.take()?)).ok()?;
        queue.start_next();
        Some(())
    });
}

impl Queue {
    /// Memory for the next band, if there is any. The bands of a frame get theirs in their order, so the first of those
    /// that are drawn can always be finished and sent, and a core never waits for the other.
    fn take(&mut self) -> Option<Band> {
        let band = self.free.pop()?;
        self.to_draw = self.after(self.to_draw);
        Some(band)
    }

    /// Begins a frame, unless it has begun.
    fn begin(&mut self, frame: u32, timer: Timer) {
        if self.begun == frame {
            self.now_ms = timer.get_counter().ticks() / 1000;
            self.begun = frame.wrapping_add(1);
            led::show(&mut self.led, self.pattern, self.now_ms);
        }
    }

    fn after(&self, (frame, number): At) -> At {
        if number + 1 < self.bands_of_frame {
            (frame, number + 1)
        } else {
            (frame.wrapping_add(1), 0)
        }
    }

    /// Starts the next band, if it is finished and nothing is being sent.
    fn start_next(&mut self) {
        let at = self.to_send;
        let mut is_started = false;
        self.sender.start(|| {
            let index = self.finished.iter().position(|&(of, _)| of == at)?;
            is_started = true;
            Some(self.finished.swap_remove(index).1)
        });
        if is_started {
            self.to_send = self.after(at);
        }
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
    psm: pac::PSM,
    ppb: pac::PPB,
    fifo: sio::SioFifo,
}

impl Rest {
    /// Starts core 1, which has the second stack.
    ///
    /// # Panics
    ///
    /// The stack was used before, or core 1 does not answer.
    pub fn start_core_1<const WORDS: usize>(
        mut self,
        stack: &Stack<WORDS>,
        work: impl FnOnce() + Send + 'static,
    ) {
        let mut cores = Multicore::new(&mut self.psm, &mut self.ppb, &mut self.fifo);
        let stack = stack.take().unwrap();
        cores.cores()[1].spawn(stack, work).unwrap();
    }
}

/// Sets up the board, with an ST7789, and the queue. May be called once.
pub fn start() -> Option<Rest> {
    start_with(&MODULE)
}

/// The same for a module.
#[inline] // leaves out the code for other controllers
pub fn start_with(module: &Module) -> Option<Rest> {
    let board = pico::set_up(pac::Peripherals::take()?, module)?;
    let queue = Queue {
        sender: board.sender,
        finished: Vec::new(),
        free: board.bands,
        to_draw: (0, 0),
        to_send: (0, 0),
        bands_of_frame: module.size().1 / pico::rows_for(module),
        begun: 0,
        now_ms: 0,
        led: board.led,
        pattern: led::RUNS,
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
