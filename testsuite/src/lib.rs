//! Charts, vectors, random charts and differential runs of grafc.
//!
//! What a chart means is said once, by the reference simulator; expectations written by hand check the simulator, and
//! everything else is checked against it: the scan program, and the generated code as other tools run it.

pub mod abc;
pub mod agreement;
pub mod binary;
pub mod browser;
pub mod charts;
pub mod compare;
pub mod controller;
pub mod differential;
pub mod drawing_lint;
pub mod drawn_chart;
pub mod enumeration;
pub mod excerpts;
pub mod executors;
pub mod expected;
pub mod fuzzing;
pub mod markdown;
pub mod mutants;
pub mod named_trace;
pub mod net_steps;
pub mod outline;
pub mod plants;
pub mod plcopen_lint;
pub mod plcopen_sheet;
pub mod plcopen_tools;
mod programs;
pub mod random;
pub mod rings;
pub mod runs;
pub mod rust_cost;
pub mod scaling;
pub mod scan_cost;
pub mod share;
pub mod sights;
pub mod tools;
mod turns;
pub mod ways;
pub mod xmi;
