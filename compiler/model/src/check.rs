//! The pipeline from syntax tree to checked chart.

use crate::chart::Chart;
use crate::checks;
use crate::resolve::resolve;
use grafc_diagnostics::Diagnostics;
use grafc_syntax::ast;

/// Resolves a syntax tree and applies every rule; gives back the chart if no rule is broken.
///
/// `default_name` names a chart without a heading. The messages are in order of place.
pub fn check(tree: &ast::Chart, default_name: &str) -> (Option<Chart>, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    let mut resolved = resolve(tree, default_name, &mut diagnostics);
    for rule in checks::ERRORS {
        rule(&resolved, &mut diagnostics);
    }
    checks::set_levels(&mut resolved, &mut diagnostics);
    let sound = resolved.complete && !diagnostics.has_errors();
    if sound {
        for rule in checks::WARNINGS {
            rule(&resolved, &mut diagnostics);
        }
    }
    diagnostics.sort_by_place();
    (sound.then_some(resolved.chart), diagnostics)
}
