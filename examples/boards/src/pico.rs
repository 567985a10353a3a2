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
//!
//! `pico_model` reads its pins from flash.

use core::panic::PanicInfo;

use cortex_m::delay::Delay;
use cortex_m::singleton;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::{MODE_0, MODE_3};
use fixel::canvas::{Canvas, Words};
use flash_model::Module;
use hal::clocks::{Clock, init_clocks_and_plls};
use hal::dma::single_buffer::{Config, Transfer};
use hal::dma::{CH0, Channel, DMAExt, SingleChannel};
use hal::fugit::HertzU32;
use hal::gpio::{
    self, DynBankId, DynFunction, DynPinId, DynPullType, FunctionSioOutput, FunctionSpi, Pin,
    new_pin,
};
use hal::pac;
use hal::spi::{SpiDevice, ValidatedPinSck, ValidatedPinTx};
use hal::{Sio, Spi, Watchdog, sio, spi};
use heapless::Vec;
#[cfg(feature = "pico2")]
pub use rp235x_hal as hal;
#[cfg(feature = "pico")]
pub use rp2040_hal as hal;

use crate::led;
use crate::panel::{Panel, Pins, Word, widen};
use crate::report::Report;
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
const LAYOUT: (u32, u32, u32, usize) = {
    // A Pico 2 has twice the memory.
    match (
        cfg!(feature = "model"),
        cfg!(feature = "world"),
        cfg!(feature = "pico2"),
    ) {
        (true, _, false) => (320, 240, 60, 3),
        (true, _, true) => (320, 240, 120, 3),
        (_, true, false) => (240, 240, 80, 3),
        (_, true, true) => (240, 240, 120, 3),
        _ => match (cfg!(feature = "ball"), cfg!(feature = "dual")) {
            (false, _) => (240, 240, 40, 3),
            (true, false) => (320, 240, 120, 2),
            (true, true) => (320, 240, 60, 3),
        },
    }
};

/// Columns of the display; of the display of `pico_model`, its module says how many.
pub const WIDTH: u32 = LAYOUT.0;
/// Rows of the display.
pub const HEIGHT: u32 = LAYOUT.1;
/// Rows of a band; their number divides the height.
pub const ROWS: u32 = LAYOUT.2;
/// Bands of a frame.
pub const BANDS_OF_FRAME: u32 = HEIGHT / ROWS;
/// Words of 16 bits of a band.
pub const PIXELS: usize = (WIDTH * ROWS) as usize;
/// Bands in memory: on their way, and one for each core to draw into.
pub const BANDS: usize = LAYOUT.3;

/// The module with the display, except for `pico_model`.
pub const MODULE: Module = if WIDTH > HEIGHT {
    Module {
        rotation: 1,
        ..Module::ST7789_TALL
    }
} else {
    Module::ST7789
};

/// The rows of a band for a module: as many as [`PIXELS`] words hold, of the numbers that divide the height.
#[must_use]
pub const fn rows_for(module: &Module) -> u32 {
    let (width, height) = module.size();
    let mut rows = height;
    while words_of(module, width * rows) > PIXELS || !height.is_multiple_of(rows) {
        rows -= 1;
    }
    rows
}

/// The words of some pixels on a module's bus.
const fn words_of(module: &Module, pixels: u32) -> usize {
    (pixels * module.bytes_of_pixel() / 2) as usize
}

/// The pixels of a band, each a word of the bus.
pub type Band = &'static mut [u16];

/// The LED on the board. A Pico W and a Pico 2 W have theirs on the wireless chip. There, this pin selects the wireless
/// chip, which is off, because GP23 does not switch it on: so the pin has no effect.
const LED: u32 = 25;

/// The frequency of the board's crystal.
const CRYSTAL_HZ: u32 = 12_000_000;
/// The frequency of the processor.
const CLOCK_HZ: u32 = if cfg!(feature = "pico2") {
    150_000_000
} else {
    125_000_000
};

/// A pin whose number is known only now.
type Wire<F> = Pin<DynPinId, F, DynPullType>;
/// A pin that the program sets.
pub type Output = Wire<FunctionSioOutput>;
/// A display.
type Display = Panel<Output, Output, Output>;
type Data<D> = (
    ValidatedPinTx<Wire<FunctionSpi>, D>,
    ValidatedPinSck<Wire<FunctionSpi>, D>,
);
/// A bus of 16-bit words.
type Bus<D> = Spi<spi::Enabled, D, Data<D>, 16>;

/// What the DMA does.
enum State<D: SpiDevice> {
    /// Nothing.
    Idle(Channel<CH0>, Bus<D>),
    /// It sends a band.
    Sends(Transfer<Channel<CH0>, Band, Bus<D>>),
}

/// Sends bands to the display by DMA, frame after frame. When a band was sent, DMA requests its interrupt 0.
pub struct Way<D: SpiDevice> {
    panel: Display,
    state: Option<State<D>>,
    /// The number in its frame of the band that is started next, and the bands of a frame.
    next: u32,
    bands_of_frame: u32,
}

