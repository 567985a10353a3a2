//! Stacks of adapters. In any order and number of adapters, a color is rounded or dithered only once, when it is
//! stored.
//!
//! Every stack of up to three adapters, over every kind of surface, is compared with the exact color, computed in f64.
//! Surface, light, tint, fog and opacity are the same at all pixels. So the mean of 8x8 pixels, the size of the dither
//! matrix, must be the exact color.

use std::cell::Cell;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray2, Gray4, Gray8, GrayColor, Rgb565, Rgb666, Rgb888, RgbColor,
};
use fixel::canvas::Opacity;
use fixel::prelude::*;
use fixel::shade::{Illumination, Output, Precise, PreciseOf, Translucent};
use fixel::view::Parallel;
use fixel::{Primitive, Window};

use rand::Rng;

use support::random::{Random, cases};
use support::reference::blending::over;
use support::reference::fog::linear;

const SIDE: u32 = 8;
static SQUARE: Mesh = shape!(plane(1, 1));

/// The distance of the square. The fog reaches from 1 to 9.
const DISTANCE: f64 = 6.;

/// The values of a scene. The values are the same at all pixels.
#[derive(Clone, Copy, Debug)]
struct Scene {
    surface: Rgb888,
    /// The color at all corners of [`SQUARE`]. Tints multiply by this color, and [`Gouraud`] shows it.
    tint: Rgb888,
    ground: Rgb888,
    /// Brightness in 65,536ths.
    light: i32,
    /// Opacity in 255ths.
    opacity: u8,
}

impl Scene {
    fn random(random: &mut Random) -> Self {
        let mut color = || {
            let [r, g, b] = random.random();
            Rgb888::new(r, g, b)
        };
        Self {
            surface: color(),
            tint: color(),
            ground: color(),
            light: random.random_range(0..=1 << 16),
            opacity: random.random(),
        }
    }

    /// The color of the ground in the canvas's format: between black and white, if the format has such a color.
    fn ground<C: Channels>(&self) -> C {
        C::from_rgb(self.ground, Point::default())
    }

    fn sun(&self) -> Light {
        Light::new(vec3!(0, 1, 0), Scalar::from_bits(self.light), fx!(0)).unwrap()
    }

    fn share(&self) -> f64 {
        f64::from(self.light) / 65_536.
    }
}

/// A color of a canvas, and its channels from 0 to 1.
trait Channels: PixelFormat + Default {
    fn channels(self) -> [f64; 3];

    /// Converts a color of 24 bits to the channels of this format, in full precision.
    fn exact(color: Rgb888) -> [f64; 3];
}

fn fractions(color: Rgb888) -> [f64; 3] {
    [color.r(), color.g(), color.b()].map(|channel| f64::from(channel) / 255.)
}

macro_rules! channels {
    (rgb: $($color:ident)+) => {$(
        impl Channels for $color {
            fn channels(self) -> [f64; 3] {
                [
                    f64::from(self.r()) / f64::from($color::MAX_R),
                    f64::from(self.g()) / f64::from($color::MAX_G),
                    f64::from(self.b()) / f64::from($color::MAX_B),
                ]
            }

            fn exact(color: Rgb888) -> [f64; 3] {
                fractions(color)
            }
        }
    )+};
    (gray: $($color:ident |$gray:ident| $value:expr;)+) => {$(
        impl Channels for $color {
            fn channels(self) -> [f64; 3] {
                let $gray = self;
                [$value; 3]
            }

            fn exact(color: Rgb888) -> [f64; 3] {
                let [r, g, b] = fractions(color);
                [0.299 * r + 0.587 * g + 0.114 * b; 3]
            }
        }
    )+};
}

channels!(rgb: Rgb565 Rgb666 Rgb888);
channels! {
    gray:
    Gray2 |gray| f64::from(gray.luma()) / 3.;
    Gray4 |gray| f64::from(gray.luma()) / 15.;
    Gray8 |gray| f64::from(gray.luma()) / 255.;
    BinaryColor |gray| f64::from(u8::from(gray.is_on()));
}

fn each(a: [f64; 3], b: [f64; 3], f: impl Fn(f64, f64) -> f64) -> [f64; 3] {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]
}

/// A stack with its type erased. The varyings are equal at all corners of [`SQUARE`], so the function contains them.
/// With this type, tests of three adapters are compiled once for each adapter, and not for each stack.
#[derive(Clone, Copy)]
struct Erased<'a, C>(&'a dyn Fn(&Fragment) -> Precise<C>);

