//! The book against the compiler: its charts are correct, its commands print what it shows, its links lead somewhere.

use grafc::Target;
use grafc_diagnostics::{Code, FileId};
use grafc_testsuite::binary::{grafc, root};
use grafc_testsuite::excerpts;
use grafc_testsuite::markdown::{FencedBlock, blocks, matches, pages, write_files};
use std::path::{Path, PathBuf};

/// The pages that readers start from, and all in `docs`; the pages of the codes have a test of their own.
fn book() -> Vec<(PathBuf, String)> {
    let mut paths: Vec<PathBuf> = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(|p| root().join(p)).into();
    paths.extend(pages(&root().join("docs")));
    paths.into_iter().map(|p| (p.clone(), std::fs::read_to_string(&p).expect("a page"))).collect()
}

fn is_error_page(path: &Path) -> bool {
    path.parent().is_some_and(|p| p.ends_with("docs/errors"))
}

#[test]
fn charts_are_correct() {
    let mut charts = 0;
    let mut faults = Vec::new();
    for (path, page) in book().iter().filter(|(path, _)| !is_error_page(path)) {
        for block in blocks(page).iter().filter(|b| b.language == "gct") {
            charts += 1;
            let (_, diagnostics) = grafc::check(FileId::new(0), &block.text, "example");
            if diagnostics.has_errors() != block.has("wrong") || (!diagnostics.is_empty() && !block.has("wrong")) {
                let diagnostics: Vec<_> = diagnostics.iter().map(|d| format!("{:?} {}", d.code, d.message)).collect();
                faults.push(format!("{}:{}: {diagnostics:?}", path.display(), block.line));
            }
        }
    }
    assert!(charts >= 5, "only {charts} charts were found");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Where charts are there to be copied, `grafc fmt` finds nothing to change.
#[test]
fn charts_to_copy_are_in_the_canonical_format() {
    let mut charts = 0;
    for (path, page) in book() {
        let copied =
            ["README.md", "introduction.md", "getting-started.md", "generated-code.md", "rust.md", "simulation.md"];
        if !copied.iter().any(|name| path.ends_with(name)) && !path.starts_with(root().join("docs/cookbook")) {
            continue;
        }
        for block in blocks(&page).iter().filter(|block| block.language == "gct" && !block.has("wrong")) {
            charts += 1;
            let (formatted, _) = grafc::format(FileId::new(0), &block.text);
            assert_eq!(formatted.as_deref(), Some(block.text.as_str()), "{}:{}", path.display(), block.line);
        }
    }
    assert!(charts >= 16, "only {charts} charts were found");
}

/// Runs the commands of a page in a folder, and counts them: each prints what the page shows.
fn run_commands(path: &Path, blocks: &[FencedBlock], folder: &Path) -> usize {
    let mut commands = 0;
    for block in blocks.iter().filter(|b| b.language == "console") {
        let wanted: i32 = block.value("exit").map_or(0, |code| code.parse().expect("a number"));
        for (command, shown) in block.commands() {
            let place = format!("{}:{}: `{command}`", path.display(), block.line);
            let Some(arguments) = command.strip_prefix("grafc ") else { continue };
            let (code, printed) = run(folder, arguments);
            assert_eq!(code, Some(wanted), "{place} printed\n{printed}");
            assert!(matches(&shown, &printed), "{place} printed\n{printed}\nbut the book shows\n{shown}");
            commands += 1;
        }
    }
    commands
}

#[test]
fn commands_print_what_the_book_shows() {
    let mut commands = 0;
    for (path, page) in book() {
        let blocks = blocks(&page);
        if !blocks.iter().any(|b| b.language == "console") {
            continue;
        }
        let folder = tempfile::tempdir().expect("a temporary folder");
        write_files(&blocks, folder.path());
        commands += run_commands(&path, &blocks, folder.path());
        let read = |name: &str| {
            let text = std::fs::read_to_string(folder.path().join(name));
            text.unwrap_or_else(|e| panic!("{}: no command wrote {name}: {e}", path.display()))
        };
        if std::env::var_os("UPDATE_EXPECT").is_some() {
            let renewed = excerpts::renew(&page, &blocks, read).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            std::fs::write(&path, renewed).expect("the page");
            continue;
        }
        let faults = excerpts::compare(&blocks, read);
        assert!(faults.is_empty(), "{}: {}\nUPDATE_EXPECT=1 renews excerpts", path.display(), faults.join("\n"));
    }
    assert!(commands >= 5, "only {commands} commands were found");
}

#[test]
fn what_new_makes_does_what_its_readme_shows() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for name in ["mixer", "plant/pump-2"] {
        assert_eq!(run(folder.path(), &format!("new {name}")).0, Some(0));
        let made = folder.path().join(name);
        let readme = made.join("README.md");
        let page = std::fs::read_to_string(&readme).expect("a README");
        assert_eq!(run_commands(&readme, &blocks(&page), &made), 4, "{page}");
        assert!(!page.contains(['{', '}']), "{page}");
    }
}

#[test]
fn the_first_command_of_the_readme_compiles_a_chart() {
    let readme = std::fs::read_to_string(root().join("README.md")).expect("the page");
    let command = readme.lines().find_map(|line| line.strip_prefix("cargo run --release -- ")).expect("the command");
    let (code, printed) = run(&root(), command);
    assert_eq!(code, Some(0), "{printed}");
    assert!(printed.contains("\nFUNCTION_BLOCK "), "{printed}");
    assert!(readme.contains("\ncargo test --workspace\n"));
}

