//! Size probe: everything except drawing. The cost of drawing is the size of another probe minus the size of this
//! probe.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[macro_use]
mod probe;

probe!(|_, _, _| Ok(()));
