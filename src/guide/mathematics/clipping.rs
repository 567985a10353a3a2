//! Clipping: what happens to an edge that reaches behind the near plane.
//!
//! The [first page](crate::guide::mathematics) of this chapter says where the axes x, y and z point, and defines the
//! letters *n* and *f*.
//!
//! # A clip
//!
//! **An edge meets the near plane at the fraction *t* of its length:**
//!
#![doc = formula!({t = frac(w[0] - n)(w[0] - w[1])})]
//!
//! The first end is inside, at the distance *w*₀ ≥ *n* ahead of the eye. The second end is outside, at *w*₁ < *n*; *w*₁
//! is negative if this end is behind the eye. Along the edge in space, the distance is *w*₀ + *t* (*w*₁ − *w*₀). Set
//! this to *n*, and solve for *t*. As *w*₁ < *n*, the divisor is never zero, and *t* is from 0 to below 1.
//!
#![doc = include_str!("../diagrams/clip.svg")]
//!
//! All coordinates and all attributes are linear along the edge in space. The values of the new corner are the means of
//! the values at both ends, with the weights 1 − *t* and *t*. Nothing has been divided by *w* yet, so no corner is
//! mirrored.
//!
//! By hand, with *n* = 1: the edge from (2, 1, −4) to (−1, −2, 2) has *w*₀ = 4 and *w*₁ = −2. So *t* = (4 − 1)/(4 + 2)
//! = ½, and the new corner is (½, −½, −1). The image of the first end is (½, ¼), and the image of the new corner is (½,
//! −½): the edge runs *down* from its first end. A division by *w*₁ = −2 would put the second end at (½, 1), and the
//! edge would run *up*.
//!
//! ```
//! use embedded_graphics::pixelcolor::BinaryColor;
//! use fixel::prelude::*;
//! use fixel::Window;
//!
//! let ends = [vec3!(2, 1, -4), vec3!(-1, -2, 2)];
//! let edge = Mesh::new(&ends, &[])?.with_edges(&[[0, 1]])?;
//! let projection = Projection::frustum(Window::centered(fx!(2), fx!(2)), fx!(1), fx!(9))?;
//! let mut pixels = [BinaryColor::Off; 64 * 64];
//! let mut canvas = Canvas::new(&mut pixels, 64, 64)?;
//! canvas.draw(edge.edges(LineStyle::HAIRLINE), &projection, &Flat::new(BinaryColor::On));
//! let drawn: Vec<usize> = (0..64 * 64).filter(|&at| pixels[at].is_on()).collect();
//! // From row 32 · (1 − ¼) to row 32 · (1 + ½).
//! assert_eq!((drawn[0] / 64, drawn[drawn.len() - 1] / 64), (24, 48));
//! # Ok::<(), Error>(())
//! ```
//!
//! **The other planes of the frustum clip in the same way.** The right plane is *x* = *w* in clip space, and the
//! distance from it is *d* = *w* − *x*. A matrix computes *x* and *w*, so they are linear in space, and *d* is linear,
//! too. If the inside end is *d*₀ inside the plane, and the outside end is *d*₁ outside, *t* = *d*₀/(*d*₀ + *d*₁). To
//! clip a polygon, walk around it (Sutherland and Hodgman): keep each corner that is inside, and insert a new corner on
//! each edge that crosses the plane. Then clip the result by the next plane. A plane cuts the outline of a triangle at
//! most twice, so each plane adds at most one corner.
//!
//! # A shared cut
//!
//! **Cut every edge from its inside end to its outside end.** Two triangles that share an edge walk along it in
//! opposite directions. In exact arithmetic, that does not matter: *t* from one end and 1 − *t* from the other end are
//! the same point. Rounded, they differ. Take an edge from 0 (inside) to 1000 (outside) that is cut at a third, with
//! *t* in units of 1/256, and all results rounded down:
//!
//! | from | *t* | step | new corner |
//! |---|---:|---:|---:|
//! | the inside end | 85/256 | 332 | 332 |
//! | the outside end | 170/256 | −665 | 335 |
//!
//! If each triangle used its own direction, their new corners would be 3 apart (332 and 335), and the background would
//! be seen through the crack. If both triangles begin at the inside end, they compute the same numbers by the same
//! steps, and get the same corner to the last bit. The rounding error is still there, but it moves both triangles by
//! the same amount.
//!
//! ```
//! let floor = |a: i32, b: i32| a.div_euclid(b);
//! let cut = |from: i32, to: i32, d0: i32, d1: i32| {
//!     let t = floor(256 * d0, d0 + d1);
//!     let step = floor((to - from) * t, 256);
//!     (t, step, from + step)
//! };
//! assert_eq!(cut(0, 1000, 1, 2), (85, 332, 332));
//! assert_eq!(cut(1000, 0, 2, 1), (170, -665, 335));
//! ```
//!
//! An edge can cross two planes. Both triangles must then use the planes in the same order, and an edge must be cut
//! only by planes that it crosses itself. Then a new corner on the shared edge depends only on the two ends of this
//! edge, never on the third corner of a triangle.
//!
//! Tests: `accuracy/formulas/clipping.rs`; clipped meshes without cracks in `accuracy/clipping.rs`, clipped attributes
//! in `accuracy/clipped_values.rs`. Unit tests: shared edges in `src/pipeline/clip.rs`.
//!
//! Next page: [Lines](crate::guide::mathematics::lines#lines).
#![cfg_attr(doc, doc = include_str!("../tables.html"))]
