//! Declarations, and variables that may not be what they are declared as.
//!
//! The editor declares an input where nobody says otherwise, and it has no delays in conditions, so its users declare
//! a variable called `2s/X202`. Neither is an error for it; both leave a chart that cannot do what it is to do.

use super::Writer;
use super::delays;
use super::names::ImportNames;
use crate::agrafe::model::{ActionKind, Model, Sort, StoredActionType, TermKind, VariableId, VariableKind};
use crate::agrafe::target;
use crate::naming::{clean, spell};
use crate::{Options, changed, doubtful, lost};
use grafc_diagnostics::{Diagnostic, Diagnostics};
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashMap;

/// What actions and terms do with a variable.
#[derive(Clone, Copy, Default)]
pub struct Use {
    /// By a continuous action.
    pub continuous: bool,
    /// By a stored action.
    pub stored: bool,
    /// In a term.
    pub read: bool,
    /// In arithmetic, where delays cannot stand.
    pub calculated: bool,
}

/// The uses of each variable. Actions without step do not count.
pub fn uses(model: &Model) -> IndexVec<VariableId, Use> {
    let mut uses: IndexVec<VariableId, Use> = index_vec![Use::default(); model.variables.len()];
    let mut calculated = index_vec![false; model.terms.len()];
    let mut assigned = index_vec![false; model.terms.len()];
    for action in &model.actions {
        match &action.kind {
            ActionKind::Continuous { variable, .. } => variable.iter().for_each(|term| assigned[*term] = true),
            ActionKind::Stored { variable, value, .. } => {
                variable.iter().for_each(|term| assigned[*term] = true);
                value.iter().for_each(|term| calculated[*term] = true);
            }
            ActionKind::Force { .. } => {}
        }
    }
    for (id, term) in model.terms.iter_enumerated() {
        let compares = matches!(term.kind, TermKind::Equal | TermKind::Greater | TermKind::Less);
        for &operand in &term.operands {
            calculated[operand] = calculated[id] || compares;
        }
        if let TermKind::Variable(Some(variable)) = term.kind
            && !assigned[id]
        {
            uses[variable].read = true;
            uses[variable].calculated |= calculated[id];
        }
    }
    for link in &model.links {
        match &model.actions[link.action].kind {
            ActionKind::Continuous { variable, .. } => {
                target(model, *variable).into_iter().for_each(|variable| uses[variable].continuous = true);
            }
            ActionKind::Stored { variable, .. } => {
                target(model, *variable).into_iter().for_each(|variable| uses[variable].stored = true);
            }
            ActionKind::Force { .. } => {}
        }
    }
    uses
}

/// Messages about the variables, and what is done with them.
pub struct Variables {
    /// Which keyword declares it; none of step variables and of those that became delays.
    pub keywords: IndexVec<VariableId, Option<&'static str>>,
    /// The delays that stand for variables.
    pub delays: FxHashMap<VariableId, String>,
}

