//! Generated Rust is laid out as rustfmt does it, and clippy has nothing to say about it.
//!
//! Skipped, saying so, where the tool is missing: both come with rustup.

use grafc_backends::rust;
use grafc_logic::{Encoding, Options};
use grafc_model::reaction::Profile;
use grafc_testsuite::charts::{cases, charts_folder, check, vectors_folder};
use grafc_testsuite::rings::Rings;
use grafc_testsuite::runs::compile_saved;
use grafc_testsuite::share::is_thorough;
use grafc_testsuite::tools::{Tool, or_skip};
use std::fs;
use std::path::Path;
use std::process::Command;

/// Writes every chart in every encoding, every vector in one, and a chart of more steps than some things are derived
/// for, as a module of its own, every other one parted as large charts are; the modules.
fn write(folder: &Path) -> Vec<String> {
    let mut modules = Vec::new();
    let mut add = |name: &str, text: &str, profile: Profile, encoding: Encoding| {
        let chart = check(name, text).expect("a chart without errors");
        let simplify = modules.len() % 3 > 0;
        let program = compile_saved(&chart, &Options { profile, encoding, simplify }).expect("a program");
        let mut options = rust::Options { header: vec![format!("from {name}")], ..rust::Options::default() };
        if modules.len() % 2 == 1 {
            options.longest_function = 1 + modules.len() % 7;
        }
        let code = rust::emit(&program, &options).expect("a module");
        let module = format!("module_{}", modules.len());
        fs::write(folder.join(format!("{module}.rs")), code).expect("a file in a temporary folder");
        modules.push(module);
    };
    add("a large ring", &Rings::one(1001).chart(), Profile::default(), Encoding::Switch);
    // The encodings take turns.
    let turn = |place: usize| Encoding::ALL[place % Encoding::ALL.len()];
    for (place, case) in cases(&charts_folder()).into_iter().enumerate() {
        (0..if is_thorough() { 3 } else { 1 })
            .for_each(|way| add(&case.name, &case.text, case.profile, turn(3 * place + way)));
    }
    for (place, case) in cases(&vectors_folder()).into_iter().enumerate().step_by(if is_thorough() { 2 } else { 6 }) {
        add(&case.name, &case.text, case.profile, turn(place / 2));
    }
    modules
}

/// A command that is there, or nothing and a line that says which test lacks it.
fn find_or_skip(tool: Tool, name: &str) -> Option<Command> {
    let found = Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success());
    or_skip(tool, found.then(|| Command::new(name)).ok_or_else(|| format!("{name} cannot be called")))
}

fn run(mut command: Command) -> Result<(), String> {
    let output = command.output().expect("a tool that was there before");
    let said = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
    if output.status.success() { Ok(()) } else { Err(said) }
}

#[test]
fn rustfmt_changes_nothing() {
    let Some(mut rustfmt) = find_or_skip(Tool::Rustfmt, "rustfmt") else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let files = write(folder.path()).into_iter().map(|module| format!("{module}.rs"));
    rustfmt.args(["--check", "--edition", "2024"]).args(files).current_dir(folder.path());
    run(rustfmt).unwrap_or_else(|said| panic!("{said}"));
}

#[test]
fn clippy_is_silent() {
    let Some(mut clippy) = find_or_skip(Tool::Clippy, "clippy-driver") else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let library: String = write(folder.path()).iter().map(|module| format!("pub mod {module};\n")).collect();
    fs::write(folder.path().join("lib.rs"), library).expect("a file in a temporary folder");
    clippy.args(["--edition", "2024", "--crate-type", "lib", "--emit=metadata", "-D", "warnings", "-D", "clippy::all"]);
    clippy.arg("lib.rs").current_dir(folder.path());
    run(clippy).unwrap_or_else(|said| panic!("{said}"));
}
