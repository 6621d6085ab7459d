//! E0306: a macro-step `M3` has exactly one expansion, with one entry step `E3` and one exit step `S3` in it.
//!
//! IEC 60848, table 10, symbol 42: the expansion replaces the macro-step. So it lies in the same grafcet, holds no
//! macro-step that holds it, and the macro-step has no state of its own: what is initial or activated is a step in it.
//!
//! Wrong: `macro step M3  expansion M3 { step E3 }`
//! Right: `macro step M3  expansion M3 { step E3 step S3 transition E3 -> S3 : a }`

use crate::chart::{MacroId, Node};
use crate::fixes::{mark, without_mark};
use crate::resolve::Resolved;
use crate::resolve::parts::{ExpansionId, ExpansionPart, Frame};
use crate::resolve::scope::{Label, kind};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix, Span};
use grafc_syntax::ast::{self, StepMark};
use grafc_syntax::spelling::written;
use index_vec::{IndexVec, index_vec};

const ONE_OF_EACH: &str =
    "IEC 60848, table 10, symbol 42: the expansion of `M3` has exactly one entry step `E3` and one exit step `S3`";

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let mut expansions: IndexVec<MacroId, Option<ExpansionId>> = index_vec![None; resolved.chart.macro_steps.len()];
    for (expansion, part) in resolved.parts.expansions.iter_enumerated() {
        match resolved.expanded[expansion] {
            Some(macro_step) => match expansions[macro_step] {
                Some(first) => diagnostics.push(second_expansion(resolved, part, first)),
                None => {
                    expansions[macro_step] = Some(expansion);
                    check_expansion(resolved, macro_step, expansion, diagnostics);
                }
            },
            None => not_a_macro_step(resolved, part).into_iter().for_each(|diagnostic| diagnostics.push(diagnostic)),
        }
    }
    for (macro_step, expansion) in expansions.iter_enumerated() {
        check_macro_step(resolved, macro_step, expansion.is_some(), diagnostics);
    }
    check_nesting(resolved, diagnostics);
}

/// The rules on the macro-step alone.
fn check_macro_step(resolved: &Resolved, id: MacroId, is_expanded: bool, diagnostics: &mut Diagnostics) {
    let written = resolved.parts.step(Node::Macro(id)).ast;
    let label = &written.label;
    let Some(rest) = rest(&label.text) else {
        let diagnostic = Diagnostic::new(
            Code::E0306,
            label.span,
            format!("the label of the macro-step `{}` is not `M` followed by something", label.text),
        );
        diagnostics.push(diagnostic.note(ONE_OF_EACH).help(format!("call it `M{}`", label.text)));
        return;
    };
    if !is_expanded && !resolved.scope.is_ambiguous(&label.text) {
        let diagnostic =
            Diagnostic::new(Code::E0306, label.span, format!("the macro-step `{}` has no expansion", label.text))
                .help(format!("add `expansion {} {{ step E{rest} … step S{rest} }}`", label.text));
        let (entry, exit) = (format!("E{rest}"), format!("S{rest}"));
        let is_free = [&entry, &exit].into_iter().all(|label| resolved.scope.label(label).is_none());
        diagnostics.push(if is_free { diagnostic.fix(expansion(written, &entry, &exit)) } else { diagnostic });
    }
    for (meaning, word) in [(StepMark::Initial, "initial"), (StepMark::Activated, "activated")] {
        if written.word(meaning).is_some() {
            let message = format!("the macro-step `{}` cannot be `{word}`", label.text);
            let mut diagnostic = Diagnostic::new(Code::E0306, label.span, message)
                .note("IEC 60848, table 10, symbol 42: a macro-step is active while a step of its expansion is")
                .help(format!("mark a step of its expansion as `{word}`"));
            let entry = resolved.chart.macro_steps[id].entry.map(|entry| resolved.parts.step(Node::Step(entry)).ast);
            diagnostic.fixes.extend(entry.map(|entry| without_mark(mark(entry, word), written, meaning)));
            diagnostics.push(diagnostic);
        }
    }
}

