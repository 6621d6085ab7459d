//! PLCopen XML and the other files that hold Structured Text in a frame: each file written for the example charts is
//! right by the rules of the project's own lint, and by the schema where it is available.

use grafc::{Options, Product};
use grafc_backends::plcopen::{self, Body, Dialect};
use grafc_backends::{Target, iec61131_10, il, scl, tcpou};
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_testsuite::charts::{Case, cases, charts_folder, vectors_folder};
use grafc_testsuite::plcopen_lint::document::Document;
use grafc_testsuite::plcopen_lint::{Rule, lint};
use grafc_testsuite::plcopen_tools::{find_or_skip, take_or_skip};
use std::collections::BTreeSet;

const NEUTRAL: &str = include_str!("../../plcopen/neutral.xml");
const CODESYS: &str = include_str!("../../plcopen/codesys.xml");
const LADDER: &str = include_str!("../../plcopen/ladder.xml");

/// A rule, and an edit of the right ladder that breaks it.
const BROKEN_LADDERS: &[(Rule, &str, &str)] = &[
    (Rule::Order, "<inOutVariables/>", "<inOutVariables/><more/>"),
    (Rule::Order, "<variable>go</variable>", "<connectionPointIn/><variable>go</variable>"),
    (Rule::Attributes, "connectionPointOut formalParameter=\"\"", "connectionPointOut"),
    (Rule::Attributes, "variable formalParameter=\"PT\"", "variable"),
    (Rule::Attributes, " typeName=\"TON\"", ""),
    (Rule::BlockPin, " formalParameter=\"Q\"><position", "><position"),
    (Rule::LadderVariable, "<variable>go</variable>", "<variable>n</variable>"),
    (Rule::LadderVariable, "<variable>late</variable>", "<variable>later</variable>"),
    (Rule::LadderVariable, "instanceName=\"wait\"", "instanceName=\"n\""),
    (
        Rule::LadderPower,
        "<connection refLocalId=\"10\"><position x=\"180\" y=\"260\"/><position x=\"160\" y=\"260\"/></connection>",
        "",
    ),
    (
        Rule::LadderPower,
        "<connection refLocalId=\"2\"><position x=\"60\" y=\"80\"/><position x=\"23\" y=\"80\"/></connection>",
        "<connection refLocalId=\"5\"><position x=\"60\" y=\"80\"/><position x=\"23\" y=\"80\"/></connection>",
    ),
    (Rule::LadderPower, "<position x=\"81\" y=\"240\"/>", "<position x=\"181\" y=\"240\"/>"),
    (
        Rule::NeutralBranches,
        "<connection refLocalId=\"5\">",
        "<connection refLocalId=\"4\"><position x=\"300\" y=\"80\"/><position x=\"81\" y=\"120\"/></connection><connection refLocalId=\"5\">",
    ),
    (
        Rule::NeutralBranches,
        "<connection refLocalId=\"4\"><position x=\"140\" y=\"80\"/>",
        "<connection refLocalId=\"2\"><position x=\"140\" y=\"80\"/>",
    ),
    (
        Rule::NeutralJump,
        "</LD>",
        "<label localId=\"14\" label=\"again\" width=\"50\" height=\"20\"><position x=\"20\" y=\"300\"/></label></LD>",
    ),
    (Rule::NeutralGeometry, "<coil localId=\"6\" width=\"21\"", "<coil localId=\"6\""),
];

