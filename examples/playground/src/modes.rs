//! The modes by their numbers in the page. The library's modes are types.

/// Runs `$work` in the mode that has this number in the page. Only mode `Fast` uses `$tolerance`.
macro_rules! in_mode {
    ($number:expr, $tolerance:expr, |$mode:ident| $work:expr) => {
        match $number {
            0 => {
                let $mode = ::fixel::mode::Exact;
                $work
            }
            1 => {
                let $mode = ::fixel::mode::Newton::default();
                $work
            }
            2 => {
                let $mode = ::fixel::mode::Fast::within($tolerance);
                $work
            }
            3 => {
                let $mode = ::fixel::mode::Affine;
                $work
            }
            _ => {
                let $mode = ::fixel::mode::Compact;
                $work
            }
        }
    };
}
