//! Clipping: pixels are drawn only inside the view volume, are drawn once, and agree with the f64 model.
//!
//! Tolerances: rounding moves a corner by at most 1/512 pixel along each axis, so an edge moves by at most √2/512 =
//! 0.0028 pixel. Rounding in clip space adds less than 0.001 pixel in scenes of some hundred units (coefficients of 30
//! bits: 2⁻²⁹ · 256 units / 0.25 of the near plane · 100 pixels from the center = 5e-5). So a pixel may be drawn or not
//! if its center is nearer than [`EDGE`] = 1/256 pixel to an edge. The crate's near and far planes equal the
//! projection's planes in the first 28 bits. The model draws twice: with planes moved inwards by the fraction
//! [`PLANES`], and with planes moved outwards by the same fraction. A test judges only the pixels on which both results
//! agree.

use std::array::from_fn;
use std::collections::HashMap;

use embedded_graphics::pixelcolor::Gray8;
use fixel::prelude::*;
use rand::Rng;
use support::counter::{BOTH_SIDES, Counter};
use support::meshes::{Point, triangulation};
use support::random::{Random, cases, list, within};
use support::recorder::{Probe, Seen, record};
use support::reference::coverage::{Bounds, center};
use support::reference::distance::to_segment;
use support::reference::linear::{self, IDENTITY};
use support::reference::silhouette::{Position, Silhouette};
use support::reference::{projection, raster, view};

const SIZE: (u32, u32) = (48, 32);
const NEAR: f64 = 0.25;
const FAR: f64 = 24.;
const FOCAL: u16 = 30;
/// Within this distance of an edge, in pixels, rounding decides whether a center is covered.
const EDGE: f64 = 1. / 256.;
/// √2/512 and the error of clip space, in pixels. Where two sides of a triangle are this near to a center, rounding can
/// swap the sides.
const FOLD: f64 = 0.0029;
/// The planes are moved by this fraction of their distance, 2⁻²⁴.
const PLANES: f64 = 1. / 16_777_216.;

fn projection() -> Projection<fixel::view::Perspective> {
    Projection::from_focal_length(Scalar::try_from(FOCAL).unwrap(), SIZE, fx!(0.25), fx!(24))
        .unwrap()
}

/// The model's view. The near and far planes of this view are moved outwards by a fraction of their distance.
fn model_view(outwards: f64) -> view::View {
    let (near, far) = (NEAR * (1. - outwards), FAR * (1. + outwards));
    view::View {
        eye: IDENTITY,
        projection: projection::focal(FOCAL.into(), SIZE, near, far),
        viewport: view::Viewport::new(SIZE.0, SIZE.1),
    }
}

fn floats(positions: &[Vec3]) -> Vec<[f64; 3]> {
    let float = |bits: i32| f64::from(bits) / 65536.;
    positions.iter().map(|p| p.to_bits().map(float)).collect()
}

/// The model's silhouettes: with planes moved a little inwards, and with planes moved a little outwards.
struct Model {
    inner: Silhouette,
    outer: Silhouette,
    /// The sides of the clipped triangles, each listed once.
    sides: Vec<[[f64; 2]; 2]>,
}

/// The sides of each face's visible part, without the sides between the pieces of the part.
fn sides<const N: usize>(pieces: &[raster::Piece<N>]) -> Vec<[[f64; 2]; 2]> {
    let key = |side: [[f64; 2]; 2]| side.map(|end| end.map(f64::to_bits));
    let mut all = HashMap::new();
    for face in pieces.chunk_by(|a, b| a.face == b.face) {
        let mut own = HashMap::new();
        for [a, b, c] in face.iter().map(|piece| piece.screen) {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let side = if from < to { [from, to] } else { [to, from] };
                own.entry(key(side)).or_insert((side, 0)).1 += 1;
            }
        }
        all.extend(own.into_iter().filter(|&(_, (_, times))| times == 1));
    }
    all.into_values().map(|(side, _)| side).collect()
}

