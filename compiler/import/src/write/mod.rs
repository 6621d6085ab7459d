//! A sequential function chart as the text of a chart that does the same, a step a scan.
//!
//! ```text
//! unit ─ parts ─▶ charts to write ─ steps, effects, selection, blocks ─▶ actions and conditions as terms ─ text
//! ```
//!
//! Each file takes one construct, and says what of it was changed, is doubtful or was lost.

mod blocks;
mod children;
mod continuous;
mod declarations;
mod effects;
mod maker;
mod meaning;
mod order;
mod outcome;
mod parts;
mod resolve;
mod roots;
mod selection;
mod steps;
mod terms;
mod text;
mod typed;
mod variables;

use crate::naming::{Taken, clean, spell, spell_label};
use crate::sfc::Project;
use crate::{Dialect, changed};
use declarations::Declaration;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use index_vec::IndexVec;
use maker::{Action, Event, Maker, When};
pub use roots::roots;
use rustc_hash::{FxHashMap, FxHashSet};
use selection::Written;
use terms::{StepId, Terms, VarId};
pub use text::Text;
use text::{Spelling, Use};
use variables::Variables;

/// The text of the chart of a unit; none if it would be longer than `limit`. Units that become its child programs are added
/// to `children`.
pub fn write(
    project: &Project,
    unit: usize,
    dialect: Dialect,
    limit: usize,
    children: &mut FxHashSet<usize>,
    diagnostics: &mut Diagnostics,
) -> Option<String> {
    let units = project.units.iter().enumerate().map(|(place, unit)| (unit.name.to_lowercase(), place)).collect();
    let mut maker = Maker {
        project,
        dialect,
        diagnostics,
        terms: Terms::default(),
        variables: Variables::default(),
        parts: Vec::new(),
        steps: IndexVec::new(),
        step_texts: IndexVec::new(),
        always: Vec::new(),
        by_name: FxHashMap::default(),
        units,
        children: FxHashMap::default(),
        constants: constants(project),
        calls: FxHashMap::default(),
        edges: Vec::new(),
        here: None,
        depth: 0,
        lost_conditions: 0,
        said: FxHashSet::default(),
        delays_called: FxHashSet::default(),
        read_behind: FxHashMap::default(),
    };
    maker.find_parts(unit);
    maker.find_calls();
    let named = maker.bodies();
    let transitions = maker.transitions();
    maker.delays();
    maker.named(named);
    maker.continuous();
    maker.tell_edges();
    maker.tell_handovers();
    maker.order();
    maker.flags(unit);
    let declarations = maker.declarations();
    children.extend(maker.children.keys());
    let writer = Writer::new(maker, limit);
    writer.chart(unit, &declarations, &transitions)
}

/// The numbers of named values, by the value alone and with its type.
fn constants(project: &Project) -> FxHashMap<String, i64> {
    let mut found = FxHashMap::default();
    for enumeration in project.enumerations.iter() {
        for (name, number) in &enumeration.values {
            found.insert(format!("{}.{}", enumeration.name, name).to_lowercase(), *number);
            found.entry(name.to_lowercase()).or_insert(*number);
        }
    }
    found
}

/// Writes what was made.
struct Writer<'a> {
    maker: Maker<'a>,
    labels: IndexVec<StepId, String>,
    names: IndexVec<VarId, String>,
    /// The name of each part, and whether it is given orders.
    grafcets: Vec<(String, bool)>,
    helper: String,
    text: Text,
}

impl<'a> Writer<'a> {
    fn new(maker: Maker<'a>, limit: usize) -> Self {
        let mut taken = Taken::default();
        let mut implied = Taken::default();
        let mut labels: IndexVec<StepId, String> = IndexVec::new();
        for place in maker.steps.indices() {
            let step = &maker.steps[place];
            let part = &maker.parts[step.part];
            let own = &part.chart.steps[step.step];
            let wanted = clean(&own.name);
            let label = if taken.is_free(&wanted) {
                taken.take(&wanted)
            } else {
                let label = taken.take(&clean(&format!("{}_{}", part.name.replace('.', "_"), own.name)));
                let message = format!("the step `{}` is called `{label}`", own.name);
                maker.diagnostics.push(changed(own.span, message).note("another step has its name"));
                label
            };
            implied.insert(&format!("X{label}"));
            implied.insert(&format!("T{label}"));
            labels.push(label);
        }
        let mut grafcets = Vec::new();
        for part in &maker.parts {
            grafcets.push((taken.take(&clean(&part.name.replace('.', "_"))), part.ordered));
        }
        let helper = taken.take("always");
        for name in grafcets.iter().map(|(name, _)| name).chain([&helper]) {
            implied.insert(&format!("X{name}"));
        }
        for (name, _) in grafcets.iter().filter(|(_, ordered)| *ordered) {
            implied.insert(&format!("F{name}"));
        }
        let mut names: IndexVec<VarId, String> = IndexVec::new();
        for variable in &maker.variables.list {
            let plain = variable.path.replace(['.', '[', ','], "_").replace(']', "");
            names.push(implied.take(&clean(plain.trim_start_matches('%'))));
        }
        Writer { maker, labels, names, grafcets, helper, text: Text::new(limit) }
    }

