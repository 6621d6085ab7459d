//! The architecture page and its picture name what there is.

use grafc_testsuite::binary::root;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

const PAGE: &str = "docs/ARCHITECTURE.md";

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Folders below `folder` that hold Rust, by their paths from the root of the workspace.
fn folders_of_rust(folder: &Path, found: &mut BTreeSet<String>) {
    let entries: Vec<PathBuf> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    if entries.iter().any(|path| path.extension().is_some_and(|extension| extension == "rs")) {
        let path = folder.strip_prefix(root()).expect("below the root");
        found.insert(path.to_string_lossy().replace('\\', "/"));
    }
    for folder in entries.iter().filter(|path| path.is_dir()) {
        folders_of_rust(folder, found);
    }
}

/// All folders of sources, tests of their own and what is made aside.
fn sources() -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for top in ["compiler", "backends", "runtime-support", "testsuite"] {
        folders_of_rust(&root().join(top), &mut found);
    }
    let is_aside = |path: &String| {
        let mut parts = path.split('/');
        let below_src = parts.by_ref().any(|part| part == "src");
        !(below_src || path.ends_with("/generated") || path.ends_with("/fuzz_targets"))
            || path.split('/').any(|part| part == "target")
    };
    found.retain(|path| !is_aside(path));
    found
}

/// What stands in backquotes.
fn quoted(text: &str) -> BTreeSet<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

#[test]
fn each_folder_has_its_words() {
    let page = read(PAGE);
    let named = quoted(&page);
    let missing: Vec<String> = sources().into_iter().filter(|folder| !named.contains(folder.as_str())).collect();
    assert_eq!(missing, Vec::<String>::new(), "folders that {PAGE} does not name");
}

#[test]
fn each_folder_that_is_named_is_there() {
    let page = read(PAGE);
    let is_folder = |name: &&str| {
        ["compiler/", "backends/", "testsuite/", "runtime-support/"].iter().any(|top| name.starts_with(top))
    };
    let gone: Vec<&str> =
        quoted(&page).into_iter().filter(is_folder).filter(|name| !root().join(name).exists()).collect();
    assert_eq!(gone, Vec::<&str>::new(), "folders that {PAGE} names and that are not there");
}

#[test]
fn the_picture_is_that_of_its_source() {
    let source = read("docs/pictures/architecture.dot");
    let picture = read("docs/pictures/architecture.svg").replace("&#45;", "-").replace("&#39;", "'");
    let labels = source.lines().filter_map(|line| line.split("label=\"").nth(1)?.split('"').next());
    for line in labels.flat_map(|label| label.split("\\n")).map(str::trim) {
        assert!(picture.contains(line), "the picture lacks `{line}`: make it again, as the source says");
    }
    for name in read("Cargo.toml").lines().filter_map(|line| line.trim().strip_prefix("\"")?.split('"').next()) {
        let is_part = !name.contains("examples") && name != "testsuite" && !name.contains("fuzz");
        assert!(!is_part || source.contains(&format!("label=\"{name}\\n")), "the picture lacks the crate `{name}`");
    }
}
