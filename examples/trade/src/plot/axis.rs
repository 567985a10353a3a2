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

    /// A range a little larger than that of the values, with as many round numbers as have room.
    pub fn around(values: impl Iterator<Item = f64>) -> Self {
        const DIGITS: [&[f64]; 4] = [
            &[1.],
            &[1., 2., 5.],
            &[1., 1.5, 2., 3., 5., 7.],
            &[1., 1.2, 1.5, 2., 2.5, 3., 3.5, 4., 5., 6., 7., 8., 9.],
        ];
        let (low, high) = ends(values);
        let (low, high) = (low / 1.25, high * 1.25);
        let ticks = |digits: &&[f64]| -> Vec<f64> {
            (low.log10().floor() as i32..=high.log10().ceil() as i32)
                .flat_map(|power| digits.iter().map(move |digit| digit * 10_f64.powi(power)))
                .filter(|tick| (low..=high).contains(tick))
                .collect()
        };
        let enough = DIGITS.iter().map(ticks).find(|ticks| ticks.len() >= 4);
        Self {
            low,
            high,
            ticks: enough.unwrap_or_else(|| ticks(&DIGITS[3])),
        }
    }

    /// The same, with the values themselves written at it.
    pub fn at(values: impl Iterator<Item = f64>) -> Self {
        let mut ticks: Vec<f64> = values.collect();
        ticks.sort_by(f64::total_cmp);
        ticks.dedup();
        Self {
            ticks: ticks.clone(),
            ..Self::around(ticks.into_iter())
        }
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

/// A tick's number without what is not needed: 0.001, 1.5, 20, 1024.
pub fn label(value: f64) -> String {
    let digits = (1. - value.log10().floor()).max(0.) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// The number of an error's tick: at the least what is below is drawn too.
pub fn error_label(value: f64) -> String {
    if value < LEAST_ERROR * 1.01 {
        format!("≤ {}", label(value))
    } else {
        label(value)
    }
}
