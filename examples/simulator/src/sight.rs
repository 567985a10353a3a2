//! Before the picture of a scene is drawn, finds whether something will be visible, and how much.

use embedded_graphics::pixelcolor::Rgb888;
use fixel::{Cull, Drawn};

use super::Result;
use super::common::layers;
use crate::args::{Args, Shade};
use crate::draw::{Lines, Style};
use crate::dump::Record;
use crate::scene::{Moment, Scene};

/// The largest side of the small pictures that are drawn only to count colors.
const SMALL: u32 = 256;
/// The most frames in which the layers of faces are counted, and the most layers. Models that people draw have a few. With
/// 200 layers, a picture of 320x240 pixels takes about a fifth of a second.
const VIEWS: u32 = 4;
const MOST_LAYERS: u64 = 200;

/// What the first frame shows, and the lines to be drawn.
pub struct Sight {
    pub records: Vec<Record>,
    pub counts: Drawn,
    pub lines: Lines,
}

/// The number of pixels at which a face or an edge is drawn.
pub fn covered(records: &[Record]) -> usize {
    records.iter().filter(|record| record.is_covered()).count()
}

/// Checks that something is visible. Adds hints for the user to `notes`, and chooses the lines to be drawn. If
/// one-sided materials hide everything, both sides will be drawn.
///
/// # Errors
///
/// Nothing is visible in any frame. The message says why, and what to do.
pub fn check(scene: &mut Scene<'_>, args: &Args, notes: &mut Vec<String>) -> Result<Sight> {
    let is_wire = scene.shade == Some(Shade::Wire);
    let views = (0..args.frames).step_by(args.frames.div_ceil(VIEWS) as usize);
    for frame in views {
        let mvp = scene.motion.mvp(Moment::of(frame))?;
        let layers = mvp.layers(&scene.pieces, args.size)?;
        layers::check(layers, MOST_LAYERS, ", or move away with --eye")?;
    }
    let look = |scene: &Scene<'_>, frame, cull, edges| {
        scene.record(args.size, u32::MAX, Moment::of(frame), edges, cull)
    };
    let any = |scene: &Scene<'_>, frames, cull, edges| -> Result<bool> {
        for frame in frames {
            if covered(&look(scene, frame, cull, edges)?.0) > 0 {
                return Ok(true);
            }
        }
        Ok(false)
    };
    let mut first = look(scene, 0, None, is_wire)?;
    if covered(&first.0) == 0 && !any(scene, 1..args.frames, None, is_wire)? {
        let frames = 0..args.frames;
        let why = if !any(scene, frames.clone(), Some(Cull::Nothing), is_wire)? {
            if any(scene, frames, None, true)? {
                "the faces in view cover no pixel: try --shade wire, a smaller --fov or a larger --size"
            } else {
                "the model is outside the picture or smaller than a pixel: see --eye, --look-at, --fov, --near and --far"
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
            first = look(scene, 0, None, is_wire)?;
            ""
        };
        if !why.is_empty() {
            return Err(format!("nothing is visible: {why}").into());
        }
    }
    let (records, counts) = first;
    let mut lines = Lines::None;
    if args.wire || is_wire {
        lines = Lines::Edges;
        let others = covered(&look(scene, 0, None, !is_wire)?.0);
        let (edges, faces) = if is_wire {
            (covered(&records), others)
        } else {
            (others, covered(&records))
        };
        if 2 * edges > faces && edges > 256 {
            lines = Lines::Outline;
            notes.push(
                "the edges would fill most of the model: only outlines and creases are drawn"
                    .into(),
            );
        }
    }
    if !is_wire {
        let is_foggy = matches!(
            scene.shade,
            Some(Shade::Texture | Shade::Lit | Shade::Gouraud | Shade::Flat)
        );
        let is_beyond = |far: f64| {
            let mut seen = records.iter().filter(|record| record.is_covered());
            seen.all(|record| record.distance() >= far)
        };
        if is_foggy && args.fog.is_some_and(|fog| is_beyond(fog.far)) {
            notes.push("all faces in view are behind the fog: see --fog".into());
        }
        let percent = if scene.is_own {
            0
        } else {
            turned_away(scene, &records, |cull| {
                Ok(look(scene, 0, Some(cull), false)?.0)
            })?
        };
        if args.cull {
            notes.push(match percent {
                0 => "--cull hides less than 1 % of the model's picture: leave it out, or move with --eye".into(),
                _ => format!("--cull hides backs of faces in {percent} % of the model's picture"),
            });
        } else if percent > 0 {
            notes.push(format!(
                "a program that culls back faces would lose {percent} % of the model's picture: see --cull"
            ));
        }
    }
    Ok(Sight {
        records,
        counts,
        lines,
    })
}

/// Returns the percentage of the model's picture that shows only backs of faces. `shown` is the picture as the
/// materials show it. `look` makes another picture, but only if the result needs it.
fn turned_away(
    scene: &Scene<'_>,
    shown: &[Record],
    look: impl Fn(Cull) -> Result<Vec<Record>>,
) -> Result<usize> {
    let picture = |cull| {
        let mut pieces = scene.pieces.iter();
        if pieces.all(|piece| piece.finish.cull == cull) {
            return Ok(shown.to_vec());
        }
        look(cull)
    };
    let both = picture(Cull::Nothing)?;
    let seen = covered(&both).max(1);
    let backs = both.iter().filter(|record| record.is_back()).count();
    if backs * 100 < seen {
        return Ok(0);
    }
    let front = picture(Cull::Back)?;
    let pairs = both.iter().zip(&front);
    Ok(pairs.filter(|(both, front)| both.hides(front)).count() * 100 / seen)
}

/// Returns the colors of the first frame. The frame is drawn small.
///
/// # Errors
///
/// The library refuses the camera.
pub fn colors(scene: &Scene<'_>, size: (u32, u32), style: &Style<'_>) -> Result<Vec<Rgb888>> {
    let size = small(size);
    let (colors, ..) = scene.draw(size, u32::MAX, Moment::default(), style)?;
    Ok(colors)
}

/// Returns the size of a picture that has the same shape, and sides of at most [`SMALL`] pixels.
fn small((width, height): (u32, u32)) -> (u32, u32) {
    let largest = width.max(height).max(SMALL);
    let side = |side: u32| (side * SMALL / largest).max(1);
    (side(width), side(height))
}
