// Draws views in WebAssembly under Node. Argument: the folder with the page. Prints the fields of each view and the
// checksum of its picture. Fails if the page's model finds errors beyond what the modes promise.
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { gunzipSync } from "node:zlib";

const folder = resolve(process.argv[2]);
const from = (name) => import(pathToFileURL(`${folder}/${name}`));
const { Crate, FIELDS, load } = await from("module.js");
const { MODES, SCENES, home, settings } = await from("scenes.js");
const { errors } = await from("model.js");

const crate = new Crate(await load(gunzipSync(readFileSync(`${folder}/playground.wasm.gz`))));
const measured = SCENES.slice(0, 5);

const state = (scene, camera = {}, size = [320, 240], format = 0) => ({
  scene,
  format,
  camera: { ...home(scene), isHome: !Object.keys(camera).length, ...camera },
  tolerance: 0.25,
  width: size[0],
  height: size[1],
  isTwoSided: false,
});

// The views as they are measured; and turned, near, wide, moved by parts of a pixel, on other displays, the last in
// black and white.
const VIEWS = [
  [{}],
  [{ yaw: 0.7, pitch: 0.5 }],
  [{ yaw: -1, distance: 1.2 }, [128, 64]],
  [{ fov: 2.4, yaw: 0.3 }, [640, 480]],
  [{ shift: [0.3, 0.7], near: 0.01, far: 3000 }, [240, 240]],
  [{ yaw: 0.1 }, [128, 64], 5],
];
for (const scene of measured.keys()) {
  for (const mode of MODES.keys()) {
    for (const [camera, size, format] of VIEWS) {
      const view = settings(state(scene, camera, size, format), mode);
      crate.draw(0, view);
      const fields = { ...view, first_row: 0, rows: view.height };
      console.log([...FIELDS.map((name) => fields[name] | 0), crate.checksum(0)].join(" "));
    }
  }
}

// What modes promise, in texels, of a texture of 64 (guide to modes): Exact, Newton and Compact a thousandth, Fast its
// tolerance and 2^-13 of the texture. Affine bends the cube.
const most = { Exact: 0.001, Newton: 0.001, Fast: 0.25 + 64 / 2 ** 13, Compact: 0.001 };
for (const scene of [0, 1, 2]) {
  for (const [mode, name] of MODES.entries()) {
    const view = settings(state(scene), mode);
    const { max, count } = errors(view, crate.recorded(0, view));
    const fails = name === "Affine" ? scene === 1 && max < 5 : max > most[name];
    if (fails || count < 20000)
      throw new Error(`${SCENES[scene].name} in mode ${name}: ${max} texels in ${count} pixels`);
  }
}
