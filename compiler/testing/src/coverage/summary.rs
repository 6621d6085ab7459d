//! Coverage in words: how much of each kind, and what is missing, with its place.

use super::{Coverage, Item, Kind};
use grafc_diagnostics::SourceFile;
use std::fmt::Write as _;

/// So much that is missing is told.
const MOST_TOLD: usize = 50;

/// A table of figures, and what is missing. `source` is the text of the chart.
pub fn summary(coverage: &Coverage, source: &SourceFile) -> String {
    let items = coverage.items();
    let mut rows: Vec<(&str, usize, usize)> = Vec::new();
    for kind in Kind::ALL {
        let of_kind = || items.iter().filter(|item| item.kind == kind);
        rows.push((kind.plural(), of_kind().filter(|item| item.count > 0).count(), of_kind().count()));
    }
    let conditions = || items.iter().filter_map(|item| item.condition);
    let counts = || conditions().flat_map(|condition| &condition.atoms).flat_map(|atom| atom.counts);
    rows.push(("values of atoms", counts().filter(|count| *count > 0).count(), counts().count()));
    let decided = || conditions().flat_map(|condition| condition.decided()).flatten();
    rows.push(("deciding atoms", decided().filter(|decided| *decided).count(), decided().count()));
    let mut text = format!("coverage of {}\n", source.name);
    for (what, met, of) in rows.iter().filter(|(_, _, of)| *of > 0) {
        // Rounded down: only all is 100 %.
        let _ = writeln!(text, "  {what:16}{met:>7} of {of:<7}{:>3} %", met * 100 / of);
    }
    let missing: Vec<String> = items.iter().flat_map(|item| missing(coverage, source, item)).collect();
    for line in missing.iter().take(MOST_TOLD) {
        let _ = writeln!(text, "{line}");
    }
    if missing.len() > MOST_TOLD {
        let _ = writeln!(text, "and {} more", missing.len() - MOST_TOLD);
    }
    text
}

/// What an item lacks, a line each. Of a condition that was never asked, nothing is said but that.
fn missing(coverage: &Coverage, source: &SourceFile, item: &Item) -> Vec<String> {
    let line = |byte: u32| format!("{}:{}", source.name, source.position(byte as usize).line);
    let mut lines = Vec::new();
    if item.count == 0 {
        lines.push(format!("  {}: {} {}", line(item.span.start), item.name, item.kind.missed()));
    }
    let Some(condition) = item.condition else { return lines };
    for (atom, decided) in condition.atoms.iter().zip(condition.decided()) {
        let span = coverage.place(atom.expr);
        let text = source.text.get(span.range()).unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ");
        let what = match atom.counts {
            [0, 0] => continue,
            [_, 0] => "was never true",
            [0, _] => "was never false",
            [_, _] if decided == Some(false) => "has not decided it both ways",
            [_, _] => continue,
        };
        lines.push(format!("  {}: `{text}` in the condition of {} {what}", line(span.start), item.name));
    }
    lines
}
