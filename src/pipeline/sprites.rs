//! Sprites: quads in eye space. They are drawn as meshes of eight quads each. Sprites that face the camera and have no
//! angles are upright rectangles on the screen; such a rectangle is drawn as one primitive if its varyings allow it.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::Drawn;
use super::cache::{self, Slots, VertexCache};
use super::call::{Call, Region};
use super::run::{self, IsPlane};
use super::thing::{Target, Thing};
use super::vertex::Projector;
use crate::canvas::{Blending, DepthTest};
use crate::math::{Transform, Vec2, Vec3};
use crate::mesh::{Index, Mesh, Placement, Positions, Sprites};
use crate::num::block::{self, BlockFloat};
use crate::num::rsqrt::unit;
use crate::num::wide::{dot, product};
use crate::num::{Angle, Scalar, TexCoord};
use crate::raster::{Blitter, Cull};
use crate::sealed::Sealed;
use crate::shade::ShaderFor;
use crate::span::{Plain, Shading, is_plane};
use crate::view::{AsMvp, Projection, ProjectionKind, Viewport};

impl Sealed for &Sprites<'_> {}

impl<C> Thing<C> for &Sprites<'_> {
    type Shading<'c, S: ShaderFor<C>, B: Blending<C>, Z: DepthTest> = Plain<S, B, Z>;

    #[inline]
    fn draw<V: AsMvp>(self, mvp: &V, to: Target<'_, impl Shading>) -> Drawn {
        let quads = Quads::new(self, (), mvp, &to.region.0.viewport);
        quads.draw(
            to.region,
            &|halves| is_plane(to.shading, halves),
            to.blitter,
        )
    }
}

impl Sealed for &Sprites<'_, &[Angle]> {}

impl<C> Thing<C> for &Sprites<'_, &[Angle]> {
    type Shading<'c, S: ShaderFor<C>, B: Blending<C>, Z: DepthTest> = Plain<S, B, Z>;

    #[inline]
    fn draw<V: AsMvp>(self, mvp: &V, to: Target<'_, impl Shading>) -> Drawn {
        let upright = self.upright();
        let quads = Quads::new(&upright, self.angles, mvp, &to.region.0.viewport);
        quads.draw(to.region, &|_| false, to.blitter)
    }
}

/// How many sprites are drawn as one mesh. Their corners take half of the vertex cache.
const BATCH: usize = 8;

/// The two triangles of each quad. The corners of a quad are in this order: bottom left, bottom right, top left, top
/// right.
static FACES: [[Index; 3]; 2 * BATCH] = faces();

const fn faces() -> [[Index; 3]; 2 * BATCH] {
    let mut faces = [[0; 3]; 2 * BATCH];
    let mut quad = 0;
    while quad < BATCH {
        let first = 4 * quad as Index;
        faces[2 * quad] = [first, first + 1, first + 2];
        faces[2 * quad + 1] = [first + 2, first + 1, first + 3];
        quad += 1;
    }
    faces
}

/// A sprite's corners, relative to its position in eye space, at scale 1: mantissas · 2^-exp.
struct UnitQuad {
    corners: [[i32; 3]; 4],
    exp: i32,
}

impl UnitQuad {
    /// The directions to the right and up of sprites that `view` transforms to eye space.
    #[inline]
    fn directions(sprites: &Sprites<'_>, view: &Transform) -> [[i32; 3]; 2] {
        /// Components of unit vectors, in units of 2^-30.
        const ONE: i32 = 1 << 30;
        let [mut right, mut up] = [[ONE, 0, 0], [0, ONE, 0]];
        let turned = sprites.axis.and_then(|axis| {
            let axis = axis.to_bits();
            unit(view.linear.map(|row| dot(&row, &axis)))
        });
        if let Some(axis) = turned {
            // The cross product of the axis and z. If they are parallel, any direction will do.
            let [x, y, _] = axis.map(i64::from);
            right = unit([y, -x, 0]).unwrap_or(right);
            up = axis;
        }
        [right, up]
    }

    /// The corners of sprites with these directions to the right and up. `pixel` is the size of a pixel in eye space, at
    /// a distance of 1 in perspective.
    #[inline]
    fn new(sprites: &Sprites<'_>, [right, up]: [[i32; 3]; 2], pixel: [BlockFloat; 2]) -> Self {
        let [width, height] = sprites
            .size
            .map(|v| BlockFloat::new(v.to_bits().into(), 16));
        let [width, height] = if sprites.is_in_pixels {
            [width.times(pixel[0]), height.times(pixel[1])]
        } else {
            [width, height]
        };
        // How far the left, right, bottom and top side are from the anchor, in units of 2^-20 of the width or height.
        let [u, v] = [sprites.anchor.x, sprites.anchor.y].map(|at| i64::from(at.to_bits()));
        let sides = [
            (right, width, -u),
            (right, width, (1 << 20) - u),
            (up, height, v - (1 << 20)),
            (up, height, v),
        ];
        let (mut numbers, mut mantissas) = ([BlockFloat::ZERO; 12], [0; 12]);
        for (numbers, (direction, length, part)) in numbers.chunks_exact_mut(3).zip(sides) {
            let length = length.times(BlockFloat::new(part, 20));
            for (number, component) in numbers.iter_mut().zip(direction) {
                *number = length.times(BlockFloat::new(component.into(), 30));
            }
        }
        let exp = block::normalize(&mut mantissas, &numbers);
        let [a, b, c, d, e, f, g, h, i, j, k, l] = mantissas;
        let [left, right, bottom, top] = [[a, b, c], [d, e, f], [g, h, i], [j, k, l]];
        // Mantissas are below 2^30.
        let sum = |[a, b, c]: [i32; 3], [x, y, z]: [i32; 3]| [a + x, b + y, c + z];
        Self {
            corners: [
                sum(left, bottom),
                sum(right, bottom),
                sum(left, top),
                sum(right, top),
            ],
            exp,
        }
    }

