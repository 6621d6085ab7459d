//! From a flat Petri net to the statements of one scan.
//!
//! ```text
//! flat Net ─ lower ─▶ formulas ─ encode ─▶ next activity of each step ─ compile ─▶ scan::Program
//! ```
//!
//! [`formula`] holds hash-consed formulas, [`scan`] the ordered, typed statements that backends spell out, and
//! [`evaluate`] runs them. Each encoding of the situation is one file in `encode/`.

mod allocate;
mod compile;
mod encode;
pub mod evaluate;
mod events;
mod exclusion;
pub mod formula;
mod input_event;
mod limits;
mod lower;
mod number;
pub mod scan;
mod symbols;
mod tokens;

pub use compile::compile;
pub use encode::Encoding;
