//! `grafc CHART --target st`.

mod common;

use common::{DUBIOUS, FAULTY, Folder, VALVE};

#[test]
fn code_goes_to_standard_output_or_to_a_file() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let printed = folder.run(&["valve.gct", "--target", "st"]);
    printed.is_done();
    assert!(printed.out.contains("FUNCTION_BLOCK Valve"), "{}", printed.out);
    assert!(printed.out.contains("END_FUNCTION_BLOCK"), "{}", printed.out);

    let written = folder.run(&["--target", "st", "-o", "valve.st", "valve.gct"]);
    assert_eq!(written.is_done().out, "");
    assert_eq!(folder.read("valve.st"), printed.out);
    assert_eq!(folder.run(&["valve.gct", "--target", "st", "-o", "-"]).is_done().out, printed.out);
}

#[test]
fn equal_runs_give_equal_code() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let first = folder.run(&["valve.gct", "--target", "st"]);
    assert_eq!(folder.run(&["valve.gct", "--target", "st"]).is_done().out, first.out);
    let elsewhere = folder.path("valve.gct").display().to_string();
    assert_eq!(folder.run(&[&elsewhere, "--target", "st"]).is_done().out, first.out);
}

#[test]
fn standard_input_is_a_chart_too() {
    let folder = Folder::new(&[]);
    let run = folder.run_with(&["-", "--target", "st"], VALVE);
    assert!(run.is_done().out.contains("FUNCTION_BLOCK Valve"));
    folder.run_with(&["-", "--target", "st"], FAULTY).ends(1, "<stdin>:6:25");
}

#[test]
fn a_chart_without_a_name_is_called_after_its_file() {
    let nameless = VALVE.replace("chart Valve \"one valve\"", "");
    let folder = Folder::new(&[("pump.gct", &nameless)]);
    assert!(folder.run(&["pump.gct", "--target", "st"]).is_done().out.contains("FUNCTION_BLOCK pump"));
    let run = folder.run_with(&["-", "--target", "st"], &nameless);
    assert!(run.is_done().out.contains("FUNCTION_BLOCK chart"), "{}", run.out);
}

#[test]
fn a_chart_named_like_a_command_is_given_by_path() {
    let folder = Folder::new(&[("check", VALVE)]);
    assert!(folder.run(&["./check", "--target", "st"]).is_done().out.contains("FUNCTION_BLOCK Valve"));
}

#[test]
fn errors_stop_without_output() {
    let folder = Folder::new(&[("faulty.gct", FAULTY), ("old.st", "as it was")]);
    let run = folder.run(&["faulty.gct", "--target", "st"]);
    run.ends(1, "error[E0201]").ends(1, "faulty.gct:6:25");
    assert_eq!(run.out, "");
    assert!(run.err.ends_with("\n1 error\n"), "{}", run.err);

    folder.run(&["faulty.gct", "--target", "st", "-o", "new.st"]).ends(1, "E0201");
    folder.run(&["faulty.gct", "--target", "st", "-o", "old.st"]).ends(1, "E0201");
    assert_eq!(folder.names(), ["faulty.gct", "old.st"]);
    assert_eq!(folder.read("old.st"), "as it was");
}

#[test]
fn warnings_do_not_stop() {
    let folder = Folder::new(&[("dubious.gct", DUBIOUS)]);
    let run = folder.run(&["dubious.gct", "--target", "st", "-o", "out.st"]);
    run.ends(0, "warning[W0403]");
    assert!(run.err.ends_with("\n1 warning\n"), "{}", run.err);
    assert!(folder.read("out.st").contains("FUNCTION_BLOCK dubious"));
}

#[test]
fn messages_may_be_json_and_go_to_standard_error() {
    let folder = Folder::new(&[("faulty.gct", FAULTY)]);
    let run = folder.run(&["faulty.gct", "--target", "st", "--format", "json"]);
    assert_eq!(run.ends(1, "").out, "");
    let message: serde_json::Value = serde_json::from_str(run.err.trim_end()).unwrap();
    assert_eq!(message["code"], "E0201");
    assert_eq!(message["start"]["line"], 6);
}

