//! Bands put together equal the frame, bit for bit, in every mode.

use std::any::type_name;

use embedded_graphics::pixelcolor::Rgb888;
use fixel::canvas::{DepthBuffer, FloatDepth};
use fixel::mode::{Affine, Exact, Fast, Mode, Newton};
use fixel::prelude::*;
use fixel::shade::PerFace;
use fixel::view::{Parallel, ProjectionKind};
use fixel::{Primitive, Window};
use rand::Rng;

use crate::examples::scenes::SPHERE;
use crate::{List, Screen, picture};
use support::counter;
use support::random::{Random, cases, list, sampled};

pub const WIDTH: u32 = 70;
pub const HEIGHT: u32 = 37;
/// Heights of the bands, in rows.
const BANDS: [u32; 3] = [1, 7, 16];

/// A shader with a color that depends on every bit of the interpolated values, so any difference between two drawings
/// shows.
#[derive(Clone, Copy)]
struct Bits;

impl Shader for Bits {
    type Color = Rgb888;
    type Varyings = [i32; 3];

    fn varyings(&self, primitive: &Primitive<'_>) -> [[i32; 3]; 3] {
        primitive.corners(|corner| {
            let p = corner.position();
            [
                p.x.to_bits(),
                p.y.to_bits().wrapping_mul(77),
                corner.distance().to_bits(),
            ]
        })
    }

    fn shade(&self, sample: &Fragment, [a, b, c]: [i32; 3]) -> Option<Rgb888> {
        let mix = [a, b, c, sample.point.x, sample.point.y].iter().fold(
            0x811c_9dc5_u32,
            |mix, &value| {
                (mix ^ value.cast_unsigned())
                    .wrapping_mul(0x0100_0193)
                    .rotate_left(7)
            },
        );
        let [red, green, blue, holes] = mix.to_be_bytes();
        // Some pixels are discarded. The depth buffer must not change there.
        (holes > 5).then_some(Rgb888::new(red, green, blue))
    }
}

/// A shader that shows the index of a triangle in the mesh as a color.
#[derive(Clone, Copy)]
pub struct Index;

impl Shader for Index {
    type Color = Rgb888;
    type Varyings = PerFace<u8>;

    fn varyings(&self, primitive: &Primitive<'_>) -> [PerFace<u8>; 3] {
        [PerFace(u8::try_from(primitive.face().unwrap()).unwrap()); 3]
    }

    fn shade(&self, _: &Fragment, PerFace(index): PerFace<u8>) -> Option<Rgb888> {
        Some(Rgb888::new(255, 0, index))
    }
}

/// A mesh around the origin that fills the view or extends beyond it.
#[derive(Debug)]
pub struct Scene {
    pub positions: Vec<Vec3>,
    pub faces: Vec<[u16; 3]>,
    edges: Vec<[u16; 2]>,
}

impl Scene {
    fn mesh(&self) -> Mesh<'_> {
        Mesh::new(&self.positions, &self.faces)
            .unwrap()
            .with_edges(&self.edges)
            .unwrap()
    }

    fn draw<I: Mode, K: ProjectionKind>(&self, mode: I, canvas: &mut Band<'_>, mvp: &Mvp<K>) {
        canvas.clear(Rgb888::new(1, 2, 3));
        let mesh = self.mesh();
        canvas.draw_with(&counter::BOTH_SIDES.with_mode(mode), &mesh, mvp, &Bits);
        canvas.draw_with(
            &DrawOptions::new().with_mode(mode),
            mesh.edges(LineStyle::HAIRLINE),
            mvp,
            &Bits,
        );
        canvas.draw_with(
            &DrawOptions::new().with_mode(mode),
            mesh.points(PointStyle::PIXEL),
            mvp,
            &Bits,
        );
    }
}

/// A band of a frame.
pub type Band<'b, D = LinearDepth> = Screen<'b, Rgb888, D>;

