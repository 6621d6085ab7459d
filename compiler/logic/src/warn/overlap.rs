//! Where the overlap of the r- and s-trigger can be seen.
//!
//! In these encodings a step goes one micro-step after its successor has come. The stable situations are those of the
//! rules all the same if
//! 1. evolution goes on until it is stable, so that the overlap is over by then;
//! 2. no condition depends on activities, or on variables that stored actions write: what is true when a token moves
//!    stays true while it overlaps. Edges of inputs are over by then, so they may not decide between two ways;
//! 3. for each transition, no step before it is ever active together with one after it: an active successor then means
//!    that the token has come from here, never that another one was there already; and the conditions of transitions
//!    that share a step exclude each other, so that none clears while the step overlaps;
//! 4. no enclosing step and no forcing step is among those that overlap;
//! 5. every reaction ends by itself, and not at its bound.
//!
//! Stored actions on deactivation or clearing see the overlap even then: they are done later, or more than once. So do
//! those whose event or value depends on activities, or on variables that other stored actions write.

use super::wording;
use crate::analysis::Analysis;
use crate::options::Options;
use grafc_diagnostics::{Code, Diagnostic, Span};
use grafc_model::chart::{Event, ExprId, ExprKind, Mode, VariableId};
use grafc_model::reaction::Evolution;
use grafc_net::Net;

/// One warning if the overlap can be seen, with the first place that shows it.
pub(crate) fn check(analysis: &Analysis, options: &Options) -> Option<Diagnostic> {
    let encoding = options.encoding.name();
    let (place, note) = match seen(analysis, options) {
        Some((place, why)) => {
            let overlap =
                "in this encoding a step stays active for one micro-step together with the step that follows it";
            (place, format!("{overlap}; {why}"))
        }
        None => endless(analysis, options)?,
    };
    Some(
        Diagnostic::new(Code::W0413, place, format!("the overlap of `{encoding}` can be seen in this chart"))
            .note(note)
            .help("use `--encoding single-phase`, `sequent` or `switch`, which do exactly what the chart means"),
    )
}

/// A reaction that may be given up at its bound. It is then where it happens to be, and that depends on how many
/// micro-steps a token takes; where resetting wins, a circle of transitions that all hold even loses it.
fn endless(analysis: &Analysis, options: &Options) -> Option<(Span, String)> {
    let net = analysis.net();
    let steps = net.places.len() + net.transitions.len() + 1;
    let bound = options.profile.bound.map_or(steps.max(200), |bound| bound as usize);
    let transients = analysis.transients();
    // A token that takes two micro-steps for one needs twice as many.
    if transients.longest.is_some_and(|longest| 2 * longest as usize <= bound) {
        return None;
    }
    let lost = "a reaction that is given up at its bound (LIVELOCK) ends in another situation than the rules say, and a \
                step may be lost for good";
    let liveness = analysis.liveness();
    if let Some((ring, first)) = liveness.rings.iter().find_map(|ring| Some((ring, ring.transitions.first()?))) {
        let row = wording::case(net, &ring.row).filter(|row| !row.is_empty());
        let row = row.map_or("with one row of inputs".to_owned(), |row| format!("while {row}"));
        let place = net.transitions[*first].span;
        return Some((place, format!("{row}, transitions are cleared in a circle without end; {lost}")));
    }
    let first =
        transients.cycle.iter().chain(&transients.chain).find(|t| !net.transitions[**t].span.range().is_empty());
    let place = first.map(|t| net.transitions[*t].span).or(net.places.first().map(|place| place.span))?;
    Some((place, format!("it is not proved that every reaction ends within its bound of {bound} micro-steps; {lost}")))
}

fn seen(analysis: &Analysis, options: &Options) -> Option<(Span, String)> {
    let net = analysis.net();
    let start = net.places.first().map(|p| p.span)?;
    if analysis.net().options.over(options.profile).evolution == Evolution::Scan {
        return Some((start, "with `--evolution scan` it is there at the end of a call".to_owned()));
    }
    if let Some(grafcet) = net.grafcets.iter().find(|g| g.steps.iter().any(|s| !net.places[*s].within.is_empty())) {
        let what = if grafcet.child { "child" } else { "enclosure" };
        return Some((grafcet.span, format!("the {what} `{}` sees both of the grafcet around it", grafcet.name)));
    }
    if let Some(order) = net.grafcets.iter().find_map(|g| g.orders.first()) {
        return Some((order.span, "a forcing order acts while both are active".to_owned()));
    }
    for action in &net.stored {
        match action.event {
            Event::EachScan(..) => {
                return Some((action.span, "an action each scan is done while both are active".to_owned()));
            }
            Event::Deactivation(_) | Event::Clearing(_) => {
                let why = "an action on deactivation or on clearing is done later or more than once";
                return Some((action.span, why.to_owned()));
            }
            Event::Event(_, event) => {
                if let Some((place, why)) = read(net, event, false, None) {
                    return Some((place, why.to_owned()));
                }
            }
            Event::Activation(_) => {}
        }
        if let Some((place, why)) = read(net, action.value, false, Some(action.target)) {
            return Some((place, why.to_owned()));
        }
    }
    for (t, transition) in net.transitions.iter_enumerated() {
        let several = transition.pre.iter().any(|s| analysis.arcs.leaving(*s).len() > 1);
        if let Some((place, why)) = read(net, transition.condition, several, None) {
            return Some((place, why.to_owned()));
        }
        for before in &transition.pre {
            for after in transition.post.iter().filter(|after| *after != before) {
                // Where steps overlap, only conditions keep a transition from clearing after another one has.
                if !analysis.never_together(*before, *after) || !analysis.rivals.of(t).is_empty() {
                    let (a, b) = (&net.places[*before].label, &net.places[*after].label);
                    let why = format!("it is not proved that step {b} is active only after step {a} has been left");
                    return Some((transition.span, why));
                }
            }
        }
    }
    None
}

/// What a condition, an event or the value given to a variable reads that the overlap changes. `several`: it decides
/// between several transitions. A value may read what it replaces.
fn read(net: &Net, root: ExprId, several: bool, replaced: Option<VariableId>) -> Option<(Span, &'static str)> {
    let mut stack = vec![root];
    while let Some(e) = stack.pop() {
        let expr = &net.exprs[e];
        let why = match &expr.kind {
            ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_) => Some("an activity is read here"),
            ExprKind::Variable(v) => match net.variables[*v].mode {
                Mode::Given => None,
                Mode::Stored if replaced == Some(*v) => None,
                Mode::Wire | Mode::Stored => Some("what actions write is read here"),
            },
            ExprKind::Rise(_) | ExprKind::Fall(_) => {
                several.then_some("an edge decides here between several transitions, and is over while the step stays")
            }
            ExprKind::Literal(_)
            | ExprKind::Not(_)
            | ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Delay { .. }
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => None,
        };
        if let Some(why) = why {
            return Some((expr.span, why));
        }
        stack.extend(expr.kind.operands());
    }
    None
}
