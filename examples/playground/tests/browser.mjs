// The page in Chromium, as a person uses it. PAGE is the folder with the page, ADDRESS its place on a file server,
// SIMULATOR the program that draws on the host, MODEL the one that makes files for a board, AXE the script that checks
// a page's accessibility. PICTURES may name a folder for screenshots. With FIXEL_RENEW=1, the page's own pictures are
// written.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import test, { after, afterEach, beforeEach } from "node:test";
import { crc32, gunzipSync } from "node:zlib";
import { Page } from "./devtools.mjs";
import { checksum, crate, drop, home, tenths, view } from "./page.mjs";

const { ADDRESS, SIMULATOR, MODEL, PICTURES } = process.env;
const axe = readFileSync(process.env.AXE, "utf8");
const assets = resolve(import.meta.dirname ?? new URL(".", import.meta.url).pathname, "../../assets");
const folder = mkdtempSync(join(tmpdir(), "playground-files-"));
const LIGHTHOUSE = 4;
const OWN = 5;
const WORLD = 6;

const page = await Page.open();
after(async () => {
  await page.close();
  rmSync(folder, { recursive: true });
});

// What a test finds in the page.
const NUMBER = `(name) => [...document.querySelectorAll("#numbers div")]
  .find((item) => item.firstChild.textContent === name)?.lastChild.textContent`;
const shows = (settings) => page.until(`(${NUMBER})("Checksum")`, checksum(settings));
const text = (selector) => `document.querySelector("${selector}").textContent`;
const base64 = (data) => `btoa(Array.from(${data}, (byte) => String.fromCharCode(byte)).join(""))`;
const pixels = async (canvas = "#canvas") =>
  Buffer.from(
    await page.evaluate(`(() => {
      const { width, height } = document.querySelector("${canvas}");
      return ${base64(`document.querySelector("${canvas}").getContext("2d").getImageData(0, 0, width, height).data`)};
    })()`),
    "base64",
  );
/** The pixels of a picture file, as the browser reads it. */
async function decoded(path) {
  const source = `data:image/png;base64,${readFileSync(path).toString("base64")}`;
  const [width, height, data] = await page.evaluate(`(async () => {
    const bitmap = await createImageBitmap(await (await fetch("${source}")).blob());
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    return [bitmap.width, bitmap.height, ${base64("data")}];
  })()`);
  return { width, height, data: Buffer.from(data, "base64") };
}
/** Moves the divider to the right border. */
async function onlyLeft() {
  await page.evaluate(`document.querySelector("#divider").focus()`);
  await page.press("End");
  await page.until(`document.querySelector("#divider").value`, "100");
}
/** Checks that the page shows one mode to the left of a column, and another one to the right. */
async function comparesModes(index, left, right, column) {
  const sides = [left, right].map((mode, slot) => {
    const settings = view(index, { mode });
    crate.draw(settings, slot);
    return Buffer.from(crate.image("show", settings, slot).data);
  });
  assert.ok(!sides[0].equals(sides[1]));
  await page.until(`new Promise((resume) => requestAnimationFrame(() => requestAnimationFrame(() => resume(true))))`);
  const found = await pixels();
  for (let row = 0; row < 240; row++) {
    const [start, middle, end] = [0, column, 320].map((column) => 4 * (320 * row + column));
    assert.ok(found.subarray(start, middle).equals(sides[0].subarray(start, middle)), `row ${row}, left`);
    assert.ok(found.subarray(middle, end).equals(sides[1].subarray(middle, end)), `row ${row}, right`);
  }
}
const scene = (index) => page.click(`#scenes label:has([value="${index}"])`);
/** Opens the page. */
async function visit(url) {
  await page.send("Page.navigate", { url: "about:blank" }); // or another fragment would load nothing
  await page.send("Page.navigate", { url });
}

beforeEach(async () => {
  await page.size(1280, 900);
  await visit(`${ADDRESS}#scene=${LIGHTHOUSE}&compares=true`);
  await page.until(`document.readyState === "complete" && document.querySelector("#plot svg") !== null`);
  await page.evaluate(`document.querySelector("#settings").open = true`);
});
// Nothing is asked of any other place: the page works offline.
afterEach(() => {
  assert.deepEqual(page.errors.splice(0), []);
  assert.deepEqual(
    page.requests.splice(0).filter((url) => !url.startsWith(ADDRESS) && !/^(data|blob|about):/.test(url)),
    [],
  );
});

test("the lighthouse is there, with its numbers, its plot and its program", async () => {
  await shows(view(LIGHTHOUSE));
  assert.match(await page.evaluate(text("#plot")), /Newton.*Affine/);
  assert.match(await page.evaluate(text("#cost")), /Cortex-M0\+: million instructions[\d.]+/);
  assert.match(await page.evaluate(text("#code")), /^use embedded_graphics/);
  assert.equal(await page.evaluate(text("#hint")), "");
  await page.click("#copy");
  await page.until(`/^(Copied|Selected)/.test(${text("#copy")})`);
});

