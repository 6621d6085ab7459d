//! What is written twice in a block is computed once.
//!
//! ```text
//! p := (X1 OR X2 OR X3) AND a             any_X1_X2_X3 := X1 OR X2 OR X3
//! q := (X1 OR X2 OR X3) AND b   becomes   p := any_X1_X2_X3 AND a
//!                                         q := any_X1_X2_X3 AND b
//! ```
//!
//! as long as nothing in between writes what it reads. Statements within others are a block of their own: what is looked at
//! in one arm only is not computed for the others.

use super::cells::{Cell, each_written, read_by};
use super::words::formula_word;
use crate::scan::{Choice, Origin, Program, Role, Statement, VarId, Variable};
use grafc_formula::{Formula, FormulaId, Type};
use rustc_hash::FxHashMap;

/// A formula that reads fewer variables is not worth a name.
const WORTH_A_NAME: u32 = 3;

/// Computes once what is written twice, in all blocks of a program.
pub(crate) fn once(program: &mut Program) {
    let sections = [&mut program.first, &mut program.before, &mut program.micro_step, &mut program.after];
    let sections = sections.map(std::mem::take);
    let Some(wanted) = Wanted::find(program, &sections) else {
        [program.first, program.before, program.micro_step, program.after] = sections;
        return;
    };
    let mut once = Once { program, wanted };
    let [first, before, micro_step, after] = sections.map(|section| once.block(section));
    (program.first, program.before, program.micro_step, program.after) = (first, before, micro_step, after);
}

/// Which formulas of a pool may be written twice.
struct Wanted {
    /// Worth a name, and used more than once.
    is: Vec<bool>,
    /// Has such a formula in it, or is one.
    holds: Vec<bool>,
}

impl Wanted {
    /// None if there is none.
    fn find(program: &Program, sections: &[Vec<Statement>]) -> Option<Wanted> {
        let pool = &program.pool;
        let mut uses = vec![0_u8; pool.len()];
        let mut open = Vec::new();
        sections.iter().for_each(|section| roots_within(section, &mut open));
        while let Some(id) = open.pop() {
            let count = &mut uses[id.index()];
            *count = count.saturating_add(1);
            if *count == 1 {
                open.extend(pool.operands(id));
            }
        }
        let named = |id: FormulaId| match pool.get(id) {
            Formula::And(_) | Formula::Or(_) | Formula::Xor(..) => true,
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Not(_)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => false,
        };
        let again = |id: FormulaId| uses[id.index()] > 1 && named(id);
        if !pool.ids().any(again) {
            return None;
        }
        let mut weights: Vec<u32> = Vec::with_capacity(pool.len());
        for id in pool.ids() {
            let below = pool.operands(id).fold(0_u32, |sum, operand| sum.saturating_add(weights[operand.index()]));
            weights.push(match pool.get(id) {
                Formula::Constant(_) => 0,
                Formula::Variable(_) | Formula::TimerDone(_) | Formula::TimerElapsed(_) | Formula::Compare(..) => 1,
                Formula::Not(_)
                | Formula::And(_)
                | Formula::Or(_)
                | Formula::Xor(..)
                | Formula::Arithmetic(..)
                | Formula::Negate(_)
                | Formula::Widen(_) => below,
            });
        }
        let is: Vec<bool> = pool.ids().map(|id| again(id) && weights[id.index()] >= WORTH_A_NAME).collect();
        if !is.contains(&true) {
            return None;
        }
        let mut holds = is.clone();
        for id in pool.ids() {
            holds[id.index()] |= pool.operands(id).any(|operand| holds[operand.index()]);
        }
        Some(Wanted { is, holds })
    }

    fn is(&self, id: FormulaId) -> bool {
        self.is.get(id.index()).is_some_and(|is| *is)
    }

    fn holds(&self, id: FormulaId) -> bool {
        self.holds.get(id.index()).is_some_and(|holds| *holds)
    }
}

/// The formulas that statements hold, those of the statements within them as well. Statements nest no deeper than lowering
/// nests them.
fn roots_within(statements: &[Statement], out: &mut Vec<FormulaId>) {
    for statement in statements {
        roots(statement, out);
        statement.bodies().for_each(|body| roots_within(body, out));
    }
}

