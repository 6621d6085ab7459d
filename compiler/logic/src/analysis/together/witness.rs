//! A case in which two conditions hold at once.
//!
//! The atoms of a condition are what is left without its Boolean operators: variables, activities of steps, edges,
//! delays, comparisons. The search gives them values, one after the other, as far as needed. It knows what an edge and
//! an on-delay imply of their operand, which comparisons contradict each other and which steps are never active
//! together, so where it ends without a case there is none. It is bounded: a case that is hard to find is of no use as an
//! explanation.

use super::questions::Questions;
use grafc_formula::{Formula, FormulaId};
use grafc_model::chart::{ExprId, ExprKind, StepId};
use rustc_hash::FxHashMap;

/// Conditions with more operators and atoms than this are not looked into.
const LARGEST: usize = 256;

/// The search ends after this many choices.
const CHOICES: usize = 128;

/// Which atoms are true and which false, in the order in which the search chose them, without those that follow from
/// others; empty if the conditions hold in any case. An atom without a place in the chart has none here.
pub(crate) type Case = Vec<(Option<ExprId>, bool)>;

/// What the search came to.
pub(in crate::analysis) enum SearchResult {
    /// This case.
    Case(Case),
    /// There is none.
    Impossible,
    /// Nothing, within its bounds.
    Unknown,
}

/// Looks for a case in which all these conditions hold while these steps are active.
pub(in crate::analysis) fn search(asked: &mut Questions, conditions: &[ExprId], active: &[StepId]) -> SearchResult {
    let Some(circuit) = Circuit::new(asked, conditions) else { return SearchResult::Unknown };
    let mut search = Search { asked, circuit, active, values: FxHashMap::default(), order: Vec::new() };
    search.run()
}

/// An operand of the Boolean operators, by place.
type GateId = usize;

/// A Boolean operator or what it works on.
#[derive(Clone, Copy)]
enum Gate {
    Known(bool),
    /// An atom, or (false) its negation.
    Atom(FormulaId, bool),
    Not(GateId),
    And(GateId, GateId),
    Or(GateId, GateId),
    Xor(GateId, GateId),
}

/// The conditions down to their atoms, and those that atoms imply; operands come first.
struct Circuit {
    gates: Vec<Gate>,
    /// What has to hold.
    goals: Vec<GateId>,
    /// Where an atom stands in the chart.
    atoms: FxHashMap<FormulaId, ExprId>,
    /// The operand that a true atom makes true or false.
    implied: FxHashMap<FormulaId, (GateId, bool)>,
}

impl Circuit {
    fn new(asked: &mut Questions, conditions: &[ExprId]) -> Option<Circuit> {
        let exprs = &asked.analysis.net.exprs;
        // Operands have smaller ids than what uses them.
        let mut inside = std::collections::BTreeSet::new();
        let mut open: Vec<ExprId> = conditions.to_vec();
        while let Some(e) = open.pop() {
            if inside.insert(e) {
                match operator(&exprs[e].kind) {
                    Operator::Boolean => open.extend(exprs[e].kind.operands()),
                    Operator::Implies(operand, _) => open.push(operand),
                    Operator::None => {}
                }
            }
            if inside.len() > LARGEST {
                return None;
            }
        }
        let mut circuit = Circuit {
            gates: Vec::new(),
            goals: Vec::new(),
            atoms: FxHashMap::default(),
            implied: FxHashMap::default(),
        };
        let mut node_of: FxHashMap<ExprId, GateId> = FxHashMap::default();
        for e in inside {
            let gate = match exprs[e].kind {
                ExprKind::Not(a) => Gate::Not(node_of[&a]),
                ExprKind::And(a, b) => Gate::And(node_of[&a], node_of[&b]),
                ExprKind::Or(a, b) => Gate::Or(node_of[&a], node_of[&b]),
                ExprKind::Xor(a, b) => Gate::Xor(node_of[&a], node_of[&b]),
                ExprKind::Literal(_)
                | ExprKind::Variable(_)
                | ExprKind::StepActive(_)
                | ExprKind::StepTime(_)
                | ExprKind::MacroActive(_)
                | ExprKind::GrafcetActive(_)
                | ExprKind::GrafcetFrozen(_)
                | ExprKind::Rise(_)
                | ExprKind::Fall(_)
                | ExprKind::Delay { .. }
                | ExprKind::Compare(..)
                | ExprKind::Arithmetic(..)
                | ExprKind::Negate(_)
                | ExprKind::Widen(_) => {
                    let formula = asked.formula(e);
                    let gate = asked.atom(formula);
                    if let Gate::Atom(atom, true) = gate {
                        circuit.atoms.entry(atom).or_insert(e);
                        if let Operator::Implies(operand, value) = operator(&exprs[e].kind) {
                            circuit.implied.insert(atom, (node_of[&operand], value));
                        }
                    }
                    gate
                }
            };
            node_of.insert(e, circuit.gates.len());
            circuit.gates.push(gate);
        }
        circuit.goals.extend(conditions.iter().map(|e| node_of[e]));
        Some(circuit)
    }

