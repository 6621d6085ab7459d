//! W0424: one row of inputs lets transitions clear in a circle.
//!
//! Inputs stand still in a reaction (R9). While these are so, the situation changes in a circle and is never stable
//! (IEC 60848, 4.9.3); the reaction is given up at its bound and raises LIVELOCK. Where the circle is left depends on
//! the bound, and on the encoding where steps overlap (W0413).
//!
//! Warned of: `1 -> 2 : start`, `2 -> 1 : stop`, with both pressed
//! Not warned of: `2 -> 1 : stop and not start`; an edge or a delay in the circle

use super::wording;
use crate::analysis::Analysis;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// More transitions of a circle are not shown.
const SHOWN: usize = 8;

/// One warning per set of steps that circles share.
pub(super) fn check(analysis: &Analysis, diagnostics: &mut Diagnostics) {
    let net = analysis.net();
    for ring in &analysis.liveness().rings {
        let spans: Vec<_> = ring.transitions.iter().map(|t| net.transitions[*t].span).collect();
        let Some((first, others)) = spans.split_first() else { continue };
        let row = wording::case(net, &ring.row).filter(|row| !row.is_empty());
        let message = match row {
            Some(row) => format!("while {row}, transitions are cleared in a circle without end"),
            None => "with one row of inputs, transitions are cleared in a circle without end".to_owned(),
        };
        let mut diagnostic = Diagnostic::new(Code::W0424, *first, message).here("the circle begins here");
        for span in others.iter().take(SHOWN) {
            diagnostic = diagnostic.also(*span, "and goes on here");
        }
        let help = match wording::both_true(net, &ring.row) {
            Some([a, b]) => {
                format!("let one exclude the other, as in `{a} and not {b}`, or wait for an edge, as in `↑{a}`")
            }
            None => "let one condition exclude another, or wait for an edge".to_owned(),
        };
        diagnostics.push(
            diagnostic
                .note("IEC 60848, 4.9.3: the situation is never stable; a reaction stops at its bound and raises LIVELOCK")
                .help(help),
        );
    }
}
