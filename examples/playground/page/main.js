// The page: what is drawn, and what the visitor does with it.
import { program } from "./code.js";
import { build, controls, take } from "./controls.js";
import { read } from "./files.js";
import { onDrop, onPicture } from "./gestures.js";
import { compare, count, numbers, times } from "./measure.js";
import { errors, heatMap } from "./model.js";
import { Crate, fetched, load } from "./module.js";
import { SCENES, home } from "./scenes.js";
import { $, format, interpolates, modes, scene, state, view } from "./state.js";

/** The visitor's model is the last scene but one. */
const OWN = SCENES.findIndex(({ id }) => id === "own");
/** The texture of a model that has none. */
const PLAIN = { data: new Uint8Array(4).fill(215), width: 1, height: 1 };

const trouble = (text) => Object.assign($("trouble"), { hidden: !text, textContent: text });
const status = (text) => ($("status").textContent = text);
let crate;

// Drawing

/** Draws both modes and shows them. */
function draw() {
  const context = $("canvas").getContext("2d");
  const { width, height } = view();
  if ($("canvas").width !== width || $("canvas").height !== height) Object.assign($("canvas"), { width, height });
  try {
    const from = Math.round((state.divider / 100) * width);
    modes().forEach((mode, slot) => {
      const now = view(mode);
      const map = state.showsErrors && interpolates() && heatMap(errors(now, crate.recorded(slot, now)), width, height);
      const time = crate.draw(slot, now);
      times[mode] = times[mode] ? times[mode] + (time - times[mode]) / 16 : time;
      context.putImageData(map || crate.shown(slot, format()), 0, 0, slot ? from : 0, 0, width, height);
    });
  } catch (error) {
    context.clearRect(0, 0, width, height);
    $("hint").textContent = `This cannot be drawn: ${error.message}`;
    return false;
  }
  return true;
}

let [animation, settling, last, rate, shown] = [0, 0, 0, 60, 0];

/** Draws again, and measures once nothing changes for a moment. */
function changed() {
  stopBands();
  controls();
  cancelAnimationFrame(animation);
  animation = requestAnimationFrame(frame);
  clearTimeout(settling);
  settling = setTimeout(settled, 200);
}

function frame(now) {
  if (state.spins) {
    const seconds = Math.min(Math.max((now - last) / 1000, 0.001), 0.1);
    rate += (1 / seconds - rate) / 30;
    if (scene().is_world) state.camera.moment = (state.camera.moment + seconds / 30) % 1;
    else Object.assign(state.camera, { yaw: state.camera.yaw + seconds / 2, isHome: false });
    animation = requestAnimationFrame(frame);
  }
  last = now;
  draw();
  if (state.spins && now > shown + 250) {
    shown = now;
    numbers(crate, rate);
  }
}

/** Everything that takes longer than a frame. */
async function settled() {
  const isStill = () => !state.spins && !bands;
  if (!isStill() || !draw()) return;
  count(crate);
  draw();
  numbers(crate);
  $("code").textContent = program(scene(), view(), { ...state, format: format() });
  if (!(await compare(crate, isStill))) return;
  draw();
  numbers(crate);
}

let bands = 0;

/** Draws band after band in slow motion. */
function drawBands() {
  stopBands();
  cancelAnimationFrame(animation);
  state.spins = false;
  controls();
  const { rows } = state;
  const now = view(modes()[0]);
  if (!draw()) return;
  const whole = crate.checksum(0);
  crate.picture(0).fill(0);
  const context = $("canvas").getContext("2d");
  context.fillStyle = "#223";
  context.fillRect(0, 0, now.width, now.height);
  $("stage").classList.add("slow");
  let first = 0;
  const next = () => {
    const height = Math.min(rows, now.height - first);
    crate.draw(0, now, first, height);
    context.putImageData(crate.shown(0, format()), 0, 0, 0, first, now.width, height);
    const share = (row) => `${(100 * row) / now.height}%`;
    Object.assign($("band").style, { top: share(first), height: share(height) });
    status(`Rows ${first} to ${first + height - 1} of ${now.height}, in the memory of one band.`);
    first += rows;
    if (first < now.height) return;
    const same = crate.checksum(0) === whole ? "the same picture, bit for bit, as drawn whole" : "another picture";
    status(`${Math.ceil(now.height / rows)} bands of ${rows} rows: ${same}.`);
    clearInterval(bands);
    bands = setTimeout(changed, 1500);
  };
  bands = setInterval(next, Math.max((2400 * rows) / now.height, 60));
}