test("a drag turns the picture, and the start view comes back", async () => {
  const { left, top } = await page.box("#canvas");
  const [x, y] = [Math.round(left) + 100, Math.round(top) + 200];
  await page.drag([x, y], [x + 60, y + 30]);
  const { yaw, pitch } = home(LIGHTHOUSE);
  await shows(view(LIGHTHOUSE, { yaw: tenths(yaw + 60 * 0.4), pitch: tenths(pitch + 30 * 0.4) }));
  // Nobody sees it from below, where it is hollow.
  await page.drag([x, y], [x, y - 190]);
  await shows(view(LIGHTHOUSE, { yaw: tenths(yaw + 60 * 0.4), pitch: 0 }));
  await page.click("#home");
  await shows(view(LIGHTHOUSE));
});

test("two fingers zoom", async () => {
  const { left, top } = await page.box("#canvas");
  const points = (...ways) => ways.map((way, id) => ({ x: Math.round(left) + way, y: Math.round(top) + 200, id }));
  const touch = (type, touchPoints) => page.send("Input.dispatchTouchEvent", { type, touchPoints });
  await touch("touchStart", points(100, 200));
  await touch("touchMove", points(100, 225));
  await touch("touchEnd", []);
  await shows(view(LIGHTHOUSE, { distance: home(LIGHTHOUSE).distance * (100 / 125) }));
});

test("the wheel zooms after a click", async () => {
  const { left, top } = await page.box("#canvas");
  const place = { x: Math.round(left) + 100, y: Math.round(top) + 200 };
  await page.drag([place.x, place.y]);
  await page.send("Input.dispatchMouseEvent", { type: "mouseWheel", ...place, deltaX: 0, deltaY: 250 });
  await shows(view(LIGHTHOUSE, { distance: home(LIGHTHOUSE).distance * 2 ** 0.5 }));
});

test("the divider is dragged; each side shows its mode", async () => {
  const { left, top, width, height } = await page.box("#stage");
  const y = top + height / 2;
  await page.drag([left + width / 2, y], [left + width * 0.4, y], [left + width / 4, y]);
  await page.until(`document.querySelector("#divider").value`, "25");
  await comparesModes(LIGHTHOUSE, 1, 3, 80);
});

test("modes, colors and sizes: the pixels of the simulator's pictures", async () => {
  await onlyLeft();
  const cases = [
    [LIGHTHOUSE, 1, 0, 4, []],
    [LIGHTHOUSE, 2, 0, 4, ["--mode", "fast"]],
    [LIGHTHOUSE, 0, 0, 0, ["--mode", "exact", "--size", "128x64"]],
    [LIGHTHOUSE, 3, 5, 0, ["--mode", "affine", "--size", "128x64", "--color", "mono"]],
    [LIGHTHOUSE, 1, 2, 3, ["--size", "240x240", "--color", "gray8"]],
    [LIGHTHOUSE, 1, 3, 6, ["--size", "640x480", "--color", "gray4"]],
    [0, 3, 0, 4, ["--scene", "floor", "--mode", "affine"]],
    [1, 0, 0, 4, ["--scene", "cube", "--mode", "exact"]],
    [2, 2, 0, 4, ["--scene", "sphere", "--mode", "fast"]],
    [3, 1, 0, 4, ["--scene", "sphere-flat"]],
  ];
  const out = join(folder, "simulator.png");
  for (const [index, mode, format, size, options] of cases) {
    await scene(index);
    await page.choose("#mode", mode);
    await page.choose("#format", format);
    await page.choose("#size", size);
    const { data, width, height } = (execFileSync(SIMULATOR, [...options, "--out", out], { stdio: "pipe" }), await decoded(out));
    await shows(view(index, { mode, format, size: `${width}x${height}` }));
    assert.ok((await pixels()).equals(data), `scene ${index}: ${options.join(" ")}`);
  }
  // The last one interpolates nothing, so it has no errors to plot.
  await page.until(`/in texels–/.test(${text("#table")})`);
});

test("errors as colors", async () => {
  await onlyLeft();
  await page.choose("#mode", 3);
  await page.click("#showsErrors");
  await page.until(`!document.querySelector("#legend").hidden`);
  const before = await pixels();
  await page.choose("#mode", 0);
  await shows(view(LIGHTHOUSE, { mode: 0 }));
  assert.ok(!(await pixels()).equals(before));
});

test("without a fragment, the page opens on a walk in the little world", async () => {
  await visit(ADDRESS);
  await page.until(`document.querySelector("#spins").checked && location.hash.includes("spins=true")`);
  await page.until(`Number((${NUMBER})("Pictures a second")) > 0`);
  assert.match(await page.evaluate(text("#status")), /^Little world/);
});

/** A slow network, in bits a second, with a round trip in milliseconds, and how soon the page shows its first picture. */
const SLOW = { bits: 1.6e6, latency: 50, limit: 1500 };

test("at 1.6 Mbit/s, the first picture is there within 1.5 seconds, before the rest of the page", async (t) => {
  await page.send("Network.setCacheDisabled", { cacheDisabled: true });
  await page.network(SLOW.bits, SLOW.latency);
  await visit(`${ADDRESS}#scene=${WORLD}`);
  const time = await page.until(`performance.getEntriesByName("picture")[0]?.startTime`);
  const first = await pixels();
  const isFirst = await page.evaluate(`document.querySelector("main").inert`);
  await page.network();
  await page.send("Network.setCacheDisabled", { cacheDisabled: false });
  t.diagnostic(`after ${Math.round(time)} ms`);
  assert.ok(time < SLOW.limit, `after ${time} ms`);
  assert.ok(isFirst, "the rest was loaded before");
  await shows(view(WORLD));
  assert.ok(first.equals(await pixels()), "the first picture is another one");
});

