//! What a program must know of a module with a panel: its controller, its glass, and its wires.

use core::fmt;

use bytemuck::{Pod, Zeroable};

/// In place of a pin's number, this number says that nothing is wired.
pub const NO_PIN: u32 = u32::MAX;

/// A module with a panel, and the pins of the board that it is wired to. Columns and rows are counted before the
/// rotation, unless a method says otherwise.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
pub struct Module {
    /// The number of the [`Controller`].
    pub controller: u32,
    /// The columns and rows of the glass.
    pub glass: [u32; 2],
    /// The columns and rows of the controller's memory.
    pub memory: [u32; 2],
    /// The first column and the first row of memory that the glass shows.
    pub offset: [u32; 2],
    /// By how many right angles the picture is turned clockwise: 0 to 3.
    pub rotation: u32,
    /// 1 if the glass shows the columns of the memory from right to left, otherwise 0.
    pub mirrored: u32,
    /// 1 if the glass has blue where the controller has red, otherwise 0.
    pub blue_first: u32,
    /// 1 if the glass shows a negative unless the controller inverts, otherwise 0.
    pub inverted: u32,
    /// The mode of SPI: 0 or 3.
    pub spi_mode: u32,
    /// The highest frequency of the bus, in Hz.
    pub clock_hz: u32,
    /// The pins of the board.
    pub pins: Wires,
    /// 1 if the backlight is on while its pin is low, otherwise 0.
    pub light_low: u32,
}

/// The pins of a board that a module is wired to, as the numbers of their GPIOs.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
pub struct Wires {
    /// The clock of the bus: SCL, SCK, CLK.
    pub clock: u32,
    /// The data of the bus: SDA, DIN, MOSI.
    pub data: u32,
    /// Low for a command, high for data.
    pub dc: u32,
    /// Chip select, or [`NO_PIN`].
    pub cs: u32,
    /// Reset, or [`NO_PIN`].
    pub reset: u32,
    /// Backlight, or [`NO_PIN`].
    pub light: u32,
}

/// What drives a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Controller {
    /// Its bus has at most 62.5 MHz.
    St7789 = 0,
    /// Its data sheet allows 10 MHz, but 40 MHz are usual.
    Ili9341 = 1,
    /// For round panels.
    Gc9a01 = 2,
    /// Its data sheet allows 15 MHz.
    St7735 = 3,
    /// It takes 18 bits for a pixel. Its data sheet allows 20 MHz, but 27 MHz are usual.
    Ili9488 = 4,
}

/// The wires of examples/boards. Many boards with a panel have the same pins for bus, DC and CS.
const WIRES: Wires = Wires {
    clock: 18,
    data: 19,
    dc: 16,
    cs: 17,
    reset: 20,
    light: 21,
};

impl Module {
    /// An ST7789 with 240x240 pixels, with or without CS: the bus has mode 3.
    pub const ST7789: Self = Self {
        controller: Controller::St7789 as u32,
        glass: [240, 240],
        memory: [240, 320],
        offset: [0, 0],
        rotation: 0,
        mirrored: 0,
        blue_first: 0,
        inverted: 1,
        spi_mode: 3,
        clock_hz: 62_500_000,
        pins: WIRES,
        light_low: 0,
    };
    /// An ST7789 with 240x320 pixels.
    pub const ST7789_TALL: Self = Self {
        glass: [240, 320],
        ..Self::ST7789
    };
    /// An ILI9341 with 320x240 pixels in landscape. Most modules are wired like this: mirrored, with blue first.
    pub const ILI9341: Self = Self {
        controller: Controller::Ili9341 as u32,
        rotation: 1,
        mirrored: 1,
        blue_first: 1,
        inverted: 0,
        clock_hz: 40_000_000,
        ..Self::ST7789_TALL
    };
    const ST7735: Self = Self {
        controller: Controller::St7735 as u32,
        glass: [128, 160],
        memory: [132, 162],
        offset: [2, 1],
        rotation: 2,
        inverted: 0,
        clock_hz: 15_000_000,
        ..Self::ST7789
    };
    const WAVESHARE: Wires = Wires {
        clock: 10,
        data: 11,
        dc: 8,
        cs: 9,
        reset: 12,
        light: 13,
    };
    const PIMORONI: Wires = Wires {
        reset: NO_PIN,
        light: 20,
        ..WIRES
    };

