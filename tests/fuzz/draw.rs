//! Checks a scene in every mode, or with one of the crate's shaders in the default mode.

use embedded_graphics::pixelcolor::Rgb565;
use fixel::mode::{Affine, Compact, Exact, Fast, Newton};
use fixel::prelude::*;
use fixel::view::ProjectionKind;

use super::call::Call;
use super::model::Truth;
use super::projection::Projected;
use super::scene::{Room, Scene, What};
use super::shaders::Bits;
use super::shades::{self, Draw, Shade, Shine};
use support::mode::Mode;
use support::recorder::{Few, Record};

/// Draws the scene that these bytes encode, if the constructors accept its numbers. Checks all invariants of the
/// pictures.
///
/// # Panics
///
/// Panics if an invariant does not hold.
pub fn check(bytes: &[u8]) {
    if let Ok(scene) = Scene::of(bytes) {
        let told = Told(&scene);
        // If a constructor refuses a number, there is nothing to draw.
        let _ = check_scene(told.0);
    }
}

/// A scene that is printed if a check panics.
struct Told<'a>(&'a Scene);

impl Drop for Told<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("{:#?}", self.0);
        }
    }
}

fn check_scene(scene: &Scene) -> Result<(), Error> {
    let mut rooms = [Room::EMPTY; 2];
    let mesh = &scene.mesh(&mut rooms)?;
    let (camera, model) = (scene.eye.camera()?, scene.model.transform());
    match scene.projection.projection(scene.size)? {
        Projected::Perspective(projection) => check_call(scene, mesh, projection * camera * model),
        Projected::Parallel(projection) => check_call(scene, mesh, projection * camera * model),
    }
}

fn check_call<K: ProjectionKind>(scene: &Scene, mesh: &Mesh, mvp: Mvp<K>) -> Result<(), Error> {
    let (options, window) = (scene.options()?, scene.window()?);
    let call = &Call {
        scene,
        mesh,
        mvp,
        window,
    };
    call.check_picking(&options);
    call.check_parts(&options);
    call.check_panels(&options);
    call.check_quantized(&options);
    call.check_mesh(&options);
    call.check_smoothed(&options);
    match call.scene.shade {
        Shade::Bits(0) => check_modes::<K, 0>(call, options),
        Shade::Bits(_) => check_modes::<K, 3>(call, options),
        Shade::Crate {
            which,
            light,
            color,
            between,
        } => {
            let lights = light.unwrap_or(Shine::DEFAULT).lights()?;
            shades::draw(which, lights, color, between, DefaultMode { call, options });
        }
    }
    Ok(())
}

/// Checks a shader in the default mode.
struct DefaultMode<'a, 'c, K> {
    call: &'a Call<'c, K>,
    options: DrawOptions,
}

impl<K: ProjectionKind> Draw for DefaultMode<'_, '_, K> {
    fn draw<F: ShaderFor<Rgb565>>(self, shader: &F) {
        // The check with the shader `Bits` covers the invariants of the pixels, which are the same for all shaders.
        // Here only frames are compared.
        self.call.check_frames(&self.options, shader);
    }
}

/// Checks every mode. All modes except `Compact` must draw the same pixels at the same depths.
fn check_modes<K: ProjectionKind, const N: usize>(call: &Call<'_, K>, options: DrawOptions)
where
    [(); N]: Few<N>,
{
    let tolerance = call.scene.tolerance;
    let truth = (call.scene.what == What::Triangles).then(|| Truth::new(call, &options));
    let mut first = None;
    let mut check = |mode, record: Record<N, Rgb565>| {
        if let Some(truth) = &truth {
            truth.check(mode, &record);
        }
        let Some(first) = &first else {
            first = Some(record);
            return;
        };
        let pixels = |record: &Record<N, Rgb565>| -> Vec<_> {
            let seen = record.seen.iter();
            seen.map(|seen| (seen.face, seen.pixel, seen.depth))
                .collect()
        };
        assert!(
            pixels(first) == pixels(&record),
            "{mode:?}: pixels or depths differ"
        );
    };
    let shader = &Bits::<N>;
    check(Mode::Exact, call.check(&options.with_mode(Exact), shader));
    check(
        Mode::Newton,
        call.check(&options.with_mode(Newton::default()), shader),
    );
    let fast = call.check(&options.with_mode(Fast::within(tolerance)), shader);
    check(Mode::Fast(tolerance.max(fx!(0))), fast);
    check(Mode::Affine, call.check(&options.with_mode(Affine), shader));
    // Depths of `Compact` can differ by a step from the depths of other modes. Then `Compact` can also draw other
    // pixels.
    let compact: Record<N, Rgb565> = call.check(&options.with_mode(Compact), shader);
    if let Some(truth) = &truth {
        truth.check(Mode::Compact, &compact);
    }
    // The storage and the blending of colors do not depend on the mode, so they are checked in one mode only.
    call.check_bytes(&options, shader);
    call.check_blended(&options, shader);
}
