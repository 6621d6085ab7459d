//! A list of things with names, each found by its name in any case.

use super::{Enumeration, NamedAction, Structure, Variable};
use rustc_hash::FxHashMap;
use std::ops::Deref;

/// Something with a name.
pub trait Named {
    /// The name, as in the file.
    fn name(&self) -> &str;
}

impl Named for Variable {
    fn name(&self) -> &str {
        &self.name
    }
}

impl Named for NamedAction {
    fn name(&self) -> &str {
        &self.name
    }
}

impl Named for Enumeration {
    fn name(&self) -> &str {
        &self.name
    }
}

impl Named for Structure {
    fn name(&self) -> &str {
        &self.name
    }
}

/// Such a list, in order of the file. Of several with one name the first is found.
pub struct ByName<T> {
    list: Vec<T>,
    /// By the name in small letters.
    places: FxHashMap<String, usize>,
}

impl<T> Default for ByName<T> {
    fn default() -> Self {
        ByName { list: Vec::new(), places: FxHashMap::default() }
    }
}

impl<T> Deref for ByName<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.list
    }
}

impl<T: Named> ByName<T> {
    /// Adds one at the end.
    pub fn push(&mut self, item: T) {
        self.places.entry(item.name().to_ascii_lowercase()).or_insert(self.list.len());
        self.list.push(item);
    }

    /// The place of a name.
    pub fn place(&self, name: &str) -> Option<usize> {
        self.places.get(&name.to_ascii_lowercase()).copied()
    }

    /// What has a name.
    pub fn find(&self, name: &str) -> Option<&T> {
        self.place(name).map(|place| &self.list[place])
    }
}

impl<T: Named> Extend<T> for ByName<T> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, items: I) {
        items.into_iter().for_each(|item| self.push(item));
    }
}

impl<T: Named> FromIterator<T> for ByName<T> {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        let mut list = ByName::default();
        list.extend(items);
        list
    }
}
