//! E0311: an enclosure belongs to one enclosing step.
//!
//! The steps of an enclosure are active only while its enclosing step is (IEC 60848, 7.4 and table 10, symbol 38); of two they
//! could not obey both. A step may have several enclosures.
//!
//! Wrong: `grafcet X8/X9/G4 { … }`
//! Right: `grafcet X9/G4 { … }`

use crate::resolve::Resolved;
use crate::resolve::scope::Label;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix, Span};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    for (id, grafcet) in resolved.parts.grafcets.iter_enumerated() {
        let Some(grafcet) = grafcet.ast else { continue };
        let Some((enclosing, above)) = grafcet.path.split_last() else { continue };
        let name = &grafcet.name.text;
        if let Some(other) = above.last() {
            diagnostics.push(
                Diagnostic::new(Code::E0311, other.span, format!("`{name}` is enclosed by more than one step"))
                    .also(enclosing.span, "the step that encloses it directly")
                    .note("labels are unique over the chart, so steps further up need not be named")
                    .help(format!("write `{}/{name}`", enclosing.text))
                    .fix(
                        Fix::certain(format!("write `{}/{name}`", enclosing.text))
                            .delete(Span { end: enclosing.span.start, ..grafcet.path[0].span }),
                    ),
            );
        }
        // A second block of the same name, with another path; with the same it is E0202.
        let Some(Label::Grafcet(first)) = resolved.scope.label(name) else { continue };
        let first_path = resolved.parts.grafcets[first].ast.and_then(|grafcet| grafcet.path.last());
        if let Some(other) = first_path.filter(|other| first != id && other.text != enclosing.text) {
            diagnostics.push(
                Diagnostic::new(Code::E0311, enclosing.span, format!("`{name}` is enclosed by two steps"))
                    .also(other.span, "enclosed by this step already")
                    .note("IEC 60848, 7.4: an enclosure belongs to one enclosing step")
                    .help("give this enclosure, and its steps, names of their own"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn two_steps_in_the_heading() {
        breaks(
            "E0311",
            "grafcet G1 { initial step 1 enclosing step 8 } grafcet X8/G2 { activated enclosing step 9 }
             grafcet X8/X9/G4 { activated step 40 }",
        );
    }

    #[test]
    fn two_headings() {
        breaks(
            "E0311",
            "grafcet G1 { initial step 1 enclosing step 8 enclosing step 9 } grafcet X8/G4 { activated step 40 }
             grafcet X9/G4 { activated step 41 }",
        );
    }

    #[test]
    fn two_enclosures_of_one_step() {
        passes(
            "grafcet G1 { initial step 1 enclosing step 8 } grafcet X8/G4 { activated step 40 }
             grafcet X8/G5 { activated step 50 }",
        );
    }
}
