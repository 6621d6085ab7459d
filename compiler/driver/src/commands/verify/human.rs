//! The answers for people.

use super::said::{fault, situation};
use grafc_verify::{Answer, Kind, Trace, Verdict, Verified, cell};
use std::fmt::Write as _;

/// A line a claim; those of steps and transitions that hold in one line a kind. Under each that fails its trace.
pub fn human(chart: &str, verified: &Verified) -> String {
    let mut out = String::new();
    let searched = &verified.searched;
    let more = if searched.limit.is_some() { ", and there are more" } else { "" };
    let _ = writeln!(out, "{chart}: {} states{more}", searched.states);
    let mut rest = verified.verdicts.as_slice();
    while let Some(first) = rest.first() {
        let kind = first.claim.kind;
        let (of_kind, others) = rest.split_at(rest.iter().take_while(|v| v.claim.kind == kind).count());
        rest = others;
        of_one_kind(kind, of_kind, &mut out);
    }
    if verified.stops_at_livelock && verified.verdicts.iter().any(|v| matches!(v.answer, Answer::Holds)) {
        out.push_str("What comes after a reaction that does not end is not looked at.\n");
    }
    let count = |is: fn(&Verdict) -> bool| verified.verdicts.iter().filter(|v| is(v)).count();
    let holds = count(|v| v.answer == Answer::Holds);
    let fails = count(|v| matches!(v.answer, Answer::Fails(_)) && !v.claim.kind.is_note());
    let notes = count(|v| matches!(v.answer, Answer::Fails(_)) && v.claim.kind.is_note());
    let open = count(|v| matches!(v.answer, Answer::Open(_)));
    let _ = write!(out, "{holds} hold");
    for (count, what) in [(fails, "fail"), (notes, "fail as notes"), (open, "open")] {
        if count > 0 {
            let _ = write!(out, ", {count} {what}");
        }
    }
    out.push('\n');
    out
}

fn of_one_kind(kind: Kind, verdicts: &[Verdict], out: &mut String) {
    let holding = verdicts.iter().filter(|v| v.answer == Answer::Holds && is_of_element(v)).count();
    let mut is_told = holding == 0;
    for verdict in verdicts {
        let name = name(verdict);
        match &verdict.answer {
            Answer::Holds if is_of_element(verdict) => {
                if !std::mem::replace(&mut is_told, true) {
                    let _ = writeln!(out, "holds  {}: {}", kind.name(), of(holding, verdicts.len()));
                }
            }
            Answer::Holds => _ = writeln!(out, "holds  {name}"),
            Answer::Fails(trace) => {
                let note = if kind.is_note() { "note" } else { "fails" };
                let _ = writeln!(out, "{note:5}  {name}: {}", fault(verdict, trace.as_ref()));
                trace.iter().for_each(|trace| rows(trace, out));
            }
            Answer::Open(reason) => _ = writeln!(out, "open   {name}: {reason}"),
        }
    }
}

/// One that is written in the chart, with its keyword.
fn name(verdict: &Verdict) -> String {
    let name = &verdict.claim.name;
    match verdict.claim.kind {
        Kind::Assert | Kind::Leads => format!("assert {name}"),
        Kind::Reach => format!("reach {name}"),
        Kind::Livelock
        | Kind::Deadlock
        | Kind::Home
        | Kind::Conflict
        | Kind::DeadTransition
        | Kind::DeadStep
        | Kind::Selection
        | Kind::Reentry => name.clone(),
    }
}

/// Of steps and transitions there may be many.
fn is_of_element(verdict: &Verdict) -> bool {
    verdict.claim.element.is_some() && verdict.claim.span.is_some()
}

fn of(count: usize, all: usize) -> String {
    if count == all { format!("all {all}") } else { format!("{count} of {all}") }
}

/// Row by row: the time, the inputs that change, the situation.
fn rows(trace: &Trace, out: &mut String) {
    let mut before: Option<&[_]> = None;
    for row in &trace.rows {
        let names = trace.inputs.iter().zip(&row.inputs).enumerate();
        let is_new = |place: usize| before.is_none_or(|before| before[place] != row.inputs[place]);
        let changed: Vec<String> = names
            .filter(|(place, _)| is_new(*place))
            .map(|(_, (name, value))| format!("{name} = {}", cell(*value)))
            .collect();
        let to = row.steps.as_ref().map_or_else(|| "LIVELOCK".to_string(), |steps| situation(steps));
        let inputs = if changed.is_empty() { "no input changes".to_string() } else { changed.join(", ") };
        let _ = writeln!(out, "       {} ms: {inputs} -> {to}", row.t_ms);
        before = Some(&row.inputs);
    }
}
