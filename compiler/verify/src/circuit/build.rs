//! The statements of a call, symbolically: what a statement writes it writes where it is reached.

use super::graph::{Graph, Literal};
use super::numbers::{Bits, constant, widened, width};
use crate::clocks::{self, Clocks};
use crate::live::Live;
use grafc_formula::{Comparison, Formula, FormulaId, TimerId, Type, Value, VarId};
use grafc_logic::scan::{Choice, ClaimKind, Division, Flag, Program, Role, SeenBody, Statement};
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;
use std::fmt;

/// A program as a circuit.
#[derive(Clone, Debug)]
pub struct Circuit {
    /// The chart's name.
    pub name: String,
    /// What all literals are of. What is given to it are inputs and latches, in the order in which they are listed there.
    pub graph: Graph,
    /// What is taken at each clock.
    pub inputs: Vec<Given>,
    /// What is kept from clock to clock.
    pub latches: Vec<Latch>,
    /// Whether the chart rests after a clock.
    pub rests: Literal,
    /// Whether each step is active after a clock, in order of declaration.
    pub situation: Vec<Literal>,
    /// The outputs where the chart rests, and elsewhere what they were: their bits, in order of declaration.
    pub outputs: Vec<Bits>,
    /// What holds of the inputs of each call.
    pub assumed: Literal,
    /// What must never hold.
    pub bad: Vec<Bad>,
}

/// An input.
#[derive(Clone, Debug)]
pub struct Given {
    /// What it is called.
    pub name: String,
    /// It.
    pub literal: Literal,
}

/// What is kept.
#[derive(Clone, Debug)]
pub struct Latch {
    /// What it is called.
    pub name: String,
    /// What it holds at first.
    pub initial: bool,
    /// What it holds.
    pub now: Literal,
    /// What it holds after a clock.
    pub next: Literal,
}

/// What must never hold.
#[derive(Clone, Debug)]
pub struct Bad {
    /// What is claimed.
    pub name: String,
    /// Whether it is broken after a clock.
    pub literal: Literal,
}

/// What has no circuit.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Beyond {
    /// A real number counts.
    Real(String),
    /// The duration of a step is used otherwise than in a comparison with a constant.
    Duration(String),
}

impl fmt::Display for Beyond {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Beyond::Real(name) => write!(f, "`{name}` is a real number, and a circuit has whole numbers alone"),
            Beyond::Duration(name) => write!(f, "the duration `{name}` is not only compared with constants"),
        }
    }
}

/// What a variable holds.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Held {
    Bool(Literal),
    Number(Bits),
    /// A real: it may be there as long as nothing asks for it.
    Unknown,
}

/// A timer: whether it runs, and which of its times have passed.
#[derive(Clone, Debug)]
struct Phase {
    on: Literal,
    passed: Vec<Literal>,
}

/// The circuit of a program that shows its claims.
///
/// # Errors
/// What has no circuit.
pub fn circuit(program: &Program) -> Result<Circuit, Beyond> {
    let mut builder = Builder::new(program)?;
    let begins = builder.begin()?;
    builder.run(&program.first, begins)?;
    builder.run(&program.before, begins)?;
    builder.run(&program.micro_step, Literal::TRUE)?;
    let (again, situation) = (builder.again(), builder.situation()?);
    builder.run(&program.after, !again)?;
    Ok(builder.end(begins, again, situation))
}

/// A latch whose next value is not known yet.
pub(super) struct Kept {
    name: String,
    initial: bool,
    pub(super) now: Literal,
    pub(super) of: Of,
}

/// What a latch is of.
#[derive(Clone, Copy)]
pub(super) enum Of {
    /// Whether the chart rests.
    Rest,
    /// Whether there was a clock before.
    Begun,
    /// A bit of a variable.
    Variable(VarId, usize),
    /// Whether a timer runs.
    Timer(TimerId),
    /// Whether a time of a timer has passed.
    Passed(TimerId, usize),
}

/// Makes a circuit, section by section of a call.
pub(super) struct Builder<'p> {
    pub(super) program: &'p Program,
    pub(super) clocks: Clocks,
    pub(super) graph: Graph,
    inputs: Vec<Given>,
    pub(super) kept: Vec<Kept>,
    names: FxHashSet<String>,
    pub(super) values: IndexVec<VarId, Held>,
    timers: IndexVec<TimerId, Phase>,
    /// What is given for an input.
    pub(super) given: Vec<(VarId, Held)>,
    /// Whether what measures an operand has run for so long, at the begin of a call.
    pub(super) ends: BTreeMap<(usize, i64), Literal>,
}

