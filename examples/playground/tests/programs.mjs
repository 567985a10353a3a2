// Writes the programs that the page prints, for many settings, as a package that draws them all and compares each
// picture with the page's. PAGE is the folder with the page; the argument is the package's folder.
import { cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { crate, drop, page, view } from "./page.mjs";

const { MODES, OWN, WORLD } = await page("module.js");
const FORMATS = ["Rgb565", "Rgb555", "Gray8", "Gray4", "Gray2", "BinaryColor"];
const SIZES = ["128x64", "128x128", "160x128", "240x240", "320x240", "480x320", "640x480"];

const root = resolve(fileURLToPath(import.meta.url), "../../../..");
const out = resolve(process.argv[2]);
const sources = join(out, "src");
mkdirSync(sources, { recursive: true });

// A roof with a floor, off the origin and too large for the crate's numbers, and a texture of its own, which is not a
// power of two wide.
const CORNERS = [[3, 1, 4], [5, 1, 4], [5, 1, 2], [3, 1, 2], [4, 3, 3]];
const OBJ = `${CORNERS.map((at) => `v ${at.map((x) => x * 20000).join(" ")}`).join("\n")}
vt 0 0\nvt 1 0\nvt 0.5 1\nvn 0 1 2\nvn 2 1 0\nvn 0 1 -2\nvn -2 1 0\nvn 0 -1 0
f 1/1/1 2/2/1 5/3/1\nf 2/1/2 3/2/2 5/3/2\nf 3/1/3 4/2/3 5/3/3\nf 4/1/4 1/2/4 5/3/4\nf 4/1/5 3/2/5 2/3/5 1/1/5\n`;
/** A BMP file of 24 bits a pixel: rows from the lowest up, blue first. */
function bitmap(width, height) {
  const head = Buffer.alloc(54);
  head.write("BM");
  const fields = [[54 + 3 * width * height, 2], [54, 10], [40, 14], [width, 18], [height, 22]];
  for (const [value, at] of fields) head.writeUInt32LE(value, at);
  head.writeUInt16LE(1, 26);
  head.writeUInt16LE(24, 28);
  // Noise: in a large picture, nearly every texel has a color of its own.
  const texels = Buffer.from(Array.from({ length: 3 * width * height }, (_, at) => Math.imul(at + 1, 0x9e3779b1) >>> 24));
  return Buffer.concat([head, texels]);
}
/** Drops a model and a texture, which the programs include, too. */
function dropped(files) {
  for (const [name, contents] of Object.entries(files)) writeFileSync(join(sources, name), contents);
  return drop(files);
}

/** FNV-1a of red, green and blue. */
function hash({ data }) {
  let found = 0x811c9dc5;
  data.forEach((byte, at) => {
    if (at % 4 < 3) found = Math.imul(found ^ byte, 0x01000193);
  });
  return found >>> 0;
}

const CAMERAS = [{}, { yaw: 40, pitch: 30 }, { yaw: -60, right: 0.3, down: 0.7 }, { fov: 137, near: -3, far: Math.log2(3000) }];
const list = [];
function add(index, changes) {
  const settings = view(index, changes);
  const number = `p${String(list.length).padStart(2, "0")}`;
  const text = crate.program(settings);
  // The project's own scenes are there once for all.
  writeFileSync(join(sources, `${number}.rs`), text.replace(/^mod (\w+);/m, "use crate::$1;"));
  const { width, height, mode } = settings;
  const format = FORMATS[settings.format];
  const about = `scene ${index}, ${MODES[mode]}, ${format}, ${width}x${height}`;
  crate.draw(settings, 0);
  list.push(`    ${number} ${format} ${width} ${height} ${hash(crate.image("show", settings, 0))}_u32 "${about}";`);
}
await dropped({ "model.obj": OBJ, "skin.bmp": bitmap(20, 16) });
for (let index = 0; index < WORLD; index++) {
  // As it is measured.
  add(index, {});
  for (const mode of MODES.keys()) {
    const at = list.length;
    add(index, {
      mode,
      ...CAMERAS[at % CAMERAS.length],
      size: SIZES[at % SIZES.length],
      format: (index + mode + 1) % FORMATS.length,
      band: [8, 16, 32][at % 3],
      tolerance: [-6, -2, 4][at % 3],
      is_two_sided: index === OWN && mode % 2 === 0,
    });
  }
}
for (const yaw of [0, 54, 216]) add(WORLD, { yaw });
const mtl = "newmtl roof\nKd 0.8 0.2 0.1\nnewmtl floor\nKd 0.3 0.3 0.6\n";
const painted = `mtllib house.mtl\n${OBJ.replace("f 1/1/1", "usemtl roof\nf 1/1/1").replace("f 4/1/5", "usemtl floor\nf 4/1/5")}`;
await dropped({ "house.mtl": mtl, "house.obj": painted });
for (const format of [0, 2]) add(OWN, { format, pitch: -20 });
// A picture for a model without texture coordinates.
await dropped({ "bare.obj": OBJ.replace(/^v[tn].*\n/gm, "").replace(/\/\d+\/\d+/g, ""), "bare.bmp": bitmap(64, 64) });
add(OWN, { pitch: -20 });
// Models far from the origin: 0.01 wide, and of a millionth of a unit.
for (const [name, scale, shift] of [["far", 0.005, [20000, -7, 300]], ["tiny", 4e-7, [0, 0, 1e-6]]]) {
  const moved = CORNERS.map((at) => `v ${at.map((x, axis) => x * scale + shift[axis]).join(" ")}`).join("\n");
  await dropped({ [`${name}.obj`]: OBJ.replace(/(v .*\n)+/, `${moved}\n`), [`${name}.bmp`]: bitmap(64, 64) });
  add(OWN, {});
}
// Colors of vertices: alone, with materials, and with a texture.
const COLORS = ["1 0 0", "0 1 0", "0 0 1", "1 1 0", "0.2 0.6 1"];
const vertices = OBJ.split("\n").map((line, at) => (line.startsWith("v ") ? `${line} ${COLORS[at]}` : line)).join("\n");
await dropped({ "vertices.obj": vertices });
for (const mode of MODES.keys()) add(OWN, { mode, format: mode, ...CAMERAS[mode % 3] });
const both = vertices.replace("f 1/1/1", "usemtl roof\nf 1/1/1").replace("f 4/1/5", "usemtl floor\nf 4/1/5");
await dropped({ "house.mtl": mtl, "both.obj": `mtllib house.mtl\n${both}` });
for (const format of [0, 2]) add(OWN, { format, pitch: -20 });
await dropped({ "vertices.obj": vertices, "skin.bmp": bitmap(20, 16) });
for (const format of [0, 1]) add(OWN, { format });
// Names with quotation marks, and with letters that macOS takes apart.
await dropped({ 'a "large" model.obj': OBJ, "scha\u0308del.bmp": bitmap(1024, 1024) });
add(OWN, {});

writeFileSync(join(sources, "list.rs"), `programs! {\n${list.join("\n")}\n}\n`);
for (const scene of ["scenes.rs", "lighthouse", "world"])
  cpSync(join(root, "examples/common", scene), join(sources, scene), { recursive: true });
cpSync(join(root, "examples/assets"), join(out, "assets"), { recursive: true });
cpSync(join(root, "examples/playground/tests/programs/draw.rs"), join(sources, "main.rs"));
// The versions of the project's own build, if there was one.
try {
  writeFileSync(join(out, "Cargo.lock"), readFileSync(join(root, "Cargo.lock")));
} catch {
  // Cargo chooses.
}
writeFileSync(
  join(out, "Cargo.toml"),
  `[package]
name = "programs"
edition = "2024"

[dependencies]
embedded-graphics = { version = "0.8", default-features = false }
fixel.path = ${JSON.stringify(root)}

[profile.dev]
opt-level = 1
debug = false

[workspace]
`,
);
