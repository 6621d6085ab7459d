//! Pairs of conditions, each with a valuation under which both hold or the reason why there is none.

use super::Analysis;
use crate::lower::Lowering;
use crate::scan::{Role, VarId};
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_formula::exclusion::EdgeFacts;
use grafc_formula::{Comparison, Formula, FormulaId, Pool, Type, Value};
use grafc_model::chart::TransitionId;

const VARIABLES: &str = "input a, b, c, d : bool  input n, m : dint  input r, q : real  input s : lreal
    var k : dint  var w : bool  const limit : dint := 7";

/// Asks `question` about two conditions.
fn ask(x: &str, y: &str, question: impl Fn(&EdgeFacts, &Lowering, FormulaId, FormulaId) -> bool) -> bool {
    let text = format!(
        "{VARIABLES}
         initial step 1  step 2 {{ k := n on activation  w := a on activation }}  step 3
         transition 1 -> 2 : {x}  transition 1 -> 3 : {y}"
    );
    let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), &text);
    assert!(!diagnostics.has_errors(), "{text}\n{diagnostics:?}");
    let (chart, diagnostics) = grafc_model::check(&tree, "chart");
    let mut net = grafc_net::build(&chart.unwrap_or_else(|| panic!("{text}\n{diagnostics:?}")));
    grafc_net::passes::run(&mut net, false, &mut Diagnostics::new());
    let Analysis { conditions, facts, .. } = Analysis::new(net);
    let (first, second) = (TransitionId::from_usize(0), TransitionId::from_usize(1));
    question(&facts, &conditions.lowering, conditions.of_transition[first], conditions.of_transition[second])
}

fn exclude(x: &str, y: &str) -> bool {
    let ask = |x: &str, y: &str| ask(x, y, |facts, lowering, a, b| facts.exclude(&lowering.pool, a, b));
    let (one, other) = (ask(x, y), ask(y, x));
    assert_eq!(one, other, "{x} and {y} exclude each other either way round or not at all");
    one
}

/// Whether `x` in one micro-step excludes `y` in a later one: inputs and constants are stable.
fn exclude_later(x: &str, y: &str) -> bool {
    ask(x, y, |facts, lowering, a, b| {
        let stable = |v: VarId| matches!(lowering.symbols.table[v].role, Role::Input | Role::Constant);
        facts.exclude_later(&lowering.pool, a, b, &stable)
    })
}

#[test]
fn factors_that_contradict() {
    assert!(exclude("a and b", "c and not a"));
    assert!(exclude("0", "a"));
    assert!(!exclude("a", "b"));
    assert!(!exclude("a and b", "a and c"));
    assert!(!exclude("a", "a"));
}

#[test]
fn formulas_without_common_factors() {
    assert!(exclude("a and b", "not a or not b"), "De Morgan");
    assert!(exclude("a or b", "not (a or b) and c"));
    assert!(exclude("a xor b", "a and b"));
    assert!(exclude("a xor b", "not (a xor b)"));
    assert!(exclude("(a or b) and (not a or b)", "not b"), "resolution: b");
    assert!(exclude("a and b or c and d", "(not a or not b) and (not c or not d)"));
    assert!(!exclude("a or b", "not a or not b"), "a, not b");
    assert!(!exclude("a xor b", "a or b"), "a, not b");
    assert!(!exclude("a and b or c", "not a"), "c, not a");
}

#[test]
fn edges_say_what_their_operand_is() {
    assert!(exclude("↑a", "↓a"));
    assert!(exclude("↑a", "not a"));
    assert!(exclude("↓a", "a and b"));
    assert!(exclude("↑a or ↑b", "not a and not b"));
    assert!(exclude("↑a or ↓b", "not a and b"));
    assert!(!exclude("↑a", "↑b"), "inputs may change together");
    assert!(!exclude("↑a", "a"), "a rises");
    assert!(!exclude("↑a", "not ↑a and a or b"), "b");
    assert!(exclude("↑a", "not ↑a and a"));
    assert!(exclude("↑(a and b)", "not ↑(a and b)"));
}