    /// The corners of a sprite of this scale, rounded to nearest; they saturate.
    fn scaled(&self, scale: BlockFloat) -> [Vec3; 4] {
        let (factor, exp) = scale.rounded();
        let exp = self.exp + exp;
        self.corners.map(|corner| {
            Vec3::from_bits(corner.map(|m| block::fixed(product(m, factor), exp, 16)))
        })
    }
}

/// How sprites are turned in the plane of their rectangles: not at all, or each by an angle.
trait Turn: Copy {
    const IS_UPRIGHT: bool;

    /// The corners at scale 1 from which all others are made.
    type Quad;

    /// Makes these corners from the arguments of [`UnitQuad::new`].
    fn quad(sprites: &Sprites<'_>, directions: [[i32; 3]; 2], pixel: [BlockFloat; 2])
    -> Self::Quad;

    /// The corners of a sprite of this scale, relative to its position.
    fn corners(self, quad: &Self::Quad, sprite: usize, scale: BlockFloat) -> [Vec3; 4];
}

impl Turn for () {
    const IS_UPRIGHT: bool = true;

    type Quad = UnitQuad;

    #[inline]
    fn quad(sprites: &Sprites<'_>, directions: [[i32; 3]; 2], pixel: [BlockFloat; 2]) -> UnitQuad {
        UnitQuad::new(sprites, directions, pixel)
    }

    #[inline]
    fn corners(self, quad: &UnitQuad, _: usize, scale: BlockFloat) -> [Vec3; 4] {
        quad.scaled(scale)
    }
}

impl Turn for &[Angle] {
    const IS_UPRIGHT: bool = false;

    /// Upright, and turned by a quarter turn, counter-clockwise about the anchor.
    type Quad = [UnitQuad; 2];

    fn quad(
        sprites: &Sprites<'_>,
        [right, up]: [[i32; 3]; 2],
        [width, height]: [BlockFloat; 2],
    ) -> [UnitQuad; 2] {
        let left = right.map(|component| -component);
        [
            UnitQuad::new(sprites, [right, up], [width, height]),
            UnitQuad::new(sprites, [up, left], [height, width]),
        ]
    }

    /// A corner that is turned by an angle is the upright corner times its cosine, plus the corner at a quarter turn
    /// times its sine.
    fn corners(
        self,
        [upright, across]: &[UnitQuad; 2],
        sprite: usize,
        scale: BlockFloat,
    ) -> [Vec3; 4] {
        let angle = self.get(sprite).copied().unwrap_or_default();
        let (sin, cos) = angle.sin_cos();
        // The exponents differ if pixels are not square.
        let exp = upright.exp.min(across.exp);
        let part = |quad: &UnitQuad, m: i32| m >> (quad.exp - exp).min(31);
        let mut corners = upright.corners;
        for (corner, across_corner) in corners.iter_mut().zip(across.corners) {
            for (m, across_m) in corner.iter_mut().zip(across_corner) {
                // Mantissas are below 2^31, and the sine and the cosine are at most 2^30. So the sum is below √2 · 2^61,
                // and half of it, in units of 2^30, fits into 32 bits.
                let sum = product(part(upright, *m), cos.to_bits())
                    + product(part(across, across_m), sin.to_bits());
                *m = ((sum + (1 << 30)) >> 31) as i32;
            }
        }
        let exp = exp - 1;
        UnitQuad { corners, exp }.scaled(scale)
    }
}

/// Whether a vector is inside the range of positions. Saturated numbers are at the ends of the range.
fn is_inside(vector: Vec3) -> bool {
    let [x, y, z] = vector.to_bits();
    let is_inside = |v: i32| i32::MIN < v && v < i32::MAX;
    is_inside(x) && is_inside(y) && is_inside(z)
}

/// The texture coordinates of a quad's corners, from the coordinates at its left, right, top and bottom side.
fn uvs_of([left, right, top, bottom]: [TexCoord; 4]) -> [Vec2; 4] {
    [[left, bottom], [right, bottom], [left, top], [right, top]].map(|[u, v]| Vec2::new(u, v))
}

/// A scale, the corners of a sprite at this scale, and whether all of them are in range.
type LastScale = (BlockFloat, [Vec3; 4], bool);

/// A draw call of sprites.
struct Quads<'s, K, A: Turn> {
    sprites: &'s Sprites<'s>,
    angles: A,
    /// From model to eye space.
    view: Transform,
    /// From eye to world space.
    pose: Transform,
    /// From eye space to the screen.
    projector: Projector<'static, K>,
    quad: A::Quad,
    /// Whether the size of a sprite is proportional to its distance.
    grows: bool,
}

