// The page: what is drawn, and what it costs.
import { program } from "./code.js";
import { SLIDERS, build, controls } from "./controls.js";
import { CORES, instructions, table } from "./cost.js";
import { read } from "./files.js";
import { onDivider, onDrop, onPicture } from "./gestures.js";
import { errors, heatMap } from "./model.js";
import { Crate, fetched, load } from "./module.js";
import { plot } from "./plot.js";
import { FORMATS, MODES, SCENES, home, settings } from "./scenes.js";
import { $, interpolates, modes, scene, short, state, trouble, view, whole } from "./state.js";

const reference = []; // counts of the measured scenes as they were measured
let [crate, count, times, settling, animation] = [null, null, [], 0, 0];

// Drawing

/** Draws both modes and shows them. */
function draw() {
  try {
    const context = $("canvas").getContext("2d");
    const { width, height } = state;
    if ($("canvas").width !== width || $("canvas").height !== height) Object.assign($("canvas"), { width, height });
    const images = modes().map((mode, slot) => {
      const now = view(mode);
      const image =
        state.showsErrors && interpolates() ? heatMap(errors(now, crate.recorded(slot, now)), width, height) : null;
      const time = crate.draw(slot, now);
      times[mode] = times[mode] ? times[mode] + (time - times[mode]) / 16 : time;
      return image ?? crate.shown(slot, state.format);
    });
    context.putImageData(images[0], 0, 0);
    const from = Math.round(state.divider * width);
    if (images[1]) context.putImageData(images[1], 0, 0, from, 0, width - from, height);
    trouble("", "drawing");
  } catch (error) {
    trouble(`This cannot be drawn: ${error.message}`, "drawing");
  }
}

/** Draws again, and tells numbers once nothing changes for a moment. */
function changed() {
  cancelAnimationFrame(animation);
  animation = requestAnimationFrame(frame);
  clearTimeout(settling);
  settling = setTimeout(settled, 200);
}

let [last, rate, shown] = [0, 60, 0];

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
  if (!state.spins) controls();
  else if (now > shown + 250) {
    shown = now;
    numbers();
  }
}

/** Everything that takes longer than a frame. */
async function settled() {
  if (state.spins || !crate || slow) return;
  numbers(true);
  $("code").textContent = program(scene(), view(), state.format, Number($("rows").value));
  await compare();
}

// Numbers

function counts() {
  const { id } = scene();
  if (scene().is_world || (id === "own" && !state.hasModel)) return [0, 0, 0, 0];
  if (scene().counted && !reference[state.scene] && id !== "own") {
    const first = { ...state, camera: home(state.scene), width: 320, height: 240, isTwoSided: false };
    reference[state.scene] = crate.counted(0, settings(first, 1));
  }
  // What the lighthouse takes more than its loops is taken for a model too.
  if (id === "own" && !reference[state.scene]) {
    const first = { ...state, scene: 4, camera: home(4), width: 320, height: 240, isTwoSided: false };
    reference[state.scene] = crate.counted(0, settings(first, 1));
  }
  return crate.counted(0, view());
}

let known = [0, 0, 0, 0];

function numbers(isStill = false) {
  if (isStill) {
    try {
      known = counts();
    } catch {
      return; // told already
    }
    draw();
  }
  const [submitted, drawn, clipped, pixels] = known;
  const { bits } = FORMATS[state.format];
  const depth = scene().id === "sphere-flat" ? 0 : 16;
  const kib = (rows) => `${+((state.width * rows * (bits + depth)) / 8 / 1024).toFixed(1)} KiB`;
  const rows = Number($("rows").value);
  const time = times[modes()[0]];
  const list = [
    ...(scene().is_world
      ? []
      : [
          ["Triangles", whole(submitted)],
          ["Drawn", whole(drawn)],
          ["Clipped", whole(clipped)],
          ["Pixels drawn", whole(pixels)],
          ["Time per pixel", pixels ? `${short((time * 1e6) / pixels)} ns` : "–"],
        ]),
    ...(scene().is_world ? [["Time per picture", `${short(time)} ms`]] : []),
    ...(state.spins ? [["Pictures a second", whole(rate)]] : [["Checksum", crate.checksum(0)]]),
    ["RAM, whole frame", kib(state.height)],
    [`RAM, ${rows} rows`, kib(Math.min(rows, state.height))],
  ];
  $("numbers").innerHTML = list.map(([name, value]) => `<div><dt>${name}</dt><dd>${value}</dd></div>`).join("");
}

