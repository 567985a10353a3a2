//! Mirrored views: draw calls, lists, and values computed once for a list show the same sides of the same triangles. Also
//! what mirrors and shadows promise about lights and culling.

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::prelude::*;
use fixel::shade::PerFace;
use fixel::{Primitive, ShadeList};

const SIZE: u32 = 32;

static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
static CREASES: Outline = outline!(BOX, deg!(30));

/// Shows a gray for each of the box's twelve triangles and for each of their sides, so that a picture shows which
/// triangles it has, and which sides they turn to the eye.
#[derive(Clone, Copy)]
struct Sides;

impl Shader for Sides {
    type Color = Gray8;
    type Varyings = PerFace<u8>;

    fn varyings(&self, primitive: &Primitive) -> [PerFace<u8>; 3] {
        let face = primitive.face().unwrap_or(0) as u8;
        [PerFace(10 * (face + 1) + u8::from(primitive.is_front())); 3]
    }

    fn shade(&self, _: &Fragment, PerFace(gray): PerFace<u8>) -> Option<Gray8> {
        Some(Gray8::new(gray))
    }
}

/// The pictures of the box and of its outline in a view: drawn directly, and from a list. Values that a shader computes
/// once give the same picture.
fn drawn(view: &Mvp, cull: Cull) -> [[Vec<Gray8>; 2]; 2] {
    let options = DrawOptions::new().with_cull(cull);
    let (faces, line) = (Sides, Flat::new(Gray8::WHITE));
    let outline = BOX.outline(&CREASES, LineStyle::HAIRLINE);
    let picture = |draw: &dyn Fn(&mut Canvas<'_, Gray8>)| {
        let mut pixels = vec![Gray8::BLACK; (SIZE * SIZE) as usize];
        draw(&mut Canvas::new(&mut pixels, SIZE, SIZE).unwrap());
        pixels
    };
    let mut list = DrawList::<100, 100>::new();
    let solid = list.prepare(&options, (SIZE, SIZE), &BOX, view).unwrap();
    let direct = picture(&|canvas| {
        canvas.draw_with(&options, &BOX, view, &faces);
    });
    let listed = picture(&|canvas| {
        canvas.draw_prepared(&solid, &faces).unwrap();
    });
    let mut memory = ShadeList::<_, 100>::new();
    let stored = solid.shade(&mut memory, |()| faces).unwrap()(&());
    let shaded = picture(&|canvas| {
        canvas.draw_prepared(&solid, &stored).unwrap();
    });
    assert!(shaded == listed, "{cull:?}");
    let mut list = DrawList::<100, 100>::new();
    let lines = list.prepare(&options, (SIZE, SIZE), outline, view).unwrap();
    let direct_lines = picture(&|canvas| {
        canvas.draw_with(&options, outline, view, &line);
    });
    let listed_lines = picture(&|canvas| {
        canvas.draw_prepared(&lines, &line).unwrap();
    });
    [[direct, listed], [direct_lines, listed_lines]]
}

#[test]
fn a_list_culls_mirrored_things_as_a_draw_call_does() {
    let projection = Projection::perspective(deg!(40), (SIZE, SIZE), fx!(1), fx!(9)).unwrap();
    let turn = Transform::rotate_x(deg!(25)) * Transform::rotate_y(deg!(35));
    let away = Transform::translate(vec3!(0, 0, -4));
    let (same, mirror) = (vec3!(1, 1, 1), vec3!(-1, 1, 1));
    for cull in [Cull::Back, Cull::Front, Cull::Nothing] {
        let views = [
            (same, same),
            (mirror, same),
            (same, mirror),
            (mirror, mirror),
        ];
        let pictures = views.map(|(camera, model)| {
            let camera = Camera::from_view(Transform::scale_axes(camera) * away);
            let view = projection * camera * (turn * Transform::scale_axes(model));
            let [[solid, listed], [lines, listed_lines]] = drawn(&view, cull);
            assert!(solid == listed, "{cull:?}, {camera:?}");
            assert!(lines == listed_lines, "{cull:?}, {camera:?}");
            let count = |pixels: &[Gray8]| pixels.iter().filter(|gray| gray.luma() > 0).count();
            assert!(count(&solid) > 50 && count(&lines) > 50, "{cull:?}");
            solid
        });
        // A box is its own mirror image, but its triangles change places.
        assert!(pictures[0] != pictures[1] && pictures[0] != pictures[2]);
    }
}

