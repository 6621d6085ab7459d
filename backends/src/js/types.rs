//! The declarations for TypeScript, which stand beside a module.

use super::Options;
use super::memory::about;
use super::names::Names;
use super::shows_all;
use super::text::{comment, quoted, type_key};
use crate::writer::{self, Writer};
use grafc_formula::Type;
use grafc_logic::scan::{Program, Role};

/// Of so many steps or transitions a type can be made of their names; compilers stop at very many.
const MOST_NAMED: usize = 1000;

/// Writes them.
pub(super) fn write(program: &Program, names: &Names, options: &Options) -> String {
    let mut out = Writer::new(&writer::JS);
    let class = &names.class;
    let title = program.comment.as_deref().map(comment).filter(|text| !text.is_empty());
    let name = comment(&program.name);
    out.comment(&title.map_or(name.clone(), |title| format!("{name}: {title}")));
    if !options.header.is_empty() {
        out.line("//");
    }
    options.header.iter().for_each(|line| out.comment(&comment(line)));
    out.blank();
    variables(&mut out, program, &format!("{class}Inputs"), "The inputs of the chart.", Role::Input);
    variables(&mut out, program, &format!("{class}Outputs"), "The outputs of the chart.", Role::Output);
    let steps: Vec<_> = program.steps.iter().map(|step| quoted(&step.label)).collect();
    named(&mut out, &format!("{class}Step"), "The label of a step.", &steps);
    let names_of = super::tables::names_of_transitions(program);
    let transitions = program.observing.iter().flat_map(|observing| &observing.transitions);
    let transitions: Vec<_> = transitions.map(|seen| quoted(&names_of[seen.transition])).collect();
    named(
        &mut out,
        &format!("{class}Transition"),
        "The designation of a transition, or `#` and its number in order of declaration.",
        &transitions,
    );
    let mut text = include_str!("runtime/types.d.ts").to_owned();
    if program.variables.iter().any(|variable| variable.retain) {
        text = text.replace("    // restart\n", RESTART);
    }
    if shows_all(program) {
        text = text.replace("    // observed\n", include_str!("runtime/observed.d.ts"));
    }
    for line in text.lines().filter(|line| !matches!(line.trim(), "// restart" | "// observed")) {
        if line.is_empty() { out.blank() } else { out.line(&line.replace("CHART", class)) }
    }
    out.finish()
}

/// What a chart that retains something has as well.
const RESTART: &str = "
    /** As after a restart of the controller: as before the first scan, but for what the chart retains. */
    restart(): void;
";

fn variables(out: &mut Writer, program: &Program, name: &str, text: &str, role: Role) {
    out.blank();
    out.line(&format!("/** {text} */"));
    if program.of_role(role).next().is_none() {
        return out.line(&format!("export type {name} = Record<string, never>;"));
    }
    out.open(&format!("export interface {name} {{"));
    for (id, variable) in program.of_role(role) {
        let remark = about(program, id);
        let of = type_name(variable.ty);
        let words: Vec<&str> = [remark.as_str(), of.1].into_iter().filter(|text| !text.is_empty()).collect();
        if !words.is_empty() {
            out.line(&format!("/** {} */", words.join("; ")));
        }
        out.line(&format!("{}: {};", type_key(&variable.name), of.0));
    }
    out.close("}");
}

/// A type of TypeScript, and what it does not say.
fn type_name(ty: Type) -> (&'static str, &'static str) {
    match ty {
        Type::Bool => ("boolean", ""),
        Type::Int => ("number", "a whole number from -32768 to 32767"),
        Type::Dint => ("number", "a whole number from -2147483648 to 2147483647"),
        Type::Uint => ("number", "a whole number from 0 to 65535"),
        Type::Udint => ("number", "a whole number from 0 to 4294967295"),
        Type::Real => ("number", "of single precision"),
        Type::Lreal | Type::Time => ("number", ""),
    }
}

fn named(out: &mut Writer, name: &str, text: &str, names: &[ecow::EcoString]) {
    out.blank();
    out.line(&format!("/** {text} */"));
    match names {
        [] => out.line(&format!("export type {name} = never;")),
        _ if names.len() > MOST_NAMED => out.line(&format!("export type {name} = string;")),
        _ => {
            let flat = format!("export type {name} = {};", names.join(" | "));
            if flat.chars().count() <= out.width() {
                return out.line(&flat);
            }
            out.open(&format!("export type {name} ="));
            for (place, label) in names.iter().enumerate() {
                out.line(&format!("| {label}{}", if place + 1 == names.len() { ";" } else { "" }));
            }
            out.leave();
        }
    }
}
