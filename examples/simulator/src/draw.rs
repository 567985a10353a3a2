//! Draws a model in any look and any color format.

use embedded_graphics::draw_target::{DrawTarget, DrawTargetExt};
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray4, Gray8, PixelColor, Rgb565, Rgb888, RgbColor,
};
use embedded_graphics::primitives::{PointsIter, Rectangle};
use fixel::mode::Newton;
use fixel::prelude::*;
use fixel::shade::{DepthView, Flat, Gouraud, Levels, NormalView, Textured, Varyings};
use fixel::target::{Biased, DepthBuffer, Native, TestAndWrite};
use fixel::texture::Blend;
use fixel::view::Perspective;
use fixel::{Drawn, LineWidth, Mesh};

use super::Result;
use super::common::lighthouse;
use super::look::Look;
use super::mode::{Mode, in_mode};
use super::surface::{FaceValues, Show, Surface};
use super::tinted::TintedLit;
use super::view::{AnyProjection, View};
use crate::args::{Filter, Shade};
use crate::piece::{Finish, Piece};

/// The simulator's canvas.
pub type Board<'a, C, D> = Canvas<'a, C, Native, D>;

/// A color that textures are stored in.
pub trait Stored: Levels + Blend + Into<Rgb888> + 'static {
    /// The shader of a piece with a texture, or of a piece in fog. It computes in this color, and the result is then
    /// `shown`.
    ///
    /// # Errors
    ///
    /// The fog ends before it begins.
    fn surface<'a>(
        look: &'a Look,
        filter: Filter,
        piece: &Piece<'_>,
        texture: Option<&'a Texture<'a, Self>>,
        shown: Show<Self>,
    ) -> Result<Surface<'a>>;
}

/// A canvas's color, and the texture's color for it.
pub trait Shown:
    Levels<Channels: Varyings<Face: FaceValues>> + Into<Rgb888> + Default + 'static
{
    /// The color that a texture is stored in. For dithered formats it is a finer color, because the picture must be
    /// dithered, not the texture.
    type Texel: Stored;

    /// Shows a texture's color at a pixel.
    fn shown(texel: Self::Texel, at: Point) -> Rgb888;

    /// The shader of a piece without texture or fog. Each color is dithered once, from the exact color.
    ///
    /// # Errors
    ///
    /// None.
    fn bare<'a>(look: &'a Look, piece: &Piece<'_>) -> Result<Surface<'a>>;

    /// The shader of the vertices' colors, without light.
    ///
    /// # Errors
    ///
    /// None.
    fn vertex_colors() -> Result<Surface<'static>>;
}

/// Lights `$unlit` as `$look` says. The lit shader is `$lit`; its layout is the first one under white light, and the
/// second one under colored lights.
macro_rules! lit {
    ($look:expr, $unlit:expr, $method:ident, [$white:expr, $colored:expr],
     |$lit:ident, $layout:ident| $result:expr) => {
        if let Some(white) = $look.white() {
            let $layout = $white;
            let $lit = $unlit.$method(white);
            $result
        } else {
            let $layout = $colored;
            let $lit = $unlit.$method($look.colored());
            $result
        }
    };
}

/// Lights a surface of one color, or of the vertices' colors, as the look says.
macro_rules! plain {
    ($look:expr, $surface:expr, [$unlit:expr, $white:expr, $colored:expr],
     |$wrapped:ident, $layout:ident| $result:expr) => {
        match $look.shade {
            Some(Shade::Texture) => {
                let $layout = $unlit;
                let $wrapped = $surface;
                $result
            }
            Some(Shade::Flat) => {
                lit!(
                    $look,
                    $surface,
                    lit_faces,
                    [$white, $colored],
                    |$wrapped, $layout| $result
                )
            }
            _ => lit!(
                $look,
                $surface,
                lit,
                [$white, $colored],
                |$wrapped, $layout| $result
            ),
        }
    };
}

