//! Two runs of one chart, which should be alike.

use crate::charts;
use crate::named_trace::NamedTrace;
use grafc_model::chart::{Chart, Value};
use grafc_model::reaction::{Profile, Response, Stimulus};

/// The first row in which two runs differ.
pub fn first_difference(left: &[Response], right: &[Response]) -> Option<usize> {
    let rows = left.len().max(right.len());
    (0..rows).find(|&row| match (left.get(row), right.get(row)) {
        (Some(l), Some(r)) => !same(l, r),
        (_, _) => true,
    })
}

/// Equality in which a NaN equals a NaN, whatever its payload.
fn same(left: &Response, right: &Response) -> bool {
    let equal = |(l, r): (&Value, &Value)| match (l, r) {
        (Value::Real(l), Value::Real(r)) => l == r || l.is_nan() && r.is_nan(),
        (l, r) => l == r,
    };
    left.situation == right.situation
        && left.flags == right.flags
        && left.outputs.len() == right.outputs.len()
        && left.outputs.iter().zip(&right.outputs).all(equal)
}

/// The first row in which the situations differ; rows after a livelock are no stable situations.
pub fn first_other_situation(left: &[Response], right: &[Response]) -> Option<usize> {
    left.iter()
        .zip(right)
        .take_while(|(l, r)| !l.flags.livelock && !r.flags.livelock)
        .position(|(l, r)| l.situation != r.situation)
}

/// Two runs that should be one: everything needed to see it again.
pub fn report(chart: &Chart, profile: Profile, stimuli: &[Stimulus], left: &[Response], right: &[Response]) -> String {
    let row = first_difference(left, right).unwrap_or_default();
    let up_to = |run: &[Response]| {
        let rows = (row + 1).min(run.len()).min(stimuli.len());
        charts::spell(chart, &stimuli[..rows], &run[..rows])
    };
    let last = |text: String| text.lines().last().unwrap_or_default().to_string();
    let (left, right) = (up_to(left), up_to(right));
    format!(
        "{}\nrow {row}\n  columns   {}\n  simulator {}\n  other     {}\n{}",
        charts::profile_line(profile),
        left.lines().next().unwrap_or_default(),
        last(left.clone()),
        last(right),
        NamedTrace::of(chart, &stimuli[..(row + 1).min(stimuli.len())]).to_csv(),
    )
}
