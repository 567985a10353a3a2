//! Adapters: shaders that change the color of a surface.

use core::marker::PhantomData;

use super::format::{FRACTION, fractions};
use super::{
    Channels, ColorOf, Fragment, Illumination, Lanes, Output, PixelFormat, Precise, PreciseOf,
    Shader, Varyings, Within,
};
use crate::mesh::{Corner, Primitive, Reads};

/// A surface and an effect. The effect changes the surface's output and has varyings of its own.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Adapted<S, E> {
    pub(super) surface: S,
    pub(super) effect: E,
}

/// An effect that changes the output, of type `O`, of a surface: a light, a tint, or fog.
#[doc(hidden)]
pub trait Effect<O: Output>: Copy {
    /// The output after the effect.
    type Color: Output;

    /// The values that the effect interpolates, in addition to the values of the surface.
    type Varyings: Varyings;

    /// Whether the effect [keeps](Shader::KEEPS_CORNERS) its values for corners.
    const KEEPS_CORNERS: bool = false;

    /// The values at the corners of a primitive. `keeps` is true if no effect below this one keeps values, because a draw
    /// call has a single cache.
    fn varyings(&self, primitive: &Primitive<'_>, keeps: bool) -> [Self::Varyings; 3];

    /// Applies the effect to the surface's output at a pixel.
    fn apply(&self, output: O, varyings: Self::Varyings) -> Self::Color;
}

/// The values at the corners of a primitive, from the draw call's cache if `keeps` is true. They may depend only on what
/// `reads` says.
#[inline]
pub(super) fn cached<V: Varyings>(
    primitive: &Primitive<'_>,
    (keeps, reads): (bool, Reads),
    mut values: impl FnMut(&Corner<'_>) -> V,
) -> [V; 3] {
    const { assert!(size_of::<V::Face>() == 0) };
    if cfg!(for_size) {
        return primitive.corners(values);
    }
    let numbers = primitive.cached_corners((keeps, reads), V::Lanes::splat(0), |corner| {
        values(corner).split().0
    });
    numbers.map(|numbers| V::join(numbers, V::Face::default()))
}

impl<S: Shader, E: Effect<S::Color>> Shader for Adapted<S, E> {
    type Color = E::Color;
    type Varyings = (S::Varyings, E::Varyings);

    const READS_DEPTH: bool = S::READS_DEPTH;
    const KEEPS_CORNERS: bool = S::KEEPS_CORNERS || E::KEEPS_CORNERS;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let [a, b, c] = self.surface.varyings(primitive);
        let [x, y, z] = self.effect.varyings(primitive, !S::KEEPS_CORNERS);
        [(a, x), (b, y), (c, z)]
    }

    #[inline]
    fn shade(&self, at: &Fragment, (inside, own): Self::Varyings) -> Option<E::Color> {
        Some(self.effect.apply(self.surface.shade(at, inside)?, own))
    }
}

/// A surface multiplied by the interpolated vertex color, channel by channel; see [`Shader::tinted`].
pub type Tinted<S> = Adapted<S, Tint>;

#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Tint;

impl<O: Output<Color: PixelFormat>> Effect<O> for Tint {
    type Color = O::With<O::Color>;
    type Varyings = Within<FRACTION, <O::Color as PixelFormat>::Channels>;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>, _: bool) -> [Self::Varyings; 3] {
        primitive.corners(|corner| Within(Channels::of(fractions::<O::Color>(corner.color()))))
    }

    #[inline]
    fn apply(&self, output: O, Within(tint): Self::Varyings) -> Self::Color {
        let (diffuse, specular) = (tint.rgb(), ());
        output.lit(Illumination { diffuse, specular })
    }
}

/// Shader `S`, converted for a canvas of color format `C`; see [`Shader::converted`].
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Converted<S, C> {
    shader: S,
    color: PhantomData<C>,
}

impl<S, C> Converted<S, C> {
    /// Converts `shader` for a canvas of color `C`.
    #[must_use]
    pub(super) const fn new(shader: S) -> Self {
        Self {
            shader,
            color: PhantomData,
        }
    }
}

impl<S: Shader<Color: Output<Color: PixelFormat>>, C: PixelFormat> Shader for Converted<S, C> {
    type Color = <S::Color as Output>::With<C>;
    type Varyings = S::Varyings;

    const READS_DEPTH: bool = S::READS_DEPTH;
    const KEEPS_CORNERS: bool = S::KEEPS_CORNERS;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.shader.varyings(primitive)
    }

    #[inline]
    fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<Self::Color> {
        Some(self.shader.shade(at, varyings)?.map(Precise::converted))
    }
}

