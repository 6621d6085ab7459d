//! `Build`, as a build script calls it.
//!
//! What it prints and how it ends the process can only be seen from outside. So a test runs this very binary again, which
//! then is the build script: `build_script` below, with what to compile in its environment.

mod common;

use common::{DUBIOUS, FAULTY, Folder, Run, VALVE};
use grafc::{Build, Code, Encoding, Evolution, Runtime};
use std::path::PathBuf;
use std::process::Command;

const CHART: &str = "GRAFC_TEST_CHART";

/// Not a test, but the build script of the others.
#[test]
fn build_script() {
    if let Some(chart) = std::env::var_os(CHART) {
        Build::new(chart).compile();
    }
}

/// Runs the build script in a place, with the folder `out` in it.
fn script(folder: &Folder, chart: &str) -> Run {
    std::fs::create_dir_all(folder.path("out")).unwrap();
    let output = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "build_script", "--nocapture", "--quiet"])
        .current_dir(folder.path("."))
        .env(CHART, chart)
        .env("OUT_DIR", folder.path("out"))
        .output();
    Run::of(output.unwrap())
}

/// What cargo takes from the output.
fn directives(run: &Run) -> Vec<&str> {
    run.out.lines().filter(|line| line.starts_with("cargo::")).collect()
}

/// A builder that writes into a place.
fn build(folder: &Folder) -> Build {
    let mut build = Build::new(folder.path("valve.gct"));
    build.out_dir(folder.path("."));
    build
}

/// The code without what makes a module of it.
fn unwrapped(code: &str, module: &str) -> String {
    let inner = code.strip_prefix(&format!("pub mod {module} {{\n")).and_then(|code| code.strip_suffix("}\n"));
    let inner = inner.unwrap_or_else(|| panic!("no module {module}:\n{code}"));
    inner.lines().map(str::trim_start).collect::<Vec<_>>().join("\n")
}

#[test]
fn warnings_can_be_denied_and_allowed() {
    let folder = Folder::new(&[("valve.gct", DUBIOUS)]);
    for deny in [Build::deny_warnings as fn(&mut Build) -> &mut Build, |build| build.deny(Code::W0403)] {
        let mut build = build(&folder);
        deny(&mut build);
        let refused = build.try_compile().unwrap_err().to_string();
        assert!(refused.contains("error[W0403]") && refused.ends_with("\n1 error\n"), "{refused}");
        assert_eq!(folder.names(), ["valve.gct"]);
    }
    build(&folder).deny_warnings().allow(Code::W0403).try_compile().unwrap();
    assert_eq!(folder.names(), ["valve.gct", "valve.rs"]);
}

#[test]
fn a_chart_becomes_a_module_in_out_dir() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let run = script(&folder, "valve.gct");
    run.is_done();
    assert_eq!(directives(&run), ["cargo::rerun-if-changed=valve.gct"]);
    assert_eq!(folder.names(), ["out", "valve.gct"]);
    let code = folder.read("out/valve.rs");
    assert!(code.contains("    pub struct Valve {"), "{code}");
}

#[test]
fn the_code_is_that_of_the_command_line() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let same = |build: &mut Build, arguments: &[&str]| {
        let path = build.module("m").out_dir(folder.path(".")).try_compile().unwrap();
        assert_eq!(path, folder.path(".").join("m.rs"));
        let all: Vec<&str> = ["valve.gct", "--target", "rust"].iter().chain(arguments).copied().collect();
        let expected = folder.run(&all).is_done().out.clone();
        let expected: Vec<&str> = expected.lines().map(str::trim_start).collect();
        // Deeper in, a line may be broken in two.
        let words = |text: &str| text.split_whitespace().collect::<String>();
        assert_eq!(words(&unwrapped(&folder.read("m.rs"), "m")), words(&expected.join("\n")), "{arguments:?}");
    };
    let new = || Build::new(folder.path("valve.gct"));
    same(&mut new(), &[]);
    for encoding in [Encoding::SinglePhase, Encoding::Sequent, Encoding::Switch] {
        same(new().encoding(encoding), &["--encoding", encoding.name()]);
    }
    same(new().runtime(Runtime::Crate), &["--runtime", "crate"]);
    same(new().optimize(false), &["-O0"]);
    same(new().evolution(Evolution::Scan), &["--evolution", "scan"]);
    same(new().initial_actions(false), &["--initial-actions", "off"]);
    same(new().bound(7), &["--bound", "7"]);
    same(new().bound(0), &["--bound", "1"]);
    same(new().reset_input("again"), &["--reset-input", "again"]);
    same(
        new().reset_input("again").reset_keeps_retained(true).clear_flags_input("ack"),
        &["--reset-input", "again", "--reset-keeps-retained", "--clear-flags-input", "ack"],
    );
}

