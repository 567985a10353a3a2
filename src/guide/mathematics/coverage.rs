//! Coverage: which share of a pixel lies beyond an edge, and which color the pixel gets.
//!
//! # A share
//!
//! **The best color of a pixel is the mean of the picture over the pixel's square.** The [top-left
//! rule](crate::guide::mathematics::triangles#a-shared-edge) gives each pixel the color at its center. So an edge
//! between two colors looks jagged. If the color is *A* on the pixel's own side of the edge and *B* beyond it, the mean
//! needs only one number, the share *s* of the square that lies beyond the edge:
//!
#![doc = formula!({A + s (B - A)})]
//!
//! Take an edge that is at most as steep as a diagonal. In each column, the edge passes between the centers of two
//! pixels, one above the other. (For a steeper edge, exchange rows and columns.) Let *m* be the edge's slope, from 0
//! (level) to 1 (diagonal), and *d* the distance from a center straight up or down to the edge. The distances *d* of
//! the two pixels add up to 1.
//!
#![doc = include_str!("../diagrams/share.svg")]
//!
//! Across the pixel, the edge rises by *m*. So its distance above or below the center is from *d* − *m*/2 on one side
//! of the pixel to *d* + *m*/2 on the other. The pixel itself ends ½ above and below the center. There are three cases.
//!
//! - *d* + *m*/2 ≤ ½: the edge leaves the pixel through its left and right side. Beyond the edge is a trapezoid of
//!   width 1, with the mean height ½ − *d*.
//! - *d* − *m*/2 ≥ ½: the edge misses the pixel.
//! - Between these cases, the edge cuts off a corner of the pixel. The triangle beyond the edge has the height *u* =
//!   ½ + *m*/2 − *d*, and the width *u*/*m*:
//!
#![doc = formula!({s = frac(u^2)(2 m)} {u = frac(1 + m)(2) - d})]
//!
//! Where two cases meet (at *u* = *m* and *u* = 0), both give the same share. In each column, the edge divides no third
//! pixel: the third pixel's *d* is above 1, and *m* is at most 1, so the edge misses it.
//!
//! ```
//! use embedded_graphics::pixelcolor::{Gray8, GrayColor};
//! use fixel::prelude::*;
//! use fixel::Window;
//!
//! /// The share beyond an edge of slope m at the distance d.
//! fn share(m: f64, d: f64) -> f64 {
//!     let u = (1. + m) / 2. - d;
//!     if u >= m { 0.5 - d } else { u.max(0.).powi(2) / (2. * m) }
//! }
//!
//! // White below an edge of slope ½ that passes 0.25 pixel below the middle of a canvas of 8x8.
//! let positions = [vec3!(-8, -4.25, 0), vec3!(8, -4.25, 0), vec3!(8, 3.75, 0)];
//! let half = Mesh::new(&positions, &[[0, 1, 2]])?;
//! let edge = [[2, 0, 1, 2]]; // a border: from position 2 to position 0, beside the face 2 0 1
//! let edge = Outline::new(&half, &edge, 0)?;
//! let projection = Projection::orthographic(Window::centered(fx!(8), fx!(8)), fx!(-1), fx!(1))?;
//! let mut pixels = [Gray8::BLACK; 64];
//! let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
//! canvas.draw(&half, &projection, &Flat::new(Gray8::WHITE));
//! canvas.smooth_edges(&DrawOptions::new(), &half, &edge, &projection);
//! for (at, gray) in pixels.iter().enumerate() {
//!     // How far the center is below the edge.
//!     let (x, y) = ((at % 8) as f64 - 3.5, 3.5 - (at / 8) as f64);
//!     let below = x / 2. - 0.25 - y;
//!     let white = if below < 0. { share(0.5, -below) } else { 1. - share(0.5, below) };
//!     assert!((f64::from(gray.luma()) / 255. - white).abs() < 3. / 256.);
//! }
//! # Ok::<(), Error>(())
//! ```
//!
//! **The color *B* beyond the edge is the neighbor's color.** The two pixels lie on different sides of the edge. So
//! [`Canvas::smooth_edges`](crate::Canvas::smooth_edges) mixes the color of each pixel with the old color of the other,
//! and needs to know neither the shader nor the order in which things were drawn. The shape does not grow, because both
//! pixels get their exact shares. Two errors remain. Where colors change along the surface, the color at the neighbor's
//! center is not the color at the edge. And where two edges meet in a pixel, only one of them changes the pixel's
//! color.
//!
//! **Rounding changes a share by less than 3/256.** Positions have 8 fraction bits. The distance *d* comes from the
//! remainder of the edge's exact division ([A shared edge](crate::guide::mathematics::triangles#a-shared-edge)), and is
//! rounded down to 1/256. The slope is rounded down to 1/256, which changes a share by at most an eighth of 1/256. If
//! the edge cuts off a corner, the share is rounded down once more.
//!
//! Tests: `accuracy/smooth_edges.rs`. Unit tests: pairs of pixels in `src/raster/straddle.rs`.
//!
//! Next page: [A normal](crate::guide::mathematics::light#a-normal).
