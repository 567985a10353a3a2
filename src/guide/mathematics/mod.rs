//! From similar triangles to the pixel: the mathematics of a picture in perspective.
//!
//! With these pages you can work out by hand where a point of your scene lands on the screen, where parallel lines meet,
//! and why a texture bends if depth is interpolated the wrong way. You can also say where the errors of fixed point
//! come from, and how large they are. You need to know vectors and matrices, but nothing about graphics. Each step
//! states a claim, derives it, and checks numbers with the call that computes them.
//!
//! 1. [A point](perspective#a-point): similar triangles
//! 2. [A matrix](perspective#a-matrix): homogeneous coordinates and pseudo-depth
//! 3. [A window](perspective#a-window): field of view, aspect ratio, pixels
//! 4. [Lines](lines#lines): slopes, vanishing points, speed
//! 5. [A segment](lines#a-segment): foreshortening
//! 6. [A triangle](pixels#a-triangle): one reciprocal per pixel
//! 7. [Fixed point](pixels#fixed-point): formats and errors
//! 8. [A camera](views#a-camera): look-at, the inverse, the order of transforms
//! 9. [Parallel views](views#parallel-views): orthographic, axonometric, oblique
//! 10. [Time](time#time): turns that do not drift
//!
//! The axes are right-handed: x points to the right, and y points up. The eye is at the origin and looks along −z. The
//! numbers *n* and *f* are the distances of the near and the far plane, both above zero. Each step ends with the names
//! of the tests that check its claim, mostly with random numbers. The files of these tests are in the repository's
//! folder `tests`.

pub mod lines;
pub mod perspective;
pub mod pixels;
pub mod time;
pub mod views;
