//! Saved memory is this chart's, as it was saved, or it is refused.

use grafc_backends::rust::{self, Runtime};
use grafc_logic::scan::{Program, dump};
use grafc_logic::{Encoding, Options};
use grafc_testsuite::charts::{cases, charts_folder, check};
use grafc_testsuite::executors::rust::Tools;
use grafc_testsuite::runs::compile_saved;
use std::collections::BTreeMap;
use std::fs;

/// A valve of two coils, its lamp, and a counter that outlives restarts: something of each kind that is saved.
const VALVE: &str = "\
chart Valve
input go, back : bool
input level : int
output open, close, lamp, full : bool
retain output strokes : uint := 5
var seen : real
grafcet Main {
  initial step 1 { close }
  step 2 \"opening\" { open   strokes := strokes + 1 on activation   full if [level > 10] }
  step 3 { open   seen := seen + 0.5 on deactivation }
  step 4
  transition 1 -> 2 : ↑go
  transition 2 -> 3 : 500ms/X2
  transition 3 -> 4 : 1s/X3/2s
  transition 4 -> 1 : back
}
grafcet Lamps {
  initial step 10 \"dark\"
  step 11 { lamp }
  transition 10 -> 11 : X2
  transition 11 -> 10 : X1
}
";

fn program(text: &str, encoding: Encoding) -> Option<Program> {
    let chart = check("chart", text).ok()?;
    compile_saved(&chart, &Options { encoding, ..Options::default() }).ok()
}

/// What a program of rustc asks of a chart. Behind each saved memory: every single flip and ten thousand double ones are
/// refused; and where somebody has sealed a flip again, it is refused or it is a memory like any other, whose steps do
/// not contradict each other.
const MAIN: &str = r#"
fn random(state: &mut u64) -> usize {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    *state as usize
}

fn look<const N: usize>(saved: [u8; N], restore: impl Fn(&[u8]) -> Option<([u8; N], bool)>) {
    assert!(restore(&saved).is_some_and(|(again, _)| again == saved));
    let flip = |bytes: &mut [u8], bit: usize| bytes[bit / 8] ^= 1 << (bit % 8);
    for bit in 0..8 * N {
        let mut bytes = saved;
        flip(&mut bytes, bit);
        assert!(restore(&bytes).is_none(), "bit {bit}");
        grafc_runtime::seal(&mut bytes);
        if let Some((again, possible)) = restore(&bytes) {
            assert!(again == bytes && possible, "bit {bit}, sealed");
        }
    }
    let mut state = 0x1234_5678_9abc_def1;
    for _ in 0..10_000 {
        let (one, other) = (random(&mut state) % (8 * N), random(&mut state) % (8 * N));
        let mut bytes = saved;
        flip(&mut bytes, one);
        flip(&mut bytes, other);
        assert!(restore(&bytes).is_none() || bytes == saved, "bits {one} and {other}");
    }
    // Forged: a few bytes behind the fingerprint are others, small as numbers of states are, and sealed.
    let mut taken = 0;
    for _ in 0..10_000 {
        let mut bytes = saved;
        for _ in 0..1 + random(&mut state) % 4 {
            let at = 8 + random(&mut state) % (N - 8);
            bytes[at] = (random(&mut state) % 6) as u8;
        }
        grafc_runtime::seal(&mut bytes);
        if let Some((again, possible)) = restore(&bytes) {
            assert!(again == bytes && possible, "{bytes:?}");
            taken += usize::from(bytes != saved);
        }
    }
    assert!(taken > 100, "only {taken} of the forged memories could be others");
    assert!(restore(&saved[1..]).is_none() && restore(&[]).is_none());
    assert!(restore(&[0; N]).is_none() && restore(&[255; N]).is_none());
}

fn main() {
    use valve::{Inputs, Step, Valve};
    let inputs = |go, level| Inputs { go, back: false, level };
    let mut chart = Valve::new();
    let possible = |chart: &Valve| {
        let active = |step| usize::from(chart.is_active(step));
        let main = active(Step::X1) + active(Step::X2) + active(Step::X3) + active(Step::X4);
        let lamps = active(Step::X10) + active(Step::X11);
        let outputs = chart.outputs();
        // Also before the first call, when nothing is active.
        (main == 1 && lamps == 1 || main + lamps == 0)
            && outputs.close == chart.is_active(Step::X1)
            && outputs.open == (chart.is_active(Step::X2) || chart.is_active(Step::X3))
            && outputs.lamp == chart.is_active(Step::X11)
            && outputs.full == chart.is_active(Step::X2)
    };
    let restore = |bytes: &[u8]| {
        let chart = Valve::restore(bytes, &inputs(true, 11), 7)?;
        Some((chart.save(), possible(&chart)))
    };
    let again = |bytes: &[u8]| Valve::restarted(bytes).map(|chart| (chart.save_retained(), true));
    look(chart.save(), restore);
    for (go, now) in [(false, 0), (true, 100), (true, 300), (true, 600), (true, 700), (true, 1_700)] {
        chart.scan(&inputs(go, 0), now);
        look(chart.save(), restore);
        look(chart.save_retained(), again);
    }
    // In step 2 the level alone decides on `full`.
    let mut chart = Valve::new();
    chart.scan(&inputs(false, 0), 0);
    chart.scan(&inputs(true, 0), 100);
    let full = |level| Valve::restore(&chart.save(), &inputs(true, level), 0).map(|chart| chart.outputs().full);
    assert!(!chart.outputs().full);
    assert_eq!((full(10), full(11)), (Some(false), Some(true)));
}
"#;

