//! Actions of steps, forcing orders, and conditions with times (IEC 60848, symbols 17, 18, 22 to 29 and 37).

use super::Writer;
use super::conditions::Binding;
use crate::agrafe::model::{
    ActionId, ActionKind, Condition, ForcingOrderType, Model, NodeId, NodeKind, StoredActionType, TermId, TermKind,
    TimeConditionType, VariableKind,
};
use crate::agrafe::target;
use crate::naming::spell;
use crate::{changed, doubtful, lost};
use grafc_diagnostics::{Diagnostics, Span};
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashSet;

/// The actions of each step, in the order of their links.
pub fn of_steps(model: &Model, diagnostics: &mut Diagnostics) -> IndexVec<NodeId, Vec<ActionId>> {
    let mut of_steps: IndexVec<NodeId, Vec<ActionId>> = index_vec![Vec::new(); model.nodes.len()];
    let mut seen = FxHashSet::default();
    let mut linked = FxHashSet::default();
    for link in &model.links {
        linked.insert(link.action);
        if seen.insert((link.step, link.action)) {
            of_steps[link.step].push(link.action);
        } else {
            diagnostics.push(changed(link.span, "an action that a step has twice is written once"));
        }
    }
    for (id, action) in model.actions.iter_enumerated() {
        if !linked.contains(&id) {
            diagnostics.push(lost(action.span, "an action is lost, because no step has it"));
        }
    }
    of_steps
}

/// Reports what does not fit in actions and conditions.
pub fn judge(model: &Model, diagnostics: &mut Diagnostics) {
    for node in &model.nodes {
        if let NodeKind::Transition(condition) = &node.kind {
            judge_time(condition, node.span, diagnostics);
            if condition.time == TimeConditionType::Limited {
                diagnostics.push(
                    doubtful(node.span, format!("the condition of the transition {} is limited in time", node.id))
                        .note("IEC 60848 limits actions only; it is written as an off-delay, as in AGRAFE's code"),
                );
            }
            if condition.term.is_none() && condition.time == TimeConditionType::None {
                let message = format!("the transition {} has no condition and is always true", node.id);
                diagnostics.push(doubtful(node.span, message).note("IEC 60848, symbol 14, writes `1` for it"));
            }
            if condition.term.is_some_and(|term| model.terms[term].kind == TermKind::Boolean(false)) {
                let message = format!("the transition {} is never cleared, because its condition is false", node.id);
                diagnostics.push(doubtful(node.span, message).note("a `BooleanConstant` without a value is false"));
            }
        }
    }
    for action in &model.actions {
        match &action.kind {
            ActionKind::Continuous { conditional: true, condition, .. } => {
                judge_time(condition, action.span, diagnostics);
                if condition.time == TimeConditionType::Limited {
                    diagnostics.push(
                        doubtful(action.span, "an action is limited in time")
                            .note("it is written as in IEC 60848, symbol 25: it ends when the time is over")
                            .note("AGRAFE's code delays the end of its condition instead"),
                    );
                }
                if condition.term.is_none() && condition.time == TimeConditionType::None {
                    diagnostics.push(doubtful(action.span, "an action has an assignment condition, and it is missing"));
                }
            }
            ActionKind::Continuous { conditional: false, condition, .. } => {
                if condition.term.is_some() || condition.time != TimeConditionType::None {
                    diagnostics.push(
                        lost(action.span, "the condition of a continuous action is lost")
                            .note("it counts only in an `assignationCondition`, in AGRAFE's code too"),
                    );
                }
            }
            ActionKind::Stored { event: StoredActionType::Event, condition: None, .. } => {
                diagnostics.push(
                    doubtful(action.span, "an action on event has no event")
                        .note("it is written with `1`, the occurrence of any input event"),
                );
            }
            ActionKind::Stored { event, condition: Some(_), .. } if *event != StoredActionType::Event => {
                diagnostics.push(
                    lost(action.span, "the condition of a stored action is lost").note("only one on event has one"),
                );
            }
            ActionKind::Stored { .. } => {}
            ActionKind::Force { order, steps, .. } => match order {
                ForcingOrderType::Explicit if steps.is_empty() => {
                    diagnostics.push(doubtful(action.span, "an explicit situation has no steps and is the empty one"));
                }
                ForcingOrderType::Explicit => {}
                ForcingOrderType::Current | ForcingOrderType::Empty | ForcingOrderType::Initial => {
                    if !steps.is_empty() {
                        diagnostics.push(
                            lost(action.span, "the steps of a forcing order are lost")
                                .note("its kind already says which situation it forces"),
                        );
                    }
                }
            },
        }
    }
}

fn judge_time(condition: &Condition, span: Span, diagnostics: &mut Diagnostics) {
    let (delay, reset) = (condition.delay.count != 0, condition.reset.count != 0);
    let unused = match condition.time {
        TimeConditionType::None if delay || reset => "times are lost, because the kind of the condition is `none`",
        TimeConditionType::Delayed if reset => "a `resetTime` is lost, because the condition is only delayed",
        TimeConditionType::Limited if delay && reset => "a `delayTime` is lost, because the condition is only limited",
        TimeConditionType::None
        | TimeConditionType::Dependent
        | TimeConditionType::Delayed
        | TimeConditionType::Limited => return,
    };
    diagnostics.push(lost(span, unused));
}

