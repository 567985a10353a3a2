// A file for a board, which shows the visitor's model.
import { $ } from "./controls.js";
import { flash } from "./files.js";
import { fetched } from "./module.js";

/** What is shown before a model was dropped. */
const DEFAULT = ["lighthouse.obj", "lighthouse.png"];

async function fetchedFile(name) {
  const response = await fetch(name);
  if (!response.ok) throw new Error(`${name} is missing here (${response.status}).`);
  return new File([await response.blob()], name);
}

/** Makes a file of the model and the program, and saves it. */
async function save(files) {
  $("flashed").textContent = "Making the file …";
  try {
    const program = await fetched("pico_model.gz");
    const model = files.length ? files : await Promise.all(DEFAULT.map(fetchedFile));
    const { uf2, name, notes } = await flash(program, model, Number($("panel").value));
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([uf2]));
    link.download = `${name.replace(/\.\w+$/, "")}.uf2`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
    const said = notes.map((note) => `${note[0].toUpperCase()}${note.slice(1)}.`);
    said.unshift(`${link.download} holds ${name} and its program. Copy it to the Pico's drive.`);
    $("flashed").textContent = said.join(" ");
  } catch (error) {
    $("flashed").textContent = error.message;
  }
}

/** Makes the button save a file with the model of these files, or of the lighthouse if there is none. */
export function showBoard(files) {
  const model = files.find(({ name }) => /\.(obj|stl|ply|gltf|glb)$/i.test(name));
  $("flash").textContent = `Save ${model?.name ?? DEFAULT[0]} as UF2`;
  $("flash").onclick = () => save(model ? files : []);
}
