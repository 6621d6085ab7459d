//! What is shown of a run beside the outputs, by the words of the user.

use grafc_model::chart::{Chart, VariableKind};
use grafc_model::simulate::Probe;
use grafc_syntax::spelling::distance;

/// A word of what is shown that the chart has nothing for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NotShown {
    /// The word.
    pub word: String,
    /// What was probably meant.
    pub near: Option<String>,
}

/// What was probably meant by a word that stands for nothing: one that differs by case, or by a letter or two.
pub(super) fn near(chart: &Chart, word: &str) -> Option<String> {
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

/// What the words stand for, each once, inputs first; how many inputs there are. An error is a word that stands for nothing.
pub(super) fn probes(chart: &Chart, words: &[String]) -> Result<(Vec<Probe>, usize), String> {
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
                    Probe::Variable(_)
                    | Probe::Step(_)
                    | Probe::Duration(_)
                    | Probe::Macro(_)
                    | Probe::Grafcet(_)
                    | Probe::Frozen(_) => behind.push(probe),
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
