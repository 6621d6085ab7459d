//! The pipeline from syntax tree to checked chart.

use crate::chart::{Chart, MacroId, Scenario, Tables};
use crate::checks;
use crate::resolve::automata::{Expanded, expand};
use crate::resolve::{Resolved, definitions, resolve, resolve_beside};
use crate::symbols::Symbols;
use grafc_diagnostics::Diagnostics;
use grafc_syntax::ast;
use index_vec::{IndexVec, index_vec};

/// What a text came to.
#[derive(Clone, Debug)]
pub struct Checked {
    /// What is wrong with it, or may not be meant, in order of place.
    pub diagnostics: Diagnostics,
    /// What is declared, and which names refer to it.
    pub symbols: Symbols,
    chart: Outcome,
}

#[derive(Clone, Debug)]
enum Outcome {
    Valid(Chart),
    Faulty(Tables),
}

impl Checked {
    /// The chart as far as it goes, whatever is wrong.
    pub fn tables(&self) -> &Tables {
        match &self.chart {
            Outcome::Valid(chart) => chart,
            Outcome::Faulty(tables) => tables,
        }
    }

    /// The chart, if no rule is broken.
    pub fn chart(&self) -> Option<&Chart> {
        match &self.chart {
            Outcome::Valid(chart) => Some(chart),
            Outcome::Faulty(_) => None,
        }
    }

    /// The chart, if no rule is broken, and the messages about it.
    pub fn into_chart(self) -> (Option<Chart>, Diagnostics) {
        let chart = match self.chart {
            Outcome::Valid(chart) => Some(chart),
            Outcome::Faulty(_) => None,
        };
        (chart, self.diagnostics)
    }
}

/// Resolves a syntax tree and applies every rule; gives back the chart if no rule is broken.
///
/// `default_name` names a chart without a heading. The messages are in order of place. Of a tree from which the parser
/// left something out there is no chart, and only those messages which hold whatever stands there.
pub fn check(tree: &ast::Chart, default_name: &str) -> (Option<Chart>, Diagnostics) {
    let expanded = expand(tree);
    let tree = expanded.as_ref().map_or(tree, |expanded| &expanded.chart);
    let (resolved, diagnostics) = apply_rules(tree, expanded.as_ref(), default_name, Symbols::unasked());
    (resolved.complete.then(|| Chart::checked(resolved.chart)), diagnostics)
}

/// As [`check`], for those who look closer, or want the chart as far as it goes.
pub fn examine(tree: &ast::Chart, default_name: &str) -> Checked {
    let expanded = expand(tree);
    let tree = expanded.as_ref().map_or(tree, |expanded| &expanded.chart);
    let (resolved, diagnostics) = apply_rules(tree, expanded.as_ref(), default_name, Symbols::new());
    let mut symbols = resolved.symbols;
    symbols.definitions = definitions(tree, &resolved.parts);
    symbols.sort();
    let mut tables = resolved.chart;
    let chart = if resolved.complete {
        Outcome::Valid(Chart::checked(tables))
    } else {
        open_circles(&mut tables);
        Outcome::Faulty(tables)
    };
    Checked { diagnostics, symbols, chart }
}

/// The scenarios of a text that lies beside a chart's, which has no errors, and what is wrong with them.
pub fn scenarios(tree: &ast::Chart, beside: &ast::Chart) -> (Vec<Scenario>, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    let scenarios = resolve_beside(tree, beside, &mut diagnostics);
    diagnostics.sort_by_place();
    (scenarios, diagnostics)
}

/// The chart under check is complete after this if no rule is broken. It is the expanded one, where it has automata.
fn apply_rules<'a>(
    tree: &'a ast::Chart,
    expanded: Option<&Expanded>,
    default_name: &str,
    symbols: Symbols,
) -> (Resolved<'a>, Diagnostics) {
    let mut diagnostics = expanded.map(|expanded| expanded.faults.clone()).unwrap_or_default();
    let mut resolved = resolve(tree, default_name, symbols, &mut diagnostics);
    if let Some(Expanded { momentary, .. }) = expanded {
        resolved
            .chart
            .variables
            .iter_mut()
            .for_each(|variable| variable.momentary = momentary.contains(&variable.name));
    }
    for rule in checks::ERRORS {
        rule(&resolved, &mut diagnostics);
    }
    checks::set_levels(&mut resolved, &mut diagnostics);
    resolved.complete &= tree.is_whole && !diagnostics.has_errors();
    if resolved.complete {
        for rule in checks::WARNINGS {
            rule(&resolved, &mut diagnostics);
        }
    }
    if !tree.is_whole {
        diagnostics.retain(|diagnostic| diagnostic.code.is_certain_beside_syntax_errors());
    }
    diagnostics.sort_by_place();
    (resolved, diagnostics)
}

/// Takes macro-steps out of the expansions that they hold themselves (E0306), so that going up from one ends.
fn open_circles(tables: &mut Tables) {
    let macro_steps = &mut tables.macro_steps;
    let mut walk_of: IndexVec<MacroId, Option<MacroId>> = index_vec![None; macro_steps.len()];
    for start in macro_steps.indices() {
        let mut at = start;
        while walk_of[at].is_none() {
            walk_of[at] = Some(start);
            match macro_steps[at].expansion_of {
                Some(outer) if walk_of[outer] == Some(start) => macro_steps[at].expansion_of = None,
                Some(outer) => at = outer,
                None => break,
            }
        }
    }
}
