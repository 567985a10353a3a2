//! Wires that record everything that is sent over them.
//!
//! The bus sends bytes, or words of 16 bits, as two bytes each. It sends as late as it may, when it is flushed. So a
//! pin that changes too early changes the meaning of bytes, as it does on a chip whose bus has a queue.

use std::cell::RefCell;
use std::convert::Infallible;
use std::fmt::Write;
use std::rc::Rc;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{self, OutputPin};
use embedded_hal::spi::{self, SpiBus};

use super::display::Command;

/// Both ends of the wires, and the chip's delay.
#[derive(Clone, Default)]
pub struct Wires(Rc<RefCell<Record>>);

#[derive(Default)]
struct Record {
    /// Levels of the pins.
    cs: bool,
    dc: bool,
    /// Bytes that the chip has given to the bus and that the bus has not sent yet.
    queue: Vec<u8>,
    commands: Vec<Command>,
    log: String,
}

impl Record {
    fn flush(&mut self) {
        for byte in self.queue.drain(..) {
            assert!(!self.cs, "{byte:#04x} was sent while no display listened");
            if self.dc {
                let command = self.commands.last_mut();
                command
                    .expect("data bytes follow a command")
                    .data
                    .push(byte);
                write!(self.log, " {byte:02x}").unwrap();
            } else if byte != 0 {
                // 0 is the command to do nothing.
                self.commands.push(Command {
                    code: byte,
                    data: vec![],
                    start: 0,
                });
                write!(self.log, "\n{byte:02x}").unwrap();
            }
        }
    }
}

impl Wires {
    pub fn select(&self) -> Pin {
        Pin(self.clone(), |record, high| record.cs = high)
    }

    pub fn data(&self) -> Pin {
        Pin(self.clone(), |record, high| record.dc = high)
    }

    pub fn reset(&self) -> Pin {
        Pin(self.clone(), |record, high| {
            let level = if high { "high" } else { "low" };
            write!(record.log, "\nreset {level}").unwrap();
        })
    }

    /// The commands so far, each with its data.
    pub fn commands(&self) -> Vec<Command> {
        let record = &mut *self.0.borrow_mut();
        record.flush();
        std::mem::take(&mut record.commands)
    }

    /// The commands as text, with waits and resets.
    pub fn log(&self) -> String {
        let record = &mut *self.0.borrow_mut();
        record.flush();
        record.log.trim_start().into()
    }
}

impl spi::ErrorType for Wires {
    type Error = Infallible;
}

macro_rules! bus {
    ($word:ty) => {
        impl SpiBus<$word> for Wires {
            fn write(&mut self, words: &[$word]) -> Result<(), Infallible> {
                let bytes = words.iter().flat_map(|word| word.to_be_bytes());
                self.0.borrow_mut().queue.extend(bytes);
                Ok(())
            }

            fn flush(&mut self) -> Result<(), Infallible> {
                self.0.borrow_mut().flush();
                Ok(())
            }

            fn read(&mut self, _: &mut [$word]) -> Result<(), Infallible> {
                unreachable!("there is no line back")
            }

            fn transfer(&mut self, _: &mut [$word], _: &[$word]) -> Result<(), Infallible> {
                unreachable!("there is no line back")
            }

            fn transfer_in_place(&mut self, _: &mut [$word]) -> Result<(), Infallible> {
                unreachable!("there is no line back")
            }
        }
    };
}
bus!(u8);
bus!(u16);

impl DelayNs for Wires {
    fn delay_ns(&mut self, ns: u32) {
        write!(self.0.borrow_mut().log, "\nwait {} us", ns / 1000).unwrap();
    }
}

/// An output pin of the chip, and the effect of its level on the record.
pub struct Pin(Wires, fn(&mut Record, bool));

impl digital::ErrorType for Pin {
    type Error = Infallible;
}

impl OutputPin for Pin {
    fn set_low(&mut self) -> Result<(), Infallible> {
        (self.1)(&mut self.0.0.borrow_mut(), false);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        (self.1)(&mut self.0.0.borrow_mut(), true);
        Ok(())
    }
}
