//! Conjunctions and disjunctions of very many operands are evaluated in pieces.
//!
//! `w := X1 OR X2 OR … OR X9000` is right, but compilers descend once for each operand of such a chain and run out of
//! stack (rustc and LLVM at some thousands). So a long one is cut:
//!
//! ```text
//!             w := X1 OR … OR X9000
//! becomes     any_1 := X1 OR … OR X256;   any_2 := X257 OR …;   …   w := any_1 OR any_2 OR …
//! ```
//!
//! Formulas have no effects, so the pieces stand before the statement that reads them; those of a condition before the
//! whole `If`.

use crate::scan::{Choice, Heading, Origin, Program, Role, Statement, Variable, origin_of};
use grafc_formula::{Formula, FormulaId, Type};
use rustc_hash::{FxHashMap, FxHashSet};

/// The most operands of one conjunction or disjunction.
const LONGEST: usize = 256;

/// Cuts every long formula of a program.
pub(crate) fn cut(program: &mut Program) {
    let is_long = |id: FormulaId| operands(program, id).is_some_and(|list| list.len() > LONGEST);
    // What has a long formula in it.
    let Some(first) = program.pool.ids().find(|id| is_long(*id)) else { return };
    let mut concerned = vec![false; program.pool.len()];
    for id in program.pool.ids().skip(first.index()) {
        concerned[id.index()] = is_long(id) || program.pool.operands(id).any(|operand| concerned[operand.index()]);
    }
    // Tables that are full would else grow to twice their size for a few pieces.
    let lists = program.pool.ids().filter_map(|id| operands(program, id)).filter(|list| list.len() > LONGEST);
    let pieces: usize = lists.map(|list| list.len().div_ceil(LONGEST)).sum();
    // Of very many pieces there are pieces again.
    program.variables.raw.reserve_exact(2 * pieces);
    let sections = [&mut program.first, &mut program.before, &mut program.micro_step, &mut program.after];
    let mut sections = sections.map(std::mem::take);
    let mut restoring = program.restoring.take();
    let mut cutter = Cutter { program, concerned, origin: Origin::Chart };
    let restored = restoring.iter_mut().map(|restoring| &mut restoring.statements);
    sections.iter_mut().chain(restored).for_each(|section| cutter.block(section));
    program.restoring = restoring;
    [program.first, program.before, program.micro_step, program.after] = sections;
}

/// The operands of a conjunction or a disjunction.
fn operands(program: &Program, id: FormulaId) -> Option<&[FormulaId]> {
    match program.pool.get(id) {
        Formula::And(list) | Formula::Or(list) => Some(program.pool.list(*list)),
        Formula::Constant(_)
        | Formula::Variable(_)
        | Formula::TimerDone(_)
        | Formula::TimerElapsed(_)
        | Formula::Not(_)
        | Formula::Xor(..)
        | Formula::Compare(..)
        | Formula::Arithmetic(..)
        | Formula::Negate(_)
        | Formula::Widen(_) => None,
    }
}

struct Cutter<'p> {
    program: &'p mut Program,
    concerned: Vec<bool>,
    /// Where the statement comes from that is cut.
    origin: Origin,
}

