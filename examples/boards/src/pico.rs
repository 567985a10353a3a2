//! The Pico (RP2040) and the Pico 2 (RP2350): clocks, pins, the display, and a band on its way there by DMA.
//!
//! | display | both boards | |
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
use embedded_hal::spi::MODE_3;
use hal::clocks::{Clock, init_clocks_and_plls};
use hal::dma::single_buffer::{Config, Transfer};
use hal::dma::{CH0, Channel, DMAExt, SingleChannel};
use hal::fugit::HertzU32;
use hal::gpio::bank0::{Gpio16, Gpio17, Gpio18, Gpio19, Gpio20};
use hal::gpio::{
    self, DynBankId, DynPinId, FunctionSioOutput, FunctionSpi, Pin, PullDown, new_pin,
};
use hal::pac;
use hal::{Sio, Spi, Watchdog, sio, spi};
use heapless::Vec;
#[cfg(feature = "pico2")]
pub use rp235x_hal as hal;
#[cfg(feature = "pico")]
pub use rp2040_hal as hal;

use crate::panel::{Controller, Panel, Pins};
use crate::slow_bus::SlowBus;

/// The second-stage boot loader, which an RP2040 runs first to set up its flash.
#[cfg(feature = "pico")]
#[allow(unsafe_code)] // names its place
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_GENERIC_03H;

/// The block that an RP2350 looks for: what follows is a program for its Arm cores.
#[cfg(feature = "pico2")]
#[allow(unsafe_code)] // names its place
#[unsafe(link_section = ".start_block")]
#[used]
static IMAGE: hal::block::ImageDef = hal::block::ImageDef::secure_exe();

/// Counts microseconds.
#[cfg(feature = "pico")]
pub use hal::Timer;
/// Counts microseconds.
#[cfg(feature = "pico2")]
pub type Timer = hal::Timer<hal::timer::CopyableTimer0>;

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

/// The frequency of the board's crystal.
const CRYSTAL_HZ: u32 = 12_000_000;

/// The fastest clock for a controller's bus. An ST7789's data sheet allows 62.5 MHz. An ILI9341's allows 10 MHz, but
/// faster is usual. The chip divides its clock by an even number: the Pico's bus runs at 62.5 or 31.25 MHz, and the bus
/// of the Pico 2 at 37.5 MHz for both.
const fn fastest(controller: Controller) -> HertzU32 {
    match controller {
        Controller::St7789 => HertzU32::Hz(62_500_000),
        Controller::Ili9341 => HertzU32::Hz(40_000_000),
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
    // The processor and its peripherals run at 125 MHz, those of the Pico 2 at 150 MHz.
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
    #[cfg(feature = "pico")]
    let mut timer = Timer::new(pac.TIMER, &mut pac.RESETS, &clocks);
    #[cfg(feature = "pico2")]
    let mut timer = Timer::new_timer0(pac.TIMER0, &mut pac.RESETS, &clocks);

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
    // A module without CS counts each edge of the clock once its reset ends, and works in mode 3 only. So from here on,
    // the bus keeps its mode and its words of 16 bits, between which there are half as many gaps as between bytes.
    let mut bus = Spi::<_, _, _, 16>::new(pac.SPI0, (data, clock)).init(
        &mut pac.RESETS,
        frequency,
        fastest(controller),
        MODE_3,
    );
    // The driver sends bytes. Until it is done, the pins of the bus belong to a bus of bytes.
    // SAFETY: nothing else uses these pins until then.
    #[allow(unsafe_code)]
    let [clock, data] = [18, 19].map(|num| unsafe {
        new_pin(DynPinId {
            bank: DynBankId::Bank0,
            num,
        })
    });
    let mut bytes = SlowBus {
        clock: clock.try_into_function().ok()?,
        data: data.try_into_function().ok()?,
        rests_high: true,
    };
    bytes.rest();
    let mut panel = match controller {
        Controller::St7789 => Panel::st7789((width, HEIGHT), &mut bytes, pins, &mut timer),
        Controller::Ili9341 => Panel::ili9341(&mut bytes, pins, &mut timer),
    }
    .ok()?;
    // Both buses rest at the same level, so there is no edge.
    bytes.clock.try_into_function::<FunctionSpi>().ok()?;
    bytes.data.try_into_function::<FunctionSpi>().ok()?;

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
