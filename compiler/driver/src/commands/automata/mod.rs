//! `grafc automata`: the transition graphs that a chart is, and the automata that it can be.

mod arguments;
mod diagram;
mod dot;
mod json;
mod picture;
mod text;

use super::{followed, refuse_output_over_input};
use crate::Exit;
use crate::report::{Failure, Format, Report};
use crate::stream::Stream;
pub use arguments::Arguments;
use arguments::{As, Form};
use grafc::Document;
use grafc_automata::{Automaton, Beyond, Kind, convert, explore, kiss2, system};
use grafc_logic::{Options, compile};
use grafc_model::reaction::Profile;

/// A table of KISS2 of more rows is of use to nobody.
const ROWS: usize = 1_000_000;

/// Shows the automata of one chart.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let output = args.output.clone().unwrap_or(Stream::Standard);
    refuse_output_over_input(&output, [&args.chart])?;
    let mut report = Report::default();
    let followed = followed(&mut report, &args.chart, &args.profile)?;
    let made = followed.and_then(|(document, asked)| told(&args, &document, asked.profile()));
    let exit = report.tell(args.quiet.messages(Format::Human));
    match made {
        None => Ok(exit),
        Some(Err(beyond)) => Err(Failure::Open(beyond.to_string(), help(&beyond).to_owned())),
        Some(Ok(text)) => {
            output.write(&text)?;
            Ok(exit)
        }
    }
}

/// What to do where a chart is no automaton.
fn help(beyond: &Beyond) -> &'static str {
    match beyond {
        Beyond::Number(_) | Beyond::Delay(_) => {
            "without `--as` the transition graphs of the chart are shown, with what they count and wait for"
        }
        Beyond::States(_) => "raise `--max`, or show the transition graphs of the chart, without `--as`",
        Beyond::Rows(_) => "another form is shorter: `--format text`",
    }
}

/// What is asked for, as a text; none if the chart cannot be lowered.
fn told(args: &Arguments, document: &Document, profile: Profile) -> Option<Result<String, Beyond>> {
    let analysis = document.analysis()?;
    let kind = match (args.kind, args.format) {
        (None, Form::Kiss2) => Kind::Mealy,
        (None, Form::Text | Form::Dot | Form::Svg | Form::Json) => {
            let system = system(analysis);
            return Some(Ok(match args.format {
                Form::Text | Form::Kiss2 => text::system(&system),
                Form::Json => json::system(&system),
                Form::Dot => dot::dot(&diagram::of_system(&system)),
                Form::Svg => picture::svg(&diagram::of_system(&system)),
            }));
        }
        (Some(As::Moore), _) => Kind::Moore,
        (Some(As::Mealy), _) => Kind::Mealy,
        (Some(As::Extended), _) => Kind::Extended,
        (Some(As::Minimal), _) => Kind::Minimal,
    };
    let options = Options { profile, ..Options::default() };
    let program = compile(analysis.clone(), &options).0;
    Some(explore(&program, args.max).and_then(|machine| form(args.format, &convert(&machine, kind))))
}

fn form(form: Form, automaton: &Automaton) -> Result<String, Beyond> {
    match form {
        Form::Text => Ok(text::automaton(automaton)),
        Form::Json => Ok(json::automaton(automaton)),
        Form::Dot => Ok(dot::dot(&diagram::of_automaton(automaton))),
        Form::Svg => Ok(picture::svg(&diagram::of_automaton(automaton))),
        Form::Kiss2 => kiss2(&automaton.machine, ROWS),
    }
}
