//! Messages for code-scanning tools: SARIF 2.1.0 (OASIS).
//!
//! One run. Its rules are the codes that occur, in order, each with its page; results are in the order given, and behind
//! them those that somebody has allowed, which are suppressed (3.35): in the source with its reason, or outside. No dates and no absolute paths other than those the user gave, so that equal runs give equal text.

use crate::{Allowed, Code, Diagnostic, Diagnostics, Edit, FileId, Fix, Label, Severity, SourceMap, Span};
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// A whole SARIF log; `version` is grafc's.
pub fn sarif(sources: &SourceMap, diagnostics: &Diagnostics, version: &str) -> String {
    let allowed = || diagnostics.allowed().iter();
    let all = || diagnostics.iter().chain(allowed().map(|(d, _)| d));
    let used: BTreeSet<Code> = all().map(|d| d.code).collect();
    let rules: Vec<Code> = Code::ALL.iter().copied().filter(|code| used.contains(code)).collect();
    let spans = all().flat_map(|d| std::iter::once(&d.primary).chain(&d.secondary)).map(|l| l.span);
    let files: Vec<FileId> = spans.map(|span| span.file).collect::<BTreeSet<_>>().into_iter().collect();
    let places = Places { sources, files: &files };
    let mut results: Vec<Value> = diagnostics.iter().map(|d| result(d, &rules, &places)).collect();
    results.extend(allowed().map(|(diagnostic, why)| {
        let mut result = result(diagnostic, &rules, &places);
        result["suppressions"] = json!([suppression(why, &places)]);
        result
    }));
    let log = json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "grafc",
                "version": version,
                "rules": rules.iter().copied().map(rule).collect::<Vec<_>>(),
            }},
            "columnKind": "unicodeCodePoints",
            "artifacts": files.iter().map(|file| artifact(sources, *file)).collect::<Vec<_>>(),
            "results": results,
        }],
    });
    format!("{log:#}\n")
}

fn rule(code: Code) -> Value {
    json!({
        "id": code.as_str(),
        "name": pascal_case(code.slug()),
        "shortDescription": { "text": code.slug().replace('-', " ") },
        "help": { "text": code.page(), "markdown": code.page() },
        "defaultConfiguration": { "level": level(code.severity()) },
    })
}

fn artifact(sources: &SourceMap, file: FileId) -> Value {
    json!({ "location": { "uri": uri(&sources.file(file).name) } })
}

fn result(diagnostic: &Diagnostic, rules: &[Code], places: &Places) -> Value {
    let mut text = diagnostic.message.clone();
    for note in &diagnostic.notes {
        text.push_str("\nnote: ");
        text.push_str(note);
    }
    if let Some(help) = &diagnostic.help {
        text.push_str("\nhelp: ");
        text.push_str(help);
    }
    let related: Vec<Value> =
        diagnostic.secondary.iter().enumerate().map(|(id, label)| places.location(label, Some(id))).collect();
    let mut result = json!({
        "ruleId": diagnostic.code.as_str(),
        "level": level(diagnostic.severity()),
        "message": { "text": text },
        "locations": [places.location(&diagnostic.primary, None)],
    });
    if let Some(index) = rules.iter().position(|rule| *rule == diagnostic.code) {
        result["ruleIndex"] = json!(index);
    }
    if !related.is_empty() {
        result["relatedLocations"] = json!(related);
    }
    if !diagnostic.fixes.is_empty() {
        result["fixes"] = diagnostic.fixes.iter().map(|fix| places.fix(fix)).collect();
    }
    result
}

fn suppression(why: &Allowed, places: &Places) -> Value {
    let mut suppression = json!({ "kind": if why.span.is_some() { "inSource" } else { "external" } });
    if let Some(reason) = &why.reason {
        suppression["justification"] = json!(reason);
    }
    if let Some(span) = why.span {
        suppression["location"] = places.location(&Label { span, text: String::new() }, None);
    }
    suppression
}

