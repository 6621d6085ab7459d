//! From a flat Petri net to the statements of one scan.
//!
//! ```text
//! flat Net ─ lower ─▶ formulas ─ encode ─▶ next activity of each step ─ compile ─▶ scan::Program
//! ```
//!
//! [`formula`] holds hash-consed formulas, [`scan`] the ordered, typed statements that backends spell out, and
//! [`evaluate`] runs them. Each encoding of the situation is one file in `encode/`.

mod allocate;
mod arms;
mod compile;
mod dormant;
mod dump;
mod encode;
pub mod evaluate;
mod events;
mod exclusion;
pub mod formula;
mod input_event;
mod lower;
mod measure;
mod number;
mod outputs;
mod overlap;
mod pieces;
mod report;
pub mod scan;
pub mod sequence;
mod settle;
mod simplify;
mod situation;
mod stored;
mod sweep;
mod symbols;
mod tokens;
mod transient;
mod warnings;

pub use compile::{Options, compile};
pub use dump::{dump, equations};
pub use encode::Encoding;
pub use measure::{Measure, measure};
pub use report::{Report, analyse, arrow};
pub use transient::Transients;
pub use warnings::warn;
