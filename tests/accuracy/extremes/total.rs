//! Drawing is total: no bits of vertices, matrices, texture coordinates or varyings cause a panic (test builds check
//! for overflow), and bands still equal the frame.

use embedded_graphics::pixelcolor::{Gray8, Rgb888};
use fixel::Drawn;
use fixel::mode::{self, Affine, Compact, Exact, Fast, Newton};
use fixel::prelude::*;
use fixel::shade::{Tolerance, Varyings};
use fixel::target::{DepthBuffer, Float, Native, NoDepth, WideFloat};
use fixel::view::ProjectionKind;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

use crate::mode::Mode;

/// Any bits, with a preference for the ends of the format, the middle, and every magnitude between them.
fn bits() -> impl Strategy<Value = i32> {
    prop_oneof![
        select(vec![i32::MAX, i32::MIN, 0, 1 << 16, -(1 << 16)]),
        (any::<i32>(), 0_u32..32).prop_map(|(value, cut)| value >> cut),
    ]
}

fn scalar() -> impl Strategy<Value = Scalar> {
    bits().prop_map(Scalar::from_bits)
}

fn vector() -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(bits()).prop_map(Vec3::from_bits)
}

/// A product of a few transforms with arbitrary numbers.
fn transform() -> impl Strategy<Value = Transform> {
    let angle = || any::<u32>().prop_map(Angle::from_bits);
    let one = prop_oneof![
        vector().prop_map(Transform::translate),
        scalar().prop_map(Transform::scale),
        vector().prop_map(Transform::scale_axes),
        angle().prop_map(Transform::rotate_x),
        angle().prop_map(Transform::rotate_y),
        Just(Transform::translate(vec3!(0, 0, -3))),
    ];
    vec(one, 0..4).prop_map(|all| {
        all.into_iter()
            .fold(Transform::IDENTITY, |t, next| t * next)
    })
}

#[derive(Clone, Debug)]
struct Scene {
    positions: Vec<Vec3>,
    /// If present, positions of 16 bits and the number of their fraction bits, which replace the other positions.
    short: Option<(Vec<[i16; 3]>, u32)>,
    uvs: Vec<Vec2>,
    faces: Vec<[u16; 3]>,
    edges: Vec<[u16; 2]>,
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

/// The format of depths.
#[derive(Clone, Copy, Debug)]
enum Format {
    Linear,
    Float,
    WideFloat,
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

/// Any mode, with any tolerance.
fn modes() -> impl Strategy<Value = Mode> {
    let plain = vec![Mode::Newton, Mode::Exact, Mode::Compact, Mode::Affine];
    prop_oneof![select(plain), scalar().prop_map(Mode::Fast)]
}

fn scene() -> impl Strategy<Value = Scene> {
    let index = || 0..u16::try_from(CORNERS).unwrap();
    let size = prop_oneof![
        8 => (1_u32..40, 1_u32..40),
        1 => select(vec![(1, 1), (2048, 3), (3, 2048)]),
    ];
    let near = prop::array::uniform3(-(1 << 18)..1 << 18).prop_map(Vec3::from_bits);
    let short = prop_oneof![
        2 => Just(None),
        1 => (vec(any::<[i16; 3]>(), CORNERS), 0_u32..=16).prop_map(Some),
    ];
    let viewport = prop_oneof![
        3 => Just(None),
        1 => (-4096..4097, -4096..4097, 1_u32..4097, 1_u32..4097).prop_map(Some),
        1 => (-40..40, -40..40, 1_u32..80, 1_u32..80).prop_map(Some),
    ];
    let cull = select(vec![Cull::Back, Cull::Nothing, Cull::Front]);
    let options = (viewport, cull).prop_map(|(viewport, cull)| match viewport {
        None => DrawOptions::new().with_cull(cull),
        Some((x, y, width, height)) => DrawOptions::new()
            .with_cull(cull)
            .with_viewport(Viewport::new(x, y, width, height).unwrap()),
    });
    let what = select(vec![
        What::Triangles,
        What::Edges,
        What::Points,
        What::Normals,
        What::Lit,
        What::Depth,
    ]);
    (
        (
            vec(prop_oneof![vector(), near], CORNERS),
            short,
            vec(
                prop::array::uniform2(bits()).prop_map(Vec2::from_bits),
                CORNERS,
            ),
            vec(prop::array::uniform3(index()), 4),
            vec(prop::array::uniform2(index()), 4),
        ),
        (
            options,
            size,
            1_u32..8,
            select(vec![Format::Linear, Format::Float, Format::WideFloat]),
            (what, modes()),
            transform(),
            transform(),
        ),
    )
        .prop_map(|((positions, short, uvs, faces, edges), rest)| {
            let (options, size, rows, depth, (what, mode), model, camera) = rest;
            Scene {
                positions,
                short,
                uvs,
                faces,
                edges,
                options,
                size,
                rows,
                depth,
                what,
                mode,
                model,
                camera,
            }
        })
}

/// Varyings of three numbers, each with a tolerance.
#[derive(Clone, Copy)]
struct Rough([i32; 3]);

impl Varyings for Rough {
    type Lanes = [(); 3];
    type Face = ();

