//! Each row of the table is tried: its chart has one fault, the row itself knows it, and what it says helps.

use super::table::TABLE;
use grafc_diagnostics::{Diagnostic, FileId, apply};

fn faults(text: &str) -> Vec<Diagnostic> {
    crate::parse(FileId::new(0), text).1.iter().cloned().collect()
}

#[test]
fn each_row_cures_its_chart() {
    let mut wrong = Vec::new();
    for (row, habit) in TABLE.iter().enumerate() {
        let found = faults(habit.wrong);
        let [fault] = found.as_slice() else {
            wrong.push(format!("{row} {:?}: {} faults: {found:#?}", habit.wrong, found.len()));
            continue;
        };
        if fault.help.is_none() {
            wrong.push(format!("{row} {:?}: no help: {}", habit.wrong, fault.message));
        }
        let cured =
            fault.fixes.first().map(|fix| apply(FileId::new(0), habit.wrong, &fix.edits).expect("the edits fit"));
        if cured.as_deref().is_some_and(|cured| cured != habit.right) {
            wrong.push(format!("{row} {:?}: cured to {:?} ({:?})", habit.wrong, cured, fault.help));
        }
        let left = faults(habit.right);
        if !left.is_empty() {
            wrong.push(format!("{row} {:?} is not right: {left:#?}", habit.right));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A row that others always precede would be of no use, and its test would show nothing.
#[test]
fn each_row_is_reached() {
    let mut functions: Vec<usize> = TABLE.iter().map(|habit| habit.cure as usize).collect();
    functions.sort_unstable();
    functions.dedup();
    assert_eq!(functions.len(), TABLE.len(), "a row a function, a function a row");
}