function stopBands() {
  clearInterval(bands); // ends a timeout, too
  bands = 0;
  $("stage").classList.remove("slow");
}

// Choices

async function choose(at) {
  trouble("");
  if (SCENES[at].is_world && !crate.world) {
    status("Loading the little world …");
    try {
      crate.world = await load(await fetched("world.wasm.gz"));
    } catch (error) {
      trouble(`The little world cannot be loaded: ${error.message}`);
      controls();
      return;
    }
  }
  const camera = { ...home(at), ...(at === OWN && state.model?.camera) };
  Object.assign(state, { scene: at, camera });
  const gestures = scene().is_world ? "" : " Drag to turn it; pinch, or click and scroll, to zoom.";
  status(`${scene().name}: ${scene().about}.${gestures}`);
  times.length = 0;
  changed();
}

async function open(files) {
  const name = (files.find(({ name }) => /\.(obj|gltf|glb)$/i.test(name)) ?? files[0]).name;
  try {
    const { model, texture } = await read(files);
    if (model) {
      const [x, y, z, radius] = crate.readModel(model.text);
      // After the parser, which reports mistakes first.
      if (model.isEmpty) throw new Error("it has no faces, so there is nothing to draw.");
      const scale = 1 / (radius || 1);
      const center = [x, y, z].map((at) => at * scale);
      state.model = { ...model, camera: { scale, center, distance: 1.05 / Math.sin(home(OWN).fov / 2) } };
    }
    // The last model's texture does not suit another one.
    if (texture || model) crate.readTexture(texture ?? PLAIN);
    await choose(OWN);
    status(`${name} is read.${model && !texture ? " Drop a picture too, to give it a texture." : ""}`);
  } catch (error) {
    if (state.model) crate.readModel(state.model.text);
    // Only OBJ files have the lines that the parser counts.
    const message = /\.obj$/i.test(name) ? error.message : error.message.replace(/^line \d+: /, "");
    trouble(`${name} cannot be read: ${message}`);
    status("");
  }
}

function orbit(right, down) {
  const { camera } = state;
  if (scene().is_world) camera.moment = (camera.moment - right / 12 + 1) % 1;
  else {
    camera.yaw += right;
    camera.pitch = Math.max(-1.57, Math.min(1.57, camera.pitch + down));
    camera.isHome = false;
  }
  changed();
}

function zoom(factor) {
  const { camera } = state;
  // The floor's eye is at its center, so it goes back and forth.
  camera.distance =
    scene().id === "floor"
      ? Math.max(0, Math.min(camera.distance + Math.log2(factor) * 4, 50))
      : Math.max(0.3, Math.min(camera.distance * factor, 200));
  camera.isHome = false;
  changed();
}

async function copy() {
  try {
    await navigator.clipboard.writeText($("code").textContent);
    $("copy").textContent = "Copied";
  } catch {
    getSelection().selectAllChildren($("code"));
    $("copy").textContent = "Selected: press Ctrl+C";
  }
  setTimeout(() => ($("copy").textContent = "Copy"), 2000);
}

function listen() {
  const restart = () => choose(state.scene);
  oninput = ({ target }) => {
    if (target.name === "scene") choose(Number(target.value));
    else if (take(target)) changed();
  };
  $("home").onclick = restart;
  $("bands").onclick = drawBands;
  $("copy").onclick = copy;
  $("files").onchange = ({ target }) => {
    open([...target.files]);
    target.value = ""; // so that the same file can be chosen again
  };
  onPicture(orbit, zoom, restart);
  onDrop(open);
}

try {
  crate = new Crate(await load(await fetched("playground.wasm.gz")));
  crate.readTexture(PLAIN);
  build();
  listen();
  await choose(state.scene);
} catch (error) {
  trouble(
    `The playground cannot start. ${error.message}\n` +
      "Build it in the project's folder, then start the server again:\n" +
      "cargo build --release -p playground -p playground-world --lib --target wasm32-unknown-unknown",
  );
}