/// Looks at all variables.
pub fn judge(
    model: &Model,
    names: &ImportNames,
    uses: &IndexVec<VariableId, Use>,
    options: &Options,
    diagnostics: &mut Diagnostics,
) -> Variables {
    let steps = delays::Steps::of(model, names);
    let mut found = Variables { keywords: IndexVec::new(), delays: FxHashMap::default() };
    for (id, variable) in model.variables.iter_enumerated() {
        let (used, name) = (uses[id], &names.variables[id]);
        let assigned = used.continuous || used.stored;
        let keyword = match variable.kind {
            VariableKind::Input if assigned => {
                diagnostics.push(
                    doubtful(variable.span, format!("`{name}` is declared as an input, and actions set it")).note(
                        "it is a `var` now; in AGRAFE a variable is an input unless it is declared as something else",
                    ),
                );
                "var"
            }
            VariableKind::Input => "input",
            VariableKind::Output => "output",
            VariableKind::Internal => "var",
            VariableKind::Step(Some(_)) => {
                let given = variable.name.as_deref().unwrap_or_default();
                if used.read && given != name {
                    let message = format!("`{}` is `{name}`, as its step is called", clean(given));
                    diagnostics.push(changed(variable.span, message));
                }
                found.keywords.push(None);
                continue;
            }
            VariableKind::Step(None) => {
                diagnostics.push(
                    doubtful(
                        variable.span,
                        format!("`{name}` is the activity of a step, but does not say of which step"),
                    )
                    .help(format!("write the activity, such as `X1`, in place of `{name}`")),
                );
                "var"
            }
        };
        let delay = delays::read(name, &steps).filter(|_| variable.sort == Sort::Bool && !assigned);
        let mut keyword = Some(keyword);
        match delay {
            Some(delay) if options.delays && !used.calculated => {
                diagnostics.push(changed(variable.span, format!("the variable `{name}` is a delay now, `{delay}`")));
                found.delays.insert(id, delay);
                keyword = None;
            }
            Some(delay) => diagnostics.push(looks_like_delay(variable.span, name, &delay, used)),
            None if used.read && !assigned => {
                let kind = match variable.kind {
                    VariableKind::Output => "an output",
                    VariableKind::Internal => "internal",
                    VariableKind::Input | VariableKind::Step(_) => "",
                };
                if !kind.is_empty() {
                    diagnostics.push(
                        doubtful(
                            variable.span,
                            format!("`{name}` is declared as {kind} and read, and nothing sets it"),
                        )
                        .note("so it keeps its first value")
                        .help("if it comes from outside, declare it as `input`"),
                    );
                }
            }
            None => {}
        }
        found.keywords.push(keyword);
    }
    found
}

fn looks_like_delay(span: grafc_diagnostics::Span, name: &str, delay: &str, used: Use) -> Diagnostic {
    let message = format!("the variable `{name}` is a delay that could not be written as one");
    let doubt = doubtful(span, message).note("it stays a variable that nothing sets, and keeps its first value");
    if used.calculated {
        doubt.help(format!("make a condition of it that is not in brackets, with `{delay}`"))
    } else {
        doubt.help(format!("import with `--delays`, or write `{delay}` in place of `` `{name}` ``"))
    }
}

/// Reports stored actions that set to false what continuous actions make true, and which are therefore left out.
///
/// AGRAFE's code lets the last assignment win. IEC 60848 (4.10.5) forbids the mixture; and without a continuous action
/// its variable is false anyway.
pub fn left_out(model: &Model, uses: &IndexVec<VariableId, Use>, diagnostics: &mut Diagnostics) -> Vec<bool> {
    let left_out = |kind: &ActionKind| match kind {
        ActionKind::Stored { variable, value: Some(value), event, .. } => {
            let resets = model.terms[*value].kind == TermKind::Boolean(false);
            let mixed = target(model, *variable).is_some_and(|id| uses[id].continuous);
            resets && mixed && *event != StoredActionType::Event
        }
        ActionKind::Stored { .. } | ActionKind::Continuous { .. } | ActionKind::Force { .. } => false,
    };
    let found: Vec<bool> = model.actions.iter().map(|action| left_out(&action.kind)).collect();
    for (action, _) in model.actions.iter().zip(&found).filter(|(_, left_out)| **left_out) {
        diagnostics.push(
            lost(action.span, "a stored action that resets the output of continuous actions is lost")
                .note("an output is set by one of the two (IEC 60848, 4.10.5)")
                .note("without a continuous action that applies, it is false anyway"),
        );
    }
    found
}

impl Writer<'_> {
    /// The declaration of a variable, if it has one.
    pub fn declaration(&mut self, id: VariableId) {
        let Some(keyword) = self.variables.keywords[id] else { return };
        let variable = &self.model.variables[id];
        self.comments_before(variable.element);
        let ty = match variable.sort {
            Sort::Bool => "bool",
            // `EInt` has 32 bits.
            Sort::Integer => "dint",
        };
        let name = spell(&self.names.variables[id]);
        self.text.push(&format!("{keyword} {name} : {ty}\n"));
    }
}
