// The page: what is drawn, and what the visitor does with it.
import { animation } from "./animation.js";
import { $, camera, keep, recall, roundAngles, settings, showCamera, showSettings } from "./controls.js";
import { compare, showNumbers } from "./figures.js";
import { chooseModel, showModel } from "./board.js";
import { read, save } from "./files.js";
import { Crate, FLOOR, LIGHTHOUSE, MODES, OWN, WORLD, World, load } from "./module.js";
import { showSegment } from "./segment.js";

/** The slot for measuring. Slots 0 and 1 have the pictures of the modes that are seen. */
const SCRATCH = 2;
/** Milliseconds of a turn in the page. */
const TURN = 24_000;
/** How long each picture of a saved animation is shown, in hundredths of a second. */
const DELAY = 6;
/** The texture of a model that has none. */
const PLAIN = { data: new Uint8Array(4).fill(215), width: 1, height: 1 };

const canvas = $("canvas");
const context = canvas.getContext("2d");
/** The buttons of the scenes, by the scenes' numbers. */
const scenes = [];
for (const button of document.querySelectorAll("#scenes input")) scenes[button.value] = button;
const tell = (id, text) => ($(id).textContent = text);
const pause = (time) => new Promise((resume) => setTimeout(resume, time));
const frame = () => new Promise(requestAnimationFrame);
/** The crate, and the little world, once they are loaded. */
let crate;
let world;
/** The visitor's model, with its materials and pictures, the latest file first. */
let own = [];

let beginnings = 0;
let isTurning = false;
/** Ends what waits, and shows the settings. Returns a function to wait with, which tells whether to go on. */
function begin() {
  const mine = ++beginnings;
  isTurning = false;
  showSettings();
  return async (wait) => {
    await wait;
    return mine === beginnings;
  };
}

/** Draws again; once nothing changes for a moment, measures, and then turns the picture if it is to turn. */
async function changed() {
  const goesOn = begin();
  tell("hint", "");
  try {
    if (!(await goesOn(frame()))) return;
    roundAngles(crate.ask("home", settings()));
    draw();
    if (!(await goesOn(pause(200)))) return;
    await measure(goesOn);
    if (settings().spins && (await goesOn())) await turn(goesOn);
  } catch (error) {
    isTurning = false;
    tell("hint", `This cannot be drawn: ${error.message}`);
  }
}

/** The degrees that the picture has turned by, after a part of a turn. The floor's eye looks left and right. */
const turned = (part) => (camera.scene === FLOOR ? 25 * Math.sin(2 * Math.PI * part) : 360 * part);

/** Draws on and on. */
async function turn(goesOn) {
  isTurning = true;
  const { yaw } = camera;
  const start = performance.now();
  let last = start;
  for (let pictures = 1; await goesOn(frame()); pictures++) {
    const now = performance.now();
    camera.yaw = (yaw + turned((now - start) / TURN)) % 360;
    const time = draw();
    if (pictures % 20) continue;
    showNumbers(crate.ask("measure", settings(), SCRATCH), time, 20000 / (now - last));
    last = now;
  }
}

/** Draws the modes that are seen, side by side. Returns the milliseconds that the left one took. */
function draw() {
  const now = settings();
  const { width, height, divider } = now;
  const times = now.modes.map((mode, slot) => {
    const { image, time } = picture({ ...now, mode }, slot);
    context.putImageData(image, 0, 0, slot * Math.round((divider / 100) * width), 0, width, height);
    return time;
  });
  return times[0];
}

/** Draws a picture, or its errors. Returns what is seen, and the milliseconds that drawing took. */
function picture(view, slot) {
  const time = crate.draw(view, slot);
  return { image: view.showsErrors ? crate.image("errors", view, SCRATCH) : crate.image("show", view, slot), time };
}

/** Milliseconds for a picture: the best of three means, each over more than the clock's steps. */
function timed(settings) {
  const mean = () => {
    let [sum, pictures] = [0, 0];
    for (; sum < 2; pictures++) sum += crate.draw(settings, SCRATCH);
    return sum / pictures;
  };
  return Math.min(mean(), mean(), mean());
}

/** Keeps the settings in the address. */
const remember = () => keep(crate.ask("home", settings()));

