//! Files: what is refused, and that they are written whole or not at all.

mod common;

use common::{FAULTY, Folder, Run, VALVE};

#[test]
fn what_cannot_be_read_is_named_with_its_reason() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let run = folder.run(&["missing.gct", "--target", "st"]);
    run.ends(3, "cannot read `missing.gct`: no such file or directory").ends(3, "help: check the path");
    folder.run(&[".", "--target", "st"]).ends(3, "cannot read `.`: is a directory").ends(3, "help:");
    folder.run(&["check", "valve.gct/x"]).ends(3, "valve.gct/x");
    folder.run(&["check", ""]).ends(3, "cannot read ``");
}

#[test]
fn what_cannot_be_written_is_named_with_its_reason() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    std::fs::create_dir(folder.path("directory")).unwrap();
    folder.run(&["valve.gct", "--target", "st", "-o", "no/out.st"]).ends(3, "cannot write `no/out.st`: no such file");
    std::fs::create_dir(folder.path("directory/valve.st")).unwrap();
    let taken = folder.run(&["valve.gct", "--target", "st", "-o", "directory/valve.st/valve.st/"]);
    taken.is_done();
    folder
        .run(&["valve.gct", "-t", "st", "-o", "directory"])
        .ends(3, "cannot write `directory/valve.st`: is a directory");
    folder.run(&["valve.gct", "-t", "st", "-o", "valve.gct/"]).ends(3, "cannot write `valve.gct/`: file exists");
    assert_eq!(folder.names(), ["directory", "valve.gct"]);
}

#[test]
fn a_file_is_replaced_whole_and_nothing_is_left_beside_it() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("out.st", &"old ".repeat(100_000))]);
    folder.run(&["valve.gct", "--target", "st", "-o", "out.st"]).is_done();
    assert!(!folder.read("out.st").contains("old old"));
    assert_eq!(folder.names(), ["out.st", "valve.gct"]);
}

#[cfg(unix)]
#[test]
fn a_link_to_what_is_not_there_yet_is_written_through() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    std::fs::create_dir(folder.path("there")).unwrap();
    std::os::unix::fs::symlink("there/second", folder.path("first.st")).unwrap();
    std::os::unix::fs::symlink("valve.st", folder.path("there/second")).unwrap();
    folder.run(&["valve.gct", "-o", "first.st"]).is_done();
    assert!(folder.read("there/valve.st").contains("FUNCTION_BLOCK Valve"));
    for link in ["first.st", "there/second"] {
        assert!(std::fs::symlink_metadata(folder.path(link)).unwrap().is_symlink(), "{link}");
    }
    std::os::unix::fs::symlink("circle.st", folder.path("circle.st")).unwrap();
    folder.run(&["valve.gct", "-o", "circle.st"]).ends(3, "cannot write `circle.st`");
}

#[cfg(unix)]
#[test]
fn the_limit_on_the_size_of_files_leaves_nothing_behind() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let command = assert_cmd::cargo::cargo_bin!("grafc");
    let script = format!("ulimit -f 1; exec '{}' valve.gct -o valve.st", command.display());
    let output = std::process::Command::new("sh").args(["-c", &script]).current_dir(folder.path(".")).output().unwrap();
    Run::of(output).ends(3, "cannot write `valve.st`: file too large").ends(3, "help: raise the limit");
    assert_eq!(folder.names(), ["valve.gct"]);
}

#[cfg(target_os = "linux")]
#[test]
fn help_that_cannot_be_written_is_a_failure() {
    let folder = Folder::new(&[]);
    let command = assert_cmd::cargo::cargo_bin!("grafc");
    for arguments in [&["--help"][..], &["--version"], &["sim", "--help"]] {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let run =
            std::process::Command::new(command).args(arguments).current_dir(folder.path(".")).stdout(full).output();
        Run::of(run.unwrap()).ends(3, "cannot write `<stdout>`: no space left on device");
    }
}

#[test]
fn paths_may_hold_blanks_and_any_letters() {
    let folder = Folder::new(&[("мой клапан №1.gct", VALVE), ("漢字 'x\".gct", FAULTY)]);
    folder.run(&["мой клапан №1.gct", "--target", "st", "-o", "выход $(x) 1.st"]).is_done();
    assert!(folder.read("выход $(x) 1.st").contains("FUNCTION_BLOCK Valve"));
    folder.run(&["check", "漢字 'x\".gct"]).ends(1, "漢字 'x\".gct:6:25");
    let log = folder.run(&["check", "漢字 'x\".gct", "--format", "sarif"]).out;
    assert!(log.contains("\"%E6%BC%A2%E5%AD%97%20%27x%22.gct\""), "{log}");
}

#[test]
fn a_chart_with_an_odd_name_still_makes_code() {
    let nameless = VALVE.replace("chart Valve \"one valve\"", "");
    let folder = Folder::new(&[("1 *) ; клапан.gct", &nameless)]);
    let run = folder.run(&["1 *) ; клапан.gct", "--target", "st"]);
    let heading = run.is_done().out.lines().find(|line| line.starts_with("FUNCTION_BLOCK ")).unwrap();
    let name = heading.trim_start_matches("FUNCTION_BLOCK ");
    assert!(name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_'), "{name}");
}

#[test]
fn code_and_map_are_written_both_or_neither() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.st", "old")]);
    folder.run(&["valve.gct", "-o", "valve.st", "--map", "no/map.json"]).ends(3, "cannot write `no/map.json`");
    assert_eq!(folder.read("valve.st"), "old");
    assert_eq!(folder.names(), ["valve.gct", "valve.st"]);
}

