//! Numbers, times, divisions.

use super::list;
use crate::st::tests::{Build, assign, body};
use grafc_formula::{Arithmetic, Comparison, FormulaId, Type, Value};
use grafc_logic::scan::{Division, Flag, Origin, Role, Statement};

#[test]
fn numbers() {
    let inputs = [
        ("n", Type::Int),
        ("dn", Type::Dint),
        ("wn", Type::Uint),
        ("lev", Type::Real),
        ("w", Type::Time),
        ("big", Type::Udint),
    ];
    let check = |ty: Type, build: fn(&mut Build, &[FormulaId]) -> FormulaId, expected: &str| {
        let program = body(&inputs, ty, |b, read, y| vec![assign(y, build(b, read))]);
        let store = if ty == Type::Bool { "= #y" } else { "T #y" };
        assert_eq!(list(&program), format!("{expected}, {store}"));
    };
    check(
        Type::Int,
        |b, i| {
            let five = b.pool().constant(Value::Int(-5), Type::Int);
            b.pool().arithmetic(Arithmetic::Subtract, Type::Int, five, i[0])
        },
        "L -5, L #n, -I",
    );
    check(Type::Int, |b, i| b.pool().negate(i[0]), "L #n, NEGI");
    check(Type::Real, |b, i| b.pool().negate(i[3]), "L #lev, NEGR");
    // An INT is extended with its sign before it meets 32 bits; a quotient of 16 bits is one of 32.
    check(
        Type::Dint,
        |b, i| {
            let wide = b.pool().widen(Type::Dint, i[0]);
            b.pool().arithmetic(Arithmetic::Multiply, Type::Dint, i[1], wide)
        },
        "L #dn, L #n, ITD, *D",
    );
    check(
        Type::Int,
        |b, i| {
            let seven = b.pool().constant(Value::Int(7), Type::Int);
            b.pool().arithmetic(Arithmetic::Modulo, Type::Int, i[0], seven)
        },
        "L #n, ITD, L L#7, MOD",
    );
    // A WORD is extended with zeros as it is loaded.
    check(
        Type::Real,
        |b, i| {
            let (wide, half) = (b.pool().widen(Type::Real, i[2]), b.pool().constant(Value::Real(0.5), Type::Real));
            b.pool().arithmetic(Arithmetic::Add, Type::Real, wide, half)
        },
        "L #wn, DTR, L 0.5, +R",
    );
    check(Type::Time, |b, i| b.pool().arithmetic(Arithmetic::Multiply, Type::Time, i[0], i[4]), "L #n, ITD, L #w, *D");
    check(
        Type::Bool,
        |b, i| {
            let long = b.pool().constant(Value::Time(90_000), Type::Time);
            b.pool().compare(Comparison::Less, i[4], long)
        },
        "L #w, L L#90000, <D",
    );
    check(
        Type::Bool,
        |b, i| {
            let limit = b.pool().constant(Value::Int(40_000), Type::Uint);
            b.pool().compare(Comparison::GreaterEqual, i[2], limit)
        },
        "L #wn, L L#40000, >=D",
    );
    // 3,000,000,000 without its highest bit is 852,516,352.
    check(
        Type::Bool,
        |b, i| {
            let limit = b.pool().constant(Value::Int(3_000_000_000), Type::Udint);
            b.pool().compare(Comparison::Less, i[5], limit)
        },
        "L #big, XOD DW#16#80000000, L L#852516352, <D",
    );
    // Of what is no number `<>R` is false, and so is its contrary.
    check(
        Type::Bool,
        |b, i| {
            let half = b.pool().constant(Value::Real(0.5), Type::Real);
            b.pool().compare(Comparison::NotEqual, i[3], half)
        },
        "L #lev, L 0.5, ==R, NOT",
    );
    check(
        Type::Bool,
        |b, i| {
            let half = b.pool().constant(Value::Real(0.5), Type::Real);
            let less = b.pool().compare(Comparison::Less, i[3], half);
            b.pool().not(less)
        },
        "L #lev, L 0.5, <R, NOT",
    );
    check(
        Type::Bool,
        |b, i| {
            let less = b.pool().compare(Comparison::Less, i[0], i[0]);
            let not = b.pool().not(less);
            let more = b.pool().compare(Comparison::Greater, i[1], i[1]);
            b.pool().and([not, more])
        },
        "L #n, L #n, >=I, A(, L #dn, L #dn, >D, )",
    );
}

#[test]
fn a_division_is_guarded() {
    let divide = |ty: Type, modulo: bool| {
        list(&body(&[("n", ty), ("k", ty)], ty, |b, i, target| {
            let flag = b.bit(Role::Flag(Flag::Div0), "DIV0");
            vec![Statement::Divide(Division {
                target,
                modulo,
                dividend: i[0],
                divisor: i[1],
                flag,
                origin: Origin::Chart,
            })]
        }))
    };
    assert_eq!(
        divide(Type::Int, false),
        "L #k, L 0, ==I, JCN M002, S #DIV0, L 0, JU M003, M002: L #n, ITD, L #k, ITD, /D, M003: T #y"
    );
    assert_eq!(
        divide(Type::Dint, true),
        "L #k, L L#0, ==D, JCN M002, S #DIV0, L L#0, JU M003, \
         M002: L #k, L L#-1, ==D, JCN M004, L L#0, JU M003, M004: L #n, L #k, MOD, M003: T #y"
    );
    assert_eq!(
        divide(Type::Real, false),
        "L #k, L 0.0, ==R, JCN M002, S #DIV0, L 0.0, JU M003, M002: L #n, L #k, /R, M003: T #y"
    );
    // Twice the quotient of the half, and one more if the rest is not less than the divisor.
    assert_eq!(
        divide(Type::Udint, false),
        "L #k, L L#0, ==D, JCN M002, S #DIV0, L L#0, JU M003, \
         M002: L #k, L L#0, <D, JC M004, \
         L #n, SRD 1, L #k, /D, SLD 1, T #number_1, L #k, *D, L #n, TAK, -D, T #number_2, JU M005, \
         M004: L L#0, T #number_1, L #n, T #number_2, \
         M005: L #number_2, XOD DW#16#80000000, L #k, XOD DW#16#80000000, <D, JC M006, \
         L #number_1, L L#1, +D, T #number_1, L #number_2, L #k, -D, T #number_2, \
         M006: L #number_1, M003: T #y"
    );
}
