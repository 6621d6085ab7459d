//! What is kept and what goes, in programs of a few statements.

use super::sweep;
use crate::scan::by_hand::{arm, assign, bit, call, empty, variable};
use crate::scan::{Heading, Program, Repeat, Role, Statement, Timer};
use grafc_formula::Type;

/// How many statements are left of each section: before, micro-step, after.
fn left(program: &mut Program) -> [usize; 3] {
    sweep(program);
    [program.before.len(), program.micro_step.len(), program.after.len()]
}

#[test]
fn what_nothing_reads_goes_and_its_variable_with_it() {
    let mut p = empty();
    let (_, a) = bit(&mut p, Role::Input);
    let (t, _) = bit(&mut p, Role::Temporary);
    let (w, _) = bit(&mut p, Role::Output);
    p.micro_step = vec![assign(t, a), assign(w, a)];
    assert_eq!(left(&mut p), [0, 1, 0]);
    assert_eq!(p.variables.len(), 2);
}

#[test]
fn a_value_that_is_written_again_before_it_is_read_goes() {
    let mut p = empty();
    let (_, a) = bit(&mut p, Role::Input);
    let (t, read) = bit(&mut p, Role::Temporary);
    let (w, _) = bit(&mut p, Role::Output);
    let not_a = p.pool.not(a);
    p.micro_step = vec![assign(t, a), assign(t, not_a), assign(w, read)];
    assert_eq!(left(&mut p), [0, 2, 0]);
}

#[test]
fn what_is_read_after_the_loop_stays_in_it() {
    let mut p = empty();
    let (_, a) = bit(&mut p, Role::Input);
    let (again, _) = bit(&mut p, Role::Temporary);
    let (t, read) = bit(&mut p, Role::Temporary);
    let (w, _) = bit(&mut p, Role::Output);
    p.repeat = Some(Repeat { again, limit: None });
    // The next micro-step writes it before it reads it: only what follows the loop needs the value at its end.
    p.micro_step = vec![assign(again, a), assign(t, a)];
    p.after = vec![assign(w, read)];
    assert_eq!(left(&mut p), [0, 2, 1]);
}

#[test]
fn what_the_next_micro_step_reads_stays() {
    let mut p = empty();
    let (_, a) = bit(&mut p, Role::Input);
    let (again, _) = bit(&mut p, Role::Temporary);
    let (t, read) = bit(&mut p, Role::Temporary);
    let (w, _) = bit(&mut p, Role::Output);
    p.repeat = Some(Repeat { again, limit: None });
    p.before = vec![assign(t, a)];
    p.micro_step = vec![assign(w, read), assign(again, a), assign(t, a)];
    assert_eq!(left(&mut p), [1, 3, 0]);
}

#[test]
fn without_a_loop_nothing_reads_it_at_the_end() {
    let mut p = empty();
    let (_, a) = bit(&mut p, Role::Input);
    let (t, read) = bit(&mut p, Role::Temporary);
    let (w, _) = bit(&mut p, Role::Output);
    p.before = vec![assign(t, a)];
    p.micro_step = vec![assign(w, read), assign(t, a)];
    assert_eq!(left(&mut p), [1, 1, 0]);
}

#[test]
fn a_value_stays_that_one_branch_only_replaces() {
    let mut p = empty();
    let (_, a) = bit(&mut p, Role::Input);
    let (t, read) = bit(&mut p, Role::Temporary);
    let (w, _) = bit(&mut p, Role::Output);
    let no = p.pool.truth(false);
    let replaced = Statement::when(a, vec![assign(t, no)]);
    p.micro_step = vec![assign(t, a), replaced, assign(w, read)];
    assert_eq!(left(&mut p), [0, 3, 0]);
}

#[test]
fn a_value_goes_that_every_branch_replaces() {
    let mut p = empty();
    let (_, a) = bit(&mut p, Role::Input);
    let (t, read) = bit(&mut p, Role::Temporary);
    let (w, _) = bit(&mut p, Role::Output);
    let (yes, no) = (p.pool.truth(true), p.pool.truth(false));
    let replaced = Statement::choice(vec![(a, vec![assign(t, no)])], vec![assign(t, yes)]);
    p.micro_step = vec![assign(t, a), replaced, assign(w, read)];
    assert_eq!(left(&mut p), [0, 2, 0]);
}

#[test]
fn what_only_a_case_asks_for_stays() {
    let mut p = empty();
    let at = variable(&mut p, Role::State, Type::Int);
    let copy = variable(&mut p, Role::Temporary, Type::Int);
    let (w, _) = bit(&mut p, Role::Output);
    let (at, yes) = (p.pool.variable(at, Type::Int), p.pool.truth(true));
    let arm = arm(1, vec![assign(w, yes)]);
    p.micro_step = vec![assign(copy, at), Statement::Case { of: copy, arms: vec![arm] }];
    assert_eq!(left(&mut p), [0, 2, 0]);
}

#[test]
fn what_only_a_timer_reads_stays() {
    let mut p = empty();
    let (_, a) = bit(&mut p, Role::Input);
    let (t, read) = bit(&mut p, Role::Temporary);
    let timer = p.timers.push(Timer { name: String::new(), preset: None, comment: None });
    p.micro_step = vec![assign(t, a), call(timer, read)];
    assert_eq!(left(&mut p), [0, 2, 0]);
}

#[test]
fn a_heading_over_nothing_goes() {
    let mut p = empty();
    let (_, a) = bit(&mut p, Role::Input);
    let (t, _) = bit(&mut p, Role::Temporary);
    let (w, _) = bit(&mut p, Role::Output);
    let heading = Statement::Heading;
    p.micro_step = vec![
        heading(Heading::Conditions),
        assign(t, a),
        heading(Heading::Outputs),
        assign(w, a),
        heading(Heading::Situation),
    ];
    sweep(&mut p);
    assert_eq!(p.micro_step, [heading(Heading::Outputs), p.micro_step[1].clone()]);
}
