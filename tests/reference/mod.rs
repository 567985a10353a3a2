//! The whole rendering pipeline in f64, written from the mathematics and sharing no code with the crate.
//!
//! It judges the integer pipeline. So each part takes the plainest textbook form rather than a fast one, and parts
//! whose answer is exact (coverage of snapped vertices) are computed in exact integers.
//!
//! Conventions: column vectors, matrices as rows, right-handed, the eye at the origin looking down −z with y up;
//! angles in radians; screen coordinates in pixels, y down, with the center of pixel (0, 0) at (½, ½); snapped
//! coordinates in 24.8, that is in 1/256 pixel.
//!
//! | file | idea |
//! |---|---|
//! | `linear` | vectors and 4x4 matrices |
//! | `projection` | projections; distance ahead and depth |
//! | `view` | from a position in space to one on the screen |
//! | `clip` | polygons and segments against planes in homogeneous coordinates |
//! | `coverage` | the pixel centers that a triangle covers |
//! | `distance` | distances from a point to a segment or a triangle on the screen |
//! | `silhouette` | how far a point is inside or outside a union of triangles |
//! | `attributes` | perspective-correct values and their gradients at a point |
//! | `raster` | a mesh to a picture: every surface at every pixel |
//! | `fog` | what is left of a surface in fog |
//! | `light` | the brightness of a surface under lights |
//! | `lines` | values along a projected segment |
//! | `mipmap` | reduced textures, the level that a pixel calls for, means over areas |
//! | `outline` | the edges of a mesh, their faces and the angles between these |
//! | `normals` | normals of a mesh that has none |
//! | `scenes` | the measured scenes |
//! | `sprites` | the corners of sprites |
//! | `texture` | a texture's color between its texels |

// Each test binary includes the model and uses part of it.
#![allow(dead_code)]
// The formulas keep the names that they have in textbooks, and f64 holds every integer used here.
#![allow(clippy::many_single_char_names, clippy::similar_names)]
#![allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)]
#![allow(clippy::cast_sign_loss, clippy::cast_possible_wrap)]
#![allow(clippy::too_many_arguments)]

pub mod attributes;
pub mod blending;
pub mod clip;
pub mod coverage;
pub mod distance;
pub mod fog;
pub mod light;
pub mod linear;
pub mod lines;
pub mod mipmap;
pub mod normals;
pub mod outline;
pub mod projection;
pub mod raster;
pub mod scenes;
pub mod silhouette;
pub mod sprites;
pub mod texture;
pub mod view;
