//! E0412: a variable is assigned by continuous actions or allocated by stored ones, not both.
//!
//! A continuous action says what the value is, a stored one what it becomes and stays; one variable cannot obey both
//! (IEC 60848, 4.10.5, note 1).
//!
//! Wrong: `step 1 { V }`, `step 2 { V := 1 on activation }`
//! Right: `step 1 { V }`, `step 2 { V }`

use crate::chart::VariableId;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use index_vec::{IndexVec, index_vec};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    if chart.stored.is_empty() {
        return;
    }
    let mut assigned: IndexVec<VariableId, Option<Span>> = index_vec![None; chart.variables.len()];
    for action in &chart.continuous {
        assigned[action.target].get_or_insert(action.span);
    }
    for action in &chart.stored {
        if let Some(other) = assigned[action.target].take() {
            let name = &chart.variables[action.target].name;
            let message = format!("`{name}` is set by a continuous action and by a stored one");
            diagnostics.push(
                Diagnostic::new(Code::E0412, action.span, message)
                    .here("the stored action")
                    .also(other, "the continuous action")
                    .note("IEC 60848, 4.10.5, note 1: an output is either assigned or allocated")
                    .help(format!("set `{name}` by stored actions alone, or by continuous ones alone")),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn both() {
        breaks("E0412", "output V : bool initial step 1 { V } step 2 { V := 1 on activation }");
        breaks("E0412", "input a : bool output V : bool initial step 1 { V } step 2 transition 1 -> 2 : a { V := 0 }");
    }

    #[test]
    fn one_of_them() {
        passes("output V, W : bool initial step 1 { V W := 1 on activation } step 2 { V W := 0 on activation }");
    }
}
