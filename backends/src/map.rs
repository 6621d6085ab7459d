//! The elements of a chart and the lines of code that come from them.

use crate::lines::Lines;
use grafc_diagnostics::Span;
use grafc_logic::scan::{GrafcetId, Origin, Program, Role, VariableId};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// All elements of a chart, in the order in which it writes them, each with its lines.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Map {
    /// The elements.
    pub elements: Vec<Element>,
}

/// An element of a chart.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Element {
    /// What it is.
    pub kind: Kind,
    /// What it is called: the label of a step, the designation of a transition or its number, the variable of an action or
    /// a declaration, the grafcet that an order forces.
    pub name: String,
    /// Of a transition, the steps around it as the chart writes them; of an action or an order, the step or transition that
    /// it belongs to.
    pub at: Option<String>,
    /// The attached comment.
    pub comment: Option<String>,
    /// Where it is in the chart.
    pub span: Span,
    /// Its lines, counted from 1: the first and the last of each run, in order.
    pub lines: Vec<(u32, u32)>,
}

/// What an element is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Kind {
    /// The declaration of a variable.
    Declaration,
    /// A step.
    Step,
    /// A transition.
    Transition,
    /// An action.
    Action,
    /// A forcing order.
    Order,
}

impl Kind {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Declaration => "declaration",
            Kind::Step => "step",
            Kind::Transition => "transition",
            Kind::Action => "action",
            Kind::Order => "order",
        }
    }
}

impl Map {
    /// The elements of a program with their lines.
    pub(crate) fn new(program: &Program, lines: &Lines) -> Self {
        let mut table = Table::new(program);
        for (origin, first, last) in &lines.ranges {
            table.add(*origin, (*first, *last));
        }
        let mut elements = table.elements;
        elements.iter_mut().for_each(|element| element.lines = joined(std::mem::take(&mut element.lines)));
        elements.sort_by_key(|element| (element.span.start, element.kind));
        Map { elements }
    }
}

/// The elements of a program, and what stands for which of them.
struct Table {
    elements: Vec<Element>,
    of: FxHashMap<Origin, usize>,
    /// The actions on a variable, and the orders on a grafcet.
    actions: IndexVec<VariableId, Vec<usize>>,
    orders: FxHashMap<GrafcetId, Vec<usize>>,
}

impl Table {
    fn new(program: &Program) -> Self {
        let mut table = Table {
            elements: Vec::new(),
            of: FxHashMap::default(),
            actions: IndexVec::new(),
            orders: FxHashMap::default(),
        };
        // The variables of the chart come first in the table of the program.
        let declared = program.variables.iter().take_while(|variable| {
            matches!(variable.role, Role::Input | Role::Output | Role::Internal | Role::Constant)
        });
        let mut names: IndexVec<VariableId, &str> = IndexVec::new();
        for variable in declared {
            let id = names.push(&variable.name);
            table.actions.push(Vec::new());
            let span = variable.span.unwrap_or_default();
            table.push(
                Origin::Declaration(id),
                Kind::Declaration,
                &variable.name,
                None,
                variable.comment.as_deref(),
                span,
            );
        }
        for (s, step) in program.steps.iter_enumerated() {
            table.push(Origin::Step(s), Kind::Step, &step.label, None, step.comment.as_deref(), step.span);
        }
        let elements = &program.elements;
        for (t, transition) in elements.transitions.iter_enumerated().filter(|(t, _)| program.is_of_chart(*t)) {
            let number = (t.index() + 1).to_string();
            let name = transition.designation.as_deref().unwrap_or(&number);
            let (arrow, comment) = (Some(program.arrow(t)), transition.comment.as_deref());
            table.push(Origin::Transition(t), Kind::Transition, name, arrow, comment, transition.span);
        }
        for (a, action) in elements.actions.iter_enumerated() {
            let at = match action.of {
                Origin::Transition(t) => Some(program.arrow(t)),
                Origin::Step(s) => Some(program.label(s).to_owned()),
                Origin::Chart
                | Origin::Action(_)
                | Origin::Actions(_)
                | Origin::Order(_)
                | Origin::Orders(_)
                | Origin::Declaration(_) => None,
            };
            table.actions[action.target].push(table.elements.len());
            table.push(Origin::Action(a), Kind::Action, names[action.target], at, None, action.span);
        }
        for (o, order) in elements.orders.iter_enumerated() {
            let at = Some(program.label(order.step).to_owned());
            table.orders.entry(order.grafcet).or_default().push(table.elements.len());
            table.push(Origin::Order(o), Kind::Order, &order.name, at, None, order.span);
        }
        table
    }

    fn push(&mut self, origin: Origin, kind: Kind, name: &str, at: Option<String>, comment: Option<&str>, span: Span) {
        let (name, comment) = (name.to_owned(), comment.map(str::to_owned));
        self.of.insert(origin, self.elements.len());
        self.elements.push(Element { kind, name, at, comment, span, lines: Vec::new() });
    }

    fn add(&mut self, origin: Origin, lines: (u32, u32)) {
        let several = match origin {
            Origin::Actions(v) => self.actions[v].as_slice(),
            Origin::Orders(g) => self.orders.get(&g).map_or(&[][..], Vec::as_slice),
            Origin::Chart
            | Origin::Step(_)
            | Origin::Transition(_)
            | Origin::Action(_)
            | Origin::Order(_)
            | Origin::Declaration(_) => self.of.get(&origin).map_or(&[][..], std::slice::from_ref),
        };
        for place in several {
            self.elements[*place].lines.push(lines);
        }
    }
}

/// Runs of lines in order, those that meet as one.
fn joined(mut runs: Vec<(u32, u32)>) -> Vec<(u32, u32)> {
    runs.sort_unstable();
    let mut joined: Vec<(u32, u32)> = Vec::with_capacity(runs.len());
    for (first, last) in runs {
        match joined.last_mut() {
            Some((_, end)) if first <= *end + 1 => *end = last.max(*end),
            _ => joined.push((first, last)),
        }
    }
    joined
}
