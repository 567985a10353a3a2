//! Blended colors on canvases of every color type and storage, compared with the formulas in f64.

use std::fmt::Debug;

use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, RawData};
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor,
    Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
};
use fixel::mode::Compact;
use fixel::prelude::*;
use fixel::shade::Translucent;
use fixel::target::{Add, Alpha, Blending, Multiply, Native, Opacity, Storage};
use fixel::view::Parallel;
use rand::Rng;

use crate::common::random::cases;
use crate::reference::blending::{add, multiply, over};

static SQUARE: Mesh = shape!(plane(1, 1));
/// The side of the dither matrix, which coarse colors use.
const SIZE: u32 = 8;

/// A color as a list of channels: the value of each, and its value in white.
trait Parts: Levels + Debug + From<Self::Raw> {
    /// Whether the color is dithered.
    const IS_COARSE: bool = false;
    fn parts(self) -> Vec<[f64; 2]>;
}

macro_rules! parts {
    (rgb: $($color:ident)+) => {$(
        impl Parts for $color {
            fn parts(self) -> Vec<[f64; 2]> {
                [[self.r(), Self::MAX_R], [self.g(), Self::MAX_G], [self.b(), Self::MAX_B]]
                    .map(|part| part.map(f64::from))
                    .to_vec()
            }
        }
    )+};
    (gray: $($color:ident $white:literal $is_coarse:literal)+) => {$(
        impl Parts for $color {
            const IS_COARSE: bool = $is_coarse;
            fn parts(self) -> Vec<[f64; 2]> {
                vec![[self.luma().into(), $white]]
            }
        }
    )+};
}

parts!(rgb: Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888);
parts!(gray: Gray2 3. true Gray4 15. true Gray8 255. false);

impl Parts for BinaryColor {
    const IS_COARSE: bool = true;
    fn parts(self) -> Vec<[f64; 2]> {
        vec![[f64::from(u8::from(self.is_on())), 1.]]
    }
}

/// A projection in which [`SQUARE`] fills the frame.
fn from_above() -> Mvp<Parallel> {
    let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2));
    projection.unwrap() * Camera::top(Vec3::ZERO, fx!(1))
}

/// Fills the frame with `below`, blends `above` over all of it, and returns the pixels. Draws in four bands.
fn pixels<C, O, B>(below: C, above: B::Source, blending: B) -> Vec<C>
where
    C: PixelColor,
    O: Storage<C>,
    B: Blending<C, Source: PartialEq>,
    for<'a> Canvas<'a, C, O>: Banded<'a, C, O>,
{
    let mvp = from_above();
    let mut all = Vec::new();
    for first in (0..SIZE).step_by(2) {
        let mut cells = [O::store(below); 2 * SIZE as usize];
        let mut band = <Canvas<'_, C, O> as Banded<C, O>>::band(&mut cells, first);
        // A pixel is blended alike in all modes; this one takes the compiler the least time.
        let options = DrawOptions::new()
            .with_mode(Compact)
            .with_blending(blending);
        // A surface of a single color, or of a single color and opacity.
        let surface = Flat::new(below).map(|_, _| Some(above));
        band.draw_with(&options, &SQUARE, &mvp, &surface);
        all.extend(band.pixels());
    }
    all
}

/// The constructors of a band, which differ by storage.
trait Banded<'a, C, O: Storage<C>> {
    fn band(cells: &'a mut [O::Cell], first: u32) -> Self;
}

impl<'a, C: PixelColor> Banded<'a, C, Native> for Canvas<'a, C> {
    fn band(cells: &'a mut [C], first: u32) -> Self {
        Canvas::band(cells, SIZE, SIZE, first).unwrap()
    }
}

impl<'a, C> Banded<'a, C, BigEndian> for Canvas<'a, C, BigEndian>
where
    BigEndian: Storage<C>,
{
    fn band(cells: &'a mut [<BigEndian as Storage<C>>::Cell], first: u32) -> Self {
        Canvas::big_endian_band(cells, SIZE, SIZE, first).unwrap()
    }
}

impl<'a, C> Banded<'a, C, LittleEndian> for Canvas<'a, C, LittleEndian>
where
    LittleEndian: Storage<C>,
{
    fn band(cells: &'a mut [<LittleEndian as Storage<C>>::Cell], first: u32) -> Self {
        Canvas::little_endian_band(cells, SIZE, SIZE, first).unwrap()
    }
}

