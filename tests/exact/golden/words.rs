//! A picture for each feature of the crate: each kind of thing, surface, light, adapter, view and canvas.
//!
//! Colors have 24 bits where possible, so that a changed rounding constant changes the picture.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::raw::ToBytes;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888, RgbColor};
use embedded_graphics::{Drawable, geometry::Point, text::Text};
use fixel::canvas::{
    Add, Biased, Contrast, DepthBuffer, ErrorDiffusion, FloatDepth, Multiply, NoTest, Opacity,
    TestAndWrite, WideFloatDepth,
};
use fixel::mesh::{Keyframes, Material, Part};
use fixel::prelude::*;
use fixel::shade::{DepthView, Gradient, NormalView, PartColors, Viewer};
use fixel::texture::{Argb4444, Indexed, Mipmap, Raw};

use super::kept;
use crate::List;
use support::erased::{Erased, Padded};

const WIDTH: u32 = 80;
const HEIGHT: u32 = 60;
const PIXELS: usize = (WIDTH * HEIGHT) as usize;

type Picture<'c> = Canvas<'c, Rgb888, Native, LinearDepth>;
type Drawn = Result<(), Error>;

static RING: Mesh = shape!(torus(fx!(0.45), 24, 12));
static BALL: Mesh = shape!(sphere(16, 12));
static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
static SMALL_CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)), quantized_8);
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

fn view() -> Result<Mvp, Error> {
    let projection = Projection::perspective(deg!(43), (WIDTH, HEIGHT), fx!(0.1), fx!(100))?;
    let camera = Camera::look_at(vec3!(0.3, 2, 3.2), Vec3::ZERO, Vec3::Y)?;
    Ok(projection * camera * Transform::rotate_z(deg!(25)))
}

fn sun() -> Result<Light, Error> {
    Light::new(vec3!(-1, 3, 2), fx!(0.23), fx!(0.71))
}

/// Draws with a shader, on a background that is neither black nor white.
fn with<S: ShaderFor<Rgb888>>(canvas: &mut Picture<'_>, mesh: &Mesh, shader: &S) -> Drawn {
    canvas.draw(mesh, &view()?, shader);
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
    format.draw(&SHEET, &view()?, &Textured::new(&SKIN));
    let lean = Transform::rotate_z(deg!(0.01)) * Transform::rotate_x(deg!(0.02));
    format.draw(&SHEET, &(view()? * lean), &Flat::new(ORANGE));
    format.show(canvas)?;
    Ok(())
}

/// A mesh with a color at each corner.
fn colored(mesh: &Mesh<'static>) -> Vec<Rgb888> {
    (0..mesh.positions().len())
        .map(|at| SKIN[at % 8][at / 8 % 8])
        .collect()
}

