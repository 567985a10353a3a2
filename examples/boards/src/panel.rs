//! The displays. The driver mipidsi sets one up on a bus that the program lends it. After that, a frame consists of
//! three short commands, which [`Panel::start_frame`] sends, and the bytes of its pixels, which the board sends by DMA.

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{ErrorType, OutputPin};
use embedded_hal::spi::SpiBus;
use embedded_hal_bus::spi::ExclusiveDevice;
use flash_model::Controller;
pub use flash_model::Module;
use mipidsi::dcs::{DcsCommand, SetColumnAddress, SetPageAddress, SoftReset, WriteMemoryStart};
use mipidsi::interface::{Interface, InterfacePixelFormat, SpiInterface};
use mipidsi::models::{GC9A01, ILI9341Rgb565, ILI9488Rgb666, Model, ST7735s, ST7789};
use mipidsi::options::{ColorInversion, ColorOrder, ModelOptions, Orientation, Rotation};

/// The bus or a pin returned an error.
#[derive(Debug)]
pub struct BusError;

/// The pins of a display, except for the clock and the data of its bus.
pub struct Pins<CS, DC, RESET> {
    /// Chip select, low while the display listens, if it has one.
    pub cs: Option<CS>,
    /// Low for a command, high for data; also called RS or A0.
    pub dc: DC,
    /// Low to reset the display, if it is wired.
    pub reset: Option<RESET>,
}

impl<CS, DC, RESET> Pins<CS, DC, RESET> {
    /// All pins.
    pub const fn new(cs: CS, dc: DC, reset: RESET) -> Self {
        Self {
            cs: Some(cs),
            dc,
            reset: Some(reset),
        }
    }
}

/// A pin that may be missing.
struct Wire<'a, P>(Option<&'a mut P>);

impl<P: ErrorType> ErrorType for Wire<'_, P> {
    type Error = P::Error;
}

impl<P: OutputPin> OutputPin for Wire<'_, P> {
    fn set_low(&mut self) -> Result<(), P::Error> {
        self.0.as_mut().map_or(Ok(()), |pin| pin.set_low())
    }

    fn set_high(&mut self) -> Result<(), P::Error> {
        self.0.as_mut().map_or(Ok(()), |pin| pin.set_high())
    }
}

/// A display that is set up and switched on.
pub struct Panel<CS, DC, RESET> {
    pins: Pins<CS, DC, RESET>,
    /// The picture's place in the controller's memory, and the whole memory.
    picture: Window,
    memory: Window,
    bytes_of_pixel: u32,
}

/// The first and the last column, and the first and the last row.
#[derive(Clone, Copy)]
struct Window([u16; 2], [u16; 2]);

impl Window {
    /// Its sides are at least 1, and it lies in a controller's memory, so its numbers fit.
    const fn new((x, y): (u32, u32), (width, height): (u32, u32)) -> Self {
        Self(
            [x as u16, (x + width - 1) as u16],
            [y as u16, (y + height - 1) as u16],
        )
    }
}

impl<CS: OutputPin, DC: OutputPin, RESET: OutputPin> Panel<CS, DC, RESET> {
    /// Sets up the display of a module.
    ///
    /// # Errors
    ///
    /// An error of the bus or of a pin, or the module's controller is unknown.
    #[inline] // leaves out the code for other controllers
    pub fn new(
        module: &Module,
        bus: &mut impl SpiBus,
        mut pins: Pins<CS, DC, RESET>,
        delay: &mut impl DelayNs,
    ) -> Result<Self, BusError> {
        let controller = module.controller().ok_or(BusError)?;
        let mut reset = Wire(pins.reset.as_mut());
        reset.set_low().map_err(|_| BusError)?;
        delay.delay_us(10);
        reset.set_high().map_err(|_| BusError)?;
        let is_reset = reset.0.is_some();

        let device = ExclusiveDevice::new_no_delay(bus, Wire(pins.cs.as_mut()));
        let mut bus = SpiInterface::new(device.map_err(|_| BusError)?, &mut pins.dc, &mut []);
        if !is_reset {
            let code = SoftReset.instruction();
            bus.send_command(code, &[]).map_err(|_| BusError)?;
            delay.delay_ms(120);
        }
        match controller {
            Controller::St7789 => init(ST7789, module, bus, delay),
            Controller::Ili9341 => init(ILI9341Rgb565, module, bus, delay),
            Controller::Gc9a01 => init(GC9A01, module, bus, delay),
            Controller::St7735 => init(ST7735s, module, bus, delay),
            Controller::Ili9488 => init(ILI9488Rgb666, module, bus, delay),
        }?;
        Ok(Self {
            pins,
            picture: Window::new(module.origin(), module.size()),
            memory: Window::new((0, 0), module.memory_size()),
            bytes_of_pixel: module.bytes_of_pixel(),
        })
    }

    /// Tells the display that a frame follows, row by row from the top: its columns, its rows, and that pixels follow.
    /// A pixel is a word of 16 bits, or two bytes, the more significant one first; for a controller with 18 bits, see
    /// [`widen`]. The display stays selected for them.
    ///
    /// # Errors
    ///
    /// An error of the bus or of a pin.
    pub fn start_frame<W: Word>(&mut self, bus: &mut impl SpiBus<W>) -> Result<(), BusError> {
        self.start(bus, self.picture)
    }

