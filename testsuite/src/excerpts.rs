//! Listings of generated code in Markdown pages: whether they are what the compiler writes now, and how they become it.

use crate::markdown::FencedBlock;
use std::collections::{BTreeMap, BTreeSet};

/// Compares all blocks `excerpt=NAME` and `part=NAME` of a page with the files that its commands wrote; says what differs.
pub fn compare(blocks: &[FencedBlock], read: impl Fn(&str) -> String) -> Vec<String> {
    let mut faults = Vec::new();
    for name in names(blocks) {
        let shown: Vec<String> = excerpts(blocks, name).flat_map(|b| lines(&b.text)).collect();
        let written = lines(&read(name));
        let differ = shown.iter().zip(&written).position(|(a, b)| a != b);
        let at = differ.unwrap_or(shown.len().min(written.len()));
        if shown.get(at) != written.get(at) {
            faults.push(format!("line {at} of {name}: shown {:?}, written {:?}", shown.get(at), written.get(at)));
        }
    }
    for block in blocks {
        let Some(name) = block.value("part") else { continue };
        let (part, written) = (unindented(&block.text), unindented(&read(name)));
        if !written.windows(part.len()).any(|window| window == part) {
            faults.push(format!("line {} of the page: not in {name}", block.line));
        }
    }
    faults
}

/// The page with its blocks brought up to date; an error names a first line that the file has no more.
///
/// A block `excerpt=NAME` goes from the place of its first line in the file to that of the next block's. A block
/// `part=NAME` that is not in the file goes from its first line, where most of the others follow, to its last line, or if
/// that is gone as far as before.
pub fn renew(page: &str, blocks: &[FencedBlock], read: impl Fn(&str) -> String) -> Result<String, String> {
    let mut page: Vec<String> = page.lines().map(str::to_string).collect();
    // By the line of the page: what takes its place, and how many lines that are.
    let mut pieces: BTreeMap<usize, (usize, Vec<String>)> = BTreeMap::new();
    for name in names(blocks) {
        let written: Vec<String> = read(name).lines().map(str::to_string).collect();
        let mut starts = Vec::new();
        let mut from = 0;
        for block in excerpts(blocks, name) {
            let anchor: Vec<&str> = block.text.lines().take(2).collect();
            let found = |length: usize| {
                (from..written.len()).find(|at| written[*at..].iter().zip(&anchor[..length]).all(|(a, b)| a == b))
            };
            let at =
                found(anchor.len()).or(found(1)).ok_or_else(|| format!("{name} has no line {:?}", anchor.first()))?;
            starts.push(at);
            from = at + 1;
        }
        starts.push(written.len());
        for (block, start) in excerpts(blocks, name).zip(starts.windows(2)) {
            let piece = written[start[0]..start[1]].join("\n");
            let piece = piece.trim_end().lines().map(str::to_string).collect();
            pieces.insert(block.line, (block.text.lines().count(), piece));
        }
    }
    for block in blocks {
        let Some(name) = block.value("part") else { continue };
        if let Some(piece) = part(block, name, &read(name))? {
            pieces.insert(block.line, (block.text.lines().count(), piece));
        }
    }
    // From the last block up, so that the lines above keep their numbers.
    for (line, (length, piece)) in pieces.into_iter().rev() {
        page.splice(line..line + length, piece);
    }
    Ok(page.join("\n") + "\n")
}

