//! The command line's arguments, and the checks that do not need the library.

use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel_assets::Format;
use lexopt::{Arg, Parser};

use crate::look::{Haze, Lamp};

/// The text of `--help`. [`options`] finds the options in it: lines such as `--eye X,Y,Z`.
pub const HELP: &str = include_str!("help.txt");

/// The arguments: see [`HELP`].
#[allow(clippy::struct_excessive_bools)] // flags
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Args {
    /// The options that the user gave, with their values.
    given: Vec<(&'static str, OsString)>,
    pub model: Option<PathBuf>,
    pub texture: Option<PathBuf>,
    pub scene: Option<SceneName>,
    pub eye: Option<[f64; 3]>,
    pub look_at: Option<[f64; 3]>,
    pub up: Option<[f64; 3]>,
    pub fov: Option<f64>,
    pub near: Option<f64>,
    pub far: Option<f64>,
    pub projection: Kind,
    pub shade: Option<Shade>,
    pub filter: Filter,
    pub mode: Mode,
    pub depth: DepthBuffer,
    pub cull: bool,
    pub wire: bool,
    pub background: Option<Rgb888>,
    pub light: Vec<Lamp>,
    pub ambient: Option<f64>,
    pub fog: Option<Haze>,
    pub color: Color,
    pub size: (u32, u32),
    pub bands: Option<u32>,
    pub frames: u32,
    pub out: Option<PathBuf>,
    pub dump: Option<PathBuf>,
    pub crc: bool,
    pub quiet: bool,
    pub window: bool,
    pub help: bool,
    pub version: bool,
}

/// The possible values of an option.
pub trait Named: Copy + PartialEq + 'static {
    const VALUES: &'static [(Self, &'static str)];

    /// The value's name, as the user writes it.
    fn name(self) -> &'static str {
        let value = Self::VALUES.iter().find(|(value, _)| *value == self);
        value.map_or("", |(_, name)| name)
    }

    fn parse(text: &str) -> Result<Self, String> {
        let value = Self::VALUES.iter().find(|(_, name)| *name == text);
        value.map(|(value, _)| *value).ok_or_else(|| {
            let names: Vec<_> = Self::VALUES.iter().map(|(_, name)| *name).collect();
            format!("the possible values are {}", names.join(", "))
        })
    }
}

/// An enum of possible values with their names. The first value is the default, if the option has one.
macro_rules! choice {
    ($name:ident: $first:ident $text:literal, $($other:ident $more:literal,)+) => {
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub enum $name {
            #[default]
            $first,
            $($other,)+
        }

        impl Named for $name {
            const VALUES: &'static [(Self, &'static str)] =
                &[(Self::$first, $text), $((Self::$other, $more),)+];
        }
    };
}

choice!(SceneName: Floor "floor", Cube "cube", Sphere "sphere", SphereFlat "sphere-flat",);
choice!(Kind: Perspective "perspective", Orthographic "orthographic", Cabinet "cabinet", Cavalier "cavalier",);
choice!(Shade: Texture "texture", Gouraud "gouraud", Flat "flat", Lit "lit", Wire "wire", Depth "depth",
    Normal "normal",);
choice!(Filter: Nearest "nearest", Bilinear "bilinear",);
choice!(Mode: Newton "newton", Exact "exact", Fast "fast", Affine "affine",);
choice!(DepthBuffer: Linear "linear", Float "float", Wide "wide",);
choice!(Color: Rgb565 "rgb565", Rgb888 "rgb888", Gray8 "gray8", Gray4 "gray4", Mono "mono",);

/// The options that work with `--scene`. The measured scenes define all other settings.
const WITH_SCENE: &[&str] = &[
    "scene", "mode", "depth", "color", "bands", "frames", "out", "dump", "crc", "quiet", "window",
];

/// The options that the project's own scene does not take, and what it has instead.
const WITH_MODEL: [(&str, &str); 2] = [
    ("texture", "the project's own scene keeps its textures"),
    (
        "cull",
        "the project's own scene always hides backs of faces",
    ),
];

/// The options in [`HELP`]: the name of each, and whether a value follows.
fn options() -> impl Iterator<Item = (&'static str, bool)> {
    let lines = HELP.lines().filter_map(|line| line.strip_prefix("  --"));
    lines.map(|line| match line.split_once(' ') {
        None => (line, false),
        Some((name, value)) => (name.trim_end_matches(','), !value.starts_with('-')),
    })
}

