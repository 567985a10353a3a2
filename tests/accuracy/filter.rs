//! Bilinear filtering: the crate's colors between the centers of texels, compared with the f64 model.

use std::array::from_fn;
use std::fmt::Debug;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::raw::RawData;
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Gray8, GrayColor, PixelColor, Rgb555, Rgb565, Rgb666, Rgb888,
    RgbColor,
};
use fixel::Window;
use fixel::prelude::*;
use fixel::shade::{ColorOf, Lanes, Output, Varyings};
use fixel::texture::{Blend, Indexed};
use rand::Rng;
use support::random::{Random, cases};
use support::reference::texture::{Blended, Wrap, bilinear};

/// A color with access to its channels.
trait Parts: Blend + PixelColor + Debug {
    /// The number of units in the distance from one texel's center to the next.
    const UNITS: f64;

    fn of(raw: u32) -> Self;

    /// The channels in steps.
    fn parts(self) -> [f64; 3];
}

macro_rules! parts {
    ($($color:ident $units:literal |$c:ident| $parts:expr;)+) => {$(
        impl Parts for $color {
            const UNITS: f64 = $units;

            fn of(raw: u32) -> Self {
                Self::from(<$color as PixelColor>::Raw::from_u32(raw))
            }

            fn parts(self) -> [f64; 3] {
                let $c = self;
                $parts.map(f64::from)
            }
        }
    )+};
}
parts! {
    Rgb555 32. |c| [c.r(), c.g(), c.b()];
    Bgr555 32. |c| [c.r(), c.g(), c.b()];
    Rgb565 32. |c| [c.r(), c.g(), c.b()];
    Bgr565 32. |c| [c.r(), c.g(), c.b()];
    Rgb666 256. |c| [c.r(), c.g(), c.b()];
    Bgr666 256. |c| [c.r(), c.g(), c.b()];
    Rgb888 256. |c| [c.r(), c.g(), c.b()];
    Bgr888 256. |c| [c.r(), c.g(), c.b()];
    Gray8 256. |c| [c.luma(); 3];
}

/// The bound that the documentation promises for a channel, in steps.
///
/// The position is rounded to the nearest of `UNITS` units between two centers. So its error is at most half a unit
/// along each axis, and it stays between the same centers. Between these centers, the color changes along either axis
/// by at most the difference of the surrounding texels, per texel. So the errors along both axes together change the
/// color by at most this difference / `UNITS`. Rounding the two rows adds at most half a step, and the mean of the rows
/// keeps this error. Rounding the mean adds another half step.
fn allowed<C: Parts>(model: &Blended) -> f64 {
    1. + (model.most - model.least) / C::UNITS
}

/// The texels of each channel, row by row.
type Channels = [Vec<Vec<f64>>; 3];

fn channels<C: Parts>(texels: &[C], width: usize) -> Channels {
    let mut channels = Channels::default();
    for row in texels.chunks(width) {
        for (k, channel) in channels.iter_mut().enumerate() {
            let mut values = Vec::new();
            for texel in row {
                values.push(texel.parts()[k]);
            }
            channel.push(values);
        }
    }
    channels
}

/// The interpolated numbers of a shader.
type Numbers<F> = <<<F as Shader>::Varyings as Varyings>::Lanes as Lanes>::Of<i32>;

/// The color that a shader returns for these interpolated numbers.
fn shade<F: Shader>(shader: &F, numbers: Numbers<F>) -> ColorOf<F> {
    let sample = Fragment {
        point: Point::zero(),
        depth: 0,
    };
    let varyings = F::Varyings::join(numbers, Default::default());
    let output = shader.shade(&sample, varyings).unwrap();
    output.finish(sample.point)
}

/// Compares both addressing modes of a texture with the model at some positions.
fn compare<C: Parts, const W: usize, const H: usize>(texels: &[[C; W]; H], places: &[[i32; 2]]) {
    let skin = Textured::new(texels).bilinear();
    let channels = channels(texels.as_flattened(), W);
    for &place in places {
        let repeated = (Wrap::Repeat, shade(&skin, place));
        let clamped = (Wrap::Clamp, shade(&skin.clamped(), place));
        for (wrap, color) in [repeated, clamped] {
            compare_at(&channels, wrap, place, color.parts(), allowed::<C>);
        }
    }
}

