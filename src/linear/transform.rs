//! Placeholder
/// An affine transform.
#[derive(Clone, Copy, Debug)]
#[allow(dead_code)]
pub struct Transform {
    pub(crate) linear: [[i32; 3]; 3],
    pub(crate) linear_exp: i32,
    pub(crate) translation: [i32; 3],
    pub(crate) translation_exp: i32,
}

impl Transform {
    /// Placeholder: cofactors of the linear part times the determinant's sign, to 30 bits.
    pub(crate) fn normal_matrix(&self) -> [[i32; 3]; 3] {
        let m = self.linear.map(|row| row.map(i64::from));
        let cofactor = |i: usize, j: usize| {
            let (i1, i2, j1, j2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
            m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1]
        };
        let rows = [0, 1, 2].map(|i| [0, 1, 2].map(|j| cofactor(i, j)));
        let size = rows
            .as_flattened()
            .iter()
            .fold(0, |all, x| all | x.unsigned_abs());
        let zeros = size.leading_zeros();
        #[allow(clippy::cast_possible_truncation)]
        let rows = rows.map(|row| {
            row.map(|x| {
                if zeros < 34 {
                    (x >> (34 - zeros)) as i32
                } else {
                    (x << (zeros - 34).min(63)) as i32
                }
            })
        });
        // A mirrored surface has its outside where the cofactors, which follow the winding, say inside.
        let determinant: i64 = (0..3).map(|j| m[0][j] * i64::from(rows[0][j])).sum();
        if determinant < 0 {
            rows.map(|row| row.map(|x| -x))
        } else {
            rows
        }
    }
}
