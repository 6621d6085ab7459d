//! A chart without its layout: what it has in whatever order and words, so that two texts of one chart are equal.
//!
//! Steps are called by their places, variables by their names. Negations stand at the leaves of conditions, operands are
//! in one order, and what nothing mentions is left out.

use grafc_model::chart::{Chart, Event, ExprId, ExprKind, StepId, Type, VariableId, VariableKind};
use grafc_net::Net;
use std::collections::BTreeSet;
use std::fmt::Write;

/// The lines of a flat chart.
pub fn outline(chart: &Chart) -> String {
    let net = grafc_net::build(chart);
    let outline = Outline { net: &net };
    let mut lines = BTreeSet::new();
    let mut used: BTreeSet<VariableId> = BTreeSet::new();
    for (place, step) in net.places.iter_enumerated() {
        lines.insert(format!("{}step {}", if step.initial { "initial " } else { "" }, place.index()));
    }
    for transition in &net.transitions {
        let list = |steps: &[StepId]| {
            let steps: BTreeSet<usize> = steps.iter().map(|step| step.index()).collect();
            format!("{steps:?}")
        };
        let condition = outline.expression(transition.condition, false);
        lines.insert(format!("transition {} {} {condition}", list(&transition.pre), list(&transition.post)));
    }
    for action in &net.continuous {
        used.insert(action.target);
        let condition = action.condition.map(|condition| outline.expression(condition, false));
        lines.insert(format!("{} sets {} {condition:?}", action.step.index(), net.variables[action.target].name));
    }
    for action in &net.stored {
        used.insert(action.target);
        let event = match action.event {
            Event::Activation(step) => format!("{} in", step.index()),
            Event::Deactivation(step) => format!("{} out", step.index()),
            Event::EachScan(step, guard) => {
                format!("{} scan {:?}", step.index(), guard.map(|guard| outline.expression(guard, false)))
            }
            Event::Event(step, on) => format!("{} event {}", step.index(), outline.expression(on, false)),
            Event::Clearing(transition) => format!("clearing {}", transition.index()),
        };
        let value = outline.expression(action.value, false);
        lines.insert(format!("{} := {value} at {event}", net.variables[action.target].name));
    }
    let words: BTreeSet<String> = lines.iter().flat_map(|line| words(line)).map(str::to_owned).collect();
    used.extend(net.variables.indices().filter(|variable| words.contains(&*net.variables[*variable].name)));
    for variable in used {
        let variable = &net.variables[variable];
        let kind = match variable.kind {
            VariableKind::Input => "input",
            VariableKind::Constant => "constant",
            VariableKind::Output | VariableKind::Internal => "set",
        };
        lines.insert(format!("{kind} {} : {:?} := {:?}", variable.name, variable.ty, variable.initial()));
    }
    lines.into_iter().fold(String::new(), |mut all, line| {
        _ = writeln!(all, "{line}");
        all
    })
}

struct Outline<'c> {
    net: &'c Net,
}

impl Outline<'_> {
    /// An expression, or its negation.
    fn expression(&self, id: ExprId, negated: bool) -> String {
        let not = if negated { "not " } else { "" };
        let pair = |word: &str, a: ExprId, b: ExprId| {
            format!("({} {word} {})", self.expression(a, false), self.expression(b, false))
        };
        match self.net.exprs[id].kind {
            ExprKind::Literal(value) => format!("{not}{value:?}"),
            ExprKind::Variable(variable) => format!("{not}{}", self.net.variables[variable].name),
            ExprKind::StepActive(step) => format!("{not}X{}", step.index()),
            ExprKind::StepTime(step) => format!("T{}", step.index()),
            ExprKind::Not(a) => self.expression(a, !negated),
            ExprKind::And(..) => self.junction(id, negated, !negated),
            ExprKind::Or(..) => self.junction(id, negated, negated),
            ExprKind::Xor(a, b) => format!("{not}{}", pair("xor", a, b)),
            ExprKind::Compare(op, a, b) => {
                // Of what is no number neither `<` nor `>=` holds.
                let is_ordered = !matches!(self.net.exprs[a].ty, Type::Real | Type::Lreal);
                let op = if negated && is_ordered { op.opposite() } else { op };
                format!("{}{}", if is_ordered { "" } else { not }, pair(&format!("{op:?}"), a, b))
            }
            ExprKind::Arithmetic(op, a, b) => pair(&format!("{op:?}"), a, b),
            ExprKind::Negate(a) => format!("-{}", self.expression(a, false)),
            ExprKind::Widen(a) => self.expression(a, false),
            ExprKind::Rise(a) => format!("{not}rise {}", self.expression(a, false)),
            ExprKind::Fall(a) => format!("{not}fall {}", self.expression(a, false)),
            ExprKind::Delay { on, operand, off } => {
                format!("{not}{}/{}/{}", on.ms, self.expression(operand, false), off.ms)
            }
            ExprKind::MacroActive(id) => format!("{not}M{}", id.index()),
            ExprKind::GrafcetActive(id) => format!("{not}G{}", id.index()),
            ExprKind::GrafcetFrozen(id) => format!("{not}F{}", id.index()),
        }
    }

    /// What is joined by one word, or by the other if it is negated, without regard to order.
    fn junction(&self, id: ExprId, negated: bool, all: bool) -> String {
        let (mut open, mut parts) = (vec![(id, negated)], BTreeSet::new());
        while let Some((id, negated)) = open.pop() {
            match self.net.exprs[id].kind {
                ExprKind::Not(a) => open.push((a, !negated)),
                ExprKind::And(a, b) if all != negated => open.extend([(a, negated), (b, negated)]),
                ExprKind::Or(a, b) if all == negated => open.extend([(a, negated), (b, negated)]),
                _ => {
                    parts.insert(self.expression(id, negated));
                }
            }
        }
        if parts.iter().any(|part| parts.contains(&format!("not {part}"))) {
            return format!("Bool({})", !all);
        }
        let parts: Vec<String> = parts.into_iter().collect();
        if parts.len() == 1 { parts.concat() } else { format!("({})", parts.join(if all { " and " } else { " or " })) }
    }
}

/// The names and numbers in a line.
fn words(line: &str) -> impl Iterator<Item = &str> {
    line.split(|c: char| !c.is_alphanumeric() && c != '_')
}
