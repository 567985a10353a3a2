//! The displays. The driver mipidsi sets one up on a bus that the program lends it. After that, a frame consists of
//! three short commands, which [`Panel::start_frame`] sends, and the bytes of its pixels, which the board sends by DMA.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiBus;
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::Builder;
use mipidsi::dcs::{InterfaceExt, SetColumnAddress, SetPageAddress, WriteMemoryStart};
use mipidsi::interface::SpiInterface;
use mipidsi::models::{ILI9341Rgb565, Model, ST7789};
use mipidsi::options::{ColorInversion, ColorOrder, ModelOptions, Orientation, Rotation};

/// The bus or a pin returned an error.
#[derive(Debug)]
pub struct BusError;

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
    /// Sets up an ST7789 with 240x240 pixels.
    ///
    /// # Errors
    ///
    /// An error of the bus or of a pin.
    pub fn st7789(
        bus: &mut impl SpiBus,
        pins: Pins<CS, DC, RESET>,
        delay: &mut impl DelayNs,
    ) -> Result<Self, BusError> {
        let mut options = ModelOptions::with_all((240, 240), (0, 0));
        options.invert_colors = ColorInversion::Inverted;
        Self::new(ST7789, &options, (240, 240), bus, pins, delay)
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

    /// Tells the display that a frame follows, row by row from the top, with two bytes per pixel, the more significant
    /// one first. The display stays selected for these bytes.
    ///
    /// # Errors
    ///
    /// An error of the bus or of a pin.
    pub fn start_frame(&mut self, bus: &mut impl SpiBus) -> Result<(), BusError> {
        // The last bytes of a transfer may still be on their way, and must arrive before a pin changes.
        bus.flush().map_err(|_| BusError)?;
        self.commands(bus).ok_or(BusError)?;
        self.pins.cs.set_low().map_err(|_| BusError)
    }

    fn commands(&mut self, bus: &mut impl SpiBus) -> Option<()> {
        let device = ExclusiveDevice::new_no_delay(bus, &mut self.pins.cs).ok()?;
        let mut display = SpiInterface::new(device, &mut self.pins.dc, &mut []);
        display
            .write_command(SetColumnAddress::new(0, self.last.0))
            .ok()?;
        display
            .write_command(SetPageAddress::new(0, self.last.1))
            .ok()?;
        display.write_command(WriteMemoryStart).ok()
    }
}
