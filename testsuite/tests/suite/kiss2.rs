//! Tables of KISS2 as charts: call by call they are what a plain interpreter of the table makes of them, and minimised,
//! written as a table and read again they are so still.
//!
//! Machines of others are tried where `KISS2_MACHINES` names a folder of them:
//! `cargo test --release -p grafc-testsuite kiss2:: -- --ignored --nocapture`.

use fastrand::Rng;
use grafc_automata::{Kind, Machine, convert, explore, kiss2, product};
use grafc_diagnostics::{Code, Diagnostics, FileId, Severity};
use grafc_logic::Options;
use grafc_model::chart::Value;
use grafc_model::reaction::{Profile, Stimulus};
use grafc_model::simulate::Simulator;
use grafc_testsuite::charts::check;
use grafc_testsuite::runs::compile;
use std::fmt::Write as _;

/// A table as it stands there, and the state in which it is.
struct Interpreter<'t> {
    rows: Vec<[&'t str; 4]>,
    outputs: usize,
    state: &'t str,
}

impl<'t> Interpreter<'t> {
    fn new(table: &'t str) -> Self {
        let lines = || table.lines().map(|line| line.split('#').next().unwrap_or_default().trim());
        let told = |word: &str| lines().find_map(|line| line.strip_prefix(word)).map(str::trim);
        let is_row = |line: &&str| !line.is_empty() && !line.starts_with('.');
        let rows: Vec<[&str; 4]> = lines()
            .filter(is_row)
            .map(|line| line.split_whitespace().collect::<Vec<_>>().try_into().expect("four words"))
            .collect();
        let outputs = told(".o ").expect("outputs").parse().expect("a number");
        let state = told(".r ").unwrap_or(rows[0][1]);
        Interpreter { rows, outputs, state }
    }

    /// The first row that fits; without one it stays, and all outputs are 0.
    fn call(&mut self, inputs: &[bool]) -> Vec<bool> {
        let fits = |cube: &str| cube.chars().zip(inputs).all(|(sign, value)| sign == '-' || (sign == '1') == *value);
        let is_here = |from: &str| from == self.state || from == "*";
        match self.rows.iter().find(|[cube, from, ..]| is_here(from) && fits(cube)) {
            None => vec![false; self.outputs],
            Some([_, _, to, outputs]) => {
                if *to != "*" && *to != "-" {
                    self.state = to;
                }
                outputs.chars().map(|sign| sign == '1').collect()
            }
        }
    }
}

fn imported(table: &str) -> (String, Diagnostics) {
    let (chart, found) = grafc_import::import(FileId::default(), table, &grafc_import::Options::default());
    (chart.unwrap_or_else(|| panic!("{found:?}\n{table}")), found)
}

fn machine(chart: &str) -> Machine {
    let chart = check("machine", chart).unwrap_or_else(|fault| panic!("{fault}"));
    explore(&compile(&chart, &Options::default()).expect("a program"), 10_000).expect("a machine")
}

/// Imports a table and runs it beside the interpreter; minimises it, writes it, imports it again. How many states there are
/// then.
fn tried(name: &str, table: &str, calls: usize) -> usize {
    let states = {
        let interpreter = Interpreter::new(table);
        let named =
            interpreter.rows.iter().flat_map(|[_, from, to, _]| [*from, *to]).filter(|s| *s != "*" && *s != "-");
        named.collect::<std::collections::BTreeSet<_>>().len()
    };
    let (text, _) = imported(table);
    let first = machine(&text);
    for kind in [Kind::Moore, Kind::Mealy, Kind::Extended] {
        // That it does the same is proved as it is made.
        convert(&first, kind);
    }
    let minimal = convert(&first, Kind::Minimal);
    assert!(minimal.vertices.len() <= states, "{name}: {} of {states}", minimal.vertices.len());
    let written = kiss2(&minimal.machine, 1_000_000).expect("a table");
    let (again, found) = imported(&written);
    assert!(found.iter().all(|one| one.code == Code::W0701), "{name}: {found:?}");
    assert!(product(&first, &machine(&again)).is_ok(), "{name}: read again it is another one");
    for chart in [&text, &again] {
        let chart = check(name, chart).expect("a chart without errors");
        let (mut rng, mut simulator) = (Rng::with_seed(calls as u64), Simulator::new(&chart, Profile::default()));
        let mut interpreter = Interpreter::new(table);
        for call in 0..calls {
            let inputs: Vec<bool> = first.inputs.iter().map(|_| rng.bool()).collect();
            let values = inputs.iter().map(|value| Value::Bool(*value)).collect();
            let response = simulator.react(&Stimulus { t_ms: call as i64, restart: false, inputs: values });
            let expected: Vec<Value> = interpreter.call(&inputs).into_iter().map(Value::Bool).collect();
            assert_eq!(response.outputs, expected, "{name}, call {call}, {inputs:?}");
        }
    }
    minimal.vertices.len()
}

/// The carry is the state.
const ADDER: &str = ".i 2\n.o 1\n.p 8\n.s 2\n.r p0\n00 p0 p0 0\n01 p0 p0 1\n10 p0 p0 1\n11 p0 p1 0\n00 p1 p0 1\n01 p1 p1 0\n10 p1 p1 0\n11 p1 p1 1\n.e\n";

/// Three states, of which `b` and `c` do the same.
const TWINS: &str = ".i 1\n.o 2\n# twins\n.r a\n0 a b 01\n1 a c 01\n0 b a 10\n1 b b 1-\n0 c a 10\n1 c c 1-\n";

