//! W0419: an input, a variable or a constant that nothing reads.
//!
//! It is left over, or another name stands where it was meant. Outputs are read by the process, and what has an address
//! or is kept over a restart may be read by others; these do not count.
//!
//! Warned of: `input spare : bool`, and no condition or value names it
//! Not warned of: `output V : bool`, which is set and not read

use crate::chart::VariableKind;
use crate::resolve::Resolved;
use crate::symbols::Usage;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// One warning per name.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    for (variable, usage) in chart.variables.iter().zip(&resolved.symbols.usage) {
        let Usage { read: None, set } = *usage else { continue };
        let name = &variable.name;
        let what = match variable.kind {
            VariableKind::Input => format!("the input `{name}` is never read"),
            VariableKind::Constant => format!("the constant `{name}` is never used"),
            VariableKind::Internal if variable.address.is_some() || variable.retain => continue,
            VariableKind::Internal if set.is_some() => format!("the variable `{name}` is set and never read"),
            VariableKind::Internal => format!("the variable `{name}` is never used"),
            VariableKind::Output => continue,
        };
        let mut diagnostic = Diagnostic::new(Code::W0419, variable.span, what);
        if let Some(place) = set {
            diagnostic = diagnostic.also(place, "set here");
        }
        let allow = format!("`allow W0419 {} \"reason\"`", grafc_syntax::dump::plain_or_quoted(name));
        diagnostics.push(diagnostic.help(format!("use it, or leave it out; what is there for later: {allow}")));
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{all_codes, labels_of};

    #[test]
    fn each_kind() {
        assert_eq!(all_codes("input a : bool initial step 1"), ["W0419"]);
        assert_eq!(all_codes("const k : int := 3 initial step 1"), ["W0419"]);
        assert_eq!(all_codes("var v : bool initial step 1"), ["W0419"]);
        assert_eq!(all_codes("var v : bool initial step 1 { v }"), ["W0419"]);
        let set = labels_of("var n : int initial step 1 { n := 2 on activation }");
        assert_eq!(set, ["n: set here"]);
    }

    #[test]
    fn what_is_read() {
        let text = "input a, b, c : bool const t : time := 3s const k : int := 2 const m : int := k + 1 var n : int
            output V : bool initial step 1 { V if t/a  n := m on event ↑b } step 2
            transition 1 -> 2 : [n > 3] transition 2 -> 1 : c { V2 := n } output V2 : int";
        assert_eq!(all_codes(text), [""; 0]);
    }

    #[test]
    fn others_may_read_it() {
        let text = "input a : bool var n : int at %MW4 retain var m : int
            initial step 1 { n := 2 on event ↑a  m := 3 on event ↑a }";
        assert_eq!(all_codes(text), [""; 0]);
    }
}
