//! Pixels: attributes with one reciprocal per pixel, the depth that a pixel stores, and the mip level that it shows.
//!
//! The [first page](crate::guide::mathematics) of this chapter says where the axes x, y and z point, and defines the
//! letters *n* and *f*.
//!
//! # An attribute
//!
//! **Across a triangle, 1/*w* and *a*/*w* are linear on the screen, as they are along a
//! [segment](crate::guide::mathematics::lines#a-segment).** This holds for every attribute *a* that is linear across
//! the triangle in space: position, texture coordinates, color, normal, light.
//!
//! The triangle lies in a plane *k* · (*x*, *y*, *z*) = *c*. If *c* were 0, the eye would be in the plane, and the
//! triangle would not be seen. A point of the triangle has the [image](crate::guide::mathematics::projection#a-point)
//! (*x*′, *y*′) on the near plane, so *x* = *x*′*w*/*n*, *y* = *y*′*w*/*n* and *z* = −*w*. Substitute these values, and
//! divide by *c* *w*:
//!
#![doc = formula!({frac(1)(w) = frac(k[x] prime(x) + k[y] prime(y) - n k[z])(c n)})]
//!
//! In the triangle's plane, the attribute is *a* = *g* · (*x*, *y*, *z*) + *d*, with a vector *g* and a number *d*.
//! Divide *a* by *w*: the first term becomes linear in *x*′ and *y*′ by the same substitution, and *d*/*w* is linear
//! because 1/*w* is.
//!
//! The value of a linear function at a point is the mean of its values at the corners, weighted with the point's
//! barycentric coordinates on the screen. The weight of a corner is proportional to the area of the triangle that the
//! point forms with the opposite side, and *α* + *β* + *γ* = 1 ([An
//! area](crate::guide::mathematics::triangles#an-area)). Hence
//!
#![doc = formula!({a = frac
    (var "α" a[0] / w[0] + var "β" a[1] / w[1] + var "γ" a[2] / w[2])
    (var "α" / w[0] + var "β" / w[1] + var "γ" / w[2])
})]
//!
#![doc = include_str!("../diagrams/weights.svg")]
//!
//! **A pixel needs one division.** Along a row of pixels, a linear function changes by the same amount from pixel to
//! pixel. So *Q* = 1/*w* and each *P* = *a*/*w* take one addition per pixel. But the quotient *P*/*Q* does not change
//! by the same amount: if *Q* takes the values 1, ¾, ½ and ¼, then *w* takes the values 1, 1⅓, 2 and 4. So additions
//! alone cannot produce the quotient. A small processor takes far longer for a division than for a product. Therefore
//! divide once, *r* = 1/*Q*, and multiply each *P* by *r*: one reciprocal per pixel serves all attributes.
//!
//! **Additions repeat their rounding error.** The step from pixel to pixel is rounded once. After 300 pixels, this
//! error has been added 300 times. So *P* and *Q* need about 9 more bits than the result: 300 errors of one unit add up
//! to less than 2⁹ = 512 units. fixel computes the steps of large triangles in 64 bits.
//!
//! ```
//! use embedded_graphics::pixelcolor::{Gray8, GrayColor, Rgb888, RgbColor};
//! use fixel::mode::{Affine, Mode, Newton};
//! use fixel::{Fraction, prelude::*, textbook::Segment};
//!
//! // At distances 1, 2 and 4. The images (−½, −½), (½, −½) and (0, 1) have the mean (0, 0).
//! let corners = [vec3!(-0.5, -0.5, -1), vec3!(1, -1, -2), vec3!(0, 4, -4)];
//! let colors = [Rgb888::BLACK, Rgb888::BLACK, Rgb888::new(252, 252, 252)];
//! let mesh = Mesh::new(&corners, &[[0, 1, 2]])?.with_colors(&colors, None)?;
//! let projection = Projection::perspective(deg!(90), (1, 1), fx!(0.5), fx!(10))?;
//!
//! fn middle(mode: impl Mode, mesh: &Mesh, projection: &Projection) -> Result<u8, Error> {
//!     let mut pixels = [Gray8::BLACK; 65 * 65];
//!     let options = DrawOptions::new().with_mode(mode);
//!     let mut canvas = Canvas::new(&mut pixels, 65, 65)?;
//!     canvas.draw_with(&options, mesh, projection, &Gouraud::new());
//!     Ok(pixels[32 * 65 + 32].luma())
//! }
//! // At (0, 0), all weights are ⅓: (252/4) / (1 + ½ + ¼) = 36. Without w it would be 252/3.
//! assert_eq!(middle(Newton::default(), &mesh, &projection)?, 36);
//! assert_eq!(middle(Affine, &mesh, &projection)?, 84);
//!
//! // Q at thirds of the way is 1, ¾, ½ and ¼.
//! let segment = Segment::new(fx!(1), fx!(4)).unwrap();
//! let w = |thirds| segment.distance(Fraction::ONE / 3 * thirds).unwrap();
//! assert_eq!([0, 1, 2, 3].map(w), [fx!(1), fx!(1.333333), fx!(2), fx!(4)]);
//! # Ok::<(), Error>(())
//! ```
//!
//! Tests: `accuracy/formulas/triangle.rs`; other attributes, and triangles of all shapes, in `accuracy/varyings.rs`.
//!
//! # A depth step
//!
//! **At the distance *w*, a depth buffer of 16 bits tells two surfaces apart if the distance between them is at least
//! *w*²/(65535 *n*).** The buffer stores the depth *D* = 65535 *n*/*w*, rounded down. Its derivative says how much *D*
//! changes when *w* changes by a small Δ*w*. Set the change of *D* to one step:
//!
#![doc = formula!({D = frac(65535 n)(w)} {frac(d D)(d w) = -frac(65535 n)(w^2)} {var "Δ" w = frac(w^2)(65535 n)})]
//!
//! So a step grows with the **square** of the distance. Relative to the distance, it is *w*/(65535 *n*): 1 % at 655
//! times the near plane's distance. So this depth buffer has [a limit for far/near](crate::guide::concepts#depth).
//!
//! By hand, with *n* = 1 and *w* = 1000: *D* = 65.535, so the buffer stores 65. The formula gives a step of
//! 1,000,000/65,535 = 15.3. The exact ends of the step are 65535/66 = 993.0 and 65535/65 = 1008.2. Two surfaces at the
//! distances 995 and 1005 have the same stored depth. With *n* = 2, their depths are 131 and 130. **With the near plane
//! twice as far away, all steps are half as large.**
//!
//! | distance *w* | stored depth | nearest | farthest with this depth | *w*²/65535 |
//! |---:|---:|---:|---:|---:|
//! | 10 | 6553 | 9.9992 | 10.0008 | 0.0015 |
//! | 100 | 655 | 99.9 | 100.1 | 0.15 |
//! | 300 | 218 | 299.2 | 300.6 | 1.4 |
//! | 1000 | 65 | 993.0 | 1008.2 | 15.3 |
//!
//! ```
//! use fixel::canvas::LinearDepth;
//! use fixel::prelude::*;
//!
//! let screen = Viewport::new(0, 0, 2, 2)?;
//! let depths = |near| -> Result<_, Error> {
//!     let projection = Projection::perspective(deg!(90), (1, 1), near, fx!(2000))?;
//!     let at = |z| screen.project(Vec3::from_ints(0, 0, z), &projection);
//!     Ok([-995, -1005].map(|z| at(z).unwrap().depth::<LinearDepth>()))
//! };
//! assert_eq!(depths(fx!(1))?, [65, 65]);
//! assert_eq!(depths(fx!(2))?, [131, 130]);
//! # Ok::<(), Error>(())
//! ```
//!
//! A step of [`FloatDepth`](crate::canvas::FloatDepth) is about the same share of the distance everywhere.
//!
//! Tests: `accuracy/formulas/pixel.rs`; depths of random triangles: `accuracy/promises.rs`.
//!
//! # A mip level
//!
//! **Level *k* of a mipmap suits a pixel that covers 2<sup>*k*</sup> texels.** A texel of level *k* is the mean of
//! 2<sup>*k*</sup>x2<sup>*k*</sup> texels of level 0. So the level is the logarithm, with base 2, of the number of
//! texels from one pixel to the next.
//!
//! Take a floor at the height *h* below the eye, and let *F* be the focal length in pixels. By similar triangles, the
//! floor at the distance *w* is seen *y* = *Fh*/*w* rows below the horizon. From column to column, the floor advances
//! by *w*/*F*. From row to row, it advances by the derivative of *w* = *Fh*/*y*, which is negative because *w* falls as
//! *y* grows:
//!
#![doc = formula!({-frac(d w)(d y) = frac(F h)(y^2) = frac(w^2)(F h) = frac(w)(F) dot frac(w)(h)})]
//!
//! The first factor, *w*/*F*, is the width that a pixel covers at the distance *w*. The second factor, *w*/*h*, says
//! how many times longer the covered piece of floor is along the line of sight. With *m* texels per unit of length:
//!
#![doc = formula!({level = log[2] (m dot frac(w)(F) dot frac(w)(h))})]
//!
//! For another plane, *h* is the distance of the eye from the plane. The level suits the direction along the line of
//! sight, in which the texture is foreshortened most. Across the line of sight, a pixel covers only *m* *w*/*F* texels.
//! In this direction, a lower level with smaller texels would be enough, so the picture is softer than necessary.
//!
//! By hand: *m* = 64, *F* = 160, *h* = 1. The floor at the distance 5 is seen 160/5 = 32 rows below the horizon.
//! Across, a pixel covers 64 · 5/160 = 2 texels. Along the line of sight, it covers five times as many, 10 texels. The
//! level is log₂ 10 = 3.32. The nearest level is 3, in which each texel is a mean of 8x8 texels. The table continues:
//!
//! | rows below the horizon | distance | texels across | texels along | level | nearest level |
//! |---:|---:|---:|---:|---:|---:|
//! | 80 | 2 | 0.8 | 1.6 | 0.68 | 1 |
//! | 64 | 2.5 | 1.0 | 2.5 | 1.32 | 1 |
//! | 32 | 5 | 2.0 | 10.0 | 3.32 | 3 |
//! | 16 | 10 | 4.0 | 40.0 | 5.32 | 5 |
//!
//! Without mipmaps, a pixel at the distance 10 would show one of 4x40 texels by chance, and another one in the next
//! frame: the floor would flicker. With mipmaps, the pixel shows a mean:
//!
#![cfg_attr(doc, doc = page_picture!("mipmapped", "A tiled floor: the left half without mipmaps flickers in the distance, the right half is even"))]
//! The page of [`Textured::mipmapped`](crate::Textured::mipmapped) gives the accuracy and the cost of mipmaps.
//!
//! Tests: `accuracy/formulas/pixel.rs`; pictures with mipmaps in `accuracy/mipmap.rs`.
//!
//! Next page: [Fixed point](crate::guide::mathematics::fixed_point#fixed-point).
#![cfg_attr(doc, doc = include_str!("../tables.html"))]
