//! The charts that the book shows running. The simulator does what is shown, says `docs.rs`; here the scan programs do.

use grafc_model::reaction::{Evolution, Profile};
use grafc_testsuite::binary::root;
use grafc_testsuite::charts::{Case, check, spell, stimuli};
use grafc_testsuite::markdown::{FencedBlock, blocks, pages};
use grafc_testsuite::runs;
use std::path::PathBuf;

/// The pages of the book.
fn book() -> Vec<(PathBuf, String)> {
    let read = |path: PathBuf| {
        let page = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        (path, page)
    };
    pages(&root().join("docs")).into_iter().map(read).collect()
}

/// The simulations of a page of which it shows all rows, and nothing else.
fn cases(page: &str) -> Vec<Case> {
    let blocks = blocks(page);
    let consoles = blocks.iter().filter(|block| block.language == "console" && block.value("exit").is_none());
    consoles.flat_map(FencedBlock::commands).filter_map(|(command, shown)| case(&blocks, &command, shown)).collect()
}

fn case(blocks: &[FencedBlock], command: &str, expected: String) -> Option<Case> {
    let mut words = command.strip_prefix("grafc sim ")?.split_whitespace();
    let name = words.next()?.to_string();
    let text = |file: &str| blocks.iter().find(|block| block.value("file") == Some(file)).map(|b| b.text.clone());
    let mut trace = None;
    let mut profile = Profile::default();
    while let Some(option) = words.next() {
        match (option, words.next()?) {
            ("--trace", file) => trace = text(file),
            ("--evolution", "scan") => profile.evolution = Evolution::Scan,
            ("--initial-actions", "off") => profile.initial_actions = false,
            // With any other option the rows are not those of the trace.
            _ => return None,
        }
    }
    let (text, trace) = (text(&name)?, trace?);
    (!expected.contains('…')).then_some(Case { name, text, trace, expected, profile, overlapping: false })
}

fn fault(case: &Case) -> Result<(), String> {
    let chart = check(&case.name, &case.text)?;
    let stimuli = stimuli(&case.name, &case.trace, &chart)?;
    for (way, options) in case.ways() {
        let actual = spell(&chart, &stimuli, &runs::evaluate(&chart, &options, &stimuli)?);
        if actual.trim() != case.expected.trim() {
            return Err(format!("{way}: shown\n{}\nand done\n{actual}", case.expected));
        }
    }
    Ok(())
}

#[test]
fn the_scan_programs_do_what_the_book_shows() {
    let mut count = 0;
    let mut faults = Vec::new();
    for (path, page) in book() {
        for case in cases(&page) {
            count += 1;
            faults.extend(fault(&case).err().map(|fault| format!("{}: {} {fault}", path.display(), case.name)));
        }
    }
    assert!(count >= 16, "only {count} simulations were found");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn each_recipe_runs() {
    let folder = root().join("docs/cookbook");
    for (path, page) in book().iter().filter(|(path, _)| path.starts_with(&folder) && !path.ends_with("index.md")) {
        let charts = blocks(page).iter().filter(|block| block.language == "gct").count();
        assert!(charts > 0 && cases(page).len() >= charts, "{}: a chart is not run", path.display());
    }
}

/// What one may argue about is shown, not only said.
#[test]
fn each_debatable_decision_runs() {
    let page = std::fs::read_to_string(root().join("docs/semantics.md")).expect("the page");
    let mut debatable = page.split("*Debatable.*");
    debatable.next();
    let mut count = 0;
    for decision in debatable {
        count += 1;
        let decision = decision.split("\n**").next().unwrap_or_default();
        assert!(!cases(decision).is_empty(), "{decision}");
    }
    assert!(count >= 4, "only {count} debatable decisions were found");
}