/// A rule, and an edit of the right document that breaks it and it alone.
const BROKEN: &[(Rule, Dialect, &str, &str)] = &[
    (Rule::WellFormed, Dialect::Neutral, "</project>", ""),
    (Rule::WellFormed, Dialect::Neutral, "</project>", "</project><project/>"),
    (Rule::WellFormed, Dialect::Neutral, "</pous>", "</pou>"),
    (Rule::Order, Dialect::Neutral, "<dataTypes/>", "<dataTypes/><dataTypes/><other/>"),
    (
        Rule::Order,
        Dialect::Neutral,
        "<position x=\"20\" y=\"130\"/>",
        "<connectionPointOut formalParameter=\"\"><relPosition x=\"1\" y=\"1\"/></connectionPointOut><position x=\"20\" y=\"130\"/>",
    ),
    (Rule::Attributes, Dialect::Neutral, " priority=\"0\"", ""),
    (Rule::Attributes, Dialect::Neutral, "<inline name=\"\">", "<inline>"),
    (Rule::Namespace, Dialect::Neutral, "tc6_0201", "tc6_0200"),
    (Rule::Namespace, Dialect::Neutral, "xmlns:xhtml=\"http://www.w3.org/1999/xhtml\"", ""),
    (Rule::Namespace, Dialect::Codesys, "tc6_0200", "tc6_0201"),
    (
        Rule::Text,
        Dialect::Neutral,
        "<xhtml:p><![CDATA[demo_1();]]></xhtml:p>",
        "<xhtml:p> <![CDATA[demo_1();]]></xhtml:p>",
    ),
    (Rule::Text, Dialect::Neutral, "<xhtml:p><![CDATA[demo_1();]]></xhtml:p>", "demo_1();"),
    (
        Rule::Text,
        Dialect::Codesys,
        "<xhtml xmlns=\"http://www.w3.org/1999/xhtml\">demo_1();</xhtml>",
        "<xhtml>demo_1();</xhtml>",
    ),
    (Rule::OneBody, Dialect::Neutral, "<body><ST><xhtml:p><![CDATA[demo_1();]]></xhtml:p></ST></body>", ""),
    (Rule::Identifier, Dialect::Neutral, "\"demo_1\"", "\"démo\""),
    (Rule::Identifier, Dialect::Neutral, "\"demo_1\"", "\"RETURN\""),
    (Rule::Identifier, Dialect::Neutral, "\"demo_1\"", "\"demo__1\""),
    (Rule::UniqueName, Dialect::Neutral, "\"go\"", "\"BACK\""),
    (Rule::UniqueName, Dialect::Neutral, "name=\"back\"", "name=\"x2\""),
    (Rule::UniqueName, Dialect::Neutral, "name=\"back\"", "name=\"NOTE\""),
    (Rule::UniqueName, Dialect::Codesys, "pou name=\"Demo_program\"", "pou name=\"DEMO\""),
    (Rule::GlobalId, Dialect::Neutral, "id_1", "1_id"),
    (Rule::KnownType, Dialect::Neutral, "derived name=\"TON\"", "derived name=\"TIMER\""),
    (Rule::Instance, Dialect::Neutral, "typeName=\"Demo_program\"", "typeName=\"Demo\""),
    (Rule::Instance, Dialect::Neutral, "T#20ms", "PT0.020S"),
    (Rule::Instance, Dialect::Codesys, "PT0.020S", "T#20ms"),
    (Rule::LocalId, Dialect::Neutral, "localId=\"10\"", "localId=\"9\""),
    (Rule::LocalId, Dialect::Neutral, "localId=\"10\"", "localId=\"ten\""),
    (Rule::Reference, Dialect::Neutral, "refLocalId=\"7\"", "refLocalId=\"77\""),
    (
        Rule::BlockPin,
        Dialect::Neutral,
        "<jumpStep localId=\"8\"",
        "<block localId=\"20\" typeName=\"TON\" instanceName=\"wait\" width=\"1\" height=\"1\"><position x=\"0\" y=\"0\"/><inputVariables/><inOutVariables/><outputVariables/></block><outVariable localId=\"21\" width=\"1\" height=\"1\"><position x=\"0\" y=\"0\"/><connectionPointIn><relPosition x=\"0\" y=\"0\"/><connection refLocalId=\"20\"/></connectionPointIn><expression>run</expression></outVariable><jumpStep localId=\"8\"",
    ),
    (Rule::InitialStep, Dialect::Neutral, " initialStep=\"true\"", ""),
    (Rule::JumpTarget, Dialect::Neutral, "localId=\"8\" targetName=\"X1\"", "localId=\"8\" targetName=\"X3\""),
    (
        Rule::Condition,
        Dialect::Neutral,
        "<condition><inline name=\"\"><ST><xhtml:p><![CDATA[go]]></xhtml:p></ST></inline></condition>",
        "",
    ),
    (Rule::Duration, Dialect::Neutral, " duration=\"T#1s\"", ""),
    (Rule::Duration, Dialect::Neutral, "qualifier=\"D\"", "qualifier=\"N\""),
    (Rule::ActionReference, Dialect::Neutral, "reference name=\"run\"", "reference name=\"wait\""),
    (
        Rule::NeutralVariables,
        Dialect::Neutral,
        "<localVars><variable name=\"demo_1\"><type><derived name=\"Demo\"/></type></variable></localVars>",
        "",
    ),
    (Rule::NeutralConfiguration, Dialect::Neutral, "<pouInstance name=\"main\" typeName=\"Demo_program\"/>", ""),
    (
        Rule::NeutralConnection,
        Dialect::Neutral,
        "<connection refLocalId=\"7\"/>",
        "<connection refLocalId=\"7\"/><connection refLocalId=\"9\"/>",
    ),
    (Rule::NeutralFeeding, Dialect::Neutral, "refLocalId=\"9\"", "refLocalId=\"0\""),
    (Rule::NeutralGeometry, Dialect::Neutral, "targetName=\"X1\" width=\"12\"", "targetName=\"X1\""),
    (
        Rule::NeutralGeometry,
        Dialect::Neutral,
        "<connectionPointIn><relPosition x=\"30\" y=\"0\"/></connectionPointIn>",
        "<connectionPointIn/>",
    ),
    (Rule::NeutralGeometry, Dialect::Neutral, "qualifier=\"N\"", "qualifier=\"N\" indicator=\"\""),
    (Rule::CodesysNumbering, Dialect::Codesys, "localId=\"12\"", "localId=\"13\""),
    (
        Rule::CodesysPlaces,
        Dialect::Codesys,
        "<expression>go</expression>",
        "<addData height=\"3\"/><expression>go</expression>",
    ),
    (
        Rule::CodesysCondition,
        Dialect::Codesys,
        "<condition><connectionPointIn><connection refLocalId=\"2\"/>",
        "<condition><connectionPointIn><connection refLocalId=\"0\"/>",
    ),
    (
        Rule::CodesysPins,
        Dialect::Codesys,
        "<connectionPointIn><connection refLocalId=\"4\" formalParameter=\"sfc\"/>",
        "<connectionPointIn><connection refLocalId=\"4\"/>",
    ),
    (Rule::CodesysPins, Dialect::Codesys, "<connectionPointOutAction formalParameter=\"x\"/>", ""),
    (
        Rule::CodesysNesting,
        Dialect::Codesys,
        "<connectionPointIn><connection refLocalId=\"10\" formalParameter=\"sfc\"/></connectionPointIn>",
        "",
    ),
    (
        Rule::CodesysFlow,
        Dialect::Codesys,
        "<connectionPointIn/>",
        "<connectionPointIn><connection refLocalId=\"0\"/></connectionPointIn>",
    ),
    (Rule::CodesysAction, Dialect::Codesys, " indicator=\"\"", ""),
    (Rule::CodesysAction, Dialect::Codesys, "qualifier=\"N\"", "qualifier=\"P1\""),
    (Rule::CodesysData, Dialect::Codesys, "handleUnknown=\"implementation\"", "handleUnknown=\"discard\""),
];

