//! A draw call that is made from bytes.

use arbitrary::{Result, Unstructured};
use embedded_graphics::pixelcolor::Rgb888;
use fixel::mesh::Keyframes;
use fixel::prelude::*;

use super::numbers::{bits, few, list, option, scalar, size, tex_coords, vector};
use super::projection::ProjectionArguments;
use super::shades::Shade;
use super::steps::{Eye, Steps};

/// The largest number of positions, and of triangles, in a mesh.
const MOST: usize = 10;

/// The values of an attribute, with or without a list of faces of their own.
#[derive(Clone, Debug)]
pub struct Attribute<T> {
    pub values: Vec<T>,
    pub faces: Option<Vec<[u16; 3]>>,
}

impl<T> Attribute<T> {
    fn arbitrary(
        u: &mut Unstructured<'_>,
        (positions, faces): (usize, usize),
        one: impl Fn(&mut Unstructured<'_>) -> Result<T>,
    ) -> Result<Self> {
        let own = u.arbitrary()?;
        let count = if own {
            u.int_in_range(1..=MOST)?
        } else {
            positions
        };
        Ok(Self {
            values: few(u, count, one)?,
            faces: own
                .then(|| few(u, faces, |u| corners(u, count)))
                .transpose()?,
        })
    }

    pub fn faces(&self) -> Option<&[[u16; 3]]> {
        self.faces.as_deref()
    }
}

/// Indices that are in range.
fn indices<const K: usize>(u: &mut Unstructured<'_>, count: usize) -> Result<[u16; K]> {
    let indices = u.arbitrary::<[u8; K]>()?;
    Ok(indices.map(|index| u16::from(index) % u16::try_from(count.max(1)).unwrap()))
}

/// The indices of an attribute's values at a triangle's corners. Sometimes, a corner has no value.
fn corners(u: &mut Unstructured<'_>, count: usize) -> Result<[u16; 3]> {
    Ok(if u.ratio(1, 8)? {
        let [a, b, _] = indices(u, count)?;
        [a, Mesh::NO_VALUE, b]
    } else {
        indices(u, count)?
    })
}

/// Which elements of a mesh are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum What {
    Triangles,
    Edges,
    Points,
    Sprites(Billboard),
}

/// The properties of sprites, except their positions. The scene's colors and texture coordinates have no effect on
/// sprites.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Billboard {
    size: (Scalar, Scalar),
    in_pixels: bool,
    axis: Option<Vec3>,
    anchor: Vec2,
    /// The scale of the first sprite. The other sprites have multiples of this scale.
    scale: Option<Scalar>,
    /// The frame of the first sprite. The other sprites have multiples of this frame number.
    frame: Option<u16>,
    grid: (u16, u16),
}

impl Billboard {
    fn arbitrary(u: &mut Unstructured<'_>) -> Result<Self> {
        Ok(Self {
            size: (size(u)?, size(u)?),
            in_pixels: u.arbitrary()?,
            axis: option(u, vector)?,
            anchor: tex_coords(u)?,
            scale: option(u, scalar)?,
            frame: u.arbitrary()?,
            grid: (u.int_in_range(0..=9)?, u.int_in_range(0..=1025)?),
        })
    }

    /// The scales and frames for this number of sprites.
    pub fn lists(&self, sprites: usize) -> (Vec<Scalar>, Vec<u16>) {
        let numbers = 1..=u16::try_from(sprites).unwrap();
        let scale = self.scale.unwrap_or_default();
        let frame = self.frame.unwrap_or_default();
        (
            numbers.clone().map(|i| scale * i32::from(i)).collect(),
            numbers.map(|i| frame.wrapping_mul(i)).collect(),
        )
    }

    /// Sprites at these positions with these [`lists`](Self::lists), if the crate accepts the numbers.
    pub fn sprites<'a>(
        &self,
        positions: &'a [Vec3],
        (scales, frames): &'a (Vec<Scalar>, Vec<u16>),
    ) -> Result<Sprites<'a>, Error> {
        let mut sprites = if self.in_pixels {
            Sprites::in_pixels(positions, self.size)?
        } else {
            Sprites::new(positions, self.size)?
        };
        sprites = sprites.with_anchor(self.anchor);
        if let Some(axis) = self.axis {
            sprites = sprites.with_axis(axis)?;
        }
        if self.scale.is_some() {
            sprites = sprites.with_scales(scales)?;
        }
        if self.frame.is_some() {
            sprites = sprites.with_frames(self.grid, frames)?;
        }
        Ok(sprites)
    }
}

