//! Depth formats chosen at run time. The library's formats are types, so that firmware links only the one it uses.

/// Runs `$draw` on `$canvas` with a depth buffer in `$format` over `$depth`.
macro_rules! with_depth {
    ($format:expr, $canvas:expr, $depth:expr, |$with:ident| $draw:expr) => {
        match $format {
            $crate::args::DepthFormat::Linear => {
                let mut canvas = $canvas.with_depth($depth)?;
                let $with = &mut canvas;
                $draw
            }
            $crate::args::DepthFormat::Float => {
                let mut canvas = $canvas.with_depth_format::<fixel::target::Float>($depth)?;
                let $with = &mut canvas;
                $draw
            }
            $crate::args::DepthFormat::Wide => {
                let mut canvas = $canvas.with_depth_format::<fixel::target::WideFloat>($depth)?;
                let $with = &mut canvas;
                $draw
            }
        }
    };
}
pub(crate) use with_depth;
