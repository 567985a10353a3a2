//! OBJ text in all its forms, its mistakes, and as another reader understands it.
#![allow(clippy::format_push_string)] // clearer here, and speed is no matter

use embedded_graphics::pixelcolor::Rgb888;
use fixel::geometry::{Buffers, Counts, obj};
use fixel::prelude::*;
use proptest::prelude::*;

/// A mesh that owns what it was read into; the attributes as their values at the corners of the triangles.
#[derive(Debug, PartialEq)]
struct Owned {
    counts: Counts,
    positions: Vec<Vec3>,
    faces: Vec<[u16; 3]>,
    edges: Vec<[u16; 2]>,
    uvs: Vec<Vec2>,
    uv_faces: Vec<[u16; 3]>,
    normals: Vec<Vec3>,
    normal_faces: Vec<[u16; 3]>,
    colors: Vec<Rgb888>,
}

fn read(text: &str) -> Result<Owned, Error> {
    let counts = obj::count(text.as_bytes())?;
    let mut owned = Owned {
        counts,
        positions: vec![Vec3::ZERO; counts.positions],
        faces: vec![[0; 3]; counts.faces],
        edges: vec![[0; 2]; counts.edges],
        uvs: vec![Vec2::default(); counts.uvs],
        uv_faces: vec![[0; 3]; counts.uv_faces],
        normals: vec![Vec3::ZERO; counts.normals],
        normal_faces: vec![[0; 3]; counts.normal_faces],
        colors: vec![Rgb888::default(); counts.colors],
    };
    let mesh = obj::parse(
        text.as_bytes(),
        Buffers {
            positions: &mut owned.positions,
            faces: &mut owned.faces,
            edges: &mut owned.edges,
            uvs: &mut owned.uvs,
            uv_faces: &mut owned.uv_faces,
            normals: &mut owned.normals,
            normal_faces: &mut owned.normal_faces,
            colors: &mut owned.colors,
        },
    )?;
    assert_eq!(mesh.positions().len(), counts.positions);
    assert_eq!(mesh.faces().len(), counts.faces);
    assert_eq!(
        (mesh.has_uvs(), mesh.has_normals(), mesh.has_colors()),
        (counts.uvs > 0, counts.normals > 0, counts.colors > 0)
    );
    let edges = mesh.edges().len();
    owned.edges.truncate(edges);
    Ok(owned)
}

fn ok(text: &str) -> Owned {
    read(text).unwrap()
}

/// The x of the position in a text of this one number.
fn number(text: &str) -> Result<Scalar, Error> {
    read(&format!("v {text} 0 0")).map(|mesh| mesh.positions[0].x)
}

/// The texture coordinate in a text of this one u and v, whose bits are those of u and 1 − v.
fn tex_coord(u: &str, v: &str) -> Result<[i32; 2], Error> {
    // Of three corners, as what no corner names is left out.
    read(&format!("{SQUARE}vt {u} {v}\nf 1/1 2/1 3/1")).map(|mesh| mesh.uvs[0].to_bits())
}

/// Line and a word of the problem.
fn fails(text: &str, line: usize, word: &str) {
    match read(text) {
        Err(Error::Obj { line: at, problem }) => {
            assert_eq!(at, line, "{problem}");
            assert!(problem.contains(word), "{problem}");
        }
        other => panic!("{text:?} gave {other:?}"),
    }
}

/// No value.
const NONE: u16 = Mesh::NO_VALUE;

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn polygon_becomes_fan_with_its_own_edges() {
    let mesh = ok(&format!("{SQUARE}v -1 0.5 0\nf 1 2 3 4 5"));
    assert_eq!(mesh.faces, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    assert_eq!(mesh.edges, [[0, 1], [0, 4], [1, 2], [2, 3], [3, 4]]);
}

#[test]
fn shared_edge_occurs_once() {
    let mesh = ok(&format!("{SQUARE}f 1 2 3\nf 1 3 4\nl 4 3 2\nl 2 4"));
    assert_eq!(mesh.edges, [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]]);
}

