//! Commanded grafcets as networks of their own, which IEC 61131-3 has a form for.
//!
//! A sequential function chart has no enclosures, children and forcing orders: nobody starts, stops, keeps or moves the
//! steps of another. What orders bring about is said by transitions of the commanded grafcet itself. It rests in a step of
//! its own while none of its steps is active, and while it is kept each step that was active has a twin that is. What the
//! commander does is a transition-condition: that one of its transitions clears.
//!
//! ```text
//! step 1 { run P }   0 -> 1 : a   1 -> 2 : b      rest_P -> 10 : X0 AND a
//! P: initial 10      10 -> 11 : c                 10 -> 11     : c AND NOT (X1 AND b)
//!                                                 10 -> rest_P : X1 AND b
//!                                                 11 -> rest_P : X1 AND b
//! ```
//!
//! So a micro-step of all networks is one of the chart: each transition of a commanded grafcet asks for the old situation
//! and inputs alone, from which follows what the new situation of the commander is (R3), and what R5 and R15 then make of
//! the grafcet. Which situations it has when which order comes is found by going through those of it and its commanders
//! together (`explore`); `commands` says when orders come, `terms` puts conditions together.
//!
//! Requires a flat net. Ensures that no place of the new one is within another, that nothing commands it, and that steps
//! and transitions of the chart keep their places in the tables.

mod commands;
mod explore;
mod terms;

use super::Reasons;
use crate::analysis::Analysis;
use crate::analysis::reachable::known::Known;
use commands::Commands;
use ecow::{EcoString, eco_format};
use explore::{Case, Explored, Moves};
use grafc_model::chart::{Event, ExprId, ExprKind, GrafcetId, MacroId, Note, PulseKind, StepId, TransitionId};
use grafc_model::truth::{Edges, Truth, truths};
use grafc_net::net::{Forced, MacroStep, Place, Steps, Transition, without};
use grafc_net::{Labels, Net};
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};
use smallvec::smallvec;
use std::collections::BTreeSet;
use terms::Terms;

/// A net in which nothing commands anything.
pub(super) struct Networks {
    pub(super) net: Net,
    /// The situations of those that were commanded.
    pub(super) situations: Vec<Known>,
    /// What commands are called, as conditions of many transitions.
    pub(super) names: FxHashMap<ExprId, EcoString>,
}

/// The net, if grafcets are commanded; all reasons why, where that cannot be said by transitions.
pub(super) fn find(analysis: &Analysis) -> Result<Option<Networks>, Reasons> {
    let net = analysis.net();
    let given = given(net);
    if given.iter().all(Given::is_none) {
        return Ok(None);
    }
    let mut reasons = refusals(analysis, &given);
    if !reasons.list.is_empty() {
        return Err(reasons);
    }
    let mut making = Making::new(net, given);
    for g in &net.hierarchy {
        if let Err((span, why)) = making.grafcet(*g) {
            reasons.add(span, why);
            return Err(reasons);
        }
    }
    Ok(Some(making.finish()))
}

/// What is given to a grafcet.
#[derive(Default)]
struct Given {
    /// What it is within.
    within: Vec<StepId>,
    /// Steps of orders on it, the one that wins first, with the situation they set; none is the current one.
    orders: Vec<(StepId, Option<Vec<StepId>>)>,
    /// Steps while one of which is active it is kept by an order, on itself or on what is around it.
    keepers: Vec<StepId>,
    /// Pulse orders, as places in the list of the net.
    pulses: Vec<usize>,
    /// Steps that run it.
    runs: Vec<StepId>,
    /// Grafcets whose kill and whose freezing reach it.
    above: Vec<GrafcetId>,
}

impl Given {
    fn is_none(&self) -> bool {
        self.within.is_empty() && self.keepers.is_empty() && !self.is_pulsed()
    }

    /// Whether pulse orders act on it.
    fn is_pulsed(&self) -> bool {
        !self.pulses.is_empty() || !self.runs.is_empty()
    }
}

