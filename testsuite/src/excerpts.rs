//! Listings of generated code in Markdown pages: whether they are what the compiler writes now, and how they become it.

use crate::markdown::FencedBlock;
use std::collections::BTreeSet;

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

/// The page with its blocks `excerpt=NAME` brought up to date. A block goes from the place of its first line in the file to
/// that of the next block's; if a first line is gone, the error names it.
pub fn renew(page: &str, blocks: &[FencedBlock], read: impl Fn(&str) -> String) -> Result<String, String> {
    let mut page: Vec<String> = page.lines().map(str::to_string).collect();
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
        // From the last block up, so that the lines above keep their numbers.
        for (block, start) in excerpts(blocks, name).zip(starts.windows(2)).collect::<Vec<_>>().into_iter().rev() {
            let piece = written[start[0]..start[1]].join("\n");
            let piece = piece.trim_end().lines().map(str::to_string);
            page.splice(block.line..block.line + block.text.lines().count(), piece);
        }
    }
    Ok(page.join("\n") + "\n")
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
}
