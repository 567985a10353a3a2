//! The command line's arguments, and the checks that do not need the library.

use std::path::PathBuf;

use clap::{Command, CommandFactory, Parser, ValueEnum};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use crate::look::{Haze, Lamp};
use fixel_assets::Format;

const EXAMPLES: &str = "\
Examples (`cargo run --release -p simulator -- ` goes before the arguments):
  simulator                                             the project's own scene, as lighthouse.png
  simulator cow.obj --texture cow.png                   your own model, textured and lit
  simulator part.stl --color mono --size 128x64         STL; PLY, glTF and GLB likewise
  simulator teapot.obj --shade gouraud --frames 60 --out teapot.gif
                                                        a turntable: 60 frames, one turn
  simulator cow.obj --shade wire --size 128x64 --color mono
                                                        as an OLED would show it
  simulator cow.obj --eye 2,1,-2 --look-at 0,0,0 --fov 40
                                                        from a place of your choice
  simulator --scene floor --dump floor.csv --crc        a measured scene, pixel by pixel

Distances are in the model's own units, which may be of any size: the program scales and centers the model before it
draws in fixed point. At the end, it prints the camera as options, for you to copy and change. A program for a
microcontroller takes the model from the same file with the macro `fixel::include_mesh!`.";

/// Draws a 3D model with integers only, as a microcontroller would, and saves the picture. Without a model, it draws
/// the project's own scene. Without camera options, the model fills the picture.
#[allow(clippy::struct_excessive_bools)] // flags
#[derive(Clone, Debug, Parser)]
#[command(name = "simulator", version, after_help = EXAMPLES, max_term_width = 100)]
pub struct Args {
    /// Model to draw: Wavefront OBJ with its MTL materials, STL, PLY or glTF (.glb or .gltf).
    ///
    /// A material has one color or one texture, and vertices can have colors. The program computes normals and texture
    /// coordinates if they are missing. In STL files, z points up; in all others, y does. --up changes this.
    #[arg(value_name = "MODEL")]
    pub model: Option<PathBuf>,

    /// Texture for the model: PNG, JPEG, BMP, TGA, GIF or WebP.
    ///
    /// The texture replaces the model's materials. Its sides are resampled to powers of two, at most 1024. [default:
    /// the model's materials, or a checker]
    #[arg(long, value_name = "FILE", help_heading = "Scene")]
    pub texture: Option<PathBuf>,

    /// One of the four measured scenes instead of a model.
    #[arg(long, value_enum, help_heading = "Scene")]
    pub scene: Option<SceneName>,

