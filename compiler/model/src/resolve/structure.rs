//! Grafcets, steps, macro-steps and arcs: who belongs to whom.
//!
//! The steps of an expansion belong to the grafcet of their macro-step, wherever the block stands (M1).

use super::comment;
use super::parts::{ExpansionId, Frame, Parts};
use super::scope::{IMPLIED_GRAFCET, Label, Scope};
use crate::chart::{ExprId, Grafcet, GrafcetId, MacroId, MacroStep, Node, Nodes, Step, Tables, Transition};
use crate::symbols::{Form, Role, Symbols, Wanted};
use grafc_diagnostics::Diagnostics;
use grafc_syntax::ast;
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashSet;

/// Fills in the grafcets, steps, macro-steps and transitions; gives back which macro-step each expansion expands.
pub fn build<'a>(
    parts: &mut Parts<'a>,
    scope: &Scope<'a>,
    chart: &mut Tables,
    symbols: &mut Symbols,
    diagnostics: &mut Diagnostics,
) -> IndexVec<ExpansionId, Option<MacroId>> {
    let expanded = expanded(parts, scope, symbols, diagnostics);
    let homes = homes(parts, &expanded);
    chart.steps.reserve(parts.steps.len());
    chart.transitions.reserve(parts.transitions.len());
    grafcets(parts, scope, chart, symbols, diagnostics);
    steps(parts, &expanded, &homes, chart);
    entries_and_exits(parts, scope, &expanded, chart);
    transitions(parts, scope, &homes, chart, symbols, diagnostics);
    expanded
}

/// The macro-step of each expansion.
fn expanded(
    parts: &Parts,
    scope: &Scope,
    symbols: &mut Symbols,
    diagnostics: &mut Diagnostics,
) -> IndexVec<ExpansionId, Option<MacroId>> {
    let macro_step = |name: &ast::Name| match scope.label(&name.text) {
        Some(label) => {
            symbols.used(name.span, label, Form::Name, Role::Expanded);
            match label {
                Label::Macro(id) => Some(id),
                Label::Step(_) | Label::Grafcet(_) => None, // E0306
            }
        }
        None => {
            symbols.missed(name.span, Wanted::MacroStep);
            diagnostics.push(scope.unknown_step(&name.text, name.span));
            None
        }
    };
    parts.expansions.iter().map(|part| &part.ast.macro_step).map(macro_step).collect()
}

/// The grafcet that the items of each expansion belong to.
fn homes(parts: &mut Parts, expanded: &IndexVec<ExpansionId, Option<MacroId>>) -> IndexVec<ExpansionId, GrafcetId> {
    let mut homes: IndexVec<ExpansionId, Option<GrafcetId>> = index_vec![None; parts.expansions.len()];
    let mut walked: IndexVec<ExpansionId, bool> = index_vec![false; parts.expansions.len()];
    for start in parts.expansions.indices() {
        let mut way = Vec::new();
        let mut at = start;
        let home = loop {
            if let Some(home) = homes[at] {
                break home;
            }
            if walked[at] {
                break parts.stray(); // expansions that hold each other (E0306)
            }
            walked[at] = true;
            way.push(at);
            match expanded[at].map(|id| parts.step(Node::Macro(id)).frame).or(parts.expansions[at].within) {
                Some(Frame::Grafcet(grafcet)) => break grafcet,
                Some(Frame::Expansion(outer)) => at = outer,
                None => break parts.stray(),
            }
        };
        for expansion in way {
            homes[expansion] = Some(home);
        }
    }
    homes.into_iter().map(|home| home.expect("every expansion has been a start")).collect()
}

fn grafcets(parts: &Parts, scope: &Scope, chart: &mut Tables, symbols: &mut Symbols, diagnostics: &mut Diagnostics) {
    for part in &parts.grafcets {
        let mut enclosing_step = None;
        for name in part.ast.iter().flat_map(|grafcet| &grafcet.path) {
            let named = name.text.strip_prefix('X').map(|label| (label, scope.label(label)));
            match named {
                Some((_, Some(label))) => symbols.used(name.span, label, Form::Activity, Role::Enclosing),
                Some((_, None)) | None => symbols.missed(name.span, Wanted::EnclosingStep),
            }
            // The last name is the step that encloses directly.
            enclosing_step = match named {
                Some((_, Some(Label::Step(step)))) => Some(step),
                Some((_, Some(Label::Macro(_)))) => None, // E0318
                Some((label, Some(Label::Grafcet(_)) | None)) => {
                    diagnostics.push(scope.unknown_step(label, name.span));
                    None
                }
                None => {
                    let mut diagnostic = scope.unknown_step(&name.text, name.span);
                    if scope.node(&name.text).is_some() {
                        diagnostic.message = format!("the enclosing step is written `X{}` here", name.text);
                    }
                    diagnostics.push(diagnostic);
                    None
                }
            };
        }
        let parent = part.ast.and_then(|grafcet| grafcet.parent.as_ref()).and_then(|name| {
            let named = scope.label(&name.text);
            match named {
                Some(label) => symbols.used(name.span, label, Form::Name, Role::Parent),
                None => symbols.missed(name.span, Wanted::Grafcet),
            }
            match named {
                Some(Label::Grafcet(id)) => Some(id),
                Some(Label::Step(_) | Label::Macro(_)) | None => {
                    diagnostics.push(scope.unknown_grafcet(&name.text, name.span, None));
                    None
                }
            }
        });
        chart.grafcets.push(Grafcet {
            name: part.ast.map_or(IMPLIED_GRAFCET.into(), |grafcet| grafcet.name.text.clone()),
            comment: part.ast.and_then(|grafcet| comment(&grafcet.comment)),
            enclosing_step,
            child: part.ast.is_some_and(|grafcet| grafcet.parent.is_some()),
            parent,
            level: 0,
            steps: Vec::new(),
            span: part.span,
        });
    }
}

