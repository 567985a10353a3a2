//! The Pico (RP2040): its clocks, its pins, and the bands on their way to the display.
//!
//! | display | Pico | |
//! |---|---|---|
//! | SCL | GP18 | SPI 0, clock |
//! | SDA | GP19 | SPI 0, data |
//! | CS | GP17 | chip select |
//! | DC | GP16 | low for a command, high for data |
//! | RES | GP20 | reset |
//! | BL | GP21 | backlight |
//! | VCC, GND | 3V3, GND | |
//!
//! DMA sends one band after the other, and an interrupt of core 0 starts the next. So the bus does not wait for the
//! processor as long as a finished band is in the queue.

use core::cell::RefCell;

use cortex_m::asm::{sev, wfe};
use cortex_m::peripheral::NVIC;
use cortex_m::singleton;
use critical_section::Mutex;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::MODE_0;
use fixel::canvas::{Canvas, Words};
use hal::clocks::{Clock, init_clocks_and_plls};
use hal::dma::single_buffer::{Config, Transfer};
use hal::dma::{CH0, Channel, DMAExt, SingleChannel};
use hal::fugit::HertzU32;
use hal::gpio::bank0::{Gpio16, Gpio17, Gpio18, Gpio19, Gpio20};
use hal::gpio::{self, FunctionSioOutput, FunctionSpi, Pin, PullDown};
use hal::pac::{self, interrupt};
use hal::{Sio, Spi, Timer, Watchdog, sio, spi};
use heapless::{Deque, Vec};
use rp2040_hal as hal;

use crate::panel::{Panel, Pins};
use crate::scene::{Memory, Scene};

/// Columns and rows of the display, rows of a band, and bands in memory. The taller bands are, the fewer triangles are in
/// several of them; two cores need a band each, and one that is being sent.
const LAYOUT: (u32, u32, u32, usize) = match (cfg!(feature = "ball"), cfg!(feature = "dual")) {
    (false, _) => (240, 240, 40, 3),
    (true, false) => (320, 240, 120, 2),
    (true, true) => (320, 240, 60, 3),
};

/// Columns of the display.
const WIDTH: u32 = LAYOUT.0;
/// Rows of the display.
const HEIGHT: u32 = LAYOUT.1;
/// Rows of a band; their number divides the height.
const ROWS: u32 = LAYOUT.2;
const BANDS_OF_FRAME: u32 = HEIGHT / ROWS;
/// Pixels of a band.
const PIXELS: usize = (WIDTH * ROWS) as usize;
/// Bands in memory: on their way, and one for each core to draw into.
const BANDS: usize = LAYOUT.3;

/// The pixels of a band, each a word of the bus.
type Band = &'static mut [u16; PIXELS];

/// The frequency of the Pico's crystal.
const CRYSTAL_HZ: u32 = 12_000_000;
const BUS_HZ: HertzU32 = HertzU32::Hz(62_500_000);

type Data = (
    Pin<Gpio19, FunctionSpi, PullDown>,
    Pin<Gpio18, FunctionSpi, PullDown>,
);
type Bus = Spi<spi::Enabled, pac::SPI0, Data, 16>;
type Output<I> = Pin<I, FunctionSioOutput, PullDown>;

/// The display, and the bands.
struct Queue {
    panel: Panel<Output<Gpio17>, Output<Gpio16>, Output<Gpio20>>,
    state: Option<State>,
    finished: Deque<Band, BANDS>,
    free: Vec<Band, BANDS>,
    /// The frame and the number in it of the band that comes into the queue next.
    next: (u32, u32),
    /// The number in its frame of the band that is started next.
    start: u32,
    /// The frames that were begun, and the time of the last.
    begun: u32,
    now_ms: u64,
}

/// What the DMA does.
enum State {
    Idle(Channel<CH0>, Bus),
    Sends(Transfer<Channel<CH0>, Band, Bus>),
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

/// Draws a core's share for ever.
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
            let band = wait_for(|queue| queue.free.pop());
            let pixels = band.as_mut_slice();
            let canvas = Canvas::<Rgb565, Words>::band(pixels, WIDTH, HEIGHT, number * ROWS);
            moment.draw(&mut canvas.unwrap());
            send((frame, number), band);
        }
        frame = frame.wrapping_add(share.frame_step);
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
        self.state = match self.state.take() {
            Some(State::Idle(channel, mut bus)) => match self.finished.pop_front() {
                Some(band) => {
                    if self.start == 0 {
                        // This chip's pins and bus return no errors.
                        self.panel.start_frame(&mut bus).ok();
                    }
                    self.start = (self.start + 1) % BANDS_OF_FRAME;
                    Some(State::Sends(Config::new(channel, band, bus).start()))
                }
                None => Some(State::Idle(channel, bus)),
            },
            state => state,
        }
    }
}

