//! A closed surface with bumps that hide one another, with as many triangles as a small model.

use std::f64::consts::{PI, TAU};

use support::reference::scenes::Shape;

/// The surface has 5,984 triangles in 68 columns and 45 rows. Texture coordinates run from 0 to 1 around the surface,
/// and from its top to its bottom.
pub fn bumpy() -> Shape {
    const COLUMNS: usize = 68;
    const ROWS: usize = 45;
    let uv = |[row, column]: [usize; 2]| [column as f64 / COLUMNS as f64, row as f64 / ROWS as f64];
    let mut shape = Shape::default();
    for row in 0..=ROWS {
        for column in 0..=COLUMNS {
            let [u, v] = uv([row, column % COLUMNS]);
            let ((sin, cos), (sin_u, cos_u)) = ((v * PI).sin_cos(), (u * TAU).sin_cos());
            // The bumps fade toward the poles, where all columns meet.
            let bumps = 0.28 * sin * (5. * u * TAU + 2. * v).sin() * (7. * v).cos();
            let radius = 0.8 + bumps + 0.1 * cos;
            let point = [sin * cos_u, cos * 1.2, -sin * sin_u].map(|x| radius * x);
            shape.positions.push(point);
        }
    }
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let quad = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[r, c]| [row + r, column + c]);
            // At a pole, one side of the quad is a point, so one of the quad's triangles has no area and is left out.
            let triangles = [(row + 1 < ROWS, [0, 1, 2]), (row > 0, [0, 2, 3])];
            for (_, corners) in triangles.into_iter().filter(|(there, _)| *there) {
                let corners = corners.map(|i| quad[i]);
                shape
                    .faces
                    .push(corners.map(|[r, c]| r * (COLUMNS + 1) + c));
                shape.uvs.push(corners.map(uv));
            }
        }
    }
    shape
}
