//! One path through one reaction: the scan program as it stands, with inputs and time as they are asked for.

use crate::atom::{Atom, Path, Question};
use crate::beyond::Beyond;
use crate::clocks::{Clocks, Phase};
use crate::live::Live;
use grafc_formula::number::{arithmetic, compare, divide, negate, zero};
use grafc_formula::{Comparison, Formula, FormulaId, TimerId, Type, Value, VarId};
use grafc_logic::scan::{Division, Program, Role, Statement, TransitionId};
use index_vec::IndexVec;

/// What is left after a reaction, as numbers that can be compared.
pub(crate) type State = Box<[u64]>;

/// How a path ended.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum End {
    /// In a state, with this situation.
    Rest(State, Vec<usize>),
    /// It would go on without end, by these transitions (R9).
    Livelock(Vec<TransitionId>),
}

/// What happened in a reaction.
pub(crate) struct Way<'m> {
    /// The transitions that were cleared, in order of time; one may be there several times.
    pub(crate) cleared: &'m [TransitionId],
    /// The timers after it.
    pub(crate) timers: &'m IndexVec<TimerId, Phase>,
}

/// Runs a program.
pub(crate) struct Machine<'p> {
    program: &'p Program,
    clocks: Clocks,
    live: Live,
    values: IndexVec<VarId, Value>,
    timers: IndexVec<TimerId, Phase>,
    memo: Vec<(u64, Seen)>,
    mark: u64,
    stack: Vec<(FormulaId, bool)>,
    /// The transitions that the latest reaction has cleared so far.
    passed: Vec<TransitionId>,
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
        Ok(Machine {
            program,
            clocks: Clocks::new(program)?,
            live: Live::new(program),
            values: IndexVec::new(),
            timers: IndexVec::new(),
            memo: vec![(0, Seen::Value(Value::Bool(false))); program.pool.len()],
            mark: 0,
            stack: Vec::new(),
            passed: Vec::new(),
        })
    }

    /// Walks all paths of a reaction from a state, or of the initial reaction, as long as they are wanted.
    pub(crate) fn reactions(
        &mut self,
        from: Option<&State>,
        mut visit: impl FnMut(End, &[(Atom, bool)]) -> bool,
    ) -> Result<(), Beyond> {
        self.reactions_seen(from, |end, answers, _| visit(end, answers))
    }

    /// The same, with what happened on the way.
    pub(crate) fn reactions_seen(
        &mut self,
        from: Option<&State>,
        mut visit: impl FnMut(End, &[(Atom, bool)], Way) -> bool,
    ) -> Result<(), Beyond> {
        let mut path = Path::default();
        loop {
            path.rewind();
            self.load(from);
            let end = self.react(&mut path)?;
            let way = Way { cleared: &self.passed, timers: &self.timers };
            if !visit(end, path.answers(), way) || !path.advance() {
                return Ok(());
            }
        }
    }

    /// The timers of the program, and what they measure.
    pub(crate) fn clocks(&self) -> &Clocks {
        &self.clocks
    }

    /// The names and values of what makes a state beside the situation.
    pub(crate) fn told(&self, state: &State) -> Vec<(String, String)> {
        let variables = self.live.between_calls.iter().zip(state.iter());
        let shown = variables.filter(|(v, _)| match self.program.variables[**v].role {
            Role::Output | Role::Internal | Role::Memory => Some(**v) != self.program.started,
            Role::Input
            | Role::Constant
            | Role::Step
            | Role::State
            | Role::Flag(_)
            | Role::Temporary
            | Role::Observed => false,
        });
        let mut told: Vec<(String, String)> = shown
            .map(|(v, bits)| {
                let variable = &self.program.variables[*v];
                (variable.name.to_string(), spelled(decoded(variable.ty, *bits)))
            })
            .collect();
        for (timer, bits) in self.program.timers.iter().zip(&state[self.live.between_calls.len()..]) {
            if *bits > 0 {
                let phase = if *bits == 1 { "runs".to_string() } else { format!("ended {}", bits - 1) };
                told.push((timer.name.clone(), phase));
            }
        }
        told
    }

    fn load(&mut self, from: Option<&State>) {
        self.values = self.program.variables.iter().map(|v| v.initial).collect();
        self.timers = self.program.timers.iter().map(|_| Phase::default()).collect();
        if let Some(wanted) = self.program.observing.as_ref().and_then(|observing| observing.wanted) {
            self.values[wanted] = Value::Bool(true);
        }
        let Some(state) = from else { return };
        // No initial reaction is due.
        if let Some(started) = self.program.started {
            self.values[started] = Value::Bool(true);
        }
        let (variables, timers) = state.split_at(self.live.between_calls.len());
        for (v, bits) in self.live.between_calls.iter().zip(variables) {
            self.values[*v] = decoded(self.program.variables[*v].ty, *bits);
        }
        for (phase, bits) in self.timers.iter_mut().zip(timers) {
            *phase = Phase { on: *bits > 0, fresh: false, passed: bits.saturating_sub(1) as usize };
        }
    }

    fn state(&self, variables: &[VarId]) -> State {
        let values = variables.iter().map(|v| encoded(self.values[*v]));
        let timers = self.timers.iter().map(|phase| if phase.on { 1 + phase.passed as u64 } else { 0 });
        values.chain(timers).collect()
    }

    fn react(&mut self, path: &mut Path) -> Result<End, Beyond> {
        let program = self.program;
        self.passed.clear();
        self.run(&program.first, path)?;
        self.run(&program.before, path)?;
        match program.repeat {
            None => {
                self.run(&program.micro_step, path)?;
                let cleared = self.cleared();
                self.passed.extend(cleared);
            }
            Some(repeat) => {
                // The states that micro-steps began in, with what they cleared.
                let mut seen: Vec<(State, Vec<TransitionId>)> = Vec::new();
                loop {
                    let head = self.state(&self.live.between_micro_steps);
                    if let Some(at) = seen.iter().position(|(state, _)| *state == head) {
                        return Ok(End::Livelock(ring(&seen[at..])));
                    }
                    self.run(&program.micro_step, path)?;
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
        let situation = self.situation(path)?;
        Ok(End::Rest(self.state(&self.live.between_calls), situation))
    }

    /// The transitions that the last micro-step cleared, in order of declaration.
    fn cleared(&self) -> Vec<TransitionId> {
        let seen = self.program.observing.iter().flat_map(|observing| &observing.transitions);
        seen.filter(|seen| self.values[seen.cleared] == Value::Bool(true)).map(|seen| seen.transition).collect()
    }

    fn situation(&mut self, path: &mut Path) -> Result<Vec<usize>, Beyond> {
        let program = self.program;
        let mut active = Vec::new();
        for (s, step) in program.steps.iter_enumerated() {
            if self.truth(step.active, path)? {
                active.push(s.index());
            }
        }
        Ok(active)
    }

    /// Statements nest no deeper than lowering nests them, whatever the chart.
    fn run(&mut self, statements: &'p [Statement], path: &mut Path) -> Result<(), Beyond> {
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
                        (false, true) => Phase { on: true, fresh: true, passed: 0 },
                        (_, false) => Phase::default(),
                    };
                }
                Statement::Case { of, arms } => {
                    let at = self.values[*of];
                    if let Some(arm) = arms.iter().find(|arm| Value::Int(arm.value) == at) {
                        self.run(&arm.body, path)?;
                    }
                }
                Statement::If { branches, otherwise } => {
                    let mut taken = otherwise;
                    for (when, body) in branches {
                        if self.truth(*when, path)? {
                            taken = body;
                            break;
                        }
                    }
                    self.run(taken, path)?;
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
            Formula::Xor(a, b) => both(known(a), known(b), |a, b| Value::Bool(a != b)),
            Formula::Compare(op, a, b) => match (known(a), known(b)) {
                (Seen::Given(v), Seen::Value(value)) => self.compared(v, op, value, path),
                (Seen::Value(value), Seen::Given(v)) => self.compared(v, op.mirrored(), value, path),
                (Seen::Elapsed(t), Seen::Value(value)) => self.elapsed(t, op, value, path),
                (Seen::Value(value), Seen::Elapsed(t)) => self.elapsed(t, op.mirrored(), value, path),
                (a, b) => both(a, b, |a, b| Value::Bool(compare(op, a, b))),
            },
            Formula::Arithmetic(op, a, b) => both(known(a), known(b), |a, b| arithmetic(op, pool.ty(id), a, b)),
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

fn encoded(value: Value) -> u64 {
    match value {
        Value::Bool(b) => b.into(),
        Value::Int(n) | Value::Time(n) => n as u64,
        Value::Real(x) => x.to_bits(),
    }
}

fn decoded(ty: Type, bits: u64) -> Value {
    match ty {
        Type::Bool => Value::Bool(bits != 0),
        Type::Int | Type::Dint | Type::Uint | Type::Udint => Value::Int(bits as i64),
        Type::Time => Value::Time(bits as i64),
        Type::Real | Type::Lreal => Value::Real(f64::from_bits(bits)),
    }
}

fn spelled(value: Value) -> String {
    match value {
        Value::Bool(b) => b.to_string(),
        Value::Int(n) => n.to_string(),
        Value::Time(n) => format!("{n}ms"),
        Value::Real(x) => format!("{x:?}"),
    }
}
