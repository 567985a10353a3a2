//! Draws a model in each look and each color.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray4, Gray8, PixelColor, Rgb565, Rgb888, RgbColor,
};
use embedded_graphics::primitives::{PointsIter, Rectangle};
use fixel::mode::Newton;
use fixel::prelude::*;
use fixel::shade::{DepthView, Flat, Fog, Gouraud, Levels, NormalView, Textured, Varyings};
use fixel::target::{Biased, DepthBuffer, Native, TestAndWrite};
use fixel::texture::Blend;
use fixel::view::Perspective;
use fixel::{Drawn, LineWidth, Mesh};

use super::Result;
use super::common::lighthouse;
use super::look::Look;
use super::mode::{Mode, in_mode};
use super::surface::{FaceValues, Surface};
use super::view::{Lens, View};
use crate::args::{Filter, Shade};
use crate::piece::{Finish, Piece};

/// The simulator's canvas.
pub type Board<'a, C, D> = Canvas<'a, C, Native, D>;

/// A canvas's color, and the texture's color for it.
pub trait Shown: Levels + Into<Rgb888> + Default + 'static {
    /// The color that a texture is stored in. For dithered colors it is a finer one, because the picture is to be
    /// dithered, not the texture.
    type Texel: Levels + Blend;

    /// The shader of a piece of a model with its `texture`; [`Shade::Wire`] has none, and draws nothing but edges.
    ///
    /// # Errors
    ///
    /// The fog ends before it begins, or the look needs more numbers than a shader can have.
    fn surface<'a>(
        look: &'a Look,
        view: &View,
        piece: &Piece<'_>,
        texture: Option<&'a Texture<'a, Self::Texel>>,
    ) -> Result<Surface<'a>>;
}

/// The error of a look with more numbers than the library interpolates: two for the texture, three each for the colors
/// of vertices and of the light, and one for fog.
const TOO_MANY: &str = "--fog with a colored --light: the model has a texture and colors of vertices, and all of them \
     are more than the eight numbers that a shader can interpolate: make the lights white, or leave out the fog";

macro_rules! shown {
    ($($color:ident $texel:ident |$shader:ident| $converted:expr;)+) => {$(
        impl Shown for $color {
            type Texel = $texel;

            fn surface<'a>(
                look: &'a Look,
                view: &View,
                piece: &Piece<'_>,
                texture: Option<&'a Texture<'a, $texel>>,
            ) -> Result<Surface<'a>> {
                fn wrapped<'a, S>($shader: S, fog: Option<Fog<$texel>>) -> Result<Surface<'a>>
                where
                    S: Shader<Color = $texel, Varyings: Varyings<Face: FaceValues>> + 'a,
                {
                    if let Some(fog) = fog {
                        let $shader = $shader.in_fog(fog);
                        return Surface::new($converted);
                    }
                    Surface::new($converted)
                }
                let fog = look.fog::<$texel>()?;
                let (is_colored, color) = (piece.mesh.has_colors(), piece.finish.color);
                /// Lights a shader in one of two ways.
                macro_rules! lit {
                    ($unlit:expr, $lit:ident, |$wrapped:ident| $result:expr) => {
                        if let Some(white) = look.white() {
                            let $wrapped = $unlit.$lit(white);
                            $result
                        } else {
                            let $wrapped = $unlit.$lit(look.colored());
                            $result
                        }
                    };
                }
                /// Takes light and fog, as the look wants them, to a surface of one color or of the vertices' colors.
                macro_rules! plain {
                    ($surface:expr, |$wrapped:ident| $result:expr) => {
                        match look.shade {
                            Shade::Texture => {
                                let $wrapped = $surface;
                                $result
                            }
                            Shade::Flat => lit!($surface, lit_faces, |$wrapped| $result),
                            _ => lit!($surface, lit, |$wrapped| $result),
                        }
                    };
                }
                /// The same for a texture.
                macro_rules! textured {
                    ($skin:expr) => {
                        match (look.shade, is_colored) {
                            (Shade::Texture, false) => wrapped($skin, fog),
                            (Shade::Texture, true) => wrapped($skin.tinted(), fog),
                            (_, false) => lit!($skin, lit, |lit| wrapped(lit, fog)),
                            (_, true) => match (look.white(), fog) {
                                (Some(white), _) => wrapped($skin.tinted().lit(white), fog),
                                (None, None) => {
                                    let $shader = $skin.tinted().lit(look.colored());
                                    Surface::new($converted)
                                }
                                (None, Some(_)) => Err(TOO_MANY.into()),
                            },
                        }
                    };
                }
                match (look.shade, texture) {
                    (Shade::Texture | Shade::Lit, Some(texture)) => {
                        let skin = Textured::new(texture);
                        match view.filter {
                            Filter::Nearest => textured!(skin),
                            Filter::Bilinear => textured!(skin.bilinear()),
                        }
                    }
                    (Shade::Texture | Shade::Lit | Shade::Gouraud | Shade::Flat, _) => {
                        match (is_colored, fog) {
                            // Without fog, a color is dithered once, from the exact color.
                            (false, None) => {
                                plain!(Flat::<$color>::rgb(color), |lit| Surface::new(lit))
                            }
                            (false, Some(_)) => {
                                plain!(Flat::<$texel>::rgb(color), |lit| wrapped(lit, fog))
                            }
                            (true, None) => {
                                plain!(Gouraud::<$color>::new(), |lit| Surface::new(lit))
                            }
                            (true, Some(_)) => {
                                plain!(Gouraud::<$texel>::new(), |lit| wrapped(lit, fog))
                            }
                        }
                    }
                    (Shade::Normal, _) => Surface::new(NormalView::<$color>::new()),
                    (Shade::Depth | Shade::Wire, _) => {
                        let [near, far] = view.depths;
                        // Keeps the farthest point visible on black.
                        let far = far.saturating_sub((near.saturating_sub(far)) / 6);
                        Surface::new(DepthView::<$color>::between(far, near))
                    }
                }
            }
        }
    )+};
}
shown! {
    Rgb565 Rgb565 |shader| shader;
    Rgb888 Rgb888 |shader| shader;
    Gray8 Gray8 |shader| shader;
    Gray4 Gray8 |shader| shader.converted::<Gray4>();
    BinaryColor Gray8 |shader| shader.converted::<BinaryColor>();
}

