//! Inputs that act on a chart as a whole, and the output that says which assertion came out false: no part of its text, but of what is asked of its code.

use super::{Chart, Mode, Type, Value, Variable, VariableId, VariableKind};
use ecow::EcoString;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};

/// The inputs of a chart that act on it as a whole.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Controls {
    /// While it is true, each call starts the chart anew (R10).
    pub reset: Option<VariableId>,
    /// Whether what is retained keeps its value then, as over a restart of the controller.
    pub keeps_retained: bool,
    /// While it is true, each call begins with all flags lowered.
    pub clear_flags: Option<VariableId>,
    /// An output: the number of the first assertion that was false; 0 while none was. It stays as flags do.
    pub assertion: Option<VariableId>,
}

impl Controls {
    /// Whether a variable is one of them. They are no inputs of the chart: a change of one is no input event (R7).
    pub fn has(&self, variable: VariableId) -> bool {
        [self.reset, self.clear_flags].contains(&Some(variable))
    }
}

/// The names that such inputs are wanted under.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ControlNames {
    /// Of the one that starts the chart anew.
    pub reset: Option<EcoString>,
    /// Whether that leaves what is retained as it is.
    pub reset_keeps_retained: bool,
    /// Of the one that lowers the flags.
    pub clear_flags: Option<EcoString>,
    /// Whether assertions are checked, and the first that comes out false is told by the output `ASSERTION`.
    pub check_assertions: bool,
}

/// What is called so that says which assertion came out false.
const ASSERTION: &str = "ASSERTION";

impl Chart {
    /// Gives the chart inputs that act on it as a whole, after those that it declares.
    ///
    /// # Errors
    /// Of each name that the chart could not declare beside its own.
    pub fn control(&mut self, names: &ControlNames) -> Result<(), Diagnostics> {
        let mut diagnostics = Diagnostics::new();
        let mut add = |name: &Option<EcoString>, about: &str, option: &str| {
            let name = name.as_ref()?;
            if let Some(fault) = taken(self, name, option) {
                diagnostics.push(fault);
                return None;
            }
            let file = self.grafcets.first().map_or_else(FileId::default, |grafcet| grafcet.span.file);
            let span = Span::new(file, 0, 0);
            Some(self.edit().variables.push(Variable {
                comment: Some(about.into()),
                ..Variable::new(name.clone(), VariableKind::Input, Type::Bool, Value::Bool(false), span)
            }))
        };
        let reset = add(&names.reset, "while true, the chart starts anew", "--reset-input");
        let clear_flags = add(&names.clear_flags, "while true, flags are lowered", "--clear-flags-input");
        let assertion = match names.check_assertions.then(|| self.assertion()).transpose() {
            Ok(assertion) => assertion.flatten(),
            Err(fault) => {
                diagnostics.push(*fault);
                None
            }
        };
        self.edit().controls = Controls { reset, keeps_retained: names.reset_keeps_retained, clear_flags, assertion };
        if diagnostics.has_errors() { Err(diagnostics) } else { Ok(()) }
    }
}

impl Chart {
    /// Gives the chart the output that says which assertion came out false, if it has assertions to check.
    fn assertion(&mut self) -> Result<Option<VariableId>, Box<Diagnostic>> {
        let names: Vec<String> =
            self.claims.assertions().map(|(number, claim, _)| format!("{number}: {}", claim.name())).collect();
        if names.is_empty() {
            return Ok(None);
        }
        if let Some(fault) = taken(self, ASSERTION, "--check-assertions") {
            return Err(Box::new(fault.help(format!("give it another name than `{ASSERTION}`"))));
        }
        let ty = if names.len() <= i16::MAX as usize { Type::Int } else { Type::Dint };
        let file = self.grafcets.first().map_or_else(FileId::default, |grafcet| grafcet.span.file);
        Ok(Some(self.edit().variables.push(Variable {
            comment: Some(EcoString::from(format!("the first assertion that was false; {}", names.join(", "))).into()),
            mode: Mode::Stored,
            ..Variable::new(ASSERTION, VariableKind::Output, ty, Value::Int(0), Span::new(file, 0, 0))
        })))
    }
}

/// The error on a name that the chart has, or that code cannot tell from one of the chart's: the rules are those of names
/// that a chart declares.
fn taken(chart: &Chart, name: &str, option: &str) -> Option<Diagnostic> {
    let folded = name.to_lowercase();
    if let Some(variable) = chart.variables.iter().find(|variable| variable.name.to_lowercase() == folded) {
        let is_same = variable.name == name;
        let message = if is_same {
            format!("`{option} {name}` names what is there already")
        } else {
            format!("`{option} {name}` and `{}` differ only by case", variable.name)
        };
        let fault = Diagnostic::new(Code::E0216, variable.span, message);
        let fault = if is_same { fault } else { fault.note(ONE_NAME) };
        return Some(match variable.span.end {
            0 => fault.help("give the two inputs names of their own"),
            _ if is_same => fault
                .here("declared here")
                .help("choose another name, or leave the option out and use the one of the chart"),
            _ => fault.here("declared here").help("choose another name"),
        });
    }
    let (label, kind, what, span) = implicit(chart, &folded)?;
    let is_same = name.get(1..) == Some(label) && name.starts_with(['X', 'T']);
    let own = format!("{}{label}", name[..1].to_ascii_uppercase());
    let message = if is_same {
        format!("`{option} {name}` names what is there already: the {what} of {kind} `{label}`")
    } else {
        format!("`{option} {name}` and `{own}`, the {what} of {kind} `{label}`, differ only by case")
    };
    let fault = Diagnostic::new(Code::E0216, span, message).here(format!("the {kind} is here"));
    let fault = if is_same { fault } else { fault.note(ONE_NAME) };
    Some(fault.help("choose another name"))
}

/// The label whose implicit variable a name is, whatever the case; what it is a label of, what the variable is, and where.
fn implicit<'a>(chart: &'a Chart, folded: &str) -> Option<(&'a str, &'static str, &'static str, Span)> {
    let (of_all, rest) =
        folded.strip_prefix('x').map(|rest| (true, rest)).or_else(|| Some((false, folded.strip_prefix('t')?)))?;
    let what = if of_all { "activity" } else { "duration" };
    let grafcets = chart.grafcets.iter().filter(|_| of_all).map(|one| (&one.name, "grafcet", one.span));
    let macros = chart.macro_steps.iter().filter(|_| of_all).map(|one| (&one.label, "macro-step", one.span));
    let steps = chart.steps.iter().map(|one| (&one.label, "step", one.span));
    let (label, kind, span) = grafcets.chain(macros).chain(steps).find(|(label, ..)| label.to_lowercase() == rest)?;
    Some((label, kind, what, span))
}

const ONE_NAME: &str = "IEC 61131-3 does not tell capital letters from small ones: the two would be one name";
