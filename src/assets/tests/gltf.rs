//! glTF files as real programs write them are read, and notes say what was replaced or left out.

#![allow(clippy::float_cmp)] // the files state these values exactly

mod common;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use common::{notes, read};
use fixel_assets::{Alpha, Disk, Image, Model};
use serde_json::{Value, json};

/// A glTF document, and the bytes of its buffer.
struct Document {
    root: Value,
    bytes: Vec<u8>,
}

impl Document {
    /// A file with one node, which draws a square of two triangles with texture coordinates, in the plane z = 0.
    fn square() -> Self {
        let mut document = Self {
            root: json!({
                "asset": {"version": "2.0"},
                "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                "meshes": [{"name": "square", "primitives": [{"attributes": {}, "material": 0}]}],
                "materials": [{}], "accessors": [], "bufferViews": [], "buffers": [],
            }),
            bytes: Vec::new(),
        };
        let positions = document.floats(
            "VEC3",
            &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0],
        );
        let uvs = document.floats("VEC2", &[0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
        let indices = document.accessor("SCALAR", 5121, 6, &[0, 1, 2, 0, 2, 3]);
        let primitive = document.primitive();
        primitive["attributes"] = json!({"POSITION": positions, "TEXCOORD_0": uvs});
        primitive["indices"] = json!(indices);
        document
    }

    fn primitive(&mut self) -> &mut Value {
        &mut self.root["meshes"][0]["primitives"][0]
    }

    /// Adds values to the buffer. Returns the index of their accessor.
    fn accessor(&mut self, kind: &str, component: u32, count: usize, bytes: &[u8]) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let view = json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len()});
        self.bytes.extend(bytes);
        let views = self.root["bufferViews"].as_array_mut().unwrap();
        views.push(view);
        let accessor = json!({"bufferView": views.len() - 1, "type": kind, "componentType": component, "count": count});
        let accessors = self.root["accessors"].as_array_mut().unwrap();
        accessors.push(accessor);
        accessors.len() - 1
    }

    fn floats(&mut self, kind: &str, values: &[f32]) -> usize {
        let components = match kind {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => 16,
        };
        let bytes: Vec<u8> = values.iter().flat_map(|x| x.to_le_bytes()).collect();
        self.accessor(kind, 5126, values.len() / components, &bytes)
    }

    /// Adds a texture to the material.
    fn texture(&mut self) {
        self.root["images"] = json!([{"uri": "wood%20chip.png"}]);
        self.root["textures"] = json!([{"source": 0}]);
        self.root["materials"][0]["pbrMetallicRoughness"] =
            json!({"baseColorTexture": {"index": 0}});
    }

    fn text(&self) -> Vec<u8> {
        let mut root = self.root.clone();
        let data = STANDARD.encode(&self.bytes);
        root["buffers"] = json!([{
            "byteLength": self.bytes.len(), "uri": format!("data:application/octet-stream;base64,{data}"),
        }]);
        root.to_string().into_bytes()
    }

    fn binary(&self) -> Vec<u8> {
        let mut root = self.root.clone();
        root["buffers"] = json!([{"byteLength": self.bytes.len()}]);
        let mut text = root.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let mut bytes = self.bytes.clone();
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        let length = |bytes: &[u8]| u32::try_from(bytes.len()).unwrap().to_le_bytes();
        let mut file = [b"glTF", &2_u32.to_le_bytes()[..], &[0; 4]].concat();
        file.extend(
            [
                &length(&text)[..],
                b"JSON",
                &text,
                &length(&bytes)[..],
                b"BIN\0",
                &bytes,
            ]
            .concat(),
        );
        let all = length(&file);
        file[8..12].copy_from_slice(&all);
        file
    }

    #[track_caller]
    fn read(&self) -> Model {
        read(&[("a.gltf", self.text())]).expect("a model")
    }

    #[track_caller]
    fn refused(&self) -> String {
        read(&[("a.gltf", self.text())]).expect_err("no model")
    }
}

/// The positions of all triangles, rounded to thousandths.
fn triangles(model: &Model) -> Vec<[[f64; 3]; 3]> {
    let position =
        |at: u32| model.positions[at as usize].map(|x| (x * 1000.0).round() / 1000.0 + 0.0);
    let corners = model.triangles.iter().map(|triangle| triangle.corners);
    corners
        .map(|corners| corners.map(|corner| position(corner.position)))
        .collect()
}

