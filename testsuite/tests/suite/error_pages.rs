//! Each page in `docs/errors` against the compiler: its wrong example gives its code and nothing else, its right
//! example gives nothing.

use grafc_diagnostics::{Code, Diagnostics, FileId, Severity, apply};
use grafc_model::chart::Chart;
use grafc_model::reaction::Profile;
use grafc_testsuite::binary::{grafc, root};
use grafc_testsuite::markdown::{FencedBlock, blocks};
use grafc_testsuite::runs::simulate;
use std::collections::BTreeSet;

/// Codes whose pages cannot show an example, and why. Their pages say so too.
const WITHOUT_EXAMPLE: &[(Code, &str)] = &[
    (Code::E0109, "the text would have to be longer than 4 GiB"),
    (Code::E0110, "a page is UTF-8 itself; `bytes_that_are_not_utf8` runs the binary instead"),
    (Code::E0506, "the chart would have to be longer than a page"),
    (Code::E0606, "it takes an option of `grafc sim`"),
    (Code::E0608, "it takes files of certain names; a test of `grafc test` runs the binary instead"),
    (Code::E0901, "no text is known to give it, else it would be corrected"),
];

/// Codes that compiling gives, not checking, and the options that their charts are compiled with.
const COMPILED_WITH: &[(Code, &[&str])] = &[
    (Code::W0413, &["--target", "st", "--encoding", "r-trigger"]),
    (Code::E0504, &["--target", "awl"]),
    (Code::E0505, &["--target", "awl"]),
    (Code::E0507, &["--target", "c", "--arduino"]),
    (Code::E0216, &["--target", "st", "--reset-input", "again"]),
    (Code::E0503, &["--target", "plcopen", "--body", "sfc", "--evolution", "scan"]),
];

fn examples(code: Code, section: &str) -> Vec<FencedBlock> {
    blocks(code.page()).into_iter().filter(|b| b.section == section).collect()
}

/// The block of a language, of which there is at most one.
fn only<'a>(blocks: &'a [FencedBlock], language: &str) -> Option<&'a FencedBlock> {
    let mut found = blocks.iter().filter(|b| b.language == language);
    let first = found.next();
    assert!(found.next().is_none(), "there are two {language} blocks");
    first
}

/// The chart of an example: ours, or that of another tool.
fn chart_of(blocks: &[FencedBlock]) -> Option<&FencedBlock> {
    only(blocks, "gct").or(only(blocks, "xml")).or(only(blocks, "kiss2"))
}

/// Whether a block is a file to be imported.
fn is_of_another_tool(block: &FencedBlock) -> bool {
    matches!(block.language.as_str(), "xml" | "kiss2")
}

/// What is said about a recording of a chart without inputs: its times are the trace.
fn compared(chart: &Chart, recording: &str) -> Diagnostics {
    let times: Vec<&str> = recording.lines().filter_map(|line| line.split(',').next()).collect();
    let (stimuli, mut diagnostics) = grafc_model::trace::parse_trace(FileId::new(1), &times.join("\n"), chart);
    let responses = simulate(chart, Profile::default(), &stimuli);
    diagnostics.append(grafc_model::trace::compare_trace(FileId::new(1), recording, chart, &stimuli, &responses).1);
    diagnostics
}

/// What is said about the example: of a chart, of its import, of a trace for it, or of its way to Structured Text.
fn diagnose(code: Code, chart: &FencedBlock, trace: Option<&FencedBlock>) -> BTreeSet<Code> {
    if is_of_another_tool(chart) {
        let options = grafc_import::Options::default();
        return codes(&grafc_import::import(FileId::new(0), &chart.text, &options).1);
    }
    let (checked, mut diagnostics) = grafc::check(FileId::new(0), &chart.text, "example");
    match trace {
        Some(trace) => {
            let checked =
                checked.unwrap_or_else(|| panic!("{code:?}: the chart of the trace has errors: {diagnostics:?}"));
            diagnostics.append(match code {
                Code::E0607 => grafc_testing::table(&checked, Profile::default(), (FileId::new(1), &trace.text), None),
                Code::E0605 => compared(&checked, &trace.text),
                Code::W0601 | Code::W0602 | Code::E0609 => {
                    let (chart, trace) = ((FileId::new(0), chart.text.as_str()), (FileId::new(1), trace.text.as_str()));
                    grafc::simulate(chart, "example", trace, None, grafc::Run::default()).1
                }
                _ => grafc_model::trace::parse_trace(FileId::new(1), &trace.text, &checked).1,
            });
        }
        None => {
            if code == Code::E0611 {
                let checked = checked.expect("a chart without errors");
                for scenario in &checked.scenarios {
                    let said = grafc_testing::scenario(&checked, Profile::default(), scenario, 10, None);
                    diagnostics.append(said);
                }
                return codes(&diagnostics);
            }
            if let Some((_, options)) = COMPILED_WITH.iter().find(|(c, _)| *c == code) {
                return compile(&chart.text, options);
            }
        }
    }
    codes(&diagnostics)
}

fn codes(diagnostics: &Diagnostics) -> BTreeSet<Code> {
    diagnostics.iter().map(|d| d.code).collect()
}

