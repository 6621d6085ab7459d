//! The variables that make a state: those that a call may read before it writes them.
//!
//! What only holds a value for others to see is none: an output that follows the situation, a flag.

use grafc_formula::{Formula, FormulaId, VarId};
use grafc_logic::scan::{Choice, Program, Role, Statement};
use index_vec::IndexVec;

/// For each variable, whether it is read before it is written.
type Set = IndexVec<VarId, bool>;

/// The variables that make states, in order.
pub(crate) struct Live {
    /// Between two calls.
    pub(crate) between_calls: Vec<VarId>,
    /// Between two micro-steps of a call.
    pub(crate) between_micro_steps: Vec<VarId>,
}

impl Live {
    /// The live variables of a program, of whose last section only some statements are run.
    pub(crate) fn new(program: &Program, after: &[Statement]) -> Live {
        let mut between_calls: Set = program.variables.iter().map(|_| false).collect();
        // The situation counts also where nothing asks for it.
        for step in &program.steps {
            read(program, step.active, &mut between_calls);
        }
        let mut head;
        loop {
            // After the last micro-step comes the next call, or another micro-step.
            head = between_calls.clone();
            backwards(program, after, &mut head);
            loop {
                let mut next = head.clone();
                backwards(program, &program.micro_step, &mut next);
                if !join(&mut head, &next) {
                    break;
                }
            }
            let mut start = head.clone();
            backwards(program, &program.before, &mut start);
            backwards(program, &program.first, &mut start);
            if !join(&mut between_calls, &start) {
                break;
            }
        }
        let list = |set: &Set| {
            let kept = set.iter_enumerated().filter(|(v, live)| **live && is_kept(program, *v));
            kept.map(|(v, _)| v).collect()
        };
        Live { between_calls: list(&between_calls), between_micro_steps: list(&head) }
    }
}

fn is_kept(program: &Program, v: VarId) -> bool {
    match program.variables[v].role {
        Role::Output | Role::Internal | Role::Step | Role::State | Role::Memory | Role::Temporary => true,
        Role::Input | Role::Constant | Role::Flag(_) | Role::Observed => false,
    }
}

/// Adds what is in the other; whether that was anything new.
fn join(set: &mut Set, other: &Set) -> bool {
    let mut new = false;
    for (mine, theirs) in set.iter_mut().zip(other) {
        new |= *theirs && !*mine;
        *mine |= *theirs;
    }
    new
}

/// What is live before statements, from what is after them. Statements nest no deeper than lowering nests them.
fn backwards(program: &Program, statements: &[Statement], live: &mut Set) {
    for statement in statements.iter().rev() {
        match statement {
            Statement::Heading(_) => {}
            Statement::Assign { target, value, .. } => {
                live[*target] = false;
                read(program, *value, live);
            }
            Statement::Divide(division) => {
                live[division.target] = false;
                read(program, division.dividend, live);
                read(program, division.divisor, live);
            }
            Statement::CallTimer { input, .. } => read(program, *input, live),
            Statement::Case { of, arms } => {
                let after = live.clone();
                for arm in arms {
                    let mut within = after.clone();
                    backwards(program, &arm.body, &mut within);
                    join(live, &within);
                }
                live[*of] = true;
            }
            Statement::If(choice) => {
                let Choice { branches, otherwise } = &**choice;
                let after = live.clone();
                backwards(program, otherwise, live);
                for (when, body) in branches.iter().rev() {
                    let mut within = after.clone();
                    backwards(program, body, &mut within);
                    join(live, &within);
                    read(program, *when, live);
                }
            }
        }
    }
}

fn read(program: &Program, formula: FormulaId, live: &mut Set) {
    let mut open = vec![formula];
    let mut seen = rustc_hash::FxHashSet::default();
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        if let Formula::Variable(v) = program.pool.get(id) {
            live[*v] = true;
        }
        open.extend(program.pool.operands(id));
    }
}
