//! Sheets: everything on one, or on pages of a size.

use crate::diagram::{Element, Elements, Part, Parts, Where, diagram, moved, shelves, wide};
use crate::panel::{Panel, name, shifted};
use crate::picture::Picture;
use crate::symbols::title_block::{HEIGHT, TitleBlock};
use grafc_layout::{Bounds, Point};
use grafc_model::chart::{StepId, Tables};
use rustc_hash::FxHashMap;
use std::collections::VecDeque;

/// What is drawn, and on what.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Only the grafcet or expansion of this name, with what it holds.
    pub grafcet: Option<String>,
    /// The labels of the active steps.
    pub situation: Vec<String>,
    /// The size of pages; without one there is a single sheet as large as it must be.
    pub page: Option<Page>,
    /// What the title block says of the revision; on a single sheet there is a title block only for this.
    pub revision: Option<String>,
}

/// A size of paper.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Page {
    /// 210 x 297 mm, upright.
    A4,
    /// 420 x 297 mm, across.
    A3,
}

impl Page {
    /// Width and height in millimetres.
    pub fn millimetres(self) -> (i32, i32) {
        match self {
            Page::A4 => (210, 297),
            Page::A3 => (420, 297),
        }
    }
}

/// A step is a centimetre wide on paper.
const PER_MILLIMETRE: i32 = 4;
/// What stays free around a sheet, and around what is on a page.
const MARGIN: i32 = 20;
const EDGE: i32 = 40;
/// From one grafcet to the next.
const APART: i32 = 60;
/// The shape of a single sheet.
const SHAPE: f64 = 1.5;
/// What is larger than a page by no more than this is drawn smaller.
const SMALLER: f64 = 1.5;

/// Why a chart cannot be drawn as asked.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Refusal {
    /// It has no grafcet or expansion of this name.
    NoGrafcet(String),
    /// It has no step with this label.
    NoStep(String),
}

/// Draws a chart.
pub fn draw(chart: &Tables, options: &Options) -> Result<Vec<Picture>, Refusal> {
    let elements = Elements::new(chart, &situation(chart, &options.situation)?);
    let parts = Parts::new(chart);
    let roots = match &options.grafcet {
        None => parts.roots.clone(),
        Some(asked) => vec![find(chart, asked)?],
    };
    let mut sheets = match options.page {
        None => vec![single(&elements, &parts, &roots)],
        Some(page) => Pages::new(&elements, &parts, page).all(&roots),
    };
    let pages = sheets.len();
    for (number, sheet) in sheets.iter_mut().enumerate() {
        finish(chart, options, sheet, (number + 1, pages));
    }
    Ok(sheets.into_iter().map(|sheet| sheet.picture).collect())
}

fn situation(chart: &Tables, labels: &[String]) -> Result<Vec<StepId>, Refusal> {
    if labels.is_empty() {
        return Ok(Vec::new());
    }
    let known: FxHashMap<&str, StepId> =
        chart.steps.iter_enumerated().map(|(id, step)| (step.label.as_str(), id)).collect();
    let step = |label: &String| known.get(label.as_str()).copied().ok_or_else(|| Refusal::NoStep(label.clone()));
    labels.iter().map(step).collect()
}

fn find(chart: &Tables, asked: &str) -> Result<Part, Refusal> {
    let grafcet = chart.grafcets.iter_enumerated().find(|(_, grafcet)| grafcet.name == asked);
    let expansion = chart.macro_steps.iter_enumerated().find(|(_, of)| of.label == asked);
    let found = grafcet.map(|(id, _)| Part::Grafcet(id)).or(expansion.map(|(id, _)| Part::Expansion(id)));
    found.ok_or_else(|| Refusal::NoGrafcet(asked.to_string()))
}

/// A sheet without its title block.
#[derive(Default)]
struct Sheet {
    picture: Picture,
    parts: Vec<String>,
}

/// Title block, margins and texts.
fn finish(chart: &Tables, options: &Options, sheet: &mut Sheet, (page, pages): (usize, usize)) {
    let picture = &mut sheet.picture;
    picture.title = match pages {
        1 => chart.name.to_string(),
        _ => format!("{}, page {page} of {pages}", chart.name),
    };
    let about = chart.comment.as_ref().map(|comment| format!("{comment}. ")).unwrap_or_default();
    let (steps, transitions) = (chart.steps.len() + chart.macro_steps.len(), chart.transitions.len());
    let parts = sheet.parts.join(", ");
    picture.description = format!("{about}GRAFCET with {steps} steps and {transitions} transitions: {parts}");
    let block = TitleBlock { chart: &chart.name, parts, revision: options.revision.as_deref(), page, pages };
    match options.page {
        Some(_) => {
            let bounds = picture.bounds;
            let (left, top) = (bounds.left + EDGE, bounds.bottom - EDGE - HEIGHT);
            let (group, _) = block.draw(left, top, bounds.width() - 2 * EDGE);
            picture.groups.push(group);
        }
        None => {
            if options.revision.is_some() {
                let wide = picture.bounds.width();
                let (group, bounds) = block.draw(picture.bounds.left, picture.bounds.bottom + MARGIN, wide);
                picture.bounds.include(bounds);
                picture.groups.push(group);
            }
            let Bounds { left, top, right, bottom } = picture.bounds;
            picture.bounds =
                Bounds { left: left - MARGIN, top: top - MARGIN, right: right + MARGIN, bottom: bottom + MARGIN };
        }
    }
}

