//! E0217: the heading gives a bound, and chooses that no call is given up.
//!
//! Under `evolution scan` each call is one micro-step (R14): there is no bound to hit.
//!
//! Faulty: `chart M evolution scan bound 400`
//! Right: `chart M evolution scan`, `chart M bound 400`

use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let options = &resolved.chart.options;
    if let (true, Some((_, span))) = (options.is_scan(), options.bound) {
        let message = "no call is given up under `evolution scan`, so a bound would do nothing";
        let fault = Diagnostic::new(Code::E0217, span, message);
        let fault = fault.note("with `evolution scan` each call is one micro-step (R14)");
        diagnostics.push(fault.help("leave the bound out").fix(Fix::maybe("leave the bound out").delete(span)));
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    const STEP: &str = "output V : bool initial step 1 { V }";

    #[test]
    fn a_bound_that_does_nothing() {
        breaks("E0217", &format!("chart M evolution scan bound 400 {STEP}"));
    }

    #[test]
    fn a_bound_that_may_be_hit() {
        passes(&format!("chart M bound 400 {STEP}"));
        passes(&format!("chart M evolution stable bound 400 {STEP}"));
    }
}
