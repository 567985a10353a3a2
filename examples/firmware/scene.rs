//! What is drawn: the four measured scenes and the project's own, each in its first pose.

use embedded_graphics::pixelcolor::raw::BigEndian;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::prelude::*;
use fixel::target::DepthBuffer;
use fixel::view::Perspective;

use super::common::lighthouse;
use super::common::scenes::{self, HEIGHT, WIDTH};

/// Bytes in the order that a display takes them.
pub type Target<'a, D> = Canvas<'a, Rgb565, BigEndian, D>;

#[derive(Clone, Copy)]
pub enum Scene {
    Floor,
    Cube,
    Sphere,
    SphereFlat,
    Lighthouse,
}

impl Scene {
    pub const ALL: [Self; 5] = [
        Self::Floor,
        Self::Cube,
        Self::Sphere,
        Self::SphereFlat,
        Self::Lighthouse,
    ];

    /// As the simulator knows it: what it draws by default, it does not name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Floor => "floor",
            Self::Cube => "cube",
            Self::Sphere => "sphere",
            Self::SphereFlat => "sphere-flat",
            Self::Lighthouse => "default",
        }
    }

    /// Whether it is drawn with a depth buffer.
    pub fn has_depth(self) -> bool {
        !matches!(self, Self::SphereFlat)
    }

    /// Takes the scene's models to the picture.
    pub fn chain(self) -> Result<Chain<Perspective>, Error> {
        match self {
            Self::Floor => scenes::floor_chain(0),
            Self::Cube => scenes::cube_chain(0),
            Self::Sphere | Self::SphereFlat => scenes::sphere_chain(0),
            Self::Lighthouse => {
                let lens = lighthouse::lens((WIDTH, HEIGHT))?;
                Ok(lens * lighthouse::camera()? * Transform::IDENTITY)
            }
        }
    }

    /// What is there before the models.
    pub fn background<D: DepthBuffer>(self, canvas: &mut Target<'_, D>) {
        match self {
            Self::Lighthouse => lighthouse::sky(canvas),
            _ => canvas.clear(Rgb565::BLACK),
        }
    }

    /// Draws the models, which is what is measured; returns how many triangles were drawn.
    pub fn draw<D: DepthBuffer>(
        self,
        canvas: &mut Target<'_, D>,
        chain: &Chain<Perspective>,
    ) -> Result<u32, Error> {
        Ok(match self {
            Self::Floor => scenes::floor(canvas, chain).drawn,
            Self::Cube => scenes::cube(canvas, chain).drawn,
            Self::Sphere => scenes::sphere(canvas, chain).drawn,
            Self::SphereFlat => scenes::sphere_flat(canvas, chain).drawn,
            Self::Lighthouse => {
                let [sea, island] = lighthouse::draw(canvas, chain)?;
                sea.drawn + island.drawn
            }
        })
    }

    /// What is written over the models.
    pub fn overlay<D: DepthBuffer>(self, canvas: &mut Target<'_, D>) {
        if let Self::Lighthouse = self {
            lighthouse::caption(canvas);
        }
    }
}
