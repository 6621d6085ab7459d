//! What the cells of a result say of a call, and whether that is what the chart did: recordings and tests share it.

use super::columns::{FLAGS, SITUATION};
use super::row::Row;
use super::said::Said;
use super::situation;
use super::values::parse_value;
use super::write::cell;
use crate::chart::{Chart, StepId, Type, Value, Variable, VariableKind};
use crate::reaction::Response;
use crate::resolve::suggest::Suggestions;
use crate::simulate::Probe;
use ecow::EcoString;
use grafc_diagnostics::{Code, Diagnostic};
use std::collections::{BTreeMap, BTreeSet};

/// What a column is about.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum About {
    /// The output of this place among the outputs.
    Output(usize),
    /// What this probe shows, which is the how manieth of those that are looked at.
    Probe(Probe, usize),
    /// The active steps.
    Situation,
    /// The raised flags.
    Flags,
}

/// What a cell says.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Saying {
    Value(Value),
    Situation(BTreeSet<StepId>),
    Flags(BTreeSet<&'static str>),
}

/// The words of a chart's results.
pub(super) struct Results<'a> {
    pub chart: &'a Chart,
    pub outputs: Vec<&'a Variable>,
    steps: BTreeMap<&'a str, StepId>,
}

const FLAG_NAMES: [&str; 4] = ["LIVELOCK", "ALLOC_CONFLICT", "FORCE_CONFLICT", "DIV0"];

impl<'a> Results<'a> {
    pub fn new(chart: &'a Chart) -> Self {
        let outputs = chart.variables.iter().filter(|v| v.kind == VariableKind::Output).collect();
        let mut steps = BTreeMap::new();
        for (id, step) in chart.steps.iter_enumerated() {
            steps.entry(step.label.as_str()).or_insert(id);
        }
        Results { chart, outputs, steps }
    }

    /// The name of a column.
    pub fn name(&self, about: About) -> EcoString {
        match about {
            About::Output(place) => self.outputs[place].name.clone(),
            About::Probe(probe, _) => probe.name(self.chart),
            About::Situation => SITUATION.into(),
            About::Flags => FLAGS.into(),
        }
    }

    /// The type of its values, if it has values.
    fn value_type(&self, about: About) -> Option<Type> {
        match about {
            About::Output(place) => Some(self.outputs[place].ty),
            About::Probe(probe, _) => Some(probe.ty(self.chart)),
            About::Situation | About::Flags => None,
        }
    }

    /// What a text says. What cannot be read is reported, and of a value then nothing is left.
    pub fn read(&self, about: About, text: &str, (row, column): (&Row, usize), said: &mut Said) -> Option<Saying> {
        if let Some(ty) = self.value_type(about) {
            return match parse_value(text, ty) {
                Ok(value) => Some(Saying::Value(value)),
                Err(expected) => {
                    let message = format!("`{text}` is not a value of `{}`", self.name(about));
                    said.bad_value(row, column, message, &expected);
                    None
                }
            };
        }
        let mut wrong = |message: String, help: String| {
            let place = said.cell(row, column);
            said.error(Diagnostic::new(Code::E0603, place, message).help(help));
        };
        // A blank cell may mean that nothing is said, so that there is a word for nothing.
        let text = if text == situation::EMPTY { "" } else { text };
        if about == About::Flags {
            let mut found = BTreeSet::new();
            for name in text.split_whitespace() {
                match FLAG_NAMES.iter().find(|flag| **flag == name) {
                    Some(flag) => _ = found.insert(*flag),
                    None => {
                        wrong(format!("`{name}` is not a flag"), format!("the flags are {}", FLAG_NAMES.join(", ")))
                    }
                }
            }
            return Some(Saying::Flags(found));
        }
        let mut found = BTreeSet::new();
        for label in situation::labels(text) {
            match self.steps.get(label) {
                Some(id) => _ = found.insert(*id),
                None => {
                    let meant = Suggestions::new().nearest(label, self.steps.keys().copied());
                    let help = meant.map_or_else(
                        || "write the labels of the active steps, with blanks between them".to_string(),
                        |meant| format!("write `{meant}`"),
                    );
                    wrong(format!("`{label}` is not a step of the chart"), help);
                }
            }
        }
        Some(Saying::Situation(found))
    }

    /// What a call came to, as a column would say it. `looks` is what the probes show.
    pub fn done(&self, about: About, response: &Response, looks: &[Value]) -> Option<Saying> {
        match about {
            About::Output(place) => response.outputs.get(place).copied().map(Saying::Value),
            About::Probe(_, place) => looks.get(place).copied().map(Saying::Value),
            About::Situation => Some(Saying::Situation(response.situation.iter().copied().collect())),
            About::Flags => Some(Saying::Flags(response.flags.names().collect())),
        }
    }

    /// Whether what is said is what was done.
    pub fn agree(&self, about: About, said: &Saying, done: &Saying) -> bool {
        match (said, done, self.value_type(about)) {
            (Saying::Value(a), Saying::Value(b), Some(ty)) => agree(ty, *a, *b),
            (said, done, _) => said == done,
        }
    }

    /// The text of a cell that says this; `{}` is an empty situation, or no flag.
    pub fn spelled(&self, about: About, saying: &Saying) -> String {
        let mut text = match saying {
            Saying::Value(value) => cell(self.value_type(about).unwrap_or(Type::Bool), *value),
            Saying::Situation(steps) => {
                let (mut text, steps) = (String::new(), Vec::from_iter(steps.iter().copied()));
                situation::write(&mut text, self.chart, &steps);
                text
            }
            Saying::Flags(flags) => Vec::from_iter(flags.iter().copied()).join(" "),
        };
        if text.is_empty() {
            text.push_str(situation::EMPTY);
        }
        text
    }
}

/// The columns of a result that are of its own.
pub(super) fn own_columns<R>(of: impl Fn(About) -> R) -> [(&'static str, R); 2] {
    [(SITUATION, of(About::Situation)), (FLAGS, of(About::Flags))]
}

/// Reals agree to as many digits as tools print: six of a `real`, twelve of an `lreal`. What is infinite or no number
/// agrees with its like alone.
pub fn agree(ty: Type, a: Value, b: Value) -> bool {
    let tolerance = if ty == Type::Real { 1e-6 } else { 1e-12 };
    match (a, b) {
        (Value::Real(a), Value::Real(b)) if a.is_finite() && b.is_finite() => {
            a == b || (a - b).abs() <= tolerance * a.abs().max(b.abs())
        }
        (Value::Real(a), Value::Real(b)) => a == b || a.is_nan() && b.is_nan(),
        (a, b) => a == b,
    }
}
