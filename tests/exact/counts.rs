//! What a draw call counts: drawn, culled, outside the view; alike at once, in bands and from a list.

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::prelude::*;
use fixel::{Drawn, FacesOrEdges, Thing};
use rand::Rng;

use support::random::{cases, list};

const SIZE: (u32, u32) = (64, 48);

static BALL: Mesh = shape!(sphere(12, 8));
static RIMS: Outline = outline!(BALL, deg!(180));
/// Two triangles of the floor, so large that planes of the view always cut them.
static FLOOR: Mesh = Mesh::checked(Mesh::new(
    &[
        vec3!(-900, -1, -900),
        vec3!(900, -1, -900),
        vec3!(-900, -1, 900),
        vec3!(900, -1, 900),
    ],
    &[[0, 2, 1], [1, 2, 3]],
));

fn projection() -> Projection {
    Projection::perspective(deg!(60), SIZE, fx!(1), fx!(50)).unwrap()
}

/// The counts of a draw call: submitted, drawn, culled, outside.
fn counts(thing: impl Thing<Gray8>, cull: Cull, model: Transform) -> [u32; 4] {
    let mut pixels = vec![Gray8::BLACK; (SIZE.0 * SIZE.1) as usize];
    let mut canvas = Canvas::new(&mut pixels, SIZE.0, SIZE.1).unwrap();
    let options = DrawOptions::new().with_cull(cull);
    let white = Flat::new(Gray8::WHITE);
    let drawn = canvas.draw_with(&options, thing, &(projection() * model), &white);
    let Drawn {
        submitted,
        drawn: shown,
        culled,
        ..
    } = drawn;
    [submitted, shown, culled, drawn.outside()]
}

fn at(x: i16, y: i16, z: i16) -> Transform {
    Transform::translate(Vec3::from_ints(x, y, z))
}

#[test]
fn wrong_winding_and_behind_the_eye_are_told_apart() {
    let all = BALL.faces().len() as u32;
    // Faces that are turned away are culled, wherever they are in view.
    let [submitted, front, back, outside] = counts(&BALL, Cull::Back, at(0, 0, -2));
    assert_eq!((submitted, outside), (all, 0));
    assert!(front > all / 5 && back > all / 5 && front + back == all);
    assert_eq!(
        counts(&BALL, Cull::Front, at(0, 0, -2)),
        [all, back, front, 0]
    );
    assert_eq!(counts(&BALL, Cull::Nothing, at(0, 0, -2)), [all, all, 0, 0]);
    // Behind the eye, beyond the far plane, far beside the picture.
    for model in [
        at(0, 0, 4),
        at(0, 0, -60),
        at(3000, 0, -4),
        at(0, -3000, -4),
    ] {
        assert_eq!(counts(&BALL, Cull::Back, model), [all, 0, 0, all]);
    }
    // Beside the picture, but in the guard band: there, faces are culled as in the picture, unless the mesh has bounds.
    let beside = at(20, 0, -2);
    assert_eq!(counts(&BALL, Cull::Back, beside), [all, 0, 0, all]);
    let positions: Vec<Vec3> = BALL.positions().iter().collect();
    let bare = Mesh::new(&positions, BALL.faces()).unwrap();
    let [_, drawn, culled, outside] = counts(&bare, Cull::Back, beside);
    assert!(drawn == 0 && culled > all / 5 && outside > all / 5);
}

#[test]
fn clipped_triangles_are_culled_or_outside() {
    // The edge between the triangles runs along the line of sight.
    let turn = Transform::rotate_y(deg!(45));
    assert_eq!(counts(&FLOOR, Cull::Back, turn), [2, 2, 0, 0]);
    // With the wrong winding.
    assert_eq!(counts(&FLOOR, Cull::Front, turn), [2, 0, 2, 0]);
    // Cut by two planes until nothing is left: the triangle passes a corner of the guard band. One of its corners is on
    // the left, one is below, and one is both.
    let corners = [
        vec3!(-101, -96, -2),
        vec3!(-101, -192, -2),
        vec3!(-48, -160, -2),
    ];
    for face in [[0, 1, 2], [0, 2, 1]] {
        let faces = [face];
        let mesh = Mesh::new(&corners, &faces).unwrap();
        assert_eq!(counts(&mesh, Cull::Back, Transform::IDENTITY), [1, 0, 0, 1]);
    }
}

