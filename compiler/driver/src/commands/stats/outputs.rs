//! `grafc stats --outputs`: which outputs are on in which situation.

use super::table::{counted, wrap};
use grafc::Document;
use grafc_logic::{StoredOutput, When, output_table};
use grafc_model::chart::{Chart, Mode, StepId, VariableId, VariableKind};
use serde::Serialize;
use std::collections::BTreeMap;

/// Lines of the table are at most this long, except where one column is wider; what does not fit is a further table.
const WIDTH: usize = 100;

/// A table of more cells nobody reads; most of them say that an output is off. Then there is a list.
const MOST_CELLS: usize = 20_000;

/// What outputs do. The names of the fields are those of the JSON object.
#[derive(Serialize)]
pub struct Outputs {
    chart: String,
    /// The outputs of continuous actions.
    outputs: Vec<String>,
    situations: Vec<Situation>,
    stored: Vec<Stored>,
}

#[derive(Serialize)]
struct Situation {
    grafcet: String,
    steps: Vec<String>,
    /// Whether it is a whole situation, and not a step of one.
    whole: bool,
    on: Vec<String>,
    /// Outputs with the conditions of which one must be true.
    #[serde(rename = "if")]
    on_if: BTreeMap<String, Vec<String>>,
}

#[derive(Serialize)]
struct Stored {
    output: String,
    written: Vec<String>,
    never_reset: bool,
    /// The orders `{}` after which it may be on.
    stays_on: Vec<Order>,
    retain: bool,
}

#[derive(Serialize)]
struct Order {
    grafcet: String,
    /// The forcing step.
    by: String,
}

impl Outputs {
    /// None where the chart has errors.
    pub fn new(document: &Document) -> Option<Outputs> {
        let (chart, analysis) = (document.chart()?, document.analysis()?);
        let table = output_table(analysis);
        let name = |v: &VariableId| chart.variables[*v].name.to_string();
        let situations = table.rows.iter().map(|row| {
            let (mut on, mut on_if) = (Vec::new(), BTreeMap::new());
            for (v, when) in &row.outputs {
                match when {
                    When::Always => on.push(name(v)),
                    When::If(conditions) => {
                        on_if.insert(name(v), conditions.clone());
                    }
                }
            }
            let grafcet = chart.grafcets[row.grafcet].name.to_string();
            let steps = row.steps.iter().map(|s| label(chart, *s)).collect();
            Situation { grafcet, steps, whole: row.is_situation, on, on_if }
        });
        let stored = |stored: &StoredOutput| Stored {
            output: name(&stored.variable),
            written: stored.written.clone(),
            never_reset: stored.is_never_reset,
            stays_on: stored
                .stays_on
                .iter()
                .map(|(g, s)| Order { grafcet: chart.grafcets[*g].name.to_string(), by: label(chart, *s) })
                .collect(),
            retain: stored.is_retained,
        };
        let wires = chart.variables.iter().filter(|v| v.kind == VariableKind::Output && v.mode == Mode::Wire);
        Some(Outputs {
            chart: chart.name.to_string(),
            outputs: wires.map(|v| v.name.to_string()).collect(),
            situations: situations.collect(),
            stored: table.stored.iter().map(stored).collect(),
        })
    }

    pub fn json(&self) -> String {
        // Strings and truths alone cannot be refused.
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }

    pub fn table(&self) -> String {
        let mut out = format!(
            "{}: {}, {}\n",
            self.chart,
            counted(self.outputs.len(), "output of continuous actions", "outputs of continuous actions"),
            counted(self.stored.len(), "of stored ones", "of stored ones"),
        );
        if self.outputs.len() * self.situations.len() <= MOST_CELLS {
            self.matrices(&mut out);
        } else {
            self.list(&mut out);
        }
        self.conditions(&mut out);
        if !self.stored.is_empty() {
            out.push_str("\nstored\n");
            let indent = 4 + self.stored.iter().map(|stored| stored.output.chars().count()).max().unwrap_or_default();
            for stored in &self.stored {
                stored.list(indent, &mut out);
            }
        }
        out
    }

