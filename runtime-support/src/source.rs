//! The text of the parts that grafc copies into generated code that stands alone.
//!
//! Each part needs `core` alone and none of the others. They hold no tests, and their names do not clash, so that any
//! of them can stand together in one module. Lines that begin with `#[cfg_attr(feature = "serde"` are to be left out
//! of a copy: the feature belongs to this crate.

/// The on-delay: `Timer`.
pub const TIMER: &str = include_str!("timer.rs");
/// Division: `Number`, `divide`, `remainder`.
pub const NUMBER: &str = include_str!("number.rs");
/// What went wrong at run time: `Flags`.
pub const FLAGS: &str = include_str!("flags.rs");
/// The memory of a chart as bytes: `Saved`, `Saver`, `seal`, `Restorer`.
pub const SAVED: &str = include_str!("saved.rs");
