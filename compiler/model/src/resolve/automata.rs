//! Automata as what they mean: grafcets of steps and transitions.
//!
//! An automaton is in one state. Of the arcs that leave it the first one goes whose condition is true: each later one waits
//! until those before it do not, so their transition-conditions exclude each other. An output on an arc is published by the
//! call that takes the arc. As `evolution scan` has one micro-step a call, there each transition gives each such output its
//! value, and in a call that takes no arc a transition from the state to itself makes them false. To stability a call may take
//! several arcs: each makes its outputs true, and each reaction begins with all of them false.
//!
//! What is made here has an empty place, behind what it is made of: nothing is said of it.

use crate::reaction::Evolution;
use ecow::EcoString;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use grafc_syntax::ast::{
    ActionKind, Assignment, BinaryOp, Chart, ChartOptionKind, Clearing, Expr, ExprId, ExprKind, Exprs, Grafcet, Item,
    Name, Step, StepKind, StepMark, Transition,
};
use rustc_hash::{FxHashMap, FxHashSet};
use smallvec::smallvec;

/// No more arcs leave a state: each waits for all before it.
const MOST_ARCS: usize = 500;

/// A chart whose automata are grafcets.
pub struct Expanded {
    /// The chart.
    pub chart: Chart,
    /// What is wrong with its automata.
    pub faults: Diagnostics,
    /// The outputs on arcs that each reaction begins with as false.
    pub momentary: FxHashSet<EcoString>,
}

/// A chart with its automata as grafcets; none if it has no automata.
pub fn expand(tree: &Chart) -> Option<Expanded> {
    if !tree.items.iter().any(|item| matches!(item, Item::Grafcet(grafcet) if grafcet.automaton)) {
        return None;
    }
    let mut made = tree.clone();
    let chosen = tree.heading.iter().flat_map(|heading| &heading.options);
    let evolution = chosen.map(|option| option.kind).find_map(|kind| match kind {
        ChartOptionKind::Evolution { scan } => Some(if scan { Evolution::Scan } else { Evolution::Stable }),
        _ => None,
    });
    let mut expander = Expander {
        exprs: &mut made.exprs,
        diagnostics: Diagnostics::new(),
        evolution,
        declared: declared(tree),
        forced: forced(tree),
        momentary: FxHashSet::default(),
    };
    for item in &mut made.items {
        match item {
            Item::Grafcet(grafcet) if grafcet.automaton => expander.automaton(grafcet),
            Item::Grafcet(_)
            | Item::Declaration(_)
            | Item::Expansion(_)
            | Item::Step(_)
            | Item::Transition(_)
            | Item::Allow(_)
            | Item::Claim(_)
            | Item::Scenario(_) => {}
        }
    }
    let Expander { diagnostics: faults, momentary, .. } = expander;
    Some(Expanded { chart: made, faults, momentary })
}

/// All names that are declared.
fn declared(tree: &Chart) -> FxHashSet<EcoString> {
    let declarations = tree.items.iter().filter_map(|item| match item {
        Item::Declaration(declaration) => Some(&declaration.names),
        Item::Grafcet(_)
        | Item::Expansion(_)
        | Item::Step(_)
        | Item::Transition(_)
        | Item::Allow(_)
        | Item::Claim(_)
        | Item::Scenario(_) => None,
    });
    declarations.flatten().map(|declared| declared.name.text.clone()).collect()
}

/// The grafcets that orders force or command.
fn forced(tree: &Chart) -> FxHashSet<EcoString> {
    let mut forced = FxHashSet::default();
    let mut lists = vec![&tree.items];
    while let Some(items) = lists.pop() {
        for item in items {
            match item {
                Item::Grafcet(grafcet) => lists.push(&grafcet.items),
                Item::Expansion(expansion) => lists.push(&expansion.items),
                Item::Step(step) => {
                    for action in &step.actions {
                        match &action.kind {
                            ActionKind::Force { grafcet, .. }
                            | ActionKind::Pulse { grafcet, .. }
                            | ActionKind::Run { grafcet } => _ = forced.insert(grafcet.text.clone()),
                            ActionKind::Continuous { .. } | ActionKind::Stored { .. } => {}
                        }
                    }
                }
                Item::Transition(transition) => {
                    forced.extend(transition.pulses().iter().map(|pulse| pulse.grafcet.text.clone()));
                }
                Item::Declaration(_) | Item::Allow(_) | Item::Claim(_) | Item::Scenario(_) => {}
            }
        }
    }
    forced
}