#[test]
fn a_text_that_is_not_utf8_is_an_error_at_its_first_bad_byte() {
    let folder = Folder::new(&[]);
    std::fs::write(folder.path("latin.gct"), b"initial step 1 \"f\xFCllen\"\n").unwrap();
    folder.run(&["latin.gct", "--target", "st"]).ends(1, "error[E0110]").ends(1, "offset 17").ends(1, "latin.gct:1:18");
    folder.run_with(&["check", "-"], b"\xFF").ends(1, "E0110");
}

#[test]
fn choices_reach_the_code() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let code = |arguments: &[&str]| {
        let all: Vec<&str> = ["valve.gct", "--target", "st"].iter().chain(arguments).copied().collect();
        folder.run(&all).is_done().out.clone()
    };
    let plain = code(&[]);
    assert_eq!(code(&["--encoding", "single-phase", "--evolution", "stable", "--initial-actions", "on"]), plain);
    assert_eq!(code(&["--optimize", "1"]), plain);
    assert_eq!(code(&["--pou", "function-block"]), plain);
    assert_ne!(code(&["--evolution", "scan"]), plain);
    assert!(code(&["--pou", "program"]).contains("\nPROGRAM "));
    let configuration = code(&["--pou", "configuration", "--task-interval", "50ms"]);
    assert!(configuration.contains("CONFIGURATION"), "{configuration}");
    assert!(configuration.to_uppercase().contains("T#50MS"), "{configuration}");
}

#[test]
fn choices_reach_the_files_of_tools() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let code = |arguments: &[&str]| {
        let all: Vec<&str> = ["valve.gct", "--target"].iter().chain(arguments).copied().collect();
        folder.run(&all).is_done().out.clone()
    };
    let plain = code(&["plcopen"]);
    assert_eq!(code(&["plcopen", "--dialect", "neutral", "--body", "st"]), plain);
    assert!(plain.contains("tc6_0201") && plain.contains("interval=\"T#20ms\""), "{plain}");
    assert!(code(&["plcopen", "--task-interval", "2s"]).contains("interval=\"T#2s\""));
    let codesys = code(&["plcopen", "--dialect", "codesys"]);
    assert!(codesys.contains("tc6_0200") && codesys.contains("<configurations/>"), "{codesys}");
    assert!(code(&["plcopen", "--dialect", "codesys", "--task-interval", "2s"]).contains("interval=\"PT2.000S\""));
    let instructions = code(&["plcopen", "--body", "il"]);
    assert!(instructions.contains("<IL>") && instructions.contains("--body il"), "{instructions}");
    let ladder = code(&["plcopen", "--body", "ld", "--evolution", "scan"]);
    assert!(ladder.contains("<LD>") && ladder.contains("--body ld"), "{ladder}");
    folder
        .run(&["valve.gct", "--target", "plcopen", "--dialect", "codesys", "--body", "ld"])
        .ends(2, "`--body ld` draws for the readers of `--dialect neutral` alone");
    let drawn = code(&["plcopen", "--body", "sfc", "--evolution", "scan"]);
    assert!(drawn.contains("<SFC>") && drawn.contains("--body sfc"), "{drawn}");
    assert!(code(&["scl"]).starts_with("FUNCTION_BLOCK \"Valve\"\n"));
    assert!(code(&["tcpou"]).contains("<POU Name=\"Valve\""));
    assert!(code(&["iec61131-10"]).contains("<FunctionBlock name=\"Valve\">"));
    for (arguments, owner) in [
        (["st", "--dialect", "codesys"], "`--target plcopen`"),
        (["scl", "--body", "st"], "`--target plcopen`"),
        (["rust", "--task-interval", "1s"], "`--target st`, `--target il`, `--target sfc` and `--target plcopen`"),
        (["plcopen", "--runtime", "crate"], "`--target rust`"),
        (["tcpou", "--pou", "program"], "`--target st`, `--target il`, `--target sfc` and `--target awl`"),
        (["scl", "--block-number", "7"], "`--target awl`"),
        (["il", "--mnemonics", "german"], "`--target awl`"),
    ] {
        let all: Vec<&str> = ["valve.gct", "--target"].iter().chain(&arguments).copied().collect();
        folder.run(&all).ends(2, &format!("`{}` is an option of {owner}", arguments[1]));
    }
}

