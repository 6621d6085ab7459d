//! The library: a document that is asked again and again says what a fresh compile says.

use fastrand::Rng;
use grafc::backends::{plcopen, st};
use grafc::{Document, Encoding, Lowering, Options, Product, Target, check, compile};
use grafc_diagnostics::{Diagnostic, Diagnostics, FileId};
use grafc_testsuite::binary::root;
use grafc_testsuite::charts::{cases, charts_folder, vectors_folder};
use std::collections::BTreeSet;
use std::process::Command;

fn list(diagnostics: &Diagnostics) -> Vec<Diagnostic> {
    let mut diagnostics = diagnostics.clone();
    diagnostics.sort_by_place();
    diagnostics.iter().cloned().collect()
}

/// All that a document says, in order of place.
fn all(document: &Document) -> Vec<Diagnostic> {
    let mut diagnostics = document.diagnostics().clone();
    diagnostics.append(document.warnings().clone());
    list(&diagnostics)
}

#[test]
fn a_document_makes_what_a_compile_makes() {
    let mut cases = cases(&charts_folder());
    cases.extend(grafc_testsuite::charts::cases(&vectors_folder()));
    let drawing = plcopen::Options { body: plcopen::Body::Sfc, ..plcopen::Options::default() };
    let targets = [Target::St(st::Options::default()), Target::Plcopen(drawing)];
    let (mut made, mut refused) = (0, 0);
    for case in &cases {
        let mut document = Document::new(format!("{}.gct", case.name), case.text.as_str());
        assert_eq!(all(&document), list(&check(FileId::new(0), &case.text, &case.name).1), "{}", case.name);
        for encoding in Encoding::ALL {
            let lowering = Lowering { profile: case.profile, encoding, simplify: true };
            document.set_options(lowering);
            for target in &targets {
                let options = Options::new(lowering, Product::Code(target.clone()));
                let (expected, diagnostics) = compile(FileId::new(0), &case.text, &case.name, &options);
                let mut found = document.diagnostics().clone();
                found.append(document.warnings().clone());
                match document.emit(target) {
                    Ok(output) => {
                        assert_eq!(Some(output), expected, "{}", case.name);
                        // What is drawn is no program.
                        if let Target::St(_) = target {
                            found.append(document.program_diagnostics().cloned().unwrap_or_default());
                        }
                        made += 1;
                    }
                    Err(why) => {
                        assert_eq!(expected, None, "{}", case.name);
                        found.append(why);
                        refused += 1;
                    }
                }
                assert_eq!(list(&found), list(&diagnostics), "{} {}", case.name, encoding.name());
            }
        }
    }
    assert!(made > cases.len() * Encoding::ALL.len() && refused > 0, "{made} made, {refused} refused");
}

/// Pieces that break a chart, repair it, or change what it means.
const PIECES: [&str; 12] =
    ["", " ", "\n", "{", "}", "step 90\n", "transition 1 -> 1 : ", "a", "ä", "and not ", "// ", "output z : bool\n"];

#[test]
fn an_edited_document_is_as_one_that_was_never_another() {
    let mut rng = Rng::with_seed(11);
    let cases = cases(&charts_folder());
    let (mut right, mut wrong) = (0, 0);
    for case in &cases {
        let mut document = Document::new("chart.gct", case.text.as_str());
        for _ in 0..8 {
            let text = document.text().to_owned();
            let places: Vec<usize> = text.char_indices().map(|(at, _)| at).chain([text.len()]).collect();
            let start = rng.usize(..places.len());
            let end = (start + rng.usize(..4)).min(places.len() - 1);
            let (range, piece) = (places[start]..places[end], PIECES[rng.usize(..PIECES.len())]);
            document.edit(range.clone(), piece).expect("places between characters");
            let mut expected = text;
            expected.replace_range(range, piece);
            assert_eq!(document.text(), expected);
            let fresh = Document::new("chart.gct", expected);
            assert_eq!(all(&document), all(&fresh));
            assert_eq!(document.symbols(), fresh.symbols());
            assert_eq!(document.chart().map(grafc_model::dump), fresh.chart().map(grafc_model::dump));
            *if document.chart().is_some() { &mut right } else { &mut wrong } += 1;
        }
    }
    assert!(right > 0 && wrong > 0, "{right} right, {wrong} wrong");
}

/// What a project with a build script compiles for it, beside itself.
#[test]
fn a_build_script_takes_few_crates() {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["tree", "--locked", "--package", "grafc", "--edges", "normal,build", "--prefix", "none"]);
    let output = cargo.current_dir(root()).output().expect("cargo can be run");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let tree = String::from_utf8_lossy(&output.stdout);
    let crates: BTreeSet<&str> = tree.lines().map(|line| line.trim_end_matches(" (*)")).collect();
    assert!(crates.len() <= 60, "{} crates: {crates:#?}", crates.len());
    let names: BTreeSet<&str> = crates.iter().filter_map(|one| one.split(' ').next()).collect();
    assert!(names.contains("grafc-syntax"), "{names:?}");
    for other in ["clap", "serde_json", "tempfile", "lalrpop", "grafc-import"] {
        assert!(!names.contains(other), "{other} is for the command line, or for those who change the grammar");
    }
}
