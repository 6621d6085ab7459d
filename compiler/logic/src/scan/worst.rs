//! The longest call: how many micro-steps and statements it can take.

use super::{Program, Statement};

/// The worst case of a call. No call takes more; whether one takes as much, conditions and plant decide.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WorstCase {
    /// Micro-steps.
    pub micro_steps: u32,
    /// Statements that are carried out: of alternatives the longest, and what leads to it as one.
    pub statements: u64,
}

impl Program {
    /// The worst case of a call, the first one included.
    pub fn worst_case(&self) -> WorstCase {
        let once = [&self.first, &self.before, &self.after].map(|section| longest(section)).iter().sum::<u64>();
        let each = longest(&self.micro_step);
        WorstCase { micro_steps: self.most, statements: once.saturating_add(each.saturating_mul(self.most.into())) }
    }
}

/// The statements of the longest way through. They nest no deeper than lowering nests them.
fn longest(statements: &[Statement]) -> u64 {
    let of = |statement: &Statement| match statement {
        Statement::Heading(_) => 0,
        Statement::Assign { .. } | Statement::Divide(_) | Statement::CallTimer { .. } => 1,
        Statement::Case { .. } | Statement::If(_) => 1 + statement.bodies().map(longest).max().unwrap_or_default(),
    };
    statements.iter().map(of).sum()
}

#[cfg(test)]
mod tests {
    use crate::scan::Statement;
    use crate::scan::by_hand::{arm, assign, bit, empty};

    #[test]
    fn of_alternatives_the_longest_counts() {
        let mut p = empty();
        let [(a, f), (b, g)] = [(); 2].map(|()| bit(&mut p, crate::scan::Role::Temporary));
        let (one, other) = (assign(a, g), assign(b, f));
        p.first = vec![one.clone()];
        // 1 for the choice, and 2 of its longer branch.
        let branches = vec![(f, vec![one.clone()]), (g, vec![one.clone(), other.clone()])];
        p.micro_step = vec![Statement::choice(branches, vec![other.clone()])];
        // 1 for the choice, and 1 of an arm.
        p.after = vec![Statement::Case { of: a, arms: vec![arm(1, vec![one]), arm(2, vec![other])] }];
        p.most = 4;
        let worst = p.worst_case();
        assert_eq!((worst.micro_steps, worst.statements), (4, 1 + 4 * 3 + 2));
    }
}
