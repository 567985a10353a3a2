//! From a vertex to its pixels: the mathematics of a picture in perspective.
//!
//! With these pages you can work out by hand where a point of your scene lands on the screen, which triangle draws a
//! pixel on a shared edge, how bright the pixel is, and why a texture bends if depth is interpolated the wrong way. You
//! can also say where the errors of fixed point come from, and how large they are. You need to know vectors and
//! matrices, but nothing about graphics. Each step states a claim, derives it, and checks an example against the
//! numbers that fixel's functions compute.
//!
//! Read the pages in this order. They follow a vertex until it has become pixels:
//!
//! 1. [A turn](rotation#a-turn): Rodrigues' formula, which turns a model in the world
//! 2. [A quaternion](rotation#a-quaternion): a turn in four numbers, and one turn after another
//! 3. [Time](rotation#time): turns that do not drift
//! 4. [A camera](camera#a-camera): look-at, the inverse, a camera placed by moves
//! 5. [A mirror](camera#a-mirror): mirror images, and shadows on a plane
//! 6. [A point](projection#a-point): similar triangles, the practice cube
//! 7. [A matrix](projection#a-matrix): homogeneous coordinates, pseudo-depth, the perspective transform
//! 8. [A window](projection#a-window): field of view, aspect ratio, frustum, pixels
//! 9. [Parallel views](projection#parallel-views): orthographic, axonometric, oblique
//! 10. [A chain](projection#a-chain): the order of transforms
//! 11. [A clip](clipping#a-clip): where an edge meets the near plane
//! 12. [A shared cut](clipping#a-shared-cut): why clipped neighbors leave no crack
//! 13. [Lines](lines#lines): slopes, vanishing points, speed, one-, two- and three-point perspective
//! 14. [A segment](lines#a-segment): foreshortening, and why 1/*w* is linear on the screen
//! 15. [An edge](triangles#an-edge): on which side of an edge a pixel lies
//! 16. [An area](triangles#an-area): its sign, and barycentric coordinates
//! 17. [A shared edge](triangles#a-shared-edge): the top-left rule, by which each pixel is drawn once
//! 18. [A share](coverage#a-share): how much of a pixel lies beyond an edge
//! 19. [A normal](light#a-normal): the transpose of the inverse
//! 20. [Matte surfaces](light#matte-surfaces): Lambert's cosine
//! 21. [Highlights](light#highlights): Phong's mirror and Blinn's halfway direction
//! 22. [An attribute](pixels#an-attribute): one reciprocal per pixel
//! 23. [A depth step](pixels#a-depth-step): how far apart surfaces must be
//! 24. [A mip level](pixels#a-mip-level): how many texels a pixel covers
//! 25. [Fixed point](fixed_point#fixed-point): formats and errors
//!
//! The axes are right-handed: x points to the right, and y points up. The eye is at the origin and looks along −z. The
//! numbers *n* and *f* are the distances of the near and the far plane, both above zero. Each step ends with the names
//! of the tests that check its claim, mostly with random numbers. The files of these tests are in the repository's
//! folder `tests`.

pub mod camera;
pub mod clipping;
pub mod coverage;
pub mod fixed_point;
pub mod light;
pub mod lines;
pub mod pixels;
pub mod projection;
pub mod rotation;
pub mod triangles;
