//! A model is the same after it was written and read back; bad bytes are refused.

use std::collections::HashSet;
use std::io;
use std::path::{Path, PathBuf};

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::Fragment;
use fixel::prelude::*;
use fixel::shade::Precise;
use fixel::texture::Sampler;
use fixel_assets::{Files, Picture};
use flash_model::{Board, HOLE, Model, Module, ModuleProblem, Part, Problem, write};

const BRICK: &[u8] = include_bytes!("../../../src/texture/samples/brick.tga");
/// The house of tests/models, with a picture for its bricks.
const HOUSE: [(&str, &[u8]); 3] = [
    (
        "house.obj",
        include_bytes!("../../../tests/models/house.obj"),
    ),
    (
        "house.mtl",
        include_bytes!("../../../tests/models/house.mtl"),
    ),
    ("brick.tga", BRICK),
];

/// Files in memory: names and contents.
struct Memory<'a>(&'a [(&'a str, &'a [u8])]);

impl Files for Memory<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let found = self.0.iter().find(|(name, _)| path == Path::new(name));
        let bytes = found.map(|(_, bytes)| bytes.to_vec());
        bytes.ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn find(&self, path: &Path) -> Option<PathBuf> {
        self.read(path).is_ok().then(|| path.into())
    }
}

/// The words of the model in the first file, for an ILI9341, and the notes.
fn written(
    files: &[(&str, &[u8])],
    spare: Option<&Picture>,
    board: Board,
) -> Result<(Vec<u32>, Vec<String>), String> {
    let mut notes = Vec::new();
    let (name, files) = (files[0].0, Memory(files));
    let words = write(name, &files, spare, board, Module::ILI9341, &mut notes)?;
    Ok((words, notes))
}

fn house() -> Vec<u32> {
    let (words, notes) = written(&HOUSE, None, Board::Pico).unwrap();
    assert_eq!(notes, ["not drawn: lines"]);
    words
}

#[test]
fn notes_tell_what_is_left_out() {
    let lantern = |lines: &str| {
        let obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
        let mtl = format!("newmtl a\n{lines}\n");
        let files = [("a.obj", obj.as_bytes()), ("a.mtl", mtl.as_bytes())];
        written(&files, None, Board::Pico).unwrap().1
    };
    assert_eq!(lantern("Kd 1 0 0"), [""; 0]);
    assert_eq!(lantern("Ke 1 1 0"), [""; 0]);
    assert_eq!(lantern("d 0.5"), ["translucent materials are drawn opaque"]);
    let [missing] = &lantern("map_Kd a.png")[..] else {
        panic!("one note")
    };
    assert!(
        missing.starts_with("cannot read texture a.png: "),
        "{missing}"
    );
    assert_eq!(lantern("Tr 1"), ["Tr 1 without d is read as opaque"]);
    let hidden = ["all faces have the opacity 0: they are drawn opaque"];
    assert_eq!(lantern("d 0"), hidden);
}

/// A closed tetrahedron with its normals outward, and an open square, both two-sided, then what else a face can be.
#[test]
fn each_part_has_its_finish() {
    let obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 2 0 2\nvt 0 0\nusemtl plain\n\
               f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 5 6 3\nusemtl holes\nf 5/1 6/1 2/1\nusemtl hidden\nf 5 6 1\n\
               usemtl glow\nf 5 6 4\n";
    let mtl = "newmtl plain\nKd 1 0 0\nnewmtl holes\nmap_Kd a.png\nnewmtl hidden\nd 0\nnewmtl glow\nKd 0 0 0\n\
               Ke 0 1 0\n";
    // Magenta, which is the color of holes, a hole, and green and blue at the border of opacity.
    let picture = png(
        2,
        2,
        &[255, 0, 255, 255, 1, 2, 3, 0, 0, 255, 0, 128, 0, 0, 255, 127],
    );
    let files = [
        ("a.obj", obj.as_bytes()),
        ("a.mtl", mtl.as_bytes()),
        ("a.png", &picture),
    ];
    let (words, notes) = written(&files, None, Board::Pico).unwrap();
    let hidden = "a material has the opacity 0: its faces are invisible";
    assert_eq!(notes, [hidden]);
    let model = Model::read(&words).unwrap();
    let parts: Vec<_> = model.parts().collect();
    let finish = |part: &Part<'_>| {
        let colors = [part.color, part.emission];
        let is = [
            part.is_two_sided,
            part.is_unlit,
            part.has_holes,
            part.is_plain(),
        ];
        (part.faces.clone(), colors, is)
    };
    let [red, black, green, white] = [Rgb888::RED, Rgb888::BLACK, Rgb888::GREEN, Rgb888::WHITE];
    // The faces of the tetrahedron come last: they are of a one-sided twin of their material.
    let wanted = [
        (0..1, [red, black], [true, false, false, true]),
        (1..2, [white, black], [true, false, true, false]),
        (2..3, [black, green], [true, false, false, false]),
        (3..7, [red, black], [false, false, false, true]),
    ];
    assert_eq!(parts.iter().map(finish).collect::<Vec<_>>(), wanted);
    let skin = parts[1].texture.unwrap();
    let texels = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(u, v)| skin.texel(u, v));
    let other = Rgb565::new(31, 1, 31);
    assert_eq!(texels, [other, HOLE, Rgb565::GREEN, HOLE]);

    // The user's own picture has holes, too.
    let spare = Picture::decode(&picture).unwrap();
    let files = [("a.obj", &b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..])];
    let (words, notes) = written(&files, Some(&spare), Board::Pico).unwrap();
    let holes = "translucent texels are drawn opaque, and as holes below half opacity";
    assert_eq!(notes, [holes]);
    let model = Model::read(&words).unwrap();
    assert!(model.parts().all(|part| part.has_holes));
}

