//! Generated Rust where there is neither an operating system nor an allocator: `no_std`, with `panic=abort`.
//!
//! Everything goes into a static library, since that has to have all it needs: what would use `std` or allocate is
//! refused. It is built for this machine, and for a microcontroller where the toolchain has its `core`.

use grafc_backends::Target;
use grafc_backends::rust::{self, Runtime};
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options};
use grafc_testsuite::binary::root;
use grafc_testsuite::charts::{cases, charts_folder};
use grafc_testsuite::executors::rust::Tools;
use grafc_testsuite::share::share;
use grafc_testsuite::tools::{Tool, or_skip};
use std::fs;
use std::path::Path;

/// A Cortex-M4 or M7 with a floating point unit.
const MICROCONTROLLER: &str = "thumbv7em-none-eabihf";

/// What a library without `std` brings along itself.
const HEAD: &str = "\
#![no_std]
#![deny(warnings)]

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
";

/// Whatever needs something at run time: timers, elapsed times, counters, divisions of all types, every kind of action.
const NEEDY: &str = "\
chart Needy
input  go, p : bool
input  i : int
input  u : udint
input  r : real
input  l : lreal
output lamp : bool
output count : int
output share : udint
output part : real
output mean : lreal
var    pause : time := 3s
const  rest : time := 2s
initial step 1 { count := count + 1 on activation }
step 2 {
  lamp if 1s/X2/4s and p
  share := u / 3 mod u on event rise p
  part := r / 2.5 on deactivation
}
step 3
transition (t1) 1 -> 2 : rise go or fall p { mean := l / l }
transition (t2) 2 -> 3 : rest/X2 or [(T2 + pause) / 3 > rest]
transition (t3) 3 -> 1 : [i / count = 7 mod i] or 250ms/p
";

/// The names and texts of the charts that are built.
fn charts() -> Vec<(String, String)> {
    let mut charts = vec![("needy".to_string(), NEEDY.to_string())];
    charts.extend(cases(&charts_folder()).into_iter().map(|case| (case.name, case.text)));
    charts
}

/// Writes `lib.rs`, with a module for each chart in each encoding, and `extra` at its end.
fn write(folder: &Path, runtime: Runtime, charts: &[(String, String)], extra: &str) {
    let mut library = HEAD.to_string();
    for (place, (name, text)) in charts.iter().enumerate() {
        for encoding in share(place, Encoding::ALL) {
            let module = format!("{name}_{}", encoding.name().replace('-', "_"));
            let product = rust::Options { runtime, module: Some(module), ..rust::Options::default() };
            let options = grafc::Options::new(
                Options { encoding, ..Options::default() },
                grafc::Product::Code(Target::Rust(product)),
            );
            let (code, diagnostics) = grafc::compile(FileId::new(0), text, name, &options);
            library.push_str(&code.unwrap_or_else(|| panic!("{name}: {diagnostics:#?}")).text);
        }
    }
    library.push_str(extra);
    fs::write(folder.join("lib.rs"), library).expect("a file in a temporary folder");
}

/// Builds `lib.rs`, and before it the run-time crate as it is without its features.
fn build(tools: &Tools, folder: &Path, target: Option<&str>) -> Result<(), String> {
    let common: Vec<&str> = ["--edition", "2024", "-C", "panic=abort"]
        .into_iter()
        .chain(target.iter().flat_map(|t| ["--target", t]))
        .collect();
    let runtime = root().join("runtime-support/src/lib.rs");
    let runtime = runtime.to_str().expect("a path of UTF-8");
    let arguments = ["--crate-name", "grafc_runtime", "--crate-type", "rlib", "-D", "warnings", runtime];
    tools.call(folder, &[&arguments, common.as_slice()].concat())?;
    let arguments = ["--crate-type", "staticlib", "--extern", "grafc_runtime=libgrafc_runtime.rlib", "lib.rs"];
    tools.call(folder, &[&arguments, common.as_slice()].concat())?;
    Ok(())
}

fn check(target: Option<&str>) {
    let Some(tools) = Tools::find_or_skip() else { return };
    if let Some(target) = target {
        let here = tools.has_target(target).then_some(());
        let here = here.ok_or_else(|| format!("rustc has no core for {target}; `rustup target add` brings it"));
        if or_skip(Tool::Microcontroller, here).is_none() {
            return;
        }
    }
    for runtime in [Runtime::Inline, Runtime::Crate] {
        let folder = tempfile::tempdir().expect("a temporary folder");
        write(folder.path(), runtime, &charts(), "");
        build(&tools, folder.path(), target).unwrap_or_else(|fault| panic!("{runtime:?}: {fault}"));
    }
}

#[test]
fn charts_need_no_operating_system() {
    check(None);
}

#[test]
fn charts_run_on_a_microcontroller() {
    check(Some(MICROCONTROLLER));
}

/// The test itself: it would find what uses `std`, and what allocates.
#[test]
fn what_needs_more_is_refused() {
    let Some(tools) = Tools::find_or_skip() else { return };
    for (extra, complaint) in [
        ("pub fn now() -> std::time::Instant { std::time::Instant::now() }", "std"),
        ("extern crate alloc;\npub fn some() -> alloc::vec::Vec<u8> { alloc::vec![1] }", "no global memory allocator"),
    ] {
        let folder = tempfile::tempdir().expect("a temporary folder");
        write(folder.path(), Runtime::Inline, &[], extra);
        let fault = build(&tools, folder.path(), None).expect_err(extra);
        assert!(fault.contains(complaint), "{fault}");
    }
}
