//! A text that most elements lack: an attached comment, a designation, an address.

use ecow::EcoString;
use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

/// Such a text. It takes a word, as it does where there is none, and copies share it: a chart has many elements, and
/// each stage its own table of them.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Note(Arc<EcoString>);

impl Note {
    /// The text itself.
    pub fn text(&self) -> &EcoString {
        &self.0
    }
}

impl<T: Into<EcoString>> From<T> for Note {
    fn from(text: T) -> Self {
        Note(Arc::new(text.into()))
    }
}

impl Deref for Note {
    type Target = str;

    fn deref(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl fmt::Debug for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
