//! A short file cannot claim much time or memory. The tests count what a reader does, because time depends on the
//! machine: elements, searches for files, and the lists of values that are read, each of which reports its progress.

mod common;

use std::cell::Cell;
use std::fmt::Write;
use std::io;
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use common::{Memory, memory, notes};
use fixel_assets::{Files, Model};

/// A megabyte.
const SIZE: usize = 1 << 20;
/// The most triangles and the most vertices of such a file: see `MOST` in src/lib.rs.
const MOST: usize = 1 << 18;
/// The most lists of values that are read from such a file: 16 megabytes, each list counting at least as 64 bytes.
const LISTS: usize = (16 << 20) / 64;

/// Files in memory. They count reads, searches and steps.
struct Counted {
    files: Memory,
    reads: Cell<usize>,
    searches: Cell<usize>,
    steps: Cell<usize>,
}

fn one_more(count: &Cell<usize>) {
    count.set(count.get() + 1);
}

impl Files for Counted {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        one_more(&self.reads);
        self.files.read(path)
    }

    fn find(&self, path: &Path) -> Option<PathBuf> {
        one_more(&self.searches);
        // The folder's list is read, which takes its time even if the folder is small.
        self.files.find(path)
    }

    fn progress(&self, _: usize, _: usize) {
        one_more(&self.steps);
    }
}

/// Reads the first file, and checks the bounds of a model.
fn read<T: AsRef<[u8]>>(files: &[(&str, T)]) -> (Result<Model, String>, Counted) {
    let counted = Counted {
        files: memory(files),
        reads: Cell::default(),
        searches: Cell::default(),
        steps: Cell::default(),
    };
    let size: usize = files.iter().map(|(_, file)| file.as_ref().len()).sum();
    assert!(size <= SIZE + SIZE / 8, "{size}");
    let model = fixel_assets::read(Path::new(files[0].0), &counted);
    if let Ok(model) = &model {
        let counts = [model.triangles.len(), model.positions.len()];
        assert!(counts.iter().all(|&count| count <= MOST), "{counts:?}");
    }
    assert!(counted.steps.get() <= LISTS, "{:?}", counted.steps);
    assert!(counted.reads.get() <= 4200, "{:?}", counted.reads);
    // Four places are looked into for each name.
    assert!(counted.searches.get() <= 4 * 4200, "{:?}", counted.searches);
    (model, counted)
}

/// `text` as often as it fits into a megabyte that begins with `start`; `#` is the number of the copy.
fn filled(start: &str, text: &str, end: &str) -> String {
    let mut all = start.to_string();
    let mut copy = 0;
    while all.len() + text.len() + end.len() < SIZE {
        all += &text.replace('#', &copy.to_string());
        copy += 1;
    }
    all + end
}

/// The text of a glTF with a buffer of `bytes`, and lists of JSON objects.
fn gltf(bytes: &[u8], rest: &str) -> String {
    let uri = STANDARD.encode(bytes);
    let len = bytes.len();
    format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"buffers\":[{{\"byteLength\":{len},\"uri\":\"data:;base64,{uri}\"}}],\
         \"bufferViews\":[{{\"buffer\":0,\"byteLength\":36}},{{\"buffer\":0,\"byteOffset\":36,\"byteLength\":{}}}],{rest}}}",
        len - 36
    )
}

/// Three positions, then `count` indices of a byte each.
fn shared(count: usize) -> Vec<u8> {
    let positions = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let bytes = positions.iter().flatten().flat_map(|x| x.to_le_bytes());
    bytes.chain((0..count).map(|at| (at % 3) as u8)).collect()
}

/// Accessors of three positions and `count` indices, and a mesh of them.
fn mesh(count: usize, mode: u32) -> String {
    format!(
        "\"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}},\
         {{\"bufferView\":1,\"componentType\":5121,\"count\":{count},\"type\":\"SCALAR\"}}],\
         \"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"indices\":1,\"mode\":{mode}}}]}}]"
    )
}

