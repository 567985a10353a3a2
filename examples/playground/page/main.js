// The page: what is drawn, and what the visitor does with it.
import { read } from "./files.js";
import { compare, count, numbers, times } from "./measure.js";
import { Crate, WORLD, fetched, load } from "./module.js";
import { $, LIGHTHOUSE, OWN, controls, interpolates, isWorld, modes, state, take, view } from "./state.js";

/** The texture of a model that has none. */
const PLAIN = { data: new Uint8Array(4).fill(215), width: 1, height: 1 };

const trouble = (text) => Object.assign($("trouble"), { hidden: !text, textContent: text });
const status = (text) => ($("status").textContent = text);
let crate;

// Drawing

/** Draws both modes and shows them. */
function draw() {
  const context = $("canvas").getContext("2d");
  const { width, height } = state;
  if ($("canvas").width !== width || $("canvas").height !== height) Object.assign($("canvas"), { width, height });
  try {
    const from = Math.round((state.divider / 100) * width);
    modes().forEach((mode, slot) => {
      const now = view(mode);
      const time = crate.draw(slot, now);
      times[mode] = times[mode] ? times[mode] + (time - times[mode]) / 16 : time;
      const image = state.showsErrors && interpolates() ? crate.errors(slot, now) : crate.shown(slot);
      context.putImageData(image, 0, 0, slot ? from : 0, 0, width, height);
    });
  } catch (error) {
    context.clearRect(0, 0, width, height);
    $("hint").textContent = `This cannot be drawn: ${error.message}`;
    return false;
  }
  return true;
}

let [animation, settling, last, rate, shown, bands] = [0, 0, 0, 60, 0, 0];

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
    if (isWorld()) state.moment = (state.moment + seconds * 12) % 360;
    else Object.assign(state, { yaw: (state.yaw + seconds * 30) % 360, is_home: 0 });
    animation = requestAnimationFrame(frame);
  }
  last = now;
  draw();
  if (state.spins && now > shown + 250) {
    shown = now;
    numbers(crate, rate);
  }
}

/** Everything that takes longer than a frame, and spoils the pictures. */
async function settled() {
  const isStill = () => !state.spins && !bands;
  const show = () => {
    draw();
    crate.draw(0, view(modes()[0])); // for its checksum
    numbers(crate);
  };
  if (!isStill() || !draw()) return;
  if (!count(crate)) $("hint").textContent = "Nothing is seen: all triangles face away, or lie outside the picture.";
  show();
  $("code").textContent = (state.scene === OWN && state.model?.note || "") + crate.program(view());
  if (await compare(crate, isStill)) show();
}

/** Draws band after band in slow motion. */
function drawBands() {
  stopBands();
  cancelAnimationFrame(animation);
  state.spins = false;
  controls();
  if (!draw()) return;
  const { band, width, height } = state;
  const now = view(modes()[0]);
  crate.draw(0, now);
  const whole = crate.checksum(0);
  crate.picture(0).fill(0);
  const context = $("canvas").getContext("2d");
  context.fillStyle = "#223";
  context.fillRect(0, 0, width, height);
  $("stage").classList.add("slow");
  let first = 0;
  const next = () => {
    const rows = Math.min(band, height - first);
    crate.draw(0, now, first, rows);
    context.putImageData(crate.shown(0), 0, 0, 0, first, width, rows);
    const share = (row) => `${(100 * row) / height}%`;
    Object.assign($("slow").style, { top: share(first), height: share(rows) });
    status(`Rows ${first} to ${first + rows - 1} of ${height}, in the memory of one band.`);
    first += band;
    if (first < height) return;
    const same = crate.checksum(0) === whole ? "the same picture, bit for bit, as drawn whole" : "another picture";
    status(`${Math.ceil(height / band)} bands of ${band} rows: ${same}.`);
    clearInterval(bands);
    bands = setTimeout(changed, 1500);
  };
  bands = setInterval(next, Math.max((2400 * band) / height, 60));
}

function stopBands() {
  clearInterval(bands); // ends a timeout, too
  bands = 0;
  $("stage").classList.remove("slow");
}

// Choices

let chosen = LIGHTHOUSE;

