//! Shaders that a program implements itself, and lists of models with different shaders.

use std::cell::RefCell;

use embedded_graphics::pixelcolor::{BinaryColor, Rgb565, Rgb888, RgbColor};
use fixel::Primitive;
use fixel::mode::{Affine, Exact, Fast, Mode, Newton};
use fixel::prelude::*;
use fixel::shade::{PerFace, Within};
use fixel::view::Perspective;
use rand::Rng;

use crate::List;
use support::erased::{Erased, Padded};
use support::random::cases;

const WIDTH: u32 = 48;
const HEIGHT: u32 = 36;

static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
static BALL: Mesh = shape!(sphere(12, 8));
static SKIN: [[Rgb565; 4]; 2] = [
    [Rgb565::WHITE, Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE],
    [
        Rgb565::new(9, 40, 3),
        Rgb565::CYAN,
        Rgb565::MAGENTA,
        Rgb565::YELLOW,
    ],
];

type Screen<'c> = crate::Screen<'c, Rgb565>;

fn sun() -> Light {
    Light::new(vec3!(1, 2, 3), fx!(0.2), fx!(0.8)).unwrap()
}

fn projection() -> Projection<Perspective> {
    Projection::perspective(Angle::from_degrees(60), (WIDTH, HEIGHT), fx!(1), fx!(20)).unwrap()
}

/// Places the mesh in front of the eye, and turns it. The near plane clips a part of the mesh.
fn pose() -> Transform {
    let turn =
        Transform::rotate_x(Angle::from_degrees(25)) * Transform::rotate_y(Angle::from_degrees(50));
    Transform::translate(vec3!(0, 0, -2.5)) * turn
}

/// The picture that `draw` draws, and its depths.
fn picture(draw: &dyn Fn(&mut Screen<'_>)) -> (Vec<Rgb565>, Vec<u16>) {
    let before = (Rgb565::BLACK, 0);
    let (colors, depths) =
        crate::picture((WIDTH, HEIGHT), HEIGHT, before, &mut |canvas| draw(canvas));
    assert!(
        colors.iter().any(|color| *color != Rgb565::BLACK),
        "nothing is drawn"
    );
    (colors, depths)
}

/// A wrapper as a program might write it: the wrapper passes on the varyings and two methods of the inner shader.
#[derive(Clone, Copy)]
struct Same<S>(S);

impl<S: Shader> Shader for Same<S> {
    type Color = S::Color;
    type Varyings = S::Varyings;

    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.0.varyings(primitive)
    }

    fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<S::Color> {
        self.0.shade(at, varyings)
    }
}

/// A wrapper that adds its own varyings to the varyings of the inner shader.
///
/// The wrapper's own varyings have a tolerance. If a varying had no tolerance, triangles with almost no change in depth
/// would be drawn exactly.
#[derive(Clone, Copy)]
struct WithFace<S>(S);

impl<S: Shader> Shader for WithFace<S> {
    type Color = S::Color;
    type Varyings = (PerFace<usize>, (S::Varyings, Within<64, [i32; 2]>));

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let face = PerFace(primitive.face().unwrap_or_default());
        self.0
            .varyings(primitive)
            .map(|corner| (face, (corner, Within([7, -7]))))
    }

    fn shade(
        &self,
        at: &Fragment,
        (face, (inside, Within(own))): Self::Varyings,
    ) -> Option<S::Color> {
        // A value that is equal at all corners can still have a rounding error.
        assert!(face.0 < 12 && own[0].abs_diff(7) <= 60 && own[1].abs_diff(-7) <= 60);
        self.0.shade(at, inside)
    }
}

/// Draws every kind of element that a canvas can draw with a shader.
fn everything<S: ShaderFor<Rgb565>>(canvas: &mut Screen<'_>, mode: impl Mode, shader: &S) {
    let options = DrawOptions::new().with_mode(mode);
    let mvp = projection() * pose();
    canvas.draw_with(&options, &BOX, &mvp, shader);
    let aside = mvp * Transform::translate(vec3!(1.5, 0.5, 0));
    canvas.draw_with(&options, BOX.edges(LineStyle::HAIRLINE), &aside, shader);
    canvas.draw_with(
        &options,
        BOX.points(PointStyle::PIXEL),
        &(aside * Transform::scale(fx!(0.5))),
        shader,
    );
    let mut list: List = DrawList::new();
    let behind = mvp * Transform::translate(vec3!(-2, 0, -1));
    let prepared = list
        .prepare(&options, (WIDTH, HEIGHT), &BOX, &behind)
        .unwrap();
    canvas.draw_prepared(&prepared, shader).unwrap();
}

