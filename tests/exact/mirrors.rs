//! Mirrored views: draw calls, lists, and values computed once for a list show the same sides of the same triangles.

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::ShadeList;
use fixel::prelude::*;
use fixel::shade::PerFace;

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
    let shades = solid.shade(&mut memory, |()| faces).unwrap();
    let shaded = picture(&|canvas| {
        canvas.draw_prepared(&solid, &shades.of(&faces)).unwrap();
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
