//! What the structure of a sequential function chart must not have.

use super::Reasons;
use crate::compile;
use crate::options::Options;
use crate::warn;
use grafc_diagnostics::Code;
use grafc_model::chart::{StepId, TransitionId};
use grafc_model::reaction::{Evolution, Profile};
use grafc_net::Net;
use index_vec::IndexVec;

/// Of more transitions after one step the conditions are not all compared.
const MOST_BRANCHES: usize = 16;

pub(super) fn check(net: &Net, profile: Profile, reasons: &mut Reasons) {
    hierarchy(net, reasons);
    transitions(net, reasons);
    selections(net, reasons);
    for (t, s) in warn::may_reenter(net) {
        let label = &net.places[s].label;
        reasons.add(
            net.transitions[t].span,
            format!("may lead to step `{label}` while it is active: its actions begin anew"),
        );
    }
    evolution(net, profile, reasons);
}

fn hierarchy(net: &Net, reasons: &mut Reasons) {
    for grafcet in &net.grafcets {
        for order in &grafcet.orders {
            reasons.add(order.span, "a forcing order");
        }
        if grafcet.steps.iter().any(|s| net.places[*s].within.is_some()) {
            reasons.add(grafcet.span, "an enclosure");
        }
    }
}

fn transitions(net: &Net, reasons: &mut Reasons) {
    for transition in &net.transitions {
        if transition.pre.is_empty() {
            reasons.add(transition.span, "a source transition");
        }
        if transition.post.is_empty() {
            reasons.add(transition.span, "a sink transition");
        }
        if transition.pre.iter().any(|s| transition.post.contains(s)) {
            reasons.add(transition.span, "leads back to a step that it leaves: its actions begin anew");
        }
    }
}

fn selections(net: &Net, reasons: &mut Reasons) {
    for said in &warn::warn(net) {
        match said.code {
            Code::W0409 => reasons.add(said.primary.span, "may clear together with another transition after its step"),
            Code::W0410 | Code::W0412 => {
                reasons.add(said.primary.span, "may happen together with another action on it")
            }
            _ => {}
        }
    }
    let mut leaving: IndexVec<StepId, Vec<TransitionId>> = net.places.iter().map(|_| Vec::new()).collect();
    for (t, transition) in net.transitions.iter_enumerated() {
        transition.pre.iter().for_each(|s| leaving[*s].push(t));
    }
    for (s, after) in leaving.iter_enumerated().filter(|(_, after)| after.len() > 1) {
        if after.len() > MOST_BRANCHES {
            reasons.add(net.places[s].span, "has too many transitions after it to know that only one clears");
        }
        for t in after.iter().filter(|t| net.transitions[**t].pre.len() > 1) {
            reasons.add(net.transitions[*t].span, "joins a step that another transition leaves, too");
        }
    }
}

/// To stability, one evolution must be proved to be enough.
fn evolution(net: &Net, profile: Profile, reasons: &mut Reasons) {
    let several = match profile.evolution {
        Evolution::Scan => false,
        Evolution::Stable => {
            let (program, _) = compile::compile(net, &Options { profile, ..Options::default() });
            program.is_none_or(|program| program.repeat.is_some())
        }
    };
    if several {
        let place = net.transitions.first().map_or_else(Default::default, |transition| transition.span);
        reasons.add(place, "may need several evolutions in one call; `--evolution scan` asks for one");
    }
}
