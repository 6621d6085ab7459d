//! What is claimed in the chart, as the program computes it: assumptions before a reaction, all else after it.

use grafc_formula::{Formula, VarId};
use grafc_logic::scan::{ClaimKind, Program, SeenBody, Statement};
use rustc_hash::FxHashSet;

/// The claims of a program.
#[derive(Clone, Debug, Default)]
pub(crate) struct Claimed {
    /// What is true of the inputs of every reaction.
    pub(crate) assumptions: Vec<VarId>,
    /// What is to be true in every state.
    pub(crate) assertions: Vec<VarId>,
    /// What is to be true in some state.
    pub(crate) wanted: Vec<VarId>,
    /// Where a chart may have come to its end.
    pub(crate) finals: Vec<VarId>,
    /// Of what leads to what, both.
    pub(crate) leads: Vec<(VarId, VarId)>,
    /// The statements after a reaction that they need, and what edges of inputs are compared with next.
    pub(crate) after: Vec<Statement>,
}

impl Claimed {
    /// The claims that a program computes.
    pub(crate) fn new(program: &Program) -> Claimed {
        let mut claimed = Claimed::default();
        for claim in &program.claims {
            match (claim.kind, claim.body) {
                (ClaimKind::Assume, SeenBody::Condition(v)) => claimed.assumptions.push(v),
                (ClaimKind::Assert, SeenBody::Condition(v)) => claimed.assertions.push(v),
                (ClaimKind::Reach, SeenBody::Condition(v)) => claimed.wanted.push(v),
                (ClaimKind::Final, SeenBody::Condition(v)) => claimed.finals.push(v),
                (_, SeenBody::Leads(from, to)) => claimed.leads.push((from, to)),
            }
        }
        if !program.claims.is_empty() {
            claimed.after = needed(program, &claimed);
        }
        claimed
    }

    /// What is true in a state, and asked for later.
    pub(crate) fn marks(&self) -> Vec<VarId> {
        self.finals.iter().copied().chain(self.leads.iter().flat_map(|(from, to)| [*from, *to])).collect()
    }
}

/// The statements of the last section without those that only show something else.
fn needed(program: &Program, claimed: &Claimed) -> Vec<Statement> {
    let of_claims = [&claimed.assertions, &claimed.wanted, &claimed.finals].into_iter().flatten().copied();
    let mut read: FxHashSet<VarId> =
        of_claims.chain(claimed.leads.iter().flat_map(|(from, to)| [*from, *to])).collect();
    // What the next call reads.
    for section in [&program.first, &program.before, &program.micro_step] {
        section.iter().for_each(|statement| reads(program, statement, &mut read));
    }
    let mut kept = Vec::new();
    for statement in program.after.iter().rev() {
        let mut written = Vec::new();
        writes(statement, &mut written);
        if written.iter().any(|v| read.contains(v)) {
            reads(program, statement, &mut read);
            kept.push(statement.clone());
        }
    }
    kept.reverse();
    kept
}

/// Statements nest no deeper than lowering nests them.
fn writes(statement: &Statement, out: &mut Vec<VarId>) {
    match statement {
        Statement::Heading(_) | Statement::CallTimer { .. } => {}
        Statement::Assign { target, .. } => out.push(*target),
        Statement::Divide(division) => out.push(division.target),
        Statement::Case { .. } | Statement::If(_) => {
            statement.bodies().flatten().for_each(|statement| writes(statement, out));
        }
    }
}

fn reads(program: &Program, statement: &Statement, out: &mut FxHashSet<VarId>) {
    let mut formula = |id| {
        for id in program.pool.below(id) {
            if let Formula::Variable(v) = program.pool.get(id) {
                out.insert(*v);
            }
        }
    };
    match statement {
        Statement::Heading(_) => {}
        Statement::Assign { value, .. } => formula(*value),
        Statement::CallTimer { input, .. } => formula(*input),
        Statement::Divide(division) => {
            formula(division.dividend);
            formula(division.divisor);
        }
        Statement::Case { of, .. } => _ = out.insert(*of),
        Statement::If(choice) => choice.branches.iter().for_each(|(when, _)| formula(*when)),
    }
    statement.bodies().flatten().for_each(|statement| reads(program, statement, out));
}
