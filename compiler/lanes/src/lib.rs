//! A scan program run for 64 scenarios at once: bit-parallel evaluation, as the textbook has it for Boolean formulas.
//!
//! ```text
//! scan::Program ─ compile ─▶ code: operations on words, and parts for choices ─ lanes ─▶ 64 scenarios, call by call
//! ```
//!
//! A *lane* is a scenario: with its own inputs, its own time, its own state. A Boolean variable is a word with a bit a lane,
//! so that one operation serves all; numbers and delays are rows of 64, lane by lane. Choices are masks: what a branch does
//! is kept in the lanes that take it. An evolution goes on until the last lane is stable; the others rest meanwhile.
//!
//! What comes out is what the scalar evaluator of `grafc_logic::scan::evaluate` gives for each lane alone.
//!
//! | file | what |
//! | --- | --- |
//! | `code` | the operations, and where values lie |
//! | `compile` | statements to parts, formulas to operations, each once as long as it keeps its value |
//! | `lanes` | the state of 64 scenarios, and a call |
//! | `batch` | any number of scenarios from their first call to their last |
//! | `operate` | what the operations do |

mod batch;
mod code;
mod compile;
mod lanes;
mod operate;

pub use batch::run;
pub use code::LANES;
pub use lanes::Lanes;

/// A bit a lane.
pub type Word = u64;
