//! One path through one reaction: the scan program as it stands, with inputs and time as they are asked for.

use crate::atom::{Atom, Path, Question};
use crate::beyond::Beyond;
use crate::claimed::Claimed;
use crate::clocks::{Clocks, Phase};
use crate::facts::{Active, Fact, Facts};
use crate::goal::Answers;
use crate::inputs::computed;
use crate::live::Live;
use crate::pack::{self, Layout, State};
use grafc_formula::number::{arithmetic, compare, divide, negate, zero};
use grafc_formula::{Comparison, Formula, FormulaId, TimerId, Type, Value, VarId};
use grafc_logic::scan::{Choice, Division, Program, Role, Statement, TransitionId};
use grafc_model::chart::Bits;
use index_vec::IndexVec;
use std::collections::BTreeSet;

/// How a path ended.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum End {
    /// In a state, with this situation.
    Rest(State, Vec<usize>),
    /// It would go on without end, by these transitions (R9).
    Livelock(Vec<TransitionId>),
    /// An assumption is broken by its inputs.
    Barred,
}

/// Runs a program.
pub(crate) struct Machine<'p> {
    program: &'p Program,
    clocks: Clocks,
    between_calls: Layout,
    between_micro_steps: Layout,
    /// What is seen of micro-steps, if that is wanted.
    facts: Option<Facts>,
    claimed: Claimed,
    values: IndexVec<VarId, Value>,
    timers: IndexVec<TimerId, Phase>,
    memo: Vec<(u64, Seen)>,
    mark: u64,
    stack: Vec<(FormulaId, bool)>,
    /// The transitions that the latest reaction has cleared so far.
    passed: Vec<TransitionId>,
    /// Inputs that are asked for bit by bit.
    by_bits: BTreeSet<VarId>,
}

/// So many claims that something leads to something are followed.
pub(crate) const MOST_LEADS: usize = 31;

/// What of claims is true in a state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Marks(u64);

impl Marks {
    /// Whether the chart may have come to its end.
    pub(crate) fn is_final(self) -> bool {
        self.0 & 1 == 1
    }

    /// Of what leads to what, whether the first is true, and the second.
    pub(crate) fn leads(self, place: usize) -> (bool, bool) {
        (self.0 >> (1 + 2 * place) & 1 == 1, self.0 >> (2 + 2 * place) & 1 == 1)
    }
}

/// What is known of a formula.
#[derive(Clone, Copy, Debug)]
enum Seen {
    Value(Value),
    /// It needs the answer to this.
    Open(Atom),
    /// It is what is given for an input that is a number.
    Given(VarId),
    /// It is for how long a timer has run.
    Elapsed(TimerId),
    /// It is made of what is given, in a way that cannot be followed.
    Beyond(VarId),
}

impl<'p> Machine<'p> {
    /// A program, of which transitions are shown.
    pub(crate) fn new(program: &'p Program) -> Result<Self, Beyond> {
        let claimed = Claimed::new(program);
        let live = Live::new(program, &claimed.after);
        Ok(Machine {
            program,
            clocks: Clocks::new(program)?,
            between_calls: Layout::new(program, &live.between_calls, 1 + 2 * claimed.leads.len()),
            between_micro_steps: Layout::new(program, &live.between_micro_steps, 1),
            facts: None,
            claimed,
            values: IndexVec::new(),
            timers: IndexVec::new(),
            memo: vec![(0, Seen::Value(Value::Bool(false))); program.pool.len()],
            mark: 0,
            stack: Vec::new(),
            passed: Vec::new(),
            by_bits: BTreeSet::new(),
        })
    }

    /// One that asks for numbers that are given bit by bit where they are not only compared with what is known.
    pub(crate) fn by_bits(program: &'p Program) -> Result<Self, Beyond> {
        Ok(Machine { by_bits: computed(program), ..Machine::new(program)? })
    }

    /// From here on, micro-steps are looked at, and timers of which no reaction asked are vague.
    pub(crate) fn look_on(&mut self) {
        self.facts = Some(Facts::new(self.program));
    }

