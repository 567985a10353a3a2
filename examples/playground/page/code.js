// The program that draws what is seen.
import { FORMATS, MODES } from "./scenes.js";

// A decimal that the crate rounds to the same number of units of 2^-16.
const decimal = (bits) => String(+(bits / 65536).toFixed(6));
const fx = (bits) => `fx!(${decimal(bits)})`;
const angle = (bits) => `Angle::from_bits(${bits >>> 0})`;
const list = (names) => (names.length > 1 ? `{${names.join(", ")}}` : names[0]);
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

/** Of each scene: imports, statics, and how it is shaded. */
const BODIES = {
  floor: {
    mesh: "FLOOR",
    shader: "Textured::new(&SKIN)",
    statics: `
static POSITIONS: [Vec3; 4] = [vec3!(-10, 0, -1), vec3!(10, 0, -1), vec3!(10, 0, -20), vec3!(-10, 0, -20)];
static UVS: [Vec2; 4] = [vec2!(0, 1), vec2!(1, 1), vec2!(1, 0), vec2!(0, 0)];
static FLOOR: Mesh = match Mesh::new(&POSITIONS, &[[0, 1, 2], [0, 2, 3]]) {
    Ok(mesh) => Mesh::checked(mesh.with_uvs(&UVS, None)),
    error => Mesh::checked(error),
};${CHECKER}`,
  },
  cube: {
    mesh: "CUBE",
    shader: "Textured::new(&SKIN)",
    statics: `
static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));${CHECKER}`,
  },
  sphere: {
    mesh: "scenes::SPHERE",
    shader: "scenes::shaded()",
    statics: `
mod scenes; // examples/common/scenes.rs of fixel, which colors the sphere at compile time`,
  },
  "sphere-flat": {
    mesh: "scenes::SPHERE",
    shader: "scenes::faceted()",
    statics: `
mod scenes; // examples/common/scenes.rs of fixel, which colors the sphere at compile time`,
  },
  own: {
    mesh: "MODEL",
    shader: "Textured::new(&SKIN).lit(sun)",
    statics: `
static MODEL: Mesh = include_obj!("model.obj"); // with normals
static SKIN: Texture<Rgb565> = include_bmp!("skin.bmp");`,
  },
};

const START = { lighthouse: "examples/common/lighthouse.rs", world: "examples/common/world" };

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

/** The program for a scene and the module's settings; of the state, the display's format, a band's rows and the model. */
export function program(scene, view, { format, rows, model }) {
  const { type } = FORMATS[format];
  if (START[scene.id]) return filed(scene, view, type);
  const body = BODIES[scene.id];
  const mode = view.mode === 2 ? `Fast::within(${fx(view.tolerance)})` : MODES[view.mode];
  const depth = scene.id !== "sphere-flat";
  const own = scene.id === "own";
  // The scenes' own file names its colors itself.
  const colors = [...new Set([...(body.statics.includes("mod scenes") ? [] : ["Rgb565"]), type])].sort();
  const traits = body.statics.includes("CSS_") ? ["WebColors"] : [];
  const bits = type !== "Rgb565";
  const shader = body.shader + (bits ? ".converted()" : "");
  const black =
    { Rgb565: "Rgb565::new(0, 0, 0)", Rgb555: "Rgb555::new(0, 0, 0)", BinaryColor: "BinaryColor::Off" }[type] ??
    `${type}::new(0)`;
  return `use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::${list([...colors, ...traits])};
use fixel::mode::${MODES[view.mode]};
use fixel::prelude::*;
${body.statics}${own && model?.fit ? moved(model.fit) : ""}

const WIDTH: u32 = ${view.width};
const HEIGHT: u32 = ${view.height};
const ROWS: u32 = ${rows}; // of a band

pub fn draw<T: DrawTarget<Color = ${type}>>(display: &mut T) -> Result<(), Error> {
    let projection = Projection::perspective(
        ${angle(view.fov)}, (WIDTH, HEIGHT), ${fx(view.near)}, ${fx(view.far)})?;
    let camera = ${camera(view)};
    let mvp = projection * camera * Transform::scale(${fx(view.scale)});
    let options = DrawOptions::new().with_mode(${mode})${view.is_two_sided ? ".with_cull(Cull::Nothing)" : ""};
${own ? "    let sun = Light::new(vec3!(2, 3, 4), fx!(0.35), fx!(0.65))?;\n" : ""}
    let mut colors = [${black}; (WIDTH * ROWS) as usize];
${depth ? "    let mut depths = [0; (WIDTH * ROWS) as usize];\n" : ""}    for first_row in (0..HEIGHT).step_by(ROWS as usize) {
        let pixels = (WIDTH * ROWS.min(HEIGHT - first_row)) as usize; // the last band may be shorter
        let mut band = Canvas::band(&mut colors[..pixels], WIDTH, HEIGHT, first_row)?${
          depth ? "\n            .with_depth(&mut depths[..pixels])?" : ""
        };
        band.clear(${black});
        band.draw_with(&options, &${body.mesh}, &mvp, &${shader});
        if band.show(display).is_err() {
            break; // the display's own error
        }
    }
    Ok(())
}
`;
}

/** How to make the file that the page drew. */
const moved = ({ center, radius }) => `
// The page moved and scaled the model for the range of the crate's numbers: of each v,
// (x, y, z) became ((x, y, z) - (${center.join(", ")})) / ${radius}.`;

/** A scene that is a file of the project. */
function filed(scene, view, type) {
  const size = `const WIDTH: u32 = ${view.width};\nconst HEIGHT: u32 = ${view.height};`;
  const imports = (colors) => `use embedded_graphics::pixelcolor::${colors};
use fixel::prelude::*;

// ${START[scene.id]} of fixel.
mod ${scene.id};

${size}
`;
  if (scene.id === "world")
    return `${imports("Rgb565")}
pub fn draw(colors: &mut [Rgb565], depths: &mut [u16]) -> Result<(), Error> {
    let mut canvas = Canvas::new(colors, WIDTH, HEIGHT)?.with_depth(depths)?;
    world::draw(&mut canvas, ${angle(view.moment)})
}
`;
  const mode = view.mode === 2 ? `Fast::within(${fx(view.tolerance)})` : MODES[view.mode];
  const eye = view.is_home ? "lighthouse::camera()?" : camera(view);
  return `${imports(type).replace("use fixel::prelude", `use fixel::mode::${MODES[view.mode]};\nuse fixel::prelude`)}
pub fn draw(colors: &mut [${type}], depths: &mut [u16]) -> Result<(), Error> {
    let projection = Projection::perspective(
        ${angle(view.fov)}, (WIDTH, HEIGHT), ${fx(view.near)}, ${fx(view.far)})?;
    let camera = ${eye};
    let options = DrawOptions::new().with_mode(${mode});
    let mut canvas = Canvas::new(colors, WIDTH, HEIGHT)?.with_depth(depths)?;
    lighthouse::sky(&mut canvas);
    lighthouse::draw(&mut canvas, &options, &(projection * camera * Transform::IDENTITY))?;
    lighthouse::caption(&mut canvas);
    Ok(())
}
`;
}
