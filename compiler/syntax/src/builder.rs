//! What the grammar's actions do: they make tree nodes, and find the faults that a grammar says badly.

use crate::ast::*;
use crate::automaton::AUTOMATON;
use crate::faults::MOST_FAULTS;
use crate::format;
use crate::habits::words::{TYPES, ours};
use crate::numeral::{self, Numeral};
use crate::spelling::distance;
use grafc_diagnostics::{Code, Diagnostic, FileId, Fix, Span};

/// The largest bound on micro-steps: what 31 bits hold.
const LARGEST_BOUND: u32 = i32::MAX as u32;

/// What one item of the token stream turned out to be.
pub(crate) enum Parsed {
    /// `chart Name`
    Heading(Box<Heading>),
    /// `grafcet G1 {`: its items follow.
    Grafcet(Box<Grafcet>),
    /// `expansion M3 {`: its items follow.
    Expansion(Box<Expansion>),
    /// A whole item.
    Item(Item),
}

// So that a list of the one becomes a list of the other where it is.
const _: () = assert!(size_of::<Parsed>() == size_of::<Item>());

impl Parsed {
    /// The item, if it opens no block.
    pub(crate) fn plain(self) -> Option<Item> {
        match self {
            Parsed::Item(item) => Some(item),
            Parsed::Heading(_) | Parsed::Grafcet(_) | Parsed::Expansion(_) => None,
        }
    }
}

/// Adds an action to those of a step, if it could be read. Most steps have one, and lists grow by four.
pub(crate) fn add_action(actions: &mut Vec<Action>, action: Option<Action>) {
    if actions.is_empty() {
        *actions = Vec::with_capacity(1);
    }
    actions.extend(action);
}

/// What is under construction, and the faults found so far.
pub(crate) struct Builder<'text> {
    pub(crate) file: FileId,
    pub(crate) text: &'text str,
    pub(crate) exprs: Exprs,
    /// The items that were read and have not been put into place yet.
    pub(crate) parsed: Vec<Parsed>,
    /// What is read again after a fault has been reported: no further messages about it.
    pub(crate) is_silent: bool,
    /// The faults in the item under way: they do not count if it cannot be read.
    pending: Vec<Diagnostic>,
    /// How many expressions there were when the item before had been read.
    kept: usize,
    listed: Vec<Diagnostic>,
    unlisted: usize,
}

impl<'text> Builder<'text> {
    pub(crate) fn new(file: FileId, text: &'text str) -> Self {
        Builder {
            file,
            text,
            exprs: Exprs::new(),
            parsed: Vec::new(),
            is_silent: false,
            pending: Vec::new(),
            kept: 0,
            listed: Vec::new(),
            unlisted: 0,
        }
    }

    /// An item has few faults of this kind, or it is no chart; the number that is kept is bounded.
    fn fault(&mut self, fault: Diagnostic) {
        if self.pending.len() < MOST_FAULTS {
            self.pending.push(fault);
        }
    }

    /// Lists a fault, if there are not too many.
    pub(crate) fn list(&mut self, fault: Diagnostic) {
        if self.listed.len() < MOST_FAULTS {
            self.listed.push(fault);
        } else {
            self.unlisted += 1;
        }
    }

    /// Whether faults are no longer listed.
    pub(crate) fn is_full(&self) -> bool {
        self.unlisted > 0
    }

    /// The faults that were listed; the last says how many were not.
    pub(crate) fn listed(&mut self) -> Vec<Diagnostic> {
        let mut listed = std::mem::take(&mut self.listed);
        if let Some(last) = listed.last_mut().filter(|_| self.unlisted > 0) {
            last.notes.push(format!("there are {} more syntax errors", self.unlisted));
        }
        listed
    }

    /// An item has been read to its end.
    pub(crate) fn item(&mut self, parsed: Parsed) {
        self.parsed.push(parsed);
        self.kept = self.exprs.len();
        let found = std::mem::take(&mut self.pending);
        if !self.is_silent {
            found.into_iter().for_each(|fault| self.list(fault));
        }
    }

    /// Forgets an item that could not be read, and all since there were so many expressions.
    pub(crate) fn discard(&mut self, exprs: usize) {
        self.exprs.truncate(exprs);
        self.parsed.clear();
        self.pending.clear();
    }