/// How a mesh changes at run time.
#[derive(Clone, Debug)]
pub struct Changes {
    keyframe: Option<Keyframe>,
    has_smooth_normals: bool,
}

/// A second keyframe, and a position between the first and the second.
#[derive(Clone, Debug)]
struct Keyframe {
    positions: Vec<Vec3>,
    normals: Option<Vec<Vec3>>,
    t: Scalar,
}

impl Changes {
    const NONE: Self = Self {
        keyframe: None,
        has_smooth_normals: false,
    };

    fn arbitrary(
        u: &mut Unstructured<'_>,
        positions: usize,
        normals: Option<usize>,
    ) -> Result<Self> {
        Ok(Self {
            keyframe: option(u, |u| {
                Ok(Keyframe {
                    t: scalar(u)?,
                    positions: few(u, positions, vector)?,
                    normals: match normals {
                        Some(count) => option(u, |u| few(u, count, vector))?,
                        None => None,
                    },
                })
            })?,
            has_smooth_normals: option(u, |_| Ok(()))?.is_some(),
        })
    }
}

/// Memory for the blended mesh, and for the mesh with computed normals.
pub type Rooms = [Room; 2];

/// Memory for the lists of any scene's mesh.
#[derive(Debug)]
pub struct Room {
    positions: [Vec3; MOST],
    normals: [Vec3; 3 * MOST],
}

impl Room {
    pub const EMPTY: Self = Self {
        positions: [Vec3::ZERO; MOST],
        normals: [Vec3::ZERO; 3 * MOST],
    };
}

/// A draw call.
#[derive(Clone, Debug)]
pub struct Scene {
    pub positions: Vec<Vec3>,
    pub faces: Vec<[u16; 3]>,
    pub edges: Vec<[u16; 2]>,
    pub uvs: Option<Attribute<Vec2>>,
    pub normals: Option<Attribute<Vec3>>,
    pub colors: Option<Attribute<Rgb888>>,
    pub eye: Eye,
    pub model: Steps,
    pub projection: ProjectionArguments,
    /// Width and height of the canvas.
    pub size: (u32, u32),
    pub viewport: Option<[i32; 4]>,
    pub cull: Cull,
    /// The heights of the bands in rows. After the last height, the first one follows again.
    pub bands: Vec<u8>,
    pub what: What,
    pub shade: Shade,
    /// The tolerance of mode `Fast`, in texels.
    pub tolerance: Scalar,
    /// The initial contents of the depth buffer: one value in its first half, the other in its second half.
    pub depths: [u16; 2],
    /// Selects the style of edges and points. With 0, they are drawn as single pixels.
    pub style: u8,
    pub changes: Changes,
}

impl Scene {
    /// The scene that these bytes encode.
    pub fn of(bytes: &[u8]) -> Result<Self> {
        let u = &mut Unstructured::new(bytes);
        // The parts with the most effect on the picture come first.
        let what = *u.choose(&[
            What::Triangles,
            What::Triangles,
            What::Triangles,
            What::Edges,
            What::Points,
        ])?;
        let shade = Shade::arbitrary(u)?;
        let size = match u.arbitrary::<u8>()? {
            0..16 => (2048, u.int_in_range(1..=3)?),
            16..32 => (u.int_in_range(1..=3)?, 2048),
            _ => (u.int_in_range(1..=80)?, u.int_in_range(1..=64)?),
        };
        let projection = ProjectionArguments::arbitrary(u)?;
        let mut positions = list(u, MOST, vector)?;
        if let (true, Some(&first)) = (u.ratio(1, 16)?, positions.first()) {
            positions.fill(first);
        }
        let count = positions.len();
        let mut faces = list(u, MOST, |u| indices(u, count))?;
        if let (true, Some(last)) = (u.ratio(1, 64)?, faces.last_mut()) {
            *last = u.arbitrary()?;
        }
        let counts = (count, faces.len());
        let mut scene = Self {
            model: Steps::arbitrary(u)?,
            eye: Eye::arbitrary(u)?,
            cull: *u.choose(&[Cull::Nothing, Cull::Back, Cull::Front])?,
            uvs: option(u, |u| Attribute::arbitrary(u, counts, tex_coords))?,
            edges: list(u, MOST, |u| indices(u, count))?,
            normals: option(u, |u| Attribute::arbitrary(u, counts, vector))?,
            colors: option(u, |u| {
                Attribute::arbitrary(u, counts, |u| {
                    let [r, g, b] = u.arbitrary()?;
                    Ok(Rgb888::new(r, g, b))
                })
            })?,
            viewport: option(u, |u| viewport(u, size))?,
            bands: u.arbitrary::<[u8; 3]>()?.to_vec(),
            tolerance: match u.int_in_range(0..=5)? {
                0 => Scalar::from_bits(bits(u)?),
                // The tolerance is 1/8 to 2 texels.
                power => Scalar::from_bits(1 << (12 + power)),
            },
            depths: u.arbitrary()?,
            // New fields come last, and missing bytes are 0, so that older inputs keep their meaning.
            style: u.arbitrary()?,
            changes: Changes::NONE,
            positions,
            faces,
            what,
            shade,
            size,
            projection,
        };
        // Sprites come last, too, so that older inputs keep their meaning.
        if let Some(sprites) = option(u, Billboard::arbitrary)? {
            scene.what = What::Sprites(sprites);
        }
        let normals = scene.normals.as_ref().map(|normals| normals.values.len());
        scene.changes = Changes::arbitrary(u, count, normals)?;
        Ok(scene)
    }

