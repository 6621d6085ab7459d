//! What never changes: constants, names of transitions, types of inputs, and what a page has to know beside.

use super::expressions::{literal, preset};
use super::memory::{about, property};
use super::places::{Places, claims, transition_word};
use super::shows_all;
use super::text::{key, quoted};
use crate::writer::Writer;
use ecow::{EcoString, eco_format};
use grafc_logic::scan::{Origin, Program, Role, SeenDelay, Transition, TransitionId};
use grafc_logic::type_name;
use index_vec::IndexVec;
use rustc_hash::FxHashSet;

/// Writes them.
pub(super) fn write(out: &mut Writer, program: &Program, places: &Places) {
    constants(out, program, shows_all(program));
    let inputs: Vec<EcoString> =
        program.of_role(Role::Input).map(|(_, v)| eco_format!("{}: \"{}\"", key(&v.name), type_name(v.ty))).collect();
    out.blank();
    object(out, "const INPUTS =", &inputs);
    // A program that shows nothing has none that can be told of.
    let Some(observing) = &program.observing else { return out.line("const TRANSITIONS = [], WORDS = [];") };
    let named = names_of_transitions(program);
    let transitions: Vec<EcoString> =
        observing.transitions.iter().map(|seen| quoted(&named[seen.transition])).collect();
    out.comment("the transitions: their designations, or their numbers in order of declaration");
    list(out, "const TRANSITIONS = ", &transitions, ";");
    let words: Vec<EcoString> =
        observing.transitions.iter().map(|seen| quoted(&transition_word(places.names, seen))).collect();
    out.comment("the words by which the code calls them");
    list(out, "const WORDS = ", &words, ";");
    if !shows_all(program) {
        return;
    }
    let grafcets: Vec<EcoString> =
        observing.frozen.iter().map(|(g, _)| quoted(&program.elements.grafcets[*g].name)).collect();
    let steps: Vec<EcoString> = observing.forced.iter().map(|(s, _)| quoted(program.label(*s))).collect();
    let numbers = |list: &[(usize, _)]| list.iter().map(|(k, _)| eco_format!("{k}")).collect::<Vec<_>>();
    out.comment("what can be frozen or forced; orders and actions, numbered as the chart declares them");
    list(out, "const FROZEN = ", &grafcets, ";");
    list(out, "const FORCED = ", &steps, ";");
    list(out, "const ORDERS = ", &numbers(&observing.orders), ";");
    list(out, "const ACTIONS = ", &numbers(&observing.actions), ";");
    let places_of = |always: bool| claims(program, always).map(|(k, _)| eco_format!("{k}")).collect::<Vec<_>>();
    out.comment("claims: assumptions and assertions, and what is to be reached, by their places in the chart");
    list(out, "const ASSERTED = ", &places_of(true), ";");
    list(out, "const WANTED = ", &places_of(false), ";");
    let delays: Vec<EcoString> = observing.delays.iter().map(|seen| delay(program, places, &named, seen)).collect();
    lines(out, "const DELAYS =", &delays);
}

fn constants(out: &mut Writer, program: &Program, shown: bool) {
    let is_empty = program.of_role(Role::Constant).next().is_none();
    if is_empty && !shown {
        return;
    }
    out.blank();
    if is_empty {
        return out.line("const constants = {};");
    }
    out.open("const constants = {");
    for (id, variable) in program.of_role(Role::Constant) {
        let outer = out.origin(Origin::declaration(id));
        let line = format!("{}: {},", key(&variable.name), literal(variable.initial(), variable.ty));
        property(out, &line, &about(program, id));
        out.origin(outer);
    }
    out.close("};");
}

/// What transitions are called: their designations, or their numbers; by these all go where the chart calls two the same.
pub(super) fn names_of_transitions(program: &Program) -> IndexVec<TransitionId, EcoString> {
    let all = &program.elements.transitions;
    let mut known: FxHashSet<&EcoString> = FxHashSet::default();
    let by_number = !all.iter().filter_map(|t| t.designation.as_ref()).all(|name| known.insert(name.text()));
    let name = |(t, transition): (TransitionId, &Transition)| match &transition.designation {
        Some(designation) if !by_number => designation.text().clone(),
        Some(_) | None => eco_format!("#{}", t.index() + 1),
    };
    all.iter_enumerated().map(name).collect()
}

/// A delay as a page shows it.
fn delay(program: &Program, places: &Places, named: &IndexVec<TransitionId, EcoString>, seen: &SeenDelay) -> EcoString {
    let (of, owner) = match seen.origin {
        Origin::Transition(t) => ("transition", named[t].clone()),
        Origin::Step(s) => ("step", program.label(s).into()),
        Origin::Action(_) => ("action", eco_format!("{}", seen.action.unwrap_or_default())),
        Origin::Chart | Origin::Actions(_) | Origin::Order(_) | Origin::Orders(_) | Origin::Declaration(_) => {
            ("chart", program.name.as_str().into())
        }
    };
    let total = preset(places, seen.total);
    let name = &places.names.timers[seen.timer];
    let held = match seen.held {
        Some(v) => eco_format!(", held: {}", quoted(&places.names.variables[v])),
        None => EcoString::new(),
    };
    eco_format!(
        "{{ of: \"{of}\", owner: {}, text: {}, total: {total}, delay: {}{held} }}",
        quoted(&owner),
        quoted(&seen.text),
        quoted(name)
    )
}

/// An object with a property a line.
fn object(out: &mut Writer, head: &str, items: &[EcoString]) {
    enclosed(out, head, items, ["{ ", " }", "{", "}"]);
}

/// A list, as many items on a line as there is room for; `tail` is behind it.
pub(super) fn list(out: &mut Writer, head: &str, items: &[EcoString], tail: &str) {
    let flat = items.join(", ");
    if out.indent() + head.len() + flat.chars().count() + tail.len() + 3 <= out.width() {
        return out.line(&format!("{head}[{flat}]{tail}"));
    }
    out.open(&format!("{head}["));
    let mut line = String::new();
    for item in items {
        if !line.is_empty() && out.indent() + line.chars().count() + item.chars().count() + 2 > out.width() {
            out.line(&std::mem::take(&mut line));
        }
        line.push_str(if line.is_empty() { "" } else { " " });
        line.push_str(item);
        line.push(',');
    }
    out.line(&line);
    out.close(&format!("]{tail}"));
}

/// A list with an item a line.
fn lines(out: &mut Writer, head: &str, items: &[EcoString]) {
    enclosed(out, head, items, ["[", "]", "[", "]"]);
}

fn enclosed(out: &mut Writer, head: &str, items: &[EcoString], brackets: [&str; 4]) {
    let [open, close, above, below] = brackets;
    let flat = items.join(", ");
    if items.is_empty() {
        return out.line(&format!("{head} {above}{below};"));
    }
    if out.indent() + head.len() + flat.len() + 6 <= out.width() {
        return out.line(&format!("{head} {open}{flat}{close};"));
    }
    out.open(&format!("{head} {above}"));
    items.iter().for_each(|item| out.line(&format!("{item},")));
    out.close(&format!("{below};"));
}
