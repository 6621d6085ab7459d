//! The commands, one a file: each takes its arguments, does its work, and says how it ended.

pub mod automata;
pub mod check;
pub mod compile;
pub mod completions;
pub mod draw;
pub mod explain;
pub mod fmt;
pub mod generate_tests;
pub mod graph;
mod graphviz;
pub mod import;
pub mod man;
pub mod new;
pub mod page;
pub mod serve;
pub mod sim;
pub mod stats;
pub mod test;
pub mod verify;

use crate::arguments::ProfileArguments;
use crate::report::{Failure, Report};
use crate::stream::Stream;
use grafc::Document;
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::{Claimed, Observed, Program};
use grafc_logic::{Extras, Options, compile_with};
use grafc_model::reaction::{Asked, Profile};
use grafc_verify::Beyond;

/// Standard input can be read once.
fn refuse_second_standard_input<'a>(streams: impl IntoIterator<Item = &'a Stream>) -> Result<(), Failure> {
    match streams.into_iter().filter(|stream| **stream == Stream::Standard).count() {
        0 | 1 => Ok(()),
        _ => Err(Failure::WrongUse(
            "standard input is named twice".to_string(),
            "give one of the inputs as a file".to_string(),
        )),
    }
}

/// An output that is one of the inputs would destroy it.
fn refuse_output_over_input<'a>(output: &Stream, inputs: impl IntoIterator<Item = &'a Stream>) -> Result<(), Failure> {
    match inputs.into_iter().find(|input| output.is_same_file(input)) {
        None => Ok(()),
        Some(input) => Err(Failure::WrongUse(
            format!("the output would overwrite `{}`", input.input_name()),
            "choose another file".to_string(),
        )),
    }
}

/// What is asked for otherwise than the heading of a chart says, if there is a chart.
fn against(document: &Document, asked: &Asked) -> Diagnostics {
    document.chart().map(|chart| chart.options.against(asked)).unwrap_or_default()
}

/// A chart and what is asked for, if neither it nor that has errors; what is wrong is reported.
fn followed(
    report: &mut Report,
    chart: &Stream,
    profile: &ProfileArguments,
) -> Result<Option<(Document, Asked)>, Failure> {
    let Some(document) = report.document(chart)? else { return Ok(None) };
    report.diagnostics.append(document.diagnostics().clone());
    let asked = profile.asked()?;
    report.diagnostics.append(against(&document, &asked));
    Ok((!report.has_errors()).then_some((document, asked)))
}

/// The program of a chart with its claims, for who follows it state by state.
fn with_claims(document: &Document, profile: Profile) -> Option<Program> {
    let analysis = document.analysis()?;
    let options = Options { profile, ..Options::default() };
    let extras = Extras { saved: true, observed: Observed::Transitions, claims: Claimed::All, ..Extras::default() };
    Some(compile_with(analysis.clone(), &options, extras).0)
}

/// What cannot be followed.
fn beyond(beyond: Beyond) -> Failure {
    Failure::Open(beyond.to_string(), "compare it with constants, or leave it out".to_string())
}

/// The assumptions of a chart allow no inputs in a situation, or at the start if no steps are named.
fn barred(steps: &[String]) -> Failure {
    let place = if steps.is_empty() { "at the start".to_string() } else { format!("in {{{}}}", steps.join(", ")) };
    Failure::Contradiction(
        format!("{place} the assumptions allow no inputs at all, so anything could be proved"),
        "the assumptions contradict each other, or what the inputs were before: leave one out".to_string(),
    )
}
