//! What a chart is made with: the project, and all that has been found and made so far.

use super::terms::{StepId, TermId, Terms, VarId};
use super::variables::Variables;
use crate::Dialect;
use crate::code::tree::Argument;
use crate::sfc::{Body, Chart, Project, Qualifier, Unit};
use grafc_diagnostics::{Diagnostics, Span};
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

/// Where names are looked up: the unit, and what stands before its names, `Valve.` for those of an instance.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Scope {
    pub unit: usize,
    pub prefix: String,
}

/// A chart that is written as a grafcet: that of the unit, or an action that is one.
pub struct Part<'a> {
    pub scope: Scope,
    pub name: String,
    pub chart: &'a Chart,
    /// Where its steps begin among all.
    pub first: usize,
    /// Who does it: steps and how; none of what is always done.
    pub callers: Vec<(StepId, Qualifier, Span)>,
    pub span: Span,
    /// True while it goes on.
    pub called: Option<TermId>,
    /// Whose child program it is, and whether it is given an order that was written.
    pub parent: Option<usize>,
    pub ordered: bool,
}

/// A step among all.
pub struct PartStep {
    pub part: usize,
    pub step: usize,
}

/// When a variable is set.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum When {
    Activation,
    Deactivation,
    /// In each scan in which a condition holds.
    EachScan(Option<TermId>),
}

/// What a step orders a child program.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Command {
    Start,
    Kill,
    Freeze,
    Resume,
}

/// When an order is given.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Event {
    Activation,
    Deactivation,
    Edge(TermId),
}

/// What a step does.
#[derive(Clone, Copy)]
pub enum Action {
    Continuous {
        variable: VarId,
        condition: Option<TermId>,
    },
    Stored {
        variable: VarId,
        value: TermId,
        when: When,
    },
    /// An order to a child program.
    Pulse {
        command: Command,
        child: usize,
        event: Event,
    },
    /// A child program goes on while the step is active.
    Run {
        child: usize,
    },
}

/// A step as it is written.
#[derive(Default)]
pub struct StepText {
    pub actions: Vec<Action>,
    /// What is lost, as comment lines.
    pub lost: Vec<String>,
}

/// A call of a function block.
pub struct BlockCall {
    pub scope: Scope,
    pub arguments: Vec<Argument>,
    /// While one of them holds it is made; none: in each scan.
    pub while_true: Vec<TermId>,
    /// Whether it is made in each scan.
    pub always: bool,
    pub span: Span,
}

/// Makes a chart.
pub struct Maker<'a> {
    pub project: &'a Project,
    pub dialect: Dialect,
    pub diagnostics: &'a mut Diagnostics,
    pub terms: Terms,
    pub variables: Variables,
    pub parts: Vec<Part<'a>>,
    pub steps: IndexVec<StepId, PartStep>,
    pub step_texts: IndexVec<StepId, StepText>,
    /// What is done whatever step is active.
    pub always: Vec<Action>,
    /// Steps by part and name in small letters.
    pub by_name: FxHashMap<(usize, String), StepId>,
    /// Units by name in small letters.
    pub units: FxHashMap<String, usize>,
    /// The parts of units that are child programs.
    pub children: FxHashMap<usize, usize>,
    /// Named values of types.
    pub constants: FxHashMap<String, i64>,
    /// Calls of function blocks, by the path of the instance in small letters.
    pub calls: FxHashMap<String, BlockCall>,
    /// The delays that were called so far where statements are done one after the other, as above.
    pub delays_called: FxHashSet<String>,
    /// Of delays whose output is read behind their call in the same scan, where.
    pub read_behind: FxHashMap<String, Span>,
    /// What is written as an edge, by the output that finds it in the file, and where that is read first.
    pub edges: Vec<(String, Span)>,
    /// The condition under which a value is looked at.
    pub here: Option<TermId>,
    /// How deep edges of edges are looked at.
    pub depth: usize,
    /// The number of the last condition that was lost.
    pub lost_conditions: usize,
    /// What has been said already and is true of many places.
    pub said: FxHashSet<String>,
}

impl<'a> Maker<'a> {
    /// The unit of a scope.
    pub fn unit(&self, scope: &Scope) -> &'a Unit {
        &self.project.units[scope.unit]
    }

    /// The action of a name: its scope and itself. `Valve.open` is one of the type of `Valve`.
    pub fn action(&self, scope: &Scope, name: &str) -> Option<(Scope, usize)> {
        let mut scope = scope.clone();
        let mut segments: Vec<&str> = name.split('.').collect();
        let last = segments.pop()?;
        for segment in segments {
            let variable = self.unit(&scope).variables.find(segment);
            let ty = match variable {
                Some(variable) => variable.ty.as_str(),
                // The name of a program stands for its only instance.
                None => segment,
            };
            let unit = *self.units.get(&ty.to_lowercase())?;
            let prefix = if variable.is_some() { format!("{}{segment}.", scope.prefix) } else { format!("{segment}.") };
            scope = Scope { unit, prefix };
        }
        let place = self.unit(&scope).actions.place(last)?;
        Some((scope, place))
    }

    /// The body of an action.
    pub fn body(&self, scope: &Scope, action: usize) -> &'a Body {
        &self.project.units[scope.unit].actions[action].body
    }

    /// The step of a name: of the part that names it, or of another of the same unit.
    pub fn step(&self, part: usize, name: &str) -> Option<StepId> {
        let name = name.to_lowercase();
        if let Some(&step) = self.by_name.get(&(part, name.clone())) {
            return Some(step);
        }
        let scope = &self.parts[part].scope;
        let others = self.parts.iter().enumerate().filter(|(_, other)| other.scope == *scope);
        let mut found = others.filter_map(|(place, _)| self.by_name.get(&(place, name.clone())));
        found.next().copied()
    }

    /// Says something once of a chart.
    pub fn once(&mut self, key: impl Into<String>) -> bool {
        self.said.insert(key.into())
    }
}