/// The picture of everything with a shader. All shaders share a rasterizer.
fn padded(mode: impl Mode, shader: impl ShaderFor<Rgb565>) -> (Vec<Rgb565>, Vec<u16>) {
    let padded = Padded::new(shader);
    picture(&|canvas| everything(canvas, mode, &padded.erased()))
}

fn check_wrappers<S: ShaderFor<Rgb565>>(mode: impl Mode, shader: S) {
    let expected = padded(mode, shader);
    assert!(padded(mode, Same(shader)) == expected);
    assert!(padded(mode, WithFace(shader)) == expected);
}

#[test]
fn a_wrapper_of_ten_lines_draws_the_same() {
    let skin = Textured::new(&SKIN);
    check_wrappers(Newton::default(), skin.lit(sun()));
    check_wrappers(Exact, skin.lit(sun()));
    check_wrappers(Fast::within(fx!(0.25)), skin.lit(sun()));
    check_wrappers(Affine, skin.lit(sun()));
    check_wrappers(
        Newton::default(),
        skin.clamped().bilinear().lit_faces(sun()),
    );
    check_wrappers(
        Newton::default(),
        FaceColors::new(&[Rgb565::RED, Rgb565::BLUE]).tinted(),
    );
    // The wrapper also works in itself and inside another shader.
    let lit = picture(&|canvas| everything(canvas, Newton::default(), &skin.lit(sun())));
    assert!(padded(Newton::default(), Same(skin).lit(sun())) == lit);
    assert!(padded(Newton::default(), Same(Same(skin.lit(sun())))) == lit);
    // A rasterizer of its own draws the wrapper, too.
    assert!(
        picture(&|canvas| everything(canvas, Newton::default(), &Same(skin.lit(sun())))) == lit
    );
}

/// The colors of a surface reach a light in full precision through a wrapper.
#[test]
fn a_wrapper_under_a_light_keeps_the_precision() {
    fn drawn(shader: impl ShaderFor<BinaryColor>) -> Vec<BinaryColor> {
        let mut pixels = vec![BinaryColor::Off; (WIDTH * HEIGHT) as usize];
        let mut canvas = Canvas::new(&mut pixels, WIDTH, HEIGHT).unwrap();
        canvas.draw(&BALL, &(projection() * pose()), &Erased::new(&shader));
        pixels
    }
    let gray = Flat::rgb(Rgb888::new(150, 150, 150));
    assert!(drawn(Same(gray).lit(sun())) == drawn(gray.lit(sun())));
    let expected = drawn(Gouraud::new().lit_faces(sun()));
    assert!(drawn(Same(Gouraud::new()).lit_faces(sun())) == expected);
}

/// A mesh with its shader.
struct Model<'m, S> {
    mesh: &'m Mesh<'m>,
    place: Transform,
    shader: S,
}

/// A model with any shader. Because the trait does not name the shader's type, one list can hold models with different
/// shaders.
trait Draw {
    fn draw(&self, canvas: &mut Screen<'_>, view: &Projection<Perspective>);
}

impl<S: ShaderFor<Rgb565>> Draw for Model<'_, S> {
    fn draw(&self, canvas: &mut Screen<'_>, view: &Projection<Perspective>) {
        canvas.draw(self.mesh, &(*view * self.place), &self.shader);
    }
}

#[test]
fn a_list_holds_models_with_different_shaders() {
    let at = |x: i16| {
        Transform::translate(Vec3::from_ints(x, 0, -6))
            * Transform::rotate_y(Angle::from_degrees(30))
    };
    let plain = Model {
        mesh: &BALL,
        place: at(-3),
        shader: Flat::rgb(Rgb888::RED).lit(sun()),
    };
    let skin = Model {
        mesh: &BOX,
        place: at(0),
        shader: Textured::new(&SKIN).lit(sun()),
    };
    let holes = Model {
        mesh: &BALL,
        place: at(3),
        shader: FaceColors::new(&[Rgb565::RED, Rgb565::BLUE])
            .map(|at, color| ((at.point.x + at.point.y) % 2 == 0).then_some(color)),
    };
    let scene: [&dyn Draw; 3] = [&plain, &skin, &holes];

    let view = projection();
    let drawn = picture(&|canvas| scene.iter().for_each(|model| model.draw(canvas, &view)));
    let expected = picture(&|canvas| {
        canvas.draw(plain.mesh, &(view * plain.place), &plain.shader);
        canvas.draw(skin.mesh, &(view * skin.place), &skin.shader);
        canvas.draw(holes.mesh, &(view * holes.place), &holes.shader);
    });
    assert!(drawn == expected);
}

