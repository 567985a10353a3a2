// A plot of error against cost: a mark for each mode, a ring around those that are drawn.
import { power, short } from "./state.js";

const [WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM] = [340, 240, 46, 326, 12, 206];

const text = (x, y, words, kind) => `<text class="${kind}" x="${x}" y="${y}">${words}</text>`;

/** Marks have a name, a cost, an error in texels, and whether they are drawn now. */
export function plot(marks, unit) {
  const known = marks.filter(({ cost, error }) => cost > 0 && Number.isFinite(error));
  if (!known.length)
    return `<p class="about">Nothing to compare: nothing is interpolated here, so every mode draws the same.</p>`;
  const most = Math.max(...known.map(({ cost }) => cost)) * 1.15;
  const logs = known.map(({ error }) => Math.log10(Math.max(error, 1e-6)));
  const [low, high] = [Math.floor(Math.min(...logs, -3)), Math.ceil(Math.max(...logs, 0))];
  const x = (cost) => LEFT + (cost / most) * (RIGHT - LEFT);
  const y = (log) => BOTTOM - ((log - low) / (high - low)) * (BOTTOM - TOP);
  let parts = text(RIGHT, HEIGHT - 3, unit, "end");
  for (let log = low; log <= high; log++) {
    parts += `<path class="axis" d="M${LEFT} ${y(log)}H${RIGHT}"/>`;
    parts += text(LEFT - 6, y(log) + 4, log < -3 ? power(log) : 10 ** log, "end");
  }
  const step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100].find((step) => most / step < 6) ?? 200;
  for (let cost = 0; cost <= most; cost += step) parts += text(x(cost), BOTTOM + 16, +cost.toFixed(1), "middle");
  // Each label goes to the first place beside its mark that is free.
  const taken = known.map(({ cost }, at) => [x(cost) - 6, y(logs[at]) - 6, 12, 12]);
  const isFree = ([left, top, width, height]) =>
    left > LEFT &&
    left + width < WIDTH &&
    !taken.some(([l, t, w, h]) => left < l + w && l < left + width && top < t + h && t < top + height);
  known.forEach(({ name, cost, here }, at) => {
    const [cx, cy, width] = [x(cost), y(logs[at]), 6.8 * name.length];
    if (here) parts += `<circle class="ring" cx="${cx}" cy="${cy}" r="8"/>`;
    parts += `<circle class="${here ? "here" : "dot"}" cx="${cx}" cy="${cy}" r="4"/>`;
    const places = [0, -12, 12, -24, 24, -36, 36].flatMap((dy) =>
      [11, -11 - width].map((dx) => [cx + dx, cy - 6 + dy, width, 11]),
    );
    const place = places.find(isFree) ?? places[0];
    taken.push(place);
    parts += text(place[0], place[1] + 10, name, "name");
  });
  const spoken = known.map(({ name, cost, error }) => `${name}: ${short(cost)}, ${short(error)} texels`);
  const label = `Largest error. ${spoken.join("; ")}`;
  return `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${label}">${parts}</svg>`;
}
