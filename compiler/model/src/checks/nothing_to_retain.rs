//! E0214: `retain` stands where there is no value to keep.
//!
//! An input is read anew before each reaction, a constant never changes, and what a continuous action sets follows from
//! the situation, which begins anew. Kept is what stored actions set.
//!
//! Wrong: `retain input a : bool`, `retain output V : bool` with `step 1 { V }`
//! Right: `retain var n : int`, `retain output V : bool` with `step 1 { V := 1 on activation }`

use crate::chart::{Mode, VariableId};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix, Span};
use grafc_syntax::ast::DeclarationKind;
use index_vec::{IndexVec, index_vec};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    if resolved.parts.declarations.iter().all(|declaration| declaration.retain.is_none()) {
        return;
    }
    let mut assigned: IndexVec<VariableId, Option<Span>> = index_vec![None; chart.variables.len()];
    for action in &chart.continuous {
        assigned[action.target].get_or_insert(action.span);
    }
    let mut first = 0;
    for declaration in &resolved.parts.declarations {
        let ids = first..first + declaration.names.len();
        first = ids.end;
        let Some(retain) = declaration.retain else { continue };
        let fix = Fix::maybe("leave out `retain`").delete(retain);
        let fault = |what: &str| Diagnostic::new(Code::E0214, retain, format!("{what} cannot be retained")).fix(fix);
        match declaration.kind {
            DeclarationKind::Input => diagnostics.push(
                fault("an input")
                    .note("an input is read anew before each reaction")
                    .help("leave `retain` out; to keep a value that came from an input, store it in a `retain var`"),
            ),
            DeclarationKind::Constant => diagnostics
                .push(fault("a constant").note("a constant has its value at all times").help("leave `retain` out")),
            DeclarationKind::Output | DeclarationKind::Variable => {
                let Some(id) = ids.map(VariableId::new).find(|id| chart.variables[*id].mode == Mode::Wire) else {
                    continue;
                };
                let variable = &chart.variables[id];
                let fault = fault(&format!("`{}`", variable.name));
                let by = assigned[id].unwrap_or(variable.span);
                diagnostics.push(
                    fault
                        .also(by, "this continuous action sets it")
                        .note("it follows from the situation, which begins anew after a restart")
                        .help("leave `retain` out, or set it by stored actions: `V := 1 on activation`"),
                );
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, breaks_all, passes};

    #[test]
    fn what_has_no_value_to_keep() {
        breaks("E0214", "retain input a : bool initial step 1");
        breaks("E0214", "retain const k : int := 1 initial step 1");
        breaks("E0214", "retain output V : bool initial step 1 { V }");
        breaks("E0214", "retain var h : bool output V : bool initial step 1 { h V if h }");
        breaks_all(&["E0214", "E0214"], "retain input a : bool retain input b : bool initial step 1");
    }

    #[test]
    fn one_of_several_names_is_enough() {
        breaks("E0214", "retain output W, V : bool initial step 1 { W := 1 on activation V }");
    }

    #[test]
    fn stored_values() {
        passes(
            "retain var n : int retain output V : bool := 1 initial step 1 { n := 1 on activation V := 0 on activation }",
        );
        passes("retain var unused : int initial step 1");
    }
}