#[test]
fn whole_numbers_lie_in_intervals() {
    assert!(exclude("[n < 3]", "[n >= 3]"));
    assert!(exclude("[n < 3]", "[n > 2]"), "no whole number lies between 2 and 3");
    assert!(exclude("[n = 3]", "[n = 4]"));
    assert!(exclude("[n <= 2]", "[n = 3]"));
    assert!(exclude("[3 > n]", "[n >= 3]"), "mirrored");
    assert!(exclude("[n >= 3]", "not [n > 2]"));
    assert!(exclude("[n > 1] and [n < 5]", "[n < 2] or [n > 4]"));
    assert!(exclude("[n > 1] and [n < 5]", "[n <> 2] and [n <> 3] and [n <> 4]"), "2, 3 and 4 are all between");
    assert!(!exclude("[n < 3]", "[n < 4]"), "2");
    assert!(!exclude("[n <= 3]", "[n >= 3]"), "3");
    assert!(!exclude("[n > 1] and [n < 5]", "[n <> 2] and [n <> 4]"), "3");
    assert!(!exclude("[n < 3]", "[m >= 3]"), "two variables");
    assert!(exclude("[k < limit]", "[k >= limit]"), "a variable and a constant");
    assert!(exclude("[T1 < 3s]", "[T1 >= 3000ms]"), "times");
    assert!(!exclude("[T1 > 2s]", "[T1 < 3s]"), "2500ms");
}

#[test]
fn two_operands_are_compared_like_one() {
    assert!(exclude("[n < m]", "[n >= m]"));
    assert!(exclude("[n < m]", "[m < n]"));
    assert!(exclude("[n <= m] and [n >= m]", "[n <> m]"));
    assert!(exclude("[n < m] or [n > m]", "[n = m]"));
    assert!(!exclude("[n <= m]", "[n >= m]"), "equal");
    assert!(!exclude("[n <> m]", "[n > m]"));
}

#[test]
fn a_real_may_be_no_number() {
    assert!(exclude("[r < 3.0]", "[r >= 3.0]"));
    assert!(exclude("[r < 3.0]", "[r > 4.0]"));
    assert!(exclude("[r = 3.0]", "[r = 4.0]"));
    assert!(exclude("[r = 3.0]", "[r <> 3.0]"));
    assert!(!exclude("[r < 3.0]", "[r > 2.0]"), "2.5");
    assert!(!exclude("not [r < 3.0]", "not [r >= 3.0]"), "no number is neither");
    assert!(!exclude("not [r < q]", "not [r >= q]"), "no number is neither");
    assert!(exclude("[r < q]", "[r >= q]"));
    assert!(!exclude("[r <> 3.0] and [r <> 4.0]", "not [r < 3.0] and not [r > 3.0]"), "no number");
    assert!(exclude("[r = 3.0]", "not [r < 4.0]"));
    assert!(!exclude("[r = 0.1]", "[r = 0.10000000001]"), "the same single");
    assert!(exclude("[s = 0.1]", "[s = 0.10000000001]"), "different doubles");
    assert!(!exclude("[r >= 0.0]", "[r <= -0.0]"), "0 and -0 are equal");
}

#[test]
fn large_conditions_are_compared_by_their_factors_only() {
    let names = (0..150).map(|i| format!("[n = {}]", 2 * i)).collect::<Vec<_>>();
    let large = names.join(" or ");
    assert!(!exclude(&format!("({large}) and b"), "[n = 1]"), "too much work");
    assert!(exclude(&format!("({large}) and b"), "not b"), "still in plain sight");
}

/// What each of many exits of one step waits for: its own input, and that none of those before has come.
fn chain(count: usize, own: impl Fn(usize) -> String) -> Vec<String> {
    let denied = |i: usize| (0..i).map(|j| format!(" and not ({})", own(j))).collect::<String>();
    (0..count).map(|i| format!("({}){}", own(i), denied(i))).collect()
}

/// The first pair of exits that is not proved to exclude each other.
fn not_exclusive(exits: &[String]) -> Option<(usize, usize)> {
    let count = exits.len();
    let inputs: Vec<String> = (0..count).flat_map(|i| [format!("a{i}"), format!("b{i}")]).collect();
    let mut text = format!("input {}, m : bool  input n : dint\ninitial step 0\n", inputs.join(", "));
    for (i, exit) in exits.iter().enumerate() {
        text += &format!("step {}\ntransition 0 -> {} : {exit}\n", i + 1, i + 1);
    }
    let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), &text);
    assert!(!diagnostics.has_errors(), "{text}\n{diagnostics:?}");
    let (chart, diagnostics) = grafc_model::check(&tree, "chart");
    let mut net = grafc_net::build(&chart.unwrap_or_else(|| panic!("{text}\n{diagnostics:?}")));
    grafc_net::passes::run(&mut net, false, &mut Diagnostics::new());
    let analysis = Analysis::new(net);
    let clash = analysis.together().clearings.first()?.pairs.first()?;
    Some((clash.first.index(), clash.second.index()))
}