/// The shaders of the project's own scene in a color: of the sea and of the island.
///
/// # Errors
///
/// None: the scene's numbers are constant.
pub fn own_surfaces<C: Shown>() -> Result<[Surface<'static>; 2]> {
    if lighthouse::is_mono::<C>() {
        return Ok([
            Surface::new(lighthouse::crests::<C>())?,
            Surface::new(lighthouse::stretched::<C>()?)?,
        ]);
    }
    Ok([
        Surface::new(lighthouse::waves::<C>())?,
        Surface::new(lighthouse::skin::<C>()?)?,
    ])
}

/// Everything that a model's picture needs but the model.
pub struct Brush<'a> {
    pub look: &'a Look,
    /// For each piece of the model.
    surfaces: Vec<Surface<'a>>,
    /// The color of lines.
    line: Rgb888,
    /// Lines' width in pixels.
    width: LineWidth,
    /// The color of the canvas at a pixel, for a background.
    background: fn(Rgb888, Point) -> Rgb888,
    backdrop: Rgb888,
}

impl<'a> Brush<'a> {
    /// Makes a brush for a canvas of color `C`: for `pieces` with what they have of `textures`, and for lines of
    /// `width` pixels.
    ///
    /// # Errors
    ///
    /// The fog ends before it begins, or the look needs more numbers than a shader can have.
    pub fn new<C: Shown>(
        look: &'a Look,
        view: &View,
        pieces: &[Piece<'_>],
        textures: &'a [Texture<'a, C::Texel>],
        width: u32,
    ) -> Result<Self> {
        let surface = |piece: &Piece<'_>| {
            let texture = piece.finish.texture.and_then(|at| textures.get(at));
            C::surface(look, view, piece, texture)
        };
        Ok(Self {
            look,
            surfaces: pieces.iter().map(surface).collect::<Result<_>>()?,
            line: look.line::<C>(),
            width: LineWidth::new(Scalar::from_num(width))?,
            background: |color, at| C::from_rgb(color, at).into(),
            backdrop: look.backdrop::<C>(),
        })
    }

    /// Fills the canvas, whose top left corner is the picture's point `origin`.
    pub fn clear<D: DepthBuffer>(&self, canvas: &mut Board<'_, Rgb888, D>, origin: Point) {
        canvas.clear(Rgb888::default());
        let rows = canvas.rows().clone();
        let corner = Point::new(0, rows.start.cast_signed());
        let area = Rectangle::new(
            corner,
            Size::new(canvas.frame_size().width, rows.end - rows.start),
        );
        let colors = area
            .points()
            .map(|at| (self.background)(self.backdrop, at + origin));
        let Ok(()) = canvas.fill_contiguous(&area, colors);
    }
}

/// Pieces of a model, their view and their pose.
#[derive(Clone, Copy)]
pub struct Posed<'a> {
    pub pieces: &'a [Piece<'a>],
    pub view: &'a View,
    pub pose: Transform,
    /// The whole picture, as seen from a canvas that is a part of it.
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
                Lens::Perspective(projection) => {
                    let $mvp = &(projection * *camera * $posed.pose);
                    $draw
                }
                Lens::Parallel(projection) => {
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
        Surface::Most(shader) => draw_in(canvas, mode, options, mesh, mvp, &shader),
    }
}

impl Posed<'_> {
    fn options(&self) -> DrawOptions {
        match self.viewport {
            Some(viewport) => self.view.options.with_viewport(viewport),
            None => self.view.options,
        }
    }

    /// Draws the triangles; `behind` the edges that are drawn over them.
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

    /// Draws the edges, in lines of a pixel.
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
        brush: &Brush<'_>,
    ) -> Drawn {
        let options = &self.options();
        let shader = &Flat::new(brush.line);
        if brush.width.pixels() == fx!(1) {
            return self.draw_edges(canvas, shader);
        }
        let options = &options.with_line(brush.width);
        each!(self, |mesh, mvp| {
            canvas.draw_edges(options, mesh, mvp, shader)
        })
    }

    /// Draws an outline in white.
    pub fn draw_outline<D: DepthBuffer>(
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

    /// Draws with `brush`.
    pub fn paint<D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, Rgb888, D>,
        brush: &Brush<'_>,
    ) -> Drawn {
        if brush.look.shade == Shade::Wire {
            return self.draw_lines(canvas, brush);
        }
        let wire = brush.look.wire;
        let drawn = self.draw_surfaces(canvas, &brush.surfaces, wire);
        if wire {
            self.draw_lines(canvas, brush);
        }
        drawn
    }

    /// Draws the triangles of each piece with its surface; `behind` the edges that are drawn over them.
    pub fn draw_surfaces<D: DepthBuffer>(
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
            Surface::Most(shader) => self.draw(canvas, &shader, behind),
        }
    }
}

/// Both together.
pub fn add(a: Drawn, b: Drawn) -> Drawn {
    let mut sum = a;
    sum.submitted += b.submitted;
    sum.drawn += b.drawn;
    sum.clipped += b.clipped;
    sum
}
