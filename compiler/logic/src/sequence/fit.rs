//! What the structure of a sequential function chart must not have.

use super::Reasons;
use crate::analysis::Analysis;
use crate::analysis::together::reentry::may_reenter;
use grafc_model::reaction::Profile;
use grafc_net::Net;

/// What is seen of the chart itself.
pub(super) fn form(net: &Net, reasons: &mut Reasons) {
    controls(net, reasons);
    assertions(net, reasons);
    momentary(net, reasons);
    transitions(net, reasons);
}

/// What is proved of it.
pub(super) fn meaning(analysis: &Analysis, profile: Profile, reasons: &mut Reasons) {
    let net = analysis.net();
    selections(analysis, reasons);
    for (t, s) in may_reenter(analysis) {
        let label = &net.places[s].label;
        reasons.add(
            net.transitions[t].span,
            format!("may lead to step `{label}` while it is active: its actions start again"),
        );
    }
    evolution(analysis, profile, reasons);
}

fn controls(net: &Net, reasons: &mut Reasons) {
    let place = net.places.first().map_or_else(Default::default, |place| place.span);
    if net.controls.reset.is_some() {
        reasons.add(place, "is to be started anew by an input (`--reset-input`)");
    }
    if net.controls.clear_flags.is_some() {
        reasons.add(place, "has no flags that an input could lower (`--clear-flags-input`)");
    }
}

fn assertions(net: &Net, reasons: &mut Reasons) {
    if net.controls.assertion.is_some() {
        let place = net.places.first().map_or_else(Default::default, |place| place.span);
        reasons.add(place, "has nowhere to check assertions (`--check-assertions`)");
    }
}

fn momentary(net: &Net, reasons: &mut Reasons) {
    for variable in net.variables.iter().filter(|variable| variable.momentary) {
        reasons.add(variable.span, "an output on arcs, which is of one reaction");
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
            reasons.add(transition.span, "leads back to a step that it leaves: its actions start again");
        }
    }
}

fn selections(analysis: &Analysis, reasons: &mut Reasons) {
    let (net, together) = (analysis.net(), analysis.together());
    for clashes in &together.clearings {
        for pair in clashes.pairs.iter().take(1) {
            let place = net.transitions[pair.second].span;
            reasons.add(place, "may clear together with another transition after its step");
        }
    }
    for meeting in together.races.iter().chain(&together.conflicts) {
        reasons.add(net.stored[meeting.second].span, "may happen together with another action on it");
    }
    for s in net.places.indices().filter(|s| analysis.rivals.many(*s)) {
        reasons.add(net.places[s].span, "has too many transitions after it to know that only one clears");
    }
}

/// To stability, one evolution must be proved to be enough.
fn evolution(analysis: &Analysis, profile: Profile, reasons: &mut Reasons) {
    if analysis.may_repeat(profile) {
        let place = analysis.net().transitions.first().map_or_else(Default::default, |transition| transition.span);
        reasons.add(place, "may need several evolutions in one call; `--evolution scan` asks for one");
    }
}
