//! What an effect keeps for a corner is what it would compute afresh.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use fixel::shade::Viewer;
use fixel::{Fragment, Index, PointLight, Primitive, Shader};
use rand::Rng;
use support::random::{Random, cases};

use super::{List, picture};

const SIZE: (u32, u32) = (48, 32);

/// A shader that keeps nothing, because only the crate's own shaders do.
#[derive(Clone, Copy)]
struct Afresh<S>(S);

impl<S: Shader> Shader for Afresh<S> {
    type Color = S::Color;
    type Varyings = S::Varyings;

    const READS_DEPTH: bool = S::READS_DEPTH;

    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.0.varyings(primitive)
    }

    fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<S::Color> {
        self.0.shade(at, varyings)
    }
}

/// The picture of a mesh: drawn at once, or prepared and drawn in bands, with or without computed values.
fn pictures<S: ShaderFor<Rgb565>>(mesh: &Mesh, mvp: &Mvp, shader: &S) -> [Vec<Rgb565>; 3] {
    let options = DrawOptions::new().with_cull(Cull::Nothing);
    let mut list = List::new();
    let mut shades = fixel::ShadeList::<S, 900>::new();
    let prepared = list.prepare(&options, SIZE, mesh, mvp).unwrap();
    let shaded = prepared.shade(&mut shades, |()| *shader).unwrap()(&());
    let start = (Rgb565::BLACK, 0);
    let direct = picture(SIZE, 32, start, &mut |canvas: &mut super::Screen<'_, _>| {
        canvas.draw_with(&options, mesh, mvp, shader);
    });
    let banded = picture(SIZE, 5, start, &mut |canvas: &mut super::Screen<'_, _>| {
        canvas.draw_prepared(&prepared, shader).unwrap();
    });
    let once = picture(SIZE, 5, start, &mut |canvas: &mut super::Screen<'_, _>| {
        canvas.draw_prepared(&prepared, &shaded).unwrap();
    });
    [direct.0, banded.0, once.0]
}

fn check<S: ShaderFor<Rgb565>>(mesh: &Mesh, mvp: &Mvp, shader: S) {
    let [afresh, ..] = pictures(mesh, mvp, &Afresh(shader));
    for kept in pictures(mesh, mvp, &shader) {
        assert!(kept == afresh, "{mesh:?}");
    }
}

/// Random triangles between the positions of a crumpled grid. Most of them share corners with recent triangles.
fn faces(random: &mut Random, len: usize) -> Vec<[Index; 3]> {
    let near = |at: usize, random: &mut Random| (at + random.random_range(0..70)) % len;
    // The first corners have the keys 0 and 1, with which slots are empty.
    let mut faces = vec![[1, 0, 2]];
    faces.extend((0..300).map(|at| [(); 3].map(|()| near(at, random) as Index)));
    faces
}

#[test]
fn kept_light_and_fog_are_those_computed_afresh() {
    cases(12, |random| {
        let vector = |random: &mut Random| {
            Vec3::from_bits([(); 3].map(|()| random.random_range(-1 << 16..1 << 16)))
        };
        let len = random.random_range(100..400);
        let positions: Vec<_> = (0..len).map(|_| vector(random)).collect();
        let normals: Vec<_> = (0..len).map(|_| vector(random)).collect();
        let (faces, mut of_normals) = (faces(random, len), faces(random, len));
        // Some corners have no normal of their own: they have the normal of their triangle.
        for corner in of_normals.as_flattened_mut().iter_mut().step_by(7) {
            *corner = Mesh::NO_VALUE;
        }
        let bare = Mesh::new(&positions, &faces).unwrap();
        let shared = bare.with_normals(&normals, None).unwrap();
        // Corners at one position have different normals, as along a crease.
        let creased = bare.with_normals(&normals, Some(&of_normals)).unwrap();
        let eye = vec3!(0, 0, 3);
        let projection = Projection::perspective(deg!(50), SIZE, fx!(0.5), fx!(9)).unwrap();
        let camera = Camera::look_at(eye, Vec3::ZERO, Vec3::Y).unwrap();
        let turn = Transform::rotate_y(Angle::from_degrees(random.random_range(0..360)));
        let mvp = projection * camera * turn;
        let sun = Light::new(vec3!(1, 2, 3), fx!(0.2), fx!(0.7)).unwrap();
        let lamp = PointLight::new(vec3!(1, 1, 1), fx!(1), fx!(3)).unwrap();
        let viewer = Viewer::at(eye);
        let fog = Fog::linear(Rgb565::WHITE, fx!(1), fx!(6)).unwrap();
        let clay = Flat::rgb(Rgb888::new(200, 150, 100));
        for mesh in [bare, shared, creased] {
            check(&mesh, &mvp, clay.lit(sun));
            check(&mesh, &mvp, clay.lit(lamp));
            check(&mesh, &mvp, clay.lit(sun.colored(Rgb888::CYAN)));
            check(
                &mesh,
                &mvp,
                clay.lit(sun.shiny(viewer, 9, fx!(0.5)).unwrap()),
            );
            check(&mesh, &mvp, clay.lit(sun.two_sided(viewer)));
            check(&mesh, &mvp, clay.in_fog(fog));
            // Two effects in a stack must not take each other's numbers.
            check(&mesh, &mvp, clay.lit(sun).in_fog(fog));
            check(&mesh, &mvp, clay.in_fog(fog).lit(lamp).lit(sun).dithered());
        }
    });
}
