//! Mipmaps: reduced textures, the level of a pixel, and the mean color over a pixel's area.

use super::linear::{Vec3, cross, dot, length, subtract};

/// One channel of a level, halved in both directions. A texel is the mean of four texels, rounded to nearest, halves
/// up.
pub fn reduced(rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mean = |pair: &[Vec<f64>], at: usize| {
        let sum: f64 = pair.iter().map(|row| row[at] + row[at + 1]).sum();
        (sum / 4. + 0.5).floor()
    };
    let row = |pair: &[Vec<f64>]| {
        (0..pair[0].len())
            .step_by(2)
            .map(|at| mean(pair, at))
            .collect()
    };
    rows.chunks(2).map(row).collect()
}

/// The level at which a texel is as long as a pixel, in the direction of the strongest foreshortening.
///
/// `corners` are in eye space. `texels` are their texture coordinates in texels. `focal` is in pixels. `z` is the
/// distance at the pixel. At the distance z, a pixel covers a width of z/focal. On a plane at the distance d from the
/// eye, this width is stretched by z/d along the line of sight (exactly only in the middle of the picture).
pub fn level(corners: [Vec3; 3], texels: [[f64; 2]; 3], focal: f64, z: f64) -> f64 {
    let [a, b, c] = corners;
    let normal = cross(subtract(b, a), subtract(c, a));
    let distance = dot(normal, a).abs() / length(normal);
    let [e, f] = [1, 2].map(|i: usize| [texels[i][0] - texels[0][0], texels[i][1] - texels[0][1]]);
    let density = ((e[0] * f[1] - e[1] * f[0]).abs() / length(normal)).sqrt();
    (density * z / focal * (z / distance)).log2()
}

/// The mean of a function over a pixel, from `across` times `across` samples.
pub fn area([x, y]: [f64; 2], across: u32, value: impl Fn([f64; 2]) -> f64) -> f64 {
    let mut sum = 0.;
    for i in 0..across {
        for j in 0..across {
            let at = |k: u32| (f64::from(k) + 0.5) / f64::from(across);
            sum += value([x + at(j), y + at(i)]);
        }
    }
    sum / f64::from(across * across)
}
