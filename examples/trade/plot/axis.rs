//! Logarithmic axes with round numbers.

/// Below this no error is told from none: half a unit of a texel as it is interpolated is 2⁻¹⁷.
pub const LEAST_ERROR: f64 = 1e-5;

/// A logarithmic axis: its range, and the numbers that are written at it.
#[derive(Clone, Debug)]
pub struct Axis {
    pub low: f64,
    pub high: f64,
    pub ticks: Vec<f64>,
}

impl Axis {
    /// Whole decades that hold all of the values.
    pub fn decades(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = ends(values);
        // A little more than the greatest, so that a mark there is not cut.
        let (low, high) = (
            low.log10().floor() as i32,
            (high * 1.2).log10().ceil() as i32,
        );
        Self {
            low: 10_f64.powi(low),
            high: 10_f64.powi(high),
            ticks: (low..=high).map(|power| 10_f64.powi(power)).collect(),
        }
    }

    /// A range a little larger than that of the values, with 1, 2 and 5 of each decade.
    pub fn around(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = ends(values);
        let (low, high) = (low / 1.25, high * 1.25);
        let ticks: Vec<f64> = (low.log10().floor() as i32..=high.log10().ceil() as i32)
            .flat_map(|power| [1., 2., 5.].map(|digit| digit * 10_f64.powi(power)))
            .filter(|tick| (low..=high).contains(tick))
            .collect();
        // Of many decades the whole ones.
        let ticks = if ticks.len() > 12 {
            ticks
                .into_iter()
                .filter(|tick| tick.log10().rem_euclid(1.) < 0.01)
                .collect()
        } else {
            ticks
        };
        Self { low, high, ticks }
    }
}

/// The least and the greatest; 1 and 1 if there are none.
fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values
        .fold(None, |ends: Option<(f64, f64)>, value| {
            let (low, high) = ends.unwrap_or((value, value));
            Some((low.min(value), high.max(value)))
        })
        .unwrap_or((1., 1.))
}

/// A tick's number without what is not needed: 0.001, 0.5, 20, 1000.
pub fn label(value: &f64) -> String {
    let digits = (-value.log10().floor()).max(0.) as usize;
    format!("{value:.digits$}")
}
