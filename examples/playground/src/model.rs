//! The user's own model, in memory of a fixed size.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::mesh::{Material, Part};
use fixel::prelude::*;

/// Most triangles, and most elements of any other list.
pub const FACES: usize = 65_536;
/// Most texels along a side, and in all.
pub const SIDE: u32 = 512;
const TEXELS: usize = (SIDE * SIDE) as usize;

/// How a macro is called for a file. One that has no room is left out.
pub type Call = heapless::String<512>;

/// A list in memory with room for the longest one.
struct List<T> {
    elements: [T; FACES],
    len: usize,
}

impl<T: Copy> List<T> {
    const fn new(element: T) -> Self {
        Self {
            elements: [element; FACES],
            len: 0,
        }
    }

    /// Takes a list from the bytes.
    fn read<const SIZE: usize>(&mut self, bytes: &mut &[u8], element: impl Fn([u8; SIZE]) -> T) {
        self.len = 0;
        for (to, &from) in self.elements.iter_mut().zip(list(bytes)) {
            *to = element(from);
            self.len += 1;
        }
    }

    fn elements(&self) -> &[T] {
        &self.elements[..self.len]
    }

    /// The elements, if there are any.
    fn some(&self) -> Option<&[T]> {
        (self.len > 0).then(|| self.elements())
    }
}

/// What gives a model its colors: a texture, its materials, its vertices, or vertices that tint one of the former.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    Plain,
    Texture,
    TintedTexture,
    Parts,
    TintedParts,
    Corners,
}

/// A mesh and its texture.
pub struct Model {
    positions: List<Vec3>,
    faces: List<[u16; 3]>,
    uvs: List<Vec2>,
    uv_faces: List<[u16; 3]>,
    normals: List<Vec3>,
    normal_faces: List<[u16; 3]>,
    colors: List<Rgb888>,
    color_faces: List<[u16; 3]>,
    parts: heapless::Vec<Part<'static>, FACES>,
    /// Whether the file has texture coordinates for all faces.
    pub has_uvs: bool,
    texels: [Rgb565; TEXELS],
    size: [u32; 2],
    /// What stands in the parentheses of `include_mesh!` and `include_texture!`; empty if there is no file.
    pub calls: [Call; 2],
    /// The center of the box around it, and the distance of the farthest position from there.
    pub ball: [Scalar; 4],
}

impl Model {
    #[allow(clippy::large_stack_arrays)] // the compiler evaluates it, for a static
    pub const fn new() -> Self {
        Self {
            positions: List::new(Vec3::ZERO),
            faces: List::new([0; 3]),
            uvs: List::new(Vec2::from_bits([0; 2])),
            uv_faces: List::new([0; 3]),
            normals: List::new(Vec3::ZERO),
            normal_faces: List::new([0; 3]),
            colors: List::new(Rgb888::new(0, 0, 0)),
            color_faces: List::new([0; 3]),
            parts: heapless::Vec::new(),
            has_uvs: false,
            texels: [Rgb565::new(0, 0, 0); TEXELS],
            size: [0; 2],
            calls: [Call::new(), Call::new()],
            ball: [fx!(0); 4],
        }
    }

    /// Reads a model from the bytes that the reader's module made.
    ///
    /// # Errors
    ///
    /// Those of a mesh: the reader makes none of them.
    pub fn read(&mut self, mut bytes: &[u8]) -> Result<(), Error> {
        let bytes = &mut bytes;
        self.positions.read(bytes, vector);
        self.faces.read(bytes, indices);
        self.uvs
            .read(bytes, |list: [u8; 8]| Vec2::from_bits(numbers(list)));
        self.uv_faces.read(bytes, indices);
        self.normals.read(bytes, vector);
        self.normal_faces.read(bytes, indices);
        self.colors
            .read(bytes, |[red, green, blue]| Rgb888::new(red, green, blue));
        self.color_faces.read(bytes, indices);
        self.parts.clear();
        for &bytes in list(bytes) {
            // There is room: a model has at most as many parts as triangles.
            let _ = self.parts.push(part(bytes));
        }
        self.has_uvs = bytes.split_off_first() == Some(&1);
        self.calls[0] = call(bytes);

        let mesh = self.mesh()?;
        let bounds = mesh.bounds();
        let center = bounds.least / fx!(2) + bounds.most / fx!(2);
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
        let mesh = Mesh::new(self.positions.elements(), self.faces.elements())?
            .with_normals(self.normals.elements(), self.normal_faces.some())?
            .with_uvs(self.uvs.elements(), self.uv_faces.some())?;
        match self.colors.some() {
            Some(colors) => mesh.with_colors(colors, self.color_faces.some()),
            None => Ok(mesh),
        }
    }