macro_rules! stored {
    ($($texel:ident)+) => {$(
        impl Stored for $texel {
            fn surface<'a>(
                look: &'a Look,
                filter: Filter,
                piece: &Piece<'_>,
                texture: Option<&'a Texture<'a, Self>>,
                shown: Show<Self>,
            ) -> Result<Surface<'a>> {
                let fog = look.fog::<Self>()?;
                /// Wraps a shader with fog, if there is any. The given layout is the one without fog.
                macro_rules! wrapped {
                    ($shader:expr, $layout:expr) => {
                        match fog {
                            Some(fog) => Surface::new(Surface::Many, $shader.in_fog(fog), shown),
                            None => Surface::new($layout, $shader, shown),
                        }
                    };
                }
                macro_rules! textured {
                    ($skin:expr) => {
                        match (look.shade, piece.mesh.has_colors()) {
                            (Some(Shade::Texture), false) => wrapped!($skin, Surface::Few),
                            (Some(Shade::Texture), true) => wrapped!($skin.tinted(), Surface::Many),
                            (_, false) => lit!(look, $skin, lit, [Surface::Few, Surface::Many], |lit, layout| {
                                wrapped!(lit, layout)
                            }),
                            (_, true) => match look.white() {
                                Some(white) => wrapped!($skin.tinted().lit(white), Surface::Many),
                                None => {
                                    let (surface, light) = ($skin, look.colored());
                                    wrapped!(TintedLit { surface, light }, Surface::Many)
                                }
                            },
                        }
                    };
                }
                let skin = texture.map(Textured::new);
                match (skin, filter, fog) {
                    (Some(skin), Filter::Nearest, _) => textured!(skin),
                    (Some(skin), Filter::Bilinear, _) => textured!(skin.bilinear()),
                    (None, _, fog) => {
                        let fog = fog.ok_or("without texture and fog, colors are not stored")?;
                        if piece.mesh.has_colors() {
                            plain!(
                                look, Gouraud::<Self>::new(),
                                [Surface::Channels, Surface::Channels, Surface::Channels],
                                |lit, layout| Surface::new(layout, lit.in_fog(fog), shown)
                            )
                        } else {
                            plain!(
                                look, Flat::<Self>::rgb(piece.finish.color),
                                [Surface::Many, Surface::Many, Surface::Many],
                                |lit, layout| Surface::new(layout, lit.in_fog(fog), shown)
                            )
                        }
                    }
                }
            }
        }
    )+};
}
stored!(Rgb565 Rgb888 Gray8);

macro_rules! shown {
    ($($color:ident $texel:ident $corners:ident |$from:ident, $at:ident| $converted:expr;)+) => {$(
        impl Shown for $color {
            type Texel = $texel;

            fn shown($from: $texel, $at: Point) -> Rgb888 {
                $converted.into()
            }

            fn vertex_colors() -> Result<Surface<'static>> {
                Surface::new(Surface::$corners, Gouraud::<Self>::new(), screen)
            }

            fn bare<'a>(look: &'a Look, piece: &Piece<'_>) -> Result<Surface<'a>> {
                if piece.mesh.has_colors() {
                    plain!(
                        look, Gouraud::<Self>::new(), [Surface::$corners, Surface::Channels, Surface::Channels],
                        |lit, layout| Surface::new(layout, lit, screen)
                    )
                } else {
                    plain!(
                        look, Flat::<Self>::rgb(piece.finish.color), [Surface::Few, Surface::Few, Surface::Many],
                        |lit, layout| Surface::new(layout, lit, screen)
                    )
                }
            }
        }
    )+};
}
shown! {
    Rgb565 Rgb565 Pairs |color, _at| color;
    Rgb888 Rgb888 Channels |color, _at| color;
    Gray8 Gray8 Channels |color, _at| color;
    Gray4 Gray8 Channels |color, at| Gray4::from_rgb(color.into(), at);
    BinaryColor Gray8 Channels |color, at| BinaryColor::from_rgb(color.into(), at);
}

/// Converts a color of the canvas to the color that a computer's screen shows.
pub fn screen<C: Into<Rgb888>>(color: C, _: Point) -> Rgb888 {
    color.into()
}

