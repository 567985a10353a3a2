//! The pieces of a model, each of one material.

use embedded_graphics::pixelcolor::Rgb888;
use fixel::Mesh;

/// The color of surfaces that have none of their own.
pub const CLAY: Rgb888 = Rgb888::new(236, 214, 190);

/// How a material is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Finish {
    /// Index of its texture.
    pub texture: Option<usize>,
    /// The color, if there is no texture and the vertices have no colors.
    pub color: Rgb888,
}

impl Finish {
    /// A texture; where textures are not drawn, clay.
    pub const fn textured(texture: usize) -> Self {
        Self {
            texture: Some(texture),
            color: CLAY,
        }
    }

    /// One color.
    pub const fn plain([r, g, b]: [u8; 3]) -> Self {
        Self {
            texture: None,
            color: Rgb888::new(r, g, b),
        }
    }
}

/// A mesh and its material.
#[derive(Clone, Copy, Debug)]
pub struct Piece<'a> {
    pub mesh: Mesh<'a>,
    pub finish: Finish,
}
