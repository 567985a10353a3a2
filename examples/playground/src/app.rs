//! The memory of the module, and what it does for the page.

use core::cell::Cell;
use core::fmt::Write;

use embedded_graphics::pixelcolor::{BinaryColor, IntoStorage, Rgb565, RgbColor};
use fixel::canvas::NoDepth;
use fixel::mode::{Mode, Newton};
use fixel::prelude::*;
use fixel::textbook::Segment;
use fixel::{Drawn, Fraction};

use super::common::lighthouse;
use super::cost::{self, CORES};
use super::exact::{self, Eye};
use super::formats::{self, Deep};
use super::model::{FACES, Model};
use super::program::{self, Text};
use super::record::Recorder;
use super::scene::{self, Part, Scene, Target};
use super::view::{CAMERA, CHECKSUM, COUNTS, ERRORS, FIELDS, INSTRUCTIONS, NAMES, View};

/// Two pictures, to compare modes, and one to measure with.
const SLOTS: usize = 3;
/// Most pixels of a picture.
const PIXELS: usize = 640 * 480;
/// Room for a model's lists (71 bytes for each of 65,536 elements) or a texture's pixels, in bytes.
const INPUT: usize = 5 << 20;

/// Where a pixel was not drawn, as bytes of red, green, blue and opacity.
const NOTHING: u32 = u32::from_le_bytes([58, 62, 68, 255]);

/// Everything. Its first value is all zeros, which take no room in the file.
pub struct App {
    /// The settings of the picture to draw next, and what was found: see `view::NAMES`.
    pub fields: [f64; FIELDS],
    pub input: [u8; INPUT],
    pub text: Text,
    /// The counts of the scenes as they are measured.
    measured: [Option<[u32; 4]>; 5],
    colors: [[Rgb565; PIXELS]; SLOTS],
    /// The same for displays of another format.
    deep: [[Deep; PIXELS]; SLOTS],
    shown: [[u32; PIXELS]; SLOTS],
    mono: [BinaryColor; PIXELS],
    /// The lighthouse is shown before its sky in a display's colors: where nothing is drawn, depths are 0.
    depths: [[u16; PIXELS]; SLOTS],
    pixels: [Cell<[i32; 3]>; PIXELS],
    triangles: [Cell<[i32; 17]>; FACES],
    model: Model,
}

/// What a call does: an error's message is kept for the page.
type Done = Result<(), Error>;

impl App {
    #[allow(clippy::large_stack_arrays)] // the compiler evaluates it, for a static
    pub const fn new() -> Self {
        Self {
            fields: [0.0; FIELDS],
            input: [0; INPUT],
            text: Text::new(),
            measured: [None; 5],
            colors: [[Rgb565::BLACK; PIXELS]; SLOTS],
            deep: [[Deep::BLACK; PIXELS]; SLOTS],
            shown: [[0; PIXELS]; SLOTS],
            mono: [BinaryColor::Off; PIXELS],
            depths: [[0; PIXELS]; SLOTS],
            pixels: [const { Cell::new([0; 3]) }; PIXELS],
            triangles: [const { Cell::new([0; 17]) }; FACES],
            model: Model::new(),
        }
    }

    /// Writes the fields' names to the text.
    #[allow(clippy::unnecessary_wraps)] // as all actions
    pub fn names(&mut self, _: usize) -> Done {
        self.text.clear();
        // It has room.
        let _ = self.text.push_str(NAMES);
        Ok(())
    }

    /// Writes the camera of a scene's start to the fields.
    #[allow(clippy::unnecessary_wraps)] // as all actions
    #[allow(clippy::cast_sign_loss)] // saturates
    pub fn home(&mut self, _: usize) -> Done {
        let scene = Scene::at(self.fields[0] as usize);
        let camera = View::home(scene, self.model.ball);
        self.fields[CAMERA].copy_from_slice(&camera);
        Ok(())
    }

    /// Draws the background, and clears the depths. It is not timed.
    pub fn clear(&mut self, slot: usize) -> Done {
        let view = View::new(&self.fields)?;
        let band = self.deep[slot % SLOTS].get_mut(view.band());
        band.unwrap_or_default().fill(Deep::BLACK);
        let mut bench = self.bench(slot, &view)?;
        view.scene.background(&mut bench.canvas);
        bench.depths.fill(0);
        Ok(())
    }

