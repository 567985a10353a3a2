//! Reads glTF 2.0, text and binary.

use std::cell::Cell;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::{Source, View};
use gltf::image::Source as Picture;
use gltf::json::Index;
use gltf::json::validation::Checked;
use gltf::mesh::Mode;
use gltf::{Accessor, Document, Gltf, Node, Primitive, Semantic};

use super::files::Folder;
use super::mtl::byte;
use super::{Corner, Image, Material, Model, Smoothing, next};

/// Reads a glTF file: the triangles of its default scene, or of its first one.
pub fn read(bytes: &[u8], folder: Folder<'_>) -> Result<Model, String> {
    if let (true, Some(Ok(len))) = (
        bytes.starts_with(b"glTF"),
        bytes.get(8..12).map(TryInto::try_into),
    ) {
        let (is, needed) = (bytes.len(), u32::from_le_bytes(len));
        if (is as u64) < u64::from(needed) {
            return Err(format!(
                "byte {is}: it ends before the {needed} bytes that its header promises"
            ));
        }
    }
    let Gltf { document, blob } =
        Gltf::from_slice_without_validation(bytes).map_err(|error| error.to_string())?;
    let document = validated(document)?;
    let buffers = buffers(&document, blob, folder)?;
    let mut reader = Reader {
        buffers: &buffers,
        model: Model::default(),
        seen: vec![false; document.nodes().count()],
        folder: Folder {
            all: buffers.iter().map(Vec::len).sum(),
            ..folder
        },
        elements: Cell::new(0),
        read: Cell::new(0),
    };
    for buffer in document.buffers() {
        match buffer.source() {
            Source::Uri(uri) if !uri.starts_with("data:") => {
                reader.model.files.push(folder.beside(&decoded(uri)));
            }
            _ => {}
        }
    }
    reader.materials(&document, folder)?;
    let scene = document
        .default_scene()
        .or_else(|| document.scenes().next());
    match scene {
        Some(scene) => {
            for node in scene.nodes() {
                reader.node(&node, IDENTITY, MOST_LEVELS)?;
            }
        }
        // The file is a library of meshes without a scene.
        None => {
            for mesh in document.meshes() {
                for primitive in mesh.primitives() {
                    reader.primitive(&primitive, IDENTITY)?;
                }
            }
        }
    }
    Ok(reader.model)
}

/// Checks all indices and properties.
fn validated(document: Document) -> Result<Document, String> {
    let root = document.into_json();
    // The library's own check assumes that positions exist.
    let positions = Checked::Valid(Semantic::Positions);
    for primitive in root.meshes.iter().flat_map(|mesh| &mesh.primitives) {
        let accessor = primitive.attributes.get(&positions).map(Index::value);
        if let Some(at) = accessor.filter(|&at| at >= root.accessors.len()) {
            let count = root.accessors.len();
            return Err(format!(
                "accessor {at} does not exist: there are {count}, counted from 0"
            ));
        }
    }
    Document::from_json(root).map_err(|error| error.to_string())
}

/// The largest number of levels of nodes.
const MOST_LEVELS: usize = 1000;

/// A matrix as glTF stores it: a list of columns.
type Matrix = [[f64; 4]; 4];

const IDENTITY: Matrix = [
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
];

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    b.map(|column| [0, 1, 2, 3].map(|row| (0..4).map(|k| a[k][row] * column[k]).sum()))
}

/// The matrix for normals: the cofactors of the upper left 3 x 3, which are its transposed inverse times its
/// determinant; and the determinant.
fn normal_matrix(m: &Matrix) -> ([[f64; 3]; 3], f64) {
    let cofactors = [0, 1, 2].map(|column| {
        let (a, b) = (&m[(column + 1) % 3], &m[(column + 2) % 3]);
        [0, 1, 2].map(|row| {
            let (i, j) = ((row + 1) % 3, (row + 2) % 3);
            a[i] * b[j] - a[j] * b[i]
        })
    });
    let determinant = (0..3).map(|row| m[0][row] * cofactors[0][row]).sum();
    (cofactors, determinant)
}

/// Returns the contents of a URI, which is data itself, or names a file in `folder`.
fn contents(uri: &str, folder: Folder<'_>) -> Result<Vec<u8>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, text) = data
            .split_once(";base64,")
            .ok_or("a data URI is not in base64")?;
        return STANDARD
            .decode(text)
            .map_err(|error| format!("a data URI is not in base64: {error}"));
    }
    let path = folder.beside(&decoded(uri));
    folder
        .files
        .read(&path)
        .map_err(|error| format!("cannot read {}: {error}", path.display()))
}

