//! The traces of claims that fail, as files.

use grafc::files::{Refusal, make_folder, put_all, stage};
use grafc_verify::{Answer, Verified};
use std::path::{Path, PathBuf};

/// Of the name of a claim so many characters stand in that of its file.
const LONGEST: usize = 60;

/// The paths and texts. A number makes each name its own, and no character of it means anything to a path.
pub fn files(folder: &Path, verified: &Verified) -> Vec<(PathBuf, String)> {
    let failing = verified.verdicts.iter().filter_map(|verdict| match &verdict.answer {
        Answer::Fails(Some(trace)) => Some((&verdict.claim.name, trace)),
        Answer::Fails(None) | Answer::Holds | Answer::Open(_) => None,
    });
    let named = failing.enumerate().map(|(place, (name, trace))| {
        (folder.join(format!("{:02}-{}.trace.csv", place + 1, plain(name))), trace.csv())
    });
    named.collect()
}

/// Letters and digits of ASCII, with a dash for whatever stands between them.
fn plain(name: &str) -> String {
    let mut out = String::new();
    for c in name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' }) {
        if c != '-' || !(out.is_empty() || out.ends_with('-')) {
            out.push(c);
        }
    }
    out.truncate(LONGEST);
    out.trim_end_matches('-').to_string()
}

/// Writes all of them, or none.
pub fn write(folder: &Path, files: Vec<(PathBuf, String)>) -> Result<(), Refusal> {
    make_folder(folder)?;
    let staged: Result<Vec<_>, Refusal> = files.iter().map(|(path, text)| stage(path, text)).collect();
    put_all(staged?)
}

#[cfg(test)]
mod tests {
    use super::plain;

    #[test]
    fn a_name_leads_out_of_no_folder() {
        assert_eq!(plain("selection ../../x"), "selection-x");
        assert_eq!(plain("dead-step 5"), "dead-step-5");
        assert_eq!(plain("Überlauf / \u{0}"), "berlauf");
        assert_eq!(plain(&"a".repeat(500)).len(), 60);
    }
}
