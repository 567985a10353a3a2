//! Draws a scene in a layout, and takes its figures.

use crc32fast::Hasher;
use fixel::prelude::*;
use fixel::target::DepthBuffer;
use fixel::view::Perspective;
use static_cell::ConstStaticCell;

use super::board::Clock;
use super::common::scenes::{HEIGHT, WIDTH};
use super::common::stack;
use super::scene::{Scene, Target};

const PIXELS: usize = (WIDTH * HEIGHT) as usize;
static COLORS: ConstStaticCell<[[u8; 2]; PIXELS]> = ConstStaticCell::new([[0; 2]; PIXELS]);
static DEPTHS: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);

/// How a picture is divided.
#[derive(Clone, Copy)]
pub enum Layout {
    /// Not at all.
    Frame,
    /// Strips, one after the other in the same memory.
    Bands,
}

impl Layout {
    pub const ALL: [Self; 2] = [Self::Frame, Self::Bands];

    pub fn name(self) -> &'static str {
        match self {
            Self::Frame => "frame",
            Self::Bands => "bands",
        }
    }

    /// Rows that are in memory at a time. A band takes 10 KiB of colour and as much of depth.
    fn rows(self) -> u32 {
        match self {
            Self::Frame => HEIGHT,
            Self::Bands => 16,
        }
    }
}

/// What a picture took.
#[derive(Default)]
pub struct Figures {
    /// Pixels that the models cover.
    pub pixels: usize,
    /// Triangles drawn; in bands, by each again.
    pub triangles: u32,
    /// Ticks of the clock around the drawing calls alone.
    pub ticks: u64,
    /// The deepest stack of the drawing calls, in bytes.
    pub stack: usize,
    /// CRC-32 of the pixels, row by row, the more significant byte first.
    pub crc: u32,
}

/// The memory that is drawn to, and the clock.
pub struct Bench {
    clock: Clock,
    colors: &'static mut [[u8; 2]; PIXELS],
    depths: &'static mut [u16; PIXELS],
}

impl Bench {
    /// Takes the memory: can be called once.
    pub fn new(clock: Clock) -> Self {
        Self {
            clock,
            colors: COLORS.take(),
            depths: DEPTHS.take(),
        }
    }

    /// Draws a scene.
    pub fn measure(&mut self, scene: Scene, layout: Layout) -> Result<Figures, Error> {
        let chain = scene.chain()?;
        let (rows, mut figures, mut crc) = (layout.rows(), Figures::default(), Hasher::new());
        for first_row in (0..HEIGHT).step_by(rows as usize) {
            self.strip(scene, &chain, (first_row, rows), (&mut figures, &mut crc))?;
        }
        figures.crc = crc.finalize();
        Ok(figures)
    }

    /// Draws `rows` rows of a scene, and adds its figures.
    fn strip(
        &mut self,
        scene: Scene,
        chain: &Chain<Perspective>,
        (first_row, rows): (u32, u32),
        (figures, crc): (&mut Figures, &mut Hasher),
    ) -> Result<(), Error> {
        let size = (rows * WIDTH) as usize;
        let (colors, depths) = (&mut self.colors[..size], &mut self.depths[..size]);
        if !scene.has_depth() {
            let mut canvas: Target<_> = Canvas::big_endian_band(colors, WIDTH, HEIGHT, first_row)?;
            draw(scene, chain, &mut canvas, &mut self.clock, figures)?;
            crc.update(canvas.bytes());
        }
        let canvas: Target<_> = Canvas::big_endian_band(colors, WIDTH, HEIGHT, first_row)?;
        let mut canvas = canvas.with_depth(depths)?;
        if scene.has_depth() {
            draw(scene, chain, &mut canvas, &mut self.clock, figures)?;
            crc.update(canvas.bytes());
        } else {
            // Again, and not measured, only to learn from the depths which pixels are covered.
            scene.background(&mut canvas);
            scene.draw(&mut canvas, chain)?;
        }
        // What is drawn is nearer than the far plane, and above 0.
        figures.pixels += depths.iter().filter(|&&depth| depth > 0).count();
        Ok(())
    }
}

/// Draws a scene to a strip, and adds what the drawing took.
fn draw<D: DepthBuffer>(
    scene: Scene,
    chain: &Chain<Perspective>,
    canvas: &mut Target<'_, D>,
    clock: &mut Clock,
    figures: &mut Figures,
) -> Result<(), Error> {
    scene.background(canvas);
    let ((triangles, ticks), stack) = stack::deepest(|| clock.time(|| scene.draw(canvas, chain)));
    scene.overlay(canvas);
    figures.triangles += triangles?;
    figures.ticks += ticks;
    figures.stack = figures.stack.max(stack);
    Ok(())
}
