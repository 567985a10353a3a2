//! A picture for each feature of the crate: each kind of thing, surface, light, adapter, view and canvas.
//!
//! Colors have 24 bits where possible, so that a changed rounding constant changes the picture.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::raw::ToBytes;
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray4, Gray8, PixelColor, Rgb565, Rgb888, RgbColor,
};
use embedded_graphics::{Drawable, geometry::Point, text::Text};
use fixel::canvas::{
    Add, Biased, Blending, Contrast, DepthBuffer, DepthTest, ErrorDiffusion, FloatDepth, Multiply,
    NoTest, Opacity, TestAndWrite, WideFloatDepth,
};
use fixel::mesh::{Keyframes, Material, Part};
use fixel::mode::Newton;
use fixel::prelude::*;
use fixel::shade::{DepthView, Gradient, NormalView, PartColors, Viewer};
use fixel::texture::{Argb4444, Indexed, Mipmap, Raw};
use fixel::{Thing, Window};

use super::kept;
use crate::List;
use support::erased::{Erased, Padded};

const WIDTH: u32 = 80;
const HEIGHT: u32 = 60;
const PIXELS: usize = (WIDTH * HEIGHT) as usize;

type Screen<'c, C> = Canvas<'c, C, Native, LinearDepth>;
type Picture<'c> = Screen<'c, Rgb888>;
type Drawn = Result<(), Error>;

static RING: Mesh = shape!(torus(fx!(0.45), 24, 12));
static BALL: Mesh = shape!(sphere(16, 12));
static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
static SMALL_CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)), quantized_8);
static DRUM: Mesh = shape!(cylinder(5));
static SHEET: Mesh = shape!(plane(2, 2));
static EDGES_OF_CUBE: Outline = outline!(CUBE, deg!(30));
static EDGES_OF_BALL: Outline = outline!(BALL, deg!(170));

const ORANGE: Rgb888 = Rgb888::new(251, 149, 53);
const SKIN: [[Rgb888; 8]; 8] = {
    let mut texels = [[Rgb888::new(203, 180, 151); 8]; 8];
    let mut at = 0;
    while at < 64 {
        if at * 7 % 5 < 2 {
            texels[at / 8][at % 8] = Rgb888::new(31, 4 * at as u8, 97);
        }
        at += 1;
    }
    texels
};

const OPTIONS: DrawOptions = DrawOptions::new();
const PLAIN: Flat<Rgb888> = Flat::new(ORANGE);
const SKINNED: Textured<&[[Rgb888; 8]; 8]> = Textured::new(&SKIN);

fn view() -> Result<Mvp, Error> {
    let projection = Projection::perspective(deg!(43), (WIDTH, HEIGHT), fx!(0.1), fx!(100))?;
    let camera = Camera::look_at(vec3!(0.3, 2, 3.2), Vec3::ZERO, Vec3::Y)?;
    Ok(projection * camera * Transform::rotate_z(deg!(25)))
}

fn sun() -> Result<Light, Error> {
    Light::new(vec3!(-1, 3, 2), fx!(0.23), fx!(0.71))
}

/// Draws with a shader, on a background that is neither black nor white.
fn with<C: PixelColor>(
    canvas: &mut Screen<'_, C>,
    thing: impl Thing<C>,
    shader: &impl ShaderFor<C>,
) -> Drawn {
    by(canvas, &OPTIONS, thing, shader)
}

/// Draws like [`with`], but with these options.
fn by<C: PixelColor>(
    canvas: &mut Screen<'_, C>,
    options: &DrawOptions<Newton, impl DepthTest, impl Blending<C>>,
    thing: impl Thing<C>,
    shader: &impl ShaderFor<C>,
) -> Drawn {
    canvas.draw_with(options, thing, &view()?, shader);
    Ok(())
}

/// Draws like [`with`], but through the rasterizer that all shaders share: here, only the shader matters.
fn surface(canvas: &mut Picture<'_>, mesh: &Mesh, shader: impl ShaderFor<Rgb888>) -> Drawn {
    with(canvas, mesh, &Padded::new(shader).erased())
}

/// Draws two sheets so close to each other that the depth format decides where each sheet is in front.
fn in_format<D: DepthBuffer>(canvas: &mut Picture<'_>) -> Drawn {
    let (mut pixels, mut depths) = (vec![Rgb888::BLACK; PIXELS], vec![0; PIXELS]);
    let format = Canvas::new(&mut pixels, WIDTH, HEIGHT)?.with_depth_format::<D>(&mut depths);
    let mut format = format?;
    format.draw(&SHEET, &view()?, &SKINNED);
    let lean = Transform::rotate_z(deg!(0.01)) * Transform::rotate_x(deg!(0.02));
    format.draw(&SHEET, &(view()? * lean), &PLAIN);
    format.show(canvas)?;
    Ok(())
}

