//! Ways to draw a scene that must all give the same picture.

use core::fmt;

use super::common::scenes::HEIGHT;
use super::scene::Scene;

/// A way to draw a scene in the default mode.
#[derive(Clone, Copy)]
pub struct Way {
    pub scene: Scene,
    /// The number of rows of a band. The last band can have fewer.
    pub rows: u32,
    pub repeat: Repeat,
    /// Whether the triangles are transformed once for all bands.
    pub is_prepared: bool,
}

/// The number of times that each band is drawn.
#[derive(Clone, Copy)]
pub enum Repeat {
    Once,
    /// Twice. The band is cleared in between.
    Again,
    /// Twice, the second time over the first picture. Of triangles at equal depths, the last one drawn shows, and the
    /// same triangle is the last one both times.
    Over,
}

impl Way {
    /// All ways. The lighthouse is not drawn with its triangles in another order: where the sea meets the island, a few
    /// pixels have equal depths, and the last triangle shows.
    pub fn all() -> impl Iterator<Item = Self> {
        let whole = (HEIGHT, Repeat::Once);
        let bands = [1, 7, 16].map(|rows| (rows, Repeat::Once));
        let twice = [Repeat::Again, Repeat::Over].map(|repeat| (HEIGHT, repeat));
        let scenes = [Scene::Inwards, Scene::Outwards, Scene::Lighthouse];
        scenes.into_iter().flat_map(move |scene| {
            let drawn = [whole].into_iter().chain(bands).chain(twice);
            drawn.flat_map(move |(rows, repeat)| {
                [false, true].map(|is_prepared| Self {
                    scene,
                    rows,
                    repeat,
                    is_prepared,
                })
            })
        })
    }
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "rows-{}", self.rows)?;
        f.write_str(match self.repeat {
            Repeat::Once => "",
            Repeat::Again => "-again",
            Repeat::Over => "-over",
        })?;
        f.write_str(match self.scene {
            Scene::Outwards => "-reversed",
            _ => "",
        })?;
        f.write_str(if self.is_prepared { "-prepared" } else { "" })
    }
}
