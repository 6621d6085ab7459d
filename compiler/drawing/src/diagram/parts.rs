//! Which elements make a diagram together, and which diagrams stand within others.

use super::Element;
use grafc_model::chart::{GrafcetId, MacroId, Node, StepId, Tables};
use rustc_hash::FxHashMap;

/// A grafcet without its expansions, or an expansion.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) enum Part {
    Grafcet(GrafcetId),
    Expansion(MacroId),
}

/// All parts of a chart.
pub(crate) struct Parts {
    own: FxHashMap<Part, Vec<Element>>,
    within: FxHashMap<Part, Vec<Part>>,
    /// Those that stand in no other, in order of declaration.
    pub roots: Vec<Part>,
}

impl Parts {
    pub(crate) fn new(chart: &Tables) -> Parts {
        let mut own: FxHashMap<Part, Vec<Element>> = FxHashMap::default();
        let mut nodes: Vec<Node> = chart.steps.indices().map(Node::Step).collect();
        nodes.extend(chart.macro_steps.indices().map(Node::Macro));
        // Steps and macro-steps have lists of their own; their order in the text is that of their places.
        nodes.sort_by_key(|node| match node {
            Node::Step(id) => (chart.steps[*id].span.start, 0),
            Node::Macro(id) => (chart.macro_steps[*id].span.start, 1),
        });
        for node in &nodes {
            own.entry(part_of(chart, *node)).or_default().push(Element::from(*node));
        }
        for (id, transition) in chart.transitions.iter_enumerated() {
            let at = transition.pre.iter().chain(&transition.post).next().map(|node| part_of(chart, *node));
            own.entry(at.unwrap_or(Part::Grafcet(transition.grafcet))).or_default().push(Element::Transition(id));
        }
        let mut enclosed: FxHashMap<StepId, Vec<GrafcetId>> = FxHashMap::default();
        for (id, grafcet) in chart.grafcets.iter_enumerated() {
            if let Some(step) = grafcet.enclosing_step {
                enclosed.entry(step).or_default().push(id);
            }
        }
        let mut parts = Parts { own, within: FxHashMap::default(), roots: Vec::new() };
        let mut met: FxHashMap<Part, ()> = FxHashMap::default();
        let tops = chart.grafcets.iter_enumerated().filter(|(_, grafcet)| grafcet.enclosing_step.is_none());
        let mut starts: Vec<Part> = tops.map(|(id, _)| Part::Grafcet(id)).collect();
        // Of a chart with errors, those that go round in a circle, or whose macro-step is elsewhere.
        starts.extend(chart.grafcets.indices().map(Part::Grafcet));
        starts.extend(chart.macro_steps.indices().map(Part::Expansion).filter(|part| parts.own.contains_key(part)));
        for start in starts {
            if met.insert(start, ()).is_some() {
                continue;
            }
            parts.roots.push(start);
            let mut open = vec![start];
            while let Some(part) = open.pop() {
                let mut within = Vec::new();
                for element in parts.own.get(&part).into_iter().flatten() {
                    match element {
                        Element::Step(id) => {
                            within.extend(enclosed.get(id).into_iter().flatten().copied().map(Part::Grafcet));
                        }
                        // A macro-step without an expansion is an error, and has no frame.
                        Element::Macro(id) => {
                            let expansion = Part::Expansion(*id);
                            within.extend(parts.own.contains_key(&expansion).then_some(expansion));
                        }
                        Element::Transition(_) => {}
                    }
                }
                within.retain(|part| met.insert(*part, ()).is_none());
                open.extend(&within);
                parts.within.insert(part, within);
            }
        }
        parts
    }

    /// Its elements, in order: steps, then transitions.
    pub(crate) fn own(&self, part: Part) -> &[Element] {
        self.own.get(&part).map_or(&[], Vec::as_slice)
    }

    /// What stands within it, in the order of the steps that it belongs to.
    pub(crate) fn within(&self, part: Part) -> &[Part] {
        self.within.get(&part).map_or(&[], Vec::as_slice)
    }
}

fn part_of(chart: &Tables, node: Node) -> Part {
    let (of, grafcet) = match node {
        Node::Step(id) => (chart.steps[id].expansion_of, chart.steps[id].grafcet),
        Node::Macro(id) => (chart.macro_steps[id].expansion_of, chart.macro_steps[id].grafcet),
    };
    of.map_or(Part::Grafcet(grafcet), Part::Expansion)
}