/// Compares the channels of a color at one position with the model.
fn compare_at(
    channels: &Channels,
    wrap: Wrap,
    place: [i32; 2],
    color: [f64; 3],
    allowed: fn(&Blended) -> f64,
) {
    let at = place.map(|bits| f64::from(bits) / 65536.);
    for (k, (part, channel)) in color.into_iter().zip(channels).enumerate() {
        let model = bilinear(channel, wrap, at);
        let error = (part - model.value).abs();
        assert!(
            error <= allowed(&model),
            "{wrap:?} channel {k} at {at:?}: {part} is not {model:?}"
        );
    }
}

/// The raw value of a random texel, of the darkest texel, or of the brightest texel.
fn raw(random: &mut Random) -> u32 {
    match random.random_range(0..3) {
        0 => random.random(),
        1 => 0,
        _ => !0,
    }
}

fn texels<C: Parts, const W: usize, const H: usize>(random: &mut Random) -> [[C; W]; H] {
    let mut texels = [[C::of(0); W]; H];
    for texel in texels.as_flattened_mut() {
        *texel = C::of(raw(random));
    }
    texels
}

/// A random position: within the texture or near its edges, anywhere, or at the very end of the format.
fn place(random: &mut Random) -> [i32; 2] {
    let ends = i32::MAX - 100_000;
    from_fn(|_| match random.random_range(0..8) {
        0..4 => random.random_range(-200_000..1_200_000),
        4..6 => random.random(),
        6 => random.random_range(ends..=i32::MAX),
        _ => random.random_range(i32::MIN..=-ends),
    })
}

fn places(random: &mut Random) -> [[i32; 2]; 32] {
    from_fn(|_| place(random))
}

/// Checks a large texture, a narrow texture, a texture of two texels, and a single texel, which is its own neighbor.
fn compare_any<C: Parts>(random: &mut Random) {
    let places = places(random);
    compare(&texels::<C, 16, 8>(random), &places);
    compare(&texels::<C, 1, 4>(random), &places);
    compare(&texels::<C, 2, 1>(random), &places);
    compare(&texels::<C, 1, 1>(random), &places);
}

/// Defines a test for each color type.
macro_rules! against_the_model {
    ($($name:ident $color:ident)+) => {$(
        #[test]
        fn $name() {
            cases(256, compare_any::<$color>);
        }
    )+};
}
against_the_model! {
    rgb555 Rgb555
    bgr555 Bgr555
    rgb565 Rgb565
    bgr565 Bgr565
    rgb666 Rgb666
    bgr666 Bgr666
    rgb888 Rgb888
    bgr888 Bgr888
    gray8 Gray8
}

fn exact_at_centers<C: Parts>(texels: &[[C; 4]; 2]) {
    let skin = Textured::new(texels).bilinear();
    for v in -5..7 {
        for u in -9..13 {
            let center = [u, v].map(|at| (at << 16) + (1 << 15));
            let texel = |wrap: Wrap| texels[wrap.index(v.into(), 2)][wrap.index(u.into(), 4)];
            assert_eq!(shade(&skin, center), texel(Wrap::Repeat), "({u}, {v})");
            let clamped = shade(&skin.clamped(), center);
            assert_eq!(clamped, texel(Wrap::Clamp), "({u}, {v})");
        }
    }
}

#[test]
fn centers_are_the_texels() {
    cases(256, |random| {
        exact_at_centers::<Rgb565>(&texels(random));
        exact_at_centers::<Rgb666>(&texels(random));
        exact_at_centers::<Rgb888>(&texels(random));
        exact_at_centers::<Gray8>(&texels(random));
    });
}

/// A color is the same from every storage of texels, and under light or vertex colors that leave it unchanged.
#[test]
fn indexed_lit_and_tinted_textures_are_filtered_alike() {
    cases(256, |random| {
        let indices: [u8; 8] = random.random();
        let [colors]: [[Rgb565; 256]; 1] = texels(random);
        let place = place(random);
        let mut list = indices.iter().map(|&index| colors[usize::from(index)]);
        let rows: [[Rgb565; 4]; 2] = from_fn(|_| from_fn(|_| list.next().unwrap()));
        let texture = Texture::from_rows(&rows);
        let (indices, _) = indices.as_chunks::<4>();
        let indexed = Indexed {
            indices: Texture::from_rows::<4, 2>(indices.try_into().unwrap()),
            colors: &colors,
        };
        let plain = Textured::new(&rows).bilinear();
        let color = shade(&plain, place);
        let edge = shade(&plain.clamped(), place);
        let [u, v] = place;
        assert_eq!(shade(&Textured::new(texture).bilinear(), place), color);
        let skin = Textured::new(indexed);
        assert_eq!(shade(&skin.bilinear(), place), color);
        assert_eq!(shade(&skin.clamped().bilinear(), place), edge);
        assert_eq!(shade(&skin.bilinear().clamped(), place), edge);
        let sun = Light::new(Vec3::Y, fx!(0), fx!(1)).unwrap();
        assert_eq!(shade(&skin.bilinear().lit(sun), [u, v, 1 << 16]), color);
        let white = [u, v, 1 << 16, 1 << 16, 1 << 16];
        assert_eq!(shade(&skin.bilinear().tinted(), white), color);
    });
}

