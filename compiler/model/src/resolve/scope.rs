//! What names mean: declared variables, labels, and the implicit variables that labels bring.
//!
//! Names are case-sensitive here and not on IEC targets, so two names that differ only by case are refused (E0203); of
//! two equal ones the first keeps the name (E0202), and what an implicit variable is called nobody may declare (E0204).

use super::habits;
use super::names::Names;
use super::parts::Parts;
use super::suggest::Suggestions;
use crate::chart::{GrafcetId, MacroId, Node, StepId, VariableId};
use crate::fixes::name_instead;
use crate::symbols::{Entity, Form};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix, Span};
use grafc_syntax::ast;
use grafc_syntax::spelling::written;
use rustc_hash::FxHashSet;

/// What a label stands for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Label {
    /// A step.
    Step(StepId),
    /// A macro-step.
    Macro(MacroId),
    /// A partial grafcet.
    Grafcet(GrafcetId),
}

/// What a name in an expression stands for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Reference {
    /// A declared variable.
    Variable(VariableId),
    /// `X` and a label.
    Activity(Label),
    /// `T` and a step label.
    Duration(StepId),
    /// `F` and the name of a grafcet that pulse orders are given to.
    Frozen(GrafcetId),
}

impl Reference {
    /// What it refers to, and how the name of that is part of it.
    pub fn entity(self) -> (Entity, Form) {
        match self {
            Reference::Variable(id) => (Entity::Variable(id), Form::Name),
            Reference::Activity(label) => (label.into(), Form::Activity),
            Reference::Duration(step) => (Entity::Step(step), Form::Duration),
            Reference::Frozen(grafcet) => (Entity::Grafcet(grafcet), Form::Frozen),
        }
    }
}

impl From<Label> for Entity {
    fn from(label: Label) -> Self {
        match label {
            Label::Step(id) => Entity::Step(id),
            Label::Macro(id) => Entity::Macro(id),
            Label::Grafcet(id) => Entity::Grafcet(id),
        }
    }
}

/// The names of what pulse orders are given to.
fn commanded<'a>(parts: &Parts<'a>) -> FxHashSet<&'a str> {
    let mut names = FxHashSet::default();
    for action in parts.steps.iter().flat_map(|part| &part.ast.actions) {
        match &action.kind {
            ast::ActionKind::Pulse { grafcet, .. } | ast::ActionKind::Run { grafcet } => {
                _ = names.insert(&*grafcet.text)
            }
            ast::ActionKind::Continuous { .. } | ast::ActionKind::Stored { .. } | ast::ActionKind::Force { .. } => {}
        }
    }
    names.extend(parts.transitions.iter().flat_map(|part| part.ast.pulses()).map(|pulse| &*pulse.grafcet.text));
    names
}

/// So many labels are listed beside one that is missing.
const NEIGHBOURS: usize = 4;

/// The name of a grafcet in a file without grafcet blocks.
pub const IMPLIED_GRAFCET: &str = "G1";

/// Who has which name.
pub struct Scope<'a> {
    variables: Names<'a, VariableId>,
    labels: Names<'a, Label>,
    /// The variables whose types could not be read.
    untyped: FxHashSet<VariableId>,
    /// The labels that were given twice (E0202): who names one may mean another than the first.
    ambiguous: FxHashSet<&'a str>,
    /// The names that pulse orders give.
    commanded: FxHashSet<&'a str>,
    suggestions: Suggestions,
}

impl<'a> Scope<'a> {
    /// The names of a chart. Variables have their places in the declarations as ids.
    pub fn declare(parts: &Parts<'a>, diagnostics: &mut Diagnostics) -> Self {
        let mut scope = Scope {
            variables: Names::with_capacity(0),
            labels: Names::with_capacity(0),
            untyped: FxHashSet::default(),
            ambiguous: FxHashSet::default(),
            commanded: commanded(parts),
            suggestions: Suggestions::new(),
        };
        let suspects = scope.declare_variables(parts, diagnostics);
        scope.declare_labels(parts, &suspects, diagnostics);
        scope
    }

