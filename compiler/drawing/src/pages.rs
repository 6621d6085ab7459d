//! Pages: grafcets and expansions in order, as many on a page as it has room for. What is too large for a page is drawn
//! smaller if it misses by less than half, else it is cut, and labels say where links go on.

use crate::claims;
use crate::cut::{cut, split};
use crate::diagram::{Diagram, Element, Elements, Part, Parts, Where, diagram, shelves};
use crate::panel::{Panel, name, shifted};
use crate::picture::Picture;
use crate::sheet::{APART, EDGE, MARGIN, Page, Sheet, on_paper};
use crate::symbols::title_block::HEIGHT;
use grafc_layout::{Bounds, Point};
use rustc_hash::FxHashMap;
use std::collections::VecDeque;

/// A step is a centimetre wide on paper.
const PER_MILLIMETRE: i32 = 4;
/// What is larger than a page by no more than this is drawn smaller.
const SMALLER: f64 = 1.5;
/// So many pages back room is looked for.
const BACK: usize = 3;
/// A piece that is still too large with its labels is split again, no more often than this.
const SPLITS: usize = 6;

/// All pages.
pub(crate) fn pages(
    elements: &Elements<'_>,
    parts: &Parts,
    page: Page,
    roots: &[Part],
    with_claims: bool,
) -> Vec<Sheet> {
    let room = Room::of(page);
    let mut items = Items { elements, parts, room, items: Vec::new() };
    let mut queue: VecDeque<Part> = roots.iter().copied().collect();
    while let Some(part) = queue.pop_front() {
        let whole = Panel::whole(elements, parts, part);
        if room.holds(whole.bounds, SMALLER) {
            items.add(name(elements, part), whole);
            continue;
        }
        let alone = diagram(elements, parts.own(part), &|_| None);
        let places = alone.places.clone();
        let panel = Panel::alone(elements, part, alone, None);
        if room.holds(panel.bounds, SMALLER) {
            items.add(name(elements, part), panel);
        } else {
            items.cut(part, cut(&places, room.wide, room.high));
        }
        parts.within(part).iter().rev().for_each(|inner| queue.push_front(*inner));
    }
    if with_claims {
        let tables = claims::claims(elements.chart, room.high);
        tables.into_iter().for_each(|table| items.add(claims::NAME.to_string(), table));
    }
    items.draw()
}

/// What a page has room for.
#[derive(Clone, Copy)]
struct Room {
    wide: i32,
    high: i32,
}

impl Room {
    fn of(page: Page) -> Room {
        let (wide, high) = page.millimetres();
        Room { wide: wide * PER_MILLIMETRE - 2 * EDGE, high: high * PER_MILLIMETRE - 2 * EDGE - HEIGHT - MARGIN }
    }

    fn holds(self, bounds: Bounds, times: f64) -> bool {
        self.misses(bounds) <= times
    }

    /// How many times as large a page has to be for all of these: so many, or as little more as is needed.
    fn enough(self, sizes: &[Bounds], times: f64) -> f64 {
        let holds = |times: f64| {
            let (wide, high) = (on_paper(self.wide, times), on_paper(self.high, times));
            let bottoms =
                shelves(sizes, APART, wide).into_iter().zip(sizes).map(|(place, size)| place.y + size.height());
            bottoms.max().unwrap_or(0) <= high && sizes.iter().all(|size| size.width() <= wide)
        };
        std::iter::successors(Some(times), |times| Some(times * 1.02)).find(|times| holds(*times)).unwrap_or(times)
    }

    /// How many times a page would have to be as large as it is.
    fn misses(self, bounds: Bounds) -> f64 {
        let across = f64::from(bounds.width()) / f64::from(self.wide);
        across.max(f64::from(bounds.height()) / f64::from(self.high)).max(1.0)
    }
}

/// What stands on a page.
struct Item {
    /// What it is called among the parts of a sheet.
    title: String,
    size: Bounds,
    content: Content,
}

enum Content {
    Whole(Panel),
    /// One of so many pieces; where the links of its elements lead is known when all have their pages.
    Piece {
        part: Part,
        elements: Vec<Element>,
        number: usize,
        of: usize,
    },
}

struct Items<'a> {
    elements: &'a Elements<'a>,
    parts: &'a Parts,
    room: Room,
    items: Vec<Item>,
}

/// A page, and where the items on it stand.
struct Filled {
    items: Vec<usize>,
    sizes: Vec<Bounds>,
    times: f64,
}