impl<D: SpiDevice> Way<D> {
    fn sent(&mut self) -> Option<Band> {
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

    fn start(&mut self, next: impl FnOnce() -> Option<Band>) {
        self.state = match self.state.take() {
            Some(State::Idle(channel, mut bus)) => match next() {
                Some(band) => {
                    if self.next == 0 {
                        // This chip's pins and bus return no errors.
                        self.panel.start_frame(&mut bus).ok();
                    }
                    self.next = (self.next + 1) % self.bands_of_frame;
                    Some(State::Sends(Config::new(channel, band, bus).start()))
                }
                None => Some(State::Idle(channel, bus)),
            },
            state => state,
        }
    }
}

/// The way to the display, by one of the chip's two buses.
pub enum Sender {
    /// SPI 0.
    Spi0(Way<pac::SPI0>),
    /// SPI 1.
    #[cfg(feature = "model")]
    Spi1(Way<pac::SPI1>),
}

impl Sender {
    /// The band that was sent last, unless it was returned before. Withdraws the request of the interrupt.
    pub fn sent(&mut self) -> Option<Band> {
        match self {
            Self::Spi0(way) => way.sent(),
            #[cfg(feature = "model")]
            Self::Spi1(way) => way.sent(),
        }
    }

    /// Starts to send the band that `next` returns, unless another one is being sent.
    pub fn start(&mut self, next: impl FnOnce() -> Option<Band>) {
        match self {
            Self::Spi0(way) => way.start(next),
            #[cfg(feature = "model")]
            Self::Spi1(way) => way.start(next),
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
    /// The LED on the board.
    pub led: Output,
    /// The way to the display, which is clear and lit.
    pub sender: Sender,
    /// The memory of the bands.
    pub bands: Vec<Band, BANDS>,
}

/// Sets up clocks, bus and display, clears the display, and switches its backlight on. May be called once.
#[inline] // leaves out the code for other controllers
pub fn set_up(mut pac: pac::Peripherals, module: &Module) -> Option<Board> {
    // The peripherals have the processor's clock.
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
    // From now on, pins work.
    gpio::Pins::new(
        pac.IO_BANK0,
        pac.PADS_BANK0,
        sio.gpio_bank0,
        &mut pac.RESETS,
    );
    let led = output(LED)?;
    let mut channel = pac.DMA.split(&mut pac.RESETS).ch0;
    channel.enable_irq0();
    let words = words_of(module, module.size().0 * rows_for(module));
    let bands = singleton!(: [[u16; PIXELS]; BANDS] = [[0; PIXELS]; BANDS])?;
    let bands = bands.iter_mut().map(|band| band.get_mut(..words));
    let bands: Vec<Band, BANDS> = bands.collect::<Option<_>>()?;
    let set_up = SetUp {
        module,
        frequency: clocks.peripheral_clock.freq(),
        resets: &mut pac.RESETS,
        timer: &mut timer,
        channel,
        black: bands.first()?,
    };
    let sender = match module.block() {
        0 => Sender::Spi0(set_up.way(pac.SPI0)?),
        #[cfg(feature = "model")]
        1 => Sender::Spi1(set_up.way(pac.SPI1)?),
        _ => return None,
    };
    Some(Board {
        timer,
        psm: pac.PSM,
        ppb: pac.PPB,
        fifo: sio.fifo,
        led,
        sender,
        bands,
    })
}

/// A pin with a number.
fn pin(num: u32) -> Option<Wire<DynFunction>> {
    let id = DynPinId {
        bank: DynBankId::Bank0,
        num: num.try_into().ok()?,
    };
    // SAFETY: a module's pins have different numbers. Those of the bus have two owners for a while, of which one waits.
    #[allow(unsafe_code)]
    (num <= 28).then(|| unsafe { new_pin(id) })
}

/// A pin that the program sets, which is high at first; `None` if nothing is wired to it.
fn output(num: u32) -> Option<Output> {
    let mut output = pin(num)?.try_into_function().ok()?;
    let Ok(()) = OutputPin::set_high(&mut output);
    Some(output)
}

/// Sets up the display by a bus of bytes, and returns both.
#[inline] // leaves out the code for other controllers
fn display(
    module: &Module,
    mut delay: &mut dyn DelayNs,
) -> Option<(Display, SlowBus<Output, Output>)> {
    let pins = module.pins;
    let mut bytes = SlowBus {
        clock: pin(pins.clock)?.try_into_function().ok()?,
        data: pin(pins.data)?.try_into_function().ok()?,
        rests_high: module.spi_mode == 3,
    };
    bytes.rest();
    let outputs = Pins {
        cs: output(pins.cs),
        dc: output(pins.dc)?,
        reset: output(pins.reset),
    };
    let panel = Panel::new(module, &mut bytes, outputs, &mut delay).ok()?;
    Some((panel, bytes))
}

/// Switches the backlight on, if the module has one.
fn light(module: &Module) {
    let light = pin(module.pins.light).and_then(|pin| pin.try_into_function().ok());
    if let Some(mut light) = light {
        let light: &mut Output = &mut light;
        let Ok(()) = light.set_state((module.light_low == 0).into());
    }
}

/// Shows what a panic says on the module's display, and blinks the LED for ever. Begins with nothing but the pins, so it
/// does not matter what the program was about to do.
#[inline] // leaves out the code for other controllers
pub fn report(info: &PanicInfo, module: &Module) -> ! {
    // The section never ends: the other core stops where it wants to enter one, and no interrupt starts a transfer.
    critical_section::with(|_| {
        // SAFETY: nothing else uses the pins from now on.
        #[allow(unsafe_code)]
        let mut pac = unsafe { pac::Peripherals::steal() };
        let (sio, resets) = (Sio::new(pac.SIO), &mut pac.RESETS);
        gpio::Pins::new(pac.IO_BANK0, pac.PADS_BANK0, sio.gpio_bank0, resets);
        // SAFETY: likewise.
        #[allow(unsafe_code)]
        let core = unsafe { cortex_m::Peripherals::steal() };
        let mut delay = SysTick(Delay::new(core.SYST, CLOCK_HZ));
        show(&Report::of(info, module.size()), module, &mut delay);
        let (mut led, mut now_ms) = (output(LED), 0);
        loop {
            if let Some(led) = &mut led {
                led::show(led, led::PANIC, now_ms);
            }
            delay.delay_ms(led::STEP_MS);
            now_ms += u64::from(led::STEP_MS);
        }
    })
}

/// Shows a report on a display, which is set up again.
#[inline] // shares `Report::draw` with the program
fn show(report: &Report, module: &Module, delay: &mut SysTick) -> Option<()> {
    let (mut panel, mut bus) = display(module, delay)?;
    panel.clear(&mut bus, &[0_u8; 64]).ok()?;
    panel.start_frame::<u8>(&mut bus).ok()?;
    let (width, height) = module.size();
    // The longest row: 480 pixels, which may become three bytes each.
    let mut words = [0; 720];
    for row in 0..height {
        let words = words.get_mut(..words_of(module, width))?;
        let pixels = words.get_mut(..width as usize)?;
        report.draw(&mut Canvas::<Rgb565, Words>::band(pixels, width, height, row).ok()?);
        if module.bytes_of_pixel() == 3 {
            widen(words);
        }
        u8::send(&mut bus, words).ok()?;
    }
    light(module);
    Some(())
}

/// Waits by the core's own timer, which needs nothing else.
struct SysTick(Delay);

impl DelayNs for SysTick {
    fn delay_ns(&mut self, ns: u32) {
        self.0.delay_us(ns.div_ceil(1000));
    }
}

/// The parts of the chip that set up the display, and its module.
struct SetUp<'a> {
    module: &'a Module,
    frequency: HertzU32,
    resets: &'a mut pac::RESETS,
    timer: &'a mut Timer,
    channel: Channel<CH0>,
    black: &'a [u16],
}

impl SetUp<'_> {
    /// Sets up a bus and the display.
    fn way<D: SpiDevice>(self, device: D) -> Option<Way<D>> {
        let (module, pins) = (self.module, self.module.pins);
        let is_mode_3 = module.spi_mode == 3;
        let clock = pin(pins.clock)?.try_into_function().ok()?;
        let data = pin(pins.data)?.try_into_function().ok()?;
        let clock = ValidatedPinSck::validate(clock, &device).ok()?;
        let data = ValidatedPinTx::validate(data, &device).ok()?;
        // A module without CS counts each edge of the clock once its reset ends, and works in mode 3 only. So from here
        // on, the bus keeps its mode and its words of 16 bits, between which there are half as many gaps as between
        // bytes. The chip divides its clock by an even number: the Pico's bus runs at 62.5 or 31.25 MHz, and slower.
        let mut bus = Spi::new(device, (data, clock)).init(
            self.resets,
            self.frequency,
            HertzU32::Hz(module.clock_hz),
            if is_mode_3 { MODE_3 } else { MODE_0 },
        );
        // The driver sends bytes. Until it is done, the pins of the bus belong to a bus of bytes.
        let (mut panel, bytes) = display(module, self.timer)?;
        // Both buses rest at the same level, so there is no edge.
        bytes.clock.try_into_function::<FunctionSpi>().ok()?;
        bytes.data.try_into_function::<FunctionSpi>().ok()?;

        panel.clear(&mut bus, self.black).ok()?;
        light(module);
        Some(Way {
            panel,
            state: Some(State::Idle(self.channel, bus)),
            next: 0,
            bands_of_frame: module.size().1 / rows_for(module),
        })
    }
}