    /// What was seen of the latest path.
    pub(crate) fn facts(&self) -> impl Iterator<Item = Fact> + '_ {
        self.facts.iter().flat_map(Facts::seen)
    }

    /// The timers after the latest path.
    pub(crate) fn timers(&self) -> &IndexVec<TimerId, Phase> {
        &self.timers
    }

    /// The transitions that the latest path has cleared, in order of time; one may be there several times.
    pub(crate) fn passed(&self) -> &[TransitionId] {
        &self.passed
    }

    /// What timers measure.
    pub(crate) fn clocks(&self) -> &Clocks {
        &self.clocks
    }

    /// Walks all paths of a reaction from a state, or of the initial reaction, as long as they are wanted.
    pub(crate) fn reactions(
        &mut self,
        from: Option<&State>,
        mut visit: impl FnMut(&Self, End, &[(Atom, bool)]) -> bool,
    ) -> Result<(), Beyond> {
        let mut path = Path::default();
        loop {
            path.rewind();
            self.load(from);
            let end = self.react(from.is_none(), &mut path)?;
            if !visit(self, end, path.answers()) || !path.advance() {
                return Ok(());
            }
        }
    }

    /// Goes one path, whose answers are known.
    pub(crate) fn walk(&mut self, from: Option<&State>, answers: &[(Atom, bool)]) -> Result<End, Beyond> {
        let mut path = Path::of(answers);
        self.load(from);
        self.react(from.is_none(), &mut path)
    }

    /// Goes the path that agrees with what is given, and says what of it was asked, in order.
    pub(crate) fn follow(&mut self, from: Option<&State>, given: &[(Atom, bool)]) -> Result<(End, Answers), Beyond> {
        let mut path = Path::given(given);
        self.load(from);
        let end = self.react(from.is_none(), &mut path)?;
        Ok((end, path.answers().to_vec()))
    }

    /// The names and values of what makes a state beside the situation.
    pub(crate) fn told(&self, state: &State) -> Vec<(String, String)> {
        let shown = self.between_calls.variables(state).filter(|(v, _)| match self.program.variables[*v].role {
            Role::Output | Role::Internal | Role::Memory => Some(*v) != self.program.started,
            Role::Input
            | Role::Constant
            | Role::Step
            | Role::State
            | Role::Flag(_)
            | Role::Temporary
            | Role::Observed => false,
        });
        let name = |v: VarId| self.program.variables[v].name.to_string();
        let mut told: Vec<(String, String)> = shown.map(|(v, value)| (name(v), spelled(value))).collect();
        for (timer, phase) in self.program.timers.iter().zip(self.between_calls.timers(state)) {
            let told_of = match phase.passed {
                _ if !phase.on => continue,
                0 => "runs".to_string(),
                passed => format!("ended {passed}"),
            };
            told.push((timer.name.clone(), told_of));
        }
        told
    }

    fn load(&mut self, from: Option<&State>) {
        self.facts.iter_mut().for_each(Facts::forget);
        self.values = self.program.variables.iter().map(|v| v.initial()).collect();
        self.timers = self.program.timers.iter().map(|_| Phase::default()).collect();
        if let Some(wanted) = self.program.observing.as_ref().and_then(|observing| observing.wanted) {
            self.values[wanted] = Value::Bool(true);
        }
        let Some(state) = from else { return };
        // No initial reaction is due.
        if let Some(started) = self.program.started {
            self.values[started] = Value::Bool(true);
        }
        for (v, value) in self.between_calls.variables(state) {
            self.values[v] = value;
        }
        self.timers = self.between_calls.timers(state).collect();
    }

    /// The phase of each timer in a state.
    pub(crate) fn phases<'s>(&'s self, state: &'s State) -> impl Iterator<Item = Phase> + 's {
        self.between_calls.timers(state)
    }

    fn react(&mut self, is_initial: bool, path: &mut Path) -> Result<End, Beyond> {
        let program = self.program;
        self.passed.clear();
        self.run(&program.first, path)?;
        if is_initial {
            self.look_at_start(path)?;
        }
        self.run(&program.before, path)?;
        if self.claimed.assumptions.iter().any(|v| self.values[*v] != Value::Bool(true)) {
            return Ok(End::Barred);
        }
        match program.repeat {
            None => {
                self.micro_step(path)?;
                let cleared = self.cleared();
                self.passed.extend(cleared);
            }
            Some(repeat) => {
                // The states that micro-steps began in, with what they cleared.
                let mut seen: Vec<(State, Vec<TransitionId>)> = Vec::new();
                loop {
                    let head = self.between_micro_steps.pack(&self.values, &self.timers, 0);
                    if let Some(at) = seen.iter().position(|(state, _)| *state == head) {
                        return Ok(End::Livelock(ring(&seen[at..])));
                    }
                    self.micro_step(path)?;
                    let cleared = self.cleared();
                    self.passed.extend(&cleared);
                    seen.push((head, cleared));
                    if self.values[repeat.again] != Value::Bool(true) {
                        break;
                    }
                    if repeat.limit.is_some_and(|limit| seen.len() >= limit.bound as usize) {
                        return Ok(End::Livelock(ring(&seen)));
                    }
                }
            }
        }
        let after = std::mem::take(&mut self.claimed.after);
        let done = self.run_own(&after, path);
        self.claimed.after = after;
        done?;
        let situation = self.situation(path)?;
        let mut marks = 0;
        if self.facts.is_some() {
            self.keep_track(path);
            marks = self.marks();
        }
        Ok(End::Rest(self.between_calls.pack(&self.values, &self.timers, marks), situation))
    }

    /// One micro-step, looked at if that is wanted.
    fn micro_step(&mut self, path: &mut Path) -> Result<(), Beyond> {
        let Some(mut facts) = self.facts.take() else { return self.run(&self.program.micro_step, path) };
        let before = self.active(path);
        let done = before.and_then(|before| {
            self.run(&self.program.micro_step, path)?;
            let after = self.active(path)?;
            facts.micro_step(&before, &self.cleared(), &after);
            Ok(())
        });
        self.look_at_flags(&mut facts);
        self.facts = Some(facts);
        done
    }

    /// The situation before the first micro-step, and what was done there.
    fn look_at_start(&mut self, path: &mut Path) -> Result<(), Beyond> {
        let Some(mut facts) = self.facts.take() else { return Ok(()) };
        let active = self.active(path).map(|active| facts.situation(&active));
        self.look_at_flags(&mut facts);
        self.facts = Some(facts);
        active
    }

    fn look_at_flags(&self, facts: &mut Facts) {
        for (flag, fact) in facts.flags() {
            if self.values[flag] == Value::Bool(true) {
                facts.note(fact);
            }
        }
    }

    fn active(&mut self, path: &mut Path) -> Result<Active, Beyond> {
        self.program.steps.iter().map(|step| self.truth(step.active, path)).collect()
    }

    /// What of claims is true in the state reached: what is asserted or wanted is seen, the rest becomes a part of the state.
    fn marks(&mut self) -> u64 {
        let holds = |v: &VarId| self.values[*v] == Value::Bool(true);
        let Claimed { assertions, wanted, finals, leads, .. } = &self.claimed;
        let broken = assertions.iter().enumerate().filter(|(_, v)| !holds(v)).map(|(place, _)| Fact::Broken(place));
        let met = wanted.iter().enumerate().filter(|(_, v)| holds(v)).map(|(place, _)| Fact::Wanted(place));
        for fact in broken.chain(met).collect::<Vec<_>>() {
            self.facts.iter_mut().for_each(|facts| facts.note(fact));
        }
        let mut marks = u64::from(finals.iter().any(holds));
        for (place, (from, to)) in leads.iter().enumerate().take(MOST_LEADS) {
            marks |= u64::from(holds(from)) << (1 + 2 * place) | u64::from(holds(to)) << (2 + 2 * place);
        }
        marks
    }

    /// What of claims is true in a state.
    pub(crate) fn marks_of(&self, state: &State) -> Marks {
        Marks(self.between_calls.marks(state))
    }

    /// What is known of timers that run after a reaction: of those that it did not ask for, no more than before.
    fn keep_track(&mut self, path: &Path) {
        for (t, phase) in self.timers.iter_mut_enumerated() {
            let next = self.clocks.times[t].get(phase.passed);
            let runs_on =
                next.filter(|_| phase.on && !phase.fresh).map(|time| Atom::Ends(self.clocks.operand[t], *time));
            phase.vague = runs_on.is_some_and(|atom| path.known(atom, Type::Time) != Some(false));
        }
    }

    /// The transitions that the last micro-step cleared, in order of declaration.
    fn cleared(&self) -> Vec<TransitionId> {
        let seen = self.program.observing.iter().flat_map(|observing| &observing.transitions);
        seen.filter(|seen| self.values[seen.cleared] == Value::Bool(true)).map(|seen| seen.transition).collect()
    }

    fn situation(&mut self, path: &mut Path) -> Result<Vec<usize>, Beyond> {
        let active = self.active(path)?;
        Ok((0..active.len()).filter(|s| active[*s]).collect())
    }

    fn run(&mut self, statements: &'p [Statement], path: &mut Path) -> Result<(), Beyond> {
        self.run_own(statements, path)
    }

    /// Statements nest no deeper than lowering nests them, whatever the chart.
    fn run_own(&mut self, statements: &[Statement], path: &mut Path) -> Result<(), Beyond> {
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => self.values[*target] = self.value(*value, path)?,
                Statement::Divide(Division { target, modulo, dividend, divisor, .. }) => {
                    let (a, b) = (self.value(*dividend, path)?, self.value(*divisor, path)?);
                    let ty = self.program.variables[*target].ty;
                    self.values[*target] = divide(ty, *modulo, a, b).unwrap_or_else(|| zero(ty));
                }
                Statement::CallTimer { timer, input, .. } => {
                    let input = self.truth(*input, path)?;
                    let phase = &mut self.timers[*timer];
                    *phase = match (phase.on, input) {
                        (true, true) => *phase,
                        (false, true) => Phase { on: true, fresh: true, passed: 0, vague: false },
                        (_, false) => Phase::default(),
                    };
                }
                Statement::Case { of, arms } => {
                    let at = self.values[*of];
                    if let Some(arm) = arms.iter().find(|arm| Value::Int(arm.value) == at) {
                        self.run_own(&arm.body, path)?;
                    }
                }
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    let mut taken = otherwise.as_slice();
                    for (when, body) in branches {
                        if self.truth(*when, path)? {
                            taken = body;
                            break;
                        }
                    }
                    self.run_own(taken, path)?;
                }
            }
        }
        Ok(())
    }

    fn truth(&mut self, formula: FormulaId, path: &mut Path) -> Result<bool, Beyond> {
        Ok(self.value(formula, path)? == Value::Bool(true))
    }

    /// The value of a formula; asks for what it needs.
    fn value(&mut self, formula: FormulaId, path: &mut Path) -> Result<Value, Beyond> {
        loop {
            match self.seen(formula, path) {
                Seen::Value(value) => return Ok(value),
                Seen::Open(atom) => {
                    let answer = path.ask(atom);
                    if let Atom::Ends(operand, time) = atom {
                        self.pass(operand, time, answer);
                    }
                }
                Seen::Given(v) | Seen::Beyond(v) => {
                    return Err(Beyond::Input(self.program.variables[v].name.to_string()));
                }
                Seen::Elapsed(t) => return Err(Beyond::Duration(self.program.timers[t].name.clone())),
            }
        }
    }

    /// A time has passed, for all timers that measure the operand.
    fn pass(&mut self, operand: usize, time: i64, passed: bool) {
        for (t, phase) in self.timers.iter_mut_enumerated() {
            if passed && self.clocks.operand[t] == operand && phase.on && !phase.fresh {
                let so_many = self.clocks.times[t].iter().take_while(|other| **other <= time).count();
                phase.passed = phase.passed.max(so_many);
            }
        }
    }

    fn seen(&mut self, root: FormulaId, path: &Path) -> Seen {
        self.mark += 1;
        self.stack.push((root, false));
        while let Some((id, ready)) = self.stack.pop() {
            if self.memo[id.index()].0 == self.mark {
                continue;
            }
            if ready {
                self.memo[id.index()] = (self.mark, self.apply(id, path));
            } else {
                self.stack.push((id, true));
                self.stack.extend(self.program.pool.operands(id).map(|o| (o, false)));
            }
        }
        self.memo[root.index()].1
    }

    /// What is known of a formula, from what is known of its operands.
    fn apply(&self, id: FormulaId, path: &Path) -> Seen {
        let pool = &self.program.pool;
        let known = |f: FormulaId| self.memo[f.index()].1;
        match *pool.get(id) {
            Formula::Constant(value) => Seen::Value(value),
            Formula::Variable(v) if self.program.variables[v].role == Role::Input => {
                if self.program.variables[v].ty == Type::Bool {
                    self.asked(Atom::Holds(v), Type::Bool, path)
                } else if self.by_bits.contains(&v) {
                    self.number(v, path)
                } else {
                    Seen::Given(v)
                }
            }
            Formula::Variable(v) => Seen::Value(self.values[v]),
            Formula::TimerDone(t) => match self.program.timers[t].preset {
                Some(preset) => self.has_run(t, preset.ms, path),
                None => Seen::Value(Value::Bool(false)),
            },
            Formula::TimerElapsed(t) => Seen::Elapsed(t),
            Formula::Not(a) => negated(known(a)),
            Formula::And(list) => junction(pool.list(list).iter().map(|f| known(*f)), false),
            Formula::Or(list) => junction(pool.list(list).iter().map(|f| known(*f)), true),
            Formula::Xor([a, b]) => both(known(a), known(b), |a, b| Value::Bool(a != b)),
            Formula::Compare(op, [a, b]) => match (known(a), known(b)) {
                (Seen::Given(v), Seen::Value(value)) => self.compared(v, op, value, path),
                (Seen::Value(value), Seen::Given(v)) => self.compared(v, op.mirrored(), value, path),
                (Seen::Elapsed(t), Seen::Value(value)) => self.elapsed(t, op, value, path),
                (Seen::Value(value), Seen::Elapsed(t)) => self.elapsed(t, op.mirrored(), value, path),
                (a, b) => both(a, b, |a, b| Value::Bool(compare(op, a, b))),
            },
            Formula::Arithmetic(op, [a, b]) => both(known(a), known(b), |a, b| arithmetic(op, pool.ty(id), a, b)),
            Formula::Negate(a) => both(known(a), known(a), |a, _| negate(pool.ty(id), a)),
            Formula::Widen(a) => match known(a) {
                // The value is the same, and bounds know the type that is given.
                Seen::Given(v) => Seen::Given(v),
                a => both(a, a, |a, _| match (a, pool.ty(id)) {
                    (Value::Int(n), Type::Real | Type::Lreal) => Value::Real(n as f64),
                    (value, _) => value,
                }),
            },
        }
    }

    fn asked(&self, atom: Atom, ty: Type, path: &Path) -> Seen {
        path.known(atom, ty).map_or(Seen::Open(atom), |answer| Seen::Value(Value::Bool(answer)))
    }

    /// A whole number that is given, bit by bit.
    fn number(&self, v: VarId, path: &Path) -> Seen {
        let ty = self.program.variables[v].ty;
        let mut word = 0;
        for bit in 0..pack::width(ty) {
            match self.asked(Atom::Bit(v, bit as usize), Type::Bool, path) {
                Seen::Value(value) => word |= u64::from(value == Value::Bool(true)) << bit,
                open => return open,
            }
        }
        Seen::Value(Bits::of_word(word).value(ty))
    }

    /// A comparison of what is given with a value.
    fn compared(&self, v: VarId, op: Comparison, value: Value, path: &Path) -> Seen {
        let ty = self.program.variables[v].ty;
        if matches!(value, Value::Real(x) if x.is_nan()) {
            return Seen::Value(Value::Bool(op == Comparison::NotEqual));
        }
        let Question { from, to, negated: is_negated } = Question::new(op, ty, value);
        let ask = |bound| self.asked(Atom::AtLeast(v, bound), ty, path);
        let parts = from.map(ask).into_iter().chain(to.map(|bound| negated(ask(bound))));
        let holds = junction(parts, false);
        if is_negated { negated(holds) } else { holds }
    }

    /// A comparison of the time that a timer has run.
    fn elapsed(&self, t: TimerId, op: Comparison, value: Value, path: &Path) -> Seen {
        let Value::Time(time) = value else { return Seen::Elapsed(t) };
        let (at, beyond) = (self.has_run(t, time, path), self.has_run(t, time.saturating_add(1), path));
        match op {
            Comparison::GreaterEqual => at,
            Comparison::Greater => beyond,
            Comparison::Less => negated(at),
            Comparison::LessEqual => negated(beyond),
            Comparison::Equal => junction([at, negated(beyond)].into_iter(), false),
            Comparison::NotEqual => junction([negated(at), beyond].into_iter(), true),
        }
    }

    /// Whether a timer has run for so long.
    fn has_run(&self, t: TimerId, time: i64, path: &Path) -> Seen {
        let phase = self.timers[t];
        let times = &self.clocks.times[t];
        let place = times.partition_point(|other| *other < time);
        if time <= 0 || phase.on && phase.passed > place {
            return Seen::Value(Value::Bool(true));
        }
        if !phase.on || phase.fresh {
            return Seen::Value(Value::Bool(false));
        }
        self.asked(Atom::Ends(self.clocks.operand[t], time), Type::Time, path)
    }
}

