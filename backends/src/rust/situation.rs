//! The situation: which steps are active.

use super::items::function;
use super::memory::{WORD, words};
use super::names::RustNames;
use super::places::Places;
use super::steps;
use crate::comment::clean;
use crate::writer::Writer;
use ecow::eco_format;
use grafc_logic::scan::{Held, Program, StepId};
use std::cmp::Ordering;

/// Writes what asks for active steps, and what sets bits of the packed situation.
pub(super) fn write(out: &mut Writer, program: &Program, names: &RustNames, places: &Places) {
    function(
        out,
        "The situation: the active steps, in order of declaration.",
        "pub fn active_steps(&self) -> impl Iterator<Item = Step> + '_",
        &["Step::ALL.into_iter().filter(|step| self.is_active(*step))"],
    );
    let situation = Situation { program, names, places };
    situation.is_active(out);
    situation.set(out);
}

struct Situation<'p> {
    program: &'p Program,
    names: &'p RustNames,
    places: &'p Places<'p>,
}

impl Situation<'_> {
    fn is_active(&self, out: &mut Writer) {
        let head = "pub const fn is_active(&self, step: Step) -> bool";
        if words(self.program) > 0 {
            let line = format!("self.situation[step as usize / {WORD}] >> (step as usize % {WORD}) & 1 != 0");
            return function(out, "Whether a step is active.", head, &[&line]);
        }
        out.line("/// Whether a step is active; none is before the first scan.");
        out.open("pub fn is_active(&self, step: Step) -> bool {");
        if let Some(started) = self.program.started {
            out.open(&format!("if !{} {{", self.places.read(started)));
            out.line("return false;");
            out.close("}");
        }
        if self.program.steps.len() > steps::MANY {
            self.runs_of_steps(out);
        } else {
            out.open("match step {");
            for s in self.program.steps.indices() {
                let value = match self.program.steps[s].held {
                    Held::Bit(bit) => self.places.read(bit),
                    Held::State(state, value) => {
                        let state = self.program.states[state].variable;
                        let variant = self.places.variant(state, value).unwrap_or_default();
                        eco_format!("{} == {variant}", self.places.read(state))
                    }
                };
                steps::arm(out, &format!("Step::{}", self.names.steps[s]), &value);
            }
            out.close("}");
        }
        out.close("}");
        out.blank();
    }

    /// The same of many steps. A set that excludes each other has them in the order of the chart mostly, and then an arm
    /// serves a run of them: rustc takes minutes for a `match` of a hundred thousand variants.
    fn runs_of_steps(&self, out: &mut Writer) {
        // The first step of a run and the last, and what holds the first.
        let mut runs: Vec<(usize, usize, Held)> = Vec::new();
        for (number, step) in self.program.steps.iter().enumerate() {
            match (runs.last_mut(), step.held) {
                (Some((first, last, Held::State(of, at))), Held::State(state, value))
                    if state == *of
                        && number == *last + 1
                        && self.place(state, value) == self.place(state, *at) + (number - *first) =>
                {
                    *last = number;
                }
                _ => runs.push((number, number, step.held)),
            }
        }
        let label = |number: usize| clean(&self.program.steps[StepId::from(number)].label);
        out.open("match step as usize {");
        for (first, last, held) in runs {
            let one = first == last;
            out.comment(&if one {
                format!("step {}", label(first))
            } else {
                format!("steps {} to {}", label(first), label(last))
            });
            let value = match held {
                Held::Bit(bit) => self.places.read(bit),
                Held::State(state, value) => {
                    let place = self.place(state, value);
                    let number = match place.cmp(&first) {
                        Ordering::Equal => "step as usize".to_owned(),
                        Ordering::Less => format!("step as usize - {}", first - place),
                        Ordering::Greater => format!("step as usize + {}", place - first),
                    };
                    eco_format!("{} as usize == {number}", self.places.read(self.program.states[state].variable))
                }
            };
            steps::arm(out, &if one { first.to_string() } else { format!("{first}..={last}") }, &value);
        }
        out.line("_ => false,");
        out.close("}");
    }

    /// At which place of the variants of a state a value is.
    fn place(&self, state: usize, value: i64) -> usize {
        self.names.states[state].place(value)
    }

    fn set(&self, out: &mut Writer) {
        if words(self.program) == 0 {
            return;
        }
        out.line("const fn set(&mut self, step: Step, active: bool) {");
        out.enter();
        out.line(&format!("let mask = 1 << (step as usize % {WORD});"));
        out.open("if active {");
        out.line(&format!("self.situation[step as usize / {WORD}] |= mask;"));
        out.leave();
        out.open("} else {");
        out.line(&format!("self.situation[step as usize / {WORD}] &= !mask;"));
        out.close("}");
        out.close("}");
        out.blank();
    }
}
