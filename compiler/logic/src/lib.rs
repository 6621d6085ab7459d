//! From a flat Petri net to the statements of one scan.
//!
//! ```text
//! flat Net ─ lower ─▶ formulas ─ analysis ─▶ what is proved of them ─ encode ─▶ statements ─ tidy ─▶ scan::Program
//! ```
//!
//! | room | what |
//! | --- | --- |
//! | `options` | what the caller may choose, the encodings among it |
//! | `compile` | the sections of a program, put together |
//! | `lower/` | conditions and values to formulas, and what holds the situation |
//! | `analysis/` | what is proved of a net: components, what may happen together, how long an evolution can be |
//! | `encode/` | a micro-step as statements, one encoding a file |
//! | `tidy/` | shorter formulas, nothing that is not read, no chain too long for a compiler |
//! | `scan/` | the program: its form, the check of its invariants, its text, its evaluator, what it takes |
//! | `sequence/` | a net as a sequential function chart, or why it is none |
//! | `warn/`, `report`, `output_table` | what was found, in words |
//! | `spell` | conditions as the chart writes them |
//!
//! Formulas themselves are in the crate `grafc-formula`.

mod analysis;
mod compile;
mod encode;
mod lower;
mod options;
mod output_table;
mod report;
pub mod scan;
pub mod sequence;
mod spell;
mod tidy;
mod warn;

pub use analysis::Analysis;
pub use analysis::transients::Transients;
pub use compile::{Extras, compile, compile_observed, compile_saved, compile_with};
pub use grafc_model::dump::type_name;
pub use grafc_model::misleading_points;
pub use options::{Encoding, Options};
pub use output_table::{OutputTable, Row, StoredOutput, When, output_table};
pub use report::{Method, arrow, bits, exclusion, sets};
pub use spell::condition;
pub use warn::warn;
