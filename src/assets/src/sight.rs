//! Refuses models of which nothing can be seen.

use crate::Model;
use crate::vector::{Vector, cross, largest, length, sub};

/// Faces this many times farther from the middle than the others make the others too small to see.
const FAR: f64 = 1000.0;

/// A face without area has less than this part of the square of its longest side. It is far above the rounding of f64.
const FLAT: f64 = 1e-12;

impl Model {
    /// Finds faces so far away that the others cannot be seen beside them: a sentence about them, if there are any.
    ///
    /// # Errors
    ///
    /// All faces are in one point, or have no area.
    pub(crate) fn check_sight(&self) -> Result<Option<String>, String> {
        let [low, high] = self.bounds();
        let size = largest(sub(high, low));
        if size == 0.0 {
            let [x, y, z] = low;
            return Err(format!(
                "there is nothing to see: all points of its faces are at {x},{y},{z}"
            ));
        }
        let triangles = || {
            self.triangles
                .iter()
                .map(|it| it.corners.map(|at| self.positions[at.position as usize]))
        };
        let is_flat = |[a, b, c]: [Vector; 3]| {
            let sides = [sub(b, a), sub(c, a)].map(|side| side.map(|x| x / size));
            let longest = length(sides[0]).max(length(sides[1]));
            length(cross(sides[0], sides[1])) <= FLAT * longest * longest
        };
        if triangles().all(is_flat) {
            return Err("there is nothing to see: the corners of each face are on a line".into());
        }
        // Most faces are around the median, however far away the others are.
        let median = [0, 1, 2].map(|axis| {
            let mut all: Vec<f64> = triangles().map(|[a, ..]| a[axis]).collect();
            let middle = all.len() / 2;
            *all.select_nth_unstable_by(middle, f64::total_cmp).1
        });
        let reach = |at: &Vector| length(sub(*at, median));
        let farthest = |corners: [Vector; 3]| {
            let corners = corners.into_iter();
            let farthest = corners.max_by(|a, b| reach(a).total_cmp(&reach(b)));
            farthest.unwrap_or(median)
        };
        let far: Vec<f64> = triangles().map(|it| reach(&farthest(it))).collect();
        let few = (far.len() / 10).max(((far.len() - 1) / 2).min(2));
        let mut sorted = far.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        let near = sorted[far.len() - 1 - few];
        let is_far = |&&far: &&f64| near > 0.0 && far > FAR * near;
        let count = far.iter().filter(is_far).count();
        Ok(far.iter().position(|far| is_far(&far)).map(|first| {
            let [x, y, z] = triangles().nth(first).map_or(median, farthest);
            let name = self.triangles[first].object;
            let of = |at| format!(" of '{}'", self.objects[at as usize]);
            let name = name.map_or(String::new(), of);
            format!(
                "{count} of {} triangles are over {FAR} times farther from the middle than the others, which are therefore too small to see: the first{name} is at {x},{y},{z}; to leave them out, delete them from the file",
                far.len(),
            )
        }))
    }
}
