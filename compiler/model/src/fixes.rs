//! What several messages offer as a change of the text.

use grafc_diagnostics::{Fix, Span};
use grafc_syntax::ast::{Step, StepMark};
use grafc_syntax::spelling::written;

/// Another name in place of one, in backquotes if it needs them.
pub fn name_instead(place: Span, name: &str) -> Fix {
    Fix::maybe(format!("write `{name}`")).replace(place, written(name))
}

/// A word before `step`.
pub fn mark(step: &Step, word: &str) -> Fix {
    let title = format!("mark step `{}` as `{word}`", step.label.text);
    Fix::maybe(title).replace(step.span.before(), format!("{word} "))
}

/// The step without a word before `step`, and the blank behind that.
pub fn without_mark(fix: Fix, step: &Step, mark: StepMark) -> Fix {
    match step.word(mark) {
        // What follows is another word, or `step`: there is something between them, and a blank is enough.
        Some(word) => fix.delete(word),
        None => fix,
    }
}

/// A unit behind a number that is to be a time.
pub fn with_unit(number: Span) -> Fix {
    Fix::maybe("give it the unit `s`").replace(number.behind(), "s")
}
