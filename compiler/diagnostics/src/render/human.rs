//! Messages for people: headline, underlined places, reasons, help.

use super::excerpt::{Excerpt, Excerpts, LINES_AFTER_START, LINES_BEFORE_END, visible, visible_lines};
use crate::{Diagnostic, Diagnostics, FileId, Label, Severity, SourceMap};
use codespan_reporting::diagnostic as codespan;
use codespan_reporting::term::termcolor::{Ansi, NoColor, WriteColor};
use codespan_reporting::term::{self, Config};
use std::ops::Range;

/// Of one message, so many places besides the first are shown; the others are counted.
const OTHER_PLACES: usize = 8;

/// All messages, in the order given, each followed by an empty line; with ANSI colours if asked to.
pub fn human(sources: &SourceMap, diagnostics: &Diagnostics, colour: bool) -> String {
    if colour {
        let mut out = Ansi::new(Vec::new());
        write_all(&mut out, sources, diagnostics);
        String::from_utf8_lossy(&out.into_inner()).into_owned()
    } else {
        let mut out = NoColor::new(Vec::new());
        write_all(&mut out, sources, diagnostics);
        let text = String::from_utf8_lossy(&out.into_inner()).into_owned();
        text.lines().flat_map(|line| [line.trim_end(), "\n"]).collect()
    }
}

fn write_all(out: &mut dyn WriteColor, sources: &SourceMap, diagnostics: &Diagnostics) {
    let config =
        Config { start_context_lines: LINES_AFTER_START, end_context_lines: LINES_BEFORE_END, ..Config::default() };
    for diagnostic in diagnostics {
        let (excerpts, message) = prepare(sources, diagnostic);
        if term::emit_to_write_style(out, &config, &excerpts, &message).is_err() {
            // The excerpt is ours and in memory; should it still be refused, the headline must not be lost.
            let header = format!("{}[{}]: {}\n\n", severity(diagnostic), diagnostic.code.as_str(), message.message);
            let _ = std::io::Write::write_all(out, header.as_bytes());
        }
    }
}

/// A message in codespan's form, and the excerpts that its labels lie in.
fn prepare(sources: &SourceMap, diagnostic: &Diagnostic) -> (Excerpts, codespan::Diagnostic<usize>) {
    let shown = &diagnostic.secondary[..diagnostic.secondary.len().min(OTHER_PLACES)];
    let labels: Vec<&Label> = std::iter::once(&diagnostic.primary).chain(shown).collect();
    let mut files: Vec<FileId> = Vec::new();
    for label in &labels {
        if !files.contains(&label.span.file) {
            files.push(label.span.file);
        }
    }

    let mut excerpts = Vec::new();
    let mut places: Vec<Option<(usize, Range<usize>)>> = vec![None; labels.len()];
    for (id, file) in files.iter().enumerate() {
        let of_file: Vec<usize> = (0..labels.len()).filter(|i| labels[*i].span.file == *file).collect();
        let file = sources.file(*file);
        let ranges: Vec<Range<usize>> = of_file.iter().map(|i| file.range(labels[*i].span)).collect();
        let (excerpt, ranges) = Excerpt::new(file, &ranges);
        excerpts.push(excerpt);
        for (label, range) in of_file.into_iter().zip(ranges) {
            places[label] = Some((id, range));
        }
    }

    let labels = labels.iter().zip(places).enumerate().filter_map(|(i, (label, place))| {
        let style = if i == 0 { codespan::LabelStyle::Primary } else { codespan::LabelStyle::Secondary };
        let (file, range) = place?;
        Some(codespan::Label::new(style, file, range).with_message(visible(&label.text)))
    });
    let mut notes: Vec<String> = diagnostic.notes.iter().map(|note| format!("note: {}", visible_lines(note))).collect();
    if diagnostic.secondary.len() > OTHER_PLACES {
        notes.push(format!("note: and {} more places", diagnostic.secondary.len() - OTHER_PLACES));
    }
    notes.extend(diagnostic.help.iter().map(|help| format!("help: {}", visible_lines(help))));
    let message = codespan::Diagnostic::new(match diagnostic.severity() {
        Severity::Error => codespan::Severity::Error,
        Severity::Warning => codespan::Severity::Warning,
    })
    .with_code(diagnostic.code.as_str())
    .with_message(visible(&diagnostic.message))
    .with_labels(labels.collect())
    .with_notes(notes);
    (Excerpts(excerpts), message)
}

