//! Steps, transitions and actions in text.

use super::reader::Reader;
use crate::code::source::Source;
use crate::code::token::{Keyword, Token};
use crate::code::tree::{ExprId, ExprKind};
use crate::code::{expression, il, read};
use crate::sfc::{Association, Body, Chart, NamedAction, Qualifier, Step, Target, Transition};
use grafc_diagnostics::{Code as ErrorCode, Diagnostic, Diagnostics, Span};
use rustc_hash::FxHashMap;
use std::ops::Range;

/// Transitions that name their steps.
#[derive(Default)]
pub struct Links {
    pub transitions: Vec<Link>,
}

/// A transition that names its steps.
pub struct Link {
    before: Vec<(String, Span)>,
    behind: Vec<(String, Span)>,
    condition: ExprId,
    priority: Option<i64>,
    span: Span,
}

impl Links {
    /// Finds the steps that are named.
    pub fn resolve(self, chart: &mut Chart, diagnostics: &mut Diagnostics) {
        let mut by_name: FxHashMap<String, usize> = FxHashMap::default();
        for (place, step) in chart.steps.iter().enumerate() {
            if by_name.insert(step.name.to_lowercase(), place).is_some() {
                let message = format!("two steps are called `{}`", step.name);
                diagnostics.push(
                    Diagnostic::new(ErrorCode::E0705, step.span, message)
                        .help("give each step of a chart a name of its own"),
                );
            }
        }
        for link in self.transitions {
            let mut find = |names: Vec<(String, Span)>| {
                let mut places = Vec::new();
                for (name, span) in names {
                    match by_name.get(&name.to_lowercase()) {
                        Some(&place) if !places.contains(&place) => places.push(place),
                        Some(_) => {}
                        None => diagnostics.push(
                            Diagnostic::new(ErrorCode::E0704, span, format!("there is no step `{name}`"))
                                .help("name a step of the same chart"),
                        ),
                    }
                }
                places
            };
            let (before, behind) = (find(link.before), find(link.behind));
            let Link { condition, priority, span, .. } = link;
            chart.transitions.push(Transition { before, behind, condition, priority, span });
        }
    }
}

