//! What a program says of itself, and what the check refuses.

use super::by_hand::{arm, assign, bit, empty, variable};
use super::*;
use grafc_diagnostics::Span;
use grafc_formula::{Comparison, FormulaId, Type, Value};

/// A program with a division of numbers of a type, whose divisor and dividend are made from a variable.
fn division(
    ty: Type,
    modulo: bool,
    make: impl FnOnce(&mut Pool, FormulaId) -> (FormulaId, FormulaId),
) -> (Program, Division) {
    let mut p = empty();
    let (n, target) = (variable(&mut p, Role::Input, ty), variable(&mut p, Role::Temporary, ty));
    let flag = variable(&mut p, Role::Flag(Flag::Div0), Type::Bool);
    let read = p.pool.variable(n, ty);
    let (dividend, divisor) = make(&mut p.pool, read);
    (p, Division { target, modulo, dividend, divisor, flag, origin: Origin::Chart })
}

#[test]
fn a_divisor_is_asked_what_no_processor_divides_by() {
    let guard = |ty, modulo, make: fn(&mut Pool, FormulaId) -> (FormulaId, FormulaId)| {
        let (program, division) = division(ty, modulo, make);
        program.guard(&division)
    };
    let constant = |pool: &mut Pool, n| pool.constant(Value::Int(n), Type::Dint);
    let both = |_: &mut Pool, n| (n, n);
    // Only of 32 bits with sign there is a quotient that the type cannot hold: 16 bits are divided at 32.
    for ty in [Type::Int, Type::Uint, Type::Udint, Type::Real, Type::Lreal] {
        assert_eq!(guard(ty, false, both), Guard::Zero, "{ty:?}");
    }
    assert_eq!(guard(Type::Dint, false, both).by_minus_one(), Some(ByMinusOne::Negative));
    assert_eq!(guard(Type::Dint, true, both).by_minus_one(), Some(ByMinusOne::Zero));
    let least = |pool: &mut Pool, n| (constant(pool, -2_147_483_648), n);
    let next = |pool: &mut Pool, n| (constant(pool, -2_147_483_647), n);
    let by_nothing = |pool: &mut Pool, n| (n, constant(pool, 0));
    let (program, one) = division(Type::Dint, false, least);
    assert_eq!(program.guard(&one).by_minus_one(), Some(ByMinusOne::Dividend));
    let (program, one) = division(Type::Dint, true, least);
    assert_eq!(program.guard(&one).by_minus_one(), Some(ByMinusOne::Zero));
    let (program, one) = division(Type::Dint, false, next);
    assert_eq!(program.guard(&one).by_minus_one(), None, "2147483647 fits");
    let (program, one) = division(Type::Dint, false, by_nothing);
    assert_eq!(program.guard(&one), Guard::Never);
}

#[test]
fn statements_are_gone_through_in_order() {
    let mut p = empty();
    let (a, when) = bit(&mut p, Role::Input);
    let targets: Vec<VarId> = (0..6).map(|_| bit(&mut p, Role::Output).0).collect();
    let write = |place: usize| assign(targets[place], when);
    let inner = Statement::choice(vec![(when, vec![write(1)])], vec![write(2)]);
    let arms = vec![arm(1, vec![inner, write(3)])];
    p.before = vec![write(0), Statement::Case { of: a, arms }, write(4)];
    p.after = vec![write(5)];
    let written = p.statements().filter_map(|statement| match statement {
        Statement::Assign { target, .. } => Some(*target),
        _ => None,
    });
    assert_eq!(written.collect::<Vec<_>>(), targets);
}

/// A program with a step, an initial reaction and a loop.
fn whole() -> Program {
    let mut p = empty();
    let (x, active) = bit(&mut p, Role::Step);
    p.steps.push(Step { label: "1".into(), comment: None, span: Span::default(), held: Held::Bit(x), active });
    let (started, is_started) = bit(&mut p, Role::Memory);
    let (again, _) = bit(&mut p, Role::Memory);
    let count = variable(&mut p, Role::Temporary, Type::Int);
    let flag = variable(&mut p, Role::Flag(Flag::Livelock), Type::Bool);
    let (yes, at_first) = (p.pool.truth(true), p.pool.not(is_started));
    let body = vec![assign(started, yes), assign(x, yes)];
    p.first = vec![Statement::when(at_first, body)];
    p.started = Some(started);
    p.repeat = Some(Repeat { again, limit: Some(Limit { count, bound: 32_767, flag }) });
    p
}

