//! The scene of all boards: a crate turns above a tiled floor.
//!
//! The scene draws into memory for a frame or for a band. The code does not depend on the chip, so it runs on your
//! computer as well: the tests of this package check its pictures and the bytes on the bus. [`panel`] drives the
//! displays.
#![no_std]
#![forbid(unsafe_code)]

pub mod panel;

use embedded_graphics::Drawable;
use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_9X18_BOLD};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor, raw::BigEndian};
use embedded_graphics::text::Text;
use fixel::canvas::{DepthBuffer, Storage};
use fixel::mode::Fast;
use fixel::prelude::*;

/// The crate: 12 triangles in flash.
static CRATE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));

/// The floor, whose texture repeats every two units.
static FLOOR: Mesh = {
    const CORNERS: [Vec3; 4] = [
        vec3!(-8, -1.6, 8),
        vec3!(8, -1.6, 8),
        vec3!(8, -1.6, -8),
        vec3!(-8, -1.6, -8),
    ];
    const UVS: [Vec2; 4] = [vec2!(0, 8), vec2!(8, 8), vec2!(8, 0), vec2!(0, 0)];
    Mesh::checked(Mesh::checked(Mesh::new(&CORNERS, &[[0, 1, 2], [0, 2, 3]])).with_uvs(&UVS, None))
};

static PLANKS: [[Rgb565; 16]; 16] = texels(&[
    b"################",
    b"#o============o#",
    b"#=+----------+=#",
    b"#=++--------++=#",
    b"#=.++......++.=#",
    b"#=--++----++--=#",
    b"#=---++--++---=#",
    b"#=....++++....=#",
    b"#=-----++-----=#",
    b"#=----++++----=#",
    b"#=...++..++...=#",
    b"#=--++----++--=#",
    b"#=-++------++-=#",
    b"#=++........++=#",
    b"#o============o#",
    b"################",
]);

static TILES: [[Rgb565; 2]; 2] = texels(&[b"bw", b"wb"]);

/// Makes a texture from a drawing, in which each letter is a color.
const fn texels<const W: usize, const H: usize>(drawing: &[&[u8; W]; H]) -> [[Rgb565; W]; H] {
    let mut texels = [[Rgb565::BLACK; W]; H];
    let mut at = 0;
    while at < W * H {
        texels[at / W][at % W] = match drawing[at / W][at % W] {
            b'#' => Rgb565::new(12, 18, 4),
            b'=' => Rgb565::new(24, 38, 9),
            b'+' => Rgb565::new(22, 33, 7),
            b'-' => Rgb565::new(29, 50, 15),
            b'.' => Rgb565::new(25, 43, 12),
            b'o' => Rgb565::new(9, 19, 10),
            b'w' => Rgb565::new(26, 53, 27),
            _ => Rgb565::new(8, 22, 15),
        };
        at += 1;
    }
    texels
}

const SKY: Rgb565 = Rgb565::new(3, 8, 8);
const CAPTION: &str = "fixel";

/// Everything that stays the same from frame to frame.
pub struct Scene {
    size: (u32, u32),
    view: Mvp,
    sun: Light,
}

impl Scene {
    /// Makes the scene for a frame of `width` x `height` pixels.
    ///
    /// # Errors
    ///
    /// No canvas can have this size.
    pub fn new(width: u32, height: u32) -> Result<Self, Error> {
        let size = (width, height);
        let projection = Projection::perspective(deg!(48), size, fx!(1), fx!(30))?;
        let camera = Camera::look_at(vec3!(0, 2.2, 4.6), vec3!(0, -0.2, 0), Vec3::Y)?;
        Ok(Self {
            size,
            view: projection * camera,
            sun: Light::new(vec3!(-2, 4, 3), fx!(0.35), fx!(0.65))?,
        })
    }

    /// Draws one band at the time `now_ms`: as many rows of the frame as `colors` holds, starting at `first_row`. A
    /// pixel is the two bytes that the panel expects, so DMA can send the band as it is. `depths` has one element per
    /// pixel.
    ///
    /// # Errors
    ///
    /// The memory is not a whole number of the frame's rows. Once the sizes are right, this never fails.
    pub fn draw_band(
        &self,
        now_ms: u64,
        first_row: u32,
        colors: &mut [[u8; 2]],
        depths: &mut [u16],
    ) -> Result<(), Error> {
        let (width, height) = self.size;
        let band = Canvas::<Rgb565, BigEndian>::band(colors, width, height, first_row)?;
        self.draw(now_ms, &mut band.with_depth(depths)?);
        Ok(())
    }

    /// Draws the part of the frame that belongs to the canvas.
    pub fn draw<O: Storage<Rgb565>, D: DepthBuffer>(
        &self,
        now_ms: u64,
        canvas: &mut Canvas<'_, Rgb565, O, D>,
    ) {
        canvas.clear(SKY);
        // `Fast` is the mode for cores without a long multiplication, such as the Pico's, and costs other cores
        // nothing.
        let options = DrawOptions::new().with_mode(Fast::within(fx!(0.25)));
        canvas.draw_with(&options, &FLOOR, &self.view, &Textured::new(&TILES));

        let spin = Transform::rotate_y(Rate::rpm(10).angle_at(now_ms))
            * Transform::rotate_x(Rate::rpm(4).angle_at(now_ms));
        let planks = Textured::new(&PLANKS).lit_faces(self.sun);
        canvas.draw_with(&options, &CRATE, &(self.view * spin), &planks);

        let style = MonoTextStyle::new(&FONT_9X18_BOLD, Rgb565::WHITE);
        let Ok(_) = Text::new(CAPTION, Point::new(8, 20), style).draw(canvas);
    }
}
