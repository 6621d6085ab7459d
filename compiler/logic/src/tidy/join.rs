//! Neighbours under the same guards become one: `IF c THEN a; END_IF; IF c THEN b; END_IF;` is `IF c THEN a; b; END_IF;`, as
//! long as `a` writes nothing that `c` reads.

use crate::scan::{Division, Program, Statement, TimerId, VarId};
use grafc_formula::{Formula, FormulaId, Pool};
use rustc_hash::FxHashSet;

/// Joins what can be joined in all blocks of a program.
pub(crate) fn join(program: &mut Program) {
    let Program { first, before, micro_step, after, pool, .. } = program;
    for section in [first, before, micro_step, after] {
        block(pool, section);
    }
}

/// What guards read.
#[derive(Default)]
struct Read {
    variables: FxHashSet<VarId>,
    timers: FxHashSet<TimerId>,
}

impl Read {
    fn of(pool: &Pool, branches: &[(FormulaId, Vec<Statement>)]) -> Read {
        let mut read = Read::default();
        for (when, _) in branches {
            for f in pool.below(*when) {
                match pool.get(f) {
                    Formula::Variable(v) => {
                        read.variables.insert(*v);
                    }
                    Formula::TimerDone(t) | Formula::TimerElapsed(t) => {
                        read.timers.insert(*t);
                    }
                    Formula::Constant(_)
                    | Formula::Not(_)
                    | Formula::And(_)
                    | Formula::Or(_)
                    | Formula::Xor(..)
                    | Formula::Compare(..)
                    | Formula::Arithmetic(..)
                    | Formula::Negate(_)
                    | Formula::Widen(_) => {}
                }
            }
        }
        read
    }

    fn is_changed_by(&self, branches: &[(FormulaId, Vec<Statement>)], otherwise: &[Statement]) -> bool {
        branches.iter().any(|(_, body)| self.is_written_by(body)) || self.is_written_by(otherwise)
    }

    /// Statements nest no deeper than lowering nests them.
    fn is_written_by(&self, statements: &[Statement]) -> bool {
        statements.iter().any(|statement| match statement {
            Statement::Heading(_) => false,
            Statement::Assign { target, .. } => self.variables.contains(target),
            Statement::Divide(Division { target, flag, .. }) => {
                self.variables.contains(target) || self.variables.contains(flag)
            }
            Statement::CallTimer { timer, .. } => self.timers.contains(timer),
            Statement::Case { .. } | Statement::If { .. } => statement.bodies().any(|body| self.is_written_by(body)),
        })
    }
}

/// Statements nest no deeper than lowering nests them.
fn block(pool: &Pool, statements: &mut Vec<Statement>) {
    let mut out: Vec<Statement> = Vec::with_capacity(statements.len());
    // What the guards of the last statement read, if another has been joined to it; whether others may be.
    let mut read: Option<Read> = None;
    let mut closed = true;
    for mut statement in statements.drain(..) {
        match &mut statement {
            Statement::Case { arms, .. } => arms.iter_mut().for_each(|arm| block(pool, &mut arm.body)),
            Statement::If { branches, otherwise } => {
                if let Some(Statement::If { branches: known, otherwise: other }) = out.last_mut()
                    && !closed
                    && same(known, branches)
                {
                    let read = read.get_or_insert_with(|| {
                        let read = Read::of(pool, known);
                        closed = read.is_changed_by(known, other);
                        read
                    });
                    if !closed {
                        closed = read.is_changed_by(branches, otherwise);
                        for ((_, body), (_, more)) in known.iter_mut().zip(branches) {
                            body.append(more);
                        }
                        other.append(otherwise);
                        continue;
                    }
                }
                (read, closed) = (None, false);
                out.push(statement);
                continue;
            }
            Statement::Heading(_) | Statement::Assign { .. } | Statement::Divide(_) | Statement::CallTimer { .. } => {}
        }
        closed = true;
        out.push(statement);
    }
    for statement in &mut out {
        if let Statement::If { branches, otherwise } = statement {
            branches.iter_mut().for_each(|(_, body)| block(pool, body));
            block(pool, otherwise);
        }
    }
    *statements = out;
}

fn same(a: &[(FormulaId, Vec<Statement>)], b: &[(FormulaId, Vec<Statement>)]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|((a, _), (b, _))| a == b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scan::Role;
    use crate::scan::by_hand::{assign, bit, empty};

    #[test]
    fn neighbours_are_joined_unless_the_guard_changes_between() {
        let mut p = empty();
        let [(_, a), (b, is_b)] = [(); 2].map(|()| bit(&mut p, Role::Input));
        let [(x, _), (y, _), (z, _)] = [(); 3].map(|()| bit(&mut p, Role::Output));
        let when = |when: FormulaId, body: Vec<Statement>| Statement::If {
            branches: vec![(when, body)],
            otherwise: Vec::new(),
        };
        let c = p.pool.and([a, is_b]);
        p.micro_step = vec![
            when(c, vec![assign(x, a)]),
            when(c, vec![assign(b, a)]),
            // From here on it is another guard.
            when(c, vec![assign(y, a)]),
            when(a, vec![assign(z, a)]),
        ];
        join(&mut p);
        let joined = vec![when(c, vec![assign(x, a), assign(b, a)]), when(c, vec![assign(y, a)])];
        assert_eq!(p.micro_step, [joined, vec![when(a, vec![assign(z, a)])]].concat());
    }
}
