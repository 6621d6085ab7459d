//! `grafc new`: what it makes is a chart that works. What its README shows is tried by the tests of the book.

mod common;

use common::Folder;

#[test]
fn a_new_chart_works() {
    let folder = Folder::new(&[]);
    let run = folder.run(&["new", "mixer"]);
    assert!(
        run.is_done().out.starts_with("made mixer/mixer.gct, mixer/mixer.trace.csv, mixer/README.md\n"),
        "{}",
        run.out
    );
    assert!(run.out.contains("\n  cd mixer\n  grafc sim mixer.gct --trace mixer.trace.csv\n"), "{}", run.out);
    assert_eq!(Folder::names_in(&folder.path("mixer")), ["README.md", "mixer.gct", "mixer.trace.csv"]);
    assert!(folder.read("mixer/mixer.gct").starts_with("chart mixer \"press start"));

    assert_eq!(folder.run(&["check", "mixer/mixer.gct"]).is_done().out, "");
    assert_eq!(folder.run(&["fmt", "--check", "mixer/mixer.gct"]).is_done().out, "");
    let simulated = folder.run(&["sim", "mixer/mixer.gct", "--trace", "mixer/mixer.trace.csv"]).is_done().out.clone();
    assert!(simulated.contains("\n1000,0,1,2,\n") && simulated.contains("\n6000,1,0,1,\n"), "{simulated}");
    for target in ["st", "il", "awl", "plcopen", "scl", "tcpou", "iec61131-10", "rust", "js", "c"] {
        folder.run(&["mixer/mixer.gct", "-t", target]).is_done();
    }
}

#[test]
fn any_plain_name_will_do() {
    let folder = Folder::new(&[]);
    for (name, chart) in [("a/b/pump-2", "pump_2"), ("2nd", "`2nd`"), ("step", "`step`"), ("Мешалка", "Мешалка")]
    {
        assert_eq!(folder.run(&["new", "-q", name]).is_done().out, "");
        let last = name.rsplit('/').next().unwrap();
        let file = format!("{name}/{last}.gct");
        assert!(folder.read(&file).starts_with(&format!("chart {chart} ")), "{}", folder.read(&file));
        assert_eq!(folder.run(&["check", &file]).is_done().out, "");
        assert_eq!(folder.run(&["fmt", "--check", &file]).is_done().out, "");
    }
}

#[test]
fn nothing_is_overwritten() {
    let folder = Folder::new(&[("mixer", "a file"), ("pump.gct", "a chart")]);
    std::fs::create_dir(folder.path("tank")).unwrap();
    for taken in ["mixer", "tank", "tank/"] {
        let run = folder.run(&["new", taken]);
        run.ends(3, &format!("cannot write `{taken}`: file exists")).ends(3, "choose another name");
        assert_eq!(run.out, "");
    }
    assert_eq!(folder.read("mixer"), "a file");
    assert!(Folder::names_in(&folder.path("tank")).is_empty());
    folder.run(&["new", "pump.gct"]).ends(2, "`pump.gct` cannot be the name of a chart");
    folder.run(&["new", "my pump"]).ends(2, "letters, digits, `_` and `-`");
    folder.run(&["new", "mixer/pump"]).ends(3, "cannot write `mixer`");
    folder.run(&["new"]).ends(2, "`grafc new` makes a folder, and needs its name").ends(2, "such as `grafc new mixer`");
    assert_eq!(folder.names(), ["mixer", "pump.gct", "tank"]);
}
