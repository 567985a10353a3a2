//! Surfaces under a light.

use core::marker::PhantomData;

use embedded_graphics::pixelcolor::Rgb888;

use super::levels::{FRACTION, Levels, dimmed};
use super::light::Light;
use super::{Addressing, Filter, Fragment, Nearest, Repeat, Sampler, Shader, Textured};
use crate::math::{Transform, Vec3};
use crate::mesh::{Corner, Face};
use crate::span::Tolerance;

/// A colour under a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Surface<C> {
    /// In full light.
    levels: [i32; 3],
    light: Light,
    color: PhantomData<C>,
}

impl<C: Levels> Surface<C> {
    fn new(color: Rgb888, light: Light) -> Self {
        Self {
            levels: C::levels(color),
            light,
            color: PhantomData,
        }
    }

    #[inline]
    fn begin(self, model: &Transform) -> Self {
        Self {
            light: self.light.begin(model),
            ..self
        }
    }

    /// The levels of the surface where it has this normal.
    #[inline]
    fn facing(&self, normal: Vec3) -> [i32; 3] {
        dimmed(self.levels, self.light.brightness(normal))
    }
}

/// One surface colour under a [`Light`], whose brightness is found at the vertices and
/// interpolated (Gouraud shading).
///
/// Normals are the mesh's, or where it has none the triangles' own. The one varying is the
/// brightness, 65,536 being 1.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor, Rgb888, RgbColor}};
/// use fixel::prelude::*;
/// static BALL: Mesh = shape!(sphere(8, 8));
/// let projection = Projection::orthographic(fx!(-1), fx!(1), fx!(-1), fx!(1), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::front(Vec3::ZERO, fx!(1));
/// let sun = Light::new(vec3!(1, 2, 1), fx!(0.2), fx!(0.8))?;
/// let mut pixels = [Gray4::BLACK; 144];
/// let mut canvas = Canvas::new(&mut pixels, 12, 12)?;
/// canvas.draw(&BALL, &mvp, &Lit::new(Rgb888::WHITE, sun));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "0000CDEF0000",
///     "009ACDEEFE00",
///     "068ABCCDDEC0",
///     "0588ABCCDDD0",
///     "34678AABBCBB",
///     "33567899AAB9",
///     "333457788988",
///     "333345667775",
///     "033334344540",
///     "033333434440",
///     "003333333300",
///     "000033330000",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lit<C> {
    surface: Surface<C>,
}

impl<C: Levels> Lit<C> {
    /// A surface that has this colour in full light.
    #[must_use]
    pub fn new(surface: impl Into<Rgb888>, light: Light) -> Self {
        Self {
            surface: Surface::new(surface.into(), light),
        }
    }
}

impl<C: Levels> Shader<1> for Lit<C> {
    type Color = C;

    const TOLERANCES: [Tolerance; 1] = [FRACTION];

    #[inline]
    fn begin(self, model: &Transform) -> Self {
        Self {
            surface: self.surface.begin(model),
        }
    }

    #[inline]
    fn varyings(&self, vertex: &Corner<'_>) -> [i32; 1] {
        [self.surface.light.brightness(vertex.normal())]
    }

    #[inline]
    fn shade(&self, sample: &Fragment, [light]: [i32; 1]) -> Option<C> {
        let levels = dimmed(self.surface.levels, light);
        Some(C::from_levels(levels, sample.point))
    }
}

/// One surface colour under a [`Light`], each triangle evenly, by its own normal.
///
/// Edges and points have the colour in full light.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor, Rgb888, RgbColor}};
/// use fixel::prelude::*;
/// static BALL: Mesh = shape!(sphere(8, 8));
/// let projection = Projection::orthographic(fx!(-1), fx!(1), fx!(-1), fx!(1), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::front(Vec3::ZERO, fx!(1));
/// let sun = Light::new(vec3!(1, 2, 1), fx!(0.2), fx!(0.8))?;
/// let mut pixels = [Gray4::BLACK; 144];
/// let mut canvas = Canvas::new(&mut pixels, 12, 12)?;
/// canvas.draw(&BALL, &mvp, &LitFaces::new(Rgb888::WHITE, sun));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "0000CDEF0000",
///     "00ACDCFFFE00",
///     "065AABDEDED0",
///     "06BABAEDEEE0",
///     "337877BBBBBB",
///     "338787BBBBBB",
///     "333444787878",
///     "334444878887",
///     "033333333330",
///     "033333434340",
///     "003333333300",
///     "000033330000",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LitFaces<C> {
    surface: Surface<C>,
    /// Levels of the triangle at hand.
    current: [i32; 3],
}

impl<C: Levels> LitFaces<C> {
    /// A surface that has this colour in full light.
    #[must_use]
    pub fn new(surface: impl Into<Rgb888>, light: Light) -> Self {
        let surface = Surface::new(surface.into(), light);
        Self {
            surface,
            current: surface.levels,
        }
    }
}

impl<C: Levels> Shader<0> for LitFaces<C> {
    type Color = C;

    const READS_DEPTH: bool = false;

    #[inline]
    fn begin(self, model: &Transform) -> Self {
        Self {
            surface: self.surface.begin(model),
            ..self
        }
    }

    #[inline]
    fn varyings(&self, _: &Corner<'_>) -> [i32; 0] {
        []
    }

    #[inline]
    fn face(self, _: &mut [[i32; 0]; 3], face: &Face<'_>) -> Self {
        Self {
            current: self.surface.facing(face.normal()),
            ..self
        }
    }

    #[inline]
    fn shade(&self, sample: &Fragment, _: [i32; 0]) -> Option<C> {
        Some(C::from_levels(self.current, sample.point))
    }
}

