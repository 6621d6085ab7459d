//! What grafc writes of a chart in C beside a source and its header: one file, a sketch of Arduino; a whole project; and what
//! stands beside names that had to change.

use grafc_backends::c::{self, Files, Pins};
use grafc_logic::{Encoding, Options};
use grafc_model::chart::{Type, VariableKind};
use grafc_testsuite::binary::{grafc, root};
use grafc_testsuite::charts::{cases, charts_folder, check};
use grafc_testsuite::executors::c::{ALL_KINDS, Arduino, Tools};
use grafc_testsuite::runs::compile_saved;
use grafc_testsuite::tools::{Tool, or_skip};
use std::fs;
use std::process::Command;

fn is_outside(kind: VariableKind) -> bool {
    matches!(kind, VariableKind::Input | VariableKind::Output)
}

/// A file of pins for all inputs and outputs.
fn pins(text: &str, name: &str) -> Pins {
    let chart = check(name, text).unwrap_or_else(|error| panic!("{name}: {error}"));
    let lines: Vec<String> = chart
        .variables
        .iter()
        .filter(|variable| is_outside(variable.kind))
        .enumerate()
        .map(|(place, variable)| match (variable.ty == Type::Bool, variable.kind == VariableKind::Input) {
            (true, true) => format!("{} = {} pullup inverted", variable.name, place + 2),
            (true, false) => format!("{} = {} inverted", variable.name, place + 2),
            (false, true) => format!("{} = A{}", variable.name, place % 16),
            (false, false) => format!("{} = {}", variable.name, place + 2),
        })
        .collect();
    Pins::parse("pins", &lines.join("\n")).expect("a file of pins")
}

fn sketch(name: &str, text: &str, encoding: Encoding) -> String {
    let chart = check(name, text).unwrap_or_else(|error| panic!("{name}: {error}"));
    let program = compile_saved(&chart, &Options { encoding, ..Options::default() }).expect("a program");
    let options = c::Options { files: Files::Sketch(pins(text, name)), ..c::Options::default() };
    let (source, header) = c::emit(&program, &options).unwrap_or_else(|diagnostics| panic!("{name}: {diagnostics:?}"));
    assert!(header.is_none());
    source
}

/// Names that are macros of Arduino or of the processor.
const MACROS: &str = "\
chart PINB
input B1, PORTB, A0, LOW, INPUT, min, abs, F : bool
output HIGH, OUTPUT, SPDR, LED_BUILTIN : bool
var UDR0 : int
initial step B0 { HIGH OUTPUT UDR0 := UDR0 + 1 on activation }
step PORTC { SPDR LED_BUILTIN }
transition B0 -> PORTC : B1 and PORTB or A0 and LOW
transition PORTC -> B0 : INPUT or min and abs or F or [UDR0 > 3]
";

#[test]
fn sketches_compile_for_arduino() {
    let Some(arduino) = Arduino::find_or_skip() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let numbers = ALL_KINDS.replace("input t : time", "var t : time").replace("output c : time", "var c : time");
    let mut charts = vec![("macros".to_owned(), MACROS.to_owned()), ("numbers".to_owned(), numbers)];
    charts.extend(cases(&charts_folder()).into_iter().map(|case| (case.name, case.text)));
    let mut compiled = 0;
    for (name, text) in &charts {
        let chart = check(name, text).unwrap_or_else(|error| panic!("{name}: {error}"));
        if chart.variables.iter().any(|v| is_outside(v.kind) && matches!(v.ty, Type::Time | Type::Lreal)) {
            continue;
        }
        for encoding in [Encoding::Switch, Encoding::SinglePhase] {
            let source = sketch(name, text, encoding);
            fs::write(folder.path().join("sketch.ino"), &source).expect("a temporary file");
            arduino.compile(folder.path(), "sketch.ino").unwrap_or_else(|said| panic!("{name}: {said}\n{source}"));
            compiled += 1;
        }
    }
    assert!(compiled > 20, "sketches that were compiled");
    arduino.link(folder.path()).expect("a program for a board");
}

