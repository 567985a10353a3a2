//! Positions of 16 bits are drawn like the same values in 32 bits, and are rounded no more than necessary.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::mode::{Exact, Mode};
use fixel::prelude::*;
use fixel::target::{Depth, Native};
use fixel::view::{Perspective, ProjectionKind};
use proptest::collection::vec;
use proptest::prelude::*;

const SIZE: (u32, u32) = (64, 48);
const PIXELS: usize = 64 * 48;

/// Numbers of 16 bits; the smallest, the largest and zero are frequent.
fn component() -> impl Strategy<Value = i16> {
    prop_oneof![
        Just(i16::MIN),
        Just(i16::MAX),
        Just(0),
        (any::<i16>(), 0_u32..16).prop_map(|(bits, cut)| bits >> cut),
    ]
}

#[derive(Clone, Debug)]
struct Model {
    positions: Vec<[i16; 3]>,
    fraction: u32,
    faces: Vec<[u16; 3]>,
    edges: Vec<[u16; 2]>,
}

fn models() -> impl Strategy<Value = Model> {
    let positions = vec(prop::array::uniform3(component()), 3..9);
    (positions, 0_u32..=16).prop_flat_map(|(positions, fraction)| {
        let index = 0..u16::try_from(positions.len()).unwrap();
        let faces = vec(prop::array::uniform3(index.clone()), 1..9);
        let edges = vec(prop::array::uniform2(index), 0..5);
        (faces, edges).prop_map(move |(faces, edges)| Model {
            positions: positions.clone(),
            fraction,
            faces,
            edges,
        })
    })
}

type Board<'a> = Canvas<'a, Rgb565, Native, Depth<'a>>;

/// Draws a mesh in every way; returns the pictures and counts.
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
    let options = DrawOptions::new().with_mode(mode).with_cull(Cull::Nothing);
    let counts = [
        canvas.draw_with(&options, mesh, mvp, &clay),
        canvas.draw_edges(&options, mesh, mvp, &Flat::new(Rgb565::RED)),
        canvas.draw_points(&options, mesh, mvp, &Flat::new(Rgb565::BLUE)),
    ];
    let mut list: TriangleList<16, 400> = TriangleList::new();
    let prepared = list.prepare(&options, SIZE, mesh, mvp).unwrap();
    canvas.draw_prepared(&prepared, &NormalView::new()).unwrap();
    (colors, depths, counts)
}