/// A URI with its escapes, such as %20, decoded.
fn decoded(uri: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = uri.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let code = after
            .get(..2)
            .filter(|_| first == b'%')
            .and_then(|digits| u8::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok());
        bytes.push(code.unwrap_or(first));
        rest = if code.is_some() { &after[2..] } else { after };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn buffers(
    document: &Document,
    blob: Option<Vec<u8>>,
    folder: Folder<'_>,
) -> Result<Vec<Vec<u8>>, String> {
    let mut blob = blob;
    let mut buffers = Vec::new();
    for buffer in document.buffers() {
        let at = buffer.index();
        let bytes = match buffer.source() {
            Source::Bin => blob
                .take()
                .ok_or_else(|| format!("buffer {at}: the file has no binary part")),
            Source::Uri(uri) => {
                contents(uri, folder).map_err(|problem| format!("buffer {at}: {problem}"))
            }
        }?;
        if bytes.len() < buffer.length() {
            let (is, needed) = (bytes.len(), buffer.length());
            return Err(format!(
                "buffer {at}: it has {is} bytes, and needs {needed}"
            ));
        }
        buffers.push(bytes);
    }
    Ok(buffers)
}

struct Reader<'b> {
    buffers: &'b [Vec<u8>],
    model: Model,
    /// Which nodes have been added.
    seen: Vec<bool>,
    folder: Folder<'b>,
    /// How many values, and how many bytes of the buffers, have been read.
    elements: Cell<usize>,
    read: Cell<usize>,
}

/// Converts a linear component of a color to sRGB.
fn srgb(linear: f64) -> u8 {
    byte(if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    })
}

