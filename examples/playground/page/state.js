// What is chosen, how it is told, and the controls that choose.
import { WORLD } from "./module.js";

export const $ = (id) => document.getElementById(id);

export const MODES = ["Exact", "Newton", "Fast", "Affine", "Compact"];
export const [SPHERE, FLAT_SPHERE, LIGHTHOUSE, OWN] = [2, 3, 4, 5];

/** The module's settings (src/view.rs), and the page's own. A key that is a control's id has its value. */
export const state = {
  scene: LIGHTHOUSE,
  mode: 1,
  other: 3,
  divider: 50,
  tolerance: 0.25,
  width: 320,
  height: 240,
  size: "320x240",
  format: 0,
  band: 16,
  axis: "time",
  is_two_sided: false,
  showsErrors: false,
  spins: false,
  model: null,
};

export const isWorld = () => state.scene === WORLD;
/** The module's settings for one of the modes. */
export const view = (mode = state.mode) => ({ ...state, mode, format: isWorld() ? 0 : state.format });
/** Whether the page waits for the visitor's model. */
export const waits = () => state.scene === OWN && !state.model;
/** The modes that are seen. The little world has its own. */
export const modes = () =>
  isWorld() ? [1] : state.other < 0 || waits() ? [state.mode] : [state.mode, state.other];
/** Whether a mode makes a difference that can be measured. */
export const interpolates = () => !isWorld() && state.scene !== FLAT_SPHERE && !waits();

/** A power of ten, as text. */
export const power = (exponent) => "10" + String(exponent).replace(/./g, (sign) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[sign] ?? "⁻");
/** Three digits of a number, small ones with a power of ten. */
export function short(value) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0 || value >= 0.001) return String(+value.toPrecision(3));
  const [digits, exponent] = value.toExponential(1).split("e");
  return `${digits} · ${power(exponent)}`;
}

/** The sliders of a camera, which is then no longer the start; and those that choose a power of 2. */
const CAMERA = ["fov", "near", "far", "right", "down"];
const POWERS = ["tolerance", "near", "far"];

/** Takes a control's value into the state; whether it is one. */
export function take({ id, type, value, checked }) {
  if (!(id in state)) return false;
  state[id] = type === "checkbox" ? checked : Number.isNaN(Number(value)) ? value : Number(value);
  if (POWERS.includes(id)) state[id] = 2 ** value;
  if (CAMERA.includes(id)) state.is_home = 0;
  [state.width, state.height] = state.size.split("x").map(Number);
  state.far = Math.max(state.far, state.near * 1.25);
  return true;
}

const ABOUT_MODES = [
  "Exact divides at every pixel: the standard to compare with.",
  "Newton, the default, corrects a guess at every pixel: as good as exact, without a division.",
  "Fast draws straight pieces, within the error below: for cores that multiply slowly.",
  "Affine only adds. Textures bend in large triangles that are seen from the side.",
  "Compact is as exact as Newton in less flash, but divides at every pixel.",
];

/** Makes controls show the state. */
export function controls() {
  for (const [id, value] of Object.entries(state)) {
    const control = $(id);
    if (!control) continue;
    if (control.type === "range" && control.dataset.unit !== undefined) {
      // A slider that is being moved stays where it is.
      if (document.activeElement !== control) control.value = POWERS.includes(id) ? Math.log2(value) : value;
      const told = short(value) + control.dataset.unit;
      control.setAttribute("aria-valuetext", told);
      control.parentElement.querySelector("output").value = told;
      control.disabled = isWorld() || (id === "tolerance" && !modes().includes(2));
    } else control[control.type === "checkbox" ? "checked" : "value"] = value;
  }
  $("scenes").querySelectorAll("input")[state.scene].checked = true;
  for (const id of ["mode", "other", "format"]) $(id).disabled = isWorld();
  $("showsErrors").disabled = !interpolates();
  $("two-sided").hidden = state.scene !== OWN;

  const compares = modes().length > 1;
  const label = (mode) => (mode === 2 ? `Fast, ${short(state.tolerance)} texel` : MODES[mode]);
  $("divider").hidden = $("line").hidden = !compares;
  $("line").style.left = `${state.divider}%`;
  $("divider").setAttribute("aria-valuetext", `${state.divider} % in mode ${MODES[state.mode]}`);
  $("left-name").textContent = compares ? label(state.mode) : "";
  $("right-name").textContent = compares ? label(state.other) : "";
  $("about-mode").textContent = isWorld()
    ? "The little world chooses its modes itself."
    : state.scene === FLAT_SPHERE
      ? "Every mode draws the same: nothing is interpolated."
      : [...new Set(modes())].map((mode) => ABOUT_MODES[mode]).join(" ");
  $("legend").hidden = !(state.showsErrors && interpolates());
  $("figure").hidden = isWorld();
  $("hint").textContent = waits()
    ? "Drop a model here (.obj, .gltf or .glb), with a picture for its texture, or open files below."
    : "";
}
