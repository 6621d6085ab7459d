//! Pulse orders (R15), for one grafcet after the other from the top of the hierarchy, between what its enclosing step and what
//! forcing orders make of it.
//!
//! ```text
//! kill    given, or what is above is killed          resume   given, and G is frozen, and no kill
//! start   given                                      freeze   given, or what is above is frozen; and no kill
//! still   fr AND NOT (kill OR resume OR start)       the freezing that goes on
//! N1_i  = own AND NOT kill  OR  resume AND saved_i  OR  start AND initial_i
//! N_i   = N1_i AND NOT stop                          stop = freeze AND NOT still
//! saved_i := stop AND N1_i  OR  still AND saved_i    fr := still  OR  stop AND (OR N1)
//! ```
//!
//! `own` is what clearings and links make of the step. What is remembered is written at the end of the micro-step.

use crate::encode::choose::raise;
use crate::encode::clearings::Clearings;
use crate::encode::input_event::InputEvent;
use crate::encode::settle::InForce;
use crate::encode::stored;
use crate::encode::task::Task;
use crate::lower::Lowering;
use crate::scan::{Flag, Origin, Role, Statement};
use grafc_formula::{Formula, FormulaId};
use grafc_model::chart::{Event, GrafcetId, PulseKind, StepId};
use grafc_net::net::CommandsOn;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// What pulse orders do in a micro-step.
pub(crate) struct Pulses {
    on: IndexVec<GrafcetId, CommandsOn>,
    below: IndexVec<GrafcetId, Vec<GrafcetId>>,
    /// When the event of a pulse occurs, of those that wait for one, by its number.
    events: FxHashMap<usize, FormulaId>,
    /// Whether a grafcet is killed or frozen in this micro-step, or enclosed in what is.
    stopped: IndexVec<GrafcetId, Option<FormulaId>>,
    /// What kills, and what freezes, what is above.
    inherited: IndexVec<GrafcetId, (Vec<FormulaId>, Vec<FormulaId>)>,
    /// Whether a step is resumed.
    resumed: FxHashMap<StepId, FormulaId>,
    /// What is remembered of it.
    pub(crate) remembered: Vec<Statement>,
    /// What of that, and of the situation, changes: the terms of a disjunction.
    pub(crate) changes: Vec<FormulaId>,
}

impl Pulses {
    /// Before anything is settled: the events that pulses wait for.
    pub(crate) fn new(
        lowering: &mut Lowering,
        task: &Task,
        input_event: &mut InputEvent,
        statements: &mut Vec<Statement>,
    ) -> Self {
        let net = &*lowering.net.clone();
        let mut events = FxHashMap::default();
        let no_edges = stored::without_edges(lowering, !task.pulses.is_empty(), statements);
        for (index, pulse) in net.pulses.iter().enumerate() {
            let (Event::Event(s, _), Some(expr)) = (pulse.event, task.pulses.get(&index)) else { continue };
            let origin = Origin::Orders(pulse.grafcet);
            let (when, _) = stored::event(lowering, (s, origin), *expr, &no_edges, input_event, statements);
            let name = format!("{}_{}", pulse.kind.word(), net.grafcets[pulse.grafcet].name);
            events.insert(index, latched(lowering, origin, &name, when, statements));
        }
        Pulses {
            on: net.commands_on(),
            below: net.commanded_below(),
            events,
            stopped: net.grafcets.iter().map(|_| None).collect(),
            inherited: net.grafcets.iter().map(|_| (Vec::new(), Vec::new())).collect(),
            resumed: FxHashMap::default(),
            remembered: Vec::new(),
            changes: Vec::new(),
        }
    }

