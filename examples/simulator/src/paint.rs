//! The shader of each piece, in any look and any color format.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use fixel::shade::{
    Channels, ColorOf, Converted, DepthView, FaceColors, Flat, Gouraud, Illumination, Lighting,
    Matte, NormalView, PixelFormat, Rgb, Source, Texels, Textured, Translucent, Varyings, Within,
};
use fixel::texture::{Bilinear, Blend, Clamp, Nearest, Repeat};
use fixel::{Fragment, Primitive};
use fixel_assets::Alpha;

use super::Result;
use super::common::{lighthouse, scenes};
use super::look::{Backdrop, Look};
use super::surface::{FaceValues, Show, Surface};
use crate::args::{Filter, SceneName, Shade};
use crate::part::{Finish, Piece};
use crate::view::View;

/// A color that textures are stored in.
pub trait Stored:
    PixelFormat<Channels: Varyings<Face: FaceValues> + FaceValues> + Blend + Into<Rgb888> + 'static
{
}

impl Stored for Rgb565 {}
impl Stored for Rgb888 {}
impl Stored for Gray8 {}

/// A canvas's color, and the texture's color for it.
pub trait Shown:
    PixelFormat<Channels: Varyings<Face: FaceValues> + FaceValues> + Into<Rgb888> + Default + 'static
{
    /// The color that a texture is stored in. For dithered formats it is a finer color, because the picture must be
    /// dithered, not the texture.
    type Texel: Stored;
}

impl Shown for Rgb565 {
    type Texel = Self;
}
impl Shown for Rgb888 {
    type Texel = Self;
}
impl Shown for Gray8 {
    type Texel = Self;
}
impl Shown for Gray4 {
    type Texel = Gray8;
}
impl Shown for BinaryColor {
    type Texel = Gray8;
}

/// A texture of colors and opacities.
pub type Skin<'a, T> = Texture<'a, Translucent<T>>;

type Sampled<'a, T, A, F> = Textured<&'a Skin<'a, T>, A, F>;

/// A surface without light: one color, or a texture in one of four ways.
#[derive(Clone, Copy)]
enum Base<'a, T> {
    Plain(Converted<Flat<Rgb888>, T>),
    Repeated(Sampled<'a, T, Repeat, Nearest>),
    Clamped(Sampled<'a, T, Clamp, Nearest>),
    RepeatedSmooth(Sampled<'a, T, Repeat, Bilinear>),
    ClampedSmooth(Sampled<'a, T, Clamp, Bilinear>),
}

fn opaque<T>(color: T) -> Translucent<T> {
    Translucent {
        color,
        opacity: 255,
    }
}

impl<'a, T: Stored> Base<'a, T> {
    fn new(texture: Option<&'a Skin<'a, T>>, finish: &Finish, filter: Filter, white: bool) -> Self {
        let Some(texture) = texture else {
            let color = if white { Rgb888::WHITE } else { finish.color };
            return Self::Plain(Flat::rgb(color));
        };
        let skin = Textured::new(texture);
        match (filter, finish.is_clamped) {
            (Filter::Nearest, false) => Self::Repeated(skin),
            (Filter::Nearest, true) => Self::Clamped(skin.clamped()),
            (Filter::Bilinear, false) => Self::RepeatedSmooth(skin.bilinear()),
            (Filter::Bilinear, true) => Self::ClampedSmooth(skin.clamped().bilinear()),
        }
    }
}

/// Calls a method of the shader in a base; the first case is the one of a single color.
macro_rules! sampled {
    ($base:expr, |$flat:ident| $plain:expr, |$skin:ident| $call:expr) => {
        match $base {
            Base::Plain($flat) => $plain,
            Base::Repeated($skin) => $call,
            Base::Clamped($skin) => $call,
            Base::RepeatedSmooth($skin) => $call,
            Base::ClampedSmooth($skin) => $call,
        }
    };
}

impl<T: Stored> Shader for Base<'_, T> {
    type Color = Translucent<T>;
    type Varyings = Texels;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Texels; 3] {
        sampled!(self, |_flat| [Texels([0; 2]); 3], |skin| skin
            .varyings(primitive))
    }

    fn shade(&self, at: &Fragment, texels: Texels) -> Option<Self::Color> {
        sampled!(self, |flat| flat.shade(at, ()).map(opaque), |skin| skin
            .shade(at, texels))
    }

    fn shade_lit(&self, at: &Fragment, texels: Texels, light: Illumination) -> Option<Self::Color> {
        sampled!(
            self,
            |flat| flat.shade_lit(at, (), light).map(opaque),
            |skin| { skin.shade_lit(at, texels, light) }
        )
    }
}

/// A surface times the colors of the vertices times the light.
///
/// The library's `surface.tinted().lit(light)` interpolates both colors, which takes six numbers. This shader
/// multiplies them at each corner, and interpolates the three products. This leaves room for a texture and fog among
/// the eight numbers that are allowed.
#[derive(Clone, Copy)]
struct TintedLit<S, L> {
    surface: S,
    light: L,
}

impl<S, L> Shader for TintedLit<S, L>
where
    S: Shader<Color: Source<Color: PixelFormat>>,
    L: Lighting<Diffuse = Rgb, Specular = Matte>,
{
    type Color = S::Color;
    type Varyings = (
        S::Varyings,
        Within<64, <ColorOf<S> as PixelFormat>::Channels>,
    );

    const READS_DEPTH: bool = S::READS_DEPTH;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let white = Flat::<ColorOf<S>>::rgb(Rgb888::WHITE);
        let tints = white.tinted().varyings(primitive);
        let lights = white.lit(self.light).varyings(primitive);
        let inner = self.surface.varyings(primitive);
        [0, 1, 2].map(|corner| {
            let (((), Within(tint)), ((), Within((light, ())))) = (tints[corner], lights[corner]);
            let (tint, light) = (tint.all(), light.all());
            // At most 2^16 each.
            let product = [0, 1, 2].map(|at| {
                let product = i64::from(tint[at]) * i64::from(light[at]);
                (product >> 16) as i32
            });
            (inner[corner], Within(Channels::first(product)))
        })
    }

    fn shade(&self, at: &Fragment, (inside, Within(light)): Self::Varyings) -> Option<S::Color> {
        let light = Illumination {
            diffuse: light.all(),
            specular: None,
        };
        self.surface.shade_lit(at, inside, light)
    }
}

