//! Timers of steps that are not active are left alone.
//!
//! The input of a delay on a step, `2s/X5`, is false as long as another step of the set is active. A timer whose input was
//! false at its last call is as it was after that call, so there is no need to call it. Where a set has many such timers,
//! only those of the active step are called, and, once, those of the step that was active before:
//!
//! ```text
//! on_X0(IN := at = 0)              IF at <> timed THEN
//! on_X1(IN := at = 1)                CASE timed OF  0: on_X0(IN := FALSE)  1: on_X1(IN := FALSE) …
//! on_X2(IN := at = 2)     becomes    timed := at
//! …                                CASE at OF  0: on_X0(IN := TRUE)  1: on_X1(IN := TRUE) …
//! ```
//!
//! so that a call costs what is active, not what is drawn. The calls go to the place of the first of them. That is the same
//! as long as between the two places nothing reads the timer and nothing writes what its input reads.

use crate::scan::{Arm, Choice, Heading, Origin, Program, Role, Statement, TimerId, Told, VarId, Variable};
use grafc_formula::{Comparison, Formula, FormulaId, Pool, Value};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;

/// Up to so many timers are called one by one, which is easier to read.
const FEW: usize = 4;

/// Timers of one state, whose calls can be made at one place.
struct Group {
    state: VarId,
    /// Of each call its statement, the value of the state that its input asks for, and the timer.
    calls: Vec<(usize, i64, TimerId)>,
}

impl Group {
    fn timers(&self) -> Vec<TimerId> {
        self.calls.iter().map(|(_, _, timer)| *timer).collect()
    }
}

/// Lets timers rest in all sections that are gone through in every call.
pub(crate) fn rest(program: &mut Program) {
    if program.states.is_empty() || program.timers.len() <= FEW {
        return;
    }
    let of_state: FxHashMap<VarId, usize> =
        program.states.iter().enumerate().map(|(index, state)| (state.variable, index)).collect();
    let sections = [&mut program.before, &mut program.micro_step, &mut program.after].map(std::mem::take);
    let groups: Vec<Vec<Group>> = sections.iter().map(|s| groups(&program.pool, &of_state, s)).collect();

    // Where one place calls other timers than another, each would have to know of the other's.
    let mut calls: FxHashMap<TimerId, usize> = FxHashMap::default();
    sections.iter().flatten().for_each(|statement| count(statement, &mut calls));
    let mut places: FxHashMap<Vec<TimerId>, usize> = FxHashMap::default();
    groups.iter().flatten().for_each(|group| *places.entry(group.timers()).or_default() += 1);
    let is_alone = |group: &Group| {
        let timers = group.timers();
        timers.len() > FEW && timers.iter().all(|timer| calls[timer] == places[&timers])
    };

    let mut memory: FxHashMap<Vec<TimerId>, VarId> = FxHashMap::default();
    let mut rested = sections.into_iter().zip(groups).map(|(mut section, groups)| {
        let mut gone = FxHashSet::default();
        let mut instead = FxHashMap::default();
        for group in groups.into_iter().filter(is_alone) {
            let timed = *memory.entry(group.timers()).or_insert_with(|| remember(program, of_state[&group.state]));
            gone.extend(group.calls.iter().map(|(place, ..)| *place));
            let first = group.calls.first().map_or(0, |(place, ..)| *place);
            instead.insert(first, calls_by_state(program, &section, &group, of_state[&group.state], timed));
        }
        let mut out = Vec::with_capacity(section.len());
        for (place, statement) in section.drain(..).enumerate() {
            out.extend(instead.remove(&place).into_iter().flatten());
            if !gone.contains(&place) {
                out.push(statement);
            }
        }
        out
    });
    let [before, micro_step, after] = [(); 3].map(|()| rested.next().unwrap_or_default());
    drop(rested);
    (program.before, program.micro_step, program.after) = (before, micro_step, after);
}

/// How often each timer is called.
fn count(statement: &Statement, calls: &mut FxHashMap<TimerId, usize>) {
    match statement {
        Statement::CallTimer { timer, .. } => *calls.entry(*timer).or_default() += 1,
        Statement::Heading(_) | Statement::Assign { .. } | Statement::Divide(_) => {}
        Statement::Case { arms, .. } => arms.iter().flat_map(|arm| &arm.body).for_each(|s| count(s, calls)),
        Statement::If(choice) => {
            let Choice { branches, otherwise } = &**choice;
            let bodies = branches.iter().flat_map(|(_, body)| body).chain(otherwise);
            bodies.for_each(|s| count(s, calls));
        }
    }
}

