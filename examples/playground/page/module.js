// The crate as a WebAssembly module: its functions, and its memory as numbers.

/** The little world, whose pictures a module of its own draws. */
export const WORLD = 6;

/** Compiles and starts a module. It needs no header from the server. */
export async function load(bytes) {
  const { instance } = await WebAssembly.instantiate(bytes, {});
  return instance.exports;
}

/** The bytes of a compressed file beside the page. Some servers unpack it. */
export async function fetched(path) {
  const response = await fetch(new URL(path, import.meta.url));
  if (!response.ok) throw new Error(`${path} is missing here (${response.status}).`);
  const bytes = new Uint8Array(await response.arrayBuffer());
  if (bytes[0] !== 0x1f) return bytes;
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

/** What the page can ask of the module. `world` is the little world's module, loaded when it is needed. */
export class Crate {
  world = null;

  constructor(exports) {
    this.exports = exports;
    this.names = this.text("names").split(" ");
  }

  numbers(Type, at, length) {
    return new Type(this.exports.memory.buffer, at, length);
  }

  /** Calls a function of the module, which throws its message; returns the text that it wrote. */
  text(name, ...numbers) {
    const isDone = this.exports[name](...numbers);
    const { text, text_size } = this.exports;
    const written = new TextDecoder().decode(this.numbers(Uint8Array, text(), text_size()));
    if (!isDone) throw new Error(written);
    return written;
  }

  call(name, ...numbers) {
    if (!this.exports[name](...numbers)) this.text(name, ...numbers);
  }

  fields() {
    return this.numbers(Float64Array, this.exports.fields(), this.names.length);
  }

  set(view) {
    this.fields().set(this.names.map((name) => Number(view[name])));
    this.view = view;
  }

  /** The settings of a scene's start. */
  home(scene) {
    this.exports.home(scene);
    const fields = [...this.fields()].map((value, at) => [this.names[at], value]);
    return Object.fromEntries(fields.slice(this.names.indexOf("is_home")));
  }

  /** Draws the view, or a band of it; returns the milliseconds that the draw calls took. */
  draw(slot, view, first_row = 0, rows = view.height) {
    this.set({ ...view, first_row, rows });
    this.call("clear", slot);
    const start = performance.now();
    if (view.scene === WORLD) {
      const moment = Math.round((view.moment / 360) * 2 ** 32) >>> 0;
      const at = this.world.draw(view.width, view.height, first_row, rows, moment);
      const time = performance.now() - start;
      const [from, length] = [first_row * view.width, rows * view.width];
      const drawn = new Uint16Array(this.world.memory.buffer, at, from + length);
      this.picture(slot).set(drawn.subarray(from), from);
      return time;
    }
    this.call("draw", slot);
    const time = performance.now() - start;
    this.call("overlay", slot);
    return time;
  }

  /** The picture in Rgb565. */
  picture(slot) {
    return this.numbers(Uint16Array, this.exports.picture(slot), this.view.width * this.view.height);
  }

  /** The picture in the display's colors, or what else a function of the module shows. */
  shown(slot, show = "show") {
    this.call(show, slot);
    const { width, height } = this.view;
    const bytes = this.numbers(Uint8ClampedArray, this.exports.shown(slot), width * height * 4);
    return new ImageData(bytes, width, height);
  }

  /** The errors of a view as a picture. Spoils its drawing. */
  errors(slot, view) {
    this.set({ ...view, first_row: 0, rows: view.height });
    return this.shown(slot, "errors");
  }

  /** Triangles in, drawn and clipped, pixels, errors, instructions of a view. Spoils its drawing. */
  measured(slot, view, hasErrors) {
    this.set({ ...view, first_row: 0, rows: view.height });
    this.call("measure", slot);
    if (hasErrors) this.call("errors", slot);
    const [submitted, drawn, clipped, pixels, max, mean, m0, m4] =
      this.numbers(Float64Array, this.exports.results(), 8);
    return { submitted, drawn, clipped, pixels, m0, m4, ...(hasErrors && { max, mean }) };
  }

  /** The program that draws a view. */
  program(view) {
    this.set(view);
    return this.text("program");
  }

  write(bytes) {
    if (bytes.length > this.exports.input_size()) throw new Error("The file is too large: at most 16 MiB can be read.");
    this.numbers(Uint8Array, this.exports.input(), bytes.length).set(bytes);
  }

  /** Reads a model from OBJ text. */
  readModel(bytes) {
    this.write(bytes);
    this.call("read_model", bytes.length);
  }

  readTexture({ data, width, height }) {
    this.write(data);
    this.call("read_texture", width, height);
  }

  checksum(slot) {
    this.set(this.view);
    return (this.exports.checksum(slot) >>> 0).toString(16).padStart(8, "0");
  }
}
