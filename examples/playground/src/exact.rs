//! The exact texel under each pixel, in double precision: from the mathematics of projection, not from the crate.
//!
//! A corner goes to eye space, is clipped where it has no place on the screen, and is divided by its distance. From
//! there on, 1/w, u/w and v/w are linear on the screen.
//!
//! The crate rounds a corner's place to 1/256 of a pixel, in every mode. In a far plane that is seen from the side,
//! this is worth more than the error of a mode, which is to be measured: so the place is the crate's. Corners that
//! clipping made are rounded here.

use heapless::Vec;

use super::view::View;

/// A corner in eye space: x, y, z, u, v.
type Corner = [f64; 5];
/// A triangle and six planes make a polygon of at most nine corners, and so at most seven pieces.
type Polygon = Vec<Corner, 9>;
pub type Pieces = Vec<Piece, 7>;

/// An angle's sine and cosine.
type Turn = (f64, f64);

/// A view in double precision.
pub struct Eye {
    yaw: Turn,
    pitch: Turn,
    shift: [Turn; 2],
    center: [f64; 3],
    scale: f64,
    distance: f64,
    size: [f64; 2],
    /// The focal length in pixels.
    focal: f64,
    near: f64,
    far: f64,
}

/// A triangle on the screen: of each corner the place in pixels, and 1/w, u/w and v/w.
pub struct Piece {
    corners: [[f64; 5]; 3],
    /// Twice.
    area: f64,
}

/// Turns from the first axis away to the second.
fn turned((sin, cos): Turn, a: f64, b: f64) -> [f64; 2] {
    [cos * a + sin * b, cos * b - sin * a]
}

/// The part of a polygon where a function of its corners is not negative.
fn clipped(polygon: &Polygon, inside: impl Fn(&Corner) -> f64) -> Polygon {
    let mut kept = Polygon::new();
    let befores = polygon.iter().cycle().skip(polygon.len().saturating_sub(1));
    for (from, to) in befores.zip(polygon) {
        let (a, b) = (inside(from), inside(to));
        // There is room: a plane cuts off at least one corner where it adds two.
        if (a < 0.0) != (b < 0.0) {
            let at = |i: usize| from[i] + a / (a - b) * (to[i] - from[i]);
            let _ = kept.push([at(0), at(1), at(2), at(3), at(4)]);
        }
        if b >= 0.0 {
            let _ = kept.push(*to);
        }
    }
    kept
}

impl Eye {
    pub fn new(view: &View) -> Self {
        let radians = |angle: fixel::Angle| {
            f64::from(angle.to_bits().cast_signed()) / 4_294_967_296.0 * core::f64::consts::TAU
        };
        let turn = |angle| libm::sincos(radians(angle));
        let size = [view.size.width, view.size.height].map(f64::from);
        let length = |length: fixel::Scalar| f64::from(length);
        Self {
            yaw: turn(view.yaw),
            pitch: turn(view.pitch),
            shift: view.shift.map(turn),
            center: [view.center.x, view.center.y, view.center.z].map(length),
            scale: length(view.scale),
            distance: length(view.distance),
            size,
            focal: size[1] / 2.0 / libm::tan(radians(view.fov) / 2.0),
            near: length(view.near),
            far: length(view.far),
        }
    }

    /// A corner of a recorded triangle in eye space.
    fn corner(&self, recorded: &[i32]) -> Corner {
        let at =
            |axis: usize| f64::from(recorded[axis]) / 65_536.0 * self.scale - self.center[axis];
        let [x, z] = turned(self.yaw, at(0), at(2));
        let [z, y] = turned(self.pitch, z, at(1));
        let [x, z] = turned(self.shift[0], x, z - self.distance);
        let [z, y] = turned(self.shift[1], z, y);
        let uv = |at: usize| f64::from(recorded[at]) / 1_048_576.0;
        [x, y, z, uv(3), uv(4)]
    }

