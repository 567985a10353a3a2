//! The Pico (RP2040): its clocks, its pins, its display, and a band on its way there by DMA.
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

use cortex_m::singleton;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::MODE_0;
use hal::clocks::{Clock, init_clocks_and_plls};
use hal::dma::single_buffer::{Config, Transfer};
use hal::dma::{CH0, Channel, DMAExt, SingleChannel};
use hal::fugit::HertzU32;
use hal::gpio::bank0::{Gpio16, Gpio17, Gpio18, Gpio19, Gpio20};
use hal::gpio::{self, FunctionSioOutput, FunctionSpi, Pin, PullDown};
use hal::pac;
use hal::{Sio, Spi, Timer, Watchdog, sio, spi};
use heapless::Vec;
use rp2040_hal as hal;

use crate::panel::{Controller, Panel, Pins};

/// Columns and rows of the display, rows of a band, and bands in memory. The taller bands are, the fewer triangles are
/// in several of them; two cores need a band each, and one that is being sent.
const LAYOUT: (u32, u32, u32, usize) = if cfg!(feature = "model") {
    (320, 240, 120, 2)
} else {
    match (cfg!(feature = "ball"), cfg!(feature = "dual")) {
        (false, _) => (240, 240, 40, 3),
        (true, false) => (320, 240, 120, 2),
        (true, true) => (320, 240, 60, 3),
    }
};

/// Columns of the display; `pico_model` has displays of fewer, too.
pub const WIDTH: u32 = LAYOUT.0;
/// Rows of the display.
pub const HEIGHT: u32 = LAYOUT.1;
/// Rows of a band; their number divides the height.
pub const ROWS: u32 = LAYOUT.2;
/// Bands of a frame.
pub const BANDS_OF_FRAME: u32 = HEIGHT / ROWS;
/// Pixels of a band, as many as the display has columns.
pub const PIXELS: usize = (WIDTH * ROWS) as usize;
/// Bands in memory: on their way, and one for each core to draw into.
pub const BANDS: usize = LAYOUT.3;

/// The pixels of a band, each a word of the bus.
pub type Band = &'static mut [u16];

/// The frequency of the Pico's crystal.
const CRYSTAL_HZ: u32 = 12_000_000;

/// The clock of a controller's bus. An ILI9341's data sheet allows 10 MHz; faster is usual.
const fn bus(controller: Controller) -> HertzU32 {
    match controller {
        Controller::St7789 => HertzU32::Hz(62_500_000),
        Controller::Ili9341 => HertzU32::Hz(31_250_000),
    }
}

type Data = (
    Pin<Gpio19, FunctionSpi, PullDown>,
    Pin<Gpio18, FunctionSpi, PullDown>,
);
/// A bus of 16-bit words.
type Bus = Spi<spi::Enabled, pac::SPI0, Data, 16>;
/// A pin that the program sets.
type Output<I> = Pin<I, FunctionSioOutput, PullDown>;

/// What the DMA does.
enum State {
    /// Nothing.
    Idle(Channel<CH0>, Bus),
    /// It sends a band.
    Sends(Transfer<Channel<CH0>, Band, Bus>),
}

/// Sends bands to the display by DMA, frame after frame. When a band was sent, DMA requests its interrupt 0.
pub struct Sender {
    panel: Panel<Output<Gpio17>, Output<Gpio16>, Output<Gpio20>>,
    state: Option<State>,
    /// The number in its frame of the band that is started next.
    next: u32,
}

impl Sender {
    /// The band that was sent last, unless it was returned before. Withdraws the request of the interrupt.
    pub fn sent(&mut self) -> Option<Band> {
        let (state, band) = match self.state.take()? {
            State::Sends(transfer) if transfer.is_done() => {
                let (mut channel, band, bus) = transfer.wait();
                channel.check_irq0();
                (State::Idle(channel, bus), Some(band))
            }
            state => (state, None),
        };
        self.state = Some(state);
        band
    }

    /// Starts to send the band that `next` returns, unless another one is being sent.
    pub fn start(&mut self, next: impl FnOnce() -> Option<Band>) {
        self.state = match self.state.take() {
            Some(State::Idle(channel, mut bus)) => match next() {
                Some(band) => {
                    if self.next == 0 {
                        // This chip's pins and bus return no errors.
                        self.panel.start_frame(&mut bus).ok();
                    }
                    self.next = (self.next + 1) % BANDS_OF_FRAME;
                    Some(State::Sends(Config::new(channel, band, bus).start()))
                }
                None => Some(State::Idle(channel, bus)),
            },
            state => state,
        }
    }
}

/// The board once it is set up.
pub struct Board {
    /// Counts microseconds.
    pub timer: Timer,
    /// For the second core.
    pub psm: pac::PSM,
    /// For the second core.
    pub ppb: pac::PPB,
    /// For the second core.
    pub fifo: sio::SioFifo,
    /// The way to the display, which is clear and lit.
    pub sender: Sender,
    /// The memory of the bands.
    pub bands: Vec<Band, BANDS>,
}

/// Sets up clocks, bus and an ST7789, clears the display, and switches its backlight on. May be called once.
pub fn set_up(pac: pac::Peripherals) -> Option<Board> {
    set_up_with(pac, Controller::St7789, WIDTH)
}

/// The same for a display with another controller, and at most [`WIDTH`] columns.
#[inline] // leaves out the code for other controllers
pub fn set_up_with(mut pac: pac::Peripherals, controller: Controller, width: u32) -> Option<Board> {
    // The processor and its peripherals run at 125 MHz.
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
        bus(controller),
        MODE_0,
    );
    let mut panel = match controller {
        Controller::St7789 => Panel::st7789((width, HEIGHT), &mut bytes, pins, &mut timer),
        Controller::Ili9341 => Panel::ili9341(&mut bytes, pins, &mut timer),
    }
    .ok()?;
    let (device, data) = bytes.disable().free();
    let mut bus = Spi::<_, _, _, 16>::new(device, data).init(
        &mut pac.RESETS,
        frequency,
        bus(controller),
        MODE_0,
    );

    let bands = singleton!(: [[u16; PIXELS]; BANDS] = [[0; PIXELS]; BANDS])?;
    let bands = bands
        .iter_mut()
        .map(|band| band.get_mut(..(width * ROWS) as usize));
    let free: Vec<Band, BANDS> = bands.collect::<Option<_>>()?;
    panel.clear(&mut bus, free.first()?).ok()?;
    let Ok(()) = gpio.gpio21.into_push_pull_output().set_high();

    let mut channel = pac.DMA.split(&mut pac.RESETS).ch0;
    channel.enable_irq0();
    Some(Board {
        timer,
        psm: pac.PSM,
        ppb: pac.PPB,
        fifo: sio.fifo,
        sender: Sender {
            panel,
            state: Some(State::Idle(channel, bus)),
            next: 0,
        },
        bands: free,
    })
}
