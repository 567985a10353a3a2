// Models that visitors drop, under Node. The importer has its own tests of formats and mistakes: src/assets/tests.
// PAGE=folder node --test.
import assert from "node:assert/strict";
import test from "node:test";
import { checksum, crate, drop, home, page, view } from "./page.mjs";

const { OWN } = await page("module.js");

const CORNERS = [
  [0, 0, 0],
  [3, 0, 0],
  [0, 4, 0],
];
const obj = (scale = 1, shift = 0) =>
  `${CORNERS.map((corner) => `v ${corner.map((at) => at * scale + shift).join(" ")}`).join("\n")}\nf 1 2 3\n`;
/** The files' picture and the files that the printed program names. */
async function drawn(files) {
  await drop(files);
  const settings = view(OWN, { is_two_sided: 1 });
  const calls = crate.program(settings).match(/include_\w+!\(.*\)/g);
  return [checksum(settings), ...calls];
}

/** A picture in TGA: 24 bits a pixel, rows from the top down. */
function tga(width, height) {
  const head = [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, width, 0, height, 0, 24, 0x20];
  return Uint8Array.from([...head, ...Array.from({ length: 3 * width * height }, (_, at) => (at * 37) % 256)]);
}

/** The triangle in every format. STL's z points up. */
const vertices = (lines) => lines.map((at) => at.join(" ")).join("\n");
const turned = CORNERS.map(([x, y, z]) => `vertex ${x} ${-z} ${y}`).join("\n");
const bytes = Buffer.from(Float32Array.from(CORNERS.flat()).buffer);
const gltf = {
  asset: { version: "2.0" },
  scenes: [{ nodes: [0] }],
  nodes: [{ mesh: 0 }],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
  accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3", min: [0, 0, 0], max: [3, 4, 0] }],
  bufferViews: [{ buffer: 0, byteLength: 36 }],
  buffers: [{ uri: "some%20data.bin", byteLength: 36 }],
};
const ply = `ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z
element face 1\nproperty list uchar int vertex_indices\nend_header\n${vertices(CORNERS)}\n3 0 1 2\n`;

test("every format draws the same triangle, and the program names the file", async () => {
  const [wanted] = await drawn({ "a.obj": obj() });
  const formats = {
    "a.stl": `solid a\nfacet normal 0 0 0\nouter loop\n${turned}\nendloop\nendfacet\nendsolid a\n`,
    "a.ply": ply,
    "a.gltf": JSON.stringify(gltf),
    "A.OBJ": obj(),
  };
  for (const [name, contents] of Object.entries(formats)) {
    const [found, call] = await drawn({ "some data.bin": bytes, [name]: contents });
    assert.equal(found, wanted, name);
    assert.equal(call, `include_mesh!("${name}", normals)`);
  }
});

test("models of any size and place have a radius near 1, and others stay as they are", async () => {
  await drop({ "a.obj": obj() });
  assert.ok(Math.abs(home(OWN).scale - 1 / 2.5) < 0.001);
  for (const [scale, shift] of [[1e-6], [1e-20], [4000, 1e5], [1e6], [1e20], [0.001, 20000]]) {
    const notes = await drop({ "a.obj": obj(scale, shift) });
    const { scale: drawn, center_x, center_y, center_z } = home(OWN);
    assert.ok(Math.abs(drawn - 1) < 0.02, `${scale}: scaled by ${drawn}`);
    const [, center, given] = /normals(, center)?, scale = ([^ )]+)\)/.exec(crate.program(view(OWN)));
    assert.ok(Math.abs(Number(given) * 2.5 * scale - 1) < 1e-5, `${scale}: ${given}`);
    const isMoved = shift > 1000 * scale;
    assert.equal(center !== undefined, isMoved);
    assert.equal(notes.some((note) => note.includes("far from the origin")), isMoved);
    if (isMoved) for (const at of [center_x, center_y, center_z]) assert.ok(Math.abs(at) < 0.02, `${scale}: center ${at}`);
  }
});

const painted = `mtllib a.mtl\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl one\n${obj().replace("f 1 2 3", "f 1/1 2/2 3/3")}`;
const materials = "newmtl one\nmap_Kd textures/One.tga\nnewmtl two\nmap_Kd two.tga\n";

/** A PLY of the triangle whose vertices have colors. */
const painting = (colors) =>
  ply
    .replace("element face", "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face")
    .replace(vertices(CORNERS), vertices(CORNERS.map((at, corner) => [...at, ...colors[corner]])));

