//! What `-o` says: the target by its ending, and a folder for several charts.

mod common;

use common::{DUBIOUS, FAULTY, Folder, VALVE};
use grafc_backends::{About, Target};

#[test]
fn short_options_are_the_long_ones() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let long = folder.run(&["valve.gct", "--target", "st"]).is_done().out.clone();
    assert_eq!(folder.run(&["valve.gct", "-t", "st"]).is_done().out, long);
    assert_eq!(folder.run(&["-tst", "valve.gct"]).is_done().out, long);
}

#[test]
fn the_ending_of_the_output_says_what_to_make() {
    // One evolution a call, which every target can do.
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let run = |arguments: &[&str]| folder.run(&[&["valve.gct", "--evolution", "scan"], arguments].concat());
    for about in Target::ALL {
        let others = Target::ALL.iter().filter(|other| other.extension == about.extension).count();
        let printed = run(&["-t", about.name]).is_done().out.clone();
        for ending in [about.extension.to_string(), about.extension.to_uppercase()] {
            let file = format!("valve.{ending}");
            let unsaid = run(&["-o", &file]);
            if others == 1 {
                unsaid.is_done();
                assert_eq!(written(&folder, &file, about), told(&printed, about));
            } else {
                unsaid.ends(2, &format!("`--target {}`", about.name)).ends(2, "say which of them is meant");
            }
            // What is said counts more.
            run(&["-t", about.name, "-o", &file]).is_done();
            assert_eq!(written(&folder, &file, about), told(&printed, about));
        }
    }
}

/// A file of a target; of C, what stands behind the line that includes the header.
fn written(folder: &Folder, file: &str, about: &About) -> String {
    let text = folder.read(file);
    match about.name {
        "c" => text.split_once("#include \"valve.h\"\n").expect("the header").1.to_owned(),
        _ => text,
    }
}

/// The same of what is printed, which holds the header itself.
fn told(printed: &str, about: &About) -> String {
    match about.name {
        "c" => printed.split_once("#endif /* GRAFC_VALVE_H */\n").expect("the header").1.to_owned(),
        _ => printed.to_owned(),
    }
}

#[test]
fn an_ending_that_says_nothing_is_refused() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let run = folder.run(&["valve.gct", "-o", "valve.txt"]);
    run.ends(2, "no target is known by the ending `.txt`")
        .ends(2, ".st, .il, .sfc, .awl, .scl, .TcPOU, .rs, .js, .mjs, .c; not .xml alone");
    folder.run(&["valve.gct", "-o", "valve"]).ends(2, "nothing says what to make of `valve.gct`");
    folder.run(&["valve.gct", "-o", "-"]).ends(2, "nothing says what to make");
    folder.run(&["valve.gct", "-o", "out.st/"]).ends(2, "nothing says what to make");
    let both = "the code and the file beside it would both be written to `valve.h`";
    folder.run(&["valve.gct", "-t", "c", "-o", "valve.h"]).ends(2, both);
    folder.run(&["valve.gct", "-o", "valve.rs", "--body", "il"]).ends(2, "`--body` is an option of `--target plcopen`");
    folder.run(&["valve.gct", "-o", "valve.TcPOU", "--map", "m.json"]).ends(2, "`--map` is an option of");
    assert_eq!(folder.names(), ["valve.gct"]);
}

#[test]
fn a_folder_takes_a_file_for_each_chart() {
    let nameless = VALVE.replace("chart Valve \"one valve\"", "");
    let folder = Folder::new(&[("valve.gct", VALVE), ("pump.gct", &nameless)]);
    folder.run(&["valve.gct", "pump.gct", "-t", "tcpou", "-o", "new/out/"]).is_done();
    assert_eq!(folder.read("new/out/valve.TcPOU"), folder.run(&["valve.gct", "-t", "tcpou"]).out);
    assert!(folder.read("new/out/pump.TcPOU").contains("<POU Name=\"pump\""));

    // A folder that is there needs no sign; and one chart may go to it, too.
    std::fs::create_dir(folder.path("there")).unwrap();
    folder.run(&["pump.gct", "--emit", "net", "-o", "there"]).is_done();
    assert_eq!(folder.read("there/pump.net"), folder.run(&["pump.gct", "--emit", "net"]).out);
    folder.run(&["pump.gct", "--dump-after", "rank-orders", "-o", "there/"]).is_done();
    folder.run(&["pump.gct", "--emit", "ast", "-o", "there/"]).is_done();
    assert!(folder.path("there/pump.ast").exists());

    folder.run(&["valve.gct", "pump.gct", "-t", "st", "-o", "there", "--map", "maps/"]).is_done();
    assert!(folder.read("maps/pump.map.json").contains("\"output\": \"pump.st\""));
    assert!(folder.read("maps/valve.map.json").contains("\"chart\": \"valve.gct\""));
}

