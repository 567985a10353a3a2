//! Error diffusion by Floyd and Steinberg (1976), for a whole frame, with an error for each pixel.

/// The steps that each pixel of `grays` (rows of 0 to 255) shows on a display with `most` steps from black to white.
///
/// A pixel's error is divided into four shares for its neighbors. A share is truncated to 1/16 of a gray, toward black,
/// and the last share is the remainder. Shares for pixels beyond the left and right sides go to the pixel below. An
/// error is limited to half a step. The rest of a larger error is dropped, because black and white pixels cannot show
/// it.
pub fn steps(grays: &[Vec<u8>], most: i32) -> Vec<Vec<i32>> {
    let (height, width) = (grays.len(), grays[0].len());
    let step = 255. / f64::from(most);
    let mut received = vec![vec![0.; width]; height];
    let mut shown = vec![vec![0; width]; height];
    for y in 0..height {
        for x in 0..width {
            let wanted = f64::from(grays[y][x]) + received[y][x];
            let nearest = (wanted / step + 0.5).floor().clamp(0., f64::from(most));
            let error = (wanted - nearest * step).clamp(-step / 2., step / 2.);
            let share = |part: f64| (error * part).floor() / 16.;
            let shares = [share(7.), share(3.), share(5.)];
            let rest = error - shares.iter().sum::<f64>();
            let targets = [(1, 0), (-1, 1), (0, 1), (1, 1)];
            for ((across, down), share) in targets
                .into_iter()
                .zip([shares[0], shares[1], shares[2], rest])
            {
                let column = x as isize + across;
                let (column, row) = if (0..width as isize).contains(&column) {
                    (column as usize, y + down)
                } else {
                    (x, y + 1)
                };
                if row < height {
                    received[row][column] += share;
                }
            }
            shown[y][x] = nearest as i32;
        }
    }
    shown
}
