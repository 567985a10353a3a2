//! Small pictures for the pages of types. Each picture shows one thing that its page describes.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Rgb565, Rgb888, RgbColor};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::{Drawable, text::Text};
use fixel::canvas::{Add, Blending, Multiply, Opacity, Replace, TestOnly};
use fixel::mesh::{Material, Part};
use fixel::mode::Affine;
use fixel::prelude::*;
use fixel::shade::{Gradient, Output, PartColors};
use fixel::texture::Mipmap;

use super::scenes::{Draw, Frame};

/// The scenes of the benchmarks.
#[allow(dead_code)] // programs that measure the scenes need the rest
#[path = "../../common/scenes.rs"]
mod benchmarks;

/// The size of these pictures.
pub const SIZE: Size = Size::new(240, 160);

/// The pictures, by the name of the type or module.
pub const PAGES: &[(&str, Draw)] = &[
    ("first", first),
    ("flat", flat),
    ("face_colors", face_colors),
    ("part_colors", part_colors),
    ("gouraud", gouraud),
    ("gradient", gradient),
    ("textured", textured),
    ("mipmapped", mipmapped),
    ("depth_view", depth_view),
    ("normal_view", normal_view),
    ("lit", lit),
    ("face_lit", face_lit),
    ("tinted", tinted),
    ("in_fog", in_fog),
    ("map", map),
    ("converted", converted),
    ("quantized", quantized),
    ("light", light),
    ("point_light", point_light),
    ("spot_light", spot_light),
    ("shiny", shiny),
    ("colored", colored),
    ("two_sided", two_sided),
    ("options", options),
    ("blending", blending),
    ("modes", modes),
    ("formats", formats),
    ("shaders", shaders),
    ("measured", measured),
    ("firmware", firmware),
];

static RING: Mesh = shape!(torus(fx!(0.45), 32, 16));
static COARSE_RING: Mesh = shape!(torus(fx!(0.45), 16, 8));
static BALL: Mesh = shape!(sphere(32, 24));
static COARSE_BALL: Mesh = shape!(sphere(10, 6));
static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
// Light is computed at corners, so the edge of a cone of light is sharp only if the squares are small.
static FLOOR: Mesh = shape!(plane(80, 80));
static SHEET: Mesh = shape!(plane(1, 1));

const SLATE: Rgb565 = Rgb565::new(5, 12, 8);
const ORANGE: Rgb888 = Rgb888::new(255, 150, 50);

/// A texture of 8x8 squares. Each square is four texels wide.
static CHECKERS: [[Rgb565; 32]; 32] = {
    let mut texels = [[Rgb565::new(30, 58, 26); 32]; 32];
    let mut at = 0;
    while at < 1024 {
        if (at / 128 + at / 4) % 2 == 1 {
            texels[at / 32][at % 32] = Rgb565::new(4, 20, 20);
        }
        at += 1;
    }
    texels
};

type Drawn = Result<(), Error>;

/// A view of everything within two units of the origin.
fn view(canvas: &Frame<'_>) -> Result<Mvp, Error> {
    let projection = Projection::perspective(deg!(43), canvas.frame_size(), fx!(0.1), fx!(100))?;
    let camera = Camera::look_at(vec3!(0, 2, 3.2), Vec3::ZERO, Vec3::Y)?;
    Ok(projection * camera * Transform::IDENTITY)
}

fn sun() -> Result<Light, Error> {
    Light::new(vec3!(-1, 3, 2), fx!(0.25), fx!(0.75))
}

/// A ring that is tilted to the left.
fn ring<S: ShaderFor<Rgb565>>(canvas: &mut Frame<'_>, mesh: &Mesh, shader: &S) -> Drawn {
    canvas.clear(SLATE);
    let mvp = view(canvas)? * Transform::rotate_z(deg!(25));
    canvas.draw(mesh, &mvp, shader);
    Ok(())
}

/// A ball that fills the picture.
fn ball<S: ShaderFor<Rgb565>>(canvas: &mut Frame<'_>, mesh: &Mesh, shader: &S) -> Drawn {
    canvas.clear(SLATE);
    let mvp = view(canvas)? * Transform::scale(fx!(1.15));
    canvas.draw(mesh, &mvp, shader);
    Ok(())
}

/// A cube that stands on an edge.
fn cube<S: ShaderFor<Rgb565>>(canvas: &mut Frame<'_>, mesh: &Mesh, shader: &S) -> Drawn {
    canvas.clear(SLATE);
    let mvp = view(canvas)? * Transform::rotate_y(deg!(35)) * Transform::scale(fx!(0.78));
    canvas.draw(mesh, &mvp, shader);
    Ok(())
}

