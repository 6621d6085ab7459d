//! W0411: pulse orders of different kinds that one event gives to one grafcet.
//!
//! Together they raise FORCE_CONFLICT (R15), except that a kill with a start is a restart. Of charts with pulse orders
//! nothing is proved about which steps exclude each other, so this tells only of what is certain: orders of one event, and
//! of events that one clearing brings about.
//!
//! Warned of: `freeze P on deactivation` in step 1 and `resume P on activation` in step 2, with a transition from 1 to 2
//! Not warned of: `start P on activation` and `kill P on activation` of one step, which restart P

use crate::analysis::Analysis;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use grafc_model::chart::{Event, GrafcetId, PulseKind, StepId, TransitionId};
use grafc_net::Net;
use rustc_hash::{FxHashMap, FxHashSet};

/// A pulse order that an event gives.
#[derive(Clone, Copy)]
struct Given {
    grafcet: GrafcetId,
    kind: PulseKind,
    span: Span,
}

/// What clearings bring about.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Cause {
    Activation(StepId),
    Deactivation(StepId),
    Clearing(TransitionId),
}

/// One warning per commanded grafcet.
pub(super) fn check(analysis: &Analysis, diagnostics: &mut Diagnostics) {
    let net = analysis.net();
    let mut by_cause: FxHashMap<Cause, Vec<Given>> = FxHashMap::default();
    for pulse in &net.pulses {
        let given = Given { grafcet: pulse.grafcet, kind: pulse.kind, span: pulse.span };
        let cause = match pulse.event {
            Event::Activation(step) => Cause::Activation(step),
            Event::Deactivation(step) => Cause::Deactivation(step),
            Event::Clearing(transition) => Cause::Clearing(transition),
            Event::Event(..) | Event::EachScan(..) => continue,
        };
        by_cause.entry(cause).or_default().push(given);
    }
    if by_cause.is_empty() {
        return;
    }
    let mut told = FxHashSet::default();
    let of_cause = |cause: Cause| by_cause.get(&cause).into_iter().flatten().copied();
    // The initial steps are activated by no clearing.
    for step in net.places.indices() {
        tell(net, of_cause(Cause::Activation(step)), &mut told, diagnostics);
    }
    for (id, transition) in net.transitions.iter_enumerated() {
        let left = transition.pre.iter().filter(|step| !transition.post.contains(step));
        let entered = transition.post.iter().filter(|step| !transition.pre.contains(step));
        let given = left.flat_map(|step| of_cause(Cause::Deactivation(*step)));
        let given = given.chain(of_cause(Cause::Clearing(id)));
        tell(net, given.chain(entered.flat_map(|step| of_cause(Cause::Activation(*step)))), &mut told, diagnostics);
    }
}

/// Tells of the first two orders on a grafcet that contradict each other.
fn tell(net: &Net, given: impl Iterator<Item = Given>, told: &mut FxHashSet<GrafcetId>, diagnostics: &mut Diagnostics) {
    // The first order of each kind on each grafcet.
    let mut first: FxHashMap<GrafcetId, Vec<Given>> = FxHashMap::default();
    for order in given {
        let known = first.entry(order.grafcet).or_default();
        if known.iter().any(|other| other.kind == order.kind) {
            continue;
        }
        let other = known.iter().find(|other| !is_restart(other.kind, order.kind)).copied();
        known.push(order);
        let Some(other) = other.filter(|_| told.insert(order.grafcet)) else { continue };
        let name = &net.grafcets[order.grafcet].name;
        let message = format!("`{} {name}` and `{} {name}` are given at once", other.kind.word(), order.kind.word());
        diagnostics.push(
            Diagnostic::new(Code::W0411, order.span, message)
                .also(other.span, "this order is given by the same event")
                .note(
                    "they take effect in the order kill, resume, start, freeze, and the flag FORCE_CONFLICT is raised",
                ),
        );
    }
}

/// Whether two orders together restart their grafcet.
fn is_restart(a: PulseKind, b: PulseKind) -> bool {
    matches!((a, b), (PulseKind::Kill, PulseKind::Start) | (PulseKind::Start, PulseKind::Kill))
}

#[cfg(test)]
mod tests {
    use crate::analysis::Analysis;
    use grafc_diagnostics::{Diagnostics, FileId};
    use grafc_net::passes;

    fn warns(first: &str, second: &str, transition: &str) -> bool {
        let text = format!(
            "chart C evolution scan input a, b : bool grafcet MAIN {{ initial step 1 {{ {first} }} step 2 {{ {second} }}
             transition 1 -> 2 : a {{ {transition} }} transition 2 -> 1 : not a }}
             child grafcet P of MAIN {{ initial step 10 step 11 transition 10 -> 11 : b transition 11 -> 10 : not b }}"
        );
        let (tree, faults) = grafc_syntax::parse(FileId::new(0), &text);
        let (chart, said) = grafc_model::check(&tree, "test");
        let chart = chart.unwrap_or_else(|| panic!("{text} has errors: {faults:?} {said:?}"));
        let mut net = grafc_net::build(&chart);
        passes::run(&mut net, false, &mut Diagnostics::new());
        crate::warn(&Analysis::new(net)).iter().any(|warning| warning.code.as_str() == "W0411")
    }

    #[test]
    fn orders_of_one_event() {
        assert!(warns("", "start P on activation freeze P on activation", ""));
        assert!(warns("start P on activation freeze P on activation", "", ""));
        assert!(!warns("", "kill P on activation start P on activation", ""));
        assert!(warns("", "kill P on activation start P on activation freeze P on activation", ""));
        assert!(!warns("", "start P on activation start P on activation", ""));
        assert!(!warns("", "start P on activation freeze P on deactivation", ""));
    }

    #[test]
    fn orders_that_one_clearing_brings_about() {
        assert!(warns("freeze P on deactivation", "resume P on activation", ""));
        assert!(warns("", "resume P on activation", "freeze P"));
        assert!(warns("kill P on deactivation", "", "freeze P"));
        assert!(!warns("kill P on deactivation", "start P on activation", ""));
        // Step 1 is entered by the other transition.
        assert!(!warns("freeze P on activation", "resume P on activation", ""));
        assert!(!warns("", "freeze P on event ↑b resume P on event ↓b", ""));
    }
}
