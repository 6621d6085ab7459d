//! The pictures of the book are those that grafc draws now. `UPDATE_EXPECT=1` draws them anew.

use grafc_drawing::{Options, draw, svg};
use grafc_testsuite::binary::root;
use grafc_testsuite::charts::check;
use grafc_testsuite::markdown::{blocks, pages};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Pictures of charts that lie elsewhere: the picture, the chart, and the page that shows it.
const OF_CHARTS: [(&str, &str, &str); 1] =
    [("docs/pictures/weigh_mix_b4.svg", "testsuite/charts/weigh_mix_b4.gct", "docs/drawing.md")];

fn drawn(name: &str, text: &str) -> String {
    let chart = check(name, text).unwrap_or_else(|error| panic!("{error}"));
    let pictures = draw(&chart, &Options::default()).expect("a drawing");
    svg(&pictures[0], None)
}

fn compare(path: &Path, drawn: &str) {
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        fs::write(path, drawn).expect("the picture");
    }
    let known = fs::read_to_string(path).unwrap_or_default().replace("\r\n", "\n");
    assert!(known == drawn, "{} is not what grafc draws: UPDATE_EXPECT=1 draws it anew", path.display());
}

/// Whether a page shows a picture.
fn shows(page: &Path, text: &str, picture: &Path) -> bool {
    let folder = page.parent().expect("a page lies in a folder");
    let mut targets = text.split("](").skip(1).filter_map(|rest| rest.split_once(')'));
    targets.any(|(target, _)| folder.join(target) == picture)
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
    for page in pages(&root().join("docs")).into_iter().chain([root().join("README.md")]) {
        let text = fs::read_to_string(&page).expect("a page");
        for block in blocks(&text) {
            let Some(picture) = block.value("picture") else { continue };
            let picture = page.parent().expect("a folder").join(picture);
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
