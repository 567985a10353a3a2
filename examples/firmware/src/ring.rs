//! The ring of the guide for firmware, in its frame of 240x240 pixels. Measures a frame in bands of each height,
//! prepared or not, with three shaders. The cost is the mean of eight poses, and includes only the draw calls. Then
//! measures the needle of the guide for displays: the whole frame, and the mean of 60 steps.
//!
//! `cargo run --profile speed -p firmware --bin ring --target thumbv6m-none-eabi` runs the program under QEMU.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod board;
#[cfg(target_os = "none")]
#[allow(dead_code)] // the program has a loop of its own
#[path = "../../cookbook/src/displays/needle.rs"]
mod needle;
#[cfg(target_os = "none")]
#[allow(dead_code)] // what programs that draw these scenes need
#[path = "../../common/scenes.rs"]
mod scenes;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("ring runs on a microcontroller: add --target thumbv6m-none-eabi");
}

#[cfg(target_os = "none")]
mod firmware {
    use core::convert::Infallible;

    use embedded_graphics::draw_target::DrawTarget;
    use embedded_graphics::geometry::{OriginDimensions, Size};
    use embedded_graphics::pixelcolor::{Rgb565, RgbColor, raw::BigEndian};
    use embedded_graphics::primitives::Rectangle;
    use fixel::mode::{Fast, Mode};
    use fixel::prelude::*;
    use semihosting::println;
    use static_cell::ConstStaticCell;

    use super::board::{self, Clock};
    use super::needle;
    use super::scenes::CHECKER;

    const WIDTH: u32 = 240;
    const HEIGHT: u32 = 240;
    const POSES: u64 = 8;
    const PIXELS: usize = (WIDTH * HEIGHT) as usize;
    static COLORS: ConstStaticCell<[[u8; 2]; PIXELS]> = ConstStaticCell::new([[0; 2]; PIXELS]);
    static DEPTHS: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);
    static LIST: ConstStaticCell<List> = ConstStaticCell::new(List::new());
    static RING: Mesh = shape!(torus(fx!(0.4), 24, 12));

    /// A list with the length that the guide states.
    type List = DrawList<300, 300>;

    struct Bench {
        clock: Clock,
        tick: u64,
        colors: &'static mut [[u8; 2]; PIXELS],
        depths: &'static mut [u16; PIXELS],
        list: &'static mut List,
    }

    impl Bench {
        /// Prints a line for each kind of band.
        fn measure<M: Mode, S: ShaderFor<Rgb565>>(
            &mut self,
            name: &str,
            options: &DrawOptions<M>,
            shader: &S,
        ) -> Result<(), Error> {
            for (rows, is_prepared) in [
                (240, false),
                (40, false),
                (40, true),
                (16, false),
                (16, true),
            ] {
                let ticks = self.frames(options, shader, rows, is_prepared)?;
                let layout = if is_prepared { "prepared" } else { "bands" };
                let each = ticks * self.tick / POSES;
                println!("ring={name} rows={rows} layout={layout} instructions={each}");
            }
            Ok(())
        }

        /// The ticks of all poses together.
        fn frames<M: Mode, S: ShaderFor<Rgb565>>(
            &mut self,
            options: &DrawOptions<M>,
            shader: &S,
            rows: u32,
            is_prepared: bool,
        ) -> Result<u64, Error> {
            let projection = Projection::perspective(deg!(50), (WIDTH, HEIGHT), fx!(0.5), fx!(20))?;
            let camera = Camera::look_at(vec3!(0, 2, 3), Vec3::ZERO, Vec3::Y)?;
            let len = (rows * WIDTH) as usize;
            let mut all = 0;
            for pose in 0..POSES {
                // A full turn takes six seconds.
                let turn = Transform::rotate_x(Rate::rpm(10).angle_at(pose * 6000 / POSES));
                let mvp = projection * camera * turn;
                let mut prepared = None;
                if is_prepared {
                    let list = &mut *self.list;
                    let (ring, ticks) = self
                        .clock
                        .time(|| list.prepare(options, (WIDTH, HEIGHT), &RING, &mvp));
                    prepared = Some(ring?);
                    all += ticks;
                }
                for first_row in (0..HEIGHT).step_by(rows as usize) {
                    let colors = &mut self.colors[..len];
                    let band: Canvas<Rgb565, BigEndian> =
                        Canvas::band(colors, WIDTH, HEIGHT, first_row)?;
                    let mut band = band.with_depth(&mut self.depths[..len])?;
                    band.clear(Rgb565::BLACK);
                    let (drawn, ticks) = self.clock.time(|| match &prepared {
                        Some(ring) => band.draw_prepared(ring, shader),
                        None => Ok(band.draw_with(options, &RING, &mvp, shader)),
                    });
                    drawn?;
                    all += ticks;
                }
            }
            Ok(all)
        }
    }

    /// A display that takes no time.
    struct Nowhere;

    impl OriginDimensions for Nowhere {
        fn size(&self) -> Size {
            needle::FRAME.size
        }
    }

    impl DrawTarget for Nowhere {
        type Color = Rgb565;
        type Error = Infallible;

        fn draw_iter<I>(&mut self, _: I) -> Result<(), Infallible> {
            Ok(())
        }

        fn fill_contiguous<I>(&mut self, _: &Rectangle, _: I) -> Result<(), Infallible> {
            Ok(())
        }
    }

    fn needle(clock: &mut Clock, tick: u64) -> Result<(), Error> {
        let mut all = 0;
        for step in 0..60 {
            let [from, to] = [step, step + 1].map(|step| Angle::from_degrees(6 * step));
            let (shown, ticks) = clock.time(|| {
                let changed = needle::changed(from, to)?;
                needle::show(&mut Nowhere, changed, to)
            });
            shown?;
            all += ticks;
        }
        let (shown, ticks) = clock.time(|| needle::show(&mut Nowhere, needle::FRAME, deg!(0)));
        shown?;
        println!("needle=whole instructions={}", ticks * tick);
        println!("needle=step instructions={}", all * tick / 60);
        Ok(())
    }

    fn run() -> Result<(), Error> {
        let mut clock = Clock::take().expect("taken once");
        let tick = board::instructions_per_tick(&mut clock);
        let (colors, depths, list) = (COLORS.take(), DEPTHS.take(), LIST.take());
        let mut bench = Bench {
            clock,
            tick,
            colors,
            depths,
            list,
        };
        let sun = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?;
        let fast = DrawOptions::new().with_mode(Fast::within(fx!(0.25)));
        let skin = Textured::new(&CHECKER).lit(sun);
        let orange = Flat::new(Rgb565::new(31, 40, 8)).lit_faces(sun);
        bench.measure("faces", &DrawOptions::new(), &orange)?;
        bench.measure("fast", &fast, &skin)?;
        bench.measure("newton", &DrawOptions::new(), &skin)?;
        needle(&mut bench.clock, tick)
    }

    #[board::entry]
    fn main() -> ! {
        board::exit(run())
    }
}