async function choose(scene) {
  chosen = scene;
  trouble("");
  if (scene === WORLD && !crate.world) {
    status("Loading the little world …");
    try {
      crate.world = await load(await fetched("world.wasm.gz"));
    } catch (error) {
      trouble(`The little world cannot be loaded: ${error.message}`);
      controls();
      return;
    }
    if (chosen !== scene) return; // in the meantime
  }
  Object.assign(state, crate.home(scene), { scene, is_two_sided: state.is_two_sided });
  const { title, textContent } = $("scenes").children[scene];
  const name = textContent.trim().replace(/\s+/g, " ");
  status(`${name}: ${title}.${isWorld() ? "" : " Drag to turn it; pinch, or click and scroll, to zoom."}`);
  times.length = 0;
  changed();
}

async function open(files) {
  const name = (files.find(({ name }) => /\.(obj|gltf|glb)$/i.test(name)) ?? files[0]).name;
  try {
    const { model, texture } = await read(files);
    if (model) {
      crate.readModel(model.text);
      // After the parser, which tells of mistakes first.
      if (model.isEmpty) throw new Error("it has no faces, so there is nothing to draw.");
      state.model = model;
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

/** Turns the picture by degrees. */
function orbit(right, down) {
  if (isWorld()) state.moment = (state.moment - right / 2 + 360) % 360;
  else {
    state.yaw = (state.yaw + right) % 360;
    state.pitch = Math.max(-90, Math.min(90, state.pitch + down));
    state.is_home = 0;
  }
  changed();
}

function zoom(factor) {
  const { distance } = state;
  // The floor's eye is at its center, so it goes back and forth.
  state.distance =
    state.scene === 0
      ? Math.max(0, Math.min(distance + Math.log2(factor) * 4, 50))
      : Math.max(0.3, Math.min(distance * factor, 200));
  state.is_home = 0;
  changed();
}

const restart = () => choose(state.scene);

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

// Pointers, keys and files

const KEYS = {
  ArrowLeft: () => orbit(-6, 0),
  ArrowRight: () => orbit(6, 0),
  ArrowUp: () => orbit(0, -6),
  ArrowDown: () => orbit(0, 6),
  "+": () => zoom(1 / 1.1),
  "=": () => zoom(1 / 1.1),
  "-": () => zoom(1.1),
  Home: restart,
};

function listen() {
  const canvas = $("canvas");
  // One pointer turns, two zoom.
  const pointers = new Map();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY) || 1;
  };
  canvas.onpointerdown = (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
  };
  canvas.onpointermove = (event) => {
    const from = pointers.get(event.pointerId);
    if (!from) return;
    const before = pointers.size === 2 && spread();
    pointers.set(event.pointerId, event);
    if (before) zoom(before / spread());
    else orbit((event.clientX - from.clientX) * 0.4, (event.clientY - from.clientY) * 0.4);
  };
  canvas.onpointerup = canvas.onpointercancel = ({ pointerId }) => pointers.delete(pointerId);
  canvas.onwheel = (event) => {
    if (document.activeElement !== canvas) return; // the page scrolls until the picture was clicked
    event.preventDefault();
    zoom(2 ** (event.deltaY / 500));
  };
  canvas.onkeydown = (event) => {
    if (!KEYS[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    KEYS[event.key]();
  };

  oninput = ({ target }) => {
    if (target.name === "scene") choose([...$("scenes").children].indexOf(target.parentElement));
    else if (take(target)) changed();
  };
  $("home").onclick = restart;
  $("bands").onclick = drawBands;
  $("copy").onclick = copy;
  $("files").onchange = ({ target }) => {
    open([...target.files]);
    target.value = ""; // so that the same file can be chosen again
  };
  const mark = (isOver) => $("stage").classList.toggle("drop", isOver);
  ondragover = (event) => mark(!event.preventDefault());
  ondragleave = () => mark(false);
  ondrop = (event) => {
    mark(Boolean(event.preventDefault()));
    if (event.dataTransfer.files.length) open([...event.dataTransfer.files]);
  };
}

try {
  crate = new Crate(await load(await fetched("playground.wasm.gz")));
  crate.readTexture(PLAIN);
  listen();
  await choose(LIGHTHOUSE);
} catch (error) {
  trouble(
    `The playground cannot start. ${error.message}\n` +
      "Build it in the project's folder, then start the server again:\n" +
      "cargo build --release -p playground -p playground-world --lib --target wasm32-unknown-unknown",
  );
}
