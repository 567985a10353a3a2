//! Corrects the normals of models with triangles that are wound the wrong way.

use std::collections::HashMap;

use crate::vector::{cross, dot, sub};
use crate::{Corner, Model};

impl Model {
    /// If all three normals of a triangle point to its back, reverses these normals. Seen from a triangle's front, its
    /// corners run counter-clockwise.
    ///
    /// Two-sided light finds a face's front from its corners. Without this correction, two-sided light would light the
    /// triangle from the wrong side.
    pub fn turn_normals(&mut self) {
        let Self {
            positions,
            normals,
            triangles,
            ..
        } = self;
        let mut turned = HashMap::new();
        for triangle in triangles {
            let corners = &mut triangle.corners;
            let [a, b, c] = corners.map(|corner| positions[corner.position as usize]);
            let front = cross(sub(b, a), sub(c, a));
            let is_behind = |corner: &Corner| {
                corner
                    .normal
                    .is_some_and(|at| dot(normals[at as usize], front) < 0.0)
            };
            if !corners.iter().all(is_behind) {
                continue;
            }
            for normal in corners
                .iter_mut()
                .filter_map(|corner| corner.normal.as_mut())
            {
                *normal = *turned.entry(*normal).or_insert_with(|| {
                    normals.push(normals[*normal as usize].map(|x| -x));
                    u32::try_from(normals.len() - 1).unwrap_or(*normal)
                });
            }
        }
    }
}
