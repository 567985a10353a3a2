//! Drawing never fails. With any bits in vertices, matrices, texture coordinates and varyings, nothing panics (test
//! builds check for overflow), and bands equal the frame.

use std::ops::Range;

use embedded_graphics::pixelcolor::{Gray8, Rgb888};
use fixel::canvas::{DepthBuffer, FloatDepth, WideFloatDepth};
use fixel::mode::{self, Affine, Compact, Exact, Fast, Newton};
use fixel::prelude::*;
use fixel::view::{Parallel, ProjectionKind};
use fixel::{DepthView, Drawn, NormalView, Window};
use rand::Rng;
use rand::seq::IndexedRandom;

use support::drawing::Raw;
use support::mode::Mode;
use support::random::{Random, cases, sampled};

/// Random bits. The ends and the middle of the format are frequent, and so are all magnitudes between them.
fn bits(random: &mut Random) -> i32 {
    if random.random() {
        let special = [i32::MAX, i32::MIN, 0, 1 << 16, -(1 << 16)];
        *special.choose(random).unwrap()
    } else {
        random.random::<i32>() >> random.random_range(0..32)
    }
}

fn scalar(random: &mut Random) -> Scalar {
    Scalar::from_bits(bits(random))
}

fn vector(random: &mut Random) -> Vec3 {
    Vec3::from_bits([bits(random), bits(random), bits(random)])
}

/// A product of a few transforms with arbitrary numbers.
fn transform(random: &mut Random) -> Transform {
    let mut product = Transform::IDENTITY;
    for _ in 0..random.random_range(0..4) {
        product = product
            * match random.random_range(0..6) {
                0 => Transform::translate(vector(random)),
                1 => Transform::scale(scalar(random)),
                2 => Transform::scale_axes(vector(random)),
                3 => Transform::rotate_x(Angle::from_bits(random.random())),
                4 => Transform::rotate_y(Angle::from_bits(random.random())),
                _ => Transform::translate(vec3!(0, 0, -3)),
            };
    }
    product
}

#[derive(Clone, Debug)]
struct Scene {
    positions: [Vec3; CORNERS],
    /// Positions of 16 bits and the number of their fraction bits. If present, they replace `positions`.
    short: Option<([[i16; 3]; CORNERS], u32)>,
    uvs: [Vec2; CORNERS],
    faces: [[u16; 3]; 4],
    edges: [[u16; 2]; 4],
    options: DrawOptions,
    size: (u32, u32),
    /// The number of rows of a band.
    rows: u32,
    depth: Format,
    what: What,
    mode: Mode,
    model: Transform,
    camera: Transform,
}

/// A format of depths.
#[derive(Clone, Copy, Debug)]
enum Format {
    Linear,
    Float,
    WideFloatDepth,
}

#[derive(Clone, Copy, Debug)]
enum What {
    Triangles,
    Edges,
    Points,
    Normals,
    Lit,
    Depth,
}

const CORNERS: usize = 6;

/// A random mode with a random tolerance.
fn any_mode(random: &mut Random) -> Mode {
    if random.random() {
        Mode::Fast(scalar(random))
    } else {
        let plain = [
            Mode::Newton,
            Mode::NewtonNarrow,
            Mode::Exact,
            Mode::Compact,
            Mode::Affine,
        ];
        *plain.choose(random).unwrap()
    }
}

fn viewport(random: &mut Random, at: Range<i32>, size: Range<u32>) -> Viewport {
    let [x, y] = [(); 2].map(|()| random.random_range(at.clone()));
    let [width, height] = [(); 2].map(|()| random.random_range(size.clone()));
    Viewport::new(x, y, width, height).unwrap()
}

