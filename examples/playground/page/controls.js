// The controls: made once, and set to show what is chosen.
import { heat } from "./model.js";
import { FORMATS, MODES, SCENES, SIZES } from "./scenes.js";
import { $, interpolates, modes, scene, short, state } from "./state.js";

const ABOUT_MODES = {
  Exact: "Exact divides at every pixel: the standard to compare with.",
  Newton: "Newton, the default, corrects a guess at every pixel: as good as exact, without a division.",
  Fast: "Fast draws straight pieces that stay within the tolerance: for cores that multiply slowly.",
  Affine: "Affine only adds. Textures bend in large triangles that are seen from the side.",
  Compact: "Compact is as exact as Newton in less flash, but divides at every pixel.",
};

const log = { to: (value) => Math.log2(value), from: (at) => 2 ** at };
const camera = (key) => ({
  get: () => state.camera[key],
  set: (value) => Object.assign(state.camera, { [key]: value, isHome: false }),
});
export const SLIDERS = [
  {
    id: "tolerance",
    name: "Tolerance of Fast",
    min: -6,
    max: 4,
    step: 0.25,
    ...log,
    shows: (value) => `${short(value)} ${value === 1 ? "texel" : "texels"}`,
    get: () => state.tolerance,
    set: (value) => {
      state.tolerance = value;
    },
    usable: () => modes().includes(2),
  },
  {
    id: "fov",
    name: "Field of view",
    min: 10,
    max: 150,
    step: 1,
    to: (value) => (value * 180) / Math.PI,
    from: (at) => (at * Math.PI) / 180,
    shows: (value) => `${((value * 180) / Math.PI).toFixed(0)}°`,
    ...camera("fov"),
  },
  { id: "near", name: "Near plane", min: -5, max: 3, step: 0.25, ...log, ...camera("near"), unit: "" },
  {
    id: "ratio",
    name: "Far plane, times the near one",
    min: 0.5,
    max: 12,
    step: 0.25,
    ...log,
    unit: "",
    get: () => state.camera.far / state.camera.near,
    set: (value) => Object.assign(state.camera, { far: Math.min(state.camera.near * value, 32000), isHome: false }),
  },
  ...["right", "down"].map((way, axis) => ({
    id: `moved-${way}`,
    name: `Moved ${way} by`,
    min: 0,
    max: 1,
    step: 1 / 16,
    to: (value) => value,
    from: (at) => at,
    unit: " pixel",
    get: () => state.camera.shift[axis],
    set: (value) => {
      state.camera.shift[axis] = value;
      state.camera.isHome = false;
    },
  })),
];
export function build() {
  $("scenes").innerHTML = SCENES.map(
    ({ name, about }, at) => `<label title="${about}"><input type="radio" name="scene" value="${at}"
    ${at === state.scene ? "checked" : ""}>${name}</label>`,
  ).join("");
  const options = (list, chosen) =>
    list.map((name, at) => `<option value="${at}" ${at === chosen ? "selected" : ""}>${name}</option>`).join("");
  $("left").innerHTML = options(MODES, state.left);
  $("right").innerHTML = options(MODES, state.right) + `<option value="-1">None</option>`;
  $("format").innerHTML = options(
    FORMATS.map(({ name }) => name),
    0,
  );
  $("size").innerHTML = SIZES.map((size) => `<option ${size === "320x240" ? "selected" : ""}>${size}</option>`).join(
    "",
  );
  $("sliders").innerHTML = SLIDERS.map(
    ({ id, name, min, max, step }) => `<div class="slider"><label for="${id}">${name}</label>
    <output for="${id}" id="${id}-value"></output><input type="range" id="${id}" min="${min}" max="${max}" step="${step}"></div>`,
  ).join("");
  const ramp = $("ramp").getContext("2d");
  for (let x = 0; x < 240; x++) {
    ramp.fillStyle = `rgb(${heat(x / 239).join()})`;
    ramp.fillRect(x, 0, 1, 10);
  }
}

/** Makes controls show the state. */
export function controls() {
  const compares = modes().length > 1;
  const percent = Math.round(state.divider * 100);
  $("divider").hidden = !compares;
  $("divider").style.left = `${percent}%`;
  $("divider").setAttribute("aria-valuenow", percent);
  $("divider").setAttribute("aria-valuetext", `${percent} % in mode ${MODES[state.left]}`);
  const label = (mode) => (MODES[mode] === "Fast" ? `Fast, ${short(state.tolerance)} texel` : MODES[mode]);
  $("left-name").textContent = compares ? label(state.left) : "";
  $("right-name").textContent = compares ? label(state.right) : "";
  const told = [...new Set(modes())].map((mode) => ABOUT_MODES[MODES[mode]]).join(" ");
  $("about-mode").textContent = scene().is_world
    ? "The little world chooses its modes itself."
    : scene().id === "sphere-flat"
      ? "Every mode draws the same: nothing is interpolated."
      : told;
  $("legend").hidden = !(state.showsErrors && interpolates());
  $("errors").checked = state.showsErrors;
  $("errors").disabled = !interpolates();
  $("spin").checked = state.spins;
  $("two-sided-label").hidden = scene().id !== "own";
  $("hint").textContent =
    scene().id === "own" && !state.hasModel
      ? "Drop a model here (.obj, .gltf or .glb), with a picture for its texture, or open files below."
      : "";
  for (const id of ["left", "right"]) $(id).disabled = scene().is_world;
  for (const { id, to, get, shows, unit, usable } of SLIDERS) {
    const slider = $(id);
    slider.disabled = scene().is_world || usable?.() === false;
    if (document.activeElement !== slider) slider.value = to(get());
    $(`${id}-value`).textContent = shows ? shows(get()) : short(get()) + unit;
    slider.setAttribute("aria-valuetext", $(`${id}-value`).textContent);
  }
}
