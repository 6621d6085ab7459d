//! Fenced blocks of Markdown pages, so that tests can hold the documentation to what it shows.
//!
//! What follows the language of a block steers the tests; readers do not see it:
//!
//! | block | means |
//! | --- | --- |
//! | `gct` | a chart without errors and warnings |
//! | `gct,wrong` | a chart with errors |
//! | `gct,file=NAME`, `csv,file=NAME`, `rust,file=NAME` | is also a file for the commands of the page |
//! | `console` | commands after `$ `, each with what it prints; `…` stands for anything |
//! | `console,exit=1` | the commands end with this code |
//! | `iecst,excerpt=NAME` | all such blocks of a page together are the file that a command wrote, apart from empty lines |
//! | `iecst,part=NAME` | stands in the file that a command wrote, perhaps indented |

use crate::binary::grafc;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A fenced block.
#[derive(Clone, Debug)]
pub struct FencedBlock {
    /// The line of its opening fence, from 1.
    pub line: usize,
    /// The heading above it, without `#`.
    pub section: String,
    /// The word after the fence.
    pub language: String,
    /// What follows the language, cut at commas.
    pub attributes: Vec<String>,
    /// The text between the fences.
    pub text: String,
}

impl FencedBlock {
    /// Whether an attribute is there: `wrong`.
    pub fn has(&self, attribute: &str) -> bool {
        self.attributes.iter().any(|a| a == attribute)
    }

    /// The value of an attribute: of `file=a.gct` it is `a.gct`.
    pub fn value(&self, attribute: &str) -> Option<&str> {
        self.attributes.iter().find_map(|a| a.strip_prefix(attribute)?.strip_prefix('='))
    }

    /// The commands of a block `console`, each with what the page says it prints.
    pub fn commands(&self) -> Vec<(String, String)> {
        let mut commands: Vec<(String, String)> = Vec::new();
        for line in self.text.lines() {
            if let Some(command) = line.strip_prefix("$ ") {
                commands.push((command.to_string(), String::new()));
            } else if let Some((_, shown)) = commands.last_mut() {
                shown.push_str(line);
                shown.push('\n');
            }
        }
        commands
    }
}

/// Writes the blocks `file=NAME` to a folder, for the commands of the page.
pub fn write_files(blocks: &[FencedBlock], folder: &Path) {
    for block in blocks {
        if let Some(name) = block.value("file") {
            let place = folder.join(name);
            // A name may be one in a folder below.
            let made = place.parent().map_or(Ok(()), fs::create_dir_all);
            made.and_then(|()| fs::write(place, &block.text)).unwrap_or_else(|e| panic!("{name}: {e}"));
        }
    }
}

/// Whether a text is the one shown, where `…` stands for anything, and white space at line ends and around the whole
/// does not count.
pub fn matches(shown: &str, printed: &str) -> bool {
    let tidy = |text: &str| text.trim().lines().map(str::trim_end).collect::<Vec<_>>().join("\n");
    let (shown, printed) = (tidy(shown), tidy(printed));
    let pieces: Vec<&str> = shown.split('…').collect();
    let [first, between @ .., last] = pieces.as_slice() else { return shown == printed };
    let Some(mut rest) = printed.strip_prefix(first) else { return false };
    for piece in between {
        let Some((_, after)) = rest.split_once(piece) else { return false };
        rest = after;
    }
    rest.ends_with(last)
}

/// The fenced blocks of a page. Those in list items are indented, and so is their text; blocks in quotations are not found.
pub fn blocks(page: &str) -> Vec<FencedBlock> {
    let mut blocks = Vec::new();
    let mut section = String::new();
    let mut open: Option<(FencedBlock, usize)> = None;
    for (number, line) in page.lines().enumerate() {
        let body = line.trim_start();
        match &mut open {
            None => {
                if let Some(info) = body.strip_prefix("```") {
                    let mut words = info.split(',').map(|word| word.trim().to_string());
                    let block = FencedBlock {
                        line: number + 1,
                        section: section.clone(),
                        language: words.next().unwrap_or_default(),
                        attributes: words.collect(),
                        text: String::new(),
                    };
                    open = Some((block, line.len() - body.len()));
                } else if let Some(heading) = line.strip_prefix('#') {
                    section = heading.trim_start_matches('#').trim().to_string();
                }
            }
            Some((block, indent)) => {
                if body.trim_end() == "```" {
                    blocks.extend(open.take().map(|(block, _)| block));
                } else {
                    let own = line.len() - body.len();
                    block.text.push_str(&line[own.min(*indent)..]);
                    block.text.push('\n');
                }
            }
        }
    }
    assert!(open.is_none(), "a block is not closed");
    blocks
}

/// The Markdown files under a folder, sorted.
pub fn pages(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        let entries = fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
        for entry in entries {
            let path = entry.unwrap_or_else(|e| panic!("{}: {e}", folder.display())).path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "md") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// Does what a page shows: its files are written into a folder, and what its commands print there is what stands below them.
/// What is no command of ours, `other` runs: what it prints, or nothing if that is not to be compared.
///
/// # Panics
/// A command fails, or prints something else.
pub fn play(page: &Path, mut other: impl FnMut(&Path, &str) -> Option<String>) {
    let text = fs::read_to_string(page).unwrap_or_else(|error| panic!("{}: {error}", page.display()));
    let blocks = blocks(&text);
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_files(&blocks, folder.path());
    for block in blocks.iter().filter(|block| block.language == "console") {
        for (command, shown) in block.commands() {
            let found = match command.strip_prefix("grafc ") {
                Some(arguments) => Some(printed(grafc().args(arguments.split(' ')), folder.path())),
                None => other(folder.path(), &command),
            };
            let is_right = found.as_ref().is_none_or(|printed| matches(&shown, printed));
            assert!(is_right, "`{command}` printed\n{}\nbut the page shows\n{shown}", found.unwrap_or_default());
        }
    }
}

/// What a command prints in a folder, warnings included.
///
/// # Panics
/// It fails.
pub fn printed(command: &mut Command, folder: &Path) -> String {
    let output = command.current_dir(folder).output().unwrap_or_else(|e| panic!("{command:?}: {e}"));
    let printed = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    assert!(output.status.success(), "{command:?}: {}\n{printed}", output.status);
    printed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_have_sections_attributes_and_text() {
        let found = blocks("# A\n\n```gct,wrong,file=a.gct\nstep 1\n```\n## B\n- x\n  ```csv\n  t_ms\n   0\n  ```\n");
        assert_eq!(found.len(), 2);
        assert_eq!((found[0].line, found[0].section.as_str(), found[0].text.as_str()), (3, "A", "step 1\n"));
        assert!(found[0].has("wrong") && found[0].value("file") == Some("a.gct"));
        assert_eq!((found[1].language.as_str(), found[1].text.as_str()), ("csv", "t_ms\n 0\n"));
    }
}