    /// Position of the camera. [default: in front, a little to the right and above]
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true, help_heading = "Camera")]
    pub eye: Option<[f64; 3]>,

    /// Point that the camera looks at. [default: the center of the model]
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true, help_heading = "Camera")]
    pub look_at: Option<[f64; 3]>,

    /// Direction that points up in the picture, or the name of an axis, for example z for a model with z up. The
    /// default view and the turntable follow it. [default: y, or z for STL]
    #[arg(long, value_name = "X,Y,Z", value_parser = axis, allow_hyphen_values = true, help_heading = "Camera")]
    pub up: Option<[f64; 3]>,

    /// Vertical field of view in degrees, above 0 and below 180. [default: 40; with --eye, wide enough for the whole
    /// model, or 100 if the eye is inside it]
    #[arg(long, value_name = "DEG", value_parser = field_of_view, allow_hyphen_values = true, help_heading = "Camera")]
    pub fov: Option<f64>,

    /// Distance of the near plane, above 0. Nothing nearer is drawn. [default: just in front of the model]
    #[arg(long, value_name = "N", value_parser = number, allow_hyphen_values = true, help_heading = "Camera")]
    pub near: Option<f64>,

    /// Distance of the far plane, beyond the near plane. Nothing farther is drawn. [default: just behind the model]
    #[arg(long, value_name = "F", value_parser = number, allow_hyphen_values = true, help_heading = "Camera")]
    pub far: Option<f64>,

    /// Projection from space to the picture.
    #[arg(
        long,
        value_enum,
        default_value = "perspective",
        help_heading = "Camera"
    )]
    pub projection: Kind,

    /// How the surface is colored. [default: lit if there are textures, texture coordinates, materials or colors; else
    /// gouraud]
    #[arg(long, value_enum, help_heading = "Look")]
    pub shade: Option<Shade>,

    /// How a texture is magnified.
    #[arg(long, value_enum, default_value = "nearest", help_heading = "Look")]
    pub filter: Filter,

    /// How exactly textures and colors are interpolated: speed against accuracy.
    #[arg(long, value_enum, default_value = "newton", help_heading = "Look")]
    pub mode: Mode,

    /// Format of the depth buffer. A wider range keeps surfaces in order even if --far is much larger than --near.
    #[arg(long, value_enum, default_value = "linear", help_heading = "Look")]
    pub depth: DepthBuffer,

    /// Hide the backs of faces, as programs for microcontrollers do by default. Without this option, backs are hidden
    /// only if the file calls the material one-sided.
    #[arg(long, help_heading = "Look")]
    pub cull: bool,

    /// Draw the model's edges over its surface.
    #[arg(long, help_heading = "Look")]
    pub wire: bool,

    /// Color behind the model. [default: a dark color, or a bright one behind a dark model]
    #[arg(long, value_name = "RRGGBB", value_parser = color, help_heading = "Look")]
    pub background: Option<Rgb888>,

    /// Direction to a light, and its color unless it is white. Repeat the option for more lights. [default: a white
    /// light from over the viewer's left shoulder]
    #[arg(long, value_name = "X,Y,Z[,RRGGBB]", value_parser = lamp, allow_hyphen_values = true, help_heading = "Look")]
    pub light: Vec<Lamp>,

    /// Ambient light, which reaches every face, from 0 to 1. [default: 0.3]
    #[arg(long, value_name = "PART", value_parser = part, allow_hyphen_values = true, help_heading = "Look")]
    pub ambient: Option<f64>,

    /// Fog: clear up to the distance NEAR, opaque from FAR on. [default color: the background]
    #[arg(long, value_name = "NEAR,FAR[,RRGGBB]", value_parser = haze, allow_hyphen_values = true,
        help_heading = "Look")]
    pub fog: Option<Haze>,

    /// Pixel format to draw in.
    #[arg(long, value_enum, default_value = "rgb565", help_heading = "Look")]
    pub color: Color,

    /// Picture size in pixels, up to 2048x2048.
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "320x240",
        allow_hyphen_values = true, help_heading = "Picture")]
    pub size: (u32, u32),

    /// Draw in bands of this many rows, as a microcontroller with little memory does. The picture stays the same.
    #[arg(long, value_name = "ROWS", value_parser = clap::value_parser!(u32).range(1..), help_heading = "Picture")]
    pub bands: Option<u32>,

    /// Number of frames of 40 ms in which the model turns once. Several frames are saved as .gif or .apng.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=10_000),
        default_value = "1", help_heading = "Animation")]
    pub frames: u32,

    /// File for the picture: .png, .gif or .apng (an animated PNG), or - for standard output. [default: a .png or .gif
    /// named after the model]
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub out: Option<PathBuf>,

    /// Also write a table of the last frame: x,y,u,v,w,depth of each pixel that the model covers.
    ///
    /// u and v are the texture coordinates, w is the distance from the eye along the view direction, and depth is in
    /// linear steps. Numbers have all their digits. The file - is standard output.
    #[arg(long, value_name = "FILE.csv", help_heading = "Output")]
    pub dump: Option<PathBuf>,

    /// Print the CRC-32 of the last frame's pixels as big-endian RGB565, row by row from the top.
    #[arg(long, help_heading = "Output")]
    pub crc: bool,

    /// Print only errors and the result of --crc.
    #[arg(long, short, help_heading = "Output")]
    pub quiet: bool,

    /// Show the picture in a window; needs SDL2 and a build with --features sdl.
    ///
    /// Drag or press the arrow keys to turn the model. Turn the wheel or press + and - to zoom. Space returns to the
    /// first view, and Escape closes the window.
    #[arg(long, help_heading = "Output")]
    pub window: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SceneName {
    /// A checkered floor to the horizon
    Floor,
    /// A checkered cube
    Cube,
    /// A sphere of 1,984 triangles, Gouraud
    Sphere,
    /// The same sphere, one color per triangle
    SphereFlat,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Distant objects look smaller
    Perspective,
    /// Parallel, straight ahead
    Orthographic,
    /// Parallel, depth drawn slanted at half its length
    Cabinet,
    /// Parallel, depth drawn slanted at its full length
    Cavalier,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Shade {
    /// The model's textures and colors, without light; a checker if it has none
    Texture,
    /// The model's colors, or clay, without textures: lit at the vertices and interpolated between them
    Gouraud,
    /// Like gouraud, with one brightness for each triangle
    Flat,
    /// The model's textures and colors, lit
    Lit,
    /// Edges only; outlines and creases where edges would fill the picture
    Wire,
    /// Depth as gray: near white, far black
    Depth,
    /// Normals as colors: x red, y green, z blue
    Normal,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Filter {
    /// The nearest texel: squares where the texture is magnified
    Nearest,
    /// A blend of the four nearest texels: smooth
    Bilinear,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Mode {
    /// Exact at every pixel
    Exact,
    /// Within a thousandth of a texel: the library's default
    Newton,
    /// Straight pieces, within a quarter of a texel
    Fast,
    /// Without perspective within triangles
    Affine,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DepthBuffer {
    /// Equal steps of 1/distance: finest near the eye
    Linear,
    /// Floating point: steps of 0.024 % of the distance, up to 65,536 times the near plane
    Float,
    /// Floating point over a wider range: steps of 0.049 % of the distance, however far
    Wide,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Color {
    /// 16-bit color
    Rgb565,
    /// 24-bit color
    Rgb888,
    /// 256 grays
    Gray8,
    /// 16 grays, dithered
    Gray4,
    /// Black and white, dithered
    Mono,
}

/// The options that work without a model. The project's own scene and the measured scenes define all other settings.
const WITHOUT_MODEL: &[&str] = &[
    "model", "scene", "mode", "depth", "color", "size", "bands", "frames", "out", "dump", "crc",
    "quiet", "window",
];

/// The command line.
pub fn command() -> Command {
    Args::command().mut_args(|arg| match arg.get_id().as_str() {
        "model" | "size" => arg.conflicts_with("scene"),
        id if WITHOUT_MODEL.contains(&id) => arg,
        _ => arg.requires("model"),
    })
}

impl Args {
    /// The direction that is up.
    pub fn up(&self) -> [f64; 3] {
        let is_stl = self.model.as_deref().and_then(Format::of) == Some(Format::Stl);
        let up = if is_stl {
            [0.0, 0.0, 1.0]
        } else {
            [0.0, 1.0, 0.0]
        };
        self.up.unwrap_or(up)
    }
}

fn number(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err("it must be a finite number".into()),
        Err(_) => Err("it must be a number, such as 1.5".into()),
    }
}

fn field_of_view(text: &str) -> Result<f64, String> {
    let degrees = number(text)?;
    // An angle is a fraction of a turn, so the library would accept 400 degrees as 40. Therefore the angle is checked
    // here.
    if degrees > 0.0 && degrees < 180.0 {
        Ok(degrees)
    } else {
        Err(format!(
            "field of view is {degrees} degrees: it must be above 0 and below 180 degrees"
        ))
    }
}

fn point(text: &str) -> Result<[f64; 3], String> {
    let numbers: Vec<f64> = text
        .split(',')
        .map(|part| number(part).map_err(|problem| format!("'{part}': {problem}")))
        .collect::<Result<_, _>>()?;
    numbers
        .try_into()
        .map_err(|_| "it must be three numbers with commas between, such as 0,1.5,-2".into())
}

fn axis(text: &str) -> Result<[f64; 3], String> {
    match text {
        "x" => Ok([1.0, 0.0, 0.0]),
        "y" => Ok([0.0, 1.0, 0.0]),
        "z" => Ok([0.0, 0.0, 1.0]),
        _ => point(text),
    }
}

fn part(text: &str) -> Result<f64, String> {
    let part = number(text)?;
    if (0.0..=1.0).contains(&part) {
        Ok(part)
    } else {
        Err("it must be between 0 and 1".into())
    }
}

fn color(text: &str) -> Result<Rgb888, String> {
    let digits = text.strip_prefix('#').unwrap_or(text);
    let is_hex = digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    match u32::from_str_radix(digits, 16) {
        Ok(value) if is_hex => {
            let [_, r, g, b] = value.to_be_bytes();
            Ok(Rgb888::new(r, g, b))
        }
        _ => Err(format!(
            "'{text}': it must be a color in hexadecimal, such as ff8800"
        )),
    }
}

/// Parses `N` numbers separated by commas. If one more word follows, it is parsed as a color.
fn numbers<const N: usize>(
    text: &str,
    such_as: &str,
) -> Result<([f64; N], Option<Rgb888>), String> {
    let parts: Vec<&str> = text.split(',').collect();
    let color = match parts.get(N..) {
        Some([]) => None,
        Some([last]) => Some(color(last)?),
        _ => {
            return Err(format!(
                "it must be {N} numbers and perhaps a color, such as {such_as}"
            ));
        }
    };
    let mut numbers = [0.0; N];
    for (to, part) in numbers.iter_mut().zip(parts) {
        *to = number(part).map_err(|problem| format!("'{part}': {problem}"))?;
    }
    Ok((numbers, color))
}

fn lamp(text: &str) -> Result<Lamp, String> {
    let (direction, color) = numbers(text, "1,2,1,ff8800")?;
    if direction.iter().all(|&x| x == 0.0) {
        return Err("it must point somewhere: at least one number must not be 0".into());
    }
    Ok(Lamp {
        direction,
        color: color.unwrap_or(Rgb888::WHITE),
    })
}

fn haze(text: &str) -> Result<Haze, String> {
    let ([near, far], color) = numbers(text, "2,9,c0d0e0")?;
    if near >= far {
        return Err(format!(
            "fog ends at {far}: that must be beyond its beginning at {near}"
        ));
    }
    Ok(Haze { near, far, color })
}

fn size(text: &str) -> Result<(u32, u32), String> {
    let parse = |part: &str| part.trim().parse().ok();
    text.split_once(['x', 'X'])
        .and_then(|(width, height)| Some((parse(width)?, parse(height)?)))
        .ok_or_else(|| "it must be width x height in whole pixels, such as 320x240".into())
}