    /// The triangles on the screen that a recorded triangle becomes, whose own corners the crate puts at `places`.
    #[allow(clippy::float_cmp)] // a corner that clipping left as it was has the same bits
    pub fn pieces(&self, recorded: &[i32; 17], places: [Option<[f64; 2]>; 3]) -> Pieces {
        let own = [2, 7, 12].map(|at| self.corner(&recorded[at..at + 5]));
        let mut polygon: Polygon = own.into_iter().collect();
        polygon = clipped(&polygon, |at| -at[2] - self.near);
        polygon = clipped(&polygon, |at| at[2] + self.far);
        // Within the guard band, 2048 pixels around the center, coordinates have enough bits.
        for axis in [0, 1] {
            for side in [1.0, -1.0] {
                polygon = clipped(&polygon, |at| {
                    -2048.0 * at[2] + side * self.focal * at[axis]
                });
            }
        }
        let [width, height] = self.size;
        for corner in &mut polygon {
            let [x, y, z, u, v] = *corner;
            let place = own.iter().zip(places).find(|(own, _)| *own == corner);
            let rounded = |at: f64| libm::round(at * 256.0) / 256.0;
            let [x, y] = place.and_then(|(_, place)| place).unwrap_or_else(|| {
                [
                    width / 2.0 - self.focal * x / z,
                    height / 2.0 + self.focal * y / z,
                ]
                .map(rounded)
            });
            *corner = [x, y, -1.0 / z, -u / z, -v / z];
        }
        let fan = polygon.windows(2).skip(1);
        fan.filter_map(|last| Piece::new([polygon[0], last[0], last[1]]))
            .collect()
    }
}

impl Piece {
    /// `None` without area.
    fn new(corners: [[f64; 5]; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        (area != 0.0).then_some(Self { corners, area })
    }

    /// u and v at a point of its plane, and whether the point is inside.
    pub fn at(&self, x: f64, y: f64) -> ([f64; 2], bool) {
        let [a, b, c] = &self.corners;
        let wb = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / self.area;
        let wc = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / self.area;
        let wa = 1.0 - wb - wc;
        let sum = |i: usize| wa * a[i] + wb * b[i] + wc * c[i];
        (
            [sum(3) / sum(2), sum(4) / sum(2)],
            wa.min(wb).min(wc) >= -1e-9,
        )
    }
}

/// u and v at a pixel's center: where rounding took a border elsewhere, the first piece goes on in its plane.
pub fn at(pieces: &Pieces, x: f64, y: f64) -> Option<[f64; 2]> {
    let mut found = pieces.iter().map(|piece| piece.at(x, y));
    let first = found.next()?;
    let inside = core::iter::once(first)
        .chain(found)
        .find(|(_, is_inside)| *is_inside);
    Some(inside.unwrap_or(first).0)
}

/// Violet, red, orange, pale yellow: from 1/1024 texel to 32 texels, by powers of two. style.css has them, too.
const HEAT: [[f64; 3]; 6] = [
    [22.0, 18.0, 48.0],
    [76.0, 32.0, 108.0],
    [158.0, 42.0, 99.0],
    [223.0, 82.0, 58.0],
    [249.0, 157.0, 45.0],
    [252.0, 232.0, 150.0],
];

/// The color of an error in texels, in bytes of red, green, blue and opacity.
#[allow(clippy::cast_sign_loss, clippy::cast_precision_loss)] // of a color's range
pub fn heat(error: f64) -> u32 {
    let at = ((libm::log2(error) + 10.0) / 3.0).clamp(0.0, 5.0);
    let stop = (at as usize).min(HEAT.len() - 2);
    let (from, to) = (HEAT[stop], HEAT[stop + 1]);
    let [r, g, b] =
        [0, 1, 2].map(|i| (from[i] + (at - stop as f64) * (to[i] - from[i]) + 0.5) as u8);
    u32::from_le_bytes([r, g, b, 255])
}
