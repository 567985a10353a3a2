// glTF models as OBJ text, which the crate reads.

/** The types of components, each with what a normalized one is divided by. */
const TYPES = {
  5120: [Int8Array, 127], 5122: [Int16Array, 32767], 5126: [Float32Array, 1],
  5121: [Uint8Array, 255], 5123: [Uint16Array, 65535], 5125: [Uint32Array, 1],
};
const SIZES = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** The scene as OBJ text, and its first texture's picture. `resource` gets the bytes of a file that the model names. */
export async function converted(bytes, resource) {
  const [gltf, chunk] = unpacked(bytes);
  const extension = gltf.extensionsRequired?.find((name) => name !== "KHR_mesh_quantization" && /mesh/.test(name));
  if (extension) throw new Error(`its meshes are compressed (${extension}), which is not read here.`);
  const fetched = ({ uri }) =>
    uri === undefined ? chunk : /^data:/.test(uri) ? fetch(uri).then((data) => data.arrayBuffer()) : resource(uri);
  const buffers = await Promise.all((gltf.buffers ?? []).map(fetched));
  const lines = [...scene(gltf, (index) => values(gltf, buffers, index))];
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
  const [start, end] = isBinary ? [20, 20 + view.getUint32(12, true)] : [0, bytes.byteLength];
  return [JSON.parse(new TextDecoder().decode(bytes.slice(start, end))), bytes.slice(end + 8)];
}

/** The values of an accessor, each a list of its components. */
function values(gltf, buffers, index) {
  const { count, type, sparse, ...accessor } = gltf.accessors[index];
  const size = SIZES[type];
  if (!Number.isInteger(count)) throw new TypeError();
  if (count > 2 ** 20) throw new Error(`accessor ${index} has ${count} elements: at most 1,048,576 can be read.`);

  /** `count` elements of a buffer. */
  const elements = ({ bufferView, byteOffset = 0, componentType, normalized }, count, size) => {
    if (bufferView === undefined) return Array.from({ length: count }, () => Array(size).fill(0));
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
  const found = elements(accessor, count, size);
  if (sparse) {
    const changed = elements({ ...accessor, byteOffset: 0, ...sparse.values }, sparse.count, size);
    elements(sparse.indices, sparse.count, 1).forEach(([at], i) => (found[at] = changed[i]));
  }
  return found;
}

/** The lines of OBJ text for a scene. `values` reads an accessor. */
function* scene(gltf, values) {
  const seen = new Set();
  function* walk(index, parent) {
    const { mesh, children = [], ...node } = gltf.nodes[index];
    if (seen.has(index)) throw new Error(`node ${index} has two parents.`);
    seen.add(index);
    const place = (at, w) => parent(placed(node, at, w), w);
    for (const primitive of gltf.meshes?.[mesh]?.primitives ?? []) yield* triangles(primitive, place, values);
    for (const child of children) yield* walk(child, place);
  }
  for (const node of gltf.scenes?.[gltf.scene ?? 0]?.nodes ?? []) yield* walk(node, (at) => at);
}

/** The lines for a primitive's triangles, in the scene where `place` puts a point (w = 1) or a direction (w = 0). */
function* triangles({ attributes, indices, mode = 4 }, place, values) {
  if (mode < 4 || attributes.POSITION === undefined) return;
  const read = (name) => (attributes[name] === undefined ? [] : values(attributes[name]));
  const lists = ["POSITION", "TEXCOORD_0", "NORMAL"].map(read);
  const [points, uvs, normals] = lists;
  const short = lists.find(({ length }) => length && length !== points.length);
  if (short) throw new Error(`${points.length} vertices have ${short.length} attributes.`);
  for (const point of points) yield `v ${place(point, 1).join(" ")}`;
  // OBJ counts v upwards.
  for (const [u, v] of uvs) yield `vt ${u} ${1 - v}`;
  // The matrix for normals, times the determinant: each column is the cross product of the other two.
  const [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => place(axis, 0));
  const columns = [cross(y, z), cross(z, x), cross(x, y)];
  const isMirrored = dot(x, columns[0]) < 0;
  for (const normal of normals) {
    const turned = [0, 1, 2].map((row) => dot(normal, columns.map((column) => column[row])));
    // Of any length for the crate, but within its numbers.
    const length = Math.hypot(...turned) * (isMirrored ? -1 : 1) || 1;
    yield `vn ${turned.map((at) => at / length).join(" ")}`;
  }

  const corners = indices === undefined ? [...points.keys()] : values(indices).flat();
  const wrong = corners.find((at) => !(at < points.length));
  if (wrong !== undefined) throw new Error(`a triangle has vertex ${wrong}, but there are ${points.length} vertices.`);
  // In OBJ, -1 is the last of the elements so far.
  const corner = (at) => lists.map(({ length }) => (length ? corners[at] - length : "")).join("/");
  for (let i = 0; i + 2 < corners.length; i += mode === 4 ? 3 : 1) {
    // A strip's triangles turn in alternate directions; all of a fan begin at its first corner.
    const [a, b, c] = mode === 6 ? [0, i + 1, i + 2] : mode === 5 && i % 2 ? [i + 1, i, i + 2] : [i, i + 1, i + 2];
    yield `f ${(isMirrored ? [c, b, a] : [a, b, c]).map(corner).join(" ")}`;
  }
}

/** Where a node puts a point (w = 1) or a direction (w = 0): scaled, rotated by a quaternion, then translated. */
function placed({ matrix: m, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }, at, w) {
  if (m) return [0, 1, 2].map((row) => dot([m[row], m[4 + row], m[8 + row], m[12 + row]], [...at, w]));
  const scaled = at.map((value, axis) => value * scale[axis]);
  // For a unit quaternion (q, r), a vector v goes to v + 2 q × (q × v + r v).
  const half = cross(rotation, scaled).map((value, axis) => value + rotation[3] * scaled[axis]);
  return cross(rotation, half).map((value, axis) => scaled[axis] + 2 * value + w * translation[axis]);
}

const dot = (a, b) => a.reduce((sum, value, axis) => sum + value * b[axis], 0);
const cross = (a, b) => [1, 2, 0].map((i) => a[i] * b[(i + 1) % 3] - a[(i + 1) % 3] * b[i]);
