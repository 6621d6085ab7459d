//! Constants at the edges of each type: what leaves the type is an error of `check`, what stays in it is the same number
//! in the simulator, in every encoding and target, and for the compilers that are at hand.
//!
//! What an expression is worth is computed here: whole numbers and times exactly, real numbers with one rounding (IEEE
//! 754) to the width of the type.

use grafc::{Options, Product};
use grafc_backends::Target;
use grafc_backends::choice::Chosen;
use grafc_diagnostics::{Code, FileId};
use grafc_logic::{Encoding, Options as Lowering};
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::{Profile, Stimulus};
use grafc_testsuite::charts::check;
use grafc_testsuite::differential::long_run::is_wrong;
use grafc_testsuite::executors::{Outcome, Task, all, is_here_or_skip};
use grafc_testsuite::runs::simulate;
use grafc_testsuite::share::is_thorough;
use std::fmt::Write as _;

/// In the names of charts with numbers beyond the range of `real`.
const FAR: &str = "_far";

/// Outputs of one chart: more would be too many for the smallest of the targets.
const A_CHART: usize = 60;

const WHOLE: [&str; 5] = ["+", "-", "*", "/", "mod"];
const REAL: [&str; 4] = ["+", "-", "*", "/"];

/// A literal as charts have it, and its value.
type Literal = (String, Value);

/// An expression, and its value; none where it leaves its type.
struct Expression {
    text: String,
    value: Option<Value>,
    /// Whether it or a part of it is beyond the range of `real`.
    is_far: bool,
}

/// Whether a number is too large for `real`, or too small for its full precision.
fn is_far(value: Value) -> bool {
    match value {
        Value::Real(number) => {
            let size = number.abs();
            size > f64::from(f32::MAX) || (size != 0.0 && size < f64::from(f32::MIN_POSITIVE))
        }
        Value::Bool(_) | Value::Int(_) | Value::Time(_) => false,
    }
}

/// Literals at the edges of a type.
fn literals(ty: Type) -> Vec<Literal> {
    let whole = |numbers: &[i64]| numbers.iter().map(|n| (n.to_string(), Value::Int(*n))).collect();
    match ty {
        Type::Int => whole(&[-32768, -32767, -2, -1, 0, 1, 2, 181, 182, 32766, 32767]),
        Type::Uint => whole(&[0, 1, 2, 255, 256, 257, 65534, 65535]),
        Type::Dint => whole(&[-2147483648, -2147483647, -1, 0, 1, 2, 46340, 46341, 2147483646, 2147483647]),
        Type::Udint => whole(&[0, 1, 2, 65535, 65536, 65537, 4294967294, 4294967295]),
        Type::Real => {
            let texts = [
                "0.0",
                "1.0",
                "-1.0",
                "0.1",
                "16777216.0",
                "1.8446743E19",
                "1.0E38",
                "3.4028235E38",
                "-3.4028235E38",
                "1.17549435E-38",
            ];
            texts
                .iter()
                .map(|t| ((*t).to_string(), Value::Real(f64::from(t.parse::<f32>().expect("a number")))))
                .collect()
        }
        Type::Lreal => {
            let texts = [
                "0.0",
                "1.0",
                "-1.0",
                "0.1",
                "9007199254740992.0",
                "1.3407807929942596E154",
                "1.0E308",
                "1.7976931348623157E308",
                "-1.7976931348623157E308",
                "2.2250738585072014E-308",
            ];
            texts.iter().map(|t| ((*t).to_string(), Value::Real(t.parse().expect("a number")))).collect()
        }
        Type::Time => [0, 1, 1000, 86_400_000, 2_147_483_646, 2_147_483_647]
            .iter()
            .map(|ms| (format!("{ms}ms"), Value::Time(*ms)))
            .collect(),
        Type::Bool => Vec::new(),
    }
}

/// The range of the whole numbers of a type.
fn range(ty: Type) -> std::ops::RangeInclusive<i128> {
    match ty {
        Type::Int => -32768..=32767,
        Type::Uint => 0..=65535,
        Type::Dint | Type::Time => -2147483648..=2147483647,
        Type::Udint => 0..=4294967295,
        Type::Bool | Type::Real | Type::Lreal => panic!("no whole numbers"),
    }
}

