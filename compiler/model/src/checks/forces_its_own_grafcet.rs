//! E0314: an order forces another grafcet than that of its step.
//!
//! Forcing is hierarchical (IEC 60848, 7.3): a grafcet that forced itself would stand above itself.
//!
//! Wrong: `grafcet G1 { initial step 1 { force G1{} } }`
//! Right: `grafcet G1 { initial step 1 { force G2{} } }`

use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    for order in &chart.orders {
        let step = &chart.steps[order.step];
        if step.grafcet == order.grafcet {
            let name = &chart.grafcets[order.grafcet].name;
            diagnostics.push(
                Diagnostic::new(
                    Code::E0314,
                    order.span,
                    format!("step `{}` forces `{name}`, to which it belongs", step.label),
                )
                .note("IEC 60848, 7.3: a grafcet is forced from a higher level of the hierarchy")
                .help("put the order into a step of another grafcet"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn its_own() {
        breaks("E0314", "initial step 1 { force G1{1} }");
    }

    #[test]
    fn its_own_from_an_expansion() {
        breaks("E0314", "initial step 1 macro step M3 expansion M3 { step E3 { force G1{1} } step S3 }");
    }

    #[test]
    fn another() {
        passes("grafcet G1 { initial step 1 { force G2{} } } grafcet G2 { initial step 2 }");
    }
}
