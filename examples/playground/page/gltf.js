// glTF models as OBJ text, which the crate reads.

/** The types of components; and what a normalized one is divided by. */
const TYPES = {
  5120: [Int8Array, 127],
  5121: [Uint8Array, 255],
  5122: [Int16Array, 32767],
  5123: [Uint16Array, 65535],
  5125: [Uint32Array, 1],
  5126: [Float32Array, 1],
};
const SIZES = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/**
 * The meshes of the scene as OBJ text, and the first color texture's picture if there is one. `resource` gets the bytes
 * of a file that the model names.
 */
export async function parsed(bytes, resource) {
  try {
    return await converted(bytes, resource);
  } catch (error) {
    // What is not said by this file is JavaScript's: a list or a number is not where glTF has it.
    throw error.constructor === Error ? error : new Error("it is damaged, or not glTF.");
  }
}

async function converted(bytes, resource) {
  const [gltf, chunk] = unpacked(bytes);
  const extension = gltf.extensionsRequired?.find((name) => name !== "KHR_mesh_quantization" && /mesh/.test(name));
  if (extension) throw new Error(`its meshes are compressed (${extension}), which is not read here.`);
  const fetched = ({ uri }) =>
    uri === undefined ? chunk : /^data:/.test(uri) ? fetch(uri).then((data) => data.arrayBuffer()) : resource(uri);
  const buffers = await Promise.all((gltf.buffers ?? []).map(fetched));
  const lines = triangles(gltf, (index) => values(gltf, buffers, index));
  const isWrong = lines.some((line) => /NaN|Infinity|undefined/.test(line));
  if (isWrong) throw new Error("it has coordinates that are not numbers.");
  if (!lines.some((line) => line.startsWith("f"))) throw new Error("it has no triangles in its scene.");

  const colors = gltf.materials?.map((material) => material.pbrMetallicRoughness?.baseColorTexture?.index) ?? [];
  const picture = gltf.images?.[gltf.textures?.[colors.find((index) => index !== undefined)]?.source];
  const { buffer, byteOffset = 0, byteLength } = gltf.bufferViews?.[picture?.bufferView] ?? {};
  const contents = picture?.uri ? await fetched(picture) : buffers[buffer]?.slice(byteOffset, byteOffset + byteLength);
  return { text: new TextEncoder().encode(lines.join("\n")), image: picture && new Blob([contents]) };
}

/** The JSON, and the binary part of a .glb file. */
function unpacked(bytes) {
  const view = new DataView(bytes);
  const isBinary = view.byteLength > 20 && view.getUint32(0, true) === 0x46546c67; // "glTF"
  const end = isBinary ? 20 + view.getUint32(12, true) : bytes.byteLength;
  const json = bytes.slice(isBinary ? 20 : 0, end);
  return [JSON.parse(new TextDecoder().decode(json)), bytes.slice(end + 8)];
}

/** The values of an accessor, each a list of its components. */
function values(gltf, buffers, index) {
  const { count, type, sparse, ...accessor } = gltf.accessors[index];
  if (!Number.isInteger(count)) throw new TypeError();
  if (count > 2 ** 20) throw new Error(`accessor ${index} has ${count} elements: at most 1,048,576 can be read.`);

  /** `count` elements of a buffer. */
  const elements = ({ bufferView, byteOffset = 0, componentType, normalized }, count, size) => {
    const { buffer, byteOffset: start = 0, byteStride } = gltf.bufferViews[bufferView];
    const [Type, most] = TYPES[componentType];
    const length = size * Type.BYTES_PER_ELEMENT;
    const at = (i) => start + byteOffset + i * (byteStride ?? length);
    if (count && !(at(count - 1) + length <= buffers[buffer].byteLength))
      throw new Error(`it is cut short: buffer ${buffer} has ${buffers[buffer].byteLength} bytes.`);
    // Two integers of a signed type stand for -1.
    const number = (value) => (normalized ? Math.max(value / most, -1) : value);
    const element = (_, i) => Array.from(new Type(buffers[buffer].slice(at(i), at(i) + length)), number);
    return Array.from({ length: count }, element);
  };
  const found =
    accessor.bufferView === undefined
      ? Array.from({ length: count }, () => Array(SIZES[type]).fill(0))
      : elements(accessor, count, SIZES[type]);
  if (sparse) {
    const changed = elements({ ...accessor, byteOffset: 0, ...sparse.values }, sparse.count, SIZES[type]);
    elements(sparse.indices, sparse.count, 1).forEach(([at], i) => (found[at] = changed[i]));
  }
  return found;
}