impl Cutter<'_> {
    /// Statements nest no deeper than lowering nests them.
    fn block(&mut self, statements: &mut Vec<Statement>) {
        // What comes before which statement.
        let mut pieces: Vec<(usize, Statement)> = Vec::new();
        let mut before = Vec::new();
        for (place, statement) in statements.iter_mut().enumerate() {
            self.origin = statement.origin();
            match statement {
                // Operands of a division have no operators.
                Statement::Heading(_) | Statement::Divide(_) => {}
                Statement::Assign { value, .. } => *value = self.formula(*value, &mut before),
                Statement::CallTimer { input, .. } => *input = self.formula(*input, &mut before),
                Statement::Case { arms, .. } => arms.iter_mut().for_each(|arm| self.block(&mut arm.body)),
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &mut **choice;
                    for (when, body) in branches {
                        self.origin = origin_of(body);
                        *when = self.formula(*when, &mut before);
                        self.block(body);
                    }
                    self.block(otherwise);
                }
            }
            if !before.is_empty() {
                pieces.extend(before.drain(..).map(|piece| (place, piece)));
            }
        }
        insert(statements, pieces);
    }

    /// A formula whose long parts have been given to variables before it.
    fn formula(&mut self, root: FormulaId, before: &mut Vec<Statement>) -> FormulaId {
        if !self.concerned[root.index()] {
            return root;
        }
        let mut by: FxHashMap<FormulaId, FormulaId> = FxHashMap::default();
        for id in self.concerned_below(root) {
            let pool = &mut self.program.pool;
            let of = |operand: FormulaId| (operand, by.get(&operand).copied().unwrap_or(operand));
            let mut short = id;
            if pool.operands(id).any(|operand| by.contains_key(&operand)) {
                let operands = pool.operands(id).map(of).collect();
                short = pool.rebuilt(id, &operands);
            }
            while let Some(list) = operands(self.program, short).filter(|list| list.len() > LONGEST) {
                let conjunction = matches!(self.program.pool.get(short), Formula::And(_));
                let pieces: Vec<Vec<FormulaId>> = list.chunks(LONGEST).map(<[FormulaId]>::to_vec).collect();
                let read: Vec<FormulaId> =
                    pieces.into_iter().map(|piece| self.piece(piece, conjunction, before)).collect();
                short = self.junction(read, conjunction);
            }
            by.insert(id, short);
        }
        by[&root]
    }

    /// What is long, or has something long in it, operands before operators.
    fn concerned_below(&self, root: FormulaId) -> Vec<FormulaId> {
        let mut seen: FxHashSet<FormulaId> = FxHashSet::default();
        let mut open = vec![root];
        while let Some(id) = open.pop() {
            if seen.insert(id) {
                open.extend(self.program.pool.operands(id).filter(|operand| self.concerned[operand.index()]));
            }
        }
        let mut ids: Vec<FormulaId> = seen.into_iter().collect();
        ids.sort_unstable();
        ids
    }

    /// A variable for a piece of a long formula.
    fn piece(&mut self, piece: Vec<FormulaId>, conjunction: bool, before: &mut Vec<Statement>) -> FormulaId {
        let value = self.junction(piece, conjunction);
        let name = if conjunction { "all" } else { "any" };
        let target = self.program.variables.push(Variable::new(Role::Temporary, name, Type::Bool));
        before.push(Statement::assign(self.origin, target, value));
        self.program.pool.variable(target, Type::Bool)
    }

    fn junction(&mut self, operands: Vec<FormulaId>, conjunction: bool) -> FormulaId {
        let pool = &mut self.program.pool;
        if conjunction { pool.and(operands) } else { pool.or(operands) }
    }
}

/// Puts statements before others, whose places they have with them, in order. Programs are long, so the statements move up
/// where they are.
fn insert(statements: &mut Vec<Statement>, new: Vec<(usize, Statement)>) {
    let mut from = statements.len();
    let mut to = from + new.len();
    statements.reserve_exact(new.len());
    statements.resize(to, Statement::Heading(Heading::Conditions));
    for (place, statement) in new.into_iter().rev() {
        while from > place {
            (from, to) = (from - 1, to - 1);
            statements.swap(from, to);
        }
        to -= 1;
        statements[to] = statement;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scan::by_hand::{assign, bit, empty};
    use crate::scan::evaluate::Evaluator;
    use grafc_formula::Value;
    use grafc_model::reaction::Stimulus;

    /// `w := NOT (i0 OR i1 OR …)` and, if that is false, `v := i0 AND i1 AND …`.
    fn program(length: usize) -> Program {
        let mut p = empty();
        let inputs: Vec<FormulaId> = (0..length).map(|_| bit(&mut p, Role::Input).1).collect();
        let [w, v] = [(); 2].map(|()| bit(&mut p, Role::Output).0);
        let any = p.pool.or(inputs.clone());
        let (none, all) = (p.pool.not(any), p.pool.and(inputs));
        let branches = vec![(any, vec![assign(v, all)])];
        p.micro_step = vec![assign(w, none), Statement::choice(branches, Vec::new())];
        p
    }

    #[test]
    fn pieces_are_short_and_mean_the_same() {
        let mut program = program(600);
        cut(&mut program);
        // Three pieces before each of the two formulas that were long where they stood, three in the branch.
        let [.., Statement::If(choice)] = program.micro_step.as_slice() else { panic!("an If at the end") };
        assert_eq!(program.micro_step.len(), 3 + 1 + 3 + 1);
        assert_eq!(choice.branches[0].1.len(), 3 + 1);
        for (ones, w, v) in [
            (0..0, true, false),
            // The last of a whole piece.
            (255..256, false, false),
            (599..600, false, false),
            (0..599, false, false),
            (0..600, false, true),
        ] {
            let inputs = (0..600).map(|n| Value::Bool(ones.contains(&n))).collect();
            let response = Evaluator::new(&program).react(&Stimulus { t_ms: 0, restart: false, inputs });
            assert_eq!(response.outputs, [Value::Bool(w), Value::Bool(v)], "{ones:?}");
        }
    }

    #[test]
    fn short_programs_stay_as_they_are() {
        let mut program = program(LONGEST);
        let before = program.micro_step.clone();
        cut(&mut program);
        assert_eq!(program.micro_step, before);
    }
}
