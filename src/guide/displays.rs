//! Each program on this page drives a display through a driver from another project. You can copy the program that fits
//! your panel, and change its scene. The programs are generic over bus and pins (embedded-hal), so they compile for
//! your computer and for your chip. The project's tests record the bytes that each program sends, and feed these bytes
//! to a model of the controller. A test fails if the model, which is written from the controller's data sheet, does not
//! show the picture on the canvas. None of the programs has run on a real panel yet.
//!
//! | program | panel | driver, and the version it was tried with |
//! |---|---|---|
//! | [A window of the frame](#a-window-of-the-frame) | ST7789, 240x240 | mipidsi 0.10; any `DrawTarget` will do |
//! | [A needle over a still dial](#a-needle-over-a-still-dial) | ST7789, 240x240 | mipidsi 0.10; any `DrawTarget` will do |
//! | [A round panel](#a-round-panel) | GC9A01, 240x240 | mipidsi 0.10; any `DrawTarget` will do |
//! | [Electronic paper](#electronic-paper) | SSD1680, 122x250 | epd-waveshare 0.6 |
//! | [An OLED without a second buffer](#an-oled-without-a-second-buffer) | SSD1306, 128x64 | ssd1306 0.10, display-interface-spi 0.5 |
//! | [18 bits a pixel](#18-bits-a-pixel) | ILI9488, 480x320 | mipidsi 0.10 |
//! | [Words of 16 bits](#words-of-16-bits) | ILI9341, 320x240 | ili9341 0.6, display-interface-spi 0.5 |
//! | [No tearing](#no-tearing) | ST7789, 240x240 | mipidsi 0.10 |
//! | [Two frames](#two-frames) | ST7789, 240x240 | lcd-async 0.1, embassy-futures 0.1 |
//!
//! The last three sections have no program. They say how many transactions [a driver's buffer](#a-drivers-buffer)
//! costs, what [panels without memory](#panels-without-memory) need, and how a canvas becomes an image [inside another
//! library](#inside-another-library). The page [Firmware](crate::guide::firmware) covers the whole chip: DMA, two
//! cores, Embassy and RTIC.
//!
#![doc = page_picture!(# "A window of the frame", "displays/", "window")]
//! Most of a dashboard does not move. So draw and send only a window around the object that moves.
//! In the picture, the window is yellow, and has a ninth of the frame's pixels.
//!
//! Make a canvas as large as the window. On this canvas, draw with the viewport of the whole frame, moved left and up
//! by the coordinates of the window's top left corner. The canvas then shows that window. Triangles cover the same
//! pixels as when the whole frame is drawn. Interpolated colors and texture coordinates can differ by up to the
//! [mode's](crate::guide::modes) error, because interpolation along a row begins at the window's edge. The pattern of
//! [ordered dithering](crate::shade::PixelFormat) begins at the corner of the canvas. So if colors are dithered, the
//! coordinates of the window's corner must be multiples of 8. The program calls embedded-graphics' `translated` twice:
//! `canvas.translated` places text by its position in the frame, and `display.translated` puts the window in its place
//! on the display. The window must contain both the old and the new position of the moving object. This program's
//! window contains all positions of the object.
//!
#![cfg_attr(not(doctest), doc = program!("window"))]
//!
#![doc = page_picture!(# "A needle over a still dial", "displays/", "needle")]
//! If only a needle moves, fixel tells you which pixels can change:
//! [`Viewport::rectangle_on_screen`](crate::Viewport::rectangle_on_screen) is a rectangle around a mesh. The program
//! draws and sends the rectangle around the old and the new place of the needle (yellow). If the needle has not moved,
//! the program does nothing. Between two readings, the processor sleeps: on a Cortex-M, `sleep` is
//! `cortex_m::asm::wfi`, and the interrupt of a timer or of the sensor wakes the processor. With Embassy, make `run` an
//! `async` function, and wait for a `Timer`: the executor sleeps meanwhile.
//!
//! If the needle goes around the dial in steps of 6 degrees, each step sends 7,411 of the frame's 115,200 bytes on
//! average. The table gives the instructions on an emulated Cortex-M0+. The time awake is an estimate for a Pico at 125
//! MHz: two cycles for each instruction, and then sending without DMA at 62.5 MHz. At ten steps a second, the processor
//! sleeps for more than nine tenths of the time.
//!
//! <!-- figures: needle -->
//! | | instructions | bytes sent | awake, ms |
//! |---|---:|---:|---:|
//! | the whole frame | 2,245,760 | 115,200 | 50.7 |
//! | a step of the needle | 300,721 | 7,411 | 5.8 |
//! <!-- end -->
//!
#![cfg_attr(not(doctest), doc = program!("needle"))]
//!
#![doc = page_picture!(# "A round panel", "displays/", "round")]
//! A round panel does not show the corners of the frame, which are a fifth of the frame. Make each band 16 rows high,
//! and as wide as the circle is in the widest of these rows (on the right in the picture). Then 15 % of the pixels are
//! neither drawn nor sent. Bands of fewer rows leave out more pixels, but transform the mesh more often.
//!
#![cfg_attr(not(doctest), doc = program!("round"))]
//!
#![doc = page_picture!(# "Electronic paper", "displays/", "epaper")]
//! A full refresh of electronic paper flashes, and takes seconds. A quick refresh takes a third of a second, and drives
//! only the pixels that differ from the previous picture. On the right, a quick refresh drove the red pixels to black
//! and the blue pixels to white. So two consecutive pictures should differ only where something moved. Ordered
//! dithering keeps its pattern in place; [error diffusion](crate::canvas::ErrorDiffusion) looks better, but a small
//! change alters pixels everywhere below the change. Use error diffusion for pictures that get a full refresh.
//! Electronic paper also needs a full refresh now and then, to remove the traces of old pictures that quick refreshes
//! leave. The panel's data sheet says how often.
//!
#![cfg_attr(not(doctest), doc = program!("epaper"))]
//!
#![doc = page_picture!(# "An OLED without a second buffer", "displays/", "oled")]
//! In its buffered mode, the driver keeps a frame of 1 KiB, and the canvas would have to be copied into this frame. In
//! its basic mode, the driver accepts bytes in the panel's own format. [`Canvas::pages`](crate::Canvas::pages) makes
//! these bytes: one byte for 8 rows of a column.
//!
#![cfg_attr(not(doctest), doc = program!("oled"))]
//!
#![doc = page_picture!(# "18 bits a pixel", "displays/", "ili9488")]
//! On SPI, an ILI9488 does not accept 16 bits per pixel. A canvas of `Rgb888` in `BigEndian` bytes stores the three
//! bytes per pixel that the panel expects, so a DMA channel can send them unchanged. The driver sets the panel up, and
//! selects the area to write.
//!
#![cfg_attr(not(doctest), doc = program!("ili9488"))]
//!
#![doc = page_picture!(# "Words of 16 bits", "displays/", "ili9341")]
//! Some drivers and buses accept words of 16 bits. A canvas in [`Words`](crate::canvas::Words) stores pixels as a slice
//! of `u16`, which these drivers can send without conversion.
//!
#![cfg_attr(not(doctest), doc = program!("ili9341"))]
//!
#![doc = page_picture!(# "No tearing", "displays/", "tearing")]
//! The panel reads its memory 60 times a second. If a frame arrives while the panel reads, the panel shows the upper
//! part of one frame and the lower part of another: a tear (on the left in the picture). The panel's output TE is low
//! while the panel reads, and high until the next reading begins.
//!
//! When to start sending depends on whether the bus or the panel is faster. If the bus takes longer to send a row than
//! the panel takes to read a row, start as soon as the panel has begun to read (TE falls). Finish before the panel's
//! next reading catches up with the bus. If the bus is faster, start when the panel has finished reading (TE rises).
//! The whole frame must be in memory, because drawing between bands would delay the sending. Panels read in the
//! direction of their longer side, so this method does not prevent tearing on a rotated panel.
//!
#![cfg_attr(not(doctest), doc = program!("tearing"))]
//!
#![doc = page_picture!(# "Two frames", "displays/", "frames")]
//! While one buffer is sent, the next frame is drawn into the other buffer. Two frames of 240x240 pixels take 225 KiB.
//! A Pico has too little RAM for two frames and everything else, but two frames fit into the PSRAM on many boards with
//! an RP2350. Keep the depth buffer in fast memory, because drawing reads and writes each depth several times.
//!
#![cfg_attr(not(doctest), doc = program!("frames"))]
//!
//! On a board with an RP2350 and PSRAM, such as a Pimoroni Pico Plus 2, `psram::Psram` of embassy-rp 0.10 sets up the
//! memory and returns its address, from which `slice::from_raw_parts_mut` makes the two frames.
//!
//! # A driver's buffer
//!
//! mipidsi collects the bytes of colors in a buffer that you give it. Each full buffer is a transaction: the driver
//! takes the bus, selects the panel, and waits. lcd-async takes the bytes of a canvas as they are
//! ([`as_bytes`](crate::Canvas::as_bytes)): each band takes six transactions for its commands, and one for its pixels.
//! These are the transactions for a frame of 240x240 pixels in six bands:
//!
//! | driver and buffer | transactions |
//! |---|---:|
//! | mipidsi, 64 bytes | 1842 |
//! | mipidsi, 512 bytes | 264 |
//! | mipidsi, 4096 bytes | 66 |
//! | lcd-async | 42 |
//!
//! # Panels without memory
//!
//! A panel with an RGB interface has no memory: a controller on the chip (LTDC of an STM32, LCD_CAM of an ESP32-S3)
//! reads the frame from RAM, 60 times a second. The frame is usually in PSRAM or SDRAM. Draw each band in fast memory,
//! with its depths, and copy the band to its rows of the frame: then each pixel is written to the slow memory once. The
//! function `draw` in the section [Two frames](#two-frames) draws bands in this way. In place of sending the frame,
//! give its address to the controller, which shows this frame from the next refresh on; then draw into the other frame.
//! The table gives the data rates that the frame needs from the slow memory:
//!
//! | pixels | a frame, KiB | read for 60 refreshes, MB/s | written for 30 frames, MB/s |
//! |---|---:|---:|---:|
//! | 320x240 | 150 | 9.2 | 4.6 |
//! | 480x272 | 255 | 15.7 | 7.8 |
//! | 800x480 | 750 | 46.1 | 23.0 |
//!
//! PSRAM with four data lines at 80 MHz moves at most 40 MB/s. That is too little for 800x480 pixels at 60 Hz; eight
//! data lines at both edges of the clock move four times as much. A processor with a data cache must write the cache
//! back before the controller reads the frame.
//!
//! If a parallel panel has memory of its own (8080, with 8 or 16 data lines), send bands, as to a panel on SPI. Let the
//! canvas store [`Words`](crate::canvas::Words) for 16 lines, and `BigEndian` bytes for 8.
//!
//! # Inside another library
//!
//! A program whose menus and texts are drawn by another library shows the scene as an image in that library's tree.
//! Draw on a canvas in the memory of the image, and then tell the library that the image has changed. If the program is
//! in C or C++, it calls a Rust function of yours that is `extern "C"`, and passes it a pointer to that memory. Your
//! function makes the canvas from the pointer.
//!
//! | library | its image | the canvas |
//! |---|---|---|
//! | LVGL 9 | `lv_canvas_set_buffer(canvas, bytes, width, height, LV_COLOR_FORMAT_RGB565)` once, and `lv_obj_invalidate(canvas)` after each frame | `Canvas<Rgb565, LittleEndian>` |
//! | Slint 1 | `Image::from_rgb8(buffer)` of a `SharedPixelBuffer<Rgb8Pixel>`, drawn in its `make_mut_bytes()` | `Canvas<Rgb888, BigEndian>` |
//! | TFT_eSPI | `pushImage(x, y, width, height, pixels)`, after `setSwapBytes(false)` | `Canvas<Rgb565, BigEndian>` |
//! | LovyanGFX | the same with pixels of the type `swap565_t` | `Canvas<Rgb565, BigEndian>` |
//!
//! The calls are from the documentation of these libraries, and were not compiled here. With TFT_eSPI and LovyanGFX, an
//! image can be a single band. LVGL and Slint need the whole image, because they draw it again when something above it
//! changes.
//!
// The smaller font lets lines of 100 characters fit into the page.
//! <style>.docblock pre.rust { font-size: 15px }</style>
#![cfg_attr(doc, doc = include_str!("tables.html"))]
