// The page's modules and the crate's WebAssembly under Node, from the folder in the variable PAGE.
import { File } from "node:buffer";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

globalThis.ImageData = class {
  constructor(data, width, height) {
    Object.assign(this, { data, width, height });
  }
};

export const folder = resolve(process.env.PAGE);
export const page = (name) => import(pathToFileURL(`${folder}/${name}`));

const { fetch } = globalThis;
globalThis.fetch = (path) => (/\.gz$/.test(path) ? new Response(readFileSync(`${folder}/${path}`)) : fetch(path));

const { Crate, World, load } = await page("module.js");
export const crate = new Crate(await load("playground.wasm.gz"));
crate.world = new World(await load("world.wasm.gz"));
const { read } = await page("files.js");

/** Reads files, given by their names and contents, as the page does; returns the notes. */
export async function drop(files) {
  const dropped = Object.entries(files).map(([name, contents]) => new File([contents], name));
  const { model, texture, notes } = await read(dropped);
  if (model) crate.read("read_model", model);
  const { data, ...size } = texture ?? { data: new Uint8Array(4).fill(215), width: 1, height: 1 };
  crate.read("read_texture", data, size);
  return notes;
}

const SETTINGS = { mode: 1, tolerance: -2, format: 0, band: 16, is_two_sided: 0, first_row: 0 };
export const home = (scene) => crate.ask("home", { ...SETTINGS, scene });

/** An angle as the page rounds it once it is another one than at the start. */
export const tenths = (degrees) => Math.round(degrees * 10) / 10;

/** The settings of a scene in its start view, with changes. */
export function view(scene, { size = "320x240", ...changes } = {}) {
  const [width, height] = size.split("x").map(Number);
  return { ...home(scene), width, height, rows: height, ...changes };
}

/** The checksum of a picture. */
export function checksum(settings) {
  crate.draw(settings, 0);
  return crate.ask("checksum", settings).checksum.toString(16).padStart(8, "0");
}
