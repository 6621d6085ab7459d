//! Saving all memory of a chart as bytes, and going on with it: only with that of this very program, only if not a bit of
//! it has changed, and only if it is a situation that the chart can be in.

use super::memory::{self, WORD, words};
use super::places::Places;
use super::record::{Piece, Record};
use super::split::Split;
use super::steps::filled;
use crate::writer::Writer;
use grafc_logic::scan::{Exclusive, Program, Role, VarId};

/// Writes `save` and `restore`, if the program was made for that.
pub(super) fn write(out: &mut Writer, program: &Program, places: &Places, split: &Split) {
    let Some(restoring) = &program.restoring else { return };
    let pieces = pieces(program, places);
    let inputs = split.restore_outputs.is_some_and(|function| split.functions[function].needs.inputs);
    let mut refused = Vec::new();
    let spare = program.steps.len() % WORD;
    if words(program) > 0 && spare > 0 {
        refused.push(format!("chart.situation[{}] >> {spare} != 0", words(program) - 1));
    }
    if let Some(started) = program.started.filter(|_| words(program) > 0) {
        let started = places.read(started).replacen("self.", "chart.", 1);
        refused.push(format!("!{started} && chart.active_steps().next().is_some()"));
    }
    if !restoring.exclusive.is_empty() {
        refused.push("!chart.is_possible()".into());
    }
    let then = split.restore_outputs.map(|_| if inputs { "inputs" } else { "" });
    let name = |name: &str, used: bool| if used { name.to_owned() } else { format!("_{name}") };
    let given = format!(", {}: &Inputs, {}: u32", name("inputs", inputs), name("now", !program.timers.is_empty()));
    Record {
        what: "the saved memory takes",
        constants: ["SAVED_LEN", "FINGERPRINT"],
        fingerprint: (
            "Which program saved bytes belong to: another chart, or encoding, has another.",
            program.fingerprint(),
        ),
        save: ("save", &["All memory as bytes, to be kept where power does not matter."]),
        restore: (
            "restore",
            &[
                "The chart as it was saved; none if these are not the bytes of this very program, not all as",
                "they were saved, or no situation of the chart. Outputs are those of its situation under",
                "`inputs`. Delays go on at `now`: the time in between does not count.",
            ],
            &given,
        ),
        pieces,
        refused,
        then: then.map(|inputs| format!("chart.restore_outputs({inputs});")),
    }
    .write(out, program, places, split.longest);
    if !restoring.exclusive.is_empty() {
        is_possible(out, program, places, &restoring.exclusive);
    }
}

/// Everything that keeps its value, except what follows from the rest.
fn pieces(program: &Program, places: &Places) -> Vec<Piece> {
    let mut list: Vec<VarId> = memory::fields(program, places).into_iter().flat_map(|(_, group)| group).collect();
    let kept = |role| matches!(role, Role::Output | Role::Internal | Role::Flag(_));
    list.extend(program.variables.iter_enumerated().filter(|(_, v)| kept(v.role)).map(|(id, _)| id));
    let derived = program.derived();
    list.retain(|id| !derived.contains(id));
    let situation = (words(program) > 0).then(|| Piece::Situation(words(program)));
    let timers = program.timers.indices().map(Piece::Timer);
    situation.into_iter().chain(list.into_iter().map(Piece::Variable)).chain(timers).collect()
}

/// Writes the function that tells whether active steps can be active together.
fn is_possible(out: &mut Writer, program: &Program, places: &Places, exclusive: &[Exclusive]) {
    let mut set_of = vec![0_usize; program.steps.len()];
    for (number, set) in (1..).zip(exclusive) {
        set.steps.iter().for_each(|s| set_of[s.index()] = number);
    }
    out.blank();
    out.line("/// For each step the number of the set that it excludes the others of; 0 is none.");
    let head = format!("const SETS: [usize; {}] =", set_of.len());
    filled(out, &head, &set_of.iter().map(usize::to_string).collect::<Vec<_>>());
    out.blank();
    out.line("/// Whether the active steps can be active together.");
    out.open("fn is_possible(&self) -> bool {");
    out.line(&format!("let mut taken = [false; {}];", exclusive.len()));
    out.open("for step in self.active_steps() {");
    out.line("let set = Self::SETS[step as usize];");
    out.open("if set > 0 && core::mem::replace(&mut taken[set - 1], true) {");
    out.line("return false;");
    out.close("}");
    out.close("}");
    let always = exclusive.iter().take_while(|set| set.always).count();
    match program.started.filter(|_| always > 0) {
        None => out.line("true"),
        Some(started) => {
            out.comment("of the first sets, one step is always active");
            let of =
                if always == exclusive.len() { "taken.iter()".into() } else { format!("taken[..{always}].iter()") };
            out.line(&format!("!{} || {of}.all(|taken| *taken)", places.read(started)));
        }
    }
    out.close("}");
}
