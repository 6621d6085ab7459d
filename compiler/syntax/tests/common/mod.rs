//! What the tests and the fuzzer share.

#![allow(dead_code)]

use grafc_diagnostics::{Code, Diagnostics, FileId, apply};
use grafc_syntax::ast::{BinaryOp, Chart, ExprId, ExprKind, Item};

/// The chart of a text that has no faults.
pub fn chart(text: &str) -> Chart {
    let (chart, diagnostics) = grafc_syntax::parse(FileId::new(0), text);
    assert!(diagnostics.is_empty(), "{:#?}\n{text}", faults_of(text, &diagnostics));
    chart
}

/// The faults of a text, as `E0107 3:7-10 expected …`: line, first column and, if it is another, last column.
pub fn faults(text: &str) -> Vec<String> {
    let found = grafc_syntax::parse(FileId::new(0), text).1;
    try_fixes(text, &found);
    faults_of(text, &found)
}

/// Each fix takes away its fault, and brings no other.
fn try_fixes(text: &str, found: &Diagnostics) {
    let messages =
        |diagnostics: &Diagnostics| -> Vec<String> { diagnostics.iter().map(|d| d.message.clone()).collect() };
    for diagnostic in found {
        for fix in &diagnostic.fixes {
            let fixed =
                apply(FileId::new(0), text, &fix.edits).unwrap_or_else(|misfit| panic!("{misfit}: {fix:?}\n{text}"));
            let mut expected = messages(found);
            let of_it = expected.iter().position(|message| *message == diagnostic.message);
            expected.remove(of_it.expect("the message is among them"));
            for new in &grafc_syntax::parse(FileId::new(0), &fixed).1 {
                match expected.iter().position(|other| *other == new.message) {
                    Some(place) => _ = expected.remove(place),
                    // A wrong character that has become a word may stand where no word belongs.
                    None if diagnostic.code == Code::E0101 && new.code == Code::E0107 => {}
                    None => panic!("{fix:?} brings {:?}\n{text}\n{fixed}", new.message),
                }
            }
        }
    }
}

fn faults_of(text: &str, diagnostics: &Diagnostics) -> Vec<String> {
    let place = |at: u32| {
        let before = &text[..at as usize];
        let line_start = before.rfind('\n').map_or(0, |n| n + 1);
        (before.matches('\n').count() + 1, text[line_start..at as usize].chars().count() + 1)
    };
    diagnostics
        .iter()
        .map(|d| {
            let (line, column) = place(d.primary.span.start);
            let length = text[d.primary.span.range()].chars().count();
            let to = if length > 1 { format!("-{}", column + length - 1) } else { String::new() };
            let mark = if length == 0 { "^" } else { "" };
            format!("{} {line}:{mark}{column}{to} {}", d.code.as_str(), d.message)
        })
        .collect()
}

/// An expression, fully parenthesised, operators in front.
pub fn show(chart: &Chart, id: ExprId) -> String {
    let one = |word: &str, x: &ExprId| format!("({word} {})", show(chart, *x));
    match &chart.exprs[id].kind {
        ExprKind::Name(name) => name.to_string(),
        ExprKind::Integer(value) => value.to_string(),
        ExprKind::Real(value) => format!("{value:?}"),
        ExprKind::Duration(value) => format!("{value}ms"),
        ExprKind::Bool(value) => value.to_string(),
        ExprKind::Paren(x) => one("paren", x),
        ExprKind::Predicate(x) => one("predicate", x),
        ExprKind::Not(x) => one("not", x),
        ExprKind::Negate(x) => one("negate", x),
        ExprKind::Rise(x) => one("rise", x),
        ExprKind::Fall(x) => one("fall", x),
        ExprKind::Binary(op, x, y) => format!("({} {} {})", operator(*op), show(chart, *x), show(chart, *y)),
        ExprKind::Delay(parts) => {
            format!("(delay {})", parts.iter().map(|p| show(chart, *p)).collect::<Vec<_>>().join(" "))
        }
        ExprKind::Error => "error".into(),
    }
}

