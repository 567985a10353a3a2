// Figures of the picture: counts, times, errors, and estimates for a microcontroller.
import { plot } from "./plot.js";
import { $, FLAT_SPHERE, MODES, OWN, SPHERE, interpolates, isWorld, modes, short, state } from "./state.js";
import { view, waits } from "./state.js";

const whole = (value) => value.toLocaleString("en", { maximumFractionDigits: 0 });
/** Milliseconds of the draw calls in each mode. */
export const times = [];
/** Bits of a pixel in each format. */
const BITS = [16, 16, 8, 4, 2, 1];
/** Cores that are estimated for: clock in MHz, and cycles for an instruction, without wait states (guide to modes). */
const CORES = [
  { id: "m0", name: "Cortex-M0+", clock: 133, cycles: 1.45 },
  { id: "m4", name: "Cortex-M4", clock: 168, cycles: 1.35 },
];
let [counts, comparison] = [{}, 0];

/** The numbers below the picture; `rate` is of pictures a second, undefined while it does not change. */
export function numbers(crate, rate) {
  const { submitted = 0, drawn = 0, clipped = 0, pixels = 0 } = waits() ? {} : counts;
  const bits = BITS[view().format] + (state.scene === FLAT_SPHERE ? 0 : 16);
  const kib = (rows) => `${+((state.width * rows * bits) / 8 / 1024).toFixed(1)} KiB`;
  const time = times[modes()[0]];
  const list = [
    ...(isWorld()
      ? [["Time per picture", `${short(time)} ms`]]
      : [
          ["Triangles", whole(submitted)],
          ["Drawn", whole(drawn), "The others are turned away or outside the picture"],
          ["Clipped", whole(clipped), "Cut at the edge of the visible space"],
          ["Pixels drawn", whole(pixels)],
          ["Time per pixel", pixels ? `${short((time * 1e6) / pixels)} ns` : "–", "In this browser"],
        ]),
    rate ? ["Pictures a second", whole(rate)] : ["Checksum", crate.checksum(0), "CRC-32 of the left picture's pixels"],
    ["RAM, whole picture", kib(state.height), "Colors and depths"],
    [`RAM, ${state.band} rows`, kib(Math.min(state.band, state.height)), "Colors and depths of a band"],
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

/** Measures every mode: its time here, its instructions, its error. Undefined if `goesOn` says no. */
async function measured(crate, goesOn) {
  const found = [];
  for (const [mode, name] of MODES.entries()) {
    const isFast = name === "Fast";
    const tolerances = isFast ? [...new Set([1 / 16, 1 / 4, 1, state.tolerance])].sort((a, b) => a - b) : [0];
    for (const tolerance of tolerances) {
      await new Promise((resume) => setTimeout(resume));
      if (!goesOn()) return undefined;
      const now = { ...view(mode), tolerance };
      const here = modes().includes(mode) && (!isFast || tolerance === state.tolerance);
      const within = { 0: "", 0.0625: " 1/16", 0.25: " ¼" }[tolerance] ?? ` ${short(tolerance)}`;
      // Instructions for Fast were counted within ¼ texel.
      const isCounted = !isFast || tolerance === 0.25;
      const counted = crate.measured(1, now, interpolates());
      found.push({ name: name + within, here, isCounted, ...counted, time: timed(crate, now) });
      if (here) times[mode] = found.at(-1).time;
    }
  }
  return found;
}

/** Counts triangles and pixels, and fills the plot and the table. Spoils the pictures. Whether nothing stopped it. */
export async function compare(crate, goesOn) {
  const mine = ++comparison;
  const found = isWorld() || waits() ? [] : await measured(crate, () => mine === comparison && goesOn());
  if (!found) return false;
  const isTime = state.axis === "time";
  const cost = (mark) => (isTime ? mark.time : mark[state.axis] / 1e6);
  $("plot").innerHTML = plot(
    found
      .filter(({ here, isCounted }) => isTime || isCounted || here)
      .map((mark) => ({ name: mark.name, here: mark.here, error: mark.max, cost: cost(mark) })),
    isTime ? "milliseconds here" : "million instructions, estimated",
  );
  tell(found.filter(({ here }) => here));
  return true;
}

/** Counts triangles and pixels; whether there are any pixels. Spoils the picture. */
export function count(crate) {
  if (isWorld() || waits()) return true;
  counts = crate.measured(0, view(), false);
  return counts.pixels > 0;
}

/** The table of the modes that are seen. */
function tell(found) {
  const rows = [
    ["Largest error, in texels", ({ max }) => short(max)],
    ["Mean error", ({ mean }) => short(mean)],
    ...CORES.flatMap(({ id, name, clock, cycles }) => [
      [`${name}: million instructions`, (mark) => (mark[id] ? (mark[id] / 1e6).toFixed(2) : "–")],
      [`${name}: pictures a second`, (mark) => (mark[id] ? ((clock * 1e6) / (mark[id] * cycles)).toFixed(0) : "–")],
    ]),
  ];
  const line = (name, cells) => `<tr><th scope="row">${name}</th>${cells.join("")}</tr>`;
  const head = line("", found.map(({ name }) => `<th scope="col">${name}</th>`));
  const body = rows.map(([name, value]) => line(name, found.map((mark) => `<td>${value(mark)}</td>`)));
  $("cost").innerHTML = `<thead>${head}</thead><tbody>${body.join("")}</tbody>`;
  $("cost").hidden = !found.length;
  const about = isWorld()
    ? ["The little world chooses modes and shaders itself; its instructions are not estimated here."]
    : [
        "A texel is a pixel of a texture. The page measures the errors of modes against a model of its own in double",
        "precision. Every mode rounds corners to 1/256 of a pixel, and so does the model: where the crate puts them,",
        "or, for corners that clipping makes, by itself.",
        "It estimates instructions from counts of this scene on an emulated core, its pixels and its triangles,",
        "and pictures a second for 133 MHz (Cortex-M0+) and 168 MHz (Cortex-M4) without wait states.",
        state.scene === SPHERE && "For its errors, the sphere has a texture of 64x64 texels in place of its colors.",
        found.some(({ name }) => name.startsWith("Fast")) && "Fast was counted within ¼ texel.",
        state.scene === OWN && "Your model is estimated as if it were the lighthouse.",
      ];
  $("about-cost").textContent = about.filter(Boolean).join(" ");
}
