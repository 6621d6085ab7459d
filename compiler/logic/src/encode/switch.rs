//! Decomposition into interacting transition graphs (Shalyto, 12.3): each set of steps that exclude each other is one
//! number, and a micro-step looks at the arm of the active step only, enclosures inside the arm of the step that encloses
//! them.
//!
//! ```text
//! CASE at OF  3: IF condition THEN next := 4 …             transitions: read the old situation, write the next one
//! IF moved THEN                                            only where something clears:
//!   enclosures and orders (R5), from the top down          on the next situation
//!   stored actions (R7), outputs that follow a state       from both
//!   at := next                                             from the bottom up
//! ```
//!
//! Where nothing else hangs on a clearing, its transition writes the states themselves, see `in_place`.
//!
//! Outside of a micro-step `next` equals the state, so nothing has to be copied where nothing moves. Steps that no set
//! covers stay bits, with the formulas of the single-phase encoding; a transition that touches one is latched like there.

use super::in_order::{Block, in_order};
use super::{Encoding, Task, bits};
use crate::allocate::choose;
use crate::arms::Arms;
use crate::events::{Clearings, Flow, StepEvents, clears, designation, drawn};
use crate::formula::{FormulaId, Type, Value};
use crate::input_event::InputEvent;
use crate::lower::{Context, Lowering};
use crate::outputs::Followers;
use crate::scan::{Role, Statement, VarId};
use crate::settle;
use crate::situation::{Holder, equals};
use crate::stored;
use crate::tokens::Cover;
use grafc_model::chart::{Event, GrafcetId, StepId, TransitionId, VariableId};
use grafc_net::Net;
use grafc_net::net::Forced;
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;

/// Arms nest no deeper than this; what is enclosed deeper starts again at the top, where an idle state costs a test.
const DEEPEST: usize = 16;

/// How sets lie in grafcets and grafcets in steps.
struct Layout {
    sets_of: IndexVec<GrafcetId, Vec<usize>>,
    /// The grafcets that a step encloses, if they have sets.
    inside: FxHashMap<StepId, Vec<GrafcetId>>,
    /// Grafcets on which an order sets a situation.
    forced: IndexVec<GrafcetId, bool>,
}

impl Layout {
    fn new(lowering: &Lowering) -> Self {
        let net = lowering.net;
        let mut layout = Layout {
            sets_of: net.grafcets.iter().map(|_| Vec::new()).collect(),
            inside: FxHashMap::default(),
            forced: net.grafcets.indices().map(|g| is_forced(net, g)).collect(),
        };
        for (index, set) in lowering.situation.sets.iter().enumerate() {
            layout.sets_of[set.grafcet].push(index);
        }
        for g in net.grafcets.indices().filter(|g| !layout.sets_of[*g].is_empty()) {
            if let Some(e) = within(net, g) {
                layout.inside.entry(e).or_default().push(g);
            }
        }
        layout
    }

    /// The sets inside a step.
    fn enclosed(&self, e: StepId) -> impl Iterator<Item = usize> + '_ {
        let grafcets = self.inside.get(&e).map_or(&[][..], Vec::as_slice);
        grafcets.iter().flat_map(|g| self.sets_of[*g].iter().copied())
    }
}

/// The step that encloses a grafcet.
fn within(net: &Net, g: GrafcetId) -> Option<StepId> {
    net.grafcets[g].steps.first().and_then(|s| net.places[*s].within)
}

