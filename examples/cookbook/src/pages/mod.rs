//! Small pictures for the pages of types. Each picture shows one thing that its page describes.

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::prelude::*;
use fixel::shade::Output;

use crate::scenes::{Draw, Frame};

/// The scenes of the benchmarks.
#[allow(dead_code)] // programs that measure the scenes need the rest
#[path = "../../../common/scenes.rs"]
mod benchmarks;
mod canvas;
mod lights;
mod programs;
mod surfaces;

/// The size of these pictures.
pub const SIZE: Size = Size::new(240, 160);

/// The pictures, by the name of the type or module.
pub const PAGES: &[(&str, Draw)] = &[
    ("first", programs::first),
    ("flat", surfaces::flat),
    ("face_colors", surfaces::face_colors),
    ("part_colors", surfaces::part_colors),
    ("gouraud", surfaces::gouraud),
    ("gradient", surfaces::gradient),
    ("textured", surfaces::textured),
    ("mipmapped", surfaces::mipmapped),
    ("depth_view", surfaces::depth_view),
    ("normal_view", surfaces::normal_view),
    ("lit", surfaces::lit),
    ("face_lit", surfaces::face_lit),
    ("tinted", surfaces::tinted),
    ("in_fog", surfaces::in_fog),
    ("map", surfaces::map),
    ("converted", surfaces::converted),
    ("quantized", surfaces::quantized),
    ("light", lights::light),
    ("point_light", lights::point_light),
    ("spot_light", lights::spot_light),
    ("shiny", lights::shiny),
    ("colored", lights::colored),
    ("two_sided", lights::two_sided),
    ("options", canvas::options),
    ("smooth_edges", canvas::smooth_edges),
    ("blending", canvas::blending),
    ("modes", canvas::modes),
    ("formats", canvas::formats),
    ("shaders", surfaces::shaders),
    ("shapes", surfaces::shapes),
    ("measured", canvas::measured),
    ("firmware", programs::firmware),
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
    let projection = Projection::perspective(deg!(43), canvas.frame_size(), fx!(0.1), fx!(50))?;
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

/// A surface with the colors that a canvas of color `C` would show.
fn shown_in<C>(surface: impl ShaderFor<Rgb888>) -> impl ShaderFor<Rgb565>
where
    C: PixelFormat + Into<Rgb888>,
{
    surface
        .converted::<C>()
        .map(|at, color| Some(Rgb565::from(color.finish(at.point).into())))
}