impl Reader<'_> {
    fn materials(&mut self, document: &Document, folder: Folder<'_>) -> Result<(), String> {
        for image in document.images() {
            let image = match image.source() {
                Picture::View { view, .. } => {
                    let name = image.name().unwrap_or("image");
                    Image::Bytes(
                        format!("{name}-{}", image.index()),
                        self.slice(&view)?.to_vec(),
                    )
                }
                Picture::Uri { uri, .. } if uri.starts_with("data:") => {
                    let data = contents(uri, folder)
                        .map_err(|problem| format!("image {}: {problem}", image.index()))?;
                    Image::Bytes(format!("image-{}", image.index()), data)
                }
                Picture::Uri { uri, .. } => Image::File(folder.beside(&decoded(uri))),
            };
            self.model.images.push(image);
        }
        for material in document.materials() {
            let surface = material.pbr_metallic_roughness();
            let [r, g, b, _] = surface.base_color_factor();
            let texture = surface.base_color_texture();
            self.model.materials.push(Material {
                color: [r, g, b].map(|x| srgb(x.into())),
                tint: [r, g, b].map(|x| srgb(x.into())),
                #[allow(clippy::cast_possible_truncation)] // an index in JSON text that was read into memory
                texture: texture.map(|texture| texture.texture().source().index() as u32),
                ..Material::new(material.name().unwrap_or_default().into())
            });
        }
        Ok(())
    }

    /// Adds a node and all nodes below it, which may be up to `depth` levels deep.
    fn node(&mut self, node: &Node<'_>, parent: Matrix, depth: usize) -> Result<(), String> {
        let index = node.index();
        let Some(depth) = depth.checked_sub(1) else {
            return Err(format!(
                "node {index}: it lies deeper than {MOST_LEVELS} levels"
            ));
        };
        if std::mem::replace(&mut self.seen[index], true) {
            return Err(format!("node {index}: it has two parents"));
        }
        let matrix = product(
            &parent,
            &node
                .transform()
                .matrix()
                .map(|column| column.map(f64::from)),
        );
        if let Some(mesh) = node.mesh() {
            for primitive in mesh.primitives() {
                self.primitive(&primitive, matrix)
                    .map_err(|problem| format!("mesh {}: {problem}", mesh.index()))?;
            }
        }
        for child in node.children() {
            self.node(&child, matrix, depth)?;
        }
        Ok(())
    }

    fn primitive(&mut self, primitive: &Primitive<'_>, matrix: Matrix) -> Result<(), String> {
        if matches!(
            primitive.mode(),
            Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip
        ) {
            return Ok(());
        }
        let Some(positions) = primitive.get(&Semantic::Positions) else {
            return Ok(());
        };
        let first = [
            next(&self.model.positions)?,
            next(&self.model.uvs)?,
            next(&self.model.normals)?,
            next(&self.model.colors)?,
        ];
        let positions = self.floats::<3>(&positions)?;
        let (normals, determinant) = normal_matrix(&matrix);
        self.model.positions.extend(positions.iter().map(|p| {
            [0, 1, 2].map(|row| matrix[3][row] + (0..3).map(|k| matrix[k][row] * p[k]).sum::<f64>())
        }));
        let count = positions.len();
        let attribute = |semantic: Semantic| {
            primitive
                .get(&semantic)
                .filter(|accessor| accessor.count() == count)
        };
        let has_normals = attribute(Semantic::Normals);
        if let Some(accessor) = &has_normals {
            let list = self.floats::<3>(accessor)?;
            self.model.normals.extend(list.iter().map(|n| {
                let turned =
                    [0, 1, 2].map(|row| (0..3).map(|k| normals[k][row] * n[k]).sum::<f64>());
                turned.map(|x| x * determinant.signum())
            }));
        }
        let material = primitive.material();
        let set = material
            .pbr_metallic_roughness()
            .base_color_texture()
            .map_or(0, |texture| texture.tex_coord());
        let has_uvs = attribute(Semantic::TexCoords(set));
        if let Some(accessor) = &has_uvs {
            let list = self.floats::<2>(accessor)?;
            self.model.uvs.extend(list);
        }
        let has_colors = attribute(Semantic::Colors(0));
        if let Some(accessor) = &has_colors {
            let list = self.floats::<3>(accessor)?;
            self.model
                .colors
                .extend(list.iter().map(|color| color.map(srgb)));
        }
        let indices = match primitive.indices() {
            Some(accessor) => self.indices(&accessor, count)?,
            None => (0..).take(count).collect(),
        };
        #[allow(clippy::cast_possible_truncation)] // as above
        let material = material.index().map(|index| index as u32);
        let mut triangle = |[a, b, c]: [u32; 3]| {
            // A mirror image reverses the winding of triangles.
            let triangle = if determinant < 0.0 {
                [a, c, b]
            } else {
                [a, b, c]
            };
            let mut corners = triangle.map(|index| Corner {
                position: first[0] + index,
                uv: has_uvs.as_ref().map(|_| first[1] + index),
                normal: has_normals.as_ref().map(|_| first[2] + index),
                color: has_colors.as_ref().map(|_| first[3] + index),
            });
            self.model.polygon(&mut corners, material, Smoothing::Angle)
        };
        match primitive.mode() {
            Mode::TriangleStrip => {
                for (at, corners) in indices.windows(3).enumerate() {
                    let [a, b, c] = [corners[0], corners[1], corners[2]];
                    triangle(if at % 2 == 0 { [a, b, c] } else { [b, a, c] })?;
                }
            }
            Mode::TriangleFan => {
                for corners in indices.get(1..).unwrap_or_default().windows(2) {
                    triangle([indices[0], corners[0], corners[1]])?;
                }
            }
            _ => {
                for corners in indices.chunks_exact(3) {
                    triangle([corners[0], corners[1], corners[2]])?;
                }
            }
        }
        Ok(())
    }

    fn indices(&self, accessor: &Accessor<'_>, count: usize) -> Result<Vec<u32>, String> {
        let list = self.floats::<1>(accessor)?;
        list.into_iter()
            .map(|[index]| {
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                // a whole number of 32 bits
                let whole = index as u32;
                if (whole as usize) < count {
                    Ok(whole)
                } else {
                    Err(format!(
                        "vertex {index} does not exist: there are {count}, counted from 0"
                    ))
                }
            })
            .collect()
    }

    fn slice(&self, view: &View<'_>) -> Result<&[u8], String> {
        let buffer = &self.buffers[view.buffer().index()];
        let end = view.offset().checked_add(view.length());
        end.and_then(|end| buffer.get(view.offset()..end))
            .ok_or_else(|| {
                let (at, len) = (view.index(), buffer.len());
                format!("buffer view {at} leaves its buffer of {len} bytes")
            })
    }

    /// The first `N` components of each value of an accessor, as numbers.
    fn floats<const N: usize>(&self, accessor: &Accessor<'_>) -> Result<Vec<[f64; N]>, String> {
        let at = accessor.index();
        let components = match accessor.dimensions() {
            Dimensions::Scalar => 1,
            Dimensions::Vec2 => 2,
            Dimensions::Vec3 => 3,
            Dimensions::Vec4 => 4,
            _ => 0,
        };
        if components < N {
            return Err(format!(
                "accessor {at}: it has {components} components a value, and needs {N}"
            ));
        }
        let kind = accessor.data_type();
        let value = |bytes: &[u8]| -> [f64; N] {
            let mut value = [0.0; N];
            for (component, bytes) in value.iter_mut().zip(bytes.chunks_exact(kind.size())) {
                *component = number(kind, bytes, accessor.normalized());
            }
            self.elements.set(self.elements.get() + 1);
            self.read.set(self.read.get() + bytes.len());
            self.folder.progress(self.elements.get(), self.read.get());
            value
        };
        let size = components * kind.size();
        let mut values = match accessor.view() {
            Some(view) => {
                let stride = view.stride().unwrap_or(size);
                rows(
                    self.slice(&view)?,
                    accessor.offset(),
                    stride,
                    size,
                    accessor.count(),
                )
                .ok_or_else(|| format!("accessor {at} leaves its buffer view"))?
                .map(value)
                .collect()
            }
            // Values without bytes of their own are zero. But a short file must not be able to claim all memory.
            None if accessor.sparse().is_some() && accessor.count() <= 1 << 24 => {
                vec![[0.0; N]; accessor.count()]
            }
            None if accessor.sparse().is_some() => {
                let count = accessor.count();
                return Err(format!(
                    "accessor {at} has {count} values but no bytes: at most 16777216 such values are read"
                ));
            }
            None => return Err(format!("accessor {at} has no values")),
        };
        if let Some(sparse) = accessor.sparse() {
            let leaves = || format!("the sparse values of accessor {at} leave their buffer view");
            let (places, changed) = (sparse.indices(), sparse.values());
            let kind = match places.index_type() {
                gltf::accessor::sparse::IndexType::U8 => DataType::U8,
                gltf::accessor::sparse::IndexType::U16 => DataType::U16,
                gltf::accessor::sparse::IndexType::U32 => DataType::U32,
            };
            let (place_view, value_view) = (places.view(), changed.view());
            let indices = rows(
                self.slice(&place_view)?,
                places.offset(),
                kind.size(),
                kind.size(),
                sparse.count(),
            );
            let changed = rows(
                self.slice(&value_view)?,
                changed.offset(),
                size,
                size,
                sparse.count(),
            );
            for (index, bytes) in indices.ok_or_else(leaves)?.zip(changed.ok_or_else(leaves)?) {
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                // a whole number of 32 bits
                let index = number(kind, index, false) as usize;
                *values.get_mut(index).ok_or_else(leaves)? = value(bytes);
            }
        }
        Ok(values)
    }
}