/// An empty expansion behind its macro-step.
fn expansion(macro_step: &ast::Step, entry: &str, exit: &str) -> Fix {
    let [name, entry, exit] = [&macro_step.label.text, entry, exit].map(written);
    let block = format!("\nexpansion {name} {{ step {entry} step {exit} transition {entry} -> {exit} : 1 }}\n");
    Fix::maybe("add an expansion").replace(macro_step.span.behind(), block)
}

/// The label without its `M`, if something is left of it.
fn rest(label: &str) -> Option<&str> {
    label.strip_prefix('M').filter(|rest| !rest.is_empty())
}

/// The rules on an expansion and its macro-step.
fn check_expansion(resolved: &Resolved, macro_step: MacroId, expansion: ExpansionId, diagnostics: &mut Diagnostics) {
    let part = &resolved.parts.expansions[expansion];
    let chart = &resolved.chart;
    let home = match part.within {
        Some(Frame::Grafcet(grafcet)) => Some(grafcet),
        Some(Frame::Expansion(outer)) => resolved.expanded[outer].map(|outer| chart.macro_steps[outer].grafcet),
        None => None,
    };
    let name = &part.ast.macro_step;
    let owner = chart.macro_steps[macro_step].grafcet;
    if let Some(home) = home
        && home != owner
        && ![home, owner].into_iter().any(|grafcet| resolved.parts.is_stray(grafcet))
    {
        let message = format!(
            "the expansion of `{}` stands in `{}`, the macro-step in `{}`",
            name.text, chart.grafcets[home].name, chart.grafcets[owner].name
        );
        diagnostics.push(
            Diagnostic::new(Code::E0306, name.span, message)
                .also(chart.macro_steps[macro_step].span, "the macro-step is here")
                .help(format!("move it into `{}`", chart.grafcets[owner].name)),
        );
    }
    let Some(rest) = rest(&name.text) else { return };
    for (letter, role) in [('E', "entry"), ('S', "exit")] {
        let label = format!("{letter}{rest}");
        if resolved.scope.is_ambiguous(&label) {
            continue;
        }
        let message = format!("the expansion of `{}` has no {role} step `{label}`", name.text);
        let missing = |elsewhere: Option<(Span, String)>| {
            let diagnostic = Diagnostic::new(Code::E0306, name.span, &*message);
            match elsewhere {
                Some((span, text)) => diagnostic
                    .also(span, text)
                    .note(ONE_OF_EACH)
                    .help(format!("move it into the expansion, or call it otherwise and add `step {label}`")),
                None => diagnostic.note(ONE_OF_EACH).help(format!("add `step {label}`, or call its {role} step so")),
            }
        };
        let fault = match resolved.scope.label(&label) {
            None => Some(missing(None)),
            Some(Label::Step(id)) => {
                let is_inside = resolved.parts.step(Node::Step(id)).frame == Frame::Expansion(expansion);
                let elsewhere = || Some((chart.steps[id].span, format!("`{label}` is here, outside the expansion")));
                (!is_inside).then(|| missing(elsewhere()))
            }
            Some(found @ Label::Macro(id)) => {
                Some(missing(Some((chart.macro_steps[id].span, format!("`{label}` is a {}", kind(found))))))
            }
            Some(found @ Label::Grafcet(id)) => {
                Some(missing(Some((chart.grafcets[id].span, format!("`{label}` is a {}", kind(found))))))
            }
        };
        if let Some(diagnostic) = fault {
            diagnostics.push(diagnostic);
        }
    }
}

fn second_expansion(resolved: &Resolved, part: &ExpansionPart, first: ExpansionId) -> Diagnostic {
    let name = &part.ast.macro_step;
    Diagnostic::new(Code::E0306, name.span, format!("`{}` has a second expansion", name.text))
        .also(resolved.parts.expansions[first].ast.macro_step.span, "the first is here")
        .help("join the two, or call this one after a macro-step of its own")
}

