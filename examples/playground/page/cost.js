// The cost of a picture on a microcontroller, from the counts in tests/instructions.csv.

/** Cores that are estimated for: clock in Hz, and cycles for an instruction, without wait states (guide to modes). */
export const CORES = [
  { id: "thumbv6m-none-eabi", name: "Cortex-M0+", clock: 133e6, cycles: 1.45 },
  { id: "thumbv7em-none-eabi", name: "Cortex-M4", clock: 168e6, cycles: 1.35 },
];

/** The counts, as a function of core, mode, thing drawn and unit; undefined where nothing was counted. */
export function table(text) {
  const counts = new Map();
  for (const line of text.split("\n")) {
    const [core, , mode, what, per, count] = line.split(",");
    counts.set([core, mode, what, per].join(), Number(count));
  }
  return (...key) => counts.get(key.join());
}

/** The work of a picture, to compare pictures: its pixels and its triangles, each with the count of its loop alone. */
function work(count, core, kernel, [submitted, drawn, , pixels]) {
  const perPixel =
    kernel === "flat"
      ? count(core, "kernel", "flat", "1000 pixels")
      : count(core, "kernel", kernel, "1000 pixels") +
        count(core, "kernel", "newton-depth-pass", "1000 pixels") -
        count(core, "kernel", "newton", "1000 pixels");
  const perTriangle = count(core, "kernel", "setup-no-pixel", "1000 triangles");
  // A triangle that is turned away takes about a tenth.
  return (pixels * perPixel + (drawn + (submitted - drawn) / 10) * perTriangle) / 1000;
}

/**
 * Instructions for a picture: the count of the scene as it was measured, times the work now over the work then.
 * `counts` and `reference` are triangles in, drawn and clipped, and pixels.
 */
export function instructions(count, core, scene, mode, counts, reference) {
  if (!scene.counted || !reference) return undefined;
  const name = mode.toLowerCase();
  let measured = count(core, name, scene.counted, "frame");
  if (name === "compact") {
    const [compact, newton] = ["compact", "newton"].map((of) => count(core, of, scene.counted, "mean-of-poses"));
    measured = (count(core, "newton", scene.counted, "frame") * compact) / newton;
  }
  const kernel = scene.id === "sphere-flat" ? "flat" : ({ fast: "fast-16", compact: "exact" }[name] ?? name);
  const [now, then] = [counts, reference].map((of) => work(count, core, kernel, of));
  const estimate = (measured * now) / then;
  return Number.isFinite(estimate) ? estimate : undefined;
}
