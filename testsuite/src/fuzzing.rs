//! What must hold for any text: of an import, of a trace, and through the whole compiler.
//!
//! The fuzz targets in `testsuite/fuzz` call these functions, and `testsuite/tests/suite/fuzzing.rs` calls them with the
//! seeds. A text that breaks a rule ends in a panic, which is what a fuzzer looks for. (The parser's own rules are beside
//! it, in `compiler/syntax/tests/common`.)

use crate::charts::{self, cases, charts_folder, vectors_folder};
use crate::compare::{first_difference, report};
use crate::random::profile;
use crate::random::trace as drawn_trace;
use crate::runs::{lowered, run, simulate};
use crate::ways::exact;
use grafc_backends::{plcopen, rust, st};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, SourceMap};
use grafc_import::Dialect;
use grafc_logic::{Encoding, Options};
use grafc_model::chart::Chart;
use grafc_model::reaction::Stimulus;
use grafc_model::trace::{Kept, Stimuli, parse_trace, write_trace};
use std::path::Path;
use std::sync::LazyLock;
use std::{fs, io};

/// Calls that a chart is given.
const ROWS: usize = 6;

/// The names of the targets.
pub const TARGETS: [&str; 4] = ["parser", "importer", "trace", "pipeline"];

/// A file of another tool: messages at places of it; a chart in canonical format exactly if none of them is an error.
pub fn importer(text: &str) {
    for (delays, dialect) in [(false, None), (true, Some(Dialect::Codesys)), (false, Some(Dialect::Isagraf))] {
        let options = grafc_import::Options { delays, dialect, unit: None };
        let (chart, diagnostics) = grafc_import::import(FileId::default(), text, &options);
        places(text, &diagnostics);
        assert_eq!(chart.is_none(), diagnostics.has_errors(), "{diagnostics:?}");
        let Some(chart) = chart else { continue };
        let (tree, faults) = grafc_syntax::parse(FileId::default(), &chart);
        assert!(!faults.has_errors(), "the import is no text of ours: {faults:?}\n{chart}");
        assert_eq!(grafc_syntax::format(&chart, &tree), chart, "the import is not in canonical format");
        // It may break a rule of charts, but is a text to check.
        let _ = grafc_model::check(&tree, "imported");
    }
}

/// The chart that traces are read for: an input of each type.
const INPUTS: &str = "
    input a : bool\ninput b : int\ninput c : dint\ninput d : uint\ninput e : udint\ninput f : real\ninput g : lreal
    input h : time\noutput Q : bool\ninitial step 1 { Q if a }\nstep 2\ntransition 1 -> 2 : rise a and [b > 3]
";

/// A trace: messages at places of it, which are the same where it comes in small pieces that nobody keeps; times do not go
/// back; what was read and is written again is read as the same.
pub fn trace(text: &str) {
    static CHART: LazyLock<Chart> = LazyLock::new(|| charts::check("inputs", INPUTS).expect("a chart without errors"));
    let chart = &*CHART;
    let (stimuli, diagnostics) = parse_trace(FileId::default(), text, chart);
    places(text, &diagnostics);
    assert_eq!(in_pieces(text, chart), (stimuli.clone(), said(&diagnostics, |byte| byte)));
    if diagnostics.has_errors() {
        return;
    }
    assert!(stimuli.windows(2).all(|pair| pair[0].t_ms <= pair[1].t_ms), "time goes back: {stimuli:?}");
    let responses = simulate(chart, profile(0), &stimuli);
    let _ = write_trace(chart, &stimuli, &responses);
}

/// What is read of a trace, and said: code, headline, and the byte of each place.
type Read = (Vec<Stimulus>, Vec<(Code, String, Vec<usize>)>);

fn said(diagnostics: &Diagnostics, byte: impl Fn(usize) -> usize) -> Vec<(Code, String, Vec<usize>)> {
    let of = |message: &Diagnostic| {
        let labels = std::iter::once(&message.primary).chain(&message.secondary);
        (message.code, message.message.clone(), labels.map(|label| byte(label.span.range().start)).collect())
    };
    diagnostics.iter().map(of).collect()
}

/// A trace as it comes: seven bytes at a time.
fn in_pieces(text: &str, chart: &Chart) -> Read {
    struct Pieces<'t>(&'t [u8]);
    impl io::Read for Pieces<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let length = buffer.len().min(7);
            io::Read::read(&mut self.0, &mut buffer[..length])
        }
    }
    let mut sources = SourceMap::new();
    let file = sources.add("trace.csv", "");
    let mut rows = Stimuli::new(file, Pieces(text.as_bytes()), chart, Kept::Rows).expect("memory can be read");
    let mut stimuli = Vec::new();
    while let Some(stimulus) = rows.next_row().expect("memory can be read") {
        stimuli.push(stimulus);
    }
    let (diagnostics, extract) = rows.finish();
    sources.show(file, extract);
    (stimuli, said(&diagnostics, |byte| sources.file(file).position(byte).byte))
}