/// Blends a color with gray fog that grows with distance: no fog at the near plane, only fog far away.
fn fogged(depth: u16, color: Rgb565) -> Rgb565 {
    // Depth is 65535 · near / distance.
    let mix = |own: u8, fog: u8| {
        let sum = u32::from(own) * u32::from(depth) + u32::from(fog) * u32::from(65535 - depth);
        (sum / 65535) as u8
    };
    Rgb565::new(mix(color.r(), 20), mix(color.g(), 40), mix(color.b(), 20))
}

#[test]
fn a_shader_may_compute_fog_from_depth() {
    let lit = Textured::new(&SKIN).lit(sun());
    let fog = lit.map(|at, color| Some(fogged(at.depth, color.finish(at.point))));
    let mvp = projection() * pose();
    let (foggy, _) = picture(&|canvas| {
        canvas.draw(&BOX, &mvp, &Erased::new(&fog));
    });
    // Compare with the surface without fog, pixel by pixel.
    let mut expected = vec![Rgb565::BLACK; foggy.len()];
    let mut nearest = vec![0; foggy.len()];
    let seen = RefCell::new(Vec::new());
    let clear = lit.map(|at, color| {
        let color = color.finish(at.point);
        seen.borrow_mut().push((*at, color));
        Some(color)
    });
    picture(&|canvas| {
        canvas.draw(&BOX, &mvp, &Erased::new(&clear));
    });
    let seen = seen.into_inner();
    for &(Fragment { point, depth }, color) in &seen {
        let at = (point.y.cast_unsigned() * WIDTH + point.x.cast_unsigned()) as usize;
        if depth >= nearest[at] {
            nearest[at] = depth;
            expected[at] = fogged(depth, color);
        }
    }
    assert_eq!(foggy, expected);
    let depths = seen.iter().map(|(at, _)| at.depth);
    assert!(
        depths.clone().max().unwrap() > 2 * depths.min().unwrap(),
        "all pixels have the same distance"
    );
}

/// Vertex light times vertex colors equals a computation in f64, within 0.6 of a step.
#[test]
fn vertex_colors_are_lit_as_in_f64() {
    // A floor that rises to the right, in eye space.
    let corners: [[f64; 3]; 3] = [[-2.5, -1., -1.5], [3.5, -0.5, -2.], [0.5, 2.5, -9.]];
    let normals: [[f64; 3]; 3] = [[0., 0., 1.], [0.5, 1., 0.25], [-1., 0.75, 1.]];
    let colors = [[250_u8, 20, 90], [30, 240, 160], [200, 130, 10]];
    let (direction, ambient, diffuse) = ([1., 2., 3.], 0.25, 0.75);

    let vectors = |of: [[f64; 3]; 3]| of.map(|vector| Vec3::try_from(vector).unwrap());
    let (positions, mesh_normals) = (vectors(corners), vectors(normals));
    let mesh_colors = colors.map(|[r, g, b]| Rgb888::new(r, g, b));
    let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
    let mesh = mesh.with_normals(&mesh_normals, None).unwrap();
    let mesh = mesh.with_colors(&mesh_colors, None).unwrap();
    let sun = Light::new(vec3!(1, 2, 3), fx!(0.25), fx!(0.75)).unwrap();
    let focal = Projection::from_focal_length(fx!(40), (WIDTH, HEIGHT), fx!(0.5), fx!(20)).unwrap();
    let mut pixels = vec![Rgb888::BLACK; (WIDTH * HEIGHT) as usize];
    let mut canvas = Canvas::new(&mut pixels, WIDTH, HEIGHT).unwrap();
    canvas.draw(
        &mesh,
        &(focal * Transform::IDENTITY),
        &Gouraud::new().lit(sun),
    );

    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    };
    let lights = normals.map(|normal| {
        let facing =
            dot(normal, direction) / (dot(normal, normal) * dot(direction, direction)).sqrt();
        ambient + diffuse * facing.max(0.)
    });
    let [a, b, c] = corners;
    let mut compared = 0;
    for (i, color) in (0_u32..).zip(&pixels) {
        let (x, y) = (f64::from(i % WIDTH) + 0.5, f64::from(i / WIDTH) + 0.5);
        let ray = [
            (x - f64::from(WIDTH) / 2.) / 40.,
            (f64::from(HEIGHT) / 2. - y) / 40.,
            -1.,
        ];
        // The volume that the ray and two corners span is the barycentric weight, in space, of the third corner.
        let volumes = [cross(b, c), cross(c, a), cross(a, b)].map(|side| dot(ray, side));
        let weights = volumes.map(|volume| volume / volumes.iter().sum::<f64>());
        // Skip pixels near the outline, because rounding decides whether they are drawn.
        if weights.iter().any(|weight| *weight < 0.005) {
            continue;
        }
        compared += 1;
        let light = dot(weights, lights);
        for (k, found) in [color.r(), color.g(), color.b()].into_iter().enumerate() {
            let expected = light * dot(weights, colors.map(|color| f64::from(color[k])));
            // Rounding the color causes an error of up to half a step. Rounding corners to 1/256 pixel adds less than
            // 0.1 steps.
            let error = (f64::from(found) - expected).abs();
            assert!(error <= 0.6, "{found} at {x}, {y} is not {expected}");
        }
    }
    assert!(compared > 300, "{compared}");
}

