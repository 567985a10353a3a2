// The exact texel under each pixel, in double precision: from the mathematics of projection, not from the crate.
//
// A corner goes to eye space, is clipped where it has no place on the screen, is divided by its distance, and is
// rounded to 1/256 of a pixel, as the crate promises. From there on, 1/w, u/w and v/w are linear on the screen.

const angle = (bits) => ((bits | 0) / 2 ** 32) * 2 * Math.PI;

/** The function from a point of the model to eye space. */
function toEye(view) {
  const aboutX = (bits) => {
    const [sin, cos] = [Math.sin(angle(bits)), Math.cos(angle(bits))];
    return ([x, y, z]) => [x, cos * y - sin * z, sin * y + cos * z];
  };
  const aboutY = (bits) => {
    const [sin, cos] = [Math.sin(angle(bits)), Math.cos(angle(bits))];
    return ([x, y, z]) => [cos * x + sin * z, y, cos * z - sin * x];
  };
  const center = [view.center_x, view.center_y, view.center_z];
  const steps = [
    (point) => point.map((at, axis) => ((at * view.scale) / 65536 - center[axis]) / 65536),
    aboutY(view.yaw),
    aboutX(view.pitch),
    ([x, y, z]) => [x, y, z - view.distance / 65536],
    aboutY(view.shift_x),
    aboutX(view.shift_y),
  ];
  return (point) => steps.reduce((at, step) => step(at), point);
}

/** The part of a polygon where a function of its corners is not negative. */
function clipped(polygon, inside) {
  return polygon.flatMap((to, at) => {
    const from = polygon.at(at - 1);
    const [a, b] = [inside(from), inside(to)];
    const cut = a < 0 !== b < 0 ? [from.map((value, i) => value + (a / (a - b)) * (to[i] - value))] : [];
    return b < 0 ? cut : [...cut, to];
  });
}

/** A triangle on the screen, as a function from a pixel's center to u and v; null outside it. */
function piece(corners) {
  const [[ax, ay], [bx, by], [cx, cy]] = corners;
  const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  if (!area) return null;
  return (x, y, anywhere) => {
    const b = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area;
    const c = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area;
    const a = 1 - b - c;
    if (!anywhere && Math.min(a, b, c) < -1e-9) return null;
    const [q, p, r] = [2, 3, 4].map((i) => a * corners[0][i] + b * corners[1][i] + c * corners[2][i]);
    return [p / q, r / q];
  };
}

/** The triangles on the screen that a triangle of the model becomes. */
function pieces(view, eye, triangle) {
  const { width, height } = view;
  const focal = height / 2 / Math.tan(angle(view.fov) / 2);
  const [near, far] = [view.near / 65536, view.far / 65536];
  const corner = (i) => {
    const [x, y, z, u, v] = triangle.subarray(2 + 5 * i, 7 + 5 * i);
    return [...eye([x, y, z]), u / 2 ** 20, v / 2 ** 20];
  };
  // Within the guard band, 2048 pixels around the center, coordinates have enough bits.
  const planes = [
    ([, , z]) => -z - near,
    ([, , z]) => far + z,
    ([x, , z]) => -2048 * z - focal * x,
    ([x, , z]) => -2048 * z + focal * x,
    ([, y, z]) => -2048 * z - focal * y,
    ([, y, z]) => -2048 * z + focal * y,
  ];
  const polygon = planes.reduce(clipped, [corner(0), corner(1), corner(2)]);
  const snap = (at) => Math.round(at * 256) / 256;
  const placed = polygon.map(([x, y, z, u, v]) => [
    snap(width / 2 - (focal * x) / z),
    snap(height / 2 + (focal * y) / z),
    -1 / z,
    -u / z,
    -v / z,
  ]);
  const fan = placed.slice(2).map((last, at) => piece([placed[0], placed[at + 1], last]));
  return fan.filter(Boolean);
}

/**
 * The error of each pixel of a recording, in texels (the larger of column and row; −1 where nothing was drawn); and the
 * largest and the mean.
 */
export function errors(view, { pixels, triangle }) {
  const eye = toEye(view);
  const known = new Map();
  const found = new Float32Array(pixels.length / 3).fill(-1);
  let [max, sum, count] = [0, 0, 0];
  for (let at = 0; at < found.length; at++) {
    const index = pixels[3 * at] - 1;
    if (index < 0) continue;
    if (!known.has(index)) {
      const corners = triangle(index);
      known.set(index, { size: [corners[0], corners[1]], parts: pieces(view, eye, corners) });
    }
    const { size, parts } = known.get(index);
    if (!parts.length) continue;
    const [x, y] = [(at % view.width) + 0.5, Math.floor(at / view.width) + 0.5];
    let uv = null;
    for (const part of parts) uv ??= part(x, y, false);
    // Where rounding took a border elsewhere, the nearest part goes on in a plane.
    uv ??= parts[0](x, y, true);
    const off = [0, 1].map((axis) => Math.abs(pixels[3 * at + 1 + axis] / 65536 - uv[axis] * size[axis]));
    found[at] = Math.max(...off);
    max = Math.max(max, found[at]);
    sum += found[at];
    count++;
  }
  return { errors: found, max, mean: count ? sum / count : 0, count };
}

// From a thousandth of a texel to 32 texels, by powers of two: violet, red, orange, pale yellow.
const STOPS = [
  [22, 18, 48],
  [76, 32, 108],
  [158, 42, 99],
  [223, 82, 58],
  [249, 157, 45],
  [252, 232, 150],
];

/** The color of an error, as a share of the way from 1/1024 texel to 32 texels. */
export function heat(share) {
  const at = Math.min(Math.max(share, 0), 1) * (STOPS.length - 1);
  const stop = Math.min(Math.floor(at), STOPS.length - 2);
  return STOPS[stop].map((from, channel) => from + (at - stop) * (STOPS[stop + 1][channel] - from));
}

export const share = (error) => (Math.log2(error) + 10) / 15;

/** A picture of errors. */
export function heatMap({ errors: found }, width, height) {
  const image = new ImageData(width, height);
  const colors = Array.from({ length: 256 }, (_, at) => heat(at / 255));
  for (let at = 0; at < found.length; at++) {
    const error = found[at];
    const step = Math.min(Math.max(Math.round(share(error) * 255), 0), 255);
    image.data.set(error < 0 ? [58, 62, 68, 255] : [...colors[step], 255], 4 * at);
  }
  return image;
}
