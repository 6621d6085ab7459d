//! A body drawn as a ladder diagram, for Beremiz and the editors that come from it.
//!
//! ```text
//! Program ─ statements, circuit ─▶ rungs ─ layout ─▶ columns and rows ─ write ─▶ XML
//! ```
//!
//! `statements` makes rungs of statements, with `branches` what stands under conditions and with `calculate` numbers;
//! `circuit` makes contacts of formulas. What a rung does it does in each call, and in the order in which the elements are
//! written: Beremiz's generator goes by that order alone (2024), other tools from the top down, which is the same.
//!
//! A ladder has no loop, and Beremiz passes over jumps without a word. So where a call is several micro-steps, the rungs
//! are a function block of their own, one micro-step, and the chart's function block calls it until the situation is
//! stable (`repeat`).

mod branches;
mod calculate;
mod circuit;
mod layout;
mod repeat;
mod rung;
mod statements;
#[cfg(test)]
mod tests;
mod write;

use super::{Dialect, Options, project};
use crate::iec::declarations::{Entry, EntryType, interface};
use crate::iec::names::Names;
use crate::iec::pou_parts::{Language, PouParts};
use crate::keywords::Family;
use crate::limits;
use crate::st::{self, Texts};
use crate::xml::Xml;
use circuit::Ladder;
use ecow::EcoString;
use grafc_diagnostics::Diagnostics;
use grafc_formula::Type;
use grafc_logic::scan::{Program, Role};
use index_vec::IndexVec;
use repeat::Repeated;
use rung::{Contact, Item, Rung, Storage};
use rustc_hash::FxHashMap;

/// Writes a program as a project in the neutral dialect, whose function block is a ladder diagram.
///
/// An error is a fault of grafc: the program breaks a promise of [`Program`] or is too deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    limits::check(program)?;
    let mut names = Names::new(program, Family::Iec);
    let repeated = program.repeat.map(|repeat| Repeated::new(program, &mut names, repeat));
    let (rungs, variables) = draw(program, &mut names, repeated.as_ref());
    let layout = layout::layout(&rungs);
    let ladder = |xml: &mut Xml, dialect| write::write(xml, &rungs, &layout, dialect);

    let options = Options { dialect: Dialect::Neutral, ..options.clone() };
    let call = st::call(program, &names);
    let Some(repeated) = repeated else {
        let parts = PouParts::new(program, names, Language::St, variables, String::new(), call);
        return Ok(project::write(&parts, &options, &[], ladder));
    };
    let inner = repeated.inner(interface(program, &names, variables));
    let outer = repeated.outer(interface(program, &names, Vec::new()));
    let body = repeated.body(program, &names);
    let mut parts = PouParts::new(program, names, Language::St, Vec::new(), body, call);
    parts.interface = outer;
    let needed = |xml: &mut Xml| {
        xml.open("pou", &[("name", &repeated.block), ("pouType", "functionBlock")]);
        project::unit(xml, &inner, &[], Some("one micro-step of the chart"), options.dialect, ladder);
    };
    Ok(project::write_with(&parts, &options, needed, &[], |xml, dialect| dialect.body(xml, "ST", &parts.body)))
}

/// The instance whose variables hold the situation, if the rungs are a function block of their own.
pub fn instance(program: &Program) -> Option<EcoString> {
    let repeat = program.repeat?;
    Some(Repeated::new(program, &mut Names::new(program, Family::Iec), repeat).instance)
}

/// The rungs of a program, and the variables that only they need.
fn draw(program: &Program, names: &mut Names, repeated: Option<&Repeated>) -> (Vec<Rung>, Vec<Entry>) {
    let spelt = names.clone();
    let texts = Texts::new(program, &spelt);
    let mut timers = Vec::new();
    let mut timer_outputs = IndexVec::new();
    for (id, timer) in program.timers.iter_enumerated() {
        let (pin, ty, note) = match timer.preset {
            Some(_) => ("Q", Type::Bool, "has run out"),
            None => ("ET", Type::Time, "has run for so long"),
        };
        let name = names.namer.name(&format!("{}_{pin}", spelt.timers[id]));
        let comment = Some(format!("{} {note}", spelt.timers[id]).into());
        timers.push(Entry { comment, ..Entry::plain(name.clone(), ty) });
        timer_outputs.push(name);
    }
    let mut ladder = Ladder {
        program,
        names,
        texts: &texts,
        timer_outputs,
        enabled: branches::enabled(program),
        rungs: Vec::new(),
        parts: Vec::new(),
        comments: Vec::new(),
        said: String::new(),
        known: FxHashMap::default(),
    };
    let at_first = repeated.and_then(Repeated::at_first);
    let (asked, reaction) = program.asked_and_reaction();
    match repeated {
        Some(repeated) => ladder.block(&repeated.asked_of_rungs(asked), at_first.as_ref()),
        None => ladder.block(asked, None),
    }
    ladder.block(reaction, None);
    for statements in program.before.chunk_by(|a, b| repeat::is_call(a) == repeat::is_call(b)) {
        ladder.block(statements, at_first.as_ref().filter(|_| !statements.iter().all(repeat::is_call)));
    }
    ladder.block(&program.micro_step, None);
    let at_last = repeated.and_then(|repeated| repeated.at_last(&mut ladder));
    ladder.block(&program.after, at_last.as_ref());
    if ladder.rungs.is_empty() {
        nothing(&mut ladder);
    }
    let Ladder { rungs, parts, .. } = ladder;
    (rungs, timers.into_iter().chain(parts).collect())
}

/// A body may not be empty.
fn nothing(ladder: &mut Ladder) {
    let mut writable = ladder.program.variables.iter_enumerated().filter(|(_, v)| v.role != Role::Constant);
    let bit = writable.clone().find(|(_, v)| v.ty == Type::Bool);
    if let Some((id, variable)) = bit.or_else(|| writable.next()) {
        let name = ladder.name(id);
        ladder.comments.push("nothing ever changes".to_owned());
        if variable.ty == Type::Bool {
            let contact = Contact { name: name.clone(), negated: false };
            ladder.coil(vec![Item::Contact(contact)], &name, Storage::Plain);
        } else {
            ladder.move_to(id, name, Vec::new());
        }
    }
}

/// A local variable of a type, with a few words on it.
fn local(name: &EcoString, ty: EntryType, note: &str) -> Entry {
    Entry { ty, comment: Some(note.into()), ..Entry::plain(name.clone(), Type::Bool) }
}
