//! Measures the light at a vertex.

use core::hint::black_box;

use fixel::math::Direction;
use fixel::prelude::*;
use fixel::shade::{Channels as _, SurfacePoint};

use super::ticks::Stopwatch;

const VERTICES: u32 = 64;

/// Measures each type of light at a vertex that it reaches, and prints the cost. The transform of the vertex to world
/// space is not included.
pub fn measure(watch: &mut Stopwatch) -> Result<(), Error> {
    let sun = Light::new(vec3!(1, 2, 3), fx!(0.2), fx!(0.8))?;
    let lamp = PointLight::new(vec3!(1, 2, 3), fx!(0.8), fx!(10))?;
    let cone = (deg!(20), deg!(80));
    let spot = SpotLight::new(vec3!(1, 2, 3), vec3!(0, -1, -1), cone, fx!(0.8), fx!(10))?;
    let viewer = Viewer::at(vec3!(0, 1, 5));
    one(watch, "light-sun", sun)?;
    one(watch, "light-point", lamp)?;
    one(watch, "light-spot", spot)?;
    one(watch, "light-sun-shiny", sun.shiny(viewer, 20, fx!(0.5))?)?;
    one(watch, "light-two-sided", sun.two_sided(viewer))
}

fn one<L: Lighting>(watch: &mut Stopwatch, name: &str, light: L) -> Result<(), Error> {
    let up = Direction::of(vec3!(0.25, 1, 0.5));
    let point = SurfacePoint {
        normal: up,
        face: up,
        position: vec3!(0.5, 0.25, 0),
    };
    let ticks = watch.time(|| {
        for _ in 0..VERTICES {
            let found = black_box(&light).at(black_box(&point));
            assert!(found.diffuse.rgb()[0] > 0, "the light reaches the vertex");
            // Without this check, the compiler would not compute a highlight.
            assert!(
                found.specular.rgb()[0] != i32::MAX,
                "a highlight is white at most"
            );
        }
        Ok::<_, Error>(())
    })?;
    watch.print(name, "vertex", VERTICES, ticks);
    Ok(())
}