#[test]
fn an_instruction_list_is_the_same_function_block() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let code = |target: &str, arguments: &[&str]| {
        let all: Vec<&str> = ["valve.gct", "--target", target].iter().chain(arguments).copied().collect();
        folder.run(&all).is_done().out.clone()
    };
    let declarations = |text: &str| {
        let (head, body) = text.rsplit_once("END_VAR").unwrap();
        let (_, variables) = head.split_once("FUNCTION_BLOCK").unwrap();
        (variables.to_string(), body.to_string())
    };
    let (list, text) = (code("il", &[]), code("st", &[]));
    assert!(list.contains("--target il --encoding single-phase"), "{list}");
    assert_eq!(declarations(&list).0, declarations(&text).0);
    assert!(!declarations(&list).1.contains(';') && declarations(&list).1.contains("    LD    X1 "), "{list}");
    assert!(code("il", &["--pou", "configuration", "--task-interval", "50ms"]).contains("T#50ms"));
    folder.run(&["valve.gct", "--target", "il", "--task-interval", "50ms"]).ends(2, "of a configuration's task");
    folder.run(&["valve.gct", "--target", "il", "--runtime", "crate"]).ends(2, "an option of `--target rust`");
    folder
        .run(&["valve.gct", "--target", "rust", "--pou", "program"])
        .ends(2, "`--target st`, `--target il`, `--target sfc` and `--target awl`");
}

#[test]
fn a_source_of_step_7_has_numbered_blocks() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("scale.gct", SCALE)]);
    let code = |arguments: &[&str]| {
        let all: Vec<&str> = ["valve.gct", "--target", "awl"].iter().chain(arguments).copied().collect();
        folder.run(&all).is_done().out.clone()
    };
    let plain = code(&[]);
    assert_eq!(code(&["--pou", "function-block", "--block-number", "1", "--mnemonics", "english"]), plain);
    assert!(plain.contains("\nFUNCTION_BLOCK FB 1\n") && plain.contains("\nDATA_BLOCK DB 1\n"), "{plain}");
    assert!(plain.contains("--target awl --encoding single-phase") && !plain.contains("ORGANIZATION_BLOCK"), "{plain}");
    let whole = code(&["--pou", "program", "--block-number", "70"]);
    assert!(whole.contains("\nORGANIZATION_BLOCK OB 1\n") && whole.contains("CALL  FB 70, DB 70 ("), "{whole}");
    assert!(code(&["--mnemonics", "german"]).contains("      U     #"));
    let wrong = |arguments: &[&str], said: &str| {
        let all: Vec<&str> = ["valve.gct", "--target", "awl"].iter().chain(arguments).copied().collect();
        folder.run(&all).ends(2, said);
    };
    wrong(&["--pou", "configuration"], "`--pou program` writes an OB 1");
    wrong(&["--task-interval", "50ms"], "an option of `--target st`");
    wrong(&["--block-number", "0"], "0");
    folder
        .run(&["scale.gct", "--target", "awl"])
        .ends(1, "error[E0504]: `weight` is an `lreal`")
        .ends(1, "scale.gct:1:7");
}

/// A number of double precision.
const SCALE: &str = "input weight : lreal\noutput full : bool\ninitial step 1\nstep 2 { full }\n\
    transition 1 -> 2 : [weight > 1.5]\ntransition 2 -> 1 : [weight < 0.5]\n";

