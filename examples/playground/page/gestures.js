// Pointers and keys on the picture and on its divider, and files dropped on the page.
import { $, state } from "./state.js";

const on = (id, event, act) => $(id).addEventListener(event, act);

/** Turns and zooms; `home` goes back to the start. */
export function onPicture(orbit, zoom, home) {
  // One pointer turns, two zoom.
  const pointers = new Map();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y) || 1;
  };
  on("canvas", "pointerdown", (event) => {
    $("canvas").setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  on("canvas", "pointermove", (event) => {
    const from = pointers.get(event.pointerId);
    if (!from) return;
    const before = pointers.size === 2 ? spread() : 0;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (before) zoom(before / spread());
    else orbit((event.clientX - from.x) / 150, (event.clientY - from.y) / 150);
  });
  for (const end of ["pointerup", "pointercancel"]) on("canvas", end, ({ pointerId }) => pointers.delete(pointerId));
  $("canvas").addEventListener(
    "wheel",
    (event) => {
      if (document.activeElement !== $("canvas")) return; // the page scrolls until the picture was clicked
      event.preventDefault();
      zoom(2 ** (event.deltaY / 500));
    },
    { passive: false },
  );
  const KEYS = {
    ArrowLeft: () => orbit(-0.1, 0),
    ArrowRight: () => orbit(0.1, 0),
    ArrowUp: () => orbit(0, -0.1),
    ArrowDown: () => orbit(0, 0.1),
    "+": () => zoom(1 / 1.1),
    "=": () => zoom(1 / 1.1),
    "-": () => zoom(1.1),
    Home: () => home(),
  };
  on("canvas", "keydown", (event) => {
    if (!KEYS[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    KEYS[event.key]();
  });
}

/** Moves the divider; `divide` gets a share of the picture. */
export function onDivider(divide) {
  on("divider", "pointerdown", (event) => $("divider").setPointerCapture(event.pointerId));
  on("divider", "pointermove", (event) => {
    if (!$("divider").hasPointerCapture(event.pointerId)) return;
    const box = $("stage").getBoundingClientRect();
    divide((event.clientX - box.left) / box.width);
  });
  on("divider", "keydown", (event) => {
    const step = {
      ArrowLeft: -0.02,
      ArrowDown: -0.02,
      ArrowRight: 0.02,
      ArrowUp: 0.02,
      PageDown: -0.1,
      PageUp: 0.1,
      Home: -1,
      End: 1,
    }[event.key];
    if (!step) return;
    event.preventDefault();
    divide(state.divider + step);
  });
}

/** Takes dropped files. */
export function onDrop(open) {
  addEventListener("dragover", (event) => {
    event.preventDefault();
    $("stage").classList.add("drop");
  });
  addEventListener("dragleave", () => $("stage").classList.remove("drop"));
  addEventListener("drop", (event) => {
    event.preventDefault();
    $("stage").classList.remove("drop");
    if (event.dataTransfer.files.length) open(event.dataTransfer.files);
  });
}
