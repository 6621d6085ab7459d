//! One habit is one mistake, however often it shows: semicolons over a whole text, and the assignments of one step that do
//! not say when they are done.

use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};

/// More places of one message are not shown.
const SHOWN: usize = 4;

/// Joins what is one mistake; the messages are in order of place.
pub(crate) fn joined(text: &str, diagnostics: Diagnostics) -> Diagnostics {
    let mut out: Vec<Diagnostic> = Vec::new();
    // Where in `out` the first semicolon is, and the place where the last assignment without an event ends.
    let (mut semicolon, mut eventless): (Option<usize>, Option<(usize, u32)>) = (None, None);
    for fault in diagnostics.iter() {
        let at = fault.primary.span;
        if is_semicolon(text, fault) {
            // Behind an assignment that has its message it belongs to that; within one it does not.
            if let Some((index, end)) = eventless
                && text.get(end as usize..at.start as usize).is_some_and(|between| between.trim().is_empty())
            {
                widen(&mut out[index], end, at.end);
            } else if let Some(index) = semicolon {
                join(&mut out[index], fault, "and here");
            } else {
                semicolon = Some(out.len());
                out.push(fault.clone());
            }
        } else if fault.code == Code::E0108 {
            match eventless {
                Some((index, end)) if !text[end as usize..at.start as usize].contains(['{', '}']) => {
                    join(&mut out[index], fault, "nor does this");
                    eventless = Some((index, at.end));
                }
                _ => {
                    eventless = Some((out.len(), at.end));
                    out.push(fault.clone());
                }
            }
        } else {
            out.push(fault.clone());
        }
    }
    let mut joined = Diagnostics::new();
    out.into_iter().for_each(|fault| joined.push(fault));
    joined
}

fn is_semicolon(text: &str, fault: &Diagnostic) -> bool {
    fault.code == Code::E0101 && matches!(&text[fault.primary.span.range()], ";" | "；")
}

/// A further place of the same mistake: what helps is done there, too.
fn join(first: &mut Diagnostic, other: &Diagnostic, words: &str) {
    if first.secondary.len() < SHOWN {
        first.secondary.push(grafc_diagnostics::Label { span: other.primary.span, text: words.to_owned() });
    }
    for (fix, more) in first.fixes.iter_mut().zip(&other.fixes) {
        fix.edits.extend(more.edits.iter().cloned());
    }
}

/// What is inserted behind an assignment takes the place of the semicolon there.
fn widen(fault: &mut Diagnostic, from: u32, to: u32) {
    for edit in fault.fixes.iter_mut().flat_map(|fix| &mut fix.edits) {
        if edit.span.start == from {
            edit.span = Span { end: to, ..edit.span };
        }
    }
}
