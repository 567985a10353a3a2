// A plot of error against cost: a mark for each mode, a ring around those that are drawn.

const [WIDTH, HEIGHT, LEFT, BOTTOM, TOP, RIGHT] = [340, 240, 46, 34, 12, 14];

const tag = (name, attributes, inside = "") =>
  `<${name} ${Object.entries(attributes)
    .map(([key, value]) => `${key}="${value}"`)
    .join(" ")}>${inside}</${name}>`;

/** Marks have a name, a cost, an error in texels, and whether they are drawn now. */
export function plot(marks, unit) {
  const known = marks.filter(({ cost, error }) => Number.isFinite(cost) && cost > 0 && Number.isFinite(error));
  if (known.length == 0 && marks.some(({ error }) => Number.isFinite(error)))
    return `<p class="about">No cost is known yet.</p>`;
  if (known.length == 0)
    return `<p class="about">Nothing to compare: nothing is interpolated here, so every mode draws the same.</p>`;
  const most = Math.max(...known.map(({ cost }) => cost)) * 1.15;
  const logs = known.map(({ error }) => Math.log10(Math.max(error, 1e-6)));
  const [low, high] = [Math.floor(Math.min(...logs, -3)), Math.ceil(Math.max(...logs, 0))];
  const x = (cost) => LEFT + (cost / most) * (WIDTH - LEFT - RIGHT);
  const y = (log) => HEIGHT - BOTTOM - ((log - low) / (high - low)) * (HEIGHT - BOTTOM - TOP);
  const parts = [];
  for (let log = low; log <= high; log++) {
    parts.push(tag("line", { class: "axis", x1: LEFT, x2: WIDTH - RIGHT, y1: y(log), y2: y(log) }));
    const label = log < -3 ? `10${[...("" + log)].map((sign) => "⁰¹²³⁴⁵⁶"[sign] ?? "⁻").join("")}` : String(10 ** log);
    parts.push(tag("text", { x: LEFT - 6, y: y(log) + 4, "text-anchor": "end" }, label));
  }
  const step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100].find((step) => most / step < 6) ?? 200;
  for (let cost = 0; cost <= most; cost += step) {
    parts.push(tag("text", { x: x(cost), y: HEIGHT - BOTTOM + 16, "text-anchor": "middle" }, +cost.toFixed(1)));
  }
  parts.push(tag("text", { x: WIDTH - RIGHT, y: HEIGHT - 3, "text-anchor": "end" }, unit));
  // Each label goes to the first place beside its mark that is free.
  const taken = known.map(({ cost }, at) => [x(cost) - 6, y(logs[at]) - 6, 12, 12]);
  const isFree = ([left, top, width, height]) =>
    left > LEFT &&
    left + width < WIDTH &&
    !taken.some(([l, t, w, h]) => left < l + w && l < left + width && top < t + h && t < top + height);
  known.forEach(({ name, cost, here }, at) => {
    const [cx, cy, width] = [x(cost), y(logs[at]), 6.2 * name.length];
    if (here) parts.push(tag("circle", { class: "ring", cx, cy, r: 8 }));
    parts.push(tag("circle", { class: here ? "here" : "dot", cx, cy, r: 4 }));
    const places = [0, -12, 12, -24, 24, -36, 36].flatMap((dy) =>
      [11, -11 - width].map((dx) => [cx + dx, cy - 6 + dy, width, 11]),
    );
    const place = places.find(isFree) ?? places[0];
    taken.push(place);
    parts.push(tag("text", { class: "name", x: place[0], y: place[1] + 10 }, name));
  });
  const spoken = known.map(
    ({ name, cost, error }) => `${name}: ${cost.toPrecision(3)}, ${error.toPrecision(2)} texels`,
  );
  return tag(
    "svg",
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": `Largest error. ${spoken.join("; ")}` },
    parts.join(""),
  );
}