pub(super) fn micro_step(
    lowering: &mut Lowering,
    cx: &mut Context,
    task: &Task,
    input_event: &mut InputEvent,
) -> Vec<Statement> {
    let net = lowering.net;
    let layout = Layout::new(lowering);
    let mut out = Vec::new();
    stored::heading(&mut out, "memory of edges", bits::edges(lowering, task.again));
    if lowering.situation.sets.iter().any(|set| set.next == set.variable) {
        out.extend(in_place(lowering, task));
        return out;
    }
    let (frozen, freezing) = settle::frozen(lowering);
    let numbered = Numbered::new(lowering);
    let moved = Moved::new(lowering, task, &numbered);

    let mut switch = Switch { task, layout, numbered, moved, cleared: IndexVec::new() };
    let transitions = switch.transitions(lowering, &frozen);
    out.push(Statement::Heading("transitions".to_owned()));
    out.extend(freezing);
    out.extend(transitions);

    // What follows happens only where something clears, unless an action on an event has to be done in any case.
    let mut inner = Vec::new();
    let next = net.places.iter().map(|_| None).collect();
    let mut clearings = Clearings { flow: Flow::new(net), cleared: std::mem::take(&mut switch.cleared), next };
    stored::heading(&mut inner, "enclosures and orders", switch.settle(lowering, &mut clearings));
    inner.extend(switch.tell_changed_bits(lowering, &clearings));
    let step_events = StepEvents::new(lowering, &clearings, task.components);
    let actions = stored::actions(lowering, cx, task, &clearings, step_events, input_event);
    stored::heading(&mut inner, "stored actions", actions);
    stored::heading(&mut inner, "outputs of the steps left and entered", switch.follow(lowering));
    stored::heading(&mut inner, "situation", switch.commit(lowering, &clearings));
    if !task.events.is_empty() {
        out.extend(inner);
    } else if !inner.is_empty() {
        let when = lowering.symbols.read(&mut lowering.pool, switch.moved.variable);
        out.push(Statement::Heading("what the clearings bring about".to_owned()));
        out.push(Statement::If { branches: vec![(when, inner)], otherwise: Vec::new() });
    }
    out
}

/// Whether nothing has to wait: without enclosures, forced situations and stored actions, and with a set for every step,
/// a transition moves its states and switches their outputs itself.
pub(crate) fn is_in_place(net: &Net, cover: &Cover) -> bool {
    let enclosed = net.places.iter().any(|place| place.within.is_some());
    let covered = cover.of_step.iter().all(Option::is_some);
    covered && !enclosed && net.stored.is_empty() && net.grafcets.indices().all(|g| !is_forced(net, g))
}

/// Whether an order sets the situation of a grafcet.
fn is_forced(net: &Net, g: GrafcetId) -> bool {
    net.grafcets[g].orders.iter().any(|order| matches!(order.forced, Forced::Steps(_)))
}

/// The transitions of a chart in which nothing has to wait.
fn in_place(lowering: &mut Lowering, task: &Task) -> Vec<Statement> {
    let net = lowering.net;
    let (frozen, freezing) = settle::frozen(lowering);
    let mut branches: FxHashMap<StepId, Vec<(FormulaId, Vec<Statement>)>> = FxHashMap::default();
    for (t, transition) in net.transitions.iter_enumerated() {
        // No set covers a step that a transition without steps before it leads to.
        let Some(first) = transition.pre.first().copied() else { continue };
        let changes = changes_of(lowering, t);
        let own = lowering.active(first);
        let factors = clears(lowering, t, task.conditions[t], &frozen, task.simplify);
        let when = lowering.pool.and(factors.into_iter().filter(|f| *f != own));
        let mut body = Vec::new();
        for (set, value) in &changes {
            body.push(assign_number(lowering, lowering.situation.sets[*set].variable, *value));
        }
        if let Some(followers) = task.followers {
            body.extend(switched(lowering, followers, t));
        }
        if let Some(again) = task.again.filter(|_| !changes.is_empty()) {
            body.push(assign_truth(lowering, again, true));
        }
        if let Some(Statement::Assign { remark, .. }) = body.first_mut() {
            *remark = Some(drawn(net, t));
        }
        if !body.is_empty() {
            branches.entry(first).or_default().push((when, body));
        }
    }
    let mut out = vec![Statement::Heading("transitions".to_owned())];
    out.extend(freezing);
    if let Some(again) = task.again.filter(|_| lowering.edges.is_empty()) {
        out.push(assign_truth(lowering, again, false));
    }
    // A condition reads states, and outputs that follow a state: as they were before the micro-step (R3).
    let states = lowering.situation.sets.iter().map(|set| set.variable);
    let wires = task.followers.iter().flat_map(|followers| followers.of_set.iter().flatten());
    let written: FxHashSet<VarId> = states.chain(wires.map(|v| lowering.symbols.declared(*v))).collect();
    let mut blocks = Vec::new();
    for set in lowering.situation.sets.clone() {
        let mut arms = Arms::default();
        for s in &set.steps {
            arms.add(lowering, *s, choose(lowering, branches.remove(s).unwrap_or_default()));
        }
        if let Some(case) = arms.case(set.variable) {
            blocks.push(Block::new(lowering, vec![case], |v| written.contains(&v)));
        }
    }
    in_order(lowering, blocks, &mut out);
    out
}

