//! `docs/rust.md` shows this very project, and what it prints.

use std::path::Path;
use std::process::Command;

/// Where the page says that the copy of grafc lies, and where it does from here.
const PATHS: [(&str, &str); 2] = [("../grafc/runtime-support", "../.."), ("../grafc", "../../..")];

#[test]
fn the_page_shows_this_project_and_what_it_prints() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |path: &str| std::fs::read_to_string(here.join(path)).unwrap_or_else(|e| panic!("{path}: {e}"));
    let mut page = read("../../../docs/rust.md");
    for (said, is) in PATHS {
        page = page.replace(said, is);
    }
    for (language, path) in
        [("gct", "blink.gct"), ("toml", "Cargo.toml"), ("rust", "build.rs"), ("rust", "src/main.rs")]
    {
        let block = format!("```{language}\n{}```\n", read(path));
        assert!(page.contains(&block), "{path} is not shown");
    }
    // 50 ms dark, 50 ms lit, until the third time is over.
    let output = Command::new(env!("CARGO_BIN_EXE_blink")).output().expect("the program runs");
    let printed = String::from_utf8_lossy(&output.stdout);
    assert_eq!(printed, "on\noff\non\noff\non\noff\n");
    assert!(page.contains(&format!("```console\n$ cargo run\n{printed}```\n")), "what it prints is not shown");
}