    fn tolerances() -> [Tolerance; 3] {
        [
            Tolerance::Texels,
            Tolerance::Units(1 << 20),
            Tolerance::Units(u32::MAX),
        ]
    }

    fn split(self) -> ([i32; 3], ()) {
        (self.0, ())
    }

    fn join(numbers: [i32; 3], (): ()) -> Self {
        Self(numbers)
    }
}

/// A shader with varyings of any magnitude, one of which jumps between the ends of its format.
#[derive(Clone, Copy)]
struct Raw;

impl Shader for Raw {
    type Color = Gray8;
    type Varyings = Rough;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Rough; 3] {
        primitive.corners(|corner| {
            let [x, y, _] = corner.position().to_bits();
            let end = if y & 1 == 0 { i32::MIN } else { i32::MAX };
            Rough([x, corner.uv().x.to_bits(), end])
        })
    }

    fn shade(&self, at: &Fragment, Rough([a, b, c]): Rough) -> Option<Gray8> {
        let [mixed, ..] = (a ^ a >> 16 ^ b ^ c ^ i32::from(at.depth)).to_le_bytes();
        Some(Gray8::new(mixed))
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
            Some((positions, fraction)) => Mesh::short(positions, *fraction, &self.faces),
            None => Mesh::new(&self.positions, &self.faces),
        };
        let mesh = &mesh
            .and_then(|mesh| mesh.with_edges(&self.edges))
            .and_then(|mesh| mesh.with_uvs(&self.uvs, None))
            .unwrap();
        let options = &self.options;
        let drawn = match (self.what, self.mode) {
            // Modes differ in how they interpolate numbers. Those of `Raw` are arbitrary, so it is enough to draw other
            // numbers in one mode, which saves the compiler seconds.
            (What::Normals, _) => canvas.draw_with(options, mesh, mvp, &NormalView::new()),
            (What::Lit, _) => {
                let light = Light::new(vec3!(1, 2, 3), fx!(0.5), fx!(0.5)).unwrap();
                let white = Flat::rgb(Rgb888::new(255, 255, 255));
                canvas.draw_with(options, mesh, mvp, &white.lit(light))
            }
            (_, Mode::Newton) => self.draw_in(&options.with_mode(Newton), canvas, mesh, mvp),
            (_, Mode::Exact) => self.draw_in(&options.with_mode(Exact), canvas, mesh, mvp),
            (_, Mode::Compact) => self.draw_in(&options.with_mode(Compact), canvas, mesh, mvp),
            (_, Mode::Fast(texels)) => {
                self.draw_in(&options.with_mode(Fast::within(texels)), canvas, mesh, mvp)
            }
            (_, Mode::Affine) => self.draw_in(&options.with_mode(Affine), canvas, mesh, mvp),
        };
        assert!(drawn.clipped <= drawn.drawn && drawn.drawn <= drawn.submitted);
        for &position in &self.positions {
            let _ = canvas.project(options, mvp, position);
        }
    }

