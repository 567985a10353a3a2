//! A hint about a model that seems to lie on its side.

use fixel_assets::vector::{cross, length, sub};
use fixel_assets::{Format, Model, Triangle};

use crate::args::Args;

/// Returns a hint if the model seems to lie on its side: it has a flat base at the low end of another axis than the
/// chosen one, but none at the low end of the chosen axis.
pub fn lying(args: &Args, model: &Model) -> Option<String> {
    let format = args.model.as_deref().and_then(Format::of);
    // In glTF files, y always points up.
    if args.up.is_some() || format == Some(Format::Gltf) {
        return None;
    }
    let corners = |triangle: &Triangle| {
        triangle
            .corners
            .map(|corner| model.positions[corner.position as usize])
    };
    let [low, high] = model.bounds();
    let size = sub(high, low);
    // For the lower and the upper side of the model's bounding box: the fraction of the side that faces cover.
    let covered = |axis: usize| {
        let mut areas = [0.0; 2];
        for [a, b, c] in model.triangles.iter().map(corners) {
            let normal = cross(sub(b, a), sub(c, a));
            if normal[axis].abs() < 0.97 * length(normal) {
                continue;
            }
            // The normal of a base points out of the box.
            for (area, (end, sign)) in areas.iter_mut().zip([(low, -1.0), (high, 1.0)]) {
                let is_at_end = (a[axis] - end[axis]).abs() <= size[axis] * 0.03;
                if is_at_end && normal[axis] * sign > 0.0 {
                    *area += normal[axis].abs() / 2.0;
                }
            }
        }
        areas.map(|area| area / (size[(axis + 1) % 3] * size[(axis + 2) % 3]))
    };
    let (up, other) = if args.up()[2] > 0.0 { (2, 1) } else { (1, 2) };
    let [base, top] = covered(other);
    let name = ["x", "y", "z"][other];
    (base > 0.15 && top < base / 4.0 && covered(up)[0] < 0.05).then(|| {
        format!("the model may lie on its side: it has a flat base at its lowest {name}; see --up {name}")
    })
}
