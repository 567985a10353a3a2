//! Reads glTF 2.0 files, both text and binary.

mod accessor;
mod matrix;

use base64::Engine;
use base64::alphabet::STANDARD;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig};
use serde_json::Value;

use std::collections::HashSet;
use std::path::PathBuf;

use matrix::{IDENTITY, Matrix, blend, local, matrix, normal_matrix, product};

use crate::files::Folder;
use crate::material::GLOW_ELSEWHERE;
use crate::mtl::byte;
use crate::sniff::contents;
use crate::text::unescaped;
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

/// Textures that are not drawn: where a material has them, and what they are.
#[rustfmt::skip]
const NOT_DRAWN: [(&str, &str); 4] = [
    ("/normalTexture", "normal maps"),
    ("/occlusionTexture", "occlusion maps"),
    ("/pbrMetallicRoughness/metallicRoughnessTexture", "metallic and rough surfaces"),
    ("/extensions/KHR_materials_pbrSpecularGlossiness/specularGlossinessTexture", "specular and glossy surfaces"),
];

/// Nodes can share meshes, skins and lists of values. All nodes together may read this many bytes of values, or 16 times
/// as many as the file has. Without this limit, a short file could take any time.
const BYTES: usize = 1 << 24;
/// A list of values, or a part of a mesh, counts at least as this many bytes.
const STEP: usize = 64;

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
    if !root["asset"].is_object() && !root["meshes"].is_array() {
        return Err("it is JSON, but not glTF: it has no asset".into());
    }
    let is_in = |list, name: &str| names(&root[list]).any(|other| other == name);
    check_compression(|name| is_in("extensionsRequired", name))?;
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
    reader.model.bytes = reader.folder.all;
    reader.images();
    reader.read = 0;
    for material in list(&root, "materials") {
        let material = reader.material(material);
        reader.model.materials.push(material);
    }
    reader.scene();
    if reader.model.triangles.is_empty() {
        check_compression(|name| is_in("extensionsUsed", name))?;
    }
    Ok(reader.model)
}

/// Fails if there is an extension that compresses meshes. `has` tells which extensions there are.
fn check_compression(has: impl Fn(&str) -> bool) -> Result<(), String> {
    let found = COMPRESSED.iter().find(|(extension, _)| has(extension));
    found.map_or(Ok(()), |(extension, method)| {
        Err(format!(
            "its meshes are compressed with {method} ({extension}): save it without compression"
        ))
    })
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
    let (is, needed) = (bytes.len(), word(8).unwrap_or(usize::MAX));
    // Any bytes can follow the file's own.
    let bytes = bytes.get(..needed).ok_or_else(|| {
        format!("byte {is}: it ends before the {needed} bytes that its header promises")
    })?;
    let word = |at: usize| Some(u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?) as usize);
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
    let float = value.as_f64()?;
    let is_whole = float.fract() == 0.0 && (0.0..9e15).contains(&float);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // checked
    is_whole.then_some(float as usize)
}

/// The numbers of a list; `None` if the list does not have `N` numbers.
fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let numbers: Vec<f64> = value.as_array()?.iter().filter_map(Value::as_f64).collect();
    numbers.try_into().ok()
}

/// Base64 without the padding at its end, which some programs leave out.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_padding_mode(DecodePaddingMode::RequireNone)
        .with_decode_allow_trailing_bits(true),
);

/// The bytes of a `data:` URI; `None` if the URI names a file.
fn data(uri: &str) -> Option<Result<Vec<u8>, String>> {
    let data = uri.strip_prefix("data:")?;
    Some(match data.split_once(',') {
        Some((kind, text)) if kind.trim_end().ends_with("base64") => {
            let mut text = unescaped(text);
            text.retain(|byte| !byte.is_ascii_whitespace() && *byte != b'=');
            let bytes = BASE64.decode(text);
            bytes.map_err(|error| format!("a data URI is not in base64: {error}"))
        }
        Some((_, text)) => Ok(unescaped(text)),
        None => Err("a data URI has no comma".into()),
    })
}

/// Converts a linear component of a color to sRGB.
fn encoded(linear: f64) -> f64 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    }
}

