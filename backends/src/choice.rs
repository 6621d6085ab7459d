//! What targets leave to choose, as data: a command line is made of it, and a target is made of what was chosen.
//!
//! A choice is a constant beside the target that it belongs to, or in `iec` where several have it. Its values have the
//! names that the command line and the head of generated code know them by.

/// Something that one or several targets leave to choose: `--NAME VALUE`.
#[derive(Debug)]
pub struct Choice {
    /// The name, without the dashes.
    pub name: &'static str,
    /// What it was called in older versions.
    pub formerly: Option<&'static str>,
    /// What stands for the value in a text of help.
    pub placeholder: &'static str,
    /// What is chosen, in a few words.
    pub about: &'static str,
    /// What is taken if nothing is chosen, as it would be written.
    pub default: &'static str,
    /// What can be chosen.
    pub values: Values,
}

/// What can be chosen.
#[derive(Clone, Copy, Debug)]
pub enum Values {
    /// One of some names, each with what it stands for.
    Names(fn() -> Vec<(&'static str, &'static str)>),
    /// A whole number, with the least and the greatest.
    Number(u32, u32),
    /// A time between two runs of a task: whole milliseconds, at least one.
    Interval,
    /// None: it is chosen or not.
    Flag,
    /// What a file says; the target has its text.
    File,
}

/// The values of a choice that has names.
pub trait Named: Copy + Eq + 'static {
    /// All of them, in the order of a text of help.
    const ALL: &'static [Self];

    /// The name.
    fn name(self) -> &'static str;

    /// What it stands for, in a few words.
    fn about(self) -> &'static str;
}

/// The names of a type, for [`Values::Names`].
pub fn names<T: Named>() -> Vec<(&'static str, &'static str)> {
    T::ALL.iter().map(|value| (value.name(), value.about())).collect()
}

/// A value that was chosen.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Value {
    /// A name.
    Name(String),
    /// A number, or an interval in milliseconds.
    Number(u32),
    /// It is chosen.
    Set,
    /// The name of a file, without folders, and its text.
    File(String, String),
}

/// All that was chosen.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Chosen {
    list: Vec<(&'static str, Value)>,
}

impl Chosen {
    /// Nothing.
    pub fn new() -> Self {
        Self::default()
    }

    /// And this.
    pub fn with(mut self, choice: &'static Choice, value: Value) -> Self {
        self.list.push((choice.name, value));
        self
    }

    /// The names of the choices that were made.
    pub fn made(&self) -> impl Iterator<Item = &'static str> {
        self.list.iter().map(|(name, _)| *name)
    }

    /// What was chosen by name, if it is one of the values.
    pub fn named<T: Named>(&self, choice: &Choice) -> Option<T> {
        match self.value(choice)? {
            Value::Name(name) => T::ALL.iter().copied().find(|value| value.name() == name),
            Value::Number(_) | Value::Set | Value::File(..) => None,
        }
    }

    /// The number that was chosen, if it is within the bounds.
    pub fn number(&self, choice: &Choice) -> Option<u32> {
        let (least, greatest) = match choice.values {
            Values::Names(_) | Values::Flag | Values::File => return None,
            Values::Number(least, greatest) => (least, greatest),
            Values::Interval => (1, i32::MAX as u32),
        };
        match self.value(choice)? {
            Value::Number(number) => Some(*number).filter(|number| (least..=greatest).contains(number)),
            Value::Name(_) | Value::Set | Value::File(..) => None,
        }
    }

    /// Whether what has no values was chosen.
    pub fn is_set(&self, choice: &Choice) -> bool {
        self.value(choice) == Some(&Value::Set)
    }

    /// The file that was chosen: its name and its text.
    pub fn file(&self, choice: &Choice) -> Option<(&str, &str)> {
        match self.value(choice)? {
            Value::File(name, text) => Some((name, text)),
            Value::Name(_) | Value::Number(_) | Value::Set => None,
        }
    }

    fn value(&self, choice: &Choice) -> Option<&Value> {
        self.list.iter().rev().find(|(name, _)| *name == choice.name).map(|(_, value)| value)
    }
}

/// Why a target does not take what was chosen.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refusal {
    /// What is wrong.
    pub what: String,
    /// What to do.
    pub help: String,
}

impl Refusal {
    /// A refusal with what to do.
    pub(crate) fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Refusal { what: what.into(), help: help.into() }
    }
}

/// What a target is that leaves nothing to choose.
pub(crate) mod none {
    use super::{Choice, Chosen, Refusal};

    /// Nothing.
    pub(crate) const CHOICES: &[&Choice] = &[];

    /// What is usual.
    pub(crate) fn options<T: Default>(_: &Chosen) -> Result<T, Refusal> {
        Ok(T::default())
    }

    /// Nothing is said.
    pub(crate) fn spelled<T>(_: &T) -> String {
        String::new()
    }
}
