//! Neighbours under the same guards become one: `IF c THEN a; END_IF; IF c THEN b; END_IF;` is `IF c THEN a; b; END_IF;`, as
//! long as `a` writes nothing that `c` reads.

use super::cells::{Cell, each_written, read_by};
use crate::scan::{Choice, Program, Statement};
use grafc_formula::{FormulaId, Pool};
use rustc_hash::FxHashSet;

/// An alternative with its guard.
type Branch = (FormulaId, Vec<Statement>);

/// Joins what can be joined in all blocks of a program.
pub(crate) fn join(program: &mut Program) {
    let Program { first, before, micro_step, after, pool, .. } = program;
    for section in [first, before, micro_step, after] {
        block(pool, section);
    }
}

/// What the guards of a statement read.
fn read_by_guards(pool: &Pool, branches: &[Branch]) -> FxHashSet<Cell> {
    branches.iter().flat_map(|(when, _)| read_by(pool, *when)).collect()
}

fn is_changed_by(read: &FxHashSet<Cell>, choice: &Choice) -> bool {
    let mut changed = false;
    for statement in choice.branches.iter().flat_map(|(_, body)| body).chain(&choice.otherwise) {
        each_written(statement, &mut |cell| changed |= read.contains(&cell));
    }
    changed
}

/// Statements nest no deeper than lowering nests them.
fn block(pool: &Pool, statements: &mut Vec<Statement>) {
    // What the guards of the last statement read, if another may be joined to it; whether that is over.
    let mut read: Option<FxHashSet<Cell>> = None;
    let mut closed = false;
    statements.dedup_by(|statement, last| {
        if !closed
            && let Statement::If(last) = last
            && let Statement::If(choice) = statement
            && same(&last.branches, &choice.branches)
        {
            let read = read.get_or_insert_with(|| {
                let read = read_by_guards(pool, &last.branches);
                closed = is_changed_by(&read, last);
                read
            });
            if !closed {
                closed = is_changed_by(read, choice);
                for ((_, body), (_, more)) in last.branches.iter_mut().zip(&mut choice.branches) {
                    body.append(more);
                }
                last.otherwise.append(&mut choice.otherwise);
                return true;
            }
        }
        (read, closed) = (None, false);
        false
    });
    for statement in statements {
        match statement {
            Statement::Case { arms, .. } => arms.iter_mut().for_each(|arm| block(pool, &mut arm.body)),
            Statement::If(choice) => {
                let Choice { branches, otherwise } = &mut **choice;
                branches.iter_mut().for_each(|(_, body)| block(pool, body));
                block(pool, otherwise);
            }
            Statement::Heading(_) | Statement::Assign { .. } | Statement::Divide(_) | Statement::CallTimer { .. } => {}
        }
    }
}

fn same(a: &[Branch], b: &[Branch]) -> bool {
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
        let when = |when: FormulaId, body: Vec<Statement>| Statement::when(when, body);
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