    /// Draws the scene, and the lighthouse's caption.
    pub fn draw(&mut self, slot: usize) -> Done {
        let view = View::new(&self.fields)?;
        self.draw_view(slot, &view)?;
        if view.scene == Scene::Lighthouse && !view.is_deep() && !view.is_mono() {
            lighthouse::caption(&mut self.bench(slot, &view)?.canvas);
        }
        Ok(())
    }

    fn draw_view(&mut self, slot: usize, view: &View) -> Result<Drawn, Error> {
        in_mode!(view.mode, view.tolerance, |mode| self
            .draw_in(slot, view, mode))
    }

    fn draw_in<M: Mode>(&mut self, slot: usize, view: &View, mode: M) -> Result<Drawn, Error> {
        if view.scene == Scene::Lighthouse && view.is_mono() {
            return self.draw_mono(slot, view, mode);
        }
        let band = view.band();
        let slot = slot % SLOTS;
        let depths = self.depths[slot].get_mut(band.clone()).unwrap_or_default();
        if view.is_deep() {
            let colors = self.deep[slot].get_mut(band).unwrap_or_default();
            scene::draw(colors, depths, view, mode, &self.model)
        } else {
            let colors = self.colors[slot].get_mut(band).unwrap_or_default();
            scene::draw(colors, depths, view, mode, &self.model)
        }
    }

