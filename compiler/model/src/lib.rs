//! The checked chart and what it means.
//!
//! [`check()`] resolves a syntax tree and applies every rule that a text can break, one rule a file in `checks/`.
//! `simulate` is the reference simulator: it follows the rules R1-R14 of `docs/semantics.md` literally, on charts
//! whose macro-steps, enclosures and forcing orders are still whole, and shares no code with the compiler's lowering.

pub mod chart;
mod check;
mod checks;
#[cfg(feature = "names")]
mod deceptive;
pub mod dump;
mod fixes;
mod profile;
pub mod reaction;
mod resolve;
pub mod simulate;
pub mod symbols;
pub mod trace;

pub use check::{Checked, check, examine, scenarios};
pub use checks::truth;
pub use dump::dump;

/// The code points of what misleads in a name, to be shown beside it; none without the feature `names`.
pub fn misleading_points(name: &str) -> Option<String> {
    #[cfg(feature = "names")]
    let points = deceptive::code_points(name);
    #[cfg(not(feature = "names"))]
    let points = Option::<String>::None.filter(|_| name.is_ascii());
    points
}