/** The lines of OBJ text for the scene's triangles. */
function triangles(gltf, values) {
  const lines = [];
  const known = [0, 0, 0]; // positions, texture coordinates and normals so far
  const add = ({ attributes, indices, mode = 4 }, place) => {
    if (mode < 4 || attributes.POSITION === undefined) return;
    const lists = ["POSITION", "TEXCOORD_0", "NORMAL"].map((name) =>
      attributes[name] === undefined ? [] : values(attributes[name]),
    );
    const [points, uvs, normals] = lists;
    const count = points.length;
    const short = lists.find(({ length }) => length && length !== count);
    if (short) throw new Error(`${count} vertices have ${short.length} attributes.`);
    for (const point of points) lines.push(`v ${transformed(place, point, 1).join(" ")}`);
    // OBJ counts v upwards.
    for (const [u, v] of uvs) lines.push(`vt ${u} ${1 - v}`);
    const turn = cofactors(place);
    const isMirrored = [0, 1, 2].reduce((sum, i) => sum + place[i] * turn[i], 0) < 0;
    for (const normal of normals) {
      const turned = transformed(turn, normal, 0);
      // Of any length for the crate, but within its numbers.
      const length = Math.hypot(...turned) * (isMirrored ? -1 : 1) || 1;
      lines.push(`vn ${turned.map((at) => at / length).join(" ")}`);
    }

    const corners = indices === undefined ? points.map((_, i) => i) : values(indices).flat();
    const wrong = corners.find((at) => !(at < count));
    if (wrong !== undefined) throw new Error(`a triangle has vertex ${wrong}, but there are ${count} vertices.`);
    const corner = (at) =>
      lists.map(({ length }, i) => (length ? at + known[i] + 1 : "")).join("/").replace(/\/+$/, "");
    const faces = [];
    for (let i = 0; i + 2 < corners.length; i += mode === 4 ? 3 : 1) {
      // A strip's triangles turn in alternate directions; all of a fan begin at its first corner.
      const [a, b, c] = mode === 6 ? [0, i + 1, i + 2] : mode === 5 && i % 2 ? [i + 1, i, i + 2] : [i, i + 1, i + 2];
      faces.push([a, b, c].map((at) => corner(corners[at])));
    }
    for (const face of faces) lines.push(`f ${(isMirrored ? face.reverse() : face).join(" ")}`);
    lists.forEach(({ length }, at) => (known[at] += length));
  };
  const seen = new Set();
  const walk = (index, parent) => {
    const { mesh, children = [], ...node } = gltf.nodes[index];
    if (seen.has(index)) throw new Error(`node ${index} has two parents.`);
    seen.add(index);
    const place = product(parent, node.matrix ?? matrix(node));
    for (const primitive of gltf.meshes?.[mesh]?.primitives ?? []) add(primitive, place);
    for (const child of children) walk(child, place);
  };
  for (const node of gltf.scenes?.[gltf.scene ?? 0]?.nodes ?? []) walk(node, IDENTITY);
  return lines;
}

// Matrices of four columns, one after the other.

/** A node's scale, then its rotation (a quaternion), then its translation. */
function matrix({ translation = [0, 0, 0], rotation: [x, y, z, w] = [0, 0, 0, 1], scale = [1, 1, 1] }) {
  const columns = [
    [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
    [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
  ];
  return [...columns.flatMap((column, at) => [...column.map((value) => value * scale[at]), 0]), ...translation, 1];
}

const product = (a, b) =>
  IDENTITY.map((_, at) => [0, 1, 2, 3].reduce((sum, k) => sum + a[(at % 4) + 4 * k] * b[at - (at % 4) + k], 0));

const transformed = (matrix, [x, y, z], w) =>
  [0, 1, 2].map((row) => matrix[row] * x + matrix[4 + row] * y + matrix[8 + row] * z + matrix[12 + row] * w);

/** The matrix for normals, times the determinant: each column is the cross product of the other two. */
function cofactors(m) {
  const cross = (a, b) => [1, 2, 0].map((i) => m[a + i] * m[b + ((i + 1) % 3)] - m[a + ((i + 1) % 3)] * m[b + i]);
  return [...cross(4, 8), 0, ...cross(8, 0), 0, ...cross(0, 4), 0, 0, 0, 0, 0];
}
