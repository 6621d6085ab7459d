//! What the text allows: `allow W0409 "reason"`, for the block that it stands in, the step or transition in whose braces
//! it stands, or the declaration that it names.

use super::parts::Parts;
use super::scope::{Reference, Scope as Names};
use crate::chart::{Variable, VariableId};
use crate::fixes::name_instead;
use crate::symbols::{Role, Symbols, Wanted};
use grafc_diagnostics::{Allowance, Allowances, Code, Diagnostic, Diagnostics, Scope, Severity};
use grafc_syntax::ast;
use index_vec::IndexVec;

/// All allowances; those that make no sense are reported and left out.
pub fn read(
    parts: &Parts,
    names: &Names,
    variables: &IndexVec<VariableId, Variable>,
    symbols: &mut Symbols,
    diagnostics: &mut Diagnostics,
) -> Allowances {
    let mut all = Vec::with_capacity(parts.allows.len());
    for (allow, scope) in &parts.allows {
        let code = Code::parse(&allow.code.text).filter(|code| code.severity() == Severity::Warning);
        if code.is_none() {
            diagnostics.push(not_a_warning(&allow.code));
        }
        let scope = match &allow.about {
            None => Some(*scope),
            Some(name) => match names.reference(&name.text) {
                Some(reference @ Reference::Variable(id)) => {
                    let (entity, form) = reference.entity();
                    symbols.used(name.span, entity, form, Role::Allowed);
                    Some(Scope::Item(variables[id].span))
                }
                Some(Reference::Activity(_) | Reference::Duration(_) | Reference::Frozen(_)) | None => {
                    symbols.missed(name.span, Wanted::Declaration);
                    let fault = names.unknown_name(&name.text, name.span);
                    diagnostics.push(
                        fault.note("what is said of a step or a transition is allowed in its braces, without a name"),
                    );
                    None
                }
            },
        };
        if let (Some(code), Some(scope)) = (code, scope) {
            all.push(Allowance { code, scope, reason: allow.reason.text.to_string(), span: allow.span });
        }
    }
    Allowances::new(all)
}

fn not_a_warning(name: &ast::Name) -> Diagnostic {
    let fault = |message: String| Diagnostic::new(Code::E0215, name.span, message);
    if Code::parse(&name.text).is_some() {
        return fault(format!("`{}` is an error, and only warnings can be allowed", name.text));
    }
    if let Some(code) =
        Code::find(name.text.replace("_", "-").as_str()).filter(|code| code.severity() == Severity::Warning)
    {
        let code = code.as_str();
        return fault(format!("a warning is allowed by its code, and not by the name `{}`", name.text))
            .help(format!("write `{code}`"))
            .fix(name_instead(name.span, code));
    }
    fault(format!("no warning has the code `{}`", name.text))
        .note("the codes of warnings are those that messages show in brackets, such as `W0409`")
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, breaks_all, help, passes};

    const STEPS: &str = "input a : bool initial step 1 step 2 transition 1 -> 2 : a transition 2 -> 1 : not a ";

    #[test]
    fn a_warning_by_its_code() {
        passes(&format!("{STEPS} allow W0409 \"r\" allow w0401 a \"r\""));
        passes(&format!("{STEPS} step 3 {{ allow W0409 \"r\" }} transition 2 -> 3 : a {{ allow W0409 \"r\" }}"));
    }

    #[test]
    fn what_is_no_warning() {
        breaks("E0215", &format!("{STEPS} allow E0201 \"r\""));
        breaks("E0215", &format!("{STEPS} allow W4090 \"r\""));
        breaks("E0215", &format!("{STEPS} step 3 {{ allow W4090 \"r\" }} transition 2 -> 3 : a"));
        let by_name = format!("{STEPS} allow output_read \"r\"");
        breaks("E0215", &by_name);
        assert_eq!(help(&by_name).as_deref(), Some("write `W0401`"));
    }

    #[test]
    fn a_declaration_that_is_not_there() {
        breaks("E0201", &format!("{STEPS} allow W0401 b \"r\""));
        breaks("E0201", &format!("{STEPS} allow W0409 X2 \"r\""));
        breaks_all(&["E0215", "E0201"], &format!("{STEPS} allow W0 b \"r\""));
    }
}
