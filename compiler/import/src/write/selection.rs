//! Transitions, and which of several after one step is cleared.
//!
//! In GRAFCET all are cleared whose conditions are true. CODESYS takes the leftmost, a priority the smallest number; then
//! a condition gets the negations of those that come before it, unless the two exclude each other by their form.

use super::maker::Maker;
use super::resolve::{Environment, Site};
use super::terms::{StepId, TermId, TermKind};
use crate::{Dialect, changed, doubtful, lost};
use grafc_diagnostics::Span;
use grafc_syntax::ast::Type;
use rustc_hash::FxHashMap;

/// A transition as it is written.
pub struct Written {
    pub part: usize,
    pub before: Vec<StepId>,
    pub behind: Vec<StepId>,
    pub condition: TermId,
    pub span: Span,
    /// The smaller, the earlier.
    priority: Option<i64>,
}

/// How many transitions after one step are compared with each other.
const MOST: usize = 200;

impl Maker<'_> {
    /// The transitions of all parts.
    pub fn transitions(&mut self) -> Vec<Written> {
        let mut written = Vec::new();
        for part in 0..self.parts.len() {
            let chart = self.parts[part].chart;
            let first = self.parts[part].first;
            let site = Site { scope: self.parts[part].scope.clone(), part, own: None };
            for transition in &chart.transitions {
                let span = transition.span;
                let condition = match self.condition(transition.condition, &site, &Environment::default()) {
                    Ok(condition) => condition,
                    Err(loss) => {
                        let name = self.lost_condition();
                        let message = format!("the condition of a transition is lost: {}", loss.why);
                        let note = format!("the input `{name}` stands in its place");
                        self.diagnostics.push(lost(loss.span, message).note(note));
                        let id = self.variables.assumed(&name, Type::Bool, span);
                        self.variables.list[id].used.read = true;
                        self.said.insert(format!("input {}", name.to_lowercase()));
                        self.terms.add(TermKind::Variable(id), Some(Type::Bool), span)
                    }
                };
                let ids = |steps: &[usize]| steps.iter().map(|&step| StepId::new(first + step)).collect();
                written.push(Written {
                    part,
                    before: ids(&transition.before),
                    behind: ids(&transition.behind),
                    condition,
                    span,
                    priority: transition.priority,
                });
            }
        }
        self.choose(&mut written);
        self.tell_loops(&written);
        for transition in &mut written {
            if let Some(called) = self.parts[transition.part].called {
                transition.condition = self.terms.and(called, transition.condition);
            }
        }
        written
    }

    /// Says of steps that are left and entered at once that they stay active.
    fn tell_loops(&mut self, written: &[Written]) {
        for transition in written {
            let Some(&step) = transition.behind.iter().find(|step| transition.before.contains(step)) else { continue };
            let name = self.step_name(step).to_string();
            if self.once(format!("loop {}", step.index())) {
                let message = format!("the step `{name}` is left and entered at once, and stays active");
                self.diagnostics.push(
                    doubtful(transition.span, message)
                        .note("in IEC 60848 that is no event; MATIEC begins the time of the step anew, CODESYS does its entry again"),
                );
            }
        }
    }

    /// A name for what a condition was.
    fn lost_condition(&mut self) -> String {
        let free = |number: &usize| self.variables.find(&format!("condition_{number}")).is_none();
        let number = (self.lost_conditions + 1..).find(free).unwrap_or_default();
        self.lost_conditions = number;
        format!("condition_{number}")
    }

    /// Where several transitions follow one step, lets the earlier ones go before the others.
    fn choose(&mut self, written: &mut [Written]) {
        let mut after: FxHashMap<StepId, Vec<usize>> = FxHashMap::default();
        let mut steps: Vec<StepId> = Vec::new();
        for (place, transition) in written.iter().enumerate() {
            for &step in &transition.before {
                let list = after.entry(step).or_default();
                if list.is_empty() {
                    steps.push(step);
                }
                list.push(place);
            }
        }
        let conditions: Vec<TermId> = written.iter().map(|transition| transition.condition).collect();
        for step in steps {
            let mut list = after.remove(&step).unwrap_or_default();
            if list.len() < 2 {
                continue;
            }
            if list.len() > MOST {
                let message = "too many transitions follow one step to let one go before the other";
                self.diagnostics.push(
                    doubtful(written[list[MOST]].span, message).note("all are cleared whose conditions are true"),
                );
                continue;
            }
            // A stable order: by priority where there is one, else as they stand.
            list.sort_by_key(|&place| written[place].priority.unwrap_or(i64::MAX));
            let mut told = false;
            for (rank, &place) in list.iter().enumerate() {
                let before: Vec<usize> = list[..rank]
                    .iter()
                    .copied()
                    .filter(|&other| !self.terms.exclude(conditions[other], conditions[place]))
                    .collect();
                if before.is_empty() {
                    continue;
                }
                let ordered =
                    self.dialect != Dialect::Iec || before.iter().any(|&other| written[other].priority.is_some());
                let span = written[place].span;
                let name = self.step_name(step).to_string();
                if !ordered {
                    if !told {
                        let message = format!("several transitions after the step `{name}` can be cleared at once");
                        self.diagnostics.push(
                            doubtful(span, message)
                                .note("IEC 61131-3 and CODESYS take the leftmost, MATIEC clears all whose conditions are true; so does the chart")
                                .help("with `--dialect codesys` the leftmost goes before the others"),
                        );
                        told = true;
                    }
                    continue;
                }
                for &other in &before {
                    if self.dialect == Dialect::Iec && written[other].priority.is_none() {
                        continue;
                    }
                    let mut taken = conditions[other];
                    for &also in written[other].before.clone().iter().filter(|&&also| also != step) {
                        let active = self.terms.logic(TermKind::Active(also), span);
                        taken = self.terms.and(taken, active);
                    }
                    let not = self.terms.not(taken);
                    written[place].condition = self.terms.and(written[place].condition, not);
                }
                let message = format!("a transition after the step `{name}` waits for those that go before it");
                self.diagnostics.push(changed(span, message).note("its condition says so now, by their negations"));
            }
        }
    }

    /// The name of a step in the file.
    pub fn step_name(&self, step: StepId) -> &str {
        let place = &self.steps[step];
        &self.parts[place.part].chart.steps[place.step].name
    }
}
