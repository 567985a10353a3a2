//! The memory of the module, and what it does for the page.

use core::cell::Cell;
use core::fmt::Write;

use embedded_graphics::pixelcolor::{BinaryColor, Rgb565, RgbColor};
use fixel::Drawn;
use fixel::mode::{Affine, Compact, Exact, Fast, Mode, Newton};
use fixel::prelude::*;
use fixel::target::NoDepth;

use super::common::lighthouse;
use super::formats;
use super::model::{FACES, Model};
use super::record::Recorder;
use super::scene::{self, Part, Scene, Target};
use super::view::View;

/// Counts of instructions, one in a line: core, mode, thing drawn, unit, number.
pub static COSTS: &str = include_str!(concat!(env!("OUT_DIR"), "/costs.csv"));

/// Most pixels of a picture.
const PIXELS: usize = 640 * 480;
/// Room for a model's text or a texture's pixels, in bytes.
const INPUT: usize = 1 << 24;

/// Runs `$work` in the view's mode. The library's modes are types.
macro_rules! in_mode {
    ($app:expr, |$mode:ident| $work:expr) => {
        match $app.view.mode {
            0 => {
                let $mode = Exact;
                $work
            }
            1 => {
                let $mode = Newton;
                $work
            }
            2 => {
                let $mode = Fast::within(Scalar::from_bits($app.view.tolerance));
                $work
            }
            3 => {
                let $mode = Affine;
                $work
            }
            _ => {
                let $mode = Compact;
                $work
            }
        }
    };
}

/// Everything. Its first value is all zeros, which take no room in the file.
pub struct App {
    pub view: View,
    pub input: [u8; INPUT],
    pub message: heapless::String<400>,
    /// Triangles in, drawn, clipped; pixels drawn.
    pub counts: [u32; 4],
    /// Two pictures, to compare modes.
    colors: [[Rgb565; PIXELS]; 2],
    shown: [[u32; PIXELS]; 2],
    mono: [BinaryColor; PIXELS],
    /// The lighthouse is shown before its sky in a display's colors: where nothing is drawn, depths are 0.
    depths: [[u16; PIXELS]; 2],
    pub pixels: [Cell<[i32; 3]>; PIXELS],
    pub triangles: [Cell<[i32; 17]>; FACES],
    model: Model,
    bounds: [i32; 4],
}

impl App {
    #[allow(clippy::large_stack_arrays)] // the compiler evaluates it, for a static
    pub const fn new() -> Self {
        Self {
            view: View::EMPTY,
            input: [0; INPUT],
            message: heapless::String::new(),
            counts: [0; 4],
            colors: [[Rgb565::BLACK; PIXELS]; 2],
            shown: [[0; PIXELS]; 2],
            mono: [BinaryColor::Off; PIXELS],
            depths: [[0; PIXELS]; 2],
            pixels: [const { Cell::new([0; 3]) }; PIXELS],
            triangles: [const { Cell::new([0; 17]) }; FACES],
            model: Model::new(),
            bounds: [0; 4],
        }
    }

    /// Draws the background, and clears the depths.
    pub fn clear(&mut self, slot: usize) -> bool {
        let done = self.bench(slot).map(|mut bench| {
            Scene::of(bench.view).background(&mut bench.canvas);
            bench.depths.fill(0);
        });
        self.tell(done)
    }

    /// Draws the scene, and counts triangles.
    pub fn draw(&mut self, slot: usize) -> bool {
        let drawn = in_mode!(self, |mode| self.draw_in(slot, mode));
        if let Ok(drawn) = drawn {
            [self.counts[0], self.counts[1], self.counts[2]] =
                [drawn.submitted, drawn.drawn, drawn.clipped];
        }
        self.tell(drawn.map(|_| ()))
    }

    fn draw_in<M: Mode>(&mut self, slot: usize, mode: M) -> Result<Drawn, Error> {
        if Scene::of(&self.view) == Scene::Lighthouse && self.view.is_mono == 1 {
            return self.draw_mono(slot, mode);
        }
        let Bench {
            mut canvas,
            depths,
            view,
            model,
            ..
        } = self.bench(slot)?;
        let scene = Scene::of(view);
        if scene.has_depth() {
            scene.draw(&mut canvas.with_depth(depths)?, view, mode, model)
        } else {
            scene.draw_flat(&mut canvas, view, mode)
        }
    }

    /// Writes the text over a scene: the lighthouse's caption. It is not timed.
    pub fn overlay(&mut self, slot: usize) -> bool {
        let is_captioned = Scene::of(&self.view) == Scene::Lighthouse && self.view.is_mono == 0;
        let done = self.bench(slot).map(|mut bench| {
            if is_captioned {
                lighthouse::caption(&mut bench.canvas);
            }
        });
        self.tell(done)
    }

    /// Draws the lighthouse by night, as it is drawn in black and white.
    fn draw_mono<M: Mode>(&mut self, slot: usize, mode: M) -> Result<Drawn, Error> {
        let (view, band) = (&self.view, self.view.band());
        let mono = self.mono.get_mut(band.clone()).unwrap_or_default();
        let depths = self.depths[slot & 1]
            .get_mut(band.clone())
            .unwrap_or_default();
        let canvas = Canvas::band(mono, view.width, view.height, view.first_row)?;
        let mut canvas = canvas.with_depth(depths)?;
        let drawn = scene::lighthouse(&mut canvas, view, mode)?;
        lighthouse::caption(&mut canvas);
        let colors = self.colors[slot & 1]
            .get_mut(band.clone())
            .unwrap_or_default();
        for (color, mono) in colors.iter_mut().zip(&self.mono[band]) {
            *color = if mono.is_on() {
                Rgb565::WHITE
            } else {
                Rgb565::BLACK
            };
        }
        Ok(drawn)
    }

