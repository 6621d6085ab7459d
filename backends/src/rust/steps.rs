//! The steps of the chart as an enum, and an enum for each set of steps that exclude each other.

use super::expressions::{SMALL, WIDTH};
use super::items::doc;
use super::names::{RustNames, StateNames};
use crate::comment::clean;
use crate::writer::Writer;
use grafc_logic::scan::{Origin, Program};

/// rustfmt puts many literals on a line if none is longer, without its quotes.
const SHORT: usize = 10;

/// Of an enum with more variants, a `Debug` that is derived costs rustc gigabytes, and a `match` with an arm for each is
/// dear, too.
pub(super) const MANY: usize = 1000;

/// Writes `Step`.
pub(super) fn steps(out: &mut Writer, program: &Program, names: &RustNames) {
    out.blank();
    out.line("/// The steps of the chart.");
    let many = program.steps.len() > MANY;
    out.line(&format!("#[derive(Clone, Copy, {}PartialEq, Eq, Hash)]", derived(many)));
    out.open("pub enum Step {");
    for (s, step) in program.steps.iter_enumerated() {
        let outer = out.origin(Origin::Step(s));
        doc(out, &about(&step.label, step.comment.as_deref()));
        out.line(&format!("{},", names.steps[s]));
        out.origin(outer);
    }
    out.close("}");
    out.blank();
    out.open("impl Step {");
    out.line("/// All steps, in order of declaration.");
    let items: Vec<String> = names.steps.iter().map(|name| format!("Self::{name}")).collect();
    list(out, &format!("pub const ALL: [Self; {}] =", items.len()), "[", &items);
    out.blank();
    let labels: Vec<String> = program.steps.iter().map(|step| quoted(&step.label)).collect();
    let head = format!("const LABELS: [&'static str; {}] =", labels.len());
    if labels.iter().all(|label| label.len() <= SHORT + 2) {
        filled(out, &head, &labels)
    } else {
        list(out, &head, "[", &labels)
    }
    out.blank();
    out.line("/// The label in the chart.");
    out.open("pub const fn label(self) -> &'static str {");
    out.line("Self::LABELS[self as usize]");
    out.close("}");
    out.close("}");
    if many {
        debug(out, "Step", "self.label()");
    }
}

fn derived(many: bool) -> &'static str {
    if many { "" } else { "Debug, " }
}

/// `Debug` for an enum of many variants.
fn debug(out: &mut Writer, name: &str, shown: &str) {
    out.blank();
    out.open(&format!("impl core::fmt::Debug for {name} {{"));
    out.open("fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {");
    out.line(&format!("f.debug_tuple(\"{name}\").field(&{shown}).finish()"));
    out.close("}");
    out.close("}");
}

/// What a step is called, in a comment.
fn about(label: &str, comment: Option<&str>) -> String {
    match comment.map(clean).filter(|text| !text.is_empty()) {
        Some(comment) => format!("step {}: {comment}", clean(label)),
        None => format!("step {}", clean(label)),
    }
}

/// An arm of a `match` that gives a value.
pub(super) fn arm(out: &mut Writer, label: &str, value: &str) {
    if out.indent() + label.len() + value.len() + 5 <= WIDTH {
        return out.line(&format!("{label} => {value},"));
    }
    out.open(&format!("{label} => {{"));
    out.line(value);
    out.close("}");
}

/// A text as a literal.
fn quoted(text: &str) -> String {
    format!("{text:?}")
}

/// Writes the enum of each state, which is as large as it must be and no larger.
pub(super) fn states(out: &mut Writer, program: &Program, names: &RustNames) {
    for (state, names) in program.states.iter().zip(&names.states) {
        let step_of = |value: i64| state.values.iter().find(|(_, n)| *n == value).map(|(s, _)| &program.steps[*s]);
        out.blank();
        out.line("/// Which of these steps is active.");
        let many = names.variants.len() > MANY;
        out.line(&format!("#[derive(Clone, Copy, {}PartialEq, Eq)]", derived(many)));
        out.open(&format!("enum {} {{", names.ty));
        let mut in_order = state.values.iter();
        for (value, variant) in &names.variants {
            // The variants of steps are in the order of the values.
            let id = if state.idle == Some(*value) { None } else { in_order.next().map(|(s, _)| *s) };
            let step = id.map(|s| &program.steps[s]);
            let outer = out.origin(id.map_or(Origin::Chart, Origin::Step));
            debug_assert_eq!(step.map(|s| &s.label), step_of(*value).map(|s| &s.label));
            match step {
                Some(step) => doc(out, &about(&step.label, step.comment.as_deref())),
                None => out.line("/// none of them"),
            }
            out.line(&format!("{variant},"));
            out.origin(outer);
        }
        out.close("}");
        if many {
            debug(out, &names.ty, "(*self as usize)");
        }
        variants(out, names);
    }
}

/// All values of a state, to read one from saved memory.
fn variants(out: &mut Writer, names: &StateNames) {
    out.blank();
    out.open(&format!("impl {} {{", names.ty));
    let items: Vec<String> = names.variants.iter().map(|(_, name)| format!("Self::{name}")).collect();
    list(out, &format!("const ALL: [Self; {}] =", items.len()), "[", &items);
    out.close("}");
}

/// Writes a constant list as rustfmt lays it out; `open` is the bracket, with what stands before it.
pub(super) fn list(out: &mut Writer, head: &str, open: &str, items: &[String]) {
    if flat(out, head, open, items) {
        return;
    }
    out.open(&format!("{head} {open}"));
    for item in items {
        out.start();
        out.text(item);
        out.text(",");
        out.end();
    }
    out.close("];");
}

/// The same of short literals, with many on a line.
pub(super) fn filled(out: &mut Writer, head: &str, items: &[String]) {
    if flat(out, head, "[", items) {
        return;
    }
    out.open(&format!("{head} ["));
    let mut line = String::new();
    for item in items {
        if !line.is_empty() && out.indent() + line.len() + item.len() + 2 > WIDTH {
            out.line(&std::mem::take(&mut line));
        }
        line.push_str(if line.is_empty() { "" } else { " " });
        line.push_str(item);
        line.push(',');
    }
    out.line(&line);
    out.close("];");
}

/// Writes a list that fits on one line; whether it does.
fn flat(out: &mut Writer, head: &str, open: &str, items: &[String]) -> bool {
    if items.iter().map(|item| item.len() + ", ".len()).sum::<usize>() > SMALL + ", ".len() {
        return false;
    }
    let flat = items.join(", ");
    let line = format!("{head} {open}{flat}];");
    if out.indent() + line.len() <= WIDTH {
        out.line(&line);
    } else {
        out.open(head);
        out.line(&format!("{open}{flat}];"));
        out.leave();
    }
    true
}