/** Milliseconds of the draw calls: the best of three means, each over more than the clock's steps. */
function timed(now) {
  let best = Infinity;
  for (let turn = 0; turn < 3; turn++) {
    let [sum, rounds] = [0, 0];
    while (sum < 2 && rounds < 400) {
      sum += crate.draw(1, now);
      rounds++;
    }
    best = Math.min(best, sum / rounds);
  }
  return best;
}

const pause = () => new Promise((resume) => setTimeout(resume));
let comparison = 0;

/** Measures every mode: its time here, its instructions, its error; fills the table and the plot. */
async function compare() {
  const mine = ++comparison;
  const tolerances = [...new Set([1 / 16, 1 / 4, 1, state.tolerance])].sort((a, b) => a - b);
  const wanted = MODES.flatMap((name, mode) =>
    name === "Fast"
      ? tolerances.map((tolerance) => ({
          mode,
          tolerance,
          name: `Fast ${tolerance === 1 / 4 ? "¼" : tolerance === 1 / 16 ? "1/16" : short(tolerance)}`,
        }))
      : [{ mode, name }],
  );
  const found = [];
  for (const { mode, tolerance = state.tolerance, name } of scene().is_world ? [] : wanted) {
    await pause();
    if (mine !== comparison || state.spins || slow) return;
    try {
      const now = { ...settings({ ...state, tolerance }, mode) };
      const error = interpolates() ? errors(now, crate.recorded(1, now)) : {};
      const here = modes().includes(mode) && (MODES[mode] !== "Fast" || tolerance === state.tolerance);
      const cost = { time: timed(now) };
      for (const { id } of CORES)
        cost[id] = instructions(count, id, scene(), MODES[mode], known, reference[state.scene]);
      if (here) times[mode] = cost.time;
      found.push({ mode, tolerance, name, here, cost, ...error });
    } catch {
      return; // told already
    }
  }
  const axis = $("axis").value;
  // Instructions for Fast were counted within ¼ texel.
  const marks = found.filter(
    ({ name, here }) => axis === "time" || !name.startsWith("Fast") || here || name === "Fast ¼",
  );
  $("figure").hidden = scene().is_world;
  const unit = axis === "time" ? "milliseconds here" : "million instructions, estimated";
  $("plot").innerHTML = plot(
    marks.map(({ name, here, cost, max }) => ({
      name,
      here,
      error: max,
      cost: axis === "time" ? cost.time : cost[axis] / 1e6,
    })),
    unit,
  );
  tell(found.filter(({ here }) => here));
  draw();
  numbers();
}

