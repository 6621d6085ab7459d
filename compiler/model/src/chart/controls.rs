//! Inputs that act on a chart as a whole: no part of its text, but of what is asked of its code.

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
}

impl Chart {
    /// Gives the chart inputs that act on it as a whole, after those that it declares.
    ///
    /// # Errors
    /// Of each name that is declared already.
    pub fn control(&mut self, names: &ControlNames) -> Result<(), Diagnostics> {
        let mut diagnostics = Diagnostics::new();
        let mut add = |name: &Option<EcoString>, about: &str, option: &str| {
            let name = name.as_ref()?;
            if let Some(variable) = self.variables.iter().find(|variable| variable.name == *name) {
                diagnostics.push(taken(name, variable, option));
                return None;
            }
            let file = self.grafcets.first().map_or_else(FileId::default, |grafcet| grafcet.span.file);
            Some(self.edit().variables.push(Variable {
                name: name.clone(),
                comment: Some(about.into()),
                kind: VariableKind::Input,
                ty: Type::Bool,
                initial: Value::Bool(false),
                initial_given: false,
                retain: false,
                address: None,
                mode: Mode::Given,
                span: Span::new(file, 0, 0),
            }))
        };
        let reset = add(&names.reset, "while true, the chart starts anew", "--reset-input");
        let clear_flags = add(&names.clear_flags, "while true, flags are lowered", "--clear-flags-input");
        self.edit().controls = Controls { reset, keeps_retained: names.reset_keeps_retained, clear_flags };
        if diagnostics.has_errors() { Err(diagnostics) } else { Ok(()) }
    }
}

fn taken(name: &str, variable: &Variable, option: &str) -> Diagnostic {
    let diagnostic =
        Diagnostic::new(Code::E0216, variable.span, format!("`{option} {name}` names what is there already"));
    if variable.span.end == 0 {
        return diagnostic.help("give the two inputs names of their own");
    }
    diagnostic.here("declared here").help("choose another name, or leave the option out and use the one of the chart")
}
