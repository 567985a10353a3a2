//! Finds the tightest view of a set of points, for given axes.
//!
//! Every bound on the eye is linear in the eye's position, so each optimum lies where two bounds meet.

/// Returns the smallest and the largest of `values`.
pub fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
        [low.min(x), high.max(x)]
    })
}

/// Returns the smallest d with |x − c| ≤ `slope` · (d − z) for all points (x, z): the distance of the nearest eye that
/// sees all points. c is 0 or, if the eye `moves` sideways, the value that makes d smallest.
pub fn distance(points: impl Iterator<Item = [f64; 2]> + Clone, slope: f64, moves: bool) -> f64 {
    // d ≥ (x + slope·z − c) / slope and d ≥ (c − x + slope·z) / slope.
    let [_, high] = range(points.clone().map(|[x, z]| x + slope * z));
    let [low, _] = range(points.map(|[x, z]| x - slope * z));
    if moves {
        (high - low) / (2.0 * slope)
    } else {
        high.max(-low) / slope
    }
}

/// Returns the c for which the largest |x − c| / w of all points (x, w), w > 0, is smallest. Seen from c, the leftmost
/// and the rightmost point are at the same angle.
///
/// The largest slope s is the maximum of (xᵢ − xⱼ) / (wᵢ + wⱼ) over all pairs of points. Dinkelbach's method finds it:
/// each step raises s to the slope of the pair that exceeds s most, until no pair exceeds s. A step is exact for its
/// pair, and s never exceeds the optimum, so the method ends after a few steps.
pub fn center(points: &(impl Iterator<Item = [f64; 2]> + Clone)) -> f64 {
    let mut slope = 0.0;
    loop {
        let value = |[x, w]: [f64; 2], sign: f64| x + sign * slope * w;
        let high = points
            .clone()
            .max_by(|&a, &b| value(a, -1.0).total_cmp(&value(b, -1.0)));
        let low = points
            .clone()
            .min_by(|&a, &b| value(a, 1.0).total_cmp(&value(b, 1.0)));
        let (Some(high), Some(low)) = (high, low) else {
            return 0.0;
        };
        let steeper = (high[0] - low[0]) / (high[1] + low[1]);
        if steeper > slope * (1.0 + 4.0 * f64::EPSILON) {
            slope = steeper;
        } else {
            return f64::midpoint(value(high, -1.0), value(low, 1.0));
        }
    }
}