/// Everything on one sheet. The first grafcet keeps its origin.
fn single(elements: &Elements<'_>, parts: &Parts, roots: &[Part]) -> Sheet {
    let panels: Vec<Panel> = roots.iter().map(|root| Panel::whole(elements, parts, *root)).collect();
    let sizes: Vec<Bounds> = panels.iter().map(|panel| panel.bounds).collect();
    let mut sheet = Sheet { parts: roots.iter().map(|root| name(elements, *root)).collect(), ..Sheet::default() };
    let origin = sizes.first().copied().unwrap_or_default();
    sheet.picture.bounds = origin;
    for (panel, place) in panels.into_iter().zip(shelves(&sizes, APART, wide(&sizes, APART, SHAPE))) {
        let by = Point { x: place.x + origin.left - panel.bounds.left, y: place.y + origin.top - panel.bounds.top };
        sheet.picture.bounds.include(moved(panel.bounds, by));
        sheet.picture.groups.extend(panel.groups.into_iter().map(|group| shifted(group, by)));
    }
    sheet
}

/// Pages as they are filled.
struct Pages<'a> {
    elements: &'a Elements<'a>,
    parts: &'a Parts,
    /// What a page has room for.
    wide: i32,
    high: i32,
    done: Vec<Sheet>,
    /// What is on the page at hand, and the names of it.
    open: Vec<(Panel, String)>,
}