/// A surface turned inside out needs its backs, and so does one with holes in it.
#[test]
fn only_closed_surfaces_with_outer_fronts_are_one_sided() {
    let sides = |faces: &str, lines: &str| {
        let obj =
            format!("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nusemtl a\n{faces}");
        let mtl = format!("newmtl a\n{lines}");
        let [whole, holes] = [255, 0].map(|alpha| png(2, 1, &[9, 9, 9, 255, 9, 9, 9, alpha]));
        let files = [
            ("a.obj", obj.as_bytes()),
            ("a.mtl", mtl.as_bytes()),
            ("whole.png", &whole),
            ("holes.png", &holes),
        ];
        let (words, _) = written(&files, None, Board::Pico).unwrap();
        let model = Model::read(&words).unwrap();
        let sides: Vec<_> = model.parts().map(|part| part.is_two_sided).collect();
        sides
    };
    let closed = "f 1/1 3/1 2/1\nf 1/1 2/1 4/1\nf 2/1 3/1 4/1\nf 1/1 4/1 3/1\n";
    assert_eq!(sides(closed, ""), [false]);
    assert_eq!(sides(closed, "map_Kd whole.png"), [false]);
    assert_eq!(sides(closed, "map_Kd holes.png"), [true]);
    assert_eq!(sides("f 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n", ""), [true]);
    // One face of four has the other direction, or is missing.
    assert_eq!(sides("f 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 4 3\n", ""), [true]);
    assert_eq!(sides("f 1 2 4\nf 2 3 4\nf 1 4 3\n", ""), [true]);
}

/// Painted parts have the colors that the library's own shaders give them.
#[test]
fn light_and_emission_are_those_of_the_library() {
    let obj = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nvn 0 0 1\nvn 1 0 1\nvn 0 1 1\nf 1//1 2//2 3//3\n";
    let (words, _) = written(&[("a.obj", obj.as_bytes())], None, Board::Pico).unwrap();
    let model = Model::read(&words).unwrap();
    let part = model.parts().next().unwrap();
    let sun = Light::new(vec3!(2, 3, 4), fx!(0.35), fx!(0.65)).unwrap();
    let color = Flat::<Rgb565>::rgb(Rgb888::new(200, 100, 50));
    let emission = Rgb888::new(0, 20, 255);
    let [lit, glowing, unlit] = [(Rgb888::BLACK, false), (emission, false), (emission, true)].map(
        |(emission, is_unlit)| {
            let part = Part {
                emission,
                is_unlit,
                ..part.clone()
            };
            drawn(&model.mesh(), part.painted(color, sun))
        },
    );
    assert!(lit == drawn(&model.mesh(), color.lit(sun)));
    let glow = Precise::of_rgb(emission);
    let plus = |_: &Fragment, color: Precise<Rgb565>| Some(color.plus(glow));
    assert!(glowing == drawn(&model.mesh(), color.lit(sun).map(plus)));
    // 200 + 0, 100 + 20, and 50 + 255, which is too much.
    let own = Rgb565::from(Rgb888::new(200, 120, 255));
    assert!(unlit.contains(&own) && unlit.iter().all(|&it| it == own || it == Rgb565::BLACK));
}

