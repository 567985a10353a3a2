//! Properties that users expect of everything that is drawn: mirrors show outsides, a face in the near plane is
//! visible, and shaders learn which face or edge they color.

use std::cell::RefCell;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::prelude::*;
use fixel::shade::PerFace;
use fixel::{Object, Primitive, ShadeList, Window};

use crate::List;

const SIZE: (u32, u32) = (64, 48);
const PIXELS: usize = (SIZE.0 * SIZE.1) as usize;

/// A wedge without symmetry, with sides of different colors.
static WEDGE: Mesh = Mesh::checked(Mesh::new(
    &[
        vec3!(-1, -1, 1),
        vec3!(2, -1, 0.5),
        vec3!(0, 1.5, 0),
        vec3!(0.5, -0.5, -1.5),
    ],
    &[[0, 1, 2], [1, 3, 2], [3, 0, 2], [0, 3, 1]],
));
static OUTLINE: Outline = outline!(WEDGE, deg!(180));
const COLORS: [Gray8; 4] = [
    Gray8::new(50),
    Gray8::new(100),
    Gray8::new(150),
    Gray8::new(200),
];

fn projection() -> Projection {
    Projection::perspective(deg!(50), SIZE, fx!(1), fx!(30)).unwrap()
}

/// The frame that `draw` leaves.
fn picture(draw: impl FnOnce(&mut Canvas<'_, Gray8>)) -> Vec<Gray8> {
    let mut color = vec![Gray8::BLACK; PIXELS];
    draw(&mut Canvas::new(&mut color, SIZE.0, SIZE.1).unwrap());
    color
}

/// A frame with left and right exchanged.
fn mirrored(mut frame: Vec<Gray8>) -> Vec<Gray8> {
    let rows = frame.chunks_mut(SIZE.0 as usize);
    rows.for_each(<[Gray8]>::reverse);
    frame
}

/// Two counts: the pixels that both frames draw in the same color, and all pixels that the first frame draws.
fn common([a, b]: [&[Gray8]; 2]) -> [usize; 2] {
    let drawn = a.iter().zip(b).filter(|(a, _)| **a != Gray8::BLACK);
    let (all, same): (Vec<_>, Vec<_>) = (
        drawn.clone().collect(),
        drawn.filter(|(a, b)| a == b).collect(),
    );
    [same.len(), all.len()]
}

/// A scene drawn through a mirror is the mirror image of the scene drawn without it, except for pixels with centers on
/// an edge.
#[test]
fn a_mirror_shows_the_mirror_image() {
    let pose = Transform::translate(vec3!(0.7, 0.2, -6)) * Transform::rotate_y(deg!(35));
    let sun = Light::new(vec3!(0, 1, 1), fx!(0.2), fx!(0.8)).unwrap();
    for mirror in [vec3!(-1, 1, 1), vec3!(-2, 2, 2)] {
        let [plain, mirror] = [Transform::IDENTITY, Transform::scale_axes(mirror)]
            .map(|first| projection() * first * pose);
        for cull in [Cull::Back, Cull::Front, Cull::Nothing] {
            let options = DrawOptions::new().with_cull(cull);
            let faces = |mvp: &Mvp| {
                picture(|canvas| {
                    canvas.draw_with(&options, &WEDGE, mvp, &FaceColors::new(&COLORS));
                })
            };
            let lines = |mvp: &Mvp| {
                picture(|canvas| {
                    let outline = WEDGE.outline(&OUTLINE, LineStyle::wide(fx!(3)).unwrap());
                    canvas.draw_with(&options, outline, mvp, &Flat::new(Gray8::WHITE));
                })
            };
            let listed = |mvp: &Mvp| {
                let mut list: List = DrawList::new();
                picture(|canvas| {
                    let wedge = list.prepare(&options, SIZE, &WEDGE, mvp).unwrap();
                    canvas
                        .draw_prepared(&wedge, &FaceColors::new(&COLORS))
                        .unwrap();
                })
            };
            let lit = |mvp: &Mvp| {
                let viewer = Viewer::of(mvp);
                picture(|canvas| {
                    let white = Flat::new(Gray8::WHITE).lit_faces(sun.two_sided(viewer));
                    canvas.draw_with(&options, &WEDGE, mvp, &white);
                })
            };
            assert_eq!(listed(&mirror), faces(&mirror));
            for draw in [&faces as &dyn Fn(&Mvp) -> Vec<Gray8>, &lines, &lit] {
                let (expected, found) = (mirrored(draw(&plain)), draw(&mirror));
                let [same, all] = common([&expected, &found]);
                assert!(
                    all > 120 && 100 * same >= 97 * all,
                    "{cull:?}: {same} of {all}"
                );
            }

            // A ray meets the face that is drawn at its pixel.
            let shown = faces(&mirror);
            let screen = Viewport::new(0, 0, SIZE.0, SIZE.1).unwrap();
            let mut met = 0;
            for (at, shown) in shown.iter().enumerate().filter(|(at, _)| at % 5 == 0) {
                let at = (at as u32).cast_signed();
                let pixel = Point::new(at % 64, at / 64);
                let ray = screen.ray(pixel, &mirror).unwrap();
                let ray = Ray { cull, ..ray };
                let color = ray.hit(&WEDGE).map_or(Gray8::BLACK, |hit| COLORS[hit.face]);
                // Without a depth buffer, the last face shows.
                met += usize::from(color == *shown || cull == Cull::Nothing);
            }
            assert!(met > 600, "{met}");
        }
    }
}

/// Two mirrors together do not mirror. A model without volume looks the same through a mirror.
#[test]
fn only_an_odd_number_of_mirrors_turns_culling_around() {
    let pose = Transform::translate(vec3!(0, 0, -6));
    let drawn = |factors: Vec3, cull: Cull| {
        let mvp = projection() * pose * Transform::scale_axes(factors);
        let options = DrawOptions::new().with_cull(cull);
        let mut count = 0;
        picture(|canvas| {
            count = canvas
                .draw_with(&options, &WEDGE, &mvp, &Flat::new(Gray8::WHITE))
                .drawn;
        });
        count
    };
    let tiny = Scalar::DELTA;
    for (factors, turned) in [
        (vec3!(1, 1, 1), vec3!(-1, -1, 1)),
        (vec3!(-1, 1, 1), vec3!(-1, -1, -1)),
        // These factors make the model as thin along z as the format allows.
        (
            Vec3::new(fx!(1), fx!(1), tiny),
            Vec3::new(fx!(-1), fx!(-1), tiny),
        ),
    ] {
        for factors in [factors, turned] {
            let [back, front] = [Cull::Back, Cull::Front].map(|cull| drawn(factors, cull));
            assert_eq!(back + front, drawn(factors, Cull::Nothing), "{factors}");
            assert!(back > 0, "{factors}");
        }
    }
    // The model is a thin needle. The side toward the viewer is its outside, through a mirror, too.
    let needle = shape_of_needle();
    for sign in [1, -1] {
        let factors = Vec3::new(Scalar::try_from(100 * sign).unwrap(), tiny * 16, tiny * 16);
        let mvp =
            projection() * Transform::translate(vec3!(0, 0, -2)) * Transform::scale_axes(factors);
        let mesh = Mesh::new(&needle, &[[0, 1, 2]]).unwrap();
        let canvas_pixels = &mut vec![Gray8::BLACK; PIXELS];
        let mut canvas = Canvas::new(canvas_pixels, SIZE.0, SIZE.1).unwrap();
        let submitted = |canvas: &mut Canvas<'_, Gray8>, cull| {
            let options = DrawOptions::new().with_cull(cull);
            let mut list: List = DrawList::new();
            let listed = list.prepare(&options, SIZE, &mesh, &mvp).unwrap();
            canvas
                .draw_prepared(&listed, &Flat::new(Gray8::WHITE))
                .unwrap()
                .drawn
        };
        assert_eq!(
            [Cull::Back, Cull::Front].map(|cull| submitted(&mut canvas, cull)),
            [1, 0],
            "{sign}"
        );
    }
}