/// The scene of the crate's page: a cube with a texture of four texels, and a text.
fn first(canvas: &mut Frame<'_>) -> Drawn {
    static SKIN: [[Rgb565; 2]; 2] = [[Rgb565::WHITE, Rgb565::BLUE], [Rgb565::BLUE, Rgb565::WHITE]];
    let projection = Projection::perspective(deg!(60), canvas.frame_size(), fx!(0.1), fx!(100))?;
    let camera = Camera::look_at(vec3!(0, 1.5, 4), Vec3::ZERO, Vec3::Y)?;
    let spin = Transform::rotate_y(Rate::rpm(10).angle_at(600));
    let sun = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?;
    canvas.clear(Rgb565::BLACK);
    let mvp = projection * camera * spin;
    canvas.draw(&CUBE, &mvp, &Textured::new(&SKIN).lit(sun));
    let style = MonoTextStyle::new(&FONT_6X10, Rgb565::YELLOW);
    Text::new("Hello", Point::new(4, 12), style).draw(canvas)?;
    Ok(())
}

fn flat(canvas: &mut Frame<'_>) -> Drawn {
    ring(canvas, &RING, &Flat::rgb(ORANGE))
}

fn face_colors(canvas: &mut Frame<'_>) -> Drawn {
    let reds = [24, 31, 20, 28, 16];
    let colors: Vec<_> = (0..COARSE_BALL.faces().len())
        .map(|face| {
            Rgb565::new(
                reds[face % 5],
                20 + 8 * (face % 3) as u8,
                6 + 5 * (face % 4) as u8,
            )
        })
        .collect();
    ball(canvas, &COARSE_BALL, &FaceColors::new(&colors))
}

fn part_colors(canvas: &mut Frame<'_>) -> Drawn {
    let faces = RING.faces().len();
    let [red, white] = [Rgb888::new(220, 60, 50), Rgb888::new(250, 245, 235)].map(Material::new);
    let parts: Vec<_> = (0..8)
        .map(|at| {
            Part::new(
                faces / 8 * at..faces / 8 * (at + 1),
                if at % 2 == 0 { red } else { white },
            )
        })
        .collect();
    ring(canvas, &RING, &PartColors::rgb(&parts).lit(sun()?))
}

/// Colors by the direction from the middle of the mesh.
fn rainbow(mesh: &Mesh) -> Vec<Rgb888> {
    let channel = |v: Scalar| 128 + (v * 100).floor().clamp(-100, 100);
    mesh.positions()
        .iter()
        .map(|at| {
            let [r, g, b] = [at.x, at.y, at.z].map(|v| channel(v).cast_unsigned() as u8);
            Rgb888::new(r, g, b)
        })
        .collect()
}

fn gouraud(canvas: &mut Frame<'_>) -> Drawn {
    let colors = rainbow(&CUBE);
    cube(canvas, &CUBE.with_colors(&colors, None)?, &Gouraud::new())
}

fn gradient(canvas: &mut Frame<'_>) -> Drawn {
    let low = (fx!(-0.6), Rgb888::new(30, 70, 160));
    let high = (fx!(0.6), Rgb888::new(250, 240, 190));
    ball(canvas, &BALL, &Gradient::new(low, high)?)
}

fn textured(canvas: &mut Frame<'_>) -> Drawn {
    cube(canvas, &CUBE, &Textured::new(&CHECKERS))
}

static HALF: Mesh = {
    const CORNERS: [Vec3; 4] = [
        vec3!(0, 0, 0),
        vec3!(40, 0, 0),
        vec3!(40, 0, -40),
        vec3!(0, 0, -40),
    ];
    const UVS: [Vec2; 4] = [vec2!(0, 40), vec2!(40, 40), vec2!(40, 0), vec2!(0, 0)];
    Mesh::checked(Mesh::checked(Mesh::new(&CORNERS, &[[0, 1, 2], [0, 2, 3]])).with_uvs(&UVS, None))
};

