//! Traces that show a fault.

use grafc_formula::Value;
use grafc_model::trace::heading;
use std::fmt::Write as _;

/// Reactions one after the other.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Trace {
    /// The names of the inputs.
    pub inputs: Vec<String>,
    /// The reactions.
    pub rows: Vec<Row>,
}

/// A reaction of a trace.
#[derive(Clone, PartialEq, Debug)]
pub struct Row {
    /// When it takes place.
    pub t_ms: i64,
    /// A value for each input, in order of declaration.
    pub inputs: Vec<Value>,
    /// The labels of the steps that are active after it; none if it does not end.
    pub steps: Option<Vec<String>>,
}

impl Trace {
    /// The trace as `grafc sim` reads it.
    pub fn csv(&self) -> String {
        let mut out = String::from("t_ms");
        for name in &self.inputs {
            let _ = write!(out, ",{}", heading(name));
        }
        out.push('\n');
        for row in &self.rows {
            let _ = write!(out, "{}", row.t_ms);
            for value in &row.inputs {
                let _ = write!(out, ",{}", cell(*value));
            }
            out.push('\n');
        }
        out
    }
}

/// A value as a trace has it.
pub fn cell(value: Value) -> String {
    match value {
        Value::Bool(b) => u8::from(b).to_string(),
        Value::Int(n) | Value::Time(n) => n.to_string(),
        Value::Real(x) => x.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trace_is_a_table_of_inputs() {
        let row = |t_ms, a, n| Row { t_ms, inputs: vec![Value::Bool(a), Value::Int(n)], steps: None };
        let trace = Trace { inputs: vec!["a".into(), "n".into()], rows: vec![row(0, false, -3), row(1, true, 7)] };
        assert_eq!(trace.csv(), "t_ms,a,n\n0,0,-3\n1,1,7\n");
    }
}
