//! Names and what they stand for: found by the name, listed in the order in which they were entered.
//!
//! The table holds places in the list, not the names once more: a chart has as many names as elements.

use hashbrown::HashTable;
use hashbrown::hash_table::Entry;
use rustc_hash::FxBuildHasher;
use std::borrow::Cow;
use std::hash::BuildHasher;

/// Names, each of which stands for something; with `FOLDED` those that nothing but case tells apart are one.
pub struct Names<'a, T, const FOLDED: bool = false> {
    list: Vec<(&'a str, T)>,
    places: HashTable<u32>,
}

impl<'a, T, const FOLDED: bool> Names<'a, T, FOLDED> {
    /// Room for so many.
    pub fn with_capacity(count: usize) -> Self {
        Names { list: Vec::with_capacity(count), places: HashTable::with_capacity(count) }
    }

    /// The name that was entered, and what it stands for.
    pub fn get(&self, name: &str) -> Option<&(&'a str, T)> {
        let name = key::<FOLDED>(name);
        let place = self.places.find(hash(&name), |place| key::<FOLDED>(self.list[*place as usize].0) == name)?;
        Some(&self.list[*place as usize])
    }

    /// Enters a name, unless it is there; then the first is given back.
    pub fn enter(&mut self, name: &'a str, meaning: T) -> Option<&(&'a str, T)> {
        let Names { list, places } = self;
        let wanted = key::<FOLDED>(name);
        let of = |place: &u32| key::<FOLDED>(list[*place as usize].0);
        match places.entry(hash(&wanted), |place| of(place) == wanted, |place| hash(&of(place))) {
            Entry::Occupied(first) => Some(&list[*first.get() as usize]),
            Entry::Vacant(entry) => {
                entry.insert(list.len() as u32);
                list.push((name, meaning));
                None
            }
        }
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &(&'a str, T)> {
        self.list.iter()
    }
}

/// What a name is found by. Most names are as they are without regard to case.
fn key<const FOLDED: bool>(name: &str) -> Cow<'_, str> {
    let is_folded = !FOLDED || name.bytes().all(|byte| byte.is_ascii() && !byte.is_ascii_uppercase());
    if is_folded { Cow::Borrowed(name) } else { Cow::Owned(name.to_lowercase()) }
}

fn hash(name: &str) -> u64 {
    FxBuildHasher.hash_one(name)
}