/// Converts a color of the canvas to the color that a computer's screen shows.
fn screen<C: Into<Rgb888>>(color: C, _: Point) -> Rgb888 {
    color.into()
}

/// Shows a texture's color at a pixel of a canvas of color `C`.
fn shown<C: Shown>(texel: C::Texel, at: Point) -> Rgb888 {
    on_canvas::<C>(texel.into(), at)
}

/// The color of a canvas of color `C` that is nearest to `color` at a pixel.
pub fn on_canvas<C: Shown>(color: Rgb888, at: Point) -> Rgb888 {
    C::from_rgb(color, at).into()
}

/// The shader of a piece that needs more than a color and light. It computes in the texture's color, and the result is
/// then `shown`.
fn stored<'a, T: Stored>(
    look: &'a Look,
    filter: Filter,
    piece: &Piece<'_>,
    texture: Option<&'a Skin<'a, T>>,
    shown: Show<T>,
) -> Result<Surface<'a>> {
    let finish = piece.finish;
    let has_colors = piece.mesh.has_colors();
    let base = Base::new(texture, &finish, filter, has_colors);
    let (light, contrast) = (look.light(), look.contrast);
    let glow = T::from_rgb(finish.glow, Point::zero());
    // Where a texture is reduced or smooth, the border of a hole lies at half of its alpha.
    let least = if matches!(finish.alpha, Alpha::Cut(_)) {
        128
    } else {
        0
    };
    let touch = move |_: &Fragment, source: Translucent<T>| {
        let color = source.color.plus(glow);
        let color = contrast.map_or(color, |contrast| {
            let gray = Gray8::from_rgb(color.into(), Point::zero());
            T::from_rgb(contrast.stretch(gray).into(), Point::zero())
        });
        let opacity = match finish.alpha {
            Alpha::Blended => source.faded(finish.opacity).opacity,
            _ => finish.opacity,
        };
        (source.opacity >= least).then_some(Translucent { color, opacity })
    };
    let fog = look.fog::<T>()?;
    /// Wraps a shader with what comes after the light.
    macro_rules! surface {
        ($shader:expr) => {
            match fog {
                Some(fog) => Surface::new(Surface::Many, $shader.map(touch).in_fog(fog), shown),
                None => Surface::new(Surface::Many, $shader.map(touch), shown),
            }
        };
    }
    match (look.shade, has_colors) {
        (Some(Shade::Texture), false) => surface!(base),
        (Some(Shade::Texture), true) => surface!(base.tinted()),
        (Some(Shade::Flat), false) => surface!(base.lit_faces(light)),
        (Some(Shade::Flat), true) => surface!(base.tinted().lit_faces(light)),
        (_, false) => surface!(base.lit(light)),
        (_, true) => surface!(TintedLit {
            surface: base,
            light
        }),
    }
}

