//! `grafc verify`: claims on a chart, each proved, shown to fail by a trace, or open.

mod emit;
mod human;
mod json;
mod junit;
mod said;
mod traces;

use super::{followed, refuse_output_over_input, with_claims};
use crate::Exit;
use crate::arguments::{ProfileArguments, QuietArgument};
use crate::progress::Progress;
use crate::report::{Failure, Format, Report};
use crate::signals::Interrupt;
use crate::stream::Stream;
use clap::{Args, ValueEnum};
use grafc::Document;
use grafc::files::print;
use grafc_model::reaction::Profile;
use grafc_verify::{Answer, Limit, Method, Subject, Verified, verify};
use std::path::PathBuf;
use std::time::{Duration, Instant};

const AFTER_HELP: &str = "\
Example:
  grafc verify valve.gct
  grafc verify valve.gct --traces faults
  grafc verify valve.gct --format junit > verified.xml
  grafc verify valve.gct --emit aiger -o valve.aig

What the chart asserts and wants (`assert`, `reach`) is answered under what it assumes. Always asked: livelock, deadlock, conflict, dead-transition, dead-step; and as notes, which change no exit code when they fail:
selection, reentry, home. A claim that fails has a trace that `grafc sim` replays to the fault.
Exit code 1: a claim fails. Exit code 4: none fails, and one is open; it is said why.";

/// Arguments of `grafc verify`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    chart: Stream,
    /// The form of the answers
    #[arg(long, value_enum, default_value_t = Form::Human)]
    format: Form,
    /// Give what is known after so many seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 60, value_parser = clap::value_parser!(u64).range(1..=31_536_000))]
    time: u64,
    /// Which engine looks: all of them share the work, or one does all of it
    #[arg(long, value_enum, default_value_t = Engine::Auto)]
    engine: Engine,
    /// Write the trace of each claim that fails into this folder
    #[arg(long, value_name = "DIR")]
    traces: Option<PathBuf>,
    /// Prove nothing, but write the chart and its claims as a circuit, for engines of others
    #[arg(long, value_name = "LANGUAGE", value_enum, conflicts_with_all = ["format", "time", "engine", "traces"])]
    emit: Option<emit::Language>,
    /// Where to put the circuit; standard output without it
    #[arg(short, long, value_name = "FILE", requires = "emit")]
    output: Option<Stream>,
    #[command(flatten)]
    profile: ProfileArguments,
    #[command(flatten)]
    quiet: QuietArgument,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Form {
    /// For people
    Human,
    /// One JSON object
    Json,
    /// For build servers
    Junit,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Engine {
    /// Each does what it is best at
    Auto,
    /// One state after the other
    Explicit,
    /// All states at once, as decision diagrams
    Symbolic,
    /// A solver of clauses
    Sat,
}

impl From<Engine> for Method {
    fn from(engine: Engine) -> Method {
        match engine {
            Engine::Auto => Method::Auto,
            Engine::Explicit => Method::Explicit,
            Engine::Symbolic => Method::Symbolic,
            Engine::Sat => Method::Sat,
        }
    }
}

/// Verifies one chart.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    if let Some(language) = args.emit {
        return emitted(&args, language);
    }
    let end = Instant::now() + Duration::from_secs(args.time);
    let (exit, found) = of_chart(&args, |document, profile| verified(document, profile, args.engine.into(), end))?;
    let Some((name, verified)) = found else { return Ok(exit) };
    if let Some(trace) = &verified.barred {
        return Err(super::barred(trace.rows.last().and_then(|row| row.steps.as_deref()).unwrap_or_default()));
    }
    let mut written = Vec::new();
    if let Some(folder) = &args.traces {
        for (path, text) in traces::files(folder, &verified) {
            refuse_output_over_input(&Stream::File(path.clone()), [&args.chart])?;
            written.push((path, text));
        }
        traces::write(folder, written)?;
    }
    let text = match args.format {
        Form::Human => human::human(&name, &verified),
        Form::Json => json::json(&name, &verified),
        Form::Junit => junit::junit(&name, &verified)?,
    };
    print(&text)?;
    Ok(exit.max(of(&verified)))
}

/// Writes the circuit.
fn emitted(args: &Arguments, language: emit::Language) -> Result<Exit, Failure> {
    let output = args.output.clone().unwrap_or(Stream::Standard);
    refuse_output_over_input(&output, [&args.chart])?;
    let (exit, made) = of_chart(args, with_claims)?;
    if let Some(program) = made {
        Stream::write_all(&[(&output, emit::text(&program, language)?)])?;
    }
    Ok(exit)
}

/// What is made of the chart, if it has no errors; what is wrong with it is told.
fn of_chart<T>(
    args: &Arguments,
    make: impl FnOnce(&Document, Profile) -> Option<T>,
) -> Result<(Exit, Option<T>), Failure> {
    let mut report = Report::default();
    let followed = followed(&mut report, &args.chart, &args.profile)?;
    let made = followed.and_then(|(document, asked)| make(&document, asked.profile()));
    Ok((report.tell(args.quiet.messages(Format::Human)), made))
}

/// A fault that is shown counts before what is open.
fn of(verified: &Verified) -> Exit {
    let fails = verified.verdicts.iter().any(|v| matches!(v.answer, Answer::Fails(_)) && !v.claim.kind.is_note());
    let is_open = verified.verdicts.iter().any(|v| matches!(v.answer, Answer::Open(_)));
    match (fails, is_open) {
        (true, _) => Exit::ChartErrors,
        (false, true) => Exit::Open,
        (false, false) => Exit::Done,
    }
}

/// The answers, if the chart has no errors, and its name.
fn verified(document: &Document, profile: Profile, method: Method, end: Instant) -> Option<(String, Verified)> {
    let program = with_claims(document, profile)?;
    let chart = document.chart()?;
    let interrupt = Interrupt::awaited();
    let mut progress = Progress::of_search();
    let mut stop = |at: grafc_verify::Progress| {
        if let Some(progress) = &mut progress {
            progress.say(format!("{} states known, {} looked at", at.known, at.looked_at));
        }
        if interrupt.has_come() {
            return Some(Limit::Interrupted);
        }
        (Instant::now() >= end).then_some(Limit::Time)
    };
    let verified = verify(Subject { chart, program: &program, profile }, method, &mut stop);
    Some((program.name.clone(), verified))
}
