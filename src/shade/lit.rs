//! Surfaces under a light.

use super::adapters::cached;
use super::format::FRACTION;
use super::light::{self, FULL, Illumination, Light, Lighting, SurfacePoint};
use super::{Adapted, Channels, Effect, Output, PerFace, PixelFormat, Within};
use crate::math::Direction;
use crate::mesh::{Corner, Primitive, Reads};

/// A surface under light that is computed at the vertices and interpolated (Gouraud shading); see [`Shader::lit`].
///
/// [`Shader::lit`]: super::Shader::lit
pub type Lit<S, L = Light> = Adapted<S, ByVertex<L>>;

#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ByVertex<L>(pub(super) L);

/// The amount of light that a light `L` throws on a surface.
type LightOf<L> = Illumination<<L as Lighting>::Diffuse, <L as Lighting>::Specular>;

/// The varyings of a light `L` on a surface of color `C`.
type PackedOf<L, C> = light::Packed<<L as Lighting>::Diffuse, <L as Lighting>::Specular, C>;

impl<O: Output<Color: PixelFormat>, L: Lighting> Effect<O> for ByVertex<L> {
    type Color = O::With<O::Color>;
    type Varyings = Within<FRACTION, PackedOf<L, O::Color>>;

    // A light that reads the face may throw different light on two sides of a vertex.
    const KEEPS_CORNERS: bool = !L::READS_FACE;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>, keeps: bool) -> [Self::Varyings; 3] {
        // Without normals, all corners of a triangle have the triangle's own normal.
        let has_normals = primitive.placement.mesh.has_normals();
        let face = if (L::READS_FACE || !has_normals) && primitive.face().is_some() {
            primitive.world_normal()
        } else {
            Direction::NONE
        };
        let light = |corner: &Corner<'_>| {
            let normal = if has_normals {
                corner.world_normal()
            } else {
                face
            };
            let point = SurfacePoint::new::<L>(normal, face, || corner.world_position());
            Within(self.0.at(&point).pack::<O::Color>())
        };
        let reads = if L::READS_POSITION {
            Reads::Both
        } else {
            Reads::Normal
        };
        let keeps = keeps && has_normals && !L::READS_FACE;
        cached(primitive, (keeps, reads), light)
    }

    #[inline]
    fn apply(&self, output: O, Within(light): Self::Varyings) -> Self::Color {
        output.lit(LightOf::<L>::unpack::<O::Color>(light))
    }
}

/// A surface under light that is computed once per triangle, at the triangle's center and for the triangle's own
/// normal; see [`Shader::lit_faces`].
///
/// [`Shader::lit_faces`]: super::Shader::lit_faces
pub type FaceLit<S, L = Light> = Adapted<S, ByFace<L>>;

#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ByFace<L>(pub(super) L);

