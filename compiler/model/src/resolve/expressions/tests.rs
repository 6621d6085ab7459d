use crate::chart::{Chart, ExprId, ExprKind, Value};
use crate::checks::testing::{breaks, chart, help, passes};

const VARIABLES: &str = "input a, b : bool input n : int input d : dint input u : uint input w : udint input r : real
                         input l : lreal input t : time const delay : time := 5s
                         initial step 1 step 9 ";

fn with(condition: &str) -> String {
    format!("{VARIABLES} transition 1 -> 9 : {condition}")
}

/// The condition as it stands in the pool, fully parenthesised.
fn shape(condition: &str) -> String {
    let chart = chart(&with(condition));
    print(&chart, chart.transitions.last().expect("there is a transition").condition)
}

/// Only for expressions that tests write, which are not deep.
fn print(chart: &Chart, id: ExprId) -> String {
    let expr = &chart.exprs[id];
    let sub = |id| print(chart, id);
    match &expr.kind {
        ExprKind::Literal(Value::Bool(value)) => value.to_string(),
        ExprKind::Literal(Value::Int(value)) => format!("{value}:{:?}", expr.ty),
        ExprKind::Literal(Value::Real(value)) => format!("{value:?}:{:?}", expr.ty),
        ExprKind::Literal(Value::Time(value)) => format!("{value}ms"),
        ExprKind::Variable(id) => chart.variables[*id].name.to_string(),
        ExprKind::StepActive(id) => format!("X{}", chart.steps[*id].label),
        ExprKind::StepTime(id) => format!("T{}", chart.steps[*id].label),
        ExprKind::MacroActive(id) => format!("X{}", chart.macro_steps[*id].label),
        ExprKind::GrafcetActive(id) => format!("X{}", chart.grafcets[*id].name),
        ExprKind::GrafcetFrozen(id) => format!("F{}", chart.grafcets[*id].name),
        ExprKind::Not(e) => format!("not {}", sub(*e)),
        ExprKind::And(e, f) => format!("({} and {})", sub(*e), sub(*f)),
        ExprKind::Or(e, f) => format!("({} or {})", sub(*e), sub(*f)),
        ExprKind::Xor(e, f) => format!("({} xor {})", sub(*e), sub(*f)),
        ExprKind::Rise(e) => format!("rise {}", sub(*e)),
        ExprKind::Fall(e) => format!("fall {}", sub(*e)),
        ExprKind::Delay { on, operand, off } => format!("{}/{}/{}", on.ms, sub(*operand), off.ms),
        ExprKind::Compare(op, e, f) => format!("{op:?}({}, {})", sub(*e), sub(*f)),
        ExprKind::Arithmetic(op, e, f) => format!("{op:?}:{:?}({}, {})", expr.ty, sub(*e), sub(*f)),
        ExprKind::Negate(e) => format!("-{}", sub(*e)),
        ExprKind::Widen(e) => format!("{:?}({})", expr.ty, sub(*e)),
    }
}

#[test]
fn conditions() {
    assert_eq!(shape("a and not b or 1"), "((a and not b) or true)");
    assert_eq!(shape("↑(a + b) · XG1"), "(rise (a or b) and XG1)");
    assert_eq!(shape("↓X1 xor (0)"), "(fall X1 xor false)");
}

#[test]
fn literals_adapt_to_what_they_meet() {
    assert_eq!(shape("[n < 3]"), "Less(n, 3:Int)");
    assert_eq!(shape("[3 < u]"), "Less(3:Uint, u)");
    assert_eq!(shape("[r = 3]"), "Equal(r, 3.0:Real)");
    assert_eq!(shape("[l > 8.5]"), "Greater(l, 8.5:Lreal)");
    assert_eq!(shape("[n > -32768]"), "Greater(n, -32768:Int)");
    assert_eq!(shape("[n > 2 * 3 + 1]"), "Greater(n, Add:Int(Multiply:Int(2:Int, 3:Int), 1:Int))");
    assert_eq!(shape("[1 < 2]"), "Less(1:Dint, 2:Dint)");
    assert_eq!(shape("[1 < 2.5]"), "Less(1.0:Lreal, 2.5:Lreal)");
}

