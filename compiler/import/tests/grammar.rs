//! The parser's tables that are kept are those of the grammar. `UPDATE_EXPECT=1` makes them again.

use std::path::Path;

#[test]
fn the_parser_is_that_of_the_grammar() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let made = Path::new(env!("CARGO_TARGET_TMPDIR")).join("grammar");
    std::fs::create_dir_all(&made).expect("a folder");
    let mut lalrpop = lalrpop::Configuration::new();
    lalrpop.set_in_dir(here.join("src/code")).set_out_dir(&made).force_build(true).log_quiet();
    lalrpop.process().expect("a grammar without conflicts");

    let (made, kept) = (made.join("grammar.rs"), here.join("generated/grammar.rs"));
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        std::fs::copy(&made, &kept).expect("the tables are put in their place");
    }
    let read = |path: &Path| std::fs::read_to_string(path).expect("a text");
    // Not `assert_eq`, which would print both.
    assert!(read(&made) == read(&kept), "the grammar has changed: run this test with UPDATE_EXPECT=1");
}
