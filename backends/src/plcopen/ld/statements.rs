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
use super::rung::{BlockCall, Coil, Contact, End, Item, Sink, Storage};
use crate::comment::clean;
use crate::iec::names::remark;
use ecow::EcoString;
use grafc_formula::{Formula, FormulaId, Type};
use grafc_logic::scan::{Role, Statement, TimerId, Told, VarId};
use rustc_hash::FxHashSet;

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
                Statement::Heading(heading) => self.comment(&self.program.heading(*heading)),
                Statement::Assign { target, value, origin, told } => {
                    // A step's comment stands beside its coil.
                    let remark = self.program.remark(*origin, *told).filter(|_| *told != Told::Comment);
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
                Statement::Divide(division) => self.divide(division, guard),
                Statement::CallTimer { timer, input, .. } => self.call_timer(*timer, *input, guard),
                Statement::Case { of, arms } => self.case(*of, arms, guard),
                Statement::If(choice) => self.branch(&choice.branches, &choice.otherwise, guard),
            }
        }
    }

    pub fn name(&self, id: VarId) -> EcoString {
        self.names.variables[id].clone()
    }

    /// Says something above the next rung, unless it was just said.
    pub fn comment(&mut self, text: &str) {
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
        // Its variable may be in it, or be it: so it is known before either is written.
        let contact = self.contact(value, false);
        let contact = if contact.name == name { self.aside(vec![Item::Contact(contact)]) } else { contact };
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
            return Some((pool.list(*list), true));
        }
        if let Formula::And(list) = pool.get(id) { Some((pool.list(*list), false)) } else { None }
    }

    /// Whether a formula reads a variable.
    pub fn reads(&self, id: FormulaId, variable: VarId) -> bool {
        self.has(id, |formula| *formula == Formula::Variable(variable))
    }

    /// Whether there is a formula of some kind in another.
    pub fn has(&self, id: FormulaId, wanted: impl Fn(&Formula) -> bool) -> bool {
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

    /// `EN` keeps its value like any input: a timer that has it in one call has it in all.
    fn call_timer(&mut self, timer: TimerId, input: FormulaId, guard: Option<&Contact>) {
        let name = self.names.timers[timer].clone();
        let output = self.timer_outputs[timer].clone();
        let timer_of = &self.program.timers[timer];
        let preset = self.names.preset(timer_of.given_preset());
        let end = match timer_of.preset {
            None => [("Q", Sink::Rail), ("ET", Sink::Variable(output))],
            Some(_) => [("Q", Sink::Coil(output)), ("ET", Sink::Open)],
        };
        let block = |power, inputs, outputs| {
            End::Block(BlockCall { kind: "TON", instance: Some(name.clone()), power, inputs, outputs })
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
}
