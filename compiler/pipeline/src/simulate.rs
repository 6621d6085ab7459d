//! A chart over a trace, with the reference simulator.

use crate::compile::{bounded, check};
use crate::stages::flatten;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};
use grafc_logic::Analysis;
use grafc_model::chart::{Chart, ControlNames, VariableKind};
use grafc_model::reaction::Profile;
use grafc_model::simulate::{Calls, MOST_CALLS, Probe, Record, run};
use grafc_model::trace::{self, Shown};
use grafc_syntax::spelling::distance;

/// How a chart is run over a trace.
#[derive(Clone, Copy, Default)]
pub struct Run<'a> {
    /// How it evolves.
    pub profile: Profile,
    /// Whether the bound on micro-steps is the one that is known to be enough, where one is.
    pub bound_as_known: bool,
    /// Inputs that act on it as a whole, if there are any.
    pub controls: Option<&'a ControlNames>,
    /// When it is called.
    pub calls: Calls,
    /// What is shown beside the outputs: `inputs`, `vars`, `steps`, and names as in conditions; a name that is one of
    /// these words stands in backquotes.
    pub show: &'a [String],
}

/// What a chart does over a trace.
pub struct Simulation {
    /// The chart.
    pub chart: Chart,
    /// Its calls, and what came of each.
    pub record: Record,
    /// What was looked at.
    pub probes: Vec<Probe>,
    /// Rows of the recording that it was compared with, if there was one.
    pub compared: Option<usize>,
    /// So many probes, inputs, come before the outputs; and whether restarts are shown.
    inputs: (usize, bool),
}

impl Simulation {
    /// The trace of its outputs, and of what else is shown.
    pub fn csv(&self) -> String {
        let (before, restarts) = self.inputs;
        let shown = Shown { restarts, probes: &self.probes, before, values: &self.record.looks };
        trace::write_shown(&self.chart, &self.record.stimuli, &self.record.responses, shown)
    }
}

/// A word of [`Run::show`] that the chart has nothing for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NotShown {
    /// The word.
    pub word: String,
    /// What was probably meant.
    pub near: Option<String>,
}

/// What was probably meant by a word that stands for nothing: one that differs by case, or by a letter or two.
fn near(chart: &Chart, word: &str) -> Option<String> {
    let labels = |prefix: &'static str| chart.steps.iter().map(move |step| format!("{prefix}{}", step.label));
    let words = ["inputs", "vars", "steps"].map(String::from).into_iter();
    let all = words.chain(chart.variables.iter().map(|variable| variable.name.to_string()));
    let all = all.chain(labels("X")).chain(labels("T"));
    // Behind X and T, numbers are all near to each other.
    let reach = match word.chars().filter(|c| !c.is_ascii_digit()).count() {
        0..=2 => 0,
        3..=5 => 1,
        _ => 2,
    };
    let lower = word.to_lowercase();
    let distances = all.filter_map(|name| Some((distance(&name.to_lowercase(), &lower, reach)?, name)));
    distances.min_by_key(|(distance, _)| *distance).map(|(_, name)| name)
}

/// A chart and a trace of its inputs to what it does, compared with a trace that was recorded elsewhere.
///
/// # Errors
/// The first word of [`Run::show`] that the chart has nothing for, and the nearest that it has.
pub fn simulate(
    chart: (FileId, &str),
    default_name: &str,
    trace: (FileId, &str),
    recorded: Option<(FileId, &str)>,
    how: Run,
) -> (Result<Option<Simulation>, NotShown>, Diagnostics) {
    let (chart, mut diagnostics) = check(chart.0, chart.1, default_name);
    let Some(mut chart) = chart else { return (Ok(None), diagnostics) };
    if let Some(Err(found)) = how.controls.map(|names| chart.control(names)) {
        diagnostics.append(found);
        return (Ok(None), diagnostics);
    }
    let (rows, found) = trace::parse_rows(trace.0, trace.1, &chart);
    diagnostics.append(found);
    if diagnostics.has_errors() {
        return (Ok(None), diagnostics);
    }
    let (probes, before) = match probes(&chart, how.show) {
        Ok(found) => found,
        Err(word) => return (Err(NotShown { near: near(&chart, &word), word }), diagnostics),
    };
    let (stimuli, places): (Vec<_>, Vec<_>) = rows.into_iter().unzip();
    let mut lowering = grafc_logic::Options { profile: how.profile, ..grafc_logic::Options::default() };
    if how.bound_as_known
        && let Some(net) = flatten(chart.clone(), false, &mut Diagnostics::new())
    {
        lowering = bounded(&lowering, true, &Analysis::new(net));
    }
    let record = run(&chart, lowering.profile, &stimuli, how.calls, &probes);
    said(&record, &places).into_iter().for_each(|one| diagnostics.push(one));
    let compared = recorded.map(|(file, text)| {
        let (rows, found) = trace::compare_trace(file, text, &chart, &record.stimuli, &record.responses);
        diagnostics.append(found);
        rows
    });
    let restarts = before > 0 && stimuli.iter().any(|stimulus| stimulus.restart);
    (Ok(Some(Simulation { chart, record, probes, compared, inputs: (before, restarts) })), diagnostics)
}

/// What is to be said of a run.
fn said(record: &Record, places: &[Span]) -> Vec<Diagnostic> {
    let place = |row: usize| places.get(row).copied().unwrap_or_default();
    let unseen = record.unseen.map(|(row, at)| {
        Diagnostic::new(Code::W0601, place(row), format!("at {at} ms a delay ends, and no row shows what follows"))
            .here("the next row")
            .also(place(row.saturating_sub(1)), "the row before")
            .note("a controller is called all the time, and would see it then")
            .help("add a row at this time, or let the simulation call the chart there: `--events`, or `--scan 20ms`")
    });
    let cut = record.cut.map(|row| {
        let message = format!("before this row there are more than {MOST_CALLS} calls");
        Diagnostic::new(Code::E0606, place(row), message)
            .help("scan less often, or only where a delay ends: `--events`")
    });
    unseen.into_iter().chain(cut).collect()
}

/// What the words stand for, each once, inputs first; how many inputs there are. An error is a word that stands for nothing.
fn probes(chart: &Chart, words: &[String]) -> Result<(Vec<Probe>, usize), String> {
    let (mut before, mut behind): (Vec<Probe>, Vec<Probe>) = (Vec::new(), Vec::new());
    for word in words {
        match word.as_str() {
            "inputs" => before.extend(Probe::variables(chart, VariableKind::Input)),
            "vars" => behind.extend(Probe::variables(chart, VariableKind::Internal)),
            "steps" => behind.extend(Probe::steps(chart)),
            name => {
                let name = name.strip_prefix('`').and_then(|rest| rest.strip_suffix('`')).unwrap_or(name);
                let probe = Probe::of(name, chart).ok_or_else(|| word.clone())?;
                match probe {
                    Probe::Variable(id) if chart.variables[id].kind == VariableKind::Input => before.push(probe),
                    // It has a column in any case.
                    Probe::Variable(id) if chart.variables[id].kind == VariableKind::Output => {}
                    Probe::Variable(_) | Probe::Step(_) | Probe::Duration(_) | Probe::Macro(_) | Probe::Grafcet(_) => {
                        behind.push(probe)
                    }
                }
            }
        }
    }
    for list in [&mut before, &mut behind] {
        let mut seen = std::collections::BTreeSet::new();
        list.retain(|probe| seen.insert(*probe));
    }
    let inputs = before.len();
    before.append(&mut behind);
    Ok((before, inputs))
}
