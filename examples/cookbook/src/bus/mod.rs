//! Wires that record the bytes of a driver, and models of the panels at the other end of the wires.
//!
//! A driver from another project gets [`Wires`] in place of a bus and pins. A model of a controller then reads the
//! record as the controller's data sheet says, and shows what the panel would show. No model uses code of a driver or
//! of fixel.

// A model panics if it gets a command that its panel would not understand.
#![allow(clippy::missing_panics_doc, clippy::must_use_candidate)]

pub mod mipi;
pub mod ssd1306;
pub mod ssd1680;
pub mod tearing;

use std::cell::RefCell;
use std::convert::Infallible;
use std::mem;
use std::rc::Rc;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{self, InputPin, OutputPin};
use embedded_hal::spi::{self, Operation, SpiDevice};

use mipi::Command;

/// A bus that can only write, with its D/C line. All clones are connected to the same wires.
#[derive(Clone, Default)]
pub struct Wires(Rc<RefCell<Record>>);

#[derive(Default)]
struct Record {
    is_data: bool,
    transactions: usize,
    now: u64,
    runs: Vec<Run>,
}

/// Bytes that follow each other without a change of D/C.
pub struct Run {
    /// Whether D/C was high, so that the bytes are data, not commands.
    pub is_data: bool,
    /// The bytes in the order in which they were sent.
    pub bytes: Vec<u8>,
    /// The time at which the first byte began, in units of the time that the bus takes for a byte.
    pub start: u64,
}

/// Returns the bytes on the wires as commands.
pub fn commands(runs: Vec<Run>) -> Vec<Command> {
    let mut commands: Vec<Command> = vec![];
    for Run {
        is_data,
        bytes,
        start,
    } in runs
    {
        if is_data {
            let command = commands.last_mut().expect("data bytes follow a command");
            if command.data.is_empty() {
                command.start = start;
            }
            command.data.extend(bytes);
        } else {
            commands.extend(bytes.into_iter().map(|code| Command {
                code,
                data: vec![],
                start,
            }));
        }
    }
    commands
}

impl Wires {
    /// Returns everything that was sent since the last call.
    pub fn take(&self) -> Vec<Run> {
        mem::take(&mut self.0.borrow_mut().runs)
    }

    /// Returns the number of transactions so far: how often a driver has taken the bus.
    pub fn transactions(&self) -> usize {
        self.0.borrow().transactions
    }

    /// Returns the number of bytes that the bus could have sent so far.
    pub fn now(&self) -> u64 {
        self.0.borrow().now
    }

    /// Waits for as long as the bus takes to send this many bytes. Nothing is sent in this time.
    pub fn wait(&self, bytes: u64) {
        self.0.borrow_mut().now += bytes;
    }
}

impl spi::ErrorType for Wires {
    type Error = Infallible;
}

impl SpiDevice for Wires {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let Record {
            is_data,
            transactions,
            now,
            runs,
        } = &mut *self.0.borrow_mut();
        *transactions += 1;
        for operation in operations {
            let Operation::Write(bytes) = operation else {
                panic!("the panel has no line to read from");
            };
            match runs.last_mut() {
                Some(run)
                    if run.is_data == *is_data && run.start + run.bytes.len() as u64 == *now =>
                {
                    run.bytes.extend_from_slice(bytes);
                }
                _ => runs.push(Run {
                    is_data: *is_data,
                    bytes: bytes.to_vec(),
                    start: *now,
                }),
            }
            *now += bytes.len() as u64;
        }
        Ok(())
    }
}

impl embedded_hal_async::spi::SpiDevice for Wires {
    async fn transaction(
        &mut self,
        operations: &mut [Operation<'_, u8>],
    ) -> Result<(), Infallible> {
        // The bus is busy until the program has done something else, as if a DMA channel were sending.
        embassy_futures::yield_now().await;
        SpiDevice::transaction(self, operations)
    }
}

/// The D/C line.
impl digital::ErrorType for Wires {
    type Error = Infallible;
}

impl OutputPin for Wires {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().is_data = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().is_data = true;
        Ok(())
    }
}

/// A pin that is connected to nothing. A driver gets this pin if the panel is always ready or needs no reset. The pin
/// reads as low.
pub struct Unconnected;

impl digital::ErrorType for Unconnected {
    type Error = Infallible;
}

impl OutputPin for Unconnected {
    fn set_low(&mut self) -> Result<(), Infallible> {
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl InputPin for Unconnected {
    fn is_high(&mut self) -> Result<bool, Infallible> {
        Ok(false)
    }

    fn is_low(&mut self) -> Result<bool, Infallible> {
        Ok(true)
    }
}

/// A delay that returns at once.
pub struct NoDelay;

impl DelayNs for NoDelay {
    fn delay_ns(&mut self, _: u32) {}
}

impl embedded_hal_async::delay::DelayNs for NoDelay {
    async fn delay_ns(&mut self, _: u32) {}
}
