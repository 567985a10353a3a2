// What is chosen, and the controls that choose it.
import { WORLD } from "./module.js";

export const $ = (id) => document.getElementById(id);

export const MODES = ["Exact", "Newton", "Fast", "Affine", "Compact"];
export const [FLOOR, FLAT_SPHERE, LIGHTHOUSE, OWN] = [0, 3, 4, 5];

/** The module's settings (src/view.rs), and the page's own. A key that is a control's id has its value. */
export const state = {
  scene: LIGHTHOUSE, mode: 1, other: 3, divider: 50, tolerance: 0.25, is_two_sided: false,
  size: "320x240", width: 320, height: 240, format: 0, band: 16,
  axis: "time", showsErrors: false, spins: false,
};

/** The sliders with their units, and those that choose a power of 2. */
const UNITS = { tolerance: " texel", fov: "°", near: "", far: "", right: " pixel", down: " pixel" };
const POWERS = ["tolerance", "near", "far"];

const isWorld = () => state.scene === WORLD;
/** Whether modes make a difference that can be measured. */
const interpolates = () => !isWorld() && state.scene !== FLAT_SPHERE;
export const showsErrors = () => state.showsErrors && interpolates();
/** The modes that are seen. The little world has its own. */
export const modes = () => (isWorld() ? [1] : state.other < 0 ? [state.mode] : [state.mode, state.other]);
/** The module's settings for a picture. */
export const settings = (mode = modes()[0]) =>
  ({ ...state, mode, format: isWorld() ? 0 : state.format, first_row: 0, rows: state.height });

/** Three digits of a number. */
export const short = (value) => (Number.isFinite(value) ? String(+value.toPrecision(3)) : "–");

/** Takes a control's value into the state. */
export function take({ id, type, value, checked }) {
  const number = POWERS.includes(id) ? 2 ** value : Number(value);
  state[id] = type === "checkbox" ? checked : Number.isNaN(number) ? value : number;
  [state.width, state.height] = state.size.split("x").map(Number);
  state.far = Math.max(state.far, state.near * 1.25);
}

/** Makes controls show the state. */
export function showState() {
  for (const [id, value] of Object.entries(state)) {
    const control = $(id);
    if (id in UNITS) {
      control.value = POWERS.includes(id) ? Math.log2(value) : value;
      control.previousElementSibling.value = short(value) + UNITS[id];
      control.setAttribute("aria-valuetext", short(value) + UNITS[id]);
    } else if (control) control[control.type === "checkbox" ? "checked" : "value"] = value;
  }
  $("accuracy").disabled = $("format").disabled = isWorld();
  $("tolerance").disabled = !modes().includes(2);
  $("showsErrors").disabled = !interpolates();

  const name = (mode) => (mode === 2 ? `Fast, ${short(state.tolerance)} texel` : MODES[mode]);
  $("stage").classList.toggle("whole", modes().length < 2);
  $("left-name").textContent = name(state.mode);
  $("right-name").textContent = name(state.other);
  $("line").style.left = `${state.divider}%`;
  $("legend").hidden = !showsErrors();
  $("figure").hidden = !interpolates();
  $("cost").hidden = isWorld();
}