/// What two numbers of a type make; `None` for a division by zero, which is not an error and not asked here.
fn worth(ty: Type, operator: &str, a: Value, b: Value) -> Option<Option<Value>> {
    let of_whole = |a: i64, b: i64| {
        let (a, b) = (i128::from(a), i128::from(b));
        let exact = match operator {
            "+" => a + b,
            "-" => a - b,
            "*" => a * b,
            "/" => a.checked_div(b)?,
            _ => a.checked_rem(b)?,
        };
        Some(range(ty).contains(&exact).then_some(exact as i64))
    };
    match (a, b) {
        (Value::Int(a), Value::Int(b)) => of_whole(a, b).map(|value| value.map(Value::Int)),
        (Value::Time(a), Value::Time(b)) => of_whole(a, b).map(|value| value.map(Value::Time)),
        (Value::Real(_), Value::Real(0.0)) if operator == "/" => None,
        (Value::Real(a), Value::Real(b)) if ty == Type::Real => {
            let (a, b) = (a as f32, b as f32);
            let result = match operator {
                "+" => a + b,
                "-" => a - b,
                "*" => a * b,
                _ => a / b,
            };
            Some(result.is_finite().then(|| Value::Real(f64::from(result))))
        }
        (Value::Real(a), Value::Real(b)) => {
            let result = match operator {
                "+" => a + b,
                "-" => a - b,
                "*" => a * b,
                _ => a / b,
            };
            Some(result.is_finite().then_some(Value::Real(result)))
        }
        _ => panic!("two numbers of one type"),
    }
}

/// Each operation of each two literals of a type.
fn expressions(ty: Type) -> Vec<Expression> {
    let literals = literals(ty);
    let operators: &[&str] = match ty {
        Type::Real | Type::Lreal => &REAL,
        Type::Time => &["+", "-"],
        Type::Int | Type::Uint | Type::Dint | Type::Udint => &WHOLE,
        Type::Bool => &[],
    };
    let mut all = Vec::new();
    for (left, a) in &literals {
        for (right, b) in &literals {
            for operator in operators {
                let right = if right.starts_with('-') { format!("({right})") } else { right.clone() };
                if let Some(value) = worth(ty, operator, *a, *b) {
                    let is_far = [Some(*a), Some(*b), value].into_iter().flatten().any(is_far);
                    all.push(Expression { text: format!("{left} {operator} {right}"), value, is_far });
                }
            }
        }
    }
    all
}

const TYPES: [(Type, &str); 7] = [
    (Type::Int, "int"),
    (Type::Uint, "uint"),
    (Type::Dint, "dint"),
    (Type::Udint, "udint"),
    (Type::Real, "real"),
    (Type::Lreal, "lreal"),
    (Type::Time, "time"),
];

/// A chart that publishes each expression and compares it with an input.
fn chart(name: &str, expressions: &[&Expression]) -> String {
    let mut text = format!("input x : {name}\n");
    for index in 0..expressions.len() {
        let _ = writeln!(text, "output o{index} : {name}\noutput less{index} : bool");
    }
    text.push_str("initial step 1 {\n");
    for (index, expression) in expressions.iter().enumerate() {
        let _ = writeln!(text, "o{index} := {} on activation", expression.text);
        let _ = writeln!(text, "less{index} if [x < {}]", expression.text);
    }
    text + "}\n"
}

#[test]
fn what_leaves_its_type_is_an_error_of_check() {
    // A long time is for the targets to refuse (E0505).
    for (ty, name) in TYPES.into_iter().filter(|(ty, _)| *ty != Type::Time) {
        let outside: Vec<Expression> = expressions(ty).into_iter().filter(|e| e.value.is_none()).collect();
        assert!(outside.len() >= 10, "{name}: {} expressions", outside.len());
        for expression in outside {
            let text = format!("input x : {name} output o : bool initial step 1 {{ o if [x < {}] }}", expression.text);
            let (tree, diagnostics) = grafc_syntax::parse(FileId::new(0), &text);
            assert!(!diagnostics.has_errors(), "{text}");
            let (chart, diagnostics) = grafc_model::check(&tree, "edges");
            let codes: Vec<Code> = diagnostics.iter().map(|one| one.code).collect();
            assert!(chart.is_none() && codes == [Code::E0210], "{text}: {codes:?}");
        }
    }
}

