//! Positions of 16 bits are drawn like the same values in 32 bits. Shortening rounds positions no more than necessary.

use std::hash::{BuildHasher, BuildHasherDefault, DefaultHasher};

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::Window;
use fixel::mode::{Mode, Newton};
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use rand::Rng;

use crate::List;
use crate::examples::scenes::SPHERE;
use support::random::{Random, cases, list};

const SIZE: (u32, u32) = (64, 48);
const PIXELS: usize = 64 * 48;

/// A random number of 16 bits; the smallest number, the largest one, and zero are frequent.
fn component(random: &mut Random) -> i16 {
    match random.random_range(0..4) {
        0 => i16::MIN,
        1 => i16::MAX,
        2 => 0,
        _ => random.random::<i16>() >> random.random_range(0..16),
    }
}

#[derive(Debug)]
struct Model {
    positions: Vec<[i16; 3]>,
    fraction: u32,
    faces: Vec<[u16; 3]>,
    edges: Vec<[u16; 2]>,
}

fn model(random: &mut Random) -> Model {
    let positions = list(random, 3..9, |random| [(); 3].map(|()| component(random)));
    let end = positions.len() as u16;
    Model {
        positions,
        fraction: random.random_range(0..=16),
        faces: list(random, 1..9, |random| {
            [(); 3].map(|()| random.random_range(0..end))
        }),
        edges: list(random, 0..5, |random| {
            [(); 2].map(|()| random.random_range(0..end))
        }),
    }
}

type Board<'a> = Canvas<'a, Rgb565, Native, LinearDepth>;

/// Draws a mesh in every way. Returns the pictures and the counts.
fn drawn<K: ProjectionKind, I: Mode>(
    mesh: &Mesh,
    mvp: &Mvp<K>,
    mode: I,
) -> impl PartialEq + use<K, I> {
    let (mut colors, mut depths) = (vec![Rgb565::BLACK; PIXELS], vec![0; PIXELS]);
    let canvas = Canvas::new(&mut colors, SIZE.0, SIZE.1).unwrap();
    let mut canvas: Board<'_> = canvas.with_depth(&mut depths).unwrap();
    let light = Light::new(vec3!(1, 2, 3), fx!(0.2), fx!(0.8)).unwrap();
    let clay = Flat::rgb(Rgb888::new(236, 214, 190)).lit(light);
    let light = Light::new(vec3!(-3, 1, 2), fx!(0.1), fx!(0.7)).unwrap();
    let cold = Flat::rgb(Rgb888::new(40, 90, 250)).lit(light);
    let options = DrawOptions::new().with_mode(mode).with_cull(Cull::Nothing);
    let counts = [
        canvas.draw_with(&options, mesh, mvp, &clay),
        canvas.draw_with(
            &options,
            mesh.edges(LineStyle::HAIRLINE),
            mvp,
            &Flat::new(Rgb565::RED),
        ),
        canvas.draw_with(
            &options,
            mesh.points(PointStyle::PIXEL),
            mvp,
            &Flat::new(Rgb565::BLUE),
        ),
    ];
    let mut list: List = DrawList::new();
    let prepared = list.prepare(&options, SIZE, mesh, mvp).unwrap();
    canvas.draw_prepared(&prepared, &cold).unwrap();
    (colors, depths, counts)
}

impl Model {
    fn check<K: ProjectionKind>(&self, mvp: &Mvp<K>) {
        let long: Vec<Vec3> = self
            .positions
            .iter()
            .map(|p| Vec3::from_bits(p.map(|x| i32::from(x) << (16 - self.fraction))))
            .collect();
        let meshes = [
            Mesh::new(&long, &self.faces),
            Mesh::quantized(&self.positions, self.fraction, &self.faces),
        ];
        let [long, short] =
            meshes.map(|mesh| mesh.and_then(|mesh| mesh.with_edges(&self.edges)).unwrap());
        let [one, other] = [&long, &short].map(Mesh::positions);
        assert!(one == other, "{self:?}");
        let hasher = BuildHasherDefault::<DefaultHasher>::default();
        assert_eq!(hasher.hash_one(one), hasher.hash_one(other), "{self:?}");
        assert_eq!(long.counts(), short.counts());
        assert!(
            drawn(&long, mvp, Newton::default()) == drawn(&short, mvp, Newton::default()),
            "{self:?}, {mvp:?}"
        );
    }
}

/// The pictures are equal bit for bit, from outside and from inside, and with a clipping plane through the mesh.
#[test]
fn short_positions_draw_what_long_positions_draw() {
    cases(1500, |random| {
        let model = model(random);
        let [x, y] = [(); 2].map(|()| Angle::from_bits(random.random()));
        // The mesh is as large as the view, or much smaller or larger.
        let scale = random.random_range(-4..6);
        let away = random.random_range(0..4);
        let size = i32::try_from(15 - model.fraction.min(15)).unwrap();
        let scale = Scalar::from_bits(1 << (16 + scale - size).clamp(0, 30));
        let place = Transform::translate(Vec3::from_ints(0, 0, -away));
        let turn = Transform::rotate_x(x) * Transform::rotate_y(y);
        let pose = place * turn * Transform::scale(scale);
        let projection = Projection::perspective(deg!(60), SIZE, fx!(0.1), fx!(100)).unwrap();
        model.check(&(projection * pose));
        let window = Window::centered(fx!(4), fx!(4));
        let projection = Projection::orthographic(window, fx!(-9), fx!(9)).unwrap();
        model.check(&(projection * pose));
    });
}

