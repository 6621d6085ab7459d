//! E0305: no arc leaves its grafcet or its expansion.
//!
//! A partial grafcet acts on another by conditions, by forcing and by enclosing (IEC 60848, 7.2 to 7.4); an expansion is
//! entered and left by its entry and exit steps alone, through its macro-step (table 10, symbol 42).
//!
//! Wrong: `grafcet G1 { initial step 1 transition 1 -> 2 : a }  grafcet G2 { step 2 }`
//! Right: `grafcet G1 { initial step 1 step 2 transition 1 -> 2 : a }`

use crate::fixes::name_instead;
use crate::resolve::Resolved;
use crate::resolve::parts::{ExpansionId, Frame};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_syntax::ast;

/// More steps of one transition are not shown.
const SHOWN: usize = 4;

/// A longer circle of macro-steps nobody writes.
const NESTED: usize = 16;

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    for part in resolved.parts.transitions.iter().filter(|part| is_known(resolved, part.frame)) {
        let sides = part.ast.from.iter().map(|name| (name, false)).chain(part.ast.to.iter().map(|name| (name, true)));
        let mut foreign = sides.filter_map(|(name, enters)| {
            let frame = frame(resolved, name)?;
            (frame != part.frame && is_known(resolved, frame)).then_some((name, frame, enters))
        });
        let Some((name, there, enters)) = foreign.next() else { continue };
        let (here_name, there_name) = (describe(resolved, part.frame), describe(resolved, there));
        let direction = if enters { "leads into" } else { "comes from" };
        let message = format!("the transition is in {here_name} and {direction} {there_name}");
        let mut diagnostic =
            Diagnostic::new(Code::E0305, name.span, message).here(format!("`{}` is in {there_name}", name.text));
        for (name, frame, _) in foreign.take(SHOWN) {
            diagnostic = diagnostic.also(name.span, format!("`{}` is in {}", name.text, describe(resolved, frame)));
        }
        diagnostics.push(match gate(resolved, part.frame, there) {
            Some(macro_step) => diagnostic
                .note("an expansion is entered by its entry step and left by its exit step, through the macro-step")
                .help(format!("name the macro-step `{macro_step}` instead"))
                .fix(name_instead(name.span, macro_step)),
            None => diagnostic
                .note(
                    "IEC 60848, 7: grafcets act on each other by conditions, by forcing and by enclosing, not by arcs",
                )
                .help(format!(
                    "leave out `{}`; what is to wait for it reads its activity, `X{}`",
                    name.text, name.text
                )),
        });
    }
}

/// The frame of a step, if it is sure which step is meant.
fn frame(resolved: &Resolved, name: &ast::Name) -> Option<Frame> {
    let node = resolved.scope.node(&name.text).filter(|_| !resolved.scope.is_ambiguous(&name.text))?;
    Some(resolved.parts.step(node).frame)
}

/// Whether where it belongs has not been reported as a fault.
fn is_known(resolved: &Resolved, frame: Frame) -> bool {
    match frame {
        Frame::Grafcet(grafcet) => !resolved.parts.is_stray(grafcet),
        Frame::Expansion(expansion) => !is_in_itself(resolved, expansion),
    }
}

/// Whether the macro-step of an expansion stands in it (E0306), so that neither is anywhere.
fn is_in_itself(resolved: &Resolved, expansion: ExpansionId) -> bool {
    let macro_steps = &resolved.chart.macro_steps;
    let Some(own) = resolved.expanded[expansion] else { return false };
    let outwards = std::iter::successors(macro_steps[own].expansion_of, |&outer| macro_steps[outer].expansion_of);
    outwards.take(NESTED).any(|outer| outer == own)
}

fn describe(resolved: &Resolved, frame: Frame) -> String {
    match frame {
        Frame::Grafcet(grafcet) => format!("`{}`", resolved.chart.grafcets[grafcet].name),
        Frame::Expansion(expansion) => {
            format!("the expansion of `{}`", resolved.parts.expansions[expansion].ast.macro_step.text)
        }
    }
}

/// The macro-step through which one gets from `here` into `there`.
fn gate<'r>(resolved: &'r Resolved, here: Frame, there: Frame) -> Option<&'r str> {
    let Frame::Expansion(expansion) = there else { return None };
    let macro_step = resolved.expanded[expansion]?;
    let outside = resolved.parts.step(crate::chart::Node::Macro(macro_step)).frame;
    (outside == here).then(|| resolved.chart.macro_steps[macro_step].label.as_str())
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn from_grafcet_to_grafcet() {
        breaks(
            "E0305",
            "input a : bool grafcet G1 { initial step 1 transition 1 -> 2 : a } grafcet G2 { initial step 2 }",
        );
    }

    #[test]
    fn into_an_expansion() {
        breaks(
            "E0305",
            "input a : bool initial step 1 macro step M3 transition 1 -> E3 : a
             expansion M3 { step E3 step S3 transition E3 -> S3 : a }",
        );
    }

    #[test]
    fn out_of_an_expansion() {
        breaks(
            "E0305",
            "input a : bool initial step 1 macro step M3 transition 1 -> M3 : a
             expansion M3 { step E3 step S3 transition E3 -> S3 : a transition S3 -> 1 : a }",
        );
    }

    #[test]
    fn through_the_macro_step() {
        passes(
            "input a : bool initial step 1 macro step M3 transition 1 -> M3 : a transition M3 -> 1 : a
             expansion M3 { step E3 step S3 transition E3 -> S3 : a }",
        );
    }
}
