//! The time operator: `3s/a/7s`, `4s/X27`, `X2/5s` (IEC 60848, symbols 17 and 18).
//!
//! Its times are durations or constants of type `time`, so they are known here already.

use super::Work;
use crate::chart::{DelayTime, Type, Value, VariableId, VariableKind};
use crate::fixes::name_instead;
use crate::resolve::scope::{Label, Reference};
use grafc_diagnostics::{Code, Diagnostic, Span};
use grafc_syntax::ast;

const NO_DELAY: DelayTime = DelayTime { ms: 0, constant: None };

/// What stands between slashes.
enum Part {
    /// A time, known.
    Time(DelayTime),
    /// A constant of type `time` whose value is wrong, or a hole; reported elsewhere.
    Faulty,
    /// Of type `time`, but no constant.
    Variable(VariableId),
    /// Anything else: the operand, if it stands in the right place.
    Other,
}

impl Work<'_, '_, '_> {
    /// Reads the parts of a delay; gives back its operand, unless the delay is faulty.
    pub(super) fn read_delay(&mut self, place: usize, parts: &[ast::ExprId]) -> Option<ast::ExprId> {
        let span = self.written(place).span;
        let kinds: Vec<Part> = parts.iter().map(|&part| self.part(part)).collect();
        let (on, operand, off) = match (&kinds[..], parts) {
            ([on, Part::Other], [_, operand]) if !matches!(on, Part::Other) => (on, *operand, &Part::Time(NO_DELAY)),
            ([Part::Other, off], [operand, _]) if !matches!(off, Part::Other) => (&Part::Time(NO_DELAY), *operand, off),
            ([on, Part::Other, off], [_, operand, _]) if !matches!(on, Part::Other) && !matches!(off, Part::Other) => {
                (on, *operand, off)
            }
            _ => {
                // None of them becomes a node, so their names are noted here.
                parts.iter().for_each(|&part| self.note(part));
                let diagnostic = self.misplaced(span, &kinds, parts);
                self.report(place, diagnostic);
                return None;
            }
        };
        parts.iter().filter(|&&part| part != operand).for_each(|&part| self.note(part));
        let on = self.time(place, on, span);
        let off = self.time(place, off, span);
        if let (Some(on), Some(off)) = (on, off) {
            self.nodes[place].detail = super::Detail::Delay { on, off };
        } else {
            self.nodes[place].faulty = true;
        }
        Some(operand)
    }

    /// Notes what a part refers to that does not become a node.
    fn note(&mut self, part: ast::ExprId) {
        let written = &self.context.tree[part];
        if let ast::ExprKind::Name(name) = &written.kind
            && let Some(reference) = self.context.scope.reference(name)
        {
            self.read(written.span, reference);
        }
    }

    fn part(&self, id: ast::ExprId) -> Part {
        match &self.context.tree[id].kind {
            ast::ExprKind::Duration(ms) => Part::Time(DelayTime { ms: *ms, constant: None }),
            ast::ExprKind::Name(name) => match self.context.scope.reference(name) {
                Some(Reference::Variable(id)) => self.variable(id),
                Some(Reference::Activity(_) | Reference::Duration(_)) | None => Part::Other,
            },
            ast::ExprKind::Error
            | ast::ExprKind::Integer(_)
            | ast::ExprKind::Real(_)
            | ast::ExprKind::Bool(_)
            | ast::ExprKind::Paren(_)
            | ast::ExprKind::Predicate(_)
            | ast::ExprKind::Not(_)
            | ast::ExprKind::Negate(_)
            | ast::ExprKind::Rise(_)
            | ast::ExprKind::Fall(_)
            | ast::ExprKind::Binary(..)
            | ast::ExprKind::Delay(_) => Part::Other,
        }
    }

    fn variable(&self, id: VariableId) -> Part {
        let variable = &self.context.variables[id];
        if variable.ty != Type::Time {
            return Part::Other;
        }
        match (variable.kind, self.context.constants[id]) {
            (VariableKind::Constant, Some(Value::Time(ms))) => Part::Time(DelayTime { ms, constant: Some(id) }),
            (VariableKind::Constant, _) => Part::Faulty,
            (VariableKind::Input | VariableKind::Output | VariableKind::Internal, _) => Part::Variable(id),
        }
    }

    /// The time of a part, which stands in a place for times.
    fn time(&mut self, place: usize, part: &Part, span: Span) -> Option<DelayTime> {
        match part {
            Part::Time(time) if time.ms >= 0 => return Some(*time),
            Part::Time(DelayTime { constant, .. }) => {
                let name = constant.map_or("it", |id| self.context.variables[id].name.as_str());
                let message = format!("a delay cannot be negative, as `{name}` is");
                self.report(place, Diagnostic::new(Code::E0210, span, message));
            }
            Part::Variable(id) => {
                let variable = &self.context.variables[*id];
                let message = format!("`{}` is not constant, and a delay is", variable.name);
                let diagnostic = Diagnostic::new(Code::E0209, span, message)
                    .also(variable.span, "declared here")
                    .note("a delay is a duration or a constant of type `time`")
                    .help(format!("compare a duration with it, as in `[T1 >= {}]`", variable.name));
                self.report(place, diagnostic);
            }
            Part::Faulty | Part::Other => {}
        }
        None
    }

    /// The error on parts in the wrong places.
    fn misplaced(&self, span: Span, kinds: &[Part], parts: &[ast::ExprId]) -> Diagnostic {
        if let Some(diagnostic) = self.path_notation(span, parts) {
            return diagnostic;
        }
        let times = kinds.iter().filter(|part| !matches!(part, Part::Other)).count();
        let message = match times {
            0 => "there is no time before or after the `/`",
            _ if times == kinds.len() => "there is nothing here that is delayed",
            _ => "the time before or after the `/` is missing",
        };
        Diagnostic::new(Code::E0209, span, message)
            .note("IEC 60848, symbols 17 and 18: `3s/a/7s` delays by 3 s on and 7 s off, `3s/a` on alone, `a/7s` off alone")
            .note("a delay is a duration or a constant of type `time`")
    }

    /// `X4/X25/X12`, `X9/G4`: where in the hierarchy something is. As a condition, its last part says as much.
    fn path_notation(&self, span: Span, parts: &[ast::ExprId]) -> Option<Diagnostic> {
        let scope = self.context.scope;
        let names: Option<Vec<&str>> = parts
            .iter()
            .map(|&part| match &self.context.tree[part].kind {
                ast::ExprKind::Name(name) => Some(name.as_str()),
                _ => None,
            })
            .collect();
        let names = names?;
        let (last, path) = names.split_last()?;
        let is_activity = |name: &str| matches!(scope.reference(name), Some(Reference::Activity(_)));
        let meant = match scope.label(last) {
            Some(Label::Grafcet(_)) => format!("X{last}"),
            Some(Label::Step(_) | Label::Macro(_)) | None if is_activity(last) => (*last).to_owned(),
            Some(Label::Step(_) | Label::Macro(_)) | None => return None,
        };
        path.iter().all(|name| is_activity(name)).then(|| {
            Diagnostic::new(
                Code::E0209,
                span,
                "a path is not a condition, and there is no time before or after the `/`",
            )
            .note("a step is active only while the steps that enclose it are")
            .help(format!("write `{meant}`"))
            .fix(name_instead(span, &meant))
        })
    }
}
