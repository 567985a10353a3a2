//! Statistics of many errors: the largest, the mean, and the 99.9th percentile.

/// A set of errors, each with the position at which it was found.
#[derive(Clone, Debug, Default)]
pub struct Spread(Vec<(f64, usize)>);

impl Spread {
    pub fn add(&mut self, error: f64, at: usize) {
        assert!(!error.is_nan());
        self.0.push((error, at));
    }

    /// The largest error, with its position.
    pub fn worst(&self) -> (f64, usize) {
        let worst = self.0.iter().max_by(|a, b| a.0.total_cmp(&b.0));
        *worst.expect("nothing was drawn")
    }

    pub fn max(&self) -> f64 {
        self.worst().0
    }

    pub fn mean(&self) -> f64 {
        self.0.iter().map(|(error, _)| error).sum::<f64>() / self.0.len() as f64
    }

    /// The fraction of the errors that are at most `limit`.
    pub fn within(&self, limit: f64) -> f64 {
        self.0.iter().filter(|(error, _)| *error <= limit).count() as f64 / self.0.len() as f64
    }

    /// The value that 999 of 1,000 errors do not exceed.
    pub fn permille(&self) -> f64 {
        let mut all: Vec<f64> = self.0.iter().map(|(error, _)| *error).collect();
        let at = (all.len() * 999).div_ceil(1000).max(1) - 1;
        *all.select_nth_unstable_by(at, f64::total_cmp).1
    }

    /// The statistics as one line of text.
    pub fn line(&self, what: &str, unit: &str) -> String {
        format!(
            "  {what:<34} max {:.3e}  99.9 % {:.3e}  mean {:.3e} {unit}",
            self.max(),
            self.permille(),
            self.mean()
        )
    }
}