/// Each chart is all or nothing, and all faults of all charts are told.
#[test]
fn a_faulty_chart_does_not_keep_the_others_back() {
    let folder = Folder::new(&[("a.gct", FAULTY), ("valve.gct", VALVE), ("b.gct", DUBIOUS), ("z.gct", FAULTY)]);
    std::fs::create_dir(folder.path("out")).unwrap();
    std::fs::write(folder.path("out/a.st"), "as it was").unwrap();
    let run = folder.run(&["a.gct", "no.gct", "valve.gct", "b.gct", "z.gct", "-t", "st", "-o", "out", "--map", "out"]);
    run.ends(3, "cannot read `no.gct`").ends(3, "a.gct:6:25").ends(3, "z.gct:6:25").ends(3, "b.gct:6:25");
    assert!(run.err.ends_with("\n2 errors, 1 warning\n"), "{}", run.err);
    assert_eq!(folder.read("out/a.st"), "as it was");
    let names: Vec<String> = Folder::names_in(&folder.path("out"));
    assert_eq!(names, ["a.st", "b.map.json", "b.st", "valve.map.json", "valve.st"]);
    folder.run(&["a.gct", "valve.gct", "-t", "st", "-o", "out"]).ends(1, "1 error");

    let nothing = folder.run(&["a.gct", "z.gct", "-t", "st", "-o", "fresh/"]);
    nothing.ends(1, "2 errors");
    assert!(!folder.path("fresh").exists());
}

#[test]
fn several_charts_need_a_folder() {
    let folder = Folder::new(&[("a.gct", VALVE), ("b.gct", VALVE), ("c.gct", VALVE)]);
    let run = folder.run(&["a.gct", "b.gct", "-t", "st"]);
    run.ends(2, "2 charts, `a.gct`, `b.gct`, and no folder for what is made of them").ends(2, "`-o DIR/`");
    folder
        .run(&["a.gct", "b.gct", "c.gct", "-o", "a.st"])
        .ends(2, "3 charts, `a.gct`, `b.gct`…, and one place, `a.st`");
    folder
        .run(&["a.gct", "b.gct", "-t", "st", "-o", "out/", "--map", "m"])
        .ends(2, "one map, `m`")
        .ends(2, "`--map DIR/`");
    folder.run(&["-", "a.gct", "-t", "st", "-o", "out/"]).ends(2, "standard input has no name");
    folder.run(&["-", "-", "-t", "st", "-o", "out/"]).ends(2, "named twice");
    assert_eq!(folder.names(), ["a.gct", "b.gct", "c.gct"]);
}

#[test]
fn no_two_charts_go_to_one_file() {
    let folder = Folder::new(&[("a.gct", VALVE), ("A.gct", VALVE), ("one.gct", VALVE)]);
    std::fs::create_dir(folder.path("sub")).unwrap();
    std::fs::copy(folder.path("a.gct"), folder.path("sub/a.gct")).unwrap();
    for two in ["sub/a.gct", "a.gct", "A.gct"] {
        let run = folder.run(&["a.gct", two, "-t", "st", "-o", "out/"]);
        run.ends(2, &format!("`a.gct` and `{two}` would both be written to `out/")).ends(2, "different folders");
    }
    // Neither over a chart: not its own, nor that of another.
    std::fs::write(folder.path("a.st"), VALVE).unwrap();
    folder.run(&["one.gct", "a.st", "-t", "st", "-o", "./"]).ends(2, "the output would overwrite `./a.st`");
    folder.run(&["a.gct", "one.gct", "-t", "st", "-o", "./", "--map", "./"]).is_done();
    assert!(!folder.path("out").exists());
}

#[test]
fn quiet_runs_tell_errors_alone() {
    let folder =
        Folder::new(&[("faulty.gct", FAULTY), ("dubious.gct", DUBIOUS), ("valve.gct", VALVE), ("t.csv", TRACE)]);
    for arguments in
        [&["dubious.gct", "-t", "st", "-o", "d.st"][..], &["check", "dubious.gct"], &["stats", "valve.gct"]]
    {
        folder.run(&[arguments, &["-q"]].concat()).is_done();
    }
    for form in ["human", "json", "sarif"] {
        let run = folder.run(&["check", "faulty.gct", "dubious.gct", "--quiet", "--format", form]);
        assert_eq!(run.code, 1);
        let told = run.out + &run.err;
        assert!(told.contains("E0201") && !told.contains("W0403") && !told.contains("1 error\n"), "{told}");
    }
    let simulated = folder.run(&["sim", "valve.gct", "--trace", "t.csv"]).is_done().out.clone();
    assert_eq!(folder.run(&["sim", "valve.gct", "--trace", "t.csv", "-q"]).is_done().out, simulated);
    std::fs::write(folder.path("r.csv"), &simulated).unwrap();
    let compare = &["sim", "valve.gct", "--trace", "t.csv", "--against", "r.csv"];
    assert_eq!(folder.run(compare).is_done().out, "2 rows agree\n");
    assert_eq!(folder.run(&[compare, &["-q"][..]].concat()).is_done().out, "");
}

const TRACE: &str = "t_ms,a\n0,0\n10,1\n";