/// What is read and written, by hand.
#[test]
fn a_sketch_reads_and_writes_pins() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let text = "chart Lamp\ninput button : bool at %IX0.2\ninput level : int\noutput lamp : bool at %QX1.5\n\
                initial step 1\nstep 2 { lamp }\ntransition 1 -> 2 : ↑button\ntransition 2 -> 1 : [level > 3]\n";
    fs::write(folder.path().join("lamp.gct"), text).expect("a temporary file");
    fs::write(folder.path().join("lamp.pins"), "level = A3 # a pot\n").expect("a temporary file");
    let call = |more: &[&str]| {
        let mut command = grafc();
        command.args(["lamp.gct", "--target", "c", "--arduino"]).args(more).current_dir(folder.path());
        let output = command.output().expect("grafc runs");
        (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    assert_eq!(call(&["--single", "--pins", "lamp.pins", "-o", "lamp/"]), (true, String::new()));
    let files: Vec<_> = fs::read_dir(folder.path().join("lamp")).expect("the folder").collect();
    assert_eq!(files.len(), 1);
    let source = fs::read_to_string(folder.path().join("lamp/lamp.ino")).expect("the sketch");
    for line in [
        "static const uint8_t pin_button = 2;",
        "static const uint8_t pin_level = A3;",
        "static const uint8_t pin_lamp = 13;",
        "    pinMode(pin_button, mode_input);",
        "    pinMode(pin_lamp, mode_output);",
        "    inputs.button = digitalRead(pin_button) != 0;",
        "    inputs.level = (int16_t)analogRead(pin_level);",
        "    (void)Lamp_scan(&chart, &inputs, millis());",
        "    digitalWrite(pin_lamp, chart.outputs.lamp ? 1 : 0);",
    ] {
        assert_eq!(source.lines().filter(|other| *other == line).count(), 1, "{line}\n{source}");
    }
    let inverted = "level = A3\nbutton = 4 pullup inverted\nlamp = 5 inverted\n";
    fs::write(folder.path().join("lamp.pins"), inverted).expect("a temporary file");
    assert_eq!(call(&["--single", "--pins", "lamp.pins", "-o", "inverted/"]), (true, String::new()));
    let source = fs::read_to_string(folder.path().join("inverted/lamp.ino")).expect("the sketch");
    for line in [
        "    digitalWrite(pin_lamp, 1);",
        "    inputs.button = digitalRead(pin_button) == 0;",
        "    digitalWrite(pin_lamp, chart.outputs.lamp ? 0 : 1);",
    ] {
        assert_eq!(source.lines().filter(|other| *other == line).count(), 1, "{line}\n{source}");
    }
    let (done, said) = call(&["-o", "other/"]);
    assert!(!done && said.contains("E0507") && said.contains("`level` has no pin"), "{said}");
    fs::write(folder.path().join("lamp.pins"), "level = 2\nvalve = 3\n").expect("a temporary file");
    let (done, said) = call(&["--pins", "lamp.pins", "-o", "other/"]);
    assert!(!done && said.contains("both at pin 2") && said.contains("`valve` has a pin"), "{said}");
    fs::write(folder.path().join("lamp.pins"), "level\nvalve = up\n= 3").expect("a temporary file");
    let (done, said) = call(&["--pins", "lamp.pins", "-o", "other/"]);
    assert!(!done && said.contains("line 1: ") && said.contains("line 3: "), "{said}");
    assert!(!folder.path().join("other").exists());
}

/// One file holds all, and is what standard output gives.
#[test]
fn one_file_needs_no_header() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let chart = charts_folder().join("weigh_mix_b4.gct");
    let call = |arguments: &[&str]| {
        let output = grafc().arg(&chart).args(arguments).current_dir(folder.path()).output().expect("grafc runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    assert_eq!(call(&["--single", "-o", "plant.c"]), "");
    let files: Vec<_> = fs::read_dir(folder.path()).expect("the folder").collect();
    assert_eq!(files.len(), 1);
    let source = fs::read_to_string(folder.path().join("plant.c")).expect("the source");
    assert_eq!(source, call(&["--target", "c", "--single"]));
    if let Some(tools) = Tools::find_or_skip() {
        tools.object(folder.path(), "plant.c", &[]).unwrap_or_else(|said| panic!("{said}\n{source}"));
    }
}

/// `runtime-support/examples/weigh_mix_c`, as its Makefile builds it, says what its story says.
#[test]
fn the_example_project_plays_its_story() {
    let Some(_) = Tools::find_or_skip() else { return };
    let found = Command::new("make").arg("--version").output();
    let found = found.map(|_| ()).map_err(|_| "make cannot be called".to_owned());
    if or_skip(Tool::Make, found).is_none() {
        return;
    }
    let examples = root().join("runtime-support/examples");
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (from, files) in [
        ("weigh_mix", &["weigh_mix.gct"][..]),
        ("weigh_mix_c", &["Makefile", "main.c", "plant.c", "plant.h", "story.txt"][..]),
    ] {
        fs::create_dir(folder.path().join(from)).expect("a folder");
        for file in files {
            fs::copy(examples.join(from).join(file), folder.path().join(from).join(file))
                .expect("a file of the example");
        }
    }
    let mut grafc_path = std::ffi::OsString::from("GRAFC=");
    grafc_path.push(grafc().get_program());
    let flags = "CFLAGS=-Wall -Wextra -Wconversion -Wshadow -Werror";
    let output = Command::new("make")
        .arg(grafc_path)
        .args([flags, "check"])
        .current_dir(folder.path().join("weigh_mix_c"))
        .output();
    let output = output.expect("make runs");
    let said = [output.stdout, output.stderr].concat();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&said));
}

/// A name that had to change has the original beside it, in backquotes, in the comment of its field.
#[test]
fn names_that_changed_are_told() {
    let text = "chart Told\ninput int \"a */ b\", `a b` : bool\noutput while, plain : bool\nvar `x-y` : int\n\
                initial step `1+` { while `x-y` := 1 on activation }\nstep 2 { plain }\n\
                transition `1+` -> 2 : int\ntransition 2 -> `1+` : `a b`\n";
    let chart = check("told", text).unwrap_or_else(|error| panic!("{error}"));
    let program = compile_saved(&chart, &Options::default()).expect("a program");
    let (source, _) = c::emit(&program, &c::Options::default()).expect("a source");
    for (field, original) in
        [("bool int_", "`int`"), ("bool a_b;", "`a b`"), ("bool while_", "`while`"), ("int16_t x_y;", "`x-y`")]
    {
        let line = source.lines().find(|line| line.trim_start().starts_with(field));
        assert!(line.is_some_and(|line| line.contains(original)), "{field}: {line:?}\n{source}");
    }
    assert!(source.contains("step `1+`"), "{source}");
    assert!(source.contains("a * / b") && !source.contains("a */ b"), "{source}");
    let plain = source.lines().find(|line| line.trim() == "bool plain;");
    assert!(plain.is_some(), "what was not changed is not told\n{source}");
}