    /// What gives the model its colors.
    pub fn look(&self) -> Look {
        match (self.calls[1].is_empty(), self.colors.len, self.parts.len()) {
            (false, 0, _) => Look::Texture,
            (false, ..) => Look::TintedTexture,
            (true, 0, 0) => Look::Plain,
            (true, 0, _) => Look::Parts,
            (true, _, 0) => Look::Corners,
            (true, ..) => Look::TintedParts,
        }
    }

    /// The parts with the colors of their materials.
    pub fn parts(&self) -> &[Part<'static>] {
        &self.parts
    }

    /// Reads a texture from bytes of red, green, blue and opacity, and the call after them.
    ///
    /// # Errors
    ///
    /// A side is not a power of two, or there are too many texels.
    pub fn read_texture(&mut self, bytes: &[u8], size: [u32; 2]) -> Result<(), Error> {
        let count = size[0].saturating_mul(size[1]) as usize;
        let (pixels, rest) = bytes.split_at(bytes.len().min(count.saturating_mul(4)));
        // A texture refuses a list that is too short for it.
        let texels = self.texels.get_mut(..pixels.len() / 4).unwrap_or_default();
        for (texel, &[red, green, blue, _]) in texels.iter_mut().zip(pixels.as_chunks().0) {
            *texel = Rgb888::new(red, green, blue).into();
        }
        Texture::new(&*texels, size[0], size[1])?;
        self.size = size;
        self.calls[1] = call(rest);
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

/// Takes a list of elements of `SIZE` bytes, after their number, from the bytes. There may be fewer.
fn list<'a, const SIZE: usize>(bytes: &mut &'a [u8]) -> &'a [[u8; SIZE]] {
    let count = bytes.split_off(..4).and_then(<[u8]>::first_chunk);
    let count = count.map_or(0, |&count| u32::from_le_bytes(count) as usize);
    let most = bytes.len();
    let list = bytes.split_off(..most.min(count.saturating_mul(SIZE)));
    list.unwrap_or_default().as_chunks().0
}

/// Numbers in little-endian bytes.
fn numbers<const SIZE: usize, const N: usize>(bytes: [u8; SIZE]) -> [i32; N] {
    let mut numbers = bytes.as_chunks().0.iter().copied().map(i32::from_le_bytes);
    core::array::from_fn(|_| numbers.next().unwrap_or_default())
}

fn vector(bytes: [u8; 12]) -> Vec3 {
    Vec3::from_bits(numbers(bytes))
}

/// The indices of a face in little-endian bytes.
fn indices([a, b, c, d, e, f]: [u8; 6]) -> [u16; 3] {
    [[a, b], [c, d], [e, f]].map(u16::from_le_bytes)
}

/// A run of faces: the first one, the one after the last, and their color.
fn part(bytes: [u8; 12]) -> Part<'static> {
    let [start, end, color] = numbers(bytes).map(i32::cast_unsigned);
    let [_, red, green, blue] = color.to_be_bytes();
    let color = Rgb888::new(red, green, blue);
    Part::new(start as usize..end as usize, Material::new(color))
}

fn call(bytes: &[u8]) -> Call {
    let text = core::str::from_utf8(bytes).unwrap_or_default();
    text.try_into().unwrap_or_default()
}
