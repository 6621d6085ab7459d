//! The body of a chart: steps, transitions, conditions, blocks of actions.

use super::bodies::{Conditions, Reading};
use super::document::{child, children, name, number};
use super::graph::{Graph, NodeKind, is_true};
use super::network::Network;
use super::vendor;
use super::wires::Wires;
use crate::code::tree::{ExprId, ExprKind};
use crate::code::{expression, source::Source};
use crate::sfc::{Association, Chart, Qualifier, Step, Target, Transition};
use crate::xml::ElementId;
use crate::{doubtful, lost};
use grafc_diagnostics::{Code as ErrorCode, Diagnostic, Span};
use rustc_hash::{FxHashMap, FxHashSet};

/// The chart of a body.
pub fn read(reading: &mut Reading, body: ElementId, conditions: &Conditions) -> Chart {
    let graph = Graph::read(reading.document, reading.text, body, reading.code, reading.diagnostics);
    let mut reader = ChartReader {
        reading,
        graph: &graph,
        conditions,
        chart: Chart::default(),
        steps: FxHashMap::default(),
        names: FxHashSet::default(),
        made_by_blocks: None,
    };
    reader.steps();
    reader.actions();
    reader.transitions(body);
    reader.tell_blocks();
    let mut chart = reader.chart;
    chart.beside = Network::new(&graph, reading.code).statements();
    chart
}

struct ChartReader<'r, 'a> {
    reading: &'r mut Reading<'a>,
    graph: &'r Graph,
    conditions: &'r Conditions,
    chart: Chart,
    /// The step of each element.
    steps: FxHashMap<usize, usize>,
    names: FxHashSet<String>,
    /// Where a block makes the condition of a transition, the first one, and of how many.
    made_by_blocks: Option<(Span, usize)>,
}

impl ChartReader<'_, '_> {
    fn error(&mut self, code: ErrorCode, span: Span, message: String, help: &str) {
        self.reading.diagnostics.push(Diagnostic::new(code, span, message).help(help));
    }

    fn steps(&mut self) {
        for (place, node) in self.graph.nodes.iter().enumerate() {
            if !matches!(node.kind, NodeKind::Step) {
                continue;
            }
            let element = &self.reading.document.elements[node.element];
            let Some(name) = name(element) else {
                let help = "give it a name in the tool that made the file";
                self.error(ErrorCode::E0705, node.span, "a step has no name".into(), help);
                continue;
            };
            if element.name == "macroStep" {
                let message = format!("what is in the macro-step `{name}` is lost, and it is a plain step");
                self.reading.diagnostics.push(lost(node.span, message));
            }
            let initial = is_true(element, "initialStep");
            let (name, comment) = (name.to_string(), self.reading.documentation(node.element));
            let actions = vendor::of_step(self.reading.document, self.reading.text, node.element);
            let actions = actions.into_iter().map(|(qualifier, action)| Association {
                qualifier,
                time: None,
                action: Target::Named(action),
                span: node.span,
            });
            if !self.names.insert(name.to_lowercase()) {
                let message = format!("two steps are called `{name}`");
                self.error(ErrorCode::E0705, node.span, message, "give each step of a chart a name of its own");
            }
            self.steps.insert(place, self.chart.steps.len());
            self.chart.steps.push(Step { name, initial, span: node.span, actions: actions.collect(), comment });
        }
    }

    fn actions(&mut self) {
        for node in self.graph.nodes.iter().filter(|node| matches!(node.kind, NodeKind::Actions)) {
            let wired = node.inputs.iter().flat_map(|pin| &pin.wires).map(|wire| self.steps.get(&wire.from).copied());
            let steps: Vec<usize> = wired.flatten().collect();
            if steps.is_empty() {
                self.reading.diagnostics.push(lost(node.span, "a block of actions is lost: no step has it"));
                continue;
            }
            let listed: Vec<ElementId> = children(self.reading.document, node.element, "action").collect();
            for action in listed {
                for &step in &steps {
                    if let Some(association) = self.association(action) {
                        self.chart.steps[step].actions.push(association);
                    }
                }
            }
        }
    }

    fn association(&mut self, id: ElementId) -> Option<Association> {
        let element = &self.reading.document.elements[id];
        let span = element.span;
        let written = element.attribute("qualifier").unwrap_or_default();
        let Some(qualifier) = Qualifier::of(written) else {
            let message = format!("an action has the qualifier `{written}`, which IEC 61131-3 does not have");
            self.error(ErrorCode::E0705, span, message, "it has N, S, R, P, P0, P1, L, D, SD, DS and SL");
            return None;
        };
        let duration = element.attribute("duration").map(str::trim).filter(|text| !text.is_empty());
        // CODESYS puts the time beside the qualifier in data of its own.
        let time = duration.map(str::to_string).or_else(|| vendor::time(self.reading.document, self.reading.text, id));
        let time = time.map(|text| {
            let mut source = Source::empty(span);
            source.text = text;
            expression(&source, self.reading.code)
        });
        let reference = child(self.reading.document, id, "reference");
        let target = reference.and_then(|reference| name(&self.reading.document.elements[reference]));
        let action = match (target, child(self.reading.document, id, "inline")) {
            (Some(name), _) => Target::Named(name.to_string()),
            (None, Some(inline)) => Target::Inline(self.reading.inline(inline)),
            (None, None) => {
                self.reading.diagnostics.push(lost(span, "an action is lost: it does not say what is done"));
                return None;
            }
        };
        Some(Association { qualifier, time, action, span })
    }