/** Fills in figures and program. */
async function measure(goesOn) {
  const now = settings();
  remember();
  const left = crate.ask("checksum", crate.ask("measure", now, SCRATCH));
  showNumbers(left, timed(now));
  if (left.submitted === 0) {
    tell("hint", "Drop a model here (.obj, .stl, .ply, .gltf or .glb), with its materials and pictures.");
    $("cost").hidden = $("figure").hidden = true; // there is nothing to compare
  } else if (left.pixels === 0) tell("hint", "Nothing is seen: all triangles face away, or lie outside the picture.");
  tell("code", crate.program(now));
  tell("copy", "Copy");
  const marks = [];
  for (const [mode, name] of MODES.entries()) {
    if (now.scene === WORLD || !(await goesOn(pause()))) return;
    const view = { ...now, mode };
    const time = timed(view);
    const found = crate.ask("errors", crate.ask("measure", view, SCRATCH), SCRATCH);
    marks.push({ ...found, name, time, isSeen: now.modes.includes(mode) });
  }
  compare(marks);
}

/** Draws band after band in slow motion. */
async function drawBands() {
  $("spins").checked = false;
  const goesOn = begin();
  $("stage").className = "slow";
  const now = settings();
  const { band, width, height } = now;
  crate.draw(now, 0);
  const whole = crate.ask("checksum", now).checksum;
  crate.picture(now, SCRATCH).fill(0);
  for (let first_row = 0; first_row < height; first_row += band) {
    const rows = Math.min(band, height - first_row);
    crate.draw({ ...now, first_row, rows }, SCRATCH);
    context.putImageData(crate.image("show", now, SCRATCH), 0, 0, 0, first_row, width, rows);
    Object.assign($("slow").style, { top: `${(100 * first_row) / height}%`, height: `${(100 * rows) / height}%` });
    tell("status", `Rows ${first_row} to ${first_row + rows - 1} of ${height}, in the memory of one band.`);
    if (!(await goesOn(pause(Math.max((2400 * band) / height, 60))))) return;
  }
  const isSame = crate.ask("checksum", now, SCRATCH).checksum === whole;
  const same = isSame ? "the same picture, bit for bit, as drawn whole" : "another picture";
  tell("status", `${Math.ceil(height / band)} bands of ${band} rows: ${same}.`);
  if (await goesOn(pause(1500))) changed();
}

/** Saves a turn of the left picture as an animated GIF. */
async function saveTurn() {
  const goesOn = begin();
  try {
    $("stage").className = "whole";
    const now = settings();
    const { width, height, yaw } = now;
    const pictures = now.scene === WORLD ? 96 : 48; // a walk is longer than a turn
    const gif = await animation(width, height);
    for (let at = 0; at < pictures; at++) {
      tell("gif", `Saving ${Math.round((100 * at) / pictures)} %`);
      if (!(await goesOn(frame()))) return;
      const { image } = picture({ ...now, yaw: (yaw + turned(at / pictures)) % 360 }, 0);
      context.putImageData(image, 0, 0);
      gif.add(image, DELAY);
    }
    const file = gif.end();
    const name = `${scenes[now.scene].parentElement.textContent.toLowerCase().replaceAll(" ", "-")}.gif`;
    save(name, file);
    tell("status", `${name} holds ${pictures} pictures in ${(file.size / 1e6).toFixed(1)} MB.`);
  } catch (error) {
    tell("status", error.message);
  } finally {
    tell("gif", "Save a GIF");
  }
  changed();
}

/** Shows a scene in its start view, or in one that an address has kept. */
async function choose(scene, kept = {}) {
  scenes[scene].checked = true;
  tell("trouble", "");
  tell("status", "Loading …");
  if (scene === WORLD) {
    crate.world = await loadedWorld();
    $("compares").checked = false;
  }
  if (!scenes[scene].checked) return; // in the meantime
  Object.assign(camera, crate.ask("home", { ...settings(), scene }), kept);
  showCamera();
  const { title, textContent } = scenes[scene].parentElement;
  tell("status", `${textContent}: ${title}.`);
  changed();
}

async function open(files) {
  tell("status", "Reading …");
  try {
    const { model, texture, name, notes } = await read(files);
    if (model) crate.read("read_model", model);
    own = model ? files : [...files, ...own];
    chooseModel(own);
    // The last model's texture does not suit another one.
    const { data, ...size } = texture ?? PLAIN;
    crate.read("read_texture", data, size);
    await choose(OWN);
    if (!texture) notes.push("drop a picture too, to give it a texture");
    tell("status", [`${name} is read.`, ...notes.map((note) => `${note[0].toUpperCase()}${note.slice(1)}.`)].join(" "));
  } catch (error) {
    tell("trouble", error.message);
    tell("status", "");
  }
}