#[test]
fn chains_of_priorities_are_exclusive_however_long_they_are() {
    for count in [2, 17, 46, 64, 65, 128, 129, 200] {
        assert_eq!(not_exclusive(&chain(count, |i| format!("a{i}"))), None, "{count} inputs");
        assert_eq!(not_exclusive(&chain(count, |i| format!("a{i} or b{i}"))), None, "{count} disjunctions");
        assert_eq!(not_exclusive(&chain(count, |i| format!("m and a{i}"))), None, "{count} with a common factor");
        assert_eq!(not_exclusive(&chain(count, |i| format!("a{i} and not b{i}"))), None, "{count} conjunctions");
        assert_eq!(not_exclusive(&chain(count, |i| format!("↑a{i}"))), None, "{count} edges");
        let intervals: Vec<String> = (0..count).map(|i| format!("[n >= {}] and [n < {}]", 3 * i, 3 * i + 3)).collect();
        assert_eq!(not_exclusive(&intervals), None, "{count} intervals");
    }
    // The last has been forgotten to wait for the first.
    let mut forgotten = chain(60, |i| format!("a{i}"));
    forgotten[59] = forgotten[59].replace(" and not (a0)", "");
    assert_eq!(not_exclusive(&forgotten), Some((0, 59)));
}

#[test]
fn factors_that_have_nothing_to_do_with_each_other_are_proved_apart() {
    // Together they have more atoms than a decision diagram may.
    let pairs: Vec<String> = (0..40).map(|i| format!("([n = {i}] xor [m > {i}])")).collect();
    let many = |name: &str| format!("({}) and ({name} xor a)", pairs.join(" and "));
    assert!(exclude(&many("b"), "not (b xor a) and d"));
    assert!(!exclude(&many("b"), "(b xor a) and d"), "b, not a");
}

#[test]
fn what_holds_later_in_the_reaction() {
    assert!(exclude_later("a", "not a"), "inputs do not change");
    assert!(exclude_later("a and w", "not a or not a and w"));
    assert!(!exclude_later("w", "not w"), "a stored variable does");
    assert!(!exclude_later("X1", "not X1"), "and so does activity");
    assert!(!exclude_later("3s/a", "not 3s/a"), "and so may a timer");
    assert!(!exclude_later("[T1 < 3s]", "[T1 >= 3s]"), "a step that is activated again starts from 0");
    assert!(exclude_later("[n < 3]", "[n > 5]"));
    assert!(!exclude_later("[k < 3]", "[k > 5]"));
    assert!(!exclude_later("[n < k]", "[n >= k]"));
    assert!(!exclude_later("a or w", "not a"), "w, not a");
    assert!(exclude_later("(a or w) and (a or not w)", "not a"), "whatever w is");
    assert!(!exclude_later("a", "b"));
}

#[test]
fn edges_of_inputs_are_over_later() {
    assert!(exclude_later("a", "↑a"), "the edge was in the first micro-step");
    assert!(exclude_later("1", "↑a"));
    assert!(exclude_later("1", "↓a and b"));
    assert!(!exclude_later("↑a", "a"), "a stays true");
    assert!(exclude_later("↑a", "not a"));
    assert!(exclude_later("↓a", "a"));
    assert!(!exclude_later("1", "↑a or b"));
    assert!(!exclude_later("1", "↑w"), "w may rise later");
    assert!(!exclude_later("↑w", "not w"), "and fall again");
}

/// Boolean variables 0 and 1, a whole number 2 and a real 3 for comparisons with constants, whole numbers 4 and 5 for
/// comparisons with each other.
type Valuation = [Value; 6];

fn valuations() -> Vec<Valuation> {
    let truths = [Value::Bool(false), Value::Bool(true)];
    let mut all = Vec::new();
    for n in -1..=4 {
        for r in [f64::NAN, f64::NEG_INFINITY, -0.0, 0.5, 1.0, 1.5, 2.0, 3.0] {
            for difference in -1..=1 {
                for p in truths {
                    all.extend(
                        truths.map(|q| [p, q, Value::Int(n), Value::Real(r), Value::Int(0), Value::Int(difference)]),
                    );
                }
            }
        }
    }
    all
}

