//! Texts that no one would write on purpose, through every stage: messages or code, never a panic, never a hang.
//!
//! Where MATIEC is available, what comes out for awkward but correct charts must be taken by it; where awlsim is, by
//! that.

use grafc_backends::{awl, il, st};
use grafc_diagnostics::{Code, Diagnostics, FileId};
use grafc_logic::scan::Program;
use grafc_logic::{Analysis, Encoding, Options};
use grafc_testsuite::charts::{cases, charts_folder};
use grafc_testsuite::executors::awlsim;
use grafc_testsuite::executors::matiec::{Tools, accepts};
use std::sync::OnceLock;

/// What a chart becomes.
struct Codes {
    /// Structured Text and an instruction list.
    iec: String,
    /// A statement list, if S7-300 and S7-400 can hold the chart.
    awl: Option<String>,
}

/// All codes, or nothing and at least one error.
fn compile(text: &str, encoding: Encoding) -> Result<Codes, Diagnostics> {
    let (tree, mut diagnostics) = grafc_syntax::parse(FileId::default(), text);
    if diagnostics.has_errors() {
        return Err(diagnostics);
    }
    let (chart, more) = grafc_model::check(&tree, "hostile");
    diagnostics.append(more);
    assert_eq!(chart.is_none(), diagnostics.has_errors(), "a chart exactly if there is no error: {diagnostics:?}");
    let Some(chart) = chart else { return Err(diagnostics) };
    let mut net = grafc_net::build(&chart);
    grafc_net::passes::run(&mut net, false, &mut diagnostics);
    if diagnostics.has_errors() {
        return Err(diagnostics);
    }
    let (program, more) = grafc_logic::compile(Analysis::new(net), &Options { encoding, ..Options::default() });
    diagnostics.append(more);
    if diagnostics.has_errors() {
        return Err(diagnostics);
    }
    let text = st::emit(&program, &st::Options::default())?;
    let awl = match awl::emit(&program, &awl::Options::default()) {
        Ok(text) => Some(text),
        Err(diagnostics)
            if diagnostics.iter().all(|one| matches!(one.code, Code::E0504 | Code::E0505 | Code::E0506)) =>
        {
            None
        }
        Err(diagnostics) => return Err(diagnostics),
    };
    let list = Program { name: format!("{}_il", program.name), ..program };
    Ok(Codes { iec: text + &il::emit(&list, &il::Options::default())?, awl })
}

/// It does not panic, and every message lies within the text and at the bounds of characters. That it does not take long is
/// seen by whoever waits: with texts of this size, what is quadratic never ends.
fn survives(text: &str) -> Result<Codes, Diagnostics> {
    let result = compile(text, Encoding::SinglePhase);
    let state_by_state = compile(text, Encoding::Switch);
    assert_eq!(result.is_ok(), state_by_state.is_ok(), "taken in one encoding, refused in the other");
    if let Err(diagnostics) = &result {
        assert!(diagnostics.has_errors(), "refused without an error");
        for one in diagnostics {
            let places = std::iter::once(&one.primary).chain(&one.secondary);
            for place in places {
                let range = place.span.range();
                assert!(text.get(range.clone()).is_some(), "{}: no such place: {range:?}", one.message);
            }
        }
    }
    result
}

/// MATIEC, looked for once.
fn matiec() -> Option<&'static Tools> {
    static FOUND: OnceLock<Option<Tools>> = OnceLock::new();
    FOUND.get_or_init(Tools::find_or_skip).as_ref()
}

/// awlsim, looked for once.
fn awlsim() -> Option<&'static awlsim::Tools> {
    static FOUND: OnceLock<Option<awlsim::Tools>> = OnceLock::new();
    FOUND.get_or_init(awlsim::Tools::find_or_skip).as_ref()
}

fn taken(text: &str) {
    let codes = survives(text).unwrap_or_else(|diagnostics| panic!("{diagnostics:?}\n{text}"));
    // Where the tool is missing the code has at least been written.
    if let Some(tools) = matiec() {
        accepts(tools, &codes.iec).unwrap_or_else(|said| panic!("{said}\n{}", codes.iec));
    }
    if let (Some(tools), Some(awl)) = (awlsim(), codes.awl) {
        awlsim::accepts(tools, &[awl]).unwrap_or_else(|said| panic!("{said}"));
    }
}

fn refused(text: &str) {
    assert!(survives(text).is_err(), "{}", text.chars().take(200).collect::<String>());
}

#[test]
fn every_prefix_of_a_chart() {
    for case in cases(&charts_folder()) {
        // All prefixes of short charts, and of long ones a sample with every remainder.
        let stride = if case.text.len() < 1000 { 1 } else { 7 };
        for (end, _) in case.text.char_indices().step_by(stride) {
            let _ = survives(&case.text[..end]);
        }
    }
}

