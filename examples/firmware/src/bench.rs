//! Draws a scene in a layout, and measures the drawing.

use crc32fast::Hasher;
use fixel::canvas::DepthBuffer;
use fixel::mode::Mode;
use fixel::prelude::*;
use fixel::view::Perspective;
use static_cell::ConstStaticCell;

use super::board::Clock;
use super::common::scenes::{HEIGHT, WIDTH};
use super::common::stack;
use super::same::{Repeat, Way};
use super::scene::{Lists, PreparedScene, Scene, Target};

const PIXELS: usize = (WIDTH * HEIGHT) as usize;
static COLORS: ConstStaticCell<[[u8; 2]; PIXELS]> = ConstStaticCell::new([[0; 2]; PIXELS]);
static LISTS: ConstStaticCell<Lists> = ConstStaticCell::new(Lists::new());
static DEPTHS: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);

/// How a picture is divided into bands.
#[derive(Clone, Copy)]
pub enum Layout {
    /// One frame.
    Frame,
    /// Bands that are drawn one after the other into the same memory. Each band transforms all models.
    Bands,
    /// Bands of triangles that are transformed once for all bands.
    Prepared,
}

impl Layout {
    pub const ALL: [Self; 3] = [Self::Frame, Self::Bands, Self::Prepared];

    pub fn name(self) -> &'static str {
        match self {
            Self::Frame => "frame",
            Self::Bands => "bands",
            Self::Prepared => "prepared",
        }
    }

    /// The number of rows that are in memory at a time. A band takes 10 KiB of color and 10 KiB of depth.
    fn rows(self) -> u32 {
        match self {
            Self::Frame => HEIGHT,
            Self::Bands | Self::Prepared => 16,
        }
    }
}

/// The measured figures of a picture.
#[derive(Default)]
pub struct Figures {
    /// The number of pixels that the models cover.
    pub pixels: usize,
    /// The number of triangles drawn. A triangle counts once in each of its bands.
    pub triangles: u32,
    /// The ticks of the clock during the calls that prepare and draw. No other call counts.
    pub ticks: u64,
    /// The largest number of bytes of stack that a call to prepare or to draw uses.
    pub stack: usize,
    /// The CRC-32 of the pixels, row by row. The more significant byte comes first.
    pub crc: u32,
}

/// The memory in which scenes are drawn, and the clock.
pub struct Bench {
    clock: Clock,
    colors: &'static mut [[u8; 2]; PIXELS],
    depths: &'static mut [u16; PIXELS],
    lists: &'static mut Lists,
}

impl Bench {
    /// Takes the memory. Can be called only once.
    pub fn new(clock: Clock) -> Self {
        Self {
            clock,
            colors: COLORS.take(),
            depths: DEPTHS.take(),
            lists: LISTS.take(),
        }
    }

    /// Draws a scene, and measures it.
    pub fn measure<I: Mode>(
        &mut self,
        scene: Scene,
        options: &DrawOptions<I>,
        layout: Layout,
    ) -> Result<Figures, Error> {
        let Self {
            clock,
            colors,
            depths,
            lists,
        } = self;
        let mvp = scene.mvp()?;
        let (rows, mut figures) = (layout.rows(), Figures::default());
        let models = if let Layout::Prepared = layout {
            let (clock, lists, mvp) = (&mut *clock, &mut **lists, &mvp);
            let ((prepared, ticks), stack) =
                stack::deepest(move || clock.time(move || scene.prepare(lists, options, mvp)));
            figures.add(ticks, stack);
            Models::Prepared(prepared?)
        } else {
            Models::Meshes(scene, options, &mvp)
        };
        let mut crc = Hasher::new();
        for first_row in (0..HEIGHT).step_by(rows as usize) {
            let size = (rows * WIDTH) as usize;
            let (colors, depths) = (&mut colors[..size], &mut depths[..size]);
            if !scene.has_depth() {
                let mut canvas: Target<_> = Canvas::band(colors, WIDTH, HEIGHT, first_row)?;
                draw(scene, &models, &mut canvas, clock, &mut figures)?;
                crc.update(canvas.as_bytes());
            }
            let canvas: Target<_> = Canvas::band(colors, WIDTH, HEIGHT, first_row)?;
            let mut canvas = canvas.with_depth(depths)?;
            if scene.has_depth() {
                draw(scene, &models, &mut canvas, clock, &mut figures)?;
                crc.update(canvas.as_bytes());
            } else {
                // Draw once more, without measuring, to count the covered pixels by their depths.
                scene.background(&mut canvas);
                models.draw(&mut canvas)?;
            }
            // Covered pixels are nearer than the far plane, so their depths are above 0.
            figures.pixels += depths.iter().filter(|&&depth| depth > 0).count();
        }
        figures.crc = crc.finalize();
        Ok(figures)
    }

    /// The checksum of a scene that is drawn with a depth buffer in the given way.
    pub fn checksum(&mut self, way: Way) -> Result<u32, Error> {
        let Way { scene, rows, .. } = way;
        let (options, mvp) = (DrawOptions::new(), scene.mvp()?);
        let models = if way.is_prepared {
            Models::Prepared(scene.prepare(self.lists, &options, &mvp)?)
        } else {
            Models::Meshes(scene, &options, &mvp)
        };
        let mut crc = Hasher::new();
        for first_row in (0..HEIGHT).step_by(rows as usize) {
            let size = (rows.min(HEIGHT - first_row) * WIDTH) as usize;
            let (colors, depths) = (&mut self.colors[..size], &mut self.depths[..size]);
            let canvas: Target<_> = Canvas::band(colors, WIDTH, HEIGHT, first_row)?;
            let mut canvas = canvas.with_depth(depths)?;
            scene.background(&mut canvas);
            models.draw(&mut canvas)?;
            match way.repeat {
                Repeat::Once => (),
                Repeat::Again => {
                    scene.overlay(&mut canvas);
                    scene.background(&mut canvas);
                    models.draw(&mut canvas)?;
                }
                Repeat::Over => _ = models.draw(&mut canvas)?,
            }
            scene.overlay(&mut canvas);
            crc.update(canvas.as_bytes());
        }
        Ok(crc.finalize())
    }
}

impl Figures {
    /// Adds the ticks and the stack of one measured call.
    fn add(&mut self, ticks: u64, stack: usize) {
        self.ticks += ticks;
        self.stack = self.stack.max(stack);
    }
}

/// The models of a band, as meshes or prepared.
enum Models<'a, I> {
    Meshes(Scene, &'a DrawOptions<I>, &'a Mvp<Perspective>),
    Prepared(PreparedScene<'a, I>),
}

impl<I: Mode> Models<'_, I> {
    fn draw<D: DepthBuffer>(&self, canvas: &mut Target<'_, D>) -> Result<u32, Error> {
        match self {
            Self::Meshes(scene, options, mvp) => scene.draw(canvas, options, mvp),
            Self::Prepared(prepared) => prepared.draw(canvas),
        }
    }
}

/// Draws a scene into a band, and adds the ticks and the stack of its draw calls.
fn draw<I: Mode, D: DepthBuffer>(
    scene: Scene,
    models: &Models<'_, I>,
    canvas: &mut Target<'_, D>,
    clock: &mut Clock,
    figures: &mut Figures,
) -> Result<(), Error> {
    scene.background(canvas);
    let ((triangles, ticks), stack) = stack::deepest(|| clock.time(|| models.draw(canvas)));
    scene.overlay(canvas);
    figures.triangles += triangles?;
    figures.add(ticks, stack);
    Ok(())
}
