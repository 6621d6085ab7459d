//! The time operator: `3s/a/7s`, `4s/X27`, `X2/5s` (IEC 60848, symbols 17 and 18).
//!
//! Its times are durations or constants of type `time`, so they are known here already.

use super::Work;
use crate::chart::{DelayTime, Type, Value, VariableId, VariableKind};
use crate::fixes::name_instead;
use crate::resolve::scope::{Label, Reference};
use crate::resolve::types;
use grafc_diagnostics::{Code, Diagnostic, Fix, Span};
use grafc_syntax::ast;
use grafc_syntax::spelling::written;

const NO_DELAY: DelayTime = DelayTime { ms: 0, constant: None };

/// What stands between slashes.
enum Part {
    /// A time, known.
    Time(DelayTime),
    /// A constant of type `time` whose value is wrong, or a hole; reported elsewhere.
    Faulty,
    /// Of type `time`, but no constant.
    Variable(VariableId),
    /// A variable whose type could not be read.
    Unknown,
    /// Anything else: the operand, if it stands in the right place.
    Other,
}

impl Work<'_, '_, '_> {
    /// Reads the parts of a delay; gives back its operand, unless the delay is faulty.
    pub(super) fn read_delay(&mut self, place: usize, parts: &[ast::ExprId]) -> Option<ast::ExprId> {
        let span = self.written(place).span;
        let kinds: Vec<Part> = parts.iter().map(|&part| self.part(part)).collect();
        if kinds.iter().any(|part| matches!(part, Part::Unknown)) {
            parts.iter().for_each(|&part| self.note(part));
            self.nodes[place].faulty = true;
            return None;
        }
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
        let on = self.time(place, on, span, operand);
        let off = self.time(place, off, span, operand);
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
                Some(Reference::Variable(id)) if self.context.scope.is_typed(id) => self.variable(id),
                // It may have been meant as a time, or as what is delayed.
                Some(Reference::Variable(_)) => Part::Unknown,
                Some(Reference::Activity(_) | Reference::Duration(_) | Reference::Frozen(_)) | None => Part::Other,
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
        match (variable.kind, self.context.constants.get(&id)) {
            (VariableKind::Constant, Some(Value::Time(ms))) => Part::Time(DelayTime { ms: *ms, constant: Some(id) }),
            (VariableKind::Constant, _) => Part::Faulty,
            (VariableKind::Input | VariableKind::Output | VariableKind::Internal, _) => Part::Variable(id),
        }
    }

    /// The time of a part, which stands in a place for times.
    fn time(&mut self, place: usize, part: &Part, span: Span, operand: ast::ExprId) -> Option<DelayTime> {
        match part {
            Part::Time(time) if time.ms >= 0 => return Some(*time),
            Part::Time(DelayTime { constant, .. }) => {
                let name = constant.map_or("it", |id| self.context.variables[id].name.as_str());
                let message = format!("a delay cannot be negative, as `{name}` is");
                let help = format!("give `{name}` a value that is not");
                self.report(place, Diagnostic::new(Code::E0210, span, message).help(help));
            }
            Part::Variable(id) => {
                let variable = &self.context.variables[*id];
                let message = format!("`{}` is not constant, and a delay is", variable.name);
                let diagnostic = Diagnostic::new(Code::E0209, span, message)
                    .also(variable.span, "declared here")
                    .note("a delay is a duration or a constant of type `time`");
                let diagnostic = self.with_comparison(diagnostic, span, operand, &variable.name);
                self.report(place, diagnostic);
            }
            Part::Faulty | Part::Unknown | Part::Other => {}
        }
        None
    }

    /// What helps where a time is not constant: of a step, its duration can be compared with it.
    fn with_comparison(&self, diagnostic: Diagnostic, span: Span, operand: ast::ExprId, time: &str) -> Diagnostic {
        let operand = &self.context.tree[operand];
        let step = if let ast::ExprKind::Name(name) = &operand.kind
            && let Some(Reference::Activity(Label::Step(_))) = self.context.scope.reference(name)
        {
            name.strip_prefix('X')
        } else {
            None
        };
        let Some(step) = step else {
            return diagnostic.help(format!("declare it as a constant, `const {time} : time := …`"));
        };
        let comparison = format!("[{} >= {}]", written(&format!("T{step}")), written(time));
        let diagnostic = diagnostic.help(format!("compare the duration of the step with it: `{comparison}`"));
        match span.start < operand.span.start && span.end == operand.span.end {
            true => diagnostic.fix(Fix::maybe(format!("write `{comparison}`")).replace(span, comparison)),
            false => diagnostic,
        }
    }

    /// The error on parts in the wrong places.
    fn misplaced(&self, span: Span, kinds: &[Part], parts: &[ast::ExprId]) -> Diagnostic {
        if let Some(diagnostic) = self.path_notation(span, parts) {
            return diagnostic;
        }
        if let Some(diagnostic) = self.counted_time(span, kinds, parts) {
            return diagnostic;
        }
        let times = kinds.iter().filter(|part| !matches!(part, Part::Other)).count();
        let written: Vec<&str> = parts.iter().map(|&part| self.spelling(part)).collect();
        let operand = kinds.iter().position(|part| matches!(part, Part::Other)).map_or("…", |at| written[at]);
        let (message, help) = match times {
            0 => (
                "there is no time before or after the `/`",
                format!("say how long: `…/{}`", written[written.len() - 1]),
            ),
            _ if times == kinds.len() => {
                ("there is nothing here that is delayed", format!("say what is delayed, as in `{}/…`", written[0]))
            }
            _ => ("the time before or after the `/` is missing", format!("say both times: `…/{operand}/…`")),
        };
        let diagnostic = Diagnostic::new(Code::E0209, span, message).note(
            "IEC 60848, symbols 17 and 18: `3s/a/7s` delays by 3 s on and 7 s off, `3s/a` on alone, `a/7s` off alone",
        );
        let number = parts.iter().find_map(|&part| {
            let ast::ExprKind::Name(name) = &self.context.tree[part].kind else { return None };
            match self.context.scope.reference(name)? {
                Reference::Variable(id) if types::is_number(self.context.variables[id].ty) => Some(id),
                Reference::Variable(_) | Reference::Activity(_) | Reference::Duration(_) | Reference::Frozen(_) => None,
            }
        });
        match number.map(|id| &self.context.variables[id]) {
            Some(number) => {
                diagnostic.also(number.span, format!("this is `{}`, not a time", types::name(number.ty))).help(format!(
                    "a delay is a duration or a constant of type `time`: `const {} : time := …`",
                    number.name
                ))
            }
            None => diagnostic.note("a delay is a duration or a constant of type `time`").help(help),
        }
    }

    /// A part as it is written, if it is one word.
    fn spelling(&self, part: ast::ExprId) -> &str {
        if let ast::ExprKind::Name(name) = &self.context.tree[part].kind { name } else { "…" }
    }

    /// `t/X1/5s`: as the first edition of the standard wrote that step 1 has been active for 5 s.
    fn counted_time(&self, span: Span, kinds: &[Part], parts: &[ast::ExprId]) -> Option<Diagnostic> {
        let ([Part::Other, Part::Other, Part::Time(time)], &[letter, operand, _]) = (kinds, parts) else { return None };
        let (ast::ExprKind::Name(letter), ast::ExprKind::Name(operand)) =
            (&self.context.tree[letter].kind, &self.context.tree[operand].kind)
        else {
            return None;
        };
        let is_unknown = letter == "t" && self.context.scope.reference(letter).is_none();
        let time = match time.constant {
            Some(id) => self.context.variables[id].name.to_string(),
            None => same_duration(time.ms),
        };
        is_unknown.then(|| {
            let right = format!("{time}/{operand}");
            Diagnostic::new(Code::E0209, span, "there is no time before the first `/`")
                .note("the first edition of IEC 60848 wrote `t/…/5s`; since the second, the time stands in front")
                .help(format!("write `{right}`"))
                .fix(Fix::maybe(format!("write `{right}`")).replace(span, right))
        })
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

/// A duration in one unit.
fn same_duration(ms: i64) -> String {
    if ms % 1000 == 0 { format!("{}s", ms / 1000) } else { format!("{ms}ms") }
}
