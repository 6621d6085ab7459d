//! Which steps are before and behind each transition, by following wires.
//!
//! Up from a transition, a selection offers one of several ways, and a join wants all of its steps; so a transition behind
//! a selection of joins stands for several. Down from a transition, a selection leads on, and a fork leads to all its
//! steps. Wires may run in loops, and a file may have them meet so often that what they stand for has no end: both end.

use super::graph::{Graph, NodeKind};
use grafc_diagnostics::Span;
use rustc_hash::FxHashSet;

/// The ways from steps to a transition, each a set of steps.
type Ways = Vec<Vec<usize>>;

/// How many ways may lead to one transition.
const MOST_WAYS: usize = 256;

/// How many wires are followed for each element, on average.
const EFFORT: usize = 1_000;

/// Follows wires.
pub struct Wires<'a> {
    graph: &'a Graph,
    /// The places of the elements to whose inputs each is wired.
    next: Vec<Vec<usize>>,
    effort: usize,
}

/// What was found, by the places of elements.
pub struct Around {
    /// Sets of steps before the transition, one of which has to be active.
    pub before: Ways,
    /// Steps, and jumps that stand for steps.
    pub behind: Vec<usize>,
    /// Elements that stand where none of their kind can, and what is wrong.
    pub faults: Vec<(Span, &'static str)>,
}

impl<'a> Wires<'a> {
    /// Looks at the wires of a body.
    pub fn new(graph: &'a Graph) -> Self {
        let mut next = vec![Vec::new(); graph.nodes.len()];
        for (place, node) in graph.nodes.iter().enumerate() {
            // A block of actions hangs on its step; nothing leads on from it.
            if matches!(node.kind, NodeKind::Actions) {
                continue;
            }
            for wire in node.inputs.iter().flat_map(|pin| &pin.wires) {
                next[wire.from].push(place);
            }
        }
        let effort = graph.nodes.len().saturating_mul(EFFORT);
        Wires { graph, next, effort }
    }

    /// What is around a transition; none if there were too many wires to follow.
    pub fn around(&mut self, transition: usize) -> Option<Around> {
        let mut faults = Vec::new();
        let before = self.up(transition, &mut faults)?;
        let behind = self.down(transition, &mut faults)?;
        Some(Around { before, behind, faults })
    }

    fn spend(&mut self, effort: usize) -> Option<()> {
        self.effort = self.effort.checked_sub(effort)?;
        Some(())
    }

    /// Ways from steps down to an element. The stack holds elements whose inputs are being looked at, with what has been
    /// found at each.
    fn up(&mut self, transition: usize, faults: &mut Vec<(Span, &'static str)>) -> Option<Ways> {
        struct Frame {
            node: usize,
            /// The inputs, each a list of places.
            inputs: Vec<Vec<usize>>,
            input: usize,
            wire: usize,
            /// The ways found so far: at the input in work, and at those before it, combined.
            here: Ways,
            all: Ways,
        }
        let frame = |node: usize| Frame {
            node,
            inputs: self.graph.nodes[node]
                .inputs
                .iter()
                .map(|pin| pin.wires.iter().map(|w| w.from).collect())
                .collect(),
            input: 0,
            wire: 0,
            here: Vec::new(),
            all: if matches!(self.graph.nodes[node].kind, NodeKind::Join) { vec![Vec::new()] } else { Vec::new() },
        };
        let mut stack = vec![frame(transition)];
        let mut open = FxHashSet::from_iter([transition]);
        let mut spent = 0_usize;
        loop {
            let top = stack.last_mut().expect("a frame until the transition is done");
            let is_join = matches!(self.graph.nodes[top.node].kind, NodeKind::Join);
            let Some(input) = top.inputs.get(top.input) else {
                let done = stack.pop().expect("the frame");
                open.remove(&done.node);
                spent += 1 + done.all.iter().map(Vec::len).sum::<usize>();
                if spent > self.effort || done.all.len() > MOST_WAYS {
                    return None;
                }
                match stack.last_mut() {
                    Some(below) => below.here.extend(done.all),
                    None => {
                        self.spend(spent)?;
                        return Some(done.all);
                    }
                }
                continue;
            };
            let Some(&from) = input.get(top.wire) else {
                let here = std::mem::take(&mut top.here);
                if is_join {
                    if top.all.len().saturating_mul(here.len()) > MOST_WAYS {
                        return None;
                    }
                    let joined =
                        top.all.iter().flat_map(|one| here.iter().map(move |two| [one.clone(), two.clone()].concat()));
                    top.all = joined.collect();
                } else {
                    top.all.extend(here);
                }
                (top.input, top.wire) = (top.input + 1, 0);
                continue;
            };
            top.wire += 1;
            spent += 1;
            let node = &self.graph.nodes[from];
            match node.kind {
                NodeKind::Step => top.here.push(vec![from]),
                NodeKind::Selection | NodeKind::Join => {
                    if open.insert(from) {
                        let below = frame(from);
                        stack.push(below);
                    } else {
                        faults.push((node.span, "its wires form a loop without a step"));
                    }
                }
                // A branch that ends in a jump is drawn to the convergence all the same.
                NodeKind::Jump(_) => {}
                NodeKind::Transition => faults.push((node.span, "a transition follows it without a step between them")),
                NodeKind::Fork => faults.push((node.span, "a transition follows it without a step between them")),
                _ => faults.push((node.span, "it is wired to a chart and is no part of one")),
            }
        }
    }

    /// The steps and jumps to which a transition leads.
    fn down(&mut self, transition: usize, faults: &mut Vec<(Span, &'static str)>) -> Option<Vec<usize>> {
        let mut found = Vec::new();
        let mut seen = FxHashSet::from_iter([transition]);
        let mut stack: Vec<usize> = self.next[transition].iter().rev().copied().collect();
        self.spend(stack.len())?;
        while let Some(place) = stack.pop() {
            if !seen.insert(place) {
                continue;
            }
            match self.graph.nodes[place].kind {
                NodeKind::Step | NodeKind::Jump(_) => found.push(place),
                NodeKind::Selection | NodeKind::Fork => {
                    let next = &self.next[place];
                    stack.extend(next.iter().rev());
                    let effort = next.len();
                    self.spend(effort)?;
                }
                NodeKind::Join => {
                    faults.push((self.graph.nodes[place].span, "it follows a transition without a step between them"));
                }
                // Told where that transition looks up.
                NodeKind::Transition => {}
                _ => {}
            }
        }
        Some(found)
    }
}
