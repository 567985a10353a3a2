//! Each program on this page drives a display through a driver of another project. You can copy the one that fits your
//! panel, and change its scene. The programs are generic over bus and pins (embedded-hal), so they compile for your
//! computer and for your chip. The project's tests record what each program sends, and feed it to a model of the
//! controller, written from its data sheet. The model must show the picture that is on the canvas. None of them has run
//! on a real panel yet.
//!
//! | program | panel | driver, and the version it was tried with |
//! |---|---|---|
//! | [A window of the frame](#a-window-of-the-frame) | ST7789, 240x240 | mipidsi 0.10; any `DrawTarget` will do |
//! | [A round panel](#a-round-panel) | GC9A01, 240x240 | mipidsi 0.10; any `DrawTarget` will do |
//! | [Electronic paper](#electronic-paper) | SSD1680, 122x250 | epd-waveshare 0.6 |
//! | [An OLED without a second buffer](#an-oled-without-a-second-buffer) | SSD1306, 128x64 | ssd1306 0.10, display-interface-spi 0.5 |
//! | [18 bits a pixel](#18-bits-a-pixel) | ILI9488, 480x320 | mipidsi 0.10 |
//! | [Words of 16 bits](#words-of-16-bits) | ILI9341, 320x240 | ili9341 0.6, display-interface-spi 0.5 |
//! | [No tearing](#no-tearing) | ST7789, 240x240 | mipidsi 0.10 |
//! | [Two frames](#two-frames) | ST7789, 240x240 | lcd-async 0.1, embassy-futures 0.1 |
//!
//! [Firmware](crate::guide::firmware) shows the same for a whole chip: DMA, two cores, and Embassy and RTIC.
//!
#![doc = display_picture!("A window of the frame", "window")]
//! Most of a dashboard stands still. If you know where something moves, draw only that window (yellow), and send only
//! its pixels: here a ninth of the frame.
//!
//! Give a canvas of the window's size the viewport of the whole frame, moved left and up by the window's corner. The
//! canvas then shows that window. It covers the same pixels as the frame; interpolated colors and texture coordinates
//! agree within the [mode's](crate::guide::modes) error, because a row of pixels begins at the window's edge. The
//! pattern of [ordered dithering](crate::shade::PixelFormat) begins at the corner of the canvas. For dithered colors,
//! let the coordinates of the window's corner be multiples of 8. embedded-graphics draws into the window and sends it
//! with `translated`. The window must contain the moving thing both where it was and where it is now;
//! [`Canvas::project`](crate::Canvas::project) tells where points are.
//!
#![doc = display_program!("window")]
//!
#![doc = display_picture!("A round panel", "round")]
//! Nobody sees the corners of a round panel. A circle leaves a fifth of its square empty; with bands of 16 rows, each
//! as wide as the circle is there (right), 15 % of the pixels are neither drawn nor sent. Bands of fewer rows save
//! more, but transform the mesh more often.
//!
#![doc = display_program!("round")]
//!
#![doc = display_picture!("Electronic paper", "epaper")]
//! A full refresh of electronic paper flashes, and takes seconds. A quick one takes a third of a second, and drives
//! only the pixels that differ from the picture before: on the right, the red ones to black and the blue ones to white.
//! So the picture should differ only where something moved. Ordered dithering keeps its pattern in place; [error
//! diffusion](crate::canvas::ErrorDiffusion) looks better, but a small change alters pixels everywhere below it: use it
//! for pictures that get a full refresh. Paper also needs a full refresh now and then, to remove what quick ones leave:
//! the panel's data sheet says how often.
//!
#![doc = display_program!("epaper")]
//!
#![doc = display_picture!("An OLED without a second buffer", "oled")]
//! The driver's buffered mode keeps a frame of 1 KiB, into which a canvas would be copied. Its basic mode takes the
//! panel's own bytes, which [`Canvas::pages`](crate::Canvas::pages) makes: a byte for 8 rows of a column.
//!
#![doc = display_program!("oled")]
//!
#![doc = display_picture!("18 bits a pixel", "ili9488")]
//! On SPI, an ILI9488 cannot take 16 bits a pixel. A canvas of `Rgb888` in `BigEndian` bytes has the three bytes that
//! the panel wants, so that a DMA channel can send them as they are. The driver sets the panel up, and opens the
//! window.
//!
#![doc = display_program!("ili9488")]
//!
#![doc = display_picture!("Words of 16 bits", "ili9341")]
//! Some drivers and buses take words. A canvas in [`Words`](crate::canvas::Words) is a slice of `u16`, which needs no
//! conversion.
//!
#![doc = display_program!("ili9341")]
//!
#![doc = display_picture!("No tearing", "tearing")]
//! The panel reads its memory 60 times a second. If a frame arrives while it reads, it shows the upper part of one
//! frame and the lower part of another: a tear (left). The panel's output TE tells when it begins to read.
//!
//! Which of the two is faster decides when to start. If the bus takes longer to send a frame than the panel takes to
//! read it, start as soon as the panel has begun to read (TE falls). Finish before its next pass catches up with you.
//! If the bus is faster, start when the panel has finished (TE rises). A frame must be in memory as a whole, because
//! drawing between bands would make it late. Panels read in the direction of their longer side, so a rotated panel
//! cannot be kept from tearing in this way.
//!
#![doc = display_program!("tearing")]
//!
#![doc = display_picture!("Two frames", "frames")]
//! While one buffer is sent, the next frame is drawn into the other buffer. Two frames of 240x240 pixels take 225 KiB:
//! too much for a Pico beside all else, but not for the PSRAM on many boards with an RP2350. Depth should stay in fast
//! memory, because each pixel reads and writes it several times.
//!
#![doc = display_program!("frames")]
//!
//! On a board with PSRAM, such as a Pimoroni Pico Plus 2, embassy-rp 0.10 makes the two frames' memory:
//!
//! ```ignore
//! use embassy_rp::{psram, psram::Psram, qmi_cs1::QmiCs1};
//!
//! let chip_select = QmiCs1::new(p.QMI_CS1, p.PIN_47);
//! let psram = Psram::new(chip_select, psram::Config::aps6404l()).unwrap();
//! // SAFETY: the PSRAM has 8 MB, and nothing else uses it.
//! let memory: &'static mut [[u8; 2]] =
//!     unsafe { slice::from_raw_parts_mut(psram.base_address().cast(), 2 * PIXELS) };
//! let (first, second) = memory.split_at_mut(PIXELS);
//! ```
//!
// So rows of 100 columns fit the page.
//! <style>.docblock pre.rust { font-size: 15px }</style>