/** The part of an element that is seen on the screen, from 0 to 1. */
const seen = (selector) =>
  page.evaluate(`(() => {
    const { top, bottom } = document.querySelector("${selector}").getBoundingClientRect();
    return Math.max(0, Math.min(bottom, innerHeight) - Math.max(top, 0)) / (bottom - top);
  })()`);

test("one click compares modes, and tells what they do", async () => {
  for (const [width, height] of [[1280, 900], [400, 800]]) {
    await page.size(width, height);
    await visit(`${ADDRESS}#scene=${WORLD}`);
    await shows(view(WORLD));
    assert.equal(await page.evaluate(`document.querySelector("#modes").checkVisibility()`), false);
    await page.click("label:has(#compares)");
    await comparesModes(0, 1, 3, 160);
    assert.match(await page.evaluate(text("#about")), /Drag the line.*Left: Newton.*reciprocal.*Right: Affine.*bend/);
    await page.evaluate(`document.querySelector("#stage").scrollIntoView({ block: "start" })`);
    assert.equal(await seen("#about"), 1, `not all of the text is seen beside the picture, ${width} pixels wide`);
    await page.click("label:has(#compares)");
    await page.until(text("#about"), "");
  }
});

test("the board's section begins on the first two screens", async () => {
  for (const [width, height] of [[1280, 900], [400, 800]]) {
    await page.size(width, height);
    await visit(ADDRESS);
    await page.until(`(${NUMBER})("Pictures a second")`);
    const top = await page.evaluate(`document.querySelector("#board").getBoundingClientRect().top + scrollY`);
    assert.ok(top < 2 * height, `${width} pixels wide: it begins at ${top}`);
  }
});

/** A picture of a view as a PNG file, as a data URL. */
const png = (settings) => {
  crate.draw(settings, 0);
  const { data } = crate.image("show", settings, 0);
  const { width, height } = settings;
  return page.evaluate(`(() => {
    const canvas = Object.assign(document.createElement("canvas"), { width: ${width}, height: ${height} });
    const data = Uint8ClampedArray.from(atob("${Buffer.from(data).toString("base64")}"), (byte) => byte.charCodeAt());
    canvas.getContext("2d").putImageData(new ImageData(data, ${width}), 0, 0);
    return canvas.toDataURL();
  })()`);
};

test("other sites find a description, a picture and an icon", async () => {
  const pictures = {
    "preview.png": view(WORLD, { size: "640x336", yaw: 40 }),
    "icon.png": view(1, { size: "128x128", mode: 0, yaw: 30, pitch: 25, distance: 3.2 }),
  };
  for (const [name, settings] of Object.entries(pictures)) {
    const path = resolve(assets, "../playground/page", name);
    if (process.env.FIXEL_RENEW) writeFileSync(path, Buffer.from((await png(settings)).split(",")[1], "base64"));
    crate.draw(settings, 0);
    const { data } = crate.image("show", settings, 0);
    const found = await decoded(path);
    assert.deepEqual([found.width, found.height], [settings.width, settings.height]);
    assert.ok(found.data.equals(Buffer.from(data)), `${name} is not as it is drawn: FIXEL_RENEW=1 writes it`);
  }
  const head = await page.evaluate(`Object.fromEntries([...document.querySelectorAll("meta")]
    .map((item) => [item.name || item.getAttribute("property"), item.content]))`);
  assert.ok(head.description.length > 50 && head.description.length < 200);
  assert.equal(head["og:image"], `${head["og:url"]}preview.png`);
  assert.equal(await page.evaluate(`document.querySelector("link[rel=icon]").href`), `${ADDRESS}icon.png`);
});

test("the guide is beside the page, and the source and the command to install are there", async () => {
  const links = await page.evaluate(`[...document.querySelectorAll("a")].map(({ href }) => href)`);
  const source = "https://github.com/fixel-rs/fixel";
  const steps = "examples/boards/flash.md";
  assert.deepEqual(links, [`${ADDRESS}doc/fixel/guide/index.html`, source, `${source}/blob/main/${steps}`]);
  assert.ok(existsSync(resolve(assets, "../..", steps)));
  assert.equal(await page.evaluate(text("nav code")), `cargo add fixel --git ${source}`);
});

test("the address holds the state", async () => {
  await page.choose("#mode", 2);
  await page.choose("#format", 2);
  const { left, top } = await page.box("#canvas");
  await page.drag([left + 100, top + 200], [left + 160, top + 200]);
  const yaw = tenths(home(LIGHTHOUSE).yaw + 60 * 0.4);
  await shows(view(LIGHTHOUSE, { mode: 2, format: 2, yaw }));
  const kept = await page.until(`/yaw=.*compares=true.*mode=2.*format=2/.test(location.hash) && location.href`);
  await page.send("Page.navigate", { url: "about:blank" });
  await page.send("Page.navigate", { url: kept });
  await shows(view(LIGHTHOUSE, { mode: 2, format: 2, yaw }));
});

