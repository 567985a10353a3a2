//! What is fuzzed: bytes to an input, the input to the crate, and what must hold of what comes of it.
//!
//! The fuzz targets in tests/fuzz call [`draw`] and [`obj`] with bytes that libFuzzer makes up; tests/accuracy/replay.rs calls
//! them with those that were worth keeping. A mistake is a panic.
//!
//! | file | idea |
//! |---|---|
//! | `numbers` | numbers of every magnitude |
//! | `scene` | a draw call: mesh, mvp, canvas, and what is drawn how |
//! | `projection` | projections, and the model's of the same numbers |
//! | `steps` | mvps of transforms, and the model's |
//! | `draw` | a scene in every mode, and with a shader of the crate |
//! | `shaders` | a shader that shows every bit |
//! | `shades` | the crate's shaders |
//! | `ways` | a draw call in bands, prepared, as bytes and twice |
//! | `knowledge` | where the f64 model has a triangle, and how well that is known |
//! | `model` | the pixels against the f64 model |
//! | `obj` | OBJ text, of any bytes or nearly right |

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