    /// Forgets an item that could not be read; those before it stay.
    pub(crate) fn discard_item(&mut self) {
        self.discard(self.kept);
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
        Name { text: text.into(), quoted, span: self.span(start, end) }
    }

    pub(crate) fn text(&self, start: u32, end: u32) -> Text {
        let written = self.slice(start, end);
        let inner = written.strip_prefix('"').unwrap_or(written);
        let inner = inner.strip_suffix('"').unwrap_or(inner);
        let text = if inner.contains('"') { inner.replace("\"\"", "\"").into() } else { inner.into() };
        Text { text, span: self.span(start, end) }
    }

    pub(crate) fn address(&self, start: u32, end: u32) -> Text {
        Text { text: self.slice(start, end).into(), span: self.span(start, end) }
    }

    pub(crate) fn ty(&mut self, start: u32, end: u32) -> (Option<Type>, Span) {
        let word = self.slice(start, end);
        let span = self.span(start, end);
        if let Some(ty) = type_of(word) {
            return (Some(ty), span);
        }
        let shown = crate::shown::shorten(word);
        let mut fault = Diagnostic::new(Code::E0107, span, format!("expected a type, found `{shown}`"))
            .note("the types are `bool`, `int`, `dint`, `uint`, `udint`, `real`, `lreal` and `time`");
        let lower = word.to_lowercase();
        fault = match TYPES.iter().map(|(known, _)| *known).find(|known| *known == lower).or_else(|| ours(TYPES, word))
        {
            Some(known) => {
                let fix = Fix::certain(format!("write `{known}`")).replace(span, known);
                fault.help(format!("write `{known}`")).fix(fix)
            }
            None => match TYPES.iter().find(|(known, _)| distance(&lower, known, 1).is_some()) {
                Some((near, _)) => {
                    let fix = Fix::maybe(format!("write `{near}`")).replace(span, *near);
                    fault.help(format!("did you mean `{near}`?")).fix(fix)
                }
                None => fault.help("choose one of these: a text, an array or a structure has no place in a chart"),
            },
        };
        self.fault(fault);
        (None, span)
    }

    /// The heading, with each choice once.
    /// The head of a grafcet, or of an automaton, which its first word tells.
    pub(crate) fn grafcet(
        &self,
        start: u32,
        end: u32,
        (path, name): (Vec<Name>, Name),
        comment: Option<Box<Text>>,
    ) -> Grafcet {
        let automaton = self.slice(start, end).starts_with(AUTOMATON);
        Grafcet { automaton, path, name, parent: None, comment, items: Vec::new(), span: self.span(start, end) }
    }

    pub(crate) fn heading(
        &mut self,
        start: u32,
        end: u32,
        name: Name,
        comment: Option<Box<Text>>,
        chosen: Vec<Option<ChartOption>>,
    ) -> Heading {
        let mut options: Vec<ChartOption> = Vec::new();
        for option in chosen.into_iter().flatten() {
            let word = option.kind.word();
            match options.iter().find(|first| first.kind.word() == word) {
                Some(first) => {
                    let fault = Diagnostic::new(Code::E0107, option.span, format!("`{word}` appears twice"));
                    // With the blanks before it.
                    let before = self.slice(0, option.span.start).trim_end().len();
                    let whole = Span { start: u32::try_from(before).unwrap_or(option.span.start), ..option.span };
                    let fix = Fix::maybe("leave it out").delete(whole);
                    let fault = fault.also(first.span, "first here").help("leave one of the two out").fix(fix);
                    self.fault(fault);
                }
                None => options.push(option),
            }
        }
        Heading { name, comment, options, span: self.span(start, end) }
    }

    /// `evolution stable`, `evolution scan`
    pub(crate) fn evolution(&mut self, start: u32, end: u32, value: Name) -> Option<ChartOption> {
        let scan = self.one_of(&value, ["stable", "scan"])? == 1;
        Some(ChartOption { kind: ChartOptionKind::Evolution { scan }, span: self.span(start, end) })
    }

