//! Sequential function charts of other tools: what they become, what is said about it, and that nothing breaks.
//!
//! `testsuite/imports/sfc` holds files, the charts `NAME.gct` and the reports `NAME.report`, written by hand.

use grafc_diagnostics::{Code, Diagnostics, FileId};
use grafc_import::{Dialect, Imported, Options};
use grafc_testsuite::binary;
use grafc_testsuite::runs::caught;
use std::time::Instant;

/// The files and the dialects that they are read in.
const FILES: [(&str, Option<Dialect>); 4] =
    [("filling.xml", None), ("sorting.txt", None), ("crane.xml", None), ("batch.txt", Some(Dialect::Isagraf))];

fn read(name: &str) -> String {
    let path = binary::root().join("testsuite/imports/sfc").join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn import(text: &str, options: &Options) -> Result<(String, Diagnostics), Diagnostics> {
    let (chart, diagnostics) = grafc_import::import(FileId::default(), text, options);
    assert_eq!(chart.is_none(), diagnostics.has_errors(), "a chart exactly if there is no error: {diagnostics:?}");
    chart.map(|chart| (chart, diagnostics.clone())).ok_or(diagnostics)
}

/// Codes and places of messages, as a report has them.
fn lines(text: &str, diagnostics: &Diagnostics) -> Vec<String> {
    let mut diagnostics = diagnostics.clone();
    diagnostics.sort_by_place();
    let place = |at: usize| {
        let before = &text[..at];
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
        format!("{}:{column}", before.matches('\n').count() + 1)
    };
    let line = |message: &grafc_diagnostics::Diagnostic| {
        format!("{} {}", message.code.as_str(), place(message.primary.span.range().start))
    };
    diagnostics.iter().map(line).collect()
}

/// Errors of an import, where they are; each says what to do.
fn faults(text: &str) -> Vec<String> {
    let diagnostics = import(text, &Options::default()).expect_err("it has errors");
    let helps = |d: &grafc_diagnostics::Diagnostic| d.help.is_some() || d.code.as_str().starts_with('W');
    assert!(diagnostics.iter().all(helps), "an error without help: {diagnostics:?}");
    lines(text, &diagnostics).into_iter().filter(|line| line.starts_with('E')).collect()
}

/// The report says nothing of a place that is not there, and what is written is a chart in canonical format.
fn holds(text: &str, found: &(Vec<Imported>, Diagnostics)) {
    let (charts, diagnostics) = found;
    assert_eq!(charts.is_empty(), diagnostics.has_errors(), "{diagnostics:?}");
    for message in diagnostics {
        assert_ne!(message.code, Code::E0901, "{message:?}\n{text}");
        let range = message.primary.span.range();
        assert!(text.get(range.clone()).is_some(), "no such place: {range:?}");
    }
    for chart in charts {
        let (tree, faults) = grafc_syntax::parse(FileId::default(), &chart.text);
        assert!(!faults.has_errors(), "{faults:?}\n{}", chart.text);
        assert_eq!(grafc_syntax::format(&chart.text, &tree), chart.text);
    }
}

#[test]
fn charts_and_reports_are_as_written_by_hand() {
    for (name, dialect) in FILES {
        let text = read(name);
        let options = Options { dialect, ..Options::default() };
        let (chart, diagnostics) =
            import(&text, &options).unwrap_or_else(|diagnostics| panic!("{name}: {diagnostics:?}"));
        let stem = name.split('.').next().expect("a name");
        assert_eq!(chart, read(&format!("{stem}.gct")), "{name}");
        let report = read(&format!("{stem}.report"));
        assert_eq!(lines(&text, &diagnostics), report.lines().collect::<Vec<_>>(), "{name}: {diagnostics:?}");
        assert!(grafc::check(FileId::new(0), &chart, name).0.is_some(), "{name}");
    }
}

/// Not one byte of a file can be missing so that something breaks.
#[test]
fn files_cut_off_anywhere_are_told() {
    for (name, dialect) in FILES {
        let text = read(name);
        let options = Options { dialect, ..Options::default() };
        for end in (0..text.len()).filter(|&end| text.is_char_boundary(end)) {
            let cut = &text[..end];
            let found = caught(|| Ok(grafc_import::import_all(FileId::default(), cut, &options)));
            holds(cut, &found.unwrap_or_else(|fault| panic!("{name}, {end} bytes: {fault}")));
        }
    }
}

/// Bytes changed, doubled and left out.
#[test]
fn damaged_files_give_an_error_or_charts() {
    let texts: Vec<String> = FILES.iter().map(|(name, _)| read(name)).collect();
    let (mut charts, mut errors) = (0, 0);
    for seed in 0..2_000 {
        let mut rng = fastrand::Rng::with_seed(seed);
        let text = grafc_testsuite::xmi::damaged(&texts[seed as usize % texts.len()], &mut rng);
        let dialect = [Dialect::Iec, Dialect::Codesys, Dialect::Isagraf][rng.usize(..3)];
        let options = Options { dialect: Some(dialect), ..Options::default() };
        let found = caught(|| Ok(grafc_import::import_all(FileId::default(), &text, &options)));
        let found = found.unwrap_or_else(|fault| panic!("seed {seed}: {fault}\n{text}"));
        holds(&text, &found);
        if found.0.is_empty() { errors += 1 } else { charts += 1 }
    }
    assert!(charts > 200 && errors > 200, "{charts} charts, {errors} errors");
}

/// A body with some elements, in a project around it.
fn body(elements: &str) -> String {
    format!(
        "<project><types><pous><pou name=\"P\" pouType=\"program\"><interface/><body><SFC>\n{elements}\n</SFC></body></pou>\
         </pous></types></project>"
    )
}

const STEP: &str = "<step localId=\"1\" name=\"A\" initialStep=\"true\"/>";

#[test]
fn what_is_wrong_is_an_error_at_its_place() {
    let transition = |from: u32| {
        format!(
            "<transition localId=\"2\"><connectionPointIn><connection refLocalId=\"{from}\"/></connectionPointIn></transition>"
        )
    };
    assert_eq!(faults("<project/>"), ["E0703 1:1"]);
    assert_eq!(faults("PROGRAM P END_PROGRAM"), ["E0703 1:1"]);
    assert_eq!(faults("some words"), ["E0703 1:1"]);
    // Two elements with one identity, one that is not there, a step without a name.
    assert_eq!(faults(&body(&format!("{STEP}\n{STEP}"))), ["E0704 3:1", "E0705 3:1"]);
    assert_eq!(faults(&body(&format!("{STEP}\n{}", transition(7)))), ["E0704 3:44"]);
    assert_eq!(faults(&body("<step localId=\"1\"/>")), ["E0705 2:1"]);
    assert_eq!(faults(&body("<step name=\"A\"/>")), ["E0705 2:1"]);
    let jump = "<jumpStep localId=\"3\" targetName=\"B\"><connectionPointIn><connection refLocalId=\"2\"/></connectionPointIn></jumpStep>";
    assert_eq!(faults(&body(&format!("{STEP}\n{}\n{jump}", transition(1)))), ["E0704 4:1"]);
    let block = "<actionBlock localId=\"2\"><connectionPointIn><connection refLocalId=\"1\"/></connectionPointIn>\n\
                 <action qualifier=\"Q\"><reference name=\"x\"/></action></actionBlock>";
    assert_eq!(faults(&body(&format!("{STEP}\n{block}"))), ["E0705 4:1"]);
    let two = "PROGRAM P\nINITIAL_STEP A END_STEP\nSTEP A END_STEP\nTRANSITION FROM A TO B := TRUE; END_TRANSITION\nEND_PROGRAM";
    assert_eq!(faults(two), ["E0705 3:6", "E0704 4:22"]);
    assert_eq!(
        faults("PROGRAM P\nINITIAL_STEP A : x(QQ); END_STEP\nTRANSITION := 1; END_TRANSITION"),
        ["E0705 1:9", "E0705 2:18", "E0705 3:1"]
    );
    // Several charts, none of them named.
    let both = "PROGRAM P INITIAL_STEP A END_STEP END_PROGRAM PROGRAM Q INITIAL_STEP A END_STEP END_PROGRAM";
    assert_eq!(faults(both), ["E0706 1:1"]);
    let one = Options { unit: Some("q".into()), ..Options::default() };
    assert!(import(both, &one).expect("a chart").0.contains("chart Q evolution scan\n"));
    let other = Options { unit: Some("R".into()), ..Options::default() };
    assert!(import(both, &other).expect_err("none").iter().all(|d| d.code == Code::E0703));
}

/// The messages of a text about the order of bodies, or about flags.
fn told(text: &str, dialect: Dialect, words: &str) -> Vec<String> {
    let options = Options { dialect: Some(dialect), ..Options::default() };
    let (_, report) = import(text, &options).unwrap_or_else(|diagnostics| panic!("{diagnostics:?}\n{text}"));
    report.iter().filter(|message| message.message.contains(words)).map(|message| message.message.clone()).collect()
}

/// In SFC a body reads what another has written before it in the same scan; in a chart it does not, but for what is stored
/// in each scan, whose values come after those of events (R15).
#[test]
fn a_value_that_is_written_and_read_in_one_scan_is_told() {
    let program = |steps: &str, transitions: &str, actions: &str| {
        format!(
            "PROGRAM P VAR go : BOOL; a, b, c : INT; END_VAR VAR_OUTPUT o : INT; END_VAR\n{steps}\n{transitions}\n{actions}\nEND_PROGRAM"
        )
    };
    let order = |text: &str| told(text, Dialect::Iec, "takes the value of before");
    let action = |name: &str, body: &str| format!("ACTION {name} : {body} END_ACTION\n");
    let arc = |from: &str, to: &str| format!("TRANSITION FROM {from} TO {to} := go; END_TRANSITION\n");
    let steps = "INITIAL_STEP S END_STEP STEP A : one(N); END_STEP STEP B : two(N); END_STEP";
    let both = arc("S", "(A, B)") + &arc("(A, B)", "S");
    let write = action("one", "a := a + 1;");
    // Steps that are active together: one writes what the other reads, as a value and as a condition.
    let value = "the step `B` reads `a` in a scan in which the step `A` writes it, and takes the value of before";
    assert_eq!(order(&program(steps, &both, &(write.clone() + &action("two", "o := a;")))), [value]);
    assert_eq!(
        order(&program(steps, &both, &(write.clone() + &action("two", "IF a > 3 THEN o := 1; END_IF;")))),
        [value]
    );
    // Nothing is told of what only one of them has to do with, nor where they follow each other.
    assert!(order(&program(steps, &both, &(write.clone() + &action("two", "o := b;")))).is_empty());
    let follow = arc("S", "A") + &arc("A", "B") + &arc("B", "S");
    assert!(order(&program(steps, &follow, &(write + &action("two", "o := a;")))).is_empty());
    // What is written at an exit is read by the next step's entry, and not before it by a body in each scan.
    let exit = |qualifier: &str| {
        format!("INITIAL_STEP S END_STEP STEP A : one(P0); END_STEP STEP B : two({qualifier}); END_STEP")
    };
    let bodies = action("one", "a := a + 1;") + &action("two", "o := a;");
    assert_eq!(order(&program(&exit("P1"), &follow, &bodies)), [value]);
    assert!(order(&program(&exit("N"), &follow, &bodies)).is_empty());
    let other_way = arc("S", "B") + &arc("B", "A") + &arc("A", "S");
    assert!(order(&program(&exit("P1"), &other_way, &bodies)).is_empty());
    // The condition of a body, in the scan of its step's entry.
    let own = "INITIAL_STEP S END_STEP STEP A : one(P1); two(N); END_STEP STEP B END_STEP";
    let bodies = action("one", "a := 0;") + &action("two", "IF a < 3 THEN a := a + 1; END_IF;");
    assert_eq!(
        order(&program(own, &follow, &bodies)),
        ["the step `A` reads `a` in the scan in which its entry writes it, and takes the value of before"]
    );
}

/// A delay of a chart begins in the scan after the one that makes its operand true; what stands behind the call of a timer
/// takes what it gives in the same scan.
#[test]
fn a_timer_that_is_read_behind_its_call_comes_a_scan_later() {
    let program = |body: &str, condition: &str| {
        format!(
            "PROGRAM P\nVAR_INPUT a : BOOL; END_VAR\nVAR busy, late : BOOL; t : TON; END_VAR\n\
             INITIAL_STEP S : each(S); END_STEP\nSTEP A : busy(N); END_STEP\n\
             TRANSITION FROM S TO A := a; END_TRANSITION\nTRANSITION FROM A TO S := {condition}; END_TRANSITION\n\
             ACTION each : {body} END_ACTION\nEND_PROGRAM\n"
        )
    };
    let told = |text: &str| {
        let (_, said) = import(text, &Options::default()).unwrap_or_else(|said| panic!("{said:?}\n{text}"));
        let late = said.iter().filter(|one| one.message.contains("as it was in the scan before"));
        late.map(|one| one.message.clone()).collect::<Vec<_>>()
    };
    let call = "t(IN := busy, PT := T#1s);";
    assert_eq!(
        told(&program(&format!("{call} late := t.Q;"), "late")),
        ["`t.Q` is taken here as it was in the scan before, since steps make its input"]
    );
    // Before the call it is that of the scan before in the file as well, and so it is in a condition.
    assert!(told(&program(&format!("late := t.Q; {call}"), "late")).is_empty());
    assert!(told(&program(call, "t.Q")).is_empty());
    // What is given is given at the beginning of the scan.
    assert!(told(&program("t(IN := a, PT := T#1s); late := t.Q;", "late")).is_empty());
}

/// A program, and one that it may command.
fn two(step: &str, bodies: &str, condition: &str, child: &str) -> String {
    format!(
        "PROGRAM Top\nVAR_INPUT a : BOOL; END_VAR\nINITIAL_STEP S1 : END_STEP\nSTEP S2 : {step} END_STEP\n\
         TRANSITION FROM S1 TO S2 := {condition}; END_TRANSITION\nTRANSITION FROM S2 TO S1 := NOT a; END_TRANSITION\n\
         {bodies}\nEND_PROGRAM\nPROGRAM Low\nVAR_INPUT b : BOOL; END_VAR\nINITIAL_STEP L1 : END_STEP\nSTEP L2 : {child} END_STEP\n\
         TRANSITION FROM L1 TO L2 := b; END_TRANSITION\nTRANSITION FROM L2 TO L1 := NOT b; END_TRANSITION\n\
         ACTION Back : GKILL(Top); END_ACTION\nEND_PROGRAM\n"
    )
}

/// Orders of ISaGRAF to programs of the same file, one by one: what stands in the chart, and what is said about it.
#[test]
fn orders_to_child_programs_become_pulse_orders() {
    let begin = "ACTION Begin : GSTART(Low); END_ACTION";
    let all: [(String, Dialect, &[&str], &[&str]); 11] = [
        (
            two("Begin(P1);", begin, "a", ""),
            Dialect::Iec,
            &["start Low on activation", "child grafcet Low of Top"],
            &[],
        ),
        (two("Begin(P0);", begin, "a", ""), Dialect::Iec, &["start Low on deactivation"], &[]),
        (two("Begin(N);", begin, "a", ""), Dialect::Iec, &["start Low on activation"], &["W0702 7:16"]),
        (
            two("Begin(N);", "ACTION Begin : IF a THEN GSTART(Low); END_IF; END_ACTION", "a", ""),
            Dialect::Iec,
            &["start Low on event ↑(XS2 and a)"],
            &["W0702 7:26"],
        ),
        (
            two("Begin(P1);", "ACTION Begin : IF a THEN GSTART(Low); END_IF; END_ACTION", "a", ""),
            Dialect::Iec,
            &["// lost: start Low"],
            &["W0703 7:26"],
        ),
        // What commands its father is no father.
        (
            two("Begin(P1);", begin, "a", "Back(P1);"),
            Dialect::Iec,
            &["child grafcet Low of Top", "// lost: GKILL(Top)"],
            &["W0703 15:15"],
        ),
        (two("Begin(P1);", begin, "a AND GSTATUS(Low) = 0", ""), Dialect::Iec, &["a and not FLow and not XLow"], &[]),
        (two("Begin(P1);", begin, "a AND GSTATUS(Low) <> 2", ""), Dialect::Iec, &["a and not FLow"], &[]),
        (two("Begin(P1);", begin, "a AND GSTATUS(Other) = 1", ""), Dialect::Iec, &["condition_1"], &["W0703 5:35"]),
        (two("Low(N);", "", "a", ""), Dialect::Isagraf, &["run Low"], &[]),
        (two("Low(S);", "", "a", ""), Dialect::Isagraf, &["start Low on activation"], &[]),
    ];
    for (text, dialect, words, report) in all {
        let options = Options { dialect: Some(dialect), ..Options::default() };
        let (chart, diagnostics) = import(&text, &options).unwrap_or_else(|said| panic!("{said:?}\n{text}"));
        for word in words {
            assert!(chart.contains(word), "{word} in\n{chart}");
        }
        assert_eq!(lines(&text, &diagnostics), report, "{diagnostics:?}\n{text}");
        assert!(grafc::check(FileId::new(0), &chart, "chart").0.is_some(), "{chart}");
    }
}

/// A program that nobody commands is a chart by itself, and one that is wanted by its name as well.
#[test]
fn who_is_commanded_is_no_chart_of_its_own() {
    let names = |text: &str, dialect, unit: Option<&str>| -> Vec<String> {
        let options = Options { dialect: Some(dialect), unit: unit.map(str::to_owned), ..Options::default() };
        let (charts, diagnostics) = grafc_import::import_all(FileId::default(), text, &options);
        assert!(!diagnostics.has_errors(), "{diagnostics:?}");
        charts.into_iter().map(|chart| chart.name).collect()
    };
    let begin = "ACTION Begin : GSTART(Low); END_ACTION";
    assert_eq!(names(&two("Begin(P1);", begin, "a", ""), Dialect::Iec, None), ["Top"]);
    assert_eq!(names(&two("Begin(P1);", begin, "a", ""), Dialect::Iec, Some("Low")), ["Low"]);
    // An action that no step has gives no order.
    assert_eq!(names(&two("", begin, "a", ""), Dialect::Iec, None), ["Top", "Low"]);
    assert_eq!(names(&two("Low(N);", "", "a", ""), Dialect::Iec, None), ["Top", "Low"]);
    assert_eq!(names(&two("Low(N);", "", "a", ""), Dialect::Isagraf, None), ["Top"]);
    // Two that command each other: the first is above.
    assert_eq!(names(&two("Begin(P1);", begin, "a", "Back(P1);"), Dialect::Iec, None), ["Top"]);
}

#[test]
fn flags_of_codesys_are_told() {
    let text = "PROGRAM P VAR SFCInit, go : BOOL; END_VAR INITIAL_STEP A END_STEP STEP B END_STEP\n\
                TRANSITION FROM A TO B := go; END_TRANSITION TRANSITION FROM B TO A := SFCPause; END_TRANSITION END_PROGRAM";
    let what = "would do to the chart, or tell of it, is lost";
    assert_eq!(told(text, Dialect::Codesys, what), [format!("what `SFCInit`, `SFCPause` {what}")]);
    assert!(told(text, Dialect::Iec, what).is_empty());
}

/// A text without a chart is told of at its first character, however many bytes that has.
#[test]
fn a_text_without_a_chart_is_told_of_at_a_character() {
    for text in ["\u{7de}", "\u{1f600} no chart", "x", ""] {
        holds(text, &grafc_import::import_all(FileId::default(), text, &Options::default()));
        assert_eq!(faults(text).len(), 1, "{text:?}");
    }
}

/// What blocks make before transitions comes a scan later in Beremiz, which is told once; a variable alone is no block.
#[test]
fn blocks_before_transitions_are_told_once() {
    let input = "<inVariable localId=\"10\"><connectionPointOut/><expression>a</expression></inVariable>\n";
    let pin = "<variable formalParameter=\"IN\"><connectionPointIn><connection refLocalId=\"10\"/></connectionPointIn></variable>";
    let block = format!(
        "<block localId=\"11\" typeName=\"NOT\"><inputVariables>{pin}</inputVariables><inOutVariables/><outputVariables/></block>\n"
    );
    let steps = "<step localId=\"2\" name=\"B\"><connectionPointIn><connection refLocalId=\"20\"/></connectionPointIn></step>\n";
    let told = |first: usize, second: usize| {
        let transition = |local: usize, from: usize, wired: usize| {
            format!(
                "<transition localId=\"{local}\"><connectionPointIn><connection refLocalId=\"{from}\"/></connectionPointIn>\
                 <condition><connectionPointIn><connection refLocalId=\"{wired}\"/></connectionPointIn></condition></transition>\n"
            )
        };
        let jump = "<jumpStep localId=\"30\" targetName=\"A\"><connectionPointIn><connection refLocalId=\"21\"/></connectionPointIn></jumpStep>\n";
        let transitions = transition(20, 1, first) + &transition(21, 2, second);
        let text = body(&format!("{STEP}\n{input}{block}{steps}{transitions}{jump}"));
        let (_, report) = import(&text, &Options::default()).expect("a chart");
        let about = report.iter().filter(|one| one.message.starts_with("blocks make"));
        about.map(|one| (one.code, one.message.clone())).collect::<Vec<_>>()
    };
    assert_eq!(told(10, 10), []);
    let one = "blocks make the condition of a transition, in the scan that looks at it".to_owned();
    assert_eq!(told(11, 10), [(Code::W0702, one)]);
    let both = "blocks make the conditions of 2 transitions, in the scan that looks at them".to_owned();
    assert_eq!(told(11, 11), [(Code::W0702, both)]);
}

/// Files that are made to break readers: all end soon, with a report or an error.
#[test]
fn hostile_files_are_told_soon() {
    let wired = |kind: &str, local: usize, from: &[usize]| {
        let wires: String = from.iter().map(|from| format!("<connection refLocalId=\"{from}\"/>")).collect();
        format!("<{kind} localId=\"{local}\"><connectionPointIn>{wires}</connectionPointIn></{kind}>\n")
    };
    // An entity bomb, wires in loops, between selections, joins and forks.
    let bomb = "<!DOCTYPE p [<!ENTITY a 'ha'><!ENTITY b '&a;&a;&a;'>]><project>&b;</project>";
    assert_eq!(faults(bomb), ["E0702 1:1"]);
    for kind in ["selectionConvergence", "simultaneousConvergence", "selectionDivergence"] {
        let ring = wired(kind, 2, &[3]) + &wired(kind, 3, &[2, 1]) + &wired("transition", 4, &[2]);
        let text = body(&format!("{STEP}\n{ring}"));
        holds(&text, &grafc_import::import_all(FileId::default(), &text, &Options::default()));
    }
    // A condition of blocks that wait for each other, and one that doubles at each of 60 blocks.
    let block = |local: usize, from: [usize; 2]| {
        let inputs: String = from
            .iter()
            .map(|from| format!("<variable formalParameter=\"IN\"><connectionPointIn><connection refLocalId=\"{from}\"/></connectionPointIn></variable>"))
            .collect();
        format!(
            "<block localId=\"{local}\" typeName=\"XOR\"><inputVariables>{inputs}</inputVariables><inOutVariables/><outputVariables/></block>\n"
        )
    };
    let condition = "<condition><connectionPointIn><connection refLocalId=\"60\"/></connectionPointIn></condition>";
    let asks = format!(
        "<transition localId=\"99\"><connectionPointIn><connection refLocalId=\"1\"/></connectionPointIn>{condition}</transition>"
    );
    let variable = "<inVariable localId=\"10\"><connectionPointOut/><expression>a</expression></inVariable>\n";
    let ring: String = (11..=60).map(|n| block(n, [if n == 11 { 60 } else { n - 1 }, 10])).collect();
    let text = body(&format!("{STEP}\n{variable}{ring}{asks}"));
    let (chart, report) = import(&text, &Options::default()).expect("a chart");
    assert!(
        chart.contains(": condition_1\n") && lines(&text, &report).iter().any(|line| line.starts_with("W0703")),
        "{chart}"
    );
    let doubling: String = (11..=60).map(|n| block(n, [n - 1, n - 1])).collect();
    assert!(faults(&body(&format!("{STEP}\n{variable}{doubling}{asks}")))[0].starts_with("E0702"));
    // Joins of selections of joins: the ways to one transition double at each.
    let steps: String = (100..140).map(|n| format!("<step localId=\"{n}\" name=\"S{n}\"/>\n")).collect();
    let mut joins = wired("selectionConvergence", 200, &[100, 101]);
    for n in 1..20 {
        joins += &wired("selectionConvergence", 200 + 2 * n, &[100 + 2 * n, 101 + 2 * n]);
        let before = if n == 1 { 200 } else { 199 + 2 * n };
        joins += &format!(
            "<simultaneousConvergence localId=\"{}\"><connectionPointIn><connection refLocalId=\"{before}\"/></connectionPointIn>\
             <connectionPointIn><connection refLocalId=\"{}\"/></connectionPointIn></simultaneousConvergence>\n",
            201 + 2 * n,
            200 + 2 * n
        );
    }
    let last = wired("transition", 999, &[239]);
    assert!(faults(&body(&format!("{STEP}\n{steps}{joins}{last}")))[0].starts_with("E0702"));
    // Ten megabytes of data that mean nothing, deep nesting, long names.
    let data = format!("<addData><data name=\"x\"><y>{}</y></data></addData>", "<z a=\"1\">words</z>".repeat(600_000));
    let started = Instant::now();
    let text = body(&format!("{STEP}\n{data}"));
    assert!(import(&text, &Options::default()).is_ok());
    let took = started.elapsed();
    assert!(took.as_secs() < 60, "ten megabytes of data took {took:?}");
    assert!(faults(&body(&"<addData>".repeat(1_000_000)))[0].starts_with("E0702"));
    let deep = format!(
        "PROGRAM P INITIAL_STEP A : b; END_STEP ACTION b : {} END_ACTION END_PROGRAM",
        "IF a THEN ".repeat(20_000)
    );
    let found = grafc_import::import_all(FileId::default(), &deep, &Options::default());
    holds(&deep, &found);
    let call = "PROGRAM P INITIAL_STEP A : b; END_STEP ACTION b : b(); b(); END_ACTION END_PROGRAM";
    let (_, report) = import(call, &Options::default()).expect("a chart");
    assert!(report.iter().any(|message| message.code == Code::W0703), "{report:?}");
}
