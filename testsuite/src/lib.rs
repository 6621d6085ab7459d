//! Charts, vectors, random charts and differential runs of grafc.
//!
//! What a chart means is said once, by the reference simulator; expectations written by hand check the simulator, and
//! everything else is checked against it: the scan program, and the generated code as other tools run it.

pub mod awlsim;
pub mod beremiz;
pub mod binary;
mod c_driver;
pub mod charts;
pub mod controller;
pub mod differential;
pub mod drawn_chart;
pub mod excerpts;
pub mod executors;
mod function_block;
pub mod fuzzing;
pub mod ironplc;
pub mod jobs;
pub mod markdown;
pub mod matiec;
pub mod mutants;
pub mod net_steps;
pub mod plants;
pub mod plcopen_lint;
pub mod plcopen_sheet;
pub mod plcopen_tools;
pub mod programs;
pub mod random;
pub mod rings;
pub mod rust;
pub mod rust_cost;
pub mod scaling;
pub mod scan_cost;
pub mod strucpp;
mod turns;
pub mod xmi;
