//! Where a fault applies: its text, found by its tokens in the files of its part.

use super::tokens::{Token, is_local, tokens};
use super::{Fault, Part};
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::ops::Range;
use std::path::Path;

/// A file of the compiler.
pub struct Source {
    /// Its path, from the root of the workspace.
    pub file: String,
    /// Its content.
    pub content: String,
}

/// Where a fault applies, and what stands there with it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Spot {
    /// The file, from the root of the workspace.
    pub file: String,
    /// The right text.
    pub range: Range<usize>,
    /// The wrong text.
    pub instead: String,
}

/// The files of a part, in order of their paths.
pub fn sources(root: &Path, part: Part) -> Result<Vec<Source>, String> {
    let mut sources = Vec::new();
    let mut folders: Vec<_> = part.folders().iter().map(|folder| root.join(folder)).collect();
    while let Some(folder) = folders.pop() {
        let told = |error: io::Error| format!("{}: {error}", folder.display());
        for entry in fs::read_dir(&folder).map_err(told)? {
            let path = entry.map_err(told)?.path();
            // Tests are no place for a fault.
            if path.file_stem().is_some_and(|name| name == "tests") {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let file = path.strip_prefix(root).unwrap_or(&path).to_string_lossy().replace('\\', "/");
                sources.push(Source { content: fs::read_to_string(&path).map_err(told)?, file });
            }
        }
    }
    sources.sort_by(|a, b| a.file.cmp(&b.file));
    Ok(sources)
}

/// Files, read into tokens once for all faults.
pub struct Index<'s> {
    files: Vec<(&'s Source, Vec<Token<'s>>)>,
}

impl<'s> Index<'s> {
    /// Reads files; their unit tests are left out.
    pub fn new(sources: &'s [Source]) -> Self {
        let code = |source: &'s Source| {
            let end = source.content.find("#[cfg(test)]\nmod tests {").unwrap_or(source.content.len());
            (source, tokens(&source.content[..end]))
        };
        Index { files: sources.iter().map(code).collect() }
    }

    /// The one place of a fault. Where its text is nowhere, a place counts that differs only in the names of local
    /// variables.
    ///
    /// # Errors
    /// What is wrong if there is none, or more than one.
    pub fn place(&self, fault: &Fault) -> Result<Spot, String> {
        let pattern = tokens(fault.text);
        let mut found = self.all(&pattern, false);
        if found.is_empty() {
            found = self.all(&pattern, true);
        }
        if let (2.., Some(function)) = (found.len(), fault.at.within) {
            found.retain(|(_, first, _)| first.function == Some(function));
        }
        match &found[..] {
            [(source, first, renamed)] => {
                let (_, tokens) = self.files.iter().find(|(file, _)| file.file == source.file).ok_or("no such file")?;
                let at = tokens.partition_point(|token| token.start < first.start);
                let end = tokens[at + pattern.len() - 1].end();
                let instead = with_names(fault.instead, renamed);
                Ok(Spot { file: source.file.clone(), range: first.start..end, instead })
            }
            [] => Err(format!("`{}`: its text is nowhere in {}", fault.name, fault.at.part.folders().join(", "))),
            several => {
                let places = several.iter().map(|(source, first, _)| {
                    let line = source.content[..first.start].lines().count();
                    format!("{}:{line} in `{}`", source.file, first.function.unwrap_or("no function"))
                });
                let places = places.collect::<Vec<_>>().join(", ");
                Err(format!(
                    "`{}`: its text is in more than one place, and `within` must say which: {places}",
                    fault.name
                ))
            }
        }
    }

    /// All places of a pattern: the file, the first token, and how local variables are called there.
    fn all<'p>(&self, pattern: &[Token<'p>], renaming: bool) -> Vec<(&'s Source, Token<'s>, Renaming<'p, 's>)> {
        let mut found = Vec::new();
        for (source, tokens) in &self.files {
            for start in 0..tokens.len().saturating_sub(pattern.len() - 1) {
                if let Some(names) = matches(pattern, tokens, start, renaming) {
                    found.push((*source, tokens[start], names));
                }
            }
        }
        found
    }
}

/// How local variables of a pattern are called in a file.
type Renaming<'p, 's> = BTreeMap<&'p str, &'s str>;