#[test]
fn every_encoding_holds_the_situation_in_its_own_way() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let code = |encoding: &str| {
        folder.run(&["valve.gct", "--target", "st", "--encoding", encoding, "--allow", "W0413"]).is_done().out.clone()
    };
    let encodings = ["single-phase", "r-trigger", "s-trigger", "sequent", "switch"];
    let codes = encodings.map(code);
    for (place, text) in codes.iter().enumerate() {
        assert!(text.contains(&format!("--encoding {} ", encodings[place])), "{text}");
        let body = |text: &str| text.split_once("*)").map(|(_, body)| body.to_string());
        assert!(codes[..place].iter().all(|other| body(other) != body(text)), "{text}");
    }
    // One step is active at any time: a number says which.
    assert!(codes[4].contains("CASE at_G1 OF\n        1:  IF a THEN at_G1 := 2;"), "{}", codes[4]);
    assert!(!codes[4].contains("X1 : BOOL") && codes[0].contains("X1, X2 : BOOL"), "{}\n{}", codes[0], codes[4]);
}

#[test]
fn the_level_of_optimisation_is_said_if_it_is_not_the_usual_one() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let code = |arguments: &[&str]| {
        let all: Vec<&str> = ["valve.gct", "--target", "st"].iter().chain(arguments).copied().collect();
        folder.run(&all).is_done().out.clone()
    };
    let plain = code(&["-O0"]);
    assert_eq!(code(&["-O", "0"]), plain);
    assert_eq!(code(&["--optimize", "0"]), plain);
    assert_eq!(code(&["--optimize=0"]), plain);
    assert!(plain.contains("--encoding single-phase --optimize 0 --evolution"), "{plain}");
    assert_eq!(code(&["-O1"]), code(&[]));
    assert!(!code(&[]).contains("optimize"));
    // One token moves: that a clearing changes something need not be asked step by step.
    assert!(plain.len() > code(&[]).len(), "{plain}");
}

#[test]
fn code_says_what_made_it() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let head = |arguments: &[&str]| {
        let out = folder.run(arguments).is_done().out.clone();
        out.lines().take(4).collect::<Vec<_>>().join("\n")
    };
    let plain = head(&["valve.gct", "--target", "st"]);
    assert!(plain.contains(&format!("grafc {} from valve.gct", env!("CARGO_PKG_VERSION"))), "{plain}");
    assert!(plain.contains("--encoding single-phase --evolution stable --initial-actions on"), "{plain}");
    assert!(head(&["valve.gct", "--target", "st", "--bound", "7"]).contains("--bound 7"));
}

#[test]
fn wrong_use_ends_with_2() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    folder.run(&[]).ends(2, "Usage: grafc");
    folder.run(&["valve.gct"]).ends(2, "nothing says what to make of `valve.gct`").ends(2, "add `--target st`");
    folder.run(&["valve.gct", "-t", "st", "--emit", "net"]).ends(2, "cannot be used with");
    folder.run(&["--target", "st"]).ends(2, "CHART");
    folder.run(&["valve.gct", "--target", "fortran"]).ends(2, "possible values: st");
    folder.run(&["valve.gct", "--target", "st", "--encoding", "gray"]).ends(2, "single-phase");
    folder.run(&["valve.gct", "--target", "st", "-O2"]).ends(2, "possible values: 0, 1");
    folder.run(&["valve.gct", "--target", "st", "-O"]).ends(2, "--optimize <LEVEL>");
    folder.run(&["valve.gct", "--target", "st", "--bound", "0"]).ends(2, "--bound");
    folder.run(&["valve.gct", "--target", "st", "--task-interval", "20ms"]).ends(2, "--pou configuration");
    folder
        .run(&["valve.gct", "--target", "st", "--pou", "configuration", "--task-interval", "0ms"])
        .ends(2, "task-interval");
    folder.run(&["valve.gct", "--target", "st", "--nonsense"]).ends(2, "--nonsense");
    folder.run(&["chek", "valve.gct"]).ends(2, "similar command exists: `grafc check`");
    folder.run(&["valve.gct", "check"]).ends(2, "a command comes first: `grafc check ...`");
    folder.run(&["run", "valve.gct"]).ends(2, "that is `grafc sim CHART --trace IN.csv`");
    folder.run(&["run", "valve.gct", "--trace", "t.csv"]).ends(2, "grafc has no command `run`");
    folder.run(&["valve", "-t", "st"]).ends(2, "there is `valve.gct`");
    // What is no word, or a command that was called wrongly, is what it looks like.
    folder.run(&["./run", "-t", "st"]).ends(3, "cannot read `./run`");
    folder.run(&["check", "--nonsense"]).ends(2, "unexpected argument '--nonsense'");
    assert_eq!(folder.names(), ["valve.gct"]);
}