/// The shader of a piece that has only colors and light. Each color is dithered once, from the exact color.
fn bare<'a, C: Shown>(look: &'a Look, piece: &Piece<'_>) -> Result<Surface<'a>> {
    let light = look.light();
    let screen: Show<C> = screen;
    if piece.mesh.has_colors() {
        let colors = Gouraud::<C>::new();
        match look.shade {
            Some(Shade::Texture) => vertex_colors::<C>(),
            Some(Shade::Flat) => {
                Surface::opaque(Surface::Channels, colors.lit_faces(light), screen)
            }
            _ => Surface::opaque(Surface::Channels, colors.lit(light), screen),
        }
    } else {
        let color = Flat::<C>::rgb(piece.finish.color);
        match look.shade {
            Some(Shade::Texture) => Surface::opaque(Surface::Many, color, screen),
            Some(Shade::Flat) => Surface::opaque(Surface::Many, color.lit_faces(light), screen),
            _ => Surface::opaque(Surface::Many, color.lit(light), screen),
        }
    }
}

/// The shader of the vertices' colors, without light.
fn vertex_colors<C: Shown>() -> Result<Surface<'static>> {
    let colors = Gouraud::<C>::new();
    if <Gouraud<C> as Shader>::Varyings::PAIRS {
        Surface::opaque(Surface::Pairs, colors, screen)
    } else {
        Surface::opaque(Surface::Channels, colors, screen)
    }
}

/// The shader of a piece of a model with its `texture`.
///
/// # Errors
///
/// The fog ends before it begins.
pub fn surface<'a, C: Shown>(
    look: &'a Look,
    view: &View,
    filter: Filter,
    piece: &Piece<'_>,
    texture: Option<&'a Skin<'a, C::Texel>>,
) -> Result<Surface<'a>> {
    let finish = piece.finish;
    let is_textured = matches!(look.shade, Some(Shade::Texture | Shade::Lit));
    let texture = texture.filter(|_| is_textured);
    match look.shade {
        Some(Shade::Normal) => Surface::opaque(Surface::Channels, NormalView::<C>::new(), screen),
        // What an outline hides has the color of the background.
        Some(Shade::Wire) => {
            let Backdrop::Color(color) = look.backdrop else {
                return Err("a wire has a background of one color".into());
            };
            Surface::opaque(Surface::Many, Flat::new(color), on_canvas::<C>)
        }
        Some(Shade::Depth) => {
            let [near, far] = view.depths;
            // The farthest point must remain visible on black.
            let far = far.saturating_sub((near.saturating_sub(far)) / 6);
            Surface::opaque(Surface::Many, DepthView::<C>::between(far, near), screen)
        }
        _ if texture.is_some()
            || look.has_fog()
            || look.contrast.is_some()
            || finish.glow != Rgb888::BLACK
            || finish.opacity < 255 =>
        {
            stored(look, filter, piece, texture, shown::<C>)
        }
        _ => bare::<C>(look, piece),
    }
}

/// The shaders of the project's own scene in a color type: the sea's and the island's.
///
/// # Errors
///
/// None: the scene's numbers are constant.
pub fn own<C: Shown>() -> Result<Vec<Surface<'static>>> {
    Ok(if lighthouse::is_mono::<C>() {
        vec![
            Surface::opaque(Surface::Many, lighthouse::crests::<C>(), screen)?,
            Surface::opaque(Surface::Many, lighthouse::stretched::<C>()?, screen)?,
        ]
    } else {
        vec![
            Surface::opaque(Surface::Many, lighthouse::waves::<C>(), screen)?,
            Surface::opaque(Surface::Many, lighthouse::skin::<C>()?, screen)?,
        ]
    })
}

/// The shader of a measured scene in color `C`. The measurements may use another color.
///
/// # Errors
///
/// None.
pub fn measured<C: Shown>(scene: SceneName) -> Result<Surface<'static>> {
    match scene {
        SceneName::Floor | SceneName::Cube => {
            let checker = Textured::new(&scenes::CHECKER).converted::<C>();
            Surface::opaque(Surface::Many, checker, screen)
        }
        SceneName::Sphere => vertex_colors::<C>(),
        SceneName::SphereFlat => {
            let colors = FaceColors::new(&scenes::FACE_COLORS).converted::<C>();
            Surface::opaque(Surface::Many, colors, screen)
        }
    }
}