/// Many edges that differ in their last byte only, in reverse order and twice.
#[test]
fn edges_about_a_hub_are_sorted() {
    let mut text = "v 0 0 0\n".repeat(601);
    for i in (2..=600).rev() {
        text += &format!("f 1 {i} {}\n", i + 1);
    }
    let spokes = (1..=600).map(|i| [0, i]);
    let rim = (1..600).map(|i| [i, i + 1]);
    assert_eq!(ok(&text).edges, spokes.chain(rim).collect::<Vec<_>>());
}

#[test]
fn negative_indices_count_back_from_their_line() {
    let expected = ok(&format!("{SQUARE}f 1 2 3\nf 1 3 4"));
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1";
    assert_eq!(ok(text), expected);
}

#[test]
fn positive_index_may_look_ahead() {
    assert_eq!(
        ok(&format!("f 1 2 3 4\n{SQUARE}")),
        ok(&format!("{SQUARE}f 1 2 3 4"))
    );
}

#[test]
fn corner_forms() {
    let attributes = "vt 0 0\nvt 1 0.25\nvn 0 0 1\nvn 0 1 0\nvn 2 0 0\n";
    let both = ok(&format!("{SQUARE}{attributes}f 1/2/3 2/1/2 3/2/1"));
    assert_eq!(
        (both.uv_faces, both.normal_faces),
        (vec![[1, 0, 1]], vec![[2, 1, 0]])
    );
    // v runs down.
    assert_eq!(both.uvs, [vec2!(0, 1), vec2!(1, 0.75)]);
    assert_eq!(both.normals, [Vec3::Z, Vec3::Y, vec3!(2, 0, 0)]);

    let uv = ok(&format!("{SQUARE}{attributes}f 1/2 2/1 3/-1"));
    assert_eq!((uv.uv_faces, uv.counts.normals), (vec![[1, 0, 1]], 0));

    let normal = ok(&format!("{SQUARE}{attributes}f 1//2 2//-3 3//3"));
    assert_eq!(
        (normal.normal_faces, normal.counts.uvs),
        (vec![[1, 0, 2]], 0)
    );

    let neither = ok(&format!("{SQUARE}{attributes}f 1 2/ 3//"));
    assert_eq!((neither.counts.uvs, neither.counts.normals), (0, 0));
}

#[test]
fn attributes_in_order_of_positions_need_no_faces() {
    let mesh = ok(&format!(
        "{SQUARE}vt 0\nvt 1\nvt 0 1 9\nvt 1 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4"
    ));
    assert_eq!((mesh.counts.uvs, mesh.counts.uv_faces), (4, 0));
    assert_eq!(mesh.uvs[..2], [vec2!(0, 1), vec2!(1, 1)]);
    let mesh = ok(&format!("{SQUARE}vt 0\nvt 1\nvt 0 1\nf 1/1 2/2 3/3"));
    assert_eq!((mesh.counts.uvs, mesh.counts.uv_faces), (3, 1));
}

#[test]
fn corner_without_value_has_none() {
    let mesh = ok(&format!("{SQUARE}vt 0 0\nvn 0 0 1\nf 1/1 2 3//1\nf 1 3 4"));
    assert_eq!(mesh.uv_faces, [[0, NONE, NONE], [NONE; 3]]);
    assert_eq!(mesh.normal_faces, [[NONE, NONE, 0], [NONE; 3]]);
}

#[test]
fn colors_only_if_all_positions_have_them() {
    let mesh = ok("v 0 0 0 1 0 0.5\nv 1 0 0 0.2 1 1 0.5");
    assert_eq!(
        mesh.colors,
        [Rgb888::new(255, 0, 128), Rgb888::new(51, 255, 255)]
    );
    assert_eq!(ok("v 0 0 0 1 0 0.5\nv 1 0 0").counts.colors, 0);
    assert_eq!(ok("v 1 2 3 4").positions, [vec3!(1, 2, 3)]);
}