#[test]
fn every_chart_without_one_character() {
    for case in cases(&charts_folder()).iter().filter(|case| case.text.len() < 600) {
        for (at, removed) in case.text.char_indices() {
            let text = [&case.text[..at], &case.text[at + removed.len_utf8()..]].concat();
            let _ = survives(&text);
        }
    }
}

#[test]
fn noise() {
    let mut rng = fastrand::Rng::with_seed(1);
    let words = [
        "step",
        "initial",
        "transition",
        "->",
        ":",
        "{",
        "}",
        "(",
        ")",
        "[",
        "]",
        "↑",
        "not",
        "1",
        "3s",
        "/",
        "X1",
        ":=",
        "on",
        "activation",
        "force",
        "*",
        "grafcet",
        "expansion",
        "\"",
        "`",
        "(*",
        "*)",
        "//",
        "\n",
        ",",
        "input",
        "bool",
        "at",
        "%IX0.0",
        "16#",
        "-",
        "+",
        "мир",
        "\u{202e}",
        "\u{0}",
        "T#",
        "é",
        "9999999999999999999999",
        "if",
        "event",
        "macro",
        "enclosing",
    ];
    for _ in 0..2000 {
        let bytes: Vec<u8> = (0..rng.usize(0..200)).map(|_| rng.u8(..)).collect();
        let _ = survives(&String::from_utf8_lossy(&bytes));
        let text: Vec<&str> = (0..rng.usize(0..60)).map(|_| words[rng.usize(0..words.len())]).collect();
        let _ = survives(&text.join(if rng.bool() { " " } else { "" }));
    }
}

#[test]
fn deep_nesting() {
    for (open, close) in [("(", ")"), ("not ", ""), ("[", "]"), ("↑(", ")"), ("1s/(", ")"), ("!", ""), ("-", "")] {
        for depth in [100, 10_000] {
            let condition = format!("{}a{}", open.repeat(depth), close.repeat(depth));
            let text = format!("input a : bool\ninitial step 1\nstep 2\ntransition 1 -> 2 : {condition}\n");
            // MATIEC takes minutes over thousands of timers.
            if let Ok(codes) = survives(&text)
                && (depth == 100 || !open.contains("1s"))
                && let Some(tools) = matiec()
            {
                accepts(tools, &codes.iec).unwrap_or_else(|said| panic!("{depth} times `{open}`: {said}"));
            }
        }
    }
    let nested = format!("{}1{}", "[1 + (".repeat(5000), ")]".repeat(5000));
    let _ = survives(&format!("output n : int\ninitial step 1 {{ n := {nested} on activation }}\n"));
    let long = vec!["(a and not b)"; 5000].join(" or ");
    taken(&format!("input a, b : bool\ninitial step 1\nstep 2\ntransition 1 -> 2 : {long}\n"));
    let mixed = vec!["a and (b"; 5000].join(" or ") + &")".repeat(5000);
    let _ = survives(&format!("input a, b : bool\ninitial step 1\nstep 2\ntransition 1 -> 2 : {mixed}\n"));
}

#[test]
fn huge_tokens() {
    let size = 2_000_000;
    let name = "a".repeat(size);
    let _ = survives(&format!("input {name} : bool\ninitial step 1\nstep 2\ntransition 1 -> 2 : {name}\n"));
    let _ = survives(&format!("initial step {}\n", "1".repeat(size)));
    let _ = survives(&format!("initial step 1 \"{}\"\n", "x ".repeat(size / 2)));
    let _ = survives(&format!("// {}\ninitial step 1\n", "y".repeat(size)));
    let _ = survives(&format!("initial step 1\nstep 2\ntransition 1 -> 2 : {}s/X1\n", "9".repeat(size)));
    let _ = survives(&"(".repeat(1_000_000));
    let _ = survives(&"(*".repeat(1_000_000));
    let _ = survives(&"{ ".repeat(1_000_000));
    let _ = survives(&"`".repeat(1_000_001));
    let _ = survives(&"initial step 1 ".repeat(20_000));
}

#[test]
fn names_that_differ_only_by_case() {
    refused("input Valve, valve : bool\ninitial step 1\n");
    refused("input a : bool\ninitial step Fill\nstep FILL\ntransition Fill -> FILL : a\n");
}

