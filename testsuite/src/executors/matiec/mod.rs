//! Generated Structured Text and instruction lists, as MATIEC compiles them and a C compiler runs them.
//!
//! The function blocks of many charts go into one file for `iec2c`, what it writes and a driver of ours (`c_driver`)
//! into one program for `gcc`, which plays each chart's trace and prints what came out. The time is fixed throughout a
//! call, as the PLC's cycle fixes it.

mod executor;
mod original;
mod run;
mod sequences;
mod tools;

pub(super) use executor::executors;
pub use original::{Scan, play_program};
pub use run::{Language, accepts, miscalculates, run};
pub(super) use run::{RUNTIME, Unit, build_and_play};
pub(super) use sequences::executor as sequences;
pub use tools::Tools;