/// The outputs that a clearing switches.
fn switched(lowering: &mut Lowering, followers: &Followers, t: TransitionId) -> Vec<Statement> {
    let net = lowering.net;
    let transition = &net.transitions[t];
    // Of each wire whether the step left leaves it true for certain, and whether the step entered makes it so.
    let mut wires: BTreeMap<VariableId, (Option<bool>, bool)> = BTreeMap::new();
    for s in transition.pre.iter().filter(|s| !transition.post.contains(s)) {
        for (wire, conditions) in followers.on_step(net, *s) {
            wires.entry(wire).or_default().0 = Some(conditions.is_empty());
        }
    }
    for s in transition.post.iter().filter(|s| !transition.pre.contains(s)) {
        for (wire, conditions) in followers.on_step(net, *s) {
            wires.entry(wire).or_default().1 |= conditions.is_empty();
        }
    }
    let mut out = Vec::new();
    for (wire, change) in wires {
        let value = match change {
            (Some(true), true) | (None, false) => continue,
            (_, entered) => entered,
        };
        let target = lowering.symbols.declared(wire);
        out.push(assign_truth(lowering, target, value));
    }
    out
}

/// The states at the start, before the first call has done anything.
pub(crate) fn start(lowering: &mut Lowering, followers: &Followers) -> Vec<Statement> {
    let net = lowering.net;
    let mut out = Vec::new();
    for set in lowering.situation.sets.clone() {
        let value = set.steps.iter().find(|s| net.places[**s].initial).map_or(set.idle, |s| value_of(lowering, *s));
        out.push(assign_number(lowering, set.variable, value));
        if set.next != set.variable {
            out.push(assign_number(lowering, set.next, value));
        }
        for s in set.steps.iter().filter(|s| net.places[**s].initial) {
            out.extend(entered(lowering, followers, *s));
        }
    }
    out
}

/// The outputs that become true with a step.
fn entered(lowering: &mut Lowering, followers: &Followers, s: StepId) -> Vec<Statement> {
    let value = lowering.pool.truth(true);
    let wires = followers.on_step(lowering.net, s).into_iter().filter(|(_, conditions)| conditions.is_empty());
    wires.map(|(v, _)| Statement::Assign { target: lowering.symbols.declared(v), value, remark: None }).collect()
}

fn value_of(lowering: &Lowering, s: StepId) -> i64 {
    match lowering.situation.holder(s) {
        Holder::State { value, .. } => value,
        Holder::Bit(_) => 0,
    }
}

fn assign_number(lowering: &mut Lowering, target: VarId, value: i64) -> Statement {
    let ty = lowering.symbols.table[target].ty;
    Statement::Assign { target, value: lowering.pool.constant(Value::Int(value), ty), remark: None }
}

fn assign_truth(lowering: &mut Lowering, target: VarId, value: bool) -> Statement {
    Statement::Assign { target, value: lowering.pool.truth(value), remark: None }
}

fn copy(lowering: &mut Lowering, target: VarId, from: VarId) -> Statement {
    let value = lowering.symbols.read(&mut lowering.pool, from);
    Statement::Assign { target, value, remark: None }
}

/// Which transition of a set clears, where an action waits for it.
struct Numbered {
    /// The variable of each set that has such a transition, 0 outside of a micro-step.
    variable: BTreeMap<usize, VarId>,
    transitions: FxHashSet<TransitionId>,
}

impl Numbered {
    fn new(lowering: &mut Lowering) -> Self {
        let net = lowering.net;
        let mut numbered = Numbered { variable: BTreeMap::new(), transitions: FxHashSet::default() };
        for action in &net.stored {
            let Event::Clearing(t) = action.event else { continue };
            let Some(set) = home(lowering, t) else { continue };
            numbered.transitions.insert(t);
            numbered.variable.entry(set).or_insert_with(|| {
                let base = lowering.symbols.table[lowering.situation.sets[set].variable].name.clone();
                let base = base.strip_prefix("at_").unwrap_or(&base);
                let comment = Some("number of the transition that clears, else 0".to_owned());
                lowering.symbols.fresh(Role::Memory, format!("clears_{base}"), Type::Dint, comment)
            });
        }
        numbered
    }
}