impl<'s, K: ProjectionKind, A: Turn> Quads<'s, K, A> {
    #[inline(never)]
    fn new(
        sprites: &'s Sprites<'s>,
        angles: A,
        mvp: &impl AsMvp<Kind = K>,
        viewport: &Viewport,
    ) -> Self {
        let (projection, view): (&Projection<K>, _) = (mvp.projection_of(), mvp.model_view_of());
        let directions = UnitQuad::directions(sprites, &view);
        Self {
            quad: A::quad(sprites, directions, projection.pixel(viewport)),
            angles,
            sprites,
            view,
            pose: mvp.camera_of().inverse_rigid(),
            projector: Projector::new(
                Positions::of_one(&Vec3::ZERO),
                projection,
                &Transform::IDENTITY,
                viewport,
            ),
            grows: sprites.is_in_pixels && K::PERSPECTIVE,
        }
    }

    /// Draws all sprites.
    #[inline(never)]
    fn draw(
        &self,
        (screen, rows): Region<'_>,
        is_plane: IsPlane<'_>,
        blitter: &mut dyn Blitter,
    ) -> Drawn {
        let scissor = screen.scissor(rows);
        let sprites = self.sprites;
        // The corners of an upright sprite that faces the camera share one z, so the screen x of a corner depends only on its x,
        // and the screen y only on its y.
        let is_plane = Some(is_plane).filter(|_| A::IS_UPRIGHT && sprites.axis.is_none());
        let mut drawn = Drawn::default();
        let mut corners = [[Vec3::ZERO; 4]; BATCH];
        // If all sprites have the same texture coordinates, they are written only here.
        let mut uvs = [uvs_of(sprites.frame(0)); BATCH];
        let mut colors = [[Rgb888::WHITE; 4]; BATCH];
        let mut entries = cache::empty();
        let mut vertices = VertexCache::new(&mut entries, Slots::new(&[]));
        // The corners are kept for the last scale, because many sprites have the same scale.
        let mut last = (BlockFloat::ZERO, [Vec3::ZERO; 4], true);
        for (batch, positions) in sprites.positions.chunks(BATCH).enumerate() {
            let first = batch * BATCH;
            let quads = corners.iter_mut().zip(&mut uvs).zip(&mut colors);
            for (i, (&position, ((corners, uvs), colors))) in
                positions.iter().zip(quads).enumerate()
            {
                let sprite = first + i;
                *corners = self.corners(sprite, position, &mut last);
                if !sprites.frames.is_empty() {
                    *uvs = uvs_of(sprites.frame(sprite));
                }
                if let Some(&color) = sprites.colors.get(sprite) {
                    *colors = [color; 4];
                }
            }
            let colors = if sprites.colors.is_empty() {
                &[]
            } else {
                colors.as_flattened()
            };
            let faces = FACES.get(..2 * positions.len()).unwrap_or_default();
            let mesh = Mesh::of_lists(
                Positions::long(corners.as_flattened()),
                (faces, &[]),
                (uvs.as_flattened(), &[]),
                (&[], &[]),
                (colors, &[]),
            );
            let call = Call {
                slots: Slots::new(&[]),
                projector: self.projector.with_positions(mesh.positions()),
                placement: Placement::new(&mesh, &self.pose, Transform::IDENTITY),
                cull: Cull::Nothing,
                scissor: scissor.clone(),
                screen,
            };
            vertices.forget(4 * BATCH);
            drawn += run::quads(&call, 2 * first, &mut vertices, is_plane, blitter);
        }
        drawn
    }

    /// The corners of a sprite in eye space. If a corner is out of range, all corners are the same, so that the sprite
    /// has no pixels.
    fn corners(&self, sprite: usize, position: Vec3, last: &mut LastScale) -> [Vec3; 4] {
        let position = self.view.point(position);
        let scale = self.sprites.scales.get(sprite).unwrap_or(&Scalar::ONE);
        let mut scale = BlockFloat::new(scale.to_bits().into(), 16);
        if self.grows {
            // Nothing behind the eye is visible.
            let distance = (-position.z).to_bits().max(0);
            scale = BlockFloat::new(scale.value * i64::from(distance), 32);
        }
        if !A::IS_UPRIGHT || last.0 != scale {
            let corners = self.angles.corners(&self.quad, sprite, scale);
            *last = (scale, corners, corners.into_iter().all(is_inside));
        }
        let &mut (_, [a, b, c, d], corners_are_inside) = last;
        let corner = |offset| Some(position + offset).filter(|&sum| is_inside(sum));
        let all = || Some([corner(a)?, corner(b)?, corner(c)?, corner(d)?]);
        if corners_are_inside && is_inside(position) {
            all().unwrap_or_default()
        } else {
            [Vec3::ZERO; 4]
        }
    }
}
