//! Function block diagrams and ladders as expressions and statements.
//!
//! What is wired to an input is an expression, contacts and functions being operators. Outputs and coils are assignments,
//! and function blocks are calls before them, in the order of the file. A loop of wires has no value.

use super::graph::{Graph, NodeKind, Pin, Storage, Wire};
use crate::code::call;
use crate::code::tree::{Argument, Code, ExprId, ExprKind, Statement, StatementKind};
use rustc_hash::FxHashMap;

/// An output of an element.
type Output = (usize, Option<String>);

/// Expressions of a network.
pub struct Network<'a> {
    graph: &'a Graph,
    code: &'a mut Code,
    values: FxHashMap<Output, ExprId>,
    continuations: FxHashMap<&'a str, usize>,
}

impl<'a> Network<'a> {
    /// A network, of which nothing is known yet.
    pub fn new(graph: &'a Graph, code: &'a mut Code) -> Self {
        let named = graph.nodes.iter().enumerate().filter_map(|(place, node)| match &node.kind {
            NodeKind::Connector(name) => Some((name.as_str(), place)),
            _ => None,
        });
        let continuations = named.collect();
        Network { graph, code, values: FxHashMap::default(), continuations }
    }

    /// What is wired to an input: one of several is enough.
    pub fn input(&mut self, wires: &[Wire]) -> Option<ExprId> {
        let mut value: Option<ExprId> = None;
        for wire in wires {
            let next = self.output((wire.from, wire.pin.clone()));
            value = Some(value.map_or(next, |before| self.code.or(before, next)));
        }
        value
    }

    /// The first block on which what was asked for depends, if there is one.
    pub fn block(&self) -> Option<usize> {
        let is_block = |node: &usize| matches!(self.graph.nodes[*node].kind, NodeKind::Block { .. });
        self.values.keys().map(|(node, _)| *node).filter(is_block).min()
    }

    /// The statements of the whole network.
    pub fn statements(&mut self) -> Vec<Statement> {
        let graph = self.graph;
        let mut out = Vec::new();
        for node in &graph.nodes {
            let wires = node.inputs.first().map(|pin| pin.wires.as_slice()).unwrap_or_default();
            match &node.kind {
                NodeKind::Block { instance: Some(instance), .. } => {
                    let arguments = self.arguments(&node.inputs);
                    out.push(Statement { kind: StatementKind::Call(instance.clone(), arguments), span: node.span });
                }
                NodeKind::Value(target) if !wires.is_empty() => {
                    let (Some(target), Some(value)) = (self.path(*target), self.input(wires)) else { continue };
                    out.push(Statement { kind: StatementKind::Assign { target, value }, span: node.span });
                }
                NodeKind::Coil { variable, negated, edge, storage } => {
                    let (Some(target), Some(mut value)) = (self.path(*variable), self.input(wires)) else { continue };
                    if let Some(direction) = *edge {
                        value = self.code.add(ExprKind::Edge(direction, value), node.span);
                    }
                    if *negated {
                        value = self.code.not(value);
                    }
                    let mut push = |kind| out.push(Statement { kind, span: node.span });
                    match storage {
                        Storage::None => push(StatementKind::Assign { target, value }),
                        Storage::Set | Storage::Reset => {
                            let constant = ExprKind::Bool(*storage == Storage::Set);
                            push(StatementKind::If(value));
                            let value = self.code.add(constant, node.span);
                            push(StatementKind::Assign { target, value });
                            push(StatementKind::EndIf);
                        }
                    }
                }
                _ => {}
            }
        }
        out
    }

    /// What the network gives to a name, or to its only output: the condition of a transition.
    pub fn result(&mut self, name: &str) -> Option<ExprId> {
        let assigned: Vec<(String, ExprId)> = self
            .statements()
            .into_iter()
            .filter_map(|statement| match statement.kind {
                StatementKind::Assign { target, value } => Some((target, value)),
                _ => None,
            })
            .collect();
        let named = assigned.iter().find(|(target, _)| target.eq_ignore_ascii_case(name));
        match (named, assigned.as_slice()) {
            (Some((_, value)), _) | (None, [(_, value)]) => Some(*value),
            _ => None,
        }
    }

    fn path(&self, id: ExprId) -> Option<String> {
        match &self.code.exprs[id].kind {
            ExprKind::Path(path) => Some(path.clone()),
            _ => None,
        }
    }