/// Triangles that contain no pixel center are outside; triangles without area are culled.
#[test]
fn small_triangles_are_outside_unless_they_have_no_area() {
    let small = |size: Scalar| {
        let corners = [
            vec3!(0.01, 0.01, -4),
            Vec3::new(fx!(0.01) + size, fx!(0.01), fx!(-4)),
            Vec3::new(fx!(0.01), fx!(0.01) + size, fx!(-4)),
        ];
        let mesh = Mesh::new(&corners, &[[0, 1, 2]]).unwrap();
        counts(&mesh, Cull::Back, Transform::IDENTITY)
    };
    assert_eq!(small(fx!(0.01)), [1, 0, 0, 1]);
    assert_eq!(small(fx!(0)), [1, 0, 1, 0]);
}

#[test]
fn edges_and_points_are_outside_and_outlines_choose() {
    let edges = BALL.edges(LineStyle::HAIRLINE);
    let all = BALL.edge_indices().len() as u32;
    assert_eq!(counts(edges, Cull::Back, at(0, 0, -2)), [all, all, 0, 0]);
    assert_eq!(counts(edges, Cull::Back, at(0, 0, 4)), [all, 0, 0, all]);
    let points = BALL.points(PointStyle::PIXEL);
    let all = BALL.positions().len() as u32;
    assert_eq!(counts(points, Cull::Back, at(0, 0, 4)), [all, 0, 0, all]);
    // The silhouette, and the edges that are not part of it.
    let outline = BALL.outline(&RIMS, LineStyle::HAIRLINE);
    let all = RIMS.edges().len() as u32;
    let [submitted, drawn, culled, outside] = counts(outline, Cull::Back, at(0, 0, -2));
    assert_eq!((submitted, outside), (all, 0));
    assert!(drawn > 8 && culled > 2 * drawn && drawn + culled == all);
    assert_eq!(counts(outline, Cull::Back, at(0, 0, 4)), [all, 0, 0, all]);
}

/// A mesh that was given no edges says so; an outline of the mesh has edges.
#[test]
fn a_mesh_without_edges_says_so() {
    let draw = |thing: FacesOrEdges<'_>| {
        let mut pixels = [Gray8::BLACK; 64];
        let mut canvas = Canvas::new(&mut pixels, 8, 8).unwrap();
        let (mvp, white) = (projection() * at(0, 0, -2), Flat::new(Gray8::WHITE));
        let direct = canvas.draw(thing, &mvp, &white).missing;
        let mut list: DrawList<400, 400> = DrawList::new();
        let options = DrawOptions::new();
        let prepared = list.prepare(&options, (8, 8), thing, &mvp).unwrap();
        let listed = canvas.draw_prepared(&prepared, &white).unwrap().missing;
        assert_eq!(direct, listed);
        direct.edges
    };
    let bare = BALL.without_edges();
    let style = LineStyle::HAIRLINE;
    assert!(draw(bare.edges(style).into()));
    assert!(!draw((&bare).into()));
    assert!(!draw(BALL.edges(style).into()));
    assert!(!draw(bare.outline(&RIMS, style).into()));
}

