//! The net as text, to look at and to compare, at any stage: what a pass has removed is not there any more.
//!
//! Things are called as [`mod@grafc_model::dump`] calls them.

use crate::net::{Fact, Forced, Net, RankedOrder};
use grafc_model::chart::{GrafcetId, MacroId, Situation, StepId, TransitionId, VariableId};
use grafc_model::dump::{
    Labels, actions, arcs, claims, comment, designation, expression, list, name, section, variable,
};

/// The whole net.
pub fn dump(net: &Net) -> String {
    let mut out = format!("net {}{}\n", name(&net.name), comment(&net.comment));
    section(&mut out, "facts", net.facts.iter().map(|fact| words(*fact).to_owned()));
    section(&mut out, "variables", net.variables.iter().map(variable));
    section(&mut out, "grafcets", net.grafcets.indices().flat_map(|g| grafcet(net, g)));
    section(&mut out, "hierarchy", net.hierarchy.iter().map(|g| net.grafcet(*g)));
    section(&mut out, "places", net.places.indices().map(|s| place(net, s)));
    section(&mut out, "macro-steps", net.macro_steps.indices().map(|m| macro_step(net, m)));
    section(&mut out, "transitions", net.transitions.indices().map(|t| transition(net, t)));
    actions(&mut out, net, &net.continuous, &net.stored, &net.exprs);
    let orders = net.orders.iter().map(|order| {
        let situation = match &order.situation {
            Situation::Steps(steps) => places(net, steps),
            Situation::Current => "*".to_owned(),
            Situation::Initial => "INIT".to_owned(),
        };
        format!("{} forces {}{{{situation}}}", net.step(order.step), net.grafcet(order.grafcet))
    });
    section(&mut out, "orders", orders);
    if net.conflict_at_start {
        section(&mut out, "start", ["orders disagree on it".to_owned()]);
    }
    section(&mut out, "claims", claims(&net.claims, net));
    out
}

fn words(fact: Fact) -> &'static str {
    match fact {
        Fact::NoMacroSteps => "no macro-steps",
        Fact::RankedOrders => "ranked orders",
        Fact::SettledStart => "settled start",
        Fact::ClosedFreezing => "closed freezing",
        Fact::NoEnclosures => "no enclosures",
        Fact::NestedChildren => "nested children",
        Fact::NoTwoStepRings => "no two-step rings",
    }
}

fn grafcet(net: &Net, id: GrafcetId) -> Vec<String> {
    let grafcet = &net.grafcets[id];
    let within = grafcet.enclosing_step.map(|e| format!(" in {}", net.step(e))).unwrap_or_default();
    let mut lines = vec![format!("{}{within}, level {}{}", net.grafcet(id), grafcet.level, comment(&grafcet.comment))];
    lines.push(format!("  steps {}", places(net, &grafcet.steps)));
    lines.extend(grafcet.orders.iter().map(|order| format!("  {}", ranked(net, order))));
    lines.extend(grafcet.frozen_with.map(|g| format!("  frozen with {}", net.grafcet(g))));
    lines
}

/// An order on the grafcet that it stands with.
fn ranked(net: &Net, order: &RankedOrder) -> String {
    let situation = match &order.forced {
        Forced::Steps(steps) => places(net, steps),
        Forced::Current => "*".to_owned(),
    };
    format!("forced by {}: {{{situation}}}", net.step(order.step))
}

fn place(net: &Net, id: StepId) -> String {
    let place = &net.places[id];
    let flags = [(place.initial, "initial "), (place.activated, "activated "), (place.auxiliary, "auxiliary ")];
    let flags: String = flags.iter().filter(|(set, _)| *set).map(|(_, word)| *word).collect();
    format!(
        "{flags}{} of {}{}{}",
        net.step(id),
        net.grafcet(place.grafcet),
        within(net, &place.within),
        comment(&place.comment)
    )
}