/// A PNG of red, green, blue and alpha.
fn png(width: u32, height: u32, pixels: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(png::ColorType::Rgba);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(pixels).unwrap();
    writer.finish().unwrap();
    file
}

/// Word numbers of the header.
const LENGTH: usize = 2;
const CHECKSUM: usize = 3;
const MODULE: usize = 4;
const FRACTION: usize = 24;
const COUNTS: usize = 29;
const HEADER: usize = 40;

/// The words with a right length and checksum.
fn sealed(mut words: Vec<u32>) -> Vec<u32> {
    words[LENGTH] = u32::try_from(4 * words.len()).unwrap();
    let bytes: Vec<u8> = words[4..]
        .iter()
        .flat_map(|word| word.to_le_bytes())
        .collect();
    words[CHECKSUM] = crc32fast::hash(&bytes);
    words
}

#[test]
fn a_model_comes_out_as_it_went_in() {
    let words = house();
    let model = Model::read(&words).unwrap();
    assert_eq!(model.module(), Module::ILI9341);
    assert_eq!(Module::wanted(&words), Module::ILI9341);

    // The box around its faces reaches from (-1, 0, -1) to (1, 2, 1), so its middle is (0, 1, 0), and the corners of
    // the walls' feet are farthest from there.
    let mesh = model.mesh();
    let radius = f64::sqrt(3.0);
    let wanted = [
        [-1.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [1.0, 0.0, -1.0],
        [-1.0, 0.0, -1.0],
    ];
    for (found, [x, y, z]) in mesh.positions().iter().zip(wanted) {
        let wanted = [x, y - 1.0, z].map(|at| at / radius);
        for (found, wanted) in found.to_bits().into_iter().zip(wanted) {
            // The radius is smaller by 2^-14, and a step is 2^-15.
            let error = f64::from(found) / 65536.0 - wanted;
            assert!(error.abs() <= 1.5 / 16384.0, "{found} {wanted}");
        }
    }
    assert_eq!(mesh.faces().len(), 14);
    assert!(mesh.has_normals() && mesh.has_uvs());
    assert!(
        mesh.positions()
            .iter()
            .all(|at| at.distance(Vec3::ZERO) <= fixel::fx!(1))
    );

    let parts: Vec<_> = model.parts().collect();
    let [walls, roof] = &parts[..] else {
        panic!("{} parts", parts.len())
    };
    assert_eq!((walls.faces.clone(), roof.faces.clone()), (0..10, 10..14));
    // 0.35, 0.3 and 0.3 of 255, rounded.
    assert_eq!(roof.color, Rgb888::new(89, 77, 77));
    assert!(roof.texture.is_none());
    let brick = Picture::decode(BRICK).unwrap();
    let skin = walls.texture.unwrap();
    assert_eq!(skin.size_log2(), [3, 2]);
    let texels = (0..4).flat_map(|v| (0..8).map(move |u| skin.texel(u, v)));
    let pixels = brick.pixels.iter();
    let pixels = pixels.map(|&[r, g, b, _]| Rgb565::from(Rgb888::new(r, g, b)));
    assert!(texels.eq(pixels));
}

/// Normals along an axis, and texture coordinates in whole steps of their grid: 65,535 steps of 16 units.
#[test]
fn attributes_belong_to_their_corners() {
    const MOST: f64 = 65_535.0 / 65_536.0;
    let obj = format!(
        "v -1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 1\nvt {MOST} 1\nvt 0 {}\nvn 0 0 1\nvn 0 -9 0\n\
         f 1/2/1 2/3/2 3/1/1\nf 2/1/2 1/1/2 4/2/1\n",
        1.0 - MOST
    );
    let picture = Picture::decode(BRICK).unwrap();
    let files = [("a.obj", obj.as_bytes())];
    let (words, _) = written(&files, Some(&picture), Board::Pico).unwrap();
    let model = Model::read(&words).unwrap();
    let mesh = model.mesh();
    let positions: Vec<_> = mesh.positions().iter().collect();
    let normals = [[0, 0, 127 << 9], [0, -127 << 9, 0]].map(Vec3::from_bits);
    let uvs = [[0, 0], [16 * 65_535, 0], [0, 16 * 65_535]].map(Vec2::from_bits);
    let wanted = Mesh::new(&positions, &[[0, 1, 2], [1, 0, 3]]).unwrap();
    let wanted = wanted.with_normals(&normals, Some(&[[0, 1, 0], [1, 1, 0]]));
    let wanted = wanted
        .unwrap()
        .with_uvs(&uvs, Some(&[[1, 2, 0], [0, 0, 1]]));
    assert_eq!(Ok(mesh), wanted);
}

/// Two triangles: each position has a color, or each face.
#[test]
fn colors_tint_as_those_of_a_mesh() {
    let [red, green, blue] = [Rgb888::RED, Rgb888::GREEN, Rgb888::new(0, 51, 255)];
    let obj =
        "v -1 -1 0 1 0 0\nv 1 -1 0 0 1 0\nv 1 1 0 0 0.2 1\nv -1 1 0 0 1 0\nf 1 2 3\nf 1 3 4\n";
    let ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
               element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n\
               property uchar blue\nend_header\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0 51 255\n";
    let of_positions = &[red, green, blue, green][..];
    let cases = [
        ("a.obj", obj, of_positions, None),
        ("a.ply", ply, &[red, blue][..], Some(&[[0; 3], [1; 3]][..])),
    ];
    let sun = Light::new(Vec3::Y, fx!(0), fx!(1)).unwrap();
    for (name, text, colors, faces) in cases {
        let picture = Picture::decode(BRICK).unwrap();
        for spare in [None, Some(&picture)] {
            let files = [(name, text.as_bytes())];
            let (words, notes) = written(&files, spare, Board::Pico).unwrap();
            assert!(notes.is_empty(), "{notes:?}");
            if faces.is_some() {
                let mut words = words.clone();
                let at = starts(&words)[7];
                words[at] = 2; // a third color
                assert_eq!(Model::read(&sealed(words)).err(), Some(Problem::Lists));
            }
            let model = Model::read(&words).unwrap();
            let part = model.parts().next().unwrap();
            let part = Part {
                is_unlit: true,
                ..part
            };
            let mesh = model.mesh();
            let wanted = mesh.with_colors(colors, faces).unwrap();
            let (found, wanted) = if let Some(skin) = part.texture {
                let skin = Textured::new(skin);
                let found = drawn(&mesh, part.painted(skin, sun));
                (found, drawn(&wanted, skin.tinted()))
            } else {
                let flat = Flat::<Rgb565>::rgb(part.color);
                let found = drawn(&mesh, part.painted(flat, sun));
                (found, drawn(&wanted, flat.tinted()))
            };
            assert!(found == wanted, "{name}");
            assert!(wanted.iter().collect::<HashSet<_>>().len() > 2);
        }
    }
}

/// The pixels of a mesh in a square picture.
fn drawn(mesh: &Mesh<'_>, shader: impl ShaderFor<Rgb565>) -> Vec<Rgb565> {
    let projection = Projection::perspective(deg!(90), (16, 16), fx!(0.1), fx!(10)).unwrap();
    let camera = Camera::look_at(vec3!(0, 0, 1), Vec3::ZERO, Vec3::Y).unwrap();
    let mut pixels = vec![Rgb565::BLACK; 256];
    let mut canvas = Canvas::new(&mut pixels, 16, 16).unwrap();
    canvas.draw(mesh, &(projection * camera), &shader);
    pixels
}

#[test]
fn every_damaged_bit_is_noticed() {
    let words = house();
    for bit in 0..32 * words.len() {
        let mut words = words.clone();
        words[bit / 32] ^= 1 << (bit % 32);
        let problem = Model::read(&words).unwrap_err();
        match bit / 32 {
            0 => assert_eq!(problem, Problem::Missing),
            1 => assert_eq!(problem, Problem::Version(words[1])),
            LENGTH => assert!(
                matches!(problem, Problem::Length(_) | Problem::Checksum { .. }),
                "{problem}"
            ),
            _ => assert!(matches!(problem, Problem::Checksum { .. }), "{problem}"),
        }
        // A panel shows the message.
        let message = problem.to_string();
        assert!(message.lines().count() <= 3 && message.lines().all(|line| line.len() <= 36));
    }
    assert_eq!(Model::read(&[]).err(), Some(Problem::Missing));
    assert_eq!(Model::read(&[u32::MAX; 100]).err(), Some(Problem::Missing));
    let short = Model::read(&words[..words.len() - 1]).err();
    assert_eq!(short, Some(Problem::Length(words[LENGTH])));
}

/// Where the lists begin.
fn starts(words: &[u32]) -> [usize; HEADER - COUNTS] {
    let sizes = [6, 6, 3, 6, 4, 6, 3, 6, 24, 12, 2];
    let mut at = HEADER;
    let starts = std::array::from_fn(|list| {
        let start = at;
        at += (words[COUNTS + list] as usize * sizes[list]).div_ceil(4);
        start
    });
    assert_eq!(at, words.len());
    starts
}

#[test]
fn lists_that_do_not_fit_each_other_are_refused() {
    let refused = |change: &dyn Fn(&mut Vec<u32>)| {
        let mut words = house();
        change(&mut words);
        assert_eq!(Model::read(&sealed(words)).err(), Some(Problem::Lists));
    };
    assert!(Model::read(&sealed(house())).is_ok());
    refused(&|words| words[FRACTION] = 17);
    let mut words = house();
    words[MODULE] = 5; // an unknown controller
    let problem = Model::read(&sealed(words)).err();
    assert_eq!(problem, Some(Problem::Module(ModuleProblem::Controller)));
    refused(&|words| words.push(0));
    for list in COUNTS..HEADER {
        for count in [0, 1, 999, u32::MAX] {
            if house()[list] != count {
                refused(&|words| words[list] = count);
            }
        }
    }
    let [
        _,
        faces,
        _,
        normal_faces,
        _,
        uv_faces,
        ..,
        parts,
        textures,
        _,
    ] = starts(&house());
    for list in [faces, normal_faces, uv_faces] {
        refused(&|words| words[list] |= 0x7fff);
    }
    refused(&|words| words[parts + 1] = 15); // a face beyond the last
    refused(&|words| words[parts] = 11); // ends before it begins
    refused(&|words| words[parts + 3] = 1); // a second texture
    refused(&|words| words[textures] = 7);
    refused(&|words| words[textures + 1] = 0);
    refused(&|words| words[textures + 2] = 1);
}

#[test]
fn a_model_that_is_too_large_gets_smaller_pictures_or_is_refused() {
    let spare = Picture {
        width: 4096,
        height: 4096,
        pixels: vec![[255; 4]; 4096 * 4096],
        table: None,
    };
    let large = |count, times, spare, board| {
        written(
            &[("a.obj", triangles(count, times).as_bytes())],
            spare,
            board,
        )
    };
    let (words, notes) = large(1, 1, Some(&spare), Board::Pico).unwrap();
    assert_eq!(
        notes,
        ["a texture of 4096x4096 texels is shrunk to 256x256"]
    );
    assert_eq!(
        Model::read(&words)
            .unwrap()
            .parts()
            .next()
            .unwrap()
            .texture
            .unwrap()
            .size_log2(),
        [8; 2]
    );
    // These triangles take 1.8 MB.
    let (_, notes) = large(21_845, 4, Some(&spare), Board::Pico).unwrap();
    assert_eq!(
        notes,
        ["a texture of 4096x4096 texels is shrunk to 128x128"]
    );
    let error = large(21_845, 6, None, Board::Pico).unwrap_err();
    assert!(error.ends_with("bytes of flash: 1835008 fit"), "{error}");
    // A Pico 2 has twice as much flash.
    large(21_845, 6, None, Board::Pico2).unwrap();
    let error = large(21_846, 1, None, Board::Pico2).unwrap_err();
    let wanted = "model a.obj: it has 65538 positions: a mesh can have at most 65536; save it with fewer triangles";
    assert_eq!(error, wanted);
}

/// The files are refused before their triangles are read, so that these need no positions.
#[test]
fn a_far_too_large_model_is_refused_by_its_header() {
    let refused = |name: &str, bytes: &[u8]| {
        let error = written(&[(name, bytes)], None, Board::Pico2).unwrap_err();
        let wanted =
            "it has 300000 faces: a board can show at most 262144; save it with fewer triangles";
        assert_eq!(error, format!("model {name}: {wanted}"));
    };
    let mut stl = vec![0; 84 + 50 * 300_000];
    stl[80..84].copy_from_slice(&300_000_u32.to_le_bytes());
    refused("a.stl", &stl);
    let facet = "facet normal 0 0 1\n outer loop\n  vertex\n";
    refused(
        "a.stl",
        format!("solid a\n{}", facet.repeat(300_000)).as_bytes(),
    );
    refused("a.obj", " f 1 2 3\n".repeat(300_000).as_bytes());
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nelement face 300000\nend_header\n";
    refused("a.ply", ply.as_bytes());
}

/// Triangles apart from each other, each several times.
fn triangles(count: usize, times: usize) -> String {
    use std::fmt::Write;
    let mut text = String::new();
    for at in 0..count {
        let _ = writeln!(text, "v {at} 0 0\nv {at} 1 0\nv {at} 0 1");
        text += &"f -3 -2 -1\n".repeat(times);
    }
    text
}
