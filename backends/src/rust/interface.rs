//! What a program around the chart sees of its variables: constants, inputs, outputs, internal variables.

use super::items::doc;
use super::literals::{literal, type_name, zero};
use super::names::RustNames;
use crate::comment::remark;
use crate::writer::Writer;
use ecow::EcoString;
use grafc_formula::Type;
use grafc_logic::scan::{Origin, Program, Role, Variable};

/// Writes the constants of the chart.
pub(super) fn constants(out: &mut Writer, program: &Program, names: &RustNames) {
    for (id, variable) in program.of_role(Role::Constant) {
        out.blank();
        let outer = out.origin(Origin::declaration(id));
        document(out, &names.variables[id], variable);
        let value = literal(variable.initial(), variable.ty);
        out.line(&format!("pub const {}: {} = {value};", names.variables[id], type_name(variable.ty)));
        out.origin(outer);
    }
}

/// Writes the three structs of variables; the internal ones only where there are any.
pub(super) fn structs(out: &mut Writer, program: &Program, names: &RustNames) {
    let derived = |default: bool, role| {
        let default = if default { ", Default" } else { "" };
        let equal = if program.of_role(role).count() <= MOST_COMPARED { ", PartialEq" } else { "" };
        format!("#[derive(Clone, Copy, Debug{default}{equal})]")
    };
    // Inputs may have values of their own before they are first read.
    let plain = program.of_role(Role::Input).all(|(_, v)| literal(v.initial(), v.ty) == zero(v.ty));
    let of_inputs = derived(plain, Role::Input);
    structure(out, program, names, Role::Input, "Inputs", "What is read from the plant for a scan.", &of_inputs);
    if !plain {
        out.blank();
        out.open("impl Default for Inputs {");
        out.open("fn default() -> Self {");
        fields(out, "Self", &values(program, names, Role::Input), "");
        out.close("}");
        out.close("}");
    }
    structure(
        out,
        program,
        names,
        Role::Output,
        "Outputs",
        "What a scan gives to the plant.",
        &derived(false, Role::Output),
    );
    if has_variables(program) {
        let about = "The internal variables of the chart.";
        structure(out, program, names, Role::Internal, "Variables", about, &derived(false, Role::Internal));
    }
}

/// Whether the chart has internal variables that keep a value.
pub(super) fn has_variables(program: &Program) -> bool {
    program.of_role(Role::Internal).next().is_some()
}

/// Each variable of a role with its value before the first scan.
pub(super) fn values(program: &Program, names: &RustNames, role: Role) -> Vec<(EcoString, EcoString)> {
    program.of_role(role).map(|(id, v)| (names.variables[id].clone(), literal(v.initial(), v.ty))).collect()
}

fn structure(
    out: &mut Writer,
    program: &Program,
    names: &RustNames,
    role: Role,
    name: &str,
    about: &str,
    derived: &str,
) {
    out.blank();
    out.line(&format!("/// {about}"));
    out.line(derived);
    if program.of_role(role).next().is_none() {
        return out.line(&format!("pub struct {name} {{}}"));
    }
    out.open(&format!("pub struct {name} {{"));
    for (id, variable) in program.of_role(role) {
        let outer = out.origin(Origin::declaration(id));
        document(out, &names.variables[id], variable);
        out.line(&format!("pub {}: {},", names.variables[id], type_name(variable.ty)));
        out.origin(outer);
    }
    out.close("}");
}

/// The comment of a variable; of a time, that it counts milliseconds; its address.
fn document(out: &mut Writer, name: &str, variable: &Variable) {
    let unit = if variable.ty == Type::Time { Some("in milliseconds") } else { None };
    let address = variable.address.as_deref().map(|address| format!("at {address}"));
    let parts = remark(&variable.name, name, variable.comment.as_deref()).into_iter().chain(unit.map(str::to_owned));
    let text = parts.chain(address).collect::<Vec<_>>().join(", ");
    doc(out, if text.is_empty() { &variable.name } else { &text });
}

/// Writes a struct expression, on one line where rustfmt would, with `tail` behind it.
pub(super) fn fields(out: &mut Writer, head: &str, values: &[(EcoString, EcoString)], tail: &str) {
    if values.is_empty() {
        return out.line(&format!("{head} {{}}{tail}"));
    }
    let length: usize = values.iter().map(|(name, value)| name.len() + value.len() + ": , ".len()).sum();
    if length - ", ".len() <= LONGEST_FLAT_STRUCT {
        let flat = values.iter().map(|(name, value)| format!("{name}: {value}")).collect::<Vec<_>>().join(", ");
        return out.line(&format!("{head} {{ {flat} }}{tail}"));
    }
    out.open(&format!("{head} {{"));
    for (name, value) in values {
        out.start();
        [name, ": ", value, ","].into_iter().for_each(|text| out.text(text));
        out.end();
    }
    out.close(&format!("}}{tail}"));
}

/// rustfmt writes shorter struct expressions on one line.
const LONGEST_FLAT_STRUCT: usize = 18;

/// Structs with more fields cannot be compared: rustc runs out of stack where thousands of fields are.
const MOST_COMPARED: usize = 1000;
