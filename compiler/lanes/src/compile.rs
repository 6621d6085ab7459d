//! Statements to parts, formulas to operations.
//!
//! A formula that has been worked out keeps its value until one of its variables or timers is written. So each is worked out
//! once in a stretch without such a write; what a branch works out counts within it alone, because it may not be taken.

use crate::code::{At, Body, BoolAt, Branch, Operation, Part, RealAt, WholeAt};
use grafc_formula::{Formula, FormulaId, Pool, TimerId, Type, Value, VarId};
use grafc_logic::scan::{Choice, Division, Program, Statement};
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashMap;

/// A section of a program with room for what it works out.
pub(crate) struct Code {
    pub(crate) operations: Vec<Operation>,
    pub(crate) variables: IndexVec<VarId, At>,
    pub(crate) first: Body,
    pub(crate) before: Body,
    pub(crate) micro_step: Body,
    pub(crate) after: Body,
    /// What works out which steps are active.
    pub(crate) situation: Body,
    /// Whether each step is, in order of declaration.
    pub(crate) active: Vec<BoolAt>,
    pub(crate) room: Room,
}

/// How many places there are, and what the constants among them hold.
#[derive(Default)]
pub(crate) struct Room {
    pub(crate) bools: usize,
    pub(crate) wholes: usize,
    pub(crate) reals: usize,
    pub(crate) constants: Vec<(At, Value)>,
}

impl Room {
    fn place(&mut self, ty: Type) -> At {
        let next = |count: &mut usize| {
            *count += 1;
            *count - 1
        };
        match ty {
            Type::Bool => At::Bool(BoolAt::from_usize(next(&mut self.bools))),
            Type::Int | Type::Uint | Type::Dint | Type::Udint | Type::Time => {
                At::Whole(WholeAt::from_usize(next(&mut self.wholes)))
            }
            Type::Real | Type::Lreal => At::Real(RealAt::from_usize(next(&mut self.reals))),
        }
    }
}

/// The code of a program.
pub(crate) fn compile(program: &Program) -> Code {
    let mut room = Room::default();
    let variables = program.variables.iter().map(|variable| room.place(variable.ty)).collect();
    let mut compiler = Compiler {
        pool: &program.pool,
        variables,
        room,
        operations: Vec::new(),
        known: FxHashMap::default(),
        undo: Vec::new(),
        seen: FxHashMap::default(),
        // What has been written at moment 0 has been written before all else.
        variable_written: index_vec![0; program.variables.len()],
        timer_written: index_vec![0; program.timers.len()],
        moment: 0,
        stack: Vec::new(),
        types: program.variables.iter().map(|variable| variable.ty).collect(),
    };
    let [first, before, micro_step, after] =
        [&program.first, &program.before, &program.micro_step, &program.after].map(|s| compiler.section(s));
    compiler.begin_section();
    let begin = compiler.operations.len();
    let active = program.steps.iter().map(|step| compiler.truth(step.active)).collect();
    let situation = vec![Part::Operations(begin..compiler.operations.len())];
    let Compiler { variables, room, operations, .. } = compiler;
    Code { operations, variables, first, before, micro_step, after, situation, active, room }
}

struct Compiler<'p> {
    pool: &'p Pool,
    variables: IndexVec<VarId, At>,
    types: IndexVec<VarId, Type>,
    room: Room,
    operations: Vec<Operation>,
    /// Where the value of a formula lies, and the moment when it was worked out. Constants stay.
    known: FxHashMap<FormulaId, (At, u32)>,
    /// What was known of the formulas that were worked out since, for the end of what may be left out.
    undo: Vec<(FormulaId, Option<(At, u32)>)>,
    /// The moment when something that a formula reads was last written, and the moment when that was found out.
    seen: FxHashMap<FormulaId, (u32, u32)>,
    variable_written: IndexVec<VarId, u32>,
    timer_written: IndexVec<TimerId, u32>,
    /// Counts writes.
    moment: u32,
    stack: Vec<(FormulaId, bool)>,
}