/// The side of the picture in the following tests, in pixels, and the side of its texture, in texels.
const SIDE: u32 = RATIO * 4;
const TEXELS: usize = 4;
/// Pixels per texel.
const RATIO: u32 = 16;

/// Draws a square that fills the picture.
fn picture<F: ShaderFor<Rgb888>>(shader: &F) -> Vec<[f64; 3]> {
    static SQUARE: Mesh = shape!(plane(1, 1));
    let window = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2));
    let mvp = window.unwrap() * Camera::top(Vec3::ZERO, fx!(1));
    let mut pixels = vec![Rgb888::BLACK; (SIDE * SIDE) as usize];
    let mut canvas = Canvas::new(&mut pixels, SIDE, SIDE).unwrap();
    canvas.draw(&SQUARE, &mvp, shader);
    pixels.into_iter().map(Parts::parts).collect()
}

/// The largest difference between two neighboring pixels of a row or a column.
fn steepest(picture: &[[f64; 3]]) -> f64 {
    let differ =
        |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|k| (a[k] - b[k]).abs()).fold(0., f64::max);
    let rows = picture.chunks(SIDE as usize);
    let across = rows.flat_map(|row| row.windows(2).map(|pair| differ(&pair[0], &pair[1])));
    let down = picture.iter().zip(&picture[SIDE as usize..]);
    let down = down.map(|(a, b)| differ(a, b));
    across.chain(down).fold(0., f64::max)
}

#[test]
fn a_magnified_texture_is_smooth() {
    cases(32, |random| {
        let texels: [[Rgb888; TEXELS]; TEXELS] = texels(random);
        let channels = channels(texels.as_flattened(), TEXELS);
        let scale = 1. / f64::from(RATIO);
        let skin = Textured::new(&texels).clamped();
        let (nearest, smooth) = (picture(&skin), picture(&skin.bilinear()));
        for (i, colors) in smooth.iter().enumerate() {
            let i = u32::try_from(i).unwrap();
            let at = [i % SIDE, i / SIDE].map(|at| (f64::from(at) + 0.5) * scale);
            for (k, part) in colors.iter().enumerate() {
                let model = bilinear(&channels[k], Wrap::Clamp, at);
                // The interpolated u and v are within 0.001 texel.
                let allowed = allowed::<Rgb888>(&model) + 0.002 * (model.most - model.least);
                assert!(
                    (part - model.value).abs() <= allowed,
                    "{at:?}: {part} is not {model:?}"
                );
            }
        }
        // The difference between neighboring pixels is a fraction of the difference between neighboring texels, plus
        // the errors of both pixels. A position has an error of 0.001 texel and half of 1/256 texel along each axis. A
        // color has an error of one step.
        let most = steepest(&nearest);
        let allowed = most * (scale + 4. * (0.001 + 1. / 512.)) + 2.;
        assert!(steepest(&smooth) <= allowed, "{texels:?}");
    });
}

/// Without the filter, each texel shows as a square.
#[test]
fn the_nearest_texel_is_not_smooth() {
    let (black, white) = (Rgb888::BLACK, Rgb888::WHITE);
    let texels: [[Rgb888; TEXELS]; TEXELS] =
        from_fn(|v| from_fn(|u| if (u + v) % 2 == 0 { black } else { white }));
    let skin = Textured::new(&texels).clamped();
    assert!(steepest(&picture(&skin)) >= 255.);
    // The color changes by 255/16 per pixel. Positions are whole 256ths of a texel, so each pixel has an error of less
    // than a step.
    assert!(steepest(&picture(&skin.bilinear())) <= 17.);
}
