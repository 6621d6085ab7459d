//! What stands on a rung.

use ecow::EcoString;
/// Closed while its variable is true, or while it is false.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Contact {
    pub name: EcoString,
    pub negated: bool,
}

impl Contact {
    /// Closed while this one is open.
    pub fn inverse(&self) -> Contact {
        Contact { name: self.name.clone(), negated: !self.negated }
    }
}

/// What the power flows through on its way from the left.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Item {
    /// One contact.
    Contact(Contact),
    /// Branches side by side, each a series of contacts.
    Group(Vec<Vec<Contact>>),
}

/// What a coil does with its variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Storage {
    /// It is as the power is.
    Plain,
    /// True with power, otherwise as before.
    Set,
    /// False with power, otherwise as before.
    Reset,
}

/// A coil.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Coil {
    pub name: EcoString,
    pub storage: Storage,
}

/// A function or a function block.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct BlockCall {
    pub kind: &'static str,
    /// The name of a function block's instance.
    pub instance: Option<EcoString>,
    /// The input that the power goes to.
    pub power: &'static str,
    /// The other inputs, and what they are given.
    pub inputs: Vec<(&'static str, EcoString)>,
    pub outputs: Vec<(&'static str, Sink)>,
}

/// What an output of a block leads to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Sink {
    /// Nothing.
    Open,
    /// The right rail.
    Rail,
    /// A coil of this variable.
    Coil(EcoString),
    /// This variable.
    Variable(EcoString),
}

/// The right end of a rung.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum End {
    /// Coils below each other.
    Coils(Vec<Coil>),
    Block(BlockCall),
}

/// One rung.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Rung {
    /// What stands above it.
    pub comments: Vec<String>,
    /// In series.
    pub items: Vec<Item>,
    pub end: End,
}