impl<C: PixelFormat> Shader for Erased<'_, C> {
    type Color = Precise<C>;
    type Varyings = ();

    fn varyings(&self, _: &Primitive<'_>) -> [(); 3] {
        [(); 3]
    }

    fn shade(&self, at: &Fragment, (): ()) -> Option<Precise<C>> {
        Some((self.0)(at))
    }
}

/// Calls a function with a triangle of [`SQUARE`].
#[derive(Clone, Copy)]
struct Hook<'a>(&'a dyn Fn(&Primitive<'_>));

impl Shader for Hook<'_> {
    type Color = Gray8;
    type Varyings = ();

    fn varyings(&self, primitive: &Primitive<'_>) -> [(); 3] {
        (self.0)(primitive);
        [(); 3]
    }

    fn shade(&self, _: &Fragment, (): ()) -> Option<Gray8> {
        None
    }
}

/// An adapter that halves a color, as a program could define it.
#[derive(Clone, Copy)]
struct Half<S>(S);

impl<S: Shader<Color: Output<Color: PixelFormat>>> Shader for Half<S> {
    type Color = PreciseOf<S>;
    type Varyings = S::Varyings;

    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.0.varyings(primitive)
    }

    fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<PreciseOf<S>> {
        let output = self.0.shade(at, varyings)?;
        Some(output.lit(Illumination::white(1 << 15)))
    }
}

fn from_above() -> Mvp<Parallel> {
    let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(9));
    projection.unwrap() * Camera::top(Vec3::ZERO, fx!(6))
}

/// The channels that a stack must show, from 0 to 1.
type Exact = [f64; 3];

/// The inputs of all tests of one scene.
struct Tests<'a> {
    triangle: &'a Primitive<'a>,
    scene: Scene,
}

impl Tests<'_> {
    /// Compares a stack with the model, opaque and blended with the ground. If `more` is above 0, does the same with
    /// each adapter added in turn.
    fn stack<C: Channels>(
        &self,
        name: &str,
        shader: impl Shader<Color: Output<Color = C>>,
        exact: Exact,
        more: usize,
    ) {
        let [varyings, ..] = shader.varyings(self.triangle);
        let precise = |at: &Fragment| {
            let kept = Cell::new(None);
            let output = shader.shade(at, varyings).unwrap();
            let _ = output.map::<C>(|color| {
                kept.set(Some(color));
                color
            });
            kept.get().unwrap()
        };
        let erased = Erased(&precise);
        self.check(name, &erased, exact, None);
        self.check(name, &erased, exact, Some(self.scene.opacity));
        if more > 0 {
            self.adapters(name, erased, exact, more - 1);
        }
    }

    fn adapters<C: Channels>(
        &self,
        name: &str,
        shader: impl Shader<Color: Output<Color = C>>,
        exact: Exact,
        more: usize,
    ) {
        let (scene, sun) = (self.scene, self.scene.sun());
        let lit = exact.map(|channel| channel * scene.share());
        self.stack(&format!("{name}.lit"), shader.lit(sun), lit, more);
        self.stack(
            &format!("{name}.lit_faces"),
            shader.lit_faces(sun),
            lit,
            more,
        );
        let tinted = each(exact, C::exact(scene.tint), |a, b| a * b);
        self.stack(&format!("{name}.tinted"), shader.tinted(), tinted, more);
        let fog = Fog::linear(scene.ground::<C>(), fx!(1), fx!(9)).unwrap();
        let left = linear(DISTANCE, 1., 9.);
        let foggy = each(exact, scene.ground::<C>().channels(), |a, b| {
            over(a, b, left)
        });
        self.stack(&format!("{name}.in_fog"), shader.in_fog(fog), foggy, more);
        let same = shader.map(|_, color| Some(color));
        self.stack(&format!("{name}.map"), same, exact, more);
        let half = exact.map(|channel| channel / 2.);
        self.stack(&format!("{name}.half"), Half(shader), half, more);
    }

    /// Draws a stack over the ground, and compares the mean of all pixels with the model.
    fn check<C: Channels>(
        &self,
        name: &str,
        shader: &Erased<'_, C>,
        exact: Exact,
        opacity: Option<u8>,
    ) {
        let ground = self.scene.ground::<C>();
        let mut pixels = [ground; (SIDE * SIDE) as usize];
        let mut canvas = Canvas::new(&mut pixels, SIDE, SIDE).unwrap();
        let mut expected = exact;
        if let Some(opacity) = opacity {
            let options = DrawOptions::new().with_blending(Opacity(opacity));
            canvas.draw_with(&options, &SQUARE, &from_above(), shader);
            let share = f64::from(opacity) / 255.;
            expected = each(exact, ground.channels(), |above, below| {
                over(above, below, share)
            });
        } else {
            canvas.draw(&SQUARE, &from_above(), shader);
        }
        let sum = pixels.iter().fold([0.; 3], |sum, pixel| {
            each(sum, pixel.channels(), |a, b| a + b)
        });
        let steps = C::MAX_STEPS.map(f64::from);
        for ((sum, expected), steps) in sum.into_iter().zip(expected).zip(steps) {
            let error = (sum / f64::from(SIDE * SIDE) - expected) * steps;
            // A dithered mean is within 1/128 step of the level, and the level can have an error of 1/128 step, too.
            // Other formats are rounded to nearest. Each of up to four products drops less than 1/250 step. The
            // rounding of a color of 24 bits to units of 2^-16, and the weights of a luma (2^-15 each), add less than
            // 0.012 of 255 steps.
            let tolerance = if C::IS_DITHERED {
                1. / 64.
            } else {
                0.5 + 4. / 250. + 0.012
            };
            assert!(
                error.abs() <= tolerance,
                "{name} covering {opacity:?} is {error} steps from {} of {} in {:?}",
                expected * steps,
                core::any::type_name::<C>(),
                self.scene,
            );
        }
    }
}

