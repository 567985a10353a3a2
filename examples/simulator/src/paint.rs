//! Makes the shader of each piece, for any look and any color format.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use fixel::shade::{
    Channels, ColorOf, Converted, DepthView, FaceColors, Flat, Gouraud, Illumination, Lighting,
    NormalView, Output, PixelFormat, Precise, PreciseOf, Texels, Textured, Translucent, Varyings,
    Within,
};
use fixel::texture::{Bilinear, Blend, Nearest};
use fixel::{Fragment, Primitive};
use fixel_assets::Alpha;

use super::Result;
use super::common::{lighthouse, scenes};
use super::look::{Backdrop, Look};
use super::surface::{FaceValues, Surface};
use crate::args::{Filter, SceneName, Shade};
use crate::part::{Finish, Piece};
use crate::view::View;

/// A color type for stored textures.
pub trait Stored:
    PixelFormat<Channels: Varyings<Face: FaceValues> + FaceValues> + Blend + Into<Rgb888> + 'static
{
}

impl Stored for Rgb565 {}
impl Stored for Rgb888 {}
impl Stored for Gray8 {}

/// The color type of a canvas. It determines the color type of textures on this canvas.
pub trait Shown:
    PixelFormat<Channels: Varyings<Face: FaceValues> + FaceValues> + Into<Rgb888> + Default + 'static
{
    /// The color type in which a texture is stored. For dithered formats, the texture has a finer type, because the
    /// picture must be dithered, not the texture.
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

type Sampled<'a, C, const CLAMPED: bool, F> =
    Converted<Textured<Skin<'a, <C as Shown>::Texel>, CLAMPED, F>, C>;

/// A surface without light: one color, or a texture that is drawn in one of four ways.
#[derive(Clone, Copy)]
enum Base<'a, C: Shown> {
    Plain(Flat<Precise<C>>),
    Repeated(Sampled<'a, C, false, Nearest>),
    Clamped(Sampled<'a, C, true, Nearest>),
    RepeatedSmooth(Sampled<'a, C, false, Bilinear>),
    ClampedSmooth(Sampled<'a, C, true, Bilinear>),
}

impl<'a, C: Shown> Base<'a, C> {
    fn new(
        texture: Option<&'a Skin<'a, C::Texel>>,
        finish: &Finish,
        filter: Filter,
        white: bool,
    ) -> Self {
        let Some(texture) = texture else {
            let color = if white { Rgb888::WHITE } else { finish.color };
            return Self::Plain(Flat::rgb(color));
        };
        let skin = Textured::new(*texture);
        match (filter, finish.is_clamped) {
            (Filter::Nearest, false) => Self::Repeated(skin.converted()),
            (Filter::Nearest, true) => Self::Clamped(skin.clamped().converted()),
            (Filter::Bilinear, false) => Self::RepeatedSmooth(skin.bilinear().converted()),
            (Filter::Bilinear, true) => Self::ClampedSmooth(skin.clamped().bilinear().converted()),
        }
    }
}

/// Evaluates an expression with the shader inside a `Base`. The first expression is for a single color, the second for
/// a texture.
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

impl<C: Shown> Shader for Base<'_, C> {
    type Color = Translucent<Precise<C>>;
    type Varyings = Texels;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Texels; 3] {
        sampled!(self, |_flat| [Texels([0; 2]); 3], |skin| skin
            .varyings(primitive))
    }

    fn shade(&self, at: &Fragment, texels: Texels) -> Option<Self::Color> {
        let opacity = 255;
        let opaque = |color| Translucent { color, opacity };
        sampled!(self, |flat| flat.shade(at, ()).map(opaque), |skin| skin
            .shade(at, texels))
    }
}

/// A surface times the colors of the vertices, times the light.
///
/// The library's `surface.tinted().lit(light)` interpolates both colors, which takes six numbers. This shader
/// multiplies the two colors at each corner, and interpolates only the product, which takes three. So a texture and fog
/// fit into the eight numbers that are allowed.
#[derive(Clone, Copy)]
struct TintedLit<S, L> {
    surface: S,
    light: L,
}

impl<S, L> Shader for TintedLit<S, L>
where
    S: Shader<Color: Output<Color: PixelFormat>>,
    L: Lighting<Diffuse = [i32; 3], Specular = ()>,
{
    type Color = PreciseOf<S>;
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
        let corner = |corner: usize| {
            let (((), Within(tint)), ((), Within((light, ())))) = (tints[corner], lights[corner]);
            let ([r, g, b], [x, y, z]) = (tint.rgb(), light.rgb());
            // Tint and light are at most 2^16 in each channel.
            let times = |tint: i32, light: i32| ((i64::from(tint) * i64::from(light)) >> 16) as i32;
            let product = [times(r, x), times(g, y), times(b, z)];
            (inner[corner], Within(Channels::of(product)))
        };
        [corner(0), corner(1), corner(2)]
    }

    fn shade(
        &self,
        at: &Fragment,
        (inside, Within(light)): Self::Varyings,
    ) -> Option<PreciseOf<S>> {
        let light = Illumination {
            diffuse: light.rgb(),
            specular: (),
        };
        Some(self.surface.shade(at, inside)?.lit(light))
    }
}

/// A surface in fog, or without fog. So a single type, and a single copy of the code, serves both.
#[derive(Clone, Copy)]
struct InAnyFog<S, C> {
    surface: S,
    fog: Option<Fog<C>>,
}

/// A shader of one output.
#[derive(Clone, Copy)]
struct Given<O>(O);

impl<O: Output> Shader for Given<O> {
    type Color = O;
    type Varyings = ();

    fn varyings(&self, _: &Primitive<'_>) -> [(); 3] {
        [(); 3]
    }

    fn shade(&self, _: &Fragment, (): ()) -> Option<O> {
        Some(self.0)
    }
}

impl<S, C> Shader for InAnyFog<S, C>
where
    S: Shader<Color = Translucent<Precise<C>>>,
    C: PixelFormat,
{
    type Color = Translucent<Precise<C>>;
    type Varyings = (S::Varyings, Within<64, i32>);

    const READS_DEPTH: bool = S::READS_DEPTH;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let [a, b, c] = self.surface.varyings(primitive);
        let [x, y, z] = match self.fog {
            Some(fog) => Given(Precise::<C>::of_rgb(Rgb888::BLACK))
                .in_fog(fog)
                .varyings(primitive),
            None => [((), Within(0)); 3],
        };
        [(a, x.1), (b, y.1), (c, z.1)]
    }

    fn shade(&self, at: &Fragment, (inside, fog): Self::Varyings) -> Option<Self::Color> {
        let color = self.surface.shade(at, inside)?;
        match self.fog {
            Some(far) => Some(
                Given(color)
                    .in_fog(far)
                    .shade(at, ((), fog))?
                    .map(|color| color),
            ),
            None => Some(color),
        }
    }
}

