// The program that draws the picture.
import { FORMATS, MODES } from "./scenes.js";

// A decimal that the crate rounds to the same number of units of 2^-16.
const decimal = (bits) => String(+(bits / 65536).toFixed(6));
const fx = (bits) => `fx!(${decimal(bits)})`;
const angle = (bits) => `Angle::from_bits(${bits >>> 0})`;
const vec3 = (...bits) => `vec3!(${bits.map(decimal).join(", ")})`;

const CHECKER = `
/// 64x64 texels, squares of 8 in two colors.
static SKIN: TextureArray<Rgb565, 64, 64> = {
    let mut texels = [[Rgb565::CSS_IVORY; 64]; 64];
    let mut at = 0;
    while at < 64 * 64 {
        if (at / 512 + at / 8) % 2 == 1 {
            texels[at / 64][at % 64] = Rgb565::CSS_STEEL_BLUE;
        }
        at += 1;
    }
    TextureArray::from_texels(texels)
};`;

/** For each scene: its parts, and how it is drawn. Colors are those of the texture; `to` converts them. */
const BODIES = {
  floor: {
    colors: ["Rgb565", "WebColors"],
    statics: `
static POSITIONS: [Vec3; 4] = [vec3!(-10, 0, -1), vec3!(10, 0, -1), vec3!(10, 0, -20), vec3!(-10, 0, -20)];
static UVS: [Vec2; 4] = [vec2!(0, 1), vec2!(1, 1), vec2!(1, 0), vec2!(0, 0)];
static FLOOR: Mesh = match Mesh::new(&POSITIONS, &[[0, 1, 2], [0, 2, 3]]) {
    Ok(mesh) => Mesh::checked(mesh.with_uvs(&UVS, None)),
    error => Mesh::checked(error),
};${CHECKER}`,
    draw: (to) => `draw_with(&options, &FLOOR, &mvp, &Textured::new(&SKIN)${to})`,
  },
  cube: {
    colors: ["Rgb565", "WebColors"],
    statics: `
static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));${CHECKER}`,
    draw: (to) => `draw_with(&options, &CUBE, &mvp, &Textured::new(&SKIN)${to})`,
  },
  sphere: {
    statics: `
mod scenes; // examples/common/scenes.rs of fixel, which colors the sphere at compile time`,
    draw: (to) => `draw_with(&options, &scenes::SPHERE, &mvp, &scenes::shaded()${to})`,
  },
  "sphere-flat": {
    statics: `
mod scenes; // examples/common/scenes.rs of fixel, which colors the sphere at compile time`,
    draw: (to) => `draw_with(&options, &scenes::SPHERE, &mvp, &scenes::faceted()${to})`,
  },
  lighthouse: {
    statics: `
mod lighthouse; // examples/common/lighthouse.rs of fixel`,
    all: () => `lighthouse::sky(&mut band);
        lighthouse::draw(&mut band, &options, &mvp)?;
        lighthouse::caption(&mut band);`,
  },
  own: {
    colors: ["Rgb565"],
    statics: `
static MODEL: Mesh = include_obj!("model.obj"); // with normals
static SKIN: Texture<Rgb565> = include_bmp!("skin.bmp");`,
    setup: `
    let sun = Light::new(vec3!(2, 3, 4), fx!(0.35), fx!(0.65))?;`,
    draw: (to) => `draw_with(&options, &MODEL, &mvp, &Textured::new(&SKIN).lit(sun)${to})`,
  },
  world: {
    statics: `
mod world; // examples/common/world of fixel`,
    all: (view) => `world::draw(&mut band, ${angle(view.moment)})?;`,
  },
};

/** The camera as `View::mvp` places it. */
function camera(view) {
  const shift =
    view.shift_x || view.shift_y
      ? `Transform::rotate_x(${angle(view.shift_y)})
            * Transform::rotate_y(${angle(view.shift_x)})
            * `
      : "";
  return `Camera::from_view(
        ${shift}Transform::translate(${vec3(0, 0, -view.distance)})
            * Transform::rotate_x(${angle(view.pitch)})
            * Transform::rotate_y(${angle(view.yaw)})
            * Transform::translate(${vec3(-view.center_x, -view.center_y, -view.center_z)}),
    )`;
}

/** How to make the file that the page drew. */
const moved = ({ center, radius }) => `
// The page moved and scaled the model for the range of the crate's numbers: of each v,
// (x, y, z) became ((x, y, z) - (${center.join(", ")})) / ${radius}.`;

/** The camera, and how triangles are drawn. */
function options(scene, view) {
  const mode = view.mode === 2 ? `Fast::within(${fx(view.tolerance)})` : MODES[view.mode];
  const isHome = scene.id === "lighthouse" && view.is_home;
  return `    let projection = Projection::perspective(
        ${angle(view.fov)}, (WIDTH, HEIGHT), ${fx(view.near)}, ${fx(view.far)})?;
    let camera = ${isHome ? "lighthouse::camera()?" : camera(view)};
    let mvp = projection * camera * Transform::scale(${fx(view.scale)});
    let options = DrawOptions::new().with_mode(${mode})${view.is_two_sided ? ".with_cull(Cull::Nothing)" : ""};`;
}

/** The program for a scene, the module's settings, a display's format, a band's rows and the model. */
export function program(scene, view, { format, rows, model }) {
  const { colors = [], statics, setup = "", draw, all } = BODIES[scene.id];
  const { type, black } = FORMATS[format];
  const names = [...new Set([...colors, type])].sort().join(", ");
  const depth = scene.id !== "sphere-flat";
  const to = type === "Rgb565" ? "" : ".converted()";
  const body = all ? all(view) : `band.clear(${black});\n        band.${draw(to)};`;
  return `use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::${names.includes(",") ? `{${names}}` : names};
${scene.is_world ? "" : `use fixel::mode::${MODES[view.mode]};\n`}use fixel::prelude::*;
${statics}${scene.id === "own" && model?.fit ? moved(model.fit) : ""}

const WIDTH: u32 = ${view.width};
const HEIGHT: u32 = ${view.height};
const ROWS: u32 = ${rows}; // of a band

pub fn draw<T: DrawTarget<Color = ${type}>>(display: &mut T) -> Result<(), Error> {
${scene.is_world ? "" : `${options(scene, view)}${setup}\n\n`}    let mut colors = [${black}; (WIDTH * ROWS) as usize];
${depth ? "    let mut depths = [0; (WIDTH * ROWS) as usize];\n" : ""}    for first_row in (0..HEIGHT).step_by(ROWS as usize) {
        let pixels = (WIDTH * ROWS.min(HEIGHT - first_row)) as usize; // the last band may be shorter
        let mut band = Canvas::band(&mut colors[..pixels], WIDTH, HEIGHT, first_row)?${
          depth ? "\n            .with_depth(&mut depths[..pixels])?" : ""
        };
        ${body}
        if band.show(display).is_err() {
            break; // the display's own error
        }
    }
    Ok(())
}
`;
}