#[test]
fn layout_does_not_matter() {
    let expected = ok(&format!("{SQUARE}f 1 2 3 4"));
    for text in [
        "\u{feff}# a comment \\\r\n\r\nv 0 0 0\r\n  v\t1 0 0  \r\nv 1 1 0\r\nv 0 1 0 # last\r\nf 1 2 3 4\r\n",
        "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r",
        "v 0 \\\n0 0\nv 1 0\\\r\n 0\nv 1 1 0\nv 0 1 0\nf 1 2\\\n\\\n 3 4",
        "mtllib a.mtl\no x\ng\ns off\nv 0 0 0\nvp 1\nv 1 0 0\nusemtl \\\nf 9 9 9\nv 1 1 0\nv 0 1 0\np 1\nf 1 2 3 4\nfoo\nvx\n#",
    ] {
        assert_eq!(ok(text), expected, "{text:?}");
    }
    assert_eq!(ok("").counts, Counts::default());
    // Names in Latin-1.
    assert!(obj::count(b"o W\xfcrfel\nv 0 0 0").is_ok());
}

#[test]
fn numbers() {
    for (text, bits) in [
        ("1", 65536),
        ("+1.", 65536),
        ("-.5", -32768),
        ("2.5e-1", 16384),
        ("25E-2", 16384),
        ("0.0025e+2", 16384),
        ("0000000000000000000000000000000000000001.5", 98304),
        ("1000000000000000000000000000000e-30", 65536),
        ("0.00000000000000000000000000000000000001e38", 65536),
        ("1e-400", 0),
        ("-1e-99999999999999999999999", 0),
        ("0e99999999999999999999999", 0),
        // Half a unit away from zero, and less by 10^-30.
        ("0.00000762939453125", 1),
        ("-0.00000762939453125", -1),
        ("0.000007629394531249999999999999", 0),
        ("12345.00000762939453125", 12345 * 65536 + 1),
        ("32767.99999", i32::MAX),
        ("-32768", i32::MIN),
        ("-32768.000007", i32::MIN),
    ] {
        assert_eq!(number(text), Ok(Scalar::from_bits(bits)), "{text}");
    }
}

#[test]
fn numbers_out_of_range() {
    for text in [
        "32767.999993",
        "32768",
        "-32768.00001",
        "1e5",
        "1e300",
        "123456789012345678901234567890",
        "1e99999999999999999999",
    ] {
        fails(&format!("#\nv {text} 0 0"), 2, "out of range");
    }
}

#[test]
fn texture_coordinates() {
    const ONE: i32 = 1 << 20;
    for (text, bits) in [
        ("1", ONE),
        ("-.5", -ONE / 2),
        ("2.5e-1", ONE / 4),
        ("25E-2", ONE / 4),
        ("2046.5", 2046 * ONE + ONE / 2),
        // Half a unit away from zero, and less by 10^-21 and 10^-30.
        ("0.000000476837158203125", 1),
        ("-0.000000476837158203125", -1),
        ("0.000000476837158203124", 0),
        ("0.000000476837158203124999999999", 0),
        ("476837158203125e-21", 1),
        ("476837158203124e-21", 0),
        ("7.00000143051147460937500", 7 * ONE + 2),
        ("7.00000143051147460937499", 7 * ONE + 1),
        ("0.99999952316284179687", ONE - 1),
        ("0.99999952316284179688", ONE),
    ] {
        assert_eq!(tex_coord(text, text), Ok([bits, ONE - bits]), "{text}");
    }
    assert_eq!(tex_coord("2047.9999995", "0"), Ok([i32::MAX, ONE]));
    assert_eq!(tex_coord("-2048.0000004", "0"), Ok([i32::MIN, ONE]));
    let last = Ok([0, i32::MAX]);
    assert_eq!(tex_coord("0", "-2046.999999046325684"), last);
}

#[test]
fn texture_coordinates_out_of_range() {
    for text in [
        "2047.9999996 0",
        "2048 0",
        "-2048.000001 0",
        "40000 0",
        "1e300 0",
        "0 2048",
        // 1 − v is not there.
        "0 -2047",
        "0 -2048",
    ] {
        fails(
            &format!("#\nvt {text}"),
            2,
            "texture coordinate is out of range: u, v and 1 - v must lie between -2048 and 2047.99999",
        );
    }
}

#[test]
fn malformed_numbers() {
    for text in [
        "", "x", ".", "+", "-", "--1", "1e", "1e+", "e1", "1.2.3", "1,5", "nan", "inf", "0x1",
        "1f", "1\\2", "é",
    ] {
        fails(
            &format!("\n\nv 1 0 {text}"),
            3,
            if text.is_empty() {
                "3 numbers"
            } else {
                "malformed"
            },
        );
    }
}

