//! Blended colors on canvases of every color type and storage, compared with the formulas in f64.

use std::fmt::Debug;

use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, RawData};
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565,
    Rgb666, Rgb888, RgbColor,
};
use fixel::canvas::{Add, Multiply, Opacity, Storage};
use fixel::mode::Compact;
use fixel::prelude::*;
use fixel::shade::{Output, Precise, Translucent};
use fixel::view::Parallel;
use fixel::{Primitive, Window};
use rand::Rng;

use support::random::cases;
use support::reference::blending::{add, multiply, over};

static SQUARE: Mesh = shape!(plane(1, 1));
/// The side of the dither matrix, in pixels. Coarse colors are dithered.
const SIZE: u32 = 8;

/// A color as a list of channels. For each channel: its value in this color, and its value in white.
type Channels = Vec<[f64; 2]>;

/// A color type with channels that the test can read.
trait Parts: PixelFormat + Debug + From<Self::Raw> {
    /// Whether the color is dithered.
    const IS_COARSE: bool = false;
    fn parts(self) -> Channels;
}

macro_rules! parts {
    (rgb: $($color:ident)+) => {$(
        impl Parts for $color {
            fn parts(self) -> Channels {
                [[self.r(), Self::MAX_R], [self.g(), Self::MAX_G], [self.b(), Self::MAX_B]]
                    .map(|part| part.map(f64::from))
                    .to_vec()
            }
        }
    )+};
    (gray: $($color:ident $white:literal $is_coarse:literal)+) => {$(
        impl Parts for $color {
            const IS_COARSE: bool = $is_coarse;
            fn parts(self) -> Channels {
                vec![[self.luma().into(), $white]]
            }
        }
    )+};
}

parts!(rgb: Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888);
parts!(gray: Gray2 3. true Gray4 15. true Gray8 255. false);

impl Parts for BinaryColor {
    const IS_COARSE: bool = true;
    fn parts(self) -> Channels {
        vec![[f64::from(u8::from(self.is_on())), 1.]]
    }
}

/// A shader with the same color everywhere, or the same color and opacity.
#[derive(Clone, Copy)]
struct Even<S>(S);

impl<S: Output> Shader for Even<S> {
    type Color = S;
    type Varyings = ();

    const READS_DEPTH: bool = false;

    fn varyings(&self, _: &Primitive<'_>) -> [(); 3] {
        [(); 3]
    }

    fn shade(&self, _: &Fragment, (): ()) -> Option<S> {
        Some(self.0)
    }
}

/// A projection in which [`SQUARE`] fills the frame.
fn from_above() -> Mvp<Parallel> {
    let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2));
    projection.unwrap() * Camera::top(Vec3::ZERO, fx!(1))
}

