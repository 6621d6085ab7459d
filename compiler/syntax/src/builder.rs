//! What the grammar's actions do: they make tree nodes, and find the faults that a grammar says badly.

use crate::ast::*;
use crate::lexer::MOST_FAULTS;
use crate::numeral;
use grafc_diagnostics::{Code, Diagnostic, FileId, Span};

/// What one item of the token stream turned out to be.
pub(crate) enum Parsed {
    /// `chart Name`
    Heading(Heading),
    /// `grafcet G1 {`: its items follow.
    Grafcet(Grafcet),
    /// `expansion M3 {`: its items follow.
    Expansion(Expansion),
    /// A whole item.
    Item(Item),
}

/// A word before `step`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Prefix {
    Initial,
    Activated,
    Enclosing,
    Macro,
}

impl Prefix {
    fn word(self) -> &'static str {
        match self {
            Prefix::Initial => "initial",
            Prefix::Activated => "activated",
            Prefix::Enclosing => "enclosing",
            Prefix::Macro => "macro",
        }
    }
}

/// The arena under construction and the faults found on the way.
pub(crate) struct Builder<'text> {
    pub(crate) file: FileId,
    pub(crate) text: &'text str,
    pub(crate) exprs: Exprs,
    pub(crate) faults: Vec<Diagnostic>,
}

impl<'text> Builder<'text> {
    pub(crate) fn new(file: FileId, text: &'text str) -> Self {
        Builder { file, text, exprs: Exprs::new(), faults: Vec::new() }
    }

    /// An item has few faults of this kind, or it is no chart; the number that is kept is bounded.
    fn fault(&mut self, fault: Diagnostic) {
        if self.faults.len() < MOST_FAULTS {
            self.faults.push(fault);
        }
    }

    pub(crate) fn span(&self, start: u32, end: u32) -> Span {
        Span::new(self.file, start as usize, end as usize)
    }

