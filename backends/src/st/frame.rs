//! What stands around the function block: a program that wires it to addresses, a configuration that runs the program.

use super::declarations::{self, Block, Entry, EntryType, entry, is_published, local};
use super::literals::time;
use super::names::Names;
use crate::writer::Writer;
use grafc_logic::scan::{Program, Role, VarId, Variable};

/// Writes a program with one instance of the block.
pub(super) fn program(out: &mut Writer, program: &Program, names: &Names) {
    out.blank();
    out.line(&format!("PROGRAM {}", names.program));
    declarations::write(out, &variables(program, names));
    body(out, program, names);
    out.blank();
    out.line("END_PROGRAM");
}

fn inputs(program: &Program) -> impl Iterator<Item = (VarId, &Variable)> {
    program.variables.iter_enumerated().filter(|(_, variable)| variable.role == Role::Input)
}

fn published(program: &Program) -> impl Iterator<Item = (VarId, &Variable)> {
    program.variables.iter_enumerated().filter(|(_, variable)| is_published(variable))
}

/// The variables of the program: those at addresses, then the others and the instance.
pub(super) fn variables(program: &Program, names: &Names) -> Vec<Block> {
    let mut located = Vec::new();
    let mut plain = Vec::new();
    for (id, variable) in inputs(program).chain(published(program)) {
        match address(variable) {
            Some(address) => located.push(located_entry(id, variable, names, address)),
            None => plain.push(entry(id, variable, names)),
        }
    }
    plain.push(Entry {
        name: names.instance.clone(),
        address: None,
        ty: EntryType::Block(names.block.clone()),
        initial: None,
        comment: None,
    });
    vec![local(located), local(plain)]
}

/// The statements of the program.
pub(super) fn body(out: &mut Writer, program: &Program, names: &Names) {
    call(out, names, inputs(program).map(|(id, _)| id));
    for (id, _) in published(program) {
        let name = &names.variables[id];
        out.line(&format!("{name} := {}.{name};", names.instance));
    }
}

/// Calls the instance, inputs by name.
fn call(out: &mut Writer, names: &Names, inputs: impl Iterator<Item = VarId>) {
    let arguments: Vec<String> = inputs.map(|id| format!("{0} := {0}", names.variables[id])).collect();
    let flat = format!("{}({});", names.instance, arguments.join(", "));
    if flat.len() <= out.width() {
        return out.line(&flat);
    }
    out.open(&format!("{}(", names.instance));
    for (place, argument) in arguments.iter().enumerate() {
        out.line(&format!("{argument}{}", if place + 1 < arguments.len() { "," } else { "" }));
    }
    out.close(");");
}

/// Writes a configuration with one cyclic task.
pub(super) fn configuration(out: &mut Writer, names: &Names, interval_ms: u32) {
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

/// A variable at its address; an input has no initial value, for it is read before each call.
fn located_entry(id: VarId, variable: &Variable, names: &Names, address: String) -> Entry {
    let mut entry = entry(id, variable, names);
    entry.address = Some(address);
    if variable.role == Role::Input {
        entry.initial = None;
    }
    entry
}