/// A texture under a [`Light`], whose brightness is found at the vertices and interpolated.
/// Made by [`Textured::lit`].
///
/// Normals are the mesh's, or where it has none the triangles' own. Varyings are column and row,
/// then the brightness, 65,536 being 1.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray8, GrayColor}};
/// use fixel::prelude::*;
/// static SKIN: TextureArray<Gray8, 2, 2> = TextureArray::gray8(&[0x88, 0xee, 0x44, 0xaa]);
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(fx!(-1), fx!(1), fx!(-1), fx!(1), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray8::BLACK; 16];
/// let mut canvas = Canvas::new(&mut pixels, 4, 4)?;
/// // Half of full light: every texel half as bright.
/// let sun = Light::new(Vec3::Y, fx!(0), fx!(0.5))?;
/// canvas.draw(&SQUARE, &mvp, &Textured::new(&SKIN).lit(sun));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["4477", "4477", "2255", "2255"]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LitTexture<S, A = Repeat, F = Nearest> {
    texture: Textured<S, A, F>,
    light: Light,
}

impl<S: Sampler, A: Addressing, F> LitTexture<S, A, F> {
    pub(super) const fn new(texture: Textured<S, A, F>, light: Light) -> Self {
        Self { texture, light }
    }
}

impl<S: Sampler, A: Addressing, F: Filter<S::Color>> Shader<3> for LitTexture<S, A, F>
where
    S::Color: Levels,
{
    type Color = S::Color;

    const TOLERANCES: [Tolerance; 3] = [Tolerance::Texels, Tolerance::Texels, FRACTION];

    #[inline]
    fn begin(self, model: &Transform) -> Self {
        Self {
            light: self.light.begin(model),
            ..self
        }
    }

    #[inline]
    fn varyings(&self, vertex: &Corner<'_>) -> [i32; 3] {
        let [u, v] = self.texture.coordinates(vertex);
        [u, v, self.light.brightness(vertex.normal())]
    }

    #[inline]
    fn face(self, corners: &mut [[i32; 3]; 3], face: &Face<'_>) -> Self {
        self.texture.place(corners, face);
        self
    }

    #[inline]
    fn shade(&self, sample: &Fragment, [u, v, light]: [i32; 3]) -> Option<S::Color> {
        Some(self.texture.color(u, v).lit(light, sample.point))
    }
}

#[cfg(test)]
mod tests {
    use super::super::trial::{IDENTITY, count, face, scale, shade};
    use super::*;
    use crate::texture::TextureArray;
    use crate::{Mesh, fx, vec2, vec3};
    use embedded_graphics::pixelcolor::{Gray8, Rgb565, RgbColor};

    static POSITIONS: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];
    static NORMALS: [Vec3; 3] = [vec3!(0, 0, 9), vec3!(0, 3, 4), vec3!(0, 1, 0)];

    fn sun() -> Light {
        Light::new(vec3!(0, 0, 1), fx!(0.25), fx!(0.5)).unwrap()
    }

    fn mesh() -> Mesh<'static> {
        Mesh::new(&POSITIONS, &[[0, 1, 2], [0, 2, 1]]).unwrap()
    }

    #[test]
    fn vertices_are_lit_by_their_normals() {
        let mesh = mesh().with_normals(&NORMALS, None).unwrap();
        let (shader, corners) = face(Lit::<Gray8>::new(Rgb888::WHITE, sun()), &IDENTITY, &mesh, 0);
        // 0.75, 0.65 and 0.25 in units of 2^-16, rounded; then of 255.
        assert_eq!(corners, [[49152], [42598], [16384]]);
        assert_eq!(
            corners.map(|corner| shade(&shader, corner)),
            [191, 166, 64].map(Gray8::new)
        );
    }

    #[test]
    fn without_normals_the_triangle_s_own_counts() {
        let lit = Lit::<Rgb565>::new(Rgb888::WHITE, sun());
        assert_eq!(face(lit, &IDENTITY, &mesh(), 0).1, [[49152]; 3]);
        assert_eq!(face(lit, &IDENTITY, &mesh(), 1).1, [[16384]; 3]);
        let lit = Lit::<Rgb565>::new(Rgb888::WHITE, sun().two_sided());
        assert_eq!(face(lit, &IDENTITY, &mesh(), 1).1, [[49152]; 3]);
    }

    #[test]
    fn faces_are_lit_evenly_in_their_pose() {
        let lit = LitFaces::<Rgb565>::new(Rgb565::WHITE, sun());
        let shown = |model, index| {
            let (shader, _) = face(lit, model, &mesh(), index);
            shade(&shader, [])
        };
        assert_eq!(shown(&IDENTITY, 0), Rgb565::new(23, 47, 23));
        assert_eq!(shown(&IDENTITY, 1), Rgb565::new(8, 16, 8));
        let mirrored = scale([1 << 29, 1 << 29, -(1 << 29)]);
        assert_eq!(shown(&mirrored, 0), Rgb565::new(8, 16, 8));
        assert_eq!(shade(&lit, []), Rgb565::WHITE);
    }

    #[test]
    fn textures_are_lit() {
        let skin = TextureArray::from_texels([[Rgb565::WHITE, Rgb565::new(20, 40, 4)]]);
        let uvs = [vec2!(2.5, 0), vec2!(2.5, 0), vec2!(2, 0)];
        let mesh = mesh().with_normals(&NORMALS, None).unwrap();
        let mesh = mesh.with_uvs(&uvs, None).unwrap();
        let (shader, corners) = face(Textured::new(&skin).lit(sun()), &IDENTITY, &mesh, 0);
        assert_eq!(
            corners,
            [[1 << 16, 0, 49152], [1 << 16, 0, 42598], [0, 0, 16384]]
        );
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
}
