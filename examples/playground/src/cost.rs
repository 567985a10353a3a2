//! What a picture costs on a microcontroller, from the counts in tests/instructions.csv.

use super::scene::Scene;

/// Counts of instructions, one in a line: core, mode, thing drawn, unit, number.
static COUNTS: &str = include_str!(concat!(env!("OUT_DIR"), "/costs.csv"));

/// The modes in the module's order.
pub const MODES: [&str; 5] = ["exact", "newton", "fast", "affine", "compact"];
/// The cores that are estimated for.
pub const CORES: [&str; 2] = ["thumbv6m-none-eabi", "thumbv7em-none-eabi"];

/// A count; `None` where nothing was counted.
fn count(core: &str, mode: &str, what: &str, per: &str) -> Option<f64> {
    COUNTS.lines().find_map(|line| {
        let mut fields = line.split(',');
        let is = [core, mode, what, per]
            .into_iter()
            .all(|key| fields.next() == Some(key));
        is.then(|| fields.next()?.parse().ok()).flatten()
    })
}

/// The work of a picture, to compare pictures: its pixels and its triangles, each with the count of its loop alone.
/// `counts` are triangles in, drawn and clipped, and pixels.
fn work(core: &str, kernel: &str, counts: [u32; 4]) -> Option<f64> {
    let [submitted, drawn, _, pixels] = counts.map(f64::from);
    let pixel = |kernel| count(core, "kernel", kernel, "1000 pixels");
    let each = match kernel {
        "flat" => pixel("flat")?,
        _ => pixel(kernel)? + pixel("newton-depth-pass")? - pixel("newton")?,
    };
    let triangle = count(core, "kernel", "setup-no-pixel", "1000 triangles")?;
    // A triangle that is turned away takes about a tenth.
    Some((pixels * each + (drawn + (submitted - drawn) / 10.0) * triangle) / 1000.0)
}

/// Instructions for a picture: the count of the scene as it was measured, times the work now over the work then. A
/// model of the user's own is estimated as if it were the lighthouse.
pub fn instructions(
    core: &str,
    mode: usize,
    scene: Scene,
    now: [u32; 4],
    then: [u32; 4],
) -> Option<f64> {
    let name = MODES[mode];
    let what = match scene {
        Scene::Floor => "floor",
        Scene::Cube => "cube",
        Scene::Sphere => "sphere",
        Scene::SphereFlat => "sphere-flat",
        Scene::Lighthouse | Scene::Own => "default",
        Scene::World => return None,
    };
    let measured = if name == "compact" {
        let mean = |mode| count(core, mode, what, "mean-of-poses");
        count(core, "newton", what, "frame")? * mean("compact")? / mean("newton")?
    } else {
        count(core, name, what, "frame")?
    };
    let kernel = match (scene, name) {
        (Scene::SphereFlat, _) => "flat",
        (_, "fast") => "fast-16",
        (_, "compact") => "exact",
        _ => name,
    };
    let estimate = measured * work(core, kernel, now)? / work(core, kernel, then)?;
    estimate.is_finite().then_some(estimate)
}
