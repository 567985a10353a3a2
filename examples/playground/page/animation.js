// An animated GIF, which a module of its own writes.
import { fetched } from "./module.js";

let module;

/** Begins a file of pictures of a size. Returns functions: `add` a picture, and `end` the file. */
export async function animation(width, height) {
  module ??= await WebAssembly.compile(await fetched("animation.wasm.gz"));
  // A new instance each time, because memory does not shrink.
  const { memory, begin, add, file, file_size } = (await WebAssembly.instantiate(module)).exports;
  const pixels = begin(width, height);
  return {
    /** Adds an ImageData, which is shown for so many hundredths of a second. */
    add({ data }, delay) {
      new Uint8Array(memory.buffer, pixels, data.length).set(data);
      if (!add(delay)) throw new Error("There is not enough memory for the GIF.");
    },
    /** Ends the file. */
    end() {
      const at = file();
      return new Blob([new Uint8Array(memory.buffer, at, file_size())], { type: "image/gif" });
    },
  };
}
