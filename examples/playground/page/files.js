// Files of the visitor's own: models as OBJ text, textures as pixels. The browser decodes pictures.

const PICTURE = /\.(png|jpe?g|webp|gif|bmp|avif)$/i;

/** Reads dropped files; returns the model as OBJ text and its texture, or undefined for what is not among them. */
export async function read(files) {
  const list = [...files];
  const find = (pattern) => list.find(({ name }) => pattern.test(name));
  const [obj, gltf, picture] = [find(/\.obj$/i), find(/\.(gltf|glb)$/i), find(PICTURE)];
  if (!obj && !gltf && !picture) throw new Error("Neither a model (.obj, .gltf, .glb) nor a picture for its texture.");
  let [text, image] = [undefined, picture];
  if (gltf) {
    const buffer = await gltf.arrayBuffer();
    const model = await parsed(buffer, list);
    [text, image] = [model.text, picture ?? model.image];
  } else if (obj) {
    text = new Uint8Array(await obj.arrayBuffer());
  }
  return { name: (obj ?? gltf)?.name, text, texture: image && (await pixels(image)) };
}

/** The pixels of a picture, with sides that are powers of two, 512 at most. */
async function pixels(file) {
  const bitmap = await createImageBitmap(file).catch(() => {
    throw new Error(`${file.name ?? "The texture"}: the browser cannot read this picture.`);
  });
  const [width, height] = [bitmap.width, bitmap.height].map((side) => 2 ** Math.min(Math.round(Math.log2(side)), 9));
  const context = new OffscreenCanvas(width, height).getContext("2d");
  context.drawImage(bitmap, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}

const TYPES = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array,
};
const SIZES = { SCALAR: 1, VEC2: 2, VEC3: 3 };

/** A glTF model, all meshes of its scene, as OBJ text for the crate's parser; and the first texture's picture. */
async function parsed(buffer, files) {
  const view = new DataView(buffer);
  let [json, binary] = [buffer, undefined];
  if (view.byteLength > 20 && view.getUint32(0, true) === 0x46546c67) {
    // "glTF"
    const length = view.getUint32(12, true);
    json = buffer.slice(20, 20 + length);
    binary = buffer.slice(28 + length);
  }
  const gltf = JSON.parse(new TextDecoder().decode(json));
  const resource = async (uri) => {
    if (uri.startsWith("data:")) return (await fetch(uri)).arrayBuffer();
    const name = decodeURIComponent(uri).split("/").pop();
    const file = files.find((file) => file.name === name);
    if (!file) throw new Error(`The model needs ${name}: drop both files together.`);
    return file.arrayBuffer();
  };
  const buffers = await Promise.all((gltf.buffers ?? []).map(({ uri }) => (uri ? resource(uri) : binary)));
  const values = (index) => {
    const { bufferView, byteOffset = 0, componentType, count, type, sparse } = gltf.accessors[index];
    const Type = TYPES[componentType];
    if (bufferView === undefined || sparse || !Type)
      throw new Error("This glTF is compressed, which is not read here.");
    const { buffer: at, byteOffset: start = 0, byteStride } = gltf.bufferViews[bufferView];
    const [size, width] = [SIZES[type], Type.BYTES_PER_ELEMENT];
    const stride = byteStride ?? size * width;
    return Array.from({ length: count }, (_, i) => {
      const from = start + byteOffset + i * stride;
      return [...new Type(buffers[at].slice(from, from + size * width))];
    });
  };

  const lines = [];
  let [positions, uvs] = [0, 0];
  const add = ({ attributes, indices, mode = 4 }, place) => {
    if (mode !== 4 || attributes.POSITION === undefined) return;
    const points = values(attributes.POSITION);
    for (const point of points)
      lines.push(
        `v ${place(point)
          .map((at) => at.toFixed(6))
          .join(" ")}`,
      );
    const texture = attributes.TEXCOORD_0 === undefined ? [] : values(attributes.TEXCOORD_0);
    // OBJ counts v upwards.
    for (const [u, v] of texture) lines.push(`vt ${u.toFixed(6)} ${(1 - v).toFixed(6)}`);
    const corners = indices === undefined ? points.map((_, i) => i) : values(indices).flat();
    for (let i = 0; i + 2 < corners.length; i += 3) {
      const names = corners
        .slice(i, i + 3)
        .map((at) => (texture.length ? `${at + positions + 1}/${at + uvs + 1}` : `${at + positions + 1}`));
      lines.push(`f ${names.join(" ")}`);
    }
    positions += points.length;
    uvs += texture.length;
  };
  const walk = (index, parent) => {
    const {
      mesh,
      children = [],
      matrix,
      translation = [0, 0, 0],
      rotation = [0, 0, 0, 1],
      scale = [1, 1, 1],
    } = gltf.nodes[index];
    const own = matrix
      ? ([x, y, z]) => [0, 1, 2].map((i) => matrix[i] * x + matrix[4 + i] * y + matrix[8 + i] * z + matrix[12 + i])
      : (point) =>
          rotated(
            point.map((at, i) => at * scale[i]),
            rotation,
          ).map((at, i) => at + translation[i]);
    const place = (point) => parent(own(point));
    for (const primitive of gltf.meshes?.[mesh]?.primitives ?? []) add(primitive, place);
    children.forEach((child) => walk(child, place));
  };
  (gltf.scenes?.[gltf.scene ?? 0]?.nodes ?? []).forEach((node) => walk(node, (point) => point));
  if (!positions) throw new Error("This glTF has no triangles in its scene.");

  const source = gltf.images?.[gltf.textures?.[0]?.source];
  let image;
  if (source?.uri) image = new Blob([await resource(source.uri)]);
  if (source?.bufferView !== undefined) {
    const { buffer: at, byteOffset = 0, byteLength } = gltf.bufferViews[source.bufferView];
    image = new Blob([buffers[at].slice(byteOffset, byteOffset + byteLength)], { type: source.mimeType });
  }
  return { text: new TextEncoder().encode(lines.join("\n")), image };
}

/** A point turned by a quaternion. */
function rotated([x, y, z], [i, j, k, w]) {
  const [a, b, c] = [2 * (j * z - k * y), 2 * (k * x - i * z), 2 * (i * y - j * x)];
  return [x + w * a + j * c - k * b, y + w * b + k * a - i * c, z + w * c + i * b - j * a];
}