#[cfg(unix)]
mod unix {
    use super::*;
    use common::Run;
    use std::os::unix::fs::{PermissionsExt, symlink};

    fn mode(folder: &Folder, name: &str) -> u32 {
        std::fs::metadata(folder.path(name)).unwrap().permissions().mode() & 0o7777
    }

    #[test]
    fn permissions_are_kept_and_new_files_get_the_usual_ones() {
        let folder = Folder::new(&[("valve.gct", VALVE), ("old.st", ""), ("ordinary", "")]);
        std::fs::set_permissions(folder.path("old.st"), std::fs::Permissions::from_mode(0o666)).unwrap();
        folder.run(&["valve.gct", "--target", "st", "-o", "old.st"]).is_done();
        folder.run(&["valve.gct", "--target", "st", "-o", "new.st"]).is_done();
        assert_eq!(mode(&folder, "old.st"), 0o666);
        assert_eq!(mode(&folder, "new.st"), mode(&folder, "ordinary"));
    }

    #[test]
    fn a_write_protected_file_stays() {
        let folder = Folder::new(&[("valve.gct", VALVE), ("out.st", "precious")]);
        std::fs::set_permissions(folder.path("out.st"), std::fs::Permissions::from_mode(0o444)).unwrap();
        let run = folder.run(&["valve.gct", "--target", "st", "-o", "out.st"]);
        run.ends(3, "cannot write `out.st`: permission denied");
        assert_eq!(folder.read("out.st"), "precious");
        assert_eq!(folder.names(), ["out.st", "valve.gct"]);
    }

    #[test]
    fn an_unreadable_chart_is_refused() {
        let folder = Folder::new(&[("valve.gct", VALVE)]);
        std::fs::set_permissions(folder.path("valve.gct"), std::fs::Permissions::from_mode(0o000)).unwrap();
        if std::fs::read(folder.path("valve.gct")).is_ok() {
            return; // The superuser may read everything.
        }
        folder.run(&["check", "valve.gct"]).ends(3, "cannot read `valve.gct`: permission denied");
    }

    #[test]
    fn a_link_stays_a_link() {
        let folder = Folder::new(&[("valve.gct", VALVE), ("real.st", "old")]);
        symlink("real.st", folder.path("link.st")).unwrap();
        folder.run(&["valve.gct", "--target", "st", "-o", "link.st"]).is_done();
        assert!(std::fs::symlink_metadata(folder.path("link.st")).unwrap().is_symlink());
        assert!(folder.read("real.st").contains("FUNCTION_BLOCK"));
    }

    #[test]
    fn a_device_is_written_to_and_not_replaced() {
        let folder = Folder::new(&[("valve.gct", VALVE)]);
        folder.run(&["valve.gct", "--target", "st", "-o", "/dev/null"]).is_done();
        assert!(!std::fs::metadata("/dev/null").unwrap().is_file());
        let run = folder.run(&["valve.gct", "--target", "st", "-o", "/dev/stdout"]);
        assert!(run.is_done().out.contains("END_FUNCTION_BLOCK"));
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_full_disk_is_said() {
        let folder = Folder::new(&[("valve.gct", VALVE)]);
        folder.run(&["valve.gct", "--target", "st", "-o", "/dev/full"]).ends(3, "cannot write `/dev/full`: no space");
        // Code and map, or nothing.
        folder.run(&["valve.gct", "-o", "a.st", "--map", "/dev/full"]).ends(3, "cannot write `/dev/full`: no space");
        assert!(!folder.path("a.st").exists());
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let output = std::process::Command::new(assert_cmd::cargo::cargo_bin!("grafc"))
            .args(["valve.gct", "--target", "st"])
            .current_dir(folder.path("."))
            .stdout(full)
            .output();
        Run::of(output.unwrap()).ends(3, "cannot write `<stdout>`: no space");
    }

    #[test]
    fn a_reader_that_has_had_enough_is_no_fault() {
        let folder = Folder::new(&[("valve.gct", VALVE), ("faulty.gct", FAULTY)]);
        for (command, code) in [
            ("man", 0),
            ("completions zsh", 0),
            ("--help", 0),
            ("explain E0201", 0),
            ("valve.gct --target st", 0),
            ("check faulty.gct --format json", 1),
        ] {
            // By the time that grafc writes, the other end of the pipe is closed.
            let script = format!("(sleep 0.2; \"$0\" {command}; echo \"ended with $?\" >&2) | true");
            let output = std::process::Command::new("sh")
                .args(["-c", &script])
                .arg(assert_cmd::cargo::cargo_bin!("grafc"))
                .current_dir(folder.path("."))
                .output();
            assert_eq!(Run::of(output.unwrap()).err, format!("ended with {code}\n"), "{command}");
        }
    }
}
