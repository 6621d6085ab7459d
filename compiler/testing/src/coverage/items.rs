//! What counts, one after the other, in the order of the text.

use super::Coverage;
use super::condition::{Condition, place};
use grafc_diagnostics::Span;
use grafc_model::chart::{Event, ExprId, StepId, TransitionId};

/// What an item is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Kind {
    /// A step, which is to be active.
    Step,
    /// A transition, which is to be cleared.
    Transition,
    /// An action, which is to assign.
    Action,
    /// A forcing order, which is to be in force.
    Order,
    /// An activation link, which is to activate its step.
    Link,
}

impl Kind {
    /// All kinds, in the order in which they are told.
    pub const ALL: [Kind; 5] = [Kind::Step, Kind::Transition, Kind::Action, Kind::Order, Kind::Link];

    /// Several of them, in words.
    pub fn plural(self) -> &'static str {
        match self {
            Kind::Step => "steps",
            Kind::Transition => "transitions",
            Kind::Action => "actions",
            Kind::Order => "orders",
            Kind::Link => "activation links",
        }
    }

    /// What did not happen to one that is not covered.
    pub(super) fn missed(self) -> &'static str {
        match self {
            Kind::Step => "was never active",
            Kind::Transition => "was never cleared",
            Kind::Action => "was never done",
            Kind::Order => "was never in force",
            Kind::Link => "was never taken",
        }
    }
}

/// Something that counts.
#[derive(Clone, Debug)]
pub struct Item<'c> {
    /// What it is.
    pub kind: Kind,
    /// The how manieth of its kind, in the order of the text; of steps and transitions, in order of declaration.
    pub number: usize,
    /// What it is called.
    pub name: String,
    /// Where it is.
    pub span: Span,
    /// How often it has happened.
    pub count: u64,
    /// Its condition, if it has one.
    pub condition: Option<&'c Condition>,
}

impl Coverage<'_> {
    /// All that counts, in the order of the text.
    pub fn items(&self) -> Vec<Item<'_>> {
        let chart = self.chart;
        let mut items = Vec::new();
        let of_step = |id: StepId| format!("step `{}`", chart.steps[id].label);
        let item = |kind, number, name, span, count, condition| Item { kind, number, name, span, count, condition };
        for (id, step) in chart.steps.iter_enumerated() {
            items.push(item(Kind::Step, id.index(), of_step(id), step.span, self.steps[id], None));
            if step.activated {
                let name = format!("the activation link of step `{}`", step.label);
                items.push(item(Kind::Link, id.index(), name, step.span, self.links[id], None));
            }
        }
        for (id, transition) in chart.transitions.iter_enumerated() {
            let condition = Some(&self.of_transitions[id]);
            let (name, count) = (self.transition_name(id), self.transitions[id]);
            items.push(item(Kind::Transition, id.index(), name, transition.span, count, condition));
        }
        let mut actions = Vec::new();
        for (place, action) in chart.continuous.iter().enumerate() {
            let name = format!("action `{}` of {}", chart.variables[action.target].name, of_step(action.step));
            let condition = self.of_continuous[place].as_ref();
            actions.push(item(Kind::Action, 0, name, action.span, self.continuous[place], condition));
        }
        for (place, action) in chart.stored.iter().enumerate() {
            let owner = match action.event {
                Event::Event(step, _)
                | Event::Activation(step)
                | Event::Deactivation(step)
                | Event::EachScan(step, _) => of_step(step),
                Event::Clearing(transition) => self.transition_name(transition),
            };
            let name = format!("action `{}` of {owner}", chart.variables[action.target].name);
            let condition = self.of_stored[place].as_ref();
            actions.push(item(Kind::Action, 0, name, action.span, self.stored[place], condition));
        }
        actions.sort_by_key(|action| action.span.start);
        actions.iter_mut().enumerate().for_each(|(number, action)| action.number = number);
        items.append(&mut actions);
        for (number, order) in chart.orders.iter().enumerate() {
            let name = format!("order on `{}` of {}", chart.grafcets[order.grafcet].name, of_step(order.step));
            items.push(item(Kind::Order, number, name, order.span, self.orders[number], None));
        }
        items.sort_by_key(|item| (item.span.start, item.kind, item.number));
        items
    }

    /// The place of an atom.
    pub fn place(&self, atom: ExprId) -> Span {
        place(self.chart, atom)
    }

    fn transition_name(&self, id: TransitionId) -> String {
        match &self.chart.transitions[id].designation {
            Some(designation) => format!("transition ({designation})"),
            None => format!("transition #{}", id.index() + 1),
        }
    }
}

impl Item<'_> {
    /// Whether it has happened, and each atom of its condition has had both values.
    pub fn is_whole(&self) -> bool {
        let atoms = self.condition.map_or(&[][..], |condition| &condition.atoms);
        self.count > 0 && atoms.iter().all(|atom| atom.counts.iter().all(|count| *count > 0))
    }
}
