//! The scenes, and their draw calls in every mode.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::Drawn;
use fixel::mode::Mode;
use fixel::prelude::*;
use fixel::target::{Depth, DepthBuffer, Native, NoDepth};
use fixel::view::Perspective;

use super::common::{lighthouse, scenes};
use super::model::Model;
use super::view::View;

/// A scene. The page knows it by its index in `ALL`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scene {
    Floor,
    Cube,
    Sphere,
    SphereFlat,
    Lighthouse,
    Own,
}

/// The canvas of a scene; most scenes have a depth buffer.
pub type Target<'a, D = Depth<'a>> = Canvas<'a, Rgb565, Native, D>;

/// A mesh of a scene, with the size of its texture.
pub struct Part<'a> {
    pub mesh: Mesh<'a>,
    pub texels: [u32; 2],
}

impl Scene {
    pub const ALL: [Self; 6] = [
        Self::Floor,
        Self::Cube,
        Self::Sphere,
        Self::SphereFlat,
        Self::Lighthouse,
        Self::Own,
    ];

    /// The scene of a view.
    pub fn of(view: &View) -> Self {
        Self::ALL
            .get(view.scene as usize)
            .copied()
            .unwrap_or(Self::Floor)
    }

    /// # Errors
    ///
    /// The view's camera is out of range.
    pub fn mvp(self, view: &View) -> Result<Mvp<Perspective>, Error> {
        match self {
            _ if view.is_home == 0 => view.mvp(),
            Self::Floor => scenes::floor_chain(0),
            Self::Cube => scenes::cube_chain(0),
            Self::Sphere | Self::SphereFlat => scenes::sphere_chain(0),
            Self::Lighthouse => {
                let projection = lighthouse::projection(view.size())?;
                Ok(projection * lighthouse::camera()? * Transform::IDENTITY)
            }
            Self::Own => view.mvp(),
        }
    }

    /// Whether it is drawn with a depth buffer.
    pub fn has_depth(self) -> bool {
        self != Self::SphereFlat
    }

    /// Fills the canvas with the scene's background.
    pub fn background<D: DepthBuffer>(self, canvas: &mut Target<'_, D>) {
        match self {
            Self::Lighthouse => lighthouse::sky(canvas),
            _ => canvas.clear(Rgb565::BLACK),
        }
    }

    /// Draws the scene that has no depth buffer.
    ///
    /// # Errors
    ///
    /// The view's camera is out of range.
    pub fn draw_flat<M: Mode>(
        self,
        canvas: &mut Target<'_, NoDepth>,
        view: &View,
        mode: M,
    ) -> Result<Drawn, Error> {
        let options = &DrawOptions::new().with_mode(mode).with_cull(view.cull());
        Ok(scenes::sphere_flat(canvas, options, &self.mvp(view)?))
    }

    /// Draws another scene in a mode.
    ///
    /// # Errors
    ///
    /// The view's camera is out of range, or there is no model.
    pub fn draw<M: Mode>(
        self,
        canvas: &mut Target<'_>,
        view: &View,
        mode: M,
        model: &Model,
    ) -> Result<Drawn, Error> {
        let options = &DrawOptions::new().with_mode(mode).with_cull(view.cull());
        let mvp = &self.mvp(view)?;
        Ok(match self {
            Self::Floor => scenes::floor(canvas, options, mvp),
            Self::Cube => scenes::cube(canvas, options, mvp),
            Self::Sphere | Self::SphereFlat => scenes::sphere(canvas, options, mvp),
            Self::Lighthouse => return lighthouse(canvas, view, mode),
            Self::Own => {
                let sun = Light::new(vec3!(2, 3, 4), fx!(0.35), fx!(0.65))?;
                canvas.draw_with(
                    options,
                    &model.mesh()?,
                    mvp,
                    &Textured::new(model.texture()?).lit(sun),
                )
            }
        })
    }

    /// The scene's meshes in the order of their draw calls.
    ///
    /// # Errors
    ///
    /// There is no model.
    pub fn parts(self, model: &Model) -> Result<[Option<Part<'_>>; 2], Error> {
        let one = |mesh, texels| Ok([Some(Part { mesh, texels }), None]);
        match self {
            Self::Floor => one(scenes::FLOOR, [64; 2]),
            Self::Cube => one(scenes::CUBE, [64; 2]),
            Self::Sphere | Self::SphereFlat => one(scenes::SPHERE, [64; 2]),
            Self::Lighthouse => Ok([
                Some(Part {
                    mesh: lighthouse::SEA,
                    texels: [64; 2],
                }),
                Some(Part {
                    mesh: lighthouse::ISLAND,
                    texels: [128; 2],
                }),
            ]),
            Self::Own => {
                let texture = model.texture()?;
                one(model.mesh()?, [texture.width(), texture.height()])
            }
        }
    }
}

/// Draws the lighthouse in any color; in black and white with its background.
///
/// # Errors
///
/// The view's camera is out of range.
pub fn lighthouse<C: Levels, M: Mode>(
    canvas: &mut Canvas<'_, C, Native, Depth<'_>>,
    view: &View,
    mode: M,
) -> Result<Drawn, Error> {
    let options = DrawOptions::new().with_mode(mode);
    if view.is_mono == 1 {
        lighthouse::sky(canvas);
    }
    let [sea, island] = lighthouse::draw(canvas, &options, &Scene::Lighthouse.mvp(view)?)?;
    Ok(Drawn {
        submitted: sea.submitted + island.submitted,
        drawn: sea.drawn + island.drawn,
        clipped: sea.clipped + island.clipped,
        ..sea
    })
}
