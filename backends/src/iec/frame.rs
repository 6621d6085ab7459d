//! What stands around the function block: a program that wires it to addresses, a configuration that runs the program.

use super::declarations::{self, Entry, EntryType, VarBlock, entry, local};
use super::literals::time;
use super::names::Names;
use super::{Options, Pou};
use crate::writer::Writer;
use grafc_logic::scan::{Origin, Program, Role, VarId, Variable};

/// Writes what stands around the function block; `body` is given the names of inputs and of what is published, and
/// writes the statements of the program, which wire the instance to them.
pub(crate) fn write(
    out: &mut Writer,
    program: &Program,
    names: &Names,
    options: &Options,
    body: impl FnOnce(&mut Writer, &[&str], &[&str]),
) {
    match options.pou {
        Pou::FunctionBlock => {}
        Pou::Program => self::program(out, program, names, body),
        Pou::Configuration => {
            self::program(out, program, names, body);
            configuration(out, names, options.interval_ms);
        }
    }
}

/// A program with one instance of the block.
fn program(out: &mut Writer, program: &Program, names: &Names, body: impl FnOnce(&mut Writer, &[&str], &[&str])) {
    out.blank();
    out.line(&format!("PROGRAM {}", names.program));
    declarations::write(out, variables(program, names), declarations::RETAIN);
    let (inputs, published) = wired(program, names);
    body(out, &inputs, &published);
    out.blank();
    out.line("END_PROGRAM");
}

fn inputs(program: &Program) -> impl Iterator<Item = (VarId, &Variable)> {
    program.of_role(Role::Input)
}

fn published(program: &Program) -> impl Iterator<Item = (VarId, &Variable)> {
    program.variables.iter_enumerated().filter(|(_, variable)| variable.is_published())
}

/// The names that the program wires: those of inputs, and of what is published.
pub(crate) fn wired<'n>(program: &Program, names: &'n Names) -> (Vec<&'n str>, Vec<&'n str>) {
    let name = |(id, _): (VarId, &Variable)| names.variables[id].as_str();
    (inputs(program).map(name).collect(), published(program).map(name).collect())
}

/// The variables of the program: those at addresses, then the others and the instance.
pub(crate) fn variables(program: &Program, names: &Names) -> Vec<VarBlock> {
    let mut located = Vec::new();
    let mut plain = Vec::new();
    for (id, variable) in inputs(program).chain(published(program)) {
        match address(variable) {
            Some(address) => located.push(located_entry(id, variable, names, address)),
            None => plain.push(Entry { retain: false, ..entry(id, variable, names) }),
        }
    }
    plain.push(Entry {
        name: names.instance.clone(),
        address: None,
        ty: EntryType::Block(names.block.clone().into()),
        initial: None,
        retain: false,
        comment: None,
        origin: Origin::Chart,
    });
    vec![local(located), local(plain)]
}

/// A configuration with one cyclic task.
fn configuration(out: &mut Writer, names: &Names, interval_ms: u32) {
    out.blank();
    out.open(&format!("CONFIGURATION {}", names.configuration));
    out.open(&format!("RESOURCE {} ON PLC", names.resource));
    out.line(&format!("TASK {}(INTERVAL := {}, PRIORITY := 0);", names.task, time(i64::from(interval_ms))));
    out.line(&format!("PROGRAM {} WITH {} : {};", names.program_instance, names.task, names.program));
    out.close("END_RESOURCE");
    out.close("END_CONFIGURATION");
}

/// An address in the form of IEC 61131-3; one that has another form is not passed on.
fn address(variable: &Variable) -> Option<String> {
    let address = variable.address.as_deref()?.to_ascii_uppercase();
    let rest = address.strip_prefix('%')?.strip_prefix(['I', 'Q', 'M'])?;
    let digits = rest.strip_prefix(['X', 'B', 'W', 'D', 'L']).unwrap_or(rest);
    let is_number = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
    digits.split('.').all(is_number).then_some(address)
}

/// A variable at its address; an input has no initial value, since it is read before each call.
fn located_entry(id: VarId, variable: &Variable, names: &Names, address: String) -> Entry {
    let mut entry = entry(id, variable, names);
    // The block keeps the value; this is what it shows.
    entry.retain = false;
    entry.address = Some(address.into());
    if variable.role == Role::Input {
        entry.initial = None;
    }
    entry
}