    /// What is given to a grafcet, by kind.
    fn given(&self, lowering: &mut Lowering, clearings: &Clearings, g: GrafcetId) -> [Vec<FormulaId>; 4] {
        let net = &*lowering.net.clone();
        let mut given: [Vec<FormulaId>; 4] = Default::default();
        let next = |lowering: &Lowering, s: StepId| clearings.next[s].unwrap_or_else(|| lowering.active(s));
        for (index, pulse) in self.on[g].pulses.iter().map(|place| (*place, &net.pulses[*place])) {
            let (occurs, is_new) = match pulse.event {
                Event::Event(..) => (self.events.get(&index).copied().unwrap_or(lowering.pool.truth(false)), false),
                Event::Clearing(t) => (clearings.cleared[t], false),
                Event::Deactivation(s) => {
                    let gone = lowering.pool.not(next(lowering, s));
                    (lowering.pool.and([lowering.active(s), gone]), false)
                }
                Event::Activation(s) => {
                    let was_not = lowering.pool.not(lowering.active(s));
                    (lowering.pool.and([next(lowering, s), was_not]), true)
                }
                Event::EachScan(..) => continue,
            };
            // What was killed or frozen gives nothing but what its new steps give.
            let stopped = self.stopped[net.commander(pulse.event)].filter(|_| !is_new);
            let goes_on = stopped.map(|stopped| lowering.pool.not(stopped));
            given[pulse.kind as usize].push(lowering.pool.and([Some(occurs), goes_on].into_iter().flatten()));
        }
        let runs = &self.on[g].runs;
        if runs.is_empty() {
            return given;
        }
        let was = lowering.pool.or(runs.iter().map(|s| lowering.active(*s)).collect::<Vec<_>>());
        let is = lowering.pool.or(runs.iter().map(|s| next(lowering, *s)).collect::<Vec<_>>());
        let (was_not, is_not) = (lowering.pool.not(was), lowering.pool.not(is));
        let begins = lowering.pool.and([was_not, is]);
        let resumed: Vec<FormulaId> = runs.iter().filter_map(|s| self.resumed.get(s).copied()).collect();
        let resumed = lowering.pool.or(resumed);
        given[PulseKind::Resume as usize].push(lowering.pool.and([begins, resumed]));
        let not_resumed = lowering.pool.not(resumed);
        given[PulseKind::Start as usize].push(lowering.pool.and([begins, not_resumed]));
        let mut left = Vec::with_capacity(runs.len());
        for s in runs {
            let goes_on = self.stopped[net.places[*s].grafcet].map(|stopped| lowering.pool.not(stopped));
            left.push(lowering.pool.and([Some(lowering.active(*s)), goes_on].into_iter().flatten()));
        }
        let left = lowering.pool.or(left);
        given[PulseKind::Kill as usize].push(lowering.pool.and([left, is_not]));
        given
    }

    /// What pulse orders make of the steps of a grafcet, of which `own` is what clearings and links make.
    pub(crate) fn act(
        &mut self,
        lowering: &mut Lowering,
        clearings: &Clearings,
        g: GrafcetId,
        (within, in_force): (Option<FormulaId>, Option<&InForce>),
        own: &mut FxHashMap<StepId, FormulaId>,
        statements: &mut Vec<Statement>,
    ) {
        let net = &*lowering.net.clone();
        let around = net.around(g).and_then(|around| self.stopped[around]);
        self.stopped[g] = around;
        if self.on[g].is_empty() {
            return;
        }
        let (grafcet, origin) = (&net.grafcets[g], Origin::Orders(g));
        let given = self.given(lowering, clearings, g);
        let one = |lowering: &mut Lowering, kind: PulseKind, more: Vec<FormulaId>, out: &mut Vec<Statement>| {
            let any = lowering.pool.or(given[kind as usize].iter().copied().chain(more));
            let name = format!("{}_{}", kind.word(), grafcet.name);
            latched(lowering, origin, &name, any, out)
        };
        let none = Vec::new;
        let [kill, resume, start, freeze] = PulseKind::ALL.map(|kind| one(lowering, kind, none(), statements));
        disagree(lowering, g, [kill, resume, start, freeze], within, statements);
        let (kills, freezes) = self.inherited[g].clone();
        let kill = lowering.pool.or([kill].into_iter().chain(kills));
        let kill = lowering.pool.and([Some(kill), within].into_iter().flatten());
        let kill = latched(lowering, origin, &format!("kills_{}", grafcet.name), kill, statements);
        let not_killed = lowering.pool.not(kill);
        let frozen = lowering.is_frozen(g);
        let resume = lowering.pool.and([Some(resume), Some(frozen), Some(not_killed), within].into_iter().flatten());
        let resume = latched(lowering, origin, &format!("resumes_{}", grafcet.name), resume, statements);
        let start = lowering.pool.and([Some(start), within].into_iter().flatten());
        let start = latched(lowering, origin, &format!("starts_{}", grafcet.name), start, statements);
        let freeze = lowering.pool.or([freeze].into_iter().chain(freezes));
        let freeze = lowering.pool.and([Some(freeze), Some(not_killed), within].into_iter().flatten());
        let freeze = latched(lowering, origin, &format!("freezes_{}", grafcet.name), freeze, statements);
        let ends = lowering.pool.or([kill, resume, start]);
        let goes_on = lowering.pool.not(ends);
        let still = lowering.pool.and([frozen, goes_on]);
        let still = latched(lowering, origin, &format!("still_{}", grafcet.name), still, statements);
        let anew = lowering.pool.not(still);
        let stop = lowering.pool.and([freeze, anew]);
        let stop = latched(lowering, origin, &format!("stops_{}", grafcet.name), stop, statements);
        let not_stopped = lowering.pool.not(stop);

        let mut tokens = Vec::with_capacity(grafcet.steps.len());
        let mut saved_steps = Vec::new();
        for s in &grafcet.steps {
            let before = own.get(s).copied().unwrap_or_else(|| lowering.active(*s));
            let mut terms = vec![lowering.pool.and([before, not_killed])];
            if let Some(bit) = lowering.frozen_bits.saved[*s] {
                let saved = lowering.symbols.read(&mut lowering.pool, bit);
                let again = lowering.pool.and([resume, saved]);
                let again = lowering.named(origin, &format!("resumed_{}", net.places[*s].label), again, statements);
                self.resumed.insert(*s, again);
                terms.push(again);
            }
            if net.places[*s].started {
                terms.push(start);
            }
            let value = lowering.pool.or(terms);
            if lowering.frozen_bits.frozen[g].is_none() {
                own.insert(*s, value);
                continue;
            }
            // The next activity of the step, which it may read, is written again before what is saved is.
            let value = match lowering.pool.as_truth(value) {
                Some(_) => value,
                None => lowering.in_new(origin, &format!("kept_{}", net.places[*s].label), value, statements),
            };
            tokens.push(value);
            saved_steps.push((*s, value));
            own.insert(*s, lowering.pool.and([value, not_stopped]));
        }
        let any = lowering.pool.or(tokens);
        let stops = lowering.pool.and([stop, any]);
        let stopped = lowering.pool.or([Some(kill), Some(stops), around].into_iter().flatten());
        let stopped = latched(lowering, origin, &format!("stopped_{}", grafcet.name), stopped, statements);
        self.stopped[g] = Some(stopped);
        for below in self.below[g].clone() {
            self.inherited[below].0.push(kill);
            self.inherited[below].1.push(freeze);
        }
        self.remember(lowering, g, (within, in_force), (stop, still, any), saved_steps);
    }

