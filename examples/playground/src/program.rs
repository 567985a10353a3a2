//! The text of a program that draws the picture.

use core::fmt::{self, Write};

use fixel::prelude::*;

use super::model::{Look, Model};
use super::scene::Scene;
use super::view::View;

pub type Text = heapless::String<8192>;

/// Names of modes and of displays' colors in the module's order; and how a display's black is written.
const MODES: [&str; 5] = ["Exact", "Newton", "Fast", "Affine", "Compact"];
const FORMATS: [[&str; 2]; 6] = [
    ["Rgb565", "Rgb565::new(0, 0, 0)"],
    ["Rgb555", "Rgb555::new(0, 0, 0)"],
    ["Gray8", "Gray8::new(0)"],
    ["Gray4", "Gray4::new(0)"],
    ["Gray2", "Gray2::new(0)"],
    ["BinaryColor", "BinaryColor::Off"],
];

const CHECKER: &str = "
/// 64x64 texels, squares of 8 in two colors.
static SKIN: [[Rgb565; 64]; 64] = {
    let mut texels = [[Rgb565::CSS_IVORY; 64]; 64];
    let mut at = 0;
    while at < 64 * 64 {
        if (at / 512 + at / 8) % 2 == 1 {
            texels[at / 64][at % 64] = Rgb565::CSS_STEEL_BLUE;
        }
        at += 1;
    }
    texels
};
";

const FLOOR: &str = "
static POSITIONS: [Vec3; 4] = [vec3!(-10, 0, -1), vec3!(10, 0, -1), vec3!(10, 0, -20), vec3!(-10, 0, -20)];
static UVS: [Vec2; 4] = [vec2!(0, 1), vec2!(1, 1), vec2!(1, 0), vec2!(0, 0)];
static FLOOR: Mesh = match Mesh::new(&POSITIONS, &[[0, 1, 2], [0, 2, 3]]) {
    Ok(mesh) => Mesh::checked(mesh.with_uvs(&UVS, None)),
    error => Mesh::checked(error),
};
";

const CUBE: &str = "
static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
";

const SPHERE: &str = "
mod scenes; // examples/common/scenes.rs of fixel, which colors the sphere at compile time
";

/// The texture of a model that has none.
const PLAIN: &str =
    "static SKIN: Texture<Rgb565> = Texture::from_rows(&[[Rgb565::new(26, 53, 26)]]);

";

/// The imports of colors beside the display's, and the statics.
fn head(scene: Scene) -> [&'static str; 3] {
    match scene {
        Scene::Floor => ["Rgb565, WebColors", FLOOR, CHECKER],
        Scene::Cube => ["Rgb565, WebColors", CUBE, CHECKER],
        Scene::Sphere | Scene::SphereFlat => ["", SPHERE, ""],
        Scene::Lighthouse => [
            "",
            "\nmod lighthouse; // examples/common/lighthouse of fixel\n",
            "",
        ],
        Scene::Own => ["Rgb565", "", ""], // see `own`
        Scene::World => ["", "\nmod world; // examples/common/world of fixel\n", ""],
    }
}

/// The mesh and the shader that a band is drawn with; `None` for a scene that draws itself.
fn drawing(scene: Scene, model: &Model) -> Option<[&'static str; 2]> {
    Some(match scene {
        Scene::Floor => ["FLOOR", "Textured::new(&SKIN)"],
        Scene::Cube => ["CUBE", "Textured::new(&SKIN)"],
        Scene::Sphere => ["scenes::SPHERE", "scenes::shaded()"],
        Scene::SphereFlat => ["scenes::SPHERE", "scenes::faceted()"],
        Scene::Own => {
            let shader = match model.look() {
                Look::Plain | Look::Texture => "Textured::new(SKIN).lit(sun)",
                Look::TintedTexture => "Textured::new(SKIN).tinted().lit(sun)",
                Look::Parts => "PartColors::rgb::<Rgb565>(PARTS).lit(sun)",
                Look::TintedParts => "PartColors::rgb::<Rgb565>(PARTS).tinted().lit(sun)",
                Look::Corners => "Gouraud::<Rgb565>::new().lit(sun)",
            };
            ["MODEL", shader]
        }
        Scene::Lighthouse | Scene::World => return None,
    })
}