test("the address holds the panel and its model, but not a model that was dropped", async () => {
  await page.choose("#panel", 1);
  await chooseModel("cabin");
  const reload = async (pattern) => {
    const kept = await page.until(`/${pattern}/.test(location.hash) && location.href`);
    await page.send("Page.navigate", { url: "about:blank" });
    await page.send("Page.navigate", { url: kept });
    await shows(view(LIGHTHOUSE));
  };
  await reload("model=cabin.*panel=1");
  await page.until(text("#flash"), "Save cabin.obj as UF2");
  assert.equal(await page.evaluate(`document.querySelector("#panel").value`), "1");
  await page.drop("#stage", lighthouse);
  await page.until(`document.querySelector("#model").value`, "own");
  await scene(LIGHTHOUSE);
  await reload("model=own");
  await page.until(text("#flash"), "Save lighthouse.obj as UF2");
  assert.equal(await page.evaluate(`document.querySelector("#model").value`), "lighthouse");
});

test("a picture that turns goes on after a reload", async () => {
  await page.click("#spins");
  await page.until(`(${NUMBER})("Pictures a second")`);
  await page.send("Page.reload");
  await page.until(`(${NUMBER})("Pictures a second")`);
  await page.click("#spins");
  await page.until(`(${NUMBER})("Checksum")`);
  await page.send("Page.reload");
  await page.until(`(${NUMBER})("Checksum")`);
  assert.equal(await page.evaluate(`document.querySelector("#spins").checked`), false);
});

test("on the segment, one point is dragged and the other one follows", async () => {
  const values = () => page.evaluate(`["on_screen", "in_space"].map((id) => Number(document.getElementById(id).value))`);
  const dragged = async (selector, right, down) => {
    const { left, top, width, height } = await page.box(selector);
    const [x, y] = [left + width / 2, top + height / 2];
    await page.drag([x, y], [x + right / 2, y + down / 2], [x + right, y + down]);
    return values();
  };
  // The segment's ends are at the distances 1 and 4: t = q / (4 - 3q), and q = 4t / (1 + 3t).
  const [[q], [, t]] = [await dragged("#pixel", 0, 20), await values()];
  assert.ok(q > 0.6 && Math.abs(t - q / (4 - 3 * q)) < 1e-6, `${q}, ${t}`);
  const [p, s] = await dragged("#place", 100, 40);
  assert.ok(s > t + 0.1 && Math.abs(p - (4 * s) / (1 + 3 * s)) < 1e-6, `${p}, ${s}`);
});

test("bands in slow motion are the same picture", async () => {
  await page.choose("#band", 2);
  await page.click("#bands");
  await page.until(`${text("#status")}.endsWith("bit for bit, as drawn whole.")`);
  await shows(view(LIGHTHOUSE));
});

test("the little world has the default mode, and no comparison", async () => {
  await page.choose("#mode", 3);
  await scene(WORLD);
  await shows(view(WORLD));
  assert.equal(await page.evaluate(`(${NUMBER})("Mode")`), "Newton");
  assert.equal(await page.evaluate(`document.querySelector("#compares").checked`), false);
  assert.match(await page.evaluate(text("#code")), /Newton::default\(\)/);
});

const lighthouse = ["lighthouse.obj", "lighthouse.png"].map((name) => join(assets, name));
const [island, skin] = lighthouse.map((path) => readFileSync(path));

/** The settings of a visitor's model, with its files by their names. */
async function own(files) {
  await drop(files);
  return view(OWN);
}

/** A triangle in space with texture coordinates, its buffer and its texture in files beside it. */
function triangle() {
  const values = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 0, 0); // v counts down: 1 in glTF, 0 in OBJ
  const accessor = (byteOffset, type, more) => ({ bufferView: 0, componentType: 5126, count: 3, byteOffset, type, ...more });
  const model = {
    asset: { version: "2.0" },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, scale: [1e-5, 1e-5, 1e-5] }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }],
    images: [{ uri: "lighthouse.png" }],
    accessors: [accessor(0, "VEC3", { min: [0, 0, 0], max: [1, 1, 1] }), accessor(36, "VEC2")],
    bufferViews: [{ buffer: 0, byteLength: 60 }],
    buffers: [{ uri: "triangle.bin", byteLength: 60 }],
  };
  const paths = ["triangle.gltf", "triangle.bin"].map((name) => join(folder, name));
  writeFileSync(paths[0], JSON.stringify(model));
  writeFileSync(paths[1], Buffer.from(values.buffer));
  return [...paths, lighthouse[1]];
}

test("a model and its texture are dropped", async () => {
  await page.drop("#stage", lighthouse);
  await shows(await own({ "lighthouse.obj": island, "lighthouse.png": skin }));
  assert.equal(await page.evaluate(text("#status")), "lighthouse.obj is read.");
  assert.match(await page.evaluate(text("#code")), /include_mesh!\("lighthouse.obj"(, normals)?\)/);
  assert.match(await page.evaluate(text("#code")), /include_texture!\("lighthouse.png"\)/);
});

test("without its texture, a model is gray, and the page tells it; the texture alone may follow", async () => {
  await page.drop("#stage", lighthouse.slice(0, 1));
  await shows(await own({ "lighthouse.obj": island }));
  const told = "lighthouse.obj is read. Drop a picture too, to give it a texture.";
  assert.equal(await page.evaluate(text("#status")), told);
  await page.drop("#stage", lighthouse.slice(1));
  await shows(await own({ "lighthouse.png": skin }));
  assert.equal(await page.evaluate(text("#status")), "lighthouse.png is read.");
});

