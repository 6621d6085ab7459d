//! E0210: a part of a condition or of an action that is made of constants alone has a value of its type.
//!
//! Arithmetic at run time wraps around, and a real number may become infinite. A value that the author has written down
//! and that leaves its type is a mistake, in a condition as in a declaration; and no controller has a literal for it.
//! A division by zero stays what it is at run time: 0, and the flag DIV0. A time within an expression may be longer than
//! a declared one; a target that cannot hold it says so (E0505).
//!
//! Wrong: `transition 1 -> 2 : [x < 1.0E38 * 10.0]`, `transition 1 -> 2 : [n < 32767 + 1]` (`x : real`, `n : int`)
//! Right: `transition 1 -> 2 : [x < 1.0E37 * 10.0]`, `transition 1 -> 2 : [n < 32766 + 1]`

use crate::chart::{ExprId, ExprKind, Type, Value, VariableId, VariableKind};
use crate::resolve::{Resolved, fold};
use grafc_diagnostics::{Code, Diagnostics};
use index_vec::IndexVec;

/// One error for the innermost part that has no value.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let mut values: IndexVec<ExprId, Option<Value>> = IndexVec::with_capacity(chart.exprs.len());
    for expr in &chart.exprs {
        let constant = |id: VariableId| Some(&chart.variables[id]).filter(|v| v.kind == VariableKind::Constant);
        let value = if let ExprKind::Variable(id) = expr.kind {
            constant(id).map(|constant| constant.initial())
        } else {
            fold::apply(expr, |operand| values[operand]).unwrap_or_else(|fault| {
                if fault.code == Code::E0210 && expr.ty != Type::Time {
                    diagnostics.push(fault.help("take a wider type, or write the value that is meant"));
                }
                None
            })
        };
        values.push(value);
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    /// A chart whose transition-condition compares a variable of the type.
    fn compared(ty: &str, operator: &str, constant: &str) -> String {
        let constants = [("top", "const top : int := 32767"), ("far", "const far : real := 3.0E38")];
        let used =
            constants.iter().find(|(name, _)| constant.contains(name)).map_or("", |(_, declaration)| declaration);
        format!(
            "input x : {ty} input back : bool {used}
             initial step 1 step 2 transition 1 -> 2 : [x {operator} {constant}] transition 2 -> 1 : back"
        )
    }

    #[test]
    fn real_numbers() {
        for constant in ["1.0E38 * 10.0", "far + far", "-3.0E38 - far", "1.0E38 / 1.0E-38", "x + (far + far)"] {
            breaks("E0210", &compared("real", "<", constant));
        }
        for constant in ["1.0E38 * 3.0", "far - far", "far + x", "x * 1.0E38 * 10.0", "1.0E-38 / 1.0E38", "1.0 / 0.0"] {
            passes(&compared("real", "<", constant));
        }
        breaks("E0210", &compared("lreal", ">", "1.0E308 * 10.0"));
        passes(&compared("lreal", ">", "1.0E38 * 10.0"));
    }

    #[test]
    fn whole_numbers_of_every_width() {
        for (ty, inside, outside) in [
            ("int", "32766 + 1", "32767 + 1"),
            ("int", "top - 1", "top + 1"),
            ("int", "-32767 - 1", "-32767 - 2"),
            ("uint", "65534 + 1", "65535 + 1"),
            ("uint", "1 - 1", "1 - 2"),
            ("dint", "2147483646 + 1", "2147483647 * 2"),
            ("udint", "4294967294 + 1", "4294967295 + 1"),
        ] {
            passes(&compared(ty, "=", inside));
            breaks("E0210", &compared(ty, "=", outside));
        }
    }

    #[test]
    fn long_times_are_for_the_targets() {
        passes(&compared("time", "<", "20d + 20d"));
    }

    #[test]
    fn in_an_action() {
        breaks("E0210", "var n : int initial step 1 { n := n + (200 * 200) on activation }");
        passes("var n : int initial step 1 { n := n + 200 * 100 on activation }");
    }
}
