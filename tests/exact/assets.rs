//! Macros that put models and pictures into flash give the same values as lists written by hand.

use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian};
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Gray8, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
};
use fixel::mesh::{Material, Outline, Part, TextureAlpha};
use fixel::prelude::*;
use fixel::texture::{Argb4444, Indexed, Mipmap, Raw, Sampler};
use fixel::{Angle, Index, Scalar};

#[test]
fn a_part_has_only_its_own_values() {
    static HOUSE: Mesh = include_mesh!("../models/house.obj");
    static PARTS: &[Part] = include_materials!("../models/house.obj");
    static ROOF: Mesh = include_mesh!("../models/house.obj", part = "tiles", scale = 2);
    let whole = HOUSE.part(PARTS[1].faces());
    assert_eq!(PARTS[1].material.name, "tiles");
    assert_eq!(ROOF.faces().len(), whole.faces().len());
    assert!(ROOF.positions().len() < HOUSE.positions().len());
    for (own, all) in ROOF.faces().iter().zip(whole.faces()) {
        for (&own, &all) in own.iter().zip(all) {
            let [own, all] = [(&ROOF, own), (&HOUSE, all)]
                .map(|(mesh, at)| mesh.positions().get(usize::from(at)).unwrap());
            assert_eq!(own, all * fx!(2));
        }
    }
    assert!(!ROOF.edge_indices().is_empty());
}

/// The box around the whole house reaches from (-1, 0, -1) to (1, 2, 1). A part is moved with the house, so that parts
/// still fit together.
#[test]
fn a_part_moves_with_the_centered_model_before_it_is_scaled() {
    static ROOF: Mesh = include_mesh!("../models/house.obj", part = "tiles", up = z);
    static MOVED: Mesh = include_mesh!(
        "../models/house.obj",
        part = "tiles",
        up = z,
        center,
        scale = 4
    );
    let middle = vec3!(0, 0, -1);
    let moved = ROOF.positions().iter().map(|at| (at - middle) * fx!(4));
    assert!(MOVED.positions().iter().eq(moved));
}

/// With `up = z`, the macro turns the model by a quarter turn around x: the file's z becomes y.
#[test]
fn z_may_point_up() {
    static HOUSE: Mesh = include_mesh!("../models/house.obj");
    static TURNED: Mesh = include_mesh!("../models/house.obj", up = z);
    let turned = |p: Vec3| Vec3::new(p.x, p.z, -p.y);
    let turned = HOUSE.positions().iter().map(turned);
    assert!(TURNED.positions().iter().eq(turned));
    assert_eq!(TURNED.faces(), HOUSE.faces());
}

#[test]
fn materials_are_those_of_the_file() {
    static PARTS: &[Part] = include_materials!("../../examples/assets/cabin.obj");
    let expected = [
        (0..10, Some("planks.tga"), "planks"),
        (10..30, None, "paint"),
        (30..32, None, "door"),
        (32..34, None, "glass"),
        (34..54, None, "stone"),
    ];
    assert_eq!(PARTS.len(), expected.len());
    for (part, (faces, texture, material)) in PARTS.iter().zip(expected) {
        assert_eq!(
            (part.faces(), part.material.texture, part.material.name),
            (faces, texture, material)
        );
    }
    assert_eq!(PARTS[1].material.color, Rgb888::new(161, 51, 41)); // 0.63 0.2 0.16
}

#[test]
fn a_material_has_its_appearance() {
    static PARTS: &[Part] = include_materials!("../models/lantern.obj");
    let [glass, flame, label] = [0, 1, 2].map(|at| PARTS[at].material);
    let named = |name, color| Material {
        name,
        ..Material::new(color)
    };
    let expected = Material {
        opacity: 128,
        ..named("glass", Rgb888::new(51, 102, 153))
    };
    assert_eq!(glass, expected);
    let emission = Rgb888::new(255, 204, 0);
    assert_eq!(
        flame,
        Material {
            emission,
            ..named("flame", Rgb888::BLACK)
        }
    );
    let texture = Some("colors.png");
    let (alpha, clamp) = (TextureAlpha::Cut(128), [true; 2]);
    assert_eq!(
        label,
        Material {
            texture,
            alpha,
            clamp,
            ..named("label", Rgb888::WHITE)
        }
    );
}