fn not_a_macro_step(resolved: &Resolved, part: &ExpansionPart) -> Option<Diagnostic> {
    let name = &part.ast.macro_step;
    let label = resolved.scope.label(&name.text)?; // E0301 if there is none
    let message = format!("`{}` is a {} and has no expansion", name.text, kind(label));
    let help = format!("declare it as `macro step {}`, or call the expansion otherwise", name.text);
    let diagnostic = Diagnostic::new(Code::E0306, name.span, message).help(help);
    Some(match label {
        Label::Step(id) => diagnostic.also(resolved.chart.steps[id].span, "declared here"),
        Label::Grafcet(id) => diagnostic.also(resolved.chart.grafcets[id].span, "declared here"),
        Label::Macro(id) => diagnostic.also(resolved.chart.macro_steps[id].span, "declared here"),
    })
}

/// No macro-step lies in its own expansion, directly or in one further in.
fn check_nesting(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let macro_steps = &resolved.chart.macro_steps;
    let mut walk_of: IndexVec<MacroId, Option<MacroId>> = index_vec![None; macro_steps.len()];
    for start in macro_steps.indices() {
        let mut at = Some(start);
        while let Some(id) = at
            && walk_of[id].is_none()
        {
            walk_of[id] = Some(start);
            at = macro_steps[id].expansion_of;
        }
        if let Some(id) = at
            && walk_of[id] == Some(start)
        {
            let label = &macro_steps[id].label;
            diagnostics.push(
                Diagnostic::new(
                    Code::E0306,
                    macro_steps[id].span,
                    format!("the macro-step `{label}` is in its own expansion"),
                )
                .note("an expansion replaces its macro-step, and this would never end")
                .help("move the macro-step out of it"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    const REST: &str = "input a : bool initial step 1 macro step M3
                        transition 1 -> M3 : a transition M3 -> 1 : a ";

    fn with(expansions: &str) -> String {
        format!("{REST}{expansions}")
    }

    #[test]
    fn one_expansion_with_entry_and_exit() {
        passes(&with("expansion M3 { step E3 step S3 transition E3 -> S3 : a }"));
    }

    #[test]
    fn none_or_two_expansions() {
        breaks("E0306", &with(""));
        breaks("E0306", &with("expansion M3 { step E3 step S3 } expansion M3 { step 7 }"));
    }

    #[test]
    fn entry_or_exit_missing() {
        breaks("E0306", &with("expansion M3 { step E3 }"));
        breaks("E0306", &with("expansion M3 { step S3 }"));
        breaks("E0306", &with("expansion M3 { step E3 } step S3"));
    }

    #[test]
    fn a_label_without_its_m() {
        breaks("E0306", "initial step 1 macro step Fill expansion Fill { step EFill step SFill }");
        breaks("E0306", "initial step 1 macro step M expansion M { step E step S }");
    }

    #[test]
    fn an_expansion_of_a_step() {
        breaks("E0306", "initial step 1 expansion 1 { step E1 step S1 }");
    }

    #[test]
    fn an_initial_macro_step() {
        breaks("E0306", "initial step 1 initial macro step M3 expansion M3 { step E3 step S3 }");
    }

    #[test]
    fn an_initial_step_in_an_expansion() {
        passes("macro step M3 expansion M3 { initial step E3 step S3 }");
    }

    #[test]
    fn expansions_in_expansions() {
        passes(
            "initial step 1 macro step M3 expansion M3 { step E3 macro step M4 step S3 }
             expansion M4 { step E4 step S4 }",
        );
        breaks(
            "E0306",
            "initial step 1 expansion M3 { step E3 macro step M4 step S3 } expansion M4 { step E4 macro step M3 step S4 }",
        );
        breaks("E0306", "initial step 1 expansion M3 { step E3 macro step M3 step S3 }");
    }

    #[test]
    fn an_expansion_in_another_grafcet() {
        breaks(
            "E0306",
            "grafcet G1 { initial step 1 macro step M3 } grafcet G2 { initial step 2 expansion M3 { step E3 step S3 } }",
        );
    }

    #[test]
    fn an_expansion_outside_the_grafcets() {
        passes("grafcet G1 { initial step 1 macro step M3 } expansion M3 { step E3 step S3 }");
    }
}
