// Files of the visitor's own: models as OBJ text, textures as pixels. The browser decodes pictures.
import { parsed } from "./gltf.js";

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
  const bytes = await model?.arrayBuffer();
  const { text, image } = /\.obj$/i.test(model?.name) || !bytes ? { text: bytes } : await parsed(bytes, resource);
  const texture = picture ?? image;
  return { model: text && fitted(new Uint8Array(text)), texture: texture && (await pixels(texture)) };
}

const SEPARATOR = String.raw`((?:[ \t]|\\\r?\n)+)`;
const POSITION = new RegExp(String.raw`^([ \t]*v)${`${SEPARATOR}(\\S+)`.repeat(3)}`, "gm");

/**
 * OBJ text with coordinates that the crate's numbers hold in few enough and enough steps of 2^-16. Where they do not,
 * the model is moved to the origin and scaled to a radius of 1, as the note says; lines stay where they are, for
 * messages.
 */
export function fitted(bytes) {
  const text = new TextDecoder("latin1").decode(bytes);
  const isEmpty = !/^[ \t]*f[ \t]/m.test(text);
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const [, , , x, , y, , z] of text.matchAll(POSITION)) {
    [x, y, z].map(Number).forEach((value, axis) => {
      low[axis] = Math.min(low[axis], value);
      high[axis] = Math.max(high[axis], value);
    });
  }
  const center = low.map((value, axis) => value / 2 + high[axis] / 2);
  const radius = Math.hypot(...high.map((value, axis) => value - center[axis]));
  const fits = radius >= 1 / 16 && Math.max(...high, ...low.map((value) => -value), radius) < 16384;
  // The crate's parser tells of what is no number.
  if (fits || !(radius > 0 && radius < Infinity)) return { text: bytes, isEmpty, note: "" };
  const to = (value, axis) => ((Number(value) - center[axis]) / radius).toFixed(9);
  const moved = text.replace(POSITION, (_, v, a, x, b, y, c, z) => v + a + to(x, 0) + b + to(y, 1) + c + to(z, 2));
  const note = `// For the range of the crate's numbers, the page moved and scaled the model: of each v in model.obj,
// (x, y, z) became ((x, y, z) - (${center.join(", ")})) / ${radius}\n`;
  return { text: new TextEncoder().encode(moved), isEmpty, note };
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
