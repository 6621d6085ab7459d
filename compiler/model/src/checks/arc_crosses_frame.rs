//! E0305: no arc leaves its grafcet or its expansion.
//!
//! A partial grafcet acts on another by conditions, by forcing and by enclosing (IEC 60848, 7.2 to 7.4); an expansion is
//! entered and left by its entry and exit steps alone, through its macro-step (table 10, symbol 42).
//!
//! Wrong: `grafcet G1 { initial step 1 transition 1 -> 2 : a }  grafcet G2 { step 2 }`
//! Right: `grafcet G1 { initial step 1 step 2 transition 1 -> 2 : a }`

use crate::chart::MacroId;
use crate::fixes::name_instead;
use crate::resolve::Resolved;
use crate::resolve::parts::Frame;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_syntax::ast;
use index_vec::IndexVec;

/// More steps of one transition are not shown.
const SHOWN: usize = 4;

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    if resolved.parts.grafcets.len() + resolved.parts.expansions.len() == 1 {
        return;
    }
    let circles = in_circles(resolved);
    let is_known = |frame| is_known(resolved, frame, &circles);
    for part in resolved.parts.transitions.iter().filter(|part| is_known(part.frame)) {
        let sides = part.ast.from.iter().map(|name| (name, false)).chain(part.ast.to.iter().map(|name| (name, true)));
        let mut foreign = sides.filter_map(|(name, enters)| {
            let frame = frame(resolved, name)?;
            (frame != part.frame && is_known(frame)).then_some((name, frame, enters))
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
fn is_known(resolved: &Resolved, frame: Frame, circles: &IndexVec<MacroId, bool>) -> bool {
    match frame {
        Frame::Grafcet(grafcet) => !resolved.parts.is_stray(grafcet),
        // A macro-step that stands in its own expansion (E0306) is nowhere, and neither is what is in that.
        Frame::Expansion(expansion) => resolved.expanded[expansion].is_none_or(|own| !circles[own]),
    }
}

/// The macro-steps that stand in their own expansions, perhaps within those of others. Each stands in one expansion at
/// most, so that each is passed once on the way outwards.
fn in_circles(resolved: &Resolved) -> IndexVec<MacroId, bool> {
    let macro_steps = &resolved.chart.macro_steps;
    let mut circles: IndexVec<MacroId, bool> = macro_steps.iter().map(|_| false).collect();
    let mut way_of: IndexVec<MacroId, Option<MacroId>> = macro_steps.iter().map(|_| None).collect();
    for start in macro_steps.indices() {
        let mut at = start;
        while way_of[at].is_none() {
            way_of[at] = Some(start);
            let Some(outer) = macro_steps[at].expansion_of else { break };
            at = outer;
            // Where this way meets itself, it goes round.
            if way_of[at] == Some(start) {
                while !std::mem::replace(&mut circles[at], true) {
                    at = macro_steps[at].expansion_of.unwrap_or(at);
                }
            }
        }
    }
    circles
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

    /// One message is that of the circle (E0306), however long it is.
    #[test]
    fn in_a_circle_of_macro_steps() {
        for length in [1, 2, 16, 17, 40] {
            let mut chart = "input a : bool initial step 1 transition 1 -> E0 : a\n".to_owned();
            for n in 0..length {
                chart.push_str(&format!("expansion M{n} {{ step E{n} macro step M{} step S{n}\n", (n + 1) % length));
                chart.push_str(&format!("transition E{n} -> S{n} : a transition S{n} -> 1 : a }}\n"));
            }
            breaks("E0306", &chart);
        }
    }

    #[test]
    fn through_the_macro_step() {
        passes(
            "input a : bool initial step 1 macro step M3 transition 1 -> M3 : a transition M3 -> 1 : a
             expansion M3 { step E3 step S3 transition E3 -> S3 : a }",
        );
    }
}