    /// `initial_actions on`, `initial_actions off`
    pub(crate) fn initial_actions(&mut self, start: u32, end: u32, value: Name) -> Option<ChartOption> {
        let on = self.one_of(&value, ["off", "on"])? == 1;
        Some(ChartOption { kind: ChartOptionKind::InitialActions(on), span: self.span(start, end) })
    }

    /// `bound 400`
    pub(crate) fn bound(&mut self, start: u32, end: u32, value: Span) -> Option<ChartOption> {
        let number = match numeral::read(self.slice(value.start, value.end)) {
            Ok(Numeral::Integer(number)) => u32::try_from(number).ok(),
            Ok(Numeral::Real(_) | Numeral::Duration(_)) | Err(_) => None,
        };
        match number.filter(|number| (1..=LARGEST_BOUND).contains(number)) {
            Some(number) => Some(ChartOption { kind: ChartOptionKind::Bound(number), span: self.span(start, end) }),
            None => {
                let message = format!("a bound is a number from 1 to {LARGEST_BOUND}");
                self.fault(Diagnostic::new(Code::E0107, value, message).help("write `bound 200`, or leave it out"));
                None
            }
        }
    }

    /// Which of two words it is.
    fn one_of(&mut self, value: &Name, words: [&str; 2]) -> Option<usize> {
        let found = words.iter().position(|word| !value.quoted && value.text == *word);
        if found.is_none() {
            let (shown, [a, b]) = (crate::shown::shorten(&value.text), words);
            let mut fault =
                Diagnostic::new(Code::E0107, value.span, format!("expected `{a}` or `{b}`, found `{shown}`"))
                    .help(format!("write `{a}` or `{b}`"));
            for word in words {
                fault = fault.fix(Fix::maybe(format!("write `{word}`")).replace(value.span, word));
            }
            self.fault(fault);
        }
        found
    }

    pub(crate) fn step(
        &mut self,
        start: u32,
        end: u32,
        words: Vec<StepWord>,
        label: Name,
        comment: Option<Box<Text>>,
        inside: (Vec<Action>, Vec<Allow>),
    ) -> Step {
        let (actions, allows) = inside;
        let mut seen: Vec<StepWord> = Vec::with_capacity(words.len());
        let mut kind = StepKind::Plain;
        for word in words {
            if let Some(first) = seen.iter().find(|s| s.meaning == word.meaning) {
                let name = self.slice(word.span.start, word.span.end);
                let fault = Diagnostic::new(Code::E0107, word.span, format!("`{name}` appears twice before `step`"))
                    .also(first.span, "first here")
                    .help("leave it out")
                    .fix(Fix::certain("leave it out").delete(word.span));
                self.fault(fault);
                continue;
            }
            seen.push(word);
            let new_kind = match word.meaning {
                StepMark::Initial | StepMark::Activated => continue,
                StepMark::Enclosing => StepKind::Enclosing,
                StepMark::Macro => StepKind::Macro,
            };
            if kind != StepKind::Plain {
                let message = "a step is either an enclosing step or a macro-step";
                let help = format!("leave out `{}`", self.slice(word.span.start, word.span.end));
                let fix = Fix::maybe(help.clone()).delete(word.span);
                self.fault(Diagnostic::new(Code::E0107, word.span, message).help(help).fix(fix));
            }
            kind = new_kind;
        }
        let actions = self.without_if_and_then(actions).into();
        Step { kind, words: seen.into(), label, comment, actions, allows: allows.into(), span: self.span(start, end) }
    }

    /// That nothing is said of the reason helps nobody.
    pub(crate) fn allow(&mut self, start: u32, end: u32, code: Name, about: Option<Name>, reason: Text) -> Allow {
        if reason.text.trim().is_empty() {
            let fault = Diagnostic::new(Code::E0107, reason.span, "the reason is empty");
            self.fault(fault.help("say why the warning may be there, for those who read the chart after you"));
        }
        Allow { code, about, reason, span: self.span(start, end) }
    }