impl Model {
    fn new(positions: &[Vec3], faces: &[[u16; 3]]) -> Self {
        let positions = floats(positions);
        let faces: Vec<_> = faces.iter().map(|face| face.map(usize::from)).collect();
        let pieces = |outwards: f64| {
            let mesh = raster::Mesh {
                positions: &positions,
                faces: &faces,
                attributes: &vec![[[0.; 0]; 3]; faces.len()],
            };
            raster::pieces(&mesh, &model_view(outwards))
        };
        let outline = |pieces: &[raster::Piece<0>]| {
            let corners: Vec<_> = pieces.iter().map(|piece| piece.screen).collect();
            Silhouette::new(&corners, SIZE.0, SIZE.1)
        };
        let inner = pieces(-PLANES);
        Self {
            inner: outline(&inner),
            outer: outline(&pieces(PLANES)),
            sides: sides(&inner),
        }
    }

    /// Whether a pixel is covered; `None` where the crate's rounding decides.
    fn covers(&self, pixel: [i32; 2]) -> Option<bool> {
        if self.inner.classify(center(pixel), EDGE) == Position::Inside {
            Some(true)
        } else if self.outer.classify(center(pixel), EDGE) == Position::Outside {
            Some(false)
        } else {
            None
        }
    }

    /// Whether two sides pass so near to a pixel's center that rounding of their ends can swap the sides. A triangle
    /// this thin can turn over, and then it overlaps its neighbors.
    fn may_fold(&self, pixel: [i32; 2]) -> bool {
        let near = |[a, b]: &[[f64; 2]; 2]| to_segment(*a, *b, center(pixel)) < FOLD;
        self.sides.iter().filter(|side| near(side)).count() > 1
    }

    /// Compares the counts of drawn pixels with the model. A pixel may be drawn twice only where a triangle can fold.
    fn check(&self, counts: &[u32]) {
        for (&count, pixel) in counts.iter().zip(Bounds::new(SIZE.0, SIZE.1).pixels()) {
            let expected = self.covers(pixel);
            assert!(
                expected.is_none_or(|covered| covered == (count > 0)),
                "{pixel:?}: drawn {count} times, covered in the model: {expected:?}"
            );
            assert!(
                count < 2 || self.may_fold(pixel),
                "{pixel:?}: drawn {count} times"
            );
        }
    }
}

fn count(
    positions: &[Vec3],
    faces: &[[u16; 3]],
    options: &DrawOptions,
) -> (Vec<u32>, fixel::Drawn) {
    let mut counter = Counter::new(SIZE);
    let mesh = Mesh::new(positions, faces).unwrap();
    let drawn = counter.draw(options, &mesh, &projection().into());
    (counter.take(), drawn)
}

/// One unit of space, in units of 2⁻¹⁶.
const UNIT: i32 = 1 << 16;

/// A position anywhere around the eye. The position can be close to the near plane, at the far plane, behind the eye,
/// or far to the side.
fn around(random: &mut Random) -> Vec3 {
    let [x, y] = from_fn(|_| {
        let reach = match random.random_range(0..7) {
            0..4 => 3 * UNIT,
            4..6 => 30 * UNIT,
            _ => 200 * UNIT,
        };
        random.random_range(-reach..reach)
    });
    let z = match random.random_range(0..9) {
        0..4 => random.random_range(-30 * UNIT..10 * UNIT),
        4..6 => random.random_range(-UNIT / 2..UNIT / 8),
        6 => random.random_range(-26 * UNIT..-22 * UNIT),
        7 => -UNIT / 4,
        _ => 0,
    };
    Vec3::from_bits([x, y, z])
}

/// Returns a function of the position on the screen. The function gives 1/w on the triangle's plane, and the gradient
/// of 1/w. On the plane N·P = D, the ray (dx, dy, −1) through a pixel has 1/w = N·ray / D.
fn inverse_w(corners: [Vec3; 3]) -> impl Fn([f64; 2]) -> (f64, f64) {
    let p = floats(&corners);
    let n = linear::cross(linear::subtract(p[1], p[0]), linear::subtract(p[2], p[0]));
    let d = linear::dot(n, p[0]);
    move |[x, y]: [f64; 2]| {
        let focal = f64::from(FOCAL);
        let ray = [
            (x - f64::from(SIZE.0) / 2.) / focal,
            (f64::from(SIZE.1) / 2. - y) / focal,
            -1.,
        ];
        let gradient = (n[0] / focal / d).hypot(n[1] / focal / d);
        (linear::dot(n, ray) / d, gradient)
    }
}