    /// The value of an output. Inputs come first, by a stack of our own; who is still open when it is asked for is part of
    /// a loop.
    fn output(&mut self, output: Output) -> ExprId {
        let mut stack = vec![(output.clone(), false)];
        let mut open: FxHashMap<usize, ()> = FxHashMap::default();
        while let Some((wanted, is_ready)) = stack.pop() {
            if self.values.contains_key(&wanted) {
                continue;
            }
            let node = wanted.0;
            if is_ready {
                let value = self.made(&wanted);
                self.values.insert(wanted, value);
                open.remove(&node);
                continue;
            }
            if open.insert(node, ()).is_some() {
                let why = "its wires form a loop".to_string();
                let value = self.code.add(ExprKind::Unknown(why), self.graph.nodes[node].span);
                self.values.insert(wanted, value);
                continue;
            }
            stack.push((wanted, true));
            stack.extend(self.before(node).into_iter().map(|output| (output, false)));
        }
        self.values[&output]
    }

    /// The outputs on which those of an element depend.
    fn before(&self, node: usize) -> Vec<Output> {
        match &self.graph.nodes[node].kind {
            // Its outputs are what the call has left behind.
            NodeKind::Block { instance: Some(_), .. } => Vec::new(),
            NodeKind::Continuation(name) => {
                self.continuations.get(name.as_str()).map(|&from| (from, None)).into_iter().collect()
            }
            _ => {
                let wires = self.graph.nodes[node].inputs.iter().flat_map(|pin| &pin.wires);
                wires.map(|wire| (wire.from, wire.pin.clone())).collect()
            }
        }
    }

    fn made(&mut self, output: &Output) -> ExprId {
        let graph = self.graph;
        let node = &graph.nodes[output.0];
        let wires = node.inputs.first().map(|pin| pin.wires.as_slice()).unwrap_or_default();
        match &node.kind {
            NodeKind::Rail => self.code.add(ExprKind::Bool(true), node.span),
            NodeKind::Value(value) if wires.is_empty() => *value,
            NodeKind::Contact { variable, negated, edge } => {
                let before = self.input(wires);
                let mut own = *variable;
                if let Some(direction) = *edge {
                    own = self.code.add(ExprKind::Edge(direction, own), node.span);
                }
                if *negated {
                    own = self.code.not(own);
                }
                before.map_or(own, |before| self.code.and(before, own))
            }
            NodeKind::Block { instance: Some(instance), ty, outputs } => {
                let pin = output.1.clone().or_else(|| outputs.first().map(|(name, _)| name.clone()));
                let pin = pin.unwrap_or_else(|| default_output(ty).to_string());
                let negated = outputs.iter().any(|(name, negated)| *name == pin && *negated);
                let value = self.code.add(ExprKind::Path(format!("{instance}.{pin}")), node.span);
                if negated { self.code.not(value) } else { value }
            }
            NodeKind::Block { instance: None, ty, outputs } => {
                let mut arguments = self.arguments(&node.inputs);
                // Extensible functions number their inputs; their order says the same.
                arguments.iter_mut().for_each(|argument| argument.name = None);
                let value = call(self.code, node.span, ty.clone(), arguments);
                let negated = outputs.first().is_some_and(|(_, negated)| *negated);
                if negated { self.code.not(value) } else { value }
            }
            NodeKind::Continuation(name) => match self.continuations.get(name.as_str()) {
                Some(&from) => self.output((from, None)),
                None => self.code.add(ExprKind::Unknown(format!("no connector is called `{name}`")), node.span),
            },
            NodeKind::Value(_) | NodeKind::Coil { .. } | NodeKind::Connector(_) => match self.input(wires) {
                Some(value) => value,
                None => self.code.add(ExprKind::Unknown("nothing is wired to it".into()), node.span),
            },
            NodeKind::Step
            | NodeKind::Transition
            | NodeKind::Selection
            | NodeKind::Fork
            | NodeKind::Join
            | NodeKind::Jump(_)
            | NodeKind::Actions
            | NodeKind::Other => self.code.add(ExprKind::Unknown("what is wired to it has no value".into()), node.span),
        }
    }

    /// The inputs of a block, as far as something is wired to them; `EN` is left to who reads the call.
    fn arguments(&mut self, pins: &[Pin]) -> Vec<Argument> {
        let mut arguments = Vec::new();
        for pin in pins {
            let Some(mut value) = self.input(&pin.wires) else { continue };
            if let Some(direction) = pin.edge {
                value = self.code.add(ExprKind::Edge(direction, value), pin.span);
            }
            if pin.negated {
                value = self.code.not(value);
            }
            if pin.name.eq_ignore_ascii_case("EN") && self.code.exprs[value].kind == ExprKind::Bool(true) {
                continue;
            }
            arguments.push(Argument { name: Some(pin.name.clone()), value, gives: false });
        }
        arguments
    }
}

fn default_output(ty: &str) -> &'static str {
    match ty.to_ascii_uppercase().as_str() {
        "SR" | "RS" => "Q1",
        _ => "Q",
    }
}
