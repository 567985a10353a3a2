//! The measured scenes with a texture, in all of their poses.

use fixel::prelude::*;
use fixel::view::Perspective;

use super::Result;
use super::measure::Scene;
use super::scenes::{
    self, CUBE_AT, FLOOR_AT, FLOOR_PITCH, POSES, SPHERE_AT, cube_turn, sphere_turn,
};
use support::moves::{Move, product};
use support::reference::scenes::view;

pub fn floor() -> Result<Scene> {
    let mut scene = Scene::new("floor");
    let (_, eye) = product(&[Move::X(FLOOR_PITCH), Move::To(FLOOR_AT)]);
    scene.add(&scenes::FLOOR, &scenes::floor_mvp(0)?, &view(eye))?;
    Ok(scene)
}

pub fn cube() -> Result<Scene> {
    poses("cube", &scenes::CUBE, scenes::cube_mvp, CUBE_AT, cube_turn)
}

pub fn sphere() -> Result<Scene> {
    let (mesh, mvp) = (&scenes::SPHERE, scenes::sphere_mvp);
    poses("sphere", mesh, mvp, SPHERE_AT, sphere_turn)
}

/// A mesh in all poses: it is turned first, and then moved.
fn poses(
    name: &'static str,
    mesh: &Mesh<'_>,
    mvp: impl Fn(i32) -> Result<Mvp<Perspective>, Error>,
    at: Vec3,
    turn: impl Fn(i32) -> [Angle; 2],
) -> Result<Scene> {
    let mut scene = Scene::new(name);
    for pose in 0..POSES {
        let [x, y] = turn(pose);
        let (_, eye) = product(&[Move::To(at), Move::X(x), Move::Y(y)]);
        scene.add(mesh, &mvp(pose)?, &view(eye))?;
    }
    Ok(scene)
}