struct Expander<'t> {
    exprs: &'t mut Exprs,
    diagnostics: Diagnostics,
    /// How the chart evolves; none if the heading does not choose.
    evolution: Option<Evolution>,
    declared: FxHashSet<EcoString>,
    forced: FxHashSet<EcoString>,
    momentary: FxHashSet<EcoString>,
}

/// What was said of a state's arcs so far.
#[derive(Clone, Copy, Default)]
struct Before {
    arcs: usize,
    /// Whether one of them is taken.
    taken: Option<ExprId>,
}

impl Expander<'_> {
    /// Whether a call is one micro-step.
    fn is_scan(&self) -> bool {
        self.evolution == Some(Evolution::Scan)
    }

    fn automaton(&mut self, automaton: &mut Grafcet) {
        let outputs = self.outputs(automaton);
        self.initial(automaton);
        let mut before: FxHashMap<EcoString, Before> = FxHashMap::default();
        let mut states: Vec<Name> = Vec::new();
        let mut items = Vec::with_capacity(automaton.items.len());
        for item in automaton.items.drain(..) {
            match item {
                Item::Transition(arc) => {
                    if let ([from], [_]) = (arc.from.as_slice(), arc.to.as_slice()) {
                        let before = before.entry(from.text.clone()).or_default();
                        items.push(Item::Transition(self.arc(&arc, before, &outputs)));
                    } else {
                        self.fault(
                            arc.span,
                            "an arc leads from one state to one state",
                            "name one on each side of `->`",
                        );
                    }
                }
                Item::Step(step) => {
                    if step.kind != StepKind::Plain {
                        let help = "leave out the word before it; a grafcet may have enclosing steps and macro-steps";
                        self.fault(step.label.span, "a state of an automaton holds nothing", help);
                    }
                    states.push(step.label.clone());
                    items.push(Item::Step(Step { kind: StepKind::Plain, ..step }));
                }
                Item::Expansion(expansion) => {
                    let help = "leave it out; a grafcet may have macro-steps and their expansions";
                    self.fault(expansion.macro_step.span, "an automaton has no expansions", help);
                }
                item @ (Item::Declaration(_)
                | Item::Grafcet(_)
                | Item::Allow(_)
                | Item::Claim(_)
                | Item::Scenario(_)) => {
                    items.push(item);
                }
            }
        }
        if self.is_scan() && !outputs.is_empty() {
            for state in &states {
                let taken = before.get(&state.text).and_then(|before| before.taken);
                items.push(Item::Transition(self.rest(state, taken, &outputs)));
            }
        }
        automaton.items = items;
    }

    /// The outputs on arcs, each once.
    fn outputs(&mut self, automaton: &Grafcet) -> Vec<Name> {
        let mut seen = FxHashSet::default();
        let mut outputs: Vec<Name> = Vec::new();
        for item in &automaton.items {
            if let Item::Transition(arc) = item {
                outputs.extend(arc.outputs().iter().filter(|output| seen.insert(output.text.clone())).cloned());
            }
        }
        if let Some(first) = outputs.first() {
            match self.evolution {
                None => {
                    let message = "an output on an arc, and the heading does not say how the chart evolves";
                    self.diagnostics.push(
                        Diagnostic::new(Code::E0324, first.span, message)
                            .note("it is published by the call that takes the arc: with `evolution scan` that is one arc at most, with `evolution stable` there may be several")
                            .help("write one of the two into the heading, as in `chart Main evolution scan`, or the output into a state"),
                    );
                }
                Some(Evolution::Scan) => {}
                Some(Evolution::Stable) => self.momentary.extend(outputs.iter().map(|output| output.text.clone())),
            }
            let may_be_out_of_force = !automaton.path.is_empty() || self.forced.contains(&automaton.name.text);
            if self.is_scan() && may_be_out_of_force {
                let message = "an output on an arc, and the automaton is enclosed, forced or commanded";
                let help = "while it is not in force nothing would make the output false: write it into a state, or let the chart evolve to stability";
                self.fault(first.span, message, help);
            }
        }
        outputs
    }

    /// An automaton begins in one state at most; that it begins in one at all is a rule of all grafcets.
    fn initial(&mut self, automaton: &Grafcet) {
        let marked = |mark: StepMark| {
            let words = automaton.items.iter().filter_map(move |item| match item {
                Item::Step(step) => step.word(mark).map(|_| step.label.span),
                Item::Declaration(_)
                | Item::Grafcet(_)
                | Item::Expansion(_)
                | Item::Transition(_)
                | Item::Allow(_)
                | Item::Claim(_)
                | Item::Scenario(_) => None,
            });
            words.collect::<Vec<Span>>()
        };
        let (initial, activated) = (marked(StepMark::Initial), marked(StepMark::Activated));
        for states in [&initial, &activated] {
            if let [first, second, ..] = states.as_slice() {
                let fault =
                    Diagnostic::new(Code::E0323, *second, "an automaton begins in one state, and this is another");
                self.diagnostics.push(fault.also(*first, "it begins here").help("leave one of the two words out"));
            }
        }
    }

    /// An arc as a transition that waits for those before it.
    fn arc(&mut self, arc: &Transition, before: &mut Before, outputs: &[Name]) -> Transition {
        let place = self.exprs[arc.condition].span.behind();
        before.arcs += 1;
        if before.arcs == MOST_ARCS + 1 {
            self.fault(
                arc.span,
                format!("more than {MOST_ARCS} arcs leave the state"),
                "join those that lead to one state",
            );
        }
        let condition = match before.taken.filter(|_| before.arcs <= MOST_ARCS) {
            None => arc.condition,
            Some(taken) => {
                let others = self.made(ExprKind::Not(taken), place);
                let kind = ExprKind::Binary(BinaryOp::And, arc.condition, others);
                self.made(kind, self.exprs[arc.condition].span)
            }
        };
        before.taken = Some(match before.taken {
            None => arc.condition,
            Some(taken) => self.made(ExprKind::Binary(BinaryOp::Or, taken, arc.condition), place),
        });
        let mut actions = arc.actions().to_vec();
        let listed: FxHashMap<&EcoString, Span> =
            arc.outputs().iter().map(|output| (&output.text, output.span)).collect();
        for output in outputs {
            let at = listed.get(&output.text).copied();
            // What is declared nowhere is said once.
            let is_told = self.is_scan() && self.declared.contains(&output.text);
            if at.is_some() || is_told {
                actions.push(self.publish(output, at.is_some(), at.unwrap_or(arc.span.behind())));
            }
        }
        arc.cleared_by(condition, actions)
    }

    /// The transition of a state to itself that makes all outputs on arcs false.
    fn rest(&mut self, state: &Name, taken: Option<ExprId>, outputs: &[Name]) -> Transition {
        let place = state.span.behind();
        let condition = match taken {
            None => self.made(ExprKind::Bool(true), place),
            Some(taken) => self.made(ExprKind::Not(taken), place),
        };
        let mut actions = Vec::with_capacity(outputs.len());
        for output in
            outputs.iter().filter(|output| self.declared.contains(&output.text)).cloned().collect::<Vec<Name>>()
        {
            actions.push(self.publish(&output, false, place));
        }
        let name = || Name { span: place, ..state.clone() };
        let own = Transition::new(smallvec![name()], smallvec![name()], condition, place);
        own.with(None, None, Clearing { actions, ..Clearing::default() })
    }

    fn publish(&mut self, output: &Name, value: bool, place: Span) -> Assignment {
        let value = self.made(ExprKind::Bool(value), place);
        Assignment { target: Name { span: place, ..output.clone() }, value, span: place }
    }

    fn made(&mut self, kind: ExprKind, span: Span) -> ExprId {
        self.exprs.push(Expr { kind, span })
    }

    fn fault(&mut self, span: Span, message: impl Into<String>, help: &str) {
        self.diagnostics.push(Diagnostic::new(Code::E0323, span, message.into()).help(help));
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn an_automaton_is_in_one_state() {
        passes(
            "input a : bool output z : bool automaton A { initial state 0 { z } state 1 arc 0 -> 1 : a arc 1 -> 0 : 1 }",
        );
        breaks("E0312", "input a : bool automaton A { state 0 state 1 arc 0 -> 1 : a arc 1 -> 0 : not a }");
        breaks(
            "E0323",
            "input a : bool automaton A { initial state 0 initial state 1 arc 0 -> 1 : a arc 1 -> 0 : not a }",
        );
        breaks("E0323", "input a : bool automaton A { initial state 0 state 1 arc 0 -> 1, 0 : a arc 1 -> 0 : not a }");
    }

    #[test]
    fn outputs_on_arcs_are_of_one_call() {
        let chart = "input a : bool output z : bool automaton A { initial state 0 state 1 arc 0 -> 1 : a { z } arc 1 -> 0 : 1 }";
        breaks("E0324", chart);
        passes(&format!("chart M evolution scan {chart}"));
    }
}
