//! One grafcet by itself: where it starts, what it lets clear in a situation, what clears together.
//!
//! All other grafcets are looked at as the plant is: what they do to a condition may happen or not. What they do to the
//! situation, by orders and by enclosing steps, is a start: an order places its steps (R5b), a step that is activated
//! places the linked steps of an empty enclosure (R5a, I1), and between them the situation only evolves. So whatever the
//! grafcet can come to is reached from one of its starts by clearings alone.

use super::possible::{Never, Transitions};
use crate::analysis::together::questions::Questions;
use grafc_model::chart::{ExprId, ExprKind, GrafcetId, Mode, StepId, TransitionId, below};
use grafc_net::Net;
use grafc_net::net::{Forced, Steps};
use rustc_hash::FxHashMap;

/// Active steps of a grafcet, in order: mostly few.
pub(super) type Marking = Steps;

/// What a condition says of the steps of its own grafcet, and whether it asks for nothing but inputs and time besides.
struct Guard {
    with: Vec<StepId>,
    without: Vec<StepId>,
    is_free: bool,
}

/// What most say.
static PLAIN: Guard = Guard { with: Vec::new(), without: Vec::new(), is_free: true };

impl Guard {
    fn is_plain(&self) -> bool {
        self.with.is_empty() && self.without.is_empty() && self.is_free
    }
}

/// A grafcet by itself.
pub(super) struct Region<'q, 'a> {
    pub(super) asked: &'q mut Questions<'a>,
    pub(super) net: &'a Net,
    pub(super) grafcet: GrafcetId,
    pub(super) transitions: &'q [TransitionId],
    never: &'q Never,
    /// Of those that are not [`PLAIN`].
    guards: FxHashMap<TransitionId, Guard>,
    sources: Vec<TransitionId>,
    implied: FxHashMap<(TransitionId, TransitionId), bool>,
    excluded: FxHashMap<(TransitionId, TransitionId), bool>,
}

impl<'q, 'a> Region<'q, 'a> {
    pub(super) fn new(
        asked: &'q mut Questions<'a>,
        never: &'q Never,
        grafcet: GrafcetId,
        transitions: &'q [TransitionId],
    ) -> Self {
        let net = asked.analysis.net();
        let guards = transitions.iter().map(|t| (*t, guard(net, *t))).filter(|(_, guard)| !guard.is_plain()).collect();
        let sources = transitions.iter().copied().filter(|t| net.transitions[*t].pre.is_empty()).collect();
        let (implied, excluded) = (FxHashMap::default(), FxHashMap::default());
        Region { asked, net, grafcet, transitions, never, guards, sources, implied, excluded }
    }

    /// Whether the situation is changed by nothing but clearings.
    pub(super) fn is_alone(&self) -> bool {
        let grafcet = &self.net.grafcets[self.grafcet];
        grafcet.orders.is_empty() && grafcet.steps.iter().all(|step| self.net.places[*step].within.is_empty())
    }

    fn guard(&self, t: TransitionId) -> &Guard {
        self.guards.get(&t).unwrap_or(&PLAIN)
    }

    /// Whether a transition is known never to clear.
    pub(super) fn is_never(&self, t: TransitionId) -> bool {
        self.never.clears[t]
    }

    /// Whether the situation alone keeps a transition from clearing, and not what its condition says of steps.
    pub(super) fn may_stand(&self, t: TransitionId) -> bool {
        let guard = self.guard(t);
        guard.with.is_empty() && guard.without.is_empty()
    }

    pub(super) fn has_sources(&self) -> bool {
        !self.sources.is_empty()
    }

    /// The situations that it can begin in.
    pub(super) fn starts(&self) -> Vec<Marking> {
        let grafcet = &self.net.grafcets[self.grafcet];
        let marked = |wanted: &dyn Fn(StepId) -> bool| -> Marking {
            let mut steps: Vec<StepId> = grafcet.steps.iter().copied().filter(|step| wanted(*step)).collect();
            steps.sort_unstable();
            steps.into()
        };
        let mut starts = vec![marked(&|step| self.net.places[step].initial)];
        if !self.is_alone() {
            starts.push(marked(&|step| self.net.places[step].activated));
            starts.extend(grafcet.orders.iter().filter_map(|order| match &order.forced {
                Forced::Steps(steps) => Some(steps.clone().into()),
                Forced::Current => None,
            }));
            starts.push(Marking::new());
        }
        starts.sort();
        starts.dedup();
        starts
    }

