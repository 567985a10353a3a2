//! Draws a model in each look and each color.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, PixelColor, Rgb565, Rgb888};
use fixel::prelude::*;
use fixel::shade::{DepthView, Flat, Gouraud, Levels, NormalView, Textured};
use fixel::target::{DepthBuffer, Native};
use fixel::texture::Blend;
use fixel::{Drawn, Mesh};

use super::mode::{Mode, in_mode};
use super::view::{Lens, View};
use crate::args::{Filter, Shade};
use crate::piece::Piece;

/// The simulator's canvas.
pub type Board<'a, C, D> = Canvas<'a, C, Native, D>;

/// A canvas's color, and the texture's color for it.
pub trait Shown: Levels + Into<Rgb888> + Default {
    /// The color that a texture is stored in. For dithered colors it is a finer one, because the picture is to be
    /// dithered, not the texture.
    type Texel: Levels + Blend;

    /// The shader, converted to the canvas's color.
    fn shown<F: Shader<Color = Self::Texel>>(shader: F) -> impl Shader<Color = Self>;
}

macro_rules! shown {
    ($($color:ident $texel:ident |$shader:ident| $converted:expr;)+) => {$(
        impl Shown for $color {
            type Texel = $texel;

            fn shown<F: Shader<Color = $texel>>(
                $shader: F,
            ) -> impl Shader<Color = Self> {
                $converted
            }
        }
    )+};
}
shown! {
    Rgb565 Rgb565 |shader| shader;
    Rgb888 Rgb888 |shader| shader;
    Gray8 Gray8 |shader| shader;
    Gray4 Gray8 |shader| shader.converted();
    BinaryColor Gray8 |shader| shader.converted();
}

/// Pieces of a model, their view and their pose.
#[derive(Clone, Copy)]
pub struct Posed<'a> {
    pub pieces: &'a [Piece<'a>],
    pub view: &'a View,
    pub pose: Transform,
}

impl Posed<'_> {
    fn each(&self, mut draw: impl FnMut(&Mesh<'_>) -> Drawn) -> Drawn {
        self.pieces
            .iter()
            .map(|piece| draw(&piece.mesh))
            .fold(Drawn::default(), add)
    }

    /// Draws the triangles.
    pub fn draw<F: Shader<Color: PixelColor>, D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, F::Color, D>,
        shader: &F,
    ) -> Drawn {
        let View {
            projection,
            camera,
            options,
            mode,
            ..
        } = self.view;
        self.each(|mesh| match *projection {
            Lens::Perspective(projection) => in_mode!(*mode, options, |options| {
                canvas.draw_with(options, mesh, &(projection * *camera * self.pose), shader)
            }),
            Lens::Parallel(projection) => {
                canvas.draw_with(options, mesh, &(projection * *camera * self.pose), shader)
            }
        })
    }

    /// Draws the edges.
    pub fn draw_edges<F: Shader<Color: PixelColor>, D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, F::Color, D>,
        shader: &F,
    ) -> Drawn {
        let View {
            projection,
            camera,
            options,
            ..
        } = self.view;
        self.each(|mesh| match *projection {
            Lens::Perspective(projection) => {
                canvas.draw_edges(options, mesh, &(projection * *camera * self.pose), shader)
            }
            Lens::Parallel(projection) => {
                canvas.draw_edges(options, mesh, &(projection * *camera * self.pose), shader)
            }
        })
    }

    /// Draws with the texture, lit or not.
    fn textured<C: Shown, D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, C, D>,
        texture: &Texture<'_, C::Texel>,
        lit: bool,
    ) -> Drawn {
        let (skin, light) = (Textured::new(texture), self.view.light());
        match (self.view.filter, lit) {
            (Filter::Nearest, false) => self.draw(canvas, &C::shown(skin)),
            (Filter::Nearest, true) => self.draw(canvas, &C::shown(skin.lit(light))),
            (Filter::Bilinear, false) => self.draw(canvas, &C::shown(skin.bilinear())),
            (Filter::Bilinear, true) => self.draw(canvas, &C::shown(skin.bilinear().lit(light))),
        }
    }

    /// Draws with the texture times the colors of the vertices, lit or not.
    fn tinted<C: Shown, D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, C, D>,
        texture: &Texture<'_, C::Texel>,
        lit: bool,
    ) -> Drawn {
        let (skin, light) = (Textured::new(texture), self.view.light());
        match (self.view.filter, lit) {
            (Filter::Nearest, false) => self.draw(canvas, &C::shown(skin.tinted())),
            (Filter::Nearest, true) => self.draw(canvas, &C::shown(skin.tinted().lit(light))),
            (Filter::Bilinear, false) => self.draw(canvas, &C::shown(skin.bilinear().tinted())),
            (Filter::Bilinear, true) => {
                self.draw(canvas, &C::shown(skin.bilinear().tinted().lit(light)))
            }
        }
    }

    /// Draws in the look of `shade`, each piece with what it has of `textures`.
    pub fn paint<C: Shown, D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, C, D>,
        shade: Shade,
        textures: &[Texture<'_, C::Texel>],
    ) -> Drawn {
        let one = |piece| {
            let one = Self {
                pieces: std::slice::from_ref(piece),
                ..*self
            };
            let texture = piece.finish.texture.and_then(|at| textures.get(at));
            one.paint_piece(canvas, shade, piece, texture)
        };
        self.pieces.iter().map(one).fold(Drawn::default(), add)
    }

    fn paint_piece<C: Shown, D: DepthBuffer>(
        &self,
        canvas: &mut Board<'_, C, D>,
        shade: Shade,
        piece: &Piece<'_>,
        texture: Option<&Texture<'_, C::Texel>>,
    ) -> Drawn {
        let light = self.view.light();
        let color = Flat::<C>::rgb(piece.finish.color);
        let is_colored = piece.mesh.has_colors();
        match (shade, texture) {
            (Shade::Texture | Shade::Lit, Some(texture)) => {
                let lit = shade == Shade::Lit;
                if is_colored {
                    self.tinted(canvas, texture, lit)
                } else {
                    self.textured(canvas, texture, lit)
                }
            }
            (Shade::Texture, None) if is_colored => self.draw(canvas, &Gouraud::new()),
            (Shade::Texture, None) => self.draw(canvas, &color),
            (Shade::Lit | Shade::Gouraud, _) if is_colored => {
                self.draw(canvas, &Gouraud::new().lit(light))
            }
            (Shade::Lit | Shade::Gouraud, _) => self.draw(canvas, &color.lit(light)),
            (Shade::Flat, _) if is_colored => self.draw(canvas, &Gouraud::new().lit_faces(light)),
            (Shade::Flat, _) => self.draw(canvas, &color.lit_faces(light)),
            (Shade::Normal, _) => self.draw(canvas, &NormalView::new()),
            (Shade::Depth, _) => {
                let [near, far] = self.view.depths;
                // Keeps the farthest point visible on black.
                let far = far.saturating_sub((near.saturating_sub(far)) / 6);
                self.draw(canvas, &DepthView::between(far, near))
            }
            (Shade::Wire, _) => {
                let white = C::from_rgb(Rgb888::new(255, 255, 255), Point::zero());
                self.draw_edges(canvas, &Flat::new(white))
            }
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