impl<'a> Pages<'a> {
    fn new(elements: &'a Elements<'a>, parts: &'a Parts, page: Page) -> Pages<'a> {
        let (wide, high) = page.millimetres();
        let (wide, high) = (wide * PER_MILLIMETRE - 2 * EDGE, high * PER_MILLIMETRE - 2 * EDGE - HEIGHT - MARGIN);
        Pages { elements, parts, wide, high, done: Vec::new(), open: Vec::new() }
    }

    fn all(mut self, roots: &[Part]) -> Vec<Sheet> {
        let mut queue: VecDeque<Part> = roots.iter().copied().collect();
        while let Some(part) = queue.pop_front() {
            let whole = Panel::whole(self.elements, self.parts, part);
            let title = name(self.elements, part);
            if self.is_within(whole.bounds, SMALLER) {
                self.add(whole, title);
                continue;
            }
            let within = self.parts.within(part);
            let alone = diagram(self.elements, self.parts.own(part), &|_| None);
            let places = alone.places.clone();
            let panel = Panel::alone(self.elements, part, alone, None);
            if self.is_within(panel.bounds, SMALLER) {
                self.add(panel, title);
            } else {
                self.cut(part, &places, &title);
            }
            within.iter().rev().for_each(|inner| queue.push_front(*inner));
        }
        self.flush();
        if self.done.is_empty() {
            self.close(Vec::new(), 1.0);
        }
        self.done
    }

    fn is_within(&self, bounds: Bounds, times: f64) -> bool {
        f64::from(bounds.width()) <= f64::from(self.wide) * times
            && f64::from(bounds.height()) <= f64::from(self.high) * times
    }

    /// Puts a panel on the page at hand, or on one of its own if it has to be drawn smaller.
    fn add(&mut self, panel: Panel, title: String) {
        if !self.is_within(panel.bounds, 1.0) {
            self.flush();
            self.scaled(panel, title);
            return;
        }
        let mut sizes: Vec<Bounds> = self.open.iter().map(|(panel, _)| panel.bounds).collect();
        sizes.push(panel.bounds);
        let places = shelves(&sizes, APART, self.wide);
        let bottom = places.iter().zip(&sizes).map(|(place, size)| place.y + size.height()).max().unwrap_or(0);
        if bottom > self.high {
            self.flush();
        }
        self.open.push((panel, title));
    }

    /// A page of its own.
    fn scaled(&mut self, panel: Panel, title: String) {
        let times = f64::from(panel.bounds.width()) / f64::from(self.wide);
        let times = times.max(f64::from(panel.bounds.height()) / f64::from(self.high)).max(1.0);
        self.close(vec![(panel, title)], times);
    }

    fn flush(&mut self) {
        if !self.open.is_empty() {
            let open = std::mem::take(&mut self.open);
            self.close(open, 1.0);
        }
    }

    /// Makes a page of panels; it has room for `times` as much as at full size.
    fn close(&mut self, panels: Vec<(Panel, String)>, times: f64) {
        let more = |length: i32| (f64::from(length) * times).ceil() as i32;
        let sizes: Vec<Bounds> = panels.iter().map(|(panel, _)| panel.bounds).collect();
        let places =
            shelves(&sizes, APART, more(self.wide).max(sizes.iter().map(|size| size.width()).max().unwrap_or(0)));
        let mut sheet = Sheet::default();
        sheet.picture.bounds = Bounds {
            left: 0,
            top: 0,
            right: more(self.wide + 2 * EDGE),
            bottom: more(self.high + 2 * EDGE + HEIGHT + MARGIN),
        };
        for ((panel, title), place) in panels.into_iter().zip(places) {
            let by = Point { x: EDGE + place.x - panel.bounds.left, y: EDGE + place.y - panel.bounds.top };
            sheet.picture.groups.extend(panel.groups.into_iter().map(|group| shifted(group, by)));
            if sheet.parts.last() != Some(&title) {
                sheet.parts.push(title);
            }
        }
        self.done.push(sheet);
    }

    /// A diagram in pieces, as many beside each other on a page as it has room for, with labels where links go on.
    fn cut(&mut self, part: Part, places: &[(Element, Bounds)], title: &str) {
        self.flush();
        let pieces = pieces(places, self.wide, self.high);
        let first = self.done.len() + 1;
        let (mut page, mut used) = (first, 0);
        let mut page_of_piece = Vec::with_capacity(pieces.len());
        for piece in &pieces {
            let wide = piece.wide + FOR_LABELS;
            if used > 0 && used + APART + wide > self.wide {
                (page, used) = (page + 1, 0);
            }
            used += wide + APART;
            page_of_piece.push(page);
        }
        let mut at: FxHashMap<Element, usize> = FxHashMap::default();
        for (number, piece) in pieces.iter().enumerate() {
            at.extend(piece.elements.iter().map(|element| (*element, number)));
        }
        let mut open: Vec<(Panel, String)> = Vec::new();
        for (number, piece) in pieces.iter().enumerate() {
            let here = page_of_piece[number];
            let elsewhere = |element: Element| {
                let page = page_of_piece[*at.get(&element)?];
                Some(if page == here { Where::Here } else { Where::Page(page) })
            };
            let diagram = diagram(self.elements, &piece.elements, &elsewhere);
            open.push((
                Panel::alone(self.elements, part, diagram, Some((number + 1, pieces.len()))),
                title.to_string(),
            ));
            if page_of_piece.get(number + 1) != Some(&here) {
                self.row(std::mem::take(&mut open));
            }
        }
    }

    /// A page of panels side by side, drawn smaller if they need it.
    fn row(&mut self, panels: Vec<(Panel, String)>) {
        let wide: i32 = panels.iter().map(|(panel, _)| panel.bounds.width() + APART).sum::<i32>() - APART;
        let high = panels.iter().map(|(panel, _)| panel.bounds.height()).max().unwrap_or(0);
        let times = (f64::from(wide) / f64::from(self.wide)).max(f64::from(high) / f64::from(self.high)).max(1.0);
        self.close(panels, times);
    }
}

/// What labels of interrupted links take, in both directions.
const FOR_LABELS: i32 = 80;

/// What stands together on a page.
struct Piece {
    /// In the order of the diagram.
    elements: Vec<Element>,
    wide: i32,
}

/// The elements of each page, from top to bottom, and where a page is too narrow from left to right. A new page begins
/// with steps.
fn pieces(places: &[(Element, Bounds)], wide: i32, high: i32) -> Vec<Piece> {
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by_key(|place| (places[*place].1.top, *place));
    let mut pieces: Vec<Vec<usize>> = vec![Vec::new()];
    let mut top = None;
    let mut at = 0;
    while at < order.len() {
        // A row: all that begins before its first box ends.
        let row_bottom = places[order[at]].1.bottom;
        let row: Vec<usize> =
            order[at..].iter().copied().take_while(|place| places[*place].1.top < row_bottom).collect();
        at += row.len();
        let bottom = row.iter().map(|place| places[*place].1.bottom).max().unwrap_or(0);
        let has_step = row.iter().any(|place| !places[*place].0.is_transition());
        let start = *top.get_or_insert(places[row[0]].1.top);
        // The transitions below the steps have to fit as well.
        if has_step && bottom + FOR_LABELS - start > high && pieces.last().is_some_and(|piece| !piece.is_empty()) {
            pieces.push(Vec::new());
            top = Some(places[row[0]].1.top);
        }
        if let Some(piece) = pieces.last_mut() {
            piece.extend(row);
        }
    }
    let mut out = Vec::new();
    for mut piece in pieces {
        piece.sort_by_key(|place| (places[*place].1.left, *place));
        let mut strips: Vec<Vec<usize>> = Vec::new();
        let mut start = 0;
        for place in piece {
            let bounds = places[place].1;
            match strips.last_mut() {
                Some(strip) if f64::from(bounds.right - start) <= f64::from(wide) * SMALLER => strip.push(place),
                Some(_) | None => {
                    start = bounds.left;
                    strips.push(vec![place]);
                }
            }
        }
        out.extend(strips.into_iter().map(|mut strip| {
            let left = strip.iter().map(|place| places[*place].1.left).min().unwrap_or(0);
            let right = strip.iter().map(|place| places[*place].1.right).max().unwrap_or(0);
            strip.sort_unstable();
            Piece { elements: strip.iter().map(|place| places[*place].0).collect(), wide: right - left }
        }));
    }
    out
}
