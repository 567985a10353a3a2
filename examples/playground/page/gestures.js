// Pointers and keys on the picture, and files dropped on the page.
import { $ } from "./state.js";

/** Turns and zooms; `home` goes back to the start. */
export function onPicture(orbit, zoom, home) {
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
    else orbit((event.clientX - from.clientX) / 150, (event.clientY - from.clientY) / 150);
  };
  canvas.onpointerup = canvas.onpointercancel = ({ pointerId }) => pointers.delete(pointerId);
  canvas.onwheel = (event) => {
    if (document.activeElement !== canvas) return; // the page scrolls until the picture was clicked
    event.preventDefault();
    zoom(2 ** (event.deltaY / 500));
  };
  const keys = {
    ArrowLeft: () => orbit(-0.1, 0),
    ArrowRight: () => orbit(0.1, 0),
    ArrowUp: () => orbit(0, -0.1),
    ArrowDown: () => orbit(0, 0.1),
    "+": () => zoom(1 / 1.1),
    "=": () => zoom(1 / 1.1),
    "-": () => zoom(1.1),
    Home: home,
  };
  canvas.onkeydown = (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
  };
}

/** Takes dropped files. */
export function onDrop(open) {
  const mark = (isOver) => $("stage").classList.toggle("drop", isOver);
  ondragover = (event) => {
    event.preventDefault();
    mark(true);
  };
  ondragleave = () => mark(false);
  ondrop = (event) => {
    event.preventDefault();
    mark(false);
    if (event.dataTransfer.files.length) open([...event.dataTransfer.files]);
  };
}