#[test]
fn what_has_changed_is_refused() {
    let Some(tools) = Tools::find_or_skip() else { return };
    for encoding in Encoding::ALL {
        // Where steps overlap, two of them may be active for a while: nothing is proved of them.
        if encoding.overlaps() {
            continue;
        }
        let program = program(VALVE, encoding).expect("a chart without errors");
        let options =
            rust::Options { module: Some("valve".into()), runtime: Runtime::Crate, ..rust::Options::default() };
        let module = rust::emit(&program, &options).expect("a module");
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("main.rs"), module + MAIN).expect("a file in a temporary folder");
        tools.build(folder.path()).unwrap_or_else(|said| panic!("{}: {said}", encoding.name()));
        tools.play(folder.path()).unwrap_or_else(|said| panic!("{}: {said}", encoding.name()));
    }
}

/// A program without what is only said of it.
fn doing(program: &Program) -> String {
    let is_said = |line: &&str| !line.trim_start().starts_with("-- ");
    let text = dump(program);
    let lines = text.lines().filter(is_said).map(|line| line.split("  -- ").next().unwrap_or_default());
    lines.map(|line| line.split(" \"").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

/// The texts in which one word or sign is another: two names changed for each other, a number one more, a word gone.
fn edits(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    let words: Vec<(usize, &str)> = text
        .match_indices(|c: char| c.is_alphanumeric() || c == '_')
        .filter(|(at, _)| !text[..*at].ends_with(|c: char| c.is_alphanumeric() || c == '_'))
        .map(|(at, _)| {
            let rest = &text[at..];
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
            (at, &rest[..end])
        })
        .collect();
    for (place, (at, word)) in words.iter().enumerate() {
        let with = |new: &str| format!("{}{new}{}", &text[..*at], &text[at + word.len()..]);
        match word.parse::<u32>() {
            Ok(number) => out.push(with(&(number + 1).to_string())),
            Err(_) => out.push(with("")),
        }
        if let Some((_, next)) = words.get(place + 1) {
            out.push(with(next));
        }
    }
    for sign in ["↑", "not ", " and ", " or ", "retain ", "initial "] {
        for (at, _) in text.match_indices(sign) {
            let with = |new: &str| format!("{}{new}{}", &text[..at], &text[at + sign.len()..]);
            out.push(with(match sign {
                " and " => " or ",
                " or " => " and ",
                "↑" => "↓",
                _ => "",
            }));
        }
    }
    out
}

/// Two programs have one fingerprint exactly if they do the same in the same memory.
#[test]
fn an_edit_that_changes_the_program_changes_the_fingerprint() {
    let (mut programs, mut changed) = (0, 0);
    for encoding in [Encoding::SinglePhase, Encoding::Switch] {
        let mut texts = vec![VALVE.to_owned()];
        texts.extend(cases(&charts_folder()).into_iter().filter(|case| case.text.len() < 2_500).map(|case| case.text));
        for text in texts {
            let Some(own) = program(&text, encoding) else { continue };
            let mut known: BTreeMap<String, u64> = BTreeMap::from([(doing(&own), own.fingerprint())]);
            let mut prints: BTreeMap<u64, String> = BTreeMap::from([(own.fingerprint(), doing(&own))]);
            for edited in edits(&text) {
                let Some(other) = program(&edited, encoding) else { continue };
                programs += 1;
                let (does, print) = (doing(&other), other.fingerprint());
                changed += usize::from(print != own.fingerprint());
                assert_eq!(*known.entry(does.clone()).or_insert(print), print, "{edited}");
                assert_eq!(*prints.entry(print).or_insert_with(|| does.clone()), does, "{edited}");
            }
        }
    }
    // Else nothing has been tried.
    assert!(programs > 500 && changed > 400, "{programs} programs, {changed} of them others");
}

#[test]
fn what_is_only_said_changes_nothing() {
    let said = VALVE.replace("\"opening\"", "\"the valve opens\" // slowly\n\n");
    assert_ne!(said, VALVE);
    for encoding in Encoding::ALL {
        let print = |text: &str| program(text, encoding).map(|program| program.fingerprint());
        assert_eq!(print(&said), print(VALVE));
        // Which of them opens and which closes: the names and their types are the same.
        let changed = VALVE.replace("{ close }", "{ open }").replace("\"opening\" { open ", "\"opening\" { close ");
        assert_ne!(print(&changed), print(VALVE));
    }
}
