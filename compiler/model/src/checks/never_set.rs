//! W0420: an output that nothing sets, or a variable that is read and never set.
//!
//! It keeps the value that it has at the start. A value that never changes is a `const`; most often an action is missing,
//! or names another variable. What has an address may be set by others, as a variable in the memory of the PLC.
//!
//! Warned of: `output V : bool`, and no action names it; `var n : int`, `transition 1 -> 2 : [n > 3]`
//! Not warned of: an input

use crate::chart::VariableKind;
use crate::dump::literal;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// One warning per name.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    for (variable, usage) in chart.variables.iter().zip(&resolved.symbols.usage) {
        if usage.set.is_some() {
            continue;
        }
        let name = &variable.name;
        let (what, help) = match (variable.kind, usage.read) {
            (VariableKind::Output, None) => {
                let allow = format!("`allow W0420 {} \"reason\"`", grafc_syntax::dump::plain_or_quoted(name));
                (
                    format!("the output `{name}` is never set"),
                    format!("set it in an action, or leave it out; what is there for later: {allow}"),
                )
            }
            (VariableKind::Output, Some(_)) => {
                (format!("the output `{name}` is read and never set"), "set it in an action".to_owned())
            }
            (VariableKind::Internal, Some(_)) if variable.address.is_none() => (
                format!("the variable `{name}` is read and never set"),
                "set it in an action; a value that never changes is declared as `const`".to_owned(),
            ),
            (VariableKind::Internal | VariableKind::Input | VariableKind::Constant, _) => continue,
        };
        let mut diagnostic = Diagnostic::new(Code::W0420, variable.span, what);
        if let Some(place) = usage.read {
            diagnostic = diagnostic.also(place, format!("always `{}` here", literal(variable.initial(), variable.ty)));
        }
        diagnostics.push(diagnostic.help(help));
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{all_codes, labels_of};

    #[test]
    fn each_kind() {
        assert_eq!(all_codes("output V : bool initial step 1"), ["W0420"]);
        let read = "output V : bool initial step 1 step 2 transition 1 -> 2 : V";
        assert_eq!(all_codes(read), ["W0420"]);
        let text = "var n : int := 4 initial step 1 step 2 transition 1 -> 2 : [n > 3]";
        assert_eq!(labels_of(text), ["n: always `int#4` here"]);
    }

    #[test]
    fn what_is_set() {
        let text = "output V, W : bool output n : int input a : bool initial step 1 { V W := 1 on activation } step 2
            transition 1 -> 2 : a { n := 3 }";
        assert_eq!(all_codes(text), [""; 0]);
    }

    #[test]
    fn others_may_set_it() {
        assert_eq!(all_codes("var n : int at %MW4 initial step 1 step 2 transition 1 -> 2 : [n > 3]"), [""; 0]);
    }
}