/// The texture coordinates of the first triangle, rounded to thousandths.
fn uvs(model: &Model) -> [[f64; 2]; 3] {
    let corners = model.triangles[0].corners;
    corners.map(|corner| {
        model.uvs[corner.uv.unwrap() as usize].map(|x| (x * 1000.0).round() / 1000.0 + 0.0)
    })
}

const SQUARE: [[[f64; 3]; 3]; 2] = [
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]],
    [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
];

#[test]
fn text_binary_and_buffers_elsewhere() {
    let document = Document::square();
    assert_eq!(triangles(&document.read()), SQUARE);
    let binary = document.binary();
    assert_eq!(triangles(&read(&[("a.glb", &binary)]).unwrap()), SQUARE);
    let short = read(&[("a.glb", &binary[..binary.len() - 1])]).unwrap_err();
    assert!(short.contains("it ends before the"), "{short}");
    let mut elsewhere = document.root.clone();
    elsewhere["buffers"] = json!([{"byteLength": document.bytes.len(), "uri": "a%20b.bin"}]);
    let text = elsewhere.to_string().into_bytes();
    let model = read(&[
        ("a.gltf", text.clone()),
        ("a b.bin", document.bytes.clone()),
    ])
    .unwrap();
    assert_eq!(triangles(&model), SQUARE);
    let missing = read(&[("a.gltf", text)]).unwrap_err();
    assert!(
        missing.contains("buffer 0: cannot read a b.bin"),
        "{missing}"
    );
}

#[test]
fn nodes_are_moved_mirrored_and_drawn_once() {
    let mut document = Document::square();
    let half = 0.5_f64.sqrt();
    document.root["scenes"][0]["nodes"] = json!([1]);
    let nodes = document.root["nodes"].as_array_mut().unwrap();
    nodes.push(json!({"children": [0, 0, 9], "translation": [0, 0, 5]}));
    nodes[0]["rotation"] = json!([0, 0, half, half]); // a quarter turn about z
    nodes[0]["scale"] = json!([-2, 1, 1]);
    let model = document.read();
    // (x, y) → (−2x, y) → (−y, −2x). The transform mirrors the square, and its front must stay the front.
    assert_eq!(
        triangles(&model)[0],
        [[0.0, 0.0, 5.0], [-1.0, -2.0, 5.0], [0.0, -2.0, 5.0]]
    );
    assert_eq!(
        notes(&model),
        [
            "a node with two parents is drawn once",
            "a node that does not exist is left out"
        ]
    );
    // A cycle of nodes does not hang the reader. All meshes of a file without a scene are read.
    document.root["nodes"][0]["children"] = json!([1]);
    assert_eq!(document.read().triangles.len(), 2);
    document.root["scenes"] = json!([]);
    assert_eq!(triangles(&document.read()), SQUARE);
}