#[test]
fn errors_name_their_line() {
    let first_at_5 = |rest: &str, word| fails(&format!("{SQUARE}{rest}"), 5, word);
    first_at_5("f 0 1 2", "0");
    first_at_5("f 1 2 -0", "0");
    first_at_5("f 1 2 5", "position that is not there");
    first_at_5("f 1 2 -5", "position that is not there");
    first_at_5("f 1 2 99999999999999999999", "position that is not there");
    first_at_5("f 1/1 2 3", "texture coordinate that is not there");
    first_at_5("f 1//-1 2 3", "normal that is not there");
    first_at_5("f", "3 corners");
    first_at_5("f 1 2", "3 corners");
    first_at_5("l 1", "2 ends");
    first_at_5("l", "2 ends");
    first_at_5("f 1 2 x", "corner is malformed");
    first_at_5("f 1 2 3/1/1/1", "corner is malformed");
    first_at_5("f 1 2 3.5", "corner is malformed");
    first_at_5("f 1 2 /3", "corner is malformed");
    first_at_5("f 1 2 +3", "corner is malformed");
    first_at_5("v 1 2", "3 numbers");
    first_at_5("v 1 2 3 4 5", "3 numbers");
    first_at_5("v 1 2 3 4 5 6 7 8", "too many");
    first_at_5("v 1 2 3 0 0 1.1", "colour");
    first_at_5("v 1 2 3 0 -0.1 1", "colour");
    first_at_5("vt", "2 numbers");
    first_at_5("vn 1 2", "3 numbers");
    first_at_5("vn 1 2 3 4", "too many");
    // A statement over several lines is where it goes wrong; comments do not go on.
    fails("# a\\\nv 0 0\\\n", 3, "3 numbers");
    fails("\r\n\r\nv", 3, "3 numbers");
    fails("\r\rv", 3, "3 numbers");
}

#[test]
fn at_most_65536_positions() {
    let mut text = "v 0 0 0\n".repeat(65_536);
    text += "f 1 65536 2\n";
    assert_eq!(ok(&text).faces, [[0, 65_535, 1]]);
    text += "v 0 0 0\n";
    fails(&text, 65_538, "65536");
}

#[test]
fn room() {
    let text = format!("{SQUARE}vt 0\nf 1/1 2/1 3/1").into_bytes();
    let (mut positions, mut faces) = ([Vec3::ZERO; 9], [[7; 3]; 1]);
    let mesh = obj::parse(&text, Buffers::new(&mut positions, &mut faces)).unwrap();
    assert_eq!(
        (mesh.positions().len(), mesh.has_uvs(), mesh.edges().len()),
        (4, false, 0)
    );
    let result = obj::parse(&text, Buffers::new(&mut positions[..3], &mut faces));
    assert!(matches!(result, Err(Error::TooMany { given: 4, max: 3 })));
    let uvs = &mut [Vec2::default()];
    let result = obj::parse(
        &text,
        Buffers {
            uvs,
            ..Buffers::new(&mut positions, &mut faces)
        },
    );
    assert!(matches!(result, Err(Error::TooMany { given: 1, max: 0 })));
}

/// In flash as at run time.
#[test]
fn included_house() {
    static HOUSE: Mesh = include_obj!("models/house.obj");
    let mesh = ok(include_str!("models/house.obj"));
    assert_eq!(HOUSE.positions(), mesh.positions);
    assert_eq!(HOUSE.faces(), mesh.faces);
    // Euler: 10 corners and 7 polygons, the ground being one; and the antenna.
    assert_eq!(HOUSE.edges(), mesh.edges);
    assert_eq!(mesh.edges.len(), 15 + 1);
    assert!(HOUSE.has_uvs());
}

