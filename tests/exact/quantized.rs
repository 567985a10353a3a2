//! A quantized mesh is drawn like a mesh with the same values in full precision.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::mesh::flash::{Small, UvGrid};
use fixel::prelude::*;
use rand::Rng;

use crate::List;
use support::erased::Padded;
use support::random::{Random, cases, list};

const SIZE: (u32, u32) = (32, 24);
const PIXELS: usize = 32 * 24;

#[derive(Debug)]
struct Model {
    positions: [Vec3; 6],
    faces: Vec<[u16; 3]>,
    normals: [[i8; 3]; 6],
    uvs: [[u8; 2]; 6],
    /// The triangles' indices of normals and texture coordinates, if they differ from the indices of positions.
    own: Option<Vec<[u16; 3]>>,
}

fn model(random: &mut Random) -> Model {
    let faces = list(random, 1..9, |random| {
        [(); 3].map(|()| random.random_range(0..6))
    });
    let position = |()| Vec3::from_bits([(); 3].map(|()| random.random_range(-0x2_0000..0x2_0000)));
    let positions = [(); 6].map(position);
    // The first two values are the lowest and the highest value of a grid, so that `UvGrid::around` finds the grid of
    // all six values.
    let mut uvs: [[u8; 2]; 6] = random.random();
    [uvs[0], uvs[1]] = [[0; 2], [255; 2]];
    Model {
        positions,
        normals: random.random(),
        uvs,
        own: random.random_bool(0.5).then(|| {
            let mut index = |()| match random.random_range(0..10) {
                0 => Mesh::NO_VALUE,
                _ => random.random_range(0..6),
            };
            faces.iter().map(|_| [(); 3].map(&mut index)).collect()
        }),
        faces,
    }
}

/// The picture of a mesh, which must be the same in a frame, in bands, and prepared.
fn drawn(mesh: &Mesh, shader: &Padded<impl ShaderFor<Rgb565>>) -> Vec<Rgb565> {
    let shader = &shader.erased();
    let projection = Projection::perspective(deg!(60), SIZE, fx!(0.1), fx!(100)).unwrap();
    let mvp = projection * Transform::translate(vec3!(0, 0, -4));
    let options = DrawOptions::new().with_cull(Cull::Nothing);
    let mut picture = vec![Rgb565::BLACK; PIXELS];
    let mut canvas = Canvas::new(&mut picture, SIZE.0, SIZE.1).unwrap();
    canvas.draw_with(&options, mesh, &mvp, shader);

    let mut list: List = DrawList::new();
    let prepared = list.prepare(&options, SIZE, mesh, &mvp).unwrap();
    let mut bands = vec![Rgb565::BLACK; PIXELS];
    for (first, band) in (0..SIZE.1).step_by(8).zip(bands.chunks_mut(8 * 32)) {
        let mut band = Canvas::band(band, SIZE.0, SIZE.1, first).unwrap();
        band.draw_prepared(&prepared, shader).unwrap();
    }
    assert!(bands == picture);
    picture
}

static SKIN: [[Rgb565; 4]; 4] = [
    [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE, Rgb565::WHITE],
    [Rgb565::CYAN, Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE],
    [Rgb565::WHITE, Rgb565::MAGENTA, Rgb565::RED, Rgb565::GREEN],
    [Rgb565::BLUE, Rgb565::WHITE, Rgb565::YELLOW, Rgb565::RED],
];

#[test]
fn pixels_equal_those_of_the_unquantized_mesh() {
    cases(256, |random| {
        let model = model(random);
        let part = random.random_range(0..9);
        let normals = model.normals;
        let normals = normals.map(|n| Vec3::from_bits(n.map(|x| i32::from(x) << 9)));
        let step = |x: u8| i32::from(x) * 9001 - (1 << 20);
        let uvs = model.uvs.map(|uv| Vec2::from_bits(uv.map(step)));
        let faces = model.own.as_deref();
        let bare = Mesh::new(&model.positions, &model.faces).unwrap();
        let long = bare.with_normals(&normals, faces).unwrap();
        let long = long.with_uvs(&uvs, faces).unwrap();

        let own = faces.unwrap_or_default();
        let grid = UvGrid::around(&uvs, 255);
        let normals = Small::normals(&model.normals);
        let bytes = Small::uvs_of_8(&model.uvs, grid);
        let of_8 = bare.with_quantized_attributes((&normals, own), (&bytes, own));
        let words = model.uvs.map(|uv| uv.map(u16::from));
        let words = Small::uvs_of_16(&words, grid);
        let of_16 = bare.with_quantized_attributes((&normals, own), (&words, own));
        assert_eq!((of_8, of_16), (long, long));

        let sun = Light::new(vec3!(1, 2, 3), fx!(0.1), fx!(0.9)).unwrap();
        let skin = Padded::new(Textured::new(&SKIN).lit(sun));
        let picture = drawn(&long, &skin);
        assert!(drawn(&of_8, &skin) == picture, "{model:?}");
        assert!(drawn(&of_16, &skin) == picture, "{model:?}");
        let picture = drawn(&long.part(part..99), &skin);
        let rest = of_8.part(part..99);
        assert!(drawn(&rest, &skin) == picture, "{part}.. of {model:?}");

        let faces = vec![Rgb565::RED; part];
        let colors = Padded::new(FaceColors::new(&faces));
        let picture = drawn(&long, &colors);
        assert!(drawn(&of_8, &colors) == picture, "{part} of {model:?}");
        let flat = of_8.without_normals().without_uvs();
        let clay = Padded::new(Flat::<Rgb565>::rgb(Rgb888::new(236, 214, 190)).lit(sun));
        let picture = drawn(&bare, &clay);
        assert!(drawn(&flat, &clay) == picture, "{model:?}");
    });
}

#[test]
fn attributes_that_a_mesh_lacks_are_reported() {
    static HOUSE: Mesh = include_mesh!("../models/house.obj", quantized_16).without_edges();
    fn missing(mesh: &Mesh<'_>, shader: &impl ShaderFor<Rgb565>) -> [bool; 2] {
        let projection = Projection::perspective(deg!(60), SIZE, fx!(0.1), fx!(100)).unwrap();
        let mvp = projection * Transform::translate(vec3!(0, 0, -4));
        let mut picture = vec![Rgb565::BLACK; PIXELS];
        let mut canvas = Canvas::new(&mut picture, SIZE.0, SIZE.1).unwrap();
        let missing = canvas.draw(mesh, &mvp, shader).missing;
        [missing.uvs, missing.colors]
    }
    let textured = Padded::new(Textured::new(&SKIN));
    let textured = textured.erased();
    assert_eq!(missing(&HOUSE, &textured), [false, false]);
    assert_eq!(missing(&HOUSE.without_uvs(), &textured), [true, false]);
    assert_eq!(missing(&HOUSE, &Gouraud::new()), [false, true]);
    assert!(HOUSE.edge_indices().is_empty());
}