/// Draws a sheet with mipmaps far away.
fn from_afar(canvas: &mut Picture<'_>, is_trilinear: bool) -> Drawn {
    let mut texels = [Rgb888::BLACK; Mipmap::<Rgb888>::len(8, 8)];
    texels[..64].copy_from_slice(SKIN.as_flattened());
    let skin = Textured::new(Mipmap::build(&mut texels, 8, 8)?);
    let projection = Projection::perspective(deg!(43), (WIDTH, HEIGHT), fx!(0.1), fx!(100))?;
    let far = projection * Transform::translate(vec3!(0, -1, -9)) * Transform::scale(fx!(7));
    let skin = skin.mipmapped(&projection, canvas.frame_size())?;
    if is_trilinear {
        canvas.draw(&SHEET, &far, &Padded::new(skin.trilinear()).erased());
    } else {
        canvas.draw(&SHEET, &far, &Padded::new(skin).erased());
    }
    Ok(())
}

/// As many colors as a mesh has corners or faces.
fn colors(count: usize) -> Vec<Rgb888> {
    (0..count).map(|at| SKIN[at % 8][at / 8 % 8]).collect()
}

/// Draws in a coarser color format, and converts the picture back to show it.
fn coarse<C>(canvas: &mut Picture<'_>, draw: impl Fn(&mut Screen<'_, C>) -> Drawn) -> Drawn
where
    C: PixelColor + Default + Into<Rgb888>,
{
    let (mut pixels, mut depths) = ([C::default(); PIXELS], [0; PIXELS]);
    let mut panel = Canvas::new(&mut pixels, WIDTH, HEIGHT)?.with_depth(&mut depths)?;
    draw(&mut panel)?;
    panel.show_with(canvas, |_, color| color.into())?;
    Ok(())
}

/// The name of a feature, the checksum of its picture, and the function that draws the picture.
type Word = (&'static str, u32, fn(&mut Picture<'_>) -> Drawn);