test("a glTF model of a hundred-thousandth of a unit is opened with its buffer and texture", async () => {
  const files = triangle();
  const { root } = await page.send("DOM.getDocument");
  const { nodeId } = await page.send("DOM.querySelector", { nodeId: root.nodeId, selector: "#files" });
  await page.send("DOM.setFileInputFiles", { nodeId, files });
  const obj = `${["0 0 0", "1e-5 0 0", "0 1e-5 1e-5"].map((at) => `v ${at}`).join("\n")}
    vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n`;
  await shows(await own({ "triangle.obj": obj, "lighthouse.png": skin }));
  assert.equal(await page.evaluate(text("#status")), "triangle.gltf is read.");
});

/** Drops files with a model, or chooses one of the page's models. */
async function chooseModel(files) {
  if (Array.isArray(files)) return files.length && page.drop("#stage", files);
  await page.choose("#model", await page.evaluate(`[...document.querySelectorAll("#model option")].findIndex(({ value }) => value === "${files}")`));
}

/** What an ELF file puts into memory: addresses and bytes. */
function segments(elf) {
  const all = Array.from({ length: elf.readUInt16LE(44) }, (_, at) => elf.readUInt32LE(28) + 32 * at);
  const loaded = all.filter((at) => elf.readUInt32LE(at) === 1 && elf.readUInt32LE(at + 16) > 0);
  return loaded.map((at) => {
    const [offset, , address, size] = [4, 8, 12, 16].map((field) => elf.readUInt32LE(at + field));
    return { address, bytes: elf.subarray(offset, offset + size) };
  });
}

/** The file that a click saves, once the page tells so. */
async function downloaded(button, name, told) {
  await page.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: folder });
  await page.click(button);
  await page.until(`${text(told)}.startsWith("${name} holds")`);
  const path = join(folder, name);
  for (let wait = 0; !existsSync(path) && wait < 100; wait++) await new Promise((resume) => setTimeout(resume, 100));
  const file = readFileSync(path);
  rmSync(path);
  return file;
}

test("a turn is saved as a GIF, here in three colors", async () => {
  await scene(0);
  await page.choose("#mode", 3);
  await shows(view(0, { mode: 3 }));
  const file = await downloaded("#gif", "floor.gif", "#status");
  const [count, ...pictures] = await page.evaluate(`(async () => {
    const data = Uint8Array.from(atob("${file.toString("base64")}"), (byte) => byte.charCodeAt());
    const decoder = new ImageDecoder({ type: "image/gif", data });
    await Promise.all([decoder.tracks.ready, decoder.completed]);
    const found = [decoder.tracks.selectedTrack.frameCount];
    const context = new OffscreenCanvas(320, 240).getContext("2d");
    for (const frameIndex of [0, 12]) {
      context.drawImage((await decoder.decode({ frameIndex })).image, 0, 0);
      const { data } = context.getImageData(0, 0, 320, 240);
      found.push(${base64("data")});
    }
    return found;
  })()`);
  assert.equal(count, 48);
  for (const [at, yaw] of [[0, 0], [1, 25]]) {
    const settings = view(0, { mode: 3, yaw });
    crate.draw(settings, 0);
    const { data } = crate.image("show", settings, 0);
    assert.ok(Buffer.from(pictures[at], "base64").equals(Buffer.from(data)), `yaw ${yaw}`);
  }
});

/** The boards, in the order in which the page offers them: a program, the bytes of flash, and the family of UF2s. */
const BOARDS = [
  { program: "pico_model.gz", size: 2 << 20, family: 0xe48bff56 },
  { program: "pico2_model.gz", size: 4 << 20, family: 0xe48bff59 },
];
/** Chooses a board and a display by their numbers. */
const choose = (board, panel) =>
  page.evaluate(`[["chip", ${board}], ["panel", ${panel}]].forEach(([id, at]) => {
    document.getElementById(id).selectedIndex = at;
    document.getElementById(id).dispatchEvent(new Event("change", { bubbles: true }));
  })`);

/** Saves a UF2 for a board, and returns what it puts into the board's flash. */
async function saved(name, { size, family }) {
  const file = await downloaded("#flash", name, "#flashed");
  const flash = Buffer.alloc(size, 0xff);
  assert.equal(file.length % 512, 0);
  for (let at = 0; at < file.length; at += 512) {
    const word = (index) => file.readUInt32LE(at + 4 * index);
    assert.deepEqual([word(0), word(1), word(2), word(127)], [0x0a324655, 0x9e5d5157, 0x2000, 0x0ab16f30]);
    // Block by block, 256 bytes each.
    assert.deepEqual([word(4), word(5), word(6), word(7)], [256, at / 512, file.length / 512, family]);
    file.copy(flash, word(3) - FLASH, at + 32, at + 288);
  }
  return { file, flash };
}
const FLASH = 0x10000000;
/** Where the model begins in flash. */
const BEHIND = 0x40000;