    /// A claim, of which the places of its keyword and of its body are given.
    pub(crate) fn claim(
        &mut self,
        (start, keyword_end): (u32, u32),
        (body_start, end): (u32, u32),
        kind: ClaimKind,
        text: Option<Box<Text>>,
        body: ClaimBody,
    ) -> Claim {
        let keyword = self.span(start, keyword_end);
        let form = match body {
            ClaimBody::After(..) => Some("after …"),
            ClaimBody::Leads(..) => Some("… leads to …"),
            ClaimBody::Condition(_) | ClaimBody::AtMostOne(_) => None,
        };
        if let Some(form) = form.filter(|_| kind != ClaimKind::Assert) {
            let message = format!("`{form}` can be asserted only");
            let fault = Diagnostic::new(Code::E0107, keyword, message).help("write `assert`");
            self.fault(fault.fix(Fix::maybe("write `assert`").replace(keyword, "assert")));
        }
        if let ClaimBody::AtMostOne(conditions) = &body
            && conditions.len() == 1
        {
            let place = self.span(body_start, end);
            let fault = Diagnostic::new(Code::E0107, place, "`at most one of` has one condition only");
            self.fault(fault.help("name the others, separated by commas"));
        }
        if let Some(text) = text.as_ref().filter(|text| text.text.trim().is_empty()) {
            let fault = Diagnostic::new(Code::E0107, text.span, "the text of the claim is empty");
            self.fault(fault.help("write what is claimed, or leave out the text and its colon"));
        }
        let written = format::on_one_line(self.slice(body_start, end));
        Claim { kind, text, body, written, keyword, span: self.span(start, end) }
    }

    /// `IF a THEN K` is read as four actions, since none of its words is ours.
    fn without_if_and_then(&mut self, mut actions: Vec<Action>) -> Vec<Action> {
        let word = |action: &Action, word: &str| match &action.kind {
            ActionKind::Continuous { target, condition: None } => {
                !target.quoted && target.text.eq_ignore_ascii_case(word)
            }
            _ => false,
        };
        let Some(first) = actions.iter().position(|action| word(action, "if")) else { return actions };
        let Some(then) = actions[first..].iter().position(|action| word(action, "then")) else { return actions };
        let (condition, target) = match &actions[first..][..then.max(1)] {
            [_, condition @ ..] if !condition.is_empty() => (condition, actions.get(first + then + 1)),
            _ => return actions,
        };
        let place = actions[first].span;
        let shown = self.slice(place.start, place.end);
        let mut fault = Diagnostic::new(Code::E0107, place, format!("expected an action, found `{shown}`"));
        let condition = condition[0].span.to(condition[condition.len() - 1].span);
        fault = match target.map(|target| &target.kind) {
            Some(ActionKind::Continuous { target, condition: None }) => {
                let after = actions.get(first + then + 2).filter(|after| word(after, "end_if"));
                let whole = place.to(after.map_or(target.span, |after| after.span));
                let right = format!("{} if {}", target.text, self.slice(condition.start, condition.end));
                fault.help(format!("write `{right}`")).fix(Fix::maybe(format!("write `{right}`")).replace(whole, right))
            }
            Some(ActionKind::Stored { assignment, .. }) => {
                let assignment = self.slice(assignment.span.start, assignment.span.end);
                let asked = self.slice(condition.start, condition.end);
                fault.help(format!("write `{assignment} on event ↑({asked})`"))
            }
            Some(ActionKind::Force { .. } | ActionKind::Run { .. } | ActionKind::Pulse { .. }) => {
                fault.help("an order has no condition: it holds while its step is active, so give it a step of its own")
            }
            Some(ActionKind::Continuous { condition: Some(_), .. }) | None => {
                fault.help("the condition stands behind the output: `… if …`")
            }
        };
        self.fault(fault);
        actions.truncate(first);
        actions
    }

    pub(crate) fn action(&self, start: u32, end: u32, kind: ActionKind) -> Option<Action> {
        Some(Action { kind, span: self.span(start, end) })
    }