    fn draw_in<I: mode::Mode, K: ProjectionKind, D: DepthBuffer>(
        &self,
        options: &DrawOptions<I>,
        canvas: &mut Canvas<'_, Gray8, Native, D>,
        mesh: &Mesh<'_>,
        mvp: &Mvp<K>,
    ) -> Drawn {
        match self.what {
            What::Triangles => canvas.draw_with(options, mesh, mvp, &Raw),
            What::Edges => canvas.draw_edges(options, mesh, mvp, &Raw),
            What::Points => canvas.draw_points(options, mesh, mvp, &Raw),
            What::Depth => canvas.draw_with(options, mesh, mvp, &DepthView::new()),
            What::Normals | What::Lit => unreachable!("drawn in one mode"),
        }
    }

    fn draw_with_depth<K: ProjectionKind>(
        &self,
        canvas: Canvas<'_, Gray8, Native, NoDepth>,
        depths: &mut [u16],
        projection: Projection<K>,
    ) {
        match self.depth {
            Format::Linear => self.draw(&mut canvas.with_depth(depths).unwrap(), projection),
            Format::Float => {
                let canvas = canvas.with_depth_format::<Float>(depths);
                self.draw(&mut canvas.unwrap(), projection);
            }
            Format::WideFloat => {
                let canvas = canvas.with_depth_format::<WideFloat>(depths);
                self.draw(&mut canvas.unwrap(), projection);
            }
        }
    }

    /// Draws the frame at once and in bands, and compares all bits.
    fn check<K: ProjectionKind>(
        &self,
        projection: Result<Projection<K>, Error>,
    ) -> Result<(), TestCaseError> {
        let Ok(projection) = projection else {
            return Ok(());
        };
        let (width, height) = self.size;
        let blank = || {
            let pixels = (width * height) as usize;
            (vec![Gray8::new(7); pixels], vec![0_u16; pixels])
        };
        let (mut colors, mut depths) = blank();
        let canvas = Canvas::new(&mut colors, width, height).unwrap();
        self.draw_with_depth(canvas, &mut depths, projection);

        let (mut band_colors, mut band_depths) = blank();
        let band = (width * self.rows) as usize;
        let bands = band_colors
            .chunks_mut(band)
            .zip(band_depths.chunks_mut(band));
        for (first_row, (colors, depths)) in (0..height).step_by(self.rows as usize).zip(bands) {
            let canvas = Canvas::band(colors, width, height, first_row).unwrap();
            self.draw_with_depth(canvas, depths, projection);
        }
        prop_assert_eq!(colors, band_colors);
        prop_assert_eq!(depths, band_depths);
        Ok(())
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6000))]

    #[test]
    fn perspective_is_total(scene in scene(), fov in 1_u32..1 << 31, cut in 0_u32..16, near in scalar(), far in scalar()) {
        let fov = Angle::from_bits((fov >> cut).max(1));
        scene.check(Projection::perspective(fov, scene.size, near, far))?;
    }

    #[test]
    fn off_center_perspective_is_total(scene in scene(), edges in prop::array::uniform6(scalar())) {
        let [l, r, b, t, n, f] = edges;
        let window = Window { left: l.min(r), right: l.max(r), bottom: b.min(t), top: b.max(t) };
        scene.check(Projection::frustum(window, n, f))?;
    }

    #[test]
    fn parallel_projections_are_total(scene in scene(), edges in prop::array::uniform6(scalar()), angle: u32) {
        let [l, r, b, t, n, f] = edges;
        let window = Window { left: l.min(r), right: l.max(r), bottom: b.min(t), top: b.max(t) };
        scene.check(Projection::orthographic(window, n, f))?;
        let angle = Angle::from_bits(angle);
        scene.check(Projection::cabinet(angle, window, n, f))?;
    }
}
