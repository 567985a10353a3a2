//! Normals that the crate computes at run time, compared with the model.

use std::array;

use fixel::prelude::*;
use rand::Rng;

use crate::bumpy::bumpy;
use support::random::{Random, cases};
use support::reference::normals::{angle, around};

/// The relative error that the documentation states for an angle, 2⁻¹³. Actual errors are far smaller.
const WEIGHT: f64 = 1. / 8192.;
/// The error of rounding a unit vector to units of 2⁻¹⁶: half a unit along each axis.
const ROUNDING: f64 = 0.87 / 65_536.;
/// The error of a sum with 22 fraction bits. Each of up to 64 triangles loses up to half a unit along each axis.
const SUM: f64 = 64. * 0.87 / 4_194_304.;

fn real(v: Vec3) -> [f64; 3] {
    v.to_bits().map(|x| f64::from(x) / 65_536.)
}

/// The angle between a normal and the model's sum of weighted normals, divided by the allowed error.
fn error(normal: Vec3, (sum, weights): ([f64; 3], f64)) -> f64 {
    let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
    let allowed = (weights * WEIGHT + SUM) / length + ROUNDING;
    let off = angle(real(normal), sum);
    // If the errors can turn the sum to any direction, every normal is right.
    if allowed > 0.5 { 0. } else { off / allowed }
}

fn model(positions: &[Vec3], faces: &[[u16; 3]]) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let faces = faces.iter().map(|face| face.map(usize::from)).collect();
    (positions.iter().copied().map(real).collect(), faces)
}

#[test]
fn smooth_normals_of_a_bumpy_surface_are_the_models() {
    let shape = bumpy();
    let positions: Vec<Vec3> = shape
        .positions
        .iter()
        .map(|&p| Vec3::try_from(p).unwrap())
        .collect();
    let faces: Vec<[u16; 3]> = shape
        .faces
        .iter()
        .map(|f| f.map(|i| u16::try_from(i).unwrap()))
        .collect();
    let mut normals = vec![Vec3::ZERO; positions.len()];
    let mesh = Mesh::new(&positions, &faces)
        .unwrap()
        .with_smooth_normals(&mut normals)
        .unwrap();
    assert!(mesh.has_normals());
    let (points, corners) = model(&positions, &faces);
    let mut worst = 0_f64;
    // The model searches all triangles for each normal, so the test checks only every third position.
    for at in (0..positions.len()).step_by(3) {
        let expected = around(at, &points, &corners);
        if expected.1 > 0. {
            worst = worst.max(error(normals[at], expected));
        }
    }
    println!("smooth normals: {worst:.3} of the error allowed");
    assert!(worst <= 1.);
}

/// Positions of a grid with hills, in a random size. Some triangles have no area.
fn hills(random: &mut Random) -> [Vec3; 25] {
    let size: u32 = random.random_range(1..31);
    let cell = 1_i64 << size.saturating_sub(2);
    array::from_fn(|at| {
        let [column, row] = [at % 5, at / 5].map(|at| (i64::try_from(at).unwrap() - 2) * cell);
        Vec3::from_bits([column, 0, row].map(|at| {
            let jitter = i64::from(random.random::<i32>()) >> (34 - size);
            (at + jitter).clamp(i32::MIN.into(), i32::MAX.into()) as i32
        }))
    })
}

fn grid() -> Vec<[u16; 3]> {
    let quads = (0..16_u16).map(|quad| quad % 4 + quad / 4 * 5);
    quads
        .flat_map(|at| [[at, at + 5, at + 6], [at, at + 6, at + 1]])
        .collect()
}

#[test]
fn normals_of_hills_of_every_size_are_the_models() {
    cases(256, |random| {
        let positions = hills(random);
        let faces = grid();
        let (points, corners) = model(&positions, &faces);
        let mut smooth = [Vec3::ZERO; 25];
        let mesh = Mesh::new(&positions, &faces).unwrap();
        mesh.with_smooth_normals(&mut smooth).unwrap();
        for (at, &normal) in smooth.iter().enumerate() {
            let expected = around(at, &points, &corners);
            if expected.1 > 0. {
                let error = error(normal, expected);
                assert!(error <= 1., "{at}: {error} of the error allowed");
            }
        }
    });
}
