//! Tests of charts: what a chart is to do, held against what the reference simulator does.
//!
//! ```text
//! Chart ─┬─ table ────┐
//!        └─ scenario ─┴─▶ what is wrong ──── coverage ─▶ table, lcov, colours
//! ```
//!
//! Nothing here reads files or prints: who does that, an editor as well as the command line, hands in texts and chart.
//!
//! | file | what |
//! | --- | --- |
//! | `table` | a test as a table: rows of what is given and what is expected |
//! | `coverage` | what of a chart tests have made happen |

pub mod coverage;
mod table;

pub use table::table;
