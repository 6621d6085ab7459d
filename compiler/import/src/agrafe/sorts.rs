//! The sorts and the number of the operands, as the constraints of the meta-model have them.
//!
//! The file repeats sorts at each term; they are determined again here, from the declarations. A whole number where a
//! condition should be would otherwise be read as a Boolean constant later.

use super::model::{ActionKind, Model, NodeKind, Sort, Term, TermId, TermKind, VariableId};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// Reports terms that mean nothing.
pub fn check(model: &Model, diagnostics: &mut Diagnostics) {
    for term in &model.terms {
        check_operands(model, term, diagnostics);
    }
    let mut expect = |term: Option<TermId>, sort: Sort, what: &str| {
        let Some(term) = term.map(|id| &model.terms[id]) else { return };
        if sort_of(model, term).is_some_and(|found| found != sort) {
            diagnostics.push(wrong_sort(term, what, sort));
        }
    };
    for node in &model.nodes {
        if let NodeKind::Transition(condition) = &node.kind {
            expect(condition.term, Sort::Bool, "a condition");
        }
    }
    for action in &model.actions {
        match &action.kind {
            ActionKind::Continuous { variable, condition, .. } => {
                expect(condition.term, Sort::Bool, "a condition");
                expect(*variable, Sort::Bool, "what a continuous action sets");
            }
            ActionKind::Stored { variable, value, condition, .. } => {
                expect(*condition, Sort::Bool, "a condition");
                if let Some(sort) = variable.and_then(|id| sort_of(model, &model.terms[id])) {
                    expect(*value, sort, "what the variable is set to");
                }
            }
            ActionKind::Force { .. } => {}
        }
    }
    for action in &model.actions {
        let missing = match &action.kind {
            ActionKind::Continuous { variable: None, .. } | ActionKind::Stored { variable: None, .. } => "variable",
            ActionKind::Stored { value: None, .. } => "value",
            ActionKind::Continuous { .. } | ActionKind::Stored { .. } | ActionKind::Force { .. } => continue,
        };
        let message = format!("an action has no {missing}");
        diagnostics.push(Diagnostic::new(Code::E0705, action.span, message).help("complete the action, or delete it"));
    }
    for action in &model.actions {
        let variable = match &action.kind {
            ActionKind::Continuous { variable: Some(variable), .. }
            | ActionKind::Stored { variable: Some(variable), .. } => variable,
            ActionKind::Continuous { .. } | ActionKind::Stored { .. } | ActionKind::Force { .. } => continue,
        };
        if !matches!(model.terms[*variable].kind, TermKind::Variable(_)) {
            let span = model.terms[*variable].span;
            diagnostics.push(
                Diagnostic::new(Code::E0705, span, "what an action sets is not a variable").help("name a variable"),
            );
        }
    }
}

/// The variable that an action sets.
pub fn target(model: &Model, variable: Option<TermId>) -> Option<VariableId> {
    match model.terms[variable?].kind {
        TermKind::Variable(id) => id,
        _ => None,
    }
}

fn check_operands(model: &Model, term: &Term, diagnostics: &mut Diagnostics) {
    let (least, most) = match term.kind {
        TermKind::Variable(_) | TermKind::Boolean(_) | TermKind::Integer(_) => (0, 0),
        TermKind::Not | TermKind::Rise | TermKind::Fall => (1, 1),
        // The same with more than two; a comparison of more would need its middle twice.
        TermKind::And | TermKind::Or => (2, usize::MAX),
        TermKind::Equal | TermKind::Greater | TermKind::Less | TermKind::Add | TermKind::Subtract => (2, 2),
    };
    if !(least..=most).contains(&term.operands.len()) {
        let count = term.operands.len();
        let message = format!("{} has {count} operand{}", article(term.kind), if count == 1 { "" } else { "s" });
        diagnostics.push(
            Diagnostic::new(Code::E0705, term.span, message)
                .note(if most > 2 { "it has two or more".to_string() } else { format!("it has {most}") })
                .help("complete the term in the tool that made the chart"),
        );
        return;
    }
    let sort = match term.kind {
        TermKind::Variable(_) | TermKind::Boolean(_) | TermKind::Integer(_) => return,
        TermKind::Not | TermKind::Rise | TermKind::Fall | TermKind::And | TermKind::Or => Sort::Bool,
        TermKind::Greater | TermKind::Less | TermKind::Add | TermKind::Subtract => Sort::Integer,
        TermKind::Equal => match sort_of(model, &model.terms[term.operands[0]]) {
            Some(sort) => sort,
            None => return,
        },
    };
    for operand in term.operands.iter().map(|&operand| &model.terms[operand]) {
        if sort_of(model, operand).is_some_and(|found| found != sort) {
            diagnostics.push(wrong_sort(operand, &format!("an operand of {}", article(term.kind)), sort));
        }
    }
}

/// What a term is of; nothing if it refers to nothing.
pub fn sort_of(model: &Model, term: &Term) -> Option<Sort> {
    match term.kind {
        TermKind::Variable(variable) => Some(model.variables[variable?].sort),
        TermKind::Integer(_) | TermKind::Add | TermKind::Subtract => Some(Sort::Integer),
        TermKind::Boolean(_)
        | TermKind::Not
        | TermKind::And
        | TermKind::Or
        | TermKind::Rise
        | TermKind::Fall
        | TermKind::Equal
        | TermKind::Greater
        | TermKind::Less => Some(Sort::Bool),
    }
}

fn wrong_sort(term: &Term, what: &str, sort: Sort) -> Diagnostic {
    let sort = match sort {
        Sort::Bool => "Boolean",
        Sort::Integer => "a whole number",
    };
    Diagnostic::new(Code::E0705, term.span, format!("{what} is not {sort}"))
        .help("correct the term, or the sort of the variable in it")
}

fn article(kind: TermKind) -> &'static str {
    match kind {
        TermKind::Variable(_) => "a variable",
        TermKind::Boolean(_) | TermKind::Integer(_) => "a constant",
        TermKind::Not => "a Not",
        TermKind::And => "an And",
        TermKind::Or => "an Or",
        TermKind::Rise => "a RisingEdge",
        TermKind::Fall => "a FallingEdge",
        TermKind::Equal => "an Equality",
        TermKind::Greater => "a GreaterThan",
        TermKind::Less => "a LessThan",
        TermKind::Add => "an Addition",
        TermKind::Subtract => "a Substraction",
    }
}
