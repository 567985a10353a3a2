//! Light: how the normals, the lights and the eye determine the brightness at the corners of triangles.
//!
//! All vectors on this page are in world space. The vectors *n* (the normal), *l* (toward the light) and *v* (toward
//! the eye) have the length one.
//!
//! # A normal
//!
//! **If a matrix *M* transforms a surface, the transpose of its inverse transforms the surface's normals.** A normal
//! *n* is at right angles to each direction *d* along the surface: *n*<sup>T</sup>*d* = 0. The directions become *Md*.
//! We look for a matrix *N* for which the normals *Nn* are at right angles to all *Md*:
//!
#![doc = formula!({(N n)^T M d = n^T N^T M d = 0} {N^T M = I} {N = (M^{-1})^T})]
//!
//! If *N*<sup>T</sup>*M* is the identity *I*, the product is *n*<sup>T</sup>*d*, which is zero. A rotation is the
//! transpose of its inverse, so rotations turn normals like points. The difference shows when a model is stretched:
//!
#![doc = include_str!("../diagrams/stretched.svg")]
//!
//! By hand: a roof with the normal (1, 0, 1) contains the direction (1, 0, −1). Stretch x to twice its length. The
//! direction becomes (2, 0, −1). With *M*, the normal would become (2, 0, 1), and its dot product with the direction
//! would be 3. The transpose of the inverse halves x: the normal becomes (½, 0, 1), and the dot product is 1 − 1 = 0.
//!
//! Light from (1, 0, 2) falls squarely on the stretched roof, so the roof has full brightness. With the wrong normal,
//! the cosine would be 4/5, and a white roof would be drawn with 204 in place of 255:
//!
//! ```
//! use embedded_graphics::pixelcolor::{Gray8, GrayColor};
//! use fixel::prelude::*;
//! use fixel::Window;
//!
//! let corners = [vec3!(1, -1, -1), vec3!(1, 1, -1), vec3!(-1, 1, 1), vec3!(-1, -1, 1)];
//! let roof = Mesh::new(&corners, &[[0, 1, 2], [0, 2, 3]])?;
//! let normals = [vec3!(1, 0, 1); 4];
//! let roof = roof.with_normals(&normals, None)?;
//! let projection = Projection::orthographic(Window::centered(fx!(4), fx!(2)), fx!(0), fx!(4))?;
//! let stretched = Transform::scale_axes(vec3!(2, 1, 1));
//! let mvp = projection * Camera::front(Vec3::ZERO, fx!(2)) * stretched;
//! let sun = Light::new(vec3!(1, 0, 2), fx!(0), fx!(1))?;
//! let mut pixels = [Gray8::BLACK; 1];
//! Canvas::new(&mut pixels, 1, 1)?.draw(&roof, &mvp, &Flat::new(Gray8::WHITE).lit(sun));
//! assert_eq!(pixels, [Gray8::WHITE]);
//! # Ok::<(), Error>(())
//! ```
//!
//! The inverse need not be computed. If *x*, *y* and *z* are the rows of *M*, the rows of *N* are *y* × *z*, *z* × *x*
//! and *x* × *y*, divided by the determinant. A normal is scaled to length one afterward, so only the sign of the
//! determinant matters. It is negative if *M* mirrors.
//!
//! # Matte surfaces
//!
//! **A matte surface is as bright as the cosine of the angle between its normal and the light (Lambert).** A beam of
//! light with a width of 1 falls on a strip of the surface. If the light comes at the angle φ from the normal, the
//! strip has the width 1/cos φ. The same light on a wider strip is weaker:
//!
#![doc = formula!({brightness = fun max (0, n dot l) = fun max (0, fun cos var "φ")})]
//!
//! A matte surface looks equally bright from all sides, so the eye is not in the formula. If *n* · *l* is negative, the
//! light is behind the surface.
//!
//! | φ | width of the strip | brightness |
//! |---:|---:|---:|
//! | 0° | 1.000 | 1.000 |
//! | 30° | 1.155 | 0.866 |
//! | 60° | 2.000 | 0.500 |
//! | 80° | 5.759 | 0.174 |
//! | 120° | none | 0.000 |
//!
//! By hand: the sun is in the direction (0, 4, 3), so *l* = (0, 0.8, 0.6). The ground has *n* = (0, 1, 0), and *n* ·
//! *l* = 0.8. With a sun of strength 0.5 and ambient light (from all sides) of strength 0.25, the brightness is 0.25 +
//! 0.5 · 0.8 = 0.65:
//!
//! ```
//! use fixel::math::Direction;
//! use fixel::prelude::*;
//!
//! let sun = Light::new(vec3!(0, 4, 3), fx!(0.25), fx!(0.5))?;
//! let brightness = f64::from(sun.brightness(Direction::of(Vec3::Y))) / 65536.0;
//! assert!((brightness - 0.65).abs() < 1e-5);
//! # Ok::<(), Error>(())
//! ```
//!
//! # Highlights
//!
//! **A shiny surface mirrors the light, and blurs the mirror image (Phong).** The mirror image of *l* is the direction
//! *r*. Split *l* into its part along the normal, (*n* · *l*) *n*, and the rest. A mirror keeps the first part, and
//! reverses the rest:
//!
#![doc = formula!({r = 2 (n dot l) n - l} {highlight = (fun max (0, r dot v))^e})]
//!
//! The larger the exponent *e*, the smaller the highlight. **Blinn uses the direction *h* halfway between *l* and *v*
//! instead:**
//!
#![doc = formula!({h = frac(l + v)(|l + v|)} {highlight = (fun max (0, n dot h))^e})]
//!
#![doc = include_str!("../diagrams/halfway.svg")]
//!
//! If the eye looks exactly along the mirrored light, *v* = *r*, then *l* + *v* = 2 (*n* · *l*) *n*. So *h* = *n*, and
//! both formulas give 1. Turn *v* away from *r* by an angle α, in the plane of *l* and *n*. Then *h* turns by only α/2.
//! For small angles, cos α is about 1 − α²/2, and its power about 1 − *e* α²/2. With half the angle, Blinn needs **four
//! times the exponent** for a highlight of the same size:
//!
//! | α | Phong, *e* = 8 | Blinn, *e* = 32 |
//! |---:|---:|---:|
//! | 0° | 1.000 | 1.000 |
//! | 10° | 0.885 | 0.885 |
//! | 20° | 0.608 | 0.613 |
//! | 30° | 0.316 | 0.330 |
//! | 40° | 0.119 | 0.137 |
//!
//! fixel uses Blinn's formula. At grazing angles, Blinn's highlights become long and narrow, as on real surfaces;
//! Phong's highlights stay round.
//!
//! By hand: *n* = *v* = (0, 0, 1), and the light is at *l* = (0.6, 0, 0.8). Then *r* = (−0.6, 0, 0.8) and *r* · *v* =
//! 0.8. The sum *l* + *v* = (0.6, 0, 1.8) has the length √3.6, so (*n* · *h*)² = 1.8²/3.6 = 0.9. With *e* = 8, Phong's
//! highlight is 0.8⁸ = 0.168, and Blinn's is 0.9⁴ = 0.656:
//!
//! ```
//! use fixel::math::Direction;
//! use fixel::prelude::*;
//! use fixel::shade::{SurfacePoint, Viewer};
//!
//! let ahead = Direction::of(Vec3::Z);
//! let point = SurfacePoint { normal: ahead, face: ahead, position: Vec3::ZERO };
//! let sun = Light::new(vec3!(3, 0, 4), fx!(0), fx!(1))?;
//! let light = sun.shiny(Viewer::toward(Vec3::Z)?, 8, fx!(1))?.at(&point);
//! assert!((f64::from(light.diffuse) / 65536.0 - 0.8).abs() < 1e-4);
//! assert!((f64::from(light.specular) / 65536.0 - 0.9_f64.powi(4)).abs() < 1e-4);
//! # Ok::<(), Error>(())
//! ```
//!
#![cfg_attr(doc, doc = page_picture!("shiny", "A ring with highlights"))]
//! fixel computes light at the corners of a triangle, and interpolates the brightness (Gouraud). "Phong shading" is not
//! Phong's highlight: it interpolates the normal, and computes the light at each pixel. Interpolated brightness cannot
//! show a highlight in the middle of a triangle, so shiny meshes must be fine.
//!
//! Tests: `accuracy/formulas/light.rs`; all lights on whole meshes in `accuracy/lights.rs`.
//!
//! Next page: [An attribute](crate::guide::mathematics::pixels#an-attribute).
#![cfg_attr(doc, doc = include_str!("../tables.html"))]
