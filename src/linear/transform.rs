//! Placeholder
/// An affine transform.
#[derive(Clone, Copy, Debug)]
pub struct Transform {
    pub(crate) linear: [[i32; 3]; 3],
    pub(crate) linear_exp: i32,
    pub(crate) translation: [i32; 3],
    pub(crate) translation_exp: i32,
}
