// A file for a board, which shows the visitor's model: saved, or run on an emulated board.
import { $, short } from "./controls.js";
import { display } from "./display.js";
import { flash, save } from "./files.js";
import { fetched } from "./module.js";

/** The program that the emulated board runs. */
const EMULATED = "pico_model.gz";
/** The visitor's files, the model first. */
let own = [];
/** The emulated board while it runs, and what it has shown. */
let run;

const tell = (text) => ($("flashed").textContent = text);

async function fetchedFile(name) {
  const response = await fetch(name);
  if (!response.ok) throw new Error(`${name} is missing here (${response.status}).`);
  return new File([await response.blob()], name);
}

/** The names of the chosen model's files, its own first. */
const names = () =>
  $("own").selected ? own.map(({ name }) => name) : $("model").selectedOptions[0].dataset.files.split(" ");

/** Makes a file of the chosen model and a board's program. Also returns the model's words, name and cost, and notes. */
async function make(board) {
  const program = await fetched(board);
  const files = $("own").selected ? own : await Promise.all(names().map(fetchedFile));
  const panel = 4 * Number($("panel").value) + Number($("turn").value);
  const { notes, ...made } = await flash(program, files, panel);
  return { ...made, notes: notes.map((note) => `${note[0].toUpperCase()}${note.slice(1)}.`) };
}

let estimates = 0;
/** Tells what the chosen model costs on the chosen board, before anything is saved. */
async function estimate() {
  $("flash").textContent = `Save ${names()[0]} as UF2`;
  tell("");
  const mine = ++estimates;
  const { value, selectedOptions: [{ text }] } = $("chip");
  const show = (told) => mine === estimates && ($("estimate").textContent = told);
  show("Measuring …");
  try {
    const { name, cost, notes } = await make(value);
    show([`${name} on a ${text}: ${cost}.`, ...notes].join(" "));
  } catch ({ message }) {
    show(message);
  }
}

async function saveFile() {
  tell("Making the file …");
  const { value, selectedOptions: [{ text }] } = $("chip");
  const { uf2, name } = await make(value);
  const file = `${name.replace(/\.\w+$/, "")}.uf2`;
  save(file, new Blob([uf2]));
  tell(`${file} holds ${name} and its program. Copy it to the drive of the ${text}.`);
}

/** Runs the file on the emulated board; stops it if it runs. */
async function emulate() {
  if (run) return stop("Stopped.");
  tell("Making the file …");
  const { uf2, words, name } = await make(EMULATED);
  const draw = await display(words);
  const script = await fetched("emulator.js.gz").catch(({ message }) => {
    throw new Error(`${message} This page was built without the emulator. Everything else works.`);
  });
  if (run) return; // a second press came meanwhile
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  const worker = new Worker(address);
  URL.revokeObjectURL(address);
  run = { worker, draw, frames: 0, same: 0, seconds: 0 };
  $("emulate").textContent = "Stop";
  $("emulated").textContent = "The emulated Pico draws its first frames …";
  const other = $("chip").value === EMULATED ? "" : " This is the file for a Pico. The page emulates no Pico 2.";
  tell(`${name} runs on an emulated RP2040 at 125 MHz.${other}`);
  worker.onerror = ({ message }) => stop(message);
  worker.onmessage = ({ data }) => (data.error ? stop(`The board has stopped: ${data.error}`) : measure(data));
  worker.postMessage(uf2.slice()); // not all of the memory that it lies in
  play(run);
}

function show(image) {
  const { width, height } = image;
  const screen = $("screen");
  if (screen.width !== width || screen.height !== height) Object.assign(screen, { width, height });
  screen.hidden = false;
  screen.getContext("2d").putImageData(image, 0, 0);
}

/** Shows the display at full speed: the emulated board takes seconds for a frame. */
async function play(mine) {
  const start = performance.now();
  while (mine === run) {
    const now = await new Promise(requestAnimationFrame);
    if (mine === run) show(mine.draw(Math.max(0, now - start)));
  }
}

/** Counts a frame that the emulated board has sent to its display, and compares its pixels with those drawn here. */
function measure({ width, rgba, begun, lasts, bytes, cores }) {
  const here = run.draw(begun);
  const isSame = here.width === width && here.data.every((value, at) => value === rgba[at]);
  run.frames++;
  run.same += isSame;
  run.seconds += lasts;
  run.last = new ImageData(rgba, width);
  const { frames, same, seconds } = run;
  const count = cores === 1 ? "one core" : `${cores} cores`;
  const pixels =
    same === frames ? "the same pixels as the picture here" : `other pixels than the picture here in ${frames - same}`;
  $("emulated").textContent = [
    `${short(frames / seconds)} frames a second on ${count}, with ${bytes.toLocaleString("en")} bytes on the bus for each.`,
    `The emulated Pico has drawn ${frames} so far, with ${pixels};`,
    `the last was begun after ${(begun / 1000).toFixed(3)} seconds of its time.`,
    "It waits for no flash: a real Pico is slower.",
  ].join(" ");
}

/** Stops the board; the last frame that it has drawn stays. */
function stop(why) {
  run.worker.terminate();
  if (run.last) show(run.last);
  else $("emulated").textContent = "";
  run = undefined;
  $("emulate").textContent = "Run it here";
  tell(why);
}

/** Shows the chosen model's name. */
export const showModel = () => ($("flash").textContent = `Save ${names()[0]} as UF2`);

/** Chooses the model of these files, if there is one. */
export function chooseModel(files) {
  const model = files.find(({ name }) => /\.(obj|stl|ply|gltf|glb)$/i.test(name));
  if (!model) return;
  own = [model, ...files.filter((file) => file !== model)];
  Object.assign($("own"), { textContent: model.name, disabled: false, hidden: false, selected: true });
  estimate();
}

const report = ({ message }) => tell(message);
for (const id of ["model", "panel", "chip", "turn"]) $(id).onchange = estimate;
$("flash").onclick = () => saveFile().catch(report);
$("emulate").onclick = () => emulate().catch(report);
