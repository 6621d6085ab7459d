//! Statements under headings that say which grafcet they are about.

use crate::lower::Lowering;
use crate::scan::{Heading, Origin, Part, Statement, origin_of};
use grafc_model::chart::{Event, GrafcetId, StepId, VariableId};
use grafc_net::Net;

/// Adds statements of which each stands for itself: those of a grafcet come together, in the order of the grafcets, and those
/// of none last.
pub(crate) fn sorted(out: &mut Vec<Statement>, lowering: &Lowering, part: Part, mut statements: Vec<Statement>) {
    if lowering.net.grafcets.len() > 1 {
        let key = |statement: &Statement| grafcet_of(&lowering.net, statement).map_or(usize::MAX, GrafcetId::index);
        statements.sort_by_cached_key(key);
    }
    headed(out, lowering, part, statements);
}

/// Adds statements that stay in their order. Those of no grafcet belong to what is before them, the first to what follows.
pub(crate) fn headed(out: &mut Vec<Statement>, lowering: &Lowering, part: Part, statements: Vec<Statement>) {
    let count = lowering.net.grafcets.len();
    let of = |statement: &Statement| if count > 1 { grafcet_of(&lowering.net, statement) } else { None };
    let mut first = None;
    let mut changes = 0;
    statements.iter().filter_map(of).fold(None, |now, g| {
        first = first.or(Some(g));
        changes += usize::from(now != Some(g));
        Some(g)
    });
    // Where they come all mixed up, headings are of no use.
    let useful = changes <= 2 * count;
    out.reserve_exact(statements.len() + changes + 1);
    let mut now = None;
    let mut is_first = true;
    for statement in statements {
        let of = if is_first { first } else { of(&statement) }.filter(|_| useful);
        if std::mem::take(&mut is_first) || (of.is_some() && of != now) {
            out.push(Statement::Heading(of.map_or(part.of_all(), |g| Heading::Of(part, g))));
            now = of;
        }
        out.push(statement);
    }
}

/// The grafcet that a statement is about, if it is one.
fn grafcet_of(net: &Net, statement: &Statement) -> Option<GrafcetId> {
    let origin = match statement {
        Statement::Heading(_) => Origin::Chart,
        Statement::Assign { origin, .. } | Statement::CallTimer { origin, .. } => *origin,
        Statement::Divide(division) => division.origin,
        Statement::Case { arms, .. } => arms.first().map_or(Origin::Chart, |arm| arm.origin),
        Statement::If(choice) => choice.branches.first().map_or(Origin::Chart, |(_, body)| origin_of(body)),
    };
    of_origin(net, origin)
}

fn of_origin(net: &Net, origin: Origin) -> Option<GrafcetId> {
    let of_step = |s: StepId| net.places[s].grafcet;
    let of_event = |event: Event| match event {
        Event::Event(s, _) | Event::Deactivation(s) | Event::Activation(s) | Event::EachScan(s, _) => of_step(s),
        Event::Clearing(t) => net.transitions[t].grafcet,
    };
    match origin {
        Origin::Step(s) => Some(of_step(s)),
        Origin::Transition(t) => Some(net.transitions[t].grafcet),
        Origin::Action(a) => match a.index().checked_sub(net.continuous.len()) {
            None => net.continuous.get(a.index()).map(|action| of_step(action.step)),
            Some(index) => net.stored.get(index).map(|action| of_event(action.event)),
        },
        Origin::Orders(g) => Some(g),
        Origin::Chart | Origin::Actions(_) | Origin::Order(_) | Origin::Declaration(_) => None,
    }
}

/// Wires by the grafcet whose steps set them; those that several set come last.
pub(crate) fn wires(
    lowering: &Lowering,
    wires: impl Iterator<Item = VariableId>,
) -> Vec<(Option<GrafcetId>, VariableId)> {
    let net = &*lowering.net;
    let mut of: Vec<Option<Option<GrafcetId>>> = vec![None; net.variables.len()];
    for action in &net.continuous {
        let entry = &mut of[action.target.index()];
        let g = Some(net.places[action.step].grafcet);
        *entry = Some(if entry.is_none_or(|known| known == g) { g } else { None });
    }
    let mut wires: Vec<(Option<GrafcetId>, VariableId)> = wires.map(|v| (of[v.index()].flatten(), v)).collect();
    if net.grafcets.len() > 1 {
        wires.sort_by_key(|(g, _)| g.map_or(usize::MAX, GrafcetId::index));
    }
    wires
}
