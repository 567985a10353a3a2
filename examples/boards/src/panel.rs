//! The displays. The driver mipidsi sets one up on a bus that the program lends it. After that, a frame consists of
//! three short commands, which [`Panel::start_frame`] sends, and the bytes of its pixels, which the board sends by DMA.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiBus;
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::Builder;
use mipidsi::dcs::{DcsCommand, SetColumnAddress, SetPageAddress, WriteMemoryStart};
use mipidsi::interface::SpiInterface;
use mipidsi::models::{ILI9341Rgb565, Model, ST7789};
use mipidsi::options::{ColorInversion, ColorOrder, ModelOptions, Orientation, Rotation};

/// The bus or a pin returned an error.
#[derive(Debug)]
pub struct BusError;

/// What drives a display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Controller {
    /// With 240x240 pixels, or 320x240 in landscape.
    St7789,
    /// With 320x240 pixels.
    Ili9341,
}

/// The pins of a display, except for the clock and the data of its bus.
pub struct Pins<CS, DC, RESET> {
    /// Chip select, low while the display listens.
    pub cs: CS,
    /// Low for a command, high for data; also called RS or A0.
    pub dc: DC,
    /// Low to reset the display.
    pub reset: RESET,
}

/// A display that is set up and switched on.
pub struct Panel<CS, DC, RESET> {
    pins: Pins<CS, DC, RESET>,
    /// Last column and last row.
    last: (u16, u16),
}

impl<CS: OutputPin, DC: OutputPin, RESET: OutputPin> Panel<CS, DC, RESET> {
    /// Sets up an ST7789 with 240x240 pixels, or one in landscape with 320x240.
    ///
    /// # Errors
    ///
    /// An error of the bus or of a pin.
    pub fn st7789(
        (width, height): (u32, u32),
        bus: &mut impl SpiBus,
        pins: Pins<CS, DC, RESET>,
        delay: &mut impl DelayNs,
    ) -> Result<Self, BusError> {
        let mut options = ModelOptions::with_all((240, width as u16), (0, 0));
        options.invert_colors = ColorInversion::Inverted;
        if width > height {
            options.orientation = Orientation::new().rotate(Rotation::Deg90);
        }
        Self::new(
            ST7789,
            &options,
            (width as u16, height as u16),
            bus,
            pins,
            delay,
        )
    }

    /// Sets up an ILI9341 in landscape, with 320x240 pixels.
    ///
    /// # Errors
    ///
    /// An error of the bus or of a pin.
    pub fn ili9341(
        bus: &mut impl SpiBus,
        pins: Pins<CS, DC, RESET>,
        delay: &mut impl DelayNs,
    ) -> Result<Self, BusError> {
        let mut options = ModelOptions::full_size::<ILI9341Rgb565>();
        // Most modules are wired like this: mirrored, with blue first.
        options.orientation = Orientation::new().flip_horizontal().rotate(Rotation::Deg90);
        options.color_order = ColorOrder::Bgr;
        Self::new(ILI9341Rgb565, &options, (320, 240), bus, pins, delay)
    }

    fn new<M: Model<ColorFormat = Rgb565>>(
        model: M,
        options: &ModelOptions,
        (width, height): (u16, u16),
        bus: &mut impl SpiBus,
        mut pins: Pins<CS, DC, RESET>,
        delay: &mut impl DelayNs,
    ) -> Result<Self, BusError> {
        let device = ExclusiveDevice::new_no_delay(bus, &mut pins.cs).map_err(|_| BusError)?;
        let interface = SpiInterface::new(device, &mut pins.dc, &mut []);
        Builder::new(model, interface)
            .display_size(options.display_size.0, options.display_size.1)
            .orientation(options.orientation)
            .invert_colors(options.invert_colors)
            .color_order(options.color_order)
            .reset_pin(&mut pins.reset)
            .init(delay)
            .map_err(|_| BusError)?;
        Ok(Self {
            pins,
            last: (width - 1, height - 1),
        })
    }

    /// Tells the display that a frame follows, row by row from the top: its columns, its rows, and that pixels follow.
    /// A pixel is a word of 16 bits, or two bytes, the more significant one first. The display stays selected for them.
    ///
    /// # Errors
    ///
    /// An error of the bus or of a pin.
    pub fn start_frame<W: Word>(&mut self, bus: &mut impl SpiBus<W>) -> Result<(), BusError> {
        let (column, row) = self.last;
        // The last words of a transfer may still be on their way, and must arrive before a pin changes.
        bus.flush().map_err(|_| BusError)?;
        // Deselected for a moment, the display forgets the bits of an incomplete word.
        self.pins.cs.set_high().map_err(|_| BusError)?;
        self.pins.cs.set_low().map_err(|_| BusError)?;
        self.command(
            bus,
            SetColumnAddress::new(0, column).instruction(),
            &[0, column],
        )?;
        self.command(bus, SetPageAddress::new(0, row).instruction(), &[0, row])?;
        self.command(bus, WriteMemoryStart.instruction(), &[])
    }

    /// Fills the display with some pixels, over and over. Until then, its memory holds noise, so do this before you
    /// switch on the backlight.
    ///
    /// # Errors
    ///
    /// An error of the bus or of a pin.
    pub fn clear<W: Word>(
        &mut self,
        bus: &mut impl SpiBus<W>,
        pixels: &[W],
    ) -> Result<(), BusError> {
        let (column, row) = self.last;
        let bytes = 2 * (usize::from(column) + 1) * (usize::from(row) + 1);
        let mut left = bytes / size_of::<W>();
        self.start_frame(bus)?;
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