/// Draws a frame in bands of `rows` rows. The memory begins with arbitrary contents, which must not show.
fn bands<D: DepthBuffer>(
    rows: u32,
    draw: &mut dyn FnMut(&mut Band<'_, D>),
) -> (Vec<Rgb888>, Vec<u16>) {
    picture((WIDTH, HEIGHT), rows, (Rgb888::new(9, 9, 9), 7), draw)
}

impl Scene {
    /// Checks the scene in every mode that differs from the others in perspective.
    fn check_perspective(&self, mvp: &Mvp) {
        self.check_mode(Exact, mvp);
        self.check_mode(Newton::default(), mvp);
        // With the first tolerance, the mode draws whole spans at once, with the second, a few pixels at once, and with
        // the third, single pixels.
        self.check_mode(Fast::within(fx!(4)), mvp);
        self.check_mode(Fast::within(fx!(0.0625)), mvp);
        self.check_mode(Fast::within(fx!(0)), mvp);
        self.check_mode(Affine, mvp);
    }

    /// Checks the scene in the modes that differ in a parallel view: all modes that are not exact are affine there.
    fn check_parallel(&self, mvp: &Mvp<Parallel>) {
        self.check_mode(Exact, mvp);
        self.check_mode(Affine, mvp);
    }

    fn check_mode<I: Mode, K: ProjectionKind>(&self, mode: I, mvp: &Mvp<K>) {
        let name = type_name::<I>();
        let draw = &mut |band: &mut Band<'_>| self.draw(mode, band, mvp);
        let frame = bands(HEIGHT, draw);
        for rows in BANDS {
            let bands = bands(rows, draw);
            let differs =
                (0..frame.0.len()).find(|&i| (frame.0[i], frame.1[i]) != (bands.0[i], bands.1[i]));
            assert!(
                differs.is_none(),
                "{name}: bands of {rows} rows differ at pixel {differs:?} of row order"
            );
        }
        self.check_prepared(mode, mvp);
    }

    /// Checks that prepared triangles are drawn and counted like triangles of a direct draw call.
    fn check_prepared<I: Mode, K: ProjectionKind>(&self, mode: I, mvp: &Mvp<K>) {
        let name = type_name::<I>();
        let mesh = self.mesh();
        let window = Viewport::new(-9, 3, 64, 48).unwrap();
        let mut list: List = DrawList::new();
        for options in [
            counter::BOTH_SIDES,
            DrawOptions::new().with_viewport(window),
            DrawOptions::new().with_cull(Cull::Front),
        ] {
            let options = options.with_mode(mode);
            let prepared = list.prepare(&options, (WIDTH, HEIGHT), &mesh, mvp).unwrap();
            for rows in [HEIGHT].into_iter().chain(BANDS) {
                let mut counts = [vec![], vec![]];
                let drawn = bands(rows, &mut |band: &mut Band<'_>| {
                    band.clear(Rgb888::new(1, 2, 3));
                    counts[0].push(band.draw_prepared(&prepared, &Bits).unwrap());
                });
                let expected = bands(rows, &mut |band: &mut Band<'_>| {
                    band.clear(Rgb888::new(1, 2, 3));
                    counts[1].push(band.draw_with(&options, &mesh, mvp, &Bits));
                });
                assert!(drawn == expected, "{name}: bands of {rows} rows differ");
                assert_eq!(counts[0], counts[1]);
            }
        }
    }
}

/// The number 1, in units of 2⁻¹⁶.
const UNIT: i32 = 1 << 16;

pub fn scene(random: &mut Random) -> Scene {
    let positions = list(random, 3..12, |random| {
        let reach = UNIT * [3, 3, 3, 40, 3000][random.random_range(0..5)];
        Vec3::from_bits([(); 3].map(|()| random.random_range(-reach..reach)))
    });
    let end = positions.len() as u16;
    Scene {
        positions,
        faces: list(random, 0..12, |random| {
            [(); 3].map(|()| random.random_range(0..end))
        }),
        edges: list(random, 0..12, |random| {
            [(); 2].map(|()| random.random_range(0..end))
        }),
    }
}