/// The groups of a section.
fn groups(pool: &Pool, of_state: &FxHashMap<VarId, usize>, section: &[Statement]) -> Vec<Group> {
    let mut done = Vec::new();
    let mut open: BTreeMap<VarId, Group> = BTreeMap::new();
    // Since the open groups began: what was written, which timers were called, and which were read by the formulas seen.
    let mut written: FxHashSet<VarId> = FxHashSet::default();
    let mut read: FxHashSet<TimerId> = FxHashSet::default();
    let mut called: FxHashSet<TimerId> = FxHashSet::default();
    let mut seen: FxHashSet<FormulaId> = FxHashSet::default();
    for (place, statement) in section.iter().enumerate() {
        match statement {
            Statement::Heading(_) => {}
            Statement::CallTimer { timer, input, .. } => {
                let asked = asked(pool, of_state, *input);
                let stays = |_: &(VarId, i64)| {
                    !read.contains(timer)
                        && !called.contains(timer)
                        && pool.below(*input).into_iter().all(|id| match pool.get(id) {
                            Formula::Variable(v) => !written.contains(v),
                            Formula::TimerDone(_) | Formula::TimerElapsed(_) => false,
                            _ => true,
                        })
                };
                if let Some((state, value)) = asked.filter(stays) {
                    let group = open.entry(state).or_insert_with(|| Group { state, calls: Vec::new() });
                    group.calls.push((place, value, *timer));
                }
                called.insert(*timer);
                timers_read(pool, *input, &mut seen, &mut read);
            }
            Statement::Assign { target, value, .. } => {
                written.insert(*target);
                timers_read(pool, *value, &mut seen, &mut read);
            }
            Statement::Divide(_) | Statement::Case { .. } | Statement::If(_) => {
                done.extend(std::mem::take(&mut open).into_values());
                written.clear();
                read.clear();
                called.clear();
                seen.clear();
            }
        }
    }
    done.extend(open.into_values());
    done
}

/// The timers that a formula reads, its parts looked at once.
fn timers_read(pool: &Pool, root: FormulaId, seen: &mut FxHashSet<FormulaId>, read: &mut FxHashSet<TimerId>) {
    let mut stack = vec![root];
    while let Some(id) = stack.pop() {
        if !seen.insert(id) {
            continue;
        }
        if let Formula::TimerDone(timer) | Formula::TimerElapsed(timer) = pool.get(id) {
            read.insert(*timer);
        }
        stack.extend(pool.operands(id));
    }
}

/// The state and its value without which an input is false.
fn asked(pool: &Pool, of_state: &FxHashMap<VarId, usize>, input: FormulaId) -> Option<(VarId, i64)> {
    pool.factors(&input).iter().find_map(|factor| comparison(pool, *factor).filter(|(v, _)| of_state.contains_key(v)))
}

fn comparison(pool: &Pool, id: FormulaId) -> Option<(VarId, i64)> {
    match pool.get(id) {
        Formula::Compare(Comparison::Equal, [a, b]) => match (pool.get(*a), pool.get(*b)) {
            (Formula::Variable(v), Formula::Constant(Value::Int(n))) => Some((*v, *n)),
            _ => None,
        },
        _ => None,
    }
}

/// A variable for the value that a state had when its timers were last called.
fn remember(program: &mut Program, index: usize) -> VarId {
    let at = &program.variables[program.states[index].variable];
    let (name, ty) = (format!("timed_{}", at.name.trim_start_matches("at_")), at.ty);
    let comment = Some("the step whose timers were last called".into());
    let timed = program.variables.push(Variable { comment, ..Variable::new(Role::Memory, name, ty) });
    program.states[index].copies.push(timed);
    timed
}

