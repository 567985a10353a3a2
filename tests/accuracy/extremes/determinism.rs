//! A picture is always the same: if it is drawn again, in bands, with triangles in another order, with either format of
//! depths, or with positions of 16 or 32 bits.
//!
//! The programs in `examples/firmware` draw on every target, and `.ci/run` compares their results with the host's
//! results.

use embedded_graphics::pixelcolor::raw::BigEndian;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::NormalView;
use fixel::canvas::{DepthBuffer, FloatDepth};
use fixel::mesh::{Buffers, Shape};
use fixel::mode::{Affine, Compact, Exact, Fast, Mode, Newton};
use fixel::prelude::*;
use fixel::view::Perspective;

use super::scene::Random;

const SIZE: (u32, u32) = (320, 240);

static SKIN: [[Rgb565; 2]; 2] = [[Rgb565::WHITE, Rgb565::BLUE], [Rgb565::GREEN, Rgb565::RED]];
static RING: Mesh = shape!(torus(fx!(0.4), 24, 12), quantized);
static BALL: Mesh = shape!(sphere(16, 12), quantized);
static FLOOR: Mesh = shape!(plane(8, 8), quantized);

/// A mesh with short positions, and the same positions in 32 bits.
struct Model {
    short: &'static Mesh<'static>,
    positions: Vec<Vec3>,
    uvs: Vec<Vec2>,
    place: Transform,
}

impl Model {
    fn new(short: &'static Mesh<'static>, shape: Result<Shape, Error>, place: Transform) -> Self {
        let shape = shape.unwrap();
        let counts = shape.counts();
        let mut positions = vec![Vec3::ZERO; counts.positions];
        let mut faces = vec![[0; 3]; counts.faces];
        let mut uvs = vec![vec2!(0, 0); counts.uvs];
        let buffers = Buffers {
            uvs: &mut uvs,
            ..Buffers::new(&mut positions, &mut faces)
        };
        shape.build(buffers).unwrap();
        assert_eq!(short.faces(), faces);
        Self {
            short,
            positions: short.positions().iter().collect(),
            uvs,
            place,
        }
    }

    fn mesh(&self, numbers: Numbers) -> Mesh<'_> {
        match numbers {
            Numbers::Short => *self.short,
            Numbers::Long => Mesh::new(&self.positions, self.short.faces())
                .and_then(|mesh| mesh.with_uvs(&self.uvs, None))
                .unwrap(),
        }
    }
}

/// The number format of a mesh's positions.
#[derive(Clone, Copy, Debug)]
enum Numbers {
    Short,
    Long,
}

/// A ring in front of a ball and a ring behind the ball, over a floor that reaches behind the eye. No two surfaces
/// coincide.
fn models() -> [Model; 4] {
    let at = |x: Scalar, y: Scalar, z: Scalar| Transform::translate(Vec3::new(x, y, z));
    let tilt = |degrees: i32| Transform::rotate_x(Angle::from_degrees(degrees));
    let ring = |place| Model::new(&RING, Shape::torus(fx!(0.4), 24, 12), place);
    [
        ring(at(fx!(-0.3), fx!(0.2), fx!(-3)) * tilt(70)),
        Model::new(
            &BALL,
            Shape::sphere(16, 12),
            at(fx!(0.2), fx!(0.3), fx!(-5.5)) * tilt(10),
        ),
        ring(at(fx!(1), fx!(0.5), fx!(-8)) * tilt(-60)),
        Model::new(
            &FLOOR,
            Shape::plane(8, 8),
            at(fx!(0), fx!(-2), fx!(0)) * Transform::scale(fx!(20)),
        ),
    ]
}

type Target<'a, F> = Canvas<'a, Rgb565, BigEndian, F>;

/// Checksums of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Sums {
    colors: u32,
    depths: u32,
}

