// Files of the visitor's own, which a module of its own reads.
import { fetched } from "./module.js";

let module;

/** Saves a file on the visitor's computer. */
export function save(name, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** Gives files to the module, and what they are for: an export with its arguments. Returns the parts of its answer. */
async function ask(files, action, ...args) {
  module ??= await WebAssembly.compile(await fetched("reader.wasm.gz"));
  const contents = await Promise.all(files.map((file) => file.arrayBuffer()));
  // A new instance each time, because memory does not shrink.
  const { memory, add, part, part_size, ...actions } = (await WebAssembly.instantiate(module)).exports;
  const put = (bytes) => {
    const at = add(bytes.length);
    new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
  };
  try {
    for (const [index, { name }] of files.entries()) {
      put(new TextEncoder().encode(name));
      put(new Uint8Array(contents[index]));
    }
    actions[action](...args);
  } catch {
    throw new Error(`${files.at(-1).name}: there is not enough memory to read it.`);
  }
  const parts = Array.from({ length: 6 }, (_, at) => new Uint8Array(memory.buffer, part(at), part_size(at)));
  const text = (at) => new TextDecoder().decode(parts[at]);
  if (text(5)) throw new Error(text(5));
  return { parts, name: text(3), notes: text(4).split("\n").filter(Boolean) };
}

/**
 * Reads dropped files. Returns what `Crate.read` needs of the model and of the texture, each undefined if there is none;
 * the name of the file that was read; and notes.
 */
export async function read(files) {
  const { parts, ...rest } = await ask(files, "read");
  const [width, height] = new Uint32Array(parts[2].slice().buffer);
  return {
    model: parts[0].length ? parts[0] : undefined,
    texture: width ? { data: parts[1], width, height } : undefined,
    ...rest,
  };
}

/**
 * Makes a UF2 of a board's program and the files' model, for a panel: four times the module's number, and right angles.
 * Returns its bytes, the words of the model, what the model costs on the board, and as above.
 */
export async function flash(program, files, panel) {
  const { parts, ...rest } = await ask([new File([program], "program"), ...files], "flash", panel);
  const [uf2, words, cost] = parts;
  return { uf2, words, cost: new TextDecoder().decode(cost), ...rest };
}
