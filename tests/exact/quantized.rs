//! A quantized mesh is drawn like a full-precision mesh with the same values.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::mesh::Quantized;
use fixel::mesh::flash::{StoredUvs, UvGrid};
use fixel::prelude::*;
use proptest::collection::vec;
use proptest::prelude::*;

const SIZE: (u32, u32) = (32, 24);
const PIXELS: usize = 32 * 24;

#[derive(Clone, Debug)]
struct Model {
    positions: Vec<Vec3>,
    faces: Vec<[u16; 3]>,
    normals: Vec<[i8; 3]>,
    uvs: Vec<[u8; 2]>,
    /// The triangles' indices of normals and texture coordinates, if they differ from those of positions.
    own: Option<Vec<[u16; 3]>>,
}

fn models() -> impl Strategy<Value = Model> {
    let position = prop::array::uniform3(-0x2_0000..0x2_0000_i32).prop_map(Vec3::from_bits);
    let faces = vec(prop::array::uniform3(0_u16..6), 1..9);
    (vec(position, 6), faces).prop_flat_map(|(positions, faces)| {
        // The first two values are the lowest and the highest of the grid.
        let uvs = vec(any::<[u8; 2]>(), 4).prop_map(|uvs| [vec![[0; 2], [255; 2]], uvs].concat());
        let index = prop_oneof![9 => 0_u16..6, 1 => Just(Mesh::NO_VALUE)];
        let own = prop::option::of(vec(prop::array::uniform3(index), faces.len()));
        (vec(any::<[i8; 3]>(), 6), uvs, own).prop_map(move |(normals, uvs, own)| Model {
            positions: positions.clone(),
            faces: faces.clone(),
            normals,
            uvs,
            own,
        })
    })
}

/// The picture of a mesh, which must be the same in a frame, in bands, and prepared.
fn drawn(mesh: &Mesh, shader: &impl Shader<Color = Rgb565>) -> Vec<Rgb565> {
    let projection = Projection::perspective(deg!(60), SIZE, fx!(0.1), fx!(100)).unwrap();
    let mvp = projection * Transform::translate(vec3!(0, 0, -4));
    let options = DrawOptions::new().with_cull(Cull::Nothing);
    let mut picture = vec![Rgb565::BLACK; PIXELS];
    let mut canvas = Canvas::new(&mut picture, SIZE.0, SIZE.1).unwrap();
    canvas.draw_with(&options, mesh, &mvp, shader);

    let mut list: TriangleList<16, 99> = TriangleList::new();
    let prepared = list.prepare(&options, SIZE, mesh, &mvp).unwrap();
    let mut bands = vec![Rgb565::BLACK; PIXELS];
    for (first, band) in (0..SIZE.1).step_by(8).zip(bands.chunks_mut(8 * 32)) {
        let mut band = Canvas::band(band, SIZE.0, SIZE.1, first).unwrap();
        band.draw_prepared(&prepared, shader).unwrap();
    }
    assert!(bands == picture);
    picture
}

static SKIN: TextureArray<Rgb565, 4, 4> = TextureArray::from_texels([
    [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE, Rgb565::WHITE],
    [Rgb565::CYAN, Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE],
    [Rgb565::WHITE, Rgb565::MAGENTA, Rgb565::RED, Rgb565::GREEN],
    [Rgb565::BLUE, Rgb565::WHITE, Rgb565::YELLOW, Rgb565::RED],
]);

proptest! {
    #[test]
    fn pixels_equal_those_of_the_unquantized_mesh(model in models(), part in 0_usize..9) {
        let normals = model.normals.iter();
        let normals: Vec<_> = normals.map(|n| Vec3::from_bits(n.map(|x| i32::from(x) << 9))).collect();
        let step = |x: u8| i32::from(x) * 9001 - (1 << 20);
        let uvs: Vec<_> = model.uvs.iter().map(|uv| Vec2::from_bits(uv.map(step))).collect();
        let faces = model.own.as_deref();
        let bare = Mesh::new(&model.positions, &model.faces).unwrap();
        let long = bare.with_normals(&normals, faces).unwrap().with_uvs(&uvs, faces).unwrap();

        let own = faces.unwrap_or_default();
        let grid = UvGrid::around(&uvs, 255);
        let bytes = StoredUvs::Bytes(&model.uvs);
        let quantized = Quantized::new(bare, (&model.normals, own), (bytes, own), grid).unwrap();
        let words: Vec<_> = model.uvs.iter().map(|uv| uv.map(u16::from)).collect();
        let of_16 = (StoredUvs::Words(&words), own);
        let of_16 = Quantized::new(bare, (&model.normals, own), of_16, grid).unwrap();

        let sun = Light::new(vec3!(1, 2, 3), fx!(0.1), fx!(0.9)).unwrap();
        let skin = Textured::new(&SKIN).lit(sun);
        let picture = drawn(&long, &skin);
        prop_assert!(drawn(quantized.mesh(), &quantized.shader(skin)) == picture);
        prop_assert!(drawn(of_16.mesh(), &of_16.shader(skin)) == picture);
        let rest = quantized.part(part..99);
        let picture = drawn(&long.part(part..99), &skin);
        prop_assert!(drawn(rest.mesh(), &rest.shader(skin)) == picture);

        let faces = vec![Rgb565::RED; part];
        let colors = FaceColors::new(&faces);
        prop_assert!(drawn(quantized.mesh(), &quantized.shader(colors)) == drawn(&long, &colors));
        let flat = quantized.without_normals().without_uvs();
        let clay = Flat::rgb(Rgb888::new(236, 214, 190)).lit(sun);
        prop_assert!(drawn(flat.mesh(), &flat.shader(clay)) == drawn(&bare, &clay));
    }
}

#[test]
fn attributes_that_a_mesh_lacks_are_reported() {
    static BALL: Quantized = shape!(sphere(8, 6), quantized_16).without_edges();
    let missing = |mesh: &Quantized<'_>| {
        let projection = Projection::perspective(deg!(60), SIZE, fx!(0.1), fx!(100)).unwrap();
        let mvp = projection * Transform::translate(vec3!(0, 0, -4));
        let mut picture = vec![Rgb565::BLACK; PIXELS];
        let mut canvas = Canvas::new(&mut picture, SIZE.0, SIZE.1).unwrap();
        let skin = mesh.shader(Textured::new(&SKIN));
        canvas.draw(mesh.mesh(), &mvp, &skin).missing.uvs
    };
    assert!(!missing(&BALL));
    assert!(missing(&BALL.without_uvs()));
    assert!(BALL.mesh().edges().is_empty());
}