#[test]
fn tables_have_to_fit_the_statements() {
    assert_eq!(verify(&whole()), Ok(()));
    let refused = |spoil: &dyn Fn(&mut Program)| {
        let mut program = whole();
        spoil(&mut program);
        verify(&program).is_err()
    };
    fn limit(program: &mut Program) -> &mut Limit {
        program.repeat.as_mut().and_then(|repeat| repeat.limit.as_mut()).expect("a limit")
    }
    let some = |p: &Program| p.started.expect("a mark");
    assert!(refused(&|p| p.started = None), "nothing guards the initial reaction");
    assert!(refused(&|p| p.first.clear()), "the mark guards nothing");
    assert!(refused(&|p| p.started = p.repeat.map(|repeat| repeat.again)), "another mark guards");
    assert!(refused(&|p| p.steps[0].held = Held::Bit(some(p))), "held by something else");
    assert!(refused(&|p| p.steps[0].held = Held::State(0, 1)), "held by a state");
    assert!(refused(&|p| limit(p).bound = 0), "no micro-step");
    assert!(refused(&|p| limit(p).bound = 32_768), "more than an INT counts to");
    assert!(refused(&|p| limit(p).flag = some(p)), "no flag");
    assert!(refused(&|p| p.repeat.iter_mut().for_each(|repeat| repeat.limit = None)), "a loop around nothing");
    assert!(refused(&|p| {
        let one = p.pool.constant(Value::Int(1), Type::Int);
        let n = variable(p, Role::Input, Type::Int);
        let read = p.pool.variable(n, Type::Int);
        p.steps[0].active = p.pool.compare(Comparison::Equal, read, one);
    }));
}

#[test]
fn a_division_stands_in_no_formula() {
    let check = |make: fn(&mut Pool, FormulaId) -> (FormulaId, FormulaId)| {
        let (mut program, division) = division(Type::Int, false, make);
        program.after = vec![Statement::Divide(division)];
        verify(&program)
    };
    assert_eq!(check(|_, n| (n, n)), Ok(()));
    assert!(check(|pool, n| (n, pool.constant(Value::Int(3), Type::Int))).is_err(), "it divides inside a formula");
    assert!(check(|pool, n| (n, pool.negate(n))).is_err(), "read more than once");
    let (mut program, mut division) = division(Type::Int, false, |_, n| (n, n));
    division.flag = division.target;
    program.after = vec![Statement::Divide(division)];
    assert!(verify(&program).is_err(), "raises no DIV0");
}

/// A program with two steps, and two transitions around them of which one has a name.
fn drawn() -> Program {
    let mut p = whole();
    let x = bit(&mut p, Role::Step);
    let comment = Some("it waits".into());
    p.steps.push(Step { label: "Wait".into(), comment, span: Span::default(), held: Held::Bit(x.0), active: x.1 });
    let [one, wait] = [0, 1].map(StepId::new);
    p.elements.transition(None, None, Span::default(), &[one, wait], &[]);
    p.elements.transition(Some("T2".into()), Some("off it goes".into()), Span::default(), &[wait], &[one]);
    p
}

#[test]
fn what_is_said_beside_a_statement() {
    let program = drawn();
    let remark = |origin, told| program.remark(origin, told);
    let [one, wait] = [0, 1].map(|s| Origin::Step(StepId::new(s)));
    let [join, back] = [0, 1].map(|t| Origin::Transition(TransitionId::new(t)));
    assert_eq!(remark(one, Told::All).as_deref(), Some("step 1"));
    assert_eq!(remark(wait, Told::Name).as_deref(), Some("step Wait"));
    assert_eq!(remark(wait, Told::All).as_deref(), Some("step Wait: it waits"));
    assert_eq!(remark(join, Told::All).as_deref(), Some("1, Wait ->"));
    assert_eq!(remark(back, Told::All).as_deref(), Some("Wait -> 1: off it goes"));
    assert_eq!(remark(back, Told::Nothing), None);
    assert_eq!(remark(Origin::Chart, Told::All), None);
}

#[test]
fn variables_come_from_what_writes_them_first() {
    let mut p = drawn();
    let (memory, read) = bit(&mut p, Role::Memory);
    let (clearing, cleared) = bit(&mut p, Role::Temporary);
    let (flag, _) = bit(&mut p, Role::Flag(Flag::AllocConflict));
    let back = Origin::Transition(TransitionId::new(1));
    p.micro_step = vec![
        Statement::assign(back, clearing, read),
        Statement::assign(Origin::Chart, memory, cleared),
        Statement::assign(Origin::Step(StepId::new(0)), memory, cleared),
        Statement::assign(back, flag, cleared),
    ];
    let origins = p.origins();
    assert_eq!(origins.variables[clearing], back);
    assert_eq!(origins.variables[memory], Origin::Step(StepId::new(0)));
    assert_eq!(origins.variables[flag], Origin::Chart, "whatever raises it");
    let Held::Bit(x) = p.steps[1].held else { panic!("a bit") };
    assert_eq!(origins.variables[x], Origin::Step(StepId::new(1)));
    assert_eq!(verify(&p), Ok(()));
    p.micro_step.push(Statement::assign(Origin::Transition(TransitionId::new(2)), memory, cleared));
    assert!(verify(&p).is_err(), "there is no third transition");
}
