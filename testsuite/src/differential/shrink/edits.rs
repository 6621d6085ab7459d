//! The edits that make a chart's text shorter, by the places in its syntax tree.

use grafc_diagnostics::{FileId, Span};
use grafc_syntax::ast::{
    ActionKind, Chart, DeclarationKind, Event, ExprId, ExprKind, Item, Situation, Step, StepKind, Transition,
};
use std::collections::BTreeMap;

/// What is put in the place of what: one place, or several that only go together.
pub(super) struct Edit(Vec<(Span, String)>);

impl Edit {
    /// The text after it.
    pub fn apply(&self, text: &str) -> String {
        let mut text = text.to_string();
        let mut parts: Vec<&(Span, String)> = self.0.iter().collect();
        parts.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
        for (span, with) in parts {
            text.replace_range(span.range(), with);
        }
        text
    }

    /// By how much it shortens a text.
    fn gain(&self) -> usize {
        self.0.iter().map(|(span, with)| span.range().len().saturating_sub(with.len())).sum()
    }
}

/// All edits that make a text shorter, the largest first.
pub(super) fn of(text: &str) -> Vec<Edit> {
    let (chart, diagnostics) = grafc_syntax::parse(FileId::default(), text);
    if diagnostics.has_errors() {
        return Vec::new();
    }
    let mut list: Vec<(Span, String)> = Vec::new();
    list.extend(chart.heading.iter().map(|heading| (heading.span, String::new())));
    let options = chart.heading.iter().flat_map(|heading| &heading.options);
    list.extend(options.map(|option| (option.span, String::new())));
    list.extend(chart.comments.iter().map(|comment| (comment.span, String::new())));
    let mut exprs: Vec<ExprId> = Vec::new();
    let mut open: Vec<&Item> = chart.items.iter().collect();
    while let Some(item) = open.pop() {
        match item {
            Item::Declaration(declaration) => {
                list.push((declaration.span, String::new()));
                list.extend(declaration.retain.map(|span| (span, String::new())));
                let names = &declaration.names;
                list.extend(names.iter().filter_map(|n| n.comment.as_ref()).map(|c| (c.span, String::new())));
                list.extend(names.windows(2).map(|pair| {
                    let (start, end) = (pair[0].name.span.start as usize, pair[1].name.span.start as usize);
                    (Span::new(declaration.span.file, start, end), String::new())
                }));
                if let [.., before, last] = &names[..] {
                    let end = before.comment.as_ref().map_or(before.name.span, |c| c.span).end as usize;
                    let last_end = last.comment.as_ref().map_or(last.name.span, |c| c.span).end as usize;
                    list.push((Span::new(declaration.span.file, end, last_end), String::new()));
                }
                let tail =
                    Span::new(declaration.span.file, declaration.ty_span.end as usize, declaration.span.end as usize);
                list.push((tail, String::new()));
            }
            Item::Allow(allow) => list.push((allow.span, String::new())),
            Item::Claim(claim) => list.push((claim.span, String::new())),
            Item::Scenario(scenario) => list.push((scenario.span, String::new())),
            Item::Grafcet(grafcet) => {
                list.push((grafcet.span, String::new()));
                open.extend(&grafcet.items);
            }
            Item::Expansion(expansion) => {
                list.push((expansion.span, String::new()));
                open.extend(&expansion.items);
            }
            Item::Step(step) => {
                list.push((step.span, String::new()));
                let words = ["initial", "activated"].into_iter().filter_map(|prefix| word(text, step, prefix));
                list.extend(words.map(|span| (span, String::new())));
                let head = step.comment.as_ref().map_or(step.label.span, |c| c.span);
                list.push((Span::new(head.file, head.end as usize, step.span.end as usize), String::new()));
                for action in &step.actions {
                    list.push((action.span, String::new()));
                    match &action.kind {
                        ActionKind::Continuous { target, condition } => {
                            let rest = Span::new(target.span.file, target.span.end as usize, action.span.end as usize);
                            list.push((rest, String::new()));
                            exprs.extend(condition);
                        }
                        ActionKind::Stored { assignment, event } => {
                            exprs.push(assignment.value);
                            list.push((chart.exprs[assignment.value].span, "1".into()));
                            match event {
                                Event::Activation | Event::Deactivation | Event::EachScan(None) => {}
                                Event::EachScan(Some(condition)) => exprs.push(*condition),
                                Event::Event(condition) => exprs.push(*condition),
                            }
                        }
                        ActionKind::Pulse { event, .. } => match event {
                            Event::Activation | Event::Deactivation | Event::EachScan(_) => {}
                            Event::Event(condition) => exprs.push(*condition),
                        },
                        ActionKind::Run { .. } => {}
                        ActionKind::Force { situation, .. } => match situation {
                            Situation::Steps(_) | Situation::Current | Situation::Initial => {}
                        },
                    }
                }
            }
            Item::Transition(transition) => {
                list.push((transition.span, String::new()));
                let condition = chart.exprs[transition.condition].span;
                let rest = Span::new(condition.file, condition.end as usize, transition.span.end as usize);
                list.push((rest, String::new()));
                exprs.push(transition.condition);
                list.extend(transition.pulses().iter().map(|pulse| (pulse.span, String::new())));
                list.push((condition, "1".into()));
                exprs.extend(transition.actions().iter().map(|a| a.value));
                list.extend(transition.actions().iter().map(|a| (chart.exprs[a.value].span, "1".into())));
                for names in [&transition.from, &transition.to] {
                    for (index, name) in names.iter().enumerate().skip(1) {
                        let from = names[index - 1].span.end as usize;
                        list.push((Span::new(name.span.file, from, name.span.end as usize), String::new()));
                    }
                }
            }
        }
    }
    while let Some(id) = exprs.pop() {
        let expr = &chart.exprs[id];
        let mut children: Vec<ExprId> = Vec::new();
        match &expr.kind {
            ExprKind::Name(_)
            | ExprKind::Integer(_)
            | ExprKind::Real(_)
            | ExprKind::Duration(_)
            | ExprKind::Bool(_)
            | ExprKind::Error => {}
            ExprKind::Paren(e) | ExprKind::Not(e) | ExprKind::Negate(e) | ExprKind::Rise(e) | ExprKind::Fall(e) => {
                children.push(*e);
            }
            ExprKind::Predicate(e) => {
                exprs.push(*e);
                list.push((expr.span, "1".into()));
            }
            ExprKind::Binary(_, l, r) => children.extend([*l, *r]),
            ExprKind::Delay(parts) => {
                children.extend(parts.iter().copied());
                if let [on, operand, off] = parts[..] {
                    let part = |from: ExprId, to: ExprId| {
                        text[chart.exprs[from].span.to(chart.exprs[to].span).range()].to_string()
                    };
                    list.push((expr.span, part(on, operand)));
                    list.push((expr.span, part(operand, off)));
                }
            }
        }
        for child in children {
            list.push((expr.span, text[chart.exprs[child].span.range()].to_string()));
            exprs.push(child);
        }
    }
    list.retain(|(span, with)| span.range().len() > with.len());
    let mut edits: Vec<Edit> = list.into_iter().map(|part| Edit(vec![part])).collect();
    edits.extend(pairs(text, &chart));
    edits.extend(shown(text, &chart));
    edits.sort_by_key(|edit| (std::cmp::Reverse(edit.gain()), edit.0[0].0.start));
    edits
}