impl Args {
    /// Parses the program's command line.
    ///
    /// # Errors
    ///
    /// The first argument that is refused, and what may stand there.
    pub fn parse() -> Result<Self, String> {
        let mut parser = Parser::from_env();
        let mut args = Self::unset();
        while let Some(arg) = parser.next().map_err(|error| error.to_string())? {
            let wanted = match arg {
                Arg::Long(name) => name.to_string(),
                Arg::Short('q') => "quiet".into(),
                Arg::Short('h') => "help".into(),
                Arg::Short('V') => "version".into(),
                Arg::Short(letter) => return Err(format!("there is no option -{letter}")),
                Arg::Value(path) if args.model.is_none() => {
                    args.model = Some(path.into());
                    continue;
                }
                Arg::Value(word) => {
                    return Err(format!("'{}': only one model can be drawn", word.display()));
                }
            };
            let Some((name, has_value)) = options().find(|(name, _)| *name == wanted) else {
                return Err(unknown(&wanted));
            };
            if args.has(name) && name != "light" {
                return Err(format!("--{name} is given twice"));
            }
            let value = if has_value {
                parser.value().map_err(|error| error.to_string())?
            } else {
                OsString::new()
            };
            if has_value && value.is_empty() {
                return Err(format!("--{name}: its value is empty"));
            }
            args.set(name, &value)
                .map_err(|problem| format!("--{name} {}: {problem}", value.display()))?;
            args.given.push((name, value));
        }
        args.check()?;
        Ok(args)
    }

    /// The arguments of an empty command line.
    fn unset() -> Self {
        Self {
            size: (320, 240),
            frames: 1,
            ..Self::default()
        }
    }

    /// Whether the user gave this option.
    pub fn has(&self, name: &str) -> bool {
        self.given.iter().any(|(given, _)| *given == name)
    }

    /// The arguments without one of the options that the user gave; `None` if the arguments stay the same.
    pub fn without(&self, name: &str) -> Option<Self> {
        let mut args = Self {
            model: self.model.clone(),
            ..Self::unset()
        };
        for (other, value) in &self.given {
            if *other != name {
                args.set(other, value).ok()?;
            }
        }
        args.given.clone_from(&self.given);
        (args != *self).then_some(args)
    }

    /// Sets an option. Flags have an empty value.
    fn set(&mut self, name: &str, value: &OsStr) -> Result<(), String> {
        let path = || Some(PathBuf::from(value));
        let text = &*value.to_string_lossy();
        match name {
            "texture" => self.texture = path(),
            "scene" => self.scene = Some(SceneName::parse(text)?),
            "eye" => self.eye = Some(point(text)?),
            "look-at" => self.look_at = Some(point(text)?),
            "up" => self.up = Some(axis(text)?),
            "fov" => self.fov = Some(field_of_view(text)?),
            "near" => self.near = Some(number(text)?),
            "far" => self.far = Some(number(text)?),
            "projection" => self.projection = Kind::parse(text)?,
            "shade" => self.shade = Some(Shade::parse(text)?),
            "filter" => self.filter = Filter::parse(text)?,
            "mode" => self.mode = Mode::parse(text)?,
            "depth" => self.depth = DepthBuffer::parse(text)?,
            "cull" => self.cull = true,
            "wire" => self.wire = true,
            "background" => self.background = Some(color(text)?),
            "light" => self.light.push(lamp(text)?),
            "ambient" => self.ambient = Some(part(text)?),
            "fog" => self.fog = Some(haze(text)?),
            "color" => self.color = Color::parse(text)?,
            "size" => self.size = size(text)?,
            "bands" => self.bands = Some(whole(text, u32::MAX)?),
            "frames" => self.frames = whole(text, 10_000)?,
            "out" => self.out = path(),
            "dump" => self.dump = path(),
            "crc" => self.crc = true,
            "quiet" => self.quiet = true,
            "window" => self.window = true,
            "help" => self.help = true,
            "version" => self.version = true,
            _ => return Err("it is not implemented".into()),
        }
        Ok(())
    }

    /// Checks that the arguments fit each other.
    fn check(&self) -> Result<(), String> {
        if self.help || self.version {
            return Ok(());
        }
        if self.scene.is_some() && self.model.is_some() {
            return Err("--scene cannot be used with a model".into());
        }
        for (name, _) in &self.given {
            if self.scene.is_some() && !WITH_SCENE.contains(name) {
                return Err(format!(
                    "--{name} cannot be used with --scene: a measured scene keeps its camera, look and size; \
                     leave out --scene, or draw a model"
                ));
            }
            let other = WITH_MODEL.iter().find(|(other, _)| other == name);
            if let (Some((_, why)), None) = (other, &self.model) {
                return Err(format!("--{name} needs a model: {why}"));
            }
        }
        Ok(())
    }

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

/// The message about an option that does not exist. It names a similar option, if there is one.
fn unknown(wanted: &str) -> String {
    let distance = |name: &str| strsim::damerau_levenshtein(name, wanted);
    let nearest = options()
        .map(|(name, _)| name)
        .min_by_key(|name| distance(name));
    let similar = match nearest.filter(|name| distance(name) <= 2) {
        Some(name) => format!(": did you mean --{name}?"),
        None => String::new(),
    };
    format!("there is no option --{wanted}{similar}")
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

fn whole(text: &str, most: u32) -> Result<u32, String> {
    match text.trim().parse() {
        Ok(number) if (1..=most).contains(&number) => Ok(number),
        _ => Err(format!("it must be a whole number from 1 to {most}")),
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
