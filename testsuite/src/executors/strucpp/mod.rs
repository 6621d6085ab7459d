//! Generated Structured Text, as STruC++ compiles it to C++ and a C++ compiler builds it.
//!
//! The function blocks of many charts go into one file, as for MATIEC. The clock of its timers is a variable of its
//! runtime, which a PLC sets before each call, and the driver here as well.

mod executor;
mod run;
mod tools;

pub(super) use executor::Strucpp;
pub use run::{accepts, limit, run};
pub use tools::Tools;