#[test]
fn bands_equal_the_frame_in_perspective() {
    cases(sampled(256), |random| {
        let scene = scene(random);
        let turn = Transform::rotate_y(Angle::from_bits(random.random()));
        let fov = Angle::from_degrees(random.random_range(10..150));
        let projection = Projection::perspective(fov, (WIDTH, HEIGHT), fx!(0.1), fx!(50)).unwrap();
        let model = Transform::translate(vec3!(0, 0, -4)) * turn;
        scene.check_perspective(&(projection * model));
    });
}

#[test]
fn bands_equal_the_frame_in_parallel() {
    cases(sampled(256), |random| {
        let scene = scene(random);
        let turn = Transform::rotate_x(Angle::from_bits(random.random()));
        let window = Window::centered(fx!(8), fx!(4));
        let projection =
            Projection::oblique(deg!(30), fx!(0.5), fx!(-20), window, fx!(-20), fx!(20)).unwrap();
        scene.check_parallel(&(projection * turn));
    });
}

/// A window shows a part of a frame: the canvas has the window's size, and the frame's viewport is moved by the
/// window's place. The window has the same covered pixels as this part of the frame. (Interpolated values can differ by
/// the mode's error, because spans begin at the window's edge.)
#[test]
fn windows_cover_the_pixels_of_the_frame() {
    let draw = |scene: &Scene, mvp: &Mvp, [x, y, width, height]: [u32; 4]| {
        let mut color = vec![Rgb888::new(1, 2, 3); (width * height) as usize];
        let mut canvas = Canvas::new(&mut color, width, height).unwrap();
        let [left, top] = [x, y].map(|at| -at.cast_signed());
        let frame = Viewport::new(left, top, WIDTH, HEIGHT).unwrap();
        let (mesh, options) = (scene.mesh(), counter::BOTH_SIDES.with_viewport(frame));
        canvas.draw_with(&options, &mesh, mvp, &Index);
        let white = Flat::new(Rgb888::new(255, 255, 255));
        canvas.draw_with(&options, mesh.edges(LineStyle::HAIRLINE), mvp, &white);
        canvas.draw_with(&options, mesh.points(PointStyle::PIXEL), mvp, &white);
        color
    };
    cases(sampled(256), |random| {
        let scene = scene(random);
        let fov = Angle::from_degrees(random.random_range(10..150));
        let projection = Projection::perspective(fov, (WIDTH, HEIGHT), fx!(0.1), fx!(50)).unwrap();
        let mvp = projection * Transform::translate(vec3!(0, 0, -4));
        let frame = draw(&scene, &mvp, [0, 0, WIDTH, HEIGHT]);
        let [x, y] = [WIDTH, HEIGHT].map(|size| random.random_range(0..size));
        let width = random.random_range(1..=WIDTH - x);
        let height = random.random_range(1..=HEIGHT - y);
        let window = draw(&scene, &mvp, [x, y, width, height]);
        for (row, found) in (y..).zip(window.chunks(width as usize)) {
            let expected = &frame[(row * WIDTH + x) as usize..][..width as usize];
            assert!(
                found == expected,
                "row {row} of {:?}",
                [x, y, width, height]
            );
        }
    });
}

/// Bands equal the frame with floating-point depths, too, in direct draw calls and with prepared triangles.
#[test]
fn bands_equal_the_frame_in_floating_depth() {
    cases(sampled(256), |random| {
        let scene = scene(random);
        let (near, far) = (fx!(0.01), fx!(600));
        let projection = Projection::perspective(deg!(70), (WIDTH, HEIGHT), near, far).unwrap();
        let turn = Transform::rotate_y(Angle::from_bits(random.random()));
        let model = Transform::translate(vec3!(0, 0, -4)) * turn;
        let (mesh, mvp) = (scene.mesh(), projection * model);
        let mut list: List = DrawList::new();
        let prepared = list.prepare(&counter::BOTH_SIDES, (WIDTH, HEIGHT), &mesh, &mvp);
        let prepared = prepared.unwrap();
        let draw = |rows: u32, is_prepared: bool| {
            bands(rows, &mut |band: &mut Band<'_, FloatDepth>| {
                band.clear(Rgb888::new(1, 2, 3));
                if is_prepared {
                    band.draw_prepared(&prepared, &Bits).unwrap();
                } else {
                    band.draw_with(&counter::BOTH_SIDES, &mesh, &mvp, &Bits);
                }
            })
        };
        let frame = draw(HEIGHT, false);
        for rows in [HEIGHT].into_iter().chain(BANDS) {
            assert!(draw(rows, false) == frame, "bands of {rows} rows differ");
            assert!(
                draw(rows, true) == frame,
                "prepared bands of {rows} rows differ"
            );
        }
    });
}

