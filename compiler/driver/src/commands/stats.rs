//! `grafc stats`: what a chart takes in each encoding.

use crate::Exit;
use crate::arguments::ProfileArguments;
use crate::place::Place;
use crate::report::{Failure, Format, Report};
use clap::{Args, ValueEnum};
use grafc::files::print;
use grafc::pipeline;
use grafc_backends::{awl, il, rust};
use grafc_diagnostics::{Diagnostics, FileId, Severity};
use grafc_logic::scan::{Measure, measure};
use grafc_logic::scan::{Program, State};
use grafc_logic::{Analysis, Encoding, Options, arrow, bits, compile};
use grafc_model::chart::{Chart, StepId, TransitionId};
use grafc_model::reaction::{Evolution, Profile};
use serde::Serialize;

const AFTER_HELP: &str = "\
Example:
  grafc stats valve.gct --evolution scan

What is counted, and how, is in docs/statistics.md.";

/// Lines are no longer than this, save for a name that is.
const WIDTH: usize = 100;

/// Arguments of `grafc stats`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    chart: Place,
    #[command(flatten)]
    profile: ProfileArguments,
    /// The form of the figures, and of messages, which go to standard error
    #[arg(long, value_enum, default_value_t = Form::Human)]
    format: Form,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Form {
    /// A table for people
    Human,
    /// One JSON object
    Json,
}

/// Measures one chart.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let mut report = Report::default();
    let mut found = None;
    if let Some(file) = report.load(&args.chart)? {
        let text = &report.sources.file(file).text;
        let (figures, said) = figures(file, text, &args.chart.chart_name(), args.profile.profile());
        report.diagnostics.append(said);
        found = figures;
    }
    let (exit, text) = match args.format {
        Form::Human => (report.tell(Format::Human), found.as_ref().map(Figures::table)),
        Form::Json => (report.tell(Format::Json), found.as_ref().map(Figures::json)),
    };
    if let Some(text) = text {
        print(&text)?;
    }
    Ok(exit)
}

/// What is said of a chart. The names of the fields are those of the JSON object.
#[derive(Serialize)]
struct Figures {
    chart: String,
    steps: usize,
    transitions: usize,
    evolution: &'static str,
    transients: Transients,
    encodings: Vec<Row>,
    switch: Decomposition,
}

/// How many micro-steps a reaction to stability can need; by arrows as the chart draws them.
#[derive(Default, Serialize)]
struct Transients {
    /// The last of which finds nothing changed; none where no bound is known.
    longest: Option<u32>,
    /// Whether one is always enough.
    single: bool,
    /// Transitions that clear one after the other in a longest reaction.
    chain: Vec<String>,
    /// Where no bound is known, transitions that may make each other clear in a circle.
    cycle: Vec<String>,
}

/// What one encoding takes.
#[derive(Serialize)]
struct Row {
    encoding: &'static str,
    state_bits: usize,
    states: Vec<usize>,
    auxiliary_bits: usize,
    auxiliary_numbers: usize,
    delays: usize,
    /// None where a call is one micro-step.
    #[serde(rename = "loop")]
    repeat: Option<Repeat>,
    statements: u64,
    instructions: u64,
    /// Those of the instruction list that `--target il` writes.
    il_instructions: u64,
    /// Those of the function block that `--target awl` writes; none where it cannot.
    awl_instructions: Option<u64>,
    /// What `size_of` gives for the chart's struct in Rust.
    rust_bytes: usize,
}

/// The stability loop.
#[derive(Serialize)]
struct Repeat {
    /// None where each evolution was proved to end.
    bound: Option<u32>,
}

/// The sets of steps that the encoding `switch` holds in one variable each, and what is left.
#[derive(Default, Serialize)]
struct Decomposition {
    states: Vec<Held>,
    bits: Vec<Bit>,
}

/// A multi-valued variable.
#[derive(Serialize)]
struct Held {
    name: String,
    /// Whether none of the steps may be active.
    idle: bool,
    steps: Vec<String>,
}

/// A step that no set holds.
#[derive(Serialize)]
struct Bit {
    step: String,
    /// Why.
    because: String,
}