/// Positions are rounded to the nearest 16-bit numbers. The largest shortened number uses at least 15 bits.
#[test]
fn shortened_positions_are_the_nearest() {
    cases(256, |random| {
        let cut = random.random_range(0..32);
        let position = random.random::<[i32; 3]>().map(|bits| bits >> cut);
        let positions = [Vec3::ZERO, Vec3::from_bits(position)];
        let mesh = Mesh::new(&positions, &[[0, 0, 1]]).unwrap();
        let ([origin, short], fraction) = mesh.quantized_positions::<2>().unwrap();
        assert_eq!(origin, [0; 3]);
        let unit = 1_i64 << (16 - fraction);
        let most = i64::from(position.map(i32::unsigned_abs).into_iter().max().unwrap());
        for (short, long) in short.into_iter().zip(position) {
            let (short, long) = (i64::from(short), i64::from(long));
            // Numbers above 32767.5 saturate to the last whole number, 32767.
            let saturates = long > i64::from(i16::MAX) << 16;
            let off = if saturates { unit } else { unit / 2 };
            let is_near = (short * unit - long).abs() <= off;
            assert!(is_near, "{long} as {short} of {unit}");
        }
        // One more fraction bit would not fit: the largest component is at least half of the largest number that fits,
        // minus its rounding error.
        let is_full = fraction == 16 || most * 4 / unit >= (1 << 16) - 2;
        assert!(is_full, "{most} in units of {unit}");
    });
}

/// Rounding moves a point by up to half a unit along each axis, so by up to d = √3/2 units. The point's image moves by
/// up to d · focal length / w · (1 + slope), where the slope is x / w or y / w.
#[test]
fn rounding_moves_a_sphere_by_less_than_a_hundredth_of_a_pixel() {
    let (short, fraction) = SPHERE.quantized_positions::<{ 33 * 33 }>().unwrap();
    let short = Mesh::quantized(&short, fraction, &[]).unwrap();
    let projection =
        Projection::from_focal_length(fx!(200), (320, 240), fx!(0.25), fx!(100)).unwrap();
    let pose =
        Transform::translate(vec3!(0, 0, -2.256)) * Transform::rotate_x(Angle::from_degrees(20));
    let mvp = projection * pose;
    let screen = Viewport::new(0, 0, 320, 240).unwrap();
    let mut worst = 0_f64;
    for (long, short) in SPHERE.positions().iter().zip(short.positions().iter()) {
        let eye = pose.point(long);
        let w = -f64::from(eye.z);
        let place = |point| {
            let place = screen.project(point, &mvp).unwrap();
            [place.x, place.y].map(f64::from)
        };
        for ((a, b), side) in place(long)
            .into_iter()
            .zip(place(short))
            .zip([eye.x, eye.y])
        {
            let unit = 2_f64.powi(-14);
            let slope = f64::from(side).abs() / w;
            let moved = 0.75_f64.sqrt() * unit * 200. / w * (1. + slope);
            // Both positions are rounded to within 1/512 pixel.
            assert!((a - b).abs() <= moved + 1. / 256., "{long}: {a} and {b}");
            worst = worst.max((a - b).abs());
        }
    }
    println!("moved by {worst} pixels at most");
    assert!(worst > 0. && worst < 0.01);
}

#[test]
fn macros_make_the_same_meshes_with_short_positions() {
    static LONG: Mesh = include_mesh!("../models/house.obj");
    static SHORT: Mesh = include_mesh!("../models/house.obj", quantized);
    static RING: Mesh = shape!(torus(fx!(0.25), 12, 8), quantized);
    static LONG_RING: Mesh = shape!(torus(fx!(0.25), 12, 8));
    assert_eq!(LONG.counts(), SHORT.counts());
    assert_eq!(
        (LONG.faces(), LONG.edge_indices()),
        (SHORT.faces(), SHORT.edge_indices())
    );
    assert_eq!(RING.counts(), LONG_RING.counts());
    for (long, short) in [(&LONG, &SHORT), (&LONG_RING, &RING)] {
        for (long, short) in long.positions().iter().zip(short.positions().iter()) {
            for (long, short) in long.to_bits().into_iter().zip(short.to_bits()) {
                // All coordinates are below 8, so short ones have at least 12 fraction bits.
                assert!((long - short).abs() <= 8, "{long} as {short}");
            }
        }
    }
}

#[test]
fn numbers_that_do_not_fit_are_refused() {
    let positions = [[0; 3]; 2];
    assert!(Mesh::quantized(&positions, 16, &[[0, 1, 1]]).is_ok());
    let error = Mesh::quantized(&positions, 17, &[]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "number of fraction bits is 17: it must be at most 16"
    );
    assert!(matches!(
        Mesh::quantized(&positions, 3, &[[0, 1, 2]]),
        Err(Error::Index { index: 2, .. })
    ));
    assert!(matches!(
        Mesh::quantized(&vec![[0; 3]; 65_537], 3, &[]),
        Err(Error::Count { given: 65_537, .. })
    ));
    let mesh = Mesh::quantized(&positions, 3, &[]).unwrap();
    assert!(matches!(
        mesh.quantized_positions::<3>(),
        Err(Error::Count {
            given: 3,
            max: 2,
            ..
        })
    ));
    assert_eq!(mesh.positions().get(2), None);
    assert!(!mesh.positions().is_empty());
}

#[test]
#[should_panic(expected = "mesh: number of fraction bits is 17: it must be at most 16")]
fn compile_time_refusals_say_why() {
    let _ = Mesh::checked(Mesh::quantized(&[], 17, &[]));
}
