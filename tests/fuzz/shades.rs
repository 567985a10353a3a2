//! The crate's shaders, selected by number.

use arbitrary::{Result, Unstructured};
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888, RgbColor};
use fixel::mesh::{Material, Part};
use fixel::prelude::*;
use fixel::shade::{Gradient, Mipmapped, Output, PartColors, Translucent};
use fixel::texture::{Argb1555, Argb4444, Indexed, Mipmap, Nearest};
use fixel::{DepthView, NormalView};

use super::numbers::{option, scalar, vector};

/// One of the crate's shaders, or the shader with colors that depend on every bit.
#[derive(Clone, Debug)]
pub enum Shade {
    /// `shaders::Bits` with this number of values.
    Bits(u8),
    Crate {
        which: u8,
        light: Option<Shine>,
        color: Rgb888,
        between: [u16; 2],
    },
}

/// The numbers of a light.
#[derive(Clone, Copy, Debug)]
pub struct Shine {
    direction: Vec3,
    ambient: Scalar,
    diffuse: Scalar,
    range: Scalar,
    exponent: u8,
}

/// The number of shaders that [`draw`](Shade::draw) knows.
const FRAGMENTS: u8 = 40;

impl Shade {
    pub fn arbitrary(u: &mut Unstructured<'_>) -> Result<Self> {
        if u.arbitrary()? {
            return Ok(Self::Bits(*u.choose(&[3, 0])?));
        }
        let which = u.int_in_range(0..=FRAGMENTS - 1)?;
        let [r, g, b] = u.arbitrary()?;
        Ok(Self::Crate {
            which,
            color: Rgb888::new(r, g, b),
            between: u.arbitrary()?,
            light: option(u, |u| {
                Ok(Shine {
                    direction: vector(u)?,
                    ambient: scalar(u)?,
                    diffuse: scalar(u)?,
                    range: scalar(u)?,
                    exponent: u.arbitrary()?,
                })
            })?,
        })
    }
}

/// A light of each type.
#[derive(Clone, Copy, Debug)]
pub struct Lights {
    sun: Light,
    lamp: PointLight,
    spot: SpotLight,
    exponent: u8,
}

impl Shine {
    /// A white light from the front.
    pub const DEFAULT: Self = Self {
        direction: vec3!(1, 2, 3),
        ambient: fx!(0.3),
        diffuse: fx!(0.7),
        range: fx!(10),
        exponent: 20,
    };

    /// The lights, if the crate accepts these numbers.
    pub fn lights(self) -> Result<Lights, Error> {
        let Self {
            direction,
            ambient,
            diffuse,
            range,
            exponent,
        } = self;
        let sun = Light::new(direction, ambient, diffuse)?;
        let lamp = PointLight::new(direction, diffuse, range)?;
        let cone = (
            Angle::from_bits(ambient.to_bits().cast_unsigned() << 13),
            deg!(75),
        );
        Ok(Lights {
            sun,
            lamp,
            spot: SpotLight::new(direction, -direction, cone, diffuse, range)?,
            exponent,
        })
    }
}

/// A function that takes a shader of any type.
pub trait Draw {
    fn draw<F: ShaderFor<Rgb565>>(self, shader: &F);
}

/// Makes texels that differ from all of their neighbors.
const fn texels<const W: usize, const H: usize>() -> [[Rgb565; W]; H] {
    let mut texels = [[Rgb565::new(0, 0, 0); W]; H];
    let mut row = 0;
    while row < H {
        let mut column = 0;
        while column < W {
            let mix = (row * 5 + column * 11) as u8;
            texels[row][column] = Rgb565::new(mix, mix >> 1, column as u8 ^ row as u8);
            column += 1;
        }
        row += 1;
    }
    texels
}

