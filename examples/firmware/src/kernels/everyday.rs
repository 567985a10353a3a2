//! Measures what people draw: a model near and far, many draw calls, terrain, a wireframe, hidden pixels, sprites,
//! stacked effects, and screens filled by each sampler.
//!
//! All scenes are drawn in the default mode. Only the filled screens have no depth buffer.

use core::hint::black_box;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::Thing;
use fixel::prelude::*;
use fixel::texture::Mipmap;
use fixel::view::{AsMvp, Perspective};

use super::common::scenes::{CHECKER, HEIGHT, WIDTH};
use super::frames::Frame;
use super::ticks::Stopwatch;

// A model of 5,760 triangles, which the build script writes.
include!(concat!(env!("OUT_DIR"), "/wreath.rs"));

static CUBE: Mesh = shape!(cuboid(vec3!(0.35, 0.35, 0.35)));
static RING: Mesh = shape!(torus(fx!(0.4), 50, 20));
static GRID: Mesh = shape!(plane(64, 64));

/// All levels of a mipmap of one color.
static LEVELS: [Rgb565; Mipmap::<Rgb565>::len(64, 64)] =
    [Rgb565::RED; Mipmap::<Rgb565>::len(64, 64)];

/// The corners of a plane that faces the eye.
static CORNERS: [Vec3; 4] = [
    vec3!(-2, -2, 0),
    vec3!(2, -2, 0),
    vec3!(2, 2, 0),
    vec3!(-2, 2, 0),
];
static NORMALS: [Vec3; 4] = [Vec3::Z; 4];
static COLORS: [Rgb888; 4] = [Rgb888::RED, Rgb888::GREEN, Rgb888::BLUE, Rgb888::WHITE];

/// The stopwatch, and the memory of a frame.
struct Bench<'a> {
    watch: &'a mut Stopwatch,
    frame: &'a mut Frame,
    projection: Projection<Perspective>,
}

pub fn measure(watch: &mut Stopwatch, frame: &mut Frame) -> Result<(), Error> {
    let (focal, size) = (fx!(200), (WIDTH, HEIGHT));
    let mut bench = Bench {
        watch,
        frame,
        projection: Projection::from_focal_length(focal, size, fx!(0.25), fx!(100))?,
    };
    // The light and the fog are hidden from the compiler, because it does not know them in a user's program, either.
    let sun = black_box(Light::new(vec3!(2, 3, 6), fx!(0.25), fx!(0.75))?);
    let fog = black_box(Fog::linear(Rgb565::WHITE, fx!(2), fx!(40))?);
    bench.models(sun)?;
    bench.cubes(sun)?;
    bench.terrain(fog)?;
    bench.lines_and_sprites()?;
    bench.layers()?;
    bench.screens(sun, fog)
}

