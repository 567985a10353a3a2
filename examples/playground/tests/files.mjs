// Models that visitors drop, under Node: glTF as OBJ text, and coordinates of any size. PAGE=folder node --test.
import assert from "node:assert/strict";
import { File } from "node:buffer";
import test from "node:test";
import { crate, home, page } from "./page.mjs";

const { fitted, read } = await page("files.js");
const { OWN } = await page("module.js");

const COMPONENTS = new Map([
  [Int8Array, 5120],
  [Uint8Array, 5121],
  [Int16Array, 5122],
  [Uint16Array, 5123],
  [Uint32Array, 5125],
  [Float32Array, 5126],
]);
const floats = (...values) => new Float32Array(values);
const bytes = (...values) => new Uint8Array(values);

/** A model with an accessor for each typed array, as `[values, type, other fields]`; `more` changes its parts. */
function gltf(arrays, primitive, more = {}) {
  const bufferViews = [];
  const parts = [];
  let length = 0;
  const view = (values) => {
    const part = Buffer.alloc(Math.ceil(values.byteLength / 4) * 4);
    Buffer.from(values.buffer).copy(part);
    parts.push(part);
    bufferViews.push({ buffer: 0, byteOffset: length, byteLength: values.byteLength });
    length += part.length;
    return bufferViews.length - 1;
  };
  const sizes = { SCALAR: 1, VEC2: 2, VEC3: 3 };
  const accessors = arrays.map(([values, type, fields]) => ({
    bufferView: view(values),
    componentType: COMPONENTS.get(values.constructor),
    count: values.length / sizes[type],
    type,
    ...(typeof fields === "function" ? fields(view) : fields),
  }));
  const uri = `data:application/octet-stream;base64,${Buffer.concat(parts).toString("base64")}`;
  const model = {
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, ...primitive }] }],
    accessors,
    bufferViews,
    buffers: [{ uri, byteLength: length }],
    ...more,
  };
  return JSON.stringify(model);
}

/** The lines of OBJ text, with faces that count elements from the first one on, not back from the last one so far. */
function counted(text) {
  const known = { v: 0, vt: 0, vn: 0 };
  const index = (at, kind) => (at ? Object.values(known)[kind] + 1 + Number(at) : "");
  return new TextDecoder().decode(text).split("\n").map((line) => {
    const [word, ...corners] = line.split(" ");
    known[word]++;
    if (word !== "f") return line;
    return ["f", ...corners.map((corner) => corner.split("/").map(index).join("/").replace(/\/+$/, ""))].join(" ");
  });
}

/** The OBJ text of a file, in lines. The crate reads it. */
async function lines(text, name = "model.gltf") {
  const { model } = await read([new File([text], name)]);
  crate.read("read_model", model.text);
  return counted(model.text);
}

const TRIANGLE = [floats(0, 0, 0, 2, 0, 0, 0, 2, 0), "VEC3"];
const SQUARE = [floats(0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0), "VEC3"];
const PLACES = ["v 0 0 0", "v 2 0 0", "v 0 2 0"];

test("a triangle without indices", async () => {
  assert.deepEqual(await lines(gltf([TRIANGLE])), [...PLACES, "f 1 2 3"]);
});

test("texture coordinates of every type", async () => {
  const coordinates = [
    [floats(0, 0, 1, 0, 0, 1), {}],
    [bytes(0, 0, 255, 0, 0, 255), { normalized: true }],
    [new Uint16Array([0, 0, 65535, 0, 0, 65535]), { normalized: true }],
    [new Int16Array([0, 0, 32767, 0, 0, 32767]), { normalized: true }],
    [new Int8Array([0, 0, 127, 0, 0, 127]), { normalized: true }],
  ];
  for (const [values, fields] of coordinates) {
    const model = gltf([TRIANGLE, [values, "VEC2", fields]], { attributes: { POSITION: 0, TEXCOORD_0: 1 } });
    assert.deepEqual((await lines(model)).slice(3), ["vt 0 1", "vt 1 1", "vt 0 0", "f 1/1 2/2 3/3"]);
  }
});

test("the least of a signed type is -1, too", async () => {
  const model = gltf([[new Int8Array([-128, -127, 0, 127, 0, 0, 0, 127, 0]), "VEC3", { normalized: true }]]);
  assert.deepEqual((await lines(model)).slice(0, 3), ["v -1 -1 0", "v 1 0 0", "v 0 1 0"]);
});

test("strips turn in alternate directions", async () => {
  const model = gltf([SQUARE, [bytes(0, 1, 2, 3), "SCALAR"]], { mode: 5, indices: 1 });
  assert.deepEqual((await lines(model)).slice(4), ["f 1 2 3", "f 3 2 4"]);
});