/// Splits `bytes` from `offset` on into `count` values of `size` bytes that begin every `stride` bytes; `None` if they
/// do not fit.
fn rows(
    bytes: &[u8],
    offset: usize,
    stride: usize,
    size: usize,
    count: usize,
) -> Option<impl Iterator<Item = &[u8]>> {
    let end = match count.checked_sub(1) {
        Some(last) => offset
            .checked_add(stride.checked_mul(last)?)?
            .checked_add(size)?,
        None => offset,
    };
    let bytes = bytes.get(offset..end)?;
    Some((0..count).map(move |at| &bytes[at * stride..][..size]))
}

/// A component of a value; `normalized` integers stand for fractions.
fn number(kind: DataType, bytes: &[u8], normalized: bool) -> f64 {
    let pair = || [bytes[0], bytes[1]];
    let four = || [bytes[0], bytes[1], bytes[2], bytes[3]];
    let (value, most) = match kind {
        DataType::I8 => (i8::from_le_bytes([bytes[0]]).into(), 127.0),
        DataType::U8 => (bytes[0].into(), 255.0),
        DataType::I16 => (i16::from_le_bytes(pair()).into(), 32_767.0),
        DataType::U16 => (u16::from_le_bytes(pair()).into(), 65_535.0),
        DataType::U32 => (u32::from_le_bytes(four()).into(), f64::from(u32::MAX)),
        DataType::F32 => (f32::from_le_bytes(four()).into(), 1.0),
    };
    if normalized {
        f64::max(value / most, -1.0)
    } else {
        value
    }
}