fn given(net: &Net) -> IndexVec<GrafcetId, Given> {
    let mut given: IndexVec<GrafcetId, Given> = net.grafcets.iter().map(|_| Given::default()).collect();
    for (g, on) in net.commands_on().into_iter_enumerated() {
        (given[g].pulses, given[g].runs) = (on.pulses, on.runs);
    }
    for (above, below) in net.commanded_below().into_iter_enumerated() {
        below.into_iter().for_each(|below| given[below].above.push(above));
    }
    // What freezes comes before what is frozen with it.
    for g in &net.hierarchy {
        let grafcet = &net.grafcets[*g];
        given[*g].within = net.within(*g).to_vec();
        let mut keepers: Vec<StepId> = grafcet.orders.iter().map(|order| order.step).collect();
        keepers.extend(grafcet.frozen_with.map(|with| given[with].keepers.clone()).unwrap_or_default());
        given[*g].keepers = keepers;
        let forced = |forced: &Forced| match forced {
            Forced::Steps(steps) => Some(steps.clone()),
            Forced::Current => None,
        };
        given[*g].orders = grafcet.orders.iter().map(|order| (order.step, forced(&order.forced))).collect();
    }
    for g in given.indices() {
        let above = std::mem::take(&mut given[g].above);
        given[g].above = above.into_iter().filter(|above| given[*above].is_pulsed()).collect();
    }
    given
}

/// What has no form, whatever the situations are.
fn refusals(analysis: &Analysis, given: &IndexVec<GrafcetId, Given>) -> Reasons {
    let net = analysis.net();
    let mut reasons = Reasons::default();
    for meeting in &analysis.together().orders {
        let order = &net.grafcets[meeting.grafcet].orders[meeting.loser];
        reasons.add(order.span, "may be in force together with another order on the grafcet, which no flag would tell");
    }
    if net.conflict_at_start {
        reasons.add(
            net.grafcets[net.hierarchy[0]].span,
            "has orders that disagree at the start, which no flag would tell",
        );
    }
    for (grafcet, given) in net.grafcets.iter().zip(given) {
        if grafcet.steps.is_empty() && !given.is_none() {
            reasons.add(grafcet.span, "is commanded and has no steps");
        }
        if !given.within.is_empty() && given.is_pulsed() {
            reasons.add(grafcet.span, "is enclosed and commanded by pulse orders as well");
        }
        if given.is_pulsed() && given.orders.iter().any(|(_, set)| set.is_some()) {
            reasons.add(grafcet.span, "is forced into situations and commanded by pulse orders as well");
        }
    }
    // An expression that holds without an edge is an event for another reason (R7).
    let levels = truths(&net.exprs, &net.variables, Edges::Never);
    for pulse in &net.pulses {
        if let Event::Event(_, expr) = pulse.event
            && levels[expr] != Truth::Never
        {
            reasons.add(pulse.span, "a pulse order on an event that need not be an edge");
        }
    }
    for transition in &net.transitions {
        let commanded = !given[transition.grafcet].is_none();
        if commanded && (transition.pre.is_empty() || transition.post.is_empty()) {
            reasons.add(transition.span, "a source or sink transition of a grafcet that is commanded");
        }
    }
    reasons
}

/// Why a grafcet cannot be a network, and where.
type Refused = (grafc_diagnostics::Span, String);

/// What a transition of a network does with its grafcet.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Does {
    /// It is a transition of the chart.
    Own,
    /// An order, or the activity of what is around, acts on the grafcet as a whole.
    All(Case),
    /// It keeps a token, or what a transition makes of tokens.
    Keeps,
    /// It lets a token go on.
    Resumes,
}

/// The nets as they come about.
struct Making {
    net: Net,
    terms: Terms,
    given: IndexVec<GrafcetId, Given>,
    /// The transitions of each grafcet so far.
    of: IndexVec<GrafcetId, Vec<TransitionId>>,
    /// What each transition does.
    does: IndexVec<TransitionId, Does>,
    /// For those that act on a grafcet as a whole, its situation before.
    from: FxHashMap<TransitionId, Vec<StepId>>,
    /// The twins of steps.
    twins: FxHashMap<StepId, StepId>,
    /// Transitions that lead to a step, and that leave it.
    entering: FxHashMap<StepId, Vec<TransitionId>>,
    leaving: FxHashMap<StepId, Vec<TransitionId>>,
    /// The condition of a kill and of a freezing, also of those that are passed on.
    kills: IndexVec<GrafcetId, Option<ExprId>>,
    freezes: IndexVec<GrafcetId, Option<ExprId>>,
    /// The conditions of transitions of the chart, as if no order came.
    bare: FxHashMap<TransitionId, ExprId>,
    /// What is around a grafcet in the chart.
    around: IndexVec<GrafcetId, Option<GrafcetId>>,
    situations: Vec<Known>,
    names: FxHashMap<ExprId, EcoString>,
    labels: Labels,
}