/// An action of an internal variable, with the word that shows the variable: a fault that only the conflict of two
/// actions showed is then seen in the value that one of them gives.
fn shown(text: &str, chart: &Chart) -> Vec<Edit> {
    let mut hidden: BTreeMap<&str, Span> = BTreeMap::new();
    let mut actions: Vec<(&str, Span)> = Vec::new();
    let mut open: Vec<&Item> = chart.items.iter().collect();
    while let Some(item) = open.pop() {
        match item {
            Item::Declaration(declaration) if declaration.kind == DeclarationKind::Variable => {
                let start = declaration.retain.map_or(declaration.span.start, |span| span.end) as usize;
                let Some(at) = text[start..declaration.span.end as usize].find("var") else { continue };
                let word = Span::new(declaration.span.file, start + at, start + at + "var".len());
                hidden.extend(declaration.names.iter().map(|n| (n.name.text.as_str(), word)));
            }
            Item::Declaration(_) | Item::Allow(_) | Item::Claim(_) | Item::Scenario(_) | Item::Transition(_) => {}
            Item::Grafcet(grafcet) => open.extend(&grafcet.items),
            Item::Expansion(expansion) => open.extend(&expansion.items),
            Item::Step(step) => actions.extend(step.actions.iter().filter_map(|action| match &action.kind {
                ActionKind::Stored { assignment, .. } => Some((assignment.target.text.as_str(), action.span)),
                ActionKind::Continuous { .. }
                | ActionKind::Pulse { .. }
                | ActionKind::Run { .. }
                | ActionKind::Force { .. } => None,
            })),
        }
    }
    let pair = |(name, action): (&str, Span)| {
        let word = *hidden.get(name)?;
        Some(Edit(vec![(action, String::new()), (word, "output".into())]))
    };
    actions.into_iter().filter_map(pair).collect()
}

