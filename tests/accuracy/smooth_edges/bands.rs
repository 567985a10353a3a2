//! Bands that overlap are smoothed like the whole frame, bit for bit, and each pixel is mixed once.

use embedded_graphics::pixelcolor::{Gray8, GrayColor, Rgb888, RgbColor};
use fixel::Window;
use fixel::canvas::{Biased, DepthBuffer, FloatDepth, TestAndWrite, WideFloatDepth};
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use rand::Rng;
use rand::seq::IndexedRandom;
use support::counter::{BOTH_SIDES, pixel_projection};
use support::random::{Random, cases, sampled};

use super::{
    BALL, BOX, CAN, CREASES_OF_BOX, CREASES_OF_CAN, Frame, GROUND, Noise, OF_BALL, OF_BOX,
    OF_GROUND, angle, is_mixed_once, viewport,
};

/// A mesh, its outline, and where it is.
struct Body {
    mesh: &'static Mesh<'static>,
    outline: &'static Outline<'static>,
    place: Transform,
}

/// Bodies that overlap and cross each other, some in front of the near plane.
fn bodies(random: &mut Random) -> Vec<Body> {
    let all: [(&Mesh, &Outline); 5] = [
        (&BOX, &CREASES_OF_BOX),
        (&BOX, &OF_BOX),
        (&BALL, &OF_BALL),
        (&CAN, &CREASES_OF_CAN),
        (&GROUND, &OF_GROUND),
    ];
    let scalar = |number: f64| Scalar::try_from(number).unwrap();
    (0..random.random_range(1..5))
        .map(|_| {
            let &(mesh, outline) = all.choose(random).unwrap();
            let [x, y, z] = [1.2, 0.9, 1.].map(|reach| random.random_range(-reach..reach));
            let size = *[0.05, 0.4, 1., 1.4].choose(random).unwrap();
            let mirror = if random.random() { 1. } else { -1. };
            Body {
                mesh,
                outline,
                place: Transform::translate(Vec3::new(scalar(x), scalar(y), scalar(z)))
                    * Transform::rotate_x(angle(random))
                    * Transform::rotate_y(angle(random))
                    * Transform::scale_axes(Vec3::new(
                        scalar(mirror * size),
                        scalar(size),
                        scalar(size),
                    )),
            }
        })
        .collect()
}

const FRAME: (u32, u32) = (66, 52);

/// Draws in bands that each show some of the rows; a band has one row more at each end if `overlaps`.
fn in_bands<D: DepthBuffer>(
    heights: &[u32],
    overlap: u32,
    draw: &mut dyn FnMut(&mut Frame<'_, Rgb888, D>),
) -> Vec<Rgb888> {
    let (width, height) = FRAME;
    let mut shown = Vec::new();
    let mut heights = heights.iter().cycle();
    let mut row = 0;
    while row < height {
        let end = (row + heights.next().unwrap()).min(height);
        let (first, last) = (row.max(overlap) - overlap, (end + overlap).min(height));
        let mut colors = vec![Rgb888::BLACK; (width * (last - first)) as usize];
        let mut depths = vec![0; colors.len()];
        let band = Canvas::band(&mut colors, width, height, first).unwrap();
        let mut band = band.with_depth_format::<D>(&mut depths).unwrap();
        band.clear(Rgb888::BLACK);
        draw(&mut band);
        let from = (width * (row - first)) as usize;
        shown.extend(&colors[from..from + (width * (end - row)) as usize]);
        row = end;
    }
    shown
}

/// Checks random scenes in a depth format. Returns how many pixels were smoothed.
fn check_bands<D: DepthBuffer, K: ProjectionKind>(
    random: &mut Random,
    projection: Projection<K>,
) -> usize {
    let bodies = bodies(random);
    let options = viewport(random);
    let options = options.with_cull(*[Cull::Back, Cull::Nothing].choose(random).unwrap());
    let eye = Camera::from_view(
        Transform::translate(vec3!(0, 0, -2.5)) * Transform::rotate_x(angle(random)),
    );
    let view = projection * eye;
    let draw = |canvas: &mut Frame<'_, Rgb888, D>| {
        canvas.draw_with(
            &options,
            &GROUND,
            &(view * Transform::translate(vec3!(0, -0.4, 0))),
            &Noise(9),
        );
        for (number, body) in bodies.iter().enumerate() {
            canvas.draw_with(&options, body.mesh, &(view * body.place), &Noise(number));
        }
    };
    let smooth = |canvas: &mut Frame<'_, Rgb888, D>| {
        draw(canvas);
        for body in &bodies {
            canvas.smooth_edges(&options, body.mesh, body.outline, &(view * body.place));
        }
    };
    let whole = in_bands(&[FRAME.1], 0, &mut { draw });
    let smoothed = in_bands(&[FRAME.1], 0, &mut { smooth });
    let mut changed = 0;
    for (at, (&before, &after)) in whole.iter().zip(&smoothed).enumerate() {
        if before != after {
            changed += 1;
            assert!(
                is_mixed_once(&whole, FRAME.0 as usize, at, after),
                "pixel {at}: {before:?} became {after:?}"
            );
        }
    }
    let heights = [(); 3].map(|()| random.random_range(1..25));
    assert!(
        in_bands(&heights, 1, &mut { smooth }) == smoothed,
        "bands of {heights:?} rows differ"
    );

    let mut objects: Vec<_> = bodies
        .iter()
        .map(|body| {
            let edges = body.mesh.outline(body.outline, LineStyle::HAIRLINE);
            Object::new(edges, body.place, ())
        })
        .collect();
    let mut list: Box<DrawList<600, 1200>> = Box::new(DrawList::new());
    let in_front = options.with_depth_test(Biased::in_front(TestAndWrite));
    let listed = list
        .prepare(&in_front, FRAME, &mut objects[..], &view)
        .unwrap();
    let mut prepared = |canvas: &mut Frame<'_, Rgb888, D>| {
        draw(canvas);
        canvas.smooth_prepared(&listed).unwrap();
    };
    assert!(
        in_bands(&[FRAME.1], 0, &mut prepared) == smoothed,
        "prepared edges differ"
    );
    assert!(
        in_bands(&heights, 1, &mut prepared) == smoothed,
        "bands of prepared edges differ"
    );
    changed
}

