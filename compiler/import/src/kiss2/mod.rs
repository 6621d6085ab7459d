//! Tables of KISS2, the format of the MCNC benchmarks: `read` to rows, `write` to a chart of one call a row.

mod read;
mod table;
mod write;

pub use read::read;
pub use write::write;

/// Whether a text looks like such a table: behind comments, its first line begins with a full stop.
pub fn is_kiss2(text: &str) -> bool {
    let mut lines = text.trim_start_matches('\u{FEFF}').lines().map(str::trim);
    lines.find(|line| !line.is_empty() && !line.starts_with('#')).is_some_and(|line| line.starts_with('.'))
}
