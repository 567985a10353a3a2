//! Averages pixels, for smooth edges.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

/// Energy of each sRGB byte, 0 to 1, as IEC 61966-2-1 defines it.
fn energies() -> [f32; 256] {
    std::array::from_fn(|byte| {
        #[allow(clippy::cast_precision_loss)] // a byte
        let value = byte as f32 / 255.0;
        if value <= 0.04045 {
            value / 12.92
        } else {
            ((value + 0.055) / 1.055).powf(2.4)
        }
    })
}

/// Returns the sRGB byte nearest to an energy.
fn byte(energies: &[f32; 256], energy: f32) -> u8 {
    let above = energies.partition_point(|&each| each < energy).min(255);
    let below = above.saturating_sub(1);
    let nearest = if energies[above] - energy < energy - energies[below] {
        above
    } else {
        below
    };
    u8::try_from(nearest).unwrap_or(u8::MAX)
}

/// Averages the energy of squares of `side` x `side` pixels in rows of `width`.
pub fn average(pixels: &[Rgb888], width: usize, side: usize) -> Vec<Rgb888> {
    if side == 1 {
        return pixels.to_vec();
    }
    let energies = energies();
    #[allow(clippy::cast_precision_loss)] // at most 256 pixels
    let share = 1.0 / (side * side) as f32;
    let mut averages = Vec::with_capacity(pixels.len() / (side * side));
    for rows in pixels.chunks_exact(width * side) {
        for column in (0..width).step_by(side) {
            let mut sum = [0.0; 3];
            for row in rows.chunks_exact(width) {
                for color in &row[column..column + side] {
                    let bytes = [color.r(), color.g(), color.b()];
                    for (sum, byte) in sum.iter_mut().zip(bytes) {
                        *sum += energies[usize::from(byte)];
                    }
                }
            }
            let [r, g, b] = sum.map(|sum| byte(&energies, sum * share));
            averages.push(Rgb888::new(r, g, b));
        }
    }
    averages
}