    /// Situations down, outputs across, as many at a time as the width allows.
    fn matrices(&self, out: &mut String) {
        if self.outputs.is_empty() {
            return;
        }
        let heads: Vec<String> = self.situations.iter().map(Situation::head).collect();
        let first = heads.iter().map(|head| head.chars().count()).max().unwrap_or_default();
        let mut left = self.outputs.as_slice();
        while !left.is_empty() {
            let mut end = first;
            let fits = left.iter().take_while(|name| {
                end += 2 + cell_width(name);
                end <= WIDTH
            });
            let (columns, rest) = left.split_at(fits.count().max(1));
            left = rest;
            out.push('\n');
            let mut head = " ".repeat(first);
            columns.iter().for_each(|name| head.push_str(&format!("  {name:<width$}", width = cell_width(name))));
            out.push_str(head.trim_end());
            out.push('\n');
            for (situation, head) in self.situations.iter().zip(&heads) {
                let mut line = format!("{head:<first$}");
                for name in columns {
                    line.push_str(&format!("  {:<width$}", situation.cell(name), width = cell_width(name)));
                }
                out.push_str(line.trim_end());
                out.push('\n');
            }
        }
        self.about_steps(out);
    }

    /// Situations down, behind each the outputs that are on.
    fn list(&self, out: &mut String) {
        out.push('\n');
        let heads: Vec<String> = self.situations.iter().map(Situation::head).collect();
        let indent = 4 + heads.iter().map(|head| head.chars().count()).max().unwrap_or_default();
        for (situation, head) in self.situations.iter().zip(&heads) {
            let on = situation.on.iter().cloned();
            let on_if = situation.on_if.keys().map(|name| format!("{name} (if)"));
            let names: Vec<String> = on.chain(on_if).collect();
            let names = if names.is_empty() { "-".to_owned() } else { names.join(", ") };
            wrap(out, head, indent, &names.split(' ').collect::<Vec<_>>());
        }
        self.about_steps(out);
    }

    /// What a line that is no situation means.
    fn about_steps(&self, out: &mut String) {
        if self.situations.iter().any(|situation| !situation.whole) {
            out.push_str(
                "\nA line with `+` is a step that may be active together with others: an output is on if one of\n\
                 them has it on.\n",
            );
        }
    }

    /// What `if` in the table stands for.
    fn conditions(&self, out: &mut String) {
        let mut of_outputs: BTreeMap<&str, Vec<(String, String)>> = BTreeMap::new();
        for situation in &self.situations {
            for (name, conditions) in &situation.on_if {
                let place = format!("{name} in {}", situation.steps.join(" "));
                of_outputs.entry(name).or_default().push((place, conditions.join(" or ")));
            }
        }
        let lines = self.outputs.iter().filter_map(|name| of_outputs.remove(name.as_str())).flatten();
        let lines: Vec<(String, String)> = lines.collect();
        if lines.is_empty() {
            return;
        }
        out.push_str("\nif\n");
        let indent = 4 + lines.iter().map(|(place, _)| place.chars().count()).max().unwrap_or_default();
        for (place, text) in lines {
            wrap(out, &place, indent, &text.split(' ').filter(|word| !word.is_empty()).collect::<Vec<_>>());
        }
    }
}

/// The width of a column.
fn cell_width(name: &str) -> usize {
    name.chars().count().max(2)
}

impl Situation {
    fn head(&self) -> String {
        format!("{}: {}{}", self.grafcet, self.steps.join(" "), if self.whole { "" } else { " +" })
    }

    fn cell(&self, output: &str) -> &'static str {
        match () {
            () if self.on.iter().any(|name| name == output) => "on",
            () if self.on_if.contains_key(output) => "if",
            () => "-",
        }
    }
}

impl Stored {
    fn list(&self, indent: usize, out: &mut String) {
        let mut notes = self.written.clone();
        notes.extend(self.never_reset.then(|| "never reset".to_owned()));
        notes.extend(
            self.stays_on.iter().map(|order| format!("may stay on after {}{{}} by {}", order.grafcet, order.by)),
        );
        notes.extend(self.retain.then(|| "keeps its value over a restart".to_owned()));
        for (place, note) in notes.iter().enumerate() {
            let name = if place == 0 { self.output.as_str() } else { "" };
            wrap(out, name, indent, &note.split(' ').collect::<Vec<_>>());
        }
    }
}

fn label(chart: &Chart, s: StepId) -> String {
    chart.steps[s].label.to_string()
}