/// A shader, and a function that is applied to each pixel that the shader colors; see [`Shader::map`].
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Map<S, F> {
    pub(super) shader: S,
    pub(super) effect: F,
}

impl<S: Shader, C: Output, F: Fn(&Fragment, S::Color) -> Option<C> + Copy> Shader for Map<S, F> {
    type Color = C;
    type Varyings = S::Varyings;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.shader.varyings(primitive)
    }

    #[inline]
    fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<C> {
        (self.effect)(at, self.shader.shade(at, varyings)?)
    }
}

/// A surface that is dithered whatever its format; see [`Shader::dithered`].
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dithered<S> {
    pub(super) surface: S,
}

impl<S: Shader<Color: Output<Color: PixelFormat>>> Shader for Dithered<S> {
    type Color = PreciseOf<S>;
    type Varyings = S::Varyings;

    const READS_DEPTH: bool = S::READS_DEPTH;
    const KEEPS_CORNERS: bool = S::KEEPS_CORNERS;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.surface.varyings(primitive)
    }

    #[inline]
    fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<PreciseOf<S>> {
        let output = self.surface.shade(at, varyings)?;
        Some(output.map::<ColorOf<S>>(|color| color.dithered(at.point)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{FaceColors, Flat, Textured, Varyings};
    use super::*;
    use crate::fixtures::shader::{IDENTITY, count, face, fragment, shade};
    use crate::{Mesh, Vec3, vec2};
    use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888, RgbColor};

    static POSITIONS: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];

    #[test]
    fn texels_are_filtered_by_the_vertex_color() {
        let skin = [[Rgb565::WHITE, Rgb565::new(20, 21, 22)]];
        let uvs = [vec2!(7.5, 0), vec2!(7.5, 0), vec2!(7, 0)];
        let colors = [
            Rgb888::WHITE,
            Rgb888::new(255, 0, 128),
            Rgb888::new(0, 128, 255),
        ];
        let mesh = Mesh::new(&POSITIONS, &[[0, 1, 2]])
            .and_then(|mesh| mesh.with_uvs(&uvs, None)?.with_colors(&colors, None))
            .unwrap();
        let (shader, corners) = face(Textured::new(&skin).tinted(), &IDENTITY, &mesh, 0);
        let (numbers, _) = Varyings::split(corners[0]);
        assert_eq!(numbers, [1 << 16, 0, 1 << 16, 1 << 16, 1 << 16]);
        assert_eq!(
            corners.map(|corner| shade(&shader, corner)),
            [
                Rgb565::new(20, 21, 22),
                Rgb565::new(20, 0, 11),
                Rgb565::new(0, 32, 31)
            ]
        );
    }

    #[test]
    fn the_color_decides_the_number_of_varyings() {
        let skin = [[Rgb565::WHITE]];
        let shader = Textured::new(&skin).tinted();
        assert_eq!(count(&shader), 5);
        assert_eq!(count(&Converted::<_, BinaryColor>::new(shader)), 5);
        let skin = [[Gray8::new(200)]];
        let shader = Textured::new(&skin).clamped().tinted();
        assert_eq!(count(&shader), 3);
        let (texels, one) = (super::super::Texels([0, 0]), Within(1 << 15));
        assert_eq!(shade(&shader, (texels, one)), Gray8::new(100));
    }

    #[test]
    fn the_inner_shader_computes_the_color() {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]; 2]).unwrap();
        let colors = [Rgb888::BLACK, Rgb888::new(8, 120, 200)];
        let shader = Converted::<_, Rgb565>::new(FaceColors::new(&colors));
        let (shader, [corner, ..]) = face(shader, &IDENTITY, &mesh, 1);
        assert_eq!(shade(&shader, corner), Rgb565::new(1, 30, 24));
    }

    #[test]
    fn coarse_colors_are_dithered() {
        let gray = Converted::<_, Gray4>::new(Flat::new(Rgb888::new(8, 8, 8)));
        // 8/255 of 15 steps is 0.47 of a step.
        let lit = (0..64).filter(|i| {
            gray.shade(&fragment(0, 0), ())
                .unwrap()
                .finish(fragment(i % 8, i / 8).point)
                == Gray4::new(1)
        });
        assert_eq!(lit.count(), 30);
        let white = Converted::<_, BinaryColor>::new(Flat::new(Rgb565::WHITE));
        assert!((0..64).all(|i| {
            white
                .shade(&fragment(0, 0), ())
                .unwrap()
                .finish(fragment(i % 8, i / 8).point)
                == BinaryColor::On
        }));
    }
}