/// The shader of a piece of a model with its `texture`; [`Shade::Wire`] has none, and draws nothing but edges.
///
/// # Errors
///
/// The fog ends before it begins.
fn surface<'a, C: Shown>(
    look: &'a Look,
    view: &View,
    piece: &Piece<'_>,
    texture: Option<&'a Texture<'a, C::Texel>>,
) -> Result<Surface<'a>> {
    match (look.shade, texture) {
        (Some(Shade::Normal), _) => Surface::new(Surface::Channels, NormalView::<C>::new(), screen),
        (Some(Shade::Depth | Shade::Wire), _) => {
            let [near, far] = view.depths;
            // The farthest point must remain visible on black.
            let far = far.saturating_sub((near.saturating_sub(far)) / 6);
            Surface::new(Surface::Few, DepthView::<C>::between(far, near), screen)
        }
        (Some(Shade::Texture | Shade::Lit), Some(_)) => {
            C::Texel::surface(look, view.filter, piece, texture, C::shown)
        }
        _ if look.has_fog() => C::Texel::surface(look, view.filter, piece, None, C::shown),
        _ => C::bare(look, piece),
    }
}

/// The shaders of the project's own scene in a color type: the sea's and the island's.
///
/// # Errors
///
/// None: the scene's numbers are constant.
fn own_surfaces<C: Shown>() -> Result<Vec<Surface<'static>>> {
    Ok(if lighthouse::is_mono::<C>() {
        vec![
            Surface::new(Surface::Few, lighthouse::crests::<C>(), screen)?,
            Surface::new(Surface::Few, lighthouse::stretched::<C>()?, screen)?,
        ]
    } else {
        vec![
            Surface::new(Surface::Few, lighthouse::waves::<C>(), screen)?,
            Surface::new(Surface::Few, lighthouse::skin::<C>()?, screen)?,
        ]
    })
}

/// The background of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backdrop {
    /// One color. It is converted to the color type of the canvas.
    Color(Rgb888),
    /// The sky of the project's own scene.
    Sky,
}

/// How a picture is drawn: everything that it needs besides the model.
pub struct Style<'a> {
    /// A shader for each piece of the model.
    surfaces: Vec<Surface<'a>>,
    /// The color of lines.
    line: Rgb888,
    /// The width of lines in pixels.
    width: LineWidth,
    /// Whether only edges are drawn.
    only_edges: bool,
    /// Whether edges are drawn over the surface.
    wire: bool,
    backdrop: Backdrop,
    /// The color of the canvas at a pixel.
    color: Show<Rgb888>,
    /// Whether the project's name is written into the picture, and if so, whether it is on black.
    caption: Option<bool>,
    /// Whether white silhouettes are drawn around the project's own island.
    silhouettes: bool,
}