#[test]
fn names_that_targets_reserve() {
    let words = [
        "TON",
        "EN",
        "ENO",
        "ADD",
        "MAX",
        "NULL",
        "EOF",
        "NAN",
        "M_PI",
        "R_EDGE",
        "READ_ONLY",
        "CONTINUE",
        "REF",
        "METHOD",
        "THIS",
        "N",
        "S",
        "R",
        "T",
        "X",
        "IN",
        "PT",
        "INIT",
        "REAL",
        "END_IF",
        "FUNCTION_BLOCK",
        "RETURN",
        "TIME",
        "DT",
        "BYTE",
        "LEFT",
        "GT",
        "REPEAT",
        "UNTIL",
        "VAR",
        "BY",
        "DO",
        "EXIT",
        "OF",
        "again",
        "micro_steps",
        "started",
        "int",
        "main",
        "data__",
        "LIVELOCK",
        "DIV0",
        "T1",
        "clr_1",
        "old_a",
        "new_a",
        "printf",
        "value",
        "while",
        "for",
        "struct",
        "default",
        "long",
        "A",
        "UN",
        "SPB",
        "M10",
        "DB1",
        "NOW",
        "RESTART",
        "clock",
        "NETWORK",
    ];
    let mut codes = Vec::new();
    for (index, word) in words.iter().enumerate() {
        let text = format!(
            "chart Block_{index}\n\ninput `{word}` \"(* {word} *)\" : bool\noutput `{word}_` : bool\noutput out : dint\n\
             initial step 1\nstep `{word}` {{\n  `{word}_`\n  out := out + 1 on activation\n}}\n\
             transition 1 -> `{word}` : ↑`{word}`\n"
        );
        // A word may be taken by an implicit variable or by a word of the other names; then it is refused, in words.
        codes.extend(survives(&text));
    }
    assert!(codes.len() + 5 > words.len(), "only {} of {} names were taken", codes.len(), words.len());
    let (iec, awl): (Vec<String>, Vec<Option<String>>) = codes.into_iter().map(|codes| (codes.iec, codes.awl)).unzip();
    if let Some(tools) = awlsim() {
        let awl: Vec<String> = awl.into_iter().flatten().collect();
        assert_eq!(awl.len(), iec.len(), "a name is no reason to refuse a chart");
        awlsim::accepts(tools, &awl).unwrap_or_else(|said| panic!("{said}"));
    }
    let Some(tools) = matiec() else { return };
    if accepts(tools, &iec.concat()).is_err() {
        for code in &iec {
            accepts(tools, code).unwrap_or_else(|said| panic!("{said}\n{code}"));
        }
    }
}

#[test]
fn names_of_every_script() {
    taken(
        "input вход \"вход\", größe, 開始, `a b`, `2s/X202`, a__b, _u, ж : bool\noutput выход, `*)`, `'$$\"` : bool\n\
         initial step шаг { выход }\nstep `(* *)` { `*)` }\nstep Ж1 { `'$$\"` }\n\
         transition шаг -> `(* *)` : ↑вход and größe or 開始\ntransition `(* *)` -> Ж1 : `a b` and `2s/X202`\n\
         transition Ж1 -> шаг : 2s/a__b or _u or ж\n",
    );
}

#[test]
fn comments_that_would_end_comments() {
    taken(
        "chart Name \"*) END_FUNCTION_BLOCK (* {pragma} \"\ninput a \"*) ; (* \", b \"(* open\", c \"shut *)\" : bool\n\
         output w \"(**)**)\" : bool\ninitial step 1 \"*)*)*)\" { w }\nstep 2 \"{ }\"\n\
         transition (1) \"*) x := 1; (*\" 1 -> 2 : a\ntransition (`*)`) \"// \" 2 -> 1 : b and c\n",
    );
}

#[test]
fn long_names() {
    let (one, two) = (format!("{}1", "n".repeat(300)), format!("{}2", "n".repeat(300)));
    taken(&format!(
        "input {one}, {two} : bool\noutput w : bool\ninitial step {one}\nstep {two} {{ w }}\n\
         transition {one} -> {two} : {one}\ntransition {two} -> {one} : {two}\n"
    ));
}

#[test]
fn extreme_numbers() {
    taken(
        "output i : int\noutput d : dint\noutput u : uint\noutput v : udint\noutput r : real\noutput l : lreal\noutput t : time\n\
         initial step 1 {\n  i := -32768 on activation\n  d := -2147483648 on activation\n  u := 65535 on activation\n\
         v := 4294967295 on activation\n  r := 1.0E38 on activation\n  l := 1.0E38 on activation\n  t := 2147483647ms on activation\n}\n",
    );
    // MATIEC refuses literals of LREAL beyond the range of REAL, typed or not: nothing that could be written helps.
    assert!(survives("output l : lreal\ninitial step 1 { l := 1.0E300 on activation }\n").is_ok());
    refused("output i : int\ninitial step 1 { i := 32768 on activation }\n");
    refused("output i : int\ninitial step 1 { i := 99999999999999999999999 on activation }\n");
    refused("output t : time\ninitial step 1 { t := 99999999999999h on activation }\n");
}

#[test]
fn nothing_at_all() {
    for text in ["", " ", "\n\n", "// only this\n", "\u{feff}", "chart Empty\n", "grafcet G1 { }\n", "input a : bool\n"]
    {
        refused(text);
    }
}
