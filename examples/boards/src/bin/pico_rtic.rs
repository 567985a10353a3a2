//! A Raspberry Pi Pico (RP2040) and an ST7789, with RTIC: `idle` draws, and the task of the DMA's interrupt sends.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use boards::pico::{MODULE, report};

#[rtic::app(device = rp2040_hal::pac)]
mod app {
    use boards::led;
    use boards::pico::{Band, HEIGHT, MODULE, Output, ROWS, Sender, Timer, WIDTH, set_up};
    use boards::scene::{Memory, Scene};
    use embedded_graphics::pixelcolor::Rgb565;
    use fixel::canvas::{Canvas, Words};
    use heapless::spsc::{Consumer, Producer, Queue};
    use rp2040_hal::pac::Interrupt;

    #[shared]
    struct Shared {}

    /// A band is free, drawn into, finished, sent, and free again. Each half of the way has its task.
    #[local]
    struct Local {
        timer: Timer,
        led: Output,
        free: Consumer<'static, Band>,
        finished: Producer<'static, Band>,
        to_send: Consumer<'static, Band>,
        sent: Producer<'static, Band>,
        sender: Sender,
    }

    // A queue holds one element less than it has room for.
    #[init(local = [there: Queue<Band, 4> = Queue::new(), back: Queue<Band, 4> = Queue::new()])]
    fn init(context: init::Context) -> (Shared, Local) {
        let board = set_up(context.device, &MODULE).unwrap();
        let (finished, to_send) = context.local.there.split();
        let (mut sent, free) = context.local.back.split();
        for band in board.bands {
            sent.enqueue(band).ok();
        }
        let local = Local {
            timer: board.timer,
            led: board.led,
            free,
            finished,
            to_send,
            sent,
            sender: board.sender,
        };
        (Shared {}, local)
    }

    /// Draws, whenever no interrupt is handled.
    #[idle(local = [timer, led, free, finished])]
    fn idle(context: idle::Context) -> ! {
        let local = context.local;
        let (scene, mut memory) = (Scene::new(WIDTH, HEIGHT).unwrap(), Memory::new());
        loop {
            let now_ms = local.timer.get_counter().ticks() / 1000;
            led::show(local.led, led::RUNS, now_ms);
            let moment = scene.at(now_ms, &mut memory).unwrap();
            for first_row in (0..HEIGHT).step_by(ROWS as usize) {
                while !local.free.ready() {}
                let band = local.free.dequeue().unwrap();
                let canvas = Canvas::<Rgb565, Words>::band(&mut band[..], WIDTH, HEIGHT, first_row);
                moment.draw(&mut canvas.unwrap());
                local.finished.enqueue(band).ok();
                rtic::pend(Interrupt::DMA_IRQ_0);
            }
        }
    }

    /// A band was sent, or another one is finished: sends the next.
    #[task(binds = DMA_IRQ_0, local = [to_send, sent, sender])]
    fn send(context: send::Context) {
        let local = context.local;
        if let Some(band) = local.sender.sent() {
            local.sent.enqueue(band).ok();
        }
        local.sender.start(|| local.to_send.dequeue());
    }
}

/// Shows the panic on the display and by the LED.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    report(info, &MODULE)
}