/// A triangle that faces the viewer. The triangle is so tall that its image is still a pixel high after the test has
/// scaled it to a needle.
fn shape_of_needle() -> [Vec3; 3] {
    [vec3!(-0.5, -900, 0), vec3!(0.5, -900, 0), vec3!(0, 900, 0)]
}

/// The front face of a box is exactly at the distance of the near plane.
#[test]
fn a_face_in_the_near_plane_is_drawn() {
    static BOX: Mesh = shape!(cuboid(vec3!(2, 1.5, 0.7)));
    let front = BOX.part(0..BOX.faces().len());
    let window = Window::centered(fx!(8), fx!(6));
    for distance in 3..20 {
        let near = Scalar::try_from(distance).unwrap();
        let model = Transform::translate(Vec3::new(fx!(0), fx!(0), -near - fx!(0.7)));
        let oblique = Projection::oblique(deg!(30), fx!(0.5), near, window, near, near + fx!(3.3))
            .unwrap()
            * model;
        let flat = Projection::orthographic(window, near, near + fx!(7)).unwrap() * model;
        let perspective =
            Projection::perspective(deg!(90), (4, 3), near, near * 2).unwrap() * model;
        let (mut color, mut depth) = (vec![Gray8::BLACK; PIXELS], vec![0; PIXELS]);
        let canvas = Canvas::new(&mut color, SIZE.0, SIZE.1).unwrap();
        let mut canvas = canvas.with_depth(&mut depth).unwrap();
        let white = Flat::new(Gray8::WHITE);
        for drawn in [
            canvas.draw(&front, &oblique, &white),
            canvas.draw(&front, &flat, &white),
            canvas.draw(&front, &perspective, &white),
        ] {
            assert!(
                drawn.drawn >= 2 && drawn.clipped == 0,
                "{distance}: {drawn:?}"
            );
        }
        // The middle of the picture shows the front.
        let at = |canvas: &Canvas<'_, _, _, _>| canvas.pixels().nth(PIXELS / 2 + 32);
        assert_eq!(at(&canvas), Some(Gray8::WHITE), "{distance}");
        assert!(depth[PIXELS / 2 + 32] >= 65_534, "{distance}");
    }
}