static ONE: [[Rgb565; 1]; 1] = texels();
static SMALL: [[Rgb565; 4]; 2] = texels();
static LARGE: [[Rgb565; 64]; 128] = texels();
/// A texture with the largest possible width.
static WIDE: [[Rgb565; 32_768]; 1] = texels();
/// A transparent texel, and three colors.
static HOLED: [[Argb1555; 2]; 2] = [
    [Argb1555::HOLE, Argb1555::new(31, 0, 9)],
    [Argb1555::new(3, 31, 0), Argb1555::new(9, 9, 31)],
];
/// Texels from transparent to opaque.
static CLEAR: [[Argb4444; 2]; 2] = [
    [Argb4444::new(0, 15, 3, 0), Argb4444::new(5, 0, 15, 0)],
    [Argb4444::new(10, 0, 3, 15), Argb4444::new(15, 15, 15, 0)],
];
/// A mask of the same size as `SMALL`.
static MASK: [[Gray8; 4]; 2] = [
    [Gray8::new(0), Gray8::new(255), Gray8::new(9), Gray8::new(0)],
    [
        Gray8::new(99),
        Gray8::new(0),
        Gray8::new(1),
        Gray8::new(254),
    ],
];
static INDICES: Indexed<&[[u8; 4]; 2], Rgb565, 3> = Indexed {
    indices: &[[0, 1, 2, 3], [2, 1, 0, 200]],
    colors: &[
        Rgb565::new(31, 0, 0),
        Rgb565::new(0, 63, 0),
        Rgb565::new(0, 0, 31),
    ],
};

/// Draws with one of the crate's shaders.
pub fn draw(which: u8, lights: Lights, color: Rgb888, between: [u16; 2], then: impl Draw) {
    let Lights {
        sun: light,
        lamp,
        spot,
        exponent,
    } = lights;
    // The shaders need distances. Any distances will do, so they are made from the depths.
    let [least, most] = between.map(|depth| Scalar::from_bits(i32::from(depth) << 4));
    let (near, beyond) = (least.min(most), least.max(most) + Scalar::DELTA);
    let linear = Fog::linear(Rgb565::from(color), near, beyond).unwrap();
    let thick = Fog::exponential(Rgb565::from(color), least.min(fx!(5))).unwrap();
    let [far, near] = between;
    let viewer = Viewer::at(vec3!(0, 0, 3));
    let glossy = spot.shiny(viewer, exponent, fx!(1)).unwrap();
    let shiny = |lamp: Light| lamp.shiny(viewer, exponent, fx!(0.5)).unwrap();
    let faces = [Rgb565::new(31, 0, 0), color.into(), Rgb565::new(0, 0, 31)];
    // The parts can be in any order, and a part's range of faces can be reversed.
    let part = |depth: u16| {
        Part::new(
            (depth & 15).into()..(depth >> 4 & 15).into(),
            Material::new(color),
        )
    };
    let parts = between.map(part);
    let (small, large) = (Textured::new(&SMALL), Textured::new(&LARGE));
    match which {
        0 => then.draw(&Flat::new(Rgb565::from(color))),
        1 => then.draw(&FaceColors::new(&faces)),
        2 => then.draw(&Gouraud::<Rgb565>::new()),
        3 => then.draw(&Flat::<Rgb565>::rgb(color).lit(light)),
        4 => then.draw(&Flat::<Rgb565>::rgb(color).lit_faces(light)),
        5 => then.draw(&small),
        6 => then.draw(&small.clamped()),
        7 => then.draw(&small.bilinear()),
        8 => then.draw(&small.clamped().bilinear()),
        9 => then.draw(&large),
        10 => then.draw(&large.clamped().bilinear()),
        11 => then.draw(&large.lit(light)),
        12 => then.draw(&small.clamped().bilinear().lit(light)),
        13 => then.draw(&small.tinted()),
        14 => then.draw(&large.clamped().tinted()),
        15 => then.draw(&Textured::new(&WIDE)),
        16 => then.draw(&Textured::new(&WIDE).clamped().bilinear()),
        17 => then.draw(&Textured::new(INDICES)),
        18 => then.draw(&Textured::new(&ONE).bilinear()),
        19 => then.draw(&DepthView::<Rgb565>::between(far, near)),
        20 => then.draw(&NormalView::<Rgb565>::new()),
        21 => then.draw(&wide(Gouraud::<Gray8>::new().converted::<Rgb888>())),
        22 => then.draw(&wide(wide_gray(Flat::<Gray4>::rgb(color).lit(light)))),
        23 => then.draw(&wide(wide_gray(large.converted::<BinaryColor>()))),
        24 => then.draw(&Flat::<Rgb565>::rgb(color).lit(lamp)),
        25 => then.draw(&small.lit((light, spot.colored(color)).two_sided(viewer))),
        26 => then.draw(&Gouraud::<Rgb565>::new().lit_faces((shiny(light), [lamp; 2]))),
        27 => then.draw(&Flat::<Rgb565>::rgb(color).lit(glossy)),
        28 => then.draw(&small.lit(light).in_fog(linear)),
        29 => then.draw(&Gouraud::new().in_fog(thick)),
        30 => then.draw(&small.cut_out(SMALL[1][1]).lit(light)),
        31 => then.draw(&large.bilinear().cut_out(LARGE[3][5])),
        32 => then.draw(&levels(least.min(most), beyond)),
        33 => then.draw(&levels(least.min(most), beyond).clamped().bilinear()),
        34 => then.draw(&levels(least.min(most), beyond).trilinear().lit(light)),
        35 => then.draw(&heights(least.min(most), beyond, color).lit(light)),
        36 => then.draw(&Textured::new(&HOLED)),
        37 => then.draw(&Textured::new(&CLEAR).bilinear().map(thinned)),
        38 => then.draw(&small.masked(&MASK).unwrap().map(thinned)),
        _ => then.draw(&PartColors::rgb(&parts).lit_faces(light)),
    }
}