fn mipmapped(canvas: &mut Frame<'_>) -> Drawn {
    let projection = Projection::perspective(deg!(50), canvas.frame_size(), fx!(0.25), fx!(100))?;
    let camera = Camera::look_at(vec3!(0, 1.4, 0), vec3!(0, 0.2, -4), Vec3::Y)?;
    canvas.clear(SLATE);
    let left = projection * camera * Transform::translate(vec3!(-40, 0, 0));
    // The joints are one texel wide.
    let mut texels = [Rgb565::new(30, 54, 24); Mipmap::<Rgb565>::len(16, 16)];
    for (at, texel) in texels.iter_mut().enumerate() {
        if at / 16 % 4 == 0 || at % 4 == 0 {
            *texel = Rgb565::new(6, 8, 8);
        }
    }
    let tiles = Textured::new(Mipmap::build(&mut texels, 16, 16)?);
    canvas.draw(&HALF, &left, &tiles);
    let smooth = tiles.mipmapped(&projection, canvas.frame_size())?;
    canvas.draw(&HALF, &(projection * camera * Transform::IDENTITY), &smooth);
    Ok(())
}

fn depth_view(canvas: &mut Frame<'_>) -> Drawn {
    ring(canvas, &RING, &DepthView::between(1250, 2750))
}

fn normal_view(canvas: &mut Frame<'_>) -> Drawn {
    ring(canvas, &RING, &NormalView::new())
}

fn lit(canvas: &mut Frame<'_>) -> Drawn {
    ring(canvas, &COARSE_RING, &Flat::rgb(ORANGE).lit(sun()?))
}

fn face_lit(canvas: &mut Frame<'_>) -> Drawn {
    ring(canvas, &COARSE_RING, &Flat::rgb(ORANGE).lit_faces(sun()?))
}

fn tinted(canvas: &mut Frame<'_>) -> Drawn {
    let colors = rainbow(&CUBE);
    let mesh = CUBE.with_colors(&colors, None)?;
    cube(canvas, &mesh, &Textured::new(&CHECKERS).tinted())
}

fn in_fog(canvas: &mut Frame<'_>) -> Drawn {
    let projection = Projection::perspective(deg!(35), canvas.frame_size(), fx!(0.5), fx!(100))?;
    let camera = Camera::look_at(vec3!(-3.2, 1.9, 5.2), vec3!(0.4, 0, -3), Vec3::Y)?;
    let gray = Rgb565::new(22, 46, 24);
    let fog = Fog::linear(gray, fx!(3), fx!(17))?;
    let shader = Flat::rgb(ORANGE).lit(sun()?).in_fog(fog);
    canvas.clear(gray);
    for at in 0..5 {
        let place = Vec3::new(Scalar::ZERO, Scalar::ZERO, fx!(1) - fx!(2.6) * at);
        let upright = Transform::rotate_x(deg!(90)) * Transform::scale(fx!(0.9));
        canvas.draw(
            &RING,
            &(projection * camera * Transform::translate(place) * upright),
            &shader,
        );
    }
    Ok(())
}

fn map(canvas: &mut Frame<'_>) -> Drawn {
    let ink = [
        Rgb565::new(10, 12, 2),
        Rgb565::new(24, 34, 4),
        Rgb565::new(31, 50, 10),
    ];
    let steps = Flat::new(Rgb565::WHITE).lit(sun()?).map(move |at, lit| {
        let lit = lit.finish(at.point);
        let step = usize::from(lit.g() > 26) + usize::from(lit.g() > 52); // white is 63
        Some(ink[step])
    });
    ring(canvas, &RING, &steps)
}

/// A surface with the colors that a canvas of color `C` would show.
fn shown_in<C>(surface: impl ShaderFor<Rgb888>) -> impl ShaderFor<Rgb565>
where
    C: PixelFormat + Into<Rgb888>,
{
    surface
        .converted::<C>()
        .map(|at, color| Some(Rgb565::from(color.finish(at.point).into())))
}

fn converted(canvas: &mut Frame<'_>) -> Drawn {
    let surface = Flat::new(ORANGE).lit(sun()?);
    ring(canvas, &RING, &shown_in::<Gray2>(surface))
}

/// A textured ring with numbers of 32 bits, and a ring with numbers of 8 bits, which takes a third of the flash.
fn quantized(canvas: &mut Frame<'_>) -> Drawn {
    static SMALL: Mesh = shape!(torus(fx!(0.45), 32, 16), quantized_8);
    canvas.clear(SLATE);
    let (half, height) = (SIZE.width / 2, SIZE.height);
    let projection = Projection::perspective(deg!(58), (half, height), fx!(0.1), fx!(100))?;
    let camera = Camera::look_at(vec3!(0, 2, 3.2), Vec3::ZERO, Vec3::Y)?;
    let mvp = projection * camera * Transform::rotate_z(deg!(25));
    let part = |x| -> Result<DrawOptions, Error> {
        Ok(DrawOptions::new().with_viewport(Viewport::new(x, 0, half, height)?))
    };
    let skin = Textured::new(&CHECKERS).lit(sun()?);
    canvas.draw_with(&part(0)?, &RING, &mvp, &skin);
    let right = part(half.cast_signed())?;
    canvas.draw_with(&right, &SMALL, &mvp, &skin);
    Ok(())
}

