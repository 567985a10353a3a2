//! The scenes: the four measured scenes and the project's own scene, each in its first pose, and the cube with another
//! cube inside.

use embedded_graphics::pixelcolor::raw::BigEndian;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::Prepared;
use fixel::canvas::DepthBuffer;
use fixel::mode::Mode;
use fixel::prelude::*;
use fixel::view::Perspective;

use super::common::lighthouse;
use super::common::scenes::{self, HEIGHT, WIDTH};
use super::nested::{INWARDS, OUTWARDS};

/// A canvas with bytes in the order that displays expect.
pub type Target<'a, D> = Canvas<'a, Rgb565, BigEndian, D>;

#[derive(Clone, Copy)]
pub enum Scene {
    Floor,
    Cube,
    Sphere,
    SphereFlat,
    Lighthouse,
    /// The cube with another cube inside. The outer cube is drawn first, and the depth test hides the inner cube, so
    /// the picture equals the cube's picture.
    Inwards,
    /// The same triangles in reverse order, with 16-bit positions.
    Outwards,
}

impl Scene {
    /// The scenes that are measured.
    pub const ALL: [Self; 5] = [
        Self::Floor,
        Self::Cube,
        Self::Sphere,
        Self::SphereFlat,
        Self::Lighthouse,
    ];

    /// The name of the scene in the simulator. The simulator has no name for its default scene.
    pub fn name(self) -> &'static str {
        match self {
            Self::Floor => "floor",
            Self::Cube | Self::Inwards | Self::Outwards => "cube",
            Self::Sphere => "sphere",
            Self::SphereFlat => "sphere-flat",
            Self::Lighthouse => "default",
        }
    }

    /// Whether the scene is drawn with a depth buffer.
    pub fn has_depth(self) -> bool {
        !matches!(self, Self::SphereFlat)
    }

    /// The model-view-projection of the scene's models.
    pub fn mvp(self) -> Result<Mvp<Perspective>, Error> {
        match self {
            Self::Floor => scenes::floor_mvp(0),
            Self::Cube | Self::Inwards | Self::Outwards => scenes::cube_mvp(0),
            Self::Sphere | Self::SphereFlat => scenes::sphere_mvp(0),
            Self::Lighthouse => {
                let projection = lighthouse::projection((WIDTH, HEIGHT))?;
                Ok(projection * lighthouse::camera()? * Transform::IDENTITY)
            }
        }
    }

    /// Fills the canvas with the scene's background.
    pub fn background<D: DepthBuffer>(self, canvas: &mut Target<'_, D>) {
        match self {
            Self::Lighthouse => lighthouse::sky(canvas),
            _ => canvas.clear(Rgb565::BLACK),
        }
    }

    /// Draws the models. Only this function is measured. Returns the number of triangles drawn.
    pub fn draw<I: Mode, D: DepthBuffer>(
        self,
        canvas: &mut Target<'_, D>,
        options: &DrawOptions<I>,
        mvp: &Mvp<Perspective>,
    ) -> Result<u32, Error> {
        Ok(match self {
            Self::Floor => scenes::floor(canvas, options, mvp).drawn,
            Self::Cube => scenes::cube(canvas, options, mvp).drawn,
            Self::Sphere => scenes::sphere(canvas, options, mvp).drawn,
            Self::SphereFlat => scenes::sphere_flat(canvas, options, mvp).drawn,
            Self::Lighthouse => {
                let [sea, island] = lighthouse::draw(canvas, options, mvp)?;
                sea.drawn + island.drawn
            }
            Self::Inwards => drawn_cubes(canvas, options, mvp, &INWARDS),
            Self::Outwards => drawn_cubes(canvas, options, mvp, &OUTWARDS),
        })
    }

    /// Prepares the models for all bands of the picture.
    pub fn prepare<'l, I: Mode>(
        self,
        lists: &'l mut Lists,
        options: &DrawOptions<I>,
        mvp: &Mvp<Perspective>,
    ) -> Result<PreparedScene<'l, I>, Error> {
        let frame = (WIDTH, HEIGHT);
        let (mesh, sea) = match self {
            Self::Floor => (&scenes::FLOOR, None),
            Self::Cube => (&scenes::CUBE, None),
            Self::Sphere | Self::SphereFlat => (&scenes::SPHERE, None),
            Self::Lighthouse => (&lighthouse::ISLAND, Some(&lighthouse::SEA)),
            Self::Inwards => (&INWARDS, None),
            Self::Outwards => (&OUTWARDS, None),
        };
        Ok(PreparedScene {
            scene: self,
            sea: match sea {
                None => None,
                Some(sea) => Some(lists.sea.prepare(options, frame, sea, mvp)?),
            },
            model: lists.model.prepare(options, frame, mesh, mvp)?,
        })
    }

    /// Writes the scene's caption over the models.
    pub fn overlay<D: DepthBuffer>(self, canvas: &mut Target<'_, D>) {
        if let Self::Lighthouse = self {
            lighthouse::caption(canvas);
        }
    }
}

fn drawn_cubes<I: Mode, D: DepthBuffer>(
    canvas: &mut Target<'_, D>,
    options: &DrawOptions<I>,
    mvp: &Mvp<Perspective>,
    cubes: &Mesh<'_>,
) -> u32 {
    canvas
        .draw_with(options, cubes, mvp, &scenes::checkered())
        .drawn
}

/// Memory for the prepared triangles of any scene: 23 KiB.
pub struct Lists {
    model: DrawList<640, 600>,
    /// A list that only the lighthouse needs.
    sea: DrawList<32, 140>,
}

impl Lists {
    pub const fn new() -> Self {
        Self {
            model: DrawList::new(),
            sea: DrawList::new(),
        }
    }
}

/// The models of a scene, prepared for every band.
pub struct PreparedScene<'l, I> {
    scene: Scene,
    model: Prepared<'l, (), &'l Mesh<'l>, DrawOptions<I>>,
    sea: Option<Prepared<'l, (), &'l Mesh<'l>, DrawOptions<I>>>,
}

impl<I: Mode> PreparedScene<'_, I> {
    /// Draws the rows of this canvas. Returns the number of triangles drawn.
    pub fn draw<D: DepthBuffer>(&self, canvas: &mut Target<'_, D>) -> Result<u32, Error> {
        let Self { scene, model, sea } = self;
        let behind = match sea {
            None => 0,
            Some(sea) => canvas.draw_prepared(sea, &lighthouse::waves())?.drawn,
        };
        let drawn = match scene {
            Scene::Floor | Scene::Cube | Scene::Inwards | Scene::Outwards => {
                canvas.draw_prepared(model, &scenes::checkered())
            }
            Scene::Sphere => canvas.draw_prepared(model, &scenes::shaded()),
            Scene::SphereFlat => canvas.draw_prepared(model, &scenes::faceted()),
            Scene::Lighthouse => canvas.draw_prepared(model, &lighthouse::skin()?),
        }?;
        Ok(behind + drawn.drawn)
    }
}
