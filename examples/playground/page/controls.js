// The controls: made once, and set to show what is chosen.
import { heat } from "./model.js";
import { FORMATS, MODES, SCENES, SIZES } from "./scenes.js";
import { $, interpolates, modes, scene, short, state, waits } from "./state.js";

const ABOUT_MODES = {
  Exact: "Exact divides at every pixel: the standard to compare with.",
  Newton: "Newton, the default, corrects a guess at every pixel: as good as exact, without a division.",
  Fast: "Fast draws straight pieces, within the error below: for cores that multiply slowly. A texel is a pixel of a texture.",
  Affine: "Affine only adds. Textures bend in large triangles that are seen from the side.",
  Compact: "Compact is as exact as Newton in less flash, but divides at every pixel.",
};

/** A slider: its range in steps, how it shows a value, and how a value becomes a step and back. */
const slider = (id, name, [min, max, step], shows, [to, from], [get, set]) =>
  ({ id, name, min, max, step, shows, to, from, get, set });
const STEPS = [(value) => value, (step) => step];
const POWERS = [Math.log2, (step) => 2 ** step];
const DEGREES = [(value) => (value * 180) / Math.PI, (step) => (step * Math.PI) / 180];
const move = (change) => Object.assign(state.camera, change, { isHome: false });
const inCamera = (key) => [() => state.camera[key], (value) => move({ [key]: value })];

const SLIDERS = [
  slider("tolerance", "Largest error of Fast", [-6, 4, 0.25], (value) => `${short(value)} texel`, POWERS, [
    () => state.tolerance,
    (value) => (state.tolerance = value),
  ]),
  slider("fov", "Field of view", [10, 150, 1], (value) => `${DEGREES[0](value).toFixed(0)}°`, DEGREES, inCamera("fov")),
  slider("near", "Nearest distance drawn", [-5, 3, 0.25], short, POWERS, inCamera("near")),
  slider("far", "Farthest distance drawn", [0.5, 12, 0.25], () => short(state.camera.far), POWERS, [
    () => state.camera.far / state.camera.near,
    (ratio) => move({ far: Math.min(state.camera.near * ratio, 32000) }),
  ]),
  ...["right", "down"].map((way, axis) =>
    slider(`move-${way}`, `Move the picture ${way}`, [0, 1, 1 / 16], (value) => `${short(value)} pixel`, STEPS, [
      () => state.camera.shift[axis],
      (value) => move({ shift: state.camera.shift.with(axis, value) }),
    ]),
  ),
];

export function build() {
  $("scenes").innerHTML = SCENES.map(
    ({ name, about }, at) =>
      `<label title="${about}"><input type="radio" name="scene" value="${at}">${name}</label>`,
  ).join("");
  const options = (list) => list.map((name, at) => `<option value="${at}">${name}</option>`).join("");
  $("left").innerHTML = options(MODES);
  $("right").innerHTML = `${options(MODES)}<option value="-1">None</option>`;
  $("format").innerHTML = options(FORMATS.map(({ name }) => name));
  $("size").innerHTML = SIZES.map((size) => `<option>${size}</option>`).join("");
  $("sliders").innerHTML = SLIDERS.map(
    ({ id, name, min, max, step }) => `<div class="slider"><label for="${id}">${name}</label>
    <output for="${id}" id="${id}-value"></output><input type="range" id="${id}" min="${min}" max="${max}" step="${step}"></div>`,
  ).join("");
  const stops = Array.from({ length: 11 }, (_, at) => `rgb(${heat(at / 10).map(Math.round).join()})`);
  $("ramp").style.background = `linear-gradient(to right, ${stops.join()})`;
}

/** Copies a control's value to the state; returns whether it is valid. */
export function take({ id, name, type, value, checked }) {
  const slider = SLIDERS.find((slider) => slider.id === id);
  if (slider) slider.set(slider.from(Number(value)));
  else if (id in state) state[id] = type === "checkbox" ? checked : Number.isNaN(Number(value)) ? value : Number(value);
  return Boolean(slider) || id in state;
}

/** Makes controls show the state. */
export function controls() {
  for (const [id, value] of Object.entries(state)) {
    if ($(id)) $(id)[$(id).type === "checkbox" ? "checked" : "value"] = value;
  }
  for (const { id, to, get, shows } of SLIDERS) {
    // A slider that is being moved stays where it is.
    if (document.activeElement !== $(id)) $(id).value = to(get());
    $(`${id}-value`).textContent = shows(get());
    $(id).setAttribute("aria-valuetext", shows(get()));
    $(id).disabled = scene().is_world || (id === "tolerance" && !modes().includes(2));
  }
  $("scenes").querySelectorAll("input")[state.scene].checked = true;
  for (const id of ["left", "right", "format"]) $(id).disabled = scene().is_world;
  $("showsErrors").disabled = !interpolates();
  $("two-sided").hidden = scene().id !== "own";

  const compares = modes().length > 1;
  const label = (mode) => (MODES[mode] === "Fast" ? `Fast, ${short(state.tolerance)} texel` : MODES[mode]);
  $("divider").hidden = $("line").hidden = !compares;
  $("line").style.left = `${state.divider}%`;
  $("divider").setAttribute("aria-valuetext", `${state.divider} % in mode ${MODES[state.left]}`);
  $("left-name").textContent = compares ? label(state.left) : "";
  $("right-name").textContent = compares ? label(state.right) : "";
  $("about-mode").textContent = scene().is_world
    ? "The little world chooses its modes itself."
    : scene().id === "sphere-flat"
      ? "Every mode draws the same: nothing is interpolated."
      : [...new Set(modes())].map((mode) => ABOUT_MODES[MODES[mode]]).join(" ");
  $("legend").hidden = !(state.showsErrors && interpolates());
  $("figure").hidden = scene().is_world;
  $("hint").textContent = waits()
    ? "Drop a model here (.obj, .gltf or .glb), with a picture for its texture, or open files below."
    : "";
}
