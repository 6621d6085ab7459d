//! Generated Rust, as rustc compiles it and the machine runs it.
//!
//! The modules of many charts go into one program with a `main` of ours (`driver`), which plays each chart's trace and
//! prints what came out. Now and then it goes on with what was saved of a chart and restored.

mod driver;
mod executor;
mod run;
mod tools;

pub(super) use executor::Rust;
pub use run::run;
pub use tools::Tools;
