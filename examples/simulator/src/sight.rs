//! Before the picture of a scene is drawn, finds whether something will be visible, and how much.

use embedded_graphics::pixelcolor::Rgb888;
use fixel::Cull;

use super::Result;
use crate::args::{Args, Shade};
use crate::bands::bands;
use crate::draw::{Lines, Style};
use crate::dump::Record;
use crate::scene::{Band, Moment, Scene};

/// The largest side of the small pictures that are drawn only to count pixels.
const SMALL: u32 = 256;
/// Checks that something is visible. Adds hints for the user to `notes`, and chooses the lines to be drawn. If
/// one-sided materials hide everything, both sides will be drawn.
///
/// # Errors
///
/// Nothing is visible in any frame. The message says why, and what to do.
pub fn check(scene: &mut Scene<'_>, args: &Args, notes: &mut Vec<String>) -> Result<Lines> {
    let is_wire = scene.shade == Some(Shade::Wire);
    let size = args.size;
    let any = |scene: &Scene<'_>, cull, edges| -> Result<bool> {
        for frame in 0..args.frames {
            if look(scene, size, frame, cull, edges)?
                .iter()
                .any(Record::is_covered)
            {
                return Ok(true);
            }
        }
        Ok(false)
    };
    if !any(scene, None, is_wire)? {
        let why = if !any(scene, Some(Cull::Nothing), is_wire)? {
            if any(scene, None, true)? {
                "the faces in view cover no pixel: try --shade wire"
            } else {
                "the model is outside the picture or smaller than a pixel"
            }
        } else if args.cull {
            "all faces in view point away, and --cull hides their backs"
        } else {
            notes.push(
                "all faces in view point away, and their materials are one-sided: both sides are drawn"
                    .into(),
            );
            for piece in &mut scene.pieces {
                piece.finish.cull = Cull::Nothing;
            }
            ""
        };
        if !why.is_empty() {
            return Err(format!("nothing is visible: {why}").into());
        }
    }
    let mut lines = Lines::None;
    if args.wire || is_wire {
        lines = Lines::Edges;
        let count = |edges| -> Result<usize> {
            let records = look(scene, size, 0, None, edges)?;
            Ok(records.iter().filter(|record| record.is_covered()).count())
        };
        let (edges, faces) = (count(true)?, count(false)?);
        if 2 * edges > faces && edges > 256 {
            lines = Lines::Outline;
            notes.push(
                "the edges would fill most of the model: only outlines and creases are drawn"
                    .into(),
            );
        }
    }
    if is_wire {
        return Ok(lines);
    }
    let size = small(size);
    let front = look(scene, size, 0, None, false)?;
    let is_foggy = matches!(
        scene.shade,
        Some(Shade::Texture | Shade::Lit | Shade::Gouraud | Shade::Flat)
    );
    let is_beyond = |far: f64| {
        let mut seen = front.iter().filter(|record| record.is_covered());
        seen.all(|record| record.distance() >= far)
    };
    if is_foggy && args.fog.is_some_and(|fog| is_beyond(fog.far)) {
        notes.push("all faces in view are behind the fog: see --fog".into());
    }
    let [shown, other] = [Cull::Nothing, Cull::Back];
    let both = look(scene, size, 0, Some(shown), false)?;
    let front = look(scene, size, 0, Some(other), false)?;
    let seen = both.iter().filter(|record| record.is_covered()).count();
    let away = both
        .iter()
        .zip(&front)
        .filter(|(both, front)| both.hides(front))
        .count();
    let percent = away * 100 / seen.max(1);
    if percent > 0 {
        notes.push(if args.cull {
                format!("--cull hides backs of faces in {percent} % of the model's picture")
            } else {
                format!(
                    "a program that culls back faces would lose {percent} % of the model's picture: see --cull"
                )
            });
    }
    Ok(lines)
}

/// Returns the colors of the model in the first frame. The frame is drawn small.
///
/// # Errors
///
/// The library refuses the camera.
pub fn colors(scene: &Scene<'_>, size: (u32, u32), style: &Style<'_>) -> Result<Vec<Rgb888>> {
    let size = small(size);
    let (colors, _) = bands(size, u32::MAX, |band| {
        scene.draw(band, Moment::default(), style)
    })?;
    let records = look(scene, size, 0, None, false)?;
    let covered = colors
        .into_iter()
        .zip(&records)
        .filter(|(_, record)| record.is_covered());
    Ok(covered.map(|(color, _)| color).collect())
}

/// Returns the size of a picture that has the same shape, and sides of at most [`SMALL`] pixels.
fn small((width, height): (u32, u32)) -> (u32, u32) {
    let largest = width.max(height).max(SMALL);
    let side = |side: u32| (side * SMALL / largest).max(1);
    (side(width), side(height))
}

/// Records the faces or the edges of a whole frame.
fn look(
    scene: &Scene<'_>,
    size: (u32, u32),
    at: u32,
    cull: Option<Cull>,
    edges: bool,
) -> Result<Vec<Record>> {
    let draw = |band: Band<'_, Record>| scene.record(band, Moment::of(at), edges, cull);
    Ok(bands(size, u32::MAX, draw)?.0)
}
