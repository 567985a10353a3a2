//! Meshes in screen coordinates that cover an area without gaps or overlaps, wherever their vertices are.

/// A corner of a triangle or a vertex of a mesh, in 24.8 fixed point.
pub type Point = [i32; 2];

/// A mesh in screen coordinates.
#[derive(Clone, Debug)]
pub struct Flat {
    pub points: Vec<Point>,
    pub faces: Vec<[u16; 3]>,
}

impl Flat {
    /// The corners of each triangle.
    pub fn triangles(&self) -> Vec<[Point; 3]> {
        let corner = |index: u16| self.points[usize::from(index)];
        self.faces.iter().map(|face| face.map(corner)).collect()
    }

    /// Shuffles the triangles and the order of their corners. With `turn`, also reverses the winding of some triangles.
    pub fn shuffled(mut self, mut seed: u64, turn: bool) -> Self {
        let mut below = |n: usize| {
            // The linear congruential generator of Knuth's MMIX.
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as usize % n
        };
        for i in (1..self.faces.len()).rev() {
            self.faces.swap(i, below(i + 1));
        }
        for face in &mut self.faces {
            face.rotate_left(below(3));
            if turn && below(2) == 0 {
                face.swap(1, 2);
            }
        }
        self
    }
}

/// A triangulation of a rectangle with `points` among its vertices. Any number of points is accepted, at any positions:
/// each point splits the triangles that contain it.
///
/// The computation is exact, so triangles can be as thin as the format allows. All triangles face the viewer.
pub fn triangulation(corners: [Point; 4], points: &[Point]) -> Flat {
    let mut mesh = Flat {
        points: corners.to_vec(),
        // Top left, bottom left, bottom right, top right: counter-clockwise on the screen.
        faces: vec![[0, 1, 2], [0, 2, 3]],
    };
    for &point in points {
        if mesh.points.contains(&point) {
            continue;
        }
        let new = u16::try_from(mesh.points.len()).unwrap();
        mesh.points.push(point);
        let place = |index: u16| mesh.points[usize::from(index)];
        let mut faces = Vec::with_capacity(mesh.faces.len() + 3);
        for &[a, b, c] in &mesh.faces {
            let sides = [[a, b], [b, c], [c, a]];
            // The corners run counter-clockwise on a screen with y down, so the inside is negative.
            let inside = sides.map(|[from, to]| -turn([place(from), place(to), point]));
            if inside.iter().any(|&distance| distance < 0) {
                faces.push([a, b, c]);
                continue;
            }
            for ([from, to], distance) in sides.into_iter().zip(inside) {
                if distance > 0 {
                    faces.push([from, to, new]);
                }
            }
        }
        mesh.faces = faces;
    }
    mesh
}

/// A fan around `center`. The function sorts the points of the rim by their angles around `center`.
pub fn fan(center: Point, mut rim: Vec<Point>) -> Flat {
    let angle = |p: &Point| {
        let [x, y] = [0, 1].map(|i| f64::from(p[i] - center[i]));
        (-y).atan2(x)
    };
    rim.retain(|&p| p != center);
    // Keep only one point per direction, because two points would make overlapping triangles.
    rim.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    rim.dedup_by(|a, b| angle(a).total_cmp(&angle(b)).is_eq());
    let count = u16::try_from(rim.len()).unwrap();
    let points: Vec<Point> = std::iter::once(center).chain(rim).collect();
    let faces = (0..count)
        .map(|i| [0, i + 1, (i + 1) % count + 1])
        // The fan has no triangle where two neighbors are half a turn or more apart.
        .filter(|face| turn(face.map(|index| points[usize::from(index)])) < 0)
        .collect();
    Flat { points, faces }
}

/// A grid of `columns` x `rows` cells over `area` pixels. `moves` shifts its inner vertices by less than half a cell.
pub fn grid(columns: u16, rows: u16, area: [i32; 2], moves: &[Point], strip: bool) -> Flat {
    let cell = [
        area[0] * 256 / i32::from(columns),
        area[1] * 256 / i32::from(rows),
    ];
    let mut points = Vec::new();
    for j in 0..=rows {
        for i in 0..=columns {
            let inner = i > 0 && i < columns && j > 0 && j < rows;
            let by = moves[points.len() % moves.len()];
            points.push([0, 1].map(|axis| {
                let at = i32::from([i, j][axis]) * cell[axis];
                let reach = cell[axis] / 2;
                if inner {
                    at + by[axis].rem_euclid(reach) - reach / 2
                } else {
                    at
                }
            }));
        }
    }
    let mut faces = Vec::new();
    for j in 0..rows {
        for i in 0..columns {
            let at = j * (columns + 1) + i;
            let below = at + columns + 1;
            // In a strip, all diagonals have the same direction; in a grid, the directions alternate.
            if strip || (i + j) % 2 == 0 {
                faces.extend([[at, below, at + 1], [at + 1, below, below + 1]]);
            } else {
                faces.extend([[at, below, below + 1], [at, below + 1, at + 1]]);
            }
        }
    }
    Flat { points, faces }
}

/// (b − a) × (p − a), exact. Positive for corners that run clockwise on a screen with y down.
fn turn([a, b, p]: [Point; 3]) -> i128 {
    let side = |to: Point| [0, 1].map(|i| i128::from(to[i]) - i128::from(a[i]));
    let ([bx, by], [px, py]) = (side(b), side(p));
    bx * py - by * px
}
