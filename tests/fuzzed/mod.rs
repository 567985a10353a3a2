//! The fuzzed checks: from bytes to an input, from the input to the crate, and the invariants of the result.
//!
//! The fuzz targets in tests/fuzz call [`draw`] and [`obj`] with bytes from libFuzzer; tests/accuracy/replay.rs calls
//! them with inputs that were worth keeping. An error is a panic.
//!
//! | file | idea |
//! |---|---|
//! | `numbers` | numbers of every magnitude |
//! | `scene` | a draw call: mesh, mvp, canvas, and options |
//! | `projection` | projections, by the crate and by the model |
//! | `steps` | products of transforms, by the crate and by the model |
//! | `draw` | a scene in every mode, and with one of the crate's shaders |
//! | `shaders` | a shader whose color depends on every bit |
//! | `shades` | the crate's shaders |
//! | `ways` | a draw call in bands, prepared, as bytes and twice |
//! | `knowledge` | the f64 model's triangles, and bounds of their error |
//! | `model` | the pixels, compared with the f64 model |
//! | `obj` | OBJ text of arbitrary bytes, or almost correct |

pub mod draw;
pub mod knowledge;
pub mod model;
pub mod numbers;
pub mod obj;
pub mod projection;
pub mod scene;
pub mod shaders;
pub mod shades;
pub mod steps;
pub mod ways;