impl<O: Output<Color: PixelFormat>, L: Lighting> Effect<O> for ByFace<L> {
    type Color = O::With<O::Color>;
    type Varyings = PerFace<PackedOf<L, O::Color>>;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>, _: bool) -> [Self::Varyings; 3] {
        let light = if primitive.face().is_some() {
            let (normal, position) = (primitive.world_normal(), || primitive.world_middle());
            let point = SurfacePoint::new::<L>(normal, normal, position);
            self.0.at(&point)
        } else {
            Illumination {
                diffuse: L::Diffuse::of([FULL; 3]),
                specular: L::Specular::default(),
            }
        };
        [PerFace(light.pack::<O::Color>()); 3]
    }

    #[inline]
    fn apply(&self, output: O, PerFace(light): Self::Varyings) -> Self::Color {
        output.lit(LightOf::<L>::unpack::<O::Color>(light))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Flat, Gouraud, Shader, Texels, Textured, Varyings};
    use super::*;
    use crate::fixtures::shader::{IDENTITY, count, face, scale, shade};
    use crate::{Mesh, Vec3, fx, vec2, vec3};
    use embedded_graphics::pixelcolor::{Gray8, Rgb565, Rgb888, RgbColor};

    static POSITIONS: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];
    static NORMALS: [Vec3; 3] = [vec3!(0, 0, 9), vec3!(0, 3, 4), vec3!(0, 1, 0)];

    fn sun() -> Light {
        Light::new(vec3!(0, 0, 1), fx!(0.25), fx!(0.5)).unwrap()
    }

    fn mesh() -> Mesh<'static> {
        Mesh::new(&POSITIONS, &[[0, 1, 2], [0, 2, 1]]).unwrap()
    }

    /// The brightness at the three corners.
    fn lights<S: Shader<Color: Output<Color: PixelFormat>>>(
        lit: Lit<S>,
        mesh: &Mesh<'_>,
        index: usize,
    ) -> [i32; 3] {
        let (_, corners) = face(lit, &IDENTITY, mesh, index);
        corners.map(|(_, Within((light, ())))| light)
    }

    #[test]
    fn vertices_are_lit_by_their_normals() {
        let mesh = mesh().with_normals(&NORMALS, None).unwrap();
        let lit = Flat::<Gray8>::rgb(Rgb888::WHITE).lit(sun());
        // The brightnesses are 0.75, 0.65 and 0.25: rounded to units of 2^-16 here, and below as grays from 0 to 255.
        assert_eq!(lights(lit, &mesh, 0), [49152, 42598, 16384]);
        let (shader, corners) = face(lit, &IDENTITY, &mesh, 0);
        assert_eq!(
            corners.map(|corner| shade(&shader, corner)),
            [191, 166, 64].map(Gray8::new)
        );
    }

    #[test]
    fn without_vertex_normals_the_triangle_normal_counts() {
        let lit = Flat::new(Rgb565::WHITE).lit(sun());
        assert_eq!(lights(lit, &mesh(), 0), [49152; 3]);
        assert_eq!(lights(lit, &mesh(), 1), [16384; 3]);
    }

    #[test]
    fn a_gray_canvas_shows_the_luma_of_colored_light() {
        let white = Light::new(vec3!(0, 0, 1), fx!(0), fx!(1)).unwrap();
        for (color, weight) in [
            (Rgb888::RED, 0.299),
            (Rgb888::GREEN, 0.587),
            (Rgb888::BLUE, 0.114),
        ] {
            let lit = Flat::new(Gray8::new(255)).lit(white.colored(color));
            let (_, corners) = face(lit, &IDENTITY, &mesh(), 0);
            for ((), Within((light, ()))) in corners {
                // The weight is off by up to 2^-15, which is 2 units; the light by 1 unit; the luma is rounded by half.
                assert!((f64::from(light) - weight * 65_536.0).abs() <= 3.5);
            }
        }
    }

    #[test]
    fn faces_are_lit_evenly_in_world_space() {
        let lit = Flat::<Rgb565>::rgb(Rgb565::WHITE).lit_faces(sun());
        let shown = |model, index| {
            let (shader, [corner, ..]) = face(lit, model, &mesh(), index);
            shade(&shader, corner)
        };
        assert_eq!(shown(&IDENTITY, 0), Rgb565::new(23, 47, 23));
        assert_eq!(shown(&IDENTITY, 1), Rgb565::new(8, 16, 8));
        let mirrored = scale([1 << 29, 1 << 29, -(1 << 29)]);
        assert_eq!(shown(&mirrored, 0), Rgb565::new(8, 16, 8));
        assert_eq!(shade(&lit, ((), PerFace((FULL, ())))), Rgb565::WHITE);
    }

    #[test]
    fn textures_are_lit() {
        let skin = [[Rgb565::WHITE, Rgb565::new(20, 40, 4)]];
        let uvs = [vec2!(2.5, 0), vec2!(2.5, 0), vec2!(2, 0)];
        let mesh = mesh().with_normals(&NORMALS, None).unwrap();
        let mesh = mesh.with_uvs(&uvs, None).unwrap();
        let (shader, corners) = face(Textured::new(&skin).lit(sun()), &IDENTITY, &mesh, 0);
        let texels = [[1 << 16, 0], [1 << 16, 0], [0, 0]].map(Texels);
        assert_eq!(corners.map(|(texels, _)| texels), texels);
        assert_eq!(
            corners.map(|corner| shade(&shader, corner)),
            [
                Rgb565::new(15, 30, 3),
                Rgb565::new(13, 26, 3),
                Rgb565::new(8, 16, 8)
            ]
        );
        assert_eq!(count(&shader), 3);
    }

    /// Light and vertex colors are separate varyings, so that their product is rounded once.
    #[test]
    fn vertex_colors_are_lit_and_rounded_once() {
        let colors = [Rgb888::new(200, 100, 0); 3];
        let mesh = mesh().with_colors(&colors, None).unwrap();
        let (shader, [corner, ..]) = face(Gouraud::<Rgb888>::new().lit(sun()), &IDENTITY, &mesh, 0);
        assert_eq!(count(&shader), 4);
        let (numbers, _) = corner.split();
        assert_eq!(numbers[3], 49152);
        assert_eq!(shade(&shader, corner), Rgb888::new(150, 75, 0));
    }
}