/// The color nearest to `color` that a canvas of color `C` can show at a pixel.
pub fn on_canvas<C: Shown>(color: Rgb888, at: Point) -> Rgb888 {
    C::from_rgb(color, at).into()
}

/// The shader of a piece that needs more than colors and light.
fn rich<'a, C: Shown>(
    look: &'a Look,
    shade: Option<Shade>,
    filter: Filter,
    piece: &Piece<'_>,
    texture: Option<&'a Skin<'a, C::Texel>>,
) -> Result<Surface<'a>> {
    let finish = piece.finish;
    let has_colors = piece.mesh.has_colors();
    let base = Base::<C>::new(texture, &finish, filter, has_colors);
    let (light, contrast) = (look.light(), look.contrast);
    let glow = Precise::of_rgb(finish.glow);
    // If a texture is reduced or smooth, its alpha changes gradually. The border of a hole is then where alpha is one
    // half.
    let least = if matches!(finish.alpha, Alpha::Cut(_)) {
        128
    } else {
        0
    };
    let touch = move |at: &Fragment, source: Translucent<Precise<C>>| {
        let color = source.color.plus(glow);
        let color = contrast.map_or(color, |contrast| {
            let gray = color.converted::<Gray8>().finish(at.point);
            Precise::of_rgb(contrast.stretch(gray).into())
        });
        let opacity = match finish.alpha {
            Alpha::Blended => source.faded(finish.opacity).opacity,
            _ => finish.opacity,
        };
        (source.opacity >= least).then_some(Translucent { color, opacity })
    };
    let fog = look.fog::<C>()?;
    /// Adds to a shader everything that follows the light: `touch` and fog.
    macro_rules! surface {
        ($shader:expr) => {{
            let surface = $shader.map(touch);
            Surface::new(Surface::Many, InAnyFog { surface, fog }, C::into)
        }};
    }
    match (shade, has_colors) {
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

/// The shader of a piece that has only colors and light. Each color is dithered only once, from its exact value.
fn bare<'a, C: Shown>(
    look: &'a Look,
    shade: Option<Shade>,
    piece: &Piece<'_>,
) -> Result<Surface<'a>> {
    let light = look.light();
    if piece.mesh.has_colors() {
        let colors = Gouraud::<C>::new();
        match shade {
            Some(Shade::Texture) => interpolated(Gouraud::<C>::new()),
            Some(Shade::Flat) => Surface::new(Surface::Channels, colors.lit_faces(light), C::into),
            _ => Surface::new(Surface::Channels, colors.lit(light), C::into),
        }
    } else {
        let color = Flat::<C>::rgb(piece.finish.color);
        match shade {
            Some(Shade::Texture) => Surface::new(Surface::Many, color, C::into),
            Some(Shade::Flat) => Surface::new(Surface::Many, color.lit_faces(light), C::into),
            _ => Surface::new(Surface::Many, color.lit(light), C::into),
        }
    }
}