impl<'a> Style<'a> {
    /// Makes the style for a canvas of color `C`, for `pieces` with their `textures`, and for lines of `width` pixels.
    ///
    /// # Errors
    ///
    /// The fog ends before it begins.
    pub fn new<C: Shown>(
        look: &'a Look,
        view: &View,
        pieces: &[Piece<'_>],
        textures: &'a [Texture<'a, C::Texel>],
        width: u32,
    ) -> Result<Self> {
        let surface = |piece: &Piece<'_>| {
            let texture = piece.finish.texture.and_then(|at| textures.get(at));
            surface::<C>(look, view, piece, texture)
        };
        let is_mono = lighthouse::is_mono::<C>();
        Ok(Self {
            surfaces: match look.shade {
                Some(_) => pieces.iter().map(surface).collect::<Result<_>>()?,
                None => own_surfaces::<C>()?,
            },
            line: look.line::<C>(),
            width: LineWidth::new(Scalar::from_num(width))?,
            only_edges: look.shade == Some(Shade::Wire),
            wire: look.wire,
            backdrop: look.backdrop,
            color: |color, at| C::from_rgb(color, at).into(),
            // Averaging would make the caption unreadable.
            caption: (look.is_scene && width == 1).then_some(is_mono),
            silhouettes: look.shade.is_none() && is_mono,
        })
    }

    /// Fills the canvas, which is a part of a picture of this height; `origin` is its position in the picture.
    pub fn clear<D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, Rgb888, D>,
        origin: Point,
        height: u32,
    ) {
        canvas.clear(Rgb888::default());
        let rows = canvas.rows().clone();
        let corner = Point::new(0, rows.start.cast_signed());
        let area = Rectangle::new(
            corner,
            Size::new(canvas.frame_size().width, rows.end - rows.start),
        );
        let colors = area.points().map(|at| {
            let at = at + origin;
            let color = match self.backdrop {
                Backdrop::Color(color) => color,
                Backdrop::Sky => lighthouse::sky_color(at.y.cast_unsigned(), height),
            };
            (self.color)(color, at)
        });
        let Ok(()) = canvas.fill_contiguous(&area, colors);
    }

    /// Writes the caption, if there is one, into a picture of this size; `origin` as for [`clear`](Self::clear).
    pub fn write<D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, Rgb888, D>,
        origin: Point,
        size: Size,
    ) {
        if let Some(on_black) = self.caption {
            lighthouse::caption_on(&mut canvas.translated(-origin), size, on_black);
        }
    }
}

/// Pieces of a model, their view and their pose.
#[derive(Clone, Copy)]
pub struct Posed<'a> {
    pub pieces: &'a [Piece<'a>],
    pub view: &'a View,
    pub pose: Transform,
    /// The viewport of the whole picture, if the canvas is only a part of it.
    pub viewport: Option<Viewport>,
}

/// Draws each mesh, in perspective or in parallel projection.
macro_rules! each {
    ($posed:expr, |$mesh:ident, $mvp:ident| $draw:block else $parallel:block) => {{
        let View {
            projection, camera, ..
        } = $posed.view;
        let mut sum = Drawn::default();
        for Piece { mesh: $mesh, .. } in $posed.pieces {
            let drawn = match *projection {
                AnyProjection::Perspective(projection) => {
                    let $mvp = &(projection * *camera * $posed.pose);
                    $draw
                }
                AnyProjection::Parallel(projection) => {
                    let $mvp = &(projection * *camera * $posed.pose);
                    $parallel
                }
            };
            sum = add(sum, drawn);
        }
        sum
    }};
    ($posed:expr, |$mesh:ident, $mvp:ident| $draw:block) => {
        each!($posed, |$mesh, $mvp| $draw else $draw)
    };
}

/// Draws a mesh in perspective, in one of the modes.
fn draw_in<S: Shader<Color: PixelColor>, D: DepthBuffer>(
    canvas: &mut Board<'_, S::Color, D>,
    mode: Mode,
    options: &DrawOptions<Newton, Biased>,
    mesh: &Mesh<'_>,
    mvp: &Mvp<Perspective>,
    shader: &S,
) -> Drawn {
    in_mode!(mode, options, |options| canvas
        .draw_with(options, mesh, mvp, shader))
}

/// Draws a mesh in perspective with any shader.
pub fn draw_surface_in<D: DepthBuffer>(
    canvas: &mut Board<'_, Rgb888, D>,
    mode: Mode,
    mesh: &Mesh<'_>,
    mvp: &Mvp<Perspective>,
    surface: &Surface<'_>,
) -> Drawn {
    let options = &DrawOptions::new().with_depth(Biased::new(TestAndWrite, 0, fx!(0)));
    match surface {
        Surface::Few(shader) => draw_in(canvas, mode, options, mesh, mvp, &shader),
        Surface::Many(shader) => draw_in(canvas, mode, options, mesh, mvp, &shader),
        Surface::Channels(shader) => draw_in(canvas, mode, options, mesh, mvp, &shader),
        Surface::Pairs(shader) => draw_in(canvas, mode, options, mesh, mvp, &shader),
    }
}