/// Rows that are missing, of any state, and left open.
const GAPS: &str = ".i 2\n.o 1\n10 here there 1\n0- there * 1\n11 * here 0\n.e\nthis is not read\n";

/// Two rows that meet: the first one counts.
const MEETING: &str = ".i 2\n.o 1\n1- s t 1\n-1 s u -\n-- t s 0\n-- u u 1\n";

#[test]
fn tables_of_ours() {
    assert_eq!(tried("adder", ADDER, 2000), 2);
    assert_eq!(tried("twins", TWINS, 2000), 2);
    assert_eq!(tried("gaps", GAPS, 2000), 2);
    assert_eq!(tried("meeting", MEETING, 2000), 3);
}

/// A table of random rows.
fn drawn(seed: u64) -> String {
    let mut rng = Rng::with_seed(seed);
    let (inputs, outputs, states) = (rng.usize(1..=5), rng.usize(1..=4), rng.usize(1..=7));
    let mut table = format!(".i {inputs}\n.o {outputs}\n");
    for _ in 0..rng.usize(1..=40) {
        let mut signs = |count: usize| -> String { (0..count).map(|_| ['0', '1', '-'][rng.usize(0..3)]).collect() };
        let (cube, given) = (signs(inputs), signs(outputs));
        let (from, to) = (rng.usize(0..states), rng.usize(0..states));
        let _ = writeln!(table, "{cube} s{from} s{to} {given}");
    }
    table
}

#[test]
fn random_tables() {
    for seed in 0..60 {
        tried(&format!("seed {seed}\n{}", drawn(seed)), &drawn(seed), 300);
    }
}

/// The chart of a small table, word for word.
#[test]
fn a_row_is_a_transition() {
    let (text, _) = imported(".i 2\n.o 1\n.r shut\n.ilb key push\n.ob bell\n10 shut open 1\n-- open shut 0\n");
    let expected = "\
chart Machine \"from a table of KISS2\" evolution scan

input key, push : bool
output bell : bool

initial step shut
step open

transition shut -> open : key and not push { bell := 1 }
transition shut -> shut : not (key and not push) { bell := 0 }

transition open -> shut : 1 { bell := 0 }
";
    assert_eq!(text, expected);
}

/// Each error with its place, all of a file in one run.
#[test]
fn hostile_tables() {
    let faults = |table: &str| -> Vec<(u32, &'static str)> {
        let (chart, found) = grafc_import::import(FileId::default(), table, &grafc_import::Options::default());
        assert_eq!(chart.is_none(), found.has_errors(), "{table:?}");
        let errors = found.iter().filter(|one| one.code.severity() == Severity::Error);
        errors
            .map(|one| {
                assert!(one.help.is_some(), "{one:?}");
                let line = table[..one.primary.span.start as usize].matches('\n').count() as u32 + 1;
                (line, one.code.as_str())
            })
            .collect()
    };
    assert_eq!(
        faults(".i 2\n.o 1\n1 s t 1\n10 s t x\n10 s t\n.r nowhere\n"),
        [(3, "E0707"), (4, "E0707"), (5, "E0707"), (6, "E0707")]
    );
    assert_eq!(faults(".i two\n.o\n"), [(1, "E0707"), (2, "E0707")]);
    assert_eq!(faults(".i 99999999999999999999\n.o 1\n"), [(1, "E0707")]);
    assert_eq!(faults(".i 4000000000\n.o 1\n"), [(1, "E0707")]);
    assert_eq!(faults(".i 1\n.o 1\n.e\n"), [(1, "E0707")]);
    assert_eq!(faults(".i 1\n.i 1\n.o 1\n- s s 1\n"), [(2, "E0707")]);
    assert_ne!(faults("10 s t 1\n.i 2\n"), []);
    assert_eq!(faults(".i 1\n.o 1\n- * * 1\n"), [(1, "E0707")]);
    // Without inputs or outputs a column is missing.
    assert_eq!(faults(".i 0\n.o 0\ns t\n"), []);
    assert_eq!(faults(".i 1\n.o 0\n1 s t\n"), []);
    // Too many rows to compare, too many lines to tell all that is wrong.
    let many = |row: &str, count: usize| format!(".i 20\n.o 1\n{}", row.repeat(count));
    assert_eq!(faults(&many("1------------------- s t 1\n", 10_000)), [(1, "E0707")]);
    assert_eq!(faults(&many("1 s t 1\n", 10_000)).len(), 50);
    // Names that are words of the language, that differ by case, or that would be those of activities.
    let names = ".i 2\n.o 1\n.ilb step X1\n.ob if\n-- 1 TRUE 1\n0- TRUE true 0\n-- true 1 1\n";
    assert_eq!(faults(names), []);
    check("names", &imported(names).0).unwrap_or_else(|fault| panic!("{fault}"));
    let cut = ADDER.as_bytes();
    for end in 0..cut.len() {
        faults(std::str::from_utf8(&cut[..end]).expect("ASCII"));
    }
}

#[test]
#[ignore = "machines of others"]
#[allow(clippy::print_stderr, reason = "somebody reads it")]
fn machines_of_others() {
    let Ok(folder) = std::env::var("KISS2_MACHINES") else { return };
    let mut paths: Vec<_> =
        std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    for path in paths {
        let table = std::fs::read_to_string(&path).expect("a table");
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let count = tried(&name, &table, 10_000);
        eprintln!("{name}: {count} states");
    }
}
