//! Comments of the file, `<!-- … -->`, which go where their neighbours go.
//!
//! A comment in a step, a transition or a declaration, or before one, stands before it in the chart; before arcs and
//! actions there is no such thing, so it stands at the end of its grafcet.

use crate::xml::{Document, ElementId};
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashMap;

/// Where comments go.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub enum Attachment {
    /// Before everything.
    Head,
    /// Before an element that is written.
    Before(ElementId),
    /// Behind the last that is in an element.
    End(ElementId),
}

/// The comments of each place, as lines.
pub struct Comments {
    lines: FxHashMap<Attachment, Vec<String>>,
}

impl Comments {
    /// Finds a place for each comment; `is_item` tells which elements are written as items, `is_block` which have an end.
    pub fn place(
        document: &Document,
        is_item: impl Fn(ElementId) -> bool,
        is_block: impl Fn(ElementId) -> bool,
    ) -> Self {
        let mut lines: FxHashMap<Attachment, Vec<String>> = FxHashMap::default();
        let next = next_items(document, &is_item);
        for comment in &document.comments {
            let place = match comment.parent {
                None if comment.start < document.root_span().start => Attachment::Head,
                None => Attachment::End(ElementId::new(0)),
                Some(parent) => place(document, parent, comment.start, &next, (&is_item, &is_block)),
            };
            lines.entry(place).or_default().extend(spell(&comment.text));
        }
        Comments { lines }
    }

    /// The comments of a place.
    pub fn take(&mut self, place: Attachment) -> Vec<String> {
        self.lines.remove(&place).unwrap_or_default()
    }
}

/// For each element, itself or the first beside it from there on that is an item.
fn next_items(document: &Document, is_item: &impl Fn(ElementId) -> bool) -> IndexVec<ElementId, Option<ElementId>> {
    let mut next = index_vec![None; document.elements.len()];
    for element in &document.elements {
        let mut following = None;
        for &child in element.children.iter().rev() {
            following = if is_item(child) { Some(child) } else { following };
            next[child] = following;
        }
    }
    next
}

fn place(
    document: &Document,
    parent: ElementId,
    start: u32,
    next: &IndexVec<ElementId, Option<ElementId>>,
    (is_item, is_block): (&impl Fn(ElementId) -> bool, &impl Fn(ElementId) -> bool),
) -> Attachment {
    let mut at = parent;
    loop {
        if is_block(at) {
            let children = &document.elements[at].children;
            let behind = children.partition_point(|&child| document.elements[child].span.start < start);
            return match children.get(behind).and_then(|&child| next[child]) {
                Some(item) => Attachment::Before(item),
                None => Attachment::End(at),
            };
        }
        if is_item(at) {
            return Attachment::Before(at);
        }
        match document.elements[at].parent {
            Some(around) => at = around,
            None => return Attachment::End(ElementId::new(0)),
        }
    }
}

/// A comment line for each line.
fn spell(text: &str) -> impl Iterator<Item = String> {
    let clean = |c: char| if c.is_control() || matches!(c, '\u{2028}' | '\u{2029}') { ' ' } else { c };
    let lines = text.trim().lines().map(move |line| line.trim().chars().map(clean).collect::<String>());
    lines.map(|line| format!("// {line}").trim_end().to_string())
}