/// A small triangle with a color at each corner, in a mode.
fn small_triangle(places: [[f64; 3]; 3], colors: &[Rgb888; 3], mode: impl Mode) -> Vec<Rgb565> {
    // At a distance of 32, one unit is one pixel.
    let projection = Projection::from_focal_length(fx!(32), (64, 48), fx!(1), fx!(100)).unwrap();
    let positions = places.map(|[x, y, near]| {
        let at = |v: f64| Scalar::try_from(v * (32. - near) / 32.).unwrap();
        Vec3::new(
            at(x - 32.),
            at(24. - y),
            Scalar::try_from(near - 32.).unwrap(),
        )
    });
    let mesh = Mesh::new(&positions, &[[0, 1, 2]])
        .and_then(|mesh| mesh.with_colors(colors, None))
        .unwrap();
    let mut pixels = vec![Rgb565::new(1, 2, 3); 64 * 48];
    let options = DrawOptions::new().with_cull(Cull::Nothing).with_mode(mode);
    let mut canvas = Canvas::new(&mut pixels, 64, 48).unwrap();
    canvas.draw_with(&options, &mesh, &projection, &Gouraud::new());
    pixels
}

/// Small triangles keep red and blue in one number. If an error carried from one channel into the other, black would
/// become full blue. Only a value near the middle between two steps may be rounded to the other step.
#[test]
fn colors_of_small_triangles_are_within_a_step_of_the_exact_ones() {
    cases(2000, |random| {
        let x = random.random_range(10.0..44.0);
        let y = random.random_range(10.0..28.0);
        let thin = f64::from(1 << random.random_range(0..6));
        // If the corners are at pixel centers, edges pass through centers, too. There, a channel takes its lowest
        // value.
        let is_centered = random.random();
        let snap = |v: f64| if is_centered { v.floor() + 0.5 } else { v };
        let places = [(); 3].map(|()| {
            let across = snap(x + random.random_range(-10.0..10.0));
            let down = snap(y + random.random_range(-10.0..10.0) / thin);
            [across, down, random.random_range(-0.3..0.3)]
        });
        let is_extreme = random.random();
        let colors = [(); 3].map(|()| {
            let [r, g, b] = random.random::<[u8; 3]>();
            let channel = |v: u8| if is_extreme { v / 128 * 255 } else { v };
            Rgb888::new(channel(r), channel(g), channel(b))
        });
        let [fast, exact] = [
            small_triangle(places, &colors, Newton::default()),
            small_triangle(places, &colors, Exact),
        ];
        for (fast, exact) in fast.into_iter().zip(exact) {
            let off = |channel: fn(&Rgb565) -> u8| channel(&fast).abs_diff(channel(&exact));
            let off = [off(RgbColor::r), off(RgbColor::g), off(RgbColor::b)];
            assert!(off.iter().all(|&off| off <= 1), "{fast:?} is not {exact:?}");
        }
    });
}