    /// What is known of each gate.
    fn evaluate(&self, values: &FxHashMap<FormulaId, bool>) -> Vec<Option<bool>> {
        let mut known: Vec<Option<bool>> = Vec::with_capacity(self.gates.len());
        for gate in &self.gates {
            known.push(match *gate {
                Gate::Known(value) => Some(value),
                Gate::Atom(atom, asserted) => values.get(&atom).map(|value| *value == asserted),
                Gate::Not(a) => known[a].map(|a| !a),
                Gate::And(a, b) => match (known[a], known[b]) {
                    (Some(false), _) | (_, Some(false)) => Some(false),
                    (Some(true), other) | (other, Some(true)) => other,
                    (None, None) => None,
                },
                Gate::Or(a, b) => match (known[a], known[b]) {
                    (Some(true), _) | (_, Some(true)) => Some(true),
                    (Some(false), other) | (other, Some(false)) => other,
                    (None, None) => None,
                },
                Gate::Xor(a, b) => known[a].zip(known[b]).map(|(a, b)| a != b),
            });
        }
        known
    }

    /// An atom on which an open gate depends, and the value of it that helps.
    fn choose(&self, known: &[Option<bool>], mut node: GateId, mut wanted: bool) -> Option<(FormulaId, bool)> {
        loop {
            (node, wanted) = match self.gates[node] {
                Gate::Known(_) => return None,
                Gate::Atom(atom, asserted) => return Some((atom, wanted == asserted)),
                Gate::Not(a) => (a, !wanted),
                Gate::And(a, b) | Gate::Or(a, b) => (if known[a].is_none() { a } else { b }, wanted),
                Gate::Xor(a, b) if known[a].is_none() => (a, wanted != known[b].unwrap_or(false)),
                Gate::Xor(a, b) => (b, wanted != known[a].unwrap_or(false)),
            };
        }
    }
}

/// How the search sees an expression.
enum Operator {
    Boolean,
    /// An atom that, if it is true, makes its operand true or false.
    Implies(ExprId, bool),
    None,
}

fn operator(kind: &ExprKind) -> Operator {
    match *kind {
        ExprKind::Not(_) | ExprKind::And(..) | ExprKind::Or(..) | ExprKind::Xor(..) => Operator::Boolean,
        ExprKind::Rise(a) => Operator::Implies(a, true),
        ExprKind::Fall(a) => Operator::Implies(a, false),
        // An on-delay alone is false as soon as its operand is (X5).
        ExprKind::Delay { operand, off, .. } if off.ms == 0 => Operator::Implies(operand, true),
        ExprKind::Delay { .. }
        | ExprKind::Literal(_)
        | ExprKind::Variable(_)
        | ExprKind::StepActive(_)
        | ExprKind::StepTime(_)
        | ExprKind::MacroActive(_)
        | ExprKind::GrafcetActive(_)
        | ExprKind::GrafcetFrozen(_)
        | ExprKind::Compare(..)
        | ExprKind::Arithmetic(..)
        | ExprKind::Negate(_)
        | ExprKind::Widen(_) => Operator::None,
    }
}

