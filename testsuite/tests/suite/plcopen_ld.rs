//! Charts drawn as ladder diagrams: right by the lint and by other readers in every encoding; nothing stands on something
//! else, and wires run from pin to pin.

use grafc::{Options, Product};
use grafc_backends::Target;
use grafc_backends::plcopen::{self, Body, Dialect};
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_model::reaction::{Evolution, Profile};
use grafc_testsuite::charts::{cases, charts_folder, vectors_folder};
use grafc_testsuite::plcopen_lint::document::{Document, Id};
use grafc_testsuite::plcopen_lint::lint;
use grafc_testsuite::plcopen_sheet::{Flow, Sheet};
use grafc_testsuite::plcopen_tools;
use grafc_testsuite::share::share;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Numbers, delays, events, and conditions that nest.
const COUNT: &str = "\
chart Count \"counts parts\"
input  go, part, reset, slow : bool
input  speed : int
output run, full : bool
output n, m : int
var    k : int
initial step 1 \"wait\"
step 2 \"run\" { run if [speed > 5] and (part or not reset)  n := n + 1 on activation }
step 3 \"full\" { full  m := n / k on activation  k := k * 2 + n on event ↑part }
transition 1 -> 2 : go and ↑part
transition 2 -> 3 : [n >= 10]
transition 2 -> 1 : 2s/X2 and [n < 10]
transition 3 -> 1 : reset or (go and ([k <> 0] or part and slow))
";

/// Names that targets reserve or that differ in what is lost, comments that would end what they stand in.
const HOSTILE: &str = "\
chart `]]>` \"]]> *) </xhtml:p> END_FUNCTION_BLOCK & \u{1} (*\"
input вход \"]]> *)\", `a b`, BEGIN, begin_1, rungs, further, part_1, again, MOVE, on_X : bool
output `]]>`, `step`, ton, a__b : bool
output `)` : int
initial step шаг \"*) ]]>\" { `]]>` }
step `(* *)` \"</content>\" { `step` ton if BEGIN  `)` := `)` + 1 on activation }
step Ж1 \"<&>\" { ton a__b }
transition (`]]>`) \"]]> <content>\" шаг -> `(* *)` : вход and not `a b` or rungs and (further or again and part_1)
transition `(* *)` -> Ж1 : BEGIN or MOVE
transition Ж1 -> шаг : 2s/begin_1 or on_X
";

fn ladder(name: &str, text: &str, encoding: Encoding, evolution: Evolution) -> String {
    let header = vec!["Made --by hand-- ]]> *) \u{2}".to_string()];
    let options = plcopen::Options { body: Body::Ld, header, ..plcopen::Options::default() };
    let lowering = Lowering { profile: Profile { evolution, ..Profile::default() }, encoding, simplify: true };
    let options = Options::new(lowering, Product::Code(Target::Plcopen(options)));
    let (made, diagnostics) = grafc::compile(FileId::default(), text, "chart", &options);
    made.unwrap_or_else(|| panic!("{name}: {diagnostics:?}")).text
}

/// All charts as ladders, by name: in both evolutions, the encodings in turn, some charts in all.
static LADDERS: LazyLock<Vec<(String, String)>> = LazyLock::new(|| {
    let mut all = Vec::new();
    for (name, text) in [("count", COUNT), ("hostile", HOSTILE)] {
        for encoding in Encoding::ALL {
            for evolution in [Evolution::Stable, Evolution::Scan] {
                all.push((format!("{name}, {}", encoding.name()), ladder(name, text, encoding, evolution)));
            }
        }
    }
    let charts = [charts_folder(), vectors_folder()].iter().flat_map(|folder| cases(folder)).collect::<Vec<_>>();
    for (turn, case) in charts.iter().enumerate() {
        let encodings: Vec<Encoding> = Encoding::ALL.into_iter().collect();
        for (place, evolution) in [Evolution::Stable, Evolution::Scan].into_iter().enumerate() {
            let encoding = encodings[(turn + place) % encodings.len()];
            let name = format!("{}, {}", case.name, encoding.name());
            all.push((name, ladder(&case.name, &case.text, encoding, evolution)));
        }
    }
    all
});

#[test]
fn ladders_are_right_by_the_lint_and_by_other_readers() {
    for (name, text) in LADDERS.iter() {
        assert_eq!(lint(text, Dialect::Neutral), [], "{name}: {text}");
        let read: plcopen_reader::Project = plcopen_reader::from_str(text).unwrap_or_else(|e| panic!("{name}: {e}"));
        let units = read.types.and_then(|types| types.pous).map(|pous| pous.pou).unwrap_or_default();
        let expected = if text.contains("REPEAT") { 3 } else { 2 };
        assert_eq!(units.len(), expected, "{name}");
    }
    let documents: Vec<String> = share(0, LADDERS.iter().map(|(_, text)| text.clone()));
    plcopen_tools::take_or_skip(&documents);
}

#[test]
fn nothing_stands_on_something_else() {
    for (name, text) in LADDERS.iter() {
        let document = Document::read(text).expect("XML");
        assert_eq!(sheet(&document).stands_clear(), Ok(()), "{name}");
    }
}

#[test]
fn wires_end_at_pins_and_run_square_and_to_the_right() {
    for (name, text) in LADDERS.iter() {
        let document = Document::read(text).expect("XML");
        assert_eq!(sheet(&document).is_wired(Flow::Right), Ok(()), "{name}");
    }
}

