use super::*;
use grafc_backends::{Target, plcopen, st};
use grafc_diagnostics::{Code, EditorPosition, Unit, render};
use grafc_logic::Encoding;
use grafc_model::symbols::{Entity, Mention};
use std::sync::Mutex;

/// Which stages were run, in order.
#[derive(Debug, Default)]
pub struct Runs(Mutex<Vec<&'static str>>);

impl Runs {
    pub fn count(&self, stage: &'static str) {
        self.0.lock().expect("nobody panicked").push(stage);
    }

    fn take(&self) -> Vec<&'static str> {
        std::mem::take(&mut *self.0.lock().expect("nobody panicked"))
    }
}

/// Two transitions leave step 1 that may clear together (W0409), which only a proof can tell from two that may not.
const VALVE: &str = "\
chart Valve
input  a, b, c : bool
output V : bool
initial step 1
step 2 { V }
step 3
transition 1 -> 2 : a and not b
transition 1 -> 3 : c and not b
transition 2 -> 1 : b
transition 3 -> 1 : b
";

fn codes(diagnostics: &Diagnostics) -> Vec<Code> {
    diagnostics.iter().map(|message| message.code).collect()
}

fn st() -> Target {
    Target::St(st::Options::default())
}

#[test]
fn each_stage_is_run_once_and_only_when_it_is_asked_for() {
    let document = Document::new("valve.gct", VALVE);
    assert!(document.runs.take().is_empty());
    // What a keystroke asks for waits for no proof.
    assert!(document.diagnostics().is_empty());
    // The chart, its grafcet, four variables, three steps, four transitions.
    assert_eq!(document.symbols().definitions().len(), 13);
    assert_eq!(document.runs.take(), ["tree", "checked"]);
    assert_eq!(codes(document.warnings()), [Code::W0409]);
    assert_eq!(document.runs.take(), ["net", "analysis", "warnings"]);
    let code = document.emit(&st()).expect("code").text;
    assert_eq!(document.runs.take(), ["program"]);
    assert_eq!(document.emit(&st()).expect("code").text, code);
    assert_eq!(codes(document.warnings()), [Code::W0409]);
    assert!(document.runs.take().is_empty());
}

#[test]
fn what_the_text_allows_is_set_aside() {
    let allow = "{ allow W0409 \"why\" }";
    let document = Document::new("valve.gct", VALVE.replace("c and not b\n", &format!("c and not b {allow}\n")));
    assert!(document.warnings().is_empty());
    assert_eq!(document.warnings().allowed().len(), 1);
    // In the other one of two transitions it is the same warning, in one that has nothing to do with it it is not.
    let document = Document::new("valve.gct", VALVE.replace("a and not b\n", &format!("a and not b {allow}\n")));
    assert!(document.warnings().is_empty());
    let document = Document::new("valve.gct", VALVE.replace("step 3\n", &format!("step 3 {allow}\n")));
    assert_eq!(codes(document.warnings()), [Code::W0425, Code::W0409]);
    let document = Document::new("valve.gct", VALVE.replace("step 3\n", "step 3\nallow W0409 \"why\"\n"));
    assert!(document.warnings().is_empty());
}

#[test]
fn a_target_runs_no_stage_but_its_own() {
    let document = Document::new("valve.gct", VALVE);
    let drawing = plcopen::Options { body: plcopen::Body::Sfc, ..plcopen::Options::default() };
    // Two transitions that may clear together cannot be drawn.
    let refused = document.emit(&Target::Plcopen(drawing)).expect_err("no drawing");
    assert_eq!(codes(&refused), [Code::E0503]);
    assert_eq!(document.runs.take(), ["tree", "checked", "net", "analysis", "sequence"]);
}

#[test]
fn other_options_run_what_depends_on_them() {
    let mut document = Document::new("valve.gct", VALVE);
    document.emit(&st()).expect("code");
    document.runs.take();
    let options = *document.options();
    document.set_options(options);
    document.emit(&st()).expect("code");
    assert!(document.runs.take().is_empty());

    document.set_options(Options { encoding: Encoding::Switch, ..options });
    document.emit(&st()).expect("code");
    assert_eq!(document.runs.take(), ["program"]);

    // Where steps overlap there is another net, once.
    document.set_options(Options { encoding: Encoding::RTrigger, ..options });
    document.emit(&st()).expect("code");
    assert_eq!(document.runs.take(), ["net", "analysis", "program"]);
    document.set_options(Options { encoding: Encoding::STrigger, ..options });
    document.emit(&st()).expect("code");
    assert_eq!(document.runs.take(), ["program"]);
}

