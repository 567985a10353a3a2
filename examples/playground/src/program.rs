//! The text of a program that draws the picture.

use core::fmt::{self, Write};

use fixel::prelude::*;

use super::model::{Call, Model};
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
            "\nmod lighthouse; // examples/common/lighthouse.rs of fixel\n",
            "",
        ],
        Scene::Own => ["Rgb565", "", ""], // see `own`
        Scene::World => ["", "\nmod world; // examples/common/world of fixel\n", ""],
    }
}

/// The mesh and the shader that a band is drawn with; `None` for a scene that draws itself.
fn drawing(scene: Scene) -> Option<[&'static str; 2]> {
    Some(match scene {
        Scene::Floor => ["FLOOR", "Textured::new(&SKIN)"],
        Scene::Cube => ["CUBE", "Textured::new(&SKIN)"],
        Scene::Sphere => ["scenes::SPHERE", "scenes::shaded()"],
        Scene::SphereFlat => ["scenes::SPHERE", "scenes::faceted()"],
        Scene::Own => ["MODEL", "Textured::new(SKIN).lit(sun)"],
        Scene::Lighthouse | Scene::World => return None,
    })
}

/// The statics of the user's model, whose files the macros read.
fn own(calls: &[Call; 2], to: &mut Text) -> fmt::Result {
    let [mesh, texture] = calls;
    let mesh = if mesh.is_empty() {
        "\"model.obj\""
    } else {
        mesh
    };
    writeln!(to, "static MODEL: Mesh = include_mesh!({mesh});")?;
    if texture.is_empty() {
        return to.write_str(PLAIN);
    }
    writeln!(
        to,
        "static SKIN: Texture<Rgb565> = include_texture!({texture});\n"
    )
}

/// Writes the program for a view.
///
/// # Errors
///
/// The text has no room for it.
pub fn write(view: &View, model: &Model, to: &mut Text) -> fmt::Result {
    let is_world = view.scene == Scene::World;
    let mode = MODES[(view.mode as usize).min(MODES.len() - 1)];
    let format = (view.format as usize).min(FORMATS.len() - 1);
    let [color, black] = FORMATS[if is_world { 0 } else { format }];
    let [colors, mesh, texture] = head(view.scene);

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
    if !is_world {
        writeln!(to, "use fixel::mode::{mode};")?;
    }
    writeln!(to, "use fixel::prelude::*;\n{mesh}{texture}")?;
    if view.scene == Scene::Own {
        own(&model.calls, to)?;
    }
    writeln!(to, "const WIDTH: u32 = {};", view.size.width)?;
    writeln!(to, "const HEIGHT: u32 = {};", view.size.height)?;
    writeln!(to, "const ROWS: u32 = {}; // of a band\n", view.band)?;
    writeln!(
        to,
        "pub fn draw<T: DrawTarget<Color = {color}>>(display: &mut T) -> Result<(), Error> {{"
    )?;
    if !is_world {
        options(view, mode, to)?;
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
    match drawing(view.scene) {
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
            let moment = view.yaw.to_bits();
            writeln!(
                to,
                "        world::draw(&mut band, Angle::from_bits({moment}))?;"
            )?;
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

/// The camera as `View::mvp` places it, and how triangles are drawn.
fn options(view: &View, mode: &str, to: &mut Text) -> fmt::Result {
    let View {
        near,
        far,
        distance,
        scale,
        tolerance,
        ..
    } = view;
    let [fov, yaw, pitch] = [view.fov, view.yaw, view.pitch].map(Angle::to_bits);
    let [right, down] = view.shift.map(Angle::to_bits);
    let center = -view.center;
    writeln!(to, "    let projection = Projection::perspective(")?;
    writeln!(
        to,
        "        Angle::from_bits({fov}), (WIDTH, HEIGHT), fx!({near}), fx!({far}))?;"
    )?;
    if view.scene == Scene::Lighthouse && view.is_home {
        writeln!(to, "    let camera = lighthouse::camera()?;")?;
    } else {
        writeln!(to, "    let camera = Camera::from_view(")?;
        to.write_str("        ")?;
        if [right, down] != [0; 2] {
            writeln!(to, "Transform::rotate_x(Angle::from_bits({down}))")?;
            writeln!(
                to,
                "            * Transform::rotate_y(Angle::from_bits({right}))"
            )?;
            to.write_str("            * ")?;
        }
        writeln!(to, "Transform::translate(vec3!(0, 0, {}))", -*distance)?;
        writeln!(
            to,
            "            * Transform::rotate_x(Angle::from_bits({pitch}))"
        )?;
        writeln!(
            to,
            "            * Transform::rotate_y(Angle::from_bits({yaw}))"
        )?;
        let (x, y, z) = (center.x, center.y, center.z);
        writeln!(
            to,
            "            * Transform::translate(vec3!({x}, {y}, {z})),\n    );"
        )?;
    }
    writeln!(
        to,
        "    let mvp = projection * camera * Transform::scale(fx!({scale}));"
    )?;
    write!(to, "    let options = DrawOptions::new().with_mode({mode}")?;
    if mode == "Fast" {
        write!(to, "::within(fx!({tolerance}))")?;
    }
    writeln!(
        to,
        "){};",
        if view.is_two_sided {
            ".with_cull(Cull::Nothing)"
        } else {
            ""
        }
    )?;
    if view.scene == Scene::Own {
        writeln!(
            to,
            "    let sun = Light::new(vec3!(2, 3, 4), fx!(0.35), fx!(0.65))?;"
        )?;
    }
    writeln!(to)
}