test("fans begin at their first corner", async () => {
  const model = gltf([SQUARE, [new Uint16Array([0, 1, 3, 2]), "SCALAR"]], { mode: 6, indices: 1 });
  assert.deepEqual((await lines(model)).slice(4), ["f 1 2 4", "f 1 4 3"]);
});

test("lines and points are left out", async () => {
  for (const mode of [0, 1, 2, 3]) await assert.rejects(lines(gltf([TRIANGLE], { mode })), /no triangles/);
});

test("sparse accessors, upon values and upon zeros", async () => {
  const sparse = (view) => ({
    sparse: {
      count: 2,
      indices: { bufferView: view(bytes(0, 2)), componentType: 5121 },
      values: { bufferView: view(floats(5, 6, 7, 8, 9, 10)) },
    },
  });
  const changed = await lines(gltf([[TRIANGLE[0], "VEC3", sparse]]));
  assert.deepEqual(changed.slice(0, 3), ["v 5 6 7", "v 2 0 0", "v 8 9 10"]);
  const zeros = await lines(gltf([[TRIANGLE[0], "VEC3", (view) => ({ ...sparse(view), bufferView: undefined })]]));
  assert.deepEqual(zeros.slice(0, 3), ["v 5 6 7", "v 0 0 0", "v 8 9 10"]);
});

test("interleaved values", async () => {
  const values = floats(0, 0, 0, 9, 2, 0, 0, 9, 0, 2, 0, 9);
  const more = JSON.parse(gltf([[values, "VEC3", { count: 3 }]]));
  more.bufferViews[0].byteStride = 16;
  assert.deepEqual(await lines(JSON.stringify(more)), [...PLACES, "f 1 2 3"]);
});

test("a mirrored node keeps its faces' fronts and its normals' directions", async () => {
  const arrays = [TRIANGLE, [floats(0, 0, 1, 0, 0, 1, 1, 0, 0), "VEC3"]];
  const primitive = { attributes: { POSITION: 0, NORMAL: 1 } };
  const mirrored = ["v 0 0 0", "v -2 0 0", "v 0 2 0", "vn 0 0 1", "vn 0 0 1", "vn -1 0 0", "f 3//3 2//2 1//1"];
  for (const node of [{ scale: [-1, 1, 1] }, { matrix: [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] }]) {
    const found = await lines(gltf(arrays, primitive, { nodes: [{ mesh: 0, ...node }] }));
    assert.deepEqual(found.map((line) => line.replace(/-0\b/g, "0")), mirrored);
  }
});

test("a node's rotation goes before its translation, and a parent's scale after both", async () => {
  const half = Math.SQRT1_2;
  const nodes = [
    { scale: [2, 2, 2], children: [1] },
    { mesh: 0, rotation: [0, 0, half, half], translation: [0, 0, 1] },
  ];
  const found = (await lines(gltf([TRIANGLE], {}, { nodes }))).slice(0, 3);
  const places = found.map((line) => line.split(" ").slice(1).map((at) => Math.round(at * 1e6) / 1e6 + 0));
  assert.deepEqual(places, [
    [0, 0, 2],
    [0, 4, 2],
    [-4, 0, 2],
  ]);
});

test("of several meshes, each has its own vertices", async () => {
  const coordinates = [floats(0, 0, 1, 0, 0, 1), "VEC2"];
  const meshes = [{ attributes: { POSITION: 0, TEXCOORD_0: 1 } }, { attributes: { POSITION: 0 } }, { attributes: { POSITION: 0 } }];
  const more = { meshes: [{ primitives: meshes.slice(0, 2) }, { primitives: meshes.slice(2) }] };
  const nodes = [{ mesh: 0, children: [1] }, { mesh: 1 }];
  const found = await lines(gltf([TRIANGLE, coordinates], {}, { ...more, nodes }));
  assert.deepEqual(found.filter((line) => line.startsWith("f")), ["f 1/1 2/2 3/3", "f 4 5 6", "f 7 8 9"]);
});