/// The statics of the user's model, whose files the macros read.
fn own(model: &Model, to: &mut Text) -> fmt::Result {
    let [mesh, texture] = &model.calls;
    let mesh = if mesh.is_empty() {
        "\"model.obj\""
    } else {
        mesh.as_str()
    };
    let look = model.look();
    let uvs = match look {
        Look::Texture | Look::TintedTexture if !model.has_uvs => ", uvs",
        _ => "",
    };
    writeln!(to, "static MODEL: Mesh = include_mesh!({mesh}{uvs});")?;
    match look {
        Look::Plain => to.write_str(PLAIN),
        Look::Texture | Look::TintedTexture => writeln!(
            to,
            "static SKIN: Texture<Rgb565> = include_texture!({texture});\n"
        ),
        Look::Parts | Look::TintedParts => {
            // The options after the name contain no quotation marks.
            let name = mesh.rfind('"').map_or(mesh, |end| &mesh[..=end]);
            writeln!(to, "static PARTS: &[Part] = include_materials!({name});\n")
        }
        Look::Corners => writeln!(to),
    }
}

/// Writes the program for a view.
///
/// # Errors
///
/// The text has no room for it.
pub fn write(view: &View, model: &Model, to: &mut Text) -> fmt::Result {
    let is_world = view.scene == Scene::World;
    let format = (view.format as usize).min(FORMATS.len() - 1);
    let [color, black] = FORMATS[if is_world { 0 } else { format }];
    let [colors, mesh, texture] = head(view.scene);
    let has_parts =
        view.scene == Scene::Own && matches!(model.look(), Look::Parts | Look::TintedParts);
    let [part, part_colors] = if has_parts {
        [
            "use fixel::mesh::Part;\n",
            "use fixel::shade::PartColors;\n",
        ]
    } else {
        [""; 2]
    };

    writeln!(to, "use embedded_graphics::draw_target::DrawTarget;")?;
    match colors.split_once(color) {
        _ if colors.is_empty() => writeln!(to, "use embedded_graphics::pixelcolor::{color};")?,
        Some(("", "")) => writeln!(to, "use embedded_graphics::pixelcolor::{color};")?,
        Some(_) => writeln!(to, "use embedded_graphics::pixelcolor::{{{colors}}};")?,
        None => writeln!(
            to,
            "use embedded_graphics::pixelcolor::{{{color}, {colors}}};"
        )?,
    }
    writeln!(
        to,
        "{part}use fixel::mode::{};\nuse fixel::prelude::*;\n{part_colors}{mesh}{texture}",
        Mode(view).name()
    )?;
    if view.scene == Scene::Own {
        own(model, to)?;
    }
    writeln!(to, "const WIDTH: u32 = {};", view.size.width)?;
    writeln!(to, "const HEIGHT: u32 = {};", view.size.height)?;
    writeln!(to, "const ROWS: u32 = {}; // of a band\n", view.band)?;
    writeln!(
        to,
        "pub fn draw<T: DrawTarget<Color = {color}>>(display: &mut T) -> Result<(), Error> {{"
    )?;
    if !is_world {
        options(view, to)?;
    }
    let depth = view.scene.has_depth();
    writeln!(
        to,
        "    let mut colors = [{black}; (WIDTH * ROWS) as usize];"
    )?;
    if depth {
        writeln!(to, "    let mut depths = [0; (WIDTH * ROWS) as usize];")?;
    }
    to.write_str("    for first_row in (0..HEIGHT).step_by(ROWS as usize) {
        let pixels = (WIDTH * ROWS.min(HEIGHT - first_row)) as usize; // the last band may be shorter
        let mut band = Canvas::band(&mut colors[..pixels], WIDTH, HEIGHT, first_row)?")?;
    if depth {
        to.write_str("\n            .with_depth(&mut depths[..pixels])?")?;
    }
    to.write_str(";\n")?;
    match drawing(view.scene, model) {
        Some([mesh, shader]) => {
            let converted = if color == "Rgb565" {
                ""
            } else {
                ".converted()"
            };
            writeln!(to, "        band.clear({black});")?;
            writeln!(
                to,
                "        band.draw_with(&options, &{mesh}, &mvp, &{shader}{converted});"
            )?;
        }
        None if is_world => {
            let (mode, moment) = (Mode(view), Degrees(view.yaw));
            writeln!(to, "        world::draw(&mut band, {mode}, {moment})?;")?;
        }
        None => to.write_str(
            "        lighthouse::sky(&mut band);
        lighthouse::draw(&mut band, &options, &mvp)?;
        lighthouse::caption(&mut band);\n",
        )?,
    }
    to.write_str(
        "        if band.show(display).is_err() {
            break; // the display's own error
        }
    }
    Ok(())
}\n",
    )
}

