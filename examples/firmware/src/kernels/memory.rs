//! Memory of the measured scenes at 320x240: flash for their lists and textures, RAM for their prepared triangles.

use core::mem::size_of_val;

use embedded_graphics::pixelcolor::Rgb888;
use fixel::Vec2;
use fixel::mesh::Index;
use fixel::mode::Newton;
use fixel::prelude::*;
use fixel::view::Perspective;

use super::common::lighthouse;
use super::common::scenes::{self, HEIGHT, POSES, WIDTH};

/// Prints a line for each scene.
pub fn print() -> Result<(), Error> {
    let ball = flash(
        &scenes::SPHERE
            .without_uvs()
            .without_normals()
            .without_colors(),
    );
    let colors = scenes::SPHERE.counts().colors * size_of::<Rgb888>();
    let lists = (0..POSES).map(|pose| list(&scenes::SPHERE, &scenes::sphere_mvp(pose)?));
    let list = lists
        .collect::<Result<Vec<_>, Error>>()?
        .into_iter()
        .max()
        .unwrap_or(0);
    println!("scene=sphere flash={} list={list}", ball + colors);
    println!(
        "scene=sphere-flat flash={} list={list}",
        ball + size_of_val(&scenes::FACE_COLORS)
    );

    let models = flash(&lighthouse::ISLAND) + flash(&lighthouse::SEA);
    let textures = size_of_val(&lighthouse::SKIN) + size_of_val(&lighthouse::WAVES);
    println!("scene=default flash={}", models + textures);
    Ok(())
}

/// The number of bytes in a mesh's lists, without the mesh's edges, because nothing draws the edges.
fn flash(mesh: &Mesh) -> usize {
    let counts = mesh.without_edges().counts();
    (counts.positions + counts.normals) * size_of::<Vec3>()
        + counts.uvs * size_of::<Vec2>()
        + counts.colors * size_of::<Rgb888>()
        + (counts.faces + counts.uv_faces + counts.normal_faces) * size_of::<[Index; 3]>()
}

/// The number of bytes in a list that has just enough room for the visible part of a mesh.
fn list(mesh: &Mesh, mvp: &Mvp<Perspective>) -> Result<usize, Error> {
    let options = DrawOptions::<Newton>::new();
    let needed = |error| match error {
        Err(Error::Full { needed, .. }) => Ok(needed),
        Err(error) => Err(error),
        Ok(()) => Ok(0),
    };
    let (mut empty, mut faces) = (DrawList::<0, 0>::new(), DrawList::<2000, 0>::new());
    let triangles = needed(
        empty
            .prepare(&options, (WIDTH, HEIGHT), mesh, mvp)
            .map(drop),
    )?;
    let vertices = needed(
        faces
            .prepare(&options, (WIDTH, HEIGHT), mesh, mvp)
            .map(drop),
    )?;
    Ok((triangles + vertices) * 16)
}
