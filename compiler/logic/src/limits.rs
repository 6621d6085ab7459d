//! What cannot be lowered yet.

use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_net::Net;

/// One error for each kind of construct that is not lowered yet, at its first place.
pub(crate) fn check(net: &Net) -> Diagnostics {
    let mut diagnostics = Diagnostics::new();
    if let Some(grafcet) = net.grafcets.iter().find(|g| g.enclosing_step.is_some()) {
        diagnostics.push(
            Diagnostic::new(
                Code::E0501,
                grafcet.span,
                format!("the enclosure `{}` cannot be compiled yet", grafcet.name),
            )
            .note("enclosures can be checked and simulated, but not yet turned into code"),
        );
    }
    if let Some(order) = net.orders.first() {
        let grafcet = &net.grafcets[order.grafcet].name;
        diagnostics.push(
            Diagnostic::new(
                Code::E0502,
                order.span,
                format!("the forcing order on `{grafcet}` cannot be compiled yet"),
            )
            .note("forcing orders can be checked and simulated, but not yet turned into code"),
        );
    }
    diagnostics
}