#[test]
fn normals_turn_with_their_node() {
    let mut document = Document::square();
    let normals = document.floats(
        "VEC3",
        &[0.6, 0.0, 0.8, 0.6, 0.0, 0.8, 0.6, 0.0, 0.8, 0.6, 0.0, 0.8],
    );
    document.primitive()["attributes"]["NORMAL"] = json!(normals);
    document.root["nodes"][0]["matrix"] = json!([-3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    let normal = document.read().normals[0];
    // The transform multiplies the x of a position by −3, so it divides the x of a normal by −3.
    let ratio = normal[0] / normal[2];
    assert!(
        (ratio + 0.2 / 0.8).abs() < 1e-6 && normal[2] > 0.0,
        "{normal:?}"
    );
}

#[test]
fn strips_and_fans() {
    for (mode, expected) in [(5, [[0, 1, 2], [2, 1, 3]]), (6, [[0, 1, 2], [0, 2, 3]])] {
        let mut document = Document::square();
        document.primitive()["mode"] = json!(mode);
        document
            .primitive()
            .as_object_mut()
            .unwrap()
            .remove("indices");
        let model = document.read();
        let corners = model
            .triangles
            .iter()
            .map(|triangle| triangle.corners.map(|corner| corner.position));
        assert!(corners.eq(expected), "{mode}");
    }
    let mut document = Document::square();
    let lines = document.primitive().clone();
    document.root["meshes"][0]["primitives"]
        .as_array_mut()
        .unwrap()
        .push(lines);
    document.root["meshes"][0]["primitives"][1]["mode"] = json!(1);
    assert_eq!(notes(&document.read()), ["not drawn: lines"]);
}

#[test]
fn components_of_every_type() {
    let quarter: [(u32, &[u8], f64); 5] = [
        (5120, &[0xc1], -63.0 / 127.0), // −63
        (5121, &[51], 0.2),
        (5122, &[0x00, 0x80], -1.0), // −32768 is −1, like −32767
        (5123, &[0x33, 0x33], 0.2),
        (5126, &[0, 0, 0x80, 0x3e], 0.25),
    ];
    for (component, bytes, expected) in quarter {
        let mut document = Document::square();
        let size = bytes.len();
        // Each value is a pair, at a stride of 12 bytes.
        let mut values = vec![0; 12 * 4];
        for at in [0, 12, 24, 36] {
            values[at..at + size].copy_from_slice(bytes);
        }
        let accessor = document.accessor("VEC2", component, 4, &values);
        document.root["accessors"][accessor]["normalized"] = json!(component != 5126);
        let view = document.root["accessors"][accessor]["bufferView"]
            .as_u64()
            .unwrap();
        document.root["bufferViews"][usize::try_from(view).unwrap()]["byteStride"] = json!(12);
        document.primitive()["attributes"]["TEXCOORD_0"] = json!(accessor);
        let found = document.read().uvs[3];
        assert!(
            (found[0] - expected).abs() < 1e-9 && found[1] == 0.0,
            "{component}: {found:?}"
        );
    }
}

#[test]
fn sparse_values() {
    let mut document = Document::square();
    let places = document.accessor("SCALAR", 5123, 2, &[2, 0, 3, 0]);
    let moved = document.floats("VEC3", &[5.0, 6.0, 7.0, 1.0, 0.0, 0.0]);
    let view = |accessor: usize| document.root["accessors"][accessor]["bufferView"].clone();
    let sparse = json!({
        "count": 2, "indices": {"bufferView": view(places), "componentType": 5123}, "values": {"bufferView": view(moved)},
    });
    document.root["accessors"][0]["sparse"] = sparse;
    assert_eq!(document.read().positions[2], [5.0, 6.0, 7.0]);
    // An accessor without bytes has the value 0 except where sparse values replace it.
    document.root["accessors"][0]
        .as_object_mut()
        .unwrap()
        .remove("bufferView");
    let model = document.read();
    assert_eq!(
        (model.positions[1], model.positions[2]),
        ([0.0; 3], [5.0, 6.0, 7.0])
    );
    document.root["accessors"][0]["count"] = json!(1_u64 << 40);
    let said = document.refused();
    assert!(said.contains("at most 262144 are read"), "{said}");
}

#[test]
fn materials() {
    let mut document = Document::square();
    document.texture();
    document.root["samplers"] = json!([{"wrapS": 33071, "wrapT": 33648}]);
    document.root["textures"][0]["sampler"] = json!(0);
    let material = &mut document.root["materials"][0];
    material["name"] = json!("oak");
    material["alphaMode"] = json!("MASK");
    material["alphaCutoff"] = json!(0.4);
    material["emissiveFactor"] = json!([1, 0, 0.25]);
    material["normalTexture"] = json!({"index": 0});
    material["pbrMetallicRoughness"]["baseColorFactor"] = json!([1, 0.5, 0, 0.8]);
    document.root["extensionsUsed"] = json!(["KHR_materials_unlit", "KHR_materials_sheen"]);
    document.root["animations"] = json!([{}]);
    let model = document.read();
    let oak = &model.materials[0];
    assert_eq!(model.images, [Image::File("wood chip.png".into())]);
    assert_eq!((oak.name.as_str(), oak.texture), ("oak", Some(0)));
    // As an sRGB byte, half of the light is 188, and a quarter of the light is 137.
    assert_eq!(
        (oak.color, oak.tint, oak.emission),
        ([255, 188, 0], [255, 188, 0], [255, 0, 137])
    );
    // The cutoff is 0.4, and the texture's alpha is multiplied by 0.8.
    assert_eq!((oak.alpha, oak.opacity), (Alpha::Cut(128), 1.0));
    assert_eq!((oak.clamp, oak.two_sided), ([true, false], false));
    assert_eq!(
        notes(&model),
        ["not drawn: KHR_materials_sheen, animations, normal maps, mirrored repeats of textures"]
    );
    let material = &mut document.root["materials"][0];
    material["alphaMode"] = json!("BLEND");
    material["doubleSided"] = json!(true);
    let model = document.read();
    let oak = &model.materials[0];
    assert_eq!((oak.alpha, oak.two_sided), (Alpha::Blended, true));
    assert!((oak.opacity - 0.8).abs() < 1e-9);
}

#[test]
fn extensions_of_materials() {
    let mut document = Document::square();
    document.texture();
    document.root["images"] = json!([{"uri": "a.png"}, {"uri": "b.webp"}]);
    document.root["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = json!(1);
    document.root["extensionsRequired"] = json!([
        "EXT_texture_webp",
        "KHR_texture_transform",
        "KHR_mesh_quantization"
    ]);
    let texture = &mut document.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
    texture["extensions"]["KHR_texture_transform"] =
        json!({"offset": [0.5, 0], "scale": [2, 3], "rotation": std::f64::consts::FRAC_PI_2});
    let model = document.read();
    assert_eq!(model.materials[0].texture, Some(1));
    // (u, v) → (2u, 3v) → a quarter turn: (3v, −2u) → (3v + 0.5, −2u).
    assert_eq!(uvs(&model), [[3.5, 0.0], [3.5, -2.0], [0.5, -2.0]]);
    let glossy = json!({"diffuseFactor": [0, 1, 0, 1], "diffuseTexture": {"index": 0}});
    document.root["materials"][0] =
        json!({"extensions": {"KHR_materials_pbrSpecularGlossiness": glossy}});
    let material = &document.read().materials[0];
    assert_eq!((material.color, material.texture), ([0, 255, 0], Some(1)));
    let strong = json!({"KHR_materials_emissive_strength": {"emissiveStrength": 4}});
    document.root["materials"][0] = json!({"emissiveFactor": [0.25, 0, 0], "extensions": strong});
    assert_eq!(document.read().materials[0].emission, [255, 0, 0]);
}

#[test]
fn images_within_the_file() {
    let mut document = Document::square();
    document.texture();
    let data = STANDARD.encode(b"picture");
    document.root["images"] = json!([
        {"uri": format!("data:image/png;base64,{data}")},
        {"name": "skin", "bufferView": 0},
        {"bufferView": 99},
    ]);
    let model = document.read();
    assert_eq!(
        model.images[0],
        Image::Bytes("image-0".into(), b"picture".to_vec())
    );
    assert_eq!(
        model.images[1],
        Image::Bytes("skin-1".into(), document.bytes[..48].to_vec())
    );
    assert_eq!(
        notes(&model),
        ["image 2: its bufferViews have no number 99: there are 3, counted from 0"]
    );
}

#[test]
fn vertices_have_colors() {
    let mut document = Document::square();
    let colors = document.accessor(
        "VEC4",
        5121,
        4,
        &[255, 0, 0, 9, 0, 255, 0, 9, 0, 0, 128, 9, 0, 0, 0, 9],
    );
    document.root["accessors"][colors]["normalized"] = json!(true);
    document.primitive()["attributes"]["COLOR_0"] = json!(colors);
    let model = document.read();
    let color = |at: usize| model.colors[model.triangles[0].corners[at].color.unwrap() as usize];
    assert_eq!((color(0), color(2)), ([255, 0, 0], [0, 0, 188]));
}

#[test]
fn shapes_are_morphed_and_bent() {
    let mut document = Document::square();
    let up = document.floats(
        "VEC3",
        &[0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    );
    document.primitive()["targets"] = json!([{"POSITION": up}]);
    document.root["meshes"][0]["weights"] = json!([0.5]);
    assert_eq!(document.read().positions[0], [0.0, 0.0, 2.0]);
    // The weights of a node take precedence over the weights of its mesh.
    document.root["nodes"][0]["weights"] = json!([0.25]);
    assert_eq!(document.read().positions[0], [0.0, 0.0, 1.0]);

    // The left side follows a joint at x = 10. The right side is the mean of this joint and a joint at rest.
    let mut document = Document::square();
    let joints = document.accessor(
        "VEC4",
        5121,
        4,
        &[0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0],
    );
    let shares = document.floats(
        "VEC4",
        &[
            1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.0, 0.0, 0.5, 0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0,
        ],
    );
    let mut inverse = [0.0; 32];
    for at in [0, 5, 10, 15, 16, 21, 26, 31] {
        inverse[at] = 1.0;
    }
    inverse[14] = 3.0; // along z
    let inverses = document.floats("MAT4", &inverse);
    let attributes = &mut document.primitive()["attributes"];
    attributes["JOINTS_0"] = json!(joints);
    attributes["WEIGHTS_0"] = json!(shares);
    document.root["skins"] = json!([{"joints": [1, 2], "inverseBindMatrices": inverses}]);
    document.root["nodes"] = json!([
        {"mesh": 0, "skin": 0, "translation": [99, 99, 99], "children": [1, 2]},
        {"translation": [-89, -99, -99]},
        {"translation": [-99, -99, -99]},
    ]);
    let positions = document.read().positions;
    assert_eq!(
        positions,
        [
            [10.0, 0.0, 3.0],
            [6.0, 0.0, 1.5],
            [6.0, 1.0, 1.5],
            [10.0, 1.0, 3.0]
        ]
    );
}

type Change = fn(&mut Document);

#[test]
fn refusals_and_notes_name_the_element() {
    let mut old = Document::square();
    old.root["asset"]["version"] = json!("1.0");
    assert!(old.refused().contains("it is glTF 1.0"));
    let first = read(&[("a.glb", b"glTF\x01\0\0\0\x14\0\0\0\0\0\0\0\0\0\0\0")]).unwrap_err();
    assert!(first.contains("it is glTF 1.0"), "{first}");
    let mut draco = Document::square();
    draco.root["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]);
    assert!(
        draco
            .refused()
            .contains("its meshes are compressed with Draco")
    );
    let text = read(&[("a.gltf", b"{\"asset\": }".to_vec())]).unwrap_err();
    assert!(
        text.contains("its JSON text: expected value at line 1 column 11"),
        "{text}"
    );

    let changes: [(Change, &str); 7] = [
        (
            |d| d.primitive()["attributes"]["POSITION"] = json!(7),
            "its accessors have no number 7: there are 3, counted from 0",
        ),
        (
            |d| d.root["accessors"][0]["componentType"] = json!(5124),
            "accessor 0: there is no componentType 5124",
        ),
        (
            |d| d.root["accessors"][0]["type"] = json!("VEC2"),
            "accessor 0: it has 2 components per value, and needs 3",
        ),
        (
            |d| d.root["accessors"][0]["count"] = json!(400),
            "accessor 0 reaches beyond its buffer view",
        ),
        (
            |d| d.root["bufferViews"][0]["byteLength"] = json!(4000),
            "bufferView 0 reaches beyond its buffer of",
        ),
        (
            |d| d.root["bufferViews"][0]["buffer"] = json!(3),
            "its buffers have no number 3: there are 1, counted from 0",
        ),
        (
            |d| d.root["nodes"][0]["mesh"] = json!(2),
            "its meshes have no number 2",
        ),
    ];
    for (change, expected) in changes {
        let mut document = Document::square();
        change(&mut document);
        let said = document.refused();
        assert!(said.contains(expected), "no '{expected}' in: {said}");
    }
    // The other parts of a mesh are drawn.
    let mut document = Document::square();
    let whole = document.primitive().clone();
    document.root["meshes"]
        .as_array_mut()
        .unwrap()
        .push(json!({"primitives": [whole]}));
    document.root["nodes"]
        .as_array_mut()
        .unwrap()
        .push(json!({"mesh": 1}));
    document.root["scenes"][0]["nodes"] = json!([0, 1]);
    document.primitive()["attributes"]["POSITION"] = json!(7);
    let model = document.read();
    assert_eq!(triangles(&model), SQUARE);
    assert_eq!(
        notes(&model),
        ["mesh 0: a part is left out: its accessors have no number 7: there are 3, counted from 0"]
    );
}

/// The file has 99 nodes that share a mesh of 131,072 vertices.
#[test]
fn a_short_file_does_not_fill_the_memory() {
    let mut document = Document::square();
    let mut accessors = document.root["accessors"].clone();
    for accessor in accessors.as_array_mut().unwrap() {
        accessor.as_object_mut().unwrap().remove("bufferView");
        accessor["count"] = json!(1 << 17);
        document.root["accessors"]
            .as_array_mut()
            .unwrap()
            .push(accessor.clone());
    }
    let mut large = document.root["meshes"][0].clone();
    large["primitives"][0]["attributes"] = json!({"POSITION": 3});
    large["primitives"][0]["indices"] = json!(5);
    document.root["meshes"].as_array_mut().unwrap().push(large);
    let nodes = (0..100).map(|at| json!({"mesh": at.min(1)}));
    document.root["nodes"] = nodes.collect();
    document.root["scenes"][0]["nodes"] = json!((0..100).collect::<Vec<_>>());
    let model = document.read();
    // The square, and as many of the large meshes as fit.
    assert_eq!(model.positions.len(), 4 + (1 << 17));
    assert!(notes(&model)[0].contains("it has over 262144 vertices"));
}

/// A PNG of one pixel.
fn png(color: [u8; 3]) -> Value {
    let mut bytes = std::io::Cursor::new(Vec::new());
    let picture = image::RgbImage::from_pixel(1, 1, image::Rgb(color));
    picture
        .write_to(&mut bytes, image::ImageFormat::Png)
        .unwrap();
    json!({"uri": format!("data:image/png;base64,{}", STANDARD.encode(bytes.into_inner()))})
}

#[test]
fn emission_is_drawn_only_with_its_texture() {
    let mut document = Document::square();
    document.root["images"] = json!([png([40, 50, 60]), png([0, 100, 200])]);
    document.root["textures"] = json!([{"source": 0}, {"source": 1}]);
    let shown = |document: &Document| {
        let mut model = document.read();
        let material = model.materials[0].clone();
        let picture = model.texture(&material, &Disk).map(|it| it.pixels[0]);
        (picture, material.emission, notes(&model))
    };
    document.root["materials"][0] = json!({
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "baseColorFactor": [1, 0, 1, 1]},
        "emissiveTexture": {"index": 1}, "emissiveFactor": [1, 1, 1],
    });
    assert_eq!(
        shown(&document),
        (Some([40, 100, 255, 255]), [0; 3], vec![])
    );
    // Strength is a factor of light: the square root of sRGB's encoding would give 1.46 for 2.4.
    let extensions = json!({"KHR_materials_emissive_strength": {"emissiveStrength": 0.214_041_14}});
    document.root["materials"][0]["extensions"] = extensions;
    assert_eq!(shown(&document).0, Some([40, 50, 160, 255]));
    document.root["materials"][0]["extensions"] = Value::Null;
    // A black factor leaves the texture as it is.
    document.root["materials"][0]["emissiveFactor"] = json!([0, 0, 0]);
    assert_eq!(shown(&document), (Some([40, 0, 60, 255]), [0; 3], vec![]));
    document.root["materials"][0]["emissiveFactor"] = json!([1, 1, 1]);
    // With other coordinates than the surface's, neither the texture nor the factor is drawn.
    document.root["materials"][0]["emissiveTexture"]["texCoord"] = json!(1);
    let elsewhere = "not drawn: emission with other texture coordinates than the surface";
    assert_eq!(
        shown(&document),
        (Some([40, 0, 60, 255]), [0; 3], vec![elsewhere.into()])
    );
    // The same holds for another border.
    document.root["materials"][0]["emissiveTexture"]["texCoord"] = json!(0);
    document.root["samplers"] = json!([{"wrapS": 33071, "wrapT": 33071}, {"wrapS": 33071}]);
    for (own, light, sum) in [(0, 1, [40, 0, 60, 255]), (1, 1, [40, 100, 255, 255])] {
        document.root["textures"][0]["sampler"] = json!(own);
        document.root["textures"][1]["sampler"] = json!(light);
        assert_eq!(shown(&document).0, Some(sum));
    }
    document.root["materials"][0]["emissiveTexture"]["texCoord"] = json!(1);
    // If the surface has no texture, the vertices get the coordinates of the light's texture.
    let uvs = document.floats("VEC2", &[0.25, 0.25, 0.5, 0.25, 0.5, 0.5, 0.25, 0.5]);
    document.primitive()["attributes"]["TEXCOORD_1"] = json!(uvs);
    document.root["materials"][0]["pbrMetallicRoughness"] =
        json!({"baseColorFactor": [0, 0, 1, 1]});
    assert_eq!(shown(&document).0, Some([0, 100, 255, 255]));
    assert_eq!(self::uvs(&document.read())[0], [0.25, 0.25]);
    assert_eq!(document.read().materials[0].clamp, [true, false]);
    // Only a factor.
    document.root["materials"][0]["emissiveTexture"] = Value::Null;
    assert_eq!(shown(&document), (None, [255; 3], vec![]));
}

#[test]
fn masks_that_hide_everything_are_opaque_and_others_are_cut() {
    let material = |cutoff: f64, alpha: f64| {
        let mut document = Document::square();
        document.root["materials"][0] = json!({
            "alphaMode": "MASK", "alphaCutoff": cutoff, "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, alpha]},
        });
        let model = document.read();
        (
            model.materials[0].opacity,
            model.materials[0].alpha,
            notes(&model),
        )
    };
    let opaque = vec!["all faces have the opacity 0: they are drawn opaque".to_string()];
    assert_eq!(material(0.5, 1.0), (1.0, Alpha::Cut(128), vec![]));
    // The surface's alpha is at least the cutoff where the texture's is at least 0.8, or 204 of 255.
    assert_eq!(material(0.4, 0.5), (1.0, Alpha::Cut(204), vec![]));
    assert_eq!(material(1.5, 1.0), (1.0, Alpha::Cut(255), opaque.clone()));
    assert_eq!(material(0.5, 0.25), (1.0, Alpha::Cut(255), opaque));
    assert_eq!(material(0.0, 0.0), (1.0, Alpha::Cut(0), vec![]));
}

#[test]
fn surfaces_without_light_have_no_emission() {
    let mut document = Document::square();
    document.root["materials"][0] = json!({
        "emissiveFactor": [1, 1, 1], "extensions": {"KHR_materials_unlit": {}},
    });
    let material = document.read().materials[0].clone();
    assert_eq!((material.unlit, material.emission), (true, [0; 3]));
}

#[test]
fn opacity_of_vertex_colors_is_noted_where_it_counts() {
    let mut document = Document::square();
    let bytes: Vec<u8> = [[255, 0, 0, 255], [255, 0, 0, 128]].repeat(2).concat();
    let colors = document.accessor("VEC4", 5121, 4, &bytes);
    document.root["accessors"][colors]["normalized"] = json!(true);
    document.primitive()["attributes"]["COLOR_0"] = json!(colors);
    assert_eq!(notes(&document.read()), [""; 0]);
    for mode in ["BLEND", "MASK"] {
        document.root["materials"][0]["alphaMode"] = json!(mode);
        assert_eq!(
            notes(&document.read()),
            ["not drawn: opacity of vertex colors"]
        );
    }
    document.root["accessors"][colors]["type"] = json!("VEC3");
    document.root["accessors"][colors]["count"] = json!(4);
    assert_eq!(notes(&document.read()), [""; 0]);
}

#[test]
fn nodes_are_drawn_without_a_scene() {
    let mut document = Document::square();
    document.root["scenes"] = Value::Null;
    document.root["nodes"] = json!([
        {"mesh": 0, "translation": [0, 0, 5]},
        {"children": [0], "translation": [10, 0, 0]},
    ]);
    let moved = SQUARE.map(|it| it.map(|[x, y, z]| [x + 10.0, y, z + 5.0]));
    assert_eq!(triangles(&document.read()), moved);
}

#[test]
fn a_vertex_can_have_eight_joints() {
    let mut document = Document::square();
    document.root["nodes"] = json!([
        {"mesh": 0, "skin": 0}, {"translation": [4, 0, 0]}, {"translation": [0, 8, 0]},
    ]);
    document.root["scenes"][0]["nodes"] = json!([0, 1, 2]);
    document.root["skins"] = json!([{"joints": [1, 2]}]);
    let set = |document: &mut Document, number: u8, weight: f32| {
        let joints = document.accessor("VEC4", 5121, 4, &[number, 0, 0, 0].repeat(4));
        let weights = document.floats("VEC4", &[weight, 0.0, 0.0, 0.0].repeat(4));
        let attributes = &mut document.primitive()["attributes"];
        attributes[format!("JOINTS_{number}")] = json!(joints);
        attributes[format!("WEIGHTS_{number}")] = json!(weights);
    };
    set(&mut document, 0, 0.25);
    let moved = |[dx, dy]: [f64; 2]| SQUARE.map(|it| it.map(|[x, y, z]| [x + dx, y + dy, z]));
    assert_eq!(triangles(&document.read()), moved([4.0, 0.0]));
    // A quarter of the first joint, and three quarters of the second, which the second set names.
    set(&mut document, 1, 0.75);
    assert_eq!(triangles(&document.read()), moved([1.0, 6.0]));
}

#[test]
fn bytes_are_read_however_they_are_written() {
    let document = Document::square();
    let text = String::from_utf8(document.text()).unwrap();
    let (start, rest) = text.split_once("base64,").unwrap();
    let (data, end) = rest.split_once('"').unwrap();
    let escaped = document.bytes.iter().map(|byte| format!("%{byte:02X}"));
    let escaped = escaped.collect::<Vec<_>>().concat();
    let bare = data.trim_end_matches('=');
    let ways = [
        format!("base64,{bare}"),
        format!("base64,{bare}=="),
        format!(
            "base64,{}",
            data.replace('=', "%3D")
                .replace('/', "%2F")
                .replace('+', "%2B")
        ),
        format!("base64,{}\\n {}", &data[..12], &data[12..]),
        format!(",{escaped}"),
    ];
    for way in ways {
        let start = if way.starts_with(',') {
            start.trim_end_matches(';')
        } else {
            start
        };
        let text = format!("{start}{way}\"{end}");
        let model = read(&[("a.gltf", text.as_str())]).unwrap();
        assert_eq!(
            (triangles(&model), notes(&model)),
            (SQUARE.to_vec(), vec![]),
            "{text}"
        );
    }
    // Bytes after the length in the header are no part of the file, whatever they are.
    for more in [&b"a"[..], b"\0\0\0\0", b"more than a header of a part"] {
        let model = read(&[("a.glb", [&document.binary(), more].concat())]).unwrap();
        assert_eq!(triangles(&model), SQUARE);
    }
}

#[test]
fn compression_is_the_reason_whether_required_or_not() {
    let draco = "its meshes are compressed with Draco (KHR_draco_mesh_compression): save it without compression";
    let meshopt = "its meshes are compressed with meshopt (EXT_meshopt_compression): save it without compression";
    let mut document = Document::square();
    document.root["extensionsUsed"] = json!(["KHR_draco_mesh_compression"]);
    // The file also has the values without compression.
    document.primitive()["extensions"] = json!({"KHR_draco_mesh_compression": {"bufferView": 0}});
    assert_eq!(triangles(&document.read()), SQUARE);
    let plain = document.primitive().clone();
    document.root["accessors"][0]["bufferView"] = Value::Null;
    assert_eq!(document.refused(), draco);
    document.root["extensionsUsed"] = Value::Null;
    assert!(document.refused().contains(draco));
    // Beside a mesh without compression, a note tells the same.
    let view = document.root["accessors"][0].clone();
    let other = document.root["accessors"].as_array_mut().unwrap();
    other.push(view);
    let at = other.len() - 1;
    document.root["accessors"][0]["bufferView"] = json!(0);
    let mut compressed = plain;
    compressed["attributes"]["POSITION"] = json!(at);
    document.root["meshes"][0]["primitives"]
        .as_array_mut()
        .unwrap()
        .push(compressed);
    let model = document.read();
    assert_eq!(triangles(&model), SQUARE);
    assert_eq!(
        notes(&model),
        [format!("mesh 0: a part is left out: {draco}")]
    );

    let mut document = Document::square();
    document.root["extensionsUsed"] = json!(["EXT_meshopt_compression"]);
    let length = document.bytes.len();
    for view in document.root["bufferViews"].as_array_mut().unwrap() {
        view["extensions"] = json!({"EXT_meshopt_compression": {"buffer": 1}});
    }
    let mut root = document.root.clone();
    root["buffers"] = json!([{"byteLength": length}]);
    assert_eq!(read(&[("a.gltf", root.to_string())]).unwrap_err(), meshopt);
}