fn steps(
    parts: &Parts,
    expanded: &IndexVec<ExpansionId, Option<MacroId>>,
    homes: &IndexVec<ExpansionId, GrafcetId>,
    chart: &mut Tables,
) {
    for part in &parts.steps {
        let step = part.ast;
        let (grafcet, expansion_of) = match part.frame {
            Frame::Grafcet(grafcet) => (grafcet, None),
            Frame::Expansion(expansion) => (homes[expansion], expanded[expansion]),
        };
        match part.node {
            Node::Step(id) => {
                chart.steps.push(Step {
                    label: step.label.text.clone(),
                    comment: comment(&step.comment),
                    grafcet,
                    expansion_of,
                    initial: step.is_initial(),
                    activated: step.is_activated(),
                    enclosing: step.kind == ast::StepKind::Enclosing,
                    span: step.label.span,
                });
                chart.grafcets[grafcet].steps.push(id);
            }
            Node::Macro(_) => {
                chart.macro_steps.push(MacroStep {
                    label: step.label.text.clone(),
                    comment: comment(&step.comment),
                    grafcet,
                    expansion_of,
                    expansion_comment: None,
                    entry: None,
                    exit: None,
                    span: step.label.span,
                });
            }
        }
    }
}

/// `E3` and `S3` of `M3`, where they are what they should be.
fn entries_and_exits(
    parts: &Parts,
    scope: &Scope,
    expanded: &IndexVec<ExpansionId, Option<MacroId>>,
    chart: &mut Tables,
) {
    for (expansion, part) in parts.expansions.iter_enumerated() {
        let Some(macro_step) = expanded[expansion] else { continue };
        let about = &mut chart.macro_steps[macro_step].expansion_comment;
        *about = about.take().or_else(|| comment(&part.ast.comment));
        let Some(rest) = part.ast.macro_step.text.strip_prefix('M') else { continue };
        let step_of = |letter: char| match scope.label(&format!("{letter}{rest}")) {
            Some(Label::Step(id)) => (chart.steps[id].expansion_of == Some(macro_step)).then_some(id),
            Some(Label::Macro(_) | Label::Grafcet(_)) | None => None,
        };
        let (entry, exit) = (step_of('E'), step_of('S'));
        let found = &mut chart.macro_steps[macro_step];
        (found.entry, found.exit) = (entry, exit);
    }
}

fn transitions(
    parts: &Parts,
    scope: &Scope,
    homes: &IndexVec<ExpansionId, GrafcetId>,
    chart: &mut Tables,
    symbols: &mut Symbols,
    diagnostics: &mut Diagnostics,
) {
    let mut seen = FxHashSet::default();
    let mut nodes = |names: &[ast::Name], role: Role| {
        let mut nodes = Nodes::with_capacity(names.len());
        seen.clear();
        for name in names {
            match scope.node(&name.text) {
                Some(node) => {
                    symbols.used(name.span, node, Form::Name, role);
                    if names.len() == 1 || seen.insert(node) {
                        nodes.push(node);
                    } // else E0303
                }
                None => {
                    symbols.missed(name.span, Wanted::Step);
                    diagnostics.push(scope.unknown_step(&name.text, name.span));
                }
            }
        }
        nodes
    };
    for part in &parts.transitions {
        let transition = part.ast;
        chart.transitions.push(Transition {
            designation: transition.designation().map(|name| name.text.clone().into()),
            comment: comment(transition.comment()),
            grafcet: match part.frame {
                Frame::Grafcet(grafcet) => grafcet,
                Frame::Expansion(expansion) => homes[expansion],
            },
            pre: nodes(&transition.from, Role::Before),
            post: nodes(&transition.to, Role::After),
            condition: ExprId::new(0), // filled in with the actions
            span: transition.span,
        });
    }
}
