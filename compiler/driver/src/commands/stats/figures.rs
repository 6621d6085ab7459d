//! What is counted of a chart.

use crate::commands::against;
use grafc::Document;
use grafc_backends::{awl, il, rust};
use grafc_diagnostics::{Diagnostics, Severity};
use grafc_logic::scan::{Measure, Program, State, measure};
use grafc_logic::{Analysis, Encoding, Method, Options, arrow, bits, exclusion};
use grafc_model::chart::{StepId, TransitionId};
use grafc_model::reaction::Asked;
use serde::Serialize;

/// The figures of a chart. The names of the fields are those of the JSON object.
#[derive(Serialize)]
pub struct Figures {
    pub chart: String,
    pub steps: usize,
    pub transitions: usize,
    pub evolution: &'static str,
    pub transients: Transients,
    pub encodings: Vec<EncodingFigures>,
    pub exclusion: Vec<Exclusion>,
    pub switch: Decomposition,
}

/// Of how many steps a method has told which others they exclude.
#[derive(Serialize)]
pub struct Exclusion {
    pub method: &'static str,
    pub steps: usize,
}

/// How many micro-steps a reaction to stability can need; by arrows as the chart draws them.
#[derive(Default, Serialize)]
pub struct Transients {
    /// The last of which finds nothing changed; none where no bound is known.
    pub longest: Option<u32>,
    /// Whether one is always enough.
    pub single: bool,
    /// Transitions that clear one after the other in a longest reaction.
    pub chain: Vec<String>,
    /// Where no bound is known, transitions that may make each other clear in a circle.
    pub cycle: Vec<String>,
}

/// What one encoding takes.
#[derive(Serialize)]
pub struct EncodingFigures {
    pub encoding: &'static str,
    pub state_bits: usize,
    pub states: Vec<usize>,
    pub auxiliary_bits: usize,
    pub auxiliary_numbers: usize,
    pub delays: usize,
    /// None where a call is one micro-step.
    #[serde(rename = "loop")]
    pub repeat: Option<Repeat>,
    pub statements: u64,
    pub instructions: u64,
    /// What no call exceeds.
    pub worst_case: Worst,
    /// Those of the instruction list that `--target il` writes.
    pub il_instructions: u64,
    /// Those of the function block that `--target awl` writes; none where it cannot.
    pub awl_instructions: Option<u64>,
    /// What `size_of` gives for the chart's struct in Rust.
    pub rust_bytes: usize,
}

/// The longest call.
#[derive(Serialize)]
pub struct Worst {
    pub micro_steps: u32,
    /// Those that are carried out.
    pub statements: u64,
}

/// The stability loop.
#[derive(Serialize)]
pub struct Repeat {
    /// None where each evolution was proved to end.
    pub bound: Option<u32>,
}

/// The sets of steps that the encoding `switch` holds in one variable each, and what is left.
#[derive(Default, Serialize)]
pub struct Decomposition {
    pub states: Vec<Held>,
    pub bits: Vec<Bit>,
}

/// A multi-valued variable.
#[derive(Serialize)]
pub struct Held {
    pub name: String,
    /// Whether none of the steps may be active.
    pub idle: bool,
    pub steps: Vec<String>,
}

/// A step that no set holds.
#[derive(Serialize)]
pub struct Bit {
    pub step: String,
    /// Why.
    pub because: String,
}

