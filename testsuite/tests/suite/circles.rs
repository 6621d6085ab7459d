//! No file uses another that uses it in turn, over however many others: who wants to read one knows where to begin.
//!
//! What a file uses is read from its paths. A name counts for the file that defines it, not for the one that hands it on
//! with `pub use`. A folder's `mod.rs` may use what lies in the folder, which it puts together.

use grafc_testsuite::binary::root;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// A module by its path within its crate, or a name in one.
type Name = Vec<String>;

/// All entries of a folder.
fn entries(folder: &Path) -> Vec<PathBuf> {
    fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect()
}

/// All files of Rust below a folder.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for path in entries(folder) {
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// The folders of sources, one a crate.
fn crates(folder: &Path, found: &mut Vec<PathBuf>) {
    for path in entries(folder).into_iter().filter(|path| path.is_dir()) {
        if path.ends_with("src") {
            found.push(path);
        } else if !path.ends_with("target") && !path.ends_with("templates") {
            crates(&path, found);
        }
    }
}

/// The module that a file is.
fn module(sources: &Path, file: &Path) -> Name {
    let path = file.strip_prefix(sources).expect("below the sources").with_extension("");
    let mut name: Name = path.iter().map(|part| part.to_string_lossy().into_owned()).collect();
    if name.last().is_some_and(|last| last == "mod") || name == ["lib"] {
        name.pop();
    }
    name
}

/// A file without comments and the tests in it.
fn code(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let begins_tests = |two: &[&str]| two[0] == "#[cfg(test)]" && two[1].starts_with("mod ") && two[1].ends_with('{');
    let end = lines.windows(2).position(begins_tests).unwrap_or(lines.len());
    let kept: Vec<&str> = lines[..end].iter().map(|line| line.split("//").next().unwrap_or_default()).collect();
    kept.join("\n")
}

/// Each path of a tree as it stands in `use`, such as `crate::a::{b, c as d}`.
fn spread(tree: &str) -> Vec<Name> {
    let mut names = Vec::new();
    let mut path = Name::new();
    // How long the path is before each brace.
    let mut open: Vec<usize> = Vec::new();
    let (mut word, mut is_over) = (String::new(), false);
    for c in tree.chars().chain([',']) {
        match c {
            ':' if word.is_empty() => {}
            ':' => path.push(std::mem::take(&mut word)),
            '{' => open.push(path.len()),
            ',' | '}' => {
                if !word.is_empty() {
                    path.push(std::mem::take(&mut word));
                    names.push(path.clone());
                }
                is_over = false;
                path.truncate(open.last().copied().unwrap_or(0));
                if c == '}' {
                    open.pop();
                    path.truncate(open.last().copied().unwrap_or(0));
                }
            }
            // What follows is `as` and another name.
            c if c.is_whitespace() => is_over = !word.is_empty(),
            c if !is_over => word.push(c),
            _ => {}
        }
    }
    names
}

/// The paths in a file, each with whether it is handed on: those of `use`, and what begins within the crate elsewhere.
fn paths(code: &str) -> Vec<(bool, Name)> {
    let mut found = Vec::new();
    let mut rest = code;
    while let Some(line) = rest.lines().next() {
        let words = line.trim_start();
        let hands_on = words.starts_with("pub");
        if words.starts_with("use ") || hands_on && words.contains(" use ") {
            let (statement, behind) = rest.split_once(';').unwrap_or((rest, ""));
            let tree = statement.split_once("use ").map_or("", |(_, tree)| tree);
            found.extend(spread(tree).into_iter().map(|name| (hands_on, name)));
            rest = behind;
            continue;
        }
        let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
        let names =
            line.split(|c| !is_part(c)).filter(|path| ["crate::", "super::"].iter().any(|word| path.starts_with(word)));
        found.extend(names.flat_map(spread).map(|name| (false, name)));
        rest = rest.split_once('\n').map_or("", |(_, rest)| rest);
    }
    found
}