/// Prepares a ball in front of the eye. The list has room for `TRIANGLES` triangles and `VERTICES` vertices.
fn prepare<const TRIANGLES: usize, const VERTICES: usize>() -> Result<u32, Error> {
    static BALL: Mesh = shape!(sphere(8, 6));
    let projection =
        Projection::perspective(Angle::from_degrees(60), (WIDTH, HEIGHT), fx!(1), fx!(10))?;
    let mvp = projection * Transform::translate(vec3!(0, 0, -2));
    let mut list: DrawList<TRIANGLES, VERTICES> = DrawList::new();
    let ball = list.prepare(&DrawOptions::new(), (WIDTH, HEIGHT), &BALL, &mvp)?;
    let mut drawn = 0;
    bands(HEIGHT, &mut |band: &mut Band<'_>| {
        drawn = band.draw_prepared(&ball, &Bits).unwrap().drawn;
    });
    Ok(drawn)
}

/// The mesh has 1089 vertices, more than the vertex cache holds.
#[test]
fn a_large_prepared_mesh_equals_the_frame() {
    let projection =
        Projection::perspective(Angle::from_degrees(60), (WIDTH, HEIGHT), fx!(1), fx!(10)).unwrap();
    // The near plane cuts the mesh.
    let mvp = projection * Transform::translate(vec3!(0, 0, -1.875));
    let mut list: DrawList<2100, 3500> = DrawList::new();
    let ball = list.prepare(&counter::BOTH_SIDES, (WIDTH, HEIGHT), &SPHERE, &mvp);
    let ball = ball.unwrap();
    let mut clipped = 0;
    let frame = bands(HEIGHT, &mut |band: &mut Band<'_>| {
        clipped = band
            .draw_with(&counter::BOTH_SIDES, &SPHERE, &mvp, &Bits)
            .clipped;
    });
    assert!(clipped > 10, "{clipped}");
    let drawn = bands(5, &mut |band: &mut Band<'_>| {
        band.draw_prepared(&ball, &Bits).unwrap();
    });
    assert!(drawn == frame);
}

#[test]
fn a_list_that_is_too_short_says_what_is_needed() {
    let Err(Error::Full {
        of, needed, room, ..
    }) = prepare::<1, 1>()
    else {
        panic!("one triangle is not enough");
    };
    assert_eq!((of, room), ("triangles", 1));
    assert_eq!(needed, 16);
    let Err(error) = prepare::<16, 1>() else {
        panic!("one vertex is not enough");
    };
    assert_eq!(
        error.to_string(),
        "20 vertices are visible: the list must have room for all, and has room for 1"
    );
    assert!(prepare::<15, 20>().is_err());
    assert!(prepare::<16, 19>().is_err());
    assert_eq!(prepare::<16, 20>(), Ok(16));
}

#[test]
fn an_impossible_frame_is_refused() {
    let mut list: DrawList<1, 1> = DrawList::new();
    let mesh = Mesh::new(&[], &[]).unwrap();
    let projection =
        Projection::perspective(Angle::from_degrees(60), (1, 1), fx!(1), fx!(10)).unwrap();
    let mvp = projection * Transform::IDENTITY;
    let prepared = list.prepare(&DrawOptions::new(), (2049, 1), &mesh, &mvp);
    assert_eq!(
        prepared.map(|_| ()).unwrap_err().to_string(),
        "number of columns of the frame is 2049: it must be at least 1 and at most 2048"
    );
}