test("a file for a board holds its program and the model", async () => {
  const cabin = ["cabin.obj", "cabin.mtl", "planks.tga"].map((name) => join(assets, name));
  const cases = [
    // Board, panel, the number of triangles, the texture's width, and what the host makes the same file of.
    ["lighthouse.uf2", [], 0, 0, 1144, 128, ["st7789", ...lighthouse]],
    ["lighthouse.uf2", [], 1, 0, 1144, 128, ["st7789", ...lighthouse]],
    ["cabin.uf2", cabin, 0, 1, 54, 32, ["ili9341", cabin[0]]],
    ["cabin.uf2", [], 1, 1, 54, 32, ["ili9341", cabin[0]]],
    // Models of the page, whose files lie side by side there.
    ["house.uf2", "house", 0, 1, 14, 8, ["ili9341", join(process.env.PAGE, "house.obj")]],
    ["globe.uf2", "globe", 1, 0, 720, undefined, ["st7789", join(process.env.PAGE, "globe.ply")]],
  ];
  for (const [name, files, board, panel, faces, width, args] of cases) {
    const program = gunzipSync(readFileSync(join(process.env.PAGE, BOARDS[board].program)));
    const elf = join(folder, "program");
    writeFileSync(elf, program);
    await chooseModel(files);
    await page.until(`/^Save ${name.replace("uf2", "(obj|ply)")} as UF2$/.test(${text("#flash")})`);
    await choose(board, panel);
    // Before anything is saved, the page tells what the host tells: notes, and what the model costs.
    const made = spawnSync(MODEL, [elf, ...args], { maxBuffer: 1 << 24 });
    assert.equal(made.status, 0);
    const [cost, ...notes] = made.stderr.toString().trim().split("\n").reverse();
    const sentences = notes.reverse().map((note) => note.replace(/^note: (.)/, (_, letter) => letter.toUpperCase()));
    const told = [`${name.replace("uf2", "(obj|ply)")} on a Pico${board ? " 2" : ""}: `, [cost, ...sentences, ""].join(". ").trim()];
    await page.until(`/^${told[0]}/.test(${text("#estimate")}) && ${text("#estimate")}.endsWith(${JSON.stringify(told[1])})`);
    const { file, flash } = await saved(name, BOARDS[board]);
    // An RP2350 starts only a program with this block in its first 4 KiB: for Arm cores, and the only one.
    const block = Buffer.from("d3deffff42012110ff01000000000000793512ab", "hex");
    assert.equal(flash.subarray(0, 4096).includes(block), board === 1);
    for (const { address, bytes } of segments(program)) {
      assert.ok(flash.subarray(address - FLASH, address - FLASH + bytes.length).equals(bytes), `${address}`);
    }
    const word = (index) => flash.readUInt32LE(BEHIND + 4 * index);
    assert.equal(flash.toString("latin1", BEHIND, BEHIND + 4), "fixm");
    // The checksum is that of everything behind it. src/lib.rs of the package flash-model has the format.
    assert.equal(word(3), crc32(flash.subarray(BEHIND + 16, BEHIND + word(2))));
    assert.deepEqual([word(4), word(30)], [panel, faces]);
    const lists = [6, 6, 3, 6, 4, 6, 3, 6, 24].map((size, list) => Math.ceil((word(29 + list) * size) / 4));
    if (width) assert.equal(word(40 + lists.reduce((sum, words) => sum + words)), width);
    // The emulated boards of .ci/boards run files from there.
    assert.ok(made.stdout.equals(file), `${name} is not the host's`);
  }
});

test("a file for a Pico runs on an emulated one, whose display shows the host's picture", async () => {
  const cabin = ["cabin.obj", "cabin.mtl", "planks.tga"].map((name) => join(assets, name));
  const cases = [
    // The board, the panel, the display's columns, and the clock of its bus. The file for a Pico 2 has the same model.
    ["lighthouse", [], 0, 0, 240, 62_500_000],
    ["cabin", cabin, 1, 1, 320, 31_250_000],
    ["globe", "globe", 0, 0, 240, 62_500_000],
  ];
  for (const [name, files, board, panel, width, clock] of cases) {
    await chooseModel(files);
    await page.until(`/^Save ${name}.(obj|ply) as UF2$/.test(${text("#flash")})`);
    await choose(board, panel);
    const uf2 = join(folder, "run.uf2");
    writeFileSync(uf2, (await saved(`${name}.uf2`, BOARDS[board])).file);
    await page.click("#emulate");
    await page.until(`/^${name}.(obj|ply) runs on/.test(${text("#flashed")})`);
    assert.equal(await page.evaluate(`${text("#flashed")}.includes("The page emulates no Pico 2.")`), board === 1);
    // The picture moves at full speed, while the emulated board begins.
    const moments = new Set();
    for (let at = 0; at < 10; at++) {
      moments.add(crc32(await pixels("#screen")));
      await new Promise((resume) => setTimeout(resume, 100));
    }
    assert.ok(moments.size >= 8, `only ${moments.size} pictures in a second`);
    // It has turned a little since the start.
    const time = `Number(/begun after ([\\d.]+) seconds/.exec(${text("#emulated")})?.[1])`;
    await page.until(`${time} > 0.5`);
    assert.match(await page.evaluate(text("#emulated")), /with the same pixels as the picture here/);
    assert.equal(await page.evaluate(text("#emulate")), "Stop");
    // The emulated display's own picture stays.
    await page.click("#emulate");
    await page.until(text("#emulate"), "Run it here");

    const host = execFileSync(MODEL, [uf2, `${Math.round(1000 * (await page.evaluate(time)))}`], { maxBuffer: 1 << 24 });
    const head = `P6 ${width} 240 255\n`;
    assert.equal(host.toString("latin1", 0, head.length), head);
    const shown = (await pixels("#screen")).filter((_, at) => at % 4 !== 3);
    assert.ok(shown.equals(host.subarray(head.length)), `${name}: the display shows another picture`);
    // Two bytes a pixel, and three commands with their numbers. The bus lets no more frames through.
    const bytes = 2 * width * 240 + 14;
    const figures = /^([\d.]+) frames a second on (?:one core|2 cores), with ([\d,]+) bytes/;
    const [, rate, told] = figures.exec(await page.evaluate(text("#emulated")));
    assert.equal(told, bytes.toLocaleString("en"));
    assert.ok(rate > 5 && rate <= clock / (8 * bytes), `${name}: ${rate} frames a second`);
  }
});