impl Bench<'_> {
    /// Draws a thing with each mvp, into a frame with a depth buffer. Prints the cost. Of a row whose name ends with
    /// `away`, nothing is in view.
    fn row<T: Thing<Rgb565>, S: ShaderFor<Rgb565>>(
        &mut self,
        (name, unit, units): (&str, &str, u32),
        thing: T,
        mvps: &[impl AsMvp],
        shader: &S,
    ) -> Result<(), Error> {
        let mut canvas = self.frame.canvas_with_depth()?;
        let mut drawn = 0;
        let ticks = self.watch.time(|| {
            for mvp in mvps {
                drawn += canvas.draw(thing, mvp, shader).drawn;
            }
            Ok::<_, Error>(())
        })?;
        assert_eq!(drawn == 0, name.ends_with("away"), "{name}: {drawn} drawn");
        self.watch.print(name, unit, units, ticks);
        Ok(())
    }

    /// Measures a model near and far, cut by the frame's edge, and behind the eye.
    fn models(&mut self, sun: Light) -> Result<(), Error> {
        let skin = Textured::new(&CHECKER);
        let lit = skin.lit(sun);
        for ([name, lit_name], place) in [
            (["wreath-far", "wreath-lit-far"], vec3!(0, 0, -16)),
            (["wreath-mid", "wreath-lit-mid"], vec3!(0, 0, -6)),
            (["wreath-near", "wreath-lit-near"], vec3!(0, 0, -3.2)),
            (["wreath-cut", "wreath-lit-cut"], vec3!(1.4, 0.6, -2.4)),
            (["wreath-away", "wreath-lit-away"], vec3!(0, 0, 9)),
        ] {
            let turned = Transform::translate(place) * Transform::rotate_x(deg!(-55));
            let mvp = [self.projection * turned];
            self.row((name, "frame", 1), &WREATH, &mvp, &skin)?;
            self.row((lit_name, "frame", 1), &WREATH, &mvp, &lit)?;
        }
        Ok(())
    }

    /// Measures 300 draw calls of 12 triangles.
    fn cubes(&mut self, sun: Light) -> Result<(), Error> {
        const COLUMNS: i32 = 20;
        const CUBES: usize = 300;
        let camera = Camera::look_at(vec3!(0, 0, 12), Vec3::ZERO, Vec3::Y)?;
        let mvps: [_; CUBES] = core::array::from_fn(|at| {
            let at = at as i32;
            let (x, y) = (2 * (at % COLUMNS) - COLUMNS + 1, at / COLUMNS - 7);
            let place = Vec3::new(fx!(0.5) * x, fx!(1) * y, fx!(0));
            let turn = Transform::rotate_y(Angle::from_degrees(17 * at));
            self.projection * camera * (Transform::translate(place) * turn)
        });
        let clay = Flat::rgb(Rgb888::new(236, 214, 190));
        let calls = |name| (name, "call", CUBES as u32);
        self.row(calls("cubes-flat"), &CUBE, &mvps, &clay)?;
        let skin = Textured::new(&CHECKER);
        self.row(calls("cubes-textured"), &CUBE, &mvps, &skin)?;
        self.row(calls("cubes-lit"), &CUBE, &mvps, &clay.lit(sun))
    }

    /// Measures a terrain of 64x64 cells in front of the eye, around it, and behind it.
    fn terrain(&mut self, fog: Fog<Rgb565>) -> Result<(), Error> {
        // Hills on a square from −16 to 16, with colors by height.
        const POINTS: usize = 65 * 65;
        let heights: [i32; POINTS] = core::array::from_fn(|at| {
            let [row, column] = [at / 65, at % 65].map(|at| at as i32);
            (column % 20 - 10).abs() * (row % 26 - 13).abs() // 0 to 130
        });
        let positions: [_; POINTS] = core::array::from_fn(|at| {
            let [x, _, z] = GRID.positions().get(at).unwrap_or_default().to_bits();
            Vec3::from_bits([16 * x, heights[at] << 11, 16 * z])
        });
        let greens = heights.map(|height| {
            let light = height as u8;
            Rgb888::new(30 + light, 90 + light, 20 + light / 2)
        });
        let terrain = Mesh::new(&positions, GRID.faces())?.with_colors(&greens, None)?;
        let colors = Gouraud::new();
        let misty = colors.in_fog(fog);
        let (hill, middle) = (vec3!(0, 8, 26), vec3!(0, 6, 0));
        for ([name, fog_name], [eye, target]) in [
            (["terrain", "terrain-fog"], [hill, Vec3::ZERO]),
            (
                ["terrain-around", "terrain-fog-around"],
                [middle, vec3!(2, 3, -16)],
            ),
            (
                ["terrain-away", "terrain-fog-away"],
                [hill, vec3!(0, 6, 50)],
            ),
        ] {
            let mvp = [self.projection * Camera::look_at(eye, target, Vec3::Y)?];
            self.row((name, "frame", 1), &terrain, &mvp, &colors)?;
            self.row((fog_name, "frame", 1), &terrain, &mvp, &misty)?;
        }
        Ok(())
    }

    /// Measures a wireframe, and sprites that are 1, 16 and 64 pixels wide.
    fn lines_and_sprites(&mut self) -> Result<(), Error> {
        let edges = ("line-depth", "edge", RING.edge_indices().len() as u32);
        let tilted = Transform::translate(vec3!(0, 0, -2.6)) * Transform::rotate_x(deg!(50));
        let (lines, white) = (RING.edges(LineStyle::HAIRLINE), Flat::new(Rgb565::WHITE));
        self.row(edges, lines, &[self.projection * tilted], &white)?;
        // At this distance, a unit is 100 pixels wide.
        let places: [Vec3; 12] = core::array::from_fn(|at| {
            let [x, y] = [at % 4 * 2, at / 4 * 2].map(|at| Scalar::from(at as u8));
            Vec3::new((x - fx!(3)) * fx!(0.36), (y - fx!(2)) * fx!(0.36), fx!(-2))
        });
        let skin = Textured::new(&CHECKER);
        for (name, side) in [
            ("sprite-1", fx!(0.01)),
            ("sprite-16", fx!(0.16)),
            ("sprite-64", fx!(0.64)),
        ] {
            let sprites = Sprites::new(&places, (side, side))?;
            self.row((name, "sprite", 12), &sprites, &[self.projection], &skin)?;
        }
        Ok(())
    }

    /// Measures eight planes that fill the frame, drawn from the front, so that seven are hidden, and from the back.
    fn layers(&mut self) -> Result<(), Error> {
        let uvs = repeats(4);
        let (plane, skin) = (plane(&uvs)?, Textured::new(&CHECKER));
        let front = [2, 3, 4, 5, 6, 7, 8, 9]
            .map(|at| self.projection * at_distance(at, Transform::IDENTITY));
        let mut back = front;
        back.reverse();
        let pixels = |name| (name, "pixel", 8 * WIDTH * HEIGHT);
        for ([flat, textured, gouraud], mvps) in [
            (["front-flat", "front-textured", "front-gouraud"], front),
            (["back-flat", "back-textured", "back-gouraud"], back),
        ] {
            self.row(pixels(flat), &plane, &mvps, &Flat::new(Rgb565::RED))?;
            self.row(pixels(textured), &plane, &mvps, &skin)?;
            self.row(pixels(gouraud), &plane, &mvps, &Gouraud::new())?;
        }
        Ok(())
    }

    /// Measures frames filled with each sampler, with effects, and with few and many repeats.
    fn screens(&mut self, sun: Light, fog: Fog<Rgb565>) -> Result<(), Error> {
        let rows = Textured::new(&CHECKER);
        let texture = black_box(Texture::new(CHECKER.as_flattened(), 64, 64)?);
        let texture = Textured::new(texture);
        let levels = Textured::new(Mipmap::new(&LEVELS, 64, 64)?);
        let levels = levels.mipmapped(&self.projection, (WIDTH, HEIGHT))?;
        self.screen("screen-rows", 4, &rows)?;
        self.screen("screen-lit", 4, &rows.lit(sun))?;
        self.screen("screen-fog", 4, &rows.in_fog(fog))?;
        self.screen("screen-lit-fog", 4, &rows.lit(sun).in_fog(fog))?;
        self.screen("screen-texture", 4, &texture)?;
        self.screen("screen-clamped", 1, &texture.clamped())?;
        self.screen("screen-bilinear", 4, &rows.bilinear())?;
        self.screen("screen-mipmap", 20, &levels)?;
        self.screen("screen-mipmap-bilinear", 20, &levels.bilinear())?;
        self.screen("screen-trilinear", 20, &levels.trilinear())?;
        self.screen("screen-24-repeats", 24, &rows)?;
        self.screen("screen-31-repeats", 31, &rows)
    }

    /// Fills a frame without a depth buffer. Prints the cost.
    fn screen<S: ShaderFor<Rgb565>>(
        &mut self,
        name: &str,
        times: i32,
        shader: &S,
    ) -> Result<(), Error> {
        let uvs = repeats(times);
        let lean = Transform::rotate_x(deg!(-20)) * Transform::rotate_y(deg!(10));
        let (plane, mvp) = (plane(&uvs)?, self.projection * at_distance(2, lean));
        let mut canvas = self.frame.canvas()?;
        let ticks = self
            .watch
            .time(|| Ok::<_, Error>(_ = canvas.draw(&plane, &mvp, shader)))?;
        self.watch.print(name, "pixel", WIDTH * HEIGHT, ticks);
        Ok(())
    }
}

/// The texture coordinates of a plane's corners, so that the texture repeats `times` times in each direction.
fn repeats(times: i32) -> [Vec2; 4] {
    [[0, 1], [1, 1], [1, 0], [0, 0]].map(|uv| Vec2::from_bits(uv.map(|end| (end * times) << 20)))
}

fn plane(uvs: &[Vec2; 4]) -> Result<Mesh<'_>, Error> {
    let plane = Mesh::new(&CORNERS, &[[0, 1, 2], [0, 2, 3]])?;
    let plane = plane.with_uvs(uvs, None)?.with_normals(&NORMALS, None)?;
    plane.with_colors(&COLORS, None)
}

/// The place of a plane that fills the frame. At each distance, it is the same picture.
fn at_distance(distance: i32, turn: Transform) -> Transform {
    let away = fx!(1) * distance;
    Transform::translate(Vec3::new(fx!(0), fx!(0), -away)) * turn * Transform::scale(away)
}
