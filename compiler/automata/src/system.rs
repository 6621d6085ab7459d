//! The system of interacting transition graphs that a chart is: a graph for each set of steps of which at most one is ever
//! active, in which each arc bears the transition-condition and the states of other graphs that it waits for.
//!
//! An arc that leads from no step of its graph is a *call* by the graph whose state it bears; one that bears the last states
//! of several graphs is where their head goes on. What acts on a graph beside transitions, an enclosing step or a forcing
//! order, is said beside it; a pulse order is an action of who gives it.

use grafc_logic::{Analysis, condition};
use grafc_model::chart::{Continuous, Event, GrafcetId, StepId, TransitionId};
use grafc_net::Net;
use grafc_net::net::Forced;
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

/// The graphs of a chart.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct System {
    /// The name of the chart.
    pub name: String,
    /// By their first steps.
    pub graphs: Vec<Graph>,
    /// Forcing orders: what is forced, and while which graph is in which state.
    pub orders: Vec<String>,
}

/// A transition graph.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Graph {
    /// What others call it.
    pub name: String,
    /// Its vertices; where none of its steps may be active, that is the last one.
    pub vertices: Vec<GraphVertex>,
    /// Its arcs, in the order of the transitions.
    pub arcs: Vec<GraphArc>,
    /// What else acts on it.
    pub notes: Vec<String>,
}

/// A vertex of a graph.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct GraphVertex {
    /// The label of its step; `-` where none is active.
    pub label: String,
    /// Whether it begins there.
    pub initial: bool,
    /// What is done there.
    pub actions: Vec<String>,
}

/// An arc of a graph.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct GraphArc {
    /// From this vertex.
    pub from: usize,
    /// To this one.
    pub to: usize,
    /// The transition-condition.
    pub when: String,
    /// The states of other graphs that it waits for: a graph, and one of its vertices.
    pub states: Vec<(usize, usize)>,
    /// So many more of them are left out.
    pub more: usize,
    /// What is done on it.
    pub actions: Vec<String>,
}

/// The vertex at which no step of a graph is active.
pub const REST: &str = "-";

impl System {
    /// What an arc bears: `A0 = 1 · A2 = 7 · xj`.
    pub fn label(&self, arc: &GraphArc) -> String {
        let state = |(graph, vertex): &(usize, usize)| {
            let graph = &self.graphs[*graph];
            format!("{} = {}", graph.name, graph.vertices[*vertex].label)
        };
        let more = (arc.more > 0).then(|| format!("… ({} more)", arc.more));
        let states: Vec<String> = arc.states.iter().map(state).chain(more).collect();
        if states.is_empty() {
            return arc.when.clone();
        }
        let when = match arc.when.as_str() {
            "1" | "true" => None,
            when if when.contains('+') || when.contains(" xor ") => Some(format!("({when})")),
            when => Some(when.to_owned()),
        };
        states.into_iter().chain(when).collect::<Vec<_>>().join(" · ")
    }
}

/// The graphs of a chart of which this is known.
pub fn system(analysis: &Analysis) -> System {
    let net = analysis.net();
    let mut sets: Vec<Vec<StepId>> = grafc_logic::sets(analysis).map(<[StepId]>::to_vec).collect();
    let mut of: IndexVec<StepId, usize> = net.places.iter().map(|_| usize::MAX).collect();
    sets.iter().flatten().for_each(|step| of[*step] = 0);
    // What shares a state with no other step is a graph of its own.
    sets.extend(net.places.indices().filter(|step| of[*step] == usize::MAX).map(|step| vec![step]));
    sets.sort_by_key(|steps| steps.iter().min().copied());
    for (graph, steps) in sets.iter().enumerate() {
        steps.iter().for_each(|step| of[*step] = graph);
    }
    let place = net.places.iter().map(|_| 0).collect();
    let commanded = net.commands().map(|(_, grafcet)| grafcet).collect();
    let mut maker = Maker { net, of, place, cleared: FxHashMap::default(), commanded, graphs: Vec::new() };
    let at_steps = maker.events();
    let letter = maker.letter();
    for (number, steps) in sets.iter().enumerate() {
        maker.graph(format!("{letter}{number}"), steps);
    }
    for (id, transition) in net.transitions.iter_enumerated() {
        let around = transition.pre.iter().chain(&transition.post);
        let mut graphs: Vec<usize> = around.map(|step| maker.of[*step]).collect();
        graphs.sort_unstable();
        graphs.dedup();
        graphs.into_iter().for_each(|graph| maker.arc(graph, id));
    }
    maker.actions(at_steps);
    maker.enclosures();
    let orders = maker.orders();
    System { name: net.name.to_string(), graphs: maker.graphs, orders }
}