/** Makes the page get something else in place of a file. */
const replace = (name, response) =>
  page.evaluate(`(() => {
    const { fetch } = window;
    window.fetch = (asked) => (asked === "${name}" ? ${response} : fetch(asked));
  })()`);

test("the page tells why the emulated Pico has stopped", async () => {
  const program = gunzipSync(readFileSync(join(process.env.PAGE, "pico_model.gz")));
  for (const { bytes } of segments(program)) bytes.fill(0xff);
  const bytes = `Uint8Array.from(atob("${program.toString("base64")}"), (byte) => byte.charCodeAt())`;
  await replace("pico_model.gz", `new Response(${bytes})`);
  await page.click("#emulate");
  await page.until(`/^The board has stopped: .* at 10000000 is not implemented/.test(${text("#flashed")})`);
  assert.equal(await page.evaluate(text("#emulate")), "Run it here");
});

test("the page tells that an emulated Pico has drawn another picture", async () => {
  const frame = "{ width: 240, rgba: new Uint8ClampedArray(4 * 240 * 240), begun: 40, lasts: 0.1, bytes: 115214, cores: 2 }";
  await replace("emulator.js.gz", `new Response("onmessage = () => postMessage(${frame})")`);
  await page.click("#emulate");
  await page.until(`/^10 frames a second on 2 cores.* other pixels than the picture here in 1;/.test(${text("#emulated")})`);
  await page.click("#emulate");
});

test("the page tells that it was built without the emulator", async () => {
  await replace("emulator.js.gz", `new Response("", { status: 404 })`);
  await page.click("#emulate");
  const told = "emulator.js.gz is missing here (404). This page was built without the emulator. Everything else works.";
  await page.until(text("#flashed"), told);
  assert.equal(await page.evaluate(text("#emulate")), "Run it here");
});

test("the page tells why a model cannot be saved for a Pico, but a Pico 2 has room for it", async () => {
  // The page draws as many triangles, but all lists with indices of their own take 2 MB.
  const count = 65_535;
  // A point has other texture coordinates and another normal in each of its three faces, so lists cannot share indices.
  const corner = (at, side) => {
    const other = ((at + side) % count) + 1;
    return `${(at % count) + 1}/${other}/${other}`;
  };
  const lines = (line) => Array.from({ length: count }, (_, at) => line(at)).join("\n");
  const points = lines((at) => `v ${at} ${at % 2} ${at % 3}\nvt ${at / count} 0\nvn ${at} 1 0`);
  const faces = lines((at) => `f ${corner(at, 0)} ${corner(at + 1, 1)} ${corner(at + 2, 2)}`);
  writeFileSync(join(folder, "many.obj"), `${points}\n${faces}\n`);
  await page.drop("#stage", [join(folder, "many.obj"), lighthouse[1]]);
  await page.until(text("#flash"), "Save many.obj as UF2");
  await choose(0, 0);
  await page.click("#flash");
  await page.until(`/^model many.obj: it takes \\d+ bytes of flash: 1835008 fit$/.test(${text("#flashed")})`);
  await choose(1, 0);
  const { flash } = await saved("many.uf2", BOARDS[1]);
  assert.ok(flash.readUInt32LE(BEHIND + 8) > 1835008);
});

test("the page tells why a file cannot be read, and the last picture stays", async () => {
  await page.drop("#stage", lighthouse);
  const settings = await own({ "lighthouse.obj": island, "lighthouse.png": skin });
  await shows(settings);
  const neither = "it is neither a model (.obj, .stl, .ply, .gltf, .glb) nor a picture for its texture: it is not a PNG";
  const wrong = {
    "points.obj": ["v 0 0 0\nv 1 0 0\n", "model points.obj: it has points or lines, but no faces"],
    "broken.gltf": ['{"a"}', "model broken.gltf: "],
    "note.txt": ["Hello", `note.txt: ${neither}`],
    "skin.png": ["no picture", `skin.png: ${neither}`],
  };
  for (const [name, [content, message]] of Object.entries(wrong)) {
    writeFileSync(join(folder, name), content);
    await page.drop("#stage", [join(folder, name)]);
    await page.until(`${text("#trouble")}.startsWith(${JSON.stringify(message)})`);
    await shows(settings);
  }
  await page.click("#home");
  await page.until(text("#trouble"), "");
});

