//! `grafc import`.

mod common;

use common::Folder;
use serde_json::Value;

/// One step; the grafcet around it has no name.
const ONE_STEP: &str = "\
<grafcet:Grafcet xmlns:grafcet=\"http://www.example.org/grafcet\" name=\"One\">
  <partialGrafcets>
    <steps initial=\"true\" id=\"7\"/>
  </partialGrafcets>
</grafcet:Grafcet>
";

const CHART: &str = "\
chart One

grafcet G1 {
  initial step 7
}
";

/// An arc to nowhere, and a step whose number is none.
const FAULTY: &str = "\
<grafcet:Grafcet xmlns:grafcet=\"http://www.example.org/grafcet\">
  <partialGrafcets>
    <steps id=\"seven\"/>
    <arcs source=\"//@partialGrafcets.0/@steps.0\" target=\"//@partialGrafcets.0/@steps.1\"/>
  </partialGrafcets>
</grafcet:Grafcet>
";

#[test]
fn the_chart_is_written_and_the_report_told() {
    let folder = Folder::new(&[("one.grafcet", ONE_STEP)]);
    let run = folder.run(&["import", "one.grafcet", "-o", "one.gct"]);
    run.ends(0, "warning[W0701]: a grafcet without a name is called `G1`").ends(0, "one.grafcet:2:3");
    assert_eq!(run.out, "");
    assert_eq!(std::fs::read_to_string(folder.path("one.gct")).unwrap(), CHART);
    assert_eq!(folder.run(&["fmt", "--check", "one.gct"]).is_done().out, "");
    assert_eq!(folder.run_with(&["import", "-"], ONE_STEP).out, CHART);
}

#[test]
fn the_report_can_be_read_by_tools() {
    let folder = Folder::new(&[("one.grafcet", ONE_STEP)]);
    let run = folder.run(&["import", "one.grafcet", "-o", "one.gct", "--format", "json"]);
    let message: Value = serde_json::from_str(&run.err).unwrap();
    assert_eq!((message["code"].as_str(), message["slug"].as_str()), (Some("W0701"), Some("import-changed")));
    assert_eq!((message["start"]["line"].as_u64(), message["start"]["column"].as_u64()), (Some(2), Some(3)));
}

#[test]
fn nothing_is_written_if_there_are_errors() {
    let folder = Folder::new(&[("faulty.grafcet", FAULTY), ("kept.gct", CHART)]);
    let run = folder.run(&["import", "faulty.grafcet", "-o", "kept.gct"]);
    run.ends(1, "E0705").ends(1, "E0704").ends(1, "2 errors");
    assert_eq!(std::fs::read_to_string(folder.path("kept.gct")).unwrap(), CHART);
    folder.run(&["import", "faulty.grafcet", "-o", "new.gct"]).ends(1, "");
    assert!(!folder.path("new.gct").exists());
}

#[test]
fn wrong_use_and_missing_files() {
    let folder = Folder::new(&[("one.grafcet", ONE_STEP)]);
    folder.run(&["import", "one.grafcet", "-o", "one.grafcet"]).ends(2, "would overwrite");
    folder.run(&["import", "two.grafcet"]).ends(3, "cannot read");
}

#[test]
fn bytes_that_are_not_utf8() {
    let folder = Folder::new(&[]);
    std::fs::write(folder.path("old.grafcet"), b"<grafcet:Grafcet name='F\xFCllen'/>").unwrap();
    folder.run(&["import", "old.grafcet"]).ends(1, "E0110").ends(1, "old.grafcet:1:25");
}