    /// What is saved, and whether the grafcet is frozen: nothing where its enclosing step is inactive, or an order sets a
    /// situation.
    fn remember(
        &mut self,
        lowering: &mut Lowering,
        g: GrafcetId,
        (within, in_force): (Option<FormulaId>, Option<&InForce>),
        (stop, still, any): (FormulaId, FormulaId, FormulaId),
        steps: Vec<(StepId, FormulaId)>,
    ) {
        let Some(frozen) = lowering.frozen_bits.frozen[g] else { return };
        let free = in_force.map(|in_force| lowering.pool.not(in_force.any));
        let mut write = |lowering: &mut Lowering, target, value: FormulaId, origin| {
            let value = lowering.pool.and([Some(value), within, free].into_iter().flatten());
            let was = lowering.symbols.read(&mut lowering.pool, target);
            if value != was {
                self.changes.push(lowering.pool.xor(value, was));
                self.remembered.push(Statement::assign(origin, target, value));
            }
        };
        for (s, value) in steps {
            let Some(bit) = lowering.frozen_bits.saved[s] else { continue };
            let saved = lowering.symbols.read(&mut lowering.pool, bit);
            let (new, old) = (lowering.pool.and([stop, value]), lowering.pool.and([still, saved]));
            let value = lowering.pool.or([new, old]);
            write(lowering, bit, value, Origin::Step(s));
        }
        let new = lowering.pool.and([stop, any]);
        let value = lowering.pool.or([still, new]);
        write(lowering, frozen, value, Origin::Orders(g));
    }
}

/// A value that is not read again from what it was made of; in a new temporary, unless it is constant.
fn latched(
    lowering: &mut Lowering,
    origin: Origin,
    name: &str,
    value: FormulaId,
    statements: &mut Vec<Statement>,
) -> FormulaId {
    let stays = match lowering.pool.get(value) {
        Formula::Variable(v) => lowering.symbols.table[*v].role == Role::Temporary,
        Formula::Constant(_) => true,
        _ => false,
    };
    if stays { value } else { lowering.in_new(origin, name, value, statements) }
}

/// Different kinds given at once raise the flag; kill with start is a restart.
fn disagree(
    lowering: &mut Lowering,
    g: GrafcetId,
    [kill, resume, start, freeze]: [FormulaId; 4],
    within: Option<FormulaId>,
    statements: &mut Vec<Statement>,
) {
    let pairs = [(kill, resume), (kill, freeze), (resume, start), (resume, freeze), (start, freeze)];
    let terms = pairs.map(|(a, b)| lowering.pool.and([a, b]));
    let both = lowering.pool.or(terms);
    let when = lowering.pool.and([Some(both), within].into_iter().flatten());
    statements.extend(raise(lowering, Flag::ForceConflict, Origin::Orders(g), when));
}
