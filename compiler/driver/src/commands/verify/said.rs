//! What is said of a claim that fails.

use grafc_verify::{Kind, Trace, Verdict};

/// In one sentence, without its end.
pub fn fault(verdict: &Verdict, trace: Option<&Trace>) -> String {
    let element = verdict.claim.element.as_deref().unwrap_or_default();
    let last = trace.and_then(|trace| trace.rows.last());
    let is_livelock = last.is_some_and(|row| row.steps.is_none());
    let at = last.and_then(|row| row.steps.as_deref());
    let at = situation(at.unwrap_or_default());
    match verdict.claim.kind {
        Kind::Livelock => "a reaction does not end".to_string(),
        Kind::Deadlock => format!("from {at} no other situation can be reached"),
        Kind::Home => format!("from {at} no initial situation can be reached"),
        Kind::Conflict if element == "orders" => "two orders on a grafcet ask for different situations".to_string(),
        Kind::Conflict => "two stored actions give a variable different values".to_string(),
        Kind::DeadTransition => "it is never cleared".to_string(),
        Kind::DeadStep => "it is never active".to_string(),
        Kind::Selection => "two transitions after it are cleared together".to_string(),
        Kind::Reentry => "it is entered while it is active".to_string(),
        Kind::Assert => format!("in {at} it is not true"),
        Kind::Leads if is_livelock => "a reaction does not end before it is reached".to_string(),
        Kind::Leads => format!("from {at} it can no longer be reached"),
        Kind::Reach => "it is true in no state".to_string(),
    }
}

/// `{1, 11}`
pub fn situation(steps: &[String]) -> String {
    format!("{{{}}}", steps.join(", "))
}