#[test]
fn another_text_runs_all_that_is_asked_for_again() {
    let mut document = Document::new("valve.gct", VALVE);
    document.emit(&st()).expect("code");
    document.runs.take();
    let at = VALVE.find(": c").expect("a condition") + 2;
    document.edit(at..at + 1, "c and not a").expect("an edit");
    assert_eq!(document.text(), VALVE.replace(": c", ": c and not a"));
    assert!(document.warnings().is_empty());
    assert_eq!(document.runs.take(), ["tree", "checked", "net", "analysis", "warnings"]);
    assert!(document.emit(&st()).expect("code").text.contains("NOT a"));
}

#[test]
fn a_text_with_errors_gives_its_tree_its_names_and_as_much_chart_as_there_is() {
    // One line cannot be read, and one names a step that is not there.
    let text = VALVE.replace("step 3\n", "step 3 {\n").replace("2 -> 1 : b", "2 -> 9 : b");
    let document = Document::new("valve.gct", text);
    assert_eq!(codes(document.diagnostics()), [Code::E0107], "what may stand in the rest is not said to be missing");
    assert!(!document.tree().items.is_empty());
    assert!(document.chart().is_none() && document.net().is_none() && document.program().is_none());
    let labels: Vec<&str> = document.tables().steps.iter().map(|step| step.label.as_str()).collect();
    assert_eq!(labels[..2], ["1", "2"]);
    assert!(document.warnings().is_empty());
    assert_eq!(codes(&document.emit(&st()).expect_err("no code")), [Code::E0107]);

    // The name of the output leads from its use to its declaration.
    let used = document.text().find("{ V }").expect("an action") as u32 + 2;
    let Some(Mention::Use(found)) = document.symbols().at(used) else { panic!("no name") };
    assert!(matches!(found.entity, Entity::Variable(_)));
    let declared = document.symbols().definition(found.entity).and_then(|definition| definition.name);
    assert_eq!(declared.map(|span| &document.text()[span.range()]), Some("V"));
}

#[test]
fn edits_that_do_not_fit_change_nothing() {
    let mut document = Document::new("ä.gct", "// ä\ninitial step 1\n");
    assert!(document.edit(4..4, "x").is_err(), "within a character");
    assert!(document.edit(90..91, "x").is_err());
    #[expect(clippy::reversed_empty_ranges, reason = "that is what is tested")]
    let reversed = 3..1;
    assert!(document.edit(reversed, "x").is_err());
    assert!(document.edit(0..usize::MAX, "x").is_err());
    assert_eq!(document.text(), "// ä\ninitial step 1\n");
    document.edit(3..5, "𝄞𝄞").expect("an edit");
    assert_eq!(document.text(), "// 𝄞𝄞\ninitial step 1\n");
    // After the second of two characters that take four bytes in UTF-8 and two units in UTF-16 each.
    assert_eq!(document.source().place(11, Unit::Utf16), EditorPosition { line: 0, column: 7 });
    assert_eq!(document.source().byte(EditorPosition { line: 1, column: 8 }, Unit::Utf16), 12 + 8);
}

#[test]
fn messages_are_rendered_with_the_text_that_they_are_about() {
    let mut document = Document::new("valve.gct", VALVE.replace(": b\n", ": d\n"));
    assert_eq!(codes(document.diagnostics()), [Code::E0201, Code::E0201]);
    let text = render::human(document.sources(), document.diagnostics(), false);
    assert!(text.contains("valve.gct:9:21"), "{text}");
    document.set_text(VALVE);
    assert!(document.diagnostics().is_empty());
}

#[test]
fn a_chart_without_a_heading_is_named_after_its_file() {
    let document = Document::new("plant/left valve.gct", VALVE.replace("chart Valve\n", ""));
    assert_eq!(document.chart().map(|chart| chart.name.as_str()), Some("left valve"));
    let document = document.named("right");
    assert_eq!(document.chart().map(|chart| chart.name.as_str()), Some("right"));
}

#[test]
fn threads_may_share_a_document() {
    let document = Document::new("valve.gct", VALVE);
    std::thread::scope(|scope| {
        let proofs = scope.spawn(|| codes(document.warnings()));
        assert!(document.diagnostics().is_empty());
        assert_eq!(proofs.join().expect("no panic"), [Code::W0409]);
    });
}
