// Writes the programs that the page prints, for many settings, as a package that draws them all and compares each
// picture with the page's. PAGE is the folder with the page; the argument is the package's folder.
import { cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { crate, page, view } from "./page.mjs";

const { program } = await page("code.js");
const { FORMATS, MODES, SCENES, SIZES } = await page("scenes.js");
const { state } = await page("state.js");
const { fitted } = await page("files.js");

const root = resolve(fileURLToPath(import.meta.url), "../../../..");
const out = resolve(process.argv[2]);
const sources = join(out, "src");
mkdirSync(sources, { recursive: true });

// A roof with a floor, off the origin, and a texture of its own.
const OBJ = `v 3 1 4\nv 5 1 4\nv 5 1 2\nv 3 1 2\nv 4 3 3
vt 0 0\nvt 1 0\nvt 0.5 1\nvn 0 1 2\nvn 2 1 0\nvn 0 1 -2\nvn -2 1 0\nvn 0 -1 0
f 1/1/1 2/2/1 5/3/1\nf 2/1/2 3/2/2 5/3/2\nf 3/1/3 4/2/3 5/3/3\nf 4/1/4 1/2/4 5/3/4\nf 4/1/5 3/2/5 2/3/5 1/1/5\n`;
const SIDE = 16;
const texels = Array.from({ length: SIDE * SIDE }, (_, at) => [at, 255 - at, (at * 37) % 256]);
/** A BMP file of 24 bits a pixel: rows from the lowest up, blue first. */
function bitmap() {
  const head = Buffer.alloc(54);
  head.write("BM");
  const fields = [[54 + 3 * texels.length, 2], [54, 10], [40, 14], [SIDE, 18], [SIDE, 22]];
  for (const [value, at] of fields) head.writeUInt32LE(value, at);
  head.writeUInt16LE(1, 26);
  head.writeUInt16LE(24, 28);
  const rows = Array.from({ length: SIDE }, (_, row) => texels.slice(row * SIDE, (row + 1) * SIDE)).reverse();
  return Buffer.concat([head, Buffer.from(rows.flat().flatMap(([r, g, b]) => [b, g, r]))]);
}
writeFileSync(join(sources, "model.obj"), OBJ);
writeFileSync(join(sources, "skin.bmp"), bitmap());
const [x, y, z, radius] = crate.readModel(fitted(new TextEncoder().encode(OBJ)).text);
crate.readTexture({ data: Uint8Array.from(texels.flatMap((rgb) => [...rgb, 255])), width: SIDE, height: SIDE });
const fit = { scale: 1 / radius, center: [x, y, z].map((at) => at / radius) };

/** FNV-1a of red, green and blue. */
function hash({ data }) {
  let found = 0x811c9dc5;
  data.forEach((byte, at) => {
    if (at % 4 < 3) found = Math.imul(found ^ byte, 0x01000193);
  });
  return found >>> 0;
}

const CAMERAS = [{}, { yaw: 0.7, pitch: 0.5 }, { yaw: -1, shift: [0.3, 0.7] }, { fov: 2.4, near: 0.125, far: 3000 }];
const list = [];
function add(index, mode, changes) {
  const { id } = SCENES[index];
  const camera = { ...(id === "own" && fit), ...changes.camera };
  const settings = view(index, mode, { ...changes, camera });
  crate.draw(0, settings);
  const number = `p${String(list.length).padStart(2, "0")}`;
  const text = program(SCENES[index], settings, { ...state, ...changes });
  // The project's own scenes are there once for all.
  writeFileSync(join(sources, `${number}.rs`), text.replace(/^mod (\w+);/m, "use crate::$1;"));
  const format = changes.format ?? 0;
  const about = `${id}, ${MODES[mode]}, ${FORMATS[format].type}, ${settings.width}x${settings.height}`;
  list.push(`    ${number} ${FORMATS[format].type} ${settings.width} ${settings.height} ${hash(crate.shown(0, format))}_u32 "${about}";`);
}
const OWN = SCENES.findIndex(({ id }) => id === "own");
const WORLD = SCENES.findIndex(({ is_world }) => is_world);
for (let index = 0; index < WORLD; index++) {
  // As it is measured.
  add(index, 1, {});
  for (const mode of MODES.keys()) {
    const at = list.length;
    add(index, mode, {
      camera: CAMERAS[at % CAMERAS.length],
      size: SIZES[at % SIZES.length],
      format: (index + mode + 1) % FORMATS.length,
      rows: [8, 16, 32][at % 3],
      tolerance: [0.015625, 0.25, 16][at % 3],
      isTwoSided: index === OWN && mode % 2 === 0,
    });
  }
}
for (const moment of [0, 0.6]) add(WORLD, 1, { camera: { moment } });

writeFileSync(join(sources, "list.rs"), `programs! {\n${list.join("\n")}\n}\n`);
for (const scene of ["scenes.rs", "lighthouse.rs", "world"])
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
