//! What grafc says about itself: help, version, completions, manual, pages on codes.

mod common;

use common::Folder;
use grafc_diagnostics::Code;

const COMMANDS: [&str; 17] = [
    "check",
    "sim",
    "test",
    "generate-tests",
    "new",
    "fmt",
    "draw",
    "page",
    "serve",
    "graph",
    "automata",
    "verify",
    "stats",
    "import",
    "explain",
    "completions",
    "man",
];

#[test]
fn help_of_every_command_shows_an_example() {
    let folder = Folder::new(&[]);
    let root = folder.run(&["--help"]);
    assert!(root.is_done().out.contains("Example:\n  grafc valve.gct -o valve.st\n"), "{}", root.out);
    assert!(root.out.contains("\n  grafc valve.gct --emit net\n"), "{}", root.out);
    // As wide as a terminal is, the text is broken somewhere.
    let text = root.out.split_whitespace().collect::<Vec<_>>().join(" ");
    let codes =
        "Exit codes: 0 done, 1 a chart has errors, 2 wrong use, 3 a file cannot be read or written, 4 not decided, 101";
    assert!(text.contains(codes), "{}", root.out);
    for command in COMMANDS {
        assert!(root.out.contains(&format!("\n  {command} ")), "{command} is listed");
        for flag in ["--help", "-h"] {
            let run = folder.run(&[command, flag]);
            assert!(run.is_done().out.contains(&format!("Example:\n  grafc {command}")), "{}", run.out);
        }
        assert!(folder.run(&["help", command]).is_done().out.contains("Example:"));
    }
}

#[test]
fn the_version_is_that_of_the_package() {
    let folder = Folder::new(&[]);
    assert_eq!(folder.run(&["--version"]).is_done().out, format!("grafc {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn completions_know_every_command() {
    let folder = Folder::new(&[]);
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = folder.run(&["completions", shell]).is_done().out.clone();
        for command in COMMANDS {
            assert!(script.contains(command), "{shell}: {command}");
        }
        for option in ["watch", "quiet", "dump-after"] {
            assert!(script.contains(option), "{shell}: --{option}");
        }
        assert!(
            script.contains("s-trigger") && script.contains("flatten-enclosures")
                || shell == "elvish"
                || shell == "powershell",
            "{shell}"
        );
    }
    folder.run(&["completions", "cmd"]).ends(2, "possible values: bash");
}

#[test]
fn the_manual_is_roff_and_there_is_one_for_each_command() {
    let folder = Folder::new(&[]);
    let page = folder.run(&["man"]).is_done().out.clone();
    assert!(page.contains(".TH grafc 1"), "{page}");
    assert!(page.contains("\\-\\-target") && page.contains("\\-\\-watch") && page.contains("Exit codes"), "{page}");
    for command in COMMANDS {
        let page = folder.run(&["man", command]).is_done().out.clone();
        assert!(page.contains(&format!(".TH grafc-{command} 1")), "{page}");
    }
    folder.run(&["man", "nothing"]).ends(2, "no command `nothing`");
}

#[test]
fn every_code_has_its_page_by_code_and_by_name() {
    let folder = Folder::new(&[]);
    for code in [Code::E0201, Code::W0401, Code::E0901] {
        assert_eq!(folder.run(&["explain", code.as_str()]).is_done().out, code.page());
        assert_eq!(folder.run(&["explain", code.slug()]).is_done().out, code.page());
        assert_eq!(folder.run(&["explain", &code.as_str().to_lowercase()]).is_done().out, code.page());
    }
}

#[test]
fn an_unknown_code_leads_to_near_ones() {
    let folder = Folder::new(&[]);
    let run = folder.run(&["explain", "E0202x"]);
    assert_eq!(run.ends(2, "no diagnostic has the code `E0202x`").out, "");
    run.ends(2, "perhaps `E0202` (declared-twice)");
    folder.run(&["explain", "unknown-nam"]).ends(2, "`E0201` (unknown-name)");
    folder.run(&["explain", "qqqqqqqqqqqq"]).ends(2, "errors run from E0101 to E0901, warnings from W0401");
    folder.run(&["explain"]).ends(2, "CODE");
}