impl<'p> Builder<'p> {
    pub(super) fn new(program: &'p Program) -> Result<Self, Beyond> {
        let clocks = Clocks::new(program).map_err(|beyond| match beyond {
            crate::Beyond::Input(name) | crate::Beyond::Duration(name) | crate::Beyond::Real(name) => {
                Beyond::Duration(name)
            }
        })?;
        Ok(Builder {
            program,
            clocks,
            graph: Graph::default(),
            inputs: Vec::new(),
            kept: Vec::new(),
            names: FxHashSet::default(),
            values: IndexVec::new(),
            timers: IndexVec::new(),
            given: Vec::new(),
            ends: BTreeMap::new(),
        })
    }

    /// What stands before a clock, with the inputs and the time of a call where one begins.
    pub(super) fn begin(&mut self) -> Result<Literal, Beyond> {
        let program = self.program;
        let begins = self.latch("rests".to_string(), true, Of::Rest);
        self.values = program.variables.iter().map(|v| self.initial(v.ty, v.initial())).collect();
        for v in self.variables_kept() {
            self.values[v] = self.held_by_latches(v);
        }
        for t in program.timers.indices() {
            let phase = self.phase(t);
            self.timers.push(phase);
        }
        for (v, variable) in program.of_role(Role::Input) {
            if let Held::Bool(_) | Held::Number(_) = self.values[v] {
                let taken = self.taken(variable.name.as_str(), variable.ty);
                self.given.push((v, taken.clone()));
                self.keep(v, taken, begins)?;
            }
        }
        self.time_goes_on(begins);
        Ok(begins)
    }

    /// Whether another micro-step is needed.
    pub(super) fn again(&self) -> Literal {
        self.program.repeat.map_or(Literal::FALSE, |repeat| self.bool_of(repeat.again))
    }

    /// Whether each step is active.
    pub(super) fn situation(&mut self) -> Result<Vec<Literal>, Beyond> {
        self.program.steps.iter().map(|step| self.truth(step.active)).collect()
    }

    /// After all sections.
    pub(super) fn end(&mut self, begins: Literal, again: Literal, situation: Vec<Literal>) -> Circuit {
        let program = self.program;
        let outputs = program.of_role(Role::Output).map(|(v, _)| match &self.values[v] {
            Held::Bool(literal) => vec![*literal],
            Held::Number(bits) => bits.clone(),
            Held::Unknown => Vec::new(),
        });
        let outputs = outputs.collect();
        let (assumed, bad) = self.claims(begins, again);
        let kept = std::mem::take(&mut self.kept);
        let latches = kept.into_iter().map(|kept| {
            let next = match kept.of {
                Of::Rest => !again,
                Of::Begun => Literal::TRUE,
                Of::Variable(v, bit) => self.bit(v, bit),
                Of::Timer(t) => self.timers[t].on,
                Of::Passed(t, place) => self.timers[t].passed[place],
            };
            Latch { name: kept.name, initial: kept.initial, now: kept.now, next }
        });
        let latches = latches.collect();
        Circuit {
            name: program.name.clone(),
            latches,
            graph: std::mem::take(&mut self.graph),
            inputs: std::mem::take(&mut self.inputs),
            rests: !again,
            situation,
            outputs,
            assumed,
            bad,
        }
    }

    /// What is assumed of each call, and what is broken after a clock: assertions where the chart rests, and conflicts.
    fn claims(&mut self, begins: Literal, again: Literal) -> (Literal, Vec<Bad>) {
        let program = self.program;
        let (mut assumed, mut bad) = (Literal::TRUE, Vec::new());
        for claim in &program.claims {
            let SeenBody::Condition(holds) = claim.body else { continue };
            let holds = self.bool_of(holds);
            match claim.kind {
                ClaimKind::Assume => {
                    let kept = self.graph.or(!begins, holds);
                    assumed = self.graph.and(assumed, kept);
                }
                ClaimKind::Assert => {
                    let literal = self.graph.and(!again, !holds);
                    bad.push(Bad { name: claim.name.to_string(), literal });
                }
                ClaimKind::Reach | ClaimKind::Final => {}
            }
        }
        for flag in [Flag::AllocConflict, Flag::ForceConflict] {
            for (v, _) in program.of_role(Role::Flag(flag)) {
                bad.push(Bad { name: flag.name().to_string(), literal: self.bool_of(v) });
            }
        }
        (assumed, bad)
    }