    /// The mesh, if its indices are in range.
    pub fn mesh<'m>(&'m self, rooms: &'m mut Rooms) -> Result<Mesh<'m>, Error> {
        self.changed(self.first()?, rooms)
    }

    /// The mesh before it is changed.
    fn first(&self) -> Result<Mesh<'_>, Error> {
        let mut mesh = Mesh::new(&self.positions, &self.faces)?.with_edges(&self.edges)?;
        if let Some(uvs) = &self.uvs {
            mesh = mesh.with_uvs(&uvs.values, uvs.faces())?;
        }
        if let Some(normals) = &self.normals {
            mesh = mesh.with_normals(&normals.values, normals.faces())?;
        }
        if let Some(colors) = &self.colors {
            mesh = mesh.with_colors(&colors.values, colors.faces())?;
        }
        Ok(mesh)
    }

    fn changed<'m>(
        &'m self,
        mut mesh: Mesh<'m>,
        [room, of_normals]: &'m mut Rooms,
    ) -> Result<Mesh<'m>, Error> {
        if let Some(keyframe) = &self.changes.keyframe {
            let mut second = Mesh::new(&keyframe.positions, &self.faces)?;
            if let (Some(first), Some(normals)) = (&self.normals, &keyframe.normals) {
                second = second.with_normals(normals, first.faces())?;
            }
            let frames = Keyframes::new(&mesh, &second)?;
            let start = frames.blend(fx!(0), &mut room.positions, &mut room.normals)?;
            assert_eq!(start.positions(), mesh.positions());
            let end = frames.blend(fx!(1), &mut room.positions, &mut room.normals)?;
            assert_eq!(end.positions(), second.positions());
            mesh = frames.blend(keyframe.t, &mut room.positions, &mut room.normals)?;
        }
        if self.changes.has_smooth_normals {
            mesh = mesh.with_smooth_normals(&mut of_normals.normals)?;
        }
        Ok(mesh)
    }

    /// The draw options in the default mode, if the crate accepts the viewport.
    pub fn options(&self) -> Result<DrawOptions, Error> {
        let options = DrawOptions::new().with_cull(self.cull);
        Ok(match self.viewport {
            None => options,
            Some(_) => options.with_viewport(self.window()?),
        })
    }

    /// The viewport: the whole canvas if the scene has none.
    pub fn window(&self) -> Result<Viewport, Error> {
        match self.viewport {
            None => Viewport::new(0, 0, self.size.0, self.size.1),
            Some([x, y, width, height]) => {
                Viewport::new(x, y, width.unsigned_abs(), height.unsigned_abs())
            }
        }
    }

    /// Whether the view of the model is a mirror image.
    pub fn mirrors(&self) -> bool {
        self.eye.mirrors() != self.model.mirrors()
    }

    /// The number of pixels of the canvas.
    pub fn pixels(&self) -> usize {
        self.size.0 as usize * self.size.1 as usize
    }
}

/// A viewport near the canvas, or anywhere and of any size.
fn viewport(u: &mut Unstructured<'_>, (width, height): (u32, u32)) -> Result<[i32; 4]> {
    let (width, height) = (width.cast_signed(), height.cast_signed());
    Ok(match u.int_in_range(0..=3)? {
        0 => [bits(u)?, bits(u)?, bits(u)?, bits(u)?],
        1 => [
            u.int_in_range(-4096..=4096)?,
            u.int_in_range(-4096..=4096)?,
            u.int_in_range(1..=4096)?,
            u.int_in_range(1..=4096)?,
        ],
        _ => [
            u.int_in_range(-width..=width)?,
            u.int_in_range(-height..=height)?,
            u.int_in_range(1..=2 * width)?,
            u.int_in_range(1..=2 * height)?,
        ],
    })
}