fn right(dialect: Dialect) -> &'static str {
    match dialect {
        Dialect::Neutral => NEUTRAL,
        Dialect::Codesys => CODESYS,
    }
}

#[test]
fn documents_that_are_right_by_every_rule() {
    assert_eq!(lint(NEUTRAL, Dialect::Neutral), []);
    assert_eq!(lint(CODESYS, Dialect::Codesys), []);
    assert_eq!(lint(LADDER, Dialect::Neutral), []);
}

#[test]
fn every_rule_catches_a_document_that_breaks_it() {
    let mut faults = Vec::new();
    let drawn = BROKEN.iter().map(|(rule, dialect, from, to)| (rule, *dialect, right(*dialect), from, to));
    let ladders = BROKEN_LADDERS.iter().map(|(rule, from, to)| (rule, Dialect::Neutral, LADDER, from, to));
    for (rule, dialect, text, from, to) in drawn.chain(ladders) {
        assert!(text.contains(from), "{rule:?}: nothing to break: {from}");
        // Every edit is made in one place, so that it breaks only what it must.
        let found = lint(&text.replacen(from, to, 1), dialect);
        if !found.iter().any(|finding| finding.rule == *rule) {
            faults.push(format!("{rule:?} does not see {to}: {found:?}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let covered: BTreeSet<Rule> =
        BROKEN.iter().map(|(rule, ..)| *rule).chain(BROKEN_LADDERS.iter().map(|(rule, ..)| *rule)).collect();
    let missing: Vec<&Rule> = Rule::ALL.iter().filter(|rule| !covered.contains(rule)).collect();
    assert!(missing.is_empty(), "no document breaks {missing:?}");
}

/// Names that some target reserves, in other scripts, of great length, that differ only in what is lost; comments that
/// would end what they stand in.
const HOSTILE: &str = "\
chart `]]>` \"]]> *) </xhtml:p> END_FUNCTION_BLOCK & \u{1} (*\"
input вход \"вход ]]>\", größe \"*) x := 1; (*\", `a b`, a__b, `2s/X202`, BEGIN, `METHOD`, ton, begin_1 : bool
input LONG, LONG2 : bool
output выход \"<b>&amp;</b>\", `*)`, `'$$\"`, `]]>`, `step` : bool
initial step шаг \"*) ]]>\" { выход `]]>` }
step `(* *)` \"{ }\" { `*)` }
step Ж1 { `'$$\"` `step` }
transition (`]]>`) \"]]> *)\" шаг -> `(* *)` : вход and (größe or BEGIN or begin_1)
transition `(* *)` -> Ж1 : `a b` and `2s/X202` and `METHOD` and ton
transition Ж1 -> шаг : 2s/a__b or LONG or LONG2
";

fn made(case: &Case, product: Product) -> String {
    let lowering = Lowering { profile: case.profile, encoding: Encoding::default(), simplify: true };
    let options = Options::new(lowering, product);
    let (made, diagnostics) = grafc::compile(FileId::default(), &case.text, &case.name, &options);
    made.unwrap_or_else(|| panic!("{}: {diagnostics:?}", case.name)).text
}

fn project(dialect: Dialect, body: Body) -> Product {
    let header = vec!["Made --by hand-- ]]> *) \u{2}".to_string()];
    Product::Code(Target::Plcopen(plcopen::Options { dialect, body, header, interval_ms: Some(10) }))
}

fn all_cases() -> Vec<Case> {
    let mut all = cases(&charts_folder());
    all.extend(cases(&vectors_folder()));
    let long = "n".repeat(199);
    let text = HOSTILE.replace("LONG2", &format!("{long}2")).replace("LONG", &format!("{long}1"));
    let (name, [trace, expected]) = ("hostile".to_string(), [String::new(), String::new()]);
    all.push(Case { name, text, trace, expected, profile: Default::default(), overlapping: false });
    all
}

#[test]
fn every_project_is_right_by_the_lint_and_by_other_readers() {
    let mut documents = vec![NEUTRAL.to_string(), CODESYS.to_string(), LADDER.to_string()];
    for case in all_cases() {
        for dialect in [Dialect::Neutral, Dialect::Codesys] {
            for body in [Body::St, Body::Il] {
                let text = made(&case, project(dialect, body));
                assert_eq!(lint(&text, dialect), [], "{}: {text}", case.name);
                documents.push(text);
            }
        }
    }
    assert!(documents.len() > 100, "charts are missing");
    take_or_skip(&documents);
}

#[test]
fn the_tools_see_what_is_wrong() {
    // Well-formed, but no document of the schema.
    let wrong = [NEUTRAL.replace("<dataTypes/>", "<dataTypes/><nonsense/>")];
    for tool in find_or_skip() {
        assert!(tool.take(&wrong).is_err());
    }
}

#[test]
fn another_reader_finds_the_same_units_and_statements() {
    for case in all_cases() {
        let text = made(&case, project(Dialect::Neutral, Body::St));
        let read: plcopen_reader::Project =
            plcopen_reader::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", case.name));
        let units = read.types.and_then(|types| types.pous).map(|pous| pous.pou).unwrap_or_default();
        let structured = made(&case, Product::Code(Target::St(Default::default())));
        let block = structured.lines().find_map(|line| line.strip_prefix("FUNCTION_BLOCK ")).unwrap_or_default();
        let names: Vec<&str> = units.iter().map(|unit| unit.name.as_str()).collect();
        assert_eq!(names.len(), 2, "{}", case.name);
        assert_eq!(names[0], block, "{}", case.name);
        let texts = plcopen_reader::st::extract_all_st_from_xml(&text);
        let (_, body) = texts.iter().find(|(name, _)| name == block).expect("the body of the function block");
        assert_eq!(body.trim(), statements(&structured).replace("]]>", "]] >"), "{}", case.name);
    }
}

#[test]
fn instructions_are_those_of_the_instruction_list() {
    for case in all_cases() {
        let options = il::Options { pou: il::Pou::Program, ..il::Options::default() };
        let list = made(&case, Product::Code(Target::Il(options)));
        let (block, program) = list.split_once("\nEND_FUNCTION_BLOCK\n").expect("a function block and a program");
        let expected = [statements(block), statements(program)];
        for dialect in [Dialect::Neutral, Dialect::Codesys] {
            let text = made(&case, project(dialect, Body::Il));
            let document = Document::read(&text).unwrap_or_else(|e| panic!("{}: {e}", case.name));
            assert_eq!(document.all("ST").count(), 0, "{}: {text}", case.name);
            let bodies = document.all("IL").map(|id| document.get(document.get(id).children[0]).text.trim());
            let expected = expected.map(|body| match dialect {
                Dialect::Neutral => body.replace("]]>", "]] >"),
                Dialect::Codesys => body.to_string(),
            });
            assert_eq!(bodies.collect::<Vec<_>>(), expected, "{}", case.name);
        }
    }
}

/// The statements of a function block in Structured Text, or of a unit in instructions.
fn statements(structured: &str) -> &str {
    let start = structured.rfind("END_VAR\n").map_or(0, |at| at + "END_VAR\n".len());
    structured[start..].trim().trim_end_matches("END_FUNCTION_BLOCK").trim_end_matches("END_PROGRAM").trim()
}

/// The texts of all elements of a name.
fn texts<'d>(document: &'d Document, name: &'d str) -> Vec<&'d str> {
    document.all(name).map(|id| document.get(id).text.as_str()).collect()
}

#[test]
fn the_vendor_forms_hold_the_same_statements() {
    for case in all_cases() {
        let structured = made(&case, Product::Code(Target::St(Default::default())));
        let statements = statements(&structured);
        let drawn_apart = statements.replace("]]>", "]] >");

        let text = made(&case, Product::Code(Target::Tcpou(tcpou::Options::default())));
        let document = Document::read(&text).unwrap_or_else(|e| panic!("{}: {e}", case.name));
        let [body] = texts(&document, "ST")[..] else { panic!("{}: not one body", case.name) };
        assert_eq!(body.trim(), drawn_apart, "{}", case.name);
        let [declaration] = texts(&document, "Declaration")[..] else { panic!("{}: no declaration", case.name) };
        assert!(declaration.trim_end().ends_with("END_VAR"), "{declaration}");

        let text = made(&case, Product::Code(Target::Iec61131_10(iec61131_10::Options::default())));
        let document = Document::read(&text).unwrap_or_else(|e| panic!("{}: {e}", case.name));
        let [body] = texts(&document, "ST")[..] else { panic!("{}: not one body", case.name) };
        assert_eq!(body.trim(), statements, "{}", case.name);
        let variables = document.all("Variable");
        let places: Vec<usize> =
            variables.filter_map(|id| document.attribute(id, "orderWithinParamSet")?.parse().ok()).collect();
        assert!(places.iter().copied().eq(0..places.len()), "{}: {places:?}", case.name);

        let text = made(&case, Product::Code(Target::Scl(scl::Options::default())));
        assert!(text.is_ascii(), "{}", case.name);
        assert!(!text.contains("(*"), "{}: {text}", case.name);
        // Without marks and comments it is the same again.
        let start = text.find("\nBEGIN\n").map_or(0, |at| at + "\nBEGIN\n".len());
        let end = text.find("\nEND_FUNCTION_BLOCK").unwrap_or(text.len());
        let plain = |text: &str, comment: &str, end: &str| -> String {
            let mut inside = false;
            let code = text.lines().map(|line| {
                let before = line.find(comment).map_or(line, |at| &line[..at]);
                let keep = if inside { "" } else { before };
                inside = (inside || line.contains(comment)) && !end.is_empty() && !line.contains(end);
                keep
            });
            // Lines break where a mark more makes them too long.
            code.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(
            plain(&text[start..end], "//", "").replace('#', ""),
            plain(statements, "(*", "*)").replace('#', ""),
            "{}",
            case.name
        );
    }
}

#[test]
fn scl_marks_every_variable_and_no_other_word() {
    let chart = "input a : bool\noutput w : bool\noutput n : int\nconst wait : time := 2s\ninitial step 1\nstep 2 { w if a }\n\
                 step 3 { n := n + 1 on activation }\ntransition 1 -> 2 : wait/X1\ntransition 2 -> 3 : not a\n\
                 transition 3 -> 1 : a\n";
    let mut case = all_cases().remove(0);
    case.text = chart.to_string();
    case.name = "press".to_string();
    let text = made(&case, Product::Code(Target::Scl(scl::Options::default())));
    for expected in [
        "FUNCTION_BLOCK \"press\"\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\nVAR_INPUT\n    a : Bool;\n",
        "    on_X1 {InstructionName := 'TON_TIME'; LibVersion := '1.0'} : TON_TIME;\n",
        "VAR CONSTANT\n    wait : Time := T#2s;\nEND_VAR\nBEGIN\n",
        "#on_X1(IN := #X1, PT := #wait);\n",
        "#w := #X2 AND #a;\n",
        "#n := #n + 1;",
        "END_FUNCTION_BLOCK\n\nDATA_BLOCK \"press_DB\" \"press\"\nBEGIN\nEND_DATA_BLOCK\n",
    ] {
        assert!(text.contains(expected), "{expected}\nin\n{text}");
    }
}
