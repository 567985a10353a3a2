//! The guide: from concepts to firmware.
//!
//! Read the pages in this order, or go straight to your question. The tests compile every program on these pages, and
//! run each program that can run on a computer.
//!
//! 1. **[Concepts](concepts)**: mesh, projection, camera, shader, options, canvas, depth and band, with diagrams;
//!    how to write numbers; and what to check when the scene is wrong.
//! 2. **[Coming from](coming_from)** OpenGL, tgx, embedded-3dgfx or small3dlib: fixel's name for each term of these
//!    libraries, and what fixel does differently. Skip this page if you know none of these libraries.
//! 3. **[Cookbook](cookbook)**: short programs, each with its picture and its cost. Each program shows one idea.
//! 4. **[Firmware](firmware)**: from `cargo new` to a panel on SPI, with bands and DMA.
//! 5. **[Displays](displays)**: programs for round panels, electronic paper, OLEDs, and panels with 18 bits per pixel;
//!    how to send only a window of the frame, how to avoid tearing, and how to keep two frames in memory.
//! 6. **[Mathematics](mathematics)**: ten pages, from a vertex to its pixels. Every formula is derived, and a
//!    program checks it.
//! 7. **[Choosing a mode](modes)**: the speed and the error of each mode of interpolation, and how the bound of each
//!    error is derived.
//! 8. **[Limits](limits)**: the range of each quantity, and what happens beyond it.
//! 9. **[Benchmarks](benchmarks)**: what drawing costs, compared with other libraries.
#![cfg_attr(doc, doc = page_picture!("shaders", "Balls in eight shaders"))]

/// Writes a program for a display. Use it under `cfg(not(doctest))`: the program would not compile here, because it
/// needs a driver. The package `cookbook` compiles and tests the program.
macro_rules! program {
    ($name:literal) => {
        concat!(
            "```\n",
            include_str!(concat!(
                "../../examples/cookbook/src/displays/",
                $name,
                ".rs"
            )),
            "```\n"
        )
    };
}

#[macro_use]
mod formula;
#[macro_use]
mod recipe;

pub mod concepts;
pub mod cookbook;
pub mod mathematics;

/// If you know OpenGL, tgx, embedded-3dgfx or small3dlib, this page gives fixel's name for each term of that library,
/// and says what fixel does differently.
///
#[cfg_attr(doc, doc = include_str!("diagrams/axes.svg"))]
///
#[doc = include_str!("coming_from.md")]
#[cfg_attr(doc, doc = include_str!("tables.html"))]
pub mod coming_from {}

/// This page leads from `cargo new` to a picture on a panel: firmware for a small chip and a 240x240 display on SPI.
///
#[cfg_attr(doc, doc = page_picture!("firmware", "The program of this page: a spinning ring with a caption"))]
#[doc = include_str!("firmware.md")]
#[cfg_attr(doc, doc = include_str!("tables.html"))]
pub mod firmware {}

pub mod displays;

/// A mode is the method that interpolates textures and colors across a triangle. This page says which mode suits which
/// scene and processor core, how large an error to expect, and how the bound of each error is derived.
///
#[doc = concat!("<div>", include_str!("diagrams/trade.svg"), "</div>\n")]
#[cfg_attr(doc, doc = page_picture!("modes", "A floor of two triangles: bent by Affine, straight by Newton"))]
#[doc = include_str!("modes.md")]
#[cfg_attr(doc, doc = include_str!("tables.html"))]
pub mod modes {}

/// This page gives the cost of drawing in instructions and bytes, measured in the same way for fixel and for similar
/// libraries. It also says where other libraries are ahead, and how to repeat the measurements.
///
#[cfg_attr(doc, doc = page_picture!("measured", "The measured scenes: floor, cube, smooth sphere, flat sphere"))]
#[doc = include_str!("benchmarks.md")]
#[cfg_attr(doc, doc = include_str!("tables.html"))]
pub mod benchmarks {}

/// For each quantity (coordinates, distances, sizes, angles), this page gives the range in which accuracy is promised,
/// the behavior beyond this range, and the errors measured at the ends of the range.
///
#[doc = include_str!("limits.md")]
#[doc = include_str!("diagrams/reach.svg")]
///
#[doc = include_str!("ranges.md")]
#[doc = include_str!("extremes.md")]
#[cfg_attr(doc, doc = include_str!("tables.html"))]
pub mod limits {}
