// A plot of error against cost: a mark for each mode, a ring around those that are drawn.

const [WIDTH, HEIGHT, LEFT, BOTTOM, TOP, RIGHT] = [340, 240, 46, 34, 12, 14];

const tag = (name, attributes, inside = "") =>
  `<${name} ${Object.entries(attributes).map(([key, value]) => `${key}="${value}"`).join(" ")}>${inside}</${name}>`;

/** Marks have a name, a cost, an error in texels, and whether they are drawn now. */
export function plot(marks, unit) {
  const known = marks.filter(({ cost, error }) => Number.isFinite(cost) && cost > 0 && Number.isFinite(error));
  if (!known.length) return `<p class="about">Nothing to compare: no texture or color is interpolated here.</p>`;
  const most = Math.max(...known.map(({ cost }) => cost)) * 1.15;
  const logs = known.map(({ error }) => Math.log10(Math.max(error, 1e-6)));
  const [low, high] = [Math.floor(Math.min(...logs, -3)), Math.ceil(Math.max(...logs, 0))];
  const x = (cost) => LEFT + cost / most * (WIDTH - LEFT - RIGHT);
  const y = (log) => HEIGHT - BOTTOM - (log - low) / (high - low) * (HEIGHT - BOTTOM - TOP);
  const parts = [];
  for (let log = low; log <= high; log++) {
    parts.push(tag("line", { class: "axis", x1: LEFT, x2: WIDTH - RIGHT, y1: y(log), y2: y(log) }));
    const label = log < -3 ? `10${[..."" + log].map((sign) => "⁰¹²³⁴⁵⁶"[sign] ?? "⁻").join("")}` : String(10 ** log);
    parts.push(tag("text", { x: LEFT - 6, y: y(log) + 4, "text-anchor": "end" }, label));
  }
  const step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100].find((step) => most / step < 6) ?? 200;
  for (let cost = 0; cost <= most; cost += step) {
    parts.push(tag("text", { x: x(cost), y: HEIGHT - BOTTOM + 16, "text-anchor": "middle" }, +cost.toFixed(1)));
  }
  parts.push(tag("text", { x: WIDTH - RIGHT, y: HEIGHT - 3, "text-anchor": "end" }, unit));
  const taken = [];
  known.forEach(({ name, cost, here }, at) => {
    const [cx, cy] = [x(cost), y(logs[at])];
    if (here) parts.push(tag("circle", { class: "ring", cx, cy, r: 8 }));
    parts.push(tag("circle", { class: here ? "here" : "dot", cx, cy, r: 4 }));
    // A label to the right of its mark, or to the left near the border; below others that are in the way.
    const left = cx > WIDTH - 90;
    let row = cy + 4;
    while (taken.some(([tx, ty]) => Math.abs(tx - cx) < 80 && Math.abs(ty - row) < 12)) row += 12;
    taken.push([cx, row]);
    parts.push(tag("text", { class: "name", x: cx + (left ? -11 : 11), y: row, "text-anchor": left ? "end" : "start" }, name));
  });
  const spoken = known.map(({ name, cost, error }) => `${name}: ${cost.toPrecision(3)}, ${error.toPrecision(2)} texels`);
  return tag("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": `Largest error. ${spoken.join("; ")}` },
    parts.join(""));
}
