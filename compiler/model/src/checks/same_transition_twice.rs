//! W0421: a transition is written twice.
//!
//! Two transitions with the same steps before and after, the same condition and the same actions and orders clear together,
//! and the second changes nothing. Most often a line was copied and not changed.
//!
//! Warned of: `transition 1 -> 2 : a` twice
//! Not warned of: `transition 1 -> 2 : a`, `transition 1 -> 2 : b`

use super::likeness::likeness;
use crate::chart::{Event, ExprId, GrafcetId, Node, PulseKind, TransitionId, VariableId};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// What a clearing does: stores a value, gives a pulse order.
#[derive(PartialEq, Eq, Hash)]
enum Deed {
    Stores(VariableId, usize),
    Orders(PulseKind, GrafcetId),
}

/// What makes two transitions the same: the condition, steps in any order, what is done.
type Key = (usize, Vec<Node>, Vec<Node>, Vec<Deed>);

/// One warning per transition that was there before.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    // Only those that are alike at a glance are looked at more closely.
    let glance = |id: &TransitionId| {
        let transition = &chart.transitions[*id];
        (transition.pre.iter().min(), transition.post.iter().min())
    };
    let mut order: Vec<TransitionId> = chart.transitions.indices().collect();
    order.sort_by_key(glance);
    let alike: Vec<&[TransitionId]> =
        order.chunk_by(|a, b| glance(a) == glance(b)).filter(|alike| alike.len() > 1).collect();
    if alike.is_empty() {
        return;
    }
    let likeness: IndexVec<ExprId, usize> = likeness(&chart.exprs);
    let stored = chart.stored.iter().map(|action| (action.event, Deed::Stores(action.target, likeness[action.value])));
    let ordered = chart.pulses.iter().map(|pulse| (pulse.event, Deed::Orders(pulse.kind, pulse.grafcet)));
    let mut deeds: FxHashMap<TransitionId, Vec<Deed>> = FxHashMap::default();
    for (event, deed) in stored.chain(ordered) {
        if let Event::Clearing(t) = event {
            deeds.entry(t).or_default().push(deed);
        }
    }
    let sorted = |nodes: &[Node]| {
        let mut nodes = nodes.to_vec();
        nodes.sort_unstable();
        nodes
    };
    for alike in alike {
        let mut first_of: FxHashMap<Key, TransitionId> = FxHashMap::default();
        for id in alike.iter().copied() {
            let transition = &chart.transitions[id];
            let deeds = deeds.remove(&id).unwrap_or_default();
            let key = (likeness[transition.condition], sorted(&transition.pre), sorted(&transition.post), deeds);
            let first = *first_of.entry(key).or_insert(id);
            if first != id {
                diagnostics.push(
                    Diagnostic::new(Code::W0421, transition.span, "this transition is there already")
                        .also(chart.transitions[first].span, "the same steps, condition and actions")
                        .help("leave one of the two out, or correct what was to be different")
                        .fix(Fix::maybe("leave it out").delete(transition.span)),
                );
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{passes, passes_with};

    const STEPS: &str = "input a, b : bool var n : int initial step 1 step 2 step 3 ";

    #[test]
    fn the_same() {
        passes_with(&["W0421"], &format!("{STEPS} transition 1 -> 2 : a · b transition (7) 1 -> 2 : b and a"));
        passes_with(&["W0421"], &format!("{STEPS} transition 1, 2 -> 3 : 3s/a transition 2, 1 -> 3 : 3s/a"));
        let actions = "transition 1 -> 2 : a { n := n + 1 } transition 1 -> 2 : a { n := n + 1 }";
        passes_with(&["W0421"], &format!("{STEPS} {actions}"));
    }

    #[test]
    fn something_is_different() {
        passes(&format!("{STEPS} transition 1 -> 2 : a transition 1 -> 2 : b"));
        passes(&format!("{STEPS} transition 1 -> 2 : a transition 1 -> 3 : a"));
        passes(&format!("{STEPS} transition 1 -> 2 : 3s/a transition 1 -> 2 : 4s/a"));
        passes(&format!("{STEPS} transition 1 -> 2 : a {{ n := 1 }} transition 1 -> 2 : a {{ n := 2 }}"));
    }

    #[test]
    fn an_order_is_different() {
        let with = |first: &str, second: &str| {
            format!(
                "input a, b : bool grafcet G1 {{ initial step 1 step 2 transition 1 -> 2 : a {first}
                 transition 1 -> 2 : a {second} transition 2 -> 1 : b }} child grafcet P of G1 {{ initial step 10 }}"
            )
        };
        passes(&with("", "{ start P }"));
        passes(&with("{ kill P }", "{ start P }"));
        passes_with(&["W0421"], &with("{ start P }", "{ start P }"));
    }
}