#[test]
fn the_table_of_endings_is_that_of_the_targets() {
    let page = std::fs::read_to_string(root().join("docs/commands.md")).expect("the page");
    for about in Target::ALL {
        let of_ending = Target::ALL.iter().filter(|other| other.extension == about.extension).count();
        let found = page.lines().any(|line| {
            line.starts_with(&format!("| `.{}` |", about.extension))
                && if of_ending == 1 {
                    line.ends_with(&format!("| `--target {}` |", about.name))
                } else {
                    line.contains(&format!("`{}`", about.name)) && line.contains("`--target` has to say which")
                }
        });
        assert!(found, "docs/commands.md has no row for `.{}`, {}", about.extension, about.name);
    }
}

fn run(folder: &Path, arguments: &str) -> (Option<i32>, String) {
    let output = grafc()
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .output()
        .expect("grafc runs");
    let printed = [output.stdout, output.stderr].concat();
    (output.status.code(), String::from_utf8_lossy(&printed).into_owned())
}

#[test]
fn links_lead_somewhere() {
    let mut faults = Vec::new();
    for (path, page) in book() {
        let folder = path.parent().expect("a page lies in a folder");
        for target in links(&page) {
            let (file, anchor) = target.split_once('#').unwrap_or((&target, ""));
            if file.contains("://") {
                continue;
            }
            let file = if file.is_empty() { path.clone() } else { folder.join(file) };
            let found = match std::fs::read_to_string(&file) {
                Err(_) => file.is_dir(),
                Ok(text) => anchor.is_empty() || anchors(&text).any(|a| a == anchor),
            };
            if !found {
                faults.push(format!("{}: {target}", path.display()));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The targets of `[text](target)`, outside of blocks and of code in a line.
fn links(page: &str) -> Vec<String> {
    let mut targets = Vec::new();
    let mut fenced = false;
    for line in page.lines() {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
        } else if !fenced {
            // Every second piece between backquotes is code.
            let prose: Vec<&str> = line.split('`').step_by(2).collect();
            for piece in prose.join("`").split("](").skip(1) {
                targets.extend(piece.split_once(')').map(|(target, _)| target.to_string()));
            }
        }
    }
    targets
}

/// The anchors of the headings of a page.
fn anchors(page: &str) -> impl Iterator<Item = String> + '_ {
    page.lines().filter(|line| line.starts_with('#')).map(|line| {
        let heading = line.trim_start_matches('#').trim().to_lowercase();
        heading
            .chars()
            .filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'))
            .collect::<String>()
            .replace(' ', "-")
    })
}

#[test]
fn the_summary_lists_every_page_once() {
    let docs = root().join("docs");
    let summary = std::fs::read_to_string(docs.join("SUMMARY.md")).expect("the summary");
    let mut listed: Vec<PathBuf> = links(&summary).iter().map(|l| docs.join(l)).collect();
    listed.sort();
    let decisions = docs.join("decisions");
    let present: Vec<PathBuf> = pages(&docs)
        .into_iter()
        .filter(|p| !p.ends_with("SUMMARY.md") && (p.parent() != Some(&decisions) || p.ends_with("index.md")))
        .collect();
    assert_eq!(listed, present);
}

#[test]
fn the_index_of_decisions_lists_every_decision() {
    let folder = root().join("docs/decisions");
    let index = std::fs::read_to_string(folder.join("index.md")).expect("the index");
    let mut listed: Vec<PathBuf> = links(&index).iter().map(|l| folder.join(l)).collect();
    listed.push(folder.join("index.md"));
    assert_eq!(listed, pages(&folder));
}

#[test]
fn the_index_of_diagnostics_lists_every_code_in_order() {
    let index = std::fs::read_to_string(root().join("docs/diagnostics.md")).expect("the index");
    let listed: Vec<&str> = index.lines().filter(|l| l.starts_with("| [")).collect();
    assert_eq!(listed.len(), Code::ALL.len());
    for (line, code) in listed.iter().zip(Code::ALL) {
        let start = format!("| [{0}](errors/{0}.md) {1} | ", code.as_str(), code.slug());
        assert!(line.starts_with(&start), "{line}");
    }
}

#[test]
fn the_command_line_reference_names_every_command_and_option() {
    let page = std::fs::read_to_string(root().join("docs/commands.md")).expect("the page");
    let (_, help) = run(&root(), "--help");
    let commands: Vec<&str> = help
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.split_whitespace().next())
        .filter(|name| *name != "help")
        .collect();
    assert!(commands.contains(&"check"), "{help}");
    let mut faults = Vec::new();
    for command in std::iter::once("").chain(commands) {
        if !command.is_empty() && !page.contains(&format!("## `grafc {command}")) {
            faults.push(format!("grafc {command}"));
        }
        let (code, help) = run(&root(), &format!("{command} --help"));
        assert_eq!(code, Some(0), "{help}");
        let options = help.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-'));
        for option in options.filter(|word| word.starts_with("--") && word.len() > 2 && *word != "--help") {
            if *option != *"--version" && !page.contains(option) {
                faults.push(format!("grafc {command} {option}"));
            }
        }
    }
    assert!(faults.is_empty(), "not in docs/commands.md: {faults:?}");
}
