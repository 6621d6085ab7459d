//! E0419: an action is done each scan, in a chart that evolves to stability.
//!
//! There a call is a reaction of several micro-steps, none of which is the scan (R9, R14): how often the action would be done
//! would hang on how long the chart takes to be stable. Only the heading decides, since it is part of what the text means.
//!
//! Faulty: `chart M`, `step 5 { n := n + 1 each scan }`
//! Right: `chart M evolution scan`, `step 5 { n := n + 1 each scan }`

use crate::chart::Event;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix, Span};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    if chart.options.is_scan() {
        return;
    }
    for action in &chart.stored {
        if !matches!(action.event, Event::EachScan(..)) {
            continue;
        }
        let fault =
            Diagnostic::new(Code::E0419, action.span, "an action each scan, and the chart evolves to stability").note(
                "a reaction has several micro-steps, and only with `evolution scan` a scan is one of them (R14, R15)",
            );
        let heading = match (chart.options.evolution, resolved.parts.heading) {
            (Some((_, span)), _) => Fix::maybe("choose `evolution scan`").replace(span, "evolution scan"),
            (None, Some(heading)) => {
                Fix::maybe("choose `evolution scan`").replace(heading.span.behind(), " evolution scan")
            }
            (None, None) => {
                let start = Span::new(resolved.parts.end.file, 0, 0);
                Fix::maybe("choose `evolution scan`").replace(start, "chart Main evolution scan\n")
            }
        };
        let help = "write `evolution scan` into the heading, as in `chart Main evolution scan`, if it is to be SFC";
        diagnostics.push(fault.help(help).fix(heading));
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    const STEP: &str = "output n : int initial step 1 { n := n + 1 each scan }";

    #[test]
    fn without_a_choice() {
        breaks("E0419", STEP);
        breaks("E0419", &format!("chart M {STEP}"));
        breaks("E0419", &format!("chart M evolution stable {STEP}"));
    }

    #[test]
    fn under_scan() {
        passes(&format!("chart M evolution scan {STEP}"));
    }
}
