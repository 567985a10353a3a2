//! Closed surfaces with random corners have no cracks, and draw no pixel twice. The surfaces may cross themselves.
//!
//! Every ray that leaves a closed surface has met as many front faces as back faces. If the pixels of two neighbors
//! neither overlap nor leave a gap along their edge, the same holds at every pixel: seen from outside, it has as many
//! front faces as back faces; seen from inside a surface that is star-shaped around the eye, it has one back face more.
//! A crack or a pixel drawn twice breaks the sum. This also holds where edges are clipped, so these tests need no model.

use std::f64::consts::{PI, TAU};

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::Window;
use fixel::canvas::Add;
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use rand::Rng;
use rand::seq::SliceRandom;

use crate::bumpy::bumpy;
use support::counter::{BOTH_SIDES, Counter, at_subpixel, pixel_projection};
use support::drawing::Drawing;
use support::mode::Mode;
use support::moves::rounded;
use support::random::{Random, cases, list, sampled, within};
use support::reference::coverage::picture;

/// A row may have more than two spans of 64 pixels.
const SIZE: (u32, u32) = (136, 32);
/// A mode for each way to draw a span.
const MODES: [Mode; 7] = [
    Mode::Exact,
    Mode::Compact,
    Mode::Newton,
    Mode::Fast(fx!(0)),
    Mode::Fast(fx!(0.0625)),
    Mode::Fast(fx!(4)),
    Mode::Affine,
];

/// A closed surface, front faces outside.
#[derive(Debug)]
struct Closed {
    positions: Vec<Vec3>,
    faces: Vec<[u16; 3]>,
}

impl Closed {
    /// A ball with poles at ±y, and a random radius at each vertex. The surface is star-shaped around the origin. The
    /// corners of a triangle are less than 90° apart, so no point of it is nearer to the origin than 0.6/√3 = 0.34.
    fn ball(random: &mut Random) -> Self {
        let (columns, rows) = (random.random_range(5..9_u16), random.random_range(4..8_u16));
        let mut place = |row: u16, column: u16| {
            let [u, v] = [
                f64::from(column) / f64::from(columns),
                f64::from(row) / f64::from(rows),
            ];
            let ((sin, cos), (sin_u, cos_u)) = ((v * PI).sin_cos(), (u * TAU).sin_cos());
            let radius = random.random_range(0.6..1.5);
            rounded([sin * cos_u, cos, -sin * sin_u].map(|x| radius * x))
        };
        let mut positions = vec![place(0, 0), place(rows, 0)];
        for row in 1..rows {
            positions.extend((0..columns).map(|column| place(row, column)));
        }
        let at = |row: u16, column: u16| match row {
            0 => 0,
            _ if row == rows => 1,
            _ => 2 + (row - 1) * columns + column % columns,
        };
        let mut faces = Vec::new();
        for row in 0..rows {
            for column in 0..columns {
                let [a, b] = [at(row, column), at(row + 1, column)];
                let [c, d] = [at(row + 1, column + 1), at(row, column + 1)];
                let all = [[a, b, c], [a, c, d]];
                faces.extend(
                    all.into_iter()
                        .filter(|[a, b, c]| a != b && b != c && c != a),
                );
            }
        }
        Self { positions, faces }
    }

