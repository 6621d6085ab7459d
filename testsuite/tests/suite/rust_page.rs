//! `docs/rust.md`: its programs are compiled by rustc and do what the page shows.
//!
//! The project of cargo on it is `runtime-support/examples/blink`, which has a test of its own.

use grafc_testsuite::binary::root;
use grafc_testsuite::executors::rust::Tools;
use grafc_testsuite::markdown::{play, printed};
use std::process::Command;

#[test]
fn the_programs_of_the_page_do_what_it_shows() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut programs = 0;
    play(&root().join("docs/rust.md"), |folder, command| match command.split_once(' ') {
        Some(("rustc", arguments)) => Some(printed(tools.command().args(arguments.split(' ')), folder)),
        Some(("cargo", "run")) => None,
        None if command.starts_with("./") => {
            programs += 1;
            Some(printed(&mut Command::new(folder.join(command)), folder))
        }
        Some(_) | None => panic!("`{command}`: the test knows no such command"),
    });
    assert!(programs >= 2, "only {programs} programs were run");
}