#[test]
fn what_stays_in_its_type_is_the_same_number_everywhere() {
    let mut charts = Vec::new();
    for (ty, name) in TYPES {
        let all = expressions(ty);
        let inside = all.iter().filter(|e| e.value.is_some());
        let (far, near): (Vec<&Expression>, Vec<&Expression>) = inside.partition(|e| ty == Type::Lreal && e.is_far);
        assert!(near.len() >= 20 && (ty != Type::Lreal || far.len() >= 20), "{name}: {} and {}", near.len(), far.len());
        let least = literals(ty)[0].1;
        let parts = near.chunks(A_CHART).map(|some| ("", some)).chain(far.chunks(A_CHART).map(|some| (FAR, some)));
        for (index, (word, some)) in parts.enumerate() {
            let text = chart(name, some);
            let chart =
                check(&format!("edges_{name}{word}_{index}"), &text).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
            let stimuli = vec![Stimulus { t_ms: 0, restart: false, inputs: vec![least] }; 2];
            let responses = simulate(&chart, Profile::default(), &stimuli);
            for (expression, outputs) in some.iter().zip(responses[1].outputs.chunks(2)) {
                assert_eq!(Some(outputs[0]), expression.value, "{}", expression.text);
            }
            no_text_holds_what_is_not_finite(&text, charts.len());
            charts.push((chart, stimuli, responses));
        }
    }
    let tasks: Vec<Task> = (charts.iter().enumerate())
        .map(|(turn, (chart, stimuli, _))| Task { chart, profile: Profile::default(), stimuli, turn })
        .collect();
    for (place, executor) in all().iter().enumerate().filter(|(_, executor)| is_here_or_skip(executor.as_ref())) {
        // What costs seconds is asked of a third, each of another one; or of a ninth.
        let parts = if is_thorough() { 3 } else { 9 };
        let is_asked = |index: &usize| !executor.is_external() || (index + place) % parts == 0;
        let asked: Vec<usize> = (0..charts.len()).filter(is_asked).collect();
        let given: Vec<Task> = asked.iter().map(|index| tasks[*index]).collect();
        for (index, outcome) in asked.into_iter().zip(executor.run(&given)) {
            let (chart, _, expected) = &charts[index];
            // MATIEC reads the literals of all types by `strtof` (a comparison of names in its preprocessor is always
            // true) and finds no type for what that cannot hold.
            if executor.name().starts_with("matiec")
                && chart.name.contains(FAR)
                && matches!(&outcome, Outcome::Failed(fault) if fault.to_lowercase().contains("data type"))
            {
                continue;
            }
            if is_wrong(executor.as_ref(), expected, &outcome) {
                let fault = if let Outcome::Failed(fault) = outcome { fault } else { "another number".to_string() };
                panic!("{}: {}: {fault}", chart.name, executor.name());
            }
        }
    }
}

/// No target has a literal for infinity, and none of these charts comes to one. How a number is written no encoding decides:
/// they take turns.
fn no_text_holds_what_is_not_finite(text: &str, turn: usize) {
    for (place, about) in Target::ALL.iter().enumerate() {
        let target = about.target(&Chosen::new()).expect("a target with what is usual");
        let encoding = Encoding::ALL[(turn + place) % Encoding::ALL.len()];
        let options = Options::new(Lowering { encoding, ..Lowering::default() }, Product::Code(target));
        // A target may refuse a type that its controllers lack.
        let (Some(output), _) = grafc::compile(FileId::new(0), text, "edges", &options) else { continue };
        for word in output.text.split(|c: char| !c.is_alphanumeric()) {
            assert!(!["inf", "nan", "infinity"].contains(&word.to_lowercase().as_str()), "{}: {word}", about.name);
        }
    }
}
