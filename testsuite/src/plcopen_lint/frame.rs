//! The project around the bodies: namespace, texts, names, types, instances.

use super::document::Id;
use super::{Lint, Rule};
use grafc_backends::keywords::{Family, Reserved};
use grafc_backends::plcopen::Dialect;
use std::collections::BTreeSet;

/// Function blocks that every system has.
const STANDARD: &str = "TON TOF TP R_TRIG F_TRIG SR RS CTU CTD CTUD";

/// Elements that hold a formatted text.
const FORMATTED: &str = "ST IL documentation content";

pub(super) fn check(lint: &mut Lint) {
    let (namespace, prefix) = match lint.dialect {
        Dialect::Neutral => ("http://www.plcopen.org/xml/tc6_0201", Some("http://www.w3.org/1999/xhtml")),
        Dialect::Codesys => ("http://www.plcopen.org/xml/tc6_0200", None),
    };
    let right = lint.value(0, "xmlns") == namespace && lint.document.attribute(0, "xmlns:xhtml") == prefix;
    lint.demand(right, Rule::Namespace, 0, "namespaces");
    for id in lint.document.within(0) {
        if FORMATTED.split(' ').any(|name| name == lint.document.name(id)) {
            formatted(lint, id);
        }
    }
    units(lint);
    global_ids(lint);
    instances(lint);
}

fn formatted(lint: &mut Lint, id: Id) {
    let document = lint.document;
    let element = document.get(id);
    let [text] = element.children[..] else {
        return lint.find(Rule::Text, id, "not one element");
    };
    let right = match lint.dialect {
        // The reader finds the section by its place right behind the tag.
        Dialect::Neutral => document.name(text) == "xhtml:p" && document.get(text).starts_with_cdata,
        Dialect::Codesys => {
            document.name(text) == "xhtml"
                && lint.value(text, "xmlns") == "http://www.w3.org/1999/xhtml"
                && !document.get(text).starts_with_cdata
        }
    };
    lint.demand(right && element.text.trim().is_empty(), Rule::Text, id, "not in the form of the dialect");
}

fn units(lint: &mut Lint) {
    let document = lint.document;
    let reserved = Reserved::of(Family::Iec);
    let mut units = BTreeSet::new();
    for unit in document.all("pou") {
        lint.demand(units.insert(upper(lint.value(unit, "name"))), Rule::UniqueName, unit, "given twice");
        name(lint, &reserved, unit);
    }
    for unit in document.all("pou") {
        let bodies: Vec<Id> = document.children(unit, "body").collect();
        let languages = |body: &Id| {
            let words = document.get(*body).children.iter().map(|child| document.name(*child));
            words.filter(|name| matches!(*name, "ST" | "IL" | "SFC" | "LD" | "FBD")).count()
        };
        let one = bodies.len() == 1 && bodies.iter().all(|body| languages(body) == 1);
        lint.demand(one, Rule::OneBody, unit, "not one body in one language");

        // A step is a variable with parts, an action a block: all share one space of names.
        let mut names = BTreeSet::new();
        for id in document.within(unit) {
            let parent = document.name(document.get(id).parent);
            let is_name = match document.name(id) {
                "variable" => parent.ends_with("Vars"),
                "step" => true,
                "action" => parent == "actions",
                _ => false,
            };
            if is_name {
                lint.demand(names.insert(upper(lint.value(id, "name"))), Rule::UniqueName, id, "given twice");
                name(lint, &reserved, id);
            }
        }
    }
    for ty in document.all("derived") {
        let wanted = upper(lint.value(ty, "name"));
        let known = units.contains(&wanted) || STANDARD.split(' ').any(|name| name == wanted);
        lint.demand(known, Rule::KnownType, ty, "unknown");
    }
}

fn upper(name: &str) -> String {
    name.to_ascii_uppercase()
}

fn name(lint: &mut Lint, reserved: &Reserved, id: Id) {
    let name = lint.value(id, "name");
    let mut chars = name.chars();
    let starts = chars.next().is_some_and(|c| c.is_ascii_alphabetic() || c == '_');
    let letters = chars.all(|c| c.is_ascii_alphanumeric() || c == '_');
    let apart = !name.contains("__") && !name.ends_with('_');
    let free = !reserved.contains(&upper(name));
    lint.demand(starts && letters && apart && free, Rule::Identifier, id, "no identifier");
}

fn global_ids(lint: &mut Lint) {
    let mut given = BTreeSet::new();
    for id in lint.document.within(0) {
        let Some(value) = lint.document.attribute(id, "globalId") else { continue };
        let starts = value.starts_with(|c: char| c.is_alphabetic() || c == '_');
        let letters = value.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '-' | '.'));
        lint.demand(starts && letters && given.insert(value), Rule::GlobalId, id, value);
    }
}

fn instances(lint: &mut Lint) {
    let document = lint.document;
    for instance in document.all("pouInstance") {
        let of = lint.value(instance, "typeName");
        let known = document
            .all("pou")
            .any(|unit| lint.value(unit, "name").eq_ignore_ascii_case(of) && lint.value(unit, "pouType") == "program");
        lint.demand(known, Rule::Instance, instance, "of no program");
        let documented = lint.dialect == Dialect::Neutral || document.child(instance, "documentation").is_some();
        lint.demand(documented, Rule::Instance, instance, "without documentation, which TwinCAT does not take");
    }
    for task in document.all("task") {
        let interval = lint.value(task, "interval");
        let right = match lint.dialect {
            Dialect::Neutral => interval.starts_with("T#"),
            Dialect::Codesys => interval.starts_with("PT"),
        };
        lint.demand(right, Rule::Instance, task, "the interval is not in the form of the dialect");
    }
}