    /// Enters the variables; returns those that may be called as an implicit variable is.
    fn declare_variables(&mut self, parts: &Parts<'a>, diagnostics: &mut Diagnostics) -> Vec<&'a ast::Name> {
        let count = parts.declarations.iter().map(|declaration| declaration.names.len()).sum();
        let mut first_of: Names<'a, Span, true> = Names::with_capacity(count);
        self.variables = Names::with_capacity(count);
        let mut suspects = Vec::new();
        let names = parts.declarations.iter().flat_map(|item| item.names.iter().map(|name| (item.ty, name)));
        for (index, (ty, declared)) in names.enumerate() {
            let name = &declared.name;
            if ty.is_none() {
                self.untyped.insert(VariableId::new(index));
            }
            match first_of.enter(&name.text, name.span) {
                Some((first, span)) if *first == name.text => diagnostics.push(
                    Diagnostic::new(Code::E0202, name.span, format!("`{}` is declared twice", name.text))
                        .also(*span, "first declared here")
                        .help("leave one of them out, or give it another name"),
                ),
                Some((first, span)) => diagnostics.push(differ_by_case(name, first, *span)),
                None if name.text.starts_with(['X', 'x', 'T', 't']) => suspects.push(name),
                None => {}
            }
            self.variables.enter(&name.text, VariableId::new(index));
        }
        suspects
    }

    /// Enters the labels; `suspects` are variables that may be called as their implicit variables are.
    fn declare_labels(&mut self, parts: &Parts<'a>, suspects: &[&ast::Name], diagnostics: &mut Diagnostics) {
        let count = parts.grafcets.len() + parts.steps.len();
        let mut first_of: Names<'a, (Label, Span), true> = Names::with_capacity(count);
        self.labels = Names::with_capacity(count);
        for (text, label, span) in labels(parts) {
            match first_of.enter(text, (label, span)) {
                Some((first, (earlier, first_span))) if *first == text => {
                    self.ambiguous.insert(text);
                    if let Some(diagnostic) = declared_twice(parts, text, label, span, *earlier, *first_span) {
                        diagnostics.push(diagnostic);
                    }
                    continue;
                }
                Some((first, (_, first_span))) => {
                    let name = ast::Name { text: text.into(), quoted: false, span };
                    diagnostics.push(differ_by_case(&name, first, *first_span));
                }
                None => {}
            }
            self.labels.enter(text, label);
        }
        for name in suspects {
            let (letter, rest) = name.text.split_at(1);
            let Some(&(text, (label, span))) = first_of.get(rest) else { continue };
            let (prefix, what) = match (letter, label) {
                ("X" | "x", _) => ("X", "activity"),
                (_, Label::Step(_)) => ("T", "duration"),
                (_, Label::Macro(_) | Label::Grafcet(_)) => continue,
            };
            let owner = format!("{} `{text}`", kind(label));
            diagnostics.push(taken(name, &format!("{prefix}{text}"), what, &owner, span));
        }
    }

    /// What a label stands for.
    pub fn label(&self, text: &str) -> Option<Label> {
        self.labels.get(text).map(|&(_, label)| label)
    }

    /// The step or macro-step of a label.
    pub fn node(&self, text: &str) -> Option<Node> {
        match self.label(text)? {
            Label::Step(step) => Some(Node::Step(step)),
            Label::Macro(macro_step) => Some(Node::Macro(macro_step)),
            Label::Grafcet(_) => None,
        }
    }

    /// Whether the type of a variable is known; if not, that has been reported, and whatever is done with the variable
    /// may be right.
    pub fn is_typed(&self, variable: VariableId) -> bool {
        !self.untyped.contains(&variable)
    }

    /// Whether the label was given twice, so that rules on what it stands for had better keep silent.
    pub fn is_ambiguous(&self, text: &str) -> bool {
        self.ambiguous.contains(text)
    }

    /// What a name in an expression stands for.
    pub fn reference(&self, text: &str) -> Option<Reference> {
        if let Some(&(_, variable)) = self.variables.get(text) {
            return Some(Reference::Variable(variable));
        }
        if let Some(label) = text.strip_prefix('X').and_then(|rest| self.label(rest)) {
            return Some(Reference::Activity(label));
        }
        match text.strip_prefix('T').and_then(|rest| self.label(rest)) {
            Some(Label::Step(step)) => Some(Reference::Duration(step)),
            Some(Label::Macro(_) | Label::Grafcet(_)) | None => {
                let rest = text.strip_prefix('F').filter(|rest| self.commanded.contains(rest))?;
                match self.label(rest)? {
                    Label::Grafcet(grafcet) => Some(Reference::Frozen(grafcet)),
                    Label::Step(_) | Label::Macro(_) => None,
                }
            }
        }
    }

    /// The error on a name that means nothing in an expression.
    pub fn unknown_name(&self, text: &str, span: Span) -> Diagnostic {
        self.unknown(text, span, "input")
    }

    /// The error on a name that means nothing, and is assigned to.
    pub fn unknown_target(&self, text: &str, span: Span) -> Diagnostic {
        self.unknown(text, span, "output")
    }

    /// `word` declares it.
    fn unknown(&self, text: &str, span: Span, word: &str) -> Diagnostic {
        let diagnostic = Diagnostic::new(Code::E0201, span, format!("nothing is called `{text}`"));
        match text.strip_prefix('T').and_then(|rest| self.label(rest)) {
            Some(label @ (Label::Macro(_) | Label::Grafcet(_))) => {
                return diagnostic
                    .note(format!("a {} has no duration, only its steps have", kind(label)))
                    .help("write the duration of a step, `T…`");
            }
            Some(Label::Step(_)) | None => {}
        }
        if let Some(label) = self.label(text) {
            let what = kind(label);
            return diagnostic
                .help(format!("the activity of the {what} `{text}` is written `X{text}`"))
                .fix(name_instead(span, &format!("X{text}")));
        }
        if let Some(habit) = habits::name(text, |name| self.reference(name).is_some()) {
            return diagnostic
                .help(habit.words)
                .fix(Fix::maybe(format!("write `{}`", habit.instead)).replace(span, habit.instead));
        }
        if let Some(near) = self.suggestions.nearest(text, self.variables.iter().map(|&(name, _)| name)) {
            return diagnostic.help(format!("did you mean `{near}`?")).fix(name_instead(span, near));
        }
        let declaration = format!("declare it, as in `{word} {} : …`", written(text));
        let implicit = ['X', 'T'].into_iter().find_map(|prefix| Some((prefix, text.strip_prefix(prefix)?)));
        let Some((prefix, rest)) = implicit.filter(|(_, rest)| !rest.is_empty()) else {
            return diagnostic
                .note("every variable is declared: `input`, `output`, `var` or `const`")
                .help(declaration);
        };
        let candidates = self.labels.iter().filter(|(_, label)| prefix == 'X' || matches!(label, Label::Step(_)));
        match self.suggestions.nearest(rest, candidates.map(|&(name, _)| name)) {
            Some(near) => {
                let near = format!("{prefix}{near}");
                diagnostic.help(format!("did you mean `{near}`?")).fix(name_instead(span, &near))
            }
            None => {
                let diagnostic =
                    diagnostic.note(format!("no variable is declared by this name, and no step is labelled `{rest}`"));
                self.with_neighbours(diagnostic, rest).help(declaration)
            }
        }
    }

    /// The error on a label that is none of a step or macro-step.
    pub fn unknown_step(&self, text: &str, span: Span) -> Diagnostic {
        let diagnostic = Diagnostic::new(Code::E0301, span, format!("there is no step `{text}`"));
        if let Some(Label::Grafcet(_)) = self.label(text) {
            return self
                .with_neighbours(diagnostic.note(format!("`{text}` is a grafcet")), text)
                .help("name a step of it");
        }
        if let Some(rest) = text.strip_prefix('X')
            && self.node(rest).is_some()
        {
            return diagnostic.help(format!("a step is named by its label: `{rest}`")).fix(name_instead(span, rest));
        }
        let candidates = self.labels.iter().filter(|(_, label)| !matches!(label, Label::Grafcet(_)));
        let declaration = format!("declare it, as in `step {}`", written(text));
        let diagnostic = self.with_suggestion(diagnostic, text, candidates, declaration);
        if diagnostic.fixes.is_empty() { self.with_neighbours(diagnostic, text) } else { diagnostic }
    }

    /// The error on a name that is none of a grafcet, where a step of the grafcet `own` forces it.
    pub fn unknown_grafcet(&self, text: &str, span: Span, own: Option<GrafcetId>) -> Diagnostic {
        let diagnostic = Diagnostic::new(Code::E0302, span, format!("there is no grafcet `{text}`"));
        let diagnostic = match self.label(text) {
            Some(label @ (Label::Step(_) | Label::Macro(_))) => {
                diagnostic.note(format!("`{text}` is a {}", kind(label)))
            }
            Some(Label::Grafcet(_)) | None => diagnostic,
        };
        let is_meant = |label: &Label| matches!(label, Label::Grafcet(id) if Some(*id) != own);
        let candidates = self.labels.iter().filter(|(_, label)| is_meant(label));
        let declaration = match self.label(text) {
            Some(_) => "name a grafcet, as in `force G2{INIT}`".to_owned(),
            None => format!("a grafcet is a block of its own: `grafcet {} {{ … }}`", written(text)),
        };
        self.with_suggestion(diagnostic, text, candidates, declaration)
    }

    /// Says which labels of steps are near one that is missing: numbers that are not far, else the first of all.
    fn with_neighbours(&self, diagnostic: Diagnostic, text: &str) -> Diagnostic {
        if !self.suggestions.is_patient() {
            return diagnostic;
        }
        let steps = self.labels.iter().filter(|(_, label)| !matches!(label, Label::Grafcet(_)));
        let mut near: Vec<&str> = match text.parse::<u64>() {
            Ok(wanted) => {
                let numbers = steps.filter_map(|(name, _)| Some((name.parse::<u64>().ok()?.abs_diff(wanted), *name)));
                let mut numbers: Vec<(u64, &str)> = numbers.collect();
                numbers.sort_by_key(|&(distance, _)| distance);
                numbers.into_iter().map(|(_, name)| name).take(NEIGHBOURS).collect()
            }
            Err(_) => Vec::new(),
        };
        if near.is_empty() {
            near = self.steps_from_the_first();
        }
        let listed: Vec<String> = near.iter().map(|name| format!("`{name}`")).collect();
        match listed.split_last() {
            None => diagnostic,
            Some((only, [])) => diagnostic.note(format!("the only step near is {only}")),
            Some((last, others)) => diagnostic.note(format!("steps near are {} and {last}", others.join(", "))),
        }
    }

    fn steps_from_the_first(&self) -> Vec<&'a str> {
        let steps = self.labels.iter().filter(|(_, label)| !matches!(label, Label::Grafcet(_)));
        steps.map(|&(name, _)| name).take(NEIGHBOURS).collect()
    }

