//! Large and deep charts are checked in time that grows with their size, and without recursion.
//!
//! The bound is far above what is needed: it only tells linear from quadratic.

use grafc_diagnostics::FileId;
use std::fmt::Write;
use std::time::{Duration, Instant};

const BOUND: Duration = Duration::from_secs(60);

/// The codes of a chart, each once, if the check stayed within the bound.
fn codes(text: &str) -> Vec<&'static str> {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::new(0), text);
    assert!(diagnostics.is_empty(), "{:?}", diagnostics.iter().next());
    let start = Instant::now();
    let (_, diagnostics) = grafc_model::check(&tree, "large");
    let taken = start.elapsed();
    assert!(taken < BOUND, "{taken:?}");
    let mut codes: Vec<&str> = diagnostics.iter().map(|d| d.code.as_str()).collect();
    codes.sort_unstable();
    codes.dedup();
    codes
}

/// The items number 0 to `count`, a line each.
fn lines(count: usize, item: impl Fn(usize) -> String) -> String {
    (0..count).fold(String::new(), |mut text, i| {
        writeln!(text, "{}", item(i)).expect("a string takes all");
        text
    })
}

#[test]
fn a_hundred_thousand_steps() {
    let count = 100_000;
    let steps = lines(count, |i| format!("step s{i} {{ V C := C + 1 on activation }}"));
    let transitions = lines(count, |i| format!("transition s{i} -> s{} : a and [C > 3] or 3s/Xs{i}", (i + 1) % count));
    let text = format!("input a : bool output V : bool var C : int initial step 0\n{steps}{transitions}");
    assert_eq!(codes(&text), [""; 0]);
}

#[test]
fn thousands_of_unknown_names() {
    let text = lines(20_000, |i| format!("transition 1 -> step{i} : name{i}"));
    assert_eq!(codes(&format!("initial step 1 {text}")), ["E0201", "E0301"]);
}

#[test]
fn a_wide_join() {
    let names: Vec<String> = (0..50_000).map(|i| format!("s{i}")).collect();
    let steps = lines(names.len(), |i| format!("step s{i}"));
    let text = format!("initial step 0 {steps} transition 0 -> {0} : 1 transition {0} -> 0 : 1", names.join(", "));
    assert_eq!(codes(&text), ["W0407"]);
}

#[test]
fn a_wide_and_deep_hierarchy() {
    let wide =
        lines(16_384, |i| format!("grafcet X1/W{i} {{ activated step w{i}_ }} grafcet F{i} {{ initial step f{i}_ }}"));
    let orders = lines(16_384, |i| format!("force F{i}{{}}"));
    let deep = lines(2_000, |i| format!("grafcet Xd{i}/D{i}_ {{ activated enclosing step d{} }}", i + 1));
    let text = format!(
        "grafcet G1 {{ initial step 0 enclosing step 1 {{ {orders} }} enclosing step d0 }}
         {wide} {deep} grafcet Xd2000/D2000_ {{ activated step last }}"
    );
    assert_eq!(codes(&text), [""; 0]);
}

#[test]
fn deep_expansions() {
    let expansions = lines(2_000, |i| {
        format!("expansion M{i} {{ step E{i} macro step M{} step S{i} transition E{i} -> S{i} : a }}", i + 1)
    });
    let text = format!(
        "input a : bool initial step 1 macro step M0 transition 1 -> M0 : XM0
         {expansions} expansion M2000 {{ step E2000 step S2000 }}"
    );
    assert_eq!(codes(&text), [""; 0]);
}

#[test]
fn a_circle_of_all_grafcets() {
    let text = lines(5_000, |i| format!("grafcet G{i}_ {{ initial step s{i} {{ force G{}_{{}} }} }}", (i + 1) % 5_000));
    assert_eq!(codes(&text), ["E0313"]);
}

#[test]
fn deep_expressions() {
    let nest = |open: &str, close: &str| {
        let inner = format!("{}a{}", open.repeat(10_000), close.repeat(10_000));
        codes(&format!("input a : bool initial step 1 step 2 transition 1 -> 2 : {inner}"))
    };
    assert_eq!(nest("(", ")"), [""; 0]);
    assert_eq!(nest("not ", ""), [""; 0]);
    assert_eq!(nest("3s/(", ")"), [""; 0]);
    assert_eq!(nest("(a or ", ")"), [""; 0]);
    assert_eq!(nest("↑(", ")"), ["E0413"]);
}

#[test]
fn long_chains_of_constants_and_of_continuous_actions() {
    let constants = lines(20_000, |i| format!("const c{i} : int := c{} + 0", i + 1));
    let variables = lines(20_000, |i| format!("var w{i} : bool"));
    let actions = lines(20_000, |i| format!("w{i} if w{}", (i + 1) % 20_000));
    let text = format!("{constants} const c20000 : int := 3 {variables} initial step x {{ {actions} }}");
    assert_eq!(codes(&text), ["E0411"]);
}
