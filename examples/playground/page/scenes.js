// The choices, and the numbers that the crate gets for each.
import { fixed, turn } from "./module.js";

const rounded = (radians) => fixed(radians) / 65536;
// The measured scenes: 200 pixels of focal length at 240 rows.
const measured = { fov: 2 * Math.atan(0.6), near: 0.25, far: 100, scale: 1, center: [0, 0, 0] };
const sphere = { ...measured, yaw: rounded(0.2), pitch: rounded(0.35), distance: 2.2562392237 };

/** Scenes in the module's order, with the camera in which each is measured. */
export const SCENES = [
  {
    id: "floor",
    name: "Floor",
    about: "2 triangles, textured, from near to far",
    counted: "floor",
    ...measured,
    yaw: 0,
    pitch: (134932750 / 2 ** 32) * 2 * Math.PI,
    distance: 0,
    center: [0, 1, 0],
  },
  {
    id: "cube",
    name: "Cube",
    about: "12 textured triangles",
    counted: "cube",
    ...measured,
    yaw: rounded(0.4),
    pitch: rounded(0.3),
    distance: 3.133832458,
  },
  { id: "sphere", name: "Sphere", about: "1,984 triangles with colors at their corners", counted: "sphere", ...sphere },
  {
    id: "sphere-flat",
    name: "Flat sphere",
    about: "1,984 triangles of one color each, without a depth buffer",
    counted: "sphere-flat",
    ...sphere,
  },
  {
    id: "lighthouse",
    name: "Lighthouse",
    about: "1,176 textured triangles in the sun",
    counted: "default",
    ...measured,
    fov: (40 / 180) * Math.PI,
    near: 1,
    far: 140,
    center: [0.45, 1.62, 0],
    yaw: -Math.atan2(2.95, 8.4),
    pitch: Math.atan2(1.48, Math.hypot(2.95, 8.4)),
    distance: Math.hypot(2.95, 1.48, 8.4),
  },
  {
    id: "own",
    name: "Your model",
    about: "drop a model and its texture here",
    counted: "default",
    like: 4, // what the lighthouse takes more than its loops is taken for a model too
    ...measured,
    yaw: 0.6,
    pitch: 0.35,
    distance: 3,
  },
  {
    id: "world",
    name: "Little world",
    about: "a garden at dusk. Drag to walk",
    is_world: true,
    ...measured,
    yaw: 0,
    pitch: 0,
    distance: 0,
  },
];

/** Modes in the module's order. */
export const MODES = ["Exact", "Newton", "Fast", "Affine", "Compact"];
/** Formats in the module's order, with their bits of a pixel, and black. */
export const FORMATS = [
  { name: "16-bit color", type: "Rgb565", bits: 16, black: "Rgb565::new(0, 0, 0)" },
  { name: "15-bit color", type: "Rgb555", bits: 16, black: "Rgb555::new(0, 0, 0)" },
  { name: "8-bit gray", type: "Gray8", bits: 8, black: "Gray8::new(0)" },
  { name: "4-bit gray", type: "Gray4", bits: 4, black: "Gray4::new(0)" },
  { name: "2-bit gray", type: "Gray2", bits: 2, black: "Gray2::new(0)" },
  { name: "1-bit", type: "BinaryColor", bits: 1, black: "BinaryColor::Off" },
];
export const SIZES = ["128x64", "128x128", "160x128", "240x240", "320x240", "480x320", "640x480"];


/** The camera in which a scene is measured. */
export function home(scene) {
  const { yaw, pitch, distance, center, fov, near, far, scale } = SCENES[scene];
  return { yaw, pitch, distance, center: [...center], fov, near, far, scale, shift: [0, 0], moment: 0.2, isHome: true };
}

/** The module's settings for a mode of a state. */
export function settings(state, mode) {
  const { scene, camera, tolerance } = state;
  const [width, height] = state.size.split("x").map(Number);
  const [center_x, center_y, center_z] = camera.center.map(fixed);
  // A pixel in the middle of the picture, as an angle.
  const pixel = Math.atan((2 * Math.tan(camera.fov / 2)) / height);
  return {
    scene,
    mode,
    width,
    height,
    center_x,
    center_y,
    center_z,
    tolerance: fixed(tolerance),
    // The measured scenes' own camera is for this size.
    is_home: Number(
      camera.isHome && (SCENES[scene].id === "lighthouse" || (scene < 4 && width === 320 && height === 240)),
    ),
    yaw: turn(camera.yaw),
    pitch: turn(camera.pitch),
    distance: fixed(camera.distance),
    scale: fixed(camera.scale),
    fov: turn(camera.fov),
    near: fixed(camera.near),
    far: fixed(camera.far),
    shift_x: turn(pixel * camera.shift[0]),
    shift_y: turn(pixel * camera.shift[1]),
    is_two_sided: Number(state.isTwoSided),
    is_mono: Number(FORMATS[state.format].bits === 1),
    is_world: Boolean(SCENES[scene].is_world),
    moment: turn(camera.moment * 2 * Math.PI),
  };
}
