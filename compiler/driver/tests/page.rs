//! `grafc page`.

mod common;

use common::{FAULTY, Folder, VALVE};

#[test]
fn a_page_is_one_file() {
    let folder = Folder::new(&[("a.gct", VALVE)]);
    let printed = folder.run(&["page", "a.gct"]).is_done().out.clone();
    for part in
        ["<!DOCTYPE html>", "<html lang=\"en\">", "<title>Valve</title>", "data-control=\"run\"", "data-step=\"1\""]
    {
        assert!(printed.contains(part), "{part} is not in the page");
    }
    folder.run(&["page", "a.gct", "-o", "a.html"]).is_done();
    assert_eq!(folder.read("a.html"), printed);
    assert_eq!(folder.names(), ["a.gct", "a.html"]);
    let german = folder.run(&["page", "a.gct", "--language", "de"]).is_done().out.clone();
    assert!(german.contains("<html lang=\"de\">") && german.contains(">Eingänge<"));
}

#[test]
fn nothing_is_written_for_a_chart_with_errors() {
    let folder = Folder::new(&[("a.gct", FAULTY)]);
    folder.run(&["page", "a.gct", "-o", "a.html"]).ends(1, "error[");
    assert_eq!(folder.names(), ["a.gct"]);
}

#[test]
fn a_warning_that_is_denied_is_an_error() {
    // Both transitions may be cleared together (W0409).
    let text = "input a, b : bool\ninitial step 1\nstep 2\nstep 3\n\
        transition 1 -> 2 : a\ntransition 1 -> 3 : b\ntransition 2 -> 1 : b\ntransition 3 -> 1 : a\n";
    let folder = Folder::new(&[("a.gct", text)]);
    folder.run(&["page", "a.gct", "-o", "a.html", "-D", "warnings"]).ends(1, "error[");
    assert_eq!(folder.names(), ["a.gct"]);
    folder.run(&["page", "a.gct", "-o", "a.gct"]).ends(2, "the output would overwrite");
    folder.run(&["page", "a.gct", "--language", "fr"]).ends(2, "invalid value 'fr'");
}
