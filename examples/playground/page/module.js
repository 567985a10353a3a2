// The crate as a WebAssembly module: its functions, and its memory as numbers.

/** The fields of the module's settings, in its order: see src/view.rs. */
export const FIELDS = (
  "scene mode tolerance width height first_row rows is_home yaw pitch distance center_x center_y center_z scale fov " +
  "near far shift_x shift_y is_two_sided is_mono"
).split(" ");

/** Radians as a fraction of 2^32, like the crate's angles. */
export const turn = (radians) => Math.round((radians / (2 * Math.PI)) * 2 ** 32) >>> 0;
/** A length in units of 2^-16, like the crate's numbers. */
export const fixed = (length) => Math.round(length * 65536);

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

/** The functions of the module that the page uses. `world` is the little world's module, loaded when it is needed. */
export class Crate {
  world = null;

  constructor(exports) {
    this.exports = exports;
  }

  numbers(Type, at, length) {
    return new Type(this.exports.memory.buffer, at, length);
  }

  text(at, length) {
    return new TextDecoder().decode(this.numbers(Uint8Array, at, length));
  }

  message() {
    return this.text(this.exports.message(), this.exports.message_size());
  }

  costs() {
    return this.text(this.exports.costs(), this.exports.costs_size());
  }

  /** Throws the module's message. */
  check(done) {
    if (!done) throw new Error(this.message());
  }

  set(view) {
    const fields = this.numbers(Int32Array, this.exports.view(), FIELDS.length);
    FIELDS.forEach((name, at) => {
      fields[at] = view[name];
    });
    this.view = view;
  }

  /** Draws the view, or a band of it; returns the milliseconds that the draw calls took. */
  draw(slot, view, first_row = 0, rows = view.height) {
    this.set({ ...view, first_row, rows });
    this.check(this.exports.clear(slot));
    const start = performance.now();
    if (view.is_world) {
      const at = this.world.draw(view.width, view.height, first_row, rows, view.moment);
      const time = performance.now() - start;
      const [from, length] = [first_row * view.width, rows * view.width];
      const drawn = new Uint16Array(this.world.memory.buffer, at, from + length);
      this.picture(slot).set(drawn.subarray(from), from);
      return time;
    }
    this.check(this.exports.draw(slot));
    const time = performance.now() - start;
    this.check(this.exports.overlay(slot));
    return time;
  }

  /** Triangles in, drawn and clipped, of the last drawing; and pixels, if they were counted after it. */
  counts() {
    return [...this.numbers(Uint32Array, this.exports.counts(), 4)];
  }

  /** The same counts for a view. Spoils the picture. */
  counted(slot, view) {
    this.draw(slot, view);
    this.check(this.exports.count(slot));
    return this.counts();
  }

  /** The picture in Rgb565. */
  picture(slot) {
    return this.numbers(Uint16Array, this.exports.picture(slot), this.view.width * this.view.height);
  }

  /** The picture in a display's format. */
  shown(slot, format) {
    const { width, height } = this.view;
    const at = this.exports.show(slot, format);
    return new ImageData(this.numbers(Uint8ClampedArray, at, width * height * 4), width, height);
  }

  /** The triangles that the view draws and the texel under each pixel. Spoils the picture. */
  recorded(slot, view) {
    this.set({ ...view, first_row: 0, rows: view.height });
    this.check(this.exports.record(slot));
    const pixels = this.numbers(Int32Array, this.exports.pixels(), 3 * view.width * view.height);
    const at = this.exports.triangles();
    return { pixels, triangle: (index) => this.numbers(Int32Array, at + 68 * index, 17) };
  }

  write(bytes) {
    if (bytes.length > this.exports.input_size()) throw new Error("The file is too large: at most 16 MiB can be read.");
    this.numbers(Uint8Array, this.exports.input(), bytes.length).set(bytes);
  }

  /** Reads a model from OBJ text; returns its center's coordinates and its radius. */
  readModel(bytes) {
    this.write(bytes);
    this.check(this.exports.read_model(bytes.length));
    return [...this.numbers(Int32Array, this.exports.bounds(), 4)].map((bits) => bits / 65536);
  }

  readTexture({ data, width, height }) {
    this.write(data);
    this.check(this.exports.read_texture(width, height));
  }

  /** CRC-32 of the picture's pixels, row by row, the more significant byte first, as the firmware computes it. */
  checksum(slot) {
    let crc = -1;
    for (const pixel of this.picture(slot)) {
      for (let bit = 0; bit < 16; bit++) {
        const next = pixel >> (bit < 8 ? 8 + bit : bit - 8);
        crc = (crc ^ next) & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
      }
    }
    return (~crc >>> 0).toString(16).padStart(8, "0");
  }
}
