//! Generated C, as a C compiler takes it and the machine runs it.
//!
//! The sources of many charts go into one program with a `main` of ours (`driver`), which plays each chart's trace and
//! prints what came out. Now and then it goes on with what was saved of a chart and restored. Whatever the compiler has to
//! say is a fault, and so is what is undefined in C.

mod driver;
mod executor;
mod run;
mod tools;

pub(super) use executor::C;
pub use run::run;
pub use tools::Tools;
