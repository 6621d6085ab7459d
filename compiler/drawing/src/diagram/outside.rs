//! Links to what is elsewhere: those that a double line has to one page are one, and what comes to a step has a label
//! right at it.

use super::{Element, Elements};
use crate::font::shown;
use rustc_hash::FxHashMap;

/// Where an element is that is not in this diagram, if it is in another one of the same part.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) enum Where {
    /// Beside it, on the same page.
    Here,
    /// On the page of this number.
    Page(usize),
}

/// Tells where other elements are.
pub(crate) type Elsewhere<'a> = &'a dyn Fn(Element) -> Option<Where>;

impl Where {
    /// Behind the name of what is there.
    pub(crate) fn words(self) -> String {
        match self {
            Where::Here => String::new(),
            Where::Page(number) => format!(", page {number}"),
        }
    }
}

/// The ends of links that are drawn as one.
pub(crate) enum Ends {
    /// Both are here, at these nodes.
    Both(usize, usize),
    /// A transition is here, at this node; they come to it or go from it.
    OfTransition { here: usize, at: Where, comes: bool },
    /// The steps are here, and the transition elsewhere; they come from it or go to it.
    OfSteps { at: Where, comes: bool },
}

/// What is drawn as one, in order of the first link of each.
pub(crate) fn together(
    links: &[(Element, Element)],
    node: &FxHashMap<Element, usize>,
    elsewhere: Elsewhere<'_>,
) -> Vec<(Ends, Vec<(Element, Element)>)> {
    let mut found: Vec<(Ends, Vec<(Element, Element)>)> = Vec::new();
    let mut known: FxHashMap<(Element, Where, bool), usize> = FxHashMap::default();
    for &(from, to) in links {
        let (transition, at, ends, comes) = match (node.get(&from), node.get(&to)) {
            (Some(&a), Some(&b)) => {
                found.push((Ends::Both(a, b), vec![(from, to)]));
                continue;
            }
            (Some(&here), None) => match elsewhere(to) {
                Some(at) if from.is_transition() => (from, at, Ends::OfTransition { here, at, comes: false }, false),
                Some(at) => (to, at, Ends::OfSteps { at, comes: false }, false),
                None => continue,
            },
            (None, Some(&here)) => match elsewhere(from) {
                Some(at) if to.is_transition() => (to, at, Ends::OfTransition { here, at, comes: true }, true),
                Some(at) => (from, at, Ends::OfSteps { at, comes: true }, true),
                None => continue,
            },
            (None, None) => continue,
        };
        let place = *known.entry((transition, at, comes)).or_insert_with(|| {
            found.push((ends, Vec::new()));
            found.len() - 1
        });
        found[place].1.push((from, to));
    }
    found
}

/// The labels over a step.
pub(crate) struct Entry {
    pub texts: Vec<String>,
    /// Whether nothing else comes to it.
    pub is_first: bool,
}

/// For each step to which single links come from elsewhere, its labels.
pub(crate) fn entries(
    elements: &Elements<'_>,
    links: &[(Element, Element)],
    node: &FxHashMap<Element, usize>,
    elsewhere: Elsewhere<'_>,
) -> FxHashMap<Element, Entry> {
    let mut found: FxHashMap<Element, Entry> = FxHashMap::default();
    let mut by_other_ways: FxHashMap<Element, ()> = FxHashMap::default();
    for (ends, links) in together(links, node, elsewhere) {
        match (ends, links.as_slice()) {
            (Ends::OfSteps { at, comes: true }, [(from, step)]) => {
                let entry = found.entry(*step).or_insert(Entry { texts: Vec::new(), is_first: true });
                entry.texts.push(format!("from {}{}", elements.origin(*from), at.words()));
            }
            (Ends::OfSteps { comes: true, .. } | Ends::Both(..), links) => {
                by_other_ways.extend(links.iter().map(|(_, to)| (*to, ())));
            }
            (Ends::OfSteps { comes: false, .. } | Ends::OfTransition { .. }, _) => {}
        }
    }
    for (step, entry) in &mut found {
        entry.is_first = !by_other_ways.contains_key(step);
    }
    found
}

/// What a label says of where links go on, or come from, that are several: `steps 16 to 23`. What is in order is
/// told by the first and the last.
pub(crate) fn group_name(elements: &Elements<'_>, steps: &[Element]) -> String {
    if let [one] = steps {
        return elements.onwards(*one);
    }
    let names: Vec<String> = steps.iter().map(|step| shown(&elements.name(*step))).collect();
    let follows = |a: &str, b: &str| match (a.parse::<u64>(), b.parse::<u64>()) {
        (Ok(a), Ok(b)) => a.checked_add(1) == Some(b),
        (Ok(_) | Err(_), _) => false,
    };
    let mut runs: Vec<(&str, &str, usize)> = Vec::new();
    for name in &names {
        match runs.last_mut() {
            Some((_, last, count)) if follows(last, name) => (*last, *count) = (name, *count + 1),
            Some(_) | None => runs.push((name, name, 1)),
        }
    }
    let word = |(first, last, count): &(&str, &str, usize)| match count {
        1 => first.to_string(),
        2 => format!("{first}, {last}"),
        _ => format!("{first} to {last}"),
    };
    // Of many only the first ones and the last: all of them stand at the other end.
    match runs.as_slice() {
        [first, second, third, _, .., last] => {
            format!("steps {}, {}, {} … {}", word(first), word(second), word(third), word(last))
        }
        few => format!("steps {}", few.iter().map(word).collect::<Vec<_>>().join(", ")),
    }
}
