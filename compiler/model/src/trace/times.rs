//! The times of rows, which do not go back.

use super::row::Row;
use super::said::Said;
use grafc_diagnostics::{Code, Diagnostic};

/// The latest time, and the row that has it.
#[derive(Default)]
pub(super) struct Times {
    latest: Option<i64>,
    /// The row before, as far as times go.
    pub before: Row,
    /// Whether the row at hand has a time.
    is_read: bool,
}

impl Times {
    /// The latest time; 0 if there was none.
    pub fn latest(&self) -> i64 {
        self.latest.unwrap_or_default()
    }

    /// Makes room for the next row.
    pub fn pass(&mut self, row: &mut Row) {
        if std::mem::take(&mut self.is_read) {
            std::mem::swap(row, &mut self.before);
        }
    }

    /// Takes the time of a row in; if it cannot be read, that of the row before stays.
    pub fn take(&mut self, row: &Row, column: usize, said: &mut Said) {
        let text = row.cell(column);
        let Some(t) = text.parse::<i64>().ok().filter(|&t| t >= 0) else {
            let message =
                if text.is_empty() { "the row has no time".into() } else { format!("`{text}` is not a time") };
            let place = said.cell(row, column);
            said.error(Diagnostic::new(Code::E0603, place, message).here("expected whole milliseconds"));
            return;
        };
        match self.latest {
            Some(before) if t < before => {
                let message = format!("the time goes back from {before} ms to {t} ms");
                // The row before is added first, so that it is shown first.
                let earlier = said.cell(&self.before, column);
                let place = said.cell(row, column);
                said.error(Diagnostic::new(Code::E0604, place, message).also(earlier, "the time before"));
            }
            Some(_) | None => {
                self.latest = Some(t);
                self.is_read = true;
            }
        }
    }
}