/** The table of the modes that are seen. */
function tell(found) {
  const rows = [
    ["Largest error, in texels", ({ max }) => short(max)],
    ["Mean error", ({ mean }) => short(mean)],
    ...CORES.flatMap(({ id, name, clock, cycles }) => [
      [`${name}: million instructions`, ({ cost }) => (cost[id] ? (cost[id] / 1e6).toFixed(2) : "–")],
      [`${name}: pictures a second`, ({ cost }) => (cost[id] ? (clock / (cost[id] * cycles)).toFixed(0) : "–")],
    ]),
  ];
  const line = (name, cell) => `<tr><th scope="row">${name}</th>${found.map(cell).join("")}</tr>`;
  $("cost").innerHTML = `<thead>${line("", ({ name }) => `<th scope="col">${name}</th>`)}</thead><tbody>${rows
    .map(([name, value]) => line(name, (mark) => `<td>${value(mark)}</td>`))
    .join("")}</tbody>`;
  $("cost").hidden = !found.length;
  $("about-cost").textContent = scene().is_world
    ? "The little world chooses modes and shaders itself; its instructions are not estimated here."
    : "The page measures errors against its own model in double precision. It estimates instructions from counts of this " +
      "scene on an emulated core and from the pixels and triangles now, and pictures a second for 133 MHz (Cortex-M0+) and " +
      "168 MHz (Cortex-M4) without wait states." +
      (scene().id === "sphere"
        ? " For its errors, the sphere has a texture of 64x64 texels in place of its colors."
        : "") +
      (found.some(({ name }) => name.startsWith("Fast ")) ? " Fast was counted within ¼ texel." : "") +
      (scene().id === "own" ? " Your model is estimated as if it were the lighthouse." : "");
}

// Bands in slow motion

let slow = 0;

function drawBands() {
  state.spins = false;
  controls();
  const [rows, height] = [Number($("rows").value), state.height];
  const context = $("canvas").getContext("2d");
  const now = view(modes()[0]);
  try {
    crate.draw(0, now);
  } catch (error) {
    trouble(`This cannot be drawn: ${error.message}`, "drawing");
    return;
  }
  const frame = crate.checksum(0);
  crate.picture(0).fill(0);
  context.fillStyle = "#223";
  context.fillRect(0, 0, state.width, height);
  stopBands();
  $("stage").classList.add("slow");
  let first = 0;
  slow = setInterval(
    () => {
      const count = Math.min(rows, height - first);
      crate.draw(0, now, first, count);
      context.putImageData(crate.shown(0, state.format), 0, 0, 0, first, state.width, count);
      Object.assign($("band").style, { top: `${(100 * first) / height}%`, height: `${(100 * count) / height}%` });
      $("band").hidden = false;
      $("status").textContent = `Rows ${first} to ${first + count - 1} of ${height}, in the memory of one band.`;
      first += count;
      if (first < height) return;
      stopBands();
      const same =
        crate.checksum(0) === frame
          ? "the same picture as the whole frame, bit for bit"
          : "another picture than the frame";
      $("status").textContent = `${Math.ceil(height / rows)} bands of ${rows} rows: ${same}.`;
      setTimeout(() => slow || changed(), 1500);
    },
    Math.max(2400 / (height / rows), 60),
  );
}

function stopBands() {
  clearInterval(slow);
  slow = 0;
  $("band").hidden = true;
  $("stage").classList.remove("slow");
}
// Choices

async function choose(at) {
  stopBands();
  trouble("");
  if (SCENES[at].is_world && !crate.world) {
    $("status").textContent = "Loading the little world …";
    try {
      crate.world = await crate.loadWorld();
    } catch (error) {
      trouble(`The little world cannot be loaded: ${error.message}`);
      $("scenes").querySelectorAll("input")[state.scene].checked = true;
      return;
    }
  }
  const keepsTurn = state.spins;
  Object.assign(state, {
    scene: at,
    camera: at === 5 && state.ownCamera ? { ...state.ownCamera } : home(at),
    spins: keepsTurn,
  });
  $("scenes").querySelectorAll("input")[at].checked = true;
  $("status").textContent = `${SCENES[at].name}: ${SCENES[at].about}.${
    SCENES[at].is_world ? "" : " Drag to turn it; pinch, or click and scroll, to zoom."
  }`;
  times = [];
  changed();
}

/** The texture of a model that has none. */
const PLAIN = { data: new Uint8Array(4).fill(215), width: 1, height: 1 };

