// Files of the visitor's own: models as OBJ text, textures as pixels. The browser decodes pictures.
import { converted } from "./gltf.js";

/** Reads dropped files; returns the model and its texture, or undefined for what is not among them. */
export async function read(files) {
  const find = (pattern) => files.find(({ name }) => pattern.test(name));
  const model = find(/\.(obj|gltf|glb)$/i);
  const picture = find(/\.(png|jpe?g|webp|gif|bmp|avif)$/i);
  if (!model && !picture) throw new Error("it is neither a model (.obj, .gltf, .glb) nor a picture for its texture.");
  const resource = (uri) => {
    const name = decodeURIComponent(uri).split("/").pop();
    const file = files.find((file) => file.name === name);
    if (!file) throw new Error(`it needs ${name}: drop both files together.`);
    return file.arrayBuffer();
  };
  // What gltf.js does not say is JavaScript's: a list or a number is not where glTF has it.
  const damaged = (error) => {
    throw error.constructor === Error ? error : new Error("it is damaged, or not glTF.");
  };
  const bytes = await model?.arrayBuffer();
  const isObj = !model || /\.obj$/i.test(model.name);
  const { text, image } = isObj ? { text: bytes } : await converted(bytes, resource).catch(damaged);
  const texture = picture ?? image;
  return { model: text && fitted(new Uint8Array(text)), texture: texture && (await pixels(texture)) };
}

const VERTEX = /^[ \t]*v((?:[ \t]|\\\r?\n)+[^\s\\]+){3}/gm;
const WORD = /[^\s\\]+/g;

/**
 * OBJ text with coordinates that the crate's numbers hold in few enough and enough steps of 2^-16. Where they do not,
 * the model is moved to the origin and scaled to a radius of 1, as the note says; lines stay where they are, for
 * messages.
 */
export function fitted(bytes) {
  const text = new TextDecoder("latin1").decode(bytes);
  const points = (text.match(VERTEX) ?? []).map((vertex) => vertex.match(WORD).slice(1).map(Number));
  const most = (pick) => points.reduce((most, at) => most.map((value, axis) => pick(value, at[axis])), points[0] ?? []);
  const [low, high] = [most(Math.min), most(Math.max)];
  const center = low.map((value, axis) => value / 2 + high[axis] / 2);
  const radius = Math.hypot(...high.map((value, axis) => value - center[axis]));
  const fits = radius >= 1 / 16 && Math.max(...high, ...low.map((value) => -value), radius) < 16384;
  // The crate's parser tells of what is no number.
  if (fits || !(radius > 0 && radius < Infinity)) return { text: bytes, note: "" };
  const moved = text.replace(VERTEX, (vertex) => {
    let axis = -1; // The word before the coordinates is v.
    return vertex.replace(WORD, (word) => (axis++ < 0 ? word : ((word - center[axis - 1]) / radius).toFixed(9)));
  });
  const note = `// For the range of the crate's numbers, the page moved and scaled the model: of each v in model.obj,
// (x, y, z) became ((x, y, z) - (${center.join(", ")})) / ${radius}\n`;
  return { text: new TextEncoder().encode(moved), note };
}

/** The pixels of a picture, with sides that are powers of two, 512 at most. */
async function pixels(file) {
  const bitmap = await createImageBitmap(file).catch(() => {
    throw new Error(`the browser cannot read the picture ${file.name ?? "of its texture"}.`);
  });
  const [width, height] = [bitmap.width, bitmap.height].map((side) => 2 ** Math.min(Math.round(Math.log2(side)), 9));
  const context = new OffscreenCanvas(width, height).getContext("2d");
  context.drawImage(bitmap, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}
