//! The crate `tobj` reads the same mesh.

use fixel::prelude::*;
use proptest::prelude::*;

use super::reading::ok;

/// Compares the values at each triangle's corners with those of `tobj`.
fn agrees_with_tobj(text: &str) -> Result<(), TestCaseError> {
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
    // f32 has a relative error of 2^-24; the crate rounds to half a unit.
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
    agrees_with_tobj(include_str!("../../models/house.obj")).unwrap();
}

/// A number as programs write it.
fn decimal() -> impl Strategy<Value = String> {
    (-1000.0..1000.0, 0..9_usize, 0..3).prop_map(|(value, places, form)| match form {
        0 => format!("{value:.places$}"),
        1 => format!("{value:.places$e}"),
        _ => format!("{:.places$}", value / 1000.0),
    })
}

/// OBJ text with `v`, `vt`, `vn` and polygons, with positive or negative indices and either kind of line end.
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
    fn tobj_agrees_on_random_text(text in text()) {
        agrees_with_tobj(&text)?;
    }
}