    /// The transitions that may clear in a situation, as far as it alone decides.
    pub(super) fn enabled(&self, marking: &[StepId]) -> Transitions {
        let holds = |step: &StepId| marking.binary_search(step).is_ok();
        let may = |t: &TransitionId| {
            let guard = self.guard(*t);
            !self.never.clears[*t] && guard.with.iter().all(holds) && !guard.without.iter().any(holds)
        };
        let arcs = &self.asked.analysis.arcs;
        let leaving = marking.iter().flat_map(|step| arcs.leaving(*step).iter().map(move |t| (*step, *t)));
        let ready = leaving.filter(|(step, t)| {
            let before = &self.net.transitions[*t].pre;
            before.first() == Some(step) && before.iter().all(holds)
        });
        self.sources.iter().copied().chain(ready.map(|(_, t)| t)).filter(may).collect()
    }

    /// Whether inputs and time alone decide on a transition, beside the situation.
    pub(super) fn is_free(&self, t: TransitionId) -> bool {
        self.guard(t).is_free
    }

    /// The transitions of those enabled that clear whenever this one does.
    pub(super) fn with_implied(&mut self, t: TransitionId, enabled: &[TransitionId]) -> Transitions {
        let implied = enabled.iter().copied().filter(|u| *u == t || self.implies(t, *u));
        implied.collect()
    }

    fn implies(&mut self, t: TransitionId, u: TransitionId) -> bool {
        let conditions = &self.asked.analysis.conditions.of_transition;
        let (a, b) = (conditions[t], conditions[u]);
        let asked = &mut *self.asked;
        *self.implied.entry((t, u)).or_insert_with(|| match asked.truth(b) {
            Some(truth) => truth,
            None => {
                let denied = asked.literal(b, false);
                asked.exclude(a, denied)
            }
        })
    }

    /// Whether two transitions never clear in one micro-step.
    pub(super) fn excludes(&mut self, t: TransitionId, u: TransitionId) -> bool {
        let pair = (t.min(u), t.max(u));
        let analysis = self.asked.analysis;
        let conditions = &analysis.conditions.of_transition;
        *self.excluded.entry(pair).or_insert_with(|| analysis.exclude(conditions[pair.0], conditions[pair.1]))
    }

    /// The situation after transitions that clear at once (R4).
    pub(super) fn after(&self, marking: &[StepId], cleared: &[TransitionId]) -> Marking {
        let all = |t: &TransitionId| &self.net.transitions[*t];
        let mut left: Steps = cleared.iter().flat_map(|t| &all(t).pre).copied().collect();
        left.sort_unstable();
        let mut next: Marking = marking.iter().copied().filter(|step| left.binary_search(step).is_err()).collect();
        next.extend(cleared.iter().flat_map(|t| &all(t).post).copied());
        next.sort_unstable();
        next.dedup();
        next
    }
}

/// What the factors of a condition say.
fn guard(net: &Net, t: TransitionId) -> Guard {
    let transition = &net.transitions[t];
    let own = |step: StepId| net.places[step].grafcet == transition.grafcet;
    let mut guard = Guard { with: Vec::new(), without: Vec::new(), is_free: true };
    let (mut first, mut factors) = (Some(transition.condition), Vec::new());
    while let Some(e) = first.take().or_else(|| factors.pop()) {
        match net.exprs[e].kind {
            ExprKind::And(a, b) => factors.extend([b, a]),
            ExprKind::StepActive(step) if own(step) => guard.with.push(step),
            ExprKind::Not(a) if matches!(net.exprs[a].kind, ExprKind::StepActive(step) if own(step)) => {
                if let ExprKind::StepActive(step) = net.exprs[a].kind {
                    guard.without.push(step);
                }
            }
            ExprKind::Delay { operand, .. } if is_before(net, t, &net.exprs[operand].kind) => {}
            ExprKind::StepActive(_)
            | ExprKind::Not(_)
            | ExprKind::Literal(_)
            | ExprKind::Variable(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Delay { .. }
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => guard.is_free &= is_free(net, t, e),
        }
    }
    guard
}

/// Whether it is the activity of a step before the transition, which only has to wait there.
fn is_before(net: &Net, t: TransitionId, kind: &ExprKind) -> bool {
    matches!(kind, ExprKind::StepActive(step) if net.transitions[t].pre.contains(step))
}

/// Whether an expression reads inputs, constants, and how long steps before the transition have been active.
fn is_free(net: &Net, t: TransitionId, root: ExprId) -> bool {
    below(&net.exprs, root).all(|e| {
        let kind = &net.exprs[e].kind;
        match kind {
            ExprKind::Variable(v) => net.variables[*v].mode == Mode::Given,
            ExprKind::StepTime(step) => net.transitions[t].pre.contains(step),
            ExprKind::StepActive(_) => is_before(net, t, kind),
            ExprKind::MacroActive(_) | ExprKind::GrafcetActive(_) | ExprKind::GrafcetFrozen(_) => false,
            ExprKind::Literal(_)
            | ExprKind::Not(_)
            | ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Delay { .. }
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => true,
        }
    })
}
