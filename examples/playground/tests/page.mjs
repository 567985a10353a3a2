// The page's modules and the crate's WebAssembly under Node, from the folder in the variable PAGE.
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { gunzipSync } from "node:zlib";

globalThis.ImageData = class {
  constructor(data, width, height) {
    Object.assign(this, { data, width, height });
  }
};

export const folder = resolve(process.env.PAGE);
export const page = (name) => import(pathToFileURL(`${folder}/${name}`));

const { Crate, load } = await page("module.js");
const { state } = await page("state.js");
const module = (name) => load(gunzipSync(readFileSync(`${folder}/${name}.wasm.gz`)));
export const crate = new Crate(await module("playground"));
crate.world = await module("world");
crate.readTexture({ data: new Uint8Array(4).fill(215), width: 1, height: 1 });

const CAMERA = ["yaw", "pitch", "distance", "fov", "near", "far", "right", "down", "scale"];

/** The settings of a scene; a camera that is not the measured one has its changes. */
export function view(scene, { size = "320x240", ...changes } = {}) {
  const [width, height] = size.split("x").map(Number);
  const is_home = !CAMERA.some((key) => key in changes);
  return { ...state, ...crate.home(scene), is_home, scene, width, height, first_row: 0, rows: height, ...changes };
}

/** The checksum of a picture. */
export function checksum(settings) {
  crate.draw(0, settings);
  return crate.checksum(0);
}
