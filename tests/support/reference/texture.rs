//! The color of a texture at a point, interpolated between the texels around it.
//!
//! Texel (i, j) has its center at (i + ½, j + ½) texels. Between centers, the color is linear in u for a fixed v, and
//! linear in v for a fixed u: f(u, v) = Σ tᵢⱼ · max(0, 1 − |u − i − ½|) · max(0, 1 − |v − j − ½|). The wrap mode
//! extends the texture to an endless plane, and the sum runs over all texels of this plane.

/// The addressing beyond a texture's edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrap {
    /// The texture repeats.
    Repeat,
    /// The nearest texel at the edge is repeated.
    Clamp,
}

impl Wrap {
    /// The column or row of the texture, from 0 to `size` − 1, that the plane shows at column or row `at`.
    pub fn index(self, at: i64, size: usize) -> usize {
        let size = size as i64;
        let inside = match self {
            Wrap::Repeat => at.rem_euclid(size),
            Wrap::Clamp => at.max(0).min(size - 1),
        };
        inside as usize
    }
}

/// One channel of a color at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blended {
    /// The value.
    pub value: f64,
    /// The smallest of the texels around the point, including texels with a weight of 0.
    pub least: f64,
    /// The largest of these texels.
    pub most: f64,
}

/// One channel of a texture at a point. The point is in texels. The rows of the texture run from top to bottom.
pub fn bilinear(rows: &[Vec<f64>], wrap: Wrap, [u, v]: [f64; 2]) -> Blended {
    let mut blended = Blended {
        value: 0.,
        least: f64::INFINITY,
        most: f64::NEG_INFINITY,
    };
    let tent = |distance: f64| (1. - distance.abs()).max(0.);
    let near = |at: f64| (at.floor() as i64 - 2)..=(at.floor() as i64 + 2);
    for j in near(v) {
        for i in near(u) {
            let row = &rows[wrap.index(j, rows.len())];
            let texel = row[wrap.index(i, row.len())];
            let away = [u - i as f64 - 0.5, v - j as f64 - 0.5];
            if away.iter().all(|distance| distance.abs() <= 1.) {
                blended.value += texel * tent(away[0]) * tent(away[1]);
                blended.least = blended.least.min(texel);
                blended.most = blended.most.max(texel);
            }
        }
    }
    blended
}
