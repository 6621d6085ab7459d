//! The laws that the constructors of formulas apply, and no others.

use grafc_formula::{Comparison, Formula, FormulaId, Pool, Type, Value};
use grafc_logic::scan::VarId;
use rustc_hash::FxHashMap;

fn pool() -> (Pool, FormulaId, FormulaId, FormulaId) {
    let mut pool = Pool::default();
    let [a, b, c] = [0, 1, 2].map(|v| pool.variable(VarId::new(v), Type::Bool));
    (pool, a, b, c)
}

#[test]
fn equal_formulas_are_one() {
    let (mut pool, a, b, _) = pool();
    assert_eq!(pool.and([a, b]), pool.and([a, b]));
    assert_ne!(pool.and([a, b]), pool.and([b, a]), "the order of the author is kept");
    let (zero, minus) = (pool.constant(Value::Real(0.0), Type::Real), pool.constant(Value::Real(-0.0), Type::Real));
    assert_ne!(zero, minus);
}

#[test]
fn constants_and_repetitions_go() {
    let (mut pool, a, b, _) = pool();
    let (yes, no) = (pool.truth(true), pool.truth(false));
    let not_a = pool.not(a);
    assert_eq!(pool.and([yes, a]), a);
    assert_eq!(pool.or([no, a, a]), a);
    assert_eq!(pool.and([a, no, b]), no);
    assert_eq!(pool.or([]), no);
    assert_eq!(pool.and([]), yes);
    assert_eq!(pool.not(not_a), a);
    assert_eq!(pool.and([a, b, not_a]), no);
    assert_eq!(pool.or([not_a, b, a]), yes);
    assert_eq!(pool.xor(a, a), no);
    assert_eq!(pool.xor(a, yes), not_a);
}

#[test]
fn chains_are_flat_and_mixtures_stay() {
    let (mut pool, a, b, c) = pool();
    let ab = pool.and([a, b]);
    let abc = pool.and([ab, c]);
    let Formula::And(list) = pool.get(abc) else { panic!("a conjunction") };
    assert_eq!(pool.list(*list), [a, b, c]);
    let mixed = pool.or([ab, c]);
    let Formula::Or(list) = pool.get(mixed) else { panic!("a disjunction") };
    assert_eq!(pool.list(*list), [ab, c]);
    assert_eq!(pool.depth(mixed), 2);
}

#[test]
fn numbers_that_are_none_do_not_differ() {
    let mut pool = Pool::default();
    let [x, y] = [0, 1].map(|v| pool.variable(VarId::new(v), Type::Lreal));
    let differs = pool.differs(x, y);
    let Formula::And(terms) = pool.get(differs) else { panic!("a conjunction") };
    assert_eq!(pool.get(pool.list(*terms)[0]), &Formula::Compare(Comparison::NotEqual, [x, y]));
    let [m, n] = [2, 3].map(|v| pool.variable(VarId::new(v), Type::Int));
    let differs = pool.differs(m, n);
    assert_eq!(pool.get(differs), &Formula::Compare(Comparison::NotEqual, [m, n]));
}

#[test]
fn substitution_simplifies_on_the_way() {
    let (mut pool, a, b, c) = pool();
    let not_b = pool.not(b);
    let left = pool.and([a, not_b]);
    let formula = pool.or([left, c]);
    let yes = pool.truth(true);
    let by = FxHashMap::from_iter([(VarId::new(1), yes)]);
    assert_eq!(pool.substitute(formula, &by), c);
}

#[test]
fn constants_are_computed_at_the_width_of_their_type() {
    let mut pool = Pool::default();
    let mut fold = |op, ty, a, b| {
        let (a, b) = (pool.constant(Value::Int(a), ty), pool.constant(Value::Int(b), ty));
        let result = pool.arithmetic(op, ty, a, b);
        pool.as_constant(result)
    };
    use grafc_formula::Arithmetic::{Add, Divide, Modulo, Multiply, Subtract};
    assert_eq!(fold(Subtract, Type::Udint, 1, 3), Some(Value::Int(4_294_967_294)));
    assert_eq!(fold(Add, Type::Int, 32_767, 1), Some(Value::Int(-32_768)));
    assert_eq!(fold(Multiply, Type::Dint, 65_536, 65_536), Some(Value::Int(0)));
    assert_eq!(fold(Divide, Type::Int, -7, 2), Some(Value::Int(-3)));
    assert_eq!(fold(Modulo, Type::Int, -7, 2), Some(Value::Int(-1)));
}
