//! What a test does that lacks a tool: it says so and passes, or fails where the tool is required.

use grafc_testsuite::tools::{REQUIRE, Tool, or_skip};
use std::process::{Command, Output};

/// A test that lacks awlsim on any machine; the other test runs it as the ordinary run does.
#[test]
#[ignore = "lacks a tool on purpose"]
fn without_awlsim() {
    assert!(or_skip(Tool::Awlsim, Err::<(), _>("it is not here".to_string())).is_none());
}

fn run(required: &str) -> Output {
    let mut test = Command::new(std::env::current_exe().expect("the path of this test"));
    test.args(["--ignored", "--exact", "tools::without_awlsim", "--nocapture"]).env(REQUIRE, required);
    test.output().expect("this test runs")
}

#[test]
fn a_lack_is_told_and_where_it_matters_a_failure() {
    let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
    for required in ["", "matiec,ironplc"] {
        let output = run(required);
        assert!(output.status.success(), "{required}");
        assert!(text(output.stderr).contains("skipped: awlsim: it is not here"), "{required}");
    }
    for (required, said) in [
        ("awlsim", "GRAFC_REQUIRE names awlsim, which cannot be used: it is not here"),
        ("matiec, awlsim", "GRAFC_REQUIRE names awlsim"),
        ("all", "GRAFC_REQUIRE names awlsim"),
        ("awlism", "GRAFC_REQUIRE: there is no tool `awlism`; there are rustc, rustfmt, "),
    ] {
        let output = run(required);
        assert!(!output.status.success(), "{required}");
        let printed = text([output.stdout, output.stderr].concat());
        assert!(printed.contains(said), "{required}: {printed}");
    }
}
