//! What an error in a varying is worth.

/// By how much a varying may be off where that spares dividing by w.
///
/// See [`TOLERANCES`](crate::Shader::TOLERANCES), by which a shader says so of each of its varyings.
///
/// ```
/// use fixel::mode::{Fast, Interpolate, Newton, Tolerance};
/// use fixel::fx;
/// assert_eq!(Newton.affine_within(Tolerance::Texels), 16);
/// assert_eq!(Fast::within(fx!(0.25)).affine_within(Tolerance::Texels), 1 << 14);
/// assert_eq!(Fast::within(fx!(0.25)).affine_within(Tolerance::Units(9)), 9);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tolerance {
    /// It is a texture coordinate, texels times 2^16: by what the mode is to be right to.
    Texels,
    /// By so many of its own units, which are not seen.
    Units(u32),
}