/// The word for a severity.
pub fn severity(diagnostic: &Diagnostic) -> &'static str {
    match diagnostic.severity() {
        Severity::Error => "error",
        Severity::Warning => "warning",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Code, Span};
    use expect_test::{Expect, expect};

    fn show(text: &str, diagnostic: impl Fn(FileId) -> Diagnostic) -> String {
        let mut sources = SourceMap::new();
        let file = sources.add("filling.gct", text);
        let mut diagnostics = Diagnostics::new();
        diagnostics.push(diagnostic(file));
        human(&sources, &diagnostics, false)
    }

    fn check(text: &str, diagnostic: impl Fn(FileId) -> Diagnostic, expected: Expect) {
        expected.assert_eq(&show(text, diagnostic));
    }

    /// The faults at a span, and at a second one if given.
    fn at(spans: &'static [(usize, usize)]) -> impl Fn(FileId) -> Diagnostic {
        move |file| {
            let diagnostic = Diagnostic::new(Code::E0201, Span::new(file, spans[0].0, spans[0].1), "no such thing");
            let diagnostic = diagnostic.here("here");
            spans[1..].iter().fold(diagnostic, |d, (start, end)| d.also(Span::new(file, *start, *end), "and there"))
        }
    }

    #[test]
    fn a_message_has_headline_places_reasons_and_a_cure() {
        let text = "input a : bool\nstep 1\nstep 2\nstep 3\ntransition 1 -> 2 : b\n";
        check(
            text,
            |file| {
                Diagnostic::new(Code::E0201, Span::new(file, 56, 57), "unknown name `b`")
                    .here("not declared")
                    .also(Span::new(file, 6, 7), "`a` is declared here")
                    .note("inputs are declared\nbefore they are read")
                    .help("declare `b`")
            },
            expect![[r#"
                error[E0201]: unknown name `b`
                  ┌─ filling.gct:5:21
                  │
                1 │ input a : bool
                  │       - `a` is declared here
                  ·
                5 │ transition 1 -> 2 : b
                  │                     ^ not declared
                  │
                  = note: inputs are declared
                    before they are read
                  = help: declare `b`

            "#]],
        );
    }

    #[test]
    fn a_warning_says_so() {
        check(
            "a",
            |file| Diagnostic::new(Code::W0403, Span::new(file, 0, 1), "m"),
            expect![[r#"
                warning[W0403]: m
                  ┌─ filling.gct:1:1
                  │
                1 │ a
                  │ ^

            "#]],
        );
    }

    #[test]
    fn zero_width_at_the_end_of_a_file_with_and_without_line_end() {
        check(
            "step 1",
            at(&[(6, 6)]),
            expect![[r#"
            error[E0201]: no such thing
              ┌─ filling.gct:1:7
              │
            1 │ step 1
              │       ^ here

        "#]],
        );
        check(
            "step 1\n",
            at(&[(7, 7)]),
            expect![[r#"
                error[E0201]: no such thing
                  ┌─ filling.gct:2:1
                  │
                2 │
                  │ ^ here

            "#]],
        );
        check(
            "",
            at(&[(0, 0)]),
            expect![[r#"
                error[E0201]: no such thing
                  ┌─ filling.gct:1:1
                  │
                1 │
                  │ ^ here

            "#]],
        );
    }

    #[test]
    fn a_line_end_is_underlined_as_the_end_of_its_line() {
        check(
            "step 1\r\nstep 2\r\n",
            at(&[(6, 8)]),
            expect![[r#"
            error[E0201]: no such thing
              ┌─ filling.gct:1:7
              │
            1 │ step 1
              │       ^ here

        "#]],
        );
        check(
            "step 1\nstep 2\n",
            at(&[(0, 7)]),
            expect![[r#"
            error[E0201]: no such thing
              ┌─ filling.gct:1:1
              │
            1 │ step 1
              │ ^^^^^^ here

        "#]],
        );
    }

    #[test]
    fn tabs_and_wide_characters_are_measured() {
        check(
            "\tстеп 1\t漢字 ab",
            at(&[(25, 26), (12, 18)]),
            expect![[r#"
                error[E0201]: no such thing
                  ┌─ filling.gct:1:14
                  │
                1 │     степ 1  漢字 ab
                  │             ----   ^ here
                  │             │
                  │             and there

            "#]],
        );
    }

    #[test]
    fn a_span_that_does_not_fit_its_text_is_cut() {
        check(
            "aä",
            at(&[(2, 90), (50, 60)]),
            expect![[r#"
            error[E0201]: no such thing
              ┌─ filling.gct:1:2
              │
            1 │ aä
              │  ^- and there
              │  │
              │  here

        "#]],
        );
    }

    #[test]
    fn a_long_span_shows_its_ends() {
        let text: String = (1..=30).map(|i| format!("step {i}\n")).collect();
        let last = text.len();
        check(
            &text,
            |file| {
                Diagnostic::new(Code::E0321, Span::new(file, 7, last), "too long")
                    .here("this")
                    .also(Span::new(file, 75, 81), "here")
            },
            expect![[r#"
                error[E0321]: too long
                   ┌─ filling.gct:2:1
                   │
                 2 │ ╭   step 2
                 3 │ │   step 3
                 4 │ │   step 4
                 5 │ │   step 5
                   · │
                11 │ │   step 11
                   │ │ ╭─────'
                12 │ │ │ step 12
                   │ │ ╰──' here
                   · │
                29 │ │   step 29
                30 │ │   step 30
                   │ ╰─────────^ this

            "#]],
        );
    }

    #[test]
    fn lines_between_two_places_are_left_out_unless_it_is_one() {
        check(
            "a\nb\nc\nd\ne\nf\n",
            at(&[(0, 1), (4, 5), (10, 11)]),
            expect![[r#"
            error[E0201]: no such thing
              ┌─ filling.gct:1:1
              │
            1 │ a
              │ ^ here
            2 │ b
            3 │ c
              │ - and there
              ·
            6 │ f
              │ - and there

        "#]],
        );
    }

    #[test]
    fn a_line_of_ten_megabytes_is_cut_around_its_labels() {
        let text = format!("{}fault{}", "x ".repeat(2_500_000), " y".repeat(2_500_000));
        check(
            &text,
            |file| {
                Diagnostic::new(Code::E0107, Span::new(file, 5_000_000, 5_000_005), "m")
                    .here("here")
                    .also(Span::new(file, 0, 1_000_000), "all this")
                    .also(Span::new(file, text.len(), text.len()), "the end")
            },
            expect![[r#"
                error[E0107]: m
                  ┌─ filling.gct:1:5000001
                  │
                1 │ x x x x x x x x x x x x x x x x x x x x x x x x x x x x x x …x x x x x x x x x x x x x x x x x x x x fault y y y y y y y y y y y y y y y y y y y y… y y y y y y y y y y y y y y y y y y y y
                  │ ------------------------------------------------------------                                         ^^^^^                                                                                 - the end
                  │ │                                                                                                    │
                  │ │                                                                                                    here
                  │ all this

            "#]],
        );
    }

    #[test]
    fn many_faults_in_a_long_line_are_not_quadratic() {
        let mut sources = SourceMap::new();
        let file = sources.add("long.gct", "ab ".repeat(1_000_000));
        let mut diagnostics = Diagnostics::new();
        for i in 0..2_000 {
            diagnostics.push(Diagnostic::new(Code::E0201, Span::new(file, i * 1500, i * 1500 + 2), "m"));
        }
        let text = human(&sources, &diagnostics, false);
        assert!(text.contains("long.gct:1:2998501\n"), "the last column is right");
        assert!(text.len() < 2_000 * 400);
    }

    #[test]
    fn nothing_from_a_text_reaches_the_terminal_as_a_command() {
        check(
            "\u{1b}[31m \u{202e}a\u{200b}\r b",
            |file| Diagnostic::new(Code::E0101, Span::new(file, 0, 1), "unexpected `\u{1b}`\n\tx").note("a\u{7}\nb"),
            expect![[r#"
                error[E0101]: unexpected `␛`  x
                  ┌─ filling.gct:1:1
                  │
                1 │ ␛[31m �a�␍ b
                  │ ^
                  │
                  = note: a␇
                    b

            "#]],
        );
    }

    #[test]
    fn a_message_with_very_many_places_shows_the_first() {
        let text = "a\n".repeat(30);
        let shown = show(&text, |file| {
            (1..20).fold(Diagnostic::new(Code::E0411, Span::new(file, 0, 1), "m"), |d, i| {
                d.also(Span::new(file, 2 * i, 2 * i + 1), "")
            })
        });
        assert!(shown.contains("= note: and 11 more places"), "{shown}");
        assert!(!shown.contains("20 │"), "{shown}");
    }

    #[test]
    fn places_in_two_texts_are_shown_each_under_its_name() {
        let mut sources = SourceMap::new();
        let chart = sources.add("a.gct", "input x : bool");
        let trace = sources.add("in.csv", "t_ms,y");
        let mut diagnostics = Diagnostics::new();
        diagnostics.push(
            Diagnostic::new(Code::E0602, Span::new(trace, 5, 6), "no input `y`")
                .also(Span::new(chart, 6, 7), "the only input"),
        );
        expect![[r#"
            error[E0602]: no input `y`
              ┌─ in.csv:1:6
              │
            1 │ t_ms,y
              │      ^
              │
              ┌─ a.gct:1:7
              │
            1 │ input x : bool
              │       - the only input

        "#]]
        .assert_eq(&human(&sources, &diagnostics, false));
    }

    #[test]
    fn colour_only_if_asked_for() {
        let mut sources = SourceMap::new();
        let file = sources.add("a.gct", "a");
        let mut diagnostics = Diagnostics::new();
        diagnostics.push(Diagnostic::new(Code::E0201, Span::new(file, 0, 1), "m"));
        assert!(human(&sources, &diagnostics, true).contains('\u{1b}'));
        assert!(!human(&sources, &diagnostics, false).contains('\u{1b}'));
    }
}