/// A triangle anywhere around the eye is drawn exactly where the model covers it between the near and far planes. Each
/// pixel has the distance of the triangle's plane.
#[test]
fn triangles_around_the_eye_are_the_models() {
    cases(512, |random| {
        let corners = from_fn(|_| around(random));
        let (counts, drawn) = count(&corners, &[[0, 1, 2]], &BOTH_SIDES);
        Model::new(&corners, &[[0, 1, 2]]).check(&counts);
        let all: u32 = counts.iter().sum();
        assert!(
            drawn.drawn > 0 || all == 0,
            "{corners:?}: {all} pixels of no triangle"
        );

        let mut pixels = vec![Gray8::new(0); counts.len()];
        let mesh = Mesh::new(&corners, &[[0, 1, 2]]).unwrap();
        let mut canvas = Canvas::new(&mut pixels, SIZE.0, SIZE.1).unwrap();
        // The probe interpolates the distance.
        let probe = Probe {
            values: &|corner| [corner.distance().to_bits()],
            color: None::<Gray8>,
        };
        let record = record(probe, |recorder| {
            canvas.draw_with(&BOTH_SIDES, &mesh, &projection(), recorder);
        });
        let plane = inverse_w(corners);
        for Seen {
            pixel,
            values: [distance],
            depth,
            ..
        } in record.seen
        {
            let w = f64::from(distance) / 65536.;
            // The corners' distances are below 64 (2^22 units), so the interpolant is distance · q · 2^-24, and q is at
            // least 2^30 · near/w. As bounds.rs derives, the errors of distance and q count as at most 56½ units of the
            // interpolant. In this small picture, they stay within 51 units.
            let q = f64::from(1 << 30) * NEAR / FAR;
            let format = (f64::from(1 << 24) * 51. / q + 4.) / 65536.;
            assert!(
                (NEAR - format..=FAR + format).contains(&w),
                "{pixel:?}: {w}"
            );
            // Rounding has moved corners by less than EDGE, so the plane has this 1/w somewhere within EDGE of the
            // pixel's center.
            let (exact, gradient) = plane(center(pixel));
            let room = gradient * EDGE + 1e-6;
            let nearest = 1. / (exact + room);
            assert!(
                w > nearest - format,
                "{pixel:?}: {w} is nearer than {nearest}"
            );
            if exact > room {
                let farthest = 1. / (exact - room);
                assert!(
                    w < farthest + format,
                    "{pixel:?}: {w} is farther than {farthest}"
                );
            }
            // Depth is rounded down. The error of 1/w, up to 40 units, is 40 · 2^-15 of a step.
            let step = 65535. * NEAR;
            let (least, most) = (step * (exact - room) - 1.01, step * (exact + room) + 0.01);
            assert!(
                (least..=most).contains(&f64::from(depth)),
                "{pixel:?}: {depth} not in {least}..{most}"
            );
        }
    });
}

/// A plane near the eye, as a map from positions of the mesh to space.
#[derive(Clone, Copy, Debug)]
struct Ground {
    /// The position in space of the mesh's origin.
    origin: [i32; 3],
    /// The changes of position per unit of the mesh's x and y.
    steps: [[i32; 3]; 2],
}

impl Ground {
    fn position(&self, [u, v]: Point) -> Vec3 {
        let [a, b] = self.steps;
        Vec3::from_bits([0, 1, 2].map(|i| self.origin[i] + u * a[i] + v * b[i]))
    }
}

/// A floor, a ceiling, a wall or tilted ground. The plane reaches from behind the eye to beyond the far plane.
fn ground(random: &mut Random) -> Ground {
    let side = if random.random() { 1 } else { -1 };
    let height = side * random.random_range(UNIT / 8..2 * UNIT);
    let [across, along] = from_fn(|_| random.random_range(-6..=6));
    let wall = random.random();
    // The mesh's y points ahead. The tilt is small, so that the horizon is visible.
    let (x, y) = ([32, across, 0], [0, along, -32]);
    let turn = |[a, b, c]: [i32; 3]| if wall { [b, a, c] } else { [a, b, c] };
    Ground {
        origin: turn([0, height, 0]),
        steps: [turn(x), turn(y)],
    }
}

