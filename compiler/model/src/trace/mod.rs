//! Traces: what goes into a run and what comes out, as CSV.
//!
//! A stimulus trace has a header `t_ms,NAME,…` of inputs, then a row a call. Inputs that it does not name keep their
//! initial value, an empty cell keeps the value of the row before. Booleans are `0`, `1`, `FALSE` or `TRUE`, numbers as
//! in a chart, times also in milliseconds. Where the column `restart` is true, the controller has restarted before the
//! call. A result has the columns `t_ms`, the outputs, `situation` and `flags`. So has a recording of another tool, which
//! is compared with what the chart does. A test is a trace whose
//! columns behind `|` say what is expected.
//!
//! All of them are read and written row by row, however many rows there are.

mod against;
mod between;
mod broken;
mod columns;
mod expected;
mod given;
mod input;
mod read;
mod results;
mod row;
mod rows;
mod said;
mod situation;
mod test_write;
#[cfg(test)]
mod tests;
mod times;
mod values;
mod write;

pub use against::{Recording, compare_trace};
pub use between::Between;
pub use broken::BrokenClaims;
pub(crate) use columns::kind_of;
pub use columns::{BAR, heading};
pub use expected::Expectations;
pub use read::{Stimuli, parse_trace};
pub use results::agree;
pub use said::{Kept, MOST_ERRORS};
pub use test_write::write_test;
pub use write::cell as spelled;
pub use write::{Shown, Table, write_trace};