    /// Draws the lighthouse by night, as it is drawn in black and white.
    fn draw_mono<M: Mode>(&mut self, slot: usize, view: &View, mode: M) -> Result<Drawn, Error> {
        let band = view.band();
        let mono = self.mono.get_mut(band.clone()).unwrap_or_default();
        let depths = self.depths[slot % SLOTS]
            .get_mut(band.clone())
            .unwrap_or_default();
        let canvas = Canvas::band(mono, view.size.width, view.size.height, view.first_row)?;
        let mut canvas = canvas.with_depth(depths)?;
        let drawn = scene::night(&mut canvas, view, mode)?;
        let colors = self.colors[slot % SLOTS]
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

    /// Writes a view's counts, and what they say of microcontrollers, to the fields. Spoils the picture.
    pub fn measure(&mut self, slot: usize) -> Done {
        let view = View::new(&self.fields)?;
        self.fields[COUNTS.start..INSTRUCTIONS.end].fill(f64::NAN);
        // The measured scene that it is like. The little world is like none.
        let scene = match view.scene {
            Scene::Own => Scene::Lighthouse,
            Scene::World => return Ok(()),
            scene => scene,
        };
        let counts = self.count(slot, &view)?;
        let measured = match self.measured[scene as usize] {
            Some(counts) => counts,
            None => self.count(slot, &View::measured(scene, self.fields)?)?,
        };
        self.measured[scene as usize] = Some(measured);
        let instructions =
            |core| cost::instructions(core, view.mode as usize, view.scene, counts, measured);
        let instructions =
            CORES.map(|core| instructions(core).map_or(f64::NAN, |count| count / 1e6));
        self.fields[COUNTS].copy_from_slice(&counts.map(f64::from));
        self.fields[INSTRUCTIONS].copy_from_slice(&instructions);
        Ok(())
    }

    /// Counts triangles, and the pixels that pass the depth test.
    fn count(&mut self, slot: usize, view: &View) -> Result<[u32; 4], Error> {
        let drawn = self.draw_view(slot, view)?;
        let count = Cell::new(0);
        let counter = Flat::new(Rgb565::BLACK).map(|_, color| {
            count.set(count.get() + 1);
            Some(color)
        });
        self.bench(slot, view)?
            .draw(view, Newton::default(), |_, _| counter)?;
        Ok([drawn.submitted, drawn.drawn, drawn.clipped, count.get()])
    }

    /// Writes a view's errors to the fields, and shows them as colors. Spoils the picture.
    pub fn errors(&mut self, slot: usize) -> Done {
        let view = View::new(&self.fields)?;
        if view.scene == Scene::SphereFlat {
            return Ok(()); // interpolates nothing
        }
        in_mode!(view.mode, view.tolerance, |mode| self
            .record(slot, &view, mode))?;
        let eye = Eye::new(&view);
        let mvp = view.mvp()?;
        let (width, height) = (view.size.width, view.size.height);
        let screen = Viewport::new(0, 0, width, height)?;
        // The place that the crate gives a recorded corner.
        let place = |corner: &[i32]| {
            let at = Vec3::from_bits([corner[0], corner[1], corner[2]]);
            let place = screen.project(at, &mvp)?;
            Some([place.x, place.y].map(|at| f64::from(at.to_bits()) / 256.0))
        };
        let (mut most, mut sum, mut count) = (0.0_f64, 0.0, 0.0);
        // A row's pixels have a triangle in common.
        let (mut last, mut pieces, mut size) = (0, exact::Pieces::new(), [0.0; 2]);
        let width = width as usize;
        let rows = self
            .pixels
            .chunks(width)
            .zip(self.shown[slot % SLOTS].chunks_mut(width));
        for (y, (pixels, shown)) in (0..height).zip(rows) {
            for (x, (pixel, shown)) in (0_u32..).zip(pixels.iter().zip(shown)) {
                let [triangle, texels @ ..] = pixel.get();
                let triangle = triangle.cast_unsigned();
                *shown = NOTHING;
                if triangle == 0 {
                    continue;
                }
                if triangle != last {
                    last = triangle;
                    let corners = self.triangles[triangle as usize - 1].get();
                    size = [corners[0], corners[1]].map(f64::from);
                    let places = [2, 7, 12].map(|at| place(&corners[at..at + 5]));
                    pieces = eye.pieces(&corners, places);
                }
                let Some(uv) = exact::at(&pieces, f64::from(x) + 0.5, f64::from(y) + 0.5) else {
                    continue;
                };
                let off = |axis: usize| {
                    (f64::from(texels[axis]) / 65_536.0 - uv[axis] * size[axis]).abs()
                };
                let error = off(0).max(off(1));
                *shown = exact::heat(error);
                most = most.max(error);
                sum += error;
                count += 1.0;
            }
        }
        self.fields[ERRORS].copy_from_slice(&[most, sum / f64::max(count, 1.0)]);
        Ok(())
    }

    /// Records the view's triangles, and its pixels.
    fn record<M: Mode>(&mut self, slot: usize, view: &View, mode: M) -> Done {
        let bench = self.bench(slot, view)?;
        let (pixels, triangles) = (bench.pixels, bench.triangles);
        for pixel in pixels {
            pixel.set([0; 3]);
        }
        bench.draw(view, mode, |part, first| Recorder {
            pixels,
            width: view.size.width,
            triangles,
            first,
            texels: part.texels,
            mesh: part.mesh,
        })
    }

    /// Converts the picture to the display's format.
    pub fn show(&mut self, slot: usize) -> Done {
        let view = View::new(&self.fields)?;
        let slot = slot % SLOTS;
        let pixels = (view.size.width * view.size.height) as usize;
        let has_sky = view.scene == Scene::Lighthouse && !view.is_mono();
        let sky = has_sky.then(|| &self.depths[slot][..pixels]);
        let shown = &mut self.shown[slot][..pixels];
        if view.is_deep() {
            formats::show(
                &self.deep[slot][..pixels],
                sky,
                view.size,
                view.format,
                shown,
            );
        } else {
            formats::show(
                &self.colors[slot][..pixels],
                sky,
                view.size,
                view.format,
                shown,
            );
        }
        Ok(())
    }

    /// Returns the pixels that are shown, in bytes of red, green, blue and opacity.
    pub fn shown(&self, slot: usize) -> *const u32 {
        self.shown[slot % SLOTS].as_ptr()
    }

    /// Returns the picture as it was drawn, in Rgb565.
    pub fn picture(&self, slot: usize) -> *const u16 {
        self.colors[slot % SLOTS].as_ptr().cast()
    }

    /// Writes the CRC-32 of the picture's pixels, row by row: in 16-bit color as the firmware computes it, the more
    /// significant byte first; in other formats of the bytes of red, green and blue that are shown.
    pub fn checksum(&mut self, slot: usize) -> Done {
        let view = View::new(&self.fields)?;
        let pixels = (view.size.width * view.size.height) as usize;
        let is_converted = view.format != 0 && view.scene != Scene::World;
        if is_converted {
            self.show(slot)?;
        }
        let slot = slot % SLOTS;
        let colors = self.colors[slot].iter().zip(&self.shown[slot]);
        let bytes = colors.take(pixels).flat_map(|(color, shown)| {
            let [high, low] = color.into_storage().to_be_bytes();
            let [red, green, blue, _] = shown.to_le_bytes();
            let (bytes, count) = if is_converted {
                ([red, green, blue], 3)
            } else {
                ([high, low, 0], 2)
            };
            bytes.into_iter().take(count)
        });
        let crc = !bytes.fold(u32::MAX, |crc, byte| {
            (0..8).fold(crc ^ u32::from(byte), |crc, _| {
                (crc >> 1) ^ (0xedb8_8320 * (crc & 1))
            })
        });
        self.fields[CHECKSUM] = f64::from(crc);
        Ok(())
    }

    /// Writes the program that draws the view to the text.
    pub fn program(&mut self, _: usize) -> Done {
        let view = View::new(&self.fields)?;
        self.text.clear();
        // It has room.
        let _ = program::write(&view, &self.model, &mut self.text);
        Ok(())
    }

    /// Reads a model's lists from the input.
    pub fn read_model(&mut self, bytes: usize) -> Done {
        self.model.read(&self.input[..bytes.min(INPUT)])
    }

    /// Reads a texture's pixels (red, green, blue, opacity) from the input. The fields have its size.
    #[allow(clippy::cast_sign_loss)] // saturates
    pub fn read_texture(&mut self, bytes: usize) -> Done {
        let size = [self.fields[3], self.fields[4]].map(|side| side as u32);
        let pixels = &self.input[..bytes.min(INPUT)];
        self.model.read_texture(pixels, size)
    }

    /// Reads from the fields the distances of a segment's ends, and a fraction on the screen or, if `number` is 1, in
    /// space. Writes the point's fraction on the screen, its fraction in space, and its distance.
    pub fn foreshorten(&mut self, number: usize) -> Done {
        let [start, end, given, ..] = self.fields;
        let (start, end) = (Scalar::try_from(start)?, Scalar::try_from(end)?);
        let given = Some(Fraction::try_from(given)?);
        let found = Segment::new(start, end).and_then(|segment| {
            let on_screen = if number == 1 {
                segment.on_screen(given?)?
            } else {
                given?
            };
            let in_space = segment.in_space(on_screen)?;
            Some([
                on_screen.into(),
                in_space.into(),
                segment.distance(on_screen)?.into(),
            ])
        });
        // The page shows no segment that begins behind the eye.
        self.fields[..3].copy_from_slice(&found.unwrap_or([f64::NAN; 3]));
        Ok(())
    }

    /// Keeps an error's message for the page.
    pub fn tell(&mut self, done: Done) -> bool {
        if let Err(error) = done {
            self.text.clear();
            // It has room.
            let _ = write!(self.text, "{error}");
        }
        done.is_ok()
    }

    /// The memory to draw one of the two pictures, or a band of it.
    fn bench(&mut self, slot: usize, view: &View) -> Result<Bench<'_>, Error> {
        let band = view.band();
        // The canvas and its depths refuse memory that is too short.
        let colors = self.colors[slot % SLOTS]
            .get_mut(band.clone())
            .unwrap_or_default();
        let canvas = Canvas::band(colors, view.size.width, view.size.height, view.first_row)?;
        Ok(Bench {
            canvas,
            depths: self.depths[slot % SLOTS].get_mut(band).unwrap_or_default(),
            model: &self.model,
            pixels: &self.pixels,
            triangles: &self.triangles,
        })
    }
}

/// What a drawing needs.
struct Bench<'a> {
    canvas: Target<'a, Rgb565, NoDepth>,
    depths: &'a mut [u16],
    model: &'a Model,
    pixels: &'a [Cell<[i32; 3]>],
    triangles: &'a [Cell<[i32; 17]>],
}

impl<'a> Bench<'a> {
    /// Draws the scene's meshes with shaders made for each, from the mesh and the number of triangles before it.
    fn draw<M: Mode, S: ShaderFor<Rgb565>>(
        self,
        view: &View,
        mode: M,
        shader: impl Fn(&Part<'a>, usize) -> S,
    ) -> Result<(), Error> {
        let options = DrawOptions::new().with_mode(mode).with_cull(view.cull());
        let mvp = view.mvp()?;
        let mut canvas = self.canvas.with_depth(self.depths)?;
        canvas.clear_depth();
        let mut first = 0;
        for part in view.scene.parts(self.model)?.iter().flatten() {
            canvas.draw_with(&options, &part.mesh, &mvp, &shader(part, first));
            first += part.mesh.faces().len();
        }
        Ok(())
    }
}