/// Each face is drawn with one of the two cullings that is drawn with none. A band and a list cull the same faces as a
/// frame does.
#[test]
fn counts_agree_between_cullings_bands_and_lists() {
    let (mut culled_in_view, mut clipped, mut outside) = (0, 0, 0);
    cases(500, |random| {
        let positions = list(random, 3..30, |random| {
            let range = [2, 20, 200][random.random_range(0..3)] << 16;
            let [x, y] = [(); 2].map(|()| random.random_range(-range..range));
            let z = random.random_range(-60 << 16..4 << 16);
            Vec3::from_bits([x, y, z])
        });
        let count = positions.len() as u16;
        let faces = list(random, 1..20, |random| {
            [(); 3].map(|()| random.random_range(0..count))
        });
        let mut mesh = Mesh::new(&positions, &faces).unwrap();
        if random.random() {
            mesh = mesh.with_bounds(mesh.bounds());
        }
        let mvp = projection() * Transform::rotate_z(Angle::from_bits(random.random()));
        let white = Flat::new(Gray8::WHITE);
        let mut pixels = vec![Gray8::BLACK; (SIZE.0 * SIZE.1) as usize];
        let [nothing, back, front] = [Cull::Nothing, Cull::Back, Cull::Front].map(|cull| {
            let options = DrawOptions::new().with_cull(cull);
            let mut canvas = Canvas::new(&mut pixels, SIZE.0, SIZE.1).unwrap();
            let whole = canvas.draw_with(&options, &mesh, &mvp, &white);
            let mut list: DrawList<400, 1200> = DrawList::new();
            let listed = list.prepare(&options, SIZE, &mesh, &mvp).unwrap();
            assert_eq!(canvas.draw_prepared(&listed, &white), Ok(whole));
            for first in [0, 16, 32] {
                let band = pixels.get_mut(..64 * 16).unwrap();
                let mut band = Canvas::band(band, SIZE.0, SIZE.1, first).unwrap();
                let drawn = band.draw_with(&options, &mesh, &mvp, &white);
                assert_eq!(drawn.culled, whole.culled);
                assert_eq!(band.draw_prepared(&listed, &white), Ok(drawn));
            }
            whole
        });
        assert_eq!(nothing.drawn, back.drawn + front.drawn);
        assert_eq!(nothing.clipped, back.clipped + front.clipped);
        // Under `Cull::Nothing`, only faces without area are culled: those that both others cull, too.
        let turned = back.culled + front.culled - 2 * nothing.culled;
        assert!(turned <= nothing.submitted - nothing.culled);
        culled_in_view += turned;
        clipped += nothing.clipped;
        outside += nothing.outside();
    });
    assert!(
        culled_in_view > 500 && clipped > 500 && outside > 100,
        "{culled_in_view} {clipped} {outside}"
    );
}

/// Draws a thing to a part of a frame. Returns the pixels, and what the draw call counts.
fn drawn<V: fixel::view::ProjectionKind>(
    thing: impl Thing<Gray8>,
    viewport: Viewport,
    mvp: &Mvp<V>,
) -> (Vec<Gray8>, Drawn) {
    let mut pixels = vec![Gray8::BLACK; (SIZE.0 * SIZE.1) as usize];
    let mut canvas = Canvas::new(&mut pixels, SIZE.0, SIZE.1).unwrap();
    let options = DrawOptions::new()
        .with_viewport(viewport)
        .with_cull(Cull::Front);
    let drawn = canvas.draw_with(&options, thing, mvp, &Flat::new(Gray8::WHITE));
    (pixels, drawn)
}

/// A mesh with bounds has the pixels and the counts of the mesh without, except that nothing is culled if the bounds are
/// out of view: then all is outside. Meshes of all sizes lie around the borders of the view, before and behind the
/// planes.
#[test]
fn bounds_change_no_pixel() {
    let (mut left_out, mut seen) = ([0; 6], [0; 6]);
    cases(2000, |random| {
        let size = 1 << random.random_range(8..21);
        let mut coordinate = |most: i32| random.random_range(-most..=most);
        let center = [
            coordinate(30 << 16),
            coordinate(30 << 16),
            coordinate(30 << 16) - (25 << 16),
        ];
        let positions = [(); 12].map(|()| Vec3::from_bits(center.map(|at| at + coordinate(size))));
        let faces: [[u16; 3]; 12] = [(); 12].map(|()| [(); 3].map(|()| random.random_range(0..12)));
        let edges: [[u16; 2]; 12] = [(); 12].map(|()| [(); 2].map(|()| random.random_range(0..12)));
        let bare = Mesh::new(&positions, &faces).unwrap();
        let bare = bare.with_edges(&edges).unwrap();
        let mut bounds = bare.bounds();
        if random.random() {
            // Bounds may be too large, as for a mesh that moves.
            let beyond = [(); 3].map(|()| random.random_range(-size..=size));
            bounds = bounds.with(bounds.most + Vec3::from_bits(beyond));
        }
        let kept = bare.with_bounds(bounds);
        let mut side = |most: i32| random.random_range(-most..most);
        let (x, y) = (side(64), side(48));
        let (width, height) = (random.random_range(1..=96), random.random_range(1..=72));
        let viewport = Viewport::new(x, y, width, height).unwrap();
        let turn = Transform::rotate_z(Angle::from_bits(random.random()))
            * Transform::rotate_x(Angle::from_bits(random.random_range(0..1 << 27)));
        let window = fixel::Window::centered(fx!(16), fx!(12));
        let parallel = Projection::orthographic(window, fx!(1), fx!(50)).unwrap();
        let is_parallel = random.random_range(0..4) == 0;
        let mut compare = |at: usize, draw: &dyn Fn(&Mesh<'_>) -> (Vec<Gray8>, Drawn)| {
            let ((pixels, of_bare), (same, of_kept)) = (draw(&bare), draw(&kept));
            assert!(pixels == same, "{positions:?} {viewport:?}");
            if of_kept == of_bare {
                seen[at] += u32::from(of_bare.drawn > 0);
            } else {
                let submitted = of_bare.submitted;
                let outside = Drawn {
                    submitted,
                    ..Drawn::default()
                };
                assert_eq!(of_kept, outside);
                // Lines and points count as drawn even beside the picture.
                assert!(of_bare.drawn == 0 || at > 0);
            }
            left_out[at] += u32::from(of_kept.outside() == of_kept.submitted);
        };
        let wide = LineStyle::wide(fx!(64)).unwrap();
        let large = PointStyle::round(fx!(60)).unwrap().attenuated();
        macro_rules! compare {
            ($mvp:expr) => {
                compare(0, &|mesh| drawn(mesh, viewport, $mvp));
                compare(1, &|mesh| {
                    drawn(mesh.edges(LineStyle::HAIRLINE), viewport, $mvp)
                });
                compare(2, &|mesh| drawn(mesh.edges(wide), viewport, $mvp));
                compare(3, &|mesh| drawn(mesh.edges(wide.smooth()), viewport, $mvp));
                compare(4, &|mesh| {
                    drawn(mesh.points(PointStyle::PIXEL), viewport, $mvp)
                });
                compare(5, &|mesh| drawn(mesh.points(large), viewport, $mvp));
            };
        }
        if is_parallel {
            compare!(&(parallel * turn));
        } else {
            compare!(&(projection() * turn));
        }
    });
    assert!(
        left_out.iter().chain(&seen).all(|&count| count > 100),
        "{left_out:?} {seen:?}"
    );
}

