//! Many charts and traces through several executors: all must respond alike.

pub mod command;
pub mod coverage;
pub mod long_run;
pub mod mismatch;
pub mod shrink;
pub mod table;