/// A lamp above a floor and a ball.
fn under<L: Lighting>(canvas: &mut Frame<'_>, light: L) -> Drawn {
    let projection = Projection::perspective(deg!(32), canvas.frame_size(), fx!(0.5), fx!(50))?;
    let camera = Camera::look_at(vec3!(0, 3, 6), vec3!(0, 0.5, 0), Vec3::Y)?;
    canvas.clear(Rgb565::BLACK);
    let white = Flat::rgb(Rgb888::new(240, 235, 225)).lit(light);
    let at = |y| projection * camera * Transform::translate(Vec3::new(fx!(0), y, fx!(0)));
    canvas.draw(&FLOOR, &(at(fx!(0)) * Transform::scale(fx!(5))), &white);
    canvas.draw(&BALL, &(at(fx!(0.8)) * Transform::scale(fx!(0.8))), &white);
    Ok(())
}

fn light(canvas: &mut Frame<'_>) -> Drawn {
    under(canvas, Light::new(vec3!(-2, 2, 1), fx!(0.2), fx!(0.8))?)
}

fn point_light(canvas: &mut Frame<'_>) -> Drawn {
    under(
        canvas,
        PointLight::new(vec3!(-1.5, 0.9, 0.9), fx!(1), fx!(4))?,
    )
}

fn spot_light(canvas: &mut Frame<'_>) -> Drawn {
    let axis = vec3!(2, -3, -0.5);
    under(
        canvas,
        SpotLight::new(
            vec3!(-2, 3.5, 0.6),
            axis,
            (deg!(14), deg!(20)),
            fx!(1),
            fx!(9),
        )?,
    )
}

fn shiny(canvas: &mut Frame<'_>) -> Drawn {
    let viewer = Viewer::of(&view(canvas)?);
    let light = Light::new(vec3!(-1, 3, 2), fx!(0.2), fx!(0.5))?.shiny(viewer, 30, fx!(0.7))?;
    ring(
        canvas,
        &RING,
        &Flat::rgb(Rgb888::new(200, 60, 40)).lit(light),
    )
}

fn colored(canvas: &mut Frame<'_>) -> Drawn {
    let red =
        PointLight::new(vec3!(-2, 1.2, 0.8), fx!(1), fx!(5))?.colored(Rgb888::new(255, 70, 40));
    let blue =
        PointLight::new(vec3!(2, 1.2, 0.8), fx!(1), fx!(5))?.colored(Rgb888::new(60, 100, 255));
    under(canvas, [red, blue])
}

/// The same sheet twice, seen from below: without the adapter and with it.
fn two_sided(canvas: &mut Frame<'_>) -> Drawn {
    let view = view(canvas)?;
    let lamp = Light::new(vec3!(0, 1, 4), fx!(0.1), fx!(0.9))?;
    let both = DrawOptions::new().with_cull(Cull::Nothing);
    canvas.clear(SLATE);
    let at = |x| {
        let turn = Transform::rotate_y(deg!(20)) * Transform::rotate_x(deg!(-65));
        view * Transform::translate(Vec3::new(x, fx!(0), fx!(0)))
            * turn
            * Transform::scale(fx!(0.6))
    };
    let [left, right] = [fx!(-0.8), fx!(0.8)].map(at);
    let green = Flat::rgb(Rgb888::new(120, 200, 110));
    canvas.draw_with(&both, &SHEET, &left, &green.lit(lamp));
    canvas.draw_with(
        &both,
        &SHEET,
        &right,
        &green.lit(lamp.two_sided(Viewer::of(&right))),
    );
    Ok(())
}

