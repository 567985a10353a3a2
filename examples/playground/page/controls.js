// What is chosen, and the controls that choose it.
import { FLAT_SPHERE, MODES, WORLD } from "./module.js";

export const $ = (id) => document.getElementById(id);
/** Three digits of a number. */
export const short = (value) => (Number.isFinite(value) ? String(+value.toPrecision(3)) : "–");

/** The sliders with their units, and those that choose the exponent of a power of 2. */
const UNITS = { tolerance: " texel", fov: "°", near: "", far: "", right: " pixel", down: " pixel" };
const EXPONENTS = ["tolerance", "near", "far"];

/** The scene and where its camera is, in settings of the module (src/view.rs). */
export const camera = {};

/** The settings of the module and of the page: the camera, and the values of controls by their ids. */
export function settings() {
  const found = { ...camera };
  for (const { id, type, value, checked } of document.querySelectorAll("select, input[id]"))
    found[id] = type === "checkbox" ? checked : Number.isNaN(Number(value)) ? value : Number(value);
  const { scene, size, mode, other, near, far } = found;
  const [width, height] = size.split("x").map(Number);
  Object.assign(found, { width, height, first_row: 0, rows: height, far: Math.max(far, near + 1 / 3) });
  found.modes = scene === WORLD || other < 0 ? [mode] : [mode, other];
  if (scene === WORLD) found.format = 0; // It has colors and modes of its own.
  found.interpolates = scene !== WORLD && scene !== FLAT_SPHERE;
  found.showsErrors &&= found.interpolates;
  return found;
}

/** Makes sliders show the camera. */
export function showCamera() {
  for (const id in UNITS) $(id).value = camera[id];
}

/** Makes what depends on the controls show the settings. */
export function showSettings() {
  const now = settings();
  for (const [id, unit] of Object.entries(UNITS)) {
    const told = short(EXPONENTS.includes(id) ? 2 ** now[id] : now[id]) + unit;
    $(id).previousElementSibling.value = told;
    $(id).setAttribute("aria-valuetext", told);
  }
  $("accuracy").disabled = $("format").disabled = $("cost").hidden = now.scene === WORLD;
  $("showsErrors").disabled = $("figure").hidden = !now.interpolates;
  $("tolerance").disabled = !now.modes.includes(2);
  $("legend").hidden = !now.showsErrors;

  const name = (mode) => (mode === 2 ? `Fast, ${short(2 ** now.tolerance)} texel` : MODES[mode]);
  $("left-name").textContent = name(now.mode);
  $("right-name").textContent = name(now.other);
  $("line").style.left = `${now.divider}%`;
  $("stage").className = now.modes.length > 1 ? "" : "whole";
  Object.assign($("canvas"), { width: now.width, height: now.height }); // clears it, too
}
