//! `docs/rust.md`: its programs are compiled by rustc and do what the page shows.
//!
//! The project of cargo on it is `runtime-support/examples/blink`, which has a test of its own.

use grafc_testsuite::binary::{grafc, root};
use grafc_testsuite::executors::rust::Tools;
use grafc_testsuite::markdown::{blocks, matches, write_files};
use std::path::Path;
use std::process::Command;

#[test]
fn the_programs_of_the_page_do_what_it_shows() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let page = std::fs::read_to_string(root().join("docs/rust.md")).expect("the page");
    let blocks = blocks(&page);
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_files(&blocks, folder.path());
    let mut programs = 0;
    for block in blocks.iter().filter(|b| b.language == "console") {
        for (command, shown) in block.commands() {
            let printed = match command.split_once(' ') {
                Some(("grafc", arguments)) => run(grafc().args(arguments.split(' ')), folder.path()),
                Some(("rustc", arguments)) => run(tools.command().args(arguments.split(' ')), folder.path()),
                Some(("cargo", "run")) => continue,
                None if command.starts_with("./") => {
                    programs += 1;
                    run(&mut Command::new(folder.path().join(&command)), folder.path())
                }
                Some(_) | None => panic!("`{command}`: the test knows no such command"),
            };
            assert!(matches(&shown, &printed), "`{command}` printed\n{printed}\nbut the page shows\n{shown}");
        }
    }
    assert!(programs >= 2, "only {programs} programs were run");
}

/// What a command prints, warnings included; it must do its work.
fn run(command: &mut Command, folder: &Path) -> String {
    let output = command.current_dir(folder).output().unwrap_or_else(|e| panic!("{command:?}: {e}"));
    let printed = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    assert!(output.status.success(), "{command:?}: {}\n{printed}", output.status);
    printed
}
