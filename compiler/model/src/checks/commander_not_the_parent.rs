//! E0322: a grafcet commands a child of another one, or itself.
//!
//! `child grafcet P of MAIN` says that the steps of MAIN start it, kill it, freeze it and resume it: those of its expansions
//! and of its enclosures among them, and nobody else. What a grafcet does to itself it does by transitions.
//!
//! Wrong: `child grafcet P of MAIN { … }`, `grafcet Other { step 5 { start P on activation } }`
//! Right: the same in a step of MAIN; or `grafcet P { … }`, which whoever is above it may command

use crate::chart::{GrafcetId, Tables};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    for (above, below, span) in chart.commands() {
        let name = |id: GrafcetId| &chart.grafcets[id].name;
        let child = &chart.grafcets[below];
        if above == below {
            let message = format!("a step of `{}` commands `{}` itself", child.name, child.name);
            let fault = Diagnostic::new(Code::E0322, span, message);
            diagnostics.push(fault.help("let transitions of the grafcet do it, or a step of another grafcet"));
            continue;
        }
        let Some(parent) = child.parent.filter(|parent| !is_within(chart, above, *parent)) else { continue };
        let message = format!("`{}` commands `{}`, which is a child of `{}`", name(above), child.name, name(parent));
        let fault = Diagnostic::new(Code::E0322, span, message)
            .also(child.span, format!("a child of `{}`", name(parent)))
            .note("only its parent, with the enclosures and expansions of that, starts, kills, freezes and resumes a child");
        let help = format!("give the order in a step of `{}`, or leave `child` and `of` out", name(parent));
        diagnostics.push(fault.help(help));
    }
}

/// Whether a grafcet is another one, or enclosed in it, however deep.
fn is_within(chart: &Tables, id: GrafcetId, around: GrafcetId) -> bool {
    let outer = |id: &GrafcetId| Some(chart.steps.get(chart.grafcets[*id].enclosing_step?)?.grafcet);
    // Enclosures that go round in a circle are E0313.
    std::iter::successors(Some(id), outer).take(chart.grafcets.len() + 1).any(|at| at == around)
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    const CHILD: &str = "child grafcet P of MAIN { initial step 10 }";

    #[test]
    fn another_one() {
        let main = "grafcet MAIN { initial step 1 { run P } }";
        breaks("E0322", &format!("{main} grafcet O {{ initial step 2 {{ kill P on activation }} }} {CHILD}"));
    }

    #[test]
    fn itself() {
        breaks("E0322", "input a : bool grafcet G { initial step 1 { start G on event ↑a } }");
    }

    #[test]
    fn the_parent_and_what_it_encloses() {
        let inside = "grafcet X1/E { initial activated step 5 { start P on activation } }";
        passes(&format!("grafcet MAIN {{ initial enclosing step 1 }} {inside} {CHILD}"));
    }

    #[test]
    fn no_child() {
        passes("grafcet A { initial step 1 { start P on activation } } grafcet P { initial step 10 }");
    }
}