    /// In a step, the standard has no action that assigns without saying when (4.8.3).
    pub(crate) fn assignment_without_event(&mut self, assignment: Assignment) -> Option<Action> {
        let target = crate::shown::shorten(&assignment.target.text);
        let end = assignment.span.end as usize;
        let gap = self.text[end..].len() - self.text[end..].trim_start().len();
        let word = self.text[end + gap..].split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
        if word != "on" && word.eq_ignore_ascii_case("on") {
            let place = self.span((end + gap) as u32, (end + gap + word.len()) as u32);
            let fault = Diagnostic::new(Code::E0107, place, format!("expected `on`, found `{word}`"));
            let help = "words of the language are in lower case: `on`";
            self.fault(fault.help(help).fix(Fix::certain("write `on`").replace(place, "on")));
            return None;
        }
        self.fault(
            Diagnostic::new(
                Code::E0108,
                assignment.span,
                format!("the assignment of `{target}` does not say when it is done"),
            )
            .note("IEC 60848, 4.8.3: a stored action is associated with an event")
            .help("add `on activation`, `on deactivation` or `on event …` after it")
            .fix(Fix::maybe("add `on activation`").replace(assignment.span.behind(), " on activation"))
            .fix(Fix::maybe("add `on deactivation`").replace(assignment.span.behind(), " on deactivation")),
        );
        None
    }

    /// `{INIT}` is the initial situation; a step of that name is written in backquotes.
    pub(crate) fn situation(&self, labels: Names) -> Situation {
        match labels.as_slice() {
            [only] if !only.quoted && only.text == "INIT" => Situation::Initial,
            _ => Situation::Steps(labels.into_vec()),
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

    /// A number or a duration that the lexer has read already.
    pub(crate) fn numeral(&mut self, start: u32, end: u32) -> ExprId {
        let kind = match numeral::read(self.slice(start, end)) {
            Ok(Numeral::Integer(value)) => ExprKind::Integer(value),
            Ok(Numeral::Real(value)) => ExprKind::Real(value),
            Ok(Numeral::Duration(value)) => ExprKind::Duration(value),
            Err(_) => ExprKind::Error,
        };
        self.expr(start, end, kind)
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

    /// `3/a` where `3s/a` was meant, and `5s/1` where `5s/X1` was, are slips that are better named here than as wrong
    /// types.
    pub(crate) fn delay(&mut self, start: u32, end: u32, parts: Vec<ExprId>) -> ExprId {
        let has_time = parts.iter().any(|&part| matches!(self.exprs[part].kind, ExprKind::Duration(_)));
        for &part in &parts {
            let span = self.exprs[part].span;
            let shown = crate::shown::shorten(self.slice(span.start, span.end));
            let (what, cure, fix) = match self.exprs[part].kind {
                ExprKind::Integer(_) if has_time => {
                    let (place, right) =
                        self.counted_time(start, end, &parts, &shown).unwrap_or((span, format!("X{shown}")));
                    let fix = Fix::maybe(format!("write `{right}`")).replace(place, right.as_str());
                    ("number", format!("the activity of step `{shown}` is delayed: `{right}`"), fix)
                }
                ExprKind::Integer(_) | ExprKind::Real(_) => (
                    "number",
                    format!("a delay has a unit: `{shown}s`"),
                    Fix::maybe("give it the unit `s`").replace(span.behind(), "s"),
                ),
                ExprKind::Bool(_) => (
                    "constant",
                    format!("put the operand in parentheses: `({shown})`"),
                    Fix::certain("put it in parentheses").replace(span.before(), "(").replace(span.behind(), ")"),
                ),
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
            self.fault(
                Diagnostic::new(Code::E0107, span, format!("expected a duration or a variable, found the {what} `{shown}`"))
                    .note("outside brackets, `/` makes a time-dependent variable such as `3s/a/7s`; division stands in brackets")
                    .help(cure)
                    .fix(fix),
            );
            self.exprs[part].kind = ExprKind::Error;
        }
        self.expr(start, end, ExprKind::Delay(parts.into()))
    }

    /// `t/1/5s`: as the first edition of the standard wrote that step 1 has been active for 5 s.
    fn counted_time(&self, start: u32, end: u32, parts: &[ExprId], step: &str) -> Option<(Span, String)> {
        let &[letter, _, time] = parts else { return None };
        let ExprKind::Name(letter) = &self.exprs[letter].kind else { return None };
        let time = self.exprs[time].span;
        (letter == "t").then(|| (self.span(start, end), format!("{}/X{step}", self.slice(time.start, time.end))))
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