test("a model of which nothing is seen is no blank picture without a word", async () => {
  writeFileSync(join(folder, "back.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n");
  await page.drop("#stage", [join(folder, "back.obj")]);
  await page.until(`/^Nothing is seen/.test(${text("#hint")})`);
  await scene(LIGHTHOUSE);
  await page.until(text("#hint"), "");
});

test("the keyboard alone", async () => {
  // Everything that can be used is reached in turn, and shows that it is.
  const wanted = await page.evaluate(`[...document.querySelectorAll("a, summary, input, select, button, canvas[tabindex], pre")]
    .filter((item) => item.checkVisibility() && !item.disabled && (item.name !== "scene" || item.checked)).length`);
  const reached = new Set();
  await page.evaluate(`document.activeElement.blur()`);
  for (let at = 0; at < 60 && reached.size < wanted; at++) {
    await page.press("Tab");
    const [id, outline] = await page.evaluate(`(() => {
      const item = document.activeElement;
      const shown = [item, item.closest("label")].map((at) => at ? getComputedStyle(at).outlineStyle : "none");
      return [item.id || item.name || (item.tagName === "BODY" ? "BODY" : item.textContent), shown.some((style) => style !== "none")];
    })()`);
    if (id !== "BODY") assert.ok(outline, `${id} does not show that it has the focus`);
    reached.add(id);
  }
  reached.delete("BODY");
  assert.equal(reached.size, wanted, [...reached].join(" "));

  const { yaw, distance } = home(LIGHTHOUSE);
  await page.evaluate(`document.querySelector("#canvas").focus()`);
  await page.press("ArrowRight");
  await shows(view(LIGHTHOUSE, { yaw: tenths(yaw + 6) }));
  await page.press("+");
  await shows(view(LIGHTHOUSE, { yaw: tenths(yaw + 6), distance: distance / 1.1 }));
  await page.press("Home");
  await shows(view(LIGHTHOUSE));
  await page.evaluate(`document.querySelector("#divider").focus()`);
  await page.press("ArrowLeft");
  await page.until(`document.querySelector("#divider").value`, "49");
  await page.evaluate(`document.querySelector("#scenes input:checked").focus()`);
  await page.press("ArrowRight");
  await shows(view(0));
  await page.evaluate(`document.querySelector("#spins").focus()`);
  await page.press(" ");
  await page.until(`(${NUMBER})("Pictures a second")`);
});

/** The least contrast of text outside the picture, with the text. */
const CONTRAST = `(() => {
  const channels = (color) => color.match(/[\\d.]+/g).map(Number);
  const light = (color) => channels(color).slice(0, 3)
    .map((value) => (value /= 255) <= 0.03928 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4)
    .reduce((sum, value, at) => sum + value * [0.2126, 0.7152, 0.0722][at], 0);
  const behind = (item) => {
    const color = item ? getComputedStyle(item).backgroundColor : "rgb(255, 255, 255)";
    return channels(color)[3] === 0 ? behind(item.parentElement) : color;
  };
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const found = [];
  while (texts.nextNode()) {
    const item = texts.currentNode.parentElement;
    if (!texts.currentNode.data.trim() || item.closest("#stage, :disabled, [hidden]") || !item.checkVisibility()) continue;
    const style = getComputedStyle(item);
    const [a, b] = [light(item.closest("svg") ? style.fill : style.color), light(behind(item))];
    found.push([(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), texts.currentNode.data]);
  }
  return found.sort(([a], [b]) => a - b)[0];
})()`;

test("no scrolling sideways, and text that can be read, in light and dark", async () => {
  for (const width of [360, 800, 1280]) {
    await page.size(width, 900);
    for (const theme of ["light", "dark"]) {
      await page.theme(theme);
      await shows(view(LIGHTHOUSE));
      await page.until(`document.querySelector("#plot svg") !== null`);
      const [contrast, words] = await page.evaluate(CONTRAST);
      assert.ok(contrast >= 4.5, `${theme}: "${words}" has a contrast of ${contrast.toFixed(2)}`);
      if (PICTURES) writeFileSync(join(PICTURES, `${theme}-${width}.png`), await page.screenshot());
    }
    for (const index of [WORLD, OWN, 2, LIGHTHOUSE]) {
      await scene(index);
      await page.until(`Number(document.querySelector("#scenes input:checked").value)`, index);
      const widest = await page.evaluate(`document.documentElement.scrollWidth`);
      assert.ok(widest <= width, `scene ${index} is ${widest} pixels wide on a screen of ${width}`);
    }
  }
});

test("a model with a long name fits on a small screen", async () => {
  const name = `${"long".repeat(30)}.obj`;
  writeFileSync(join(folder, name), island);
  await page.size(360, 900);
  await page.drop("#stage", [join(folder, name)]);
  await page.until(text("#flash"), `Save ${name} as UF2`);
  assert.ok((await page.evaluate(`document.documentElement.scrollWidth`)) <= 360);
});

test("axe finds nothing to mend, in light and dark", async () => {
  for (const width of [360, 1280]) {
    await page.size(width, 900);
    for (const theme of ["light", "dark"]) {
      await page.theme(theme);
      for (const index of [LIGHTHOUSE, WORLD, OWN]) {
        await scene(index);
        if (index === LIGHTHOUSE && theme === "dark") await page.click("label:has(#compares)");
        await page.until(`Number(document.querySelector("#scenes input:checked").value)`, index);
        await page.until(`${text("#code")}.includes("fn draw")`);
        const found = await page.evaluate(`${axe}; axe.run().then(({ violations }) =>
          violations.flatMap(({ id, help, nodes }) => nodes.map(({ target }) => id + " of " + target + ": " + help)))`);
        assert.deepEqual(found, [], `${theme}, ${width} pixels wide, scene ${index}`);
      }
    }
  }
});