    fn start<W: Word>(
        &mut self,
        bus: &mut impl SpiBus<W>,
        Window(columns, rows): Window,
    ) -> Result<(), BusError> {
        // The last words of a transfer may still be on their way, and must arrive before a pin changes.
        bus.flush().map_err(|_| BusError)?;
        // Deselected for a moment, the display forgets the bits of an incomplete word.
        let mut cs = Wire(self.pins.cs.as_mut());
        cs.set_high().map_err(|_| BusError)?;
        cs.set_low().map_err(|_| BusError)?;
        self.command(bus, SetColumnAddress::new(0, 0).instruction(), &columns)?;
        self.command(bus, SetPageAddress::new(0, 0).instruction(), &rows)?;
        self.command(bus, WriteMemoryStart.instruction(), &[])
    }

    /// Fills the controller's whole memory with some pixels, over and over. Until then, the memory holds noise, so do
    /// this before you switch on the backlight.
    ///
    /// # Errors
    ///
    /// An error of the bus or of a pin.
    pub fn clear<W: Word>(
        &mut self,
        bus: &mut impl SpiBus<W>,
        pixels: &[W],
    ) -> Result<(), BusError> {
        let Window([_, column], [_, row]) = self.memory;
        let bytes = self.bytes_of_pixel * (u32::from(column) + 1) * (u32::from(row) + 1);
        let mut left = (bytes as usize).div_ceil(size_of::<W>());
        self.start(bus, self.memory)?;
        while left > 0 && !pixels.is_empty() {
            let words = pixels.get(..left).unwrap_or(pixels);
            bus.write(words).map_err(|_| BusError)?;
            left -= words.len();
        }
        Ok(())
    }

    /// Sends a command and its numbers. Before it come eight bits of zeros, the command to do nothing, so that a bus of
    /// 16-bit words can send it.
    fn command<W: Word>(
        &mut self,
        bus: &mut impl SpiBus<W>,
        code: u8,
        numbers: &[u16],
    ) -> Result<(), BusError> {
        bus.flush().map_err(|_| BusError)?;
        self.pins.dc.set_low().map_err(|_| BusError)?;
        W::send(bus, &[code.into()])?;
        bus.flush().map_err(|_| BusError)?;
        self.pins.dc.set_high().map_err(|_| BusError)?;
        W::send(bus, numbers)
    }
}

/// Sets up a controller that was reset.
fn init<M: Model, BUS: Interface>(
    mut controller: M,
    module: &Module,
    mut bus: BUS,
    delay: &mut impl DelayNs,
) -> Result<(), BusError>
where
    M::ColorFormat: InterfacePixelFormat<BUS::Word>,
{
    let mut options = ModelOptions::full_size::<M>();
    let rotation = [
        Rotation::Deg0,
        Rotation::Deg90,
        Rotation::Deg180,
        Rotation::Deg270,
    ];
    options.orientation = Orientation {
        rotation: rotation[module.rotation as usize & 3],
        mirrored: module.mirrored == 1,
    };
    if module.inverted == 1 {
        options.invert_colors = ColorInversion::Inverted;
    }
    if module.blue_first == 1 {
        options.color_order = ColorOrder::Bgr;
    }
    let done = controller.init(&mut bus, delay, &options);
    done.map(|_| ()).map_err(|_| BusError)
}

/// Makes pixels of 18 bits, three bytes each, of the pixels of 16 bits in the first two thirds of the words. The number
/// of pixels must be even.
pub fn widen(words: &mut [u16]) {
    // A level of five bits becomes one of six, which is in the upper bits of a byte.
    let wide = |pixel: u16| {
        let [red, green, blue] = [pixel >> 11, pixel >> 5 & 63, pixel & 31].map(u32::from);
        let six = |level: u32| level << 1 | level >> 4;
        six(red) << 18 | green << 10 | six(blue) << 2
    };
    for pair in (0..words.len() / 3).rev() {
        let [first, second] = [words[2 * pair], words[2 * pair + 1]].map(wide);
        let bytes = [
            first >> 8,
            (first & 0xff) << 8 | second >> 16,
            second & 0xffff,
        ];
        for (to, bytes) in words[3 * pair..].iter_mut().zip(bytes) {
            *to = bytes as u16;
        }
    }
}

/// What a bus sends at a time: a byte, or a word of 16 bits.
pub trait Word: Copy + 'static {
    /// Sends numbers, each with its most significant bit first.
    ///
    /// # Errors
    ///
    /// An error of the bus.
    fn send(bus: &mut impl SpiBus<Self>, numbers: &[u16]) -> Result<(), BusError>;
}

impl Word for u8 {
    fn send(bus: &mut impl SpiBus<u8>, numbers: &[u16]) -> Result<(), BusError> {
        let mut numbers = numbers.iter();
        numbers.try_for_each(|number| bus.write(&number.to_be_bytes()).map_err(|_| BusError))
    }
}

impl Word for u16 {
    fn send(bus: &mut impl SpiBus<u16>, numbers: &[u16]) -> Result<(), BusError> {
        bus.write(numbers).map_err(|_| BusError)
    }
}
