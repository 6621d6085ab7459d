//! What stands under conditions, as rungs behind a contact.
//!
//! ```text
//! IF a THEN x := TRUE; y := FALSE     ──┤a├──┬──(S x)
//!                                            └──(R y)
//! IF a THEN n := 1                    ──┤/a├──┤b├──( part_1 )
//! ELSIF b THEN n := 2                 ──┤a├──[ EN MOVE ]── n
//!                                     ──┤part_1├──[ EN MOVE ]── n
//! ```
//!
//! A rung is done in each call, so what is chosen is found before anything is done that may change a condition.

use super::circuit::{Factor, Ladder};
use super::rung::{Coil, Contact, End, Storage};
use crate::iec::literals::literal;
use grafc_formula::{Comparison, Formula, FormulaId, TimerId, Value};
use grafc_logic::scan::{Arm, Choice, Program, Statement, VarId, is_empty};
use rustc_hash::FxHashSet;

/// So many contacts of branches that were not taken stand in a row.
const MOST_EXCLUDED: usize = 4;

impl Ladder<'_> {
    /// All values are compared before anything is done.
    pub fn case(&mut self, of: VarId, arms: &[Arm], guard: Option<&Contact>) {
        let (name, ty) = (self.name(of), self.program.variables[of].ty);
        let mut chosen = Vec::with_capacity(arms.len());
        for arm in arms {
            self.comment(&self.program.remark(arm.origin, arm.told).unwrap_or_default());
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
            self.comment(&self.program.remark(arm.origin, arm.told).unwrap_or_default());
            self.block(&arm.body, Some(&contact));
        }
    }

    /// Which branch is taken is found before anything is done.
    pub fn branch(
        &mut self,
        branches: &[(FormulaId, Vec<Statement>)],
        otherwise: &[Statement],
        guard: Option<&Contact>,
    ) {
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
    /// condition again for each coil, so what is in it can only be written by the last.
    fn constants(&self, condition: FormulaId, body: &[Statement]) -> Option<Vec<Coil>> {
        let (mut coils, mut last) = (Vec::new(), None);
        let mut targets = FxHashSet::default();
        for statement in body {
            match statement {
                Statement::Assign { target, value, .. } => {
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
                Statement::Divide(_) | Statement::CallTimer { .. } | Statement::Case { .. } | Statement::If(_) => {
                    return None;
                }
            }
        }
        coils.extend(last);
        Some(coils)
    }

    /// What a body says of itself stands above its condition.
    fn announce(&mut self, body: &[Statement]) {
        if let Some(Statement::Assign { origin, told, .. }) = body.first()
            && let Some(text) = self.program.remark(*origin, *told)
        {
            self.comment(&text);
        }
    }
}

/// The timers that are called under conditions.
pub(super) fn enabled(program: &Program) -> FxHashSet<TimerId> {
    let mut written = Written::default();
    for statement in program.sections().into_iter().flatten() {
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
                Statement::Divide(division) => self.variables.extend([division.target, division.flag]),
                Statement::Case { of: _, arms } => arms.iter().for_each(|arm| self.add(&arm.body)),
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
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
