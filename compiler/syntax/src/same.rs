//! Whether two trees are the same, apart from their places.
//!
//! The parser fills the arena in the order of the text, so the arenas of two texts with the same meaning are equal
//! element by element, and nothing needs to be walked in depth.

use crate::ast::*;

/// Whether two texts were read as the same chart: everything but spans, and as many comments.
pub fn same(a: &Chart, b: &Chart) -> bool {
    let headings = match (&a.heading, &b.heading) {
        (Some(a), Some(b)) => {
            let options = |a: &ChartOption, b: &ChartOption| a.kind == b.kind;
            name(&a.name, &b.name) && text(&a.comment, &b.comment) && all(&a.options, &b.options, options)
        }
        (None, None) => true,
        (Some(_), None) | (None, Some(_)) => false,
    };
    headings
        && a.comments.len() == b.comments.len()
        && a.exprs.len() == b.exprs.len()
        && a.exprs.iter().zip(&b.exprs).all(|(a, b)| a.kind == b.kind)
        && items(&a.items, &b.items)
}

fn all<T>(a: &[T], b: &[T], same: impl Fn(&T, &T) -> bool) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b))
}

fn name(a: &Name, b: &Name) -> bool {
    a.text == b.text && a.quoted == b.quoted
}

fn names(a: &[Name], b: &[Name]) -> bool {
    all(a, b, name)
}

fn text(a: &Option<Box<Text>>, b: &Option<Box<Text>>) -> bool {
    a.as_ref().map(|a| &a.text) == b.as_ref().map(|b| &b.text)
}

/// Blocks are nested at most 64 deep (see `items.rs`), so this may recurse.
fn items(a: &[Item], b: &[Item]) -> bool {
    all(a, b, |a, b| match (a, b) {
        (Item::Declaration(a), Item::Declaration(b)) => {
            (a.retain.is_some(), a.kind) == (b.retain.is_some(), b.kind)
                && all(&a.names, &b.names, |a, b| name(&a.name, &b.name) && text(&a.comment, &b.comment))
                && a.ty == b.ty
                && a.initial == b.initial
                && text(&a.address, &b.address)
        }
        (Item::Grafcet(a), Item::Grafcet(b)) => {
            a.automaton == b.automaton
                && names(&a.path, &b.path)
                && name(&a.name, &b.name)
                && names(a.parent.as_slice(), b.parent.as_slice())
                && text(&a.comment, &b.comment)
                && items(&a.items, &b.items)
        }
        (Item::Expansion(a), Item::Expansion(b)) => {
            name(&a.macro_step, &b.macro_step) && text(&a.comment, &b.comment) && items(&a.items, &b.items)
        }
        (Item::Step(a), Item::Step(b)) => {
            a.kind == b.kind
                && (a.is_initial(), a.is_activated()) == (b.is_initial(), b.is_activated())
                && name(&a.label, &b.label)
                && text(&a.comment, &b.comment)
                && all(&a.actions, &b.actions, action)
                && all(&a.allows, &b.allows, allow)
        }
        (Item::Transition(a), Item::Transition(b)) => {
            a.designation().map(|n| (&n.text, n.quoted)) == b.designation().map(|n| (&n.text, n.quoted))
                && text(a.comment(), b.comment())
                && names(&a.from, &b.from)
                && names(&a.to, &b.to)
                && a.condition == b.condition
                && all(a.actions(), b.actions(), assignment)
                && all(a.pulses(), b.pulses(), |a, b| a.kind == b.kind && name(&a.grafcet, &b.grafcet))
                && names(a.outputs(), b.outputs())
                && all(a.allows(), b.allows(), allow)
        }
        (Item::Allow(a), Item::Allow(b)) => allow(a, b),
        (Item::Claim(a), Item::Claim(b)) => {
            a.kind == b.kind && text(&a.text, &b.text) && a.body == b.body && a.written == b.written
        }
        (Item::Scenario(a), Item::Scenario(b)) => a.name.text == b.name.text && all(&a.lines, &b.lines, scenario_line),
        (
            Item::Declaration(_)
            | Item::Grafcet(_)
            | Item::Expansion(_)
            | Item::Step(_)
            | Item::Transition(_)
            | Item::Allow(_)
            | Item::Claim(_)
            | Item::Scenario(_),
            Item::Declaration(_)
            | Item::Grafcet(_)
            | Item::Expansion(_)
            | Item::Step(_)
            | Item::Transition(_)
            | Item::Allow(_)
            | Item::Claim(_)
            | Item::Scenario(_),
        ) => false,
    })
}

fn allow(a: &Allow, b: &Allow) -> bool {
    let about = |allow: &Allow| allow.about.as_ref().map(|n| (n.text.clone(), n.quoted));
    name(&a.code, &b.code) && about(a) == about(b) && a.reason.text == b.reason.text
}

fn scenario_line(a: &ScenarioLine, b: &ScenarioLine) -> bool {
    use ScenarioLineKind::*;
    let expected = |a: &Expectation, b: &Expectation| name(&a.name, &b.name) && a.value == b.value;
    let given =
        |a: &Given, b: &Given| name(&a.name, &b.name) && a.value == b.value && a.pulse.is_some() == b.pulse.is_some();
    let kind = match (&a.kind, &b.kind) {
        (At { time: s, is_after: f, given: a }, At { time: t, is_after: g, given: b }) => {
            s == t && f == g && all(a, b, given)
        }
        (Until { condition: c, within: s }, Until { condition: d, within: t }) => c == d && s == t,
        (At { .. } | Until { .. }, At { .. } | Until { .. }) => false,
    };
    kind && all(&a.expected, &b.expected, expected)
}

fn assignment(a: &Assignment, b: &Assignment) -> bool {
    name(&a.target, &b.target) && a.value == b.value
}

fn action(a: &Action, b: &Action) -> bool {
    use ActionKind::*;
    match (&a.kind, &b.kind) {
        (Continuous { target: a, condition: c }, Continuous { target: b, condition: d }) => name(a, b) && c == d,
        (Stored { assignment: a, event: e }, Stored { assignment: b, event: f }) => assignment(a, b) && e == f,
        (Force { grafcet: a, situation: s }, Force { grafcet: b, situation: t }) => name(a, b) && situation(s, t),
        (Pulse { kind: k, grafcet: a, event: e }, Pulse { kind: l, grafcet: b, event: f }) => {
            k == l && name(a, b) && e == f
        }
        (Run { grafcet: a }, Run { grafcet: b }) => name(a, b),
        (
            Continuous { .. } | Stored { .. } | Pulse { .. } | Run { .. } | Force { .. },
            Continuous { .. } | Stored { .. } | Pulse { .. } | Run { .. } | Force { .. },
        ) => false,
    }
}

fn situation(a: &Situation, b: &Situation) -> bool {
    match (a, b) {
        (Situation::Steps(a), Situation::Steps(b)) => names(a, b),
        (Situation::Current, Situation::Current) | (Situation::Initial, Situation::Initial) => true,
        (
            Situation::Steps(_) | Situation::Current | Situation::Initial,
            Situation::Steps(_) | Situation::Current | Situation::Initial,
        ) => false,
    }
}