    /// The modules that have names, each with a description.
    pub const ALL: [(&str, &str, Self); 15] = [
        ("st7789", "ST7789, 240x240", Self::ST7789),
        ("ili9341", "ILI9341, 320x240", Self::ILI9341),
        (
            "st7789-no-cs",
            "ST7789, 240x240, without CS",
            Self {
                pins: Wires {
                    cs: NO_PIN,
                    ..WIRES
                },
                ..Self::ST7789
            },
        ),
        ("st7789-240x320", "ST7789, 240x320", Self::ST7789_TALL),
        (
            "st7789-135x240",
            "ST7789, 135x240",
            Self {
                glass: [135, 240],
                offset: [52, 40],
                ..Self::ST7789
            },
        ),
        (
            "st7789-170x320",
            "ST7789, 170x320",
            Self {
                glass: [170, 320],
                offset: [35, 0],
                ..Self::ST7789
            },
        ),
        (
            "st7789-240x280",
            "ST7789, 240x280, round corners",
            Self {
                glass: [240, 280],
                offset: [0, 20],
                ..Self::ST7789
            },
        ),
        (
            "gc9a01",
            "GC9A01, 240x240, round",
            Self {
                controller: Controller::Gc9a01 as u32,
                memory: [240, 240],
                blue_first: 1,
                ..Self::ST7789
            },
        ),
        ("st7735-128x160", "ST7735, 128x160", Self::ST7735),
        (
            "st7735-80x160",
            "ST7735, 160x80",
            Self {
                glass: [80, 160],
                offset: [26, 1],
                rotation: 1,
                blue_first: 1,
                inverted: 1,
                ..Self::ST7735
            },
        ),
        (
            "ili9488",
            "ILI9488, 480x320",
            Self {
                controller: Controller::Ili9488 as u32,
                glass: [320, 480],
                memory: [320, 480],
                clock_hz: 27_000_000,
                ..Self::ILI9341
            },
        ),
        (
            "pico-lcd-1.3",
            "Waveshare Pico-LCD-1.3",
            Self {
                rotation: 1,
                pins: Self::WAVESHARE,
                ..Self::ST7789
            },
        ),
        (
            "pico-display",
            "Pimoroni Pico Display Pack, 240x135",
            Self {
                glass: [135, 240],
                offset: [52, 40],
                rotation: 1,
                pins: Self::PIMORONI,
                ..Self::ST7789
            },
        ),
        (
            "pico-display-2",
            "Pimoroni Pico Display Pack 2.0, 320x240",
            Self {
                rotation: 1,
                pins: Self::PIMORONI,
                ..Self::ST7789_TALL
            },
        ),
        (
            "pico-explorer",
            "Pimoroni Pico Explorer, 240x240",
            Self {
                pins: Wires {
                    light: NO_PIN,
                    ..Self::PIMORONI
                },
                ..Self::ST7789
            },
        ),
    ];

    /// The controller, or `None` if no controller has this number.
    #[must_use]
    pub const fn controller(&self) -> Option<Controller> {
        Some(match self.controller {
            0 => Controller::St7789,
            1 => Controller::Ili9341,
            2 => Controller::Gc9a01,
            3 => Controller::St7735,
            4 => Controller::Ili9488,
            _ => return None,
        })
    }

    /// The number of bytes that a pixel has on the bus.
    #[must_use]
    pub const fn bytes_of_pixel(&self) -> u32 {
        if self.controller == Controller::Ili9488 as u32 {
            3
        } else {
            2
        }
    }

    /// The picture's columns and rows, after the rotation.
    #[must_use]
    pub const fn size(&self) -> (u32, u32) {
        self.turned(self.glass)
    }

    /// The memory's columns and rows, after the rotation.
    #[must_use]
    pub const fn memory_size(&self) -> (u32, u32) {
        self.turned(self.memory)
    }

