//! Generated C under other compilers, on other machines, and before those who check it: nobody has anything to say, and a
//! microcontroller does what the chart means.

use grafc_backends::c;
use grafc_logic::{Encoding, Options};
use grafc_model::chart::Type;
use grafc_testsuite::agreement::Agreement;
use grafc_testsuite::binary::{grafc, root};
use grafc_testsuite::charts::{Case, cases, charts_folder, check, vectors_folder};
use grafc_testsuite::executors::c::{ALL_KINDS, Board, Compiler, Emulated, Tools};
use grafc_testsuite::runs::compile_saved;
use grafc_testsuite::share::is_thorough;
use grafc_testsuite::tools::{Tool, or_skip};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The same with a number of double precision.
fn with_lreal() -> String {
    ALL_KINDS
        .replace("output lamp", "output mean : lreal\noutput lamp")
        .replace("step 3 {", "step 3 { mean := d / r on activation ")
}

/// A source beside its header, as `chart.c` and `chart.h` in a folder; none where the chart cannot be encoded so.
fn write(folder: &Path, name: &str, text: &str, encoding: Encoding) -> Option<String> {
    let chart = check(name, text).unwrap_or_else(|error| panic!("{name}: {error}"));
    let program = compile_saved(&chart, &Options { encoding, ..Options::default() }).ok()?;
    let options = c::Options { include: Some("chart.h".into()), ..c::Options::default() };
    let (source, header) = c::emit(&program, &options).expect("a source");
    fs::write(folder.join("chart.c"), &source).expect("a temporary file");
    fs::write(folder.join("chart.h"), header.expect("a header")).expect("a temporary file");
    Some(source)
}

/// Each chart is compiled in so many encodings: they take turns, since what a compiler says of one chart it says of others.
fn encodings() -> usize {
    if is_thorough() { 3 } else { 1 }
}

/// All charts, those of arithmetic included, and all encodings.
fn compile_all(with: &str, compile: impl Fn(&Path) -> Result<(), String>) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut charts: Vec<(String, String)> =
        cases(&charts_folder()).into_iter().map(|case| (case.name, case.text)).collect();
    charts.push(("kinds".into(), ALL_KINDS.into()));
    for (turn, (name, text)) in charts.iter().enumerate() {
        for encoding in Encoding::ALL.into_iter().cycle().skip(turn * encodings()).take(encodings()) {
            if let Some(source) = write(folder.path(), name, text, encoding) {
                compile(folder.path())
                    .unwrap_or_else(|said| panic!("{with}, {name}, {}: {said}\n{source}", encoding.name()));
            }
        }
    }
}

#[test]
fn clang_has_nothing_to_say() {
    let Some(tools) = or_skip(Tool::Clang, Tools::named("clang")) else { return };
    compile_all("clang", |folder| tools.object(folder, "chart.c", &["-O1"]));
}

#[test]
fn compilers_for_microcontrollers_have_nothing_to_say() {
    for board in Board::ALL {
        let Some(compiler) = Compiler::find_or_skip(board) else { continue };
        compile_all(compiler_name(board), |folder| compiler.object(folder, "chart.c"));
    }
}

fn compiler_name(board: Board) -> &'static str {
    board.compiler().name()
}

/// A number that would be another one does not compile, wherever `double` has 32 bits; elsewhere it does.
#[test]
fn what_would_be_less_exact_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    write(folder.path(), "kinds", &with_lreal(), Encoding::Switch).expect("a source");
    if let Some(avr) = Compiler::find_or_skip(Board::Avr) {
        let said = avr.object(folder.path(), "chart.c").expect_err("a double of 32 bits");
        assert!(said.contains("an lreal of the chart is a double of 64 bits"), "{said}");
    }
    if let Some(arm) = Compiler::find_or_skip(Board::CortexM) {
        arm.object(folder.path(), "chart.c").expect("a double of 64 bits");
    }
    if let Some(tools) = Tools::find_or_skip() {
        tools.object(folder.path(), "chart.c", &[]).expect("a double of 64 bits");
        let narrow = ["-U__DBL_MANT_DIG__", "-D__DBL_MANT_DIG__=24"];
        let said = tools.object(folder.path(), "chart.c", &narrow).expect_err("a double that is narrower");
        assert!(said.contains("an lreal of the chart is a double of 64 bits"), "{said}");
        let wide = ["-U__FLT_EVAL_METHOD__", "-D__FLT_EVAL_METHOD__=2"];
        let said = tools.object(folder.path(), "chart.c", &wide).expect_err("results that are rounded later");
        assert!(said.contains("each result is rounded to its own type"), "{said}");
    }
}

/// The rules of MISRA C:2012 that cppcheck may report, which `docs/c.md` gives the reasons for.
fn deviations() -> BTreeSet<String> {
    let page = fs::read_to_string(root().join("docs/c.md")).expect("the page");
    let table = page.split("## MISRA C").nth(1).expect("the section").split("\n## ").next().expect("its text");
    let rows = table.lines().filter_map(|line| line.strip_prefix("| ")?.split(" |").next());
    let rules: BTreeSet<String> =
        rows.filter(|rule| rule.starts_with(|c: char| c.is_ascii_digit())).map(str::to_owned).collect();
    assert!(!rules.is_empty(), "the table of deviations");
    rules
}