#[test]
fn values_widen_without_loss() {
    assert_eq!(shape("[n < d]"), "Less(Dint(n), d)");
    assert_eq!(shape("[n <> u]"), "NotEqual(Dint(n), Dint(u))");
    assert_eq!(shape("[r <= d]"), "LessEqual(Lreal(r), Lreal(d))");
    assert_eq!(shape("[d >= w]"), "GreaterEqual(Lreal(d), Lreal(w))");
    assert_eq!(shape("[n + 1 > d]"), "Greater(Dint(Add:Int(n, 1:Int)), d)");
    assert_eq!(shape("[n + d * 2 = 0]"), "Equal(Add:Dint(Dint(n), Multiply:Dint(d, 2:Dint)), 0:Dint)");
}

#[test]
fn conditions_are_compared_without_a_comparison() {
    assert_eq!(shape("[a = b]"), "not (a xor b)");
    assert_eq!(shape("[a <> 1]"), "(a xor true)");
}

#[test]
fn times() {
    assert_eq!(shape("[T1 >= 5s]"), "GreaterEqual(T1, 5000ms)");
    assert_eq!(
        shape("[t + 2s > 3 * t - n * t / 2]"),
        "Greater(Add:Time(t, 2000ms), Subtract:Time(Multiply:Time(3:Dint, t), Divide:Time(Multiply:Time(n, t), 2:Dint)))"
    );
    assert_eq!(shape("[-t < delay]"), "Less(-t, delay)");
}

#[test]
fn delays() {
    assert_eq!(shape("3s/a/7s"), "3000/a/7000");
    assert_eq!(shape("4s/X1"), "4000/X1/0");
    assert_eq!(shape("X1/500ms"), "0/X1/500");
    assert_eq!(shape("delay/X9"), "5000/X9/0");
    assert_eq!(shape("3s/(a and 2s/b)"), "3000/(a and 2000/b/0)/0");
}

#[test]
fn what_is_no_condition() {
    for condition in ["n", "2", "a and T1", "not n", "↑d", "3s/r", "[n]", "[n + 1]", "8.5", "5s", "[-1]"] {
        breaks("E0206", &with(condition));
    }
    passes(&with("1"));
    passes(&with("true and not 0"));
}

#[test]
fn types_that_do_not_meet() {
    for condition in [
        "[a > b]",
        "[a = n]",
        "[a = 2]",
        "[n = 8.5]",
        "[n > 3s]",
        "[t > 3]",
        "[t * t > 3s]",
        "[t / t > 1]",
        "[t mod 2 > 1s]",
        "[2 / t > 1s]",
        "[t * r > 1s]",
        "[d + w > 1]",
        "[n / w > 1]",
        "[r mod 2 > 1]",
        "[-u < 1]",
        "[-a = b]",
        "[n + a > 1]",
    ] {
        breaks("E0205", &with(condition));
    }
}

#[test]
fn literals_out_of_range() {
    for condition in ["[n > 32768]", "[n > -32769]", "[u > -1]", "[w < 4294967296]", "[1 < 4294967296]"] {
        breaks("E0210", &with(condition));
    }
}

#[test]
fn what_is_no_delay() {
    for condition in ["a/b", "3s/5s", "t/a", "3s/a/b", "a/3s/b", "X1/X9", "X1/G1", "XG1/X9"] {
        breaks("E0209", &with(condition));
    }
    assert_eq!(help(&with("X1/X9")).as_deref(), Some("write `X9`"));
    assert_eq!(help(&with("X1/G1")).as_deref(), Some("write `XG1`"));
    breaks("E0210", "const back : time := 1s - 2s initial step 1 transition 1 -> 1 : back/X1");
}

#[test]
fn one_fault_is_reported_once() {
    breaks("E0201", &with("[nope + 1 > 3s] and a"));
    breaks("E0205", &with("[(n + a) * 3 > t]"));
    breaks("E0201", &with("↑(not nope) and 3s/(a or b)"));
}
