//! Checks of draw calls, models and pictures made from arbitrary bytes. A check makes an input from the bytes, passes it
//! to the crate or to its importer, and checks the invariants of the result.
//!
//! libFuzzer's targets, in `targets`, call [`draw::check`], [`import::model`] and [`import::picture`] with arbitrary
//! bytes. `replay.rs` calls them with the inputs that were kept. A check that fails panics.
//!
//! | file | contents |
//! |---|---|
//! | `numbers` | numbers of every magnitude |
//! | `scene` | a draw call: mesh, model-view-projection, canvas, and options |
//! | `projection` | projections, made both by the crate and by the model |
//! | `steps` | products of transforms, made both by the crate and by the model |
//! | `draw` | draws a scene in every mode, and with one of the crate's shaders |
//! | `shaders` | a shader with colors that depend on every bit |
//! | `shades` | the crate's shaders |
//! | `call` | draws a scene in bands, prepared, as bytes and twice |
//! | `knowledge` | the f64 model's triangles, and bounds on the crate's deviation from them |
//! | `model` | the comparison of pixels with the f64 model |
//! | `import` | files of models and pictures |

// f64 holds every integer used here, and no pixel lies left of or above the picture.
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)]

mod call;
pub mod draw;
pub mod import;
mod knowledge;
mod model;
mod numbers;
mod projection;
mod scene;
mod shaders;
mod shades;
mod steps;
