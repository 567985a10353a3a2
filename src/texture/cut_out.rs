//! Textures with holes in place of the texels of one color.

use super::{Blend, Sampler, blend};

/// A texture in which the texels of one color are holes; see [`Textured::cut_out`](crate::Textured::cut_out).
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CutOut<S, C> {
    pub(crate) texture: S,
    pub(crate) key: C,
}

/// A texel, or a hole.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct OrHole<C>(pub(crate) Option<C>);

impl<S: Sampler<Color = C>, C: Copy + PartialEq> Sampler for CutOut<S, C> {
    type Color = OrHole<C>;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        self.texture.size_log2()
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> OrHole<C> {
        self.texel_at(0, u, v)
    }

    #[inline]
    fn texel_at(&self, level: u32, u: i32, v: i32) -> OrHole<C> {
        let texel = self.texture.texel_at(level, u, v);
        OrHole((texel != self.key).then_some(texel))
    }
}

/// The nearest texel decides whether there is a hole. Where there is no hole, the nearest texel's color also replaces
/// the holes around it.
impl<C: Blend> Blend for OrHole<C> {
    const WEIGHT_BITS: u32 = C::WEIGHT_BITS;

    #[inline]
    fn blend(texels: [[Self; 2]; 2], weights: [u32; 2]) -> Self {
        let filled = |nearest| blend::each(texels, |OrHole(texel): Self| texel.unwrap_or(nearest));
        let OrHole(nearest) = blend::nearest(texels, weights);
        OrHole(nearest.map(|nearest| C::blend(filled(nearest), weights)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::filter::around;
    use super::super::{Bilinear, Filter, Nearest};
    use super::*;
    use crate::random::cases;
    use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
    use rand::Rng;

    const KEY: Rgb888 = Rgb888::MAGENTA;

    /// Gray texels. If bit i of `holes` is set, texel i is a hole.
    fn skin(grays: [u8; 16], holes: u16) -> [[Rgb888; 4]; 4] {
        let texel = |i: usize| match holes >> i & 1 {
            1 => KEY,
            _ => Rgb888::new(grays[i], grays[i], grays[i]),
        };
        core::array::from_fn(|row| core::array::from_fn(|column| texel(4 * row + column)))
    }

    /// A blend that contained the key's color would not be gray. Where none of the four texels is a hole, the color is
    /// the same as without holes.
    #[test]
    fn holes_are_the_key_s_and_leave_no_fringe() {
        cases(256, |random| {
            let grays = random.random::<[u8; 16]>();
            let holes = random.random::<u16>();
            let at = random.random::<[i32; 2]>();
            let (skin, whole) = (&skin(grays, holes), &skin(grays, 0));
            let holed = CutOut {
                texture: skin,
                key: KEY,
            };
            let at = at.map(|at| at >> 10);
            let nearest = Nearest::color::<false>(&skin, at, 0);
            let cut = Nearest::color::<false>(&holed, at, 0);
            assert_eq!(cut, OrHole((nearest != KEY).then_some(nearest)));

            let OrHole(smooth) = Bilinear::color::<false>(&holed, at, 0);
            if let Some(color) = smooth {
                assert!(
                    color.r() == color.g() && color.g() == color.b(),
                    "{color:?}"
                );
            }
            // Weights are rounded to 1/256 texel. Except at this distance from a texel's border, both filters agree on
            // the nearest texel.
            if at
                .iter()
                .all(|at| (at & 0xffff) >= 256 && (at & 0xffff) < 0xff00)
            {
                assert_eq!(smooth.is_none(), nearest == KEY);
            }
            let (texels, _) = around::<_, false>(&skin, at, 0);
            if !texels.as_flattened().contains(&KEY) {
                assert_eq!(smooth, Some(Bilinear::color::<false>(&whole, at, 0)));
            }
        });
    }

    #[test]
    fn a_cut_out_texel_leaves_color_and_depth() {
        use crate::{Window, prelude::*};
        static SKIN: [[Rgb565; 2]; 1] = [[Rgb565::RED, Rgb565::BLACK]];
        static SQUARE: Mesh = shape!(plane(1, 1));
        let window = Window::centered(fx!(2), fx!(2));
        let projection = Projection::orthographic(window, fx!(0), fx!(2)).unwrap();
        let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
        let (mut pixels, mut depths) = ([Rgb565::BLUE; 4], [7; 4]);
        let canvas = Canvas::new(&mut pixels, 4, 1).unwrap();
        let mut canvas = canvas.with_depth(&mut depths).unwrap();
        let skin = Textured::new(&SKIN).clamped();
        canvas.draw(&SQUARE, &mvp, &skin.cut_out(Rgb565::BLACK));
        assert_eq!(
            pixels,
            [Rgb565::RED, Rgb565::RED, Rgb565::BLUE, Rgb565::BLUE]
        );
        assert_eq!(depths[2..], [7, 7]);
        assert!(depths[0] > 7);
    }
}
