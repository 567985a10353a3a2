//! The scenes, and their draw calls in every mode.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::Drawn;
use fixel::canvas::{DepthBuffer, NoDepth};
use fixel::mode::Mode;
use fixel::prelude::*;

use super::common::{lighthouse, scenes};
use super::model::Model;
use super::view::View;

/// A scene. The page knows it by its place in the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scene {
    Floor,
    Cube,
    Sphere,
    SphereFlat,
    Lighthouse,
    /// The user's model.
    Own,
    /// The little world, which a module of its own draws.
    World,
}

/// The canvas of a scene; most scenes have a depth buffer.
pub type Target<'a, D = LinearDepth> = Canvas<'a, Rgb565, Native, D>;

/// A mesh of a scene, with the size of its texture.
pub struct Part<'a> {
    pub mesh: Mesh<'a>,
    pub texels: [u32; 2],
}

impl Scene {
    /// The scene at a place in the list.
    pub fn at(place: usize) -> Self {
        let list = [
            Self::Floor,
            Self::Cube,
            Self::Sphere,
            Self::SphereFlat,
            Self::Lighthouse,
            Self::Own,
            Self::World,
        ];
        list.get(place).copied().unwrap_or(Self::Floor)
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

    /// Draws the scene with a depth buffer, in a mode.
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
        let mvp = &view.mvp()?;
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
            Self::World => return Ok(Drawn::default()),
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
            Self::World => Ok([None, None]),
        }
    }
}

/// Draws the flat sphere, which needs no depth buffer.
///
/// # Errors
///
/// The view's camera is out of range.
pub fn flat<M: Mode>(
    canvas: &mut Target<'_, NoDepth>,
    view: &View,
    mode: M,
) -> Result<Drawn, Error> {
    let options = &DrawOptions::new().with_mode(mode).with_cull(view.cull());
    Ok(scenes::sphere_flat(canvas, options, &view.mvp()?))
}

/// Draws the lighthouse in any color; in black and white with its background.
///
/// # Errors
///
/// The view's camera is out of range.
pub fn lighthouse<C: PixelFormat, M: Mode>(
    canvas: &mut Canvas<'_, C, Native, LinearDepth>,
    view: &View,
    mode: M,
) -> Result<Drawn, Error> {
    let options = DrawOptions::new().with_mode(mode).with_cull(view.cull());
    if view.is_mono() {
        lighthouse::sky(canvas);
    }
    let [sea, island] = lighthouse::draw(canvas, &options, &view.mvp()?)?;
    Ok(Drawn {
        submitted: sea.submitted + island.submitted,
        drawn: sea.drawn + island.drawn,
        clipped: sea.clipped + island.clipped,
        ..sea
    })
}
