//! What is proved of a flat net, found once and used by all that follows: the lowering and the encodings shorten formulas
//! by it, warnings and the report put it into words, a sequential function chart is refused by it.
//!
//! | room | what |
//! | --- | --- |
//! | `canonical` | the net in an order that the text does not decide |
//! | `rivals` | transitions after one step that conditions do not prove to exclude each other |
//! | `reachable/` | all situations of a part of the net, where there are not too many |
//! | `components/` | sets of steps of which at most one is active at any time, and which of them share a variable |
//! | `exclusive` | steps that are never active together, conditions that never hold together |
//! | `parts` | the nodes of a graph that lead to each other in circles |
//! | `liveness/` | what can never happen, situations without a way out, circles that come to no rest |
//! | `together/` | transitions, assignments and orders that are not proved never to meet |
//! | `transients/` | how many micro-steps a reaction can need |

mod canonical;
pub(crate) mod components;
#[cfg(test)]
mod exclusion_tests;
mod exclusive;
pub(crate) mod liveness;
mod parts;
pub(crate) mod reachable;
mod rivals;
pub(crate) mod together;
pub(crate) mod transients;

use crate::lower::cover::Cover;
use crate::lower::{Context, Lowering, Moment};
use crate::scan::{ActionId, Origin};
use components::{Components, FoundComponents, Reason};
use grafc_formula::FormulaId;
use grafc_formula::exclusion::EdgeFacts;
use grafc_model::chart::{Event, GrafcetId, StepId, TransitionId};
use grafc_net::{Arcs, Net};
use index_vec::IndexVec;
use liveness::Liveness;
use reachable::Reachable;
use reachable::known::Known;
use rivals::Rivals;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::{Arc, OnceLock};
use together::Together;
use transients::Transients;

/// A flat net and what is proved of it. What not everybody asks for is found when somebody does.
///
/// What is said of how things go on in a micro-step holds where steps do not overlap; see
/// [`Encoding::overlaps`](crate::Encoding::overlaps).
#[derive(Clone)]
pub struct Analysis {
    pub(crate) net: Arc<Net>,
    pub(crate) arcs: Arcs,
    /// The conditions of a micro-step as formulas, with a bit for each step.
    pub(crate) conditions: Conditions,
    pub(crate) facts: EdgeFacts,
    pub(crate) components: Components,
    pub(crate) cover: Cover,
    /// Why each step that the cover leaves out stays a bit.
    pub(crate) reasons: Vec<(StepId, Reason)>,
    pub(crate) reachable: Reachable,
    pub(crate) rivals: Arc<Rivals>,
    /// Steps of parts of which one component holds every step.
    pub(crate) one_token: FxHashSet<StepId>,
    /// Grafcets that pulse orders act on, of which nothing is proved.
    pub(crate) commanded: IndexVec<GrafcetId, bool>,
    transients: OnceLock<Transients>,
    together: OnceLock<Together>,
    liveness: OnceLock<Liveness>,
}

impl Analysis {
    /// Of a flat net, that is, after all passes.
    pub fn new(net: impl Into<Arc<Net>>) -> Analysis {
        Analysis::of(net.into(), &[])
    }

    /// The same where all situations of some steps are known.
    pub(crate) fn of(net: Arc<Net>, situations: &[Known]) -> Analysis {
        let arcs = Arcs::of(&net, |_| true);
        let conditions = Conditions::new(Lowering::new(net.clone(), None, false));
        let facts = EdgeFacts::new(&conditions.lowering.edges);
        let commanded = net.commanded();
        let found = components::find(&net, &arcs, &facts, &conditions, &commanded, situations);
        let FoundComponents { components, cover, reasons, reachable, rivals, one_token } = found;
        let (transients, together, liveness) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        Analysis {
            net,
            arcs,
            conditions,
            facts,
            components,
            cover,
            reasons,
            reachable,
            rivals: Arc::new(rivals),
            one_token,
            commanded,
            transients,
            together,
            liveness,
        }
    }

    /// The net.
    pub fn net(&self) -> &Net {
        &self.net
    }

    /// What a program is made of; all else has served.
    pub(crate) fn into_parts(self) -> (Arc<Net>, Arcs, Conditions, Components, Cover) {
        (self.net, self.arcs, self.conditions, self.components, self.cover)
    }

    /// How many micro-steps a reaction can need; what pulse orders may make of a situation is not looked into.
    pub fn transients(&self) -> &Transients {
        let find = || if self.net.has_commands() { Transients::unknown() } else { transients::find(self) };
        self.transients.get_or_init(find)
    }

    /// What can never happen, where nothing goes on, and where nothing comes to rest.
    pub(crate) fn liveness(&self) -> &Liveness {
        let find = || if self.net.has_commands() { Liveness::of_conditions(self) } else { liveness::find(self) };
        self.liveness.get_or_init(find)
    }

    /// What may meet in one micro-step.
    pub(crate) fn together(&self) -> &Together {
        self.together.get_or_init(|| together::find(self))
    }
}

/// What a micro-step evaluates: every condition has to be known before its first statement, because the operands of all
/// edges are compared at once.
#[derive(Clone)]
pub(crate) struct Conditions {
    pub(crate) lowering: Lowering,
    pub(crate) cx: Context,
    /// The condition of each transition.
    pub(crate) of_transition: IndexVec<TransitionId, FormulaId>,
    /// Expressions of stored actions on an event and each scan, by the number of the action.
    pub(crate) of_event: FxHashMap<usize, FormulaId>,
    /// Expressions of pulse orders on an event, by the number of the order.
    pub(crate) of_pulse: FxHashMap<usize, FormulaId>,
}

impl Conditions {
    /// Lowers them all.
    pub(crate) fn new(mut lowering: Lowering) -> Conditions {
        let net = &*lowering.net.clone();
        let mut cx = Context::new(Moment::MicroStep);
        let mut of_transition = IndexVec::with_capacity(net.transitions.len());
        for (t, transition) in net.transitions.iter_enumerated() {
            cx.origin = Origin::Transition(t);
            of_transition.push(lowering.expr(&mut cx, transition.condition));
        }
        let mut of_event = FxHashMap::default();
        for (index, action) in net.stored.iter().enumerate() {
            cx.origin = Origin::Action(ActionId::from(net.continuous.len() + index));
            if let Event::Event(_, e) | Event::EachScan(_, Some(e)) = action.event {
                of_event.insert(index, lowering.expr(&mut cx, e));
            }
            lowering.prepare(&mut cx, action.value, true);
        }
        let mut of_pulse = FxHashMap::default();
        for (index, pulse) in net.pulses.iter().enumerate() {
            cx.origin = Origin::Orders(pulse.grafcet);
            if let Event::Event(_, e) = pulse.event {
                of_pulse.insert(index, lowering.expr(&mut cx, e));
            }
        }
        for (index, action) in net.continuous.iter().enumerate() {
            cx.origin = Origin::Action(ActionId::from(index));
            if let Some(condition) = action.condition {
                lowering.prepare(&mut cx, condition, false);
            }
        }
        cx.origin = Origin::Chart;
        Conditions { lowering, cx, of_transition, of_event, of_pulse }
    }
}
