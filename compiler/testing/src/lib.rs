//! Tests of charts: what a chart is to do, held against what the reference simulator does.
//!
//! ```text
//! Chart ─┬─ table ────┐
//!        └─ scenario ─┴─▶ what is wrong ──── coverage ─▶ table, lcov, colours
//! Moves ─── trips ─ certify ─▶ tables that cover all of them
//! ```
//!
//! Nothing here reads files or prints: who does that, an editor as well as the command line, hands in texts and chart.
//!
//! | file | what |
//! | --- | --- |
//! | `table` | a test as a table: rows of what is given and what is expected |
//! | `scenario` | a test in words of time |
//! | `coverage` | what of a chart tests have made happen |
//! | `trips` | few and short round trips through what can happen |
//! | `certify` | trips with expected values: the certification tests of the textbook |

mod certify;
pub mod coverage;
mod scenario;
mod table;
mod trips;

pub use certify::{Certified, CertifiedTest, certify};
pub use scenario::scenario;
pub use table::table;
pub use trips::{Cover, Totals};
