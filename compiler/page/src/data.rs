//! What the script has to know of a chart: names, comments, types, and what is in what, in order of declaration.

use grafc_model::chart::{ExprId, ExprKind, Node, Tables, Value, VariableId, VariableKind};
use grafc_model::dump::type_name;
use rustc_hash::FxHashMap;
use serde::Serialize;

/// The root.
#[derive(Serialize)]
struct Data<'a> {
    name: &'a str,
    comment: Option<&'a str>,
    variables: Vec<Variable<'a>>,
    steps: Vec<Step<'a>>,
    macros: Vec<Macro<'a>>,
    grafcets: Vec<Grafcet<'a>>,
    transitions: Vec<Transition<'a>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    claims: Vec<Claim<'a>>,
}

#[derive(Serialize)]
struct Variable<'a> {
    name: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    comment: Option<&'a str>,
    kind: &'static str,
    #[serde(rename = "type")]
    ty: &'static str,
    initial: Number,
    /// The numbers that an input is compared with: its slider reaches a little beyond them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    marks: Vec<Number>,
}

/// A value as the script has it. JSON has no word for what is no number or infinite.
#[derive(Serialize, Clone, Copy)]
#[serde(untagged)]
enum Number {
    Bool(bool),
    Int(i64),
    Real(f64),
    Word(&'static str),
}

impl From<Value> for Number {
    fn from(value: Value) -> Self {
        match value {
            Value::Bool(truth) => Number::Bool(truth),
            Value::Int(number) | Value::Time(number) => Number::Int(number),
            Value::Real(number) if number.is_finite() => Number::Real(number),
            Value::Real(number) if number.is_nan() => Number::Word("NaN"),
            Value::Real(number) => Number::Word(if number > 0.0 { "inf" } else { "-inf" }),
        }
    }
}

#[derive(Serialize)]
struct Step<'a> {
    label: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    comment: Option<&'a str>,
    grafcet: usize,
    /// The macro-step whose expansion holds it.
    #[serde(skip_serializing_if = "Option::is_none")]
    within: Option<usize>,
}

#[derive(Serialize)]
struct Macro<'a> {
    label: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    comment: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    within: Option<usize>,
}

#[derive(Serialize)]
struct Grafcet<'a> {
    name: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    comment: Option<&'a str>,
    /// The label of the step that encloses it.
    #[serde(skip_serializing_if = "Option::is_none")]
    enclosing: Option<&'a str>,
}

#[derive(Serialize)]
struct Transition<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    designation: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    comment: Option<&'a str>,
    before: Vec<&'a str>,
    after: Vec<&'a str>,
}

#[derive(Serialize)]
struct Claim<'a> {
    kind: &'static str,
    /// Its text or, without one, its body.
    name: &'a str,
}

/// The chart as JSON that can stand in a page.
pub(crate) fn json(chart: &Tables) -> Result<String, serde_json::Error> {
    let marks = marks(chart);
    let label = |node: &Node| match *node {
        Node::Step(id) => chart.steps[id].label.as_str(),
        Node::Macro(id) => chart.macro_steps[id].label.as_str(),
    };
    let data = Data {
        name: &chart.name,
        comment: chart.comment.as_deref(),
        variables: chart
            .variables
            .iter_enumerated()
            .map(|(id, variable)| Variable {
                name: &variable.name,
                comment: variable.comment.as_deref(),
                kind: kind(variable.kind),
                ty: type_name(variable.ty),
                initial: variable.initial().into(),
                marks: marks.get(&id).cloned().unwrap_or_default(),
            })
            .collect(),
        steps: chart
            .steps
            .iter()
            .map(|step| Step {
                label: &step.label,
                comment: step.comment.as_deref(),
                grafcet: step.grafcet.index(),
                within: step.expansion_of.map(|id| id.index()),
            })
            .collect(),
        macros: chart
            .macro_steps
            .iter()
            .map(|of| Macro {
                label: &of.label,
                comment: of.comment.as_deref(),
                within: of.expansion_of.map(|id| id.index()),
            })
            .collect(),
        grafcets: chart
            .grafcets
            .iter()
            .map(|grafcet| Grafcet {
                name: &grafcet.name,
                comment: grafcet.comment.as_deref(),
                enclosing: grafcet.enclosing_step.map(|id| chart.steps[id].label.as_str()),
            })
            .collect(),
        transitions: chart
            .transitions
            .iter()
            .map(|transition| Transition {
                designation: transition.designation.as_deref(),
                comment: transition.comment.as_deref(),
                before: transition.pre.iter().map(label).collect(),
                after: transition.post.iter().map(label).collect(),
            })
            .collect(),
        claims: chart
            .claims
            .list
            .iter()
            .map(|claim| Claim { kind: claim.kind.keyword(), name: claim.name() })
            .collect(),
    };
    serde_json::to_string(&data).map(|text| in_html(&text))
}

/// JSON between the tags of a script. The signs are in strings alone, where they can be written otherwise.
pub(crate) fn in_html(json: &str) -> String {
    let mut out = String::with_capacity(json.len());
    for c in json.chars() {
        match c {
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' => out.push_str(&format!("\\u{:04x}", c as u32)),
            c => out.push(c),
        }
    }
    out
}

fn kind(kind: VariableKind) -> &'static str {
    match kind {
        VariableKind::Input => "input",
        VariableKind::Output => "output",
        VariableKind::Internal => "internal",
        VariableKind::Constant => "constant",
    }
}

/// The literals and constants that each numeric input is compared with.
fn marks(chart: &Tables) -> FxHashMap<VariableId, Vec<Number>> {
    let mut found: FxHashMap<VariableId, Vec<Number>> = FxHashMap::default();
    let bare = |id: ExprId| {
        let mut id = id;
        while let ExprKind::Widen(inner) = chart.exprs[id].kind {
            id = inner;
        }
        chart.exprs[id].kind
    };
    for expr in &chart.exprs {
        let ExprKind::Compare(_, a, b) = expr.kind else { continue };
        for (side, other) in [(bare(a), bare(b)), (bare(b), bare(a))] {
            if let (ExprKind::Variable(id), Some(value)) = (side, chart.constant(&other))
                && chart.variables[id].kind == VariableKind::Input
            {
                found.entry(id).or_default().push(value.into());
            }
        }
    }
    found
}
