// Figures of the picture: counts and times, errors, and estimates for a microcontroller.
import { $, short } from "./controls.js";
import { FLAT_SPHERE, MODES } from "./module.js";

/** Bits of a pixel in each format. */
const BITS = [16, 16, 8, 4, 2, 1];
/** Cores that are estimated for: clock in MHz, and cycles for an instruction, without wait states (guide to modes). */
const CORES = [
  { id: "m0", name: "Cortex-M0+", clock: 133, cycles: 1.45 },
  { id: "m4", name: "Cortex-M4", clock: 168, cycles: 1.35 },
];

/** Shows numbers of the left picture: what the module measured, milliseconds, and pictures a second while it turns. */
export function showNumbers({ submitted, drawn, clipped, pixels, checksum, mode, ...settings }, time, rate) {
  const { width, height, band } = settings;
  const bits = BITS[settings.format] + (settings.scene === FLAT_SPHERE ? 0 : 16);
  const kib = (rows) => `${short((width * rows * bits) / 8 / 1024)} KiB`;
  const whole = (value) => value.toLocaleString("en", { maximumFractionDigits: 0 });
  const list = [
    ["Mode", MODES[mode], "How textures follow perspective"],
    ["Triangles", whole(submitted)],
    ["Drawn", whole(drawn), "The others are turned away or outside the picture"],
    ["Clipped", whole(clipped), "Cut at the edge of the visible space"],
    ["Pixels drawn", whole(pixels)],
    pixels
      ? ["Time per pixel", `${short((time * 1e6) / pixels)} ns`, "In this browser"]
      : ["Time per picture", `${short(time)} ms`, "In this browser"],
    rate
      ? ["Pictures a second", whole(rate)]
      : ["Checksum", checksum.toString(16).padStart(8, "0"), "CRC-32 of the left picture's pixels as they are shown"],
    ["RAM, whole picture", kib(height), "Colors and depths"],
    [`RAM, ${band} rows`, kib(Math.min(band, height)), "Colors and depths of a band"],
  ];
  $("numbers").innerHTML = list
    .filter(([, value]) => value !== "NaN") // The little world counts nothing.
    .map(([name, value, title = ""]) => `<div title="${title}"><dt>${name}</dt><dd>${value}</dd></div>`)
    .join("");
}

/** Shows the errors and costs of the modes that are seen in a table, and those of all modes in a plot. */
export function compare(marks) {
  const seen = marks.filter(({ isSeen }) => isSeen);
  const row = (head, cells) => `<tr>${head}${cells.join("")}</tr>`;
  const numbers = (name, number) =>
    row(`<th scope="row">${name}</th>`, seen.map((mark) => `<td>${short(number(mark))}</td>`));
  $("table").innerHTML = [
    row("<td></td>", seen.map(({ name }) => `<th scope="col">${name}</th>`)),
    numbers("Largest error, in texels", ({ max }) => max),
    numbers("Mean error", ({ mean }) => mean),
    ...CORES.flatMap(({ id, name, clock, cycles }) => [
      numbers(`${name}: million instructions`, (mark) => mark[id]),
      numbers(`${name}: pictures a second`, (mark) => clock / (mark[id] * cycles)),
    ]),
  ].join("");
  // Nothing is plotted of scenes where nothing is interpolated or drawn.
  const costs = marks.map((mark) => ({ ...mark, cost: mark[mark.axis] }));
  $("plot").innerHTML = plot(costs.filter(({ cost, max }) => cost > 0 && max >= 0));
}

/** Where a mode's name stands beside its mark. Modes of like errors and costs have sides of their own. */
const SIDES = { Exact: [0, -9], Newton: [0, 18], Fast: [0, -9], Affine: [-27, 4], Compact: [0, -21] };

/** A plot of error against cost. */
function plot(marks) {
  const [LEFT, RIGHT, TOP, BOTTOM] = [46, 326, 12, 206];
  const log = ({ max }) => Math.log10(Math.max(max, 1e-4));
  const [low, high] = [Math.floor(Math.min(...marks.map(log), -3) - 0.5), Math.ceil(Math.max(...marks.map(log), 0))];
  const most = Math.max(...marks.map(({ cost }) => cost)) * 1.15;
  const x = (cost) => LEFT + (cost / most) * (RIGHT - LEFT);
  const y = (log) => BOTTOM - ((log - low) / (high - low)) * (BOTTOM - TOP);
  const text = (x, y, words) => `<text x="${x}" y="${y}">${words}</text>`;
  let parts = "";
  for (let log = low; log <= high; log++) {
    parts += `<path d="M${LEFT} ${y(log)}H${RIGHT}"/>`;
    parts += text(LEFT - 24, y(log) + 4, Number(`1e${log}`));
  }
  const step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100].find((step) => most / step < 6) ?? 200;
  for (let cost = 0; cost <= most; cost += step) parts += text(x(cost), BOTTOM + 16, short(cost));
  for (const mark of marks) {
    const [cx, cy, [right, down]] = [x(mark.cost), y(log(mark)), SIDES[mark.name]];
    const name = text(cx + right, cy + down, mark.name);
    parts += `<g class="${mark.isSeen ? "seen" : ""}"><circle cx="${cx}" cy="${cy}" r="4"/>${name}</g>`;
  }
  const spoken = marks.map(({ name, cost, max }) => `${name}: ${short(cost)}, ${short(max)} texels`);
  return `<svg viewBox="0 0 340 226" role="img" aria-label="${spoken.join("; ")}">${parts}</svg>`;
}