fn scene(random: &mut Random) -> Scene {
    let positions = [(); CORNERS].map(|()| {
        if random.random() {
            vector(random)
        } else {
            Vec3::from_bits([(); 3].map(|()| random.random_range(-(1 << 18)..1 << 18)))
        }
    });
    let is_short = random.random_ratio(1, 3);
    let short = is_short.then(|| (random.random(), random.random_range(0..=16)));
    let uvs = [(); CORNERS].map(|()| Vec2::from_bits([bits(random), bits(random)]));
    let mut index = || random.random_range(0..CORNERS as u16);
    let faces = [(); 4].map(|()| [index(), index(), index()]);
    let edges = [(); 4].map(|()| [index(), index()]);
    let cull = [Cull::Back, Cull::Nothing, Cull::Front];
    let options = DrawOptions::new().with_cull(*cull.choose(random).unwrap());
    let options = match random.random_range(0..5) {
        0 => options.with_viewport(viewport(random, -4096..4097, 1..4097)),
        1 => options.with_viewport(viewport(random, -40..40, 1..80)),
        _ => options,
    };
    let size = if random.random_ratio(1, 9) {
        *[(1, 1), (2048, 3), (3, 2048)].choose(random).unwrap()
    } else {
        (random.random_range(1..40), random.random_range(1..40))
    };
    let depth = [Format::Linear, Format::Float, Format::WideFloatDepth];
    let what = [
        What::Triangles,
        What::Edges,
        What::Points,
        What::Normals,
        What::Lit,
        What::Depth,
    ];
    Scene {
        positions,
        short,
        uvs,
        faces,
        edges,
        options,
        size,
        rows: random.random_range(1..8),
        depth: *depth.choose(random).unwrap(),
        what: *what.choose(random).unwrap(),
        mode: any_mode(random),
        model: transform(random),
        camera: transform(random),
    }
}

impl Scene {
    fn draw<K: ProjectionKind, D: DepthBuffer>(
        &self,
        canvas: &mut Canvas<'_, Gray8, Native, D>,
        projection: Projection<K>,
    ) {
        let mvp = &(projection * self.camera * self.model);
        let mesh = match &self.short {
            Some((positions, fraction)) => Mesh::quantized(positions, *fraction, &self.faces),
            None => Mesh::new(&self.positions, &self.faces),
        };
        let mesh = &mesh
            .and_then(|mesh| mesh.with_edges(&self.edges))
            .and_then(|mesh| mesh.with_uvs(&self.uvs, None))
            .unwrap();
        let options = &self.options;
        let drawn = match (self.what, self.mode) {
            // Modes differ only in how they interpolate numbers, and `Raw` tests them with arbitrary numbers. So the
            // other shaders are drawn in one mode only, which saves seconds of compilation.
            (What::Depth, _) => canvas.draw_with(options, mesh, mvp, &DepthView::new()),
            (What::Normals, _) => canvas.draw_with(options, mesh, mvp, &NormalView::new()),
            (What::Lit, _) => {
                let light = Light::new(vec3!(1, 2, 3), fx!(0.5), fx!(0.5)).unwrap();
                let white = Flat::rgb(Rgb888::new(255, 255, 255));
                canvas.draw_with(options, mesh, mvp, &white.lit(light))
            }
            (_, Mode::Newton) => {
                self.draw_in(&options.with_mode(Newton::default()), canvas, mesh, mvp)
            }
            (_, Mode::NewtonNarrow) => {
                self.draw_in(&options.with_mode(Newton::NARROW), canvas, mesh, mvp)
            }
            (_, Mode::Exact) => self.draw_in(&options.with_mode(Exact), canvas, mesh, mvp),
            (_, Mode::Compact) => self.draw_in(&options.with_mode(Compact), canvas, mesh, mvp),
            (_, Mode::Fast(texels)) => {
                self.draw_in(&options.with_mode(Fast::within(texels)), canvas, mesh, mvp)
            }
            (_, Mode::Affine) => self.draw_in(&options.with_mode(Affine), canvas, mesh, mvp),
        };
        assert!(drawn.clipped <= drawn.drawn && drawn.drawn + drawn.culled <= drawn.submitted);
        let screen = options.viewport.unwrap_or(canvas.viewport());
        for &position in &self.positions {
            let _ = screen.project(position, mvp);
        }
    }

    fn draw_in<I: mode::Mode, K: ProjectionKind, D: DepthBuffer>(
        &self,
        options: &DrawOptions<I>,
        canvas: &mut Canvas<'_, Gray8, Native, D>,
        mesh: &Mesh<'_>,
        mvp: &Mvp<K>,
    ) -> Drawn {
        let raw = &Raw(None);
        match self.what {
            What::Triangles => canvas.draw_with(options, mesh, mvp, raw),
            What::Edges => canvas.draw_with(options, mesh.edges(LineStyle::HAIRLINE), mvp, raw),
            What::Points => canvas.draw_with(options, mesh.points(PointStyle::PIXEL), mvp, raw),
            What::Depth | What::Normals | What::Lit => unreachable!("drawn in one mode"),
        }
    }

