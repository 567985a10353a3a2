//! Values that a shader computes once for all bands give the same pixels as values that it computes again in each band.

use std::cell::Cell;

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::prelude::*;
use fixel::shade::PerFace;
use fixel::{Object, Primitive, ShadeList};

use crate::List;

const WIDTH: u32 = 48;
const HEIGHT: u32 = 36;
const SIZE: (u32, u32) = (WIDTH, HEIGHT);

static BALL: Mesh = shape!(sphere(12, 8));
static OUTLINE: Outline = outline!(BALL, deg!(30));
static RING: Mesh = shape!(torus(fx!(0.3), 16, 8));

fn view() -> Mvp {
    let projection = Projection::perspective(deg!(60), SIZE, fx!(1), fx!(20)).unwrap();
    projection * Camera::look_at(vec3!(0, 1, 3), Vec3::ZERO, Vec3::Y).unwrap()
}

/// The near plane cuts a ball at the first place, and does not cut a ball at the second place.
fn places() -> [Transform; 2] {
    [vec3!(-0.8, 0.3, 1.5), vec3!(0.8, 0, -1)].map(Transform::translate)
}

fn sun() -> Light {
    Light::new(vec3!(1, 2, 1), fx!(0.2), fx!(0.8)).unwrap()
}

/// The frame, drawn in bands of six rows, and whether texture coordinates were missing.
fn frame(mut draw: impl FnMut(&mut Canvas<'_, Gray8>) -> Drawn) -> (Vec<Gray8>, bool) {
    let (mut all, mut drawn) = (Vec::new(), Drawn::default());
    for first in (0..HEIGHT).step_by(6) {
        let mut color = vec![Gray8::BLACK; (WIDTH * 6) as usize];
        drawn += draw(&mut Canvas::band(&mut color, WIDTH, HEIGHT, first).unwrap());
        all.extend(color);
    }
    (all, drawn.missing.uvs)
}

/// A shader that counts how often it is asked for varyings. Its varyings are a value at each corner, and a value of the
/// whole face.
#[derive(Clone, Copy)]
struct Counting<'c>(&'c Cell<u32>);

impl Shader for Counting<'_> {
    type Color = Gray8;
    type Varyings = ([i32; 1], PerFace<u8>);

    fn varyings(&self, primitive: &Primitive) -> [Self::Varyings; 3] {
        self.0.set(self.0.get() + 1);
        let side = if primitive.is_front() { 60 } else { 20 };
        primitive.corners(|corner| {
            let height = corner.position().y.to_bits() >> 10;
            ([height + corner.uv().x.to_bits()], PerFace(side))
        })
    }

    fn shade(&self, _: &Fragment, ([height], PerFace(side)): Self::Varyings) -> Option<Gray8> {
        let height = u8::try_from((height + 64).clamp(0, 128)).unwrap();
        Some(Gray8::new(side + height))
    }
}

macro_rules! check {
    ($thing:expr, $shader:expr) => {{
        let (mut list, mut memory): (List, _) = (DrawList::new(), ShadeList::new());
        let memory: &mut ShadeList<_, 400> = &mut memory;
        let options = DrawOptions::new().with_cull(Cull::Nothing);
        for place in places() {
            let (thing, shader) = ($thing, $shader);
            let prepared = list
                .prepare(&options, SIZE, thing, &(view() * place))
                .unwrap();
            let expected = frame(|band| band.draw_prepared(&prepared, &shader).unwrap());
            assert!(expected.0.iter().any(|pixel| pixel.luma() > 0));
            let stored = prepared.shade(memory, |()| shader).unwrap()(&());
            let found = frame(|band| band.draw_prepared(&prepared, &stored).unwrap());
            assert!(found == expected);
        }
    }};
}

#[test]
fn light_computed_once_draws_the_same_pixels() {
    let (white, asked) = (Flat::new(Gray8::WHITE), Cell::new(0));
    check!(&BALL, white.lit(sun()));
    check!(&BALL, white.lit_faces(sun()));
    check!(&RING.without_normals(), white.lit(sun()));
    check!(&BALL.without_uvs(), Counting(&asked));
    check!(&BALL, Counting(&asked));
    check!(BALL.edges(LineStyle::HAIRLINE), Counting(&asked));
    let wide = LineStyle::wide(fx!(3)).unwrap();
    check!(BALL.outline(&OUTLINE, wide.smooth()), Counting(&asked));
}

#[test]
fn a_shader_is_asked_once_for_each_visible_triangle() {
    let (asked, mut list) = (Cell::new(0), List::new());
    let (shader, mut memory) = (Counting(&asked), ShadeList::<_, 400>::new());
    let (options, mvp) = (DrawOptions::new(), view() * places()[1]);
    let ball = list.prepare(&options, SIZE, &BALL, &mvp).unwrap();
    let stored = ball.shade(&mut memory, |()| shader).unwrap()(&());
    let visible = asked.get();
    let (expected, _) = frame(|band| band.draw_prepared(&ball, &stored).unwrap());
    assert_eq!(asked.get(), visible);
    frame(|band| band.draw_prepared(&ball, &shader).unwrap());
    assert!(asked.get() > visible * 2);

    // If something else is drawn with the stored values, the shader is asked again.
    let before = asked.get();
    let (found, _) = frame(|band| band.draw(&BALL, &mvp, &stored));
    assert!(found == expected && asked.get() > before);
    let mut other = List::new();
    let mvp = view() * places()[0];
    let other = other.prepare(&options, SIZE, &BALL, &mvp).unwrap();
    let (found, _) = frame(|band| band.draw_prepared(&other, &stored).unwrap());
    let (expected, _) = frame(|band| band.draw_prepared(&other, &shader).unwrap());
    assert!(found == expected);

    let mut short = ShadeList::<_, 9>::new();
    let error = ball.shade(&mut short, |()| shader).map(|_| ()).unwrap_err();
    let message = format!(
        "{visible} triangles are visible: the list must have room for all, and has room for 9"
    );
    assert_eq!(error.to_string(), message);
}

/// Each object has its own material, and objects with different materials alternate in the sorted list.
#[test]
fn the_objects_of_a_scene_are_shaded_by_their_materials() {
    let lit = |gray| Flat::new(Gray8::new(gray)).lit(sun());
    let tilted = Transform::rotate_x(deg!(70)) * Transform::scale(fx!(1.3));
    let mut objects = [
        Object::new(&BALL, Transform::scale(fx!(0.6)), lit(250)),
        Object::new(&RING, tilted, lit(120)),
        Object::new(&BALL, places()[0], lit(60)),
    ];
    let (mut list, mut memory) = (List::new(), ShadeList::<_, 600>::new());
    let (options, view) = (DrawOptions::new(), view());
    let scene = list
        .prepare_back_to_front(&options, SIZE, &mut objects, &view)
        .unwrap();
    let stored = scene.shade(&mut memory, |&material| material).unwrap();
    let drawn = |is_stored: bool| {
        frame(|band| {
            let mut drawn = Drawn::default();
            for (shader, part) in scene.parts(band).unwrap() {
                drawn += if is_stored {
                    band.draw_prepared(&part, &stored(shader)).unwrap()
                } else {
                    band.draw_prepared(&part, shader).unwrap()
                };
            }
            drawn
        })
    };
    assert!(drawn(true) == drawn(false));
}
