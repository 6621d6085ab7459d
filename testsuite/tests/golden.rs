//! The generated code of the example charts, word for word: so that a change of it is seen and read before it lands.
//!
//! A golden file proves nothing about meaning; that is what the other tests are for. `UPDATE_EXPECT=1` rewrites them.

use expect_test::expect_file;
use grafc::pipeline::{self, Options, Target};
use grafc_backends::st;
use grafc_diagnostics::FileId;
use grafc_logic::Encoding;
use grafc_testsuite::charts::{cases, charts_folder, check, is_flat};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("golden")
}

#[test]
fn the_generated_st_is_as_it_was_read_last() {
    let mut wanted = BTreeSet::new();
    for case in cases(&charts_folder()) {
        let chart = check(&case.name, &case.text).unwrap_or_else(|said| panic!("{said}"));
        if !is_flat(&chart) {
            continue;
        }
        let options = Options {
            profile: case.profile,
            encoding: Encoding::default(),
            target: Target::St(st::Options {
                header: vec![format!("from {}.gct", case.name)],
                ..st::Options::default()
            }),
        };
        let (code, said) = pipeline::compile(FileId::default(), &case.text, &case.name, &options);
        let code = code.unwrap_or_else(|| panic!("{}: {said:?}", case.name));
        let file = format!("{}.st", case.name);
        expect_file![folder().join(&file)].assert_eq(&code);
        wanted.insert(file);
    }
    assert!(wanted.len() >= 10, "only {} flat charts were found", wanted.len());
    let stale: Vec<String> = std::fs::read_dir(folder())
        .expect("the folder of golden files")
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| !wanted.contains(name))
        .collect();
    assert!(stale.is_empty(), "these golden files have no chart: {stale:?}");
}