/// The mode of a view, as an expression.
struct Mode<'a>(&'a View);

impl Mode<'_> {
    fn name(&self) -> &'static str {
        MODES[(self.0.mode as usize).min(MODES.len() - 1)]
    }
}

impl fmt::Display for Mode<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.name() {
            "Fast" => write!(to, "Fast::within(fx!({}))", self.0.tolerance),
            "Newton" => to.write_str("Newton::default()"),
            name => to.write_str(name),
        }
    }
}

/// The shortest decimal of degrees, from -180 to 180, that `deg!` rounds to an angle.
struct Degrees(Angle);

impl fmt::Display for Degrees {
    #[allow(clippy::cast_precision_loss)] // of whole numbers below 2^35
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let degrees = f64::from(self.0.to_bits().cast_signed()) / 4_294_967_296.0 * 360.0;
        let mut scale = 1;
        // With eight digits, steps are smaller than an angle's.
        for digits in 0..=8 {
            let steps = libm::round(degrees * scale as f64) as i64;
            if digits == 8 || Angle::try_from_degrees(steps as f64 / scale as f64) == Ok(self.0) {
                let sign = if steps < 0 { "-" } else { "" };
                let [whole, rest] = [steps.abs() / scale, steps.abs() % scale];
                return match digits {
                    0 => write!(to, "deg!({sign}{whole})"),
                    _ => write!(to, "deg!({sign}{whole}.{rest:0digits$})"),
                };
            }
            scale *= 10;
        }
        Ok(())
    }
}

/// The camera's transform as `View::mvp` multiplies it, without the factors that change nothing.
fn camera(view: &View, to: &mut Text) -> fmt::Result {
    let View {
        yaw,
        pitch,
        shift: [right, down],
        ..
    } = *view;
    let distance = -view.distance;
    let Vec3 { x, y, z } = -view.center;
    let mut factors = 0;
    let mut factor = |changes: bool, text: fmt::Arguments<'_>| {
        if !changes {
            return Ok(());
        }
        factors += 1;
        let before = if factors == 1 { "" } else { "\n            * " };
        write!(to, "{before}Transform::{text}")
    };
    let turns = |angle| angle != Angle::ZERO;
    factor(turns(down), format_args!("rotate_x({})", Degrees(down)))?;
    factor(turns(right), format_args!("rotate_y({})", Degrees(right)))?;
    factor(
        distance != fx!(0),
        format_args!("translate(vec3!(0, 0, {distance}))"),
    )?;
    factor(turns(pitch), format_args!("rotate_x({})", Degrees(pitch)))?;
    factor(turns(yaw), format_args!("rotate_y({})", Degrees(yaw)))?;
    factor(
        view.center != Vec3::ZERO,
        format_args!("translate(vec3!({x}, {y}, {z}))"),
    )?;
    if factors == 0 {
        to.write_str("Transform::IDENTITY")?;
    }
    Ok(())
}

/// The camera, and how triangles are drawn.
fn options(view: &View, to: &mut Text) -> fmt::Result {
    let View {
        near, far, scale, ..
    } = view;
    let fov = Degrees(view.fov);
    writeln!(
        to,
        "    let projection = Projection::perspective({fov}, (WIDTH, HEIGHT), fx!({near}), fx!({far}))?;"
    )?;
    if view.scene == Scene::Lighthouse && view.is_home {
        writeln!(to, "    let camera = lighthouse::camera()?;")?;
    } else {
        to.write_str("    let camera = Camera::from_view(\n        ")?;
        camera(view, to)?;
        to.write_str(",\n    );\n")?;
    }
    to.write_str("    let mvp = projection * camera")?;
    if *scale != fx!(1) {
        write!(to, " * Transform::scale(fx!({scale}))")?;
    }
    to.write_str(";\n")?;
    let cull = if view.is_two_sided {
        ".with_cull(Cull::Nothing)"
    } else {
        ""
    };
    let mode = Mode(view);
    writeln!(
        to,
        "    let options = DrawOptions::new().with_mode({mode}){cull};"
    )?;
    if view.scene == Scene::Own {
        writeln!(
            to,
            "    let sun = Light::new(vec3!(2, 3, 4), fx!(0.35), fx!(0.65))?;"
        )?;
    }
    writeln!(to)
}