#[test]
fn the_chart_is_never_overwritten() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    folder.run(&["valve.gct", "--target", "st", "-o", "valve.gct"]).ends(2, "overwrite `valve.gct`");
    folder.run(&["valve.gct", "--target", "st", "-o", "./valve.gct"]).ends(2, "overwrite");
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("valve.gct", folder.path("link.st")).unwrap();
        folder.run(&["valve.gct", "--target", "st", "-o", "link.st"]).ends(2, "overwrite");
        std::fs::hard_link(folder.path("valve.gct"), folder.path("hard.st")).unwrap();
        folder.run(&["valve.gct", "--target", "st", "-o", "hard.st"]).ends(2, "overwrite");
    }
    assert_eq!(folder.read("valve.gct"), VALVE);
}

#[test]
fn a_bound_has_its_limits() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    for refused in ["0", "2147483648", "4294967296", "-1", "many"] {
        folder.run(&["valve.gct", "--target", "st", &format!("--bound={refused}")]).ends(2, "from 1 to 2147483647");
    }
    let largest = folder.run(&["valve.gct", "--target", "st", "--bound", "2147483647"]);
    assert!(largest.is_done().out.contains("micro_steps >= 2147483647"));
    let auto = folder.run(&["valve.gct", "--target", "st", "--bound", "auto"]);
    assert!(auto.is_done().out.contains("--bound auto"));
}

#[test]
fn names_of_controls_are_names() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    for refused in ["", " ", "a`b", "a\nb"] {
        folder.run(&["valve.gct", "--target", "st", "--reset-input", refused]).ends(2, "no name");
    }
    folder.run(&["valve.gct", "--target", "st", "--reset-keeps-retained"]).ends(2, "--reset-input");
    folder.run(&["valve.gct", "--target", "st", "--reset-input", "a"]).ends(1, "E0216");
    let made = folder.run(&["valve.gct", "--target", "st", "--reset-input", "`step`", "--clear-flags-input", "ack"]);
    assert!(made.is_done().out.contains("ack : BOOL;"));
}

#[test]
fn what_the_heading_chooses_may_be_repeated_and_not_changed() {
    let valve = "chart Valve evolution scan initial_actions off\ninput a : bool\noutput V : bool\ninitial step 1\n\
                 step 2 { V }\ntransition 1 -> 2 : a\ntransition 2 -> 1 : not a\n";
    let folder = Folder::new(&[("valve.gct", valve), ("in.csv", "t_ms,a\n0,1\n")]);
    let commands: [&[&str]; 6] = [
        &["valve.gct", "--target", "st"],
        &["sim", "valve.gct", "--trace", "in.csv"],
        &["stats", "valve.gct"],
        &["graph", "valve.gct"],
        &["verify", "valve.gct"],
        &["page", "valve.gct"],
    ];
    for command in commands {
        let with = |options: &[&'static str]| folder.run(&[command, options].concat());
        let plain = with(&[]).is_done().out.clone();
        let repeated = with(&["--evolution", "scan", "--initial-actions", "off"]);
        assert_eq!(repeated.is_done().out, plain, "{command:?}");
        let changed = [["--evolution", "stable"], ["--initial-actions", "on"], ["--bound", "7"], ["--bound", "auto"]];
        for options in changed {
            let refused = with(&options);
            assert!(refused.err.contains("error[E0217]"), "{command:?} {options:?}: {}", refused.err);
            // Each cure is to leave the option out, which `plain` shows to be right.
            let cure = if options[0] == "--bound" { "leave `--bound` out" } else { "ask for nothing" };
            assert!(refused.err.contains(cure), "{command:?} {options:?}: {}", refused.err);
            assert_eq!(refused.out, "", "{command:?} {options:?}");
        }
    }
    let code = folder.run(&["valve.gct", "--target", "st"]).out.clone();
    assert!(code.contains("--evolution scan --initial-actions off"), "{code}");
}
