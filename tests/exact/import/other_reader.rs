//! The crate `tobj` reads the same mesh.

use fixel::prelude::*;
use rand::Rng;

use super::reading::ok;
use crate::common::random::{Random, cases};

/// Compares the values at each triangle's corners with those of `tobj`.
fn agrees_with_tobj(text: &str) {
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
            assert!(
                close(ours.x, theirs[0]) && close(ours.y, theirs[1]) && close(ours.z, theirs[2]),
                "{text}"
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
                assert!(
                    close_uv(u, theirs[0]) && close_uv(1.0 - down, theirs[1]),
                    "{text}"
                );
            }
            if mine.counts.normals > 0 {
                let faces = if mine.normal_faces.is_empty() {
                    &mine.faces
                } else {
                    &mine.normal_faces
                };
                let ours = mine.normals[usize::from(faces[face][k])];
                let theirs = &mesh.normals[3 * mesh.normal_indices[corner] as usize..];
                assert!(
                    close(ours.x, theirs[0])
                        && close(ours.y, theirs[1])
                        && close(ours.z, theirs[2]),
                    "{text}"
                );
            }
        }
        at += mesh.indices.len();
    }
    assert_eq!(at, 3 * mine.faces.len(), "{text}");
}

#[test]
fn tobj_agrees_on_the_house() {
    agrees_with_tobj(include_str!("../../models/house.obj"));
}

/// A number as programs write it.
fn decimal(random: &mut Random) -> String {
    let value = random.random_range(-1000.0..1000.0);
    let places = random.random_range(0..9);
    match random.random_range(0..3) {
        0 => format!("{value:.places$}"),
        1 => format!("{value:.places$e}"),
        _ => format!("{:.places$}", value / 1000.0),
    }
}

/// OBJ text with `v`, `vt`, `vn` and polygons, with positive or negative indices and either kind of line end.
fn text(random: &mut Random) -> String {
    let end = if random.random() { "\r\n" } else { "\n" };
    let mut text = String::from("# generated") + end;
    let positions = random.random_range(3..20);
    for _ in 0..positions {
        let [x, y, z] = [(); 3].map(|()| decimal(random));
        text += &format!("v {x} {y}  {z}{end}");
    }
    let uvs = random.random_range(1..20);
    for _ in 0..uvs {
        let [u, v] = [(); 2].map(|()| decimal(random));
        text += &format!("vt {u} {v}{end}");
    }
    let normals = random.random_range(1..20);
    for _ in 0..normals {
        let [x, y, z] = [(); 3].map(|()| decimal(random));
        text += &format!("vn {x}\t{y} {z} {end}");
    }
    let form = random.random_range(0..4);
    for _ in 0..random.random_range(1..12) {
        text += "f";
        for _ in 0..random.random_range(3..8) {
            let is_negative = random.random();
            let [p, u, n] = [positions, uvs, normals].map(|count: i32| {
                random.random_range(0..count) + if is_negative { -count } else { 1 }
            });
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
}

#[test]
fn tobj_agrees_on_random_text() {
    cases(256, |random| agrees_with_tobj(&text(random)));
}