/// The lines of a file that a block of a page shows, if it shows others.
fn part(block: &FencedBlock, name: &str, written: &str) -> Result<Option<Vec<String>>, String> {
    let shown = unindented(&block.text);
    // Empty lines do not count.
    let lines: Vec<(usize, &str)> =
        written.lines().map(str::trim).enumerate().filter(|(_, line)| !line.is_empty()).collect();
    let (Some(first), Some(last)) = (shown.first(), shown.last()) else { return Ok(None) };
    if lines.windows(shown.len()).any(|window| window.iter().zip(&shown).all(|((_, line), shown)| line == shown)) {
        return Ok(None);
    }
    // Where more lines are the same at once, and then where more of them are there at all.
    let like = |at: usize| {
        let window = || lines[at..].iter().take(shown.len()).map(|(_, line)| *line);
        let same = window().zip(&shown).take_while(|(line, shown)| line == shown).count();
        (same, window().filter(|line| shown.iter().any(|shown| shown == line)).count())
    };
    let starts = (0..lines.len()).filter(|at| lines[*at].1 == first);
    let start = starts.max_by_key(|at| (like(*at), std::cmp::Reverse(*at)));
    let start = start.ok_or_else(|| format!("{name} has no line {first:?}"))?;
    let usual = start + shown.len() - 1;
    let ends = (start + 1..(start + 2 * shown.len()).min(lines.len())).filter(|at| lines[*at].1 == last);
    let end = ends.min_by_key(|at| at.abs_diff(usual)).unwrap_or(usual.min(lines.len() - 1));
    let piece: Vec<&str> = written.lines().take(lines[end].0 + 1).skip(lines[start].0).collect();
    let indent = |line: &&str| line.len() - line.trim_start().len();
    let common = piece.iter().filter(|line| !line.trim().is_empty()).map(indent).min().unwrap_or_default();
    Ok(Some(piece.iter().map(|line| line.get(common..).unwrap_or_default().trim_end().to_owned()).collect()))
}

fn names(blocks: &[FencedBlock]) -> BTreeSet<&str> {
    blocks.iter().filter_map(|b| b.value("excerpt")).collect()
}

fn excerpts<'b>(blocks: &'b [FencedBlock], name: &str) -> impl Iterator<Item = &'b FencedBlock> {
    blocks.iter().filter(move |b| b.value("excerpt") == Some(name))
}

/// The lines that are not empty, without white space at their ends.
fn lines(text: &str) -> Vec<String> {
    text.lines().map(|line| line.trim_end().to_string()).filter(|line| !line.is_empty()).collect()
}

fn unindented(text: &str) -> Vec<String> {
    lines(text).iter().map(|line| line.trim_start().to_string()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::markdown::blocks;

    const PAGE: &str = "```iecst,excerpt=a.st\none\ntwo\n```\ntext\n```iecst,excerpt=a.st\nthree\n```\n";

    #[test]
    fn excerpts_are_the_whole_file() {
        let blocks = blocks(PAGE);
        assert!(compare(&blocks, |_| "one\ntwo\n\nthree\n".into()).is_empty());
        assert_eq!(compare(&blocks, |_| "one\n2\nthree\n".into()).len(), 1);
        assert_eq!(compare(&blocks, |_| "one\ntwo\nthree\nfour\n".into()).len(), 1);
    }

    #[test]
    fn excerpts_are_renewed_from_first_line_to_first_line() {
        let renewed = renew(PAGE, &blocks(PAGE), |_| "one\n2\n2a\n\nthree\nfour\n".into());
        let expected = PAGE.replace("two", "2\n2a").replace("three", "three\nfour");
        assert_eq!(renewed, Ok(expected));
        assert!(renew(PAGE, &blocks(PAGE), |_| "other\n".into()).is_err());
    }

    #[test]
    fn parts_are_renewed_where_they_are_no_more_in_the_file() {
        let page =
            "```iecst,part=a.st\nIF x THEN\n  one;\n  two;\nEND_IF;\n```\ntext\n```iecst,part=a.st\nlast;\n```\n";
        let written = "IF x THEN\n  other;\nEND_IF;\n  IF x THEN\n    one;\n\n    2;\n    two;\n  END_IF;\n  last;\n";
        let old = blocks(page);
        assert_eq!(compare(&old, |_| written.into()).len(), 1);
        let renewed = renew(page, &old, |_| written.into()).unwrap();
        assert_eq!(renewed, page.replace("  one;\n", "  one;\n\n  2;\n"));
        assert!(compare(&blocks(&renewed), |_| written.into()).is_empty());
        // What is right stays as it is laid out; of what has another last line, as much is shown as before.
        assert_eq!(renew(&renewed, &blocks(&renewed), |_| written.into()), Ok(renewed.clone()));
        let shorter = "IF x THEN\n  one;\n  two;\nELSE\nlast;\n";
        assert_eq!(renew(page, &old, |_| shorter.into()), Ok(page.replace("END_IF", "ELSE").replace("ELSE;", "ELSE")));
        assert!(renew(page, &old, |_| "other\n".into()).is_err());
    }
}