/// Only deviations that have a reason are reported, and each of them is.
#[test]
fn cppcheck_reports_what_the_page_says() {
    let version = Command::new("cppcheck").arg("--version").output();
    let found = version.map(|_| ()).map_err(|_| "cppcheck cannot be called".to_owned());
    if or_skip(Tool::Cppcheck, found).is_none() {
        return;
    }
    let known = deviations();
    let mut seen = BTreeSet::new();
    let mut charts = vec![("kinds".to_owned(), with_lreal())];
    let chosen = ["weigh_mix_b4", "weigh_mix_b6", "operating_hours", "lock_extended", "shift_register", "figure_3"];
    let of_folder = cases(&charts_folder()).into_iter().filter(|case| chosen.contains(&case.name.as_str()));
    charts.extend(of_folder.map(|case| (case.name, case.text)));
    assert_eq!(charts.len(), 1 + chosen.len());
    for (place, (name, text)) in charts.iter().enumerate() {
        for encoding in [Encoding::Switch, Encoding::Sequent, Encoding::SinglePhase] {
            // The last three are enough once; the first has everything.
            if place > 3 && encoding != Encoding::Switch || place > 0 && !is_thorough() {
                continue;
            }
            let folder = tempfile::tempdir().expect("a temporary folder");
            let source = write(folder.path(), name, text, encoding).expect("a source");
            let float = ["-DFLT_MANT_DIG=24", "-DDBL_MANT_DIG=53", "-DFLT_EVAL_METHOD=0"];
            let mut cppcheck = Command::new("cppcheck");
            cppcheck.args(["--addon=misra", "--std=c99", "--enable=style", "--suppress=missingIncludeSystem"]);
            let output =
                cppcheck.args(float).arg("chart.c").current_dir(folder.path()).output().expect("cppcheck runs");
            let said = String::from_utf8_lossy(&output.stderr);
            let reported = said.split("[misra-c2012-").skip(1).filter_map(|rest| rest.split(']').next());
            let reported: BTreeSet<String> = reported.map(str::to_owned).collect();
            assert!(reported.contains("15.5"), "{name}: the rules were not looked at\n{said}");
            let new: Vec<&String> = reported.difference(&known).collect();
            assert!(new.is_empty(), "{name}, {}: {new:?}\n{said}\n{source}", encoding.name());
            seen.extend(reported);
        }
    }
    if is_thorough() {
        assert_eq!(seen, known, "the deviations of the page");
    }
}

/// Charts without real numbers, which a program of a few lines cannot print.
fn for_boards(cases: &[Case]) -> Vec<&Case> {
    let whole = |case: &&Case| {
        let chart = check(&case.name, &case.text).unwrap_or_else(|error| panic!("{}: {error}", case.name));
        !chart.variables.iter().any(|variable| matches!(variable.ty, Type::Real | Type::Lreal))
    };
    cases.iter().filter(whole).collect()
}

/// The plant, other charts and some vectors as microcontrollers run them, saved and restored on the way, across the end of
/// the clock's range.
#[test]
fn microcontrollers_do_what_charts_mean() {
    let charts = cases(&charts_folder());
    // Delays, numbers, forcing, enclosures: a seventh of all.
    let vectors: Vec<Case> = cases(&vectors_folder()).into_iter().step_by(7).collect();
    for board in Board::ALL {
        let Some(emulated) = Emulated::find_or_skip(board) else { continue };
        let mut agreement = Agreement::default();
        for (turn, case) in for_boards(&charts).into_iter().chain(for_boards(&vectors)).enumerate() {
            let all = case.ways();
            let (way, options) = &all[turn % all.len()];
            agreement.case(case, way, |chart| compile_saved(chart, options));
        }
        assert!(agreement.count() > 30, "programs that are run");
        agreement.hold(board as usize, 100, |jobs| emulated.run(jobs));
    }
}

/// Bytes by hand: 3 outputs, 4 flags, 8 steps, whether it has started. Without compilers that is said, and no failure.
#[test]
fn stats_tell_what_a_microcontroller_takes() {
    let chart = charts_folder().join("figure_12_6.gct");
    let empty = tempfile::tempdir().expect("a temporary folder");
    let call = |path: Option<&Path>| {
        let mut command = grafc();
        command.arg("stats").arg(&chart).args(["--compiled", "--evolution", "scan"]);
        if let Some(path) = path {
            command.env("PATH", path);
        }
        let output = command.output().expect("grafc runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    let bare = call(Some(empty.path()));
    for missing in ["arm-none-eabi-gcc is not on PATH", "avr-gcc is not on PATH"] {
        assert!(bare.contains(&format!("not measured: {missing}")), "{bare}");
    }
    if Board::ALL.into_iter().all(|board| Compiler::find_or_skip(board).is_some()) {
        let told = call(None);
        let rows: Vec<&str> = told.lines().filter(|line| line.trim_start().starts_with("single-phase")).collect();
        let bytes =
            rows.iter().map(|row| row.split_whitespace().skip(1).map(|n| n.parse().expect("a number")).collect());
        let bytes: Vec<Vec<u32>> = bytes.collect();
        assert!(bytes.len() == 2 && bytes.iter().all(|row| row[0] > 500 && row[1] == 16), "{told}");
    }
}
