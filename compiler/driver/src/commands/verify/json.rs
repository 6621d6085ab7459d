//! The answers for programs; their form is described in docs/verification.md.

use super::said::fault;
use grafc_model::chart::Value;
use grafc_verify::{Answer, Trace, Verified};
use serde::{Serialize, Serializer};

#[derive(Serialize)]
struct Form<'v> {
    version: u32,
    chart: &'v str,
    states: Count,
    complete: bool,
    claims: Vec<Claim<'v>>,
}

#[derive(Serialize)]
struct Claim<'v> {
    name: &'v str,
    kind: &'static str,
    answer: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    element: Option<&'v str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    why: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    trace: Option<Vec<Row<'v>>>,
}

#[derive(Serialize)]
struct Row<'v> {
    t_ms: i64,
    inputs: Inputs<'v>,
    /// None if the reaction does not end.
    situation: Option<&'v [String]>,
}

/// An object, in the order of the chart.
struct Inputs<'v>(&'v [String], &'v [Value]);

impl Serialize for Inputs<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().zip(self.1.iter().map(|value| Plain(*value))))
    }
}

/// A whole number, as long as it is exact.
struct Count(f64);

impl Serialize for Count {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0 < EXACT { serializer.serialize_u64(self.0 as u64) } else { serializer.serialize_f64(self.0) }
    }
}

/// From here on not every whole number is one of `f64`.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// A value as JSON has it; a time in milliseconds.
struct Plain(Value);

impl Serialize for Plain {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Value::Bool(b) => serializer.serialize_bool(b),
            Value::Int(n) | Value::Time(n) => serializer.serialize_i64(n),
            Value::Real(x) => serializer.serialize_f64(x),
        }
    }
}

/// One object in one line.
pub fn json(chart: &str, verified: &Verified) -> String {
    let claims = verified.verdicts.iter().map(|verdict| {
        let (answer, why, trace) = match &verdict.answer {
            Answer::Holds => ("holds", None, None),
            Answer::Fails(trace) => ("fails", Some(fault(verdict, trace.as_ref())), trace.as_ref().map(rows)),
            Answer::Open(reason) => ("open", Some(reason.to_string()), None),
        };
        let claim = &verdict.claim;
        Claim { name: &claim.name, kind: claim.kind.name(), answer, element: claim.element.as_deref(), why, trace }
    });
    let searched = &verified.searched;
    let form = Form {
        version: 1,
        chart,
        states: Count(searched.states),
        complete: searched.limit.is_none(),
        claims: claims.collect(),
    };
    // Texts and numbers can all be written.
    serde_json::to_string(&form).map(|text| text + "\n").unwrap_or_default()
}

fn rows(trace: &Trace) -> Vec<Row<'_>> {
    let mut out = Vec::with_capacity(trace.rows.len());
    for grafc_verify::Row { t_ms, inputs, steps } in &trace.rows {
        out.push(Row { t_ms: *t_ms, inputs: Inputs(&trace.inputs, inputs), situation: steps.as_deref() });
    }
    out
}