#[test]
fn nodes_that_share_a_mesh_are_bounded() {
    // 30,000 nodes draw 100,000 triangles each, or 300,000 as a strip.
    for mode in [4, 5] {
        let (bytes, mesh) = (shared(300_000), mesh(300_000, mode));
        let nodes = "{\"mesh\":0},".repeat(30_000);
        let text = gltf(&bytes, &format!("{mesh},\"nodes\":[{nodes}{{}}]"));
        let (model, _) = read(&[("a.gltf", text)]);
        match model {
            Ok(model) => {
                let note = "mesh 0: a part is left out: it has over 262144 triangles: too many for its size";
                assert!(
                    notes(&model).iter().any(|it| it.starts_with(note)),
                    "{:?}",
                    notes(&model)
                );
            }
            Err(problem) => assert!(problem.contains("too many for its size"), "{problem}"),
        }
    }
}

#[test]
fn values_that_are_read_again_and_again_are_bounded() {
    let accessor = "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}";
    // An attribute of many values beside three positions, a list without vertices, targets, bones, and images.
    let long = "{\"bufferView\":1,\"componentType\":5121,\"count\":300000,\"type\":\"SCALAR\"}";
    let none = "{\"componentType\":5126,\"count\":0,\"type\":\"VEC3\"}";
    let sparse =
        "{\"componentType\":5126,\"count\":262144,\"type\":\"VEC4\",\"sparse\":{\"count\":9}}";
    let accessors = format!("\"accessors\":[{accessor},{long},{none},{sparse}]");
    let primitive = |attributes: &str| format!("{{\"attributes\":{{{attributes}}}}},");
    let primitives = [
        primitive("\"POSITION\":0,\"NORMAL\":1,\"COLOR_0\":1,\"TEXCOORD_0\":1"),
        primitive("\"POSITION\":2"),
        primitive("\"POSITION\":0,\"COLOR_0\":3"),
    ];
    for primitive in primitives {
        let meshes = format!(
            "\"meshes\":[{{\"primitives\":[{}{{}}]}}]",
            primitive.repeat(3000)
        );
        let nodes = "{\"mesh\":0},".repeat(20_000);
        let text = gltf(
            &shared(300_000),
            &format!("{accessors},{meshes},\"nodes\":[{nodes}{{}}]"),
        );
        let (model, _) = read(&[("a.gltf", text)]);
        assert!(model.is_ok_and(|it| it.triangles.len() > 1000) || primitive.contains("\":2"));
    }
    let skins = format!("\"skins\":[{{\"joints\":[{}0]}}]", "0,".repeat(100_000));
    let nodes = "{\"mesh\":0,\"skin\":0},".repeat(20_000);
    let mesh = mesh(3, 4);
    let (model, _) = read(&[(
        "a.gltf",
        gltf(
            &shared(3),
            &format!("{mesh},{skins},\"nodes\":[{nodes}{{}}]"),
        ),
    )]);
    let model = model.unwrap();
    // A joint takes 32 bytes, so each node reads 3.2 MB.
    assert_eq!(model.triangles.len(), 5);
    let images = "{\"bufferView\":1},".repeat(20_000);
    let text = gltf(
        &shared(300_000),
        &format!("{mesh},\"images\":[{images}{{\"bufferView\":0}}]"),
    );
    let (model, _) = read(&[("a.gltf", text)]);
    let images = model.unwrap().images;
    let bytes: usize = images
        .iter()
        .map(|it| format!("{it:?}").len().min(1000))
        .sum();
    assert!(bytes < 56 * 1000 + 20_000 * 50, "{bytes}");
}

