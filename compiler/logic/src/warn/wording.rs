//! Conditions in the words of the chart, for messages.

use crate::analysis::together::Case;
use crate::report::arrow;
use crate::spell::in_words;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::Net;

/// More atoms than this are not spelt out.
const SPELT_OUT: usize = 6;

/// A case as `a` and `b` are true and `c` is false, if it can be said in a few words.
pub(super) fn case(net: &Net, case: &Case) -> Option<String> {
    if case.len() > SPELT_OUT {
        return None;
    }
    let mut sides = Vec::new();
    for value in [true, false] {
        let atoms = case.iter().filter(|(_, is)| *is == value);
        let names: Option<Vec<String>> = atoms.map(|(atom, _)| in_words(net, (*atom)?)).collect();
        let names = names?;
        let verb = if names.len() == 1 { "is" } else { "are" };
        if !names.is_empty() {
            sides.push(format!("{} {verb} {value}", list(&names)));
        }
    }
    Some(sides.join(" and "))
}

/// The first two variables that are true in a case.
pub(super) fn both_true(net: &Net, case: &Case) -> Option<[String; 2]> {
    let is_name = |name: &String| name.chars().all(|c| c.is_alphanumeric() || c == '_');
    let mut names = case.iter().filter(|(_, is)| *is).filter_map(|(atom, _)| in_words(net, (*atom)?)).filter(is_name);
    Some([names.next()?, names.next()?])
}

/// `step `4`` or `steps `4` and `5``; of many, the first.
pub(super) fn steps(net: &Net, steps: &[StepId]) -> String {
    let names: Vec<String> = steps.iter().take(SPELT_OUT).map(|step| net.places[*step].label.to_string()).collect();
    let more = if steps.len() > SPELT_OUT { format!(" (and {} more)", steps.len() - SPELT_OUT) } else { String::new() };
    format!("step{} {}{more}", if steps.len() == 1 { "" } else { "s" }, list(&names))
}

/// Transitions one after the other, as the chart draws them; of many, the last.
pub(super) fn way(net: &Net, way: &[TransitionId]) -> String {
    let from = way.len().saturating_sub(SPELT_OUT);
    let names: Vec<String> = way[from..].iter().map(|t| format!("`{}`", arrow(net, *t))).collect();
    format!("{}{}", if from > 0 { "…, " } else { "" }, names.join(", "))
}

/// Names in backquotes, the last after `and`: `a`, `b` and `c`.
fn list(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match quoted.split_last() {
        None => String::new(),
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} and {last}", others.join(", ")),
    }
}