impl Making {
    fn new(net: &Net, given: IndexVec<GrafcetId, Given>) -> Making {
        let mut net = net.clone();
        let labels = Labels::of(&net);
        let around = net.grafcets.indices().map(|g| net.around(g)).collect();
        let nothing: IndexVec<GrafcetId, Option<ExprId>> = net.grafcets.iter().map(|_| None).collect();
        let mut of: IndexVec<GrafcetId, Vec<TransitionId>> = net.grafcets.iter().map(|_| Vec::new()).collect();
        let does = net.transitions.iter().map(|_| Does::Own).collect();
        let (mut entering, mut leaving): (FxHashMap<_, Vec<_>>, FxHashMap<_, Vec<_>>) = Default::default();
        for (t, transition) in net.transitions.iter_enumerated() {
            of[transition.grafcet].push(t);
            transition.entered().into_iter().for_each(|s| entering.entry(s).or_default().push(t));
            transition.left().into_iter().for_each(|s| leaving.entry(s).or_default().push(t));
        }
        for grafcet in &mut net.grafcets {
            (grafcet.orders, grafcet.frozen_with) = (Vec::new(), None);
        }
        Making {
            net,
            terms: Terms::default(),
            given,
            of,
            does,
            from: FxHashMap::default(),
            twins: FxHashMap::default(),
            entering,
            leaving,
            kills: nothing.clone(),
            freezes: nothing,
            bare: FxHashMap::default(),
            around,
            situations: Vec::new(),
            names: FxHashMap::default(),
            labels,
        }
    }

    /// Turns one grafcet into a network; those above it are.
    fn grafcet(&mut self, g: GrafcetId) -> Result<(), Refused> {
        if self.given[g].is_none() {
            return Ok(());
        }
        let rest = self.add_places(g);
        let explored = explore::find(self, g, rest)?;
        let commands = Commands::of(self, g, &explored);
        (self.kills[g], self.freezes[g]) = (commands.kill, commands.freeze);
        self.add_transitions(g, &explored, &commands);
        let known = self.known(g, explored.situations);
        self.situations.push(known);
        for s in self.net.grafcets[g].steps.clone() {
            let place = &mut self.net.places[s];
            place.within = Steps::new();
            (place.activated, place.saved) = (false, false);
        }
        self.net.grafcets[g].starts_frozen = false;
        Ok(())
    }

    /// Adds the step in which a grafcet rests, and, where it can be frozen, the twins of its steps.
    fn add_places(&mut self, g: GrafcetId) -> StepId {
        let grafcet = self.net.grafcets[g].clone();
        if self.can_freeze(g) {
            for s in &grafcet.steps {
                let place = self.net.places[*s].clone();
                let comment = match &place.comment {
                    Some(comment) => eco_format!("kept: {comment}"),
                    None => eco_format!("keeps step {}", place.label),
                };
                let twin = self.add_place(g, eco_format!("kept_{}", place.label), comment, place.saved);
                self.twins.insert(*s, twin);
            }
        }
        let active = |s: &StepId| self.net.places[*s].initial || self.net.places[*s].saved;
        let is_at_rest = !grafcet.steps.iter().any(active);
        let comment = eco_format!("{} has no active step", grafcet.name);
        self.add_place(g, eco_format!("rest_{}", grafcet.name), comment, is_at_rest)
    }

    /// Whether it, or what passes that on to it, is frozen by some order.
    fn can_freeze(&self, g: GrafcetId) -> bool {
        let Given { pulses, above, .. } = &self.given[g];
        pulses.iter().any(|place| self.net.pulses[*place].kind == PulseKind::Freeze)
            || above.iter().any(|above| self.freezes[*above].is_some())
    }

    fn add_place(&mut self, g: GrafcetId, label: EcoString, comment: EcoString, initial: bool) -> StepId {
        let place = Place::auxiliary(self.labels.unused(label), g, self.net.grafcets[g].span);
        self.net.places.push(Place { comment: Some(Note::from(comment)), initial, ..place })
    }