/// A path from the root of the crate.
fn absolute(from: &[String], path: &[String]) -> Name {
    let mut whole: Name = from.to_vec();
    for part in path {
        match part.as_str() {
            "crate" => whole.clear(),
            "super" => _ = whole.pop(),
            "self" => {}
            _ => whole.push(part.clone()),
        }
    }
    whole
}

/// The files of a crate that lie on circles, or between two of them, each with those among them that it uses.
fn circles(texts: &BTreeMap<Name, String>) -> BTreeMap<&Name, BTreeSet<&Name>> {
    let all = texts.iter().flat_map(|(from, text)| {
        paths(&code(text)).into_iter().map(move |(hands_on, path)| (from, hands_on, absolute(from, &path)))
    });
    let all: Vec<(&Name, bool, Name)> = all.collect();
    let handed_on: BTreeMap<Name, &Name> = all
        .iter()
        .filter(|(_, hands_on, _)| *hands_on)
        .filter_map(|(from, _, to)| Some(([from.as_slice(), &[to.last()?.clone()]].concat(), to)))
        .collect();
    let mut uses: BTreeMap<&Name, BTreeSet<&Name>> = texts.keys().map(|name| (name, BTreeSet::new())).collect();
    for (from, _, to) in &all {
        let mut to = to;
        let mut seen = BTreeSet::new();
        while let Some(next) = handed_on.get(to).filter(|_| seen.insert(to)) {
            to = next;
        }
        let home = (0..=to.len()).rev().find_map(|length| texts.get_key_value(&to[..length]));
        if let Some((home, _)) = home
            && !home.starts_with(from)
        {
            uses.entry(from).or_default().insert(home);
        }
    }
    loop {
        let used: BTreeSet<&Name> = uses.values().flatten().copied().collect();
        let count = uses.len();
        uses.retain(|name, uses| used.contains(name) && !uses.is_empty());
        let left: BTreeSet<&Name> = uses.keys().copied().collect();
        uses.values_mut().for_each(|uses| uses.retain(|name| left.contains(name)));
        if uses.len() == count {
            return uses;
        }
    }
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    let mut folders = Vec::new();
    for top in ["compiler", "backends", "runtime-support", "testsuite"] {
        crates(&root().join(top), &mut folders);
    }
    assert!(folders.len() > 10, "{folders:?}");
    let mut told = String::new();
    for sources in folders {
        let mut found = Vec::new();
        files(&sources, &mut found);
        let read = |file: &PathBuf| fs::read_to_string(file).expect("a text");
        let texts = found.iter().map(|file| (module(&sources, file), read(file))).collect();
        for (name, uses) in circles(&texts) {
            let uses: Vec<String> = uses.iter().map(|name| name.join("::")).collect();
            told += &format!("{}: `{}` uses `{}`\n", sources.display(), name.join("::"), uses.join("`, `"));
        }
    }
    assert!(told.is_empty(), "what several files need goes into a file of its own:\n{told}");
}

#[test]
fn a_circle_is_found_through_names_that_are_handed_on() {
    let text = |name: &str, text: &str| (name.split("::").map(Into::into).collect::<Name>(), text.to_owned());
    let mut texts = BTreeMap::from([
        (Name::new(), "mod a;\nmod b;\npub use a::one::{One as First};\npub use self::b::Two;".to_owned()),
        text("a", "pub(crate) mod one;\nmod two;\npub(crate) use self::two::Three;\n"),
        text("a::one", "use super::Three; // crate::b\n#[cfg(test)]\nmod tests {\n    use crate::b::Two;\n}\n"),
        text("a::two", "use crate::{\n    b::{self, Two as Other},\n    c,\n};\n"),
        text("b", "fn f() -> crate::c::Four {}\n"),
        text("c", "use std::fmt;\n"),
    ]);
    assert_eq!(circles(&texts), BTreeMap::new());
    texts.extend([text("c", "use crate::a::one::One;")]);
    let on_circle: Vec<String> = circles(&texts).into_keys().map(|name| name.join("::")).collect();
    assert_eq!(on_circle, ["a::one", "a::two", "b", "c"]);
}