/// Records the faces and edges for which varyings are asked.
#[derive(Clone, Copy)]
struct Asked<'a>(&'a RefCell<Vec<[Option<usize>; 2]>>);

impl Shader for Asked<'_> {
    type Color = Gray8;
    type Varyings = PerFace<u8>;

    fn varyings(&self, primitive: &Primitive<'_>) -> [PerFace<u8>; 3] {
        self.0
            .borrow_mut()
            .push([primitive.face(), primitive.edge()]);
        [PerFace(0); 3]
    }

    fn shade(&self, _: &Fragment, _: PerFace<u8>) -> Option<Gray8> {
        Some(Gray8::WHITE)
    }
}

/// A face of a part has its index in the whole mesh, an edge has its index in its list, and a point has no index.
/// Direct draw calls and prepared lists give the same indices.
#[test]
fn shaders_learn_which_face_or_edge_they_color() {
    let edges = [[0, 1], [1, 2], [2, 3]];
    let mesh = WEDGE.with_edges(&edges).unwrap();
    let mvp = projection() * Transform::translate(vec3!(0, 0, -6));
    let both = DrawOptions::new().with_cull(Cull::Nothing);
    let part = mesh.part(1..4).part(1..3);
    let (lines, outline) = (
        mesh.edges(LineStyle::HAIRLINE),
        mesh.outline(&OUTLINE, LineStyle::HAIRLINE),
    );
    let asked = |draw: &dyn Fn(&mut Canvas<'_, Gray8>, &Asked<'_>)| {
        let seen = RefCell::new(Vec::new());
        picture(|canvas| draw(canvas, &Asked(&seen)));
        let mut seen = seen.into_inner();
        // For the pixels at its two ends, a line asks for varyings again.
        seen.dedup();
        seen
    };
    let faces = |numbers: &[usize]| numbers.iter().map(|&n| [Some(n), None]).collect::<Vec<_>>();
    let numbers = |numbers: &[usize]| numbers.iter().map(|&n| [None, Some(n)]).collect::<Vec<_>>();
    let draw = asked(&|canvas, shader| _ = canvas.draw_with(&both, &part, &mvp, shader));
    assert_eq!(draw, faces(&[2, 3]));
    let draw = asked(&|canvas, shader| _ = canvas.draw_with(&both, lines, &mvp, shader));
    assert_eq!(draw, numbers(&[0, 1, 2]));
    let draw =
        asked(&|canvas, shader| _ = canvas.draw(mesh.points(PointStyle::PIXEL), &mvp, shader));
    assert_eq!(draw, [[None; 2]]);

    let listed = asked(&|canvas, shader| {
        let mut list: List = DrawList::new();
        let listed = list.prepare(&both, SIZE, &part, &mvp).unwrap();
        canvas.draw_prepared(&listed, shader).unwrap();
        let listed = list.prepare(&both, SIZE, outline, &mvp).unwrap();
        canvas.draw_prepared(&listed, shader).unwrap();
        // All objects of a scene are drawn with one shader.
        let mut objects = [Object::new(lines, Transform::IDENTITY, ()); 2];
        let scene = list.prepare(&both, SIZE, &mut objects, &mvp).unwrap();
        assert_eq!(canvas.draw_prepared(&scene, shader).unwrap().submitted, 6);
    });
    let (first, rest) = listed.split_at(2);
    assert_eq!(first, faces(&[2, 3]));
    let (outlined, rest) = rest.split_at(rest.len() - 6);
    let direct = asked(&|canvas, shader| _ = canvas.draw_with(&both, outline, &mvp, shader));
    assert_eq!(outlined, direct);
    assert!(direct.len() > 2);
    assert_eq!(rest, numbers(&[0, 1, 2, 0, 1, 2]));
}

