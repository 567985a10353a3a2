//! Measures whole frames. For each measured scene, the cost is the mean over its eight poses.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::mode::Mode;
use fixel::prelude::*;
use fixel::view::Perspective;
use static_cell::ConstStaticCell;

use super::common::scenes::{self, HEIGHT, POSES, WIDTH};
use super::ticks::Stopwatch;

const PIXELS: usize = (WIDTH * HEIGHT) as usize;
static COLORS: ConstStaticCell<[Rgb565; PIXELS]> = ConstStaticCell::new([Rgb565::BLACK; PIXELS]);
static DEPTHS: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);

/// Memory for the colors of a frame, in the processor's byte order, and for its depths.
pub struct Frame {
    colors: &'static mut [Rgb565; PIXELS],
    depths: &'static mut [u16; PIXELS],
}

/// A function that returns a scene's model-view-projection in a pose.
pub type Posed = fn(i32) -> Result<Mvp<Perspective>, Error>;

impl Frame {
    /// Takes the memory. Can be called only once.
    pub fn take() -> Self {
        Self {
            colors: COLORS.take(),
            depths: DEPTHS.take(),
        }
    }

    /// A black canvas without a depth buffer.
    pub fn canvas(&mut self) -> Result<Canvas<'_, Rgb565>, Error> {
        let mut canvas = Canvas::new(&mut *self.colors, WIDTH, HEIGHT)?;
        canvas.clear(Rgb565::BLACK);
        Ok(canvas)
    }

    /// A black canvas with a depth buffer.
    pub fn canvas_with_depth(&mut self) -> Result<Canvas<'_, Rgb565, Native, LinearDepth>, Error> {
        let canvas = Canvas::new(&mut *self.colors, WIDTH, HEIGHT)?;
        let mut canvas = canvas.with_depth(&mut *self.depths)?;
        canvas.clear(Rgb565::BLACK);
        Ok(canvas)
    }

    /// Draws all poses of all scenes, and prints the ticks of the draw calls.
    pub fn measure<M: Mode>(
        &mut self,
        watch: &mut Stopwatch,
        mode_name: &str,
        mode: M,
    ) -> Result<(), Error> {
        let options = DrawOptions::new().with_mode(mode);
        for (name, mvp) in [
            ("floor", scenes::floor_mvp as Posed),
            ("cube", scenes::cube_mvp),
            ("sphere", scenes::sphere_mvp),
            ("sphere-flat", scenes::sphere_mvp),
        ] {
            let mut ticks = 0;
            for pose in 0..POSES {
                ticks += self.pose(watch, name, &options, &mvp(pose)?)?;
            }
            watch.print_frames(mode_name, name, POSES.cast_unsigned(), ticks);
        }
        Ok(())
    }

    /// Draws all poses of a mesh, with or without a depth buffer, and prints the ticks of the draw calls.
    pub fn mesh<M: Mode, S: ShaderFor<Rgb565>>(
        &mut self,
        watch: &mut Stopwatch,
        (mode_name, options): (&str, &DrawOptions<M>),
        (name, mesh, mvp): (&str, &Mesh, Posed),
        shader: &S,
        has_depth: bool,
    ) -> Result<(), Error> {
        let mut ticks = 0;
        for pose in 0..POSES {
            let mvp = mvp(pose)?;
            let mut canvas = Canvas::new(&mut *self.colors, WIDTH, HEIGHT)?;
            canvas.clear(Rgb565::BLACK);
            ticks += if has_depth {
                let mut canvas = canvas.with_depth(&mut *self.depths)?;
                canvas.clear_depth();
                watch.time(|| Ok::<_, Error>(_ = canvas.draw_with(options, mesh, &mvp, shader)))
            } else {
                watch.time(|| Ok(_ = canvas.draw_with(options, mesh, &mvp, shader)))
            }?;
        }
        watch.print_frames(mode_name, name, POSES.cast_unsigned(), ticks);
        Ok(())
    }

    /// Draws a scene. Returns the ticks.
    fn pose<M: Mode>(
        &mut self,
        watch: &mut Stopwatch,
        name: &str,
        options: &DrawOptions<M>,
        mvp: &Mvp<Perspective>,
    ) -> Result<u64, Error> {
        let mut canvas = Canvas::new(&mut *self.colors, WIDTH, HEIGHT)?;
        canvas.clear(Rgb565::BLACK);
        if name == "sphere-flat" {
            return watch.time(|| Ok(_ = scenes::sphere_flat(&mut canvas, options, mvp)));
        }
        let mut canvas = canvas.with_depth(&mut *self.depths)?;
        canvas.clear_depth();
        watch.time(|| {
            _ = match name {
                "floor" => scenes::floor(&mut canvas, options, mvp),
                "cube" => scenes::cube(&mut canvas, options, mvp),
                _ => scenes::sphere(&mut canvas, options, mvp),
            };
            Ok(())
        })
    }
}