/// Converts a linear component of a color to a byte in sRGB.
fn srgb(linear: f64) -> u8 {
    byte(encoded(linear))
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
        let count = items.len();
        let missing = || format!("its {of} have no number {at}: there are {count}, counted from 0");
        items.get(at).ok_or_else(missing)
    }

    /// Counts bytes of values that are read.
    fn spend(&mut self, bytes: usize) -> Result<(), String> {
        let Folder { all, files, .. } = self.folder;
        self.read = self.read.saturating_add(bytes);
        if self.read > BYTES.max(all.saturating_mul(16)) {
            return Err("its nodes share too much: they would repeat it too often".into());
        }
        files.progress(self.read.min(all), all);
        Ok(())
    }

    /// The path of the file with this URI.
    fn path(&self, uri: &str) -> PathBuf {
        self.folder
            .beside(&String::from_utf8_lossy(&unescaped(uri)))
    }

    fn buffers(&mut self, binary: Option<&[u8]>) {
        let mut paths = HashSet::new();
        for (at, buffer) in list(self.root, "buffers").iter().enumerate() {
            let bytes = match buffer["uri"].as_str() {
                None => (binary.filter(|_| at == 0).map(<[u8]>::to_vec))
                    .ok_or_else(|| "the file has no binary part for it".into()),
                Some(uri) => data(uri).unwrap_or_else(|| {
                    let path = self.path(uri);
                    let name = path.display();
                    if !paths.insert(path.clone()) {
                        return Err(format!("another buffer is {name}"));
                    }
                    let read = contents(self.folder.files.read(&path));
                    let read = read.map_err(|error| format!("cannot read {name}: {error}"));
                    self.model.files.push(path);
                    read
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
                        let path = self.path(uri);
                        self.model.images.push(Image::File(path));
                        continue;
                    }
                    Some(bytes) => bytes,
                },
                (None, Some(view)) => (self.view(view).map(|(bytes, _)| bytes.to_vec()))
                    .and_then(|bytes| self.spend(bytes.len()).map(|()| bytes)),
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
        let (factor, texture) = surface(material);
        let [r, g, b, alpha] = numbers(factor).unwrap_or([1.0; 4]);
        let color = [r, g, b].map(srgb);
        let strength =
            &material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"];
        let strength = strength.as_f64().unwrap_or(1.0);
        let emission = numbers(&material["emissiveFactor"]).unwrap_or([0.0; 3]);
        let light = emission.map(|x: f64| encoded(x * strength));
        for (map, name) in NOT_DRAWN {
            if material.pointer(map).is_some_and(Value::is_object) {
                self.model.notes.left_out(name);
            }
        }
        let mode = material["alphaMode"].as_str().unwrap_or("OPAQUE");
        let unlit = material["extensions"]["KHR_materials_unlit"].is_object();
        let cutoff = material["alphaCutoff"].as_f64().unwrap_or(0.5);
        let mut new = Material {
            color,
            tint: color,
            emission: if unlit { [0; 3] } else { light.map(byte) },
            opacity: match mode {
                "BLEND" => alpha.clamp(0.0, 1.0),
                // No alpha of a texture is above the cutoff.
                "MASK" if alpha < cutoff => 0.0,
                _ => 1.0,
            },
            alpha: match mode {
                // The cutoff applies to the product of the texture's alpha and the factor's alpha. The cutoff divided
                // by the factor applies to the texture's alpha alone.
                "MASK" => Alpha::Cut(byte(cutoff / alpha.max(cutoff).max(f64::MIN_POSITIVE))),
                "BLEND" => Alpha::Blended,
                _ => Alpha::Ignored,
            },
            two_sided: material["doubleSided"].as_bool().unwrap_or(false),
            unlit,
            ..Material::new(material["name"].as_str().unwrap_or_default().into())
        };
        let glow = &material["emissiveTexture"];
        let [own, other] = [texture, glow].map(|texture| {
            let found = self.texture(texture);
            found.unwrap_or_else(|problem| {
                self.model.notes.add(problem);
                Default::default()
            })
        });
        (new.texture, new.clamp) = own;
        if glow.is_object() && !new.unlit {
            new.emission = [0; 3];
            let (image, clamp) = other;
            let own = new.texture.map_or(glow, |_| texture);
            let is_same = coordinates(own) == coordinates(glow);
            match image.filter(|_| light.iter().any(|&x| x > 0.0)) {
                Some(image) if is_same && (new.texture.is_none() || new.clamp == clamp) => {
                    new.clamp = clamp;
                    self.model.glow(&mut new, image, light);
                }
                Some(_) => self.model.notes.left_out(GLOW_ELSEWHERE),
                None => {}
            }
        }
        new
    }

    /// The image of a material's texture, and whether it is clamped.
    fn texture(&mut self, texture: &Value) -> Result<(Option<u32>, [bool; 2]), String> {
        let Some(at) = whole(&texture["index"]) else {
            return Ok(Default::default());
        };
        let texture = self.item("textures", at)?;
        let webp = whole(&texture["extensions"]["EXT_texture_webp"]["source"]);
        let image = webp.or(whole(&texture["source"]));
        if let Some(image) = image {
            self.item("images", image)?;
        }
        let mut clamp = [false; 2];
        if let Some(sampler) = whole(&texture["sampler"]) {
            let sampler = self.item("samplers", sampler)?;
            let wraps = ["wrapS", "wrapT"].map(|wrap| whole(&sampler[wrap]));
            clamp = wraps.map(|wrap| wrap == Some(33071));
            if wraps.contains(&Some(33648)) {
                self.model.notes.left_out("mirrored repeats of textures");
            }
        }
        Ok((image.and_then(|at| u32::try_from(at).ok()), clamp))
    }

    /// Adds the meshes of the default scene. Without a default scene, adds the meshes of the first scene. Without
    /// scenes, adds the meshes of all nodes; if no node comes first, adds all meshes.
    fn scene(&mut self) {
        let scenes = list(self.root, "scenes");
        let scene = whole(&self.root["scene"])
            .and_then(|at| scenes.get(at))
            .or(scenes.first());
        let nodes = list(self.root, "nodes");
        let inner = nodes.iter().flat_map(|node| list(node, "children"));
        let inner: HashSet<usize> = inner.filter_map(whole).collect();
        let mut roots: Vec<usize> = (0..nodes.len()).rev().collect();
        roots.retain(|at| !inner.contains(at));
        if scene.is_none() && roots.is_empty() {
            for at in 0..list(self.root, "meshes").len() {
                self.mesh(at, &Value::Null, &[], IDENTITY);
            }
            return;
        }
        let mut places: Vec<Option<Matrix>> = vec![None; nodes.len()];
        let mut order = Vec::new();
        let children = |of: &'a Value, name, parent: Matrix| {
            let children = list(of, name).iter().rev().filter_map(whole);
            children.map(move |child| (child, parent))
        };
        let mut next: Vec<(usize, Matrix)> = match scene {
            Some(scene) => children(scene, "nodes", IDENTITY).collect(),
            None => roots.into_iter().map(|root| (root, IDENTITY)).collect(),
        };
        let notes = &mut self.model.notes;
        while let Some((at, parent)) = next.pop() {
            let Some(place) = places.get_mut(at) else {
                notes.add("a node that does not exist is left out");
                continue;
            };
            if place.is_some() {
                notes.add("a node with two parents is drawn once");
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
            let weights = weights.into_iter().flatten();
            let weights: Vec<f64> = weights.map(|x| x.as_f64().unwrap_or(0.0)).collect();
            for primitive in list(mesh, "primitives") {
                self.primitive(primitive, &weights, &joints, matrix)?;
            }
            Ok(())
        };
        let added: Result<(), String> = add();
        if let Err(problem) = added {
            let note = format!("mesh {at}: a part is left out: {problem}");
            self.model.notes.add(note);
        }
    }

    /// The matrices of a skin's joints, at rest.
    fn joints(&mut self, skin: usize, places: &[Option<Matrix>]) -> Result<Vec<Matrix>, String> {
        let skin = self.item("skins", skin)?;
        self.spend(size_of_val(list(skin, "joints")))?;
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
        self.spend(STEP)?;
        let mode = whole(&primitive["mode"]).unwrap_or(4);
        if mode < 4 {
            let what = if mode == 0 { "points" } else { "lines" };
            self.model.notes.left_out(what);
            return Ok(());
        }
        let material = whole(&primitive["material"]);
        let material = material.filter(|&at| at < self.model.materials.len());
        let vertices = self.vertices(primitive, material, weights, joints, node)?;
        let indices = match whole(&primitive["indices"]) {
            Some(at) => self.values::<1>(at)?.into_flattened(),
            #[allow(clippy::cast_precision_loss)] // below 2^53
            None => (0..vertices.count).map(|at| at as f64).collect(),
        };
        let material = material.and_then(|at| u32::try_from(at).ok());
        let count = match mode {
            5 | 6 => indices.len().saturating_sub(2),
            _ => indices.len() / 3,
        };
        for at in 0..count {
            // Every other triangle of a strip is wound the other way.
            let triangle = match mode {
                5 => [at + at % 2, at + 1 - at % 2, at + 2],
                6 => [0, at + 1, at + 2],
                _ => [3 * at, 3 * at + 1, 3 * at + 2],
            };
            let mut corners = triangle.map(|at| vertices.corner(indices[at]));
            // A mirror image reverses the winding of triangles.
            if vertices.mirrored {
                corners.swap(1, 2);
            }
            (self.model).polygon(&mut corners, material, Smoothing::Angle)?;
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
        if self.item("accessors", positions)?["bufferView"].is_null() {
            check_compression(|name| primitive["extensions"][name].is_object())?;
        }
        let mut positions = self.values::<3>(positions)?;
        let count = positions.len();
        (self.model).check(self.model.positions.len() + count, "vertices")?;
        let mut normals = self.attribute::<3>(&attributes["NORMAL"], count)?;
        for (target, &weight) in list(primitive, "targets").iter().zip(weights) {
            for (name, values) in [("POSITION", &mut positions), ("NORMAL", &mut normals)] {
                let moved = self.attribute::<3>(&target[name], count)?;
                for (value, moved) in values.iter_mut().zip(moved) {
                    *value = [0, 1, 2].map(|i| value[i] + weight * moved[i]);
                }
            }
        }
        let material = match material {
            Some(at) => &list(self.root, "materials")[at],
            None => &Value::Null,
        };
        let (_, texture) = surface(material);
        let texture = if texture.is_object() {
            texture
        } else {
            &material["emissiveTexture"]
        };
        let uvs = self.uvs(attributes, texture, count)?;
        let colors = self.attribute::<3>(&attributes["COLOR_0"], count)?;
        if material["alphaMode"]
            .as_str()
            .is_some_and(|mode| mode != "OPAQUE")
            && self.has_alpha(&attributes["COLOR_0"], count)?
        {
            self.model.notes.left_out("opacity of vertex colors");
        }
        // Each set has four joints for each vertex, and their weights.
        let mut bones: Vec<Vec<([f64; 4], [f64; 4])>> = Vec::new();
        let name = |what: &str, set: usize| format!("{what}_{set}");
        while !joints.is_empty() && attributes[name("JOINTS", bones.len())].is_number() {
            let set = ["JOINTS", "WEIGHTS"].map(|what| &attributes[name(what, bones.len())]);
            let shares = self.attribute::<4>(set[1], count)?;
            let which = self.attribute::<4>(set[0], count)?;
            bones.push(which.into_iter().zip(shares).collect());
        }

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
            let bones = bones.iter().filter_map(|set| set.get(at));
            let matrix = blend(joints, bones).unwrap_or(node);
            let moved = |row: usize| (0..3).map(|k| matrix[k][row] * p[k]).sum::<f64>();
            let position = [0, 1, 2].map(|row| matrix[3][row] + moved(row));
            model.positions.push(position);
            if let Some(n) = normals.get(at) {
                let (matrix, determinant) = normal_matrix(&matrix);
                vertices.mirrored = determinant < 0.0;
                let normal =
                    [0, 1, 2].map(|row| (0..3).map(|k| matrix[k][row] * n[k]).sum::<f64>());
                model.normals.push(normal.map(|x| x * determinant.signum()));
            }
        }
        model.uvs.extend(uvs);
        let colors = colors.iter().map(|color| color.map(srgb));
        model.colors.extend(colors);
        Ok(vertices)
    }

    /// The texture coordinates of a primitive's vertices.
    fn uvs(
        &mut self,
        attributes: &Value,
        texture: &Value,
        count: usize,
    ) -> Result<Vec<[f64; 2]>, String> {
        let (set, transform) = coordinates(texture);
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

/// The number of a texture's set of coordinates, and their transform.
fn coordinates(texture: &Value) -> (usize, &Value) {
    let transform = &texture["extensions"]["KHR_texture_transform"];
    let set = whole(&transform["texCoord"]).or(whole(&texture["texCoord"]));
    (set.unwrap_or(0), transform)
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