/// Draws only faces with `is_front`. These faces must be the faces that are left after culling.
#[derive(Clone, Copy)]
struct Fronts;

impl Shader for Fronts {
    type Color = Gray8;
    type Varyings = PerFace<bool>;

    fn varyings(&self, face: &Primitive) -> [PerFace<bool>; 3] {
        [PerFace(face.is_front()); 3]
    }

    fn shade(&self, _: &Fragment, PerFace(is_front): PerFace<bool>) -> Option<Gray8> {
        is_front.then_some(Gray8::WHITE)
    }
}

#[test]
fn fronts_are_what_culling_leaves() {
    let all = DrawOptions::new().with_cull(Cull::Nothing);
    // At the last place, the near plane cuts the model.
    for place in [vec3!(0, 0, -5), vec3!(1, 0.5, -4), vec3!(0, 0, -2)] {
        for mirror in [vec3!(1, 1, 1), vec3!(-1, 1, 1)] {
            let model = Transform::translate(place) * Transform::rotate_y(deg!(40));
            let mvp = projection() * model * Transform::scale_axes(mirror);
            let white = Flat::new(Gray8::WHITE);
            let expected = picture(|canvas| _ = canvas.draw(&WEDGE, &mvp, &white));
            let found = picture(|canvas| _ = canvas.draw_with(&all, &WEDGE, &mvp, &Fronts));
            assert!(found == expected, "{place:?} {mirror:?}");
            let mut list = List::new();
            let listed = list.prepare(&all, SIZE, &WEDGE, &mvp).unwrap();
            let found = picture(|canvas| _ = canvas.draw_prepared(&listed, &Fronts).unwrap());
            assert!(found == expected, "{place:?} {mirror:?}, listed");
            let mut memory = ShadeList::<_, 8>::new();
            let fronts = listed.shade(&mut memory, |()| Fronts).unwrap()(&());
            let found = picture(|canvas| _ = canvas.draw_prepared(&listed, &fronts).unwrap());
            assert!(found == expected, "{place:?} {mirror:?}, stored");
        }
    }
}
