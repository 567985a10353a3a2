// What is chosen, and the controls that choose it.
import { FLAT_SPHERE, MODES, NEWTON, WORLD } from "./module.js";

export const $ = (id) => document.getElementById(id);
/** Three digits of a number. */
export const short = (value) => (Number.isFinite(value) ? String(+value.toPrecision(3)) : "–");

/** The sliders with their units, and those that choose the exponent of a power of 2. */
const UNITS = { tolerance: " texel", fov: "°", near: "", far: "", right: " pixel", down: " pixel" };
const EXPONENTS = ["tolerance", "near", "far"];

/** What a mode does, in the order of the modes. */
const ABOUT = [
  "Exact divides at every pixel. It is the standard to compare with.",
  "Newton, the default, computes one reciprocal of depth for each pixel, without a division. It is correct to 1/32 texel.",
  "Fast draws straight pieces of texture, as long as the largest error allows. It suits cores that multiply slowly.",
  "Affine only adds. It costs the least, but textures bend and swim in large triangles that are seen from the side.",
  "Compact divides at every pixel, too. It is as exact as Exact, and takes less flash.",
];

/** Controls of the camera and its picture. The little world has its own. */
const OF_CAMERA = ["fov", "near", "far", "right", "down", "is_two_sided"];

/** The scene and where its camera is, in settings of the module (src/view.rs). */
export const camera = {};

/** The settings of the module and of the page: the camera, and the values of controls by their ids. */
export function settings() {
  const found = { ...camera };
  for (const { id, type, value, checked } of document.querySelectorAll("select, input[id]"))
    found[id] = type === "checkbox" ? checked : Number.isNaN(Number(value)) ? value : Number(value);
  const { scene, size, mode, other, compares, near, far } = found;
  const [width, height] = size.split("x").map(Number);
  Object.assign(found, { width, height, first_row: 0, rows: height, far: Math.max(far, near + 1 / 3) });
  found.modes = compares ? [mode, other] : [mode];
  // The little world has a mode and colors of its own.
  if (scene === WORLD) Object.assign(found, { mode: NEWTON, modes: [NEWTON], compares: false, format: 0 });
  found.interpolates = scene !== WORLD && scene !== FLAT_SPHERE;
  found.showsErrors &&= found.compares && found.interpolates;
  return found;
}

/** Controls whose values an address keeps, besides those of the camera. */
const kept = () => [...document.querySelectorAll("#side select, [type=checkbox], #tolerance, #divider")];
/** The part of the camera that the visitor moves. */
const VIEW = ["yaw", "pitch", "distance", "fov", "near", "far", "right", "down"];
/** The value of a control as the page begins. */
function initial({ type, options, defaultChecked, defaultValue }) {
  if (options) return ([...options].find((option) => option.defaultSelected) ?? options[0]).value;
  return type === "checkbox" ? String(defaultChecked) : defaultValue || "50"; // the middle, where a slider begins
}
const value = ({ type, checked, value }) => (type === "checkbox" ? String(checked) : value);

/** Writes what differs from the scene's start view into the page's address. */
export function keep(home) {
  const found = { ...camera, ...settings() };
  const changed = kept().filter((control) => value(control) !== initial(control));
  const changes = changed.map((control) => [control.id, value(control)]);
  const moves = VIEW.filter((name) => Math.abs(found[name] - home[name]) > 1e-3).map((name) => [name, String(+found[name].toPrecision(5))]);
  history.replaceState(null, "", `#${new URLSearchParams([["scene", camera.scene], ...moves, ...changes])}`);
}

/** Sets the controls as the address says; returns the scene and the view that it has kept. */
export function recall() {
  const found = new URLSearchParams(location.hash.slice(1));
  for (const control of kept()) {
    const wanted = found.get(control.id);
    const exists = ({ value, disabled }) => value === wanted && !disabled;
    if (wanted === null || (control.options && ![...control.options].some(exists))) continue;
    if (control.type === "checkbox") control.checked = wanted === "true";
    else control.value = wanted;
  }
  const numbers = ["scene", ...VIEW].map((name) => [name, parseFloat(found.get(name))]);
  return Object.fromEntries(numbers.filter(([, number]) => Number.isFinite(number)));
}

/** Angles that differ from the scene's start view become tenths of a degree, which the printed program can name. */
export function roundAngles(home) {
  const rounded = (name, now) => (Math.abs(now - home[name]) < 1e-9 ? now : Math.round(now * 10) / 10);
  for (const name of ["yaw", "pitch"]) camera[name] = rounded(name, camera[name]);
  $("fov").value = rounded("fov", Number($("fov").value));
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
  for (const id of [...OF_CAMERA, "format"]) $(id).disabled = now.scene === WORLD;
  $("cost").hidden = now.scene === WORLD;
  $("modes").hidden = !now.compares;
  $("showsErrors").disabled = $("figure").hidden = !now.interpolates;
  $("tolerated").hidden = !now.modes.includes(2);
  $("legend").hidden = !now.showsErrors;

  const about = now.modes.map((mode, side) => `<b>${["Left", "Right"][side]}:</b> ${ABOUT[mode]}`);
  about.unshift("A mode decides how exactly textures follow perspective. Drag the line to compare two modes.");
  $("about").innerHTML = now.compares ? about.join("<br>") : "";
  const name = (mode) => (mode === 2 ? `Fast, ${short(2 ** now.tolerance)} texel` : MODES[mode]);
  $("left-name").textContent = name(now.mode);
  $("right-name").textContent = name(now.other);
  $("line").style.left = `${now.divider}%`;
  $("stage").className = now.modes.length > 1 ? "" : "whole";
  // The picture stays until the next one is drawn: another size would clear it.
  const { width, height } = $("canvas");
  if (width !== now.width || height !== now.height) Object.assign($("canvas"), { width: now.width, height: now.height });
}