/// Compares with `tobj`: the values at each triangle's corners.
fn as_tobj_reads(text: &str) -> Result<(), TestCaseError> {
    let mine = ok(text);
    let options = tobj::LoadOptions {
        triangulate: true,
        ignore_lines: true,
        ..tobj::LoadOptions::default()
    };
    let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| {
        Ok((Vec::new(), std::collections::HashMap::default()))
    })
    .unwrap();
    // f32 is exact to 2^-24 of the value, and rounding to half a unit follows.
    let within = |ours: f64, theirs: f32, unit: f64| {
        (ours - f64::from(theirs)).abs() <= unit / 2.0 + f64::from(theirs.abs()) / 16_777_216.0
    };
    let close = |ours: Scalar, theirs: f32| within(ours.to_num(), theirs, Scalar::DELTA.to_num());
    let close_uv = |ours: f64, theirs: f32| within(ours, theirs, TexCoord::DELTA.to_num());
    let mut at = 0;
    for model in models {
        let mesh = &model.mesh;
        for corner in 0..mesh.indices.len() {
            let (face, k) = ((at + corner) / 3, (at + corner) % 3);
            let ours = mine.positions[usize::from(mine.faces[face][k])];
            let theirs = &mesh.positions[3 * mesh.indices[corner] as usize..];
            prop_assert!(
                close(ours.x, theirs[0]) && close(ours.y, theirs[1]) && close(ours.z, theirs[2])
            );
            if mine.counts.uvs > 0 {
                let faces = if mine.uv_faces.is_empty() {
                    &mine.faces
                } else {
                    &mine.uv_faces
                };
                let ours = mine.uvs[usize::from(faces[face][k])];
                let theirs = &mesh.texcoords[2 * mesh.texcoord_indices[corner] as usize..];
                let (u, down): (f64, f64) = (ours.x.to_num(), ours.y.to_num());
                prop_assert!(close_uv(u, theirs[0]) && close_uv(1.0 - down, theirs[1]));
            }
            if mine.counts.normals > 0 {
                let faces = if mine.normal_faces.is_empty() {
                    &mine.faces
                } else {
                    &mine.normal_faces
                };
                let ours = mine.normals[usize::from(faces[face][k])];
                let theirs = &mesh.normals[3 * mesh.normal_indices[corner] as usize..];
                prop_assert!(
                    close(ours.x, theirs[0])
                        && close(ours.y, theirs[1])
                        && close(ours.z, theirs[2])
                );
            }
        }
        at += mesh.indices.len();
    }
    prop_assert_eq!(at, 3 * mine.faces.len());
    Ok(())
}

#[test]
fn tobj_agrees_on_the_house() {
    as_tobj_reads(include_str!("models/house.obj")).unwrap();
}

/// A number as programs write them.
fn decimal() -> impl Strategy<Value = String> {
    (-1000.0..1000.0, 0..9_usize, 0..3).prop_map(|(value, places, form)| match form {
        0 => format!("{value:.places$}"),
        1 => format!("{value:.places$e}"),
        _ => format!("{:.places$}", value / 1000.0),
    })
}

/// A text of `v`, `vt`, `vn` and polygons, with indices of either sign and either line end.
fn text() -> impl Strategy<Value = String> {
    let vectors = |n| prop::collection::vec(prop::array::uniform3(decimal()), n);
    let corner = (any::<u16>(), any::<u16>(), any::<u16>(), any::<bool>());
    let faces = prop::collection::vec(prop::collection::vec(corner, 3..8), 1..12);
    (
        vectors(3..20),
        vectors(1..20),
        vectors(1..20),
        faces,
        0..4,
        any::<bool>(),
    )
        .prop_map(|(positions, uvs, normals, faces, form, crlf)| {
            let end = if crlf { "\r\n" } else { "\n" };
            let mut text = String::from("# generated") + end;
            for [x, y, z] in &positions {
                text += &format!("v {x} {y}  {z}{end}");
            }
            for [u, v, _] in &uvs {
                text += &format!("vt {u} {v}{end}");
            }
            for [x, y, z] in &normals {
                text += &format!("vn {x}\t{y} {z} {end}");
            }
            for face in faces {
                text += "f";
                for (p, u, n, negative) in face {
                    let index = |i: u16, len: usize| {
                        let len = i64::try_from(len).unwrap();
                        let i = i64::from(i) % len;
                        if negative { i - len } else { i + 1 }
                    };
                    let (p, u, n) = (
                        index(p, positions.len()),
                        index(u, uvs.len()),
                        index(n, normals.len()),
                    );
                    text += &match form {
                        0 => format!(" {p}"),
                        1 => format!(" {p}/{u}"),
                        2 => format!(" {p}//{n}"),
                        _ => format!(" {p}/{u}/{n}"),
                    };
                }
                text += end;
            }
            text
        })
}