impl Posed<'_> {
    fn options(&self) -> DrawOptions {
        match self.viewport {
            Some(viewport) => self.view.options.with_viewport(viewport),
            None => self.view.options,
        }
    }

    /// Draws the triangles. `behind` moves them behind the edges that are drawn over them.
    pub fn draw<S: Shader<Color: PixelColor>, D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, S::Color, D>,
        shader: &S,
        behind: bool,
    ) -> Drawn {
        let depth = if behind {
            Biased::behind(TestAndWrite)
        } else {
            Biased::new(TestAndWrite, 0, fx!(0))
        };
        let options = &self.options().with_depth(depth);
        each!(self, |mesh, mvp| { draw_in(canvas, self.view.mode, options, mesh, mvp, shader) }
            else { canvas.draw_with(options, mesh, mvp, shader) })
    }

    /// Draws the edges as lines one pixel wide.
    pub fn draw_edges<S: Shader<Color: PixelColor>, D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, S::Color, D>,
        shader: &S,
    ) -> Drawn {
        let options = &self.options();
        each!(self, |mesh, mvp| {
            canvas.draw_edges(options, mesh, mvp, shader)
        })
    }

    /// Draws the edges.
    fn draw_lines<D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, Rgb888, D>,
        style: &Style<'_>,
    ) -> Drawn {
        let options = &self.options();
        let shader = &Flat::new(style.line);
        if style.width.pixels() == fx!(1) {
            return self.draw_edges(canvas, shader);
        }
        let options = &options.with_line(style.width);
        each!(self, |mesh, mvp| {
            canvas.draw_edges(options, mesh, mvp, shader)
        })
    }

    /// Draws an outline in white.
    fn draw_outline<D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, Rgb888, D>,
        mesh: &'static Mesh<'static>,
        outline: &Outline<'_>,
    ) {
        let piece = Piece {
            mesh: *mesh,
            finish: Finish::textured(0),
        };
        let posed = Posed {
            pieces: std::slice::from_ref(&piece),
            ..*self
        };
        let (options, white) = (&posed.options(), &Flat::new(Rgb888::WHITE));
        each!(posed, |mesh, mvp| {
            canvas.draw_outline(options, mesh, outline, mvp, white)
        });
    }

    /// Draws the surfaces, the lines and the outline of `style`.
    pub fn draw_in_style<D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, Rgb888, D>,
        style: &Style<'_>,
    ) -> Drawn {
        if style.only_edges {
            return self.draw_lines(canvas, style);
        }
        let drawn = self.draw_surfaces(canvas, &style.surfaces, style.wire);
        if style.wire {
            self.draw_lines(canvas, style);
        }
        if style.silhouettes {
            self.draw_outline(canvas, &lighthouse::ISLAND, &lighthouse::SILHOUETTES);
        }
        drawn
    }

    /// Draws the triangles of each piece with its surface. `behind` moves them behind the edges that are drawn over
    /// them.
    fn draw_surfaces<D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, Rgb888, D>,
        surfaces: &[Surface<'_>],
        behind: bool,
    ) -> Drawn {
        let one = |(piece, surface)| {
            let posed = Posed {
                pieces: std::slice::from_ref(piece),
                ..*self
            };
            posed.draw_surface(canvas, surface, behind)
        };
        (self.pieces.iter().zip(surfaces).map(one)).fold(Drawn::default(), add)
    }

    fn draw_surface<D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, Rgb888, D>,
        surface: &Surface<'_>,
        behind: bool,
    ) -> Drawn {
        match surface {
            Surface::Few(shader) => self.draw(canvas, &shader, behind),
            Surface::Many(shader) => self.draw(canvas, &shader, behind),
            Surface::Channels(shader) => self.draw(canvas, &shader, behind),
            Surface::Pairs(shader) => self.draw(canvas, &shader, behind),
        }
    }
}

/// The sum of two counts.
pub fn add(a: Drawn, b: Drawn) -> Drawn {
    let mut sum = a;
    sum.submitted += b.submitted;
    sum.drawn += b.drawn;
    sum.clipped += b.clipped;
    sum
}