    fn chart(mut self, unit: usize, declarations: &[Declaration], transitions: &[Written]) -> Option<String> {
        let name = spell(&clean(&self.maker.project.units[unit].name));
        self.text.push(&format!("chart {name} evolution scan\n"));
        for keyword in ["input", "output", "var", "const"] {
            self.text.push("\n");
            for declaration in declarations.iter().filter(|declaration| declaration.keyword == keyword) {
                self.declaration(declaration);
            }
        }
        let mut places = transitions.iter().peekable();
        for part in 0..self.maker.parts.len() {
            let grafcet = spell(&self.grafcets[part].0);
            let head = match self.maker.parts[part].parent {
                Some(parent) => format!("child grafcet {grafcet} of {}", spell(&self.grafcets[parent].0)),
                None => format!("grafcet {grafcet}"),
            };
            self.text.push(&format!("\n{head} {{\n"));
            let first = self.maker.parts[part].first;
            for place in 0..self.maker.parts[part].chart.steps.len() {
                self.step(part, StepId::new(first + place));
            }
            self.text.push("\n");
            while let Some(transition) = places.next_if(|transition| transition.part == part) {
                self.transition(transition);
            }
            self.text.push("}\n");
        }
        self.always();
        if self.text.is_full() {
            let span = self.maker.project.units[unit].span;
            self.maker.diagnostics.push(
                Diagnostic::new(Code::E0702, span, "the chart would be many times longer than its file")
                    .note("what one element stands for is written out at each place where it is used")
                    .help("join fewer sequences at one place, or compute what is long in a variable of its own"),
            );
            return None;
        }
        Some(self.text.out)
    }

    fn declaration(&mut self, declaration: &Declaration) {
        let variable = &self.maker.variables.list[declaration.variable];
        let retain = if declaration.retain { "retain " } else { "" };
        let mut line = format!("{retain}{} {}", declaration.keyword, spell(&self.names[declaration.variable]));
        if let Some(comment) = &variable.comment {
            line.push_str(&format!(" \"{}\"", quoted(comment)));
        }
        line.push_str(&format!(" : {}", variable.ty.keyword()));
        if let Some(address) = &declaration.address {
            line.push_str(&format!(" at {address}"));
        }
        if let Some(initial) = &declaration.initial {
            line.push_str(&format!(" := {initial}"));
        }
        self.text.push(&line);
        self.text.push("\n");
    }

    fn step(&mut self, part: usize, id: StepId) {
        let step = &self.maker.parts[part].chart.steps[self.maker.steps[id].step];
        let initial = if step.initial { "initial " } else { "" };
        let comment = step.comment.as_deref().map(|comment| format!(" \"{}\"", quoted(comment))).unwrap_or_default();
        for line in &self.maker.step_texts[id].lost {
            self.text.push(&format!("// lost: {}\n", commented(line)));
        }
        self.text.push(&format!("{initial}step {}{comment}", spell_label(&self.labels[id])));
        let actions = std::mem::take(&mut self.maker.step_texts[id].actions);
        self.actions(&actions);
        self.text.push("\n");
    }

    fn actions(&mut self, actions: &[Action]) {
        if actions.is_empty() {
            return;
        }
        self.text.push(" { ");
        for action in actions {
            let spelling = Spelling {
                terms: &self.maker.terms,
                variables: &self.names,
                labels: &self.labels,
                grafcets: &self.grafcets,
            };
            match *action {
                Action::Continuous { variable, condition } => {
                    self.text.push(&spell(&self.names[variable]));
                    if let Some(condition) = condition {
                        self.text.push(" if ");
                        spelling.term(&mut self.text, condition, Use::Condition);
                    }
                }
                Action::Stored { variable, value, when } => {
                    self.text.push(&spell(&self.names[variable]));
                    self.text.push(" := ");
                    spelling.term(&mut self.text, value, Use::Value);
                    match when {
                        When::Activation => self.text.push(" on activation"),
                        When::Deactivation => self.text.push(" on deactivation"),
                        When::EachScan(guard) => {
                            self.text.push(" each scan");
                            if let Some(guard) = guard {
                                self.text.push(" if ");
                                spelling.term(&mut self.text, guard, Use::Condition);
                            }
                        }
                    }
                }
                Action::Pulse { command, child, event } => {
                    let child = spell(&self.grafcets[child].0);
                    self.text.push(&format!("{} {child} on ", command.word()));
                    match event {
                        Event::Activation => self.text.push("activation"),
                        Event::Deactivation => self.text.push("deactivation"),
                        Event::Edge(edge) => {
                            self.text.push("event ");
                            spelling.term(&mut self.text, edge, Use::Condition);
                        }
                    }
                }
                Action::Run { child } => self.text.push(&format!("run {}", spell(&self.grafcets[child].0))),
            }
            self.text.push("\n");
        }
        self.text.push("}");
    }

    fn transition(&mut self, transition: &Written) {
        self.text.push("transition ");
        self.steps(&transition.before);
        self.text.push(" -> ");
        self.steps(&transition.behind);
        self.text.push(" : ");
        let spelling = Spelling {
            terms: &self.maker.terms,
            variables: &self.names,
            labels: &self.labels,
            grafcets: &self.grafcets,
        };
        spelling.term(&mut self.text, transition.condition, Use::Condition);
        self.text.push("\n");
    }

    fn steps(&mut self, steps: &[StepId]) {
        let labels: Vec<String> = steps.iter().map(|&step| spell_label(&self.labels[step])).collect();
        self.text.push(&labels.join(", "));
    }

    /// The step that is always active, if there is something for it to do.
    fn always(&mut self) {
        let actions = std::mem::take(&mut self.maker.always);
        if actions.is_empty() {
            return;
        }
        let name = spell(&self.helper);
        self.text.push(&format!("\ngrafcet {name} {{\ninitial step {name}_step"));
        self.actions(&actions);
        self.text.push("\n}\n");
    }
}

/// A text between quotation marks, in one line.
fn quoted(text: &str) -> String {
    commented(text).replace('"', "\"\"")
}

/// A text in one line.
fn commented(text: &str) -> String {
    let clean = |c: char| if c.is_control() || matches!(c, '\u{2028}' | '\u{2029}') { ' ' } else { c };
    text.trim().chars().take(500).map(clean).collect()
}