/// What cannot go alone: a macro-step with its expansion, an enclosure with the word that makes its step enclosing, an
/// initial step with the transition after it, where the next steps become initial in its place.
fn pairs(text: &str, chart: &Chart) -> Vec<Edit> {
    let mut steps: BTreeMap<&str, &Step> = BTreeMap::new();
    let mut blocks: Vec<(&str, Span)> = Vec::new();
    let mut transitions: Vec<&Transition> = Vec::new();
    let mut open: Vec<&Item> = chart.items.iter().collect();
    while let Some(item) = open.pop() {
        match item {
            Item::Step(step) => {
                steps.insert(&step.label.text, step);
            }
            Item::Grafcet(grafcet) => {
                let encloser = grafcet.path.last().and_then(|name| name.text.strip_prefix('X'));
                blocks.extend(encloser.map(|label| (label, grafcet.span)));
                open.extend(&grafcet.items);
            }
            Item::Expansion(expansion) => {
                blocks.push((&expansion.macro_step.text, expansion.span));
                open.extend(&expansion.items);
            }
            Item::Transition(transition) => transitions.push(transition),
            Item::Declaration(_) | Item::Allow(_) | Item::Claim(_) | Item::Scenario(_) => {}
        }
    }
    let later = |transition: &Transition| {
        let [from] = &transition.from[..] else { return None };
        let first = steps.get(from.text.as_str()).filter(|step| step.is_initial())?;
        let next = transition.to.iter().filter_map(|name| steps.get(name.text.as_str()));
        let start = |step: &&Step| Span::new(step.span.file, step.span.start as usize, step.span.start as usize);
        let initial = next.map(|step| (start(step), "initial ".to_string()));
        Some(Edit([(transition.span, String::new()), (first.span, String::new())].into_iter().chain(initial).collect()))
    };
    let pair = |(label, block): (&str, Span)| {
        let step = steps.get(label)?;
        let span = match step.kind {
            StepKind::Macro => step.span,
            StepKind::Enclosing => word(text, step, "enclosing")?,
            StepKind::Plain => return None,
        };
        Some(Edit(vec![(block, String::new()), (span, String::new())]))
    };
    blocks.into_iter().filter_map(pair).chain(transitions.into_iter().filter_map(later)).collect()
}

/// A word before the label of a step.
fn word(text: &str, step: &Step, word: &str) -> Option<Span> {
    let start = step.span.start as usize;
    let at = start + text[start..step.label.span.start as usize].find(word)?;
    Some(Span::new(step.span.file, at, at + word.len()))
}
