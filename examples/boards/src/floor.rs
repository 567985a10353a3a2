//! A crate turns above a tiled floor.

use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_9X18_BOLD};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::text::Text;
use fixel::canvas::Storage;
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
    view: Mvp,
    sun: Light,
}

/// This scene prepares nothing that needs memory.
pub struct Memory;

impl Memory {
    /// Empty memory.
    #[must_use]
    #[allow(clippy::new_without_default)] // for statics
    pub const fn new() -> Self {
        Self
    }
}

impl Scene {
    /// Makes the scene for a frame of `width` x `height` pixels.
    ///
    /// # Errors
    ///
    /// No canvas can have this size.
    pub fn new(width: u32, height: u32) -> Result<Self, Error> {
        let projection = Projection::perspective(deg!(48), (width, height), fx!(1), fx!(30))?;
        let camera = Camera::look_at(vec3!(0, 2.2, 4.6), vec3!(0, -0.2, 0), Vec3::Y)?;
        Ok(Self {
            view: projection * camera,
            sun: Light::new(vec3!(-2, 4, 3), fx!(0.35), fx!(0.65))?,
        })
    }

    /// The scene at the time `now_ms`.
    ///
    /// # Errors
    ///
    /// None.
    pub fn at<'s>(&'s self, now_ms: u64, _: &'s mut Memory) -> Result<Moment<'s>, Error> {
        let spin = Transform::rotate_y(Rate::rpm(10).angle_at(now_ms))
            * Transform::rotate_x(Rate::rpm(4).angle_at(now_ms));
        Ok(Moment {
            scene: self,
            crate_mvp: self.view * spin,
        })
    }
}

/// A moment of the scene.
pub struct Moment<'s> {
    scene: &'s Scene,
    crate_mvp: Mvp,
}

impl Moment<'_> {
    /// Draws the part of the frame that belongs to the canvas.
    pub fn draw<O: Storage<Rgb565>>(&self, canvas: &mut Canvas<'_, Rgb565, O>) {
        canvas.clear(SKY);
        // `Fast` is the mode for cores without a long multiplication, such as the Pico's. A Cortex-M4 would be a tenth
        // faster in the default mode. Wherever both are seen, the crate is in front of the floor. So in this order, no
        // depth buffer is needed.
        let options = DrawOptions::new().with_mode(Fast::within(fx!(0.25)));
        canvas.draw_with(&options, &FLOOR, &self.scene.view, &Textured::new(&TILES));
        let planks = Textured::new(&PLANKS).lit_faces(self.scene.sun);
        canvas.draw_with(&options, &CRATE, &self.crate_mvp, &planks);

        let style = MonoTextStyle::new(&FONT_9X18_BOLD, Rgb565::WHITE);
        canvas.overlay(&Text::new(CAPTION, Point::new(8, 20), style));
    }
}
