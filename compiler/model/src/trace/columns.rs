//! What the header of a trace names: columns of its own, and variables of the chart.
//!
//! A name of the chart that is that of a column of the trace's own stands in backquotes, as names do in a chart that
//! would be something else without; any other may.

use super::row::Row;
use super::said::Said;
use crate::chart::{Variable, VariableKind};
use crate::resolve::suggest::Suggestions;
use grafc_diagnostics::{Code, Diagnostic, Fix, Span};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;

/// The column of times.
pub const TIME: &str = "t_ms";
/// The column that marks restarts of the controller.
pub const RESTART: &str = "restart";
/// The column of active steps.
pub const SITUATION: &str = "situation";
/// The column of raised flags.
pub const FLAGS: &str = "flags";
/// The column that parts what is given from what is expected.
pub const BAR: &str = "|";

/// A cell of a header.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Heading<'t> {
    /// The name, without backquotes.
    pub name: &'t str,
    /// Whether it stood in backquotes: then it is one of the chart's.
    pub quoted: bool,
}

impl<'t> Heading<'t> {
    pub fn read(cell: &'t str) -> Self {
        match cell.strip_prefix('`').and_then(|rest| rest.strip_suffix('`')).filter(|name| !name.is_empty()) {
            Some(name) => Heading { name, quoted: true },
            None => Heading { name: cell, quoted: false },
        }
    }

    /// Whether it is this column of the trace's own.
    pub fn is(self, own: &str) -> bool {
        !self.quoted && self.name == own
    }
}

/// How the header writes a name of the chart.
pub fn heading(name: &str) -> Cow<'_, str> {
    if is_own(name) { Cow::Owned(format!("`{name}`")) } else { Cow::Borrowed(name) }
}

/// Where the column is that parts what is given from what is expected, if there is one.
pub(super) fn bar(header: &Row) -> Option<usize> {
    (0..header.len()).find(|column| header.cell(*column) == BAR)
}

/// The roles of some columns; the first of the table is that of times. `own` gives those of the trace's own, `variables`
/// those of the chart's variables; what is neither, or there twice, is reported and has the role `unknown`.
pub(super) fn columns<R: Copy>(
    said: &mut Said,
    header: &Row,
    part: Range<usize>,
    (time, unknown): (R, R),
    own: &[(&str, R)],
    variables: &BTreeMap<&str, R>,
    fault: impl Fn(&str, Span) -> Diagnostic,
) -> Vec<R> {
    let mut seen: BTreeMap<Heading, Span> = BTreeMap::new();
    let mut columns = Vec::with_capacity(part.len());
    for (column, range) in header.ranges().into_iter().enumerate().take(part.end).skip(part.start) {
        let (cell, span) = (header.cell(column), said.place(header, range));
        let heading = Heading::read(cell);
        let of_its_own = own.iter().find(|(name, _)| heading.is(name));
        let of_the_chart = variables.get(heading.name);
        // The same name is the same column, in backquotes or not, unless it could be either.
        let key = Heading { quoted: heading.quoted && is_own(heading.name), ..heading };
        let earlier = seen.insert(key, span);
        columns.push(if column == 0 {
            if !heading.is(TIME) {
                let message = format!("the first column is `{}`, not `{TIME}`", heading.name);
                let help = format!("begin the header with `{TIME}`, and each row with its time in milliseconds");
                said.error(Diagnostic::new(Code::E0601, span, message).help(help));
            }
            time
        } else if let Some(earlier) = earlier {
            let message = format!("column `{}` appears twice", heading.name);
            let fault = Diagnostic::new(Code::E0601, span, message).also(earlier, "also here");
            let is_hidden = of_the_chart.is_some() && is_own(heading.name) && !heading.quoted;
            let help = if is_hidden { in_backquotes(heading.name) } else { "leave one of them out".to_string() };
            said.error(fault.help(help));
            unknown
        } else {
            match (of_its_own, of_the_chart) {
                (Some(_), Some(_)) if !header.has(&self::heading(heading.name)) => {
                    said.error(ambiguous(heading.name, span));
                    unknown
                }
                (Some((_, role)), _) | (None, Some(role)) => *role,
                (None, None) => {
                    said.error(fault(heading.name, span));
                    unknown
                }
            }
        });
    }
    columns
}

fn is_own(name: &str) -> bool {
    [TIME, RESTART, SITUATION, FLAGS, BAR].contains(&name)
}

fn in_backquotes(name: &str) -> String {
    format!("the chart's own name stands in backquotes: {}", heading(name))
}

/// A name that is the chart's and one of the trace's own, where the trace has one column of it.
fn ambiguous(name: &str, span: Span) -> Diagnostic {
    let message = format!("`{name}` is the name of a column of the trace's own and of a variable of the chart");
    Diagnostic::new(Code::E0602, span, message)
        .help(format!("{}; where both are meant, there are both columns", in_backquotes(name)))
        .fix(Fix::maybe("put it in backquotes").replace(span, heading(name)))
}

/// A column that the chart has no variable for: what it is, and what was meant.
pub fn unknown(message: String, name: &str, span: Span, candidates: &[&Variable], looks: &Suggestions) -> Diagnostic {
    let fault = Diagnostic::new(Code::E0602, span, message);
    let all = || candidates.iter().map(|variable| variable.name.as_str());
    let folded = name.to_lowercase();
    let like = all().find(|other| other.to_lowercase() == folded);
    let Some(meant) = like.or_else(|| looks.nearest(name, all())) else {
        return fault.help(if candidates.is_empty() {
            "leave the column out".to_string()
        } else {
            format!("leave the column out, or name one of these: {}", listed(all()))
        });
    };
    let title = format!("write `{meant}`");
    let fix = if like.is_some() { Fix::certain(title.clone()) } else { Fix::maybe(title.clone()) };
    fault.help(title).fix(fix.replace(span, heading(meant)))
}

/// The first of some names.
fn listed<'a>(mut names: impl Iterator<Item = &'a str>) -> String {
    const NAMES: usize = 8;
    let first: Vec<String> = names.by_ref().take(NAMES).map(|name| format!("`{name}`")).collect();
    first.join(", ") + if names.next().is_some() { ", …" } else { "" }
}

/// What a variable is, in words.
pub fn kind_of(variable: &Variable) -> &'static str {
    match variable.kind {
        VariableKind::Input => "an input",
        VariableKind::Output => "an output",
        VariableKind::Internal => "an internal variable",
        VariableKind::Constant => "a constant",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_as_the_same_name() {
        for name in ["a", "t_ms", "restart", "situation", "flags", "|", "Restart", "with, comma"] {
            let written = heading(name);
            let read = Heading::read(&written);
            assert_eq!(read.name, name);
            assert!(![TIME, RESTART, SITUATION, FLAGS, BAR].into_iter().any(|own| read.is(own)), "{name}");
        }
    }

    #[test]
    fn lone_backquotes_are_part_of_a_name() {
        for cell in ["`", "``", "`a", "a`"] {
            assert_eq!(Heading::read(cell), Heading { name: cell, quoted: false });
        }
    }
}