fn negated(a: Seen) -> Seen {
    match a {
        Seen::Value(value) => Seen::Value(Value::Bool(value != Value::Bool(true))),
        other => other,
    }
}

/// A conjunction, or a disjunction: one operand may decide it, whatever the others are.
fn junction(operands: impl Iterator<Item = Seen>, decides: bool) -> Seen {
    let mut open = None;
    for operand in operands {
        match operand {
            Seen::Value(value) if value == Value::Bool(decides) => return operand,
            Seen::Value(_) => {}
            other => open = open.or(Some(other)),
        }
    }
    open.unwrap_or(Seen::Value(Value::Bool(!decides)))
}

fn both(a: Seen, b: Seen, of: impl Fn(Value, Value) -> Value) -> Seen {
    match (a, b) {
        (Seen::Value(a), Seen::Value(b)) => Seen::Value(of(a, b)),
        (Seen::Given(v) | Seen::Beyond(v), _) | (_, Seen::Given(v) | Seen::Beyond(v)) => Seen::Beyond(v),
        (Seen::Elapsed(t), _) | (_, Seen::Elapsed(t)) => Seen::Elapsed(t),
        (Seen::Open(atom), _) | (_, Seen::Open(atom)) => Seen::Open(atom),
    }
}

/// The transitions cleared in a round, in order of declaration.
fn ring(round: &[(State, Vec<TransitionId>)]) -> Vec<TransitionId> {
    let mut cleared: Vec<TransitionId> = round.iter().flat_map(|(_, cleared)| cleared).copied().collect();
    cleared.sort_unstable();
    cleared.dedup();
    cleared
}

fn spelled(value: Value) -> String {
    match value {
        Value::Bool(b) => b.to_string(),
        Value::Int(n) => n.to_string(),
        Value::Time(n) => format!("{n}ms"),
        Value::Real(x) => format!("{x:?}"),
    }
}