#[test]
fn nodes_in_any_order_are_bounded() {
    let mesh = mesh(3, 4);
    // One below the other; each its own child; all below each.
    let deep: Vec<_> = (1..=20_000)
        .map(|at| format!("{{\"mesh\":0,\"children\":[{at}]}}"))
        .collect();
    let own: Vec<_> = (0..20_000)
        .map(|at| format!("{{\"mesh\":0,\"children\":[{at}]}}"))
        .collect();
    let all = "1,".repeat(5000);
    let all = vec![format!("{{\"mesh\":0,\"children\":[{all}0]}}"); 80];
    for (nodes, wanted) in [(deep, 20_000), (own, 1), (all, 1)] {
        let nodes = format!("\"nodes\":[{},{{\"mesh\":0}}]", nodes.join(","));
        let (model, _) = read(&[("a.gltf", gltf(&shared(3), &format!("{mesh},{nodes}")))]);
        let count = model.unwrap().triangles.len();
        assert!(count >= wanted && count <= 20_001, "{count}");
    }
    let (model, _) = read(&[("a.gltf", filled("", "[", ""))]);
    assert!(model.unwrap_err().contains("recursion limit"));
}

#[test]
fn buffers_do_not_repeat_bytes() {
    // Each of 100,000 buffers is the file's binary part.
    let json = format!(
        "{{\"asset\":{{}},\"buffers\":[{}{{}}]}}  ",
        "{},".repeat(100_000)
    );
    let json = &json[..json.len() / 4 * 4];
    let mut bytes = Vec::new();
    let long = |len: usize| u32::try_from(len).unwrap().to_le_bytes();
    bytes.extend([&b"glTF"[..], &long(2), &long(28 + json.len() + 600_000)].concat());
    bytes.extend([&long(json.len())[..], b"JSON", json.as_bytes()].concat());
    bytes.extend([&long(600_000)[..], b"BIN\0", &vec![0; 600_000]].concat());
    let (model, _) = read(&[("a.glb", bytes)]);
    assert!(
        model
            .unwrap_err()
            .contains("the file has no binary part for it")
    );
    let buffers = "{\"uri\":\"b.bin\"},".repeat(40_000);
    let text = format!("{{\"asset\":{{}},\"buffers\":[{buffers}{{}}]}}");
    let (_, counted) = read(&[("a.gltf", text.as_bytes()), ("b.bin", &vec![0; 300_000])]);
    assert_eq!(counted.reads.get(), 2);
}

#[test]
fn long_polygons_are_bounded() {
    let positions = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let obj = filled(&format!("{positions}f"), " 1 2 3", "\n");
    let many = filled(positions, "f 1 2 3\n", "");
    let strip = [
        b"ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty char z\n\
          element tristrips 1\nproperty list int uchar vertex_indices\nend_header\n\0\0\0\x01\0\0\0\x01\0\x18\xfc\x0f\0",
        &(0..SIZE - 1000)
            .map(|at| (at % 3) as u8).collect::<Vec<_>>()[..],
    ]
    .concat();
    for (name, file) in [("a.obj", obj.as_bytes()), ("a.ply", &strip)] {
        let (model, _) = read(&[(name, file)]);
        let problem = model.map(|it| it.triangles.len()).unwrap_err();
        assert_eq!(
            problem,
            "it has over 262144 triangles: too many for its size"
        );
    }
    let (model, _) = read(&[("a.obj", many)]);
    assert!(model.unwrap().triangles.len() > 100_000);
}

