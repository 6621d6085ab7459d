//! What the fuzz targets in `testsuite/fuzz` look for holds for the texts that they begin with, and for what they have
//! found before.

use grafc_testsuite::fuzzing::{TARGETS, importer, pipeline, seeds, trace};

#[test]
fn every_target_has_seeds() {
    for target in TARGETS {
        assert!(seeds(target).len() >= 3, "{target} has hardly any seeds");
    }
}

#[test]
fn imports_keep_the_rules() {
    seeds("importer").iter().for_each(|(_, text)| importer(text));
}

#[test]
fn traces_keep_the_rules() {
    seeds("trace").iter().for_each(|(_, text)| trace(text));
}

#[test]
fn charts_keep_the_rules() {
    seeds("pipeline").iter().for_each(|(_, text)| pipeline(text));
}
