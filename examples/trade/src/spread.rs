//! Statistics of many errors.

use super::Result;

/// The largest error, the 99th percentile, and the mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    pub max: f64,
    pub p99: f64,
    pub mean: f64,
}

impl Spread {
    /// Returns the statistics of these errors.
    ///
    /// # Errors
    ///
    /// There are no errors, or an error is not a number.
    pub fn of(mut errors: Vec<f64>) -> Result<Self> {
        if errors.is_empty() || errors.iter().any(|error| error.is_nan()) {
            return Err("no pixel to measure".into());
        }
        let count = errors.len();
        let rank = (count * 99).div_ceil(100) - 1;
        let (_, &mut p99, above) = errors.select_nth_unstable_by(rank, f64::total_cmp);
        let max = above.iter().copied().fold(p99, f64::max);
        let mean = errors.iter().sum::<f64>() / count as f64;
        Ok(Self { max, p99, mean })
    }
}

/// Returns the median: the lower one if there are two middle values, and 0 if there are no values.
pub fn median(mut values: Vec<f64>) -> f64 {
    if values.is_empty() {
        return 0.;
    }
    let middle = (values.len() - 1) / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}