test("vertices have their colors, in every format", async () => {
  const [red, green, blue] = [[255, 0, 0], [0, 255, 0], [0, 0, 255]];
  const [wanted, mesh, ...others] = await drawn({ "a.ply": painting([red, green, blue]) });
  assert.deepEqual([mesh, others], ['include_mesh!("a.ply", normals)', []]);
  assert.match(crate.program(view(OWN)), /Gouraud::<Rgb565>::new\(\)\.lit\(sun\)/);
  const lines = obj().split("\n");
  const colorful = lines.map((line, at) => (at < 3 ? `${line} ${[red, green, blue][at].join(" ")}` : line)).join("\n");
  const [ofObj] = await drawn({ "a.obj": colorful });
  assert.equal(ofObj, wanted);
  const model = structuredClone(gltf);
  const colors = Buffer.from(Uint8Array.from([...red, 0, ...green, 0, ...blue, 0]));
  model.meshes[0].primitives[0].attributes.COLOR_0 = 1;
  model.accessors.push({ bufferView: 1, componentType: 5121, normalized: true, count: 3, type: "VEC3" });
  model.bufferViews.push({ buffer: 1, byteLength: 12, byteStride: 4 });
  model.buffers.push({ uri: `data:;base64,${colors.toString("base64")}`, byteLength: 12 });
  const [ofGltf] = await drawn({ "some data.bin": bytes, "a.gltf": JSON.stringify(model) });
  assert.equal(ofGltf, wanted);
  const [gray] = await drawn({ "a.ply": ply });
  const [turned] = await drawn({ "a.ply": painting([green, blue, red]) });
  assert.equal(new Set([wanted, gray, turned]).size, 3);
});

test("colors of vertices tint a texture and the colors of materials", async () => {
  const files = { "a.obj": painted, "a.mtl": "newmtl one\nKd 1 1 0\n" };
  const [yellow] = await drawn(files);
  const tinted = painted.replace(/^v .*$/gm, "$& 0 1 1");
  const [green, ...calls] = await drawn({ ...files, "a.obj": tinted });
  assert.deepEqual(calls, ['include_mesh!("a.obj", normals)', 'include_materials!("a.obj")']);
  const [other] = await drawn({ ...files, "a.mtl": "newmtl one\nKd 0 1 0\n" });
  assert.notEqual(green, yellow);
  assert.equal(green, other);
  const [plain] = await drawn({ "a.obj": painted, "skin.tga": tga(4, 4) });
  const [shaded, , skin] = await drawn({ "a.obj": tinted, "skin.tga": tga(4, 4) });
  assert.equal(skin, 'include_texture!("skin.tga")');
  assert.notEqual(plain, shaded);
});

test("a picture for a model without texture coordinates: the program computes them, too", async () => {
  const [, mesh] = await drawn({ "a.stl": `solid a\nfacet normal 0 0 0\nouter loop\n${turned}\nendloop\nendfacet\nendsolid a\n`, "a.tga": tga(4, 4) });
  assert.equal(mesh, 'include_mesh!("a.stl", normals, uvs)');
});

test("a model gets its material's picture, in sides that are powers of two", async () => {
  const others = { "other.tga": tga(4, 4), "a.mtl": materials, "a.obj": painted };
  const [found, , call] = await drawn({ ...others, "one.tga": tga(6, 8) });
  assert.equal(call, 'include_texture!("one.tga", size = "8x8")'); // as it was dropped
  // Alone, another picture follows.
  const [other, , name] = await drawn({ "other.tga": tga(4, 4) });
  assert.equal(name, 'include_texture!("other.tga")');
  assert.notEqual(other, found);
});

test("a picture that a model contains is named by its number", async () => {
  const image = (bytes) => ({ uri: `data:image/x-tga;base64,${Buffer.from(bytes).toString("base64")}` });
  const model = structuredClone(gltf);
  model.meshes[0].primitives[0].material = 0;
  Object.assign(model, {
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 1 }],
    images: [image([0]), image(tga(8, 4))],
  });
  const [, , call] = await drawn({ "some data.bin": bytes, "a.gltf": JSON.stringify(model) });
  assert.equal(call, 'include_texture!("a.gltf", image = 1)');
});

test("materials without pictures have their colors", async () => {
  const model = painted.replace("f 1/1", "usemtl one\nf 1/1");
  const files = (color) => ({ "a.mtl": `newmtl one\nKd ${color}\n`, "a.obj": model });
  const [red, mesh, parts] = await drawn(files("1 0 0"));
  assert.deepEqual([mesh, parts], ['include_mesh!("a.obj", normals)', 'include_materials!("a.obj")']);
  const [blue] = await drawn(files("0 0 1"));
  const [white, , gray] = await drawn(files("1 1 1"));
  assert.equal(new Set([red, blue, white]).size, 3);
  assert.equal(gray, undefined);
  // A picture that follows is drawn instead.
  await drop(files("1 0 0"));
  const [, , skin] = await drawn({ "other.tga": tga(4, 4) });
  assert.equal(skin, 'include_texture!("other.tga")');
});

test("notes tell what is missing, and what the page leaves out", async () => {
  const notes = async (files) => (await drop({ "a.obj": painted, ...files })).join("\n");
  assert.match(await notes({}), /a\.mtl/);
  assert.match(await notes({ "a.mtl": materials }), /cannot read texture One\.tga: drop it together with the model/);
  const two = `${painted}usemtl two\nf 1/1 3/3 2/2\n`;
  const both = { "one.tga": tga(8, 8), "two.tga": tga(8, 8), "a.mtl": materials, "a.obj": two };
  assert.match(await notes(both), /draws one texture, one\.tga, and not .*two\.tga/);
});

test("a model that is too large is refused", async () => {
  const many = `${obj()}${"f 1 2 3\n".repeat(65536)}`;
  await assert.rejects(drop({ "a.obj": many }), /65537 triangles: the page draws at most 65536/);
});
