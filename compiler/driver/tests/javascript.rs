//! `--target js` writes two files: both or none.

mod common;

use common::{FAULTY, Folder, VALVE};

#[test]
fn types_stand_beside_the_module() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    for (name, beside) in [("valve.js", "valve.d.ts"), ("valve.mjs", "valve.d.mts"), ("valve.MJS", "valve.d.mts")] {
        folder.run(&["valve.gct", "-o", name]).is_done();
        assert!(folder.read(name).contains("\nexport class Valve {\n"), "{name}");
        assert!(folder.read(beside).contains("\nexport declare class Valve {\n"), "{beside}");
        std::fs::remove_file(folder.path(beside)).expect("a file");
    }
    folder.run(&["valve.gct", "-t", "js", "-o", "valve.txt"]).is_done();
    assert!(folder.read("valve.d.ts").contains("ValveInputs"));
    // Both say which chart they are of, and how they were made.
    for text in [folder.read("valve.txt"), folder.read("valve.d.ts")] {
        assert!(text.contains("// --target js --encoding single-phase"), "{text}");
    }
    // On standard output there is only the module.
    let printed = folder.run(&["valve.gct", "-t", "js"]).is_done().out.clone();
    assert_eq!(printed, folder.read("valve.txt"));
}

#[test]
fn several_charts_have_two_files_each() {
    let other = VALVE.replace("chart Valve", "chart Other");
    let folder = Folder::new(&[("valve.gct", VALVE), ("other.gct", &other)]);
    folder.run(&["valve.gct", "other.gct", "-t", "js", "-o", "out/"]).is_done();
    assert_eq!(Folder::names_in(&folder.path("out")), ["other.d.ts", "other.js", "valve.d.ts", "valve.js"]);
}

#[test]
fn all_is_written_or_nothing() {
    let folder = Folder::new(&[("faulty.gct", FAULTY), ("valve.gct", VALVE), ("valve.d.ts", VALVE)]);
    folder.run(&["faulty.gct", "-o", "faulty.js"]).ends(1, "error[E0201]");
    assert!(!folder.path("faulty.js").exists() && !folder.path("faulty.d.ts").exists());
    // A folder is in the way of the types.
    std::fs::create_dir(folder.path("taken.d.mts")).expect("a folder");
    folder.run(&["valve.gct", "-o", "taken.mjs"]).ends(3, "taken.d.mts");
    assert!(!folder.path("taken.mjs").exists());
    // Nothing takes the place of a chart, or of a map.
    folder.run(&["valve.d.ts", "-o", "valve.js"]).ends(2, "would overwrite");
    folder.run(&["valve.gct", "-o", "a.js", "--map", "a.d.ts"]).ends(2, "one place");
    assert!(!folder.path("a.js").exists() && !folder.path("valve.js").exists());
    assert_eq!(folder.read("valve.d.ts"), VALVE);
}
