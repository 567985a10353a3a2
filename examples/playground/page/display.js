// What the display of a board shows, drawn here by the code that draws it on the board.
import { fetched } from "./module.js";

let module;

/** Takes the words of a model. Returns a function that draws a frame as an ImageData, after so many milliseconds. */
export async function display(words) {
  module ??= await WebAssembly.compile(await fetched("display.wasm.gz"));
  const exports = (await WebAssembly.instantiate(module)).exports;
  const memory = new Uint8Array(exports.memory.buffer);
  memory.set(words, exports.words());
  const [width, height] = [exports.width(), exports.height()];
  return (milliseconds) => {
    const at = exports.draw(milliseconds);
    return new ImageData(new Uint8ClampedArray(memory.slice(at, at + 4 * width * height).buffer), width);
  };
}
