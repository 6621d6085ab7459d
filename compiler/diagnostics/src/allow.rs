//! Warnings that the author has looked at and allows, with the reason: `allow W0409 "interlocked by hardware"`.
//!
//! An allowance holds for a part of the text. The parts lie within each other or apart, as blocks and items do, so
//! finding those around a place takes no more than a search and as many steps as blocks are nested.

use crate::{Allowed, Code, Diagnostic, Diagnostics, Fix, Severity, Span};
use std::collections::{BTreeMap, BTreeSet};

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

/// The allowances of a text.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Allowances {
    of_code: BTreeMap<Code, Nest>,
    /// Where each is written, in order of place, with its warning.
    written: BTreeMap<Span, Code>,
}

/// Warnings that a check of the text alone does not give: they come with an encoding, a trace or an import.
const ELSEWHERE: &[Code] = &[Code::W0413, Code::W0601, Code::W0701, Code::W0702, Code::W0703];

impl Allowances {
    /// Whatever a text allows, in any order. Of two for one part of the text the first one counts.
    pub fn new(all: impl IntoIterator<Item = Allowance>) -> Self {
        let mut lists: BTreeMap<Code, Vec<Allowance>> = BTreeMap::new();
        let mut written = BTreeMap::new();
        for allowance in all {
            written.insert(allowance.span, allowance.code);
            lists.entry(allowance.code).or_default().push(allowance);
        }
        let of_code = lists.into_iter().map(|(code, list)| (code, Nest::new(list))).collect();
        Allowances { of_code, written }
    }

    /// Sets aside the warnings that are allowed where they are.
    pub fn apply(&self, said: &mut Diagnostics) {
        if !self.of_code.is_empty() {
            said.set_aside(|diagnostic| self.allowed(diagnostic));
        }
    }

    /// Warns of those that set nothing aside (W0425), once everything that a check of the text finds has been `said`.
    pub fn without_effect(&self, said: &[&Diagnostics]) -> Diagnostics {
        let used: BTreeSet<Span> =
            said.iter().flat_map(|said| said.allowed()).filter_map(|(_, why)| why.span).collect();
        let mut found = Diagnostics::new();
        for (span, code) in &self.written {
            if !used.contains(span) && *code != Code::W0425 && !ELSEWHERE.contains(code) {
                let message = format!("this allows nothing: {} is not given here", code.as_str());
                found.push(
                    Diagnostic::new(Code::W0425, *span, message)
                        .note("a warning that comes later would be hidden, and the reason would not be about it")
                        .help("leave it out")
                        .fix(Fix::maybe("leave it out").delete(*span)),
                );
            }
        }
        self.apply(&mut found);
        found
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
        Span::new(FileId::new(0), start, end)
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
    fn what_sets_nothing_aside_is_told() {
        let allowance = |code, at: usize, scope| Allowance { code, scope, reason: "r".into(), span: span(at, at + 1) };
        let all = Allowances::new([
            allowance(Code::W0409, 1, Scope::Block(span(0, 99))),
            allowance(Code::W0409, 3, Scope::Block(span(50, 60))),
            allowance(Code::W0410, 5, Scope::Block(span(0, 99))),
            // The second for the same part, one of an encoding, and one of this warning itself.
            allowance(Code::W0409, 7, Scope::Block(span(0, 99))),
            allowance(Code::W0413, 9, Scope::Block(span(0, 99))),
            allowance(Code::W0425, 50, Scope::Block(span(3, 4))),
        ]);
        let mut said = Diagnostics::new();
        said.push(Diagnostic::new(Code::W0409, span(70, 71), "m"));
        all.apply(&mut said);
        let told: Vec<u32> = all.without_effect(&[&said]).iter().map(|d| d.primary.span.start).collect();
        assert_eq!(told, [5, 7]);
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