impl Items<'_> {
    fn add(&mut self, title: String, panel: Panel) {
        self.items.push(Item { title, size: panel.bounds, content: Content::Whole(panel) });
    }

    /// A part in pieces, each measured with labels as long as they can become.
    fn cut(&mut self, part: Part, mut pieces: Vec<Vec<Element>>) {
        let total = self.parts.own(part).len();
        for round in 0..=SPLITS {
            let mut at: FxHashMap<Element, usize> = FxHashMap::default();
            for (number, piece) in pieces.iter().enumerate() {
                at.extend(piece.iter().map(|element| (*element, number)));
            }
            let mut next = Vec::with_capacity(pieces.len());
            let mut sizes = Vec::with_capacity(pieces.len());
            let mut is_split = false;
            for (number, piece) in pieces.into_iter().enumerate() {
                // A number of as many digits as there can be.
                let longest = if total < 1000 { 888 } else { 88_888 };
                let elsewhere = |element| at.get(&element).filter(|at| **at != number).map(|_| Where::Page(longest));
                let drawn = diagram(self.elements, &piece, &elsewhere);
                let places = drawn.places.clone();
                let size = Panel::alone(self.elements, part, drawn, Some((number + 1, total))).bounds;
                let halves = if self.room.holds(size, SMALLER) || round == SPLITS {
                    None
                } else {
                    // Where it misses most, or else where it can be.
                    let across = i64::from(size.width()) * i64::from(self.room.high);
                    let is_high = i64::from(size.height()) * i64::from(self.room.wide) > across;
                    split(&places, is_high).or_else(|| split(&places, !is_high))
                };
                is_split |= halves.is_some();
                match halves {
                    Some(halves) => next.extend(halves),
                    None => {
                        next.push(piece);
                        sizes.push(size);
                    }
                }
            }
            pieces = next;
            if !is_split {
                let of = pieces.len();
                let items = pieces.into_iter().zip(sizes).enumerate();
                self.items.extend(items.map(|(number, (elements, size))| {
                    let content = Content::Piece { part, elements, number: number + 1, of };
                    Item { title: name(self.elements, part), size, content }
                }));
                return;
            }
        }
    }

    /// Gives each item a page: the first of the last few that has room; pieces of one part go forward.
    fn fill(&self) -> Vec<Filled> {
        let mut pages: Vec<Filled> = Vec::new();
        let mut least = 0;
        for (number, item) in self.items.iter().enumerate() {
            let times = self.room.misses(item.size);
            let first = match item.content {
                Content::Piece { number: 2.., .. } => least,
                Content::Piece { .. } | Content::Whole(_) => 0,
            };
            let mut found = None;
            for (page, filled) in pages.iter().enumerate().skip(pages.len().saturating_sub(BACK).max(first)) {
                let mut sizes = filled.sizes.clone();
                sizes.push(item.size);
                let (wide, high) = (on_paper(self.room.wide, filled.times), on_paper(self.room.high, filled.times));
                let places = shelves(&sizes, APART, wide);
                let bottom = places.iter().zip(&sizes).map(|(place, size)| place.y + size.height()).max();
                // What fits at full size is not drawn smaller because of others.
                let is_alike = if times > 1.0 { times <= filled.times } else { filled.times <= 1.0 };
                if is_alike && bottom.unwrap_or(0) <= high {
                    found = Some(page);
                    break;
                }
            }
            let page = found.unwrap_or_else(|| {
                pages.push(Filled { items: Vec::new(), sizes: Vec::new(), times });
                pages.len() - 1
            });
            pages[page].items.push(number);
            pages[page].sizes.push(item.size);
            least = page;
        }
        pages
    }

    fn draw(self) -> Vec<Sheet> {
        let pages = self.fill();
        let Items { elements, room, items, .. } = self;
        let mut page_of_item = vec![0; items.len()];
        for (page, filled) in pages.iter().enumerate() {
            filled.items.iter().for_each(|item| page_of_item[*item] = page + 1);
        }
        let mut page_of: FxHashMap<Element, (usize, usize)> = FxHashMap::default();
        for (number, item) in items.iter().enumerate() {
            if let Content::Piece { elements, .. } = &item.content {
                page_of.extend(elements.iter().map(|element| (*element, (number, page_of_item[number]))));
            }
        }
        let mut items: Vec<Option<Item>> = items.into_iter().map(Some).collect();
        let mut sheets = Vec::with_capacity(pages.len());
        for (number, filled) in pages.iter().enumerate() {
            let mut panels = Vec::with_capacity(filled.items.len());
            let mut sizes = Vec::with_capacity(filled.items.len());
            for item in &filled.items {
                let Some(Item { title, content, size }) = items[*item].take() else { continue };
                let panel = match content {
                    Content::Whole(panel) => panel,
                    Content::Piece { part, elements: own, number: piece, of } => {
                        let elsewhere = |element: Element| match page_of.get(&element) {
                            Some((other, _)) if other == item => None,
                            Some((_, page)) if *page == number + 1 => Some(Where::Here),
                            Some((_, page)) => Some(Where::Page(*page)),
                            None => None,
                        };
                        let drawn: Diagram = diagram(elements, &own, &elsewhere);
                        Panel::alone(elements, part, drawn, Some((piece, of)))
                    }
                };
                // With shorter labels links may go other ways, and take more room than was measured.
                let (wide, high) = (size.width().max(panel.bounds.width()), size.height().max(panel.bounds.height()));
                sizes.push(Bounds { left: 0, top: 0, right: wide, bottom: high });
                panels.push((title, panel));
            }
            let times = room.enough(&sizes, filled.times);
            let mut sheet = empty(room, times);
            let (wide, edge) = (on_paper(room.wide, times), on_paper(EDGE, times));
            for ((title, panel), place) in panels.into_iter().zip(shelves(&sizes, APART, wide)) {
                let by = Point { x: edge + place.x - panel.bounds.left, y: edge + place.y - panel.bounds.top };
                sheet.picture.groups.extend(panel.groups.into_iter().map(|group| shifted(group, by)));
                if sheet.parts.last() != Some(&title) {
                    sheet.parts.push(title);
                }
            }
            sheets.push(sheet);
        }
        if sheets.is_empty() {
            sheets.push(empty(room, 1.0));
        }
        sheets
    }
}

/// A page with room for so many times as much as at full size.
fn empty(room: Room, times: f64) -> Sheet {
    let right = on_paper(room.wide + 2 * EDGE, times);
    let bottom = on_paper(room.high + 2 * EDGE + HEIGHT + MARGIN, times);
    let bounds = Bounds { left: 0, top: 0, right, bottom };
    Sheet { picture: Picture { bounds, ..Picture::default() }, parts: Vec::new(), times }
}