fn operator(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::And => "and",
        BinaryOp::Or => "or",
        BinaryOp::Xor => "xor",
        BinaryOp::Equal => "=",
        BinaryOp::NotEqual => "<>",
        BinaryOp::Less => "<",
        BinaryOp::LessEqual => "<=",
        BinaryOp::Greater => ">",
        BinaryOp::GreaterEqual => ">=",
        BinaryOp::Add => "+",
        BinaryOp::Subtract => "-",
        BinaryOp::Multiply => "*",
        BinaryOp::Divide => "/",
        BinaryOp::Modulo => "mod",
    }
}

/// The condition of the only transition of `transition -> : …`, as [`show`] writes it.
pub fn condition(text: &str) -> String {
    let chart = chart(&format!("transition 1 -> 2 : {text}"));
    match chart.items.as_slice() {
        [Item::Transition(transition)] => show(&chart, transition.condition),
        items => panic!("one transition was written: {items:?}"),
    }
}

/// The value of `var v : int := …`, as [`show`] writes it.
pub fn value(text: &str) -> String {
    let chart = chart(&format!("var v : int := {text}"));
    match chart.items.as_slice() {
        [Item::Declaration(declaration)] => show(&chart, declaration.initial.expect("it was written")),
        items => panic!("one declaration was written: {items:?}"),
    }
}

/// What holds for any text: spans lie in it; if it has no faults, formatting keeps its meaning and its comments, and
/// formatting again changes nothing. Returns whether the text had no faults.
pub fn check(text: &str) -> bool {
    let (chart, diagnostics) = grafc_syntax::parse(FileId::new(0), text);
    for diagnostic in &diagnostics {
        let places = std::iter::once(&diagnostic.primary).chain(&diagnostic.secondary);
        for label in places {
            assert!(text.get(label.span.range()).is_some(), "{diagnostic:?} is not a place of the text");
        }
        assert!(!diagnostic.message.is_empty() && !diagnostic.message.contains('\n'), "{diagnostic:?}");
    }
    for expr in &chart.exprs {
        assert!(text.get(expr.span.range()).is_some(), "{expr:?} is not a place of the text");
    }
    // Children come before their parents, so each chart can be walked with a loop.
    for (id, expr) in chart.exprs.iter_enumerated() {
        let children: Vec<ExprId> = match &expr.kind {
            ExprKind::Paren(x)
            | ExprKind::Predicate(x)
            | ExprKind::Not(x)
            | ExprKind::Negate(x)
            | ExprKind::Rise(x)
            | ExprKind::Fall(x) => vec![*x],
            ExprKind::Binary(_, x, y) => vec![*x, *y],
            ExprKind::Delay(parts) => parts.to_vec(),
            ExprKind::Name(_)
            | ExprKind::Integer(_)
            | ExprKind::Real(_)
            | ExprKind::Duration(_)
            | ExprKind::Bool(_)
            | ExprKind::Error => vec![],
        };
        assert!(children.iter().all(|c| *c < id), "{id:?} stands before a child");
    }
    if diagnostics.has_errors() {
        // It is not called then, but it must not panic either.
        let _ = grafc_syntax::format(text, &chart);
        return false;
    }
    assert!(!chart.exprs.iter().any(|e| e.kind == ExprKind::Error), "an unreadable expression was not reported");
    let formatted = grafc_syntax::format(text, &chart);
    let (again, faults) = grafc_syntax::parse(FileId::new(0), &formatted);
    assert!(faults.is_empty(), "formatting made faults:\n{:#?}\n{text}\n{formatted}", faults_of(&formatted, &faults));
    assert!(grafc_syntax::same(&chart, &again), "formatting changed the meaning:\n{text}\n{formatted}");
    assert_eq!(
        comments(text, &chart),
        comments(&formatted, &again),
        "formatting changed a comment:\n{text}\n{formatted}"
    );
    let twice = grafc_syntax::format(&formatted, &again);
    assert_eq!(formatted, twice, "formatting twice is not formatting once");
    true
}

fn comments(text: &str, chart: &Chart) -> Vec<String> {
    chart.comments.iter().map(|c| text[c.span.range()].replace("\r\n", "\n")).collect()
}
