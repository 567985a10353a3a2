// A segment and its picture, seen from above: a point on one moves on the other. The crate computes both.
import { $, short } from "./controls.js";

/** The screen's distance from the eye. Distances are those ahead of the eye, and run to the right. */
const NEAR = 0.7;
const [EYE, UNIT, MIDDLE] = [[24, 125], 130, 125];
/** The ends of the segment: distance, and place to the left of the line of sight. */
const ends = [[1, 0.62], [4, -0.72]];
/** Fractions of picture and segment. */
let at;
let crate;

const x = (distance) => EYE[0] + distance * UNIT;
const y = (left) => MIDDLE - left * UNIT;
const image = ([distance, left]) => (left / distance) * NEAR;
const mix = (from, to, fraction) => from + (to - from) * fraction;
const inSpace = (fraction) => [0, 1].map((axis) => mix(ends[0][axis], ends[1][axis], fraction));

const line = ([a, b], [c, d], kind = "") => `<line class="${kind}" x1="${x(a)}" y1="${y(b)}" x2="${x(c)}" y2="${y(d)}"/>`;
const words = ([a, b], text, right = 0, down = 0) => `<text x="${x(a) + right}" y="${y(b) + down}">${text}</text>`;
const point = (id, [a, b], radius, kind = "") =>
  `<circle id="${id}" class="${kind}" cx="${x(a)}" cy="${y(b)}" r="${radius}"/>`;

/** Moves the point to a fraction, and draws. */
function move(fraction, isInSpace) {
  at = crate.foreshorten(ends[0][0], ends[1][0], Math.max(0, Math.min(fraction, 1)), isInSpace);
  const [first, last] = ends.map(image);
  const screen = (q) => [NEAR, mix(first, last, q)];
  // Ten equal steps on the screen, and where their rays meet the segment.
  const steps = Array.from({ length: 11 }, (_, step) => crate.foreshorten(ends[0][0], ends[1][0], step / 10, false));
  const rays = steps.map((step) => line([0, 0], inSpace(step.inSpace), "ray"));
  const dots = steps.flatMap((step) => [point("", screen(step.onScreen), 2.5), point("", inSpace(step.inSpace), 2.5)]);
  $("segment").innerHTML = [
    ...rays,
    line([0, 0], inSpace(at.inSpace), "point"),
    line([NEAR, 0.9], [NEAR, -0.9]),
    line(...ends, "bar"),
    ...dots,
    point("eye", [0, 0], 6),
    ...ends.map((end, index) => point(`end${index}`, end, 7)),
    point("pixel", screen(at.onScreen), 7, "seen"),
    point("place", inSpace(at.inSpace), 7, "seen"),
    words([0, 0], "eye", 0, 24),
    words([NEAR, -0.9], "screen", 36, 0),
    words(screen(at.onScreen), `q = ${short(at.onScreen)}`, -42, -8),
    words(inSpace(at.inSpace), `t = ${short(at.inSpace)}`, 4, -14),
    ...ends.map((end, index) => words(end, `z${"₀₁"[index]} = ${short(end[0])}`, 0, [-14, 24][index])),
  ].join("");
  for (const [id, value] of [["on_screen", at.onScreen], ["in_space", at.inSpace]]) {
    $(id).value = value;
    $(id).previousElementSibling.value = short(value);
  }
  const [z0, z1] = ends.map(([distance]) => short(distance));
  $("formula").textContent =
    `t = q·z₀ / (z₁ − q·(z₁ − z₀)) = ${short(at.inSpace)}, and 1/z = 1/${z0} + q·(1/${z1} − 1/${z0}), so z = ${short(at.distance)}.`;
}

/** What is dragged: moves it to a place. */
const DRAGS = {
  pixel: (_, left) => move((left - image(ends[0])) / (image(ends[1]) - image(ends[0])), false),
  place: (distance, left) => {
    const [[a, b], [c, d]] = ends;
    move(((distance - a) * (c - a) + (left - b) * (d - b)) / ((c - a) ** 2 + (d - b) ** 2), true);
  },
  end0: (distance, left) => pull(0, distance, left),
  end1: (distance, left) => pull(1, distance, left),
};
function pull(index, distance, left) {
  ends[index] = [Math.max(NEAR, Math.min(distance, 4.6)), Math.max(-0.85, Math.min(left, 0.85))];
  move(at.onScreen, false);
}

export function showSegment(module) {
  crate = module;
  move(0.5, false);
  const picture = $("segment");
  let dragged;
  picture.onpointerdown = (event) => {
    dragged = DRAGS[event.target.id];
    if (dragged) picture.setPointerCapture(event.pointerId);
  };
  picture.onpointerup = picture.onpointercancel = () => (dragged = undefined);
  picture.onpointermove = (event) => {
    if (!dragged) return;
    const { left, top, width, height } = picture.getBoundingClientRect();
    const [right, down] = [((event.clientX - left) / width) * 640, ((event.clientY - top) / height) * 250];
    dragged((right - EYE[0]) / UNIT, (MIDDLE - down) / UNIT);
  };
  $("perspective").oninput = (event) => {
    event.stopPropagation(); // nothing of the picture above changes
    move(Number(event.target.value), event.target.id === "in_space");
  };
}