/// The figures of a chart. There are some exactly if no message is an error. What an encoding warns of is said when the
/// chart is compiled with it.
fn figures(file: FileId, text: &str, default_name: &str, profile: Profile) -> (Option<Figures>, Diagnostics) {
    let (chart, mut said) = pipeline::check(file, text, default_name);
    let Some(chart) = chart else { return (None, said) };
    let mut figures = Figures {
        chart: chart.name.to_string(),
        steps: chart.steps.len(),
        transitions: chart.transitions.len(),
        evolution: match profile.evolution {
            Evolution::Stable => "stable",
            Evolution::Scan => "scan",
        },
        transients: Transients::default(),
        encodings: Vec::new(),
        switch: Decomposition::default(),
    };
    let mut net = grafc_net::build(&chart);
    grafc_net::passes::run(&mut net, false, &mut said);
    let analysis = Analysis::new(net);
    let proved = analysis.transients();
    let arrows = |list: &[TransitionId]| list.iter().map(|t| arrow(analysis.net(), *t)).collect();
    figures.transients = Transients {
        longest: proved.longest,
        single: proved.single,
        chain: arrows(&proved.chain),
        cycle: arrows(&proved.cycle),
    };
    for encoding in Encoding::ALL {
        let mut found = Diagnostics::new();
        // Charts are drawn otherwise where steps overlap.
        let of_encoding = if encoding.overlaps() { flattened(&chart, &mut found) } else { Some(analysis.clone()) };
        let options = Options { profile, encoding, ..Options::default() };
        let program = of_encoding.and_then(|analysis| program(analysis, &options, &mut found));
        let row =
            program.as_ref().and_then(|program| Row::new(encoding, program).map_err(|fault| found.append(fault)).ok());
        let (Some(program), Some(row)) = (program, row) else {
            found.retain(|d| d.code.severity() == Severity::Error);
            said.append(found);
            return (None, said);
        };
        figures.encodings.push(row);
        match encoding {
            Encoding::Switch => figures.switch = Decomposition::new(&chart, &program, &analysis),
            Encoding::SinglePhase | Encoding::RTrigger | Encoding::STrigger | Encoding::Sequent => {}
        }
    }
    (Some(figures), said)
}

/// A chart for an encoding in which steps overlap, unless a message is an error.
fn flattened(chart: &Chart, said: &mut Diagnostics) -> Option<Analysis> {
    let mut net = grafc_net::build(chart);
    grafc_net::passes::run(&mut net, true, said);
    (!said.has_errors()).then(|| Analysis::new(net))
}

/// The scan program under an encoding, unless a message is an error.
fn program(analysis: Analysis, options: &Options, said: &mut Diagnostics) -> Option<Program> {
    let (program, found) = compile(analysis, options);
    said.append(found);
    Some(program).filter(|_| !said.has_errors())
}

impl Row {
    /// The error is that of the instruction list.
    fn new(encoding: Encoding, program: &Program) -> Result<Row, Diagnostics> {
        let Measure { state_bits, states, auxiliary_bits, auxiliary_numbers, timers, statements, instructions } =
            measure(program);
        Ok(Row {
            encoding: encoding.name(),
            state_bits,
            states,
            auxiliary_bits,
            auxiliary_numbers,
            delays: timers,
            repeat: program.repeat.map(|repeat| Repeat { bound: repeat.limit.map(|limit| limit.bound) }),
            statements,
            instructions,
            il_instructions: il::instructions(program)?,
            awl_instructions: awl::instructions(program).ok(),
            rust_bytes: rust::size_of(program),
        })
    }
}

impl Decomposition {
    fn new(chart: &Chart, program: &Program, analysis: &Analysis) -> Decomposition {
        let label = |s: &StepId| chart.steps.get(*s).map(|step| step.label.to_string());
        let held = |state: &State| Held {
            name: program.variables[state.variable].name.clone(),
            idle: state.idle.is_some(),
            steps: state.values.iter().filter_map(|(s, _)| label(s)).collect(),
        };
        let bit = |(s, because): (StepId, String)| Some(Bit { step: label(&s)?, because });
        Decomposition {
            states: program.states.iter().map(held).collect(),
            bits: bits(analysis).filter_map(bit).collect(),
        }
    }
}

/// The heads of the table; the first column is aligned to the left, the others to the right.
const HEADS: [&str; 10] = [
    "encoding",
    "state bits",
    "states",
    "aux bits",
    "aux nums",
    "delays",
    "loop",
    "statements",
    "instructions",
    "in IL",
];

impl Figures {
    fn json(&self) -> String {
        // Strings and numbers alone cannot be refused.
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }

    fn table(&self) -> String {
        let mut rows = vec![HEADS.map(str::to_string)];
        rows.extend(self.encodings.iter().map(Row::cells));
        let widths: Vec<usize> =
            (0..HEADS.len()).map(|column| rows.iter().map(|row| row[column].len()).max().unwrap_or_default()).collect();
        let counted = |n: usize, word: &str| format!("{n} {word}{}", if n == 1 { "" } else { "s" });
        let (steps, transitions) = (counted(self.steps, "step"), counted(self.transitions, "transition"));
        let mut out = format!("{}: {steps}, {transitions}, evolution {}\n\n", self.chart, self.evolution);
        for row in &rows {
            for (column, (cell, width)) in row.iter().zip(&widths).enumerate() {
                match column {
                    0 => out.push_str(&format!("{cell:<width$}")),
                    _ => out.push_str(&format!("  {cell:>width$}")),
                }
            }
            out.push('\n');
        }
        let by_encoding = |figure: &dyn Fn(&Row) -> String| {
            let all: Vec<String> =
                self.encodings.iter().map(|row| format!("{} {}", row.encoding, figure(row))).collect();
            all.join(", ")
        };
        let awl = |row: &Row| row.awl_instructions.map_or("none".to_string(), |count| count.to_string());
        out.push_str(&format!("\nin AWL\n  {}\n", by_encoding(&awl)));
        out.push_str(&format!("\nbytes in Rust\n  {}\n", by_encoding(&|row| row.rust_bytes.to_string())));
        self.transients.list(&mut out);
        self.switch.list(&mut out);
        out
    }
}

impl Row {
    fn cells(&self) -> [String; HEADS.len()] {
        let repeat = match &self.repeat {
            None => "none".to_string(),
            Some(Repeat { bound: Some(bound) }) => bound.to_string(),
            Some(Repeat { bound: None }) => "ends".to_string(),
        };
        [
            self.encoding.to_string(),
            self.state_bits.to_string(),
            self.states.len().to_string(),
            self.auxiliary_bits.to_string(),
            self.auxiliary_numbers.to_string(),
            self.delays.to_string(),
            repeat,
            self.statements.to_string(),
            self.instructions.to_string(),
            self.il_instructions.to_string(),
        ]
    }
}

impl Decomposition {
    /// The variables with their steps, and the steps that stay bits.
    fn list(&self, out: &mut String) {
        out.push_str("\nsteps in switch\n");
        let names = self.states.iter().map(|state| state.name.len());
        let indent = 4 + names.max().unwrap_or_default();
        for state in &self.states {
            let mut words: Vec<&str> = state.steps.iter().map(String::as_str).collect();
            words.extend(state.idle.then_some("(or none)"));
            wrap(out, &state.name, indent, &words);
        }
        if self.bits.is_empty() {
            return;
        }
        out.push_str("\nsteps that stay bits\n");
        let indent = 4 + self.bits.iter().map(|bit| bit.step.len()).max().unwrap_or_default();
        for bit in &self.bits {
            wrap(out, &bit.step, indent, &bit.because.split(' ').collect::<Vec<_>>());
        }
    }
}

impl Transients {
    /// How an evolution to stability ends, and what shows it.
    fn list(&self, out: &mut String) {
        /// No more transitions than this are shown.
        const SHOWN: usize = 8;
        let (text, arrows) = match self.longest {
            _ if self.single => ("one micro-step is always enough".to_owned(), &[][..]),
            Some(longest) if self.chain.is_empty() => (format!("ends after at most {longest} micro-steps"), &[][..]),
            Some(longest) => (format!("ends after at most {longest} micro-steps, as after"), self.chain.as_slice()),
            None if self.cycle.is_empty() => ("no bound is known".to_owned(), &[][..]),
            None => ("no bound is known: in a circle may clear".to_owned(), self.cycle.as_slice()),
        };
        // An arrow is not broken between two lines.
        let mut words: Vec<String> = text.split(' ').map(str::to_owned).collect();
        for (place, arrow) in arrows.iter().take(SHOWN).enumerate() {
            words.push(format!("`{arrow}`{}", if place + 1 < arrows.len() { "," } else { "" }));
        }
        words.extend((arrows.len() > SHOWN).then(|| "…".to_owned()));
        out.push_str("\nevolution to stability\n");
        wrap(out, "", 2, &words.iter().map(String::as_str).collect::<Vec<_>>());
    }
}

/// A name, and words beside it in as many lines as they need.
fn wrap(out: &mut String, name: &str, indent: usize, words: &[&str]) {
    let mut line = format!("{:<indent$}", format!("  {name}"));
    let mut bare = true;
    for word in words {
        if !bare && line.chars().count() + 1 + word.chars().count() > WIDTH {
            out.push_str(&line);
            out.push('\n');
            line = " ".repeat(indent);
            bare = true;
        }
        if !bare {
            line.push(' ');
        }
        line.push_str(word);
        bare = false;
    }
    out.push_str(line.trim_end());
    out.push('\n');
}