    fn transitions(&mut self, body: ElementId) {
        let by_name: FxHashMap<String, usize> =
            self.chart.steps.iter().enumerate().map(|(place, step)| (step.name.to_lowercase(), place)).collect();
        let mut wires = Wires::new(self.graph);
        for (place, node) in self.graph.nodes.iter().enumerate() {
            if !matches!(node.kind, NodeKind::Transition) {
                continue;
            }
            let Some(around) = wires.around(place) else {
                let span = self.reading.document.elements[body].span;
                let message = "the wires of a chart join too many elements".to_string();
                let help = "join fewer sequences at one place, or make intermediate steps";
                return self.error(ErrorCode::E0702, span, message, help);
            };
            for (span, fault) in around.faults {
                self.reading.diagnostics.push(lost(span, format!("a connection is lost: {fault}")));
            }
            let condition = self.condition(node.element, node.span);
            let mut behind: Vec<usize> = Vec::new();
            for place in around.behind {
                let step = match &self.graph.nodes[place].kind {
                    NodeKind::Jump(target) => by_name.get(&target.to_lowercase()).copied().or_else(|| {
                        let message = format!("a jump leads to the step `{target}`, which is not there");
                        let help = "name a step of the same chart";
                        self.error(ErrorCode::E0704, self.graph.nodes[place].span, message, help);
                        None
                    }),
                    _ => self.steps.get(&place).copied(),
                };
                behind.extend(step.filter(|step| !behind.contains(step)));
            }
            if around.before.is_empty() {
                self.reading.diagnostics.push(lost(node.span, "a transition is lost: no step is before it"));
                continue;
            }
            if behind.is_empty() {
                let message = "no step is behind a transition, which ends its sequence";
                self.reading.diagnostics.push(doubtful(node.span, message));
            }
            let priority = number(&self.reading.document.elements[node.element], "priority").filter(|&n: &i64| n != 0);
            for way in around.before {
                let mut before: Vec<usize> = Vec::new();
                for place in way {
                    before.extend(self.steps.get(&place).copied().filter(|step| !before.contains(step)));
                }
                self.chart.transitions.push(Transition {
                    before,
                    behind: behind.clone(),
                    condition,
                    priority,
                    span: node.span,
                });
            }
        }
    }

    /// One message for all: the generator of Beremiz and OpenPLC takes all blocks before transitions into one action, which is
    /// done in each scan, as all actions are, behind the transitions.
    fn tell_blocks(&mut self) {
        let Some((first, count)) = self.made_by_blocks else { return };
        let message = match count {
            1 => "blocks make the condition of a transition, in the scan that looks at it".to_owned(),
            _ => format!("blocks make the conditions of {count} transitions, in the scan that looks at them"),
        };
        self.reading.diagnostics.push(
            doubtful(first, message)
                .note("Beremiz and OpenPLC call such blocks behind the transitions: there what they make counts a scan later")
                .note("to see that, give their generated text to `grafc import`"),
        );
    }

    fn condition(&mut self, transition: ElementId, span: Span) -> ExprId {
        let document = self.reading.document;
        let Some(id) = child(document, transition, "condition") else {
            let message = "a transition has no condition and is always true";
            self.reading.diagnostics.push(doubtful(span, message).note("IEC 60848, symbol 14, writes `1` for it"));
            return self.reading.code.add(ExprKind::Bool(true), span);
        };
        let unknown = |why: String| ExprKind::Unknown(why);
        let condition = if let Some(reference) = child(document, id, "reference") {
            let wanted = name(&document.elements[reference]).unwrap_or_default();
            match self.conditions.get(&wanted.to_lowercase()) {
                Some(&condition) => condition,
                // A Boolean variable may stand in its place.
                None if !wanted.is_empty() => self.reading.code.add(ExprKind::Path(wanted.to_string()), span),
                None => self.reading.code.add(unknown("it does not say which".into()), span),
            }
        } else if let Some(inline) = child(document, id, "inline") {
            self.reading.condition(inline, "")
        } else if let Some(point) = child(document, id, "connectionPointIn") {
            let wires = self.graph.wires(document, point, self.reading.diagnostics);
            let mut network = Network::new(self.graph, self.reading.code);
            let wired = network.input(&wires);
            if let Some(block) = network.block() {
                let (first, count) = self.made_by_blocks.unwrap_or((self.graph.nodes[block].span, 0));
                self.made_by_blocks = Some((first, count + 1));
            }
            match wired {
                Some(condition) => condition,
                None => self.reading.code.add(unknown("nothing is wired to it".into()), span),
            }
        } else {
            self.reading.code.add(unknown("it is empty".into()), span)
        };
        if is_true(&document.elements[id], "negated") { self.reading.code.not(condition) } else { condition }
    }
}