/// The formulas that a statement holds itself; operands of a division have no operators.
fn roots(statement: &Statement, out: &mut Vec<FormulaId>) {
    match statement {
        Statement::Heading(_) | Statement::Divide(_) | Statement::Case { .. } => {}
        Statement::Assign { value, .. } => out.push(*value),
        Statement::CallTimer { input, .. } => out.push(*input),
        Statement::If(choice) => out.extend(choice.branches.iter().map(|(when, _)| *when)),
    }
}

/// A formula over the statements between which it keeps its value.
struct Span {
    formula: FormulaId,
    /// The statements that hold it, one for each time.
    uses: Vec<usize>,
    /// A temporary of the program that has just this value, from the first of them on.
    carrier: Option<VarId>,
}

struct Once<'p> {
    program: &'p mut Program,
    wanted: Wanted,
}

impl Once<'_> {
    /// Statements nest no deeper than lowering nests them.
    fn block(&mut self, statements: Vec<Statement>) -> Vec<Statement> {
        let chosen = self.chosen(&statements);
        let mut of_statement: FxHashMap<usize, Vec<usize>> = FxHashMap::default();
        for (place, span) in chosen.iter().enumerate() {
            let mut last = None;
            for at in span.uses.iter().filter(|at| last.replace(**at) != Some(**at)) {
                of_statement.entry(*at).or_default().push(place);
            }
        }
        let mut carriers: Vec<Option<FormulaId>> = vec![None; chosen.len()];
        let mut out = Vec::with_capacity(statements.len() + chosen.len());
        for (at, mut statement) in statements.into_iter().enumerate() {
            let mut by: FxHashMap<FormulaId, FormulaId> = FxHashMap::default();
            let mut here = of_statement.remove(&at).unwrap_or_default();
            // Operands first.
            here.sort_unstable_by_key(|place| chosen[*place].formula);
            let mut carried = None;
            for place in here {
                let span = &chosen[place];
                let read = match (carriers[place], span.carrier) {
                    (Some(read), _) => read,
                    (None, Some(variable)) => {
                        carried = Some(span.formula);
                        let read = self.program.pool.variable(variable, Type::Bool);
                        carriers[place] = Some(read);
                        continue;
                    }
                    (None, None) => {
                        let value = self.program.pool.replace(span.formula, &by);
                        let (read, definition) =
                            self.define(value, crate::scan::origin_of(std::slice::from_ref(&statement)));
                        out.push(definition);
                        carriers[place] = Some(read);
                        read
                    }
                };
                by.insert(span.formula, read);
            }
            if !by.is_empty() {
                self.replace(&mut statement, &by);
            }
            debug_assert!(carried.is_none() || matches!(statement, Statement::Assign { .. }));
            out.push(self.inside(statement));
        }
        out
    }

    /// The formulas that are written more than once in a block, each as long as it keeps its value.
    fn chosen(&self, statements: &[Statement]) -> Vec<Span> {
        let pool = &self.program.pool;
        let mut spans: Vec<Span> = Vec::new();
        let mut known: FxHashMap<FormulaId, usize> = FxHashMap::default();
        let mut reads: FxHashMap<Cell, Vec<FormulaId>> = FxHashMap::default();
        for (at, statement) in statements.iter().enumerate() {
            let mut open = Vec::new();
            roots(statement, &mut open);
            while let Some(id) = open.pop() {
                if !self.wanted.holds(id) {
                    continue;
                }
                if self.wanted.is(id) {
                    if let Some(span) = known.get(&id) {
                        spans[*span].uses.push(at);
                        continue;
                    }
                    known.insert(id, spans.len());
                    let carrier = match statement {
                        Statement::Assign { target, value, .. }
                            if *value == id && self.program.variables[*target].role == Role::Temporary =>
                        {
                            Some(*target)
                        }
                        _ => None,
                    };
                    for cell in read_by(pool, id) {
                        reads.entry(cell).or_default().push(id);
                    }
                    spans.push(Span { formula: id, uses: vec![at], carrier });
                }
                open.extend(pool.operands(id));
            }
            // What is written from here on has another value.
            each_written(statement, &mut |cell| {
                for id in reads.remove(&cell).unwrap_or_default() {
                    known.remove(&id);
                }
            });
            if let Statement::Assign { target, value, .. } = statement
                && known.get(value).is_some_and(|span| spans[*span].carrier == Some(*target))
            {
                reads.entry(Cell::Variable(*target)).or_default().push(*value);
            }
        }
        spans.retain(|span| span.uses.len() > 1);
        spans
    }

    fn define(&mut self, value: FormulaId, origin: Origin) -> (FormulaId, Statement) {
        let name = formula_word(&self.program.pool, &self.program.variables, &self.program.timers, value);
        let target = self.program.variables.push(Variable::new(Role::Temporary, name, Type::Bool));
        (self.program.pool.variable(target, Type::Bool), Statement::assign(origin, target, value))
    }

    fn replace(&mut self, statement: &mut Statement, by: &FxHashMap<FormulaId, FormulaId>) {
        let pool = &mut self.program.pool;
        match statement {
            Statement::Heading(_) | Statement::Divide(_) | Statement::Case { .. } => {}
            Statement::Assign { value, .. } => *value = pool.replace(*value, by),
            Statement::CallTimer { input, .. } => *input = pool.replace(*input, by),
            Statement::If(choice) => {
                choice.branches.iter_mut().for_each(|(when, _)| *when = pool.replace(*when, by));
            }
        }
    }

    /// The same for the blocks within a statement.
    fn inside(&mut self, mut statement: Statement) -> Statement {
        match &mut statement {
            Statement::Heading(_) | Statement::Assign { .. } | Statement::Divide(_) | Statement::CallTimer { .. } => {}
            Statement::Case { arms, .. } => {
                arms.iter_mut().for_each(|arm| arm.body = self.block(std::mem::take(&mut arm.body)));
            }
            Statement::If(choice) => {
                let Choice { branches, otherwise } = &mut **choice;
                branches.iter_mut().for_each(|(_, body)| *body = self.block(std::mem::take(body)));
                *otherwise = self.block(std::mem::take(otherwise));
            }
        }
        statement
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scan::by_hand::{assign, bit, empty};

    #[test]
    fn what_keeps_its_value_is_computed_once() {
        let mut p = empty();
        let [(va, a), (_, b), (_, c), (_, d)] = [(); 4].map(|()| bit(&mut p, Role::Input));
        let [(x, _), (y, _), (z, _)] = [(); 3].map(|()| bit(&mut p, Role::Output));
        let any = p.pool.or([a, b, c]);
        let (one, other) = (p.pool.and([any, d]), p.pool.not(any));
        p.micro_step = vec![assign(x, one), assign(y, other), assign(va, d), assign(z, any)];
        once(&mut p);
        let [Statement::Assign { target, value, .. }, first, second, _, last] = p.micro_step.as_slice() else {
            panic!("{:?}", p.micro_step)
        };
        let read = p.pool.variable(*target, Type::Bool);
        let (short, not) = (p.pool.and([read, d]), p.pool.not(read));
        assert_eq!(*value, any);
        assert_eq!((first, second), (&assign(x, short), &assign(y, not)));
        // By then `a` has another value.
        assert_eq!(*last, assign(z, any));
    }

    #[test]
    fn a_temporary_that_has_the_value_is_read() {
        let mut p = empty();
        let [(_, a), (_, b), (_, c)] = [(); 3].map(|()| bit(&mut p, Role::Input));
        let (t, read) = bit(&mut p, Role::Temporary);
        let (x, _) = bit(&mut p, Role::Output);
        let any = p.pool.or([a, b, c]);
        p.micro_step = vec![assign(t, any), assign(x, any)];
        once(&mut p);
        assert_eq!(p.micro_step, [assign(t, any), assign(x, read)]);
    }

    #[test]
    fn arms_are_blocks_of_their_own() {
        let mut p = empty();
        let [(_, a), (_, b), (_, c)] = [(); 3].map(|()| bit(&mut p, Role::Input));
        let (x, _) = bit(&mut p, Role::Output);
        let any = p.pool.or([a, b, c]);
        let when = |body| Statement::when(a, vec![body]);
        let before = vec![when(assign(x, any)), when(assign(x, any))];
        p.micro_step = before.clone();
        once(&mut p);
        assert_eq!(p.micro_step, before);
    }
}
