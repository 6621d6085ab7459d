//! Statements as rungs.
//!
//! ```text
//! X1 := clr_3 OR X1 AND NOT clr_1      ──┤clr_1├──(R X1)     ──┤clr_3├──(S X1)      activation wins
//! X1 := NOT X2 AND (clr_3 OR X1)       ──┤clr_3├──(S X1)     ──┤X2├─────(R X1)      deactivation wins
//! IF c THEN x := TRUE; n := n + 1      ──┤c├──(S x)          ──┤c├──[ EN MOVE ]── n
//! T1(IN := a, PT := T#2s)              ──┤a├──[ IN TON Q ]──( T1_Q )
//! ```
//!
//! A ladder has neither branches nor a loop: each rung is done in each call. What stands under a condition is done by
//! coils that only set or reset, and by functions with `EN`, behind a contact of the condition as it was before.

use super::circuit::{Factor, Ladder};
use super::rung::{Block, Coil, Contact, End, Item, Sink, Storage};
use crate::comment::clean;
use crate::iec::literals::{literal, operand, time, zero};
use crate::iec::names::remark;
use crate::limits::is_empty;
use grafc_logic::formula::{Arithmetic, Comparison, Formula, FormulaId, Type, Value};
use grafc_logic::scan::{Arm, Program, Role, Statement, TimerId, VarId};
use rustc_hash::FxHashSet;

/// What a timer without a preset is given: the longest time that all compilers take.
const FOR_EVER_MS: i64 = i32::MAX as i64;
/// So many contacts of branches that were not taken stand in a row.
const MOST_EXCLUDED: usize = 4;

/// Something negated or not.
type Literal = (FormulaId, bool);

/// How a value that has its variable in it is written: what sets, what resets, and which comes first.
struct Kept {
    set: Vec<Literal>,
    reset: Vec<Literal>,
    set_first: bool,
}