const WORDS: &[Word] = &[
    ("Flat", 0x93d3_ff40, |c| with(c, &RING, &PLAIN)),
    ("FaceColors", 0x99b5_d3d7, |c| {
        surface(c, &RING, FaceColors::new(&colors(RING.faces().len())))
    }),
    ("PartColors", 0x6c52_e659, |c| {
        let parts = [(0..200, ORANGE), (200..576, Rgb888::BLUE)];
        let parts = parts.map(|(faces, color)| Part::new(faces, Material::new(color)));
        surface(c, &RING, PartColors::rgb(&parts))
    }),
    ("Gouraud", 0x5ac0_0bb5, |c| {
        let colors = colors(CUBE.positions().len());
        let gouraud = Gouraud::<Rgb888>::new();
        with(c, &CUBE.with_colors(&colors, None)?, &Erased::new(&gouraud))
    }),
    ("tinted", 0xd282_30a8, |c| {
        let colors = colors(BALL.positions().len());
        surface(c, &BALL.with_colors(&colors, None)?, SKINNED.tinted())
    }),
    ("Gradient", 0x41d4_8339, |c| {
        let (low, high) = ((fx!(-0.6), ORANGE), (fx!(0.6), Rgb888::BLUE));
        with(c, &BALL, &Erased::new(&Gradient::<Rgb888>::new(low, high)?))
    }),
    ("DepthView", 0xee16_379b, |c| {
        surface(c, &RING, DepthView::between(1200, 3300))
    }),
    ("NormalView", 0x3857_812c, |c| {
        with(c, &RING, &Erased::new(&NormalView::<Rgb888>::new()))
    }),
    ("Textured", 0x3a8f_8d50, |c| with(c, &CUBE, &SKINNED)),
    ("clamped", 0x4e48_401a, |c| {
        surface(c, &CUBE, SKINNED.clamped().bilinear())
    }),
    ("bilinear", 0x9e52_ee32, |c| {
        surface(c, &CUBE, SKINNED.bilinear())
    }),
    ("cut_out", 0xfb13_c68c, |c| {
        surface(c, &CUBE, SKINNED.cut_out(SKIN[0][1]))
    }),
    ("Indexed", 0xe7f4_8d0f, |c| {
        let indices: [[u8; 8]; 8] =
            std::array::from_fn(|row| std::array::from_fn(|column| ((row ^ column) % 3) as u8));
        let colors = [ORANGE, Rgb888::BLUE, Rgb888::new(9, 200, 77)];
        surface(
            c,
            &CUBE,
            Textured::new(Indexed {
                indices: &indices,
                colors: &colors,
            }),
        )
    }),
    ("Raw", 0x3a8f_8d50, |c| {
        let bytes: Vec<_> = SKIN
            .as_flattened()
            .iter()
            .flat_map(|color| color.to_be_bytes())
            .collect();
        surface(c, &CUBE, Textured::new(Raw::<Rgb888>::new(&bytes, 8, 8)?))
    }),
    ("Argb4444", 0x18b9_a80c, |c| {
        let texels = [[Argb4444::new(9, 15, 4, 2), Argb4444::new(3, 1, 14, 6)]];
        coarse::<Rgb565>(c, |c| with(c, &CUBE, &Textured::new(&texels)))
    }),
    ("mipmapped", 0xb960_1a0b, |c| from_afar(c, false)),
    ("trilinear", 0xe5a5_7553, |c| from_afar(c, true)),
    ("Light", 0x9efc_2e07, |c| {
        surface(c, &RING, PLAIN.lit(sun()?))
    }),
    ("lit_faces", 0x54c1_b743, |c| {
        surface(c, &BALL, PLAIN.lit_faces(sun()?))
    }),
    ("lit texture", 0x3818_bf37, |c| {
        with(c, &BALL, &SKINNED.lit(sun()?))
    }),
    ("PointLight", 0x7800_d04b, |c| {
        surface(
            c,
            &RING,
            PLAIN.lit(PointLight::new(vec3!(1, 1, 1), fx!(1), fx!(4))?),
        )
    }),
    ("SpotLight", 0xff46_66ff, |c| {
        let cone = (deg!(15), deg!(30));
        let lamp = SpotLight::new(vec3!(0, 3, 0), vec3!(0.1, -1, 0), cone, fx!(1), fx!(9))?;
        surface(c, &RING, PLAIN.lit(lamp))
    }),
    ("shiny", 0x4052_59b6, |c| {
        let light = sun()?.shiny(Viewer::of(&view()?), 20, fx!(0.8))?;
        surface(c, &BALL, PLAIN.lit(light))
    }),
    ("colored", 0x3a74_95eb, |c| {
        let lights = (
            sun()?.colored(Rgb888::new(200, 99, 7)),
            PointLight::new(vec3!(2, 0, 2), fx!(1), fx!(4))?,
        );
        surface(c, &RING, SKINNED.lit(lights))
    }),
    ("two_sided", 0x597c_ea93, |c| {
        let light = sun()?.two_sided(Viewer::of(&view()?));
        let options = OPTIONS.with_cull(Cull::Nothing);
        let below = view()? * Transform::rotate_x(deg!(160));
        let surface = Padded::new(PLAIN.lit(light));
        c.draw_with(&options, &SHEET, &below, &surface.erased());
        Ok(())
    }),
    ("linear fog", 0xc650_d53c, |c| {
        surface(
            c,
            &RING,
            PLAIN
                .lit(sun()?)
                .in_fog(Fog::linear(Rgb888::BLUE, fx!(2.7), fx!(5))?),
        )
    }),
    ("exponential fog", 0x8be0_6eb5, |c| {
        surface(
            c,
            &RING,
            SKINNED.in_fog(Fog::exponential(Rgb888::BLUE, fx!(0.2))?),
        )
    }),
    ("Opacity", 0xbc05_d0c9, |c| {
        by(
            c,
            &OPTIONS.with_blending(Opacity(99)),
            &RING,
            &PLAIN.lit(sun()?),
        )
    }),
    ("Add", 0x8d63_4db1, |c| {
        by(c, &OPTIONS.with_blending(Add), &RING, &PLAIN.lit(sun()?))
    }),
    ("Multiply", 0xbf49_12f1, |c| {
        by(c, &OPTIONS.with_blending(Multiply), &RING, &SKINNED)
    }),
    ("dithered", 0x07ab_577e, |c| {
        coarse::<Rgb565>(c, |c| {
            let dithered = Flat::<Rgb565>::rgb(ORANGE).lit(sun()?).dithered();
            with(c, &RING, &Erased::new(&dithered))
        })
    }),
    ("Rgb565", 0x5e14_f8c6, |c| {
        coarse::<Rgb565>(c, |c| {
            let lit = Flat::<Rgb565>::rgb(ORANGE).lit(sun()?);
            with(c, &RING, &Erased::new(&lit))
        })
    }),
    ("Gray4", 0x7f88_7a0d, |c| {
        coarse::<Gray4>(c, |c| with(c, &RING, &Flat::rgb(ORANGE).lit(sun()?)))
    }),
    ("BinaryColor", 0x855b_6cdf, |c| {
        coarse::<BinaryColor>(c, |c| with(c, &RING, &Flat::rgb(ORANGE).lit(sun()?)))
    }),
    ("ErrorDiffusion", 0xd358_fc04, |c| {
        let (mut grays, mut depths) = ([Gray8::new(0); PIXELS], [0; PIXELS]);
        let mut gray = Canvas::new(&mut grays, WIDTH, HEIGHT)?.with_depth(&mut depths)?;
        with(&mut gray, &RING, &Flat::new(Gray8::new(200)).lit(sun()?))?;
        let mut errors = [0; WIDTH as usize];
        let (contrast, mut diffusion) = (Contrast::of(&gray, 4), ErrorDiffusion::new(&mut errors));
        let mut pixels = [BinaryColor::Off; PIXELS];
        let mut panel = Canvas::new(&mut pixels, WIDTH, HEIGHT)?;
        gray.show_diffused(&mut panel, contrast, &mut diffusion)?;
        panel.show_with(c, |_, color| color.into())?;
        Ok(())
    }),
    ("edges", 0x674b_3f8a, |c| {
        with(c, CUBE.edges(LineStyle::HAIRLINE), &PLAIN)
    }),
    ("smooth lines", 0xd9f0_08ad, |c| {
        with(c, BALL.edges(LineStyle::HAIRLINE.smooth()), &PLAIN)
    }),
    ("wide lines", 0x7a4a_8316, |c| {
        with(c, DRUM.edges(LineStyle::wide(fx!(3.3))?), &SKINNED)
    }),
    ("smooth wide lines", 0x3478_5065, |c| {
        with(c, CUBE.edges(LineStyle::wide(fx!(2.6))?.smooth()), &PLAIN)
    }),
    ("creases", 0xedeb_411d, |c| {
        let options = OPTIONS.with_depth_test(Biased::in_front(TestAndWrite));
        c.draw(&CUBE, &view()?, &PLAIN);
        let outline = CUBE.outline(&EDGES_OF_CUBE, LineStyle::HAIRLINE);
        by(c, &options, outline, &Flat::new(Rgb888::WHITE))
    }),
    ("silhouettes", 0xb613_37d4, |c| {
        with(
            c,
            BALL.outline(&EDGES_OF_BALL, LineStyle::wide(fx!(2))?),
            &PLAIN,
        )
    }),
    ("points", 0x682f_1bbd, |c| {
        let lit = Padded::new(PLAIN.lit(sun()?));
        with(c, RING.points(PointStyle::PIXEL), &lit.erased())
    }),
    ("square points", 0x0d22_a96c, |c| {
        with(c, CUBE.points(PointStyle::square(fx!(5.5))?), &PLAIN)
    }),
    ("round points", 0x6b74_7171, |c| {
        with(
            c,
            CUBE.points(PointStyle::round(fx!(0.31))?.attenuated()),
            &PLAIN,
        )
    }),
    ("Sprites", 0x4b60_aa26, |c| {
        let places = [vec3!(-1, 0, 0.3), vec3!(0.9, 0.4, -1)];
        let sprites = Sprites::new(&places, (fx!(1.1), fx!(0.9)))?.with_axis(Vec3::Y)?;
        with(c, &sprites, &SKINNED)
    }),
    ("Sprites in pixels", 0x84b2_8b68, |c| {
        let (places, scales) = ([vec3!(-1, 0, 0.3), vec3!(0.9, 0.4, -1)], [fx!(1), fx!(1.7)]);
        let sprites = Sprites::in_pixels(&places, (fx!(11), fx!(9.5)))?;
        let sprites = sprites.with_scales(&scales)?.with_anchor(vec2!(0.5, 1));
        with(c, &sprites, &SKINNED)
    }),
    ("quantized", 0xd988_58c2, |c| {
        with(c, &SMALL_CUBE, &SKINNED.lit(sun()?))
    }),
    ("smooth normals", 0x71e4_b386, |c| {
        let mut normals = vec![Vec3::ZERO; CUBE.positions().len()];
        surface(
            c,
            &CUBE.with_smooth_normals(&mut normals)?,
            PLAIN.lit(sun()?),
        )
    }),
    ("Keyframes", 0x49f3_d703, |c| {
        let bent: Vec<_> = BALL
            .positions()
            .iter()
            .map(|p| p + vec3!(0.7, 0, 0) * (p.y * p.y))
            .collect();
        let bent = Mesh::new(&bent, BALL.faces())?;
        let frames = Keyframes::new(&BALL.without_normals().without_uvs(), &bent)?;
        let mut positions = vec![Vec3::ZERO; BALL.positions().len()];
        let mesh = frames.blend(fx!(0.37), &mut positions, &mut [])?;
        surface(c, &mesh, PLAIN.lit_faces(sun()?))
    }),
    ("orthographic", 0x28a0_9cc9, |c| {
        let window = Window::centered(fx!(4), fx!(3));
        let turn = Transform::rotate_x(deg!(35.264)) * Transform::rotate_y(deg!(45));
        let view = Projection::orthographic(window, fx!(-9), fx!(9))? * turn;
        c.draw(&CUBE, &view, &SKINNED.lit(sun()?));
        Ok(())
    }),
    ("cabinet", 0x1d3f_29ce, |c| {
        let window = Window::centered(fx!(6), fx!(4.5));
        let view = Projection::oblique(deg!(30), fx!(0.5), fx!(-1), window, fx!(-1), fx!(9))?;
        c.draw(
            &CUBE,
            &(view * Transform::IDENTITY),
            &PLAIN.lit_faces(sun()?),
        );
        Ok(())
    }),
    ("viewport", 0x526b_dfa1, |c| {
        let options = OPTIONS.with_viewport(Viewport::new(-13, 7, 71, 48)?);
        by(c, &options, &RING, &SKINNED)
    }),
    ("Cull::Front", 0x8afc_3ffe, |c| {
        by(c, &OPTIONS.with_cull(Cull::Front), &CUBE, &SKINNED)
    }),
    ("NoTest", 0x8b1f_a8aa, |c| {
        let options = OPTIONS.with_depth_test(NoTest).with_cull(Cull::Nothing);
        by(c, &options, &RING, &SKINNED)
    }),
    ("FloatDepth", 0x4016_7d8b, in_format::<FloatDepth>),
    ("WideFloatDepth", 0x7811_6199, in_format::<WideFloatDepth>),
    ("DrawList", 0x4cdd_c081, |c| {
        let mut list = Box::new(List::new());
        let ring = list.prepare(&OPTIONS, c.frame_size(), &RING, &view()?)?;
        c.draw_prepared(&ring, &SKINNED.lit(sun()?))?;
        Ok(())
    }),
    ("back to front", 0x519e_1fc3, |c| {
        let mut list = Box::new(List::new());
        let options = OPTIONS.with_depth_test(NoTest).with_cull(Cull::Nothing);
        let glass = options.with_blending(Opacity(120));
        let ring = list.prepare_back_to_front(&glass, c.frame_size(), &RING, &view()?)?;
        c.draw_prepared(&ring, &SKINNED)?;
        Ok(())
    }),
    ("label", 0xc2e0_33e7, |c| {
        with(c, &RING, &PLAIN)?;
        if let Some(at) = c.viewport().project(vec3!(-0.9, 0.2, 0), &view()?) {
            let style = MonoTextStyle::new(&FONT_6X10, Rgb888::WHITE);
            Text::new("Label", Point::zero(), style).draw(&mut c.label(at))?;
        }
        Ok(())
    }),
    ("mirror", 0x79e6_09cd, |c| {
        let mirrored = view()? * Transform::scale_axes(vec3!(-1, 1, 1));
        c.draw(&CUBE, &mirrored, &SKINNED.lit(sun()?));
        Ok(())
    }),
];

#[test]
fn checksums_of_every_word() {
    let mut pictures = Vec::new();
    for (name, stated, draw) in WORDS {
        let (mut pixels, mut depths) = (vec![Rgb888::BLACK; PIXELS], vec![0; PIXELS]);
        let canvas = Canvas::new(&mut pixels, WIDTH, HEIGHT).unwrap();
        let mut canvas = canvas.with_depth(&mut depths).unwrap();
        let background = Rgb888::new(41, 73, 89);
        canvas.clear(background);
        draw(&mut canvas).unwrap();
        let drawn = canvas.pixels().filter(|&color| color != background).count();
        assert!(drawn > 30, "{name} draws {drawn} pixels");
        let rgb: Vec<_> = canvas.pixels().flat_map(ToBytes::to_be_bytes).collect();
        pictures.push(kept::Picture {
            name: (*name).to_string(),
            stated: *stated,
            checksum: crc32fast::hash(&rgb),
            rgb,
        });
    }
    kept::check("words", WIDTH as usize, pictures.len(), &pictures);
}
