// A file for a board, which shows the visitor's model: saved, or run on an emulated board.
import { $, short } from "./controls.js";
import { flash, save } from "./files.js";
import { fetched } from "./module.js";

/** The program that the emulated board runs. */
const EMULATED = "pico_model.gz";
/** The visitor's files, the model first. */
let own = [];
/** The emulated board, while it runs. */
let worker;

const tell = (text) => ($("flashed").textContent = text);

async function fetchedFile(name) {
  const response = await fetch(name);
  if (!response.ok) throw new Error(`${name} is missing here (${response.status}).`);
  return new File([await response.blob()], name);
}

/** The names of the chosen model's files, its own first. */
const names = () =>
  $("own").selected ? own.map(({ name }) => name) : $("model").selectedOptions[0].dataset.files.split(" ");

/** Makes a file of the chosen model and a program; returns its bytes, the model's name, and notes. */
async function make(board) {
  tell("Making the file …");
  const program = await fetched(board);
  const files = $("own").selected ? own : await Promise.all(names().map(fetchedFile));
  const panel = 4 * Number($("panel").value) + Number($("turn").value);
  const { uf2, name, notes } = await flash(program, files, panel);
  return { uf2, name, notes: notes.map((note) => `${note[0].toUpperCase()}${note.slice(1)}.`) };
}

async function saveFile() {
  const { value, selectedOptions: [{ text }] } = $("chip");
  const { uf2, name, notes } = await make(value);
  const file = `${name.replace(/\.\w+$/, "")}.uf2`;
  save(file, new Blob([uf2]));
  tell([`${file} holds ${name} and its program. Copy it to the drive of the ${text}.`, ...notes].join(" "));
}

/** Runs the file on the emulated board; stops it if it runs. */
async function emulate() {
  if (worker) return stop("Stopped.");
  const { uf2, name, notes } = await make(EMULATED);
  const script = await fetched("emulator.js.gz").catch(({ message }) => {
    throw new Error(`${message} This page was built without the emulator. Everything else works.`);
  });
  worker?.terminate(); // a second press may have come meanwhile
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  worker = new Worker(address);
  URL.revokeObjectURL(address);
  $("emulate").textContent = "Stop";
  $("screen").hidden = true;
  $("emulated").textContent = "";
  if ($("chip").value !== EMULATED) notes.unshift("This is the file for a Pico. The page emulates no Pico 2.");
  tell([`${name} runs on an emulated RP2040 at 125 MHz.`, ...notes].join(" "));
  worker.onerror = ({ message }) => stop(message);
  worker.onmessage = ({ data }) => (data.error ? stop(`The board has stopped: ${data.error}`) : show(data));
  worker.postMessage(uf2.slice()); // not all of the memory that it lies in
}

function stop(why) {
  worker.terminate();
  worker = undefined;
  $("emulate").textContent = "Run it here";
  tell(why);
}

/** Shows a frame that the board has sent to its display. */
function show({ width, rgba, begun, lasts, bytes }) {
  const image = new ImageData(rgba, width);
  Object.assign($("screen"), { width, height: image.height, hidden: false });
  $("screen").getContext("2d").putImageData(image, 0, 0);
  $("emulated").textContent = [
    `${short(1 / lasts)} frames a second, ${bytes.toLocaleString("en")} bytes on the bus for each.`,
    `This one was begun after ${(begun / 1000).toFixed(3)} seconds of the board's time, which passes more slowly here.`,
  ].join(" ");
}

/** Shows the chosen model's name. */
export const showModel = () => ($("flash").textContent = `Save ${names()[0]} as UF2`);

/** Chooses the model of these files, if there is one. */
export function chooseModel(files) {
  const model = files.find(({ name }) => /\.(obj|stl|ply|gltf|glb)$/i.test(name));
  if (!model) return;
  own = [model, ...files.filter((file) => file !== model)];
  Object.assign($("own"), { textContent: model.name, disabled: false, hidden: false, selected: true });
  showModel();
}

const report = ({ message }) => tell(message);
$("model").onchange = showModel;
$("flash").onclick = () => saveFile().catch(report);
$("emulate").onclick = () => emulate().catch(report);