/// Each corner of a comb may hide each other one.
#[test]
fn concave_polygons_are_cut_in_bounded_time() {
    let comb = |teeth: u32| {
        let mut obj = String::new();
        for at in 0..teeth {
            let up = 1.0 + f64::from(at) / 1e5;
            let _ = writeln!(obj, "v {at} 0 0\nv {at}.5 {up} 0");
        }
        let _ = write!(obj, "v {teeth} -1 0\nv 0 -1 0\nf");
        for at in (1..2 * teeth + 3).rev() {
            let _ = write!(obj, " {at}");
        }
        fixel_assets::read(Path::new("a.obj"), &memory(&[("a.obj", &obj)])).unwrap()
    };
    let area = |model: &Model| -> f64 {
        let corners = model
            .triangles
            .iter()
            .map(|it| it.corners.map(|at| model.positions[at.position as usize]));
        corners
            .map(|[a, b, c]| ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs())
            .sum()
    };
    // A polygon of 10,002 corners is cut, and one of 24,002, with 576 million pairs, becomes a fan that overlaps itself.
    // The area of a tooth and of the square below it is at least 1.5; these are twice the areas.
    let [cut, fan] = [5000, 12_000].map(|teeth| (area(&comb(teeth)), 3.0 * f64::from(teeth)));
    assert!(cut.0 < cut.1 * 1.1, "{cut:?}");
    assert!(fan.0 > fan.1 * 1.5, "{fan:?}");
}

#[test]
fn names_of_files_are_bounded() {
    let face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let (model, _) = read(&[("a.obj", filled(face, "mtllib #.mtl\n", ""))]);
    assert_eq!(
        model.map(|_| ()).unwrap_err(),
        "line 69: it names over 64 files of materials"
    );
    let (model, _) = read(&[("a.obj", filled(&format!("{face}mtllib"), " #.mtl", "\n"))]);
    assert_eq!(model.unwrap().triangles.len(), 1);
    let mtl = filled("", "newmtl #\nmap_Kd #.png\nmap_Ke #.jpg\n", "");
    let obj = format!("mtllib a.mtl\n{face}");
    let (model, _) = read(&[("a.obj", &obj), ("a.mtl", &mtl)]);
    assert!(model.unwrap().materials.len() > 20_000);
    let images = filled("{\"asset\":{},\"images\":[", "{\"uri\":\"#.png\"},", "{}]}");
    let (model, _) = read(&[("a.gltf", images)]);
    assert!(model.is_err());
    // Names of objects are compared in no more than one step each.
    let (model, _) = read(&[("a.obj", filled(face, "o #\n", ""))]);
    assert!(model.unwrap().objects.len() > 100_000);
}

/// A picture of 4096x4096 texels in many tints: a gray TGA of runs of 128 texels.
#[test]
fn tints_of_a_picture_are_bounded() {
    let mut tga = vec![0, 0, 11, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 16, 0, 16, 8, 0];
    tga.extend([255, 9].repeat(4096 * 4096 / 128));
    let files = memory(&[("a.tga", &tga)]);
    let (model, _) = read(&[("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")]);
    let mut model = model.unwrap();
    model.images.push(fixel_assets::Image::File("a.tga".into()));
    let mut material = fixel_assets::Material::new(String::new());
    material.texture = Some(0);
    let count = (0..6).filter(|_| model.texture(&material, &files).is_some());
    // 2^26 texels.
    assert_eq!(count.count(), 4);
    let note = "cannot read texture a.tga: with it, the textures have 83886080 pixels: too many; its faces have one color";
    assert_eq!(notes(&model)[0], note);
}

/// Smooth groups around one point are summed in one pass.
#[test]
fn a_point_of_many_faces_is_smooth() {
    let mut obj = "v 0 0 1\ns 1\n".to_string();
    for at in 0..20_000 {
        let (sin, cos) = (f64::from(at) * 6e-4).sin_cos();
        let _ = writeln!(obj, "v {cos:.4} {sin:.4} 0");
        if at > 0 {
            let _ = writeln!(obj, "f 1 {} {}", at + 1, at + 2);
        }
    }
    let mut model = read(&[("a.obj", obj)]).0.unwrap();
    model.complete();
    let top = model
        .triangles
        .iter()
        .flat_map(|it| it.corners)
        .find(|it| it.position == 0);
    let normal = model.normals[top.unwrap().normal.unwrap() as usize];
    assert!(normal[2] > 0.9, "{normal:?}");
}