/// Draws in a coarser color format, and converts the picture back to show it.
fn coarse<C>(
    canvas: &mut Picture<'_>,
    draw: impl Fn(&mut Canvas<'_, C, Native, LinearDepth>) -> Drawn,
) -> Drawn
where
    C: embedded_graphics::pixelcolor::PixelColor + Default + Into<Rgb888>,
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
    ("Flat", 0x93d3_ff40, |c| with(c, &RING, &Flat::new(ORANGE))),
    ("FaceColors", 0x99b5_d3d7, |c| {
        let colors: Vec<_> = (0..RING.faces().len())
            .map(|at| SKIN[at % 8][at / 8 % 8])
            .collect();
        surface(c, &RING, FaceColors::new(&colors))
    }),
    ("PartColors", 0x6c52_e659, |c| {
        let parts = [(0..200, ORANGE), (200..576, Rgb888::BLUE)];
        let parts = parts.map(|(faces, color)| Part::new(faces, Material::new(color)));
        surface(c, &RING, PartColors::rgb(&parts))
    }),
    ("Gouraud", 0x53bb_453d, |c| {
        let colors = colored(&CUBE);
        let gouraud = Gouraud::<Rgb888>::new();
        with(c, &CUBE.with_colors(&colors, None)?, &Erased::new(&gouraud))
    }),
    ("tinted", 0xd282_30a8, |c| {
        let colors = colored(&BALL);
        surface(
            c,
            &BALL.with_colors(&colors, None)?,
            Textured::new(&SKIN).tinted(),
        )
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
    ("Textured", 0x3a8f_8d50, |c| {
        with(c, &CUBE, &Textured::new(&SKIN))
    }),
    ("clamped", 0x4e48_401a, |c| {
        surface(c, &CUBE, Textured::new(&SKIN).clamped().bilinear())
    }),
    ("bilinear", 0x9e52_ee32, |c| {
        surface(c, &CUBE, Textured::new(&SKIN).bilinear())
    }),
    ("cut_out", 0xfb13_c68c, |c| {
        surface(c, &CUBE, Textured::new(&SKIN).cut_out(SKIN[0][1]))
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
        coarse::<Rgb565>(c, |c| {
            c.draw(&CUBE, &view()?, &Textured::new(&texels));
            Ok(())
        })
    }),
    ("mipmapped", 0xb960_1a0b, |c| {
        let mut texels = [Rgb888::BLACK; Mipmap::<Rgb888>::len(8, 8)];
        texels[..64].copy_from_slice(SKIN.as_flattened());
        let skin = Textured::new(Mipmap::build(&mut texels, 8, 8)?);
        let projection = Projection::perspective(deg!(43), (WIDTH, HEIGHT), fx!(0.1), fx!(100))?;
        let far = projection * Transform::translate(vec3!(0, -1, -9)) * Transform::scale(fx!(7));
        let skin = Padded::new(skin.mipmapped(&projection, c.frame_size())?);
        c.draw(&SHEET, &far, &skin.erased());
        Ok(())
    }),
    ("trilinear", 0xe5a5_7553, |c| {
        let mut texels = [Rgb888::BLACK; Mipmap::<Rgb888>::len(8, 8)];
        texels[..64].copy_from_slice(SKIN.as_flattened());
        let skin = Textured::new(Mipmap::build(&mut texels, 8, 8)?);
        let projection = Projection::perspective(deg!(43), (WIDTH, HEIGHT), fx!(0.1), fx!(100))?;
        let far = projection * Transform::translate(vec3!(0, -1, -9)) * Transform::scale(fx!(7));
        let skin = skin.mipmapped(&projection, c.frame_size())?;
        c.draw(&SHEET, &far, &Padded::new(skin.trilinear()).erased());
        Ok(())
    }),
    ("Light", 0x9efc_2e07, |c| {
        surface(c, &RING, Flat::new(ORANGE).lit(sun()?))
    }),
    ("lit_faces", 0x54c1_b743, |c| {
        surface(c, &BALL, Flat::new(ORANGE).lit_faces(sun()?))
    }),
    ("lit texture", 0xce1f_7c04, |c| {
        with(c, &BALL, &Textured::new(&SKIN).lit(sun()?))
    }),
    ("PointLight", 0x7800_d04b, |c| {
        surface(
            c,
            &RING,
            Flat::new(ORANGE).lit(PointLight::new(vec3!(1, 1, 1), fx!(1), fx!(4))?),
        )
    }),
    ("SpotLight", 0xff46_66ff, |c| {
        let cone = (deg!(15), deg!(30));
        let lamp = SpotLight::new(vec3!(0, 3, 0), vec3!(0.1, -1, 0), cone, fx!(1), fx!(9))?;
        surface(c, &RING, Flat::new(ORANGE).lit(lamp))
    }),
    ("shiny", 0x4052_59b6, |c| {
        let light = sun()?.shiny(Viewer::of(&view()?), 20, fx!(0.8))?;
        surface(c, &BALL, Flat::new(ORANGE).lit(light))
    }),
    ("colored", 0x13bf_26f6, |c| {
        let lights = (
            sun()?.colored(Rgb888::new(200, 99, 7)),
            PointLight::new(vec3!(2, 0, 2), fx!(1), fx!(4))?,
        );
        surface(c, &RING, Textured::new(&SKIN).lit(lights))
    }),
    ("two_sided", 0x597c_ea93, |c| {
        let light = sun()?.two_sided(Viewer::of(&view()?));
        let options = DrawOptions::new().with_cull(Cull::Nothing);
        let below = view()? * Transform::rotate_x(deg!(160));
        let surface = Padded::new(Flat::new(ORANGE).lit(light));
        c.draw_with(&options, &SHEET, &below, &surface.erased());
        Ok(())
    }),
    ("linear fog", 0x2151_a275, |c| {
        surface(
            c,
            &RING,
            Flat::new(ORANGE)
                .lit(sun()?)
                .in_fog(Fog::linear(Rgb888::BLUE, fx!(2.7), fx!(5))?),
        )
    }),
    ("exponential fog", 0x94a7_6c51, |c| {
        surface(
            c,
            &RING,
            Textured::new(&SKIN).in_fog(Fog::exponential(Rgb888::BLUE, fx!(0.2))?),
        )
    }),
    ("Opacity", 0xbc05_d0c9, |c| {
        c.draw_with(
            &DrawOptions::new().with_blending(Opacity(99)),
            &RING,
            &view()?,
            &Flat::new(ORANGE).lit(sun()?),
        );
        Ok(())
    }),
    ("Add", 0x8d63_4db1, |c| {
        c.draw_with(
            &DrawOptions::new().with_blending(Add),
            &RING,
            &view()?,
            &Flat::new(ORANGE).lit(sun()?),
        );
        Ok(())
    }),
    ("Multiply", 0x2a5e_d919, |c| {
        c.draw_with(
            &DrawOptions::new().with_blending(Multiply),
            &RING,
            &view()?,
            &Textured::new(&SKIN),
        );
        Ok(())
    }),
    ("dithered", 0x07ab_577e, |c| {
        coarse::<Rgb565>(c, |c| {
            let dithered = Flat::<Rgb565>::rgb(ORANGE).lit(sun()?).dithered();
            c.draw(&RING, &view()?, &Erased::new(&dithered));
            Ok(())
        })
    }),
    ("Rgb565", 0x5e14_f8c6, |c| {
        coarse::<Rgb565>(c, |c| {
            let lit = Flat::<Rgb565>::rgb(ORANGE).lit(sun()?);
            c.draw(&RING, &view()?, &Erased::new(&lit));
            Ok(())
        })
    }),
    ("Gray4", 0x7f88_7a0d, |c| {
        coarse::<Gray4>(c, |c| {
            c.draw(&RING, &view()?, &Flat::rgb(ORANGE).lit(sun()?));
            Ok(())
        })
    }),
    ("BinaryColor", 0x855b_6cdf, |c| {
        coarse::<BinaryColor>(c, |c| {
            c.draw(&RING, &view()?, &Flat::rgb(ORANGE).lit(sun()?));
            Ok(())
        })
    }),
    ("ErrorDiffusion", 0xd358_fc04, |c| {
        let (mut grays, mut depths) = ([Gray8::new(0); PIXELS], [0; PIXELS]);
        let mut gray = Canvas::new(&mut grays, WIDTH, HEIGHT)?.with_depth(&mut depths)?;
        gray.draw(&RING, &view()?, &Flat::new(Gray8::new(200)).lit(sun()?));
        let mut errors = [0; WIDTH as usize];
        let contrast = Contrast::of(&gray, 4);
        coarse::<BinaryColor>(c, |c| {
            gray.show_diffused(c, contrast, &mut ErrorDiffusion::new(&mut errors.clone()))?;
            Ok(())
        })?;
        errors.fill(0);
        Ok(())
    }),
    ("edges", 0x674b_3f8a, |c| {
        c.draw(
            CUBE.edges(LineStyle::HAIRLINE),
            &view()?,
            &Flat::new(ORANGE),
        );
        Ok(())
    }),
    ("smooth lines", 0xd9f0_08ad, |c| {
        c.draw(
            BALL.edges(LineStyle::HAIRLINE.smooth()),
            &view()?,
            &Flat::new(ORANGE),
        );
        Ok(())
    }),
    ("wide lines", 0xcbd0_82d0, |c| {
        c.draw(
            CUBE.edges(LineStyle::wide(fx!(3.3))?),
            &view()?,
            &Textured::new(&SKIN),
        );
        Ok(())
    }),
    ("smooth wide lines", 0x3478_5065, |c| {
        c.draw(
            CUBE.edges(LineStyle::wide(fx!(2.6))?.smooth()),
            &view()?,
            &Flat::new(ORANGE),
        );
        Ok(())
    }),
    ("creases", 0xedeb_411d, |c| {
        let options = DrawOptions::new().with_depth(Biased::in_front(TestAndWrite));
        c.draw(&CUBE, &view()?, &Flat::new(ORANGE));
        let outline = CUBE.outline(&EDGES_OF_CUBE, LineStyle::HAIRLINE);
        c.draw_with(&options, outline, &view()?, &Flat::new(Rgb888::WHITE));
        Ok(())
    }),
    ("silhouettes", 0xb613_37d4, |c| {
        c.draw(
            BALL.outline(&EDGES_OF_BALL, LineStyle::wide(fx!(2))?),
            &view()?,
            &Flat::new(ORANGE),
        );
        Ok(())
    }),
    ("points", 0x682f_1bbd, |c| {
        let lit = Padded::new(Flat::new(ORANGE).lit(sun()?));
        c.draw(RING.points(PointStyle::PIXEL), &view()?, &lit.erased());
        Ok(())
    }),
    ("square points", 0x0d22_a96c, |c| {
        c.draw(
            CUBE.points(PointStyle::square(fx!(5.5))?),
            &view()?,
            &Flat::new(ORANGE),
        );
        Ok(())
    }),
    ("round points", 0x6b74_7171, |c| {
        c.draw(
            CUBE.points(PointStyle::round(fx!(0.31))?.attenuated()),
            &view()?,
            &Flat::new(ORANGE),
        );
        Ok(())
    }),
    ("Sprites", 0x4b60_aa26, |c| {
        let places = [vec3!(-1, 0, 0.3), vec3!(0.9, 0.4, -1)];
        let sprites = Sprites::new(&places, (fx!(1.1), fx!(0.9)))?.with_axis(Vec3::Y)?;
        c.draw(&sprites, &view()?, &Textured::new(&SKIN));
        Ok(())
    }),
    ("Sprites in pixels", 0x84b2_8b68, |c| {
        let (places, scales) = ([vec3!(-1, 0, 0.3), vec3!(0.9, 0.4, -1)], [fx!(1), fx!(1.7)]);
        let sprites = Sprites::in_pixels(&places, (fx!(11), fx!(9.5)))?;
        let sprites = sprites.with_scales(&scales)?.with_anchor(vec2!(0.5, 1));
        c.draw(&sprites, &view()?, &Textured::new(&SKIN));
        Ok(())
    }),
    ("quantized", 0xd988_58c2, |c| {
        with(c, &SMALL_CUBE, &Textured::new(&SKIN).lit(sun()?))
    }),
    ("smooth normals", 0x7824_927e, |c| {
        let mut normals = vec![Vec3::ZERO; CUBE.positions().len()];
        surface(
            c,
            &CUBE.with_smooth_normals(&mut normals)?,
            Flat::new(ORANGE).lit(sun()?),
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
        surface(c, &mesh, Flat::new(ORANGE).lit_faces(sun()?))
    }),
    ("orthographic", 0x28a0_9cc9, |c| {
        let window = Window::centered(fx!(4), fx!(3));
        let turn = Transform::rotate_x(deg!(35.264)) * Transform::rotate_y(deg!(45));
        let view = Projection::orthographic(window, fx!(-9), fx!(9))? * turn;
        c.draw(&CUBE, &view, &Textured::new(&SKIN).lit(sun()?));
        Ok(())
    }),
    ("cabinet", 0x1d3f_29ce, |c| {
        let window = Window::centered(fx!(6), fx!(4.5));
        let view = Projection::cabinet(deg!(30), window, fx!(-1), fx!(9))?;
        c.draw(
            &CUBE,
            &(view * Transform::IDENTITY),
            &Flat::new(ORANGE).lit_faces(sun()?),
        );
        Ok(())
    }),
    ("viewport", 0x0a33_e320, |c| {
        let options = DrawOptions::new().with_viewport(Viewport::new(-13, 7, 71, 48)?);
        c.draw_with(&options, &RING, &view()?, &Textured::new(&SKIN));
        Ok(())
    }),
    ("Cull::Front", 0x8afc_3ffe, |c| {
        c.draw_with(
            &DrawOptions::new().with_cull(Cull::Front),
            &CUBE,
            &view()?,
            &Textured::new(&SKIN),
        );
        Ok(())
    }),
    ("NoTest", 0xb188_1922, |c| {
        let options = DrawOptions::new()
            .with_depth(NoTest)
            .with_cull(Cull::Nothing);
        c.draw_with(&options, &RING, &view()?, &Textured::new(&SKIN));
        Ok(())
    }),
    ("FloatDepth", 0x4016_7d8b, in_format::<FloatDepth>),
    ("WideFloatDepth", 0x7811_6199, in_format::<WideFloatDepth>),
    ("DrawList", 0x2956_de48, |c| {
        let mut list = Box::new(List::new());
        let ring = list.prepare(&DrawOptions::new(), c.frame_size(), &RING, &view()?)?;
        c.draw_prepared(&ring, &Textured::new(&SKIN).lit(sun()?))?;
        Ok(())
    }),
    ("back to front", 0x178d_d878, |c| {
        let mut list = Box::new(List::new());
        let options = DrawOptions::new()
            .with_depth(NoTest)
            .with_cull(Cull::Nothing);
        let glass = options.with_blending(Opacity(120));
        let ring = list.prepare_back_to_front(&glass, c.frame_size(), &RING, &view()?)?;
        c.draw_prepared(&ring, &Textured::new(&SKIN))?;
        Ok(())
    }),
    ("label", 0xc2e0_33e7, |c| {
        with(c, &RING, &Flat::new(ORANGE))?;
        let options = DrawOptions::new();
        if let Some(at) = c.project(&options, &view()?, vec3!(-0.9, 0.2, 0)) {
            let style = MonoTextStyle::new(&FONT_6X10, Rgb888::WHITE);
            Text::new("Label", Point::zero(), style).draw(&mut c.label(at))?;
        }
        Ok(())
    }),
    ("mirror", 0x79e6_09cd, |c| {
        let mirrored = view()? * Transform::scale_axes(vec3!(-1, 1, 1));
        c.draw(&CUBE, &mirrored, &Textured::new(&SKIN).lit(sun()?));
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