impl Reader<'_> {
    /// `STEP name : action(N, T#2s); … END_STEP`.
    pub fn step(&mut self, initial: bool) -> Option<Step> {
        let head = self.span();
        self.advance();
        let span = self.span();
        let name = self.word().map(str::to_string);
        let (range, _) = self.up_to(Keyword::EndStep);
        let Some(name) = name else {
            self.malformed(head, "a step has no name", "write its name behind the keyword");
            return None;
        };
        let behind = std::mem::replace(&mut self.at, range.start);
        self.take(Token::Colon);
        let mut actions = Vec::new();
        while self.at < range.end {
            let begin = self.at;
            let mut action = String::new();
            let place = self.span();
            while let Some(word) = self.word() {
                action.push_str(word);
                if !self.take(Token::Point) {
                    break;
                }
                action.push('.');
            }
            if action.is_empty() {
                // A semicolon, or what is not understood.
                if !self.take(Token::Semicolon) {
                    self.malformed(place, "an action of a step is not understood", "write `NAME(QUALIFIER);`");
                    self.skip_action(range.end);
                }
                continue;
            }
            let (qualifier, time) = self.qualifier(range.end, place);
            let Some(qualifier) = qualifier else { continue };
            let span = self.place(self.source(begin..self.at).span(0..0).range().start..place.range().end);
            actions.push(Association { qualifier, time, action: Target::Named(action), span });
        }
        self.at = behind;
        Some(Step { name, initial, span, actions, comment: None })
    }

    fn skip_action(&mut self, most: usize) {
        while self.at < most && !self.take(Token::Semicolon) {
            self.advance();
        }
    }

    /// `(N)`, `(D, T#2s)`; without one it is `N`.
    fn qualifier(&mut self, most: usize, place: Span) -> (Option<Qualifier>, Option<ExprId>) {
        if !self.take(Token::OpenParen) {
            self.take(Token::Semicolon);
            return (Some(Qualifier::N), None);
        }
        let mut depth = 1_usize;
        let begin = self.at;
        let mut commas = Vec::new();
        while self.at < most && depth > 0 {
            match self.token() {
                Some(Token::OpenParen) => depth += 1,
                Some(Token::CloseParen) => depth -= 1,
                Some(Token::Comma) if depth == 1 => commas.push(self.at),
                _ => {}
            }
            self.advance();
        }
        let end = self.at.saturating_sub(usize::from(depth == 0));
        self.take(Token::Semicolon);
        let first = commas.first().copied().unwrap_or(end);
        let written = self.source(begin..first).text;
        let Some(qualifier) = Qualifier::of(&written) else {
            let message = format!("an action has the qualifier `{}`, which IEC 61131-3 does not have", written.trim());
            self.malformed(place, message, "it has N, S, R, P, P0, P1, L, D, SD, DS and SL");
            return (None, None);
        };
        // Behind a qualifier without time comes an indicator, which does nothing.
        let time = commas.first().filter(|_| qualifier.is_timed()).map(|&comma| {
            let source = self.source(comma + 1..commas.get(1).copied().unwrap_or(end));
            expression(&source, self.code)
        });
        (Some(qualifier), time)
    }

    /// `TRANSITION name (PRIORITY := 1) FROM a TO (b, c) := condition; END_TRANSITION`.
    pub fn transition(&mut self) -> Option<Link> {
        let span = self.span();
        self.advance();
        let (range, _) = self.up_to(Keyword::EndTransition);
        let behind = std::mem::replace(&mut self.at, range.start);
        let find = |reader: &Self, keyword: Keyword| {
            range.clone().find(|&at| reader.token_at(at) == Some(Token::Keyword(keyword)))
        };
        let (Some(from), Some(to)) = (find(self, Keyword::From), find(self, Keyword::To)) else {
            self.at = behind;
            self.malformed(span, "a transition does not say from where to where it leads", "write `FROM STEP TO STEP`");
            return None;
        };
        let mut numbers = (range.start..from).filter(|&at| self.token_at(at) == Some(Token::Integer));
        let priority = numbers.next_back().and_then(|at| self.text_at(at).parse().ok());
        let begins = |token| matches!(token, Some(Token::Assign | Token::Colon));
        let begin = (to..range.end).find(|&at| begins(self.token_at(at))).unwrap_or(range.end);
        let (before, behind_steps) = (self.names(from + 1..to), self.names(to + 1..begin));
        let is_list = self.token_at(begin) == Some(Token::Colon);
        let source = self.source(begin + 1..range.end);
        let condition = if is_list { self.list(&source) } else { expression(&source, self.code) };
        self.at = behind;
        Some(Link { before, behind: behind_steps, condition, priority, span })
    }

    /// The condition that an instruction list leaves behind.
    fn list(&mut self, source: &Source) -> ExprId {
        match il::read(source, self.code).result {
            Some(result) => result,
            None => self.code.add(ExprKind::Unknown("its instructions leave nothing behind".into()), source.whole),
        }
    }

    /// The names of steps.
    fn names(&self, range: Range<usize>) -> Vec<(String, Span)> {
        let is_name = |at: &usize| {
            !matches!(
                self.token_at(*at),
                Some(Token::OpenParen | Token::CloseParen | Token::Comma | Token::Semicolon) | None
            )
        };
        range.filter(is_name).map(|at| (self.text_at(at).to_string(), self.source(at..at + 1).whole)).collect()
    }

    /// `ACTION name : … END_ACTION`.
    pub fn action(&mut self) -> Option<NamedAction> {
        let span = self.span();
        self.advance();
        let name = self.word().map(str::to_string);
        self.take(Token::Colon);
        let (range, _) = self.up_to(Keyword::EndAction);
        let Some(name) = name else {
            self.malformed(span, "an action has no name", "write its name behind the keyword");
            return None;
        };
        let source = self.source(range.clone());
        let is_list = !range.clone().any(|at| matches!(self.token_at(at), Some(Token::Assign | Token::Semicolon)))
            && !range.is_empty();
        let statements = if is_list { il::read(&source, self.code).statements } else { read(&source, self.code) };
        Some(NamedAction { name, span, body: Body::Statements(statements) })
    }
}