    /// The picture's first column and first row in memory, after the rotation.
    #[must_use]
    pub const fn origin(&self) -> (u32, u32) {
        let ([columns, rows], [width, height]) = (self.memory, self.glass);
        let [mut x, mut y] = self.offset;
        // The controller counts from the other side.
        if (self.rotation == 1 || self.rotation == 2) != (self.mirrored == 1) {
            x = columns.saturating_sub(width + x);
        }
        if self.rotation >= 2 {
            y = rows.saturating_sub(height + y);
        }
        self.turned([x, y])
    }

    const fn turned(&self, [x, y]: [u32; 2]) -> (u32, u32) {
        if self.rotation & 1 == 1 {
            (y, x)
        } else {
            (x, y)
        }
    }

    /// The number of the board's SPI block that the clock belongs to: 0 or 1.
    #[must_use]
    pub const fn block(&self) -> u32 {
        // Of each 16 pins, the first eight belong to block 0.
        self.pins.clock >> 3 & 1
    }

    /// Checks that a program can use this module.
    ///
    /// # Errors
    ///
    /// The first value that no program can use.
    pub fn check(&self) -> Result<(), ModuleProblem> {
        use ModuleProblem as Problem;
        self.controller().ok_or(Problem::Controller)?;
        let fits = |axis: usize| {
            let (glass, memory) = (self.glass[axis], self.memory[axis]);
            (1..=480).contains(&glass)
                && memory <= 480
                && self.offset[axis] <= memory
                && glass <= memory - self.offset[axis]
        };
        // The bus sends two bytes at a time, so a pixel of three bytes needs another one in its row.
        if !fits(0) || !fits(1) || (self.bytes_of_pixel() == 3 && self.size().0 & 1 == 1) {
            return Err(Problem::Size);
        }
        if self.rotation > 3 {
            return Err(Problem::Rotation);
        }
        let flags = [
            self.mirrored,
            self.blue_first,
            self.inverted,
            self.light_low,
        ];
        if flags.iter().any(|&flag| flag > 1) {
            return Err(Problem::Flag);
        }
        if self.spi_mode != 0 && self.spi_mode != 3 {
            return Err(Problem::Mode);
        }
        if !(1_000_000..=62_500_000).contains(&self.clock_hz) {
            return Err(Problem::Clock);
        }
        self.pins.check()
    }
}

impl Default for Module {
    fn default() -> Self {
        Self::ST7789
    }
}

impl Wires {
    fn check(&self) -> Result<(), ModuleProblem> {
        use ModuleProblem as Problem;
        let pins = [
            self.clock, self.data, self.dc, self.cs, self.reset, self.light,
        ];
        let is_used = |pin: u32| pin != NO_PIN;
        // GP23, GP24, GP25 and GP29 are not on the board's edge.
        let is_pin = |pin: u32| pin <= 28 && !(23..=25).contains(&pin);
        for (at, &pin) in pins.iter().enumerate() {
            if (at < 3 || is_used(pin)) && !is_pin(pin) {
                return Err(Problem::NoSuchPin(pin));
            }
            if is_used(pin) && pins[..at].contains(&pin) {
                return Err(Problem::PinTwice(pin));
            }
        }
        if self.clock & 3 != 2 {
            return Err(Problem::ClockPin(self.clock));
        }
        let (clock, data) = (self.clock, self.data);
        if data & 3 != 3 || (data ^ clock) & 8 != 0 {
            return Err(Problem::DataPin { clock, data });
        }
        if !is_used(self.cs) && !is_used(self.reset) {
            return Err(Problem::NoReset);
        }
        Ok(())
    }
}

/// Why no program can use a module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModuleProblem {
    /// The controller has an unknown number.
    Controller,
    /// The glass does not lie in the controller's memory, or is too large.
    Size,
    /// The rotation is more than three right angles.
    Rotation,
    /// A value that says yes or no is neither 0 nor 1.
    Flag,
    /// The bus has another mode than 0 and 3.
    Mode,
    /// The bus is too slow or too fast.
    Clock,
    /// The board has no such pin.
    NoSuchPin(u32),
    /// Two wires go to the same pin.
    PinTwice(u32),
    /// This pin cannot be a clock.
    ClockPin(u32),
    /// These pins do not belong to one SPI block.
    DataPin {
        /// The clock's pin.
        clock: u32,
        /// The data's pin.
        data: u32,
    },
    /// There is neither CS nor a reset.
    NoReset,
}

