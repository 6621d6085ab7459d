//! The elements of a chart: what they are called, what they look like, what they are linked to.

use crate::font::shown;
use crate::picture::Group;
use crate::rich::Token;
use crate::symbols::action::{Block, When};
use crate::symbols::step::{self, Step};
use crate::symbols::transition::{self, Transition};
use crate::symbols::{Symbol, order};
use crate::wording;
use grafc_layout::Start;
use grafc_model::chart::{
    Continuous, Event, MacroId, Node, Order, Pulse, Run, StepId, Stored, Tables, TransitionId, VariableId,
};
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashMap;

/// What stands in a diagram.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) enum Element {
    Step(StepId),
    Macro(MacroId),
    Transition(TransitionId),
}

impl From<Node> for Element {
    fn from(node: Node) -> Self {
        match node {
            Node::Step(id) => Element::Step(id),
            Node::Macro(id) => Element::Macro(id),
        }
    }
}

impl Element {
    pub(crate) fn is_transition(self) -> bool {
        match self {
            Element::Transition(_) => true,
            Element::Step(_) | Element::Macro(_) => false,
        }
    }
}

/// What a step or transition does, in order of the text.
#[derive(Clone, Copy)]
enum Deed<'a> {
    Continuous(&'a Continuous),
    Stored(&'a Stored),
    Order(&'a Order),
    Pulse(&'a Pulse),
    Run(&'a Run),
}

impl Deed<'_> {
    /// Where it is written.
    fn start(self) -> u32 {
        match self {
            Deed::Continuous(action) => action.span.start,
            Deed::Stored(action) => action.span.start,
            Deed::Order(order) => order.span.start,
            Deed::Pulse(pulse) => pulse.span.start,
            Deed::Run(run) => run.span.start,
        }
    }
}

/// A chart, and what belongs to each element.
pub(crate) struct Elements<'a> {
    pub chart: &'a Tables,
    is_active: IndexVec<StepId, bool>,
    of_steps: IndexVec<StepId, Vec<(Deed<'a>, usize)>>,
    of_transitions: IndexVec<TransitionId, Vec<(Deed<'a>, usize)>>,
    /// The transitions next to each step or macro-step.
    next_to: FxHashMap<Node, Vec<TransitionId>>,
}

impl<'a> Elements<'a> {
    pub(crate) fn new(chart: &'a Tables, active: &[StepId]) -> Elements<'a> {
        let mut is_active = index_vec![false; chart.steps.len()];
        active.iter().for_each(|step| is_active[*step] = true);
        let mut of_steps: IndexVec<StepId, Vec<(Deed<'a>, usize)>> = index_vec![Vec::new(); chart.steps.len()];
        let mut of_transitions: IndexVec<TransitionId, Vec<(Deed<'a>, usize)>> =
            index_vec![Vec::new(); chart.transitions.len()];
        // Actions are counted through, whatever their kind, and so are orders.
        let mut actions: Vec<Deed<'a>> = chart.continuous.iter().map(Deed::Continuous).collect();
        actions.extend(chart.stored.iter().map(Deed::Stored));
        actions.sort_by_key(|deed| deed.start());
        let mut orders: Vec<Deed<'a>> = chart.orders.iter().map(Deed::Order).collect();
        orders.extend(chart.pulses.iter().map(Deed::Pulse));
        orders.extend(chart.runs.iter().map(Deed::Run));
        let orders = orders.into_iter().enumerate();
        for (number, deed) in actions.into_iter().enumerate().chain(orders) {
            match deed {
                Deed::Continuous(action) => of_steps[action.step].push((deed, number)),
                Deed::Order(order) => of_steps[order.step].push((deed, number)),
                Deed::Run(run) => of_steps[run.step].push((deed, number)),
                Deed::Stored(Stored { event, .. }) | Deed::Pulse(Pulse { event, .. }) => match *event {
                    Event::Event(step, _)
                    | Event::Deactivation(step)
                    | Event::Activation(step)
                    | Event::EachScan(step, _) => {
                        of_steps[step].push((deed, number));
                    }
                    Event::Clearing(transition) => of_transitions[transition].push((deed, number)),
                },
            }
        }
        for deeds in &mut of_steps {
            deeds.sort_by_key(|(deed, _)| deed.start());
        }
        let mut next_to: FxHashMap<Node, Vec<TransitionId>> = FxHashMap::default();
        for (id, transition) in chart.transitions.iter_enumerated() {
            for node in transition.pre.iter().chain(&transition.post) {
                next_to.entry(*node).or_default().push(id);
            }
        }
        Elements { chart, is_active, of_steps, of_transitions, next_to }
    }

    /// What an element is called: a label, a designation, or `#n`.
    pub(crate) fn name(&self, element: Element) -> String {
        match element {
            Element::Step(id) => self.chart.steps[id].label.to_string(),
            Element::Macro(id) => self.chart.macro_steps[id].label.to_string(),
            Element::Transition(id) => match &self.chart.transitions[id].designation {
                Some(designation) => designation.to_string(),
                None => format!("#{}", id.index() + 1),
            },
        }
    }

    /// What a label says of where a link goes on; a transition without a designation is known by its steps.
    pub(crate) fn onwards(&self, element: Element) -> String {
        match element {
            Element::Step(_) | Element::Macro(_) => format!("step {}", shown(&self.name(element))),
            Element::Transition(id) => {
                let about = &self.chart.transitions[id];
                self.transition(id).unwrap_or_else(|| match (about.post.first(), about.pre.first()) {
                    (Some(node), _) => format!("transition to {}", self.onwards((*node).into())),
                    (None, Some(node)) => format!("transition after {}", self.onwards((*node).into())),
                    (None, None) => "transition".to_string(),
                })
            }
        }
    }

    /// What a label says of where a link comes from.
    pub(crate) fn origin(&self, element: Element) -> String {
        match element {
            Element::Step(_) | Element::Macro(_) => self.onwards(element),
            Element::Transition(id) => {
                let before = self.chart.transitions[id].pre.first();
                let named = || before.map(|node| self.onwards((*node).into()));
                self.transition(id).or_else(named).unwrap_or_else(|| self.onwards(element))
            }
        }
    }

    /// A transition by its designation, if it has one.
    fn transition(&self, id: TransitionId) -> Option<String> {
        self.chart.transitions[id].designation.as_ref().map(|name| format!("transition ({})", shown(name)))
    }

    /// Where drawing begins.
    pub(crate) fn start(&self, element: Element) -> Start {
        let Element::Step(id) = element else { return Start::Plain };
        let step = &self.chart.steps[id];
        let is_entry = step.expansion_of.is_some_and(|of| self.chart.macro_steps[of].entry == Some(id));
        match (step.initial, step.activated || is_entry) {
            (true, _) => Start::Initial,
            (false, true) => Start::Entered,
            (false, false) => Start::Plain,
        }
    }

    /// The links of a transition, in order.
    pub(crate) fn links(&self, element: Element) -> impl Iterator<Item = (Element, Element)> + '_ {
        let transition = match element {
            Element::Transition(id) => Some(&self.chart.transitions[id]),
            Element::Step(_) | Element::Macro(_) => None,
        };
        let pre = transition.into_iter().flat_map(|transition| &transition.pre);
        let post = transition.into_iter().flat_map(|transition| &transition.post);
        pre.map(move |node| (Element::from(*node), element))
            .chain(post.map(move |node| (element, Element::from(*node))))
    }

    /// The transitions that a step or macro-step is before or after, in order.
    pub(crate) fn next_to(&self, element: Element) -> &[TransitionId] {
        let node = match element {
            Element::Step(id) => Node::Step(id),
            Element::Macro(id) => Node::Macro(id),
            Element::Transition(_) => return &[],
        };
        self.next_to.get(&node).map_or(&[], Vec::as_slice)
    }

    /// What an element looks like.
    pub(crate) fn symbol(&self, element: Element) -> Symbol {
        match element {
            Element::Step(id) => {
                let about = &self.chart.steps[id];
                step::step(Step {
                    label: &about.label,
                    comment: about.comment.as_deref(),
                    is_macro: false,
                    is_initial: about.initial,
                    is_enclosing: about.enclosing,
                    is_activated: about.activated,
                    is_active: self.is_active[id],
                    blocks: self.of_steps[id].iter().map(|deed| self.block(*deed)).collect(),
                })
            }
            Element::Macro(id) => {
                let about = &self.chart.macro_steps[id];
                let is_active = self.active_macro(id);
                step::step(Step {
                    label: &about.label,
                    comment: about.comment.as_deref(),
                    is_macro: true,
                    is_initial: false,
                    is_enclosing: false,
                    is_activated: false,
                    is_active,
                    blocks: Vec::new(),
                })
            }
            Element::Transition(id) => {
                let about = &self.chart.transitions[id];
                transition::transition(Transition {
                    name: self.name(element),
                    designation: about.designation.as_deref(),
                    comment: about.comment.as_deref(),
                    condition: wording::expression(self.chart, about.condition),
                    blocks: self.of_transitions[id].iter().map(|deed| self.block(*deed)).collect(),
                    number: id.index() + 1,
                })
            }
        }
    }

    /// A macro-step is active while a step of its expansion is; for expansions within, these are asked.
    fn active_macro(&self, id: MacroId) -> bool {
        let mut of = self.is_active.iter_enumerated().filter(|(_, active)| **active).map(|(step, _)| {
            let mut at = self.chart.steps[step].expansion_of;
            while let Some(outer) = at.filter(|outer| *outer != id) {
                at = self.chart.macro_steps[outer].expansion_of;
            }
            at
        });
        of.any(|found| found == Some(id))
    }

    fn block(&self, (deed, number): (Deed<'_>, usize)) -> Block {
        let stored = match deed {
            Deed::Order(of) => return order::order(self.chart, of, number),
            Deed::Run(run) => {
                let name = &self.chart.grafcets[run.grafcet].name;
                let text = vec![Token::plain(format!("run {}", shown(name)))];
                let owner = self.name(Element::Step(run.step));
                return Block::action(text, When::While(None), commands("run", owner, name, number));
            }
            Deed::Pulse(pulse) => {
                let name = &self.chart.grafcets[pulse.grafcet].name;
                let text = vec![Token::plain(format!("{} {}", pulse.kind.word(), shown(name)))];
                let (when, owner) = match pulse.event {
                    Event::Event(step, event) => {
                        (When::Event(wording::expression(self.chart, event)), Element::Step(step))
                    }
                    Event::Activation(step) => (When::Activation, Element::Step(step)),
                    Event::Deactivation(step) => (When::Deactivation, Element::Step(step)),
                    Event::EachScan(step, _) => (When::While(None), Element::Step(step)),
                    Event::Clearing(transition) => (When::Clearing, Element::Transition(transition)),
                };
                return Block::action(text, when, commands(pulse.kind.word(), self.name(owner), name, number));
            }
            Deed::Continuous(action) => {
                let text = vec![Token::plain(shown(&self.chart.variables[action.target].name))];
                let condition = action.condition.map(|id| wording::expression(self.chart, id));
                let owner = self.name(Element::Step(action.step));
                return Block::action(text, When::While(condition), self.group("action", owner, action.target, number));
            }
            Deed::Stored(stored) => stored,
        };
        let mut text = vec![Token::plain(format!("{} := ", shown(&self.chart.variables[stored.target].name)))];
        text.extend(wording::value(self.chart, stored.value));
        let (when, owner, class) = match stored.event {
            Event::Event(step, event) => {
                (When::Event(wording::expression(self.chart, event)), Element::Step(step), "action on-event")
            }
            Event::Activation(step) => (When::Activation, Element::Step(step), "action on-activation"),
            Event::EachScan(step, condition) => {
                text.push(Token::plain(" each scan".to_owned()));
                let condition = condition.map(|id| wording::expression(self.chart, id));
                (When::While(condition), Element::Step(step), "action each-scan")
            }
            Event::Deactivation(step) => (When::Deactivation, Element::Step(step), "action on-deactivation"),
            Event::Clearing(transition) => (When::Clearing, Element::Transition(transition), "action on-clearing"),
        };
        Block::action(text, when, self.group(class, self.name(owner), stored.target, number))
    }

    fn group(&self, class: &str, owner: String, target: VariableId, number: usize) -> Group {
        let variable = &self.chart.variables[target];
        let group = Group::new(class).of("data-owner", owner).of("data-variable", variable.name.to_string());
        group.of("data-action", number.to_string()).about(variable.comment.as_deref())
    }
}

/// What a pulse order is, to who reads the picture by program.
fn commands(word: &'static str, owner: String, grafcet: &str, number: usize) -> Group {
    let group = Group::new("order pulse").of("data-kind", word.to_owned()).of("data-owner", owner);
    group.of("data-grafcet", grafcet.to_owned()).of("data-order", number.to_string())
}
