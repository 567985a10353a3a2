//! Triangles: which pixels a triangle covers, and which of two triangles gets a pixel on their shared edge.
//!
//! All positions on this page are on the screen: x points to the right, and y points **down**. A pixel belongs to a
//! triangle if the triangle covers the pixel's center. Column 3 of row 2 has its center at (3.5, 2.5).
//!
//! # An edge
//!
//! **An edge function says on which side of an edge a point lies.** For the edge from *a* to *b* and the point *p*:
//!
#![doc = formula!({E[a b] (p) = (b[x] - a[x]) (p[y] - a[y]) - (b[y] - a[y]) (p[x] - a[x])})]
//!
//! This is the cross product of *b* − *a* and *p* − *a*: the length of the edge times the distance of *p* from the
//! line, with a sign. On the line, the function is zero. It is positive on the right-hand side of someone who walks
//! from *a* to *b*. In the other direction, from *b* to *a*, left and right are exchanged, and the function has the
//! opposite sign.
//!
//! An edge function is linear in *p*: one column to the right, it grows by the y of *a* minus the y of *b*; one row
//! down, it grows by the x of *b* minus the x of *a*.
//!
//! # An area
//!
//! **The edge functions of the three edges add up to twice the area of the triangle, at every point:**
//!
#![doc = formula!({E[a b] (p) + E[b c] (p) + E[c a] (p) = E[a b] (c) = 2 A})]
//!
//! In the sum, *p* is multiplied by the three sides of the triangle, which add up to zero as vectors. So the sum is the
//! same everywhere. At *p* = *c*, only the first term is left: base times height. Divide each edge function by 2*A*:
//! the three quotients add up to 1. They are the barycentric coordinates of *p*, the weights with which
//! [attributes](crate::guide::mathematics::pixels#an-attribute) are interpolated.
//!
//! The area has a sign. It is positive if the corners run clockwise on the screen. Front faces run counter-clockwise,
//! so a triangle with a positive area shows its back, and is culled.
//!
//! A point is inside a triangle if the three edge functions have the same sign.
//!
//! # A shared edge
//!
//! **If a center lies exactly on an edge, the triangle owns the pixel only if the edge is a left edge or a top edge.**
//! A left edge has the triangle on its right. A top edge is level, and has the triangle below it. This is the top-left
//! rule.
//!
//! Why is a rule needed? Two triangles lie on the two sides of the edge that they share. At a center beside the edge,
//! the edge function is positive for one triangle and negative for the other. So one of them draws the pixel. At a
//! center on the edge, the function is zero for both. If zero counted as inside, both would draw the pixel, and glass
//! would have a bright seam. If zero counted as outside, the background would show. By the rule, exactly one triangle
//! draws the pixel: the left edge of one triangle is the right edge of the other, and the top edge of one is the bottom
//! edge of the other.
//!
//! Why does the rule also decide at a corner, where many triangles meet? Move all centers by an infinitely small step
//! to the right, and down by a step that is far smaller still. Now no center is on an edge, and each center is in
//! exactly one triangle. The move takes centers on a left or a top edge into the triangle, and centers on all other
//! edges out of it. So the moved centers and the rule give the same answers.
//!
//! By hand: a square from (1.5, 1.5) to (5.5, 5.5) has two triangles, both clockwise. The orange one has the corners
//! (1.5, 1.5), (5.5, 1.5), (1.5, 5.5), and the blue one (5.5, 1.5), (5.5, 5.5), (1.5, 5.5). The center (3.5, 3.5) is on
//! the diagonal. In the blue triangle, the diagonal runs from *a* = (1.5, 5.5) to *b* = (5.5, 1.5), and its edge
//! function is 4 · (−2) − (−4) · 2 = 0. The other two edge functions are 8 and 8. The sum is 16, twice the triangle's
//! area of 8. The diagonal is the blue triangle's left edge, so the blue triangle owns the pixel.
//!
#![doc = include_str!("../diagrams/shared_edge.svg")]
//!
//! The dots are centers. Of the square's 16 pixels, the orange triangle has 10 and the blue one 6. The centers on the
//! square's right and bottom edges belong to neither. The program adds 1 for a pixel of the orange triangle and 2 for a
//! pixel of the blue one. A pixel that both drew would be a 3:
//!
//! ```
//! use embedded_graphics::pixelcolor::{Gray8, GrayColor};
//! use fixel::canvas::Add;
//! use fixel::prelude::*;
//! use fixel::Window;
//!
//! let [a, b] = [vec3!(1.5, -1.5, 0), vec3!(5.5, -1.5, 0)];
//! let [c, d] = [vec3!(1.5, -5.5, 0), vec3!(5.5, -5.5, 0)];
//! // A unit is a pixel, and y points up.
//! let window = Window { left: fx!(0), right: fx!(7), bottom: fx!(-7), top: fx!(0) };
//! let projection = Projection::orthographic(window, fx!(-1), fx!(1))?;
//! let options = DrawOptions::new().with_cull(Cull::Nothing).with_blending(Add);
//! let mut pixels = [Gray8::BLACK; 7 * 7];
//! let mut canvas = Canvas::new(&mut pixels, 7, 7)?;
//! for (corners, gray) in [([a, b, c], 1), ([b, d, c], 2)] {
//!     let mesh = Mesh::new(&corners, &[[0, 1, 2]])?;
//!     canvas.draw_with(&options, &mesh, &projection, &Flat::new(Gray8::new(gray)));
//! }
//! let rows = pixels.chunks(7).map(|row| row.iter().map(|pixel| pixel.luma().to_string()).collect());
//! let rows: Vec<String> = rows.collect();
//! assert_eq!(
//!     rows,
//!     ["0000000", "0111100", "0111200", "0112200", "0122200", "0000000", "0000000"],
//! );
//! # Ok::<(), Error>(())
//! ```
//!
//! **All of this must be exact.** Rounded edge functions of a shared edge could be a little above zero in both
//! triangles. fixel rounds the corners to 1/256 pixel first. Then all numbers are integers: differences of positions
//! have at most 21 bits, their products 42, and nothing is rounded any more. Neighbors round a shared corner in the
//! same way, so they have the same edge.
//!
//! **fixel does not compute three edge functions for every pixel.** In each row, it needs only two columns: the first
//! with its center on the left edge or to the right of it, and the first with its center on the right edge or to the
//! right of it. The triangle covers the columns from the first of these up to, but *not* including, the second, as the
//! top-left rule demands. The rows are found in the same way. From row to row, an edge moves sideways by its width
//! divided by its height. fixel divides once for each edge, and then adds the quotient and the remainder in each row,
//! so the positions remain exact.
//!
//! Tests: `accuracy/formulas/coverage.rs`; all kinds of meshes in `accuracy/coverage.rs`. Unit tests: edges in
//! `src/raster/edge.rs`, whole triangles in `src/raster/triangle.rs`.
//!
//! Next page: [A share](crate::guide::mathematics::coverage#a-share).