/** Turns the picture by degrees, and multiplies its distance. */
function move(right, down, factor = 1) {
  const { yaw, pitch, distance, scene } = camera;
  camera.yaw = (yaw + right) % 360;
  // The lighthouse is hollow below.
  camera.pitch = Math.max(scene === LIGHTHOUSE ? 0 : -90, Math.min(pitch + down, 90));
  // The floor's eye is at its center, so it goes back and forth.
  const [least, wanted] = scene === FLOOR ? [0, distance + Math.log2(factor) * 4] : [0.3, distance * factor];
  camera.distance = Math.max(least, Math.min(wanted, 200));
  changed();
}

/** One pointer turns, two zoom. */
const pointers = new Map();
canvas.onpointerdown = (event) => {
  canvas.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, event);
};
canvas.onpointerup = canvas.onpointercancel = ({ pointerId }) => pointers.delete(pointerId);
canvas.onpointermove = (event) => {
  const from = pointers.get(event.pointerId);
  if (!from) return;
  pointers.set(event.pointerId, event);
  const other = [...pointers.values()].find((pointer) => pointer !== event);
  const spread = ({ clientX, clientY }) => Math.hypot(clientX - other.clientX, clientY - other.clientY) || 1;
  if (other) move(0, 0, spread(from) / spread(event));
  else move((event.clientX - from.clientX) * 0.4, (event.clientY - from.clientY) * 0.4);
};
canvas.onwheel = (event) => {
  if (document.activeElement !== canvas) return; // the page scrolls until the picture was clicked
  event.preventDefault();
  move(0, 0, 2 ** (event.deltaY / 500));
};
const MOVES = {
  ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, -6], ArrowDown: [0, 6],
  "+": [0, 0, 1 / 1.1], "=": [0, 0, 1 / 1.1], "-": [0, 0, 1.1],
};
canvas.onkeydown = (event) => {
  if (event.ctrlKey || event.metaKey || !(event.key in MOVES || event.key === "Home")) return;
  event.preventDefault();
  if (event.key === "Home") choose(camera.scene);
  else move(...MOVES[event.key]);
};

oninput = ({ target }) => {
  if (target.name === "scene") choose(Number(target.value));
  // The divider changes no figures: a picture that turns needs no pause.
  else if (target.id === "divider" && isTurning) showSettings();
  // Modes differ most on the floor.
  else if (target.id === "compares" && target.checked && !settings().interpolates) choose(FLOOR);
  else if (target.type !== "file") changed();
};
onchange = ({ target }) => {
  if (target.id === "divider") remember();
};
$("home").onclick = () => choose(camera.scene);
$("bands").onclick = drawBands;
$("gif").onclick = saveTurn;
$("copy").onclick = () => {
  getSelection().selectAllChildren($("code"));
  document.execCommand("copy"); // works without https, too
  tell("copy", "Copied");
};
$("open").onclick = () => $("files").click();
$("files").onchange = ({ target }) => {
  open([...target.files]);
  target.value = ""; // so that the same file can be chosen again
};
ondragover = ondragleave = ondrop = (event) => {
  event.preventDefault();
  $("stage").classList.toggle("drop", event.type === "dragover");
  if (event.type === "drop" && event.dataTransfer.files.length) open([...event.dataTransfer.files]);
};

onhashchange = () => location.reload();
onunhandledrejection = ({ reason }) => {
  tell("trouble", reason.message);
  tell("status", "");
  if (camera.scene in scenes) scenes[camera.scene].checked = true;
};

const loadedWorld = async () => (world ??= new World(await load("world.wasm.gz", window.world)));

/** Shows the little world, before the rest of the page is loaded. */
async function showWorld(kept) {
  scenes[WORLD].checked = true;
  Object.assign(camera, World.HOME, kept);
  const now = settings();
  Object.assign(canvas, { width: now.width, height: now.height });
  (await loadedWorld()).draw(now);
  context.putImageData(world.image(now), 0, 0);
  performance.mark("picture");
}

async function start() {
  const { scene: asked, ...kept } = recall();
  const scene = asked in scenes ? asked : WORLD;
  if (scene === WORLD) await showWorld(kept);
  crate = new Crate(await load("playground.wasm.gz"));
  crate.read("read_texture", PLAIN.data, PLAIN);
  showSegment(crate);
  document.querySelector("main").inert = false;
  showModel();
  // Without an address that says what to show, the picture turns. Where little motion is wanted, it never starts to
  // turn by itself.
  if (asked === undefined) $("spins").checked = true;
  if (matchMedia("(prefers-reduced-motion)").matches) $("spins").checked = false;
  await choose(scene, kept);
  // On the visitor's own computer, a kept copy would hide any other page at the same port.
  if (location.hostname !== "localhost") navigator.serviceWorker?.register("offline.js").catch(() => {});
}
start();