    fn with_suggestion<'n>(
        &self,
        diagnostic: Diagnostic,
        text: &str,
        candidates: impl Iterator<Item = &'n (&'a str, Label)>,
        otherwise: String,
    ) -> Diagnostic
    where
        'a: 'n,
    {
        match self.suggestions.nearest(text, candidates.map(|&(name, _)| name)) {
            Some(near) => {
                let fix = name_instead(diagnostic.primary.span, near);
                diagnostic.help(format!("did you mean `{near}`?")).fix(fix)
            }
            None => diagnostic.help(otherwise),
        }
    }
}

/// What messages call it.
pub fn kind(label: Label) -> &'static str {
    match label {
        Label::Step(_) => "step",
        Label::Macro(_) => "macro-step",
        Label::Grafcet(_) => "grafcet",
    }
}

/// All labels: grafcets first: where labels collide, the grafcet keeps its name, since it is the larger thing.
fn labels<'a>(parts: &Parts<'a>) -> impl Iterator<Item = (&'a str, Label, Span)> {
    let grafcets = parts.grafcets.iter_enumerated().filter(|(id, _)| !parts.is_stray(*id)).map(|(id, part)| {
        let name = part.ast.map_or(IMPLIED_GRAFCET, |grafcet| grafcet.name.text.as_str());
        (name, Label::Grafcet(id), part.span)
    });
    let steps = parts.steps.iter().map(|part| {
        let label = match part.node {
            Node::Step(step) => Label::Step(step),
            Node::Macro(macro_step) => Label::Macro(macro_step),
        };
        (part.ast.label.text.as_str(), label, part.ast.label.span)
    });
    grafcets.chain(steps)
}