/// The channels of two colors, and of the pixels that result from blending one over the other.
struct Channels {
    above: Vec<[f64; 2]>,
    below: Vec<[f64; 2]>,
    found: Vec<Vec<[f64; 2]>>,
    is_coarse: bool,
}

impl Channels {
    fn new<C: Parts>([above, below]: [C; 2], found: &[C]) -> Self {
        Self {
            above: above.parts(),
            below: below.parts(),
            found: found.iter().map(|color| color.parts()).collect(),
            is_coarse: C::IS_COARSE,
        }
    }

    /// Compares all pixels with a formula of two channels from 0 to 1. `error` gives the allowed error in steps, for
    /// two channels that differ by a number of steps.
    fn compare(&self, what: &str, formula: &dyn Fn(f64, f64) -> f64, error: &dyn Fn(f64) -> f64) {
        for (part, (above, below)) in self.above.iter().zip(&self.below).enumerate() {
            let white = above[1];
            let exact = formula(above[0] / white, below[0] / white) * white;
            let error = error((above[0] - below[0]).abs());
            let values: Vec<f64> = self.found.iter().map(|parts| parts[part][0]).collect();
            let context = || format!("{what} of {above:?} and {below:?}: {exact}, not {values:?}");
            if self.is_coarse {
                // Dithering gives the whole steps around the exact level. Its 64 thresholds are 1/64 apart, from 1/128.
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
}

/// Checks every way to blend two colors on a canvas with storage `O`.
fn blended<C: Parts, O: Storage<C>>([above, below]: [C; 2], opacity: u8)
where
    for<'a> Canvas<'a, C, O>: Banded<'a, C, O>,
{
    let share = f64::from(opacity) / 255.;
    // An opacity in 255ths becomes 256ths, with an error of at most 1/512. Colors of 15 and 16 bits keep only 32nds.
    let is_short = C::Raw::BITS_PER_PIXEL == 16 || C::Raw::BITS_PER_PIXEL == 15;
    let weight = 0.5 / 256. + if is_short { 1. / 64. } else { 0. };
    let both = [above, below];
    let found = pixels::<C, O, _>(below, above, Opacity(opacity));
    let channels = Channels::new(both, &found);
    channels.compare("opacity", &|a, b| over(a, b, share), &|steps| {
        weight * steps
    });
    let source = Translucent {
        color: above,
        opacity,
    };
    assert_eq!(pixels::<C, O, _>(below, source, Alpha), found);
    let found = pixels::<C, O, _>(below, above, Add);
    Channels::new(both, &found).compare("sum", &add, &|_| 0.);
    // Sums of whole steps are whole steps, so dithering changes nothing.
    assert!(found.iter().all(|color| *color == found[0]));
    let found = pixels::<C, O, _>(below, above, Multiply);
    Channels::new(both, &found).compare("product", &multiply, &|_| 16. / 65_536.);

    // Opacities 0 and 255 are exact.
    assert!(
        pixels::<C, O, _>(below, above, Opacity(0))
            .iter()
            .all(|color| *color == below)
    );
    assert!(
        pixels::<C, O, _>(below, above, Opacity(255))
            .iter()
            .all(|color| *color == above)
    );
}

fn every_storage<C: Parts>(bits: [u32; 2], opacity: u8)
where
    BigEndian: Storage<C>,
    LittleEndian: Storage<C>,
{
    let colors = bits.map(|bits| C::from(C::Raw::from_u32(bits)));
    blended::<C, Native>(colors, opacity);
    blended::<C, BigEndian>(colors, opacity);
    blended::<C, LittleEndian>(colors, opacity);
}

#[test]
fn blended_colors_follow_the_formulas() {
    cases(64, |random| {
        let bits = random.random();
        let opacity = random.random();
        every_storage::<Rgb555>(bits, opacity);
        every_storage::<Bgr555>(bits, opacity);
        every_storage::<Rgb565>(bits, opacity);
        every_storage::<Bgr565>(bits, opacity);
        every_storage::<Rgb666>(bits, opacity);
        every_storage::<Bgr666>(bits, opacity);
        every_storage::<Rgb888>(bits, opacity);
        every_storage::<Bgr888>(bits, opacity);
        every_storage::<Gray8>(bits, opacity);
        every_storage::<Gray4>(bits, opacity);
        every_storage::<Gray2>(bits, opacity);
        every_storage::<BinaryColor>(bits, opacity);
    });
}