impl Compiler<'_> {
    /// Nothing is known any more but constants: a section is run again and again.
    fn begin_section(&mut self) {
        let pool = self.pool;
        self.known.retain(|id, _| pool.as_constant(*id).is_some());
        self.undo.clear();
    }

    fn section(&mut self, statements: &[Statement]) -> Body {
        self.begin_section();
        self.body(statements)
    }

    fn body(&mut self, statements: &[Statement]) -> Body {
        let mut body = Body::new();
        let mut begin = self.operations.len();
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    let value = self.value(*value);
                    let keep = match (self.variables[*target], value) {
                        (At::Bool(to), At::Bool(from)) => Operation::KeepBool(to, from),
                        (At::Whole(to), At::Whole(from)) => Operation::KeepWhole(to, from),
                        (At::Real(to), At::Real(from)) => Operation::KeepReal(to, from),
                        (to, from) => unreachable!("an assignment to another type: {to:?} := {from:?}"),
                    };
                    self.operations.push(keep);
                    self.written(*target);
                }
                Statement::Divide(Division { target, modulo, dividend, divisor, flag, .. }) => {
                    let (a, b) = (self.value(*dividend), self.value(*divisor));
                    let ty = self.types[*target];
                    let raised = self.variables[*flag].bool();
                    self.operations.push(match (self.variables[*target], a, b) {
                        (At::Whole(to), At::Whole(a), At::Whole(b)) => {
                            Operation::DivideWholes(to, *modulo, ty, (a, b), raised)
                        }
                        (At::Real(to), At::Real(a), At::Real(b)) => {
                            Operation::DivideReals(to, *modulo, ty, (a, b), raised)
                        }
                        other => unreachable!("a division of other types: {other:?}"),
                    });
                    self.written(*target);
                    self.written(*flag);
                }
                Statement::CallTimer { timer, input, .. } => {
                    let input = self.truth(*input);
                    self.operations.push(Operation::CallTimer(*timer, input));
                    self.moment += 1;
                    self.timer_written[*timer] = self.moment;
                }
                Statement::Case { of, arms } => {
                    let At::Whole(of) = self.variables[*of] else { unreachable!("arms are of whole numbers") };
                    self.end(&mut body, begin);
                    let mut bodies: Vec<(i64, Body)> =
                        arms.iter().map(|arm| (arm.value, self.within(&arm.body))).collect();
                    bodies.sort_unstable_by_key(|(value, _)| *value);
                    body.push(Part::Case { of, bodies });
                    begin = self.operations.len();
                }
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    self.end(&mut body, begin);
                    let outside = self.undo.len();
                    let mut made = Vec::with_capacity(branches.len());
                    for (when, then) in branches {
                        // What a condition needs is worked out where the branches before it are not taken by all.
                        let begin = self.operations.len();
                        let when = self.truth(*when);
                        let operations = begin..self.operations.len();
                        let body = self.within(then);
                        made.push(Branch { operations, when, body });
                    }
                    let otherwise = self.within(otherwise);
                    self.forget(outside);
                    body.push(Part::If { branches: made, otherwise });
                    begin = self.operations.len();
                }
            }
        }
        self.end(&mut body, begin);
        body
    }

    fn end(&self, body: &mut Body, begin: usize) {
        if begin < self.operations.len() {
            body.push(Part::Operations(begin..self.operations.len()));
        }
    }

    /// A body that may be left out: what it works out is not known behind it.
    fn within(&mut self, statements: &[Statement]) -> Body {
        let outside = self.undo.len();
        let body = self.body(statements);
        self.forget(outside);
        body
    }

    /// What was worked out since is not known any more.
    fn forget(&mut self, outside: usize) {
        for (id, before) in self.undo.drain(outside..).rev() {
            match before {
                Some(before) => _ = self.known.insert(id, before),
                None => _ = self.known.remove(&id),
            }
        }
    }

    fn written(&mut self, variable: VarId) {
        self.moment += 1;
        self.variable_written[variable] = self.moment;
    }

    fn truth(&mut self, formula: FormulaId) -> BoolAt {
        self.value(formula).bool()
    }

    /// Where the value of a formula lies, once the operations so far are done.
    fn value(&mut self, root: FormulaId) -> At {
        self.stack.push((root, false));
        while let Some((id, ready)) = self.stack.pop() {
            if self.seen.get(&id).is_some_and(|(_, when)| *when == self.moment) && self.is_known(id) {
                continue;
            }
            if !ready {
                self.stack.push((id, true));
                self.stack.extend(self.pool.operands(id).map(|operand| (operand, false)));
                continue;
            }
            let written = match self.pool.get(id) {
                Formula::Constant(_) => 0,
                Formula::Variable(v) => self.variable_written[*v],
                Formula::TimerDone(t) | Formula::TimerElapsed(t) => self.timer_written[*t],
                Formula::Not(_)
                | Formula::And(_)
                | Formula::Or(_)
                | Formula::Xor(..)
                | Formula::Compare(..)
                | Formula::Arithmetic(..)
                | Formula::Negate(_)
                | Formula::Widen(_) => self.pool.operands(id).map(|operand| self.seen[&operand].0).max().unwrap_or(0),
            };
            self.seen.insert(id, (written, self.moment));
            if !self.is_known(id) {
                let at = self.work_out(id);
                let before = self.known.insert(id, (at, self.moment));
                if self.pool.as_constant(id).is_none() {
                    self.undo.push((id, before));
                }
            }
        }
        self.known[&root].0
    }

    /// Whether what was worked out is still so.
    fn is_known(&self, id: FormulaId) -> bool {
        let written = self.seen.get(&id).map_or(0, |(written, _)| *written);
        self.known.get(&id).is_some_and(|(_, when)| *when >= written)
    }

    fn work_out(&mut self, id: FormulaId) -> At {
        let (pool, ty) = (self.pool, self.pool.ty(id));
        match *pool.get(id) {
            Formula::Constant(value) => {
                let at = self.room.place(ty);
                self.room.constants.push((at, value));
                at
            }
            Formula::Variable(v) => self.variables[v],
            Formula::TimerDone(t) => self.bools(|to| Operation::TimerDone(to, t)),
            Formula::TimerElapsed(t) => {
                let At::Whole(to) = self.room.place(Type::Time) else { unreachable!("times are whole numbers") };
                self.operations.push(Operation::TimerElapsed(to, t));
                At::Whole(to)
            }
            Formula::Not(a) => {
                let a = self.known[&a].0.bool();
                self.bools(|to| Operation::Not(to, a))
            }
            Formula::And(list) => self.chain(pool.list(list), Operation::And),
            Formula::Or(list) => self.chain(pool.list(list), Operation::Or),
            Formula::Xor([a, b]) => {
                let (a, b) = (self.known[&a].0.bool(), self.known[&b].0.bool());
                self.bools(|to| Operation::Xor(to, a, b))
            }
            Formula::Compare(op, [a, b]) => match (self.known[&a].0, self.known[&b].0) {
                (At::Whole(a), At::Whole(b)) => self.bools(|to| Operation::CompareWholes(to, op, a, b)),
                (At::Real(a), At::Real(b)) => self.bools(|to| Operation::CompareReals(to, op, a, b)),
                other => unreachable!("a comparison of other types: {other:?}"),
            },
            Formula::Arithmetic(op, [a, b]) => {
                let to = self.room.place(ty);
                self.operations.push(match (to, self.known[&a].0, self.known[&b].0) {
                    (At::Whole(to), At::Whole(a), At::Whole(b)) => Operation::Wholes(to, op, ty, a, b),
                    (At::Real(to), At::Real(a), At::Real(b)) => Operation::Reals(to, op, ty, a, b),
                    other => unreachable!("arithmetic of other types: {other:?}"),
                });
                to
            }
            Formula::Negate(a) => {
                let to = self.room.place(ty);
                self.operations.push(match (to, self.known[&a].0) {
                    (At::Whole(to), At::Whole(a)) => Operation::NegateWholes(to, ty, a),
                    (At::Real(to), At::Real(a)) => Operation::NegateReals(to, ty, a),
                    other => unreachable!("a negation of another type: {other:?}"),
                });
                to
            }
            Formula::Widen(a) => match (self.known[&a].0, ty) {
                (At::Whole(a), Type::Real | Type::Lreal) => {
                    let At::Real(to) = self.room.place(ty) else { unreachable!("a real is one") };
                    self.operations.push(Operation::Widen(to, a));
                    At::Real(to)
                }
                // The same value, of a wider type.
                (at, _) => at,
            },
        }
    }

    fn bools(&mut self, operation: impl FnOnce(BoolAt) -> Operation) -> At {
        let to = BoolAt::from_usize(self.room.bools);
        self.room.bools += 1;
        self.operations.push(operation(to));
        At::Bool(to)
    }

    /// A conjunction or disjunction, two operands at a time.
    fn chain(&mut self, operands: &[FormulaId], join: impl Fn(BoolAt, BoolAt, BoolAt) -> Operation) -> At {
        let to = BoolAt::from_usize(self.room.bools);
        self.room.bools += 1;
        // There are two or more.
        let mut so_far = self.known[&operands[0]].0.bool();
        for operand in &operands[1..] {
            self.operations.push(join(to, so_far, self.known[operand].0.bool()));
            so_far = to;
        }
        At::Bool(to)
    }
}
