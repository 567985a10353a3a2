//! Reads glTF 2.0 files, both text and binary.

mod accessor;
mod matrix;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::Value;

use matrix::{IDENTITY, Matrix, blend, local, matrix, normal_matrix, product};

use crate::files::Folder;
use crate::mtl::byte;
use crate::{Alpha, Corner, Image, Material, Model, Smoothing, next};

/// Extensions that compress the geometry, each with the name of its method. A file that requires one of these
/// extensions cannot be read.
const COMPRESSED: [(&str, &str); 3] = [
    ("KHR_draco_mesh_compression", "Draco"),
    ("EXT_meshopt_compression", "meshopt"),
    ("KHR_meshopt_compression", "meshopt"),
];

/// Extensions that are read, or that change nothing that is drawn.
const READ: [&str; 7] = [
    "KHR_mesh_quantization",
    "KHR_materials_unlit",
    "KHR_materials_emissive_strength",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_texture_transform",
    "EXT_texture_webp",
    "KHR_xmp_json_ld",
];

/// An accessor without bytes, with values of 0, may have at most this many values. All nodes together may have at most
/// this many vertices, or as many as the file has bytes. Without these limits, a short file could claim all memory,
/// because nodes can share a mesh.
const MOST: usize = 1 << 20;

/// Reads the triangles of a glTF file's default scene. Without a default scene, reads its first scene.
pub fn read(bytes: &[u8], folder: Folder<'_>) -> Result<Model, String> {
    let (json, binary) = parts(bytes)?;
    let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
    let root: Value =
        serde_json::from_slice(json).map_err(|error| format!("its JSON text: {error}"))?;
    let version = root["asset"]["version"].as_str().unwrap_or("2.0");
    if version.starts_with('1') || root["meshes"].is_object() {
        return Err("it is glTF 1.0: only glTF 2.0 can be read".into());
    }
    for name in names(&root["extensionsRequired"]) {
        if let Some((_, compression)) = COMPRESSED.iter().find(|(extension, _)| *extension == name)
        {
            return Err(format!(
                "its meshes are compressed with {compression} ({name}): save it without compression"
            ));
        }
    }
    let mut reader = Reader {
        root: &root,
        buffers: Vec::new(),
        model: Model::default(),
        folder,
        read: 0,
    };
    for name in names(&root["extensionsUsed"]).filter(|name| !READ.contains(name)) {
        reader.model.notes.left_out(name);
    }
    for name in ["animations", "cameras"] {
        if !list(&root, name).is_empty() {
            reader.model.notes.left_out(name);
        }
    }
    reader.buffers(binary);
    reader.images();
    for material in list(&root, "materials") {
        let material = reader.material(material);
        reader.model.materials.push(material);
    }
    reader.scene();
    Ok(reader.model)
}

/// The JSON text of a file and, if the file is binary, the buffer in it.
fn parts(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    let word = |at: usize| Some(u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?) as usize);
    if !bytes.starts_with(b"glTF") {
        return Ok((bytes, None));
    }
    if word(4) == Some(1) {
        return Err("it is glTF 1.0: only glTF 2.0 can be read".into());
    }
    if let Some(needed) = word(8).filter(|&needed| needed > bytes.len()) {
        let is = bytes.len();
        return Err(format!(
            "byte {is}: it ends before the {needed} bytes that its header promises"
        ));
    }
    let (mut at, mut json, mut binary) = (12, None, None);
    while let (Some(length), Some(kind)) = (word(at), word(at + 4)) {
        let chunk = bytes.get(at + 8..).and_then(|rest| rest.get(..length));
        let chunk = chunk.ok_or_else(|| {
            format!("byte {at}: a part of {length} bytes reaches beyond the end of the file")
        })?;
        match &kind.to_le_bytes()[..4] {
            b"JSON" => json = Some(chunk),
            b"BIN\0" => binary = Some(chunk),
            _ => {}
        }
        at += 8 + length;
    }
    Ok((json.ok_or("it has no JSON text")?, binary))
}

/// The elements of the list `name` in an object; empty if there is no such list.
fn list<'v>(object: &'v Value, name: &str) -> &'v [Value] {
    object[name].as_array().map_or(&[], Vec::as_slice)
}

/// The strings of a list.
fn names(list: &Value) -> impl Iterator<Item = &str> {
    list.as_array()
        .into_iter()
        .flatten()
        .filter_map(Value::as_str)
}

