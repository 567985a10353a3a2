//! Checks, before a picture is drawn, that something will be visible in it.

use fixel::Cull;

use super::Result;
use crate::args::{Args, Shade};
use crate::dump::Record;
use crate::job::{Band, Model, Moment};

/// Largest side of the small pictures in which back faces are counted.
const SMALL: u32 = 256;
/// Largest side that a picture in one piece can have.
const LARGE: u32 = 2048;

/// Returns hints for the user: most faces in view show their backs, which are not drawn; or fog hides all of them.
///
/// # Errors
///
/// Nothing is visible in any frame. The message says why, and what to do.
pub fn check(model: &Model<'_>, args: &Args) -> Result<Vec<String>> {
    let is_wire = model.shade == Some(Shade::Wire);
    let cull = model.view.options.cull();
    let (width, height) = args.size;
    let size = within((width * args.samples, height * args.samples), LARGE);
    let any = |cull, edges| -> Result<bool> {
        for frame in 0..args.frames {
            let records = model.look(size, frame, cull, edges)?;
            if records.iter().any(Record::is_covered) {
                return Ok(true);
            }
        }
        Ok(false)
    };
    if !any(cull, is_wire)? {
        let why = if any(Cull::Nothing, is_wire)? {
            "all faces in view point away: try --two-sided"
        } else if any(Cull::Nothing, true)? {
            "the faces in view cover no pixel: try --shade wire"
        } else {
            "the model is outside the picture or smaller than a pixel"
        };
        return Err(format!("nothing is visible: {why}").into());
    }
    let mut hints = Vec::new();
    if is_wire || model.shade.is_none() {
        return Ok(hints);
    }
    let size = within(size, SMALL);
    let front = model.look(size, 0, cull, false)?;
    let is_foggy = matches!(
        model.shade,
        Some(Shade::Texture | Shade::Lit | Shade::Gouraud | Shade::Flat)
    );
    let is_beyond = |far: f64| {
        let mut seen = front.iter().filter(|record| record.is_covered());
        seen.all(|record| record.distance() >= far)
    };
    if is_foggy && args.fog.is_some_and(|fog| is_beyond(fog.far)) {
        hints.push("all faces in view are behind the fog: see --fog".into());
    }
    if cull == Cull::Nothing {
        return Ok(hints);
    }
    let both = model.look(size, 0, Cull::Nothing, false)?;
    let seen = both.iter().filter(|record| record.is_covered()).count();
    let away = (both.iter().zip(&front)).filter(|(both, front)| both.hides(front));
    if 2 * away.count() > seen {
        hints.push("most faces in view point away: try --two-sided".into());
    }
    Ok(hints)
}

/// Returns the size of a picture of the same shape, with sides of at most `most` pixels.
fn within((width, height): (u32, u32), most: u32) -> (u32, u32) {
    let largest = u64::from(width.max(height));
    let side = |side: u32| {
        let less = u64::from(side) * u64::from(most) / largest.max(1);
        u32::try_from(less).unwrap_or(most).max(1)
    };
    if largest > u64::from(most) {
        (side(width), side(height))
    } else {
        (width, height)
    }
}

impl Model<'_> {
    /// Records a whole frame, of faces or of edges.
    fn look(&self, size: (u32, u32), frame: u32, cull: Cull, edges: bool) -> Result<Vec<Record>> {
        let pixels = size.0 as usize * size.1 as usize;
        let mut records = vec![Record::default(); pixels];
        let mut depth = vec![0; pixels];
        let mut view = self.view;
        view.options = view.options.with_cull(cull);
        let band = Band {
            pixels: &mut records,
            depth: &mut depth,
            size,
            first_row: 0,
            viewport: None,
        };
        let moment = Moment {
            frame,
            ..Moment::default()
        };
        self.record_in(&view, band, moment, edges)?;
        Ok(records)
    }
}
