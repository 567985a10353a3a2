//! The whole rendering pipeline in f64, written from the mathematics. The model shares no code with the crate.
//!
//! The tests compare the crate's integer pipeline with this pipeline. Each part therefore has its plainest textbook
//! form, not a fast form. Parts with an exact answer (the coverage of snapped vertices) are computed in exact integers.
//!
//! Conventions: column vectors; matrices as rows; right-handed axes; the eye at the origin, looking down −z, y up;
//! angles in radians; screen coordinates in pixels, y down, with the center of pixel (0, 0) at (½, ½); snapped
//! coordinates in 24.8, that is in 1/256 pixel.
//!
//! | file | idea |
//! |---|---|
//! | `linear` | vectors and 4x4 matrices |
//! | `projection` | projections; distance ahead and depth |
//! | `view` | the transform of a position in space to one on the screen |
//! | `clip` | polygons and segments against planes in homogeneous coordinates |
//! | `coverage` | the pixel centers that a triangle covers |
//! | `distance` | distances from a point to a segment or a triangle on the screen |
//! | `silhouette` | how far a point is inside or outside a union of triangles |
//! | `attributes` | perspective-correct values and their gradients at a point |
//! | `raster` | a mesh drawn as a picture: every surface at every pixel |
//! | `diffusion` | error diffusion of a frame |
//! | `blending` | blending of two colors |
//! | `fog` | the part of a surface's color that shows through fog |
//! | `light` | the brightness of a surface under lights |
//! | `lines` | values along a projected segment |
//! | `mipmap` | reduced textures, the level of a pixel, means over areas |
//! | `outline` | the edges of a mesh, their faces, and the angles between the faces |
//! | `normals` | normals of a mesh that has none |
//! | `ray` | where a ray meets a triangle |
//! | `scenes` | the measured scenes |
//! | `sprites` | the corners of sprites |
//! | `texture` | a texture's color between its texels |
//! | `tests` | the model, compared with numbers worked out by hand |

// Each binary that includes the model uses only parts of it.
#![allow(dead_code)]
// Formulas keep their textbook names, and f64 represents every integer used here exactly.
#![allow(clippy::many_single_char_names, clippy::similar_names)]
#![allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)]
#![allow(clippy::cast_sign_loss, clippy::cast_possible_wrap)]
#![allow(clippy::too_many_arguments)]

pub mod attributes;
pub mod blending;
pub mod clip;
pub mod coverage;
pub mod diffusion;
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
pub mod ray;
pub mod scenes;
pub mod silhouette;
pub mod sprites;
pub mod texture;
pub mod view;