/// Wraps a shader of interpolated colors, without light.
fn interpolated<'a, C: Shown, S>(colors: S) -> Result<Surface<'a>>
where
    S: ShaderFor<C, Varyings = Precise<C>> + 'a,
{
    if S::Varyings::PAIRS {
        Surface::new(Surface::Pairs, colors, C::into)
    } else {
        Surface::new(Surface::Channels, colors, C::into)
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
    let shade = match look.shade {
        Some(Shade::Lit | Shade::Gouraud | Shade::Flat) if finish.is_unlit => Some(Shade::Texture),
        shade => shade,
    };
    match shade {
        Some(Shade::Normal) => interpolated(NormalView::<C>::new()),
        // The faces have the color of the background: they cannot be seen, but hide the lines behind them.
        Some(Shade::Wire) => {
            let Backdrop::Color(color) = look.backdrop else {
                return Err("a wire has a background of one color".into());
            };
            Surface::new(Surface::Many, Flat::<C>::rgb(color), C::into)
        }
        Some(Shade::Depth) => {
            let [near, far] = view.depths;
            // The farthest point must remain visible on black.
            let far = far.saturating_sub((near.saturating_sub(far)) / 6);
            Surface::new(Surface::Many, DepthView::<C>::between(far, near), C::into)
        }
        _ if texture.is_some()
            || look.has_fog()
            || look.contrast.is_some()
            || finish.glow != Rgb888::BLACK
            || finish.opacity < 255 =>
        {
            rich::<C>(look, shade, filter, piece, texture)
        }
        _ => bare::<C>(look, shade, piece),
    }
}

/// The shaders of the sea and of the island, the two pieces of the project's own scene, in color `C`.
///
/// # Errors
///
/// None: the scene's numbers are constant.
pub fn own<C: Shown>() -> Result<Vec<Surface<'static>>> {
    Ok(if lighthouse::is_mono::<C>() {
        vec![
            Surface::new(Surface::Many, lighthouse::crests::<C>(), C::into)?,
            Surface::new(Surface::Many, lighthouse::stretched::<C>()?, C::into)?,
        ]
    } else {
        vec![
            Surface::new(Surface::Many, lighthouse::waves::<C>(), C::into)?,
            Surface::new(Surface::Many, lighthouse::skin::<C>()?, C::into)?,
        ]
    })
}

/// The shader of a measured scene in color `C`. (Outside of the simulator, the scenes are measured in one color type
/// only.)
///
/// # Errors
///
/// None.
pub fn measured<C: Shown>(scene: SceneName) -> Result<Surface<'static>> {
    match scene {
        SceneName::Floor | SceneName::Cube => {
            let checker = Textured::new(&scenes::CHECKER).converted::<C>();
            Surface::new(Surface::Many, checker, C::into)
        }
        SceneName::Sphere => interpolated(Gouraud::<C>::new()),
        SceneName::SphereFlat => {
            let colors = FaceColors::new(&scenes::FACE_COLORS).converted::<C>();
            Surface::new(Surface::Many, colors, C::into)
        }
    }
}