/// The compiler finds the bounds of meshes in flash. Each mesh leaves the view in each direction: no pixel is lost on the
/// way, and far out all is outside.
#[test]
fn meshes_in_flash_have_bounds() {
    static OWN: Mesh = Mesh::checked(Mesh::new(
        &[vec3!(-1, 2, 0), vec3!(-2, -1, 0.5), vec3!(3, 0, -2)],
        &[[0, 1, 2]],
    ));
    static SMALL_BALL: Mesh = shape!(sphere(12, 8), quantized);
    static SMALLEST_BALL: Mesh = shape!(sphere(12, 8), quantized_8);
    static HOUSE: Mesh = include_mesh!("../models/house.obj");
    static SMALL_HOUSE: Mesh = include_mesh!("../models/house.obj", quantized);
    static SMALLER_HOUSE: Mesh = include_mesh!("../models/house.obj", quantized_16);
    static SMALLEST_HOUSE: Mesh = include_mesh!("../models/house.obj", quantized_8);
    let viewport = Viewport::new(0, 0, SIZE.0, SIZE.1).unwrap();
    let window = fixel::Window::centered(fx!(16), fx!(12));
    let view = Projection::orthographic(window, fx!(1), fx!(21)).unwrap() * at(0, 0, -11);
    for mesh in [
        &OWN,
        &BALL,
        &SMALL_BALL,
        &SMALLEST_BALL,
        &HOUSE,
        &SMALL_HOUSE,
        &SMALLER_HOUSE,
        &SMALLEST_HOUSE,
    ] {
        let positions: Vec<Vec3> = mesh.positions().iter().collect();
        let bare = Mesh::new(&positions, mesh.faces()).unwrap();
        for direction in [Vec3::X, -Vec3::X, Vec3::Y, -Vec3::Y, Vec3::Z, -Vec3::Z] {
            for step in 0..100 {
                let mvp = view * Transform::translate(direction * (fx!(0.25) * step));
                let (pixels, of_bare) = drawn(&bare, viewport, &mvp);
                let (same, of_mesh) = drawn(mesh, viewport, &mvp);
                assert!(pixels == same, "{direction:?} {step}");
                if step == 99 {
                    assert_eq!((of_mesh.outside(), of_bare.drawn), (of_mesh.submitted, 0));
                } else if step == 0 {
                    assert_eq!(of_mesh, of_bare);
                }
            }
        }
    }
}