/// The set in whose arms a transition is looked at: that of the first step before it, if sets hold all steps around it.
fn home(lowering: &Lowering, t: TransitionId) -> Option<usize> {
    let transition = &lowering.net.transitions[t];
    let set = |s: &StepId| match lowering.situation.holder(*s) {
        Holder::State { set, .. } => Some(set),
        Holder::Bit(_) => None,
    };
    let first = set(transition.pre.first()?)?;
    transition.pre.iter().chain(&transition.post).all(|s| set(s).is_some()).then_some(first)
}

/// The variable that says that something clears, and whether it is also what asks for another micro-step.
struct Moved {
    variable: VarId,
    asks_again: bool,
}

impl Moved {
    fn new(lowering: &mut Lowering, task: &Task, numbered: &Numbered) -> Self {
        // A clearing that leads back to where it came from changes nothing, but its actions are done.
        let only_back = numbered.transitions.iter().any(|t| changes_of(lowering, *t).is_empty());
        let bits = lowering.net.places.indices().any(|s| lowering.situation.bit(s).is_some());
        match task.again.filter(|_| lowering.edges.is_empty() && !only_back && !bits) {
            Some(variable) => Moved { variable, asks_again: true },
            None => {
                let variable = lowering.symbols.fresh(Role::Temporary, "moved", Type::Bool, None);
                Moved { variable, asks_again: false }
            }
        }
    }
}

/// What a clearing makes of the states around it.
fn changes_of(lowering: &Lowering, t: TransitionId) -> Vec<(usize, i64)> {
    let transition = &lowering.net.transitions[t];
    let mut left: BTreeMap<usize, i64> = BTreeMap::new();
    let mut come: BTreeMap<usize, i64> = BTreeMap::new();
    for s in &transition.pre {
        if let Holder::State { set, value } = lowering.situation.holder(*s) {
            left.insert(set, value);
        }
    }
    for s in &transition.post {
        if let Holder::State { set, value } = lowering.situation.holder(*s) {
            come.insert(set, value);
        }
    }
    let mut changes = Vec::new();
    for (set, from) in &left {
        let to = come.get(set).copied().unwrap_or(lowering.situation.sets[*set].idle);
        if to != *from {
            changes.push((*set, to));
        }
    }
    changes.extend(come.iter().filter(|(set, _)| !left.contains_key(set)).map(|(set, to)| (*set, *to)));
    changes
}

struct Switch<'t> {
    task: &'t Task<'t>,
    layout: Layout,
    numbered: Numbered,
    moved: Moved,
    cleared: IndexVec<TransitionId, FormulaId>,
}