impl fmt::Display for ModuleProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Controller => f.write_str("the controller is unknown"),
            Self::Size => f.write_str(
                "the glass must lie in the controller's memory, with at most 480 columns and rows",
            ),
            Self::Rotation => f.write_str("the rotation must be 0, 1, 2 or 3 right angles"),
            Self::Flag => f.write_str("a value that says yes or no must be 1 or 0"),
            Self::Mode => f.write_str("the mode of SPI must be 0 or 3"),
            Self::Clock => f.write_str("the bus must have 1000000 to 62500000 Hz"),
            Self::NoSuchPin(pin) if pin == NO_PIN => {
                f.write_str("clock, data and DC must be wired")
            }
            Self::NoSuchPin(pin) => write!(f, "the board has no pin GP{pin} for wires"),
            Self::PinTwice(pin) => write!(f, "two wires go to GP{pin}"),
            Self::ClockPin(pin) => write!(
                f,
                "GP{pin} cannot be the clock: GP2, 6, 18 and 22 (SPI 0) and GP10, 14 and 26 (SPI 1) can"
            ),
            Self::DataPin { clock, data } => {
                let block = clock >> 3 & 1;
                let pins = ["GP3, 7 and 19", "GP11, 15 and 27"][block as usize];
                write!(
                    f,
                    "GP{data} cannot be the data: the clock GP{clock} belongs to SPI {block}, so {pins} can"
                )
            }
            Self::NoReset => f.write_str("either CS or the reset must be wired"),
        }
    }
}

#[cfg(feature = "write")]
impl Module {
    /// Reads the name of a module and, after commas, values that replace its own: `pico-display,rotation=3,light=none`.
    ///
    /// # Errors
    ///
    /// No module has this name, nothing has the name before a `=`, or no program can use the module.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut words = text.split(',');
        let name = words.next().unwrap_or_default();
        let found = Self::ALL.iter().find(|(known, ..)| *known == name);
        let Some(&(.., mut module)) = found else {
            let names = Self::ALL.map(|(name, ..)| name).join(", ");
            return Err(format!("there is no module {name}: there are {names}"));
        };
        for word in words {
            module.set(word)?;
        }
        module
            .check()
            .map_err(|problem| format!("{text}: {problem}"))?;
        Ok(module)
    }

    fn set(&mut self, word: &str) -> Result<(), String> {
        let (name, value) = word
            .split_once('=')
            .ok_or_else(|| format!("{word} is not of the form name=value"))?;
        let numbers: Option<Vec<u32>> = value
            .split('x')
            .map(|number| match number {
                "none" => Some(NO_PIN),
                _ => number.parse().ok(),
            })
            .collect();
        let number = |to: &mut u32| match numbers.as_deref() {
            Some(&[number]) => {
                *to = number;
                Ok(())
            }
            _ => Err(format!("{value} is no value for {name}: a number is")),
        };
        let pair = |to: &mut [u32; 2]| match numbers.as_deref() {
            Some(&[x, y]) => {
                *to = [x, y];
                Ok(())
            }
            _ => Err(format!(
                "{value} is no value for {name}: two numbers with an x are"
            )),
        };
        match name {
            "size" => pair(&mut self.glass),
            "memory" => pair(&mut self.memory),
            "offset" => pair(&mut self.offset),
            "rotation" => number(&mut self.rotation),
            "mirrored" => number(&mut self.mirrored),
            "blue_first" => number(&mut self.blue_first),
            "inverted" => number(&mut self.inverted),
            "mode" => number(&mut self.spi_mode),
            "hz" => number(&mut self.clock_hz),
            "clock" => number(&mut self.pins.clock),
            "data" => number(&mut self.pins.data),
            "dc" => number(&mut self.pins.dc),
            "cs" => number(&mut self.pins.cs),
            "reset" => number(&mut self.pins.reset),
            "light" => number(&mut self.pins.light),
            "light_low" => number(&mut self.light_low),
            _ => Err(format!(
                "nothing is named {name}: size, memory, offset, rotation, mirrored, blue_first, inverted, mode, hz, \
                 clock, data, dc, cs, reset, light and light_low are"
            )),
        }
    }
}
