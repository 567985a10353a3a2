// Figures of the picture: counts, times, errors, and estimates for a microcontroller.
import { CORES, instructions, table } from "./cost.js";
import { errors } from "./model.js";
import { plot } from "./plot.js";
import { FORMATS, MODES, home, settings } from "./scenes.js";
import { $, format, interpolates, modes, scene, short, state, view, waits, whole } from "./state.js";

const reference = []; // counts of the measured scenes as they were measured
/** Milliseconds of the draw calls in each mode. */
export const times = [];
let known = [0, 0, 0, 0];
let [counted, comparison] = [null, 0];

/** Counts triangles in, drawn and clipped, and pixels. Spoils the picture. */
export function count(crate) {
  if (scene().is_world || waits()) return;
  const like = scene().like ?? state.scene;
  const measured = { ...state, scene: like, camera: home(like), size: "320x240", isTwoSided: false };
  reference[like] ??= crate.counted(0, settings(measured, 1));
  known = crate.counted(0, view());
}

/** The numbers below the picture; `rate` is of pictures a second, undefined while it does not change. */
export function numbers(crate, rate) {
  const [submitted, drawn, clipped, pixels] = waits() ? [0, 0, 0, 0] : known;
  const { width, height } = view();
  const bits = FORMATS[format()].bits + (scene().id === "sphere-flat" ? 0 : 16);
  const kib = (rows) => `${+((width * rows * bits) / 8 / 1024).toFixed(1)} KiB`;
  const time = times[modes()[0]];
  const list = [
    ...(scene().is_world
      ? [["Time per picture", `${short(time)} ms`]]
      : [
          ["Triangles", whole(submitted)],
          ["Drawn", whole(drawn), "The others are turned away or outside the picture"],
          ["Clipped", whole(clipped), "Cut at the edge of the visible space"],
          ["Pixels drawn", whole(pixels)],
          ["Time per pixel", pixels ? `${short((time * 1e6) / pixels)} ns` : "–", "In this browser"],
        ]),
    rate ? ["Pictures a second", whole(rate)] : ["Checksum", crate.checksum(0), "CRC-32 of the left picture's pixels"],
    ["RAM, whole picture", kib(height), "Colors and depths"],
    [`RAM, ${state.rows} rows`, kib(Math.min(state.rows, height)), "Colors and depths of a band"],
  ];
  $("numbers").innerHTML = list
    .map(([name, value, title = ""]) => `<div title="${title}"><dt>${name}</dt><dd>${value}</dd></div>`)
    .join("");
}

/** Milliseconds of the draw calls: the best of three means, each over more than the clock's steps. */
function timed(crate, now) {
  const mean = () => {
    let [sum, rounds] = [0, 0];
    for (; sum < 2 && rounds < 400; rounds++) sum += crate.draw(1, now);
    return sum / rounds;
  };
  return Math.min(mean(), mean(), mean());
}

/** Measures every mode: its time here, its instructions, its error. Undefined if `goesOn` stops it. */
async function measured(crate, goesOn) {
  counted ??= table(crate.costs());
  const found = [];
  for (const [mode, name] of MODES.entries()) {
    const tolerances = name === "Fast" ? [...new Set([1 / 16, 1 / 4, 1, state.tolerance])].sort((a, b) => a - b) : [0];
    for (const tolerance of tolerances) {
      await new Promise((resume) => setTimeout(resume));
      if (!goesOn()) return undefined;
      const now = settings({ ...state, tolerance }, mode);
      const error = interpolates() ? errors(now, crate.recorded(1, now)) : {};
      const here = modes().includes(mode) && (name !== "Fast" || tolerance === state.tolerance);
      const cost = { time: timed(crate, now) };
      for (const { id } of CORES)
        cost[id] = instructions(counted, id, scene(), name, known, reference[scene().like ?? state.scene]);
      if (here) times[mode] = cost.time;
      const within = { 0: "", 0.0625: " 1/16", 0.25: " ¼" }[tolerance] ?? ` ${short(tolerance)}`;
      // Instructions for Fast were counted within ¼ texel.
      const isCounted = name !== "Fast" || tolerance === 0.25;
      found.push({ name: name + within, here, isCounted, cost, ...error });
    }
  }
  return found;
}

/** Fills the plot and the table of the modes in view; returns whether nothing stopped it. Spoils the pictures. */
export async function compare(crate, goesOn) {
  const mine = ++comparison;
  const found = scene().is_world ? [] : await measured(crate, () => mine === comparison && goesOn());
  if (!found) return false;
  const { axis } = state;
  const isTime = axis === "time";
  $("plot").innerHTML = plot(
    found
      .filter(({ here, isCounted }) => isTime || isCounted || here)
      .map(({ name, here, cost, max }) => ({ name, here, error: max, cost: isTime ? cost.time : cost[axis] / 1e6 })),
    isTime ? "milliseconds here" : "million instructions, estimated",
  );
  tell(found.filter(({ here }) => here));
  return true;
}

/** The table of the modes that are seen. */
function tell(found) {
  const rows = [
    ["Largest error, in texels", ({ max }) => short(max)],
    ["Mean error", ({ mean }) => short(mean)],
    ...CORES.flatMap(({ id, name, clock, cycles }) => [
      [`${name}: million instructions`, ({ cost }) => (cost[id] ? (cost[id] / 1e6).toFixed(2) : "–")],
      [`${name}: pictures a second`, ({ cost }) => (cost[id] ? (clock / (cost[id] * cycles)).toFixed(0) : "–")],
    ]),
  ];
  const line = (name, cells) => `<tr><th scope="row">${name}</th>${cells.join("")}</tr>`;
  const head = line("", found.map(({ name }) => `<th scope="col">${name}</th>`));
  const body = rows.map(([name, value]) => line(name, found.map((mark) => `<td>${value(mark)}</td>`)));
  $("cost").innerHTML = `<thead>${head}</thead><tbody>${body.join("")}</tbody>`;
  $("cost").hidden = !found.length;
  $("about-cost").textContent = scene().is_world
    ? "The little world chooses modes and shaders itself; its instructions are not estimated here."
    : "A texel is a pixel of a texture. The page measures errors against its own model in double precision. It estimates " +
      "instructions from counts of this scene on an emulated core and from the pixels and triangles now, and pictures a " +
      "second for 133 MHz (Cortex-M0+) and 168 MHz (Cortex-M4) without wait states." +
      (scene().id === "sphere"
        ? " For its errors, the sphere has a texture of 64x64 texels in place of its colors."
        : "") +
      (found.some(({ name }) => name.startsWith("Fast")) ? " Fast was counted within ¼ texel." : "") +
      (scene().id === "own" ? " Your model is estimated as if it were the lighthouse." : "");
}