fn sheet(document: &Document) -> Sheet<'_> {
    Sheet::of(document, "LD").expect("a ladder")
}

/// Names stand above contacts and coils: they need room to the left and to the right.
#[test]
fn names_do_not_run_into_each_other() {
    for (name, text) in LADDERS.iter() {
        let document = Document::read(text).expect("XML");
        let mut rows: BTreeMap<i64, Vec<(i64, i64)>> = BTreeMap::new();
        let sheet = sheet(&document);
        for &object in sheet.objects() {
            let Some(variable) = document.child(object, "variable") else { continue };
            let [left, top, right, _] = sheet.frame(object).expect("a frame");
            let half = 7 * i64::try_from(document.get(variable).text.chars().count()).expect("a length") / 2;
            let middle = (left + right) / 2;
            rows.entry(top).or_default().push((middle - half, middle + half));
        }
        for row in rows.values_mut() {
            row.sort_unstable();
            assert!(row.windows(2).all(|pair| pair[0].1 < pair[1].0), "{name}: {row:?}");
        }
    }
}

/// The ways from the left rail to an object, as the names on them.
fn ways(document: &Document, objects: &BTreeMap<&str, Id>, pin: Id) -> Vec<String> {
    let mut ways = Vec::new();
    for wire in document.children(pin, "connection") {
        let from = objects[document.attribute(wire, "refLocalId").expect("from something")];
        let Some(variable) = document.child(from, "variable") else {
            ways.push(String::new());
            continue;
        };
        let not = if document.attribute(from, "negated") == Some("true") { "/" } else { "" };
        let before = self::ways(document, objects, document.child(from, "connectionPointIn").expect("an input"));
        let name = &document.get(variable).text;
        ways.extend(before.iter().map(|way| format!("{way} {not}{name}").trim().to_string()));
    }
    ways
}

/// The coils, in order, with the ways to them: `a /b | c -> S y`.
fn coils(text: &str) -> Vec<String> {
    let document = Document::read(text).expect("XML");
    let sheet = sheet(&document);
    let objects = sheet.numbered();
    let coil = |id: &Id| {
        let storage = match document.attribute(*id, "storage") {
            Some("set") => "S ",
            Some("reset") => "R ",
            _ => "",
        };
        let name = &document.get(document.child(*id, "variable").expect("a name")).text;
        let ways = ways(&document, &objects, document.child(*id, "connectionPointIn").expect("an input"));
        format!("{} -> {storage}{name}", ways.join(" | "))
    };
    sheet.objects().iter().filter(|id| document.name(**id) == "coil").map(coil).collect()
}

/// The gate of the book: three steps in a ring.
const GATE: &str = "\
input  open, opened, closed : bool
output up, down : bool
initial step 1
step 2 { up }
step 3 { down }
transition 1 -> 2 : open
transition 2 -> 3 : opened and not open
transition 3 -> 1 : closed
";

#[test]
fn the_encodings_as_ladders() {
    let gate = |encoding| coils(&ladder("gate", GATE, encoding, Evolution::Scan));
    let start = ["/started -> S X1", "/started -> S started"];
    let outputs = ["X2 -> up", "X3 -> down"];
    let all = |body: &[&'static str]| [&start[..], body, &outputs[..]].concat();
    assert_eq!(
        gate(Encoding::SinglePhase),
        all(&[
            "X1 open -> clr_1_2",
            "X2 opened /open -> clr_2_3",
            "X3 closed -> clr_3_1",
            "clr_1_2 -> R X1",
            "clr_3_1 -> S X1",
            "clr_2_3 -> R X2",
            "clr_1_2 -> S X2",
            "clr_3_1 -> R X3",
            "clr_2_3 -> S X3",
        ])
    );
    // Reset by the step after it, which wins.
    let r_trigger = gate(Encoding::RTrigger);
    assert!(r_trigger.contains(&"/X2 X3 closed | /X2 X1 -> next_1".to_string()), "{r_trigger:?}");
    // A transition has one rung; what it reads itself it writes last.
    let sequent = gate(Encoding::Sequent);
    let at = sequent.iter().position(|coil| coil == "X3 closed -> S X1").expect("the transition 3 -> 1");
    assert_eq!(sequent[at + 1], "X3 closed -> R X3");
}

/// The reader walks backwards through wires: what branches off a contact has it on all its ways.
#[test]
fn conditions_that_nest() {
    let text = ladder("count", COUNT, Encoding::SinglePhase, Evolution::Scan);
    let coils = coils(&text);
    // k <> 0 is the fourth thing with a rung of its own, after the first call, n >= 10 and n < 10.
    for expected in
        ["X1 go rise_part -> clr_1_2", "go part_4 | go part slow -> part_5", "X3 reset | X3 part_5 -> clr_3_1"]
    {
        assert!(coils.iter().any(|coil| coil == expected), "{expected} in {coils:#?}");
    }
}

#[test]
fn comments_name_transitions_and_steps() {
    let text = ladder("count", COUNT, Encoding::SinglePhase, Evolution::Scan);
    let document = Document::read(&text).expect("XML");
    let comments = document.all("content").map(|id| document.get(document.get(id).children[0]).text.as_str());
    let comments: Vec<&str> = comments.collect();
    for expected in ["transitions that clear", "2 -> 1", "X1: wait", "X3: full", "outputs"] {
        assert!(comments.contains(&expected), "{expected} in {comments:?}");
    }
}