/// Reads a whole number: a number of elements or bytes, or an index.
fn whole(value: &Value) -> Option<usize> {
    // Some programs write 3 as 3.0.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // checked
    let float = value
        .as_f64()
        .filter(|x| x.fract() == 0.0 && (0.0..9e15).contains(x))
        .map(|x| x as usize);
    float
}

/// The numbers of a list; `None` if the list does not have `N` numbers.
fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let numbers: Vec<f64> = value.as_array()?.iter().filter_map(Value::as_f64).collect();
    numbers.try_into().ok()
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

/// The bytes of a `data:` URI; `None` if the URI names a file.
fn data(uri: &str) -> Option<Result<Vec<u8>, String>> {
    let data = uri.strip_prefix("data:")?;
    Some(match data.split_once(',') {
        Some((kind, text)) if kind.ends_with(";base64") => STANDARD
            .decode(text)
            .map_err(|error| format!("a data URI is not in base64: {error}")),
        Some((_, text)) => Ok(decoded(text).into_bytes()),
        None => Err("a data URI has no comma".into()),
    })
}

/// Converts a linear component of a color to sRGB.
fn srgb(linear: f64) -> u8 {
    byte(if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    })
}

struct Reader<'a> {
    root: &'a Value,
    buffers: Vec<Vec<u8>>,
    model: Model,
    folder: Folder<'a>,
    /// How many bytes of the buffers have been read.
    read: usize,
}