    /// Keeps the transitions of the chart from clearing where orders act, and adds those that orders are.
    fn add_transitions(&mut self, g: GrafcetId, explored: &Explored, commands: &Commands) {
        let own = self.of[g].clone();
        let keepers = self.given[g].keepers.clone();
        // That nothing keeps a transition from clearing.
        let mut free = Vec::new();
        for keeper in keepers {
            let active = self.active(keeper);
            free.push(self.not(active));
        }
        // As they would clear if no order came.
        for t in &own {
            let condition = self.net.transitions[*t].condition;
            let bare = self.and(free.iter().copied().chain([condition]));
            self.bare.insert(*t, bare);
        }
        // In what situation a transition is enabled, an order that is never met there is never given.
        let met = explored.moves.keys().chain(&explored.still).map(|(_, case)| *case);
        let met: BTreeSet<Case> = met.filter(|case| case.keeps_from_clearing()).collect();
        for case in &met {
            let comes = commands.when[case];
            free.push(self.not(comes));
        }
        let free = self.and(free);
        let name = eco_format!("free_{}", self.net.grafcets[g].name);
        self.names.entry(free).or_insert(name);
        let mut made = Vec::new();
        for t in &own {
            let Transition { pre, post, span, condition, .. } = self.net.transitions[*t].clone();
            if met.contains(&Case::Freeze) {
                let post = post.iter().map(|s| self.twins[s]).collect();
                let condition = self.and([self.bare[t], commands.when[&Case::Freeze]]);
                made.push((pre, post, condition, Does::Keeps, None, span));
            }
            let condition = self.and([condition, free]);
            let transition = &mut self.net.transitions[*t];
            transition.condition = condition;
            transition.within = Steps::new();
        }
        let span = self.net.grafcets[g].span;
        for s in self.net.grafcets[g].steps.clone() {
            if explored.freezes_at(s) {
                let mut alone = vec![commands.when[&Case::Freeze]];
                for t in &own {
                    if self.net.transitions[*t].pre.contains(&s) {
                        let clears = self.clears(*t, Some(s), self.bare[t]);
                        alone.push(self.not(clears));
                    }
                }
                let condition = self.and(alone);
                made.push((smallvec![s], smallvec![self.twins[&s]], condition, Does::Keeps, None, span));
            }
            if explored.resumes_at(s, &self.twins) {
                let condition = commands.when[&Case::Resume];
                made.push((smallvec![self.twins[&s]], smallvec![s], condition, Does::Resumes, None, span));
            }
        }
        for ((from, case), to) in &explored.moves {
            if matches!(case, Case::Freeze | Case::Resume) {
                continue;
            }
            let exactly = self.exactly(from, to, &explored.situations);
            let condition = self.and([exactly, commands.when[case]]);
            let (pre, post) = (without(from, to).into(), without(to, from).into());
            made.push((pre, post, condition, Does::All(*case), Some(from.clone()), span));
        }
        for (pre, post, condition, does, from, span) in made {
            let transition = Transition::auxiliary(g, pre, post, condition, span);
            let (left, entered) = (transition.left(), transition.entered());
            let t = self.net.transitions.push(transition);
            left.into_iter().for_each(|s| self.leaving.entry(s).or_default().push(t));
            entered.into_iter().for_each(|s| self.entering.entry(s).or_default().push(t));
            self.of[g].push(t);
            self.does.push(does);
            if let Some(from) = from {
                self.from.insert(t, from);
            }
        }
    }

    /// That the steps that stay are active, too, and that no larger situation is there.
    fn exactly(&mut self, from: &[StepId], to: &[StepId], situations: &[Vec<StepId>]) -> ExprId {
        let stay: Vec<StepId> = from.iter().copied().filter(|s| to.contains(s)).collect();
        let larger = situations.iter().filter(|other| from.iter().all(|s| other.contains(s)));
        let mut more: Vec<StepId> = larger.flatten().copied().filter(|s| !from.contains(s)).collect();
        more.sort_unstable();
        more.dedup();
        let mut terms: Vec<ExprId> = stay.into_iter().map(|s| self.active(s)).collect();
        for s in more {
            let active = self.active(s);
            terms.push(self.not(active));
        }
        self.and(terms)
    }

