// The crate as a WebAssembly module. Settings go in, and results come out, by their names in src/view.rs.

export const MODES = ["Exact", "Newton", "Fast", "Affine", "Compact"];
export const NEWTON = 1;
/** Scenes. The little world's pictures are drawn by a module of its own. */
export const [FLOOR, FLAT_SPHERE, LIGHTHOUSE, OWN, WORLD] = [0, 3, 4, 5, 6];

/** The bytes of a module in a compressed file beside the page, which may be asked for already. No header is needed. */
export async function fetched(path, request = fetch(path)) {
  const response = await request;
  if (!response.ok) throw new Error(`${path} is missing here (${response.status}).`);
  const packed = await response.blob();
  const unpacked = packed.stream().pipeThrough(new DecompressionStream("gzip"));
  // Some servers unpack it themselves.
  return new Response(unpacked).arrayBuffer().catch(() => packed.arrayBuffer());
}

/** Starts a module. */
export const load = async (...path) => (await WebAssembly.instantiate(await fetched(...path))).instance.exports;

/** The little world. It needs no other module, so the page opens with it. It is drawn in the default mode. */
export class World {
  /** The start view: in the settings of the page, the moment of the walk is an angle. */
  static HOME = { scene: WORLD, yaw: 72 };

  constructor(exports) {
    this.exports = exports;
  }

  /** Draws a picture, or a band of it, and returns its colors as Rgb565. */
  draw({ width, height, first_row, rows, yaw }) {
    const at = this.exports.draw(width, height, first_row, rows, Math.round((yaw / 360) * 2 ** 32));
    return new Uint16Array(this.exports.memory.buffer, at, width * rows);
  }

  /** What was drawn last, as it is shown. */
  image({ width, rows }) {
    const at = this.exports.show(width * rows);
    return new ImageData(new Uint8ClampedArray(this.exports.memory.buffer, at, 4 * width * rows), width);
  }
}

/** What a module does and holds. Its three pictures are in slots. */
export class Crate {
  /** The little world, once it is loaded. */
  world = null;

  constructor(exports) {
    this.exports = exports;
    exports.names();
    this.names = this.text().split(" ");
    this.fields = this.numbers(Float64Array, exports.fields(), this.names.length);
  }

  /** Numbers in the module's memory, which stays where it is. */
  numbers(Type, at, length) {
    return new Type(this.exports.memory.buffer, at, length);
  }

  /** What the last action wrote. */
  text() {
    return new TextDecoder().decode(this.numbers(Uint8Array, this.exports.text(), this.exports.text_size()));
  }

  /** Does an action with settings; returns these with the results. */
  ask(action, settings, number = 0) {
    this.fields.set(this.names.map((name) => settings[name]));
    if (!this.exports[action](number)) throw new Error(this.text());
    return { ...settings, ...Object.fromEntries(this.names.map((name, at) => [name, this.fields[at]])) };
  }

  /** Draws a picture, or a band of it; returns the milliseconds that the scene took, without its background. */
  draw(settings, slot) {
    this.ask("clear", settings, slot);
    const start = performance.now();
    this.ask("draw", settings, slot);
    if (settings.scene === WORLD) {
      this.picture(settings, slot).set(this.world.draw(settings), settings.width * settings.first_row);
    }
    return performance.now() - start;
  }

  /** The picture as it was drawn, in Rgb565. */
  picture({ width, height }, slot) {
    return this.numbers(Uint16Array, this.exports.picture(slot), width * height);
  }

  /** A picture as an action makes it: "show" in the display's colors; "errors", which spoils what was drawn. */
  image(action, settings, slot) {
    this.ask(action, settings, slot);
    const { width, height } = settings;
    const bytes = this.numbers(Uint8ClampedArray, this.exports.shown(slot), 4 * width * height);
    return new ImageData(bytes, width, height);
  }

  /** Takes what files.js has read: "read_model" a mesh, "read_texture" pixels of a size. */
  read(action, bytes, size = {}) {
    this.numbers(Uint8Array, this.exports.input(), bytes.length).set(bytes);
    this.ask(action, size, bytes.length);
  }

  /** A segment from one distance to another: the fractions of picture and segment, and the distance, at one of them. */
  foreshorten(start, end, fraction, isInSpace) {
    this.fields.set([start, end, fraction]);
    if (!this.exports.foreshorten(Number(isInSpace))) throw new Error(this.text());
    const [onScreen, inSpace, distance] = this.fields;
    return { onScreen, inSpace, distance };
  }

  /** The program that draws a picture. */
  program(settings) {
    this.ask("program", settings);
    return this.text();
  }
}
