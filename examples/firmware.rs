//! The measured scenes on a Cortex-M: the same pixels as on the host, in whole frames and in bands.
//!
//! `cargo run --release --example firmware --target thumbv7em-none-eabi` runs it under QEMU, which
//! must be installed with its Arm boards, as must be `ld.lld`. For each scene and layout it prints
//! the instructions that drawing took, in ticks of 40, and a checksum of the picture.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() {
    println!("firmware runs on a microcontroller: add --target thumbv7em-none-eabi");
}

#[cfg(target_os = "none")]
#[path = "common/mod.rs"]
mod common;

#[cfg(target_os = "none")]
mod firmware {
    use cortex_m::peripheral::{Peripherals, SYST, syst::SystClkSource};
    use cortex_m_rt::entry;
    use embedded_graphics::pixelcolor::raw::BigEndian;
    use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    use fixel::prelude::*;
    use fixel::target::DepthBuffer;
    use fixel::view::Perspective;
    use semihosting::{println, process};

    use super::common::lighthouse;
    use super::common::scenes::{self, HEIGHT, WIDTH};

    const PIXELS: usize = (WIDTH * HEIGHT) as usize;
    /// Rows of a band.
    const BAND: u32 = 16;

    /// SysTick counts down through 24 bits.
    const MOST: u32 = 0x00ff_ffff;

    /// CRC-32 (IEEE 802.3) of the bytes of pictures, bit by bit: it is not what is measured.
    struct Crc(u32);

    impl Crc {
        fn add(&mut self, bytes: &[u8]) {
            for &byte in bytes {
                self.0 ^= u32::from(byte);
                for _ in 0..8 {
                    self.0 = self.0 >> 1 ^ (0xedb8_8320 & (self.0 & 1).wrapping_neg());
                }
            }
        }
    }

    type Color<'a, D> = Canvas<'a, Rgb565, BigEndian, D>;

    /// What is drawn, into any canvas: a scene in its first pose.
    #[derive(Clone, Copy)]
    enum Scene {
        Floor,
        Cube,
        Sphere,
        SphereFlat,
        Lighthouse,
    }

    impl Scene {
        const ALL: [(Self, &'static str); 5] = [
            (Self::Floor, "floor"),
            (Self::Cube, "cube"),
            (Self::Sphere, "sphere"),
            (Self::SphereFlat, "sphere-flat"),
            (Self::Lighthouse, "default"),
        ];

        fn chain(self) -> Result<Chain<Perspective>, Error> {
            match self {
                Self::Floor => scenes::floor_chain(0),
                Self::Cube => scenes::cube_chain(0),
                Self::Sphere | Self::SphereFlat => scenes::sphere_chain(0),
                Self::Lighthouse => Ok(lighthouse::lens((WIDTH, HEIGHT))?
                    * lighthouse::camera()?
                    * Transform::IDENTITY),
            }
        }

        /// Clears the canvas and draws; returns triangles drawn and ticks that drawing took.
        fn draw<D: DepthBuffer>(
            self,
            canvas: &mut Color<'_, D>,
            timer: &SYST,
        ) -> Result<(u32, u32), Error> {
            let chain = self.chain()?;
            match self {
                Self::Lighthouse => lighthouse::sky(canvas),
                _ => canvas.clear(Rgb565::BLACK),
            }
            let start = timer.cvr.read();
            let drawn = match self {
                Self::Floor => scenes::floor(canvas, &chain).drawn,
                Self::Cube => scenes::cube(canvas, &chain).drawn,
                Self::Sphere => scenes::sphere(canvas, &chain).drawn,
                Self::SphereFlat => scenes::sphere_flat(canvas, &chain).drawn,
                Self::Lighthouse => {
                    let [sea, island] = lighthouse::draw(canvas, &chain)?;
                    sea.drawn + island.drawn
                }
            };
            // No scene takes the timer's whole range of 2^24 ticks.
            let ticks = start.wrapping_sub(timer.cvr.read()) & MOST;
            if let Self::Lighthouse = self {
                lighthouse::caption(canvas);
            }
            Ok((drawn, ticks))
        }
    }

    /// Draws `scene` in strips of `rows` rows; returns triangles, ticks and checksum.
    fn frame(
        scene: Scene,
        rows: u32,
        (pixels, depths): (&mut [[u8; 2]], &mut [u16]),
        timer: &SYST,
    ) -> Result<(u32, u32, u32), Error> {
        let (mut triangles, mut ticks, mut crc) = (0, 0, Crc(!0));
        let strip = (rows * WIDTH) as usize;
        for band in 0..HEIGHT / rows {
            let canvas: Color<_> =
                Canvas::big_endian_band(&mut pixels[..strip], WIDTH, HEIGHT, band * rows)?;
            let drawn = if let Scene::SphereFlat = scene {
                let mut canvas = canvas;
                let drawn = scene.draw(&mut canvas, timer)?;
                crc.add(canvas.bytes());
                drawn
            } else {
                let mut canvas = canvas.with_depth(&mut depths[..strip])?;
                let drawn = scene.draw(&mut canvas, timer)?;
                crc.add(canvas.bytes());
                drawn
            };
            triangles += drawn.0;
            ticks += drawn.1;
        }
        Ok((triangles, ticks, !crc.0))
    }

    fn run() -> Result<(), Error> {
        let mut timer = Peripherals::take().expect("taken once").SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(MOST);
        timer.clear_current();
        timer.enable_counter();
        // On the stack, which has all of the board's memory.
        let mut pixels = [[0; 2]; PIXELS];
        let mut depths = [0; PIXELS];
        for (scene, name) in Scene::ALL {
            for (layout, rows) in [("frame", HEIGHT), ("bands", BAND)] {
                let (triangles, ticks, crc) =
                    frame(scene, rows, (&mut pixels, &mut depths), &timer)?;
                println!(
                    "scene={} mode=exact layout={} triangles={} ticks={} crc={:08x}",
                    name, layout, triangles, ticks, crc
                );
            }
        }
        Ok(())
    }

    #[entry]
    fn main() -> ! {
        match run() {
            Ok(()) => process::exit(0),
            Err(error) => {
                println!("{}", error);
                process::exit(1)
            }
        }
    }

    #[panic_handler]
    fn panic(info: &core::panic::PanicInfo<'_>) -> ! {
        println!("{}", info);
        process::exit(1)
    }
}