/// The codes that compiling gives, as the user sees them.
fn compile(chart: &str, options: &[&str]) -> BTreeSet<Code> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(folder.path().join("example.gct"), chart).expect("a file in it");
    let mut command = grafc();
    let output = command
        .current_dir(folder.path())
        .args(["example.gct", "-o", "example.st"])
        .args(options)
        .output()
        .expect("grafc runs");
    let said = String::from_utf8_lossy(&output.stderr);
    let found: BTreeSet<Code> =
        Code::ALL.iter().copied().filter(|c| said.contains(&format!("[{}]", c.as_str()))).collect();
    let errors = found.iter().any(|c| c.severity() == Severity::Error);
    assert_eq!(output.status.success(), !errors, "exit code and messages disagree: {said}");
    assert_eq!(
        folder.path().join("example.st").exists(),
        !errors,
        "a file is written if and only if there is no error"
    );
    found
}

#[test]
fn every_code_has_a_page_with_all_sections() {
    for code in Code::ALL {
        let page = code.page();
        let title = format!("# {}: {}\n", code.as_str(), code.slug());
        assert!(page.starts_with(&title), "{code:?}: the title is not {title}");
        let shown = ["Wrong", "Right"].map(|section| !examples(*code, section).is_empty());
        let excused = WITHOUT_EXAMPLE.iter().any(|(c, _)| c == code);
        assert_eq!(shown, [!excused; 2], "{code:?}: examples Wrong, Right");
        assert_eq!(page.contains("There is no example here"), excused, "{code:?}");
        for section in ["Why", "What to do"] {
            assert!(page.contains(&format!("\n## {section}\n")), "{code:?}: no section {section}");
        }
        let long = page.lines().position(|line| line.chars().count() > 100);
        assert_eq!(long, None, "{code:?}: a line is too long for a terminal");
    }
}

#[test]
fn no_page_is_without_code() {
    let mut pages = 0;
    for entry in std::fs::read_dir(root().join("docs/errors")).expect("the folder of pages") {
        let path = entry.expect("an entry").path();
        let stem = path.file_stem().expect("a name").to_string_lossy().into_owned();
        assert!(path.extension().is_some_and(|e| e == "md"), "{} is no page", path.display());
        assert!(Code::ALL.iter().any(|c| c.as_str() == stem), "{} has no code", path.display());
        pages += 1;
    }
    assert_eq!(pages, Code::ALL.len());
}

#[test]
fn wrong_examples_give_their_code_alone() {
    let mut faults = Vec::new();
    for code in Code::ALL {
        let wrong = examples(*code, "Wrong");
        let Some(chart) = chart_of(&wrong) else { continue };
        let of_import = code.as_str()[1..].starts_with("07");
        assert_eq!(is_of_another_tool(chart), of_import, "{code:?}: pages about imports show a file to be imported");
        let trace = only(&wrong, "csv");
        // What is wrong with a scenario shows in the chart that has it.
        let of_trace = code.as_str()[1..].starts_with("06") && !matches!(code, Code::E0610 | Code::E0611);
        assert_eq!(trace.is_some(), of_trace, "{code:?}: pages about traces show a trace");
        let found = diagnose(*code, chart, trace);
        if found != BTreeSet::from([*code]) {
            faults.push(format!("{code:?}: gives {found:?}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// A fix of a chart leaves no error but those that there were besides.
#[test]
fn fixes_of_wrong_examples_cure_them() {
    let mut tried = BTreeSet::new();
    for code in Code::ALL {
        let wrong = examples(*code, "Wrong");
        let Some(chart) = only(&wrong, "gct") else { continue };
        let diagnostics = grafc::check(FileId::new(0), &chart.text, "example").1;
        for diagnostic in &diagnostics {
            let errors =
                |diagnostics: &Diagnostics| diagnostics.iter().filter(|d| d.code.severity() == Severity::Error).count();
            let is_error = usize::from(diagnostic.code.severity() == Severity::Error);
            for fix in &diagnostic.fixes {
                let fixed = apply(FileId::new(0), &chart.text, &fix.edits).unwrap_or_else(|e| panic!("{code:?}: {e}"));
                let now = grafc::check(FileId::new(0), &fixed, "example").1;
                assert!(errors(&now) <= errors(&diagnostics) - is_error, "{code:?}: {fix:?} gives {now:#?}\n{fixed}");
                let is_left = now.iter().any(|d| d.code == *code && d.message == diagnostic.message);
                assert!(!is_left, "{code:?}: {fix:?} does not help\n{fixed}");
                tried.insert(*code);
            }
        }
    }
    // The pages whose help is a change of the text.
    use Code::*;
    let errors = [
        E0101, E0107, E0108, E0201, E0211, E0214, E0217, E0306, E0310, E0312, E0316, E0318, E0319, E0320, E0321, E0419,
    ];
    let warnings = [W0421, W0422, W0423, W0425];
    assert_eq!(tried, errors.into_iter().chain(warnings).collect());
}

#[test]
fn right_examples_give_nothing() {
    let mut faults = Vec::new();
    for code in Code::ALL {
        let right = examples(*code, "Right");
        let wrong = examples(*code, "Wrong");
        // A page about traces shows the chart once.
        let Some(chart) = chart_of(&right).or(chart_of(&wrong)) else { continue };
        let found = diagnose(*code, chart, only(&right, "csv"));
        if !found.is_empty() {
            faults.push(format!("{code:?}: gives {found:?}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn bytes_that_are_not_utf8() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(folder.path().join("old.gct"), b"initial step f\xFCllen").expect("a file in it");
    let output = grafc().current_dir(folder.path()).args(["check", "old.gct"]).output().expect("grafc runs");
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("error[E0110]"), "{said}");
}
