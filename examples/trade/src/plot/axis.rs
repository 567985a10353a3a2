//! Logarithmic axes with round numbers.

/// Errors below this value count as zero. For comparison, half a unit of an interpolated texel is 2⁻¹⁷.
pub const LEAST_ERROR: f64 = 1e-5;

/// A logarithmic axis: its range and its labels.
#[derive(Clone, Debug)]
pub struct Axis {
    pub low: f64,
    pub high: f64,
    pub ticks: Vec<f64>,
}

impl Axis {
    /// Makes an axis of whole decades that contains all values.
    pub fn decades(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = ends(values);
        // The axis is a little longer than the largest value, so that the value's mark is not cut off.
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

    /// Makes an axis a little longer than the range of the values. The labels are as many round numbers as fit.
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

    /// Makes an axis like [`around`](Self::around), with the values themselves as labels.
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

/// Returns the smallest and the largest value, or 1 and 1 if there are no values.
fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values
        .fold(None, |ends: Option<(f64, f64)>, value| {
            let (low, high) = ends.unwrap_or((value, value));
            Some((low.min(value), high.max(value)))
        })
        .unwrap_or((1., 1.))
}

/// Formats the number of a tick without unnecessary zeros, for example 0.001, 1.5, 20 or 1024.
pub fn label(value: f64) -> String {
    let digits = (1. - value.log10().floor()).max(0.) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// Formats the number of a tick on an axis of errors. Errors below the lowest tick are drawn at this tick.
pub fn error_label(value: f64) -> String {
    if value < LEAST_ERROR * 1.01 {
        format!("≤ {}", label(value))
    } else {
        label(value)
    }
}