/// A band was sent.
#[interrupt]
fn DMA_IRQ_0() {
    critical_section::with(|cs| {
        let mut queue = QUEUE.borrow_ref_mut(cs);
        let Some(queue) = queue.as_mut() else { return };
        if let Some(State::Sends(transfer)) = queue.state.take() {
            let (mut channel, band, bus) = transfer.wait();
            channel.check_irq0();
            queue.state = Some(State::Idle(channel, bus));
            queue.free.push(band).ok();
        }
        queue.start_next();
    });
    sev();
}

/// What a program has once the board is set up.
pub struct Board {
    pub timer: Timer,
    pub psm: pac::PSM,
    pub ppb: pac::PPB,
    pub fifo: sio::SioFifo,
}

/// Sets up clocks, bus and display, clears the display, and switches its backlight on. May be called once.
pub fn start() -> Option<Board> {
    // The processor and its peripherals run at 125 MHz.
    let mut pac = pac::Peripherals::take()?;
    let mut watchdog = Watchdog::new(pac.WATCHDOG);
    let clocks = init_clocks_and_plls(
        CRYSTAL_HZ,
        pac.XOSC,
        pac.CLOCKS,
        pac.PLL_SYS,
        pac.PLL_USB,
        &mut pac.RESETS,
        &mut watchdog,
    )
    .ok()?;
    let mut timer = Timer::new(pac.TIMER, &mut pac.RESETS, &clocks);

    let sio = Sio::new(pac.SIO);
    let gpio = gpio::Pins::new(
        pac.IO_BANK0,
        pac.PADS_BANK0,
        sio.gpio_bank0,
        &mut pac.RESETS,
    );
    let clock = gpio.gpio18.into_function::<FunctionSpi>();
    let data = gpio.gpio19.into_function::<FunctionSpi>();
    let frequency = clocks.peripheral_clock.freq();
    let pins = Pins {
        cs: gpio.gpio17.into_push_pull_output(),
        dc: gpio.gpio16.into_push_pull_output(),
        reset: gpio.gpio20.into_push_pull_output(),
    };
    // The driver sends bytes; after that, words of 16 bits, between which there are half as many gaps.
    let mut bytes = Spi::<_, _, _, 8>::new(pac.SPI0, (data, clock)).init(
        &mut pac.RESETS,
        frequency,
        BUS_HZ,
        MODE_0,
    );
    let mut panel = Panel::st7789((WIDTH, HEIGHT), &mut bytes, pins, &mut timer).ok()?;
    let (device, data) = bytes.disable().free();
    let mut bus =
        Spi::<_, _, _, 16>::new(device, data).init(&mut pac.RESETS, frequency, BUS_HZ, MODE_0);

    let bands = singleton!(: [[u16; PIXELS]; BANDS] = [[0; PIXELS]; BANDS])?;
    let free: Vec<Band, BANDS> = bands.iter_mut().collect();
    panel.clear(&mut bus, free.first()?.as_slice()).ok()?;
    let Ok(()) = gpio.gpio21.into_push_pull_output().set_high();

    let mut channel = pac.DMA.split(&mut pac.RESETS).ch0;
    channel.enable_irq0();
    let queue = Queue {
        panel,
        state: Some(State::Idle(channel, bus)),
        finished: Deque::new(),
        free,
        next: (0, 0),
        start: 0,
        begun: 0,
        now_ms: 0,
    };
    critical_section::with(|cs| QUEUE.borrow_ref_mut(cs).replace(queue));
    // SAFETY: the program does not rely on this interrupt's not being enabled.
    #[allow(unsafe_code)]
    unsafe {
        NVIC::unmask(pac::Interrupt::DMA_IRQ_0);
    }
    Some(Board {
        timer,
        psm: pac.PSM,
        ppb: pac.PPB,
        fifo: sio.fifo,
    })
}