/// A chart: messages at places of it; if it is accepted, every encoding gives a program that verifies, the exact ones
/// do what the simulator does, and the backends write the program or say why not.
pub fn pipeline(text: &str) {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), text);
    places(text, &diagnostics);
    if diagnostics.has_errors() {
        return;
    }
    let (chart, diagnostics) = grafc_model::check(&tree, "fuzzed");
    places(text, &diagnostics);
    assert_eq!(chart.is_none(), diagnostics.has_errors(), "a chart exactly if there is no error: {diagnostics:?}");
    let Some(chart) = chart else { return };
    let profile = profile(text.len() as u64);
    let stimuli = drawn_trace(text.len() as u64, &chart, ROWS);
    let expected = simulate(&chart, profile, &stimuli);
    for (way, options) in exact(profile) {
        let Some(program) = accepted(text, &chart, &options) else { continue };
        let actual = run(&program, &stimuli);
        assert!(
            first_difference(&expected, &actual).is_none(),
            "{way}\n{}",
            report(&chart, profile, &stimuli, &expected, &actual)
        );
    }
    for encoding in Encoding::ALL.into_iter().filter(|encoding| encoding.overlaps()) {
        if let Some(program) = accepted(text, &chart, &Options { profile, encoding, simplify: true }) {
            run(&program, &stimuli);
        }
    }
}

/// The program of an accepted chart, which verifies and is written by all backends or refused with a reason.
fn accepted(text: &str, chart: &Chart, options: &Options) -> Option<grafc_logic::scan::Program> {
    let (program, diagnostics) = lowered(chart, options);
    places(text, &diagnostics);
    if diagnostics.has_errors() {
        return None;
    }
    assert_eq!(grafc_logic::scan::verify(&program), Ok(()), "{}", options.encoding.name());
    let written = [
        st::emit(&program, &st::Options::default()),
        rust::emit(&program, &rust::Options::default()),
        plcopen::emit(&program, &plcopen::Options::default()),
        plcopen::emit_il(&program, &plcopen::Options::default()),
        plcopen::ld::emit(&program, &plcopen::Options::default()),
    ];
    for refused in written.into_iter().filter_map(Result::err) {
        places(text, &refused);
        assert!(refused.has_errors(), "refused without a reason");
    }
    Some(program)
}

/// Every message lies in the text, at the bounds of characters.
fn places(text: &str, diagnostics: &Diagnostics) {
    for message in diagnostics {
        for label in std::iter::once(&message.primary).chain(&message.secondary) {
            assert!(text.get(label.span.range()).is_some(), "{message:?} is not at a place of the text");
        }
    }
}

/// The texts that a target begins with, each with a name.
pub fn seeds(target: &str) -> Vec<(String, String)> {
    let cases = || cases(&vectors_folder()).into_iter().chain(cases(&charts_folder()));
    match target {
        "importer" => imports(),
        "trace" => {
            let header = "t_ms,a,b,c,d,e,f,g,h\n0,0,1,2,3,4,5.5,-6e3,1s\n10,1,-1,2,3,4,0.1,7,1500ms\n".to_owned();
            cases().map(|case| (case.name, case.trace)).chain([("types".to_owned(), header)]).collect()
        }
        _ => {
            let tested = "input a : bool output V : bool initial step 1 step 2 { V } transition 1 -> 2 : a\n\
                scenario \"s\" { 0s : a = 0  after 1s : a = 1 ↑ -> V, not X1  until X2 within 1min -> T2 = 3s }";
            cases().map(|case| (case.name, case.text)).chain([("scenario".to_owned(), tested.to_owned())]).collect()
        }
    }
}

/// The files of other tools in the suite, in order of their names.
fn imports() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("imports");
    let mut found = Vec::new();
    for folder in [folder.join("sfc"), folder] {
        for entry in fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            let is_ours = path.is_dir() || path.extension().is_some_and(|ending| ending == "gct" || ending == "report");
            if let (false, Some(name), Ok(text)) = (is_ours, path.file_stem(), fs::read_to_string(&path)) {
                found.push((name.to_string_lossy().into_owned(), text));
            }
        }
    }
    found.sort();
    found
}