fn draw(pool: &mut Pool, random: &mut fastrand::Rng, depth: u32) -> FormulaId {
    use Comparison::*;
    let comparison = [Equal, NotEqual, Less, LessEqual, Greater, GreaterEqual][random.usize(..6)];
    let kind = if depth == 0 { random.u32(..4) } else { random.u32(..8) };
    match kind {
        0 => pool.variable(VarId::from_usize(random.usize(..2)), Type::Bool),
        1 => {
            let (n, c) = (pool.variable(VarId::from_usize(2), Type::Dint), Value::Int(random.i64(0..4)));
            let c = pool.constant(c, Type::Dint);
            if random.bool() { pool.compare(comparison, n, c) } else { pool.compare(comparison, c, n) }
        }
        2 => {
            let (r, c) = (pool.variable(VarId::from_usize(3), Type::Real), [0.0, 1.0, 2.0][random.usize(..3)]);
            let c = pool.constant(Value::Real(c), Type::Real);
            if random.bool() { pool.compare(comparison, r, c) } else { pool.compare(comparison, c, r) }
        }
        3 => {
            let pair = [4, 5].map(|v| pool.variable(VarId::from_usize(v), Type::Dint));
            let left = random.usize(..2);
            pool.compare(comparison, pair[left], pair[1 - left])
        }
        4 => {
            let a = draw(pool, random, depth - 1);
            pool.not(a)
        }
        5 => {
            let operands = [(); 3].map(|()| draw(pool, random, depth - 1));
            pool.and(operands)
        }
        6 => {
            let operands = [(); 3].map(|()| draw(pool, random, depth - 1));
            pool.or(operands)
        }
        _ => {
            let (a, b) = (draw(pool, random, depth - 1), draw(pool, random, depth - 1));
            pool.xor(a, b)
        }
    }
}

fn value(pool: &Pool, f: FormulaId, valuation: &Valuation) -> Value {
    let truth = |f: FormulaId| matches!(value(pool, f, valuation), Value::Bool(true));
    match pool.get(f) {
        Formula::Constant(c) => *c,
        Formula::Variable(v) => valuation[v.index()],
        Formula::Not(a) => Value::Bool(!truth(*a)),
        Formula::And(list) => Value::Bool(pool.list(*list).iter().all(|f| truth(*f))),
        Formula::Or(list) => Value::Bool(pool.list(*list).iter().any(|f| truth(*f))),
        Formula::Xor([a, b]) => Value::Bool(truth(*a) != truth(*b)),
        Formula::Compare(op, [a, b]) => {
            let order = match (value(pool, *a, valuation), value(pool, *b, valuation)) {
                (Value::Int(a), Value::Int(b)) => Some(a.cmp(&b)),
                (Value::Real(a), Value::Real(b)) => a.partial_cmp(&b),
                other => panic!("{other:?} are not drawn"),
            };
            Value::Bool(match op {
                Comparison::Equal => order.is_some_and(|o| o.is_eq()),
                Comparison::NotEqual => !order.is_some_and(|o| o.is_eq()),
                Comparison::Less => order.is_some_and(|o| o.is_lt()),
                Comparison::LessEqual => order.is_some_and(|o| o.is_le()),
                Comparison::Greater => order.is_some_and(|o| o.is_gt()),
                Comparison::GreaterEqual => order.is_some_and(|o| o.is_ge()),
            })
        }
        other => panic!("{other:?} is not drawn"),
    }
}

/// Exclusion is exactly that there is no model: the valuations have a value in each interval between the constants.
#[test]
fn exclusion_is_the_absence_of_a_model() {
    let (facts, valuations) = (EdgeFacts::new(&[]), valuations());
    let (mut yes, mut no) = (0, 0);
    for seed in 0..1_500 {
        let (mut pool, mut random) = (Pool::default(), fastrand::Rng::with_seed(seed));
        let a = draw(&mut pool, &mut random, 2);
        let b = draw(&mut pool, &mut random, 2);
        let holds = |f, valuation| matches!(value(&pool, f, valuation), Value::Bool(true));
        let models = |f| valuations.iter().filter(move |v| holds(f, v)).count();
        let common = valuations.iter().any(|v| holds(a, v) && holds(b, v));
        let excluded = facts.exclude(&pool, a, b);
        assert!(!(excluded && common), "seed {seed}: {:?} and {:?}", pool.get(a), pool.get(b));
        // Without a common variable nothing is proved of a condition that is never true by itself.
        if models(a) > 0 && models(b) > 0 {
            assert_eq!(excluded, !common, "seed {seed}: {:?} and {:?}", pool.get(a), pool.get(b));
            *(if excluded { &mut yes } else { &mut no }) += 1;
        }
    }
    assert!(yes > 50 && no > 1_000, "{yes} excluded, {no} not");
}