/// Four viewports: default options, front faces culled, lines, and points.
fn options(canvas: &mut Frame<'_>) -> Drawn {
    let view = view(canvas)?;
    let ring = view * Transform::rotate_z(deg!(25));
    let orange = Flat::rgb(ORANGE);
    let surface = orange.lit(sun()?);
    canvas.clear(SLATE);
    let (width, height) = (SIZE.width / 2, SIZE.height / 2);
    let part = |column: u32, row: u32| -> Result<DrawOptions, Error> {
        let (x, y) = (column * width, row * height);
        Ok(DrawOptions::new().with_viewport(Viewport::new(
            x.cast_signed(),
            y.cast_signed(),
            width,
            height,
        )?))
    };
    canvas.draw_with(&part(0, 0)?, &RING, &ring, &surface);
    canvas.draw_with(&part(1, 0)?.with_cull(Cull::Front), &RING, &ring, &surface);
    canvas.draw_with(
        &part(0, 1)?,
        COARSE_RING.edges(LineStyle::HAIRLINE),
        &ring,
        &orange,
    );
    canvas.draw_with(&part(1, 1)?, RING.points(PointStyle::PIXEL), &ring, &orange);
    Ok(())
}

/// A pane over stripes, blended in four ways.
fn blending(canvas: &mut Frame<'_>) -> Drawn {
    fn pane<B: Blending<Rgb565>>(canvas: &mut Frame<'_>, at: i32, blending: B) -> Drawn {
        let projection =
            Projection::orthographic(Window::centered(fx!(3), fx!(2)), fx!(0), fx!(4))?;
        let mvp = projection
            * Camera::top(Vec3::ZERO, fx!(2))
            * Transform::translate(Vec3::new(fx!(-1.1) + fx!(0.73) * at, fx!(0), fx!(0)));
        let options = DrawOptions::new()
            .with_depth(TestOnly)
            .with_blending(blending);
        let shader = Flat::new(Rgb565::new(28, 30, 8));
        canvas.draw_with(
            &options,
            &SHEET,
            &(mvp * Transform::scale_axes(vec3!(0.3, 1, 0.7))),
            &shader,
        );
        Ok(())
    }
    canvas.clear(SLATE);
    let stripes = [
        Rgb565::new(3, 10, 22),
        Rgb565::new(20, 52, 28),
        Rgb565::new(10, 26, 10),
    ];
    for (at, color) in (0..12).zip(stripes.iter().cycle()) {
        canvas.fill_solid(
            &Rectangle::new(Point::new(0, 14 * at), Size::new(SIZE.width, 14)),
            *color,
        )?;
    }
    pane(canvas, 0, Replace)?;
    pane(canvas, 1, Opacity(128))?;
    pane(canvas, 2, Add)?;
    pane(canvas, 3, Multiply)
}

/// A floor in mode `Affine`, and in the default mode.
fn modes(canvas: &mut Frame<'_>) -> Drawn {
    canvas.clear(SLATE);
    let (half, size) = (SIZE.width / 2, canvas.frame_size());
    let projection = Projection::perspective(deg!(70), (half, size.height), fx!(0.1), fx!(100))?;
    let camera = Camera::look_at(vec3!(0, 1.1, 1.75), vec3!(0, -0.35, 0), Vec3::Y)?;
    let mvp = projection * camera * Transform::rotate_y(deg!(20));
    let part = |x| -> Result<DrawOptions, Error> {
        Ok(DrawOptions::new().with_viewport(Viewport::new(x, 0, half - 2, size.height)?))
    };
    let floor = Textured::new(&CHECKERS);
    canvas.draw_with(&part(0)?.with_mode(Affine), &SHEET, &mvp, &floor);
    canvas.draw_with(&part(half.cast_signed() + 2)?, &SHEET, &mvp, &floor);
    Ok(())
}

/// A ball in 16 bits of color, in four grays, in black and white.
fn formats(canvas: &mut Frame<'_>) -> Drawn {
    fn ball(canvas: &mut Frame<'_>, at: i32, shader: &impl ShaderFor<Rgb565>) -> Drawn {
        let (third, height) = (SIZE.width / 3, SIZE.height);
        let projection = Projection::perspective(deg!(52), (third, height), fx!(0.1), fx!(50))?;
        let camera = Camera::front(Vec3::ZERO, fx!(5));
        let part = Viewport::new(at * third.cast_signed(), 0, third, height)?;
        let options = DrawOptions::new().with_viewport(part);
        canvas.draw_with(
            &options,
            &BALL,
            &(projection * camera * Transform::IDENTITY),
            shader,
        );
        Ok(())
    }
    canvas.clear(Rgb565::BLACK);
    let surface = Flat::new(ORANGE).lit(sun()?);
    ball(canvas, 0, &shown_in::<Rgb565>(surface))?;
    ball(canvas, 1, &shown_in::<Gray2>(surface))?;
    ball(canvas, 2, &shown_in::<BinaryColor>(surface))
}

