//! The script of the page: ES modules, a file a thing, joined into one text.
//!
//! Each becomes a function that is called once, and what it exports an object; what it imports it takes from those before
//! it. The files keep to a form that makes this a matter of lines: an import is one line, and so is what begins with
//! `export`. So there is no bundler, and each file can also be run alone by node.

use std::fmt::Write as _;

macro_rules! files {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("script/", $name, ".js")))),*]
    };
}

/// The files: what another one uses comes before it.
pub(crate) const FILES: &[(&str, &str)] = files![
    "texts",
    "values",
    "cells",
    "table",
    "model",
    "trace",
    "csv",
    "history",
    "result",
    "engine",
    "vcd",
    "replay",
    "settings",
    "clock",
    "dom",
    "view",
    "pan",
    "fold",
    "names",
    "inputs",
    "keys",
    "watch",
    "breakpoints",
    "timing",
    "timing_panel",
    "files",
    "controls",
    "keep",
    "main",
];

/// The whole script: the module of the chart, which others have as `chart.js`, then the files.
pub(crate) fn joined(module: &str) -> String {
    let (body, exports) = unwrapped(module);
    // What is exported by default, and under its own name, is the chart.
    let chart = exports.first().copied().unwrap_or("undefined");
    let mut out =
        format!("'use strict';\n(() => {{\nconst $chart = (() => {{\n{body}return {{ Chart: {chart} }};\n}})();\n");
    for (name, text) in FILES {
        let (body, exports) = unwrapped(text);
        let _ = write!(out, "const ${name} = (() => {{\n{body}return {{ {} }};\n}})();\n", exports.join(", "));
    }
    out.push_str("})();\n");
    out
}

/// The body of a file as a function has it, and the names that it exports.
fn unwrapped(text: &str) -> (String, Vec<&str>) {
    let (mut body, mut exports) = (String::new(), Vec::new());
    for line in text.lines() {
        if let Some((names, from)) = import(line) {
            let _ = writeln!(body, "const {{ {names} }} = ${from};");
            continue;
        }
        match line.strip_prefix("export ") {
            // Under another name it is exported already.
            Some(rest) if rest.starts_with("default ") && rest.ends_with(';') || rest.starts_with('{') => continue,
            Some(rest) => {
                let rest = rest.strip_prefix("default ").unwrap_or(rest);
                exports.extend(declared(rest));
                body.push_str(rest);
            }
            None => body.push_str(line),
        }
        body.push('\n');
    }
    (body, exports)
}

/// `import { a, b } from './x.js';` to `a, b` and `x`.
fn import(line: &str) -> Option<(&str, &str)> {
    let (names, from) = line.strip_prefix("import { ")?.split_once(" } from './")?;
    Some((names, from.strip_suffix(".js';")?))
}

/// The name that a declaration declares.
fn declared(declaration: &str) -> Option<&str> {
    let words = ["async function ", "function ", "class ", "const "];
    let rest = words.iter().find_map(|word| declaration.strip_prefix(word))?;
    rest.split(|c: char| !c.is_alphanumeric() && c != '_' && c != '$').next()
}

/// A text as it may stand between the tags of a script, where nothing but a tag ends it: such signs are in strings and
/// comments alone, where a backslash more means the same. The reader of HTML makes one sign of line ends, and another of
/// what is no character; the hash of the text is that of what it reads.
pub(crate) fn in_html(script: &str) -> String {
    let mut out = String::with_capacity(script.len());
    let mut rest = script;
    while let Some(at) = rest.find('<') {
        let (before, from) = rest.split_at(at);
        out.push_str(before);
        let ends = from.get(1..7).is_some_and(|word| word.eq_ignore_ascii_case("script"))
            || from.starts_with("<!--")
            || from.get(1..8).is_some_and(|word| word.eq_ignore_ascii_case("/script"));
        out.push_str(if ends { "<\\" } else { "<" });
        rest = &from[1..];
    }
    out.push_str(rest);
    out.replace("\r\n", "\n").replace('\r', "\n").replace('\0', "\u{fffd}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_file_takes_from_files_before_it_what_they_export() {
        let mut known: Vec<(&str, Vec<&str>)> = vec![("chart", vec!["Chart"])];
        for (name, text) in FILES {
            for line in text.lines().filter(|line| line.starts_with("import")) {
                let (names, from) = import(line).unwrap_or_else(|| panic!("{name}: {line}"));
                let exports = known.iter().find(|(file, _)| file == &from);
                let exports =
                    &exports.unwrap_or_else(|| panic!("{name} takes from {from}, which does not come before it")).1;
                for wanted in names.split(", ") {
                    assert!(exports.contains(&wanted), "{name} takes `{wanted}` from {from}");
                }
            }
            let exports = text.lines().filter(|line| line.starts_with("export")).map(|line| {
                let name = line.strip_prefix("export ").and_then(declared);
                name.unwrap_or_else(|| panic!("{line}: not in the form that is joined"))
            });
            known.push((name, exports.collect()));
        }
    }

    #[test]
    fn no_text_ends_the_script() {
        let text = "'</script>' /* <SCRIPT <!-- a<b </ScRiPt */";
        assert_eq!(in_html(text), "'<\\/script>' /* <\\SCRIPT <\\!-- a<b <\\/ScRiPt */");
        assert_eq!(in_html("a\r\nb\rc"), "a\nb\nc");
    }
}
