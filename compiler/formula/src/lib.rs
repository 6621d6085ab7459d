//! Formulas: what conditions and values become once names, steps and delays are variables and timers.
//!
//! [`pool`] holds them hash-consed, [`number`] computes at the width of a type, [`exclusion`] proves on decision diagrams
//! that two conditions never hold together. Nothing here knows of charts or programs: what lowers a chart and what proves
//! something of it both stand on this.

pub mod exclusion;
pub mod number;
pub mod pool;

pub use pool::{Arithmetic, Comparison, Formula, FormulaId, List, Pool, TimerId, Type, Value, VarId};
