//! A triangle that covers the whole frame, whatever the frame's width is.

use core::hint::black_box;

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::canvas::{Blending, DepthBuffer, TestAndWrite};
use fixel::mode::Mode;
use fixel::prelude::*;
use fixel::view::Perspective;
use static_cell::ConstStaticCell;

use super::ticks::Stopwatch;

/// The widths of the frames that are compared. Two are within one span, and one is three spans wider.
const WIDTHS: [u32; 3] = [16, 48, 240];
pub const ROWS: u32 = 64;
/// The number of times that a frame is drawn, because a tick can take many instructions.
const REPEATS: u32 = 4;
/// The number of pixels of the widest frame.
const PIXELS: usize = 240 * ROWS as usize;

/// The distance from the eye to the screen, in pixels.
const FOCAL: i32 = 256;

/// Corners in pixels from the frame's top left corner, and their distances. 1/w decreases by half over 640 columns. The
/// relative change of 1/w per pixel increases from 1/1280 to 1/640. With this change, no mode falls back to division,
/// and no mode skips the correction of perspective.
const CORNERS: [([i32; 2], i32); 3] = [([-16, -16], 1), ([-16, 144], 1), ([624, -16], 2)];
/// Texture coordinates of the corners. From one column to the next, a texture of 64x64 texels moves by half a texel to
/// two texels.
pub const UVS: [Vec2; 3] = [vec2!(0, 0), vec2!(0, 2), vec2!(10, 1)];

static COLORS: ConstStaticCell<[Rgb565; PIXELS]> = ConstStaticCell::new([Rgb565::BLACK; PIXELS]);
static DEPTHS: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);

/// The color of pixels that were not drawn. No measured draw call produces this color.
const UNDRAWN: Rgb565 = Rgb565::new(20, 40, 20);

/// The depth buffer before the draw call.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Depths {
    /// No depth buffer.
    None,
    /// Depths farther than the wall.
    Far,
    /// Depths nearer than the wall.
    Near,
}

/// The options of a measured draw call.
type Options<I, B> = DrawOptions<I, TestAndWrite, B>;

/// The memory in which frames are drawn, and the stopwatch.
pub struct Bench {
    watch: Stopwatch,
    colors: &'static mut [Rgb565; PIXELS],
    depths: &'static mut [u16; PIXELS],
}

impl Bench {
    /// Takes the memory. Can be called only once.
    pub fn new(watch: Stopwatch) -> Self {
        Self {
            watch,
            colors: COLORS.take(),
            depths: DEPTHS.take(),
        }
    }

    /// Measures opaque pixels, and prints their cost.
    pub fn kernel<I: Mode, F: ShaderFor<Rgb565>>(
        &mut self,
        name: &str,
        mode: I,
        shader: &F,
        depths: Depths,
    ) -> Result<(), Error> {
        self.blended(name, DrawOptions::new().with_mode(mode), shader, depths)
    }

    /// Measures pixels, and prints their cost in columns 16 to 48 and in columns 48 to 240.
    pub fn blended<I: Mode, B: Blending<Rgb565>, F: ShaderFor<Rgb565>>(
        &mut self,
        name: &str,
        options: Options<I, B>,
        shader: &F,
        depths: Depths,
    ) -> Result<(), Error> {
        let mut ticks = [0; 3];
        for (ticks, width) in ticks.iter_mut().zip(WIDTHS) {
            for _ in 0..REPEATS {
                *ticks += self.frame(width, options, shader, depths)?;
            }
        }
        let [narrow, wide, widest] = WIDTHS.map(|columns| columns * ROWS * REPEATS);
        let [least, more, most] = ticks;
        self.watch.print(name, "pixel", wide - narrow, more - least);
        self.watch
            .print(name, "long-pixel", widest - wide, most - more);
        Ok(())
    }

    /// Draws a frame that the wall covers completely. Returns the ticks.
    fn frame<I: Mode, B: Blending<Rgb565>, F: ShaderFor<Rgb565>>(
        &mut self,
        width: u32,
        options: Options<I, B>,
        shader: &F,
        depths: Depths,
    ) -> Result<u64, Error> {
        let pixels = (width * ROWS) as usize;
        let (colors, depth) = (&mut self.colors[..pixels], &mut self.depths[..pixels]);
        colors.fill(UNDRAWN);
        depth.fill(if depths == Depths::Near { u16::MAX } else { 0 });
        let mut canvas = Canvas::new(colors, width, ROWS)?;
        let ticks = if depths == Depths::None {
            draw(&mut self.watch, &mut canvas, width, options, shader)
        } else {
            let mut canvas = canvas.with_depth(depth)?;
            draw(&mut self.watch, &mut canvas, width, options, shader)
        }?;
        let drawn = self.colors[..pixels]
            .iter()
            .filter(|&&color| color != UNDRAWN);
        let wanted = if depths == Depths::Near { 0 } else { pixels };
        assert_eq!(drawn.count(), wanted, "pixels drawn");
        Ok(ticks)
    }

    /// A row of the widest frame, drawn with a shader.
    pub fn row<I: Mode, F: ShaderFor<Rgb565>>(
        &mut self,
        mode: I,
        shader: &F,
    ) -> Result<&[Rgb565], Error> {
        let [.., width] = WIDTHS;
        let mut canvas = Canvas::new(&mut self.colors[..], width, ROWS)?;
        let (positions, mvp) = (positions(width), mvp(width)?);
        let wall = Mesh::new(&positions, &[[0, 1, 2]])?.with_uvs(&UVS, None)?;
        canvas.draw_with(&DrawOptions::new().with_mode(mode), &wall, &mvp, shader);
        Ok(&self.colors[..width as usize])
    }
}

/// Draws the wall to a canvas. Returns the ticks.
fn draw<I: Mode, B: Blending<Rgb565>, F: ShaderFor<Rgb565>, D: DepthBuffer>(
    watch: &mut Stopwatch,
    canvas: &mut Canvas<'_, Rgb565, fixel::canvas::Native, D>,
    width: u32,
    options: Options<I, B>,
    shader: &F,
) -> Result<u64, Error> {
    let (positions, mvp) = (positions(width), mvp(width)?);
    let wall = Mesh::new(&positions, &[[0, 1, 2]])?.with_uvs(&UVS, None)?;
    // Hide the values from the compiler, because it does not know them in a user's program, either.
    let (options, shader) = black_box((options, shader));
    watch.time(|| {
        let drawn = canvas.draw_with(&options, &wall, &mvp, shader);
        assert_eq!((drawn.drawn, drawn.clipped), (1, 0));
        Ok(())
    })
}

/// The wall's corners in front of a frame of this width.
pub fn positions(width: u32) -> [Vec3; 3] {
    let center = [width, ROWS].map(u32::cast_signed);
    CORNERS.map(|([x, y], distance)| {
        // Coordinates are relative to the frame's center, in half pixels.
        let (x, y) = (2 * x - center[0], center[1] - 2 * y);
        let eye = |half_pixels: i32| fx!(1) * (half_pixels * distance) / (2 * FOCAL);
        Vec3::new(eye(x), eye(y), fx!(-1) * distance)
    })
}

/// The wall's mvp in a frame of this width.
pub fn mvp(width: u32) -> Result<Mvp<Perspective>, Error> {
    let focal = fx!(const FOCAL);
    let projection = Projection::from_focal_length(focal, (width, ROWS), fx!(0.5), fx!(4))?;
    Ok(projection.into())
}
