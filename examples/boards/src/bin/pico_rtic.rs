//! A Raspberry Pi Pico (RP2040) and an ST7789, with RTIC: `idle` draws, and the task of the DMA's interrupt sends.
#![no_std]
#![no_main]

use panic_halt as _;

/// The second-stage boot loader, which the chip runs first to set up its flash.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_GENERIC_03H;

#[rtic::app(device = rp2040_hal::pac)]
mod app {
    use boards::pico::{BANDS_OF_FRAME, Band, Board, Display, HEIGHT, ROWS, State, WIDTH, set_up};
    use boards::scene::{Memory, Scene};
    use embedded_graphics::pixelcolor::Rgb565;
    use fixel::canvas::{Canvas, Words};
    use heapless::spsc::{Consumer, Producer, Queue};
    use rp2040_hal::Timer;
    use rp2040_hal::dma::{SingleChannel, single_buffer::Config};
    use rp2040_hal::pac::Interrupt;

    #[shared]
    struct Shared {}

    #[local]
    struct Local {
        timer: Timer,
        finished: Producer<'static, Band>,
        free: Consumer<'static, Band>,
        bus: Bus,
    }

    /// The end of the bands' way. `start` is the number in its frame of the band that is started next.
    pub struct Bus {
        panel: Display,
        state: Option<State>,
        start: u32,
        finished: Consumer<'static, Band>,
        free: Producer<'static, Band>,
    }

    // A queue holds one element less than it has room for.
    #[init(local = [there: Queue<Band, 4> = Queue::new(), back: Queue<Band, 4> = Queue::new()])]
    fn init(context: init::Context) -> (Shared, Local) {
        let Board {
            timer,
            panel,
            state,
            bands,
            ..
        } = set_up(context.device).unwrap();
        let (finished, to_send) = context.local.there.split();
        let (mut sent, free) = context.local.back.split();
        for band in bands {
            sent.enqueue(band).ok();
        }
        let state = Some(state);
        let bus = Bus {
            panel,
            state,
            start: 0,
            finished: to_send,
            free: sent,
        };
        (
            Shared {},
            Local {
                timer,
                finished,
                free,
                bus,
            },
        )
    }

    /// Draws, whenever no interrupt is handled.
    #[idle(local = [timer, finished, free])]
    fn idle(context: idle::Context) -> ! {
        let local = context.local;
        let (scene, mut memory) = (Scene::new(WIDTH, HEIGHT).unwrap(), Memory::new());
        loop {
            let now_ms = local.timer.get_counter().ticks() / 1000;
            let moment = scene.at(now_ms, &mut memory).unwrap();
            for first_row in (0..HEIGHT).step_by(ROWS as usize) {
                let band = loop {
                    if let Some(band) = local.free.dequeue() {
                        break band;
                    }
                };
                let pixels = band.as_mut_slice();
                let canvas = Canvas::<Rgb565, Words>::band(pixels, WIDTH, HEIGHT, first_row);
                moment.draw(&mut canvas.unwrap());
                local.finished.enqueue(band).ok();
                rtic::pend(Interrupt::DMA_IRQ_0);
            }
        }
    }

    /// A band was sent, or another one is finished: sends the next.
    #[task(binds = DMA_IRQ_0, local = [bus])]
    fn send(context: send::Context) {
        let Bus {
            panel,
            state,
            start,
            finished,
            free,
        } = context.local.bus;
        let (channel, mut bus) = match state.take() {
            Some(State::Sends(transfer)) if transfer.is_done() => {
                let (mut channel, band, bus) = transfer.wait();
                channel.check_irq0();
                free.enqueue(band).ok();
                (channel, bus)
            }
            Some(State::Idle(channel, bus)) => (channel, bus),
            sends => return *state = sends,
        };
        let Some(band) = finished.dequeue() else {
            return *state = Some(State::Idle(channel, bus));
        };
        if *start == 0 {
            panel.start_frame(&mut bus).ok(); // this chip's pins and bus return no errors
        }
        *start = (*start + 1) % BANDS_OF_FRAME;
        *state = Some(State::Sends(Config::new(channel, band, bus).start()));
    }
}
