//! Generated JavaScript, as node runs it.
//!
//! The modules of many charts lie in one folder with a script of ours (`driver.mjs`), which plays each chart's trace and
//! prints what came out. Some scans go micro-step by micro-step; now and then it goes on with what was saved of a chart and
//! restored, also in the middle of a scan.

mod executor;
mod run;
mod tools;

pub(super) use executor::JavaScript;
pub use run::{MicroStep, run, watch};
pub use tools::{Tools, Typescript};