fn differ_by_case(name: &ast::Name, first: &str, first_span: Span) -> Diagnostic {
    Diagnostic::new(Code::E0203, name.span, format!("`{}` and `{first}` differ only by case", name.text))
        .also(first_span, format!("`{first}` is here"))
        .note("IEC 61131-3 does not tell capital letters from small ones: the two would be one name")
        .help("give one of them another name")
}

fn taken(name: &ast::Name, implicit: &str, what: &str, label: &str, label_span: Span) -> Diagnostic {
    let place = format!("the {label} is here");
    if name.text == implicit {
        Diagnostic::new(Code::E0204, name.span, format!("`{implicit}` already names the {what} of {label}"))
            .also(label_span, place)
            .help(format!("give the variable another name than `{}`", name.text))
    } else {
        let message = format!("`{}` and `{implicit}`, the {what} of {label}, differ only by case", name.text);
        Diagnostic::new(Code::E0203, name.span, message)
            .also(label_span, place)
            .note("IEC 61131-3 does not tell capital letters from small ones: the two would be one name")
            .help(format!("give the variable another name than `{}`", name.text))
    }
}

/// The error on a label that has been given before; none if another rule says it better.
fn declared_twice(
    parts: &Parts,
    text: &str,
    label: Label,
    span: Span,
    first: Label,
    first_span: Span,
) -> Option<Diagnostic> {
    if let (Label::Grafcet(a), Label::Grafcet(b)) = (first, label) {
        let path = |id: GrafcetId| parts.grafcets[id].ast.and_then(|grafcet| grafcet.path.last());
        let differ = path(a).zip(path(b)).is_some_and(|(a, b)| a.text != b.text);
        if differ {
            return None; // E0311
        }
    }
    let diagnostic = Diagnostic::new(Code::E0202, span, format!("the label `{text}` is given twice"));
    Some(match first {
        Label::Grafcet(id) if parts.grafcets[id].ast.is_none() => diagnostic
            .note(format!("a file without `grafcet` blocks is one grafcet named `{IMPLIED_GRAFCET}`"))
            .help("give the step another label"),
        Label::Grafcet(_) | Label::Step(_) | Label::Macro(_) => diagnostic
            .also(first_span, format!("here it labels a {}", kind(first)))
            .note("steps, macro-steps and grafcets share their labels, over the whole chart")
            .help("give one of them another label"),
    })
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, breaks_all, help, passes};

    #[test]
    fn names_that_mean_nothing() {
        breaks("E0201", "initial step 1 step 2 transition 1 -> 2 : valve");
        breaks("E0201", "initial step 1 step 2 transition 1 -> 2 : X3");
        breaks("E0201", "initial step 1 { V }");
        breaks("E0301", "input a : bool initial step 1 transition 1 -> 2 : a");
        breaks("E0301", "grafcet G1 { initial step 1 { force G2{3} } } grafcet G2 { step 2 }");
        breaks("E0301", "grafcet G1 { initial step 1 } grafcet X9/G2 { activated step 2 }");
        breaks("E0302", "initial step 1 { force G2{} }");
    }

    #[test]
    fn each_unknown_name_is_reported() {
        breaks_all(&["E0201", "E0201", "E0201"], "initial step 1 transition 1 -> 1 : x and not y or 3s/z");
    }

    #[test]
    fn near_names_are_suggested() {
        let near = |text: &str| help(text).unwrap_or_default();
        assert_eq!(near("input valve : bool initial step 1 transition 1 -> 1 : valev"), "did you mean `valve`?");
        assert_eq!(near("initial step Filling transition Filling -> Filling : XFiling"), "did you mean `XFilling`?");
        assert_eq!(near("initial step Filling transition Filling -> Filing : 1"), "did you mean `Filling`?");
        let block = "a grafcet is a block of its own: `grafcet Mian { … }`";
        assert_eq!(near("initial step 1 { force Mian{} }"), block);
        // A step does not force its own grafcet.
        assert_eq!(near("grafcet Main { initial step 1 { force Mian{} } }"), block);
        let forced = "grafcet Main { initial step 1 } grafcet G2 { initial step 2 { force Mian{} } }";
        assert_eq!(near(forced), "did you mean `Main`?");
        assert_eq!(
            near("initial step Fill transition Fill -> Fill : Fill"),
            "the activity of the step `Fill` is written `XFill`"
        );
        assert_eq!(near("initial step 5 transition 5 -> 5 : 5"), "the activity of step `5` is written `X5`");
        assert_eq!(near("initial step 5 transition X5 -> 5 : 1"), "a step is named by its label: `5`");
    }

    #[test]
    fn what_has_no_duration() {
        breaks("E0201", "grafcet G1 { initial step 1 transition 1 -> 1 : [TG1 > 3s] }");
    }

    #[test]
    fn names_given_twice() {
        breaks("E0202", "input a : bool var a : int initial step 1");
        breaks("E0202", "initial step 1 step 1");
        breaks("E0202", "grafcet G1 { initial step 1 } grafcet G1 { initial step 2 }");
        breaks("E0202", "grafcet G1 { initial step 1 } grafcet G2 { initial step G1 }");
        breaks("E0202", "initial step G1");
    }

    #[test]
    fn a_label_given_twice_breaks_nothing_else() {
        breaks(
            "E0202",
            "input a : bool grafcet G1 { initial step 1 } grafcet G2 { initial step 1 step 2 transition 1 -> 2 : a }",
        );
    }

    #[test]
    fn names_that_differ_by_case() {
        breaks("E0203", "input Valve, valve : bool initial step 1");
        breaks("E0203", "input Ä, ä : bool initial step 1");
        breaks("E0203", "initial step Fill step fill");
        breaks("E0203", "grafcet G1 { initial step 1 } grafcet g1 { initial step 2 }");
        breaks("E0203", "input x1 : bool initial step 1");
    }

    #[test]
    fn names_of_implicit_variables() {
        breaks("E0204", "input X1 : bool initial step 1");
        breaks("E0204", "input T1 : bool initial step 1");
        breaks("E0204", "input XG1 : bool initial step 1");
        breaks("E0204", "input XM3 : bool initial step 1 macro step M3 expansion M3 { step E3 step S3 }");
        passes("input X2, T2, TG1, G2 : bool initial step 1");
    }

    #[test]
    fn a_label_is_no_variable() {
        passes("input Fill : bool initial step Fill step Drain transition Fill -> Drain : Fill and XFill");
    }
}