/// All stacks of up to three adapters over a surface in the canvas's format, a surface of 24 bits, and vertex colors.
fn all<C: Channels>(scene: Scene) {
    let colors = [scene.tint; 4];
    let mesh = SQUARE.with_colors(&colors, None).unwrap();
    let hook = |triangle: &Primitive<'_>| {
        let tests = Tests { triangle, scene };
        let plain = C::from_rgb(scene.surface, Point::default());
        tests.adapters::<C>("plain", Flat::new(plain), plain.channels(), 2);
        tests.stack::<C>("rgb", Flat::rgb(scene.surface), C::exact(scene.surface), 3);
        tests.stack::<C>("vertex colors", Gouraud::new(), C::exact(scene.tint), 3);
        let lit = C::exact(scene.surface).map(|channel| channel * scene.share());
        let wide = Flat::new(scene.surface).lit(scene.sun());
        tests.stack::<C>("lit.converted", wide.converted(), lit, 1);
    };
    let mut pixel = [Gray8::new(0)];
    let mut canvas = Canvas::new(&mut pixel, 1, 1).unwrap();
    canvas.draw(&mesh, &from_above(), &Hook(&hook));
}

#[test]
fn dithered_formats_show_the_product() {
    cases(8, |random| {
        let scene = Scene::random(random);
        all::<BinaryColor>(scene);
        all::<Gray2>(scene);
        all::<Gray4>(scene);
    });
}

#[test]
fn rounded_formats_show_the_product() {
    cases(8, |random| {
        let scene = Scene::random(random);
        all::<Rgb565>(scene);
        all::<Rgb666>(scene);
        all::<Rgb888>(scene);
        all::<Gray8>(scene);
    });
}

/// A translucent surface keeps its opacity through all adapters.
#[test]
fn translucent_surfaces_keep_their_opacity() {
    let surface = Flat::new(Gray4::new(12)).map(|_, color| {
        let opacity = 171;
        Some(Translucent { color, opacity })
    });
    let sun = Light::new(vec3!(0, 1, 0), fx!(0.5), fx!(0)).unwrap();
    let mut pixels = [Gray4::new(0); (SIDE * SIDE) as usize];
    let mut canvas = Canvas::new(&mut pixels, SIDE, SIDE).unwrap();
    canvas.draw(&SQUARE, &from_above(), &surface.lit(sun).lit_faces(sun));
    let sum: u32 = pixels.iter().map(|pixel| u32::from(pixel.luma())).sum();
    let exact = 12. / 4. * 171. / 255.;
    let mean = f64::from(sum) / f64::from(SIDE * SIDE);
    assert!((mean - exact).abs() <= 1. / 64., "{mean}, not {exact}");
}
