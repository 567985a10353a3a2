//! The user's own model, in memory of a fixed size.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::mesh::{Buffers, Counts, obj};
use fixel::prelude::*;

/// Most triangles.
pub const FACES: usize = 65_536;
const POSITIONS: usize = 65_535;
/// Most texels along a side, and in all.
pub const SIDE: u32 = 512;
const TEXELS: usize = (SIDE * SIDE) as usize;

/// A mesh and its texture.
pub struct Model {
    counts: Counts,
    positions: [Vec3; POSITIONS],
    faces: [[u16; 3]; FACES],
    uvs: [Vec2; POSITIONS],
    uv_faces: [[u16; 3]; FACES],
    normals: [Vec3; POSITIONS],
    normal_faces: [[u16; 3]; FACES],
    texels: [Rgb565; TEXELS],
    size: [u32; 2],
    /// The center of the box around it, and the distance of the farthest position from there.
    pub ball: [Scalar; 4],
}

impl Model {
    #[allow(clippy::large_stack_arrays)] // the compiler evaluates it, for a static
    pub const fn new() -> Self {
        Self {
            counts: Counts {
                positions: 0,
                faces: 0,
                edges: 0,
                uvs: 0,
                uv_faces: 0,
                normals: 0,
                normal_faces: 0,
                colors: 0,
            },
            positions: [Vec3::ZERO; POSITIONS],
            faces: [[0; 3]; FACES],
            uvs: [Vec2::from_bits([0; 2]); POSITIONS],
            uv_faces: [[0; 3]; FACES],
            normals: [Vec3::ZERO; POSITIONS],
            normal_faces: [[0; 3]; FACES],
            texels: [Rgb565::new(0, 0, 0); TEXELS],
            size: [0; 2],
            ball: [fx!(0); 4],
        }
    }

    /// Reads a model from OBJ text. One without normals gets smooth ones.
    ///
    /// # Errors
    ///
    /// Those of [`obj::parse`]: the line of a mistake, or a list that is too long.
    pub fn read(&mut self, text: &[u8]) -> Result<(), Error> {
        self.counts = Counts::default();
        let counts = obj::count(text)?;
        let buffers = Buffers {
            uvs: &mut self.uvs,
            uv_faces: &mut self.uv_faces,
            normals: &mut self.normals,
            normal_faces: &mut self.normal_faces,
            ..Buffers::new(&mut self.positions, &mut self.faces)
        };
        obj::parse(text, buffers)?;
        self.counts = counts;
        if counts.normals == 0 {
            let (positions, faces) = (
                &self.positions[..counts.positions],
                &self.faces[..counts.faces],
            );
            Mesh::new(positions, faces)?.with_smooth_normals(&mut self.normals)?;
            self.counts.normals = counts.positions;
        }
        let mesh = self.mesh()?;
        let bounds = mesh.bounds();
        let center = bounds.least() / fx!(2) + bounds.most() / fx!(2);
        let distances = mesh.positions().iter().map(|at| at.distance(center));
        self.ball = [
            center.x,
            center.y,
            center.z,
            distances.max().unwrap_or_default(),
        ];
        Ok(())
    }

    /// # Errors
    ///
    /// None for a model that was read.
    pub fn mesh(&self) -> Result<Mesh<'_>, Error> {
        let Counts {
            positions,
            faces,
            uvs,
            uv_faces,
            normals,
            normal_faces,
            ..
        } = self.counts;
        let mesh = Mesh::new(&self.positions[..positions], &self.faces[..faces])?;
        let mesh = mesh.with_normals(
            &self.normals[..normals],
            (normal_faces > 0).then_some(&self.normal_faces[..normal_faces]),
        )?;
        if uvs == 0 {
            return Ok(mesh);
        }
        mesh.with_uvs(
            &self.uvs[..uvs],
            (uv_faces > 0).then_some(&self.uv_faces[..uv_faces]),
        )
    }

    /// Reads a texture from bytes of red, green, blue and opacity.
    ///
    /// # Errors
    ///
    /// A side is not a power of two, or there are too many texels.
    pub fn read_texture(&mut self, bytes: &[u8], size: [u32; 2]) -> Result<(), Error> {
        // A texture refuses a list that is too short for it.
        let texels = self.texels.get_mut(..bytes.len() / 4).unwrap_or_default();
        for (texel, rgba) in texels.iter_mut().zip(bytes.chunks_exact(4)) {
            *texel = Rgb888::new(rgba[0], rgba[1], rgba[2]).into();
        }
        Texture::new(&*texels, size[0], size[1])?;
        self.size = size;
        Ok(())
    }

    /// # Errors
    ///
    /// None after a texture was read.
    pub fn texture(&self) -> Result<Texture<'_, Rgb565>, Error> {
        let [width, height] = self.size;
        Texture::new(&self.texels[..(width * height) as usize], width, height)
    }
}