#[test]
fn bands_that_overlap_are_smoothed_like_the_frame() {
    let mut changed = 0;
    cases(sampled(1600), |random| {
        let fov = Angle::from_degrees(random.random_range(20..100));
        let perspective = Projection::perspective(fov, FRAME, fx!(0.5), fx!(20)).unwrap();
        let window = Window::centered(fx!(4), fx!(3));
        let parallel = Projection::orthographic(window, fx!(-1), fx!(8)).unwrap();
        changed += check_bands::<LinearDepth, _>(random, perspective);
        changed += check_bands::<FloatDepth, _>(random, perspective);
        changed += check_bands::<WideFloatDepth, _>(random, perspective);
        changed += check_bands::<LinearDepth, _>(random, parallel);
    });
    assert!(changed > 40_000, "only {changed} pixels are smoothed");
}

/// A leaning sheet behind a parallel wall. The wall is nearer by about as much as the bias of the sheet's edges, so in
/// every row of a tall frame, the last bit of a depth decides whether the edge is hidden. This bit must not depend on the
/// row in which a band begins.
#[test]
fn depths_along_an_edge_do_not_depend_on_the_band() {
    const TALL: (u32, u32) = (8, 2000);
    let mut changed = 0;
    cases(24, |random| {
        let lean = random.random_range(-40_000..40_000);
        let sheet = |left: i32, right: i32, nearer: i32| {
            [
                [left, -40],
                [right, -40],
                [right + 9, 2050],
                [left + 9, 2050],
            ]
            .map(|[x, y]| {
                let z = lean / 2 - lean * y / 1000 + nearer;
                Vec3::from_bits([x << 14, -y << 16, z])
            })
        };
        let faces = [[0, 2, 1], [0, 3, 2]];
        // A unit of the depth is two units of z. The bias is two units of the depth and the change from row to row.
        let ahead = 4 + lean.abs() / 1000 + random.random_range(-3..4);
        let (wall, sheet) = (sheet(-40, 90, ahead), sheet(11, 21, 0));
        let [wall, sheet] = [&wall, &sheet].map(|corners| Mesh::new(corners, &faces).unwrap());
        let mut room = [[0; 4]; 6];
        let outline = Outline::build(&sheet, deg!(180), &mut room).unwrap();
        let mvp = pixel_projection(TALL);
        let bands = |rows: u32| {
            let mut all: Vec<Gray8> = Vec::new();
            for row in (0..TALL.1).step_by(rows as usize) {
                let (first, last) = (row.max(1) - 1, (row + rows + 1).min(TALL.1));
                let mut colors = vec![Gray8::BLACK; (TALL.0 * (last - first)) as usize];
                let mut depths = vec![0; colors.len()];
                let band = Canvas::band(&mut colors, TALL.0, TALL.1, first).unwrap();
                let mut band = band.with_depth(&mut depths).unwrap();
                let stripes = Flat::new(Gray8::BLACK)
                    .map(|at, _| Some(Gray8::new(99 * (at.point.x as u8 & 1))));
                band.draw_with(&BOTH_SIDES, &sheet, &mvp, &Flat::new(Gray8::WHITE));
                band.draw_with(&BOTH_SIDES, &wall, &mvp, &stripes);
                band.smooth_edges(&BOTH_SIDES, &sheet, &outline, &mvp);
                let from = (TALL.0 * (row - first)) as usize;
                all.extend(&colors[from..from + (TALL.0 * rows.min(TALL.1 - row)) as usize]);
            }
            all
        };
        let whole = bands(TALL.1);
        changed += whole
            .iter()
            .filter(|color| ![0, 99, 255].contains(&color.luma()))
            .count();
        for rows in [1, 7, 100] {
            let differ = bands(rows)
                .iter()
                .zip(&whole)
                .filter(|(a, b)| a != b)
                .count();
            assert_eq!(differ, 0, "bands of {rows} rows");
        }
    });
    assert!(changed > 4000, "only {changed} pixels are smoothed");
}