    /// The variables that a later clock may read, and inputs, which are held while the chart does not rest.
    fn variables_kept(&self) -> Vec<VarId> {
        let program = self.program;
        let live = Live::new(program, &program.after);
        let mut is_kept: IndexVec<VarId, bool> = program
            .variables
            .iter()
            .map(|v| match v.role {
                Role::Input | Role::Output | Role::Flag(_) => true,
                Role::Internal
                | Role::Constant
                | Role::Step
                | Role::State
                | Role::Memory
                | Role::Temporary
                | Role::Observed => false,
            })
            .collect();
        for v in live.between_calls.iter().chain(&live.between_micro_steps) {
            is_kept[*v] = true;
        }
        is_kept.into_iter_enumerated().filter(|(_, kept)| *kept).map(|(v, _)| v).collect()
    }

    /// A name that nothing else has: tools refuse it twice.
    fn named(&mut self, mut name: String) -> String {
        while !self.names.insert(name.clone()) {
            name.push('\'');
        }
        name
    }

    pub(super) fn latch(&mut self, name: String, initial: bool, of: Of) -> Literal {
        let name = self.named(name);
        let now = self.graph.given();
        self.kept.push(Kept { name, initial, now, of });
        now
    }

    fn initial(&self, ty: Type, value: Value) -> Held {
        match value {
            Value::Bool(value) => Held::Bool(Literal::of(value)),
            Value::Int(n) | Value::Time(n) => Held::Number(constant(ty, n)),
            Value::Real(_) => Held::Unknown,
        }
    }

    fn held_by_latches(&mut self, v: VarId) -> Held {
        let variable = &self.program.variables[v];
        // An input of this name is what is given at a clock.
        let held = if variable.role == Role::Input { " held" } else { "" };
        let name = format!("{}{held}", variable.name);
        match variable.initial() {
            Value::Bool(initial) => Held::Bool(self.latch(name, initial, Of::Variable(v, 0))),
            Value::Int(n) | Value::Time(n) => {
                let bits = 0..width(variable.ty).unwrap_or_default();
                let latch = |bit| self.latch(format!("{name}[{bit}]"), n >> bit & 1 == 1, Of::Variable(v, bit));
                Held::Number(bits.map(latch).collect())
            }
            Value::Real(_) => Held::Unknown,
        }
    }

    fn phase(&mut self, t: TimerId) -> Phase {
        let name = &self.program.timers[t].name;
        let on = self.latch(format!("{name} runs"), false, Of::Timer(t));
        let times = self.clocks.times[t].clone();
        let passed = times.iter().enumerate();
        let passed =
            passed.map(|(place, ms)| self.latch(format!("{name} after {ms}ms"), false, Of::Passed(t, place))).collect();
        Phase { on, passed }
    }

    /// What is given for an input at a clock.
    fn taken(&mut self, name: &str, ty: Type) -> Held {
        match width(ty) {
            None => Held::Bool(self.input(name.to_string())),
            Some(width) => Held::Number((0..width).map(|bit| self.input(format!("{name}[{bit}]"))).collect()),
        }
    }

    fn input(&mut self, name: String) -> Literal {
        let name = self.named(name);
        let literal = self.graph.given();
        self.inputs.push(Given { name, literal });
        literal
    }

    /// Delays that run end or do not: of the times of one operand, with each all shorter ones.
    fn time_goes_on(&mut self, begins: Literal) {
        let mut times: FxHashMap<usize, Vec<i64>> = FxHashMap::default();
        for (t, operand) in self.clocks.operand.iter_enumerated() {
            times.entry(*operand).or_default().extend(&self.clocks.times[t]);
        }
        let mut operands: Vec<(usize, Vec<i64>)> = times.into_iter().collect();
        operands.sort_unstable();
        for (operand, mut times) in operands {
            times.sort_unstable();
            times.dedup();
            let mut longer = Literal::FALSE;
            for ms in times.into_iter().rev() {
                let ends_now = self.input(format!("delay {operand} ends after {ms}ms"));
                longer = self.graph.or(longer, ends_now);
                self.ends.insert((operand, ms), longer);
            }
        }
        for t in self.program.timers.indices() {
            let operand = self.clocks.operand[t];
            for place in 0..self.clocks.times[t].len() {
                let ends = self.ends[&(operand, self.clocks.times[t][place])];
                let phase = &self.timers[t];
                let now = self.graph.all([begins, phase.on, ends]);
                self.timers[t].passed[place] = self.graph.or(self.timers[t].passed[place], now);
            }
        }
    }