    /// A tetrahedron on which smaller ones stand: again and again, a face becomes a fan around a new point. The points
    /// may be anywhere, so faces cross each other, and some of them turn inside out.
    fn fans(random: &mut Random, point: impl Fn(&mut Random) -> Vec3) -> Self {
        let mut positions: Vec<Vec3> = (0..4).map(|_| point(random)).collect();
        let mut faces = vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [3, 2, 1]];
        for new in list(random, 0..40, &point) {
            let [a, b, c] = faces.swap_remove(random.random_range(0..faces.len()));
            let top = u16::try_from(positions.len()).unwrap();
            positions.push(new);
            faces.extend([[a, b, top], [b, c, top], [c, a, top]]);
        }
        faces.shuffle(random);
        Self { positions, faces }
    }

    fn mesh(&self) -> Mesh<'_> {
        Mesh::new(&self.positions, &self.faces).unwrap()
    }

    /// How often each pixel is drawn in a mode, in bands of `rows` rows.
    fn counts<K: ProjectionKind>(
        &self,
        mvp: Mvp<K>,
        mode: Mode,
        cull: Cull,
        rows: u32,
    ) -> Vec<u32> {
        let drawing = Drawing {
            size: SIZE,
            options: DrawOptions::new().with_cull(cull),
            mode,
            mesh: self.mesh(),
            mvp,
        };
        let mut counts = vec![0; (SIZE.0 * SIZE.1) as usize];
        let seen = drawing.all_in_bands::<3>(rows, &|corner| corner.position().to_bits());
        for [x, y] in seen.into_iter().map(|seen| seen.pixel) {
            counts[y as usize * SIZE.0 as usize + x as usize] += 1;
        }
        counts
    }

    /// Checks that each pixel has `more` back faces than front faces, in every mode and in bands. Returns the number of
    /// front faces at each pixel.
    fn check<K: ProjectionKind>(&self, mvp: Mvp<K>, rows: u32, more: u32) -> Vec<u32> {
        let mut first = None;
        for (mode, rows) in MODES
            .into_iter()
            .flat_map(|mode| [(mode, SIZE.1), (mode, rows)])
        {
            let counts = [Cull::Back, Cull::Front].map(|cull| self.counts(mvp, mode, cull, rows));
            let [fronts, backs] = &counts;
            let expected: Vec<u32> = fronts.iter().map(|count| count + more).collect();
            assert_eq!(
                picture(backs, SIZE.0),
                picture(&expected, SIZE.0),
                "{mode:?}, bands of {rows}: {self:?}"
            );
            assert!(
                first.get_or_insert(counts.clone()) == &counts,
                "{mode:?}, bands of {rows}"
            );
        }
        let [fronts, backs] = first.unwrap();
        for (cull, counts) in [(Cull::Back, &fronts), (Cull::Front, &backs)] {
            assert_eq!(&self.added(mvp, cull, rows), counts, "{cull:?}");
        }
        fronts
    }

    /// Adds one to a pixel for each face. Counts pixels that are stored, and not calls of a shader.
    fn added<K: ProjectionKind>(&self, mvp: Mvp<K>, cull: Cull, rows: u32) -> Vec<u32> {
        let mut grays = vec![Gray8::new(0); (SIZE.0 * SIZE.1) as usize];
        let options = DrawOptions::new().with_cull(cull).with_blending(Add);
        let bands = grays.chunks_mut((SIZE.0 * rows) as usize);
        for (first, grays) in (0..).step_by(rows as usize).zip(bands) {
            let mut band = Canvas::band(grays, SIZE.0, SIZE.1, first).unwrap();
            band.draw_with(&options, &self.mesh(), &mvp, &Flat::new(Gray8::new(1)));
        }
        grays.iter().map(|gray| gray.luma().into()).collect()
    }
}

/// A ball, or fans around points near the origin.
fn any(random: &mut Random) -> Closed {
    if random.random() {
        return Closed::ball(random);
    }
    Closed::fans(random, |random| {
        rounded([(); 3].map(|()| random.random_range(-1.2..1.2)))
    })
}

/// A random turn.
fn turn(random: &mut Random) -> Transform {
    let axis = Vec3::from_bits(within(random, [1..9999, -9999..9999, -9999..9999]));
    Transform::rotate(axis, Angle::from_bits(random.random())).unwrap()
}