static RING: Mesh = shape!(torus(fx!(0.4), 24, 12));

fn picture(mesh: &Mesh, view: &Mvp, cull: Cull, shader: &impl ShaderFor<Gray8>) -> Vec<u8> {
    let mut pixels = [Gray8::BLACK; (SIZE * SIZE) as usize];
    let mut depths = [0; (SIZE * SIZE) as usize];
    let canvas = Canvas::new(&mut pixels, SIZE, SIZE).unwrap();
    let mut canvas = canvas.with_depth(&mut depths).unwrap();
    canvas.draw_with(&DrawOptions::new().with_cull(cull), mesh, view, shader);
    pixels.map(|gray| gray.luma()).to_vec()
}

/// The other way to draw a mirror image: the world is turned upside down, and its lights with it.
#[test]
fn a_mirrored_camera_shows_the_light_of_the_world() {
    let projection = Projection::perspective(deg!(40), (SIZE, SIZE), fx!(1), fx!(20)).unwrap();
    let camera = Camera::look_at(vec3!(1, 1, 6), vec3!(0, -1, 0), Vec3::Y).unwrap();
    let mirrored = camera.mirrored(vec3!(3, -1, 2), vec3!(0, 2, 0)).unwrap();
    let down = Transform::translate(vec3!(0, -2, 0)) * Transform::scale_axes(vec3!(1, -1, 1));
    let ring = Transform::rotate_x(deg!(25)) * Transform::rotate_z(deg!(20));
    let lamp = |to_lamp, viewer| {
        let sun = Light::new(to_lamp, fx!(0.25), fx!(0.5)).unwrap();
        sun.shiny(viewer, 20, fx!(0.25)).unwrap()
    };
    let to_sun = vec3!(1, 3, 2);
    let (inside, before) = (projection * mirrored, projection * camera);
    let white = Flat::new(Gray8::WHITE);
    let found = white.lit(lamp(to_sun, Viewer::of(&inside)));
    let expected = white.lit(lamp(down.direction(to_sun), Viewer::of(&before)));
    let [found, expected] = [
        picture(&RING, &(inside * ring), Cull::Back, &found),
        picture(&RING, &(before * down * ring), Cull::Back, &expected),
    ];
    // A sum of light and highlight is rounded to 255ths, from values with errors of less than 2^-12.
    let differs = |(a, b): (&u8, &u8)| a.abs_diff(*b) > 1;
    assert!(!found.iter().zip(&expected).any(differs));
    // The ring is lit from above, so the upper half of its mirror image is dark.
    let lit = |rows: &[u8]| rows.iter().filter(|gray| **gray > 100).count();
    let (above, below) = found.split_at(found.len() / 2);
    assert!(lit(above) * 4 < lit(below), "{} {}", lit(above), lit(below));
}

/// Where the shadow of a closed mesh covers a pixel, as many faces show their fronts as their backs.
#[test]
fn the_shadow_of_a_closed_mesh_needs_no_other_culling() {
    let projection = Projection::perspective(deg!(40), (SIZE, SIZE), fx!(1), fx!(20)).unwrap();
    let camera = Camera::look_at(vec3!(1, 5, 6), Vec3::ZERO, Vec3::Y).unwrap();
    let (ground, normal) = (vec3!(0, -1, 0), vec3!(1, 5, 1));
    let white = Flat::new(Gray8::WHITE);
    for to_sun in [vec3!(0, 1, 0), vec3!(1, 2, 0), vec3!(-2, 1, -1)] {
        let shadow = Transform::shadow(ground, normal, to_sun).unwrap();
        for turn in [0, 30, 75, 90].map(Angle::from_degrees) {
            let model = shadow * Transform::rotate_x(turn) * Transform::rotate_z(turn);
            for camera in [camera, camera.mirrored(Vec3::X, Vec3::X).unwrap()] {
                let view = projection * camera * model;
                for mesh in [&RING, &BOX] {
                    let [fronts, all] =
                        [Cull::Back, Cull::Nothing].map(|cull| picture(mesh, &view, cull, &white));
                    assert!(all.iter().filter(|gray| **gray > 0).count() > 20);
                    assert!(fronts == all, "{to_sun:?}, {turn:?}");
                }
            }
        }
    }
}