    pub(super) fn bool_of(&self, v: VarId) -> Literal {
        match &self.values[v] {
            Held::Bool(literal) => *literal,
            Held::Number(_) | Held::Unknown => unreachable!("{} is Boolean", self.program.variables[v].name),
        }
    }

    fn bit(&self, v: VarId, bit: usize) -> Literal {
        match &self.values[v] {
            Held::Bool(literal) => *literal,
            Held::Number(bits) => bits[bit],
            Held::Unknown => unreachable!("what is unknown has no latch"),
        }
    }

    /// Stores where a statement is reached.
    fn keep(&mut self, v: VarId, value: Held, reached: Literal) -> Result<(), Beyond> {
        let graph = &mut self.graph;
        self.values[v] = match (&self.values[v], value) {
            (Held::Bool(old), Held::Bool(new)) => Held::Bool(graph.choose(reached, new, *old)),
            (Held::Number(old), Held::Number(new)) => Held::Number(graph.choose_bits(reached, &new, old)),
            (Held::Unknown, _) => Held::Unknown,
            // What is no real is unknown only where it is made of the duration of a step.
            (Held::Bool(_) | Held::Number(_), Held::Unknown) => {
                return Err(Beyond::Duration(self.program.variables[v].name.to_string()));
            }
            (Held::Bool(_), Held::Number(_)) | (Held::Number(_), Held::Bool(_)) => {
                unreachable!("{} keeps its type", self.program.variables[v].name)
            }
        };
        Ok(())
    }