    pub(crate) fn slice(&self, start: u32, end: u32) -> &'text str {
        &self.text[start as usize..end as usize]
    }

    /// A name without its backquotes; also one that the lexer reported as unfinished.
    pub(crate) fn name(&self, start: u32, end: u32) -> Name {
        let written = self.slice(start, end);
        let (text, quoted) = match written.strip_prefix('`') {
            Some(rest) => (rest.strip_suffix('`').unwrap_or(rest), true),
            None => (written, false),
        };
        Name { text: text.to_owned(), quoted, span: self.span(start, end) }
    }

    pub(crate) fn text(&self, start: u32, end: u32) -> Text {
        let written = self.slice(start, end);
        let inner = written.strip_prefix('"').unwrap_or(written);
        let inner = inner.strip_suffix('"').unwrap_or(inner);
        Text { text: inner.replace("\"\"", "\""), span: self.span(start, end) }
    }

    pub(crate) fn address(&self, start: u32, end: u32) -> Text {
        Text { text: self.slice(start, end).to_owned(), span: self.span(start, end) }
    }

    pub(crate) fn ty(&mut self, start: u32, end: u32) -> (Type, Span) {
        let word = self.slice(start, end);
        let span = self.span(start, end);
        if let Some(ty) = type_of(word) {
            return (ty, span);
        }
        let shown = crate::expected::shorten(word);
        let mut fault = Diagnostic::new(Code::E0107, span, format!("expected a type, found `{shown}`"))
            .note("the types are `bool`, `int`, `dint`, `uint`, `udint`, `real`, `lreal` and `time`");
        if let Some(known) = type_of(&word.to_lowercase()).map(|_| word.to_lowercase()) {
            fault = fault.help(format!("write `{known}`"));
        }
        self.fault(fault);
        (Type::Bool, span)
    }

    pub(crate) fn step(
        &mut self,
        start: u32,
        end: u32,
        prefixes: Vec<(Prefix, u32, u32)>,
        label: Name,
        comment: Option<Text>,
        actions: Vec<Action>,
    ) -> Step {
        let mut seen: Vec<(Prefix, u32, u32)> = Vec::new();
        let mut kind = StepKind::Plain;
        for &(prefix, l, r) in &prefixes {
            let place = self.span(l, r);
            if let Some(&(_, first_l, first_r)) = seen.iter().find(|s| s.0 == prefix) {
                let fault =
                    Diagnostic::new(Code::E0107, place, format!("`{}` stands twice before `step`", prefix.word()))
                        .also(self.span(first_l, first_r), "first here");
                self.fault(fault);
                continue;
            }
            seen.push((prefix, l, r));
            let new_kind = match prefix {
                Prefix::Initial | Prefix::Activated => continue,
                Prefix::Enclosing => StepKind::Enclosing,
                Prefix::Macro => StepKind::Macro,
            };
            if kind != StepKind::Plain {
                self.fault(Diagnostic::new(Code::E0107, place, "a step is either an enclosing step or a macro-step"));
            }
            kind = new_kind;
        }
        Step {
            kind,
            initial: seen.iter().any(|s| s.0 == Prefix::Initial),
            activated: seen.iter().any(|s| s.0 == Prefix::Activated),
            label,
            comment,
            actions,
            span: self.span(start, end),
        }
    }

    pub(crate) fn action(&self, start: u32, end: u32, kind: ActionKind) -> Option<Action> {
        Some(Action { kind, span: self.span(start, end) })
    }

    /// In a step, the standard has no action that assigns without saying when (4.8.3).
    pub(crate) fn assignment_without_event(&mut self, assignment: Assignment) -> Option<Action> {
        let target = crate::expected::shorten(&assignment.target.text);
        self.fault(
            Diagnostic::new(
                Code::E0108,
                assignment.span,
                format!("the assignment of `{target}` does not say when it is done"),
            )
            .note("IEC 60848, 4.8.3: a stored action is associated with an event")
            .help("add `on activation`, `on deactivation` or `on event …` behind it"),
        );
        None
    }

    /// `{INIT}` is the initial situation; a step of that name is written in backquotes.
    pub(crate) fn situation(&self, labels: Vec<Name>) -> Situation {
        match labels.as_slice() {
            [only] if !only.quoted && only.text == "INIT" => Situation::Initial,
            _ => Situation::Steps(labels),
        }
    }

    pub(crate) fn expr(&mut self, start: u32, end: u32, kind: ExprKind) -> ExprId {
        let span = self.span(start, end);
        self.exprs.push(Expr { kind, span })
    }

    pub(crate) fn binary(&mut self, start: u32, end: u32, op: BinaryOp, left: ExprId, right: ExprId) -> ExprId {
        self.expr(start, end, ExprKind::Binary(op, left, right))
    }

    pub(crate) fn variable(&mut self, start: u32, end: u32) -> ExprId {
        let name = self.name(start, end).text;
        self.expr(start, end, ExprKind::Name(name))
    }

    pub(crate) fn whole(&mut self, start: u32, end: u32) -> ExprId {
        let word = self.slice(start, end);
        match numeral::whole(word) {
            Ok(value) => self.expr(start, end, ExprKind::Integer(value)),
            Err(fault) => {
                let fault = fault.diagnostic(self.span(start, end), word);
                self.fault(fault);
                self.expr(start, end, ExprKind::Error)
            }
        }
    }

    /// `3/a` where `3s/a` was meant is a slip that is better named here than as a wrong type.
    pub(crate) fn delay(&mut self, start: u32, end: u32, parts: Vec<ExprId>) -> ExprId {
        for &part in &parts {
            let span = self.exprs[part].span;
            let (what, cure) = match self.exprs[part].kind {
                ExprKind::Integer(_) | ExprKind::Real(_) => (
                    "number",
                    format!("a delay has a unit: `{}s`", crate::expected::shorten(self.slice(span.start, span.end))),
                ),
                ExprKind::Bool(_) => ("constant", "put the operand in parentheses".to_owned()),
                ExprKind::Name(_)
                | ExprKind::Duration(_)
                | ExprKind::Paren(_)
                | ExprKind::Predicate(_)
                | ExprKind::Not(_)
                | ExprKind::Negate(_)
                | ExprKind::Rise(_)
                | ExprKind::Fall(_)
                | ExprKind::Binary(..)
                | ExprKind::Delay(_)
                | ExprKind::Error => continue,
            };
            let shown = crate::expected::shorten(self.slice(span.start, span.end));
            self.fault(
                Diagnostic::new(Code::E0107, span, format!("expected a duration or a variable, found the {what} `{shown}`"))
                    .note("outside brackets, `/` makes a time-dependent variable such as `3s/a/7s`; division stands in brackets")
                    .help(cure),
            );
            self.exprs[part].kind = ExprKind::Error;
        }
        self.expr(start, end, ExprKind::Delay(parts))
    }
}

/// The type of this name.
fn type_of(word: &str) -> Option<Type> {
    Some(match word {
        "bool" => Type::Bool,
        "int" => Type::Int,
        "dint" => Type::Dint,
        "uint" => Type::Uint,
        "udint" => Type::Udint,
        "real" => Type::Real,
        "lreal" => Type::Lreal,
        "time" => Type::Time,
        _ => return None,
    })
}