/// Draws a frame in bands of `rows` rows, and returns its checksums.
fn sums<F: DepthBuffer>(
    rows: u32,
    draw: &dyn Fn(&mut Target<'_, F>, &Projection<Perspective>),
) -> Sums {
    let projection = Projection::from_focal_length(fx!(200), SIZE, fx!(0.25), fx!(100)).unwrap();
    let mut colors = crc32fast::Hasher::new();
    let mut depths = crc32fast::Hasher::new();
    for first in (0..SIZE.1).step_by(rows as usize) {
        let pixels = (SIZE.0 * rows.min(SIZE.1 - first)) as usize;
        // The memory is not blank at first, so that the test fails if earlier contents show.
        let (mut color, mut depth) = (vec![[9; 2]; pixels], vec![7; pixels]);
        let band = Canvas::band(&mut color, SIZE.0, SIZE.1, first).unwrap();
        let mut band = band.with_depth_format::<F>(&mut depth).unwrap();
        band.clear(Rgb565::new(1, 2, 3));
        draw(&mut band, &projection);
        colors.update(band.as_bytes());
        for depth in depth {
            depths.update(&depth.to_le_bytes());
        }
    }
    Sums {
        colors: colors.finalize(),
        depths: depths.finalize(),
    }
}

fn frame<F: DepthBuffer>(mode: impl Mode, rows: u32, numbers: Numbers) -> Sums {
    let options = DrawOptions::new().with_mode(mode);
    let models = models();
    sums::<F>(rows, &|band, projection| {
        for model in &models {
            let mvp = *projection * model.place;
            band.draw_with(&options, &model.mesh(numbers), &mvp, &Textured::new(&SKIN));
        }
    })
}

/// Draws a whole frame, and bands of several heights, with positions of 16 and 32 bits. Returns the checksums, which
/// must all be equal.
fn bands<F: DepthBuffer>(mode: impl Mode) -> Sums {
    let whole = frame::<F>(mode, SIZE.1, Numbers::Long);
    for rows in [1, 7, 16, 240] {
        for numbers in [Numbers::Long, Numbers::Short] {
            let drawn = frame::<F>(mode, rows, numbers);
            assert_eq!(drawn, whole, "bands of {rows}, {numbers:?}");
        }
    }
    whole
}

#[test]
fn bands_equal_the_frame() {
    fn with_either_depth(mode: impl Mode) {
        let [linear, floating] = [bands::<LinearDepth>(mode), bands::<FloatDepth>(mode)];
        // The depth formats store different numbers. But no two surfaces are so close to each other that the colors
        // differ.
        assert_eq!(linear.colors, floating.colors);
        assert_ne!(linear.depths, floating.depths);
    }
    // Only `Compact` computes depths in its own way.
    with_either_depth(Newton::default());
    with_either_depth(Compact);
    bands::<LinearDepth>(Exact);
    bands::<LinearDepth>(Fast::within(fx!(0.25)));
    bands::<LinearDepth>(Affine);
}

/// Shuffles a list, in the same way every time.
fn shuffled<T>(list: &mut [T], random: &mut Random) {
    for i in (1..list.len()).rev() {
        list.swap(i, random.below(i + 1));
    }
}

/// Draws the models in another order, and each model's triangles in another order. Only depth decides which triangles
/// show. (Of two triangles at the same position and depth, the last triangle would show, but these models have no such
/// triangles.)
fn orders<F: DepthBuffer>() -> Sums {
    let draw = |rows: u32, parts: &[(Vec<[u16; 3]>, Model)]| {
        sums::<F>(rows, &|band, projection| {
            for (faces, model) in parts {
                let mesh = Mesh::new(&model.positions, faces).unwrap();
                band.draw(&mesh, &(*projection * model.place), &NormalView::new());
            }
        })
    };
    let mut parts = models().map(|model| (model.short.faces().to_vec(), model));
    let whole = draw(SIZE.1, &parts);
    let mut random = Random(12);
    for rows in [1, 7, 16, 240] {
        shuffled(&mut parts, &mut random);
        for (faces, ..) in &mut parts {
            shuffled(faces, &mut random);
        }
        assert_eq!(draw(rows, &parts), whole, "bands of {rows}");
    }
    whole
}

#[test]
fn the_order_of_triangles_does_not_change_the_picture() {
    assert_eq!(
        orders::<LinearDepth>().colors,
        orders::<FloatDepth>().colors
    );
}