struct Places<'a> {
    sources: &'a SourceMap,
    files: &'a [FileId],
}

impl Places<'_> {
    fn artifact(&self, file: FileId) -> Value {
        let mut artifact = json!({ "uri": uri(&self.sources.file(file).name) });
        if let Ok(index) = self.files.binary_search(&file) {
            artifact["index"] = json!(index);
        }
        artifact
    }

    fn region(&self, span: Span) -> Value {
        let file = self.sources.file(span.file);
        let range = file.range(span);
        let (start, end) = (file.position(range.start), file.position(range.end));
        json!({
            "startLine": start.line,
            "startColumn": start.column,
            "endLine": end.line,
            "endColumn": end.column,
            "byteOffset": start.byte,
            "byteLength": end.byte - start.byte,
        })
    }

    /// A fix changes artifacts, each by replacements (SARIF 2.1.0, 3.55 to 3.57).
    fn fix(&self, fix: &Fix) -> Value {
        let of_file = |file: FileId| -> Value {
            let edits = fix.edits.iter().filter(|edit| edit.span.file == file).map(|edit| self.replacement(edit));
            json!({ "artifactLocation": self.artifact(file), "replacements": edits.collect::<Vec<_>>() })
        };
        let files: BTreeSet<FileId> = fix.edits.iter().map(|edit| edit.span.file).collect();
        json!({
            "description": { "text": fix.title },
            "artifactChanges": files.into_iter().map(of_file).collect::<Vec<_>>(),
        })
    }

    fn replacement(&self, edit: &Edit) -> Value {
        let mut replacement = json!({ "deletedRegion": self.region(edit.span) });
        if !edit.text.is_empty() {
            replacement["insertedContent"] = json!({ "text": edit.text });
        }
        replacement
    }

    fn location(&self, label: &Label, id: Option<usize>) -> Value {
        let mut location = json!({
            "physicalLocation": {
                "artifactLocation": self.artifact(label.span.file),
                "region": self.region(label.span),
            },
        });
        if let Some(id) = id {
            location["id"] = json!(id);
        }
        if !label.text.is_empty() {
            location["message"] = json!({ "text": label.text });
        }
        location
    }
}

fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    }
}

/// `unknown-name` as `UnknownName`, as SARIF viewers expect a rule's name.
fn pascal_case(slug: &str) -> String {
    slug.split('-')
        .flat_map(|word| {
            let mut characters = word.chars();
            characters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(characters)
        })
        .collect()
}

