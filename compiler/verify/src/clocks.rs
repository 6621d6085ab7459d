//! The timers of a program, and which of them measure the same operand.

use crate::beyond::Beyond;
use grafc_formula::{Formula, FormulaId, TimerId, Value};
use grafc_logic::scan::{Program, Role, Statement};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// What is known of the timers of a program.
pub(crate) struct Clocks {
    /// For each timer, the number of what it measures: that of others with the same input, called in the same section.
    pub(crate) operand: IndexVec<TimerId, usize>,
    /// For each timer, the times that anything asks for, in order.
    pub(crate) times: IndexVec<TimerId, Vec<i64>>,
}

/// The state of a timer between two reactions.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Phase {
    /// Whether its input is true.
    pub(crate) on: bool,
    /// Whether that began in this reaction.
    pub(crate) fresh: bool,
    /// How many of its times have passed.
    pub(crate) passed: usize,
    /// Whether more of them may have passed that no reaction has asked for since; known only where that is followed.
    pub(crate) vague: bool,
}

impl Clocks {
    /// The timers of a program.
    pub(crate) fn new(program: &Program) -> Result<Clocks, Beyond> {
        let mut operands: FxHashMap<(bool, FormulaId), usize> = FxHashMap::default();
        // One that is never called never runs.
        let mut operand: IndexVec<TimerId, usize> = program.timers.iter().map(|_| 0).collect();
        // A duration begins at the end of a micro-step, a delay at the beginning of the next: where a call is one
        // micro-step, they are not the same.
        let durations = timers_of(&program.before);
        for statement in program.statements() {
            if let Statement::CallTimer { timer, input, .. } = statement {
                let is_duration = durations.contains(timer);
                let next = operands.len();
                operand[*timer] = *operands.entry((is_duration, *input)).or_insert(next);
            }
        }
        let mut times: IndexVec<TimerId, Vec<i64>> = program.timers.iter().map(|_| Vec::new()).collect();
        for id in program.pool.ids() {
            if let Formula::TimerDone(t) = program.pool.get(id) {
                times[*t].extend(program.timers[*t].preset.map(|preset| preset.ms));
            }
            let Formula::Compare(_, [a, b]) = program.pool.get(id) else { continue };
            for (side, other) in [(a, b), (b, a)] {
                if let Formula::TimerElapsed(t) = program.pool.get(*side) {
                    let Some(Value::Time(time)) = constant(program, *other) else {
                        return Err(Beyond::Duration(program.timers[*t].name.clone()));
                    };
                    times[*t].extend([time, time.saturating_add(1)]);
                }
            }
        }
        for list in &mut times {
            list.sort_unstable();
            list.dedup();
        }
        Ok(Clocks { operand, times })
    }
}

/// A constant, perhaps by its name.
pub(crate) fn constant(program: &Program, formula: FormulaId) -> Option<Value> {
    let known = program.pool.as_constant(formula);
    if let Formula::Variable(v) = program.pool.get(formula) {
        let variable = &program.variables[*v];
        return known.or((variable.role == Role::Constant).then_some(variable.initial()));
    }
    known
}

fn timers_of(statements: &[Statement]) -> Vec<TimerId> {
    let mut found = Vec::new();
    let mut open: Vec<&Statement> = statements.iter().collect();
    while let Some(statement) = open.pop() {
        if let Statement::CallTimer { timer, .. } = statement {
            found.push(*timer);
        }
        open.extend(statement.bodies().flatten());
    }
    found
}
