//! The pictures of the book are those that grafc draws now. `UPDATE_EXPECT=1` draws them anew.

use grafc::Document;
use grafc_drawing::{Options, draw, svg};
use grafc_testsuite::binary::{grafc, root};
use grafc_testsuite::charts::check;
use grafc_testsuite::markdown::{blocks, pages, write_files};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Pictures of charts that lie elsewhere: the picture, the chart, and the page that shows it.
const OF_CHARTS: [(&str, &str, &str); 1] =
    [("docs/pictures/weigh_mix_b4.svg", "testsuite/charts/weigh_mix_b4.gct", "docs/drawing.md")];

/// Graphs of charts on pages: the picture, the page, and the file of the chart there.
const OF_GRAPHS: [(&str, &str, &str); 1] = [("docs/pictures/tools_graph.svg", "docs/graph.md", "tools.gct")];

fn drawn(name: &str, text: &str) -> String {
    let chart = check(name, text).unwrap_or_else(|error| panic!("{error}"));
    let pictures = draw(&chart, &Options::default()).expect("a drawing");
    svg(&pictures[0], None)
}

/// Fragments of charts, each the symbol of one row of the language: what they lack to be whole is left out of the picture.
const SYMBOLS: &str = "docs/pictures/symbols";

/// A fragment, as far as it goes; with `// only G1` in front, of that grafcet.
fn fragment(name: &str, text: &str) -> String {
    let document = Document::new(name, text);
    let grafcet = text.strip_prefix("// only ").and_then(|rest| rest.lines().next()).map(str::to_owned);
    svg(&draw(document.tables(), &Options { grafcet, ..Options::default() }).expect("a drawing")[0], None)
}

fn compare(path: &Path, drawn: &str) {
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        fs::write(path, drawn).expect("the picture");
    }
    let known = fs::read_to_string(path).unwrap_or_default().replace("\r\n", "\n");
    assert!(known == drawn, "{} is not what grafc draws: UPDATE_EXPECT=1 draws it anew", path.display());
}

/// Where a link of a page leads.
fn beside(page: &Path, target: &str) -> PathBuf {
    let mut path = page.parent().expect("a page lies in a folder").to_owned();
    for part in target.split('/') {
        match part {
            ".." => assert!(path.pop(), "{target} leads out of the world"),
            part => path.push(part),
        }
    }
    path
}

/// Whether a page shows a picture.
fn shows(page: &Path, text: &str, picture: &Path) -> bool {
    let mut targets = text.split("](").skip(1).filter_map(|rest| rest.split_once(')'));
    targets.any(|(target, _)| beside(page, target) == picture)
}

#[test]
fn symbols_are_what_grafc_draws() {
    let page = root().join("docs/language.md");
    let shown = fs::read_to_string(&page).expect("a page");
    let files = fs::read_dir(root().join(SYMBOLS)).expect("the folder").map(|entry| entry.expect("a file").path());
    let (charts, pictures): (Vec<PathBuf>, Vec<PathBuf>) =
        files.partition(|path| path.extension().is_some_and(|ending| ending == "gct"));
    assert!(charts.len() >= 30, "symbols are missing: only {} were found", charts.len());
    for chart in &charts {
        let name = chart.file_stem().and_then(|name| name.to_str()).expect("a name");
        let picture = chart.with_extension("svg");
        compare(&picture, &fragment(name, &fs::read_to_string(chart).expect("a fragment")));
        assert!(shows(&page, &shown, &picture), "{} does not show {}", page.display(), picture.display());
    }
    let of_nothing: Vec<&PathBuf> =
        pictures.iter().filter(|picture| !charts.contains(&picture.with_extension("gct"))).collect();
    assert!(of_nothing.is_empty(), "pictures of nothing: {of_nothing:?}");
}

#[test]
fn pictures_are_what_grafc_draws() {
    let mut known: BTreeSet<PathBuf> = BTreeSet::new();
    for (picture, chart, page) in OF_CHARTS {
        let text = fs::read_to_string(root().join(chart)).expect("a chart");
        let (picture, page) = (root().join(picture), root().join(page));
        compare(&picture, &drawn("chart", &text));
        let shown = fs::read_to_string(&page).expect("a page");
        assert!(shows(&page, &shown, &picture), "{} does not show {}", page.display(), picture.display());
        known.insert(picture);
    }
    for (picture, page, chart) in OF_GRAPHS {
        let (picture, page) = (root().join(picture), root().join(page));
        let shown = fs::read_to_string(&page).expect("a page");
        let folder = tempfile::tempdir().expect("a folder");
        write_files(&blocks(&shown), folder.path());
        let made =
            grafc().current_dir(folder.path()).args(["graph", chart, "--format", "svg"]).output().expect("grafc");
        compare(&picture, &String::from_utf8_lossy(&made.stdout));
        assert!(shows(&page, &shown, &picture), "{} does not show {}", page.display(), picture.display());
        known.insert(picture);
    }
    for page in pages(&root().join("docs")).into_iter().chain([root().join("README.md")]) {
        let text = fs::read_to_string(&page).expect("a page");
        for block in blocks(&text) {
            let Some(picture) = block.value("picture") else { continue };
            let picture = beside(&page, picture);
            compare(&picture, &drawn("chart", &block.text));
            assert!(shows(&page, &text, &picture), "{} does not show {}", page.display(), picture.display());
            known.insert(picture);
        }
    }
    let entries =
        fs::read_dir(root().join("docs/pictures")).expect("the folder").map(|entry| entry.expect("one").path());
    let made: Vec<PathBuf> = entries
        .filter(|path| path.extension().is_some_and(|ending| ending == "svg") && !path.with_extension("dot").exists())
        .filter(|path| !known.contains(path))
        .collect();
    assert!(made.is_empty(), "pictures of nothing: {made:?}");
}
