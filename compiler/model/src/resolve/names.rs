//! Names and what they stand for: found by the name, listed in the order in which they were entered.
//!
//! The table holds places in the list, not the names once more: a chart has as many names as elements.

use hashbrown::HashTable;
use hashbrown::hash_table::Entry;
use rustc_hash::FxBuildHasher;
use std::borrow::Cow;
use std::hash::BuildHasher;

/// Names, each of which stands for something.
pub struct Names<'a, T> {
    list: Vec<(&'a str, T)>,
    places: HashTable<u32>,
}

impl<'a, T: Copy> Names<'a, T> {
    /// Room for so many.
    pub fn with_capacity(count: usize) -> Self {
        Names { list: Vec::with_capacity(count), places: HashTable::with_capacity(count) }
    }

    /// What a name stands for.
    pub fn get(&self, name: &str) -> Option<T> {
        let place = self.places.find(hash(name), |place| self.list[*place as usize].0 == name)?;
        Some(self.list[*place as usize].1)
    }

    /// Enters a name, unless it is there.
    pub fn enter(&mut self, name: &'a str, meaning: T) {
        let Names { list, places } = self;
        let of = |place: &u32| list[*place as usize].0;
        if let Entry::Vacant(entry) = places.entry(hash(name), |place| of(place) == name, |place| hash(of(place))) {
            entry.insert(list.len() as u32);
            list.push((name, meaning));
        }
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &(&'a str, T)> {
        self.list.iter()
    }
}

/// The first of the names that nothing but case tells apart, each with what is known of it.
pub struct Firsts<'a, T> {
    list: Vec<(&'a str, T)>,
    places: HashTable<u32>,
}

impl<'a, T> Firsts<'a, T> {
    /// Room for so many.
    pub fn with_capacity(count: usize) -> Self {
        Firsts { list: Vec::with_capacity(count), places: HashTable::with_capacity(count) }
    }

    /// The first of those that are like a name.
    pub fn get(&self, name: &str) -> Option<&(&'a str, T)> {
        let name = folded(name);
        let place = self.places.find(hash(&name), |place| folded(self.list[*place as usize].0) == name)?;
        Some(&self.list[*place as usize])
    }

    /// Enters a name, unless one like it is there, which is given back.
    pub fn enter(&mut self, name: &'a str, known: T) -> Option<&(&'a str, T)> {
        let Firsts { list, places } = self;
        let key = folded(name);
        let of = |place: &u32| folded(list[*place as usize].0);
        match places.entry(hash(&key), |place| of(place) == key, |place| hash(&of(place))) {
            Entry::Occupied(first) => Some(&list[*first.get() as usize]),
            Entry::Vacant(entry) => {
                entry.insert(list.len() as u32);
                list.push((name, known));
                None
            }
        }
    }
}

/// A name without regard to case; most names are so already.
fn folded(name: &str) -> Cow<'_, str> {
    let is_folded = name.bytes().all(|byte| byte.is_ascii() && !byte.is_ascii_uppercase());
    if is_folded { Cow::Borrowed(name) } else { Cow::Owned(name.to_lowercase()) }
}

fn hash(name: &str) -> u64 {
    FxBuildHasher.hash_one(name)
}