#[test]
fn a_picture_becomes_any_texture() {
    static PLANKS: Texture<Rgb565> = include_texture!("../../examples/assets/planks.tga");
    static ARRAY: [[Rgb565; 32]; 32] = include_texture!("../../examples/assets/planks.tga");
    static TEXELS: &[Rgb565] = include_texture!("../../examples/assets/planks.tga");
    static GRAY: Texture<Gray8> = include_texture!("../../examples/assets/planks.tga");
    static OPAQUE: Texture<Argb4444> = include_texture!("../../examples/assets/planks.tga");
    static SMALL: Texture<Rgb888> =
        include_texture!("../../examples/assets/planks.tga", size = "8x4");
    static TILES: Indexed<Texture<u8>, Rgb565> =
        include_texture!("../../src/texture/samples/tiles.bmp");
    static FEW: Indexed<&[[u8; 4]; 2], Rgb565, 4> =
        include_texture!("../../src/texture/samples/tiles.bmp");
    static SAME: Texture<Rgb565> = include_texture!("../../src/texture/samples/tiles.bmp");
    assert_eq!(Texture::from_rows(&ARRAY), PLANKS);
    assert_eq!((GRAY.width(), GRAY.height()), (32, 32));
    assert!(
        OPAQUE
            .texels()
            .iter()
            .all(|texel| texel.opacity() == Argb4444::new(15, 0, 0, 0).opacity())
    );
    assert_eq!((SMALL.width(), SMALL.height()), (8, 4));
    assert_eq!(TEXELS, PLANKS.texels());
    for (u, v) in (0..2).flat_map(|v| (0..4).map(move |u| (u, v))) {
        assert_eq!(TILES.texel(u, v), SAME.texel(u, v));
        assert_eq!(FEW.texel(u, v), SAME.texel(u, v));
    }
}

/// The macro finds outlines in f64, `Outline::build` in integers. Both must find the same edges.
#[test]
fn outlines_are_those_that_are_built() {
    static HOUSE: Mesh = include_mesh!("../models/house.obj");
    static CABIN: Mesh = include_mesh!("../../examples/assets/cabin.obj");
    static LIGHTHOUSE: Mesh = include_mesh!("../../examples/assets/lighthouse.obj");
    let cases: [(&Mesh, Outline, i32); 5] = [
        (&HOUSE, include_outline!("../models/house.obj"), 30),
        (
            &CABIN,
            include_outline!("../../examples/assets/cabin.obj", crease = 50),
            50,
        ),
        (
            &LIGHTHOUSE,
            include_outline!("../../examples/assets/lighthouse.obj", crease = 0.0),
            0,
        ),
        (
            &LIGHTHOUSE,
            include_outline!("../../examples/assets/lighthouse.obj", crease = 35),
            35,
        ),
        (
            &LIGHTHOUSE,
            include_outline!("../../examples/assets/lighthouse.obj", crease = 180),
            180,
        ),
    ];
    for (mesh, outline, crease) in cases {
        let mut room = vec![[0; 4]; 3 * mesh.faces().len()];
        let limit = Angle::from_degrees(crease);
        let built = Outline::build(mesh, limit, &mut room).unwrap();
        let sorted = |outline: &Outline| {
            let (creases, others) = outline.edges().split_at(outline.creases());
            [creases, others].map(|edges| {
                let position = |at: Index| mesh.positions().get(usize::from(at)).unwrap();
                // Either face of an edge can come first, and the same end can have several indices.
                let mut edges: Vec<_> = edges
                    .iter()
                    .map(|edge| edge.map(position))
                    .map(|[a, b, c, d]| {
                        let (ab, ba) = ([a, b, c, d], [b, a, d, c]);
                        if d != a && ba.map(key) < ab.map(key) {
                            ba.map(key)
                        } else {
                            ab.map(key)
                        }
                    })
                    .collect();
                edges.sort_unstable();
                edges
            })
        };
        assert_eq!(sorted(&outline), sorted(&built), "{crease}");
    }
}

fn key(p: Vec3) -> [i32; 3] {
    [p.x, p.y, p.z].map(Scalar::to_bits)
}