impl Model {
    fn check<K: ProjectionKind>(&self, mvp: &Mvp<K>) -> Result<(), TestCaseError> {
        let long: Vec<Vec3> = self
            .positions
            .iter()
            .map(|p| Vec3::from_bits(p.map(|x| i32::from(x) << (16 - self.fraction))))
            .collect();
        let meshes = [
            Mesh::new(&long, &self.faces),
            Mesh::short(&self.positions, self.fraction, &self.faces),
        ];
        let [long, short] =
            meshes.map(|mesh| mesh.and_then(|mesh| mesh.with_edges(&self.edges)).unwrap());
        prop_assert!(long.positions() == short.positions());
        prop_assert_eq!(long.counts(), short.counts());
        prop_assert!(drawn(&long, mvp, Exact) == drawn(&short, mvp, Exact));
        Ok(())
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    /// The pictures are equal bit for bit, from outside and from inside, and with a clipping plane through the mesh.
    #[test]
    fn short_positions_draw_what_long_positions_draw(
        model in models(),
        turn: [u32; 2],
        // The mesh is as large as the view, or much smaller or larger.
        scale in -4_i32..6,
        away in 0_i32..4,
    ) {
        let [x, y] = turn.map(Angle::from_bits);
        let size = i32::try_from(15 - model.fraction.min(15)).unwrap();
        let scale = Scalar::from_bits(1 << (16 + scale - size).clamp(0, 30));
        let place = Transform::translate(Vec3::new(fx!(0), fx!(0), Scalar::from_num(-away)));
        let pose = place * Transform::rotate_x(x) * Transform::rotate_y(y) * Transform::scale(scale);
        let projection = Projection::perspective(Angle::from_degrees(60), SIZE, fx!(0.1), fx!(100)).unwrap();
        model.check::<Perspective>(&(projection * pose))?;
        let projection = Projection::orthographic(Window::centered(fx!(4), fx!(4)), fx!(-9), fx!(9)).unwrap();
        model.check(&(projection * pose))?;
    }

    /// Positions are rounded to the nearest 16-bit numbers. The largest of them uses at least 15 bits.
    #[test]
    fn shortened_positions_are_the_nearest(bits in prop::array::uniform3(any::<i32>()), cut in 0_u32..32) {
        let position = bits.map(|bits| bits >> cut);
        let positions = [Vec3::ZERO, Vec3::from_bits(position)];
        let mesh = Mesh::new(&positions, &[[0, 0, 1]]).unwrap();
        let ([origin, short], fraction) = mesh.shortened::<2>().unwrap();
        prop_assert_eq!(origin, [0; 3]);
        let unit = 1_i64 << (16 - fraction);
        let most = position.into_iter().map(i64::from).max_by_key(|x| x.abs()).unwrap();
        for (short, long) in short.into_iter().zip(position) {
            let (short, long) = (i64::from(short), i64::from(long));
            // Numbers above 32767.5 saturate to the last whole number, 32767.
            let off = if long > (i64::from(i16::MAX) << 16) { unit } else { unit / 2 };
            prop_assert!((short * unit - long).abs() <= off, "{long} as {short} of {unit}");
        }
        // Another fraction bit would not fit: the largest number is at least half of the largest that fits, minus its
        // rounding.
        let is_full = fraction == 16 || most.abs() * 4 / unit >= (1 << 16) - 2;
        prop_assert!(is_full, "{most} in units of {unit}");
    }
}

/// Rounding moves a point by up to half a unit along each axis, √3/2 units in all. Its image moves by up to that
/// distance times focal length / w, and by as much again for each unit of its slope x / w or y / w.
#[test]
fn rounding_moves_a_sphere_by_less_than_a_hundredth_of_a_pixel() {
    static LONG: Mesh = shape!(sphere(32, 32));
    static SHORT: Mesh = shape!(sphere(32, 32), short);
    let projection =
        Projection::from_focal_length(fx!(200), (320, 240), fx!(0.25), fx!(100)).unwrap();
    let pose =
        Transform::translate(vec3!(0, 0, -2.256)) * Transform::rotate_x(Angle::from_degrees(20));
    let (mvp, mut colors) = (projection * pose, vec![Rgb565::BLACK; 320 * 240]);
    let canvas = Canvas::new(&mut colors, 320, 240).unwrap();
    let mut worst = 0_f64;
    for (long, short) in LONG.positions().iter().zip(SHORT.positions().iter()) {
        let eye = pose.point(long);
        let w = -eye.z.to_num::<f64>();
        let place = |point| {
            let place = canvas.project(&DrawOptions::new(), &mvp, point).unwrap();
            [place.x, place.y].map(|at| at.to_num::<f64>())
        };
        for ((a, b), side) in place(long)
            .into_iter()
            .zip(place(short))
            .zip([eye.x, eye.y])
        {
            let unit = 2_f64.powi(-14);
            let slope = side.to_num::<f64>().abs() / w;
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
    static LONG: Mesh = include_obj!("../models/house.obj");
    static SHORT: Mesh = include_obj!("../models/house.obj", short);
    static RING: Mesh = shape!(torus(fx!(0.25), 12, 8), short);
    static LONG_RING: Mesh = shape!(torus(fx!(0.25), 12, 8));
    assert_eq!(LONG.counts(), SHORT.counts());
    assert_eq!((LONG.faces(), LONG.edges()), (SHORT.faces(), SHORT.edges()));
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
    assert!(Mesh::short(&positions, 16, &[[0, 1, 1]]).is_ok());
    let error = Mesh::short(&positions, 17, &[]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "number of fraction bits is 17: it must lie between 0 and 16"
    );
    assert!(matches!(
        Mesh::short(&positions, 3, &[[0, 1, 2]]),
        Err(Error::Index { index: 2, .. })
    ));
    assert!(matches!(
        Mesh::short(&vec![[0; 3]; 65_537], 3, &[]),
        Err(Error::TooMany { given: 65_537, .. })
    ));
    let mesh = Mesh::short(&positions, 3, &[]).unwrap();
    assert!(matches!(
        mesh.shortened::<3>(),
        Err(Error::Length {
            given: 3,
            needed: 2,
            ..
        })
    ));
    assert_eq!(mesh.positions().get(2), None);
    assert!(!mesh.positions().is_empty());
}

#[test]
#[should_panic(expected = "mesh: number of fraction bits is 17: it must lie between 0 and 16")]
fn compile_time_refusals_say_why() {
    let _ = Mesh::checked(Mesh::short(&[], 17, &[]));
}
