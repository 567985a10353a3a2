//! The four measured scenes, in all of their poses.

use std::f64::consts::TAU;

use fixel::prelude::*;
use fixel::view::Perspective;

use super::Result;
use super::case::{Case, FocalProjection, Shot};
use super::scenes::{
    self, CUBE_AT, FLOOR_AT, FLOOR_PITCH, HEIGHT, POSES, SPHERE_AT, WIDTH, cube_turn, sphere_turn,
};
use super::surface::Surface;
use support::reference::linear::{Matrix, multiply, product, rotate_x, rotate_y, translate};

/// The projection of the scenes.
const PROJECTION: FocalProjection = FocalProjection {
    focal: 200.,
    size: (WIDTH, HEIGHT),
    near: 0.25,
    far: 100.,
};

/// The scenes. Each has the name that the program `firmware` prints.
pub fn cases() -> Result<Vec<Case>> {
    let floor = Shot::of_mesh(
        &scenes::FLOOR,
        scenes::floor_mvp(0)?,
        multiply(&rotate_x(radians(FLOOR_PITCH)), &moved(FLOOR_AT)),
        PROJECTION,
    );
    let cube = poses(&scenes::CUBE, scenes::cube_mvp, CUBE_AT, cube_turn)?;
    let sphere = || poses(&scenes::SPHERE, scenes::sphere_mvp, SPHERE_AT, sphere_turn);
    let case = |name, surface, shots| Case {
        name,
        size: (WIDTH, HEIGHT),
        surface,
        texels_log2: 8,
        interpolates: surface != Surface::Faceted,
        shots,
    };
    Ok(vec![
        case("floor", Surface::Checkered, vec![floor]),
        case("cube", Surface::Checkered, cube),
        case("sphere", Surface::Shaded, sphere()?),
        case("sphere-flat", Surface::Faceted, sphere()?),
    ])
}

/// All poses of a mesh that is rotated first, and then moved.
fn poses(
    mesh: &'static Mesh<'static>,
    mvp: impl Fn(i32) -> Result<Mvp<Perspective>, Error>,
    at: Vec3,
    turn: impl Fn(i32) -> [Angle; 2],
) -> Result<Vec<Shot>> {
    (0..POSES)
        .map(|k| {
            let [x, y] = turn(k).map(radians);
            let eye = product(&[moved(at), rotate_x(x), rotate_y(y)]);
            Ok(Shot::of_mesh(mesh, mvp(k)?, eye, PROJECTION))
        })
        .collect()
}

/// Converts an angle to radians, rounded to f64.
fn radians(angle: Angle) -> f64 {
    f64::from(angle.to_bits()) / 2_f64.powi(32) * TAU
}

fn moved(by: Vec3) -> Matrix {
    translate([by.x, by.y, by.z].map(f64::from))
}