/// The ground continues below the eye and behind the eye. The triangles of the ground have all shapes.
#[test]
fn meshes_through_the_near_plane_are_the_models() {
    cases(128, |random| {
        let ground = ground(random);
        let points = list(random, 0..16, |random| {
            // 2^11 mesh units are one unit of space.
            let ranges = match random.random_range(0..3) {
                0 => [-8000..8000, -8000..8000],
                1 => [-2000..2000, 0..3000],
                _ => [-30_000..30_000, -20_000..60_000],
            };
            let [x, y] = within(random, ranges);
            [x, -y]
        });
        let (left, right, back, front) = (-40_000, 40_000, -20_000, 60_000);
        let corners = [[left, front], [left, back], [right, back], [right, front]];
        let corners = corners.map(|[x, y]| [x, -y]);
        let mesh = triangulation(corners, &points).shuffled(random.random(), true);
        let positions: Vec<Vec3> = mesh
            .points
            .iter()
            .map(|&[x, y]| ground.position([x, -y]))
            .collect();
        let (counts, drawn) = count(&positions, &mesh.faces, &BOTH_SIDES);
        assert!(drawn.clipped > 0, "{ground:?}: {mesh:?}");
        Model::new(&positions, &mesh.faces).check(&counts);
    });
}

/// The near and far planes both clip each of these thin triangles, so four of its corners are new and rounded. A
/// clipped triangle is only a few subpixels wide at the far end, so rounding can make its outline cross itself there.
/// In this case, the triangles of the outline's fan overlap, but no pixel may be drawn twice.
#[test]
fn thin_clipped_triangles_draw_each_pixel_once() {
    // Rounding decides which triangles fold over a pixel's center. Only few triangles fold, so the test draws many.
    let mut drawn = 0;
    for height in (10_000..60_000).step_by(100) {
        let place = |[u, v]: Point| Vec3::from_bits([32 * u, height + u + 5 * v, -32 * v]);
        // The third corner is 96 to 24 mesh units away from the line between the first two.
        for across in [96, 72, 48, 24] {
            let corners = [
                [40_000, -20_000],
                [-40_000, 60_000],
                [-17_121 + across, 37_121],
            ]
            .map(place);
            for face in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
                let (counts, _) = count(&corners, &[face], &BOTH_SIDES);
                assert!(
                    counts.iter().all(|&count| count <= 1),
                    "{corners:?}, {face:?}"
                );
                drawn += counts.iter().sum::<u32>();
            }
        }
    }
    // The triangles are thin, but together they have 921 pixels.
    assert!(drawn > 800, "{drawn} pixels");
}

/// Positions inside the view volume, and three positions beyond each of its planes: near (some behind the eye), far,
/// left, right, bottom, top. The last four planes are the sides of the guard band, ±2048 pixels. At a distance of 4 and
/// with a focal length of 30 pixels, these sides are 273 units from the axis.
const INSIDE: [[f64; 3]; 3] = [[-1., -1., -4.], [1.5, -0.5, -5.], [0., 1., -3.]];
const BEYOND: [[[f64; 3]; 3]; 6] = [
    [[-0.5, 0.25, -0.125], [0.5, 0.5, 2.], [1., -1., 0.]],
    [[-3., 1., -40.], [5., 2., -25.], [0., -6., -100.]],
    [[-400., 1., -4.], [-300., 50., -4.], [-500., -100., -4.5]],
    [[400., 1., -4.], [300., 50., -4.], [500., -100., -4.5]],
    [[1., -400., -4.], [50., -300., -4.], [-100., -500., -4.5]],
    [[1., 400., -4.], [50., 300., -4.], [-100., 500., -4.5]],
];

