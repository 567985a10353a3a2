//! The registers of the LM3S6965 that drive the panel. The registers have the names that the data sheet gives them.
//!
//! The clock, select and data lines of the panel are pins A2, A3 and A5, which belong to the serial interface SSI0. Pin
//! C7 says whether a byte is a command. D0 selects the SD card on the same wires.

use cortex_m::asm;

/// A register of 32 bits at this address.
struct Register(usize);

impl Register {
    #[allow(unsafe_code)]
    fn read(&self) -> u32 {
        let address = self.0 as *const u32;
        // SAFETY: every address is one of the constants below, and these are aligned addresses of the chip's registers.
        // Reading a register has an effect only on its peripheral.
        unsafe { address.read_volatile() }
    }

    #[allow(unsafe_code)]
    fn write(&self, value: u32) {
        let address = self.0 as *mut u32;
        // SAFETY: the address is valid as above. The peripherals to which the program writes cannot access memory,
        // because neither DMA nor an interrupt is enabled.
        unsafe { address.write_volatile(value) }
    }

    fn set(&self, bits: u32) {
        self.write(self.read() | bits);
    }
}

/// A port of eight pins.
struct Port(usize);

impl Port {
    /// Makes `pin` an output that software drives, with this level.
    fn output(&self, pin: u32, high: bool) {
        Register(self.0 + 0x400).set(1 << pin); // GPIODIR
        Register(self.0 + 0x51c).set(1 << pin); // GPIODEN
        self.write(pin, high);
    }

    /// Connects `pins` to their peripheral.
    fn alternate(&self, pins: u32) {
        Register(self.0 + 0x420).set(pins); // GPIOAFSEL
        Register(self.0 + 0x51c).set(pins); // GPIODEN
    }

    fn write(&self, pin: u32, high: bool) {
        // GPIODATA: bits 9 to 2 of the address select the pins to write.
        Register(self.0 + (4 << pin)).write(u32::from(high) << pin);
    }
}

/// The registers that switch on the clocks of SSI0, and of ports A, C and D.
const RCGC1: Register = Register(0x400f_e104);
const RCGC2: Register = Register(0x400f_e108);

const PORT_A: Port = Port(0x4000_4000);
const PORT_C: Port = Port(0x4000_6000);
const PORT_D: Port = Port(0x4000_7000);

const SSICR0: Register = Register(0x4000_8000);
const SSICR1: Register = Register(0x4000_8004);
const SSIDR: Register = Register(0x4000_8008);
const SSISR: Register = Register(0x4000_800c);
const SSICPSR: Register = Register(0x4000_8010);

/// Bits of SSISR: there is room for a byte to send, a byte was received, the interface is busy.
const TNF: u32 = 1 << 1;
const RNE: u32 = 1 << 2;
const BSY: u32 = 1 << 4;

/// The wires to the panel. The board has only one panel.
pub struct Oled(());

impl Oled {
    /// Sets up the pins and the interface. Call it only once.
    pub fn new() -> Self {
        RCGC1.set(1 << 4);
        RCGC2.set(1 << 0 | 1 << 2 | 1 << 3);
        // A peripheral can be accessed from the third cycle after its clock has started.
        asm::delay(3);

        PORT_D.output(0, true);
        PORT_C.output(7, true);
        PORT_A.alternate(1 << 2 | 1 << 3 | 1 << 5);

        // The chip starts at 12 MHz. Use a quarter of this frequency, because the panel allows 4 MHz.
        SSICR1.write(0);
        SSICPSR.write(4);
        // A byte has eight bits. The clock is high when idle, and the panel samples at its rising edge.
        SSICR0.write(1 << 7 | 1 << 6 | 7);
        SSICR1.write(1 << 1);
        Self(())
    }

    /// Sends a command and its arguments.
    pub fn command(&mut self, bytes: &[u8]) {
        PORT_C.write(7, false);
        self.send(bytes);
    }

    /// Sends pixels.
    pub fn data(&mut self, bytes: &[u8]) {
        PORT_C.write(7, true);
        self.send(bytes);
    }

    /// Sends bytes. Returns when the last byte has been sent, because the panel samples pin C7 with the last bit of a
    /// byte.
    #[allow(clippy::unused_self)] // `self` owns the interface
    fn send(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            while SSISR.read() & TNF == 0 {}
            SSIDR.write(byte.into());
            // For each byte sent, the interface also receives a byte, although the panel sends none. QEMU waits until
            // the received bytes are read.
            while SSISR.read() & RNE != 0 {
                SSIDR.read();
            }
        }
        while SSISR.read() & (BSY | RNE) != 0 {
            SSIDR.read();
        }
    }
}
