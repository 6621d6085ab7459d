//! A trace that fits a chart and what is left of it.

use grafc_model::chart::{Chart, Value, VariableKind};
use grafc_model::reaction::Stimulus;
use grafc_model::trace::heading;
use std::ops::Range;

/// A trace by the names of inputs, so that it survives the deletion of one.
#[derive(Clone, Debug)]
pub struct NamedTrace {
    names: Vec<String>,
    rows: Vec<Stimulus>,
}

impl NamedTrace {
    /// The stimuli of a chart.
    pub fn of(chart: &Chart, rows: &[Stimulus]) -> Self {
        let inputs = chart.variables.iter().filter(|v| v.kind == VariableKind::Input);
        NamedTrace { names: inputs.map(|v| v.name.to_string()).collect(), rows: rows.to_vec() }
    }

    /// The stimuli for a chart that may have fewer inputs.
    pub fn stimuli(&self, chart: &Chart) -> Vec<Stimulus> {
        let inputs: Vec<_> = chart.variables.iter().filter(|v| v.kind == VariableKind::Input).collect();
        let column = |name: &str| self.names.iter().position(|n| n == name);
        let value = |row: &Stimulus, name: &str, initial: Value| column(name).map_or(initial, |i| row.inputs[i]);
        let inputs_of = |row: &Stimulus| inputs.iter().map(|v| value(row, &v.name, v.initial())).collect();
        self.rows.iter().map(|row| Stimulus { t_ms: row.t_ms, restart: row.restart, inputs: inputs_of(row) }).collect()
    }

    /// The trace as a file of it would read.
    pub fn to_csv(&self) -> String {
        let cell = |value: &Value| match value {
            Value::Bool(b) => u8::from(*b).to_string(),
            Value::Int(n) | Value::Time(n) => n.to_string(),
            Value::Real(x) => x.to_string(),
        };
        let restarts = self.rows.iter().any(|row| row.restart);
        let marked =
            |cells: Vec<String>, mark: &str| if restarts { [vec![mark.to_string()], cells].concat() } else { cells };
        let names = self.names.iter().map(|name| heading(name).into_owned()).collect();
        let mut out = format!("t_ms,{}\n", marked(names, "restart").join(","));
        for row in &self.rows {
            let cells = marked(row.inputs.iter().map(cell).collect(), if row.restart { "1" } else { "" });
            out.push_str(&format!("{},{}\n", row.t_ms, cells.join(",")));
        }
        out
    }

    /// So many rows.
    pub(super) fn len(&self) -> usize {
        self.rows.len()
    }

    /// The same without some rows.
    pub(super) fn without(&self, rows: Range<usize>) -> NamedTrace {
        let mut shorter = self.clone();
        shorter.rows.drain(rows);
        shorter
    }

    /// Traces in which less happens: an input stays as it was, no time passes, or the controller does not restart.
    pub(super) fn calmer(&self) -> Vec<NamedTrace> {
        let mut found = Vec::new();
        for row in 0..self.rows.len() {
            let (before, inputs) = match row.checked_sub(1).map(|before| &self.rows[before]) {
                Some(before) => (before.t_ms, before.inputs.clone()),
                None => (0, self.rows[0].inputs.iter().map(|value| zero(*value)).collect()),
            };
            if self.rows[row].restart {
                let mut calm = self.clone();
                calm.rows[row].restart = false;
                found.push(calm);
            }
            let gap = self.rows[row].t_ms - before;
            if gap > 0 {
                let mut calm = self.clone();
                calm.rows[row..].iter_mut().for_each(|later| later.t_ms -= gap);
                found.push(calm);
            }
            for (column, value) in inputs.into_iter().enumerate() {
                if self.rows[row].inputs[column] != value {
                    let mut calm = self.clone();
                    calm.rows[row].inputs[column] = value;
                    found.push(calm);
                }
            }
        }
        found
    }
}

fn zero(value: Value) -> Value {
    match value {
        Value::Bool(_) => Value::Bool(false),
        Value::Int(_) => Value::Int(0),
        Value::Real(_) => Value::Real(0.0),
        Value::Time(_) => Value::Time(0),
    }
}