test("binary glTF, and a buffer in another file", async () => {
  const model = JSON.parse(gltf([TRIANGLE]));
  const data = Buffer.from(model.buffers[0].uri.split(",")[1], "base64");
  model.buffers[0] = { uri: "some%20data.bin", byteLength: data.length };
  const apart = await read([new File([JSON.stringify(model)], "a.gltf"), new File([data], "some data.bin")]);
  assert.deepEqual(counted(apart.model.text), [...PLACES, "f 1 2 3"]);
  await assert.rejects(lines(JSON.stringify(model)), /needs some data.bin: drop both files together/);

  delete model.buffers[0].uri;
  const json = Buffer.from(JSON.stringify(model));
  const number = (value) => Buffer.from(Uint32Array.of(value).buffer);
  const header = [number(0x46546c67), number(2), number(28 + json.length + data.length), number(json.length)];
  const chunk = [number(data.length), Buffer.from("BIN\0")];
  const binary = Buffer.concat([...header, Buffer.from("JSON"), json, ...chunk, data]);
  assert.deepEqual(await lines(binary, "a.glb"), [...PLACES, "f 1 2 3"]);
  await assert.rejects(lines(binary.subarray(0, -4), "a.glb"), /cut short: buffer 0 has 32 bytes/);
});

test("messages are about the file, not about JavaScript", async () => {
  const broken = {
    "{": /damaged, or not glTF/,
    "[]": /no triangles/,
    null: /damaged, or not glTF/,
    [gltf([TRIANGLE], {}, { accessors: [] })]: /damaged/,
    [gltf([TRIANGLE], {}, { bufferViews: [] })]: /damaged/,
    [gltf([TRIANGLE], {}, { buffers: [] })]: /damaged/,
    [gltf([TRIANGLE], {}, { nodes: [] })]: /damaged/,
    [gltf([TRIANGLE], {}, { nodes: [{ children: [0] }] })]: /node 0 has two parents/,
    [gltf([TRIANGLE], {}, { extensionsRequired: ["KHR_draco_mesh_compression"] })]: /KHR_draco_mesh_compression/,
    [gltf([TRIANGLE, [bytes(0, 1, 7), "SCALAR"]], { indices: 1 })]: /vertex 7, but there are 3/,
    [gltf([TRIANGLE, [floats(0, 0), "VEC2"]], { attributes: { POSITION: 0, TEXCOORD_0: 1 } })]: /3 vertices have 1 attr/,
    [gltf([[TRIANGLE[0], "VEC3", { count: "x" }]])]: /damaged/,
    [gltf([[TRIANGLE[0], "VEC3", { count: 4 }]])]: /cut short: buffer 0 has 36 bytes/,
    [gltf([[TRIANGLE[0], "VEC3", { count: 1e9 }]])]: /1000000000 elements/,
    [gltf([[TRIANGLE[0], "VEC3", { type: "CUBE" }]])]: /cut short|damaged/,
    [gltf([[floats(0, 0, NaN, 1, 0, 0, 0, 1, 0), "VEC3"]])]: /not numbers/,
  };
  for (const [text, message] of Object.entries(broken)) await assert.rejects(lines(text), message);
});

const CORNERS = [
  [0, 0, 0],
  [3, 0, 0],
  [0, 4, 0],
];
const obj = (scale, shift = 0, head = "") =>
  new TextEncoder().encode(
    `${head}${CORNERS.map((corner) => `v ${corner.map((at) => at * scale + shift).join("\t")} # corner`).join("\n")}\nf 1 2 3\n`,
  );

test("models of any size and place have a radius near 1, and others stay as they are", () => {
  const usual = obj(1);
  assert.equal(fitted(usual).text, usual);
  for (const [scale, shift] of [[1e-6], [1e-30], [4000, 1e5], [1e6], [1e30], [0.001, 20000]]) {
    const { text, note } = fitted(obj(scale, shift));
    crate.read("read_model", text);
    const { scale: drawn, center_x, center_y, center_z } = home(OWN);
    assert.ok(Math.abs(drawn - 1) < 0.02, `${scale}: scaled by ${drawn}`);
    for (const at of [center_x, center_y, center_z]) assert.ok(Math.abs(at) < 0.02, `${scale}: center ${at}`);
    const radius = Number(/ (\S+)\n$/.exec(note)[1]);
    assert.ok(Math.abs(radius / (2.5 * scale) - 1) < 1e-5, `${scale}: ${radius}`);
  }
});

test("the parser's message has the line of the file, also of a model that was scaled", () => {
  for (const scale of [1, 1e-6, 1e6]) {
    const text = new TextDecoder().decode(obj(scale, 0, "# comment\nv 1 \\\n 0 0\n")).replace("f 1 2 3", "f 1 2 9");
    assert.throws(() => crate.read("read_model", fitted(new TextEncoder().encode(text)).text), /^Error: line 7: /);
  }
  const broken = new TextEncoder().encode("v 0 0 0\nv 1e9 x 0\n");
  assert.throws(() => crate.read("read_model", fitted(broken).text), /^Error: line 2: /);
});
