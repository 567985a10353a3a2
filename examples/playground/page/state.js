// The state of the choices, and who is told when it changes.
import { SCENES, home, settings } from "./scenes.js";

export const $ = (id) => document.getElementById(id);

/** The keys that are ids of controls have their values. */
export const state = {
  scene: 4,
  camera: home(4),
  left: 1,
  right: 3,
  divider: 50,
  tolerance: 0.25,
  size: "320x240",
  format: 0,
  rows: 16,
  axis: "time",
  isTwoSided: false,
  showsErrors: false,
  spins: false,
  model: null,
};

export const scene = () => SCENES[state.scene];
export const view = (mode = state.left) => settings(state, mode);
/** The colors that are shown: the little world has its own. */
export const format = () => (scene().is_world ? 0 : state.format);
/** Whether the page waits for the visitor's model. */
export const waits = () => scene().id === "own" && !state.model;
/** The modes that are seen. */
export const modes = () => (scene().is_world ? [1] : state.right < 0 || waits() ? [state.left] : [state.left, state.right]);
/** Whether a mode makes a difference that can be measured. */
export const interpolates = () => !scene().is_world && scene().id !== "sphere-flat" && !waits();

export const whole = (value) => Math.round(value).toLocaleString("en");
/** Three digits of a number, small ones with a power of ten. */
export function short(value) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0 || value >= 0.001) return String(+value.toPrecision(3));
  const [digits, power] = value.toExponential(1).split("e-");
  return `${digits} · 10⁻${[...power].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]).join("")}`;
}
