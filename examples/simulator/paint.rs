//! A model in each look and each colour.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888};
use fixel::prelude::*;
use fixel::shade::{Channels, Levels};
use fixel::shade::{Converted, DepthView, Flat, Lit, LitFaces, NormalView, Textured};
use fixel::target::{Depth, Native};
use fixel::{Drawn, Mesh};

use super::view::{Lens, View};
use crate::args::Shade;
use crate::skin::Texels;

/// A canvas as the simulator has it.
pub type Board<'a, C> = Canvas<'a, C, Native, Depth<'a>>;

/// A canvas's colour, and how it takes a texture.
pub trait Shown: Levels + Into<Rgb888> + Default {
    /// The colour that a texture is kept in: for dithered colours a finer one, as it is the
    /// picture that is to be dithered and not the texture.
    type Texel: Levels;

    /// Draws with the texture as it is, or lit.
    fn textured(
        canvas: &mut Board<'_, Self>,
        model: &Posed<'_>,
        texels: &Texels<Self::Texel>,
        lit: bool,
    ) -> Drawn;
}

macro_rules! shown {
    ($($color:ident $texel:ident |$fragment:ident| $converted:expr;)+) => {$(
        impl Shown for $color {
            type Texel = $texel;

            fn textured(
                canvas: &mut Board<'_, Self>,
                model: &Posed<'_>,
                texels: &Texels<$texel>,
                lit: bool,
            ) -> Drawn {
                if lit {
                    let $fragment = Textured::new(texels).lit(model.view.light);
                    model.draw(canvas, &$converted)
                } else {
                    let $fragment = Textured::new(texels);
                    model.draw(canvas, &$converted)
                }
            }
        }
    )+};
}
shown! {
    Rgb565 Rgb565 |fragment| fragment;
    Rgb888 Rgb888 |fragment| fragment;
    Gray8 Gray8 |fragment| fragment;
    Gray4 Gray8 |fragment| Converted::<_, Gray4>::new(fragment);
    BinaryColor Gray8 |fragment| Converted::<_, BinaryColor>::new(fragment);
}

/// Meshes, how they are seen and in which pose.
#[derive(Clone, Copy)]
pub struct Posed<'a> {
    pub meshes: &'a [Mesh<'a>],
    pub view: &'a View,
    pub pose: Transform,
}

impl Posed<'_> {
    fn each(&self, mut draw: impl FnMut(&Mesh<'_>) -> Drawn) -> Drawn {
        self.meshes
            .iter()
            .map(&mut draw)
            .fold(Drawn::default(), add)
    }

    /// Draws the triangles.
    pub fn draw<F: Fragment<N>, const N: usize>(
        &self,
        canvas: &mut Board<'_, F::Color>,
        fragment: &F,
    ) -> Drawn {
        let View {
            lens, camera, pass, ..
        } = self.view;
        self.each(|mesh| match *lens {
            Lens::Perspective(lens) => {
                canvas.draw_with(pass, mesh, &(lens * *camera * self.pose), fragment)
            }
            Lens::Parallel(lens) => {
                canvas.draw_with(pass, mesh, &(lens * *camera * self.pose), fragment)
            }
        })
    }

    /// Draws the edges.
    pub fn draw_edges<F: Fragment<N>, const N: usize>(
        &self,
        canvas: &mut Board<'_, F::Color>,
        fragment: &F,
    ) -> Drawn {
        let View {
            lens, camera, pass, ..
        } = self.view;
        self.each(|mesh| match *lens {
            Lens::Perspective(lens) => {
                canvas.draw_edges(pass, mesh, &(lens * *camera * self.pose), fragment)
            }
            Lens::Parallel(lens) => {
                canvas.draw_edges(pass, mesh, &(lens * *camera * self.pose), fragment)
            }
        })
    }

    /// Draws in the look of `shade`.
    pub fn paint<C: Shown + Channels<K>, const K: usize>(
        &self,
        canvas: &mut Board<'_, C>,
        shade: Shade,
        texels: &Texels<C::Texel>,
    ) -> Drawn {
        const CLAY: Rgb888 = Rgb888::new(236, 214, 190);
        let light = self.view.light;
        match shade {
            Shade::Texture => C::textured(canvas, self, texels, false),
            Shade::Lit => C::textured(canvas, self, texels, true),
            Shade::Gouraud => self.draw(canvas, &Lit::new(CLAY, light)),
            Shade::Flat => self.draw(canvas, &LitFaces::new(CLAY, light)),
            Shade::Normal => self.draw(canvas, &NormalView::new()),
            Shade::Depth => {
                let [near, far] = self.view.depths;
                // The farthest point stays visible on black.
                let far = far.saturating_sub((near.saturating_sub(far)) / 6);
                self.draw(canvas, &DepthView::between(far, near))
            }
            Shade::Wire => {
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