impl Ladder<'_> {
    /// Statements in order, behind a contact if one is given; nothing in them writes its variable.
    pub fn block(&mut self, statements: &[Statement], guard: Option<&Contact>) {
        // The rung that the next constant may share.
        let mut open = None;
        for statement in statements {
            self.known.clear();
            let shared = open.take().filter(|_| self.comments.is_empty());
            match statement {
                Statement::Heading(text) => self.comment(text),
                Statement::Assign { target, value, remark } => {
                    let constant = self.program.pool.as_truth(*value);
                    match (guard, constant, shared) {
                        (Some(_), Some(truth), Some(rung)) if remark.is_none() => {
                            self.join(rung, *target, truth);
                            open = shared;
                        }
                        (Some(guard), Some(truth), _) => {
                            self.remark(*target, remark.as_deref());
                            let storage = if truth { Storage::Set } else { Storage::Reset };
                            let items = self.items(vec![Factor::Contact(guard.clone())]);
                            self.coil(items, &self.name(*target), storage);
                            open = Some(self.rungs.len() - 1);
                        }
                        (_, _, _) => {
                            self.remark(*target, remark.as_deref());
                            self.assign(*target, *value, guard);
                        }
                    }
                }
                Statement::Divide { target, modulo, dividend, divisor, flag } => {
                    self.divide(*target, *modulo, [*dividend, *divisor], *flag, guard);
                }
                Statement::CallTimer { timer, input } => self.call_timer(*timer, *input, guard),
                Statement::Case { of, arms } => self.case(*of, arms, guard),
                Statement::If { branches, otherwise } => self.branch(branches, otherwise, guard),
            }
        }
    }

    pub fn name(&self, id: VarId) -> String {
        self.names.variables[id].clone()
    }

    /// Says something above the next rung, unless it was just said.
    fn comment(&mut self, text: &str) {
        let text = clean(text);
        if !text.is_empty() && text != self.said {
            self.said.clone_from(&text);
            self.comments.push(text);
        }
    }

    /// What stands above a rung: what the program says, otherwise what the chart says of a step.
    fn remark(&mut self, target: VarId, text: Option<&str>) {
        let variable = &self.program.variables[target];
        let own = || {
            let note = remark(&variable.name, &self.names.variables[target], variable.comment.as_deref())?;
            (variable.role == Role::Step).then(|| format!("{}: {note}", self.names.variables[target]))
        };
        if let Some(text) = text.map(str::to_owned).or_else(own) {
            self.comment(&text);
        }
    }

    /// Adds a coil to a rung.
    fn join(&mut self, rung: usize, target: VarId, truth: bool) {
        let coil = Coil { name: self.name(target), storage: if truth { Storage::Set } else { Storage::Reset } };
        if let End::Coils(coils) = &mut self.rungs[rung].end {
            coils.push(coil);
        }
    }

    fn assign(&mut self, target: VarId, value: FormulaId, guard: Option<&Contact>) {
        let pool = &self.program.pool;
        if pool.ty(value) != Type::Bool {
            return self.calculate(target, value, guard.cloned().into_iter().collect());
        }
        let name = self.name(target);
        let Some(guard) = guard else {
            if let Some(truth) = pool.as_truth(value) {
                return self.coil(Vec::new(), &name, if truth { Storage::Plain } else { Storage::Reset });
            }
            match self.kept(target, value) {
                Some(Kept { set, reset, set_first }) => {
                    let mut rungs = [(set, Storage::Set), (reset, Storage::Reset)];
                    if !set_first {
                        rungs.reverse();
                    }
                    for (when, storage) in rungs.into_iter().filter(|(when, _)| !when.is_empty()) {
                        let items = self.items(vec![Factor::AnyOf(when)]);
                        self.coil(items, &name, storage);
                    }
                }
                None => {
                    let items = self.items(vec![Factor::Formula(value, false)]);
                    self.coil(items, &name, Storage::Plain);
                }
            }
            return;
        };
        // Its variable may be in it: so it is known before either is written.
        let contact = self.contact(value, false);
        for (contact, storage) in [(contact.clone(), Storage::Set), (contact.inverse(), Storage::Reset)] {
            let items = self.items(vec![Factor::Contact(guard.clone()), Factor::Contact(contact)]);
            self.coil(items, &name, storage);
        }
    }

    /// How a value keeps its variable, if it does: `S OR x AND NOT R` or `NOT R AND (S OR x)`.
    fn kept(&self, target: VarId, value: FormulaId) -> Option<Kept> {
        let pool = &self.program.pool;
        let is_own = |id: &FormulaId| *pool.get(*id) == Formula::Variable(target);
        let (outer, sum) = self.junction(value)?;
        // The operand that keeps it: the variable alone, or with others in the other junction.
        let mut keeps = outer.iter().enumerate().filter(|(_, id)| self.reads(**id, target));
        let (Some((place, keeper)), None) = (keeps.next(), keeps.next()) else { return None };
        let inner = match self.junction(*keeper) {
            Some((list, inner_sum)) if inner_sum != sum => list,
            Some(_) | None => std::slice::from_ref(keeper),
        };
        let own = inner.iter().position(is_own)?;
        let others = |list: &[FormulaId], but: usize, negated: bool| -> Vec<Literal> {
            list.iter().enumerate().filter(|(at, _)| *at != but).map(|(_, id)| (*id, negated)).collect()
        };
        let inner_reads = inner.iter().enumerate().any(|(at, id)| at != own && self.reads(*id, target));
        if inner_reads {
            return None;
        }
        let (outer, inner) = (others(outer, place, !sum), others(inner, own, sum));
        let (set, reset) = if sum { (outer, inner) } else { (inner, outer) };
        Some(Kept { set, reset, set_first: !sum })
    }

    /// The operands of a junction, and whether it is a disjunction.
    fn junction(&self, id: FormulaId) -> Option<(&[FormulaId], bool)> {
        let pool = &self.program.pool;
        if let Formula::Or(list) = pool.get(id) {
            return Some((list, true));
        }
        if let Formula::And(list) = pool.get(id) { Some((list, false)) } else { None }
    }

    /// Whether a formula reads a variable.
    fn reads(&self, id: FormulaId, variable: VarId) -> bool {
        self.has(id, |formula| *formula == Formula::Variable(variable))
    }

    /// Whether there is a formula of some kind in another.
    fn has(&self, id: FormulaId, wanted: impl Fn(&Formula) -> bool) -> bool {
        let pool = &self.program.pool;
        let (mut due, mut seen) = (vec![id], FxHashSet::default());
        while let Some(id) = due.pop() {
            if wanted(pool.get(id)) {
                return true;
            }
            due.extend(pool.operands(id).filter(|operand| seen.insert(*operand)));
        }
        false
    }

    /// Stores what a formula of numbers gives, behind some contacts. An operator is a function, and its operands texts:
    /// a text with a literal of a time in its middle, `t + T#1s`, is a puzzle to Beremiz.
    fn calculate(&mut self, target: VarId, value: FormulaId, behind: Vec<Contact>) {
        let pool = &self.program.pool;
        let ty = pool.ty(value);
        let text = |id: &FormulaId| self.text(*id);
        let (kind, operands) = match pool.get(value) {
            // `TIME * n` is taken everywhere, `n * TIME` is not.
            Formula::Arithmetic(Arithmetic::Multiply, a, b) if pool.ty(*b) == Type::Time => ("MUL", [text(b), text(a)]),
            Formula::Arithmetic(op, a, b) => {
                let kind = match op {
                    Arithmetic::Add => "ADD",
                    Arithmetic::Subtract => "SUB",
                    Arithmetic::Multiply => "MUL",
                    Arithmetic::Divide => "DIV",
                    Arithmetic::Modulo => "MOD",
                };
                (kind, [text(a), text(b)])
            }
            // Negates a zero, too.
            Formula::Negate(a) if matches!(ty, Type::Real | Type::Lreal) => {
                ("MUL", [text(a), operand(Value::Real(-1.0), ty)])
            }
            Formula::Negate(a) => ("SUB", [zero(ty), text(a)]),
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Widen(_) => return self.move_to(target, text(&value), behind),
        };
        let [a, b] = operands;
        self.function(kind, vec![("IN1", a), ("IN2", b)], target, behind);
    }

    /// Stores a number behind some contacts.
    pub fn move_to(&mut self, target: VarId, text: String, behind: Vec<Contact>) {
        self.function("MOVE", vec![("IN", text)], target, behind);
    }

    /// Stores what a function makes of its inputs, behind some contacts.
    fn function(
        &mut self,
        kind: &'static str,
        inputs: Vec<(&'static str, String)>,
        target: VarId,
        behind: Vec<Contact>,
    ) {
        let items = self.items(behind.into_iter().map(Factor::Contact).collect());
        let outputs = vec![("ENO", Sink::Rail), ("OUT", Sink::Variable(self.name(target)))];
        self.rung(items, End::Block(Block { kind, instance: None, power: "EN", inputs, outputs }));
    }

    /// Division guarded against 0, and against the one quotient that a type cannot hold: its least value by -1.
    fn divide(&mut self, target: VarId, modulo: bool, [a, b]: [FormulaId; 2], flag: VarId, guard: Option<&Contact>) {
        let pool = &self.program.pool;
        let (ty, result) = (pool.ty(b), self.program.variables[target].ty);
        let behind =
            |more: &[&Contact]| -> Vec<Contact> { guard.into_iter().chain(more.iter().copied()).cloned().collect() };
        let [dividend, divisor] = [a, b].map(|id| self.text(id));
        if pool.as_constant(b).is_some() {
            // Other constants divide without a guard, inside a formula.
            self.move_to(target, zero(result), behind(&[]));
            let items = self.items(behind(&[]).into_iter().map(Factor::Contact).collect());
            return self.coil(items, &self.name(flag), Storage::Set);
        }
        let by_zero = self.comparison(Comparison::Equal, [divisor.clone(), zero(ty)]);
        let items = self.items(behind(&[&by_zero]).into_iter().map(Factor::Contact).collect());
        self.coil(items, &self.name(flag), Storage::Set);
        let least = Value::Int(i64::from(i32::MIN));
        let constant = pool.as_constant(a);
        let overflows = result == Type::Dint && ty == Type::Dint && constant.is_none_or(|a| a == least);
        let by_minus_one =
            overflows.then(|| self.comparison(Comparison::Equal, [divisor.clone(), literal(Value::Int(-1), ty)]));
        // Each of the quotients is stored behind contacts that exclude the others, and were found before.
        self.move_to(target, zero(result), behind(&[&by_zero]));
        let mut others = vec![by_zero.inverse()];
        if let Some(by_minus_one) = by_minus_one {
            let behind = behind(&[&by_minus_one]);
            match (modulo, constant) {
                (true, _) => self.move_to(target, zero(result), behind),
                // It is what overflows. MATIEC computes with constants and refuses the difference.
                (false, Some(_)) => self.move_to(target, dividend.clone(), behind),
                (false, None) => {
                    let operands = vec![("IN1", zero(result)), ("IN2", dividend.clone())];
                    self.function("SUB", operands, target, behind);
                }
            }
            others.push(by_minus_one.inverse());
        }
        let others: Vec<&Contact> = others.iter().collect();
        let kind = if modulo { "MOD" } else { "DIV" };
        self.function(kind, vec![("IN1", dividend), ("IN2", divisor)], target, behind(&others));
    }

    /// `EN` keeps its value like any input: a timer that has it in one call has it in all.
    fn call_timer(&mut self, timer: TimerId, input: FormulaId, guard: Option<&Contact>) {
        let name = self.names.timers[timer].clone();
        let output = self.timer_outputs[timer].clone();
        let (preset, end) = match self.program.timers[timer].preset {
            None => (time(FOR_EVER_MS), [("Q", Sink::Rail), ("ET", Sink::Variable(output))]),
            Some(preset) => {
                let text = preset.constant.map_or_else(|| time(preset.ms), |id| self.name(id));
                (text, [("Q", Sink::Coil(output)), ("ET", Sink::Open)])
            }
        };
        let block = |power, inputs, outputs| {
            End::Block(Block { kind: "TON", instance: Some(name.clone()), power, inputs, outputs })
        };
        if guard.is_none() && !self.enabled.contains(&timer) {
            let items = match self.program.pool.as_truth(input) {
                Some(false) => vec![Item::Contact(self.contact(input, false))],
                Some(true) | None => self.items(vec![Factor::Formula(input, false)]),
            };
            return self.rung(items, block("IN", vec![("PT", preset)], end.into()));
        }
        let input = self.contact(input, false);
        let input = if input.negated { self.aside(vec![Item::Contact(input)]) } else { input };
        let items = self.items(guard.cloned().map(Factor::Contact).into_iter().collect());
        let outputs = [vec![("ENO", Sink::Open)], end.into()].concat();
        self.rung(items, block("EN", vec![("IN", input.name), ("PT", preset)], outputs));
    }

    /// All values are compared before anything is done.
    fn case(&mut self, of: VarId, arms: &[Arm], guard: Option<&Contact>) {
        let (name, ty) = (self.name(of), self.program.variables[of].ty);
        let mut chosen = Vec::with_capacity(arms.len());
        for arm in arms {
            self.comment(arm.remark.as_deref().unwrap_or_default());
            let value = literal(Value::Int(arm.value), ty);
            let contact = self.comparison(Comparison::Equal, [name.clone(), value]);
            chosen.push(match guard {
                None => contact,
                Some(guard) => {
                    let items = self.items(vec![Factor::Contact(guard.clone()), Factor::Contact(contact)]);
                    self.aside(items)
                }
            });
        }
        for (arm, contact) in arms.iter().zip(chosen) {
            self.comment(arm.remark.as_deref().unwrap_or_default());
            self.block(&arm.body, Some(&contact));
        }
    }

    /// Which branch is taken is found before anything is done.
    fn branch(&mut self, branches: &[(FormulaId, Vec<Statement>)], otherwise: &[Statement], guard: Option<&Contact>) {
        let mut written = Written::default();
        branches.iter().for_each(|(_, body)| written.add(body));
        written.add(otherwise);
        if let [(condition, body)] = branches
            && is_empty(otherwise)
            && let Some(coils) = self.constants(*condition, body)
        {
            self.announce(body);
            let behind = guard.cloned().map(Factor::Contact);
            let items = self.items(behind.into_iter().chain([Factor::Formula(*condition, false)]).collect());
            return self.rung(items, End::Coils(coils));
        }
        let mut before: Vec<Contact> = guard.cloned().into_iter().collect();
        let mut chosen: Vec<(Contact, &[Statement])> = Vec::new();
        for (condition, body) in branches {
            self.announce(body);
            let contact = if before.is_empty() && !self.has(*condition, |formula| written.has(formula)) {
                self.contact(*condition, false)
            } else {
                let behind = before.iter().cloned().map(Factor::Contact);
                let items = self.items(behind.chain([Factor::Formula(*condition, false)]).collect());
                self.aside(items)
            };
            before.push(contact.inverse());
            if before.len() > MOST_EXCLUDED {
                let items = self.items(before.drain(..).map(Factor::Contact).collect());
                before.push(self.aside(items));
            }
            chosen.push((contact, body));
        }
        if !is_empty(otherwise) {
            let contact = match &before[..] {
                [contact] => contact.clone(),
                _ => {
                    let items = self.items(before.into_iter().map(Factor::Contact).collect());
                    self.aside(items)
                }
            };
            chosen.push((contact, otherwise));
        }
        for (contact, body) in chosen {
            self.block(body, Some(&contact));
        }
    }

    /// The coils of a body that only sets and resets, if they can share the rung of its condition: Beremiz looks at the
    /// condition anew for each coil, so what is in it can only be written by the last.
    fn constants(&self, condition: FormulaId, body: &[Statement]) -> Option<Vec<Coil>> {
        let (mut coils, mut last) = (Vec::new(), None);
        let mut targets = FxHashSet::default();
        for statement in body {
            match statement {
                Statement::Assign { target, value, remark: _ } => {
                    let storage = if self.program.pool.as_truth(*value)? { Storage::Set } else { Storage::Reset };
                    let coil = Coil { name: self.name(*target), storage };
                    if !targets.insert(*target) {
                        return None;
                    }
                    if !self.reads(condition, *target) {
                        coils.push(coil);
                    } else if last.replace(coil).is_some() {
                        return None;
                    }
                }
                Statement::Heading(_) => {}
                Statement::Divide { .. }
                | Statement::CallTimer { .. }
                | Statement::Case { .. }
                | Statement::If { .. } => return None,
            }
        }
        coils.extend(last);
        Some(coils)
    }

    /// What a body says of itself stands above its condition.
    fn announce(&mut self, body: &[Statement]) {
        if let Some(Statement::Assign { remark: Some(text), .. }) = body.first() {
            self.comment(text);
        }
    }
}