/// What a time counts from.
#[derive(Clone, Copy)]
enum Operand<'a> {
    Term(TermId),
    /// The activity of steps, where there is no term.
    Steps(&'a [NodeId]),
}

impl Writer<'_> {
    /// The condition of a transition.
    pub fn transition_condition(&mut self, condition: &Condition, before: &[NodeId]) {
        let operand = condition.term.map_or(Operand::Steps(before), Operand::Term);
        match (condition.time, condition.term) {
            (TimeConditionType::None, Some(term)) => self.condition(term, Binding::Or),
            (TimeConditionType::None, None) => self.text.push("1"),
            (TimeConditionType::Dependent, _) => self.delay(operand, condition.delay_text(), condition.reset_text()),
            (TimeConditionType::Delayed, _) => self.delay(operand, condition.delay_text(), None),
            (TimeConditionType::Limited, _) => self.delay(operand, None, condition.limit_text()),
        }
    }

    /// One action of a step.
    pub fn action(&mut self, action: ActionId, step: NodeId) {
        let model = self.model;
        match &model.actions[action].kind {
            ActionKind::Continuous { variable, conditional, condition } => {
                self.target(*variable);
                if *conditional {
                    self.assignment_condition(condition, step);
                }
            }
            ActionKind::Stored { variable, event, value, condition } => {
                self.target(*variable);
                self.text.push(" := ");
                value.iter().for_each(|&value| self.value(value));
                match event {
                    StoredActionType::Activation => self.text.push(" on activation"),
                    StoredActionType::Deactivation => self.text.push(" on deactivation"),
                    StoredActionType::Event => {
                        self.text.push(" on event ");
                        match condition {
                            Some(term) => self.condition(*term, Binding::Or),
                            None => self.text.push("1"),
                        }
                    }
                }
            }
            ActionKind::Force { grafcet, order, steps } => {
                let name = grafcet.map(|grafcet| spell(&self.names.grafcets[grafcet])).unwrap_or_default();
                self.text.push(&format!("force {name}"));
                self.text.push("{");
                match order {
                    ForcingOrderType::Current => self.text.push("*"),
                    ForcingOrderType::Empty => {}
                    ForcingOrderType::Initial => self.text.push("INIT"),
                    ForcingOrderType::Explicit => self.labels(steps),
                }
                self.text.push("}");
            }
        }
        self.text.push("\n");
    }

    fn target(&mut self, variable: Option<TermId>) {
        if let Some(variable) = target(self.model, variable) {
            let name = spell(&self.names.variables[variable]);
            self.text.push(&name);
        }
    }

    fn assignment_condition(&mut self, condition: &Condition, step: NodeId) {
        let own = [step];
        let operand = condition.term.map_or(Operand::Steps(&own), Operand::Term);
        if condition.time == TimeConditionType::None && condition.term.is_none() {
            return;
        }
        self.text.push(" if ");
        match condition.time {
            TimeConditionType::None => condition.term.iter().for_each(|&term| self.condition(term, Binding::Or)),
            TimeConditionType::Dependent => self.delay(operand, condition.delay_text(), condition.reset_text()),
            TimeConditionType::Delayed => self.delay(operand, condition.delay_text(), None),
            TimeConditionType::Limited => {
                // While the step is active, its activity need not be said (symbol 25).
                if let Operand::Term(term) = operand
                    && !self.is_activity(term, step)
                {
                    self.condition(term, Binding::And);
                    self.text.push(" and ");
                }
                self.text.push("not ");
                let limit = condition.limit_text().unwrap_or_else(|| "0s".to_string());
                self.delay(operand, Some(limit), None);
            }
        }
    }

    fn is_activity(&self, term: TermId, step: NodeId) -> bool {
        match self.model.terms[term].kind {
            TermKind::Variable(Some(id)) => self.model.variables[id].kind == VariableKind::Step(Some(step)),
            _ => false,
        }
    }

    /// `3s/a/7s`, or less of it.
    fn delay(&mut self, operand: Operand, delay: Option<String>, reset: Option<String>) {
        let timed = delay.is_some() || reset.is_some();
        if let Some(delay) = delay {
            self.text.push(&delay);
            self.text.push("/");
        }
        match operand {
            Operand::Term(term) => self.condition(term, if timed { Binding::Delay } else { Binding::Or }),
            Operand::Steps([]) => self.text.push("(1)"),
            Operand::Steps([step]) => self.activity(*step),
            Operand::Steps(steps) => {
                self.text.push("(");
                for (place, &step) in steps.iter().enumerate() {
                    self.text.push(if place > 0 { " and " } else { "" });
                    self.activity(step);
                }
                self.text.push(")");
            }
        }
        if let Some(reset) = reset {
            self.text.push("/");
            self.text.push(&reset);
        }
    }

    fn activity(&mut self, step: NodeId) {
        let name = spell(&format!("X{}", self.names.labels[step]));
        self.text.push(&name);
    }
}

impl Condition {
    fn delay_text(&self) -> Option<String> {
        (self.delay.count > 0).then(|| format!("{}{}", self.delay.count, self.delay.unit))
    }

    fn reset_text(&self) -> Option<String> {
        (self.reset.count > 0).then(|| format!("{}{}", self.reset.count, self.reset.unit))
    }

    /// AGRAFE's code takes the `resetTime`; the other is there in case nobody filled it in.
    fn limit_text(&self) -> Option<String> {
        self.reset_text().or_else(|| self.delay_text())
    }
}
