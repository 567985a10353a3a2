// Runs a program on the emulated Pico in a worker of a page. Takes the bytes of a UF2. Posts each frame once it is
// complete: its columns; its pixels as red, green, blue and alpha; the milliseconds after which the program began it;
// the seconds until the next one; the bytes on the bus until then; and how many cores run. An error ends the run: its
// first line is posted.
import { Pico } from "./pico.js";

onmessage = ({ data }) => {
  try {
    run(new Pico(data));
  } catch (error) {
    postMessage({ error: error.message.split("\n", 1)[0] });
  }
};

function run(pico) {
  const { panel } = pico;
  let frame;
  panel.onFrame = (next) => {
    panel.check();
    // The first frame only clears the panel.
    if (panel.begun > 2) show(pico, frame, next);
    frame = next;
  };
  for (;;) pico.step();
}

function show({ asked, panel, cores }, { at, received, pixels }, next) {
  const [width, height] = panel.size();
  const rgba = new Uint8ClampedArray(4 * width * height).fill(255);
  for (let pixel = 0; pixel < width * height; pixel++) {
    rgba.set(pixels.subarray(3 * pixel, 3 * pixel + 3), 4 * pixel);
  }
  postMessage({
    width,
    rgba,
    begun: Math.floor(asked.shift() / 1000),
    lasts: (next.at - at) / 1e9,
    bytes: next.received - received,
    cores: cores.filter(({ runs }) => runs).length,
  });
}