    /// What has been found of the situations. Of two transitions of which one is an order, at most one clears: that is how
    /// their conditions are made.
    fn known(&self, g: GrafcetId, situations: Vec<Vec<StepId>>) -> Known {
        let transition = |t: &TransitionId| &self.net.transitions[*t];
        let enabled = |t: &TransitionId, situation: &[StepId]| transition(t).pre.iter().all(|s| situation.contains(s));
        let own: Vec<TransitionId> = self.of[g].iter().copied().filter(|t| self.does[*t] == Does::Own).collect();
        let (mut entering_active, mut enabled_at_once) = (Vec::new(), Vec::new());
        for situation in &situations {
            let able: Vec<TransitionId> = own.iter().copied().filter(|t| enabled(t, situation)).collect();
            for (place, a) in able.iter().enumerate() {
                let again = transition(a).entered().into_iter().filter(|s| situation.contains(s));
                entering_active.extend(again.map(|s| (*a, s)));
                enabled_at_once.extend(able[place + 1..].iter().map(|b| (*a, *b)));
            }
        }
        let places = self.net.places.iter_enumerated().filter(|(_, place)| place.grafcet == g);
        Known { steps: places.map(|(s, _)| s).collect(), situations, entering_active, enabled_at_once }
    }

    /// What nothing commands any more.
    fn finish(mut self) -> Networks {
        /// What fewer transitions ask for is said in each.
        const FEW: usize = 3;
        self.frozen_as_steps();
        let Making { mut net, mut names, situations, .. } = self;
        let mut uses: FxHashMap<ExprId, usize> = FxHashMap::default();
        for transition in &net.transitions {
            let (mut open, mut seen) = (vec![transition.condition], FxHashSet::default());
            while let Some(id) = open.pop() {
                if names.contains_key(&id) {
                    *uses.entry(id).or_default() += 1;
                }
                open.extend(net.exprs[id].kind.operands().filter(|operand| seen.insert(*operand)));
            }
        }
        names.retain(|id, _| uses.get(id).is_some_and(|uses| *uses > FEW));
        net.pulses.clear();
        net.runs.clear();
        Networks { net, situations, names }
    }

    /// That a grafcet is frozen is that one of the twins is active: these are to an expression what the steps of a
    /// macro-step are.
    fn frozen_as_steps(&mut self) {
        let mut of: FxHashMap<GrafcetId, MacroId> = FxHashMap::default();
        for id in self.net.exprs.indices() {
            let ExprKind::GrafcetFrozen(g) = self.net.exprs[id].kind else { continue };
            let steps = &self.net.grafcets[g].steps;
            let Some(first) = steps.first().copied() else { continue };
            let m = *of.entry(g).or_insert_with(|| {
                let places = steps.iter().filter_map(|s| self.twins.get(s).copied()).collect();
                let label = eco_format!("F{}", self.net.grafcets[g].name);
                let (inner, entered_by, left_by) = (Vec::new(), Vec::new(), Vec::new());
                self.net.macro_steps.push(MacroStep {
                    label,
                    entry: first,
                    exit: first,
                    places,
                    inner,
                    entered_by,
                    left_by,
                })
            });
            self.net.exprs[id].kind = ExprKind::MacroActive(m);
        }
    }

    fn active(&mut self, s: StepId) -> ExprId {
        self.terms.active(&mut self.net.exprs, s)
    }

    fn not(&mut self, a: ExprId) -> ExprId {
        self.terms.not(&mut self.net.exprs, a)
    }

    fn and(&mut self, terms: impl IntoIterator<Item = ExprId>) -> ExprId {
        self.terms.and(&mut self.net.exprs, terms)
    }

    fn or(&mut self, terms: impl IntoIterator<Item = ExprId>) -> ExprId {
        self.terms.or(&mut self.net.exprs, terms)
    }
}

/// What is looked up of a network by who explores it.
impl Making {
    /// What is around a grafcet, from the inside out.
    fn around(&self, g: GrafcetId) -> impl Iterator<Item = GrafcetId> + '_ {
        std::iter::successors(self.around[g], |g| self.around[*g])
    }

    fn moves(&self, g: GrafcetId) -> Moves<'_> {
        Moves { net: &self.net, of: &self.of[g], does: &self.does, from: &self.from }
    }
}
