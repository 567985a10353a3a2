// What is chosen, and how it is told.
import { SCENES, home, settings } from "./scenes.js";

export const $ = (id) => document.getElementById(id);
/** Tells what went wrong. A drawing that succeeds takes back only what a drawing told. */
export function trouble(text, teller = "") {
  if (!text && teller && teller !== told) return;
  told = teller;
  Object.assign($("trouble"), { hidden: !text, textContent: text });
}
let told = "";
export const whole = (value) => Math.round(value).toLocaleString("en");
export const short = (value) =>
  value === undefined || !Number.isFinite(value)
    ? "–"
    : value === 0
      ? "0"
      : value < 0.001
        ? value
            .toExponential(1)
            .replace("e-", " · 10⁻")
            .replace(/\d$/, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit])
        : String(+value.toPrecision(3));

export const state = {
  scene: 4,
  camera: home(4),
  left: 1,
  right: 3,
  divider: 0.5,
  tolerance: 0.25,
  width: 320,
  height: 240,
  format: 0,
  isTwoSided: false,
  showsErrors: false,
  spins: false,
  hasModel: false,
};

export const scene = () => SCENES[state.scene];
export const modes = () => (scene().is_world ? [1] : state.right < 0 ? [state.left] : [state.left, state.right]);
export const view = (mode = state.left) => settings(state, mode);
/** Whether a mode makes a difference that can be measured. */
export const interpolates = () =>
  !scene().is_world && scene().id !== "sphere-flat" && (scene().id !== "own" || state.hasModel);