/// Eight surfaces.
fn shaders(canvas: &mut Frame<'_>) -> Drawn {
    fn ball(
        canvas: &mut Frame<'_>,
        at: i32,
        mesh: &Mesh,
        shader: &impl ShaderFor<Rgb565>,
    ) -> Drawn {
        let (width, height) = (SIZE.width / 4, SIZE.height / 2);
        let projection = Projection::perspective(deg!(40), (width, height), fx!(0.1), fx!(50))?;
        let camera = Camera::look_at(vec3!(0, 2, 4), Vec3::ZERO, Vec3::Y)?;
        let (column, row) = (at % 4, at / 4);
        let corner = (column * width.cast_signed(), row * height.cast_signed());
        let part = Viewport::new(corner.0, corner.1, width, height)?;
        let mvp = projection * camera * Transform::IDENTITY;
        canvas.draw_with(&DrawOptions::new().with_viewport(part), mesh, &mvp, shader);
        Ok(())
    }
    canvas.clear(SLATE);
    let (sun, orange) = (sun()?, Flat::rgb(ORANGE));
    let reds: Vec<_> = (0..COARSE_BALL.faces().len())
        .map(|face| Rgb565::new(16 + 5 * (face % 4) as u8, 20 + 8 * (face % 3) as u8, 8))
        .collect();
    let colors = rainbow(&BALL);
    let viewer = Viewer::of(&view(canvas)?);
    ball(canvas, 0, &BALL, &orange)?;
    ball(canvas, 1, &COARSE_BALL, &FaceColors::new(&reds))?;
    ball(
        canvas,
        2,
        &BALL.with_colors(&colors, None)?,
        &Gouraud::new(),
    )?;
    ball(canvas, 3, &BALL, &Textured::new(&CHECKERS).lit(sun))?;
    ball(canvas, 4, &COARSE_BALL, &orange.lit_faces(sun))?;
    ball(canvas, 5, &BALL, &orange.lit(sun))?;
    ball(
        canvas,
        6,
        &BALL,
        &orange.lit(sun.shiny(viewer, 30, fx!(0.7))?),
    )?;
    let steps = Flat::new(Rgb565::WHITE).lit(sun).map(|at, lit| {
        let lit = lit.finish(at.point);
        let bright = u8::from(lit.g() > 26) + u8::from(lit.g() > 52); // white is 63
        Some(Rgb565::new(13 + 9 * bright, 18 + 18 * bright, 2))
    });
    ball(canvas, 7, &BALL, &steps)
}

/// The scenes that are measured: floor, cube, sphere, sphere with flat triangles.
fn measured(canvas: &mut Frame<'_>) -> Drawn {
    canvas.clear(SLATE);
    // The viewport has the proportions of 320x240, because the scenes are made for a frame of this size.
    let (width, height) = (106, SIZE.height / 2);
    let part = |column: i32, row: i32| -> Result<DrawOptions, Error> {
        let corner = (7 + 120 * column, row * height.cast_signed());
        Ok(DrawOptions::new().with_viewport(Viewport::new(corner.0, corner.1, width, height)?))
    };
    benchmarks::floor(canvas, &part(0, 0)?, &benchmarks::floor_mvp(0)?);
    benchmarks::cube(canvas, &part(1, 0)?, &benchmarks::cube_mvp(0)?);
    benchmarks::sphere(canvas, &part(0, 1)?, &benchmarks::sphere_mvp(0)?);
    benchmarks::sphere_flat(canvas, &part(1, 1)?, &benchmarks::sphere_mvp(0)?);
    Ok(())
}

/// The scene in the guide for firmware: a ring with a caption.
fn firmware(canvas: &mut Frame<'_>) -> Drawn {
    static RING: Mesh = shape!(torus(fx!(0.4), 24, 12));
    let projection = Projection::perspective(deg!(50), canvas.frame_size(), fx!(0.5), fx!(20))?;
    let camera = Camera::look_at(vec3!(0, 2, 3), Vec3::ZERO, Vec3::Y)?;
    let mvp = projection * camera * Transform::rotate_x(Rate::rpm(10).angle_at(700));
    let light = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?;
    canvas.clear(Rgb565::BLACK);
    canvas.draw(
        &RING,
        &mvp,
        &Flat::new(Rgb565::new(31, 40, 8)).lit_faces(light),
    );
    let style = MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE);
    Text::new("10 rpm", Point::new(4, 12), style).draw(canvas)?;
    Ok(())
}