    fn in_perspective(
        &self,
        canvas: Canvas<'_, Gray8>,
        depths: &mut [u16],
        projection: Projection,
    ) {
        match self.depth {
            Format::Linear => self.draw(&mut canvas.with_depth(depths).unwrap(), projection),
            Format::Float => {
                let canvas = canvas.with_depth_format::<FloatDepth>(depths);
                self.draw(&mut canvas.unwrap(), projection);
            }
            Format::WideFloatDepth => {
                let canvas = canvas.with_depth_format::<WideFloatDepth>(depths);
                self.draw(&mut canvas.unwrap(), projection);
            }
        }
    }

    /// In parallel, all scenes have linear depth: how depths are stored does not depend on the projection.
    fn in_parallel(
        &self,
        canvas: Canvas<'_, Gray8>,
        depths: &mut [u16],
        projection: Projection<Parallel>,
    ) {
        self.draw(&mut canvas.with_depth(depths).unwrap(), projection);
    }

    /// Draws the frame at once and in bands, and compares all bits.
    fn check<K: ProjectionKind>(
        &self,
        projection: Result<Projection<K>, Error>,
        draw: fn(&Self, Canvas<'_, Gray8>, &mut [u16], Projection<K>),
    ) {
        let Ok(projection) = projection else {
            return;
        };
        let (width, height) = self.size;
        let blank = || {
            let pixels = (width * height) as usize;
            (vec![Gray8::new(7); pixels], vec![0_u16; pixels])
        };
        let (mut colors, mut depths) = blank();
        let canvas = Canvas::new(&mut colors, width, height).unwrap();
        draw(self, canvas, &mut depths, projection);

        let (mut band_colors, mut band_depths) = blank();
        let band = (width * self.rows) as usize;
        let bands = band_colors
            .chunks_mut(band)
            .zip(band_depths.chunks_mut(band));
        for (first_row, (colors, depths)) in (0..height).step_by(self.rows as usize).zip(bands) {
            let canvas = Canvas::band(colors, width, height, first_row).unwrap();
            draw(self, canvas, depths, projection);
        }
        assert_eq!(colors, band_colors, "{self:?}, {projection:?}");
        assert_eq!(depths, band_depths, "{self:?}, {projection:?}");
    }
}

/// The number of random inputs that a test checks.
const CASES: u32 = 6000;

/// A window with random sides.
fn window(random: &mut Random) -> Window {
    let [a, b, c, d] = [(); 4].map(|()| scalar(random));
    Window {
        left: a.min(b),
        right: a.max(b),
        bottom: c.min(d),
        top: c.max(d),
    }
}

#[test]
fn perspective_is_total() {
    cases(sampled(CASES), |random| {
        let scene = scene(random);
        let fov: u32 = random.random_range(1..1 << 31);
        let fov = Angle::from_bits((fov >> random.random_range(0..16)).max(1));
        let (near, far) = (scalar(random), scalar(random));
        let projection = Projection::perspective(fov, scene.size, near, far);
        scene.check(projection, Scene::in_perspective);
    });
}

#[test]
fn off_center_perspective_is_total() {
    cases(sampled(CASES), |random| {
        let (near, far) = (scalar(random), scalar(random));
        let scene = scene(random);
        let projection = Projection::frustum(window(random), near, far);
        scene.check(projection, Scene::in_perspective);
    });
}

#[test]
fn parallel_projections_are_total() {
    cases(sampled(CASES), |random| {
        let (scene, window) = (scene(random), window(random));
        let (near, far) = (scalar(random), scalar(random));
        let projection = Projection::orthographic(window, near, far);
        scene.check(projection, Scene::in_parallel);
        let angle = Angle::from_bits(random.random());
        let projection = Projection::oblique(angle, fx!(0.5), near, window, near, far);
        scene.check(projection, Scene::in_parallel);
    });
}
