//! E0317: in a file with `grafcet` blocks, steps and transitions stand in them.
//!
//! Every step and transition belongs to one partial grafcet (IEC 60848, 7.1). A file without blocks is one grafcet; beside
//! blocks, bare items belong to none.
//!
//! Wrong: `grafcet G1 { initial step 1 }  step 2`
//! Right: `grafcet G1 { initial step 1  step 2 }`

use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// More places are not shown.
const SHOWN: usize = 4;

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let Some((&first, others)) = resolved.parts.bare.split_first() else { return };
    let message = match others.len() {
        0 => "a step or transition stands outside the grafcets".to_owned(),
        more => format!("{} steps and transitions stand outside the grafcets", more + 1),
    };
    let mut diagnostic = Diagnostic::new(Code::E0317, first, message);
    for &span in others.iter().take(SHOWN) {
        diagnostic = diagnostic.also(span, "");
    }
    diagnostics.push(
        diagnostic
            .note("a file without `grafcet` blocks is one grafcet; a file with blocks has all steps in them")
            .help("move them into a `grafcet` block"),
    );
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn bare_steps_beside_a_block() {
        breaks("E0317", "input a : bool grafcet G1 { initial step 1 } initial step 2 step 3 transition 2 -> 3 : a");
    }

    #[test]
    fn bare_steps_alone() {
        passes("input a : bool initial step 2 step 3 transition 2 -> 3 : a");
    }
}
