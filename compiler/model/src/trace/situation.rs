//! The column of active steps: labels, parted by blanks. A label that holds a blank stands in backquotes, as in a chart.

use crate::chart::{Chart, StepId};
use std::borrow::Cow;

/// How a cell says that no step is active, where a blank one says nothing.
pub(super) const EMPTY: &str = "{}";

/// Writes the cell for a situation.
pub(super) fn write(cell: &mut String, chart: &Chart, situation: &[StepId]) {
    for (place, step) in situation.iter().enumerate() {
        if place > 0 {
            cell.push(' ');
        }
        cell.push_str(&quoted(&chart.steps[*step].label));
    }
}

fn quoted(label: &str) -> Cow<'_, str> {
    if label.contains(char::is_whitespace) || label == EMPTY {
        Cow::Owned(format!("`{label}`"))
    } else {
        Cow::Borrowed(label)
    }
}

/// The labels in a cell, in order; any may stand in backquotes.
pub(super) fn labels(cell: &str) -> impl Iterator<Item = &str> {
    let mut rest = cell.trim_start();
    std::iter::from_fn(move || {
        let quoted =
            rest.strip_prefix('`').and_then(|inner| inner.split_once('`')).filter(|(label, _)| !label.is_empty());
        let (label, behind) = match quoted {
            Some(found) => found,
            None => rest.split_at(rest.find(char::is_whitespace).unwrap_or(rest.len())),
        };
        rest = behind.trim_start();
        (!label.is_empty()).then_some(label)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_with_blanks_stand_apart() {
        for all in [
            &["1", "2"][..],
            &["{}"],
            &["tank full", "tank", "full"],
            &["a b"],
            &["", "x"][1..],
            &["\u{a0}", "a\u{3000}b"],
        ] {
            let written: Vec<Cow<str>> = all.iter().map(|label| quoted(label)).collect();
            assert_eq!(labels(&written.join(" ")).collect::<Vec<_>>(), all);
        }
    }

    #[test]
    fn any_label_may_stand_in_backquotes() {
        assert_eq!(labels(" `1`  `a b` 2 ").collect::<Vec<_>>(), ["1", "a b", "2"]);
        assert_eq!(labels("").count(), 0);
        // A backquote without its partner is part of a label, which no step has.
        assert_eq!(labels("`a b").collect::<Vec<_>>(), ["`a", "b"]);
    }
}