/// The texels of all levels of a mipmap.
const fn all_levels<const LENGTH: usize>() -> [Rgb565; LENGTH] {
    let texels: [[Rgb565; LENGTH]; 1] = texels();
    texels[0]
}

static LEVELS: [Rgb565; Mipmap::<Rgb565>::len(32, 8)] = all_levels();

/// A surface with mipmaps, made for a projection that can differ from the draw call's projection.
fn levels(
    near: Scalar,
    far: Scalar,
) -> Textured<Mipmap<'static, Rgb565>, false, Nearest, Mipmapped> {
    let near = near.max(Scalar::DELTA);
    let far = far.max(near + Scalar::DELTA);
    let projection = Projection::perspective(deg!(75), (3, 2), near, far).unwrap();
    let levels = Mipmap::new(&LEVELS, 32, 8).unwrap();
    Textured::new(levels)
        .mipmapped(&projection, (30, 20))
        .unwrap()
}

/// A gradient of colors between two heights.
fn heights(low: Scalar, high: Scalar, color: Rgb888) -> Gradient<Rgb565> {
    Gradient::new((low, color), (high, Rgb888::new(9, 200, 50))).unwrap()
}

/// A color that depends on the opacity. Transparent pixels are discarded.
fn thinned(_: &Fragment, Translucent { color, opacity }: Translucent<Rgb565>) -> Option<Rgb565> {
    (opacity > 0).then(|| Rgb565::new(color.r() & opacity, color.g(), opacity >> 3))
}

/// Converts the colors of a shader to the canvas's color type.
fn wide(shader: impl ShaderFor<Rgb888>) -> impl ShaderFor<Rgb565> {
    shader.map(|at, color| Some(Rgb565::from(color.finish(at.point))))
}

/// Converts the few grays of a shader to colors of 24 bits.
fn wide_gray<C: PixelFormat>(shader: impl ShaderFor<C>) -> impl ShaderFor<Rgb888> {
    shader.converted()
}
