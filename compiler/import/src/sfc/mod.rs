//! Sequential function charts of IEC 61131-3, in whatever form a file has them.
//!
//! A project has program organisation units, each with its declarations; a unit, or a named action of one, has a chart as
//! its body. Names are as in the file and mean the same in any case. Conditions and bodies lie in one [`Code`].

mod by_name;

use crate::code::tree::{Code, ExprId, Statement};
pub use by_name::ByName;
use grafc_diagnostics::Span;

/// All that a file has.
#[derive(Default)]
pub struct Project {
    pub code: Code,
    pub units: Vec<Unit>,
    /// Variables outside of units.
    pub globals: ByName<Variable>,
    pub enumerations: ByName<Enumeration>,
    pub structures: ByName<Structure>,
    /// The product that wrote the file, if it says so.
    pub product: Option<String>,
}

/// A program, or a type of function blocks.
pub struct Unit {
    pub name: String,
    pub span: Span,
    pub variables: ByName<Variable>,
    pub actions: ByName<NamedAction>,
    /// The body, if it is a chart.
    pub chart: Option<Chart>,
}

/// A variable that is declared.
#[derive(Clone)]
pub struct Variable {
    pub name: String,
    pub section: Section,
    /// Its type as it is written, in capitals if it is elementary.
    pub ty: String,
    pub initial: Option<ExprId>,
    pub address: Option<String>,
    pub comment: Option<String>,
    pub constant: bool,
    pub retain: bool,
    pub span: Span,
}

/// Where a variable is declared.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Section {
    Input,
    Output,
    InOut,
    Local,
    External,
    Global,
}

/// A type with named values.
pub struct Enumeration {
    pub name: String,
    /// The names, with their numbers.
    pub values: Vec<(String, i64)>,
}

/// A type with members.
pub struct Structure {
    pub name: String,
    pub members: ByName<Variable>,
}

/// An action with a name.
pub struct NamedAction {
    pub name: String,
    pub span: Span,
    pub body: Body,
}

/// What an action does.
pub enum Body {
    Statements(Vec<Statement>),
    /// A chart, which goes on while the action is done.
    Chart(Chart),
}

/// Steps and transitions.
#[derive(Default)]
pub struct Chart {
    pub steps: Vec<Step>,
    pub transitions: Vec<Transition>,
    /// What is drawn beside the steps and done in each scan: blocks whose outputs are wired to conditions.
    pub beside: Vec<Statement>,
}

/// A step.
pub struct Step {
    pub name: String,
    pub initial: bool,
    pub span: Span,
    pub actions: Vec<Association>,
    pub comment: Option<String>,
}

/// What a step does with an action.
pub struct Association {
    pub qualifier: Qualifier,
    /// Its time, if it has one.
    pub time: Option<ExprId>,
    pub action: Target,
    pub span: Span,
}

/// What is done.
pub enum Target {
    /// A Boolean variable or an action of this name.
    Named(String),
    Inline(Vec<Statement>),
}

/// How an action is done (IEC 61131-3, 2.6.4.4), and CODESYS's ways beside.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Qualifier {
    N,
    S,
    R,
    P,
    P1,
    P0,
    L,
    D,
    SD,
    DS,
    SL,
    /// The action of a step of CODESYS, which is not done once more at the end.
    Main,
    /// At the entry and at the exit.
    Entry,
    Exit,
}

impl Qualifier {
    /// The qualifier of a name.
    pub fn of(name: &str) -> Option<Qualifier> {
        Some(match name.trim().to_ascii_uppercase().as_str() {
            "N" | "" => Qualifier::N,
            "S" => Qualifier::S,
            "R" => Qualifier::R,
            "P" => Qualifier::P,
            "P1" => Qualifier::P1,
            "P0" => Qualifier::P0,
            "L" => Qualifier::L,
            "D" => Qualifier::D,
            "SD" => Qualifier::SD,
            "DS" => Qualifier::DS,
            "SL" => Qualifier::SL,
            _ => return None,
        })
    }

    /// Whether it needs a time.
    pub fn is_timed(self) -> bool {
        matches!(self, Qualifier::L | Qualifier::D | Qualifier::SD | Qualifier::DS | Qualifier::SL)
    }
}

/// A transition. Steps are places in the list of the chart.
pub struct Transition {
    pub before: Vec<usize>,
    pub behind: Vec<usize>,
    pub condition: ExprId,
    /// The smaller, the earlier.
    pub priority: Option<i64>,
    pub span: Span,
}

impl Chart {
    /// Whether at most one step can be active: one begins, and no transition has two before or behind it.
    pub fn is_sequential(&self) -> bool {
        self.steps.iter().filter(|step| step.initial).count() <= 1
            && self.transitions.iter().all(|t| t.before.len() == 1 && t.behind.len() <= 1)
    }
}

impl Unit {
    /// How many charts it has, those of its actions among them.
    pub fn charts(&self) -> impl Iterator<Item = &Chart> {
        let of_action = |action: &'_ NamedAction| matches!(action.body, Body::Chart(_));
        let actions = self.actions.iter().filter(move |action| of_action(action));
        self.chart.iter().chain(actions.filter_map(|action| match &action.body {
            Body::Chart(chart) => Some(chart),
            Body::Statements(_) => None,
        }))
    }
}