/// The calls of a group, by the value of its state.
fn calls_by_state(
    program: &mut Program,
    section: &[Statement],
    group: &Group,
    index: usize,
    timed: VarId,
) -> Vec<Statement> {
    let state = &program.states[index];
    let steps: FxHashMap<i64, Origin> = state.values.iter().map(|(s, value)| (*value, Origin::Step(*s))).collect();
    let pool = &mut program.pool;
    let (yes, no) = (pool.truth(true), pool.truth(false));
    let (mut on, mut off): (BTreeMap<i64, Vec<Statement>>, BTreeMap<i64, Vec<Statement>>) = Default::default();
    for (place, value, timer) in &group.calls {
        let Statement::CallTimer { input, origin, .. } = &section[*place] else { continue };
        let origin = *origin;
        let others: Vec<FormulaId> = pool.factors(input).to_vec();
        let others = others.into_iter().filter(|f| comparison(pool, *f) != Some((group.state, *value)));
        let others: Vec<FormulaId> = others.collect();
        let input = if others.is_empty() { yes } else { pool.and(others) };
        on.entry(*value).or_default().push(Statement::CallTimer { timer: *timer, input, origin });
        off.entry(*value).or_default().push(Statement::CallTimer { timer: *timer, input: no, origin });
    }
    let arms = |bodies: BTreeMap<i64, Vec<Statement>>| {
        let arm = |(value, body)| Arm {
            value,
            origin: steps.get(&value).copied().unwrap_or_default(),
            told: Told::Name,
            body,
        };
        bodies.into_iter().map(arm).collect::<Vec<Arm>>()
    };
    let ty = program.variables[timed].ty;
    let (is, was) = (pool.variable(group.state, ty), pool.variable(timed, ty));
    let moved = pool.differs(is, was);
    let left = vec![
        Statement::Heading(Heading::TimersOfTheStepBefore),
        Statement::Case { of: timed, arms: arms(off) },
        Statement::assign(Origin::Chart, timed, is),
    ];
    vec![
        Statement::when(moved, left),
        Statement::Heading(Heading::TimersOfTheActiveStep),
        Statement::Case { of: group.state, arms: arms(on) },
    ]
}

#[cfg(test)]
mod tests {
    use crate::scan::{Program, Statement};
    use crate::{Analysis, Encoding, Options, compile};
    use grafc_diagnostics::{Diagnostics, FileId};

    fn program(text: &str) -> Program {
        let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), text);
        assert!(!diagnostics.has_errors(), "{diagnostics:?}");
        let (chart, diagnostics) = grafc_model::check(&tree, "chart");
        let mut net = grafc_net::build(&chart.unwrap_or_else(|| panic!("{diagnostics:?}")));
        grafc_net::passes::run(&mut net, false, &mut Diagnostics::new());
        let options = Options { encoding: Encoding::Switch, ..Options::default() };
        compile(Analysis::new(net), &options).0
    }

    /// A ring of steps, no small one, of which so many are left after a second.
    fn ring(timers: usize) -> String {
        const STEPS: usize = 24;
        let mut text = String::from("chart C\ninput a : bool\n");
        for i in 0..STEPS {
            let initial = if i == 0 { "initial " } else { "" };
            let condition = if i < timers { format!("1s/X{i}") } else { "a".to_owned() };
            text += &format!("{initial}step {i}\ntransition {i} -> {} : {condition}\n", (i + 1) % STEPS);
        }
        text
    }

    fn plain_calls(statements: &[Statement]) -> usize {
        statements.iter().filter(|statement| matches!(statement, Statement::CallTimer { .. })).count()
    }

    #[test]
    fn a_few_timers_are_called_one_by_one() {
        assert_eq!(plain_calls(&program(&ring(super::FEW)).micro_step), super::FEW);
    }

    #[test]
    fn many_timers_are_called_by_the_step_that_is_active() {
        let program = program(&ring(super::FEW + 1));
        assert_eq!(plain_calls(&program.micro_step), 0);
        let arms = program.micro_step.iter().find_map(|statement| match statement {
            Statement::Case { arms, .. } => Some(arms),
            _ => None,
        });
        let arms = arms.unwrap_or_else(|| panic!("a CASE of timers"));
        assert_eq!(arms.len(), super::FEW + 1);
        assert!(arms.iter().all(|arm| plain_calls(&arm.body) == 1 && arm.body.len() == 1));
    }

    #[test]
    fn a_timer_of_an_input_is_always_called() {
        let text = ring(6).replace(" : 1s/X3", " : 1s/X3 and 2s/a");
        assert_eq!(plain_calls(&program(&text).micro_step), 1);
    }
}