#[test]
fn the_name_of_module_and_file_can_be_chosen() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    build(&folder).module("LeftValve").try_compile().unwrap();
    assert!(folder.read("LeftValve.rs").starts_with("pub mod left_valve {\n"));
    build(&folder).module("type").try_compile().unwrap();
    let code = folder.read("type.rs");
    assert!(code.starts_with("pub mod ") && !code.starts_with("pub mod type {"), "{code}");
}

#[test]
fn errors_are_said_as_the_command_line_says_them() {
    let two_faults = FAULTY.replace("input  a", "input  a, a");
    let folder = Folder::new(&[("valve.gct", &two_faults), ("bytes.gct", "")]);
    std::fs::write(folder.path("bytes.gct"), b"initial step 1 \xFF\n").unwrap();
    for chart in ["valve.gct", "bytes.gct", "missing.gct"] {
        let run = script(&folder, chart);
        let expected = folder.run(&[chart, "--target", "rust"]);
        assert!(expected.err.contains("error"), "{}", expected.err);
        assert_eq!((run.code, run.err.as_str()), (expected.code, expected.err.as_str()), "{chart}");
        // Cargo has to run the script again once the chart is right.
        assert_eq!(directives(&run), [format!("cargo::rerun-if-changed={chart}")]);
    }
    let both = script(&folder, "valve.gct");
    both.ends(1, "error[E0202]").ends(1, "error[E0201]").ends(1, "2 errors");
}

#[test]
fn after_an_error_the_old_code_is_still_there() {
    let folder = Folder::new(&[("valve.gct", FAULTY), ("valve.rs", "old")]);
    let error = build(&folder).try_compile().unwrap_err();
    assert_eq!(folder.read("valve.rs"), "old");
    assert_eq!(folder.names(), ["valve.gct", "valve.rs"]);
    assert!(error.to_string().starts_with("error[E0201]: "), "{error}");
    // It is `Debug` that is printed of an error that `main` returns.
    assert_eq!(format!("{error:?}"), error.to_string());
}

#[test]
fn warnings_go_to_cargo_line_by_line() {
    let folder = Folder::new(&[("valve.gct", DUBIOUS)]);
    let run = script(&folder, "valve.gct");
    run.is_done();
    let expected = folder.run(&["valve.gct", "--target", "rust"]).err;
    let expected: Vec<&str> = expected.lines().filter(|line| !line.is_empty()).collect();
    let (count, picture) = expected.split_last().unwrap();
    assert_eq!(*count, "1 warning");
    assert!(picture[0].starts_with("warning[W0403]: "), "{picture:?}");
    let said: Vec<&str> =
        directives(&run).into_iter().filter_map(|line| line.strip_prefix("cargo::warning=")).collect();
    assert_eq!(said, picture);
    assert!(folder.read("out/valve.rs").contains("pub struct "));
}

#[test]
fn what_cannot_be_written_is_named_with_its_reason() {
    let folder = Folder::new(&[("valve.gct", DUBIOUS), ("valve.rs", VALVE)]);
    let error = build(&folder).out_dir(folder.path("none")).try_compile().unwrap_err().to_string();
    assert!(error.contains("warning[W0403]") && error.contains("error: cannot write `"), "{error}");
    let error = Build::new(folder.path("valve.rs")).out_dir(folder.path(".")).try_compile().unwrap_err().to_string();
    assert!(error.contains("the output would overwrite `"), "{error}");
    assert_eq!(folder.read("valve.rs"), VALVE);
    assert_eq!(std::env::var_os("OUT_DIR").map(PathBuf::from), None);
    let error = Build::new(folder.path("valve.gct")).try_compile().unwrap_err().to_string();
    assert!(error.contains("there is no `OUT_DIR`") && error.contains("help: "), "{error}");
}
