//! From the syntax tree to the chart: names, types, constants, who belongs where.
//!
//! What is wrong is reported and left out or given a stand-in, so that the rules in `checks/` see all the rest. Tables
//! with stand-ins never become a [`Chart`](crate::chart::Chart).

mod actions;
mod addresses;
mod allowances;
pub mod automata;
mod claims;
mod declarations;
mod definitions;
mod expressions;
pub mod fold;
mod habits;
mod names;
pub mod parts;
pub mod scenarios;
pub mod scope;
mod structure;
pub mod suggest;
pub mod types;

pub use definitions::definitions;

use crate::chart::{ChartOptions, MacroId, Note, Scenario, Tables};
use crate::reaction::Evolution;
use crate::symbols::Symbols;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_syntax::ast;
use index_vec::IndexVec;
use parts::{ExpansionId, Parts};
use scope::Scope;

/// A chart under check, with what it was made of.
pub struct Resolved<'a> {
    /// The items as written, by their ids.
    pub parts: Parts<'a>,
    /// What names mean.
    pub scope: Scope<'a>,
    /// The macro-step of each expansion, if there is one.
    pub expanded: IndexVec<ExpansionId, Option<MacroId>>,
    /// The chart. Levels and `hierarchy` are not known yet.
    pub chart: Tables,
    /// Whether no stand-in is in it.
    pub complete: bool,
    /// What names were taken for, if somebody asks; declarations are not among it yet.
    pub symbols: Symbols,
}

/// Resolves a syntax tree; in `symbols` it is noted what names were taken for.
pub fn resolve<'a>(
    tree: &'a ast::Chart,
    default_name: &str,
    mut symbols: Symbols,
    diagnostics: &mut Diagnostics,
) -> Resolved<'a> {
    let mut parts = Parts::collect(tree);
    let scope = Scope::declare(&parts, diagnostics);
    let mut variables = declarations::variables(&parts);
    addresses::assign(&parts, &mut variables, diagnostics);
    symbols.expect(variables.len(), tree.exprs.len() + 2 * parts.transitions.len());
    let values = declarations::evaluate(&tree.exprs, &parts, &scope, &mut variables, &mut symbols, diagnostics);
    let mut chart = Tables {
        name: tree.heading.as_ref().map_or_else(|| default_name.into(), |heading| heading.name.text.clone()),
        comment: tree.heading.as_ref().and_then(|heading| comment(&heading.comment)),
        options: tree.heading.as_ref().map(|heading| options(&heading.options)).unwrap_or_default(),
        variables,
        ..Tables::default()
    };
    chart.exprs.reserve(tree.exprs.len());
    let expanded = structure::build(&mut parts, &scope, &mut chart, &mut symbols, diagnostics);
    let interpreted =
        actions::interpret(&tree.exprs, &parts, &scope, &values.constants, &mut chart, &mut symbols, diagnostics);
    let context = expressions::Context {
        tree: &tree.exprs,
        scope: &scope,
        variables: &chart.variables,
        constants: &values.constants,
        step: None,
    };
    let (claims, claimed) = claims::read(&parts, context, &mut symbols, diagnostics);
    chart.claims = claims;
    let against = scenarios::Against {
        tree: &tree.exprs,
        scope: &scope,
        variables: &chart.variables,
        constants: &values.constants,
    };
    chart.scenarios = scenarios::read(&parts.scenarios, against, &mut symbols, diagnostics);
    chart.allowances = allowances::read(&parts, &scope, &chart.variables, &mut symbols, diagnostics);
    Resolved { parts, scope, expanded, chart, complete: values.complete && interpreted && claimed, symbols }
}

/// Resolves the scenarios of another text against a chart.
pub fn resolve_beside(tree: &ast::Chart, beside: &ast::Chart, diagnostics: &mut Diagnostics) -> Vec<Scenario> {
    let mut unsaid = Diagnostics::new();
    let mut symbols = Symbols::unasked();
    let parts = Parts::collect(tree);
    let scope = Scope::declare(&parts, &mut unsaid);
    let mut variables = declarations::variables(&parts);
    symbols.expect(variables.len(), 0);
    let values = declarations::evaluate(&tree.exprs, &parts, &scope, &mut variables, &mut symbols, &mut unsaid);
    let mut written = Vec::new();
    for item in &beside.items {
        match item {
            ast::Item::Scenario(scenario) => written.push(&**scenario),
            ast::Item::Declaration(_)
            | ast::Item::Grafcet(_)
            | ast::Item::Expansion(_)
            | ast::Item::Step(_)
            | ast::Item::Transition(_)
            | ast::Item::Allow(_)
            | ast::Item::Claim(_) => {
                let fault = Diagnostic::new(Code::E0610, item.span(), "a file of scenarios has scenarios alone");
                diagnostics.push(fault.help("what belongs to the chart stands in its own file"));
            }
        }
    }
    let against =
        scenarios::Against { tree: &beside.exprs, scope: &scope, variables: &variables, constants: &values.constants };
    scenarios::read(&written, against, &mut symbols, diagnostics)
}

/// What the heading chooses.
fn options(chosen: &[ast::ChartOption]) -> ChartOptions {
    let mut options = ChartOptions::default();
    for option in chosen {
        match option.kind {
            ast::ChartOptionKind::Evolution { scan } => {
                let evolution = if scan { Evolution::Scan } else { Evolution::Stable };
                options.evolution = Some((evolution, option.span));
            }
            ast::ChartOptionKind::InitialActions(on) => options.initial_actions = Some((on, option.span)),
            ast::ChartOptionKind::Bound(bound) => options.bound = Some((bound, option.span)),
        }
    }
    options
}

fn comment(text: &Option<Box<ast::Text>>) -> Option<Note> {
    text.as_ref().map(|text| text.text.clone().into())
}
