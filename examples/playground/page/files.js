// Files of the visitor's own, which a module of its own reads.
import { fetched } from "./module.js";

let module;

/**
 * Reads dropped files. Returns what `Crate.read` needs of the model and of the texture, each undefined if there is none;
 * the name of the file that was read; and notes.
 */
export async function read(files) {
  module ??= await WebAssembly.compile(await fetched("reader.wasm.gz"));
  const contents = await Promise.all(files.map((file) => file.arrayBuffer()));
  // A new instance for each drop, because memory does not shrink.
  const { memory, add, read, part, part_size } = (await WebAssembly.instantiate(module)).exports;
  const put = (bytes) => {
    const at = add(bytes.length);
    new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
  };
  try {
    for (const [index, { name }] of files.entries()) {
      put(new TextEncoder().encode(name));
      put(new Uint8Array(contents[index]));
    }
    read();
  } catch {
    throw new Error(`${files[0].name}: there is not enough memory to read it.`);
  }
  const parts = Array.from({ length: 6 }, (_, at) => new Uint8Array(memory.buffer, part(at), part_size(at)));
  const text = (at) => new TextDecoder().decode(parts[at]);
  if (text(5)) throw new Error(text(5));
  const [width, height] = new Uint32Array(parts[2].slice().buffer);
  return {
    model: parts[0].length ? parts[0] : undefined,
    texture: width ? { data: parts[1], width, height } : undefined,
    name: text(3),
    notes: text(4).split("\n").filter(Boolean),
  };
}
