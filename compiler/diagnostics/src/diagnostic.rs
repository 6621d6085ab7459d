//! One message, and the list a stage returns.

use crate::{Code, Fix, Severity, Span};

/// A place and what is to be said there.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// What is to be said there; empty if the headline says it all.
    pub text: String,
}

/// One message about a text.
///
/// The headline alone must suffice: lower case, names in backquotes, what is wrong, no full stop, no blame.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    /// Stable code; decides the severity.
    pub code: Code,
    /// The headline.
    pub message: String,
    /// Where the fault is.
    pub primary: Label,
    /// Other places involved.
    pub secondary: Vec<Label>,
    /// Reasons: a clause of the standard, what was expected.
    pub notes: Vec<String>,
    /// How to correct it, only if that is sure to help.
    pub help: Option<String>,
    /// The same as changes of the text, where it is one; each is a correction by itself.
    pub fixes: Vec<Fix>,
    /// Whether it is a warning that is taken for an error.
    pub is_denied: bool,
}

impl Diagnostic {
    /// A message at a place; add to it with the other methods.
    pub fn new(code: Code, span: Span, message: impl Into<String>) -> Self {
        Diagnostic {
            code,
            message: message.into(),
            primary: Label { span, text: String::new() },
            secondary: Vec::new(),
            notes: Vec::new(),
            help: None,
            fixes: Vec::new(),
            is_denied: false,
        }
    }

    /// How bad it is: as its code says, if it has not been denied.
    pub fn severity(&self) -> Severity {
        if self.is_denied { Severity::Error } else { self.code.severity() }
    }

    /// Says something at the primary place.
    pub fn here(mut self, text: impl Into<String>) -> Self {
        self.primary.text = text.into();
        self
    }

    /// Shows another place.
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Self {
        self.secondary.push(Label { span, text: text.into() });
        self
    }

    /// Adds a reason.
    pub fn note(mut self, text: impl Into<String>) -> Self {
        self.notes.push(text.into());
        self
    }

    /// Adds a hint how to correct it.
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help = Some(text.into());
        self
    }

    /// Adds a change of the text that does what the hint says.
    pub fn fix(mut self, fix: Fix) -> Self {
        self.fixes.push(fix);
        self
    }
}

/// Why a message is not shown.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Allowed {
    /// What the text gives as the reason; none if it was allowed from outside.
    pub reason: Option<String>,
    /// The place that allows it, if the text does.
    pub span: Option<Span>,
}

/// The messages of a stage, in the order in which they were found.
///
/// Those that somebody has allowed are kept apart: only who asks for them sees them.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
    allowed: Vec<(Diagnostic, Allowed)>,
    left_out: usize,
}

impl Diagnostics {
    /// No messages.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds one message.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        self.list.push(diagnostic);
    }

    /// Adds all messages of another stage.
    pub fn append(&mut self, mut other: Diagnostics) {
        self.list.append(&mut other.list);
        self.allowed.append(&mut other.allowed);
        self.left_out += other.left_out;
    }

    /// Says that there are more errors, too many to be told.
    pub fn leave_out(&mut self, errors: usize) {
        self.left_out += errors;
    }

    /// So many errors were counted, and not told.
    pub fn left_out(&self) -> usize {
        self.left_out
    }

    /// Keeps the messages of which it is true.
    pub fn retain(&mut self, keep: impl FnMut(&Diagnostic) -> bool) {
        self.list.retain(keep);
    }

    /// Sets those messages aside that are allowed.
    pub fn set_aside(&mut self, mut allowed: impl FnMut(&Diagnostic) -> Option<Allowed>) {
        for diagnostic in std::mem::take(&mut self.list) {
            match allowed(&diagnostic) {
                Some(why) => self.allowed.push((diagnostic, why)),
                None => self.list.push(diagnostic),
            }
        }
    }

    /// The messages that are allowed, and why.
    pub fn allowed(&self) -> &[(Diagnostic, Allowed)] {
        &self.allowed
    }

    /// The messages, to be changed in place.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, Diagnostic> {
        self.list.iter_mut()
    }

    /// Whether one of the messages is an error, or taken for one.
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|d| d.severity() == Severity::Error)
    }

    /// Whether nothing was said.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The messages in the order in which they were found.
    pub fn iter(&self) -> std::slice::Iter<'_, Diagnostic> {
        self.list.iter()
    }

    /// Orders the messages by place, so that a reader can follow them down the file.
    pub fn sort_by_place(&mut self) {
        self.list.sort_by_key(|d| d.primary.span);
        self.allowed.sort_by_key(|(d, _)| d.primary.span);
    }
}

impl<'a> IntoIterator for &'a Diagnostics {
    type Item = &'a Diagnostic;
    type IntoIter = std::slice::Iter<'a, Diagnostic>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}