/// Fills the frame with a color, calls `draw` to draw over all of it in four bands, and returns the pixels.
fn pixels<C, O>(below: C, draw: &dyn Fn(&mut Canvas<'_, C, O>)) -> Vec<Channels>
where
    C: Parts,
    O: Storage<C>,
{
    let mut all = Vec::new();
    for first in (0..SIZE).step_by(2) {
        let mut cells = [O::store(below); 2 * SIZE as usize];
        let mut band = Canvas::<C, O>::band(&mut cells, SIZE, SIZE, first).unwrap();
        draw(&mut band);
        for color in band.pixels() {
            all.push(color.parts());
        }
    }
    all
}

/// All modes blend pixels in the same way. `Compact` takes the compiler the least time.
const OPTIONS: DrawOptions<Compact> = DrawOptions::new().with_mode(Compact);

/// Draws a color with an opacity over another color, on a canvas with storage `O`.
fn with_opacity<C: Parts, O: Storage<C>>(above: C, below: C, opacity: u8) -> Vec<Channels> {
    let options = OPTIONS.with_blending(Opacity(opacity));
    pixels::<C, O>(below, &|band| {
        band.draw_with(&options, &SQUARE, &from_above(), &Even(above));
    })
}

/// Two colors, and the pixels that result from every way to blend one color over the other color.
struct Blended {
    above: Channels,
    below: Channels,
    /// Whether the colors are dithered.
    is_coarse: bool,
    /// The largest error of the weight that the crate computes from an opacity in 255ths.
    weight: f64,
    opacity: Vec<Channels>,
    alpha: Vec<Channels>,
    /// The color has an opacity, and so has the draw call.
    both: Vec<Channels>,
    /// The same, with the color in full precision.
    precise: Vec<Channels>,
    /// The color has an opacity, and the draw call has opacity 255.
    alpha_of_all: Vec<Channels>,
    /// The color has an opacity, and is added.
    alpha_of_sum: Vec<Channels>,
    sum: Vec<Channels>,
    product: Vec<Channels>,
    /// The pixels after blending with opacity 0.
    none: Vec<Channels>,
    /// The pixels after blending with opacity 255.
    all: Vec<Channels>,
}

impl Blended {
    /// `second` is the opacity of a draw call whose color has the opacity `opacity`.
    fn new<C: Parts>(above: C, below: C, [opacity, second]: [u8; 2]) -> Self {
        let (options, mvp) = (OPTIONS, from_above());
        let source = Translucent {
            color: above,
            opacity,
        };
        let precise = Translucent {
            color: Precise::from(above),
            opacity,
        };
        let covered = |second: u8| {
            let options = options.with_blending(Opacity(second));
            pixels::<C, Native>(below, &|band| {
                band.draw_with(&options, &SQUARE, &mvp, &Even(source));
            })
        };
        let is_short = matches!(C::Raw::BITS_PER_PIXEL, 15 | 16);
        Self {
            above: above.parts(),
            below: below.parts(),
            is_coarse: C::IS_COARSE,
            // The weight has an error of half of 2^-16. Colors of 15 and 16 bits keep only 32nds of the weight.
            weight: 0.5 / 65_536. + if is_short { 1. / 64. } else { 0. },
            opacity: with_opacity::<C, Native>(above, below, opacity),
            alpha: pixels::<C, Native>(below, &|band| {
                band.draw_with(&options, &SQUARE, &mvp, &Even(source));
            }),
            both: covered(second),
            precise: pixels::<C, Native>(below, &|band| {
                let options = options.with_blending(Opacity(second));
                band.draw_with(&options, &SQUARE, &mvp, &Even(precise));
            }),
            alpha_of_all: covered(255),
            alpha_of_sum: pixels::<C, Native>(below, &|band| {
                band.draw_with(&options.with_blending(Add), &SQUARE, &mvp, &Even(source));
            }),
            sum: pixels::<C, Native>(below, &|band| {
                band.draw_with(&options.with_blending(Add), &SQUARE, &mvp, &Even(above));
            }),
            product: pixels::<C, Native>(below, &|band| {
                let options = options.with_blending(Multiply);
                band.draw_with(&options, &SQUARE, &mvp, &Even(above));
            }),
            none: with_opacity::<C, Native>(above, below, 0),
            all: with_opacity::<C, Native>(above, below, 255),
        }
    }

    /// Compares pixels with a formula of two channels from 0 to 1. `error` maps the difference of the two channels to
    /// the allowed error, both in steps.
    fn compare(
        &self,
        what: &str,
        found: &[Channels],
        formula: &dyn Fn(f64, f64) -> f64,
        error: &dyn Fn(f64) -> f64,
    ) {
        for (part, (above, below)) in self.above.iter().zip(&self.below).enumerate() {
            let white = above[1];
            let exact = formula(above[0] / white, below[0] / white) * white;
            let error = error((above[0] - below[0]).abs());
            let values: Vec<f64> = found.iter().map(|parts| parts[part][0]).collect();
            let context = || format!("{what} of {above:?} and {below:?}: {exact}, not {values:?}");
            if self.is_coarse {
                // Dithering gives the two whole steps around the exact level. The 64 thresholds of dithering begin at
                // 1/128 and are 1/64 apart.
                let mean = values.iter().sum::<f64>() / values.len() as f64;
                assert!((mean - exact).abs() <= error + 1. / 128., "{}", context());
                assert!(
                    values
                        .iter()
                        .all(|value| (value - exact).abs() < 1. + error),
                    "{}",
                    context()
                );
            } else {
                // Rounding to nearest adds half a step.
                assert!(
                    values
                        .iter()
                        .all(|value| (value - exact).abs() <= 0.5 + error),
                    "{}",
                    context()
                );
            }
        }
    }

    /// Checks all blended pixels.
    fn check(&self, opacities: [u8; 2]) {
        let [share, second] = opacities.map(|opacity| f64::from(opacity) / 255.);
        let over_by = |share: f64| move |a, b| over(a, b, share);
        self.compare("opacity", &self.opacity, &over_by(share), &|steps| {
            self.weight * steps
        });
        assert_eq!(self.alpha, self.opacity);
        // Each of the two weights has an error of half of 2^-16 and loses its last bit, and so does their product: less
        // than 4 · 2^-16.
        let product = |steps: f64| (self.weight + 3.5 / 65_536.) * steps;
        let both = over_by(share * second);
        self.compare("two opacities", &self.both, &both, &product);
        // Only plain colors of 15 and 16 bits round the weight to 32nds. A product in full precision drops less than
        // 1/250 step.
        self.compare("two precise opacities", &self.precise, &both, &|steps| {
            4. / 65_536. * steps + 1. / 250.
        });
        assert_eq!(self.alpha_of_all, self.alpha);
        let sum_over = |a, b| over(add(a, b), b, share);
        self.compare("sum by opacity", &self.alpha_of_sum, &sum_over, &|_| {
            255. * 0.5 / 65_536. + 1. / 250.
        });
        self.compare("sum", &self.sum, &add, &|_| 0.);
        // Sums of whole steps are whole steps, so dithering does not change them.
        assert!(self.sum.iter().all(|color| *color == self.sum[0]));
        self.compare("product", &self.product, &multiply, &|_| 16. / 65_536.);
        // Opacities 0 and 255 give exactly the color below and the color above.
        assert!(self.none.iter().all(|color| *color == self.below));
        assert!(self.all.iter().all(|color| *color == self.above));
    }
}

/// Converts bits to a color.
fn color<C: Parts>(bits: u32) -> C {
    C::Raw::from_u32(bits).into()
}

/// Checks every way to blend two colors, given as bits.
fn check<C: Parts>(bits: [u32; 2], opacities: [u8; 2])
where
    BigEndian: Storage<C>,
    LittleEndian: Storage<C>,
{
    let [above, below] = bits.map(color::<C>);
    Blended::new(above, below, opacities).check(opacities);
    // Blending reads colors from bytes, too.
    let stored = [
        pixels::<C, BigEndian>(below, &|_| {}),
        pixels::<C, LittleEndian>(below, &|_| {}),
    ];
    let is_read = |drawn: &Channels| *drawn == below.parts();
    assert!(stored.iter().flatten().all(is_read));
}

/// Storage and blending do not depend on each other, so bytes are blended in one color type of each kind.
fn check_bytes<C: Parts>(bits: [u32; 2], opacity: u8)
where
    BigEndian: Storage<C>,
    LittleEndian: Storage<C>,
{
    let [above, below] = bits.map(color::<C>);
    let expected = with_opacity::<C, Native>(above, below, opacity);
    let bytes = [
        with_opacity::<C, BigEndian>(above, below, opacity),
        with_opacity::<C, LittleEndian>(above, below, opacity),
    ];
    assert!(bytes.iter().all(|drawn| *drawn == expected));
}

#[test]
fn blended_colors_follow_the_formulas() {
    cases(64, |random| {
        let bits = random.random();
        let opacities: [u8; 2] = random.random();
        check::<Rgb555>(bits, opacities);
        check::<Bgr555>(bits, opacities);
        check::<Rgb565>(bits, opacities);
        check::<Bgr565>(bits, opacities);
        check::<Rgb666>(bits, opacities);
        check::<Bgr666>(bits, opacities);
        check::<Rgb888>(bits, opacities);
        check::<Bgr888>(bits, opacities);
        check::<Gray8>(bits, opacities);
        check::<Gray4>(bits, opacities);
        check::<Gray2>(bits, opacities);
        check::<BinaryColor>(bits, opacities);
        check_bytes::<Rgb565>(bits, opacities[0]);
        check_bytes::<BinaryColor>(bits, opacities[0]);
    });
}