impl Switch<'_> {
    /// The transitions: those around bits latched one by one, the others in the arms of their first step.
    fn transitions(&mut self, lowering: &mut Lowering, frozen: &settle::Frozen) -> Vec<Statement> {
        let net = lowering.net;
        let mut latched = Vec::new();
        let mut moves = Vec::new();
        let mut branches: FxHashMap<StepId, Vec<(FormulaId, Vec<Statement>)>> = FxHashMap::default();
        for (t, transition) in net.transitions.iter_enumerated() {
            let factors = clears(lowering, t, self.task.conditions[t], frozen, self.task.simplify);
            let mut body = Vec::new();
            let changes = changes_of(lowering, t);
            for (set, value) in &changes {
                body.push(assign_number(lowering, lowering.situation.sets[*set].next, *value));
            }
            let home = home(lowering, t);
            let mut cleared = lowering.pool.truth(false);
            if let (Some(set), true) = (home, self.numbered.transitions.contains(&t)) {
                let (variable, number) = (self.numbered.variable[&set], t.index() as i64 + 1);
                body.push(assign_number(lowering, variable, number));
                cleared = equals(&lowering.symbols, &mut lowering.pool, variable, number);
            }
            if home.is_none() || !body.is_empty() {
                body.push(assign_truth(lowering, self.moved.variable, true));
            }
            let told = self.moved.asks_again || changes.is_empty();
            if let Some(again) = self.task.again.filter(|_| !told) {
                body.push(assign_truth(lowering, again, true));
            }
            match (home, transition.pre.first()) {
                (Some(_), Some(first)) => {
                    let own = lowering.active(*first);
                    let when = lowering.pool.and(factors.into_iter().filter(|f| *f != own));
                    if let Some(Statement::Assign { remark, .. }) = body.first_mut() {
                        *remark = Some(drawn(net, t));
                    }
                    if !body.is_empty() {
                        branches.entry(*first).or_default().push((when, body));
                    }
                }
                _ => {
                    let value = lowering.pool.and(factors);
                    let name = format!("clr_{}", designation(net, t));
                    let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
                    latched.push(Statement::Assign { target, value, remark: Some(drawn(net, t)) });
                    cleared = lowering.symbols.read(&mut lowering.pool, target);
                    moves.extend(choose(lowering, vec![(cleared, body)]));
                }
            }
            self.cleared.push(cleared);
        }
        let mut out = Vec::new();
        out.push(assign_truth(lowering, self.moved.variable, false));
        if let Some(again) = self.task.again.filter(|_| !self.moved.asks_again && lowering.edges.is_empty()) {
            out.push(assign_truth(lowering, again, false));
        }
        out.extend(latched);
        out.extend(self.nest(lowering, branches));
        out.extend(moves);
        out
    }

    /// Puts the branches of each step into the arms of its set, and those of an enclosure into the arm of the step that
    /// encloses it; from the bottom of the hierarchy up.
    fn nest(
        &self,
        lowering: &Lowering,
        mut branches: FxHashMap<StepId, Vec<(FormulaId, Vec<Statement>)>>,
    ) -> Vec<Statement> {
        let net = lowering.net;
        let mut depth: IndexVec<GrafcetId, usize> = net.grafcets.iter().map(|_| 0).collect();
        for g in &net.hierarchy {
            depth[*g] = match within(net, *g) {
                Some(e) if lowering.situation.bit(e).is_none() => (depth[net.places[e].grafcet] + 1) % DEEPEST,
                Some(_) | None => 0,
            };
        }
        let mut nested: FxHashMap<StepId, Vec<Statement>> = FxHashMap::default();
        let mut top: BTreeMap<GrafcetId, Vec<Statement>> = BTreeMap::new();
        for g in net.hierarchy.iter().rev() {
            // What is nested comes from the last to the first, and is put in order when its arm is written.
            for index in self.layout.sets_of[*g].iter().rev() {
                let set = &lowering.situation.sets[*index];
                let mut arms = Arms::default();
                for s in &set.steps {
                    let mut body = choose(lowering, branches.remove(s).unwrap_or_default());
                    body.extend(nested.remove(s).unwrap_or_default().into_iter().rev());
                    arms.add(lowering, *s, body);
                }
                let case = arms.case(set.variable);
                match within(net, *g).filter(|_| depth[*g] > 0) {
                    Some(e) => nested.entry(e).or_default().extend(case),
                    None => top.entry(*g).or_default().extend(case),
                }
            }
        }
        top.into_values().flat_map(|cases| cases.into_iter().rev()).collect()
    }

    /// Enclosures and orders, grafcet by grafcet from the top down (R5).
    fn settle(&self, lowering: &mut Lowering, clearings: &mut Clearings) -> Vec<Statement> {
        let net = lowering.net;
        let acted_on = settle::acted_on(net);
        let mut out = Vec::new();
        for g in &net.hierarchy {
            let around = within(net, *g).map(|e| self.next(lowering, clearings, e));
            let known = &clearings.next;
            let mut next = |lowering: &mut Lowering, s: StepId| match known[s] {
                Some(next) => next,
                None => next_in_set(lowering, s),
            };
            let in_force = settle::orders(lowering, self.task.components, *g, around, &mut next, &mut out);
            for s in net.grafcets[*g].steps.iter().filter(|s| acted_on[**s]) {
                if lowering.situation.bit(*s).is_none() {
                    continue;
                }
                let own = match clearings.place(lowering, *s, false) {
                    Some(place) => Encoding::Switch.next(&mut lowering.pool, &place),
                    None => lowering.active(*s),
                };
                let value = settle::settled(lowering, *s, own, around, in_force.as_ref());
                let name = format!("next_{}", net.places[*s].label);
                let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
                out.push(Statement::Assign { target, value, remark: None });
                clearings.next[*s] = Some(lowering.symbols.read(&mut lowering.pool, target));
            }
            if let Some(in_force) = in_force {
                for index in &self.layout.sets_of[*g] {
                    let set = lowering.situation.sets[*index].clone();
                    let mut branches = Vec::new();
                    for (when, steps) in &in_force.orders {
                        let member = steps.iter().find(|s| set.steps.binary_search(s).is_ok());
                        let value = member.map_or(set.idle, |s| value_of(lowering, *s));
                        let when = lowering.pool.and(around.into_iter().chain([*when]));
                        branches.push((when, vec![assign_number(lowering, set.next, value)]));
                    }
                    out.extend(choose(lowering, branches));
                }
            }
            out.extend(self.enclose(lowering, clearings, *g));
        }
        // Events of covered steps compare the state with the next one.
        for s in net.places.indices() {
            if lowering.situation.bit(s).is_none() {
                clearings.next[s] = Some(next_in_set(lowering, s));
            }
        }
        out
    }

    /// What the steps of a grafcet enclose is emptied with them and starts with them (R5a).
    fn enclose(&self, lowering: &mut Lowering, clearings: &Clearings, g: GrafcetId) -> Vec<Statement> {
        let net = lowering.net;
        let mut out = Vec::new();
        if self.layout.inside.is_empty() {
            return out;
        }
        for index in &self.layout.sets_of[g] {
            let set = lowering.situation.sets[*index].clone();
            let (mut left, mut come) = (Arms::default(), Arms::default());
            for s in &set.steps {
                let (emptied, started) = (self.emptied(lowering, *s), self.started(lowering, *s));
                left.add(lowering, *s, emptied);
                come.add(lowering, *s, started);
            }
            let body: Vec<Statement> = left.case(set.variable).into_iter().chain(come.case(set.next)).collect();
            if !body.is_empty() {
                let moves = differs(lowering, set.variable, set.next);
                out.extend(choose(lowering, vec![(moves, body)]));
            }
        }
        for s in &net.grafcets[g].steps {
            let Some(next) = clearings.next[*s].filter(|_| lowering.situation.bit(*s).is_some()) else { continue };
            let active = lowering.active(*s);
            let (gone, fresh) = (lowering.pool.not(next), lowering.pool.not(active));
            for (when, body) in [
                (lowering.pool.and([active, gone]), self.emptied(lowering, *s)),
                (lowering.pool.and([next, fresh]), self.started(lowering, *s)),
            ] {
                if !body.is_empty() {
                    out.extend(choose(lowering, vec![(when, body)]));
                }
            }
        }
        out
    }

    fn emptied(&self, lowering: &mut Lowering, e: StepId) -> Vec<Statement> {
        let mut body = Vec::new();
        for index in self.layout.enclosed(e) {
            let set = &lowering.situation.sets[index];
            let (next, idle) = (set.next, set.idle);
            body.push(assign_number(lowering, next, idle));
        }
        body
    }

    fn started(&self, lowering: &mut Lowering, e: StepId) -> Vec<Statement> {
        let mut body = Vec::new();
        for index in self.layout.enclosed(e) {
            let set = &lowering.situation.sets[index];
            let (next, first) = (set.next, set.steps.iter().copied().find(|s| lowering.net.places[*s].activated));
            if let Some(s) = first {
                body.push(assign_number(lowering, next, value_of(lowering, s)));
            }
        }
        body
    }

    /// Bits that change ask for another micro-step; states have done so when they were written.
    fn tell_changed_bits(&self, lowering: &mut Lowering, clearings: &Clearings) -> Option<Statement> {
        let again = self.task.again?;
        let told: IndexVec<TransitionId, bool> =
            lowering.net.transitions.indices().map(|t| !changes_of(lowering, t).is_empty()).collect();
        let mut terms = clearings.changes(lowering, self.task, |t| told[t]);
        if terms.is_empty() {
            return None;
        }
        terms.insert(0, lowering.symbols.read(&mut lowering.pool, again));
        Some(Statement::Assign { target: again, value: lowering.pool.or(terms), remark: None })
    }

    /// Outputs that follow a state.
    fn follow(&self, lowering: &mut Lowering) -> Vec<Statement> {
        let mut out = Vec::new();
        let Some(followers) = self.task.followers else { return out };
        for (index, wires) in followers.of_set.iter().enumerate() {
            if wires.is_empty() {
                continue;
            }
            let set = lowering.situation.sets[index].clone();
            let (mut left, mut come) = (Arms::default(), Arms::default());
            for s in &set.steps {
                let mut off = Vec::new();
                for (wire, _) in followers.on_step(lowering.net, *s) {
                    let target = lowering.symbols.declared(wire);
                    off.push(assign_truth(lowering, target, false));
                }
                let on = entered(lowering, followers, *s);
                left.add(lowering, *s, off);
                come.add(lowering, *s, on);
            }
            let body: Vec<Statement> = left.case(set.variable).into_iter().chain(come.case(set.next)).collect();
            let moves = differs(lowering, set.variable, set.next);
            out.extend(choose(lowering, vec![(moves, body)]));
        }
        out
    }

    /// The next situation becomes the situation, from the bottom up: a state is read until what it encloses is written.
    fn commit(&self, lowering: &mut Lowering, clearings: &Clearings) -> Vec<Statement> {
        let net = lowering.net;
        let mut out = Vec::new();
        for s in net.places.indices() {
            let Some(target) = lowering.situation.bit(s) else { continue };
            let value = match clearings.next[s] {
                Some(next) => Some(next),
                None => {
                    clearings.place(lowering, s, false).map(|place| Encoding::Switch.next(&mut lowering.pool, &place))
                }
            };
            if let Some(value) = value.filter(|value| *value != lowering.active(s)) {
                out.push(Statement::Assign { target, value, remark: None });
            }
        }
        for g in net.hierarchy.iter().rev() {
            for index in &self.layout.sets_of[*g] {
                let set = lowering.situation.sets[*index].clone();
                out.extend(self.commit_enclosed(lowering, &set));
                let by_encloser =
                    within(net, *g).is_some_and(|e| lowering.situation.bit(e).is_none()) && !self.layout.forced[*g];
                if !by_encloser {
                    out.push(copy(lowering, set.variable, set.next));
                }
            }
        }
        for variable in self.numbered.variable.values() {
            out.push(assign_number(lowering, *variable, 0));
        }
        out
    }

    /// Only what the step that was active and the one that will be enclose can have moved.
    fn commit_enclosed(&self, lowering: &mut Lowering, set: &crate::situation::Set) -> Vec<Statement> {
        let (mut was, mut will) = (Arms::default(), Arms::default());
        for s in &set.steps {
            let mut body = Vec::new();
            for index in self.layout.enclosed(*s) {
                let inner = &lowering.situation.sets[index];
                if !self.layout.forced[inner.grafcet] {
                    let (variable, next) = (inner.variable, inner.next);
                    body.push(copy(lowering, variable, next));
                }
            }
            was.add(lowering, *s, body.clone());
            will.add(lowering, *s, body);
        }
        let mut out: Vec<Statement> = was.case(set.variable).into_iter().collect();
        if let Some(case) = will.case(set.next) {
            let moves = differs(lowering, set.variable, set.next);
            out.extend(choose(lowering, vec![(moves, vec![case])]));
        }
        out
    }

    /// The next activity of a step.
    fn next(&self, lowering: &mut Lowering, clearings: &Clearings, s: StepId) -> FormulaId {
        match clearings.next[s] {
            Some(next) => next,
            None => next_in_set(lowering, s),
        }
    }
}

fn next_in_set(lowering: &mut Lowering, s: StepId) -> FormulaId {
    match lowering.situation.holder(s) {
        Holder::State { set, value } => {
            equals(&lowering.symbols, &mut lowering.pool, lowering.situation.sets[set].next, value)
        }
        Holder::Bit(_) => lowering.active(s),
    }
}

/// `next <> at`.
fn differs(lowering: &mut Lowering, a: VarId, b: VarId) -> FormulaId {
    let (a, b) = (lowering.symbols.read(&mut lowering.pool, a), lowering.symbols.read(&mut lowering.pool, b));
    lowering.pool.differs(b, a)
}
