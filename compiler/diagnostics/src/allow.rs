//! Warnings that the author has looked at and allows, with the reason: `allow W0409 "interlocked by hardware"`.
//!
//! An allowance holds for a part of the text. The parts lie within each other or apart, as blocks and items do, so
//! finding those around a place takes no more than a search and as many steps as blocks are nested.

use crate::{Code, Diagnostic, Diagnostics, Severity, Span};
use std::collections::BTreeMap;

/// What a text allows, where, and why.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Allowance {
    /// The warning.
    pub code: Code,
    /// Where it is allowed.
    pub scope: Scope,
    /// Why.
    pub reason: String,
    /// The item that says so.
    pub span: Span,
}

/// Where a warning is allowed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Scope {
    /// In a block, or in the whole text.
    Block(Span),
    /// Where it is about this step, transition or declaration: one of the places that the message shows lies in it.
    Item(Span),
}

/// Why a message is not shown.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Allowed {
    /// What the text gives as the reason; none if it was allowed from outside.
    pub reason: Option<String>,
    /// The place that allows it, if the text does.
    pub span: Option<Span>,
}

/// The allowances of a text.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Allowances {
    of_code: BTreeMap<Code, Nest>,
}

impl Allowances {
    /// Whatever a text allows, in any order. Of two for one part of the text the first one counts.
    pub fn new(all: impl IntoIterator<Item = Allowance>) -> Self {
        let mut lists: BTreeMap<Code, Vec<Allowance>> = BTreeMap::new();
        for allowance in all {
            lists.entry(allowance.code).or_default().push(allowance);
        }
        Allowances { of_code: lists.into_iter().map(|(code, list)| (code, Nest::new(list))).collect() }
    }

    /// Sets aside the warnings that are allowed where they are.
    pub fn apply(&self, said: &mut Diagnostics) {
        if !self.of_code.is_empty() {
            said.set_aside(|diagnostic| self.allowed(diagnostic));
        }
    }

    fn allowed(&self, diagnostic: &Diagnostic) -> Option<Allowed> {
        if diagnostic.code.severity() != Severity::Warning {
            return None;
        }
        let nest = self.of_code.get(&diagnostic.code)?;
        let around = |span: Span, is_primary: bool| {
            nest.around(span).find(|allowance| is_primary || matches!(allowance.scope, Scope::Item(_)))
        };
        let found = around(diagnostic.primary.span, true)
            .or_else(|| diagnostic.secondary.iter().find_map(|label| around(label.span, false)))?;
        Some(Allowed { reason: Some(found.reason.clone()), span: Some(found.span) })
    }
}

/// Allowances of one code by their parts of the text, each with the one around it.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Nest {
    parts: Vec<(Allowance, Option<usize>)>,
}

impl Nest {
    fn new(mut list: Vec<Allowance>) -> Self {
        let order = |part: &Allowance| {
            let Span { file, start, end } = part.scope.span();
            (file, start, std::cmp::Reverse(end))
        };
        list.sort_by_key(order);
        list.dedup_by_key(|part| part.scope.span());
        let mut parts: Vec<(Allowance, Option<usize>)> = Vec::with_capacity(list.len());
        let mut open: Vec<usize> = Vec::new();
        for part in list {
            let is_over = |around: &usize| !parts[*around].0.scope.span().holds(part.scope.span());
            while open.last().is_some_and(is_over) {
                open.pop();
            }
            parts.push((part, open.last().copied()));
            open.push(parts.len() - 1);
        }
        Nest { parts }
    }

    /// Those that hold for a place, the innermost first.
    fn around(&self, span: Span) -> impl Iterator<Item = &Allowance> {
        let begins = |part: &Span| (part.file, part.start) <= (span.file, span.start);
        let last = self.parts.partition_point(|(part, _)| begins(&part.scope.span())).checked_sub(1);
        std::iter::successors(last, |at| self.parts[*at].1)
            .map(|at| &self.parts[at].0)
            .filter(move |part| part.scope.span().holds(span))
    }
}

impl Scope {
    fn span(self) -> Span {
        match self {
            Scope::Block(span) | Scope::Item(span) => span,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FileId;

    fn span(start: usize, end: usize) -> Span {
        Span::new(FileId(0), start, end)
    }

    fn reason(allowances: &Allowances, diagnostic: Diagnostic) -> Option<String> {
        let mut said = Diagnostics::new();
        said.push(diagnostic);
        allowances.apply(&mut said);
        said.allowed().first().and_then(|(_, why)| why.reason.clone())
    }

    fn allowances(scopes: &[Scope]) -> Allowances {
        let allowance = |(i, scope): (usize, &Scope)| Allowance {
            code: Code::W0409,
            scope: *scope,
            reason: i.to_string(),
            span: span(0, 1),
        };
        Allowances::new(scopes.iter().enumerate().map(allowance))
    }

    #[test]
    fn the_innermost_around_a_place_gives_the_reason() {
        let nested = allowances(&[
            Scope::Block(span(10, 90)),
            Scope::Block(span(20, 40)),
            Scope::Block(span(50, 60)),
            Scope::Block(span(20, 40)),
        ]);
        let at = |start, end| reason(&nested, Diagnostic::new(Code::W0409, span(start, end), "m"));
        assert_eq!(at(5, 8), None);
        assert_eq!(at(10, 11).as_deref(), Some("0"));
        assert_eq!(at(20, 40).as_deref(), Some("1"));
        assert_eq!(at(45, 46).as_deref(), Some("0"));
        assert_eq!(at(55, 56).as_deref(), Some("2"));
        assert_eq!(at(70, 71).as_deref(), Some("0"));
        assert_eq!(at(90, 95), None);
    }

    #[test]
    fn an_item_is_meant_by_any_of_the_places_and_a_block_by_the_first() {
        let warning = || Diagnostic::new(Code::W0409, span(1, 2), "m").also(span(30, 31), "there");
        assert_eq!(reason(&allowances(&[Scope::Item(span(30, 40))]), warning()).as_deref(), Some("0"));
        assert_eq!(reason(&allowances(&[Scope::Block(span(30, 40))]), warning()), None);
    }

    #[test]
    fn other_codes_and_errors_are_not_allowed() {
        let everywhere = allowances(&[Scope::Block(span(0, 99))]);
        assert_eq!(reason(&everywhere, Diagnostic::new(Code::W0410, span(1, 2), "m")), None);
        let error = Allowances::new([Allowance {
            code: Code::E0201,
            scope: Scope::Block(span(0, 99)),
            reason: String::new(),
            span: span(0, 1),
        }]);
        assert_eq!(reason(&error, Diagnostic::new(Code::E0201, span(1, 2), "m")), None);
    }
}