/// For each plane: triangles with one, two and three corners beyond the plane.
#[test]
fn each_plane_clips_one_two_and_three_corners() {
    for (plane, beyond) in BEYOND.iter().enumerate() {
        for outside in 0..=3 {
            let corners = [0, 1, 2].map(|i| if i < outside { beyond[i] } else { INSIDE[i] });
            let corners = corners.map(|p| Vec3::try_from(p).unwrap());
            for face in [[0, 1, 2], [1, 2, 0], [2, 1, 0]] {
                let (counts, drawn) = count(&corners, &[face], &BOTH_SIDES);
                Model::new(&corners, &[face]).check(&counts);
                let (seen, clipped) = (outside < 3, outside == 1 || outside == 2);
                assert_eq!(
                    (drawn.drawn, drawn.clipped),
                    (u32::from(seen), u32::from(clipped)),
                    "{outside} corners beyond plane {plane}"
                );
                assert_eq!(counts.iter().any(|&count| count > 0), seen);
            }
        }
    }
}

/// Without clipping, an object behind the eye would appear as a mirror image, because w is negative.
#[test]
fn nothing_behind_the_eye_is_drawn() {
    let mirrored = INSIDE.map(|[x, y, z]| [-x, -y, -z]);
    let touching = [[-1., -1., 0.], [1., -1., 0.], [0., 1., 0.25]];
    for corners in [mirrored, touching] {
        let corners = corners.map(|p| Vec3::try_from(p).unwrap());
        let edges = [[0, 1], [1, 2], [2, 0]];
        let mesh = Mesh::new(&corners, &[[0, 1, 2]])
            .unwrap()
            .with_edges(&edges)
            .unwrap();
        let mut counter = Counter::new(SIZE);
        let mvp = projection().into();
        assert_eq!(counter.draw(&BOTH_SIDES, &mesh, &mvp).drawn, 0);
        assert_eq!(counter.draw_edges(&BOTH_SIDES, &mesh, &mvp).drawn, 0);
        assert_eq!(counter.draw_points(&BOTH_SIDES, &mesh, &mvp).drawn, 0);
        assert!(counter.take().iter().all(|&count| count == 0));
    }
}

/// Ground below the eye reaches from far behind the eye to the far plane. The ground ends at the far plane, below the
/// horizon, and covers all pixels below this end. The far plane is 24 units away, so the ground ends 30/24 = 1¼ rows
/// below the middle, and centers from 17.5 down show ground.
#[test]
fn ground_fills_the_picture_up_to_the_far_plane() {
    let ground = [
        [-100., -1., 100.],
        [100., -1., 100.],
        [100., -1., -100.],
        [-100., -1., -100.],
    ];
    let ground = ground.map(|p| Vec3::try_from(p).unwrap());
    let (counts, drawn) = count(&ground, &[[0, 1, 2], [0, 2, 3]], &DrawOptions::new());
    assert!(drawn.clipped > 0);
    for (&count, [x, y]) in counts.iter().zip(Bounds::new(SIZE.0, SIZE.1).pixels()) {
        assert_eq!(count, u32::from(y >= 17), "column {x}, row {y}");
    }
}

/// The largest viewport ends where the guard band ends. At this end, too, no pixel may be lost or drawn twice.
#[test]
fn a_viewport_as_wide_as_the_guard_band_is_filled_once() {
    let size = (2048, 24);
    let wide = DrawOptions::new().with_viewport(Viewport::new(-1024, -12, 4096, 48).unwrap());
    let projection =
        Projection::perspective(Angle::from_degrees(90), (4096, 48), fx!(0.25), fx!(24)).unwrap();
    let wall = [
        [-9000., -900., -3.],
        [9000., -800., -3.],
        [8000., 700., -3.],
        [-7000., 900., -3.],
    ];
    let wall = wall.map(|p| Vec3::try_from(p).unwrap());
    let mut counter = Counter::new(size);
    let faces = [[0, 1, 2], [0, 2, 3]];
    let mesh = Mesh::new(&wall, &faces).unwrap();
    assert!(counter.draw(&wide, &mesh, &projection.into()).clipped > 0);
    assert!(counter.take().iter().all(|&count| count == 1));
}
