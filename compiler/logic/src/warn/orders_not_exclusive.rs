//! W0411: two steps that may be active together force one grafcet into different situations.
//!
//! At most one order on a grafcet is in force (R2): that of the higher grafcet, then the first in the text. Where another
//! one says something else, the flag FORCE_CONFLICT is raised.
//!
//! Warned of: `force G3{}` in step 1 of G1 and `force G3{31}` in step 2 of G2
//! Not warned of: both in steps of one sequence, or if the step of G1 also forces G2 away from the step of G2

use crate::analysis::Analysis;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// One warning per forced grafcet.
pub(super) fn check(analysis: &Analysis, diagnostics: &mut Diagnostics) {
    let net = analysis.net();
    for found in &analysis.together().orders {
        let grafcet = &net.grafcets[found.grafcet];
        let (winner, loser) = (&grafcet.orders[found.winner], &grafcet.orders[found.loser]);
        let [high, low] = [winner, loser].map(|order| &net.places[order.step].label);
        let message = if winner.step == loser.step {
            format!("step `{high}` forces `{}` into two situations", grafcet.name)
        } else {
            format!(
                "steps `{high}` and `{low}` force `{}` into two situations and may be active together",
                grafcet.name
            )
        };
        diagnostics.push(
            Diagnostic::new(Code::W0411, loser.span, message)
                .here("does not take effect then")
                .also(winner.span, "this order wins")
                .note("where orders in force disagree, the flag FORCE_CONFLICT is raised"),
        );
    }
}