/// The figures of a chart. There are some exactly if no message is an error. What an encoding warns of is said when the
/// chart is compiled with it.
pub fn figures(document: &mut Document, asked: &Asked) -> (Option<Figures>, Diagnostics) {
    let mut diagnostics = document.diagnostics().clone();
    diagnostics.append(document.warnings().clone());
    let against = against(document, asked);
    if against.has_errors() {
        diagnostics.append(against);
        return (None, diagnostics);
    }
    let (Some(chart), Some(analysis)) = (document.chart(), document.analysis()) else { return (None, diagnostics) };
    let profile = chart.options.over(asked.profile());
    let mut figures = Figures {
        chart: chart.name.to_string(),
        steps: chart.steps.len(),
        transitions: chart.transitions.len(),
        evolution: profile.evolution.word(),
        transients: Transients::new(analysis),
        encodings: Vec::new(),
        exclusion: exclusion(analysis).filter(|(_, steps)| *steps > 0).map(Exclusion::new).collect(),
        switch: Decomposition::default(),
    };
    for encoding in Encoding::ALL {
        document.set_options(Options { profile, encoding, ..Options::default() });
        document.bound_as_known(asked.bound_as_known);
        match row(document, encoding) {
            Ok(row) => figures.encodings.push(row),
            Err(mut found) => {
                found.retain(|d| d.code.severity() == Severity::Error);
                diagnostics.append(found);
                return (None, diagnostics);
            }
        }
        match encoding {
            Encoding::Switch => figures.switch = Decomposition::new(document).unwrap_or_default(),
            Encoding::SinglePhase | Encoding::RTrigger | Encoding::STrigger | Encoding::Sequent => {}
        }
    }
    (Some(figures), diagnostics)
}

/// What the encoding that a document is in takes.
fn row(document: &Document, encoding: Encoding) -> Result<EncodingFigures, Diagnostics> {
    let diagnostics = || document.program_diagnostics().cloned().unwrap_or_default();
    EncodingFigures::new(encoding, document.program().ok_or_else(diagnostics)?)
}

impl Transients {
    fn new(analysis: &Analysis) -> Transients {
        let proved = analysis.transients();
        let arrows = |list: &[TransitionId]| list.iter().map(|t| arrow(analysis.net(), *t)).collect();
        Transients {
            longest: proved.longest,
            single: proved.single,
            chain: arrows(&proved.chain),
            cycle: arrows(&proved.cycle),
        }
    }
}

impl Exclusion {
    fn new((method, steps): (Method, usize)) -> Exclusion {
        let method = match method {
            Method::OneToken => "one-token",
            Method::AllSituations => "all-situations",
            Method::Search => "search",
        };
        Exclusion { method, steps }
    }
}

impl EncodingFigures {
    /// The error is that of the instruction list.
    fn new(encoding: Encoding, program: &Program) -> Result<EncodingFigures, Diagnostics> {
        let Measure { state_bits, states, auxiliary_bits, auxiliary_numbers, timers, statements, instructions } =
            measure(program);
        let worst = program.worst_case();
        Ok(EncodingFigures {
            encoding: encoding.name(),
            state_bits,
            states,
            auxiliary_bits,
            auxiliary_numbers,
            delays: timers,
            repeat: program.repeat.map(|repeat| Repeat { bound: repeat.limit.map(|limit| limit.bound) }),
            statements,
            instructions,
            worst_case: Worst { micro_steps: worst.micro_steps, statements: worst.statements },
            il_instructions: il::instructions(program)?,
            awl_instructions: awl::instructions(program).ok(),
            rust_bytes: rust::size_of(program),
        })
    }
}

impl Decomposition {
    /// Of a document in the encoding `switch`.
    fn new(document: &Document) -> Option<Decomposition> {
        let (chart, program, analysis) = (document.chart()?, document.program()?, document.analysis()?);
        let label = |s: &StepId| chart.steps.get(*s).map(|step| step.label.to_string());
        let held = |state: &State| Held {
            name: program.variables[state.variable].name.to_string(),
            idle: state.idle.is_some(),
            steps: state.values.iter().filter_map(|(s, _)| label(s)).collect(),
        };
        let bit = |(s, because): (StepId, String)| Some(Bit { step: label(&s)?, because });
        Some(Decomposition {
            states: program.states.iter().map(held).collect(),
            bits: bits(analysis).filter_map(bit).collect(),
        })
    }
}