/// Whether a pattern is at a place.
fn matches<'p, 's>(
    pattern: &[Token<'p>],
    tokens: &[Token<'s>],
    start: usize,
    renaming: bool,
) -> Option<Renaming<'p, 's>> {
    let mut names = Renaming::new();
    for (index, token) in pattern.iter().enumerate() {
        let other = tokens.get(start + index)?;
        if renaming && is_local(pattern, index) {
            let known = names.insert(token.text, other.text);
            if !is_local(tokens, start + index) || known.is_some_and(|known| known != other.text) {
                return None;
            }
        } else if token.text != other.text {
            return None;
        }
    }
    let mut called: Vec<&str> = names.values().copied().collect();
    called.sort_unstable();
    let count = called.len();
    called.dedup();
    // Two variables are not one.
    (called.len() == count).then_some(names)
}

/// A text with the local variables called as they are at its place.
fn with_names(text: &str, names: &Renaming) -> String {
    let found = tokens(text);
    let mut out = String::new();
    let mut done = 0;
    for (index, token) in found.iter().enumerate() {
        if let Some(name) = names.get(token.text).filter(|_| is_local(&found, index)) {
            out.push_str(&text[done..token.start]);
            out.push_str(name);
            done = token.end();
        }
    }
    out.push_str(&text[done..]);
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mutants::At;

    const FAULT: Fault = Fault {
        name: "one-too-few",
        at: At::anywhere(Part::Compiler),
        breaks: "the last one is lost",
        text: "list.iter().take(count + 1)",
        instead: "list.iter().take(count)",
    };

    fn place(fault: &Fault, files: &[(&str, &str)]) -> Result<(String, String), String> {
        let source = |(file, content): &(&str, &str)| Source { file: file.to_string(), content: content.to_string() };
        let sources: Vec<Source> = files.iter().map(source).collect();
        let place = Index::new(&sources).place(fault)?;
        let content = &sources.iter().find(|source| source.file == place.file).expect("its file").content;
        Ok((content[place.range].to_string(), place.instead))
    }

    #[test]
    fn a_text_is_found_wherever_it_moves_and_however_it_is_laid_out() {
        let instead = "list.iter().take(count)".to_string();
        let laid_out =
            "list\n        .iter()\n        // and one more\n        .take(\n            count + 1,\n        )";
        for text in [FAULT.text, laid_out] {
            let content = format!("fn f() {{\n    {text}.collect()\n}}\n");
            for files in
                [[("a.rs", content.as_str()), ("b.rs", "fn g() {}")], [("a.rs", "fn g() {}"), ("b.rs", &content)]]
            {
                assert_eq!(place(&FAULT, &files), Ok((text.to_string(), instead.clone())));
            }
        }
    }

    #[test]
    fn variables_may_have_other_names() {
        let content = "fn f() { steps.iter().take(n + 1) }";
        let expected = ("steps.iter().take(n + 1)".to_string(), "steps.iter().take(n)".to_string());
        assert_eq!(place(&FAULT, &[("a.rs", content)]), Ok(expected));
        // Two that are one, and a field, are something else.
        assert!(place(&FAULT, &[("a.rs", "fn f() { n.iter().take(n + 1) }")]).is_err());
        assert!(place(&FAULT, &[("a.rs", "fn f() { self.list.iter().take(self.count + 1) }")]).is_err());
    }

    #[test]
    fn a_function_tells_texts_apart() {
        let content =
            format!("fn f() {{ {0} }}\nfn g() {{ {0} }}\n#[cfg(test)]\nmod tests {{ fn h() {{ {0} }} }}", FAULT.text);
        let said = place(&FAULT, &[("a.rs", &content)]).expect_err("two places");
        assert!(said.contains("a.rs:1 in `f`, a.rs:2 in `g`"), "{said}");
        assert!(place(&Fault { at: FAULT.at.within("g"), ..FAULT }, &[("a.rs", &content)]).is_ok());
        assert!(place(&Fault { at: FAULT.at.within("h"), ..FAULT }, &[("a.rs", &content)]).is_err());
        assert!(place(&FAULT, &[("a.rs", "fn f() {}")]).is_err());
    }
}