#[test]
fn a_mipmap_has_the_means_of_the_picture() {
    static PLANKS: Texture<Rgb888> = include_texture!("../../examples/assets/planks.tga");
    static LEVELS: Mipmap<Rgb888> = include_texture!("../../examples/assets/planks.tga", mipmap);
    assert_eq!(LEVELS.texels()[..1024], *PLANKS.texels());
    // The last texel, which is the only texel of the last level, is the mean of all texels, rounded to the nearest
    // whole number.
    let sum = PLANKS
        .texels()
        .iter()
        .map(|texel| u32::from(texel.r()))
        .sum::<u32>();
    assert_eq!(
        u32::from(LEVELS.texels().last().unwrap().r()),
        (sum + 512) / 1024
    );
}

#[test]
fn an_object_and_its_normals() {
    static BASKET: Mesh = include_mesh!("../../examples/assets/balloon.glb", object = "basket");
    static WOVEN: Mesh = include_mesh!("../../examples/assets/balloon.glb", object = "basket", uvs);
    static BALLOON: Mesh = include_mesh!("../../examples/assets/balloon.glb");
    static HOUSE: Mesh = include_mesh!("../models/house.obj", normals);
    static BARE: Mesh = include_mesh!("../models/house.obj");
    let parts: &[Part] = include_materials!("../../examples/assets/balloon.glb");
    assert_eq!(parts[1].material.name, "wicker");
    assert_eq!(BASKET.faces().len(), parts[1].faces().len());
    assert!(
        BASKET.positions().iter().all(|p| p.y < fx!(0)) && !BASKET.has_uvs() && BALLOON.has_uvs()
    );
    assert!(WOVEN.has_uvs() && WOVEN.faces() == BASKET.faces());
    // The house has no normals of its own; the balloon has.
    assert!(HOUSE.has_normals() && !BARE.has_normals() && BALLOON.has_normals());
}

/// The globe's faces get another order. Its outline has the same order, with and without the option.
#[test]
fn option_file_order_keeps_the_order_of_mesh_and_outline() {
    static GLOBE: Mesh = include_mesh!("../../examples/assets/globe.ply");
    static OUTLINE: Outline = include_outline!("../../examples/assets/globe.ply");
    static OF_FILE: Mesh = include_mesh!("../../examples/assets/globe.ply", file_order);
    static OUTLINE_OF_FILE: Outline =
        include_outline!("../../examples/assets/globe.ply", file_order);
    assert_eq!(OF_FILE.faces()[..3], [[0, 1, 2], [1, 3, 2], [2, 3, 4]]);
    assert_ne!(GLOBE.faces(), OF_FILE.faces());
    for (mesh, outline) in [(&GLOBE, &OUTLINE), (&OF_FILE, &OUTLINE_OF_FILE)] {
        let mut edges = vec![[0; 4]; 3 * 720];
        let built = Outline::build(mesh, deg!(30), &mut edges).unwrap();
        assert_eq!(built.edges(), outline.edges());
    }
}

/// A texture of raw bytes has the same texels as a texture that the macro makes.
#[test]
fn raw_bytes_are_those_of_the_texels() {
    macro_rules! check {
        ($($color:ident $format:ident $order:ident,)+) => {$({
            static TEXELS: Texture<$color> = include_texture!("../../examples/assets/planks.tga");
            let bytes = include_texture!("../../examples/assets/planks.tga", raw = $format);
            let raw = Raw::<$color, $order>::new(bytes, 32, 32).unwrap();
            for (u, v) in (0..32).flat_map(|v| (0..32).map(move |u| (u, v))) {
                assert_eq!(raw.texel(u, v), TEXELS.texel(u, v), stringify!($format));
            }
        })+};
    }
    check! {
        Rgb555 rgb555 BigEndian,
        Bgr555 bgr555_le LittleEndian,
        Rgb565 rgb565 BigEndian,
        Rgb565 rgb565_le LittleEndian,
        Bgr565 bgr565 BigEndian,
        Rgb666 rgb666 BigEndian,
        Bgr666 bgr666_le LittleEndian,
        Rgb888 rgb888 BigEndian,
        Bgr888 bgr888_le LittleEndian,
    }
}
