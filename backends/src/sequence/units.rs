//! The units that a sequential function chart is made of.
//!
//! ```text
//! Gate_chart   the chart, drawn; what is found before it is called is an input
//! Gate         rise_open := open AND NOT old_open;
//!              old_open := open;
//!              drawn(open := open, closed := closed, rise_open := rise_open);
//!              up := drawn.up;
//!              lamp := drawn.at_1 OR drawn.at_2;
//! ```
//!
//! What several steps set is found behind the chart, since tools differ in what they make of two actions on one variable.
//! If there is nothing to find, the chart is the function block itself.

use super::texts::Texts;
use crate::iec::declarations::{Entry, EntryType, VarBlock, VarKind, interface};
use crate::iec::frame;
use crate::iec::names::Names;
use crate::iec::pou_parts::{Language, PouParts};
use crate::keywords::Family;
use crate::st;
use ecow::{EcoString, eco_format};
use grafc_formula::Type;
use grafc_logic::scan::VarId;
use grafc_logic::sequence::Sequence;
use rustc_hash::FxHashSet;

/// The units around the chart.
pub(crate) struct Units {
    /// The function block of the chart and the program.
    pub parts: PouParts,
    /// The function block that holds the steps, if it is another: its name and its variables.
    pub drawn: Option<(EcoString, Vec<VarBlock>)>,
}

/// The name of the instance that is drawn.
pub(super) fn instance(names: &mut Names) -> EcoString {
    names.namer.name("drawn")
}

/// Takes the declarations of some names out.
fn show(blocks: &mut [VarBlock], names: &[EcoString]) -> Vec<Entry> {
    let mut taken = Vec::new();
    for (_, entries) in blocks.iter_mut().flat_map(|block| &mut block.sections) {
        let (out, kept) = std::mem::take(entries).into_iter().partition(|entry| names.contains(&entry.name));
        *entries = kept;
        taken.extend::<Vec<Entry>>(out);
    }
    taken
}

impl Units {
    /// The units of a chart. A step brings its activity and its duration along.
    pub fn new(sequence: &Sequence, texts: &Texts) -> Self {
        let program = &sequence.program;
        let mut names = Names::new(program, Family::Iec);
        let call = st::call(program, &names);
        if !sequence.is_held() {
            let mut parts = PouParts::new(program, names, Language::St, Vec::new(), String::new(), call);
            parts.interface.iter_mut().for_each(|block| block.retain(|name| !texts.is_of_a_step(name)));
            return Units { parts, drawn: None };
        }
        let instance = instance(&mut names);
        let block = names.namer.unit(&format!("{}_chart", names.block));
        let all = |ids: &[VarId]| -> Vec<EcoString> { ids.iter().map(|id| names.variables[*id].clone()).collect() };
        let [given, memory, shown] = [&sequence.given, &sequence.memory, &sequence.shown].map(|ids| all(ids));
        let timers: FxHashSet<&str> = names.timers.iter().map(EcoString::as_str).collect();
        let is_found = |name: &str| timers.contains(name) || given.iter().chain(&memory).any(|found| found == name);

        let late: FxHashSet<EcoString> = sequence.found_after().map(|id| names.variables[id].clone()).collect();
        let is_late = |name: &str| late.contains(name);

        let mut inner = interface(program, &names, Vec::new());
        for block in &mut inner {
            block.retain(|name| !texts.is_of_a_step(name) && !is_found(name) && !is_late(name));
            if block.kind == VarKind::Input {
                let entries = given.iter().map(|name| Entry::plain(name.clone(), Type::Bool)).collect();
                block.sections.push(("".into(), entries));
            }
        }
        let markers = show(&mut inner, &shown);
        if let Some(output) = inner.iter_mut().find(|block| block.kind == VarKind::Output) {
            output.sections.push(("".into(), markers));
        }
        let (mut inputs, mut published) = frame::wired(program, &names);
        published.retain(|name| !is_late(name));
        inputs.extend(given.iter().map(EcoString::as_str));
        let mut spelt = names.clone();
        for id in &sequence.shown {
            spelt.variables[*id] = eco_format!("{instance}.{}", names.variables[*id]);
        }
        let mut body = st::before(program, &spelt);
        body.blank();
        st::call::write(&mut body, &instance, &inputs, &published);
        body.append(st::after(program, &spelt));
        let body = body.finish();

        let mut outer = interface(program, &names, Vec::new());
        let drawn = Entry {
            ty: EntryType::Block(block.clone().into()),
            comment: Some("the chart".into()),
            ..Entry::plain(instance.clone(), Type::Bool)
        };
        for block in &mut outer {
            if block.kind == VarKind::Local {
                block.retain(is_found);
            }
        }
        if let Some(local) = outer.iter_mut().find(|block| block.kind == VarKind::Local) {
            local.sections.push(("".into(), vec![drawn]));
        }
        let mut parts = PouParts::new(program, names, Language::St, Vec::new(), body, call);
        parts.interface = outer;
        Units { parts, drawn: Some((block, inner)) }
    }

    /// The variables of the unit that is drawn.
    pub fn interface(&self) -> &[VarBlock] {
        self.drawn.as_ref().map_or(&self.parts.interface, |(_, interface)| interface)
    }
}

/// Names that nothing else has.
pub(crate) struct Fresh {
    taken: FxHashSet<String>,
}

impl Fresh {
    /// Besides those that are taken, in any case.
    pub fn new<'n>(taken: impl Iterator<Item = &'n str>) -> Self {
        Fresh { taken: taken.map(str::to_ascii_uppercase).collect() }
    }

    /// The wanted name, or one that begins like it.
    pub fn name(&mut self, wanted: &str) -> String {
        let suffixes = std::iter::once(String::new()).chain((1_u64..).map(|number| format!("_{number}")));
        let mut names = suffixes.map(|suffix| format!("{wanted}{suffix}"));
        let free = names.find(|name| self.taken.insert(name.to_ascii_uppercase()));
        free.unwrap_or_else(|| wanted.to_owned())
    }
}
