//! A drawn sequential function chart, read back: which steps each transition leaves and enters, by IEC 61131-3, clause
//! 2.6 of edition 2, and by nothing but the wires.
//!
//! A selection stands between a step and its transitions, or between transitions and their step; a simultaneous sequence
//! between a transition and several steps. What stands elsewhere is an error.

use crate::plcopen_lint::document::{Document, Id};
use std::collections::{BTreeMap, BTreeSet};

/// A transition between steps.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Transition {
    /// The steps that it leaves.
    pub before: BTreeSet<String>,
    /// The steps that it enters.
    pub after: BTreeSet<String>,
    /// Its condition.
    pub condition: String,
}

/// The chart that a drawing shows.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Drawn {
    /// Initial steps.
    pub initial: BTreeSet<String>,
    /// All transitions, sorted.
    pub transitions: Vec<Transition>,
    /// The rows of action blocks by step: qualifier, and variable or statement.
    pub actions: BTreeMap<String, Vec<(String, String)>>,
}

/// Reads the first sequential function chart of a document.
///
/// # Errors
/// What is wired so that it means nothing.
pub fn read(document: &Document) -> Result<Drawn, String> {
    let body = document.all("SFC").next().ok_or("no sequential function chart")?;
    let objects = document.get(body).children.iter().copied();
    let by_number = objects.clone().filter_map(|id| Some((document.attribute(id, "localId")?, id))).collect();
    let mut sheet = Sheet { document, objects: by_number, leaving: BTreeMap::new() };
    for id in objects.clone() {
        for from in sheet.sources(id)? {
            *sheet.leaving.entry(from).or_default() += 1;
        }
    }
    let (mut initial, mut actions) = (BTreeSet::new(), BTreeMap::new());
    let mut transitions: BTreeMap<Id, Transition> = BTreeMap::new();
    for id in objects.clone().filter(|id| document.name(*id) == "transition") {
        let before = sheet.above_a_transition(id)?;
        let condition = sheet.condition(id).ok_or("a transition without a condition")?;
        transitions.insert(id, Transition { before, after: BTreeSet::new(), condition });
    }
    for id in objects {
        let target = match document.name(id) {
            "step" => sheet.attribute(id, "name")?,
            "jumpStep" => sheet.attribute(id, "targetName")?,
            "actionBlock" => {
                let step = sheet.sources(id)?;
                let [step] = step[..] else { return Err("an action block of several steps".to_owned()) };
                actions.insert(sheet.attribute(step, "name")?.to_owned(), sheet.rows(id)?);
                continue;
            }
            _ => continue,
        };
        if document.attribute(id, "initialStep") == Some("true") {
            initial.insert(target.to_owned());
        }
        for transition in sheet.above_a_step(id)? {
            let after = transitions.get_mut(&transition).map(|transition| &mut transition.after);
            after.ok_or("a wire from nothing")?.insert(target.to_owned());
        }
    }
    let mut transitions: Vec<Transition> = transitions.into_values().collect();
    transitions.sort();
    Ok(Drawn { initial, transitions, actions })
}

struct Sheet<'d> {
    document: &'d Document,
    objects: BTreeMap<&'d str, Id>,
    /// How many wires come from each object.
    leaving: BTreeMap<Id, usize>,
}

impl Sheet<'_> {
    fn attribute(&self, id: Id, key: &str) -> Result<&str, String> {
        self.document.attribute(id, key).ok_or_else(|| format!("{} without {key}", self.document.name(id)))
    }

    /// What the inputs of an object are wired to.
    fn sources(&self, id: Id) -> Result<Vec<Id>, String> {
        let inputs = self.document.children(id, "connectionPointIn");
        let wires = inputs.flat_map(|input| self.document.children(input, "connection"));
        let from = wires.map(|wire| {
            let number = self.attribute(wire, "refLocalId")?;
            self.objects.get(number).copied().ok_or_else(|| format!("a wire from {number}, which is nothing"))
        });
        from.collect()
    }

    /// The steps that must all be active.
    fn above_a_transition(&self, id: Id) -> Result<BTreeSet<String>, String> {
        let mut due = self.sources(id)?;
        if due.len() > 1 {
            return Err("several wires to a transition".to_owned());
        }
        let mut steps = BTreeSet::new();
        while let Some(id) = due.pop() {
            match self.document.name(id) {
                "step" => drop(steps.insert(self.attribute(id, "name")?.to_owned())),
                "selectionDivergence" | "simultaneousConvergence" => due.extend(self.sources(id)?),
                other => return Err(format!("{other} above a transition")),
            }
        }
        Ok(steps)
    }

    /// The transitions of which each leads to a step.
    fn above_a_step(&self, id: Id) -> Result<Vec<Id>, String> {
        let mut due = self.sources(id)?;
        if due.len() > 1 {
            return Err("several wires to a step".to_owned());
        }
        let mut transitions = Vec::new();
        while let Some(id) = due.pop() {
            match self.document.name(id) {
                "transition" => transitions.push(id),
                // CODESYS closes a selection below jumps, too; what has jumped does not come there.
                "jumpStep" => {}
                "selectionConvergence" | "simultaneousDivergence" => due.extend(self.sources(id)?),
                other => return Err(format!("{other} above a step")),
            }
        }
        // Without a bar a box leads to one other.
        match transitions.iter().find(|id| self.leaving.get(id) != Some(&1)) {
            Some(_) => Err("several wires from a transition".to_owned()),
            None => Ok(transitions),
        }
    }

    /// The condition in a transition, or wired to it.
    fn condition(&self, id: Id) -> Option<String> {
        let condition = self.document.child(id, "condition")?;
        let wired = self.sources(condition).ok()?;
        let text = match wired[..] {
            [from] => self.document.child(from, "expression")?,
            _ => self.document.within(condition).find(|id| self.document.get(*id).starts_with_cdata)?,
        };
        Some(self.document.get(text).text.clone())
    }

    fn rows(&self, block: Id) -> Result<Vec<(String, String)>, String> {
        let rows = self.document.children(block, "action").map(|action| {
            let text = match self.document.child(action, "reference") {
                Some(reference) => self.attribute(reference, "name")?,
                None => {
                    let text = self.document.within(action).find(|id| self.document.get(*id).starts_with_cdata);
                    self.document.get(text.ok_or("an action without a text")?).text.as_str()
                }
            };
            Ok((self.attribute(action, "qualifier")?.to_owned(), text.to_owned()))
        });
        rows.collect()
    }
}