impl Questions<'_> {
    /// The atom that a formula is.
    fn atom(&self, formula: FormulaId) -> Gate {
        match (self.truth(formula), self.get(formula)) {
            (Some(value), _) => Gate::Known(value),
            (None, Formula::Not(inner)) => Gate::Atom(*inner, false),
            (None, _) => Gate::Atom(formula, true),
        }
    }
}

struct Search<'k, 'n> {
    asked: &'k mut Questions<'n>,
    circuit: Circuit,
    /// Steps that are active.
    active: &'k [StepId],
    values: FxHashMap<FormulaId, bool>,
    /// The atoms in the order in which they got their values, and whether the other value is still to be tried.
    order: Vec<(FormulaId, bool)>,
}

impl Search<'_, '_> {
    fn run(&mut self) -> SearchResult {
        for _ in 0..CHOICES {
            let gates = self.circuit.evaluate(&self.values);
            let mut goals: Vec<(GateId, bool)> = self.circuit.goals.iter().map(|node| (*node, true)).collect();
            let is_true = |(atom, _): &&(FormulaId, bool)| self.values[atom];
            goals.extend(self.order.iter().filter(is_true).filter_map(|(atom, _)| self.circuit.implied.get(atom)));
            let refuted = goals.iter().any(|(node, wanted)| gates[*node] == Some(!wanted));
            let open = goals.iter().find(|(node, _)| gates[*node].is_none());
            let next = open.and_then(|(node, wanted)| self.circuit.choose(&gates, *node, *wanted));
            let goes_on = match next {
                _ if refuted => self.turn_back(),
                None => return SearchResult::Case(self.case()),
                Some((atom, value)) => self.give(atom, value, true) || self.turn_back(),
            };
            if !goes_on {
                return SearchResult::Impossible;
            }
        }
        SearchResult::Unknown
    }

    /// Takes back choices up to one whose other value is possible and untried.
    fn turn_back(&mut self) -> bool {
        while let Some((atom, untried)) = self.order.pop() {
            if let Some(value) = self.values.remove(&atom)
                && untried
                && self.give(atom, !value, false)
            {
                return true;
            }
        }
        false
    }

    /// Gives an atom a value. It stays even if it contradicts others, for `turn_back` to find; then false is returned.
    fn give(&mut self, atom: FormulaId, value: bool, untried: bool) -> bool {
        let fits = self.fits(atom, value);
        if !fits && !untried {
            return false;
        }
        self.values.insert(atom, value);
        self.order.push((atom, untried));
        fits
    }

    fn fits(&mut self, atom: FormulaId, value: bool) -> bool {
        if let Some(step) = self.step(atom) {
            if !value {
                return !self.active.contains(&step);
            }
            let active = self.order.iter().filter(|(a, _)| self.values[a]).filter_map(|(a, _)| self.step(*a));
            let mut active = active.chain(self.active.iter().copied());
            return !active.any(|other| self.asked.analysis.never_together(step, other));
        }
        let literal = self.asked.literal(atom, value);
        for index in 0..self.order.len() {
            let other = self.order[index].0;
            let other = self.asked.literal(other, self.values[&other]);
            if self.asked.exclude(literal, other) {
                return false;
            }
        }
        true
    }

    /// The step whose activity an atom is.
    fn step(&self, atom: FormulaId) -> Option<StepId> {
        match self.asked.analysis.net.exprs[*self.circuit.atoms.get(&atom)?].kind {
            ExprKind::StepActive(step) => Some(step),
            _ => None,
        }
    }

    /// The case as it was found.
    fn case(&self) -> Case {
        // What an edge or a delay says of its operand need not be said again.
        let implied = |atom: &FormulaId| {
            self.order.iter().filter(|(a, _)| self.values[a]).any(|(a, _)| {
                let operand = self.circuit.implied.get(a).map(|(node, _)| self.circuit.gates[*node]);
                matches!(operand, Some(Gate::Atom(operand, _)) if operand == *atom)
            })
        };
        let told = self.order.iter().map(|(atom, _)| atom).filter(|atom| !implied(atom));
        told.map(|atom| (self.circuit.atoms.get(atom).copied(), self.values[atom])).collect()
    }
}