/// Of more states that an arc waits for, so many are named: a synchronisation of thousands of steps is an arc of each.
const STATES: usize = 32;

struct Maker<'n> {
    net: &'n Net,
    /// The graph of each step.
    of: IndexVec<StepId, usize>,
    /// Its vertex there.
    place: IndexVec<StepId, usize>,
    /// What is done on the clearing of transitions.
    cleared: FxHashMap<TransitionId, Vec<String>>,
    /// The grafcets that pulse orders command.
    commanded: FxHashSet<GrafcetId>,
    graphs: Vec<Graph>,
}

impl Maker<'_> {
    /// What names of graphs begin with, so that none is that of a variable.
    fn letter(&self) -> &'static str {
        let begins = |letter: &&str| {
            let number =
                |name: &str| name.strip_prefix(*letter).is_some_and(|rest| rest.bytes().all(|b| b.is_ascii_digit()));
            self.net.variables.iter().any(|variable| number(&variable.name))
        };
        ["A", "Y", "Q", "graph_"].into_iter().find(|letter| !begins(letter)).unwrap_or("automaton_")
    }

    fn graph(&mut self, name: String, steps: &[StepId]) {
        let mut steps = steps.to_vec();
        steps.sort_unstable();
        let mut vertices = Vec::with_capacity(steps.len() + 1);
        for step in &steps {
            self.place[*step] = vertices.len();
            let place = &self.net.places[*step];
            vertices.push(GraphVertex { label: place.label.to_string(), initial: place.initial, actions: Vec::new() });
        }
        self.graphs.push(Graph { name, vertices, arcs: Vec::new(), notes: Vec::new() });
        let number = self.graphs.len() - 1;
        let is_within = |step: &StepId| !self.net.places[*step].within.is_empty();
        let is_forced = |step: &StepId| {
            let grafcet = self.net.places[*step].grafcet;
            !self.net.grafcets[grafcet].orders.is_empty() || self.commanded.contains(&grafcet)
        };
        let rests = !steps.iter().any(|step| self.net.places[*step].initial);
        if rests || steps.iter().any(|step| is_within(step) || is_forced(step)) {
            self.rest(number, rests);
        }
    }

    /// The vertex of a graph at which none of its steps is active.
    fn rest(&mut self, graph: usize, initial: bool) -> usize {
        let vertices = &mut self.graphs[graph].vertices;
        if vertices.last().is_none_or(|vertex| vertex.label != REST) {
            vertices.push(GraphVertex { label: REST.to_owned(), initial, actions: Vec::new() });
        }
        vertices.len() - 1
    }

    fn arc(&mut self, graph: usize, id: TransitionId) {
        let net = self.net;
        let transition = &net.transitions[id];
        let own = |steps: &[StepId]| steps.iter().find(|step| self.of[**step] == graph).map(|step| self.place[*step]);
        let (from, to) = (own(&transition.pre), own(&transition.post));
        let around = transition.encloser();
        let others = transition.pre.iter().chain(&around).filter(|step| self.of[**step] != graph);
        let mut states: Vec<(usize, usize)> =
            others.clone().take(STATES).map(|step| (self.of[*step], self.place[*step])).collect();
        let more = others.count() - states.len();
        states.sort_unstable();
        states.dedup();
        let from = from.unwrap_or_else(|| self.rest(graph, false));
        let to = to.unwrap_or_else(|| self.rest(graph, false));
        let when = condition(net, transition.condition);
        let actions = self.cleared.get(&id).cloned().unwrap_or_default();
        self.graphs[graph].arcs.push(GraphArc { from, to, when, states, more, actions });
    }

    /// What is done at events: those at steps, while those of transitions are kept.
    fn events(&mut self) -> Vec<(StepId, String)> {
        let net = self.net;
        let stored = net.stored.iter().map(|action| {
            let target = &net.variables[action.target].name;
            (action.event, format!("{target} := {}", condition(net, action.value)))
        });
        let pulses = net
            .pulses
            .iter()
            .map(|pulse| (pulse.event, format!("{} {}", pulse.kind.word(), net.grafcets[pulse.grafcet].name)));
        let mut at_steps = Vec::new();
        for (event, what) in stored.chain(pulses) {
            let (step, when) = match event {
                Event::Activation(step) => (step, "on activation".to_owned()),
                Event::Deactivation(step) => (step, "on deactivation".to_owned()),
                Event::Event(step, event) => (step, format!("on event {}", condition(net, event))),
                Event::EachScan(step, None) => (step, "each scan".to_owned()),
                Event::EachScan(step, Some(when)) => (step, format!("each scan if {}", condition(net, when))),
                Event::Clearing(transition) => {
                    self.cleared.entry(transition).or_default().push(what);
                    continue;
                }
            };
            at_steps.push((step, format!("{what} {when}")));
        }
        at_steps
    }

    /// What is done at vertices.
    fn actions(&mut self, at_steps: Vec<(StepId, String)>) {
        let net = self.net;
        let mut found: Vec<(StepId, String)> = Vec::new();
        for Continuous { step, target, condition: when, .. } in &net.continuous {
            let name = &net.variables[*target].name;
            let when = when.map(|when| format!(" if {}", condition(net, when))).unwrap_or_default();
            found.push((*step, format!("{name}{when}")));
        }
        found.extend(net.runs.iter().map(|run| (run.step, format!("run {}", net.grafcets[run.grafcet].name))));
        for (step, action) in found.into_iter().chain(at_steps) {
            self.graphs[self.of[step]].vertices[self.place[step]].actions.push(action);
        }
    }

    /// A graph, and one of its vertices.
    fn state(&self, step: StepId) -> String {
        let graph = &self.graphs[self.of[step]];
        format!("{} = {}", graph.name, graph.vertices[self.place[step]].label)
    }

    /// What enclosing steps do to the graphs that they enclose.
    fn enclosures(&mut self) {
        let net = self.net;
        let mut found: Vec<(usize, String)> = Vec::new();
        let mut seen = vec![false; self.graphs.len()];
        for (id, place) in net.places.iter_enumerated() {
            if place.within.is_empty() {
                continue;
            }
            let around: Vec<String> = place.within.iter().map(|step| self.state(*step)).collect();
            let around = around.join(" or ");
            let graph = self.of[id];
            if place.activated {
                found.push((graph, format!("{REST} -> {} when {around} begins", place.label)));
            }
            if !std::mem::replace(&mut seen[graph], true) {
                found.push((graph, format!("any -> {REST} when {around} ends")));
            }
        }
        found.into_iter().for_each(|(graph, note)| self.graphs[graph].notes.push(note));
    }

    /// What forcing orders do.
    fn orders(&self) -> Vec<String> {
        let told = |grafcet: &grafc_net::net::Grafcet| {
            let order = |order: &grafc_net::net::RankedOrder| {
                let forced = match &order.forced {
                    Forced::Current => "*".to_owned(),
                    Forced::Steps(steps) => {
                        steps.iter().map(|step| self.net.places[*step].label.as_str()).collect::<Vec<_>>().join(", ")
                    }
                };
                format!("{}{{{forced}}} while {}", grafcet.name, self.state(order.step))
            };
            grafcet.orders.iter().map(order).collect::<Vec<_>>()
        };
        self.net.grafcets.iter().flat_map(told).collect()
    }
}