/// A path as a URI reference (RFC 3986): relative paths stay relative, bytes that a URI cannot hold are escaped.
fn uri(path: &str) -> String {
    let path = if cfg!(windows) { path.replace('\\', "/") } else { path.to_string() };
    let mut out = String::new();
    if path.starts_with("//") {
        out.push_str("file:");
    } else if path.starts_with('/') {
        out.push_str("file://");
    } else if cfg!(windows) && path.as_bytes().get(1) == Some(&b':') {
        out.push_str("file:///");
    }
    for byte in path.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => out.push(char::from(byte)),
            _ => out.push_str(&format!("%{byte:02X}")),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Policy;
    use expect_test::expect;

    #[test]
    fn a_log_names_rules_artifacts_and_results() {
        let mut sources = SourceMap::new();
        let unused = sources.add("unused.gct", "");
        let file = sources.add("my charts/ä.gct", "вход a\nb\n");
        let mut diagnostics = Diagnostics::new();
        diagnostics.push(Diagnostic::new(Code::W0401, Span::new(file, 9, 10), "output `a` is read"));
        diagnostics.push(
            Diagnostic::new(Code::E0104, Span::new(file, 11, 11), "m")
                .here("here")
                .also(Span::new(file, 0, 8), "there")
                .note("n")
                .help("h"),
        );
        diagnostics.push(Diagnostic::new(Code::W0401, Span::new(file, 11, 12), "again"));
        let mut log: Value = serde_json::from_str(&sarif(&sources, &diagnostics, "1.2.3")).unwrap();
        assert_ne!(unused, file);
        for rule in log["runs"][0]["tool"]["driver"]["rules"].as_array_mut().unwrap() {
            assert!(rule["help"]["text"].as_str().unwrap().starts_with(&format!("# {}", rule["id"].as_str().unwrap())));
            rule.as_object_mut().unwrap().remove("help");
        }
        expect![[r#"
            {
              "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
              "runs": [
                {
                  "artifacts": [
                    {
                      "location": {
                        "uri": "my%20charts/%C3%A4.gct"
                      }
                    }
                  ],
                  "columnKind": "unicodeCodePoints",
                  "results": [
                    {
                      "level": "warning",
                      "locations": [
                        {
                          "physicalLocation": {
                            "artifactLocation": {
                              "index": 0,
                              "uri": "my%20charts/%C3%A4.gct"
                            },
                            "region": {
                              "byteLength": 1,
                              "byteOffset": 9,
                              "endColumn": 7,
                              "endLine": 1,
                              "startColumn": 6,
                              "startLine": 1
                            }
                          }
                        }
                      ],
                      "message": {
                        "text": "output `a` is read"
                      },
                      "ruleId": "W0401",
                      "ruleIndex": 1
                    },
                    {
                      "level": "error",
                      "locations": [
                        {
                          "message": {
                            "text": "here"
                          },
                          "physicalLocation": {
                            "artifactLocation": {
                              "index": 0,
                              "uri": "my%20charts/%C3%A4.gct"
                            },
                            "region": {
                              "byteLength": 0,
                              "byteOffset": 11,
                              "endColumn": 1,
                              "endLine": 2,
                              "startColumn": 1,
                              "startLine": 2
                            }
                          }
                        }
                      ],
                      "message": {
                        "text": "m\nnote: n\nhelp: h"
                      },
                      "relatedLocations": [
                        {
                          "id": 0,
                          "message": {
                            "text": "there"
                          },
                          "physicalLocation": {
                            "artifactLocation": {
                              "index": 0,
                              "uri": "my%20charts/%C3%A4.gct"
                            },
                            "region": {
                              "byteLength": 8,
                              "byteOffset": 0,
                              "endColumn": 5,
                              "endLine": 1,
                              "startColumn": 1,
                              "startLine": 1
                            }
                          }
                        }
                      ],
                      "ruleId": "E0104",
                      "ruleIndex": 0
                    },
                    {
                      "level": "warning",
                      "locations": [
                        {
                          "physicalLocation": {
                            "artifactLocation": {
                              "index": 0,
                              "uri": "my%20charts/%C3%A4.gct"
                            },
                            "region": {
                              "byteLength": 1,
                              "byteOffset": 11,
                              "endColumn": 2,
                              "endLine": 2,
                              "startColumn": 1,
                              "startLine": 2
                            }
                          }
                        }
                      ],
                      "message": {
                        "text": "again"
                      },
                      "ruleId": "W0401",
                      "ruleIndex": 1
                    }
                  ],
                  "tool": {
                    "driver": {
                      "name": "grafc",
                      "rules": [
                        {
                          "defaultConfiguration": {
                            "level": "error"
                          },
                          "id": "E0104",
                          "name": "MalformedName",
                          "shortDescription": {
                            "text": "malformed name"
                          }
                        },
                        {
                          "defaultConfiguration": {
                            "level": "warning"
                          },
                          "id": "W0401",
                          "name": "OutputRead",
                          "shortDescription": {
                            "text": "output read"
                          }
                        }
                      ],
                      "version": "1.2.3"
                    }
                  }
                }
              ],
              "version": "2.1.0"
            }
        "#]]
        .assert_eq(&format!("{log:#}\n"));
    }

    #[test]
    fn fixes_are_replacements() {
        let mut sources = SourceMap::new();
        let file = sources.add("a.gct", "вход a\nb\n");
        let fix = Fix::certain("f").replace(Span::new(file, 9, 10), "я").delete(Span::new(file, 11, 12));
        let mut diagnostics = Diagnostics::new();
        diagnostics.push(Diagnostic::new(Code::E0201, Span::new(file, 9, 10), "m").fix(fix));
        let log: Value = serde_json::from_str(&sarif(&sources, &diagnostics, "0")).unwrap();
        let region = |line, column, byte, end| {
            json!({ "startLine": line, "startColumn": column, "endLine": line, "endColumn": end,
                    "byteOffset": byte, "byteLength": 1 })
        };
        let expected = json!([{
            "description": { "text": "f" },
            "artifactChanges": [{
                "artifactLocation": { "uri": "a.gct", "index": 0 },
                "replacements": [
                    { "deletedRegion": region(1, 6, 9, 7), "insertedContent": { "text": "я" } },
                    { "deletedRegion": region(2, 1, 11, 2) },
                ],
            }],
        }]);
        assert_eq!(log["runs"][0]["results"][0]["fixes"], expected);
    }

    #[test]
    fn what_is_allowed_is_suppressed_and_what_is_denied_an_error() {
        let mut sources = SourceMap::new();
        let file = sources.add("a.gct", "вход a\nb\n");
        let mut diagnostics = Diagnostics::new();
        for (code, at) in [(Code::W0401, 9), (Code::W0402, 9), (Code::W0403, 11)] {
            diagnostics.push(Diagnostic::new(code, Span::new(file, at, at + 1), "m"));
        }
        let place = Span::new(file, 11, 12);
        diagnostics.set_aside(|d| {
            let of_text = Allowed { reason: Some("why".into()), span: Some(place) };
            (d.code == Code::W0401).then_some(of_text)
        });
        let policy = Policy { deny_all: true, allow: [Code::W0402].into(), ..Policy::default() };
        policy.apply(&mut diagnostics);
        let log: Value = serde_json::from_str(&sarif(&sources, &diagnostics, "0")).unwrap();
        let results = log["runs"][0]["results"].as_array().unwrap();
        let told: Vec<(&str, &str)> =
            results.iter().map(|r| (r["ruleId"].as_str().unwrap(), r["level"].as_str().unwrap())).collect();
        assert_eq!(told, [("W0403", "error"), ("W0401", "warning"), ("W0402", "warning")]);
        assert_eq!(results[0].get("suppressions"), None);
        let region = json!({ "startLine": 2, "startColumn": 1, "endLine": 2, "endColumn": 2,
                             "byteOffset": 11, "byteLength": 1 });
        let location = json!({ "physicalLocation": {
            "artifactLocation": { "uri": "a.gct", "index": 0 }, "region": region } });
        let in_source = json!([{ "kind": "inSource", "justification": "why", "location": location }]);
        assert_eq!(results[1]["suppressions"], in_source);
        assert_eq!(results[2]["suppressions"], json!([{ "kind": "external" }]));
        let json = crate::render::json(&sources, &diagnostics);
        assert_eq!(json.lines().count(), 1, "scripts see what people see: {json}");
        assert!(json.contains(r#""code":"W0403","slug":"negated-edge","severity":"error""#), "{json}");
        assert_eq!(crate::render::summary(&diagnostics), "1 error\n");
    }

    #[test]
    fn a_log_without_results_is_still_a_log() {
        let log: Value = serde_json::from_str(&sarif(&SourceMap::new(), &Diagnostics::new(), "0")).unwrap();
        assert_eq!(log["runs"][0]["results"], json!([]));
        assert_eq!(log["version"], "2.1.0");
    }

    #[test]
    fn paths_become_uri_references() {
        assert_eq!(uri("a/b.gct"), "a/b.gct");
        assert_eq!(uri("/a b.gct"), "file:///a%20b.gct");
        assert_eq!(uri("a:b?#%.gct"), "a%3Ab%3F%23%25.gct");
        assert_eq!(uri("<stdin>"), "%3Cstdin%3E");
        assert_eq!(pascal_case("not-utf8"), "NotUtf8");
    }
}