    /// Counts the pixels of the view's triangles that pass the depth test. Spoils the picture.
    pub fn count(&mut self, slot: usize) -> bool {
        let count = Cell::new(0);
        let counter = Flat::new(Rgb565::BLACK).map(|_, color| {
            count.set(count.get() + 1);
            Some(color)
        });
        let done = self
            .bench(slot)
            .and_then(|bench| bench.draw(Newton, |_, _| counter));
        self.counts[3] = count.get();
        self.tell(done)
    }

    /// Records the view's triangles, and its pixels in the view's mode. Spoils the picture.
    pub fn record(&mut self, slot: usize) -> bool {
        let done = in_mode!(self, |mode| self.record_in(slot, mode));
        self.tell(done)
    }

    fn record_in<M: Mode>(&mut self, slot: usize, mode: M) -> Result<(), Error> {
        let bench = self.bench(slot)?;
        let (pixels, triangles, width) = (bench.pixels, bench.triangles, bench.view.width);
        for pixel in pixels {
            pixel.set([0; 3]);
        }
        bench.draw(mode, |part, first| Recorder {
            pixels,
            width,
            triangles,
            first,
            texels: part.texels,
            mesh: part.mesh,
        })
    }

    /// Returns the picture in a display's format.
    pub fn show(&mut self, slot: usize, format: usize) -> *const u32 {
        let slot = slot & 1;
        let size = self.view.size();
        let pixels = (size.width * size.height) as usize;
        let has_sky = Scene::of(&self.view) == Scene::Lighthouse && self.view.is_mono == 0;
        if let (Some(colors), Some(shown)) = (
            self.colors[slot].get(..pixels),
            self.shown[slot].get_mut(..pixels),
        ) {
            let sky = has_sky.then_some(&self.depths[slot][..pixels]);
            formats::show(colors, sky, size, format, shown);
        }
        self.shown[slot].as_ptr()
    }

    /// Returns the picture as it was drawn.
    pub fn colors(&self, slot: usize) -> &[Rgb565] {
        let size = (self.view.width * self.view.height) as usize;
        self.colors[slot & 1].get(..size).unwrap_or_default()
    }

    /// Reads a model's text from the input.
    pub fn read_model(&mut self, bytes: usize) -> bool {
        let done = self.model.read(&self.input[..bytes.min(INPUT)]);
        if let (Ok(()), Ok(mesh)) = (done, self.model.mesh()) {
            let bounds = mesh.bounds();
            let center = bounds.least() / fx!(2) + bounds.most() / fx!(2);
            let radius = mesh
                .positions()
                .iter()
                .map(|point| point.distance(center))
                .max();
            let [x, y, z] = center.to_bits();
            self.bounds = [x, y, z, radius.unwrap_or_default().to_bits()];
        }
        self.tell(done)
    }

    /// Returns the center of the model's box, and the distance of the farthest position from it.
    pub fn bounds(&self) -> *const [i32; 4] {
        &raw const self.bounds
    }

    /// Reads a texture's pixels from the input.
    pub fn read_texture(&mut self, width: u32, height: u32) -> bool {
        let bytes = width.saturating_mul(height).saturating_mul(4) as usize;
        let done = self
            .model
            .read_texture(&self.input[..bytes.min(INPUT)], [width, height]);
        self.tell(done)
    }

    /// Keeps an error's message for the page.
    fn tell(&mut self, done: Result<(), Error>) -> bool {
        self.message.clear();
        if let Err(error) = done {
            // A longer message is cut.
            let _ = write!(self.message, "{error}");
        }
        done.is_ok()
    }

    /// The memory to draw one of the two pictures, or a band of it.
    fn bench(&mut self, slot: usize) -> Result<Bench<'_>, Error> {
        let Self {
            view,
            colors,
            depths,
            pixels,
            triangles,
            model,
            ..
        } = self;
        let band = view.band();
        // The canvas and its depths refuse memory that is too short.
        let colors = colors[slot & 1].get_mut(band.clone()).unwrap_or_default();
        let canvas = Canvas::band(colors, view.width, view.height, view.first_row)?;
        Ok(Bench {
            canvas,
            depths: depths[slot & 1].get_mut(band).unwrap_or_default(),
            view,
            model,
            pixels,
            triangles,
        })
    }
}

/// What a drawing needs.
struct Bench<'a> {
    canvas: Target<'a, NoDepth>,
    depths: &'a mut [u16],
    view: &'a View,
    model: &'a Model,
    pixels: &'a [Cell<[i32; 3]>],
    triangles: &'a [Cell<[i32; 17]>],
}

impl<'a> Bench<'a> {
    /// Draws the scene's meshes with shaders made for each, from the mesh and the number of triangles before it.
    fn draw<M: Mode, S: Shader<Color = Rgb565>>(
        self,
        mode: M,
        shader: impl Fn(&Part<'a>, usize) -> S,
    ) -> Result<(), Error> {
        let scene = Scene::of(self.view);
        let (options, mvp) = (
            DrawOptions::new()
                .with_mode(mode)
                .with_cull(self.view.cull()),
            scene.mvp(self.view)?,
        );
        let mut canvas = self.canvas.with_depth(self.depths)?;
        canvas.clear_depth();
        let mut first = 0;
        for part in scene.parts(self.model)?.iter().flatten() {
            canvas.draw_with(&options, &part.mesh, &mvp, &shader(part, first));
            first += part.mesh.faces().len();
        }
        Ok(())
    }
}