    /// Statements nest no deeper than lowering nests them, whatever the chart.
    pub(super) fn run(&mut self, statements: &[Statement], reached: Literal) -> Result<(), Beyond> {
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    let value = self.value(*value)?;
                    self.keep(*target, value, reached)?;
                }
                Statement::Divide(division) => self.divide(division, reached)?,
                Statement::CallTimer { timer, input, .. } => {
                    let input = self.truth(*input)?;
                    let Phase { on, passed } = self.timers[*timer].clone();
                    let graph = &mut self.graph;
                    // One that begins in this call has no time behind it, and one that does not run has none.
                    let goes_on = graph.and(on, input);
                    let passed = passed.iter().map(|passed| {
                        let now = graph.and(goes_on, *passed);
                        graph.choose(reached, now, *passed)
                    });
                    let passed = passed.collect();
                    self.timers[*timer] = Phase { on: self.graph.choose(reached, input, on), passed };
                }
                Statement::Case { of, arms } => {
                    let ty = self.program.variables[*of].ty;
                    let Held::Number(at) = self.values[*of].clone() else { unreachable!("arms are of whole numbers") };
                    for arm in arms {
                        let number = constant(ty, arm.value);
                        let here = self.graph.compare(Comparison::Equal, ty, &at, &number);
                        let here = self.graph.and(reached, here);
                        if here != Literal::FALSE {
                            self.run(&arm.body, here)?;
                        }
                    }
                }
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    let mut left = reached;
                    for (when, body) in branches {
                        let when = self.truth(*when)?;
                        let taken = self.graph.and(left, when);
                        if taken != Literal::FALSE {
                            self.run(body, taken)?;
                        }
                        left = self.graph.and(left, !when);
                    }
                    if left != Literal::FALSE {
                        self.run(otherwise, left)?;
                    }
                }
            }
        }
        Ok(())
    }

    fn divide(&mut self, division: &Division, reached: Literal) -> Result<(), Beyond> {
        let Division { target, modulo, dividend, divisor, flag, .. } = *division;
        let ty = self.program.variables[target].ty;
        let (a, b) = (self.value(dividend)?, self.value(divisor)?);
        let (Held::Number(a), Held::Number(b)) = (a, b) else {
            return Err(self.real(target));
        };
        use grafc_formula::Arithmetic::{Divide, Modulo};
        let quotient = self.graph.arithmetic(if modulo { Modulo } else { Divide }, ty, &a, &b);
        let (by_zero, zero) = (self.graph.is_zero(&b), constant(ty, 0));
        let quotient = self.graph.choose_bits(by_zero, &zero, &quotient);
        self.keep(target, Held::Number(quotient), reached)?;
        let raised = self.graph.and(reached, by_zero);
        self.keep(flag, Held::Bool(Literal::TRUE), raised)
    }

    fn real(&self, v: VarId) -> Beyond {
        Beyond::Real(self.program.variables[v].name.to_string())
    }

    fn truth(&mut self, formula: FormulaId) -> Result<Literal, Beyond> {
        match self.value(formula)? {
            Held::Bool(literal) => Ok(literal),
            Held::Number(_) => unreachable!("a condition is Boolean"),
            Held::Unknown => Err(Beyond::Real(self.program.name.clone())),
        }
    }

    /// The value of a formula, each shared part once.
    fn value(&mut self, root: FormulaId) -> Result<Held, Beyond> {
        let mut known: FxHashMap<FormulaId, Held> = FxHashMap::default();
        for id in self.program.pool.below(root) {
            let held = self.apply(id, &known)?;
            known.insert(id, held);
        }
        Ok(known.remove(&root).unwrap_or(Held::Unknown))
    }

    fn apply(&mut self, id: FormulaId, known: &FxHashMap<FormulaId, Held>) -> Result<Held, Beyond> {
        let pool = &self.program.pool;
        let ty = pool.ty(id);
        let truth = |f: &FormulaId| match &known[f] {
            Held::Bool(literal) => *literal,
            Held::Number(_) | Held::Unknown => unreachable!("an operand is Boolean"),
        };
        let bits = |f: &FormulaId| match &known[f] {
            Held::Number(bits) => Some(bits),
            Held::Bool(_) | Held::Unknown => None,
        };
        Ok(match pool.get(id) {
            Formula::Constant(value) => self.initial(ty, *value),
            Formula::Variable(v) => self.values[*v].clone(),
            Formula::TimerDone(t) => Held::Bool(match self.program.timers[*t].preset {
                Some(preset) => self.has_run(*t, preset.ms),
                None => Literal::FALSE,
            }),
            // It is asked for where it is compared.
            Formula::TimerElapsed(_) => Held::Unknown,
            Formula::Not(a) => Held::Bool(!truth(a)),
            Formula::And(list) => Held::Bool(self.graph.all(pool.list(*list).iter().map(truth))),
            Formula::Or(list) => Held::Bool(self.graph.any(pool.list(*list).iter().map(truth))),
            Formula::Xor([a, b]) => Held::Bool(self.graph.xor(truth(a), truth(b))),
            Formula::Compare(op, [a, b]) => Held::Bool(match (bits(a), bits(b)) {
                (Some(left), Some(right)) => self.graph.compare(*op, pool.ty(*a), left, right),
                (None, _) | (_, None) => self.elapsed(*op, *a, *b)?,
            }),
            Formula::Arithmetic(op, [a, b]) => match (bits(a), bits(b)) {
                (Some(a), Some(b)) => Held::Number(self.graph.arithmetic(*op, ty, a, b)),
                (None, _) | (_, None) => Held::Unknown,
            },
            Formula::Negate(a) => match bits(a) {
                Some(a) => Held::Number(self.graph.negated(a)),
                None => Held::Unknown,
            },
            Formula::Widen(a) => match bits(a) {
                Some(bits) if width(ty).is_some() => Held::Number(widened(pool.ty(*a), bits, ty)),
                Some(_) | None => Held::Unknown,
            },
        })
    }

    /// A comparison of the time that a timer has run with a constant; anything else that is unknown is a real.
    fn elapsed(&mut self, op: Comparison, a: FormulaId, b: FormulaId) -> Result<Literal, Beyond> {
        let pool = &self.program.pool;
        let (timer, other, op) = match (pool.get(a), pool.get(b)) {
            (Formula::TimerElapsed(t), _) => (*t, b, op),
            (_, Formula::TimerElapsed(t)) => (*t, a, op.mirrored()),
            _ => return Err(Beyond::Real(self.program.name.clone())),
        };
        let Some(Value::Time(time)) = clocks::constant(self.program, other) else {
            return Err(Beyond::Duration(self.program.timers[timer].name.clone()));
        };
        let (at, beyond) = (self.has_run(timer, time), self.has_run(timer, time.saturating_add(1)));
        Ok(match op {
            Comparison::GreaterEqual => at,
            Comparison::Greater => beyond,
            Comparison::Less => !at,
            Comparison::LessEqual => !beyond,
            Comparison::Equal => self.graph.and(at, !beyond),
            Comparison::NotEqual => self.graph.or(!at, beyond),
        })
    }

    /// Whether a timer has run for so long.
    fn has_run(&mut self, t: TimerId, time: i64) -> Literal {
        if time <= 0 {
            return Literal::TRUE;
        }
        let place = self.clocks.times[t].partition_point(|other| *other < time);
        let Phase { on, passed } = &self.timers[t];
        let passed = passed.get(place).copied().unwrap_or(Literal::FALSE);
        let on = *on;
        self.graph.and(on, passed)
    }
}

/// A name without line ends: in the texts of circuits they end a symbol, or a comment.
pub(super) fn one_line(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