/// The eye looks from near or far, with a wide angle or through a telescope, in which parts of the surface lie beyond
/// the guard band.
#[test]
fn closed_surfaces_have_no_cracks_from_outside() {
    let (mut seen, mut clipped) = (0, 0);
    cases(sampled(256), |random| {
        let closed = any(random);
        // No vertex is farther from the origin than 1.2 · √3 = 2.08, so the near plane cuts nothing.
        let (near, far) = (fx!(0.015_625), fx!(50));
        let focal = [fx!(25), fx!(70), fx!(9000), fx!(30_000)][random.random_range(0..4)];
        let projection = Projection::from_focal_length(focal, SIZE, near, far).unwrap();
        let away = rounded([0., 0., -random.random_range(2.1..4.)]);
        let mvp = projection * Transform::translate(away) * turn(random);
        let fronts = closed.check(mvp, random.random_range(1..20), 0);
        if closed.faces.len() == 4 {
            assert!(fronts.iter().all(|&count| count <= 1), "{closed:?}");
        }
        seen += fronts.iter().filter(|&&count| count > 0).count();
        let mut counter = Counter::new(SIZE);
        clipped += counter.draw(&BOTH_SIDES, &closed.mesh(), &mvp).clipped;
    });
    let (pixels, triangles) = (sampled(256) as usize * 500, sampled(256) / 2);
    println!("{seen} pixels, {clipped} clipped");
    assert!(
        seen > pixels && clipped > triangles,
        "{seen} pixels, {clipped} clipped"
    );
}

#[test]
fn closed_surfaces_have_no_cracks_in_parallel() {
    cases(sampled(256), |random| {
        let closed = any(random);
        let window = Window::centered(fx!(5.1), fx!(2.4));
        let projection =
            Projection::oblique(deg!(30), fx!(0.5), fx!(-9), window, fx!(-9), fx!(9)).unwrap();
        closed.check(projection * turn(random), random.random_range(1..20), 0);
    });
}

/// Corners lie on the centers of pixels, so that many edges cross centers, and the top-left rule decides. Some triangles
/// are larger than the picture.
#[test]
fn closed_surfaces_have_no_cracks_across_pixel_centers() {
    cases(sampled(256), |random| {
        let reach = [16, 40, 200][random.random_range(0..3)];
        let closed = Closed::fans(random, |random| {
            let [x, y] = within(random, [-reach..reach, -reach..reach]);
            let [x, y, _] = at_subpixel([68 + x, 16 + y].map(|at| at * 256 + 128)).to_bits();
            Vec3::from_bits([x, y, random.random_range(-60_000..60_000)])
        });
        closed.check(pixel_projection(SIZE), random.random_range(1..20), 0);
    });
}

/// The near plane cuts the triangles beside the eye. Each pixel of the picture must still show the surface: the visible
/// part of the near plane lies inside it, because its corners are at most 0.15 from the eye.
#[test]
fn closed_surfaces_have_no_cracks_from_inside() {
    let mut clipped = 0;
    cases(sampled(256), |random| {
        let closed = Closed::ball(random);
        let fov = Angle::from_degrees([130, 100, 20][random.random_range(0..3)]);
        let projection = Projection::perspective(fov, SIZE, fx!(0.015_625), fx!(50)).unwrap();
        let mvp = projection * turn(random);
        closed.check(mvp, random.random_range(1..20), 1);
        clipped += Counter::new(SIZE)
            .draw(&BOTH_SIDES, &closed.mesh(), &mvp)
            .clipped;
    });
    println!("{clipped} clipped");
    assert!(clipped > sampled(256) / 2, "{clipped}");
}

/// A surface with thousands of triangles, many of them smaller than a pixel.
#[test]
fn a_bumpy_surface_has_no_cracks() {
    let shape = bumpy();
    let index = |i: usize| u16::try_from(i).unwrap();
    let closed = Closed {
        positions: shape.positions.iter().map(|&p| rounded(p)).collect(),
        faces: shape.faces.iter().map(|face| face.map(index)).collect(),
    };
    cases(sampled(16), |random| {
        let projection = Projection::perspective(deg!(45), SIZE, fx!(0.0625), fx!(50)).unwrap();
        let mvp = projection * Transform::translate(vec3!(0, 0, -2.5)) * turn(random);
        let fronts = closed.check(mvp, random.random_range(1..20), 0);
        assert!(fronts.iter().filter(|&&count| count > 0).count() > 300);
    });
}