fn macro_step(net: &Net, id: MacroId) -> String {
    let m = &net.macro_steps[id];
    let mut text = format!("{}: {} to {}", net.macro_step(id), net.step(m.entry), net.step(m.exit));
    let transitions = |list_: &[TransitionId]| list(list_.iter().map(|t| net.transition(*t)));
    for (word, names) in [
        ("places", places(net, &m.places)),
        ("inner", list(m.inner.iter().map(|m| net.macro_step(*m)))),
        ("entered by", transitions(&m.entered_by)),
        ("left by", transitions(&m.left_by)),
    ] {
        if !names.is_empty() {
            text.push_str(&format!("; {word} {names}"));
        }
    }
    text
}

fn transition(net: &Net, id: TransitionId) -> String {
    let t = &net.transitions[id];
    let (pre, post) = (places(net, &t.pre), places(net, &t.post));
    let condition = expression(&net.exprs, net, t.condition);
    let head = format!("{}: {} when {condition}", net.transition(id), arcs(&pre, &post));
    format!("{head}{}{}", within(net, &t.within), comment(&t.comment))
}

fn places(net: &Net, ids: &[StepId]) -> String {
    list(ids.iter().map(|s| net.step(*s)))
}

fn within(net: &Net, around: &[StepId]) -> String {
    if around.is_empty() {
        String::new()
    } else {
        format!(", within {}", around.iter().map(|e| net.step(*e)).collect::<Vec<_>>().join(" or "))
    }
}

impl Labels for Net {
    fn variable(&self, id: VariableId) -> String {
        name(&self.variables[id].name)
    }

    fn step(&self, id: StepId) -> String {
        name(&self.places[id].label)
    }

    fn macro_step(&self, id: MacroId) -> String {
        name(&self.macro_steps[id].label)
    }

    fn grafcet(&self, id: GrafcetId) -> String {
        name(&self.grafcets[id].name)
    }

    fn transition(&self, id: TransitionId) -> String {
        designation(self.transitions[id].designation.as_deref(), id)
    }
}

#[cfg(test)]
mod tests {
    use super::dump;
    use crate::{build, passes};
    use grafc_diagnostics::{Diagnostics, FileId};

    /// The lines below a heading.
    fn below<'t>(text: &'t str, heading: &str) -> Vec<&'t str> {
        let lines = text.lines().skip_while(|line| *line != heading).skip(1);
        lines.take_while(|line| !line.is_empty()).map(|line| &line[2..]).collect()
    }

    #[test]
    fn what_passes_leave_behind() {
        let text = "grafcet G1 { initial step 1 { force G2{3} } initial step 2 { force G2{} } transition 1 -> 2 : 1 }
            grafcet G2 { step 3 enclosing step 4 transition 3 -> 4 : 1 transition (back) 4 -> 3 : 1 }
            grafcet X4/G3 { activated step 5 }";
        let (tree, _) = grafc_syntax::parse(FileId::default(), text);
        let (chart, diagnostics) = grafc_model::check(&tree, "N");
        let mut net = build(&chart.unwrap_or_else(|| panic!("{diagnostics:?}")));
        let before = dump(&net);
        assert_eq!(below(&before, "orders"), ["1 forces G2{3}", "2 forces G2{}"]);
        assert_eq!(below(&before, "grafcets")[4..], ["G3 in 4, level 2", "  steps 5"]);

        passes::run(&mut net, true, &mut Diagnostics::new());
        let after = dump(&net);
        assert!(below(&after, "orders").is_empty(), "{after}");
        assert_eq!(
            below(&after, "grafcets"),
            [
                "G1, level 0",
                "  steps 1, 2",
                "G2, level 1",
                "  steps 3, 4, `4_3`",
                "  forced by 1: {3}",
                "  forced by 2: {}",
                "G3, level 2",
                "  steps 5",
                "  frozen with G2",
            ]
        );
        assert_eq!(
            below(&after, "places"),
            [
                "initial 1 of G1",
                "initial 2 of G1",
                "initial 3 of G2",
                "4 of G2",
                "activated 5 of G3, within 4",
                "auxiliary `4_3` of G2",
            ]
        );
        assert_eq!(
            below(&after, "transitions"),
            [
                "#1: 1 -> 2 when true",
                "#2: 3 -> 4 when true",
                "(back): 4 -> `4_3` when true",
                "#4: `4_3` -> 3 when true"
            ]
        );
        assert_eq!(below(&after, "start"), ["orders disagree on it"]);
    }
}
