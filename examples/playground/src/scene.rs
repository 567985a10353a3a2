//! The scenes, and their draw calls in every mode.

use embedded_graphics::pixelcolor::{BinaryColor, Rgb565, RgbColor};
use fixel::Drawn;
use fixel::canvas::DepthBuffer;
use fixel::mode::Mode;
use fixel::prelude::*;
use fixel::shade::PartColors;

use super::common::{lighthouse, scenes};
use super::formats::Color;
use super::model::{Look, Model};
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
pub type Target<'a, C = Rgb565, D = LinearDepth> = Canvas<'a, C, Native, D>;

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
    pub fn background<D: DepthBuffer>(self, canvas: &mut Target<'_, Rgb565, D>) {
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
    fn draw<C: Color, M: Mode>(
        self,
        canvas: &mut Target<'_, C>,
        view: &View,
        mode: M,
        model: &Model,
    ) -> Result<Drawn, Error> {
        let options = &DrawOptions::new().with_mode(mode).with_cull(view.cull());
        let mvp = &view.mvp()?;
        let checkered = C::shader(scenes::checkered());
        Ok(match self {
            Self::Floor => canvas.draw_with(options, &scenes::FLOOR, mvp, &checkered),
            Self::Cube => canvas.draw_with(options, &scenes::CUBE, mvp, &checkered),
            Self::Sphere | Self::SphereFlat => {
                let shaded = C::shader(scenes::shaded());
                canvas.draw_with(options, &scenes::SPHERE, mvp, &shaded)
            }
            Self::Lighthouse => {
                let (waves, skin) = (
                    C::shader(lighthouse::waves()),
                    C::shader(lighthouse::skin()?),
                );
                both(lighthouse::surfaces(canvas, options, mvp, (&waves, &skin)))
            }
            Self::Own => {
                let sun = Light::new(vec3!(2, 3, 4), fx!(0.35), fx!(0.65))?;
                let (mesh, skin) = (&model.mesh()?, Textured::new(model.texture()?));
                let parts = PartColors::rgb::<Rgb565>(model.parts());
                /// Draws the mesh with a shader in the sun.
                macro_rules! lit {
                    ($shader:expr) => {
                        canvas.draw_with(options, mesh, mvp, &C::shader($shader.lit(sun)))
                    };
                }
                match model.look() {
                    Look::Plain | Look::Texture => lit!(skin),
                    Look::TintedTexture => lit!(skin.tinted()),
                    Look::Parts => lit!(parts),
                    Look::TintedParts => lit!(parts.tinted()),
                    Look::Corners => lit!(Gouraud::<Rgb565>::new()),
                }
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

/// Draws a view, or a band of it, in a mode: all scenes but the flat sphere with a depth buffer.
///
/// # Errors
///
/// The view's camera is out of range, there is no model, or the memory is too short.
pub fn draw<C: Color, M: Mode>(
    colors: &mut [C],
    depths: &mut [u16],
    view: &View,
    mode: M,
    model: &Model,
) -> Result<Drawn, Error> {
    let mut canvas = Canvas::band(colors, view.size.width, view.size.height, view.first_row)?;
    if view.scene.has_depth() {
        return view
            .scene
            .draw(&mut canvas.with_depth(depths)?, view, mode, model);
    }
    let options = &DrawOptions::new().with_mode(mode).with_cull(view.cull());
    let faceted = C::shader(scenes::faceted());
    Ok(canvas.draw_with(options, &scenes::SPHERE, &view.mvp()?, &faceted))
}

/// Draws the lighthouse by night, as it is drawn in black and white, with its background and caption.
///
/// # Errors
///
/// The view's camera is out of range.
pub fn night<M: Mode>(
    canvas: &mut Target<'_, BinaryColor>,
    view: &View,
    mode: M,
) -> Result<Drawn, Error> {
    let options = DrawOptions::new().with_mode(mode).with_cull(view.cull());
    lighthouse::sky(canvas);
    let drawn = lighthouse::draw(canvas, &options, &view.mvp()?)?;
    lighthouse::caption(canvas);
    Ok(both(drawn))
}

/// What two draw calls did.
fn both([sea, island]: [Drawn; 2]) -> Drawn {
    let mut drawn = sea;
    drawn += island;
    drawn
}