async function open(files) {
  try {
    const { name, text, texture } = await read(files);
    if (text) {
      if (!/^\s*f\s/m.test(new TextDecoder().decode(text))) throw new Error("it has no faces, so there is nothing to draw");
      state.hasModel = false;
      const [x, y, z, radius] = crate.readModel(text);
      state.text = text;
      const scale = Math.min(1 / (radius || 1), 30000);
      state.ownCamera = { ...home(5), scale, center: [x, y, z].map((at) => at * scale) };
      state.ownCamera.distance = 1.05 / Math.sin(state.ownCamera.fov / 2);
      state.hasModel = true;
    }
    // The last model's texture does not suit another one.
    if (texture || text) crate.readTexture(texture ?? PLAIN);
    await choose(5);
    $("status").textContent =
      `${name ?? "The texture"} is read.${text && !texture ? " Drop a picture too, to give it a texture." : ""}`;
  } catch (error) {
    const name = [...files].find(({ name }) => /\.(obj|gltf|glb)$/i.test(name))?.name ?? "The file";
    if (state.text) {
      crate.readModel(state.text);
      state.hasModel = true;
    }
    trouble(`${name} cannot be read: ${error.message}`);
    $("status").textContent = "";
  }
}

function orbit(right, down) {
  stopBands();
  if (scene().is_world) state.camera.moment = (state.camera.moment - right / 12 + 1) % 1;
  else {
    state.camera.yaw += right;
    state.camera.pitch = Math.max(-1.57, Math.min(1.57, state.camera.pitch + down));
    state.camera.isHome = false;
  }
  changed();
}

function zoom(factor) {
  stopBands();
  // The floor's eye is at its center, so it goes back and forth.
  const { distance } = state.camera;
  state.camera.distance =
    scene().id === "floor"
      ? Math.max(0, Math.min(distance + Math.log2(factor) * 4, 50))
      : Math.max(0.3, Math.min(distance * factor, 200));
  state.camera.isHome = false;
  changed();
}
function listen() {
  const on = (id, event, act) => $(id).addEventListener(event, act);
  on("scenes", "change", ({ target }) => choose(Number(target.value)));
  for (const id of ["left", "right", "format"]) {
    on(id, "change", ({ target }) => {
      state[id] = Number(target.value);
      stopBands();
      changed();
    });
  }
  on("size", "change", ({ target }) => {
    [state.width, state.height] = target.value.split("x").map(Number);
    stopBands();
    changed();
  });
  on("rows", "change", () => {
    stopBands();
    changed();
  });
  on("axis", "change", changed);
  on("spin", "change", ({ target }) => {
    state.spins = target.checked;
    stopBands();
    last = performance.now();
    rate = 60;
    controls();
    changed();
  });
  on("errors", "change", ({ target }) => {
    state.showsErrors = target.checked;
    stopBands();
    changed();
  });
  on("two-sided", "change", ({ target }) => {
    state.isTwoSided = target.checked;
    changed();
  });
  on("home", "click", () => choose(state.scene));
  on("bands", "click", drawBands);
  on("files", "change", ({ target }) => {
    open([...target.files]);
    // So that the same file can be chosen again.
    target.value = "";
  });
  on("copy", "click", async () => {
    try {
      await navigator.clipboard.writeText($("code").textContent);
      $("copy").textContent = "Copied";
    } catch {
      getSelection().selectAllChildren($("code"));
      $("copy").textContent = "Selected: press Ctrl+C";
    }
    setTimeout(() => {
      $("copy").textContent = "Copy";
    }, 2000);
  });
  for (const { id, from, set } of SLIDERS)
    on(id, "input", ({ target }) => {
      set(from(Number(target.value)));
      changed();
    });

  onPicture(orbit, zoom, () => choose(state.scene));
  onDivider((share) => {
    state.divider = Math.max(0, Math.min(share, 1));
    controls();
    draw();
  });
  onDrop(open);
}

try {
  crate = new Crate(await load(await fetched("playground.wasm.gz")), async () => load(await fetched("world.wasm.gz")));
  count = table(crate.costs());
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
