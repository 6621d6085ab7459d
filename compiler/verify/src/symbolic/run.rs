//! Statements, run once for all states: each variable is a function of what it was before.

use super::bits::{Bits, beyond};
use super::number;
use super::seen::Seen;
use super::sets::{Halt, Sets};
use crate::atom::{Atom, Question};
use crate::beyond::Beyond;
use crate::clocks::{Clocks, constant};
use biodivine_lib_bdd::Bdd;
use grafc_formula::{Comparison, Formula, FormulaId, TimerId, Type, Value, VarId};
use grafc_logic::scan::{Choice, Program, Role, Statement};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// The values of all variables, and the timers, as functions.
pub(crate) struct Run<'p> {
    program: &'p Program,
    bits: &'p Bits,
    clocks: &'p Clocks,
    pub(crate) values: IndexVec<VarId, Option<Seen>>,
    pub(crate) timers: IndexVec<TimerId, Running>,
}

/// A timer, as functions.
#[derive(Clone)]
pub(crate) struct Running {
    pub(crate) on: Bdd,
    pub(crate) passed: Vec<Bdd>,
}

impl<'p> Run<'p> {
    /// Before the first call.
    pub(crate) fn at_first(program: &'p Program, bits: &'p Bits, clocks: &'p Clocks) -> Run<'p> {
        let no = bits.all.mk_false();
        let timers = clocks.times.iter().map(|times| Running { on: no.clone(), passed: vec![no.clone(); times.len()] });
        let mut run = Run {
            program,
            bits,
            clocks,
            values: program.variables.iter().map(|v| number::of_value(&bits.all, v.ty, v.initial())).collect(),
            timers: timers.collect(),
        };
        if let Some(wanted) = program.observing.as_ref().and_then(|observing| observing.wanted) {
            run.values[wanted] = Some(Seen::Truth(bits.all.mk_true()));
        }
        run
    }

    /// In any state.
    pub(crate) fn anywhere(program: &'p Program, bits: &'p Bits, clocks: &'p Clocks) -> Run<'p> {
        let mut run = Run::at_first(program, bits, clocks);
        if let Some(started) = program.started {
            run.values[started] = Some(Seen::Truth(bits.all.mk_true()));
        }
        for (v, of) in &bits.of {
            let mut functions: Vec<Bdd> = of.iter().map(|bit| bits.all.mk_var(bit.now)).collect();
            let ty = program.variables[*v].ty;
            // What takes fewer bits than its type has no sign.
            if super::bits::width(ty).is_some_and(|width| of.len() < width) {
                functions.push(bits.all.mk_false());
                run.values[*v] = Some(Seen::Number(functions));
            } else {
                run.values[*v] = Some(number::of_bits(&bits.all, ty, functions));
            }
        }
        for (running, phases) in run.timers.iter_mut().zip(&bits.timers) {
            running.on = bits.all.mk_var(phases.on.now);
            running.passed = phases.passed.iter().map(|bit| bits.all.mk_var(bit.now)).collect();
        }
        run
    }

    /// Nothing.
    pub(crate) fn no(&self) -> Bdd {
        self.bits.all.mk_false()
    }

    /// Time has passed: of timers that run, more times may have.
    pub(crate) fn pass(&mut self, sets: &mut Sets) -> Result<(), Halt> {
        for (t, running) in self.timers.iter_mut_enumerated() {
            for (passed, time) in running.passed.iter_mut().zip(&self.clocks.times[t]) {
                let ends = self.bits.all.mk_var(self.bits.asked[&Atom::Ends(self.clocks.operand[t], *time)]);
                let either = sets.or(passed, &ends)?;
                *passed = sets.and(&running.on, &either)?;
            }
        }
        Ok(())
    }

    /// Statements nest no deeper than lowering nests them.
    pub(crate) fn statements(&mut self, statements: &[Statement], guard: &Bdd, sets: &mut Sets) -> Result<(), Halt> {
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    let value = self.value(*value, sets)?;
                    let ty = self.program.variables[*target].ty;
                    let value = number::stored(&self.bits.all, ty, value);
                    let before = self.values[*target].take();
                    let Some(value) = value else { continue };
                    self.values[*target] = Some(match before {
                        Some(before) if !guard.is_true() => {
                            number::choice(guard, value, before, sets)?.ok_or_else(|| beyond(self.program, *target))?
                        }
                        _ => value,
                    });
                }
                Statement::Divide(division) => return Err(beyond(self.program, division.target)),
                Statement::CallTimer { timer, input, .. } => {
                    let input = self.truth(*input, sets)?;
                    let running = &mut self.timers[*timer];
                    let goes_on = sets.and(&input, &running.on)?;
                    for passed in &mut running.passed {
                        let still = sets.and(&goes_on, passed)?;
                        *passed = sets.choice(guard, &still, passed)?;
                    }
                    running.on = sets.choice(guard, &input, &running.on)?;
                }
                Statement::Case { of, arms } => {
                    let mut guards = Vec::with_capacity(arms.len());
                    for arm in arms {
                        let at = self.values[*of].clone().ok_or_else(|| beyond(self.program, *of))?;
                        let Seen::Number(at) = at else { return Err(beyond(self.program, *of)) };
                        let value = number::whole(&self.bits.all, arm.value);
                        let is_it = number::compare(Comparison::Equal, &at, &value, sets)?;
                        guards.push(sets.and(guard, &is_it)?);
                    }
                    for (arm, guard) in arms.iter().zip(guards) {
                        self.statements(&arm.body, &guard, sets)?;
                    }
                }
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    let mut rest = guard.clone();
                    for (when, body) in branches {
                        let when = self.truth(*when, sets)?;
                        let taken = sets.and(&rest, &when)?;
                        if !taken.is_false() {
                            self.statements(body, &taken, sets)?;
                        }
                        rest = sets.minus(&rest, &when)?;
                    }
                    if !rest.is_false() {
                        self.statements(otherwise, &rest, sets)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// A formula that is a truth.
    pub(crate) fn truth(&self, formula: FormulaId, sets: &mut Sets) -> Result<Bdd, Halt> {
        match self.value(formula, sets)? {
            Seen::Truth(truth) => Ok(truth),
            Seen::Number(_) | Seen::Real(_) | Seen::Given(_) | Seen::Elapsed(_) => Ok(self.bits.all.mk_false()),
        }
    }

    fn value(&self, root: FormulaId, sets: &mut Sets) -> Result<Seen, Halt> {
        let mut known: FxHashMap<FormulaId, Seen> = FxHashMap::default();
        for id in self.program.pool.below(root) {
            let value = self.apply(id, &known, sets)?;
            known.insert(id, value);
        }
        Ok(known.remove(&root).unwrap_or(Seen::Truth(self.bits.all.mk_false())))
    }

    fn apply(&self, id: FormulaId, known: &FxHashMap<FormulaId, Seen>, sets: &mut Sets) -> Result<Seen, Halt> {
        let (pool, all) = (&self.program.pool, &self.bits.all);
        let truth = |f: FormulaId| match known.get(&f) {
            Some(Seen::Truth(truth)) => truth.clone(),
            _ => all.mk_false(),
        };
        let cannot = || Halt::Beyond(Beyond::Input(self.named(id)));
        Ok(match *pool.get(id) {
            Formula::Constant(value) => number::of_value(all, pool.ty(id), value).ok_or_else(cannot)?,
            Formula::Variable(v) if self.program.variables[v].role != Role::Input => {
                self.values[v].clone().ok_or_else(|| beyond(self.program, v))?
            }
            Formula::Variable(v) if self.program.variables[v].ty == Type::Bool => {
                Seen::Truth(all.mk_var(self.bits.asked[&Atom::Holds(v)]))
            }
            Formula::Variable(v) => self.given(v),
            Formula::TimerDone(t) => match self.program.timers[t].preset {
                Some(preset) => Seen::Truth(self.has_run(t, preset.ms, sets)?),
                None => Seen::Truth(all.mk_false()),
            },
            Formula::TimerElapsed(t) => Seen::Elapsed(t),
            Formula::Not(a) => Seen::Truth(truth(a).not()),
            Formula::And(list) => {
                let mut out = all.mk_true();
                for f in pool.list(list) {
                    out = sets.and(&out, &truth(*f))?;
                }
                Seen::Truth(out)
            }
            Formula::Or(list) => {
                let mut out = all.mk_false();
                for f in pool.list(list) {
                    out = sets.or(&out, &truth(*f))?;
                }
                Seen::Truth(out)
            }
            Formula::Xor([a, b]) => Seen::Truth(sets.xor(&truth(a), &truth(b))?),
            Formula::Compare(op, [a, b]) => Seen::Truth(match (&known[&a], &known[&b]) {
                (Seen::Given(v), _) => self.compared(*v, op, constant(self.program, b).ok_or_else(cannot)?, sets)?,
                (_, Seen::Given(v)) => {
                    self.compared(*v, op.mirrored(), constant(self.program, a).ok_or_else(cannot)?, sets)?
                }
                (Seen::Elapsed(t), _) => self.elapsed(*t, op, constant(self.program, b), sets)?.ok_or_else(cannot)?,
                (_, Seen::Elapsed(t)) => {
                    self.elapsed(*t, op.mirrored(), constant(self.program, a), sets)?.ok_or_else(cannot)?
                }
                (Seen::Number(a), Seen::Number(b)) => number::compare(op, a, b, sets)?,
                (Seen::Truth(a), Seen::Truth(b)) => number::compare_truths(op, a, b, sets)?.ok_or_else(cannot)?,
                _ => return Err(cannot()),
            }),
            Formula::Arithmetic(op, [a, b]) => {
                let (Seen::Number(a), Seen::Number(b)) = (&known[&a], &known[&b]) else { return Err(cannot()) };
                number::arithmetic(all, pool.ty(id), op, a, b, sets)?.ok_or_else(cannot)?
            }
            Formula::Negate(a) => {
                let Seen::Number(a) = &known[&a] else { return Err(cannot()) };
                number::negate(all, pool.ty(id), a, sets)?
            }
            Formula::Widen(a) => match &known[&a] {
                Seen::Number(_) if matches!(pool.ty(id), Type::Real | Type::Lreal) => return Err(cannot()),
                same => same.clone(),
            },
        })
    }

    /// An input that is a number: its bits, if they are asked for.
    fn given(&self, v: VarId) -> Seen {
        let ty = self.program.variables[v].ty;
        let bits = (0..super::bits::width(ty).unwrap_or_default()).map(|bit| self.bits.asked.get(&Atom::Bit(v, bit)));
        let bits: Option<Vec<Bdd>> = bits.map(|bit| bit.map(|bit| self.bits.all.mk_var(*bit))).collect();
        match bits {
            Some(bits) if !bits.is_empty() => number::of_bits(&self.bits.all, ty, bits),
            Some(_) | None => Seen::Given(v),
        }
    }

    /// A variable that stands in a formula.
    fn named(&self, id: FormulaId) -> String {
        let below = self.program.pool.below(id);
        let named = below.iter().find_map(|id| {
            let Formula::Variable(v) = self.program.pool.get(*id) else { return None };
            Some(self.program.variables[*v].name.to_string())
        });
        named.unwrap_or_default()
    }

    fn has_run(&self, t: TimerId, time: i64, sets: &mut Sets) -> Result<Bdd, Halt> {
        let place = self.clocks.times[t].partition_point(|other| *other < time);
        match self.timers[t].passed.get(place) {
            _ if time <= 0 => Ok(self.bits.all.mk_true()),
            Some(passed) => sets.and(&self.timers[t].on, passed),
            None => Ok(self.bits.all.mk_false()),
        }
    }

    fn compared(&self, v: VarId, op: Comparison, value: Value, sets: &mut Sets) -> Result<Bdd, Halt> {
        let all = &self.bits.all;
        let ty = self.program.variables[v].ty;
        let Question { from, to, negated } = Question::new(op, ty, value);
        let ask = |bound| match (Atom::AtLeast(v, bound), crate::atom::Bound::trivial(bound, ty)) {
            (_, Some(known)) => {
                if known {
                    all.mk_true()
                } else {
                    all.mk_false()
                }
            }
            (atom, None) => all.mk_var(self.bits.asked[&atom]),
        };
        let mut holds = all.mk_true();
        for part in from.map(ask).into_iter().chain(to.map(|bound| ask(bound).not())) {
            holds = sets.and(&holds, &part)?;
        }
        Ok(if negated { holds.not() } else { holds })
    }

    fn elapsed(&self, t: TimerId, op: Comparison, value: Option<Value>, sets: &mut Sets) -> Result<Option<Bdd>, Halt> {
        let Some(Value::Time(time)) = value else { return Ok(None) };
        let (at, beyond) = (self.has_run(t, time, sets)?, self.has_run(t, time.saturating_add(1), sets)?);
        Ok(Some(match op {
            Comparison::GreaterEqual => at,
            Comparison::Greater => beyond,
            Comparison::Less => at.not(),
            Comparison::LessEqual => beyond.not(),
            Comparison::Equal => sets.minus(&at, &beyond)?,
            Comparison::NotEqual => sets.minus(&at, &beyond)?.not(),
        }))
    }
}
