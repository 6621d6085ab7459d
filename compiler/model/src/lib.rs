//! The checked chart and what it means.
//!
//! [`check()`] resolves a syntax tree and applies every rule that a text can break, one rule a file in `checks/`.
//! `simulate` is the reference simulator: it follows the rules R1-R14 of `docs/semantics.md` literally, on charts
//! whose macro-steps, enclosures and forcing orders are still whole, and shares no code with the compiler's lowering.

pub mod chart;
mod check;
mod checks;
pub mod dump;
mod fixes;
pub mod reaction;
mod resolve;
pub mod simulate;
pub mod symbols;
pub mod trace;

pub use check::{Checked, check, examine};
pub use dump::dump;