proptest! {
    #[test]
    fn tobj_agrees(text in text()) {
        as_tobj_reads(&text)?;
    }

    /// To the nearest, halves away from zero, as the sum of exact fractions says.
    #[test]
    fn numbers_round_exactly(value in -327_670_000_000_000_i64..327_670_000_000_000, point in 0..12_u32) {
        // value · 10^-10 in f64 is not exact; 128-bit integers are.
        let scaled = i128::from(value) << 17;
        let quotient = scaled.abs() / 10_000_000_000;
        let nearest = (quotient + 1) / 2 * scaled.signum();
        let digits = 10_i64.pow(10);
        let plain = format!("{}{}.{:010}", if value < 0 { "-" } else { "" }, value.abs() / digits, value.abs() % digits);
        prop_assert_eq!(i128::from(number(&plain).unwrap().to_bits()), nearest);
        let shifted = format!("{value}e{}", -10);
        prop_assert_eq!(i128::from(number(&shifted).unwrap().to_bits()), nearest);
        let padded = format!("{value}{:0<width$}E-{}", "", 10 + point, width = point as usize);
        prop_assert_eq!(i128::from(number(&padded).unwrap().to_bits()), nearest);
    }

    /// The same with the bits of a texture coordinate.
    #[test]
    fn texture_coordinates_round_exactly(
        value in -204_600_000_000_000_000_i64..204_600_000_000_000_000,
        fine in 0..10_u128.pow(21),
        point in 0..12_u32,
    ) {
        let scaled = i128::from(value) << 21;
        let nearest = (scaled.abs() / 10_i128.pow(14) + 1) / 2 * scaled.signum();
        let digits = 10_i64.pow(14);
        let plain = format!("{}{}.{:014}", if value < 0 { "-" } else { "" }, value.abs() / digits, value.abs() % digits);
        prop_assert_eq!(i128::from(tex_coord(&plain, "0").unwrap()[0]), nearest);
        let padded = format!("{value}{:0<width$}E-{}", "", 14 + point, width = point as usize);
        prop_assert_eq!(i128::from(tex_coord(&padded, "0").unwrap()[0]), nearest);
        // As many places as decide.
        let nearest = ((fine << 21) / 10_u128.pow(21)).div_ceil(2) as i32;
        for text in [format!("0.{fine:021}"), format!("{fine}e-21"), format!("0.{fine:021}9e0")] {
            prop_assert_eq!(tex_coord(&text, "0").unwrap()[0], nearest, "{}", text);
        }
    }

    /// Whatever it is fed, it returns.
    #[test]
    fn any_bytes_return(bytes in prop::collection::vec(prop::sample::select(&b"vvftnl 0123456789./-+eE\\\r\n\n#\t\xff"[..]), 0..200)) {
        if let Ok(counts) = obj::count(&bytes) {
            let (mut positions, mut faces) = (vec![Vec3::ZERO; counts.positions], vec![[0; 3]; counts.faces]);
            let mut edges = vec![[0; 2]; counts.edges];
            let _ = obj::parse(&bytes, Buffers { edges: &mut edges, ..Buffers::new(&mut positions, &mut faces) });
        }
    }

    /// Edges: sorted, each once, those of the polygons.
    #[test]
    fn edges_are_a_sorted_set(polygons in prop::collection::vec(prop::collection::vec(0..400_u16, 3..6), 1..300)) {
        let mut text = "v 0 0 0\n".repeat(400);
        let mut expected = std::collections::BTreeSet::new();
        for polygon in &polygons {
            text += "f";
            for (i, &a) in polygon.iter().enumerate() {
                let b = polygon[(i + 1) % polygon.len()];
                text += &format!(" {}", a + 1);
                if a != b {
                    expected.insert([a.min(b), a.max(b)]);
                }
            }
            text += "\n";
        }
        prop_assert_eq!(ok(&text).edges, expected.into_iter().collect::<Vec<_>>());
    }
}