/// The timers that are called under conditions.
pub(super) fn enabled(program: &Program) -> FxHashSet<TimerId> {
    let mut written = Written::default();
    for statement in [&program.first, &program.before, &program.micro_step, &program.after].into_iter().flatten() {
        if !matches!(statement, Statement::CallTimer { .. }) {
            written.add(std::slice::from_ref(statement));
        }
    }
    written.timers
}

/// What statements write.
#[derive(Default)]
struct Written {
    variables: FxHashSet<VarId>,
    timers: FxHashSet<TimerId>,
}

impl Written {
    fn add(&mut self, statements: &[Statement]) {
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::CallTimer { timer, .. } => {
                    self.timers.insert(*timer);
                }
                Statement::Assign { target, .. } => {
                    self.variables.insert(*target);
                }
                Statement::Divide { target, flag, .. } => self.variables.extend([*target, *flag]),
                Statement::Case { of: _, arms } => arms.iter().for_each(|arm| self.add(&arm.body)),
                Statement::If { branches, otherwise } => {
                    branches.iter().for_each(|(_, body)| self.add(body));
                    self.add(otherwise);
                }
            }
        }
    }

    /// Whether a formula is directly of something that is written.
    fn has(&self, formula: &Formula) -> bool {
        match formula {
            Formula::Variable(variable) => self.variables.contains(variable),
            Formula::TimerDone(timer) | Formula::TimerElapsed(timer) => self.timers.contains(timer),
            Formula::Constant(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => false,
        }
    }
}