impl<'a> Reader<'a> {
    /// The element with the index `at` in the file's list `of`.
    fn item(&self, of: &str, at: usize) -> Result<&'a Value, String> {
        let items = list(self.root, of);
        items.get(at).ok_or_else(|| {
            let one = if of == "meshes" {
                "mesh"
            } else {
                of.trim_end_matches('s')
            };
            format!(
                "{one} {at} does not exist: there are {}, counted from 0",
                items.len()
            )
        })
    }

    fn buffers(&mut self, binary: Option<&[u8]>) {
        for (at, buffer) in list(self.root, "buffers").iter().enumerate() {
            let bytes = match buffer["uri"].as_str() {
                None => binary
                    .map(<[u8]>::to_vec)
                    .ok_or_else(|| "the file has no binary part".into()),
                Some(uri) => data(uri).unwrap_or_else(|| {
                    let path = self.folder.beside(&decoded(uri));
                    self.model.files.push(path.clone());
                    let read = self.folder.files.read(&path);
                    read.map_err(|error| format!("cannot read {}: {error}", path.display()))
                }),
            };
            let needed = whole(&buffer["byteLength"]).unwrap_or(0);
            let problem = match &bytes {
                Ok(bytes) if bytes.len() >= needed => None,
                Ok(bytes) => Some(format!("it has {} bytes, and needs {needed}", bytes.len())),
                Err(problem) => Some(problem.clone()),
            };
            if let Some(problem) = problem {
                self.model.notes.add(format!("buffer {at}: {problem}"));
            }
            self.buffers.push(bytes.unwrap_or_default());
        }
        self.folder.all = self.buffers.iter().map(Vec::len).sum();
    }

    fn images(&mut self) {
        for (at, image) in list(self.root, "images").iter().enumerate() {
            let name = format!("{}-{at}", image["name"].as_str().unwrap_or("image"));
            let bytes = match (image["uri"].as_str(), whole(&image["bufferView"])) {
                (Some(uri), _) => match data(uri) {
                    None => {
                        let path = self.folder.beside(&decoded(uri));
                        self.model.images.push(Image::File(path));
                        continue;
                    }
                    Some(bytes) => bytes,
                },
                (None, Some(view)) => self.view(view).map(|(bytes, _)| bytes.to_vec()),
                (None, None) => Err("it names no file".into()),
            };
            if let Err(problem) = &bytes {
                self.model.notes.add(format!("image {at}: {problem}"));
            }
            self.model
                .images
                .push(Image::Bytes(name, bytes.unwrap_or_default()));
        }
    }

    fn material(&mut self, material: &Value) -> Material {
        let glossy = &material["extensions"]["KHR_materials_pbrSpecularGlossiness"];
        let metallic = &material["pbrMetallicRoughness"];
        let (factor, texture) = surface(material);
        let [r, g, b, alpha] = numbers(factor).unwrap_or([1.0; 4]);
        let color = [r, g, b].map(srgb);
        let strength =
            &material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"];
        let strength = strength.as_f64().unwrap_or(1.0);
        let emission = numbers(&material["emissiveFactor"]).unwrap_or([0.0; 3]);
        for (map, name) in [
            (&material["normalTexture"], "normal maps"),
            (&material["occlusionTexture"], "occlusion maps"),
            (&material["emissiveTexture"], "emissive textures"),
            (
                &metallic["metallicRoughnessTexture"],
                "metallic and rough surfaces",
            ),
            (
                &glossy["specularGlossinessTexture"],
                "specular and glossy surfaces",
            ),
        ] {
            if map.is_object() {
                self.model.notes.left_out(name);
            }
        }
        let mode = material["alphaMode"].as_str().unwrap_or("OPAQUE");
        let mut new = Material {
            color,
            tint: color,
            emission: emission.map(|x: f64| srgb(x * strength)),
            opacity: if mode == "BLEND" {
                alpha.clamp(0.0, 1.0)
            } else {
                1.0
            },
            alpha: match mode {
                "MASK" => {
                    let cutoff = material["alphaCutoff"].as_f64().unwrap_or(0.5);
                    // The cutoff applies to the product of the texture's alpha and the factor's alpha. The cutoff
                    // divided by the factor applies to the texture's alpha alone.
                    Alpha::Cut(if alpha > 0.0 {
                        byte(cutoff / alpha)
                    } else {
                        255
                    })
                }
                "BLEND" => Alpha::Blended,
                _ => Alpha::Ignored,
            },
            two_sided: material["doubleSided"].as_bool().unwrap_or(false),
            ..Material::new(material["name"].as_str().unwrap_or_default().into())
        };
        let texture = whole(&texture["index"]).map(|at| self.texture(at, &mut new));
        if let Some(Err(problem)) = texture {
            self.model.notes.add(problem);
        }
        new
    }

    /// Sets the image of a material, and whether the texture is clamped.
    fn texture(&mut self, at: usize, material: &mut Material) -> Result<(), String> {
        let texture = self.item("textures", at)?;
        let webp = whole(&texture["extensions"]["EXT_texture_webp"]["source"]);
        if let Some(image) = webp.or(whole(&texture["source"])) {
            self.item("images", image)?;
            material.texture = u32::try_from(image).ok();
        }
        if let Some(sampler) = whole(&texture["sampler"]) {
            let sampler = self.item("samplers", sampler)?;
            let wraps = ["wrapS", "wrapT"].map(|wrap| whole(&sampler[wrap]));
            material.clamp = wraps.map(|wrap| wrap == Some(33071));
            if wraps.contains(&Some(33648)) {
                self.model.notes.left_out("mirrored repeats of textures");
            }
        }
        Ok(())
    }

    /// Adds the meshes of the default scene. Without a default scene, adds the meshes of the first scene. Without
    /// scenes, adds all meshes.
    fn scene(&mut self) {
        let scenes = list(self.root, "scenes");
        let scene = whole(&self.root["scene"])
            .and_then(|at| scenes.get(at))
            .or(scenes.first());
        let Some(scene) = scene else {
            for at in 0..list(self.root, "meshes").len() {
                self.mesh(at, &Value::Null, &[], IDENTITY);
            }
            return;
        };
        let nodes = list(self.root, "nodes");
        let mut places: Vec<Option<Matrix>> = vec![None; nodes.len()];
        let mut order = Vec::new();
        let children = |of: &'a Value, name, parent: Matrix| {
            let children = list(of, name).iter().rev().filter_map(whole);
            children.map(move |child| (child, parent))
        };
        let mut next: Vec<(usize, Matrix)> = children(scene, "nodes", IDENTITY).collect();
        while let Some((at, parent)) = next.pop() {
            let Some(place) = places.get_mut(at) else {
                self.model
                    .notes
                    .add("a node that does not exist is left out");
                continue;
            };
            if place.is_some() {
                self.model
                    .notes
                    .add("a node with two parents is drawn once");
                continue;
            }
            let matrix = *place.insert(product(&parent, &local(&nodes[at])));
            order.push(at);
            next.extend(children(&nodes[at], "children", matrix));
        }
        for at in order {
            if let Some(mesh) = whole(&nodes[at]["mesh"]) {
                self.mesh(mesh, &nodes[at], &places, places[at].unwrap_or(IDENTITY));
            }
        }
    }

    /// Adds a mesh of a node. `places` has the matrices of all nodes, because skins need them.
    fn mesh(&mut self, at: usize, node: &Value, places: &[Option<Matrix>], matrix: Matrix) {
        let mut add = || {
            let mesh = self.item("meshes", at)?;
            let name = mesh["name"].as_str().or(node["name"].as_str());
            if let Some(name) = name.filter(|name| !name.is_empty()) {
                self.model.begin_object(name);
            }
            let joints = match whole(&node["skin"]) {
                Some(skin) => self.joints(skin, places)?,
                None => Vec::new(),
            };
            let weights = [&node["weights"], &mesh["weights"]]
                .into_iter()
                .find_map(Value::as_array);
            let weights: Vec<f64> = weights
                .into_iter()
                .flatten()
                .map(|x| x.as_f64().unwrap_or(0.0))
                .collect();
            for primitive in list(mesh, "primitives") {
                self.primitive(primitive, &weights, &joints, matrix)?;
            }
            Ok(())
        };
        let added: Result<(), String> = add();
        if let Err(problem) = added {
            self.model
                .notes
                .add(format!("mesh {at}: a part is left out: {problem}"));
        }
    }

    /// The matrices of a skin's joints, at rest.
    fn joints(&mut self, skin: usize, places: &[Option<Matrix>]) -> Result<Vec<Matrix>, String> {
        let skin = self.item("skins", skin)?;
        let inverses = match whole(&skin["inverseBindMatrices"]) {
            Some(at) => self.values::<16>(at)?,
            None => Vec::new(),
        };
        let joints = list(skin, "joints").iter().enumerate().map(|(at, joint)| {
            let place = whole(joint).and_then(|joint| *places.get(joint)?);
            let inverse = inverses
                .get(at)
                .map_or(IDENTITY, |numbers| matrix(*numbers));
            product(&place.unwrap_or(IDENTITY), &inverse)
        });
        Ok(joints.collect())
    }

    fn primitive(
        &mut self,
        primitive: &Value,
        weights: &[f64],
        joints: &[Matrix],
        node: Matrix,
    ) -> Result<(), String> {
        let mode = whole(&primitive["mode"]).unwrap_or(4);
        if mode < 4 {
            self.model
                .notes
                .left_out(if mode == 0 { "points" } else { "lines" });
            return Ok(());
        }
        let material = whole(&primitive["material"]);
        let material = material.filter(|&at| at < self.model.materials.len());
        let vertices = self.vertices(primitive, material, weights, joints, node)?;
        let indices = match whole(&primitive["indices"]) {
            Some(at) => self
                .values::<1>(at)?
                .into_iter()
                .map(|[index]| index)
                .collect(),
            #[allow(clippy::cast_precision_loss)] // below 2^53
            None => (0..vertices.count)
                .map(|at| at as f64)
                .collect::<Vec<f64>>(),
        };
        let material = material.and_then(|at| u32::try_from(at).ok());
        let mut triangle = |[a, b, c]: [f64; 3]| {
            // A mirror image reverses the winding of triangles.
            let triangle = if vertices.mirrored {
                [a, c, b]
            } else {
                [a, b, c]
            };
            let mut corners = triangle.map(|index| vertices.corner(index));
            self.model.polygon(&mut corners, material, Smoothing::Angle)
        };
        match mode {
            5 => {
                for (at, corners) in indices.windows(3).enumerate() {
                    let [a, b, c] = [corners[0], corners[1], corners[2]];
                    triangle(if at % 2 == 0 { [a, b, c] } else { [b, a, c] })?;
                }
            }
            6 => {
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

    /// Adds the vertices of a primitive. The vertices are morphed by `weights`, and then moved by their joints or,
    /// without joints, by the matrix of the node.
    fn vertices(
        &mut self,
        primitive: &Value,
        material: Option<usize>,
        weights: &[f64],
        joints: &[Matrix],
        node: Matrix,
    ) -> Result<Vertices, String> {
        let attributes = &primitive["attributes"];
        let positions = whole(&attributes["POSITION"]).ok_or("it has no positions")?;
        let mut positions = self.values::<3>(positions)?;
        let count = positions.len();
        let (all, bytes) = (self.model.positions.len() + count, self.folder.all);
        if all > MOST.max(bytes) {
            return Err(format!(
                "with it, there are {all} vertices: at most {MOST} are read"
            ));
        }
        let mut normals = self.attribute::<3>(&attributes["NORMAL"], count)?;
        for (target, &weight) in list(primitive, "targets").iter().zip(weights) {
            for (name, values) in [("POSITION", &mut positions), ("NORMAL", &mut normals)] {
                let moved = self.attribute::<3>(&target[name], count)?;
                for (value, moved) in values.iter_mut().zip(moved) {
                    *value = [0, 1, 2].map(|i| value[i] + weight * moved[i]);
                }
            }
        }
        let (_, texture) = surface(match material {
            Some(at) => &list(self.root, "materials")[at],
            None => &Value::Null,
        });
        let uvs = self.uvs(attributes, texture, count)?;
        let colors = self.attribute::<3>(&attributes["COLOR_0"], count)?;
        let shares = match joints {
            [] => Vec::new(),
            _ => self.attribute::<4>(&attributes["WEIGHTS_0"], count)?,
        };
        let bones = self.attribute::<4>(&attributes["JOINTS_0"], count)?;
        let bones: Vec<([f64; 4], [f64; 4])> = bones.into_iter().zip(shares).collect();

        let model = &mut self.model;
        let mut vertices = Vertices {
            count,
            position: next(&model.positions)?,
            uv: (!uvs.is_empty()).then_some(next(&model.uvs)?),
            normal: (!normals.is_empty()).then_some(next(&model.normals)?),
            color: (!colors.is_empty()).then_some(next(&model.colors)?),
            mirrored: normal_matrix(&node).1 < 0.0,
        };
        for (at, p) in positions.iter().enumerate() {
            let matrix = bones
                .get(at)
                .and_then(|bone| blend(joints, bone))
                .unwrap_or(node);
            model
                .positions
                .push([0, 1, 2].map(|row| {
                    matrix[3][row] + (0..3).map(|k| matrix[k][row] * p[k]).sum::<f64>()
                }));
            if let Some(n) = normals.get(at) {
                let (matrix, determinant) = normal_matrix(&matrix);
                vertices.mirrored = determinant < 0.0;
                let normal =
                    [0, 1, 2].map(|row| (0..3).map(|k| matrix[k][row] * n[k]).sum::<f64>());
                model.normals.push(normal.map(|x| x * determinant.signum()));
            }
        }
        model.uvs.extend(uvs);
        model
            .colors
            .extend(colors.iter().map(|color| color.map(srgb)));
        Ok(vertices)
    }

    /// The texture coordinates of a primitive's vertices.
    fn uvs(
        &mut self,
        attributes: &Value,
        texture: &Value,
        count: usize,
    ) -> Result<Vec<[f64; 2]>, String> {
        let transform = &texture["extensions"]["KHR_texture_transform"];
        let set = whole(&transform["texCoord"])
            .or(whole(&texture["texCoord"]))
            .unwrap_or(0);
        let mut uvs = self.attribute::<2>(&attributes[format!("TEXCOORD_{set}")], count)?;
        if transform.is_object() {
            let [x, y] = numbers(&transform["offset"]).unwrap_or([0.0; 2]);
            let [width, height] = numbers(&transform["scale"]).unwrap_or([1.0; 2]);
            let (sin, cos) = transform["rotation"].as_f64().unwrap_or(0.0).sin_cos();
            for uv in &mut uvs {
                let [u, v] = [uv[0] * width, uv[1] * height];
                *uv = [x + cos * u + sin * v, y - sin * u + cos * v];
            }
        }
        Ok(uvs)
    }
}

/// The vertices of a primitive: how many there are, and the index of the first one in each of the model's lists.
struct Vertices {
    count: usize,
    position: u32,
    uv: Option<u32>,
    normal: Option<u32>,
    color: Option<u32>,
    mirrored: bool,
}

impl Vertices {
    /// The corner at a vertex. If the vertex does not exist, the corner gets the index of a position that does not
    /// exist either.
    fn corner(&self, index: f64) -> Corner {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        // a whole number of 32 bits
        let index = index as u32;
        if index as usize >= self.count {
            return Corner {
                position: u32::MAX,
                ..Corner::default()
            };
        }
        let of = |first: Option<u32>| first.map(|first| first + index);
        Corner {
            position: self.position + index,
            uv: of(self.uv),
            normal: of(self.normal),
            color: of(self.color),
        }
    }
}

/// The base color and the base texture of a material. If the material describes its surface by specular color and
/// glossiness, they are its diffuse color and texture.
fn surface(material: &Value) -> (&Value, &Value) {
    let glossy = &material["extensions"]["KHR_materials_pbrSpecularGlossiness"];
    if glossy.is_object() {
        return (&glossy["diffuseFactor"], &glossy["diffuseTexture"]);
    }
    let surface = &material["pbrMetallicRoughness"];
    (&surface["baseColorFactor"], &surface["baseColorTexture"])
}
