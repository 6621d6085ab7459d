//! A picture without its groups: boxes, texts and lines where they are.

use grafc_drawing::{Anchor, Group, Picture, Shape, Style, font};
use grafc_layout::{Bounds, Point};
use std::collections::BTreeSet;

/// What belongs together: the element, by a number, and what it is.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Owner {
    pub number: usize,
    pub class: String,
    pub data: Vec<(String, String)>,
}

impl Owner {
    pub fn is(&self, class: &str) -> bool {
        self.class.split(' ').any(|word| word == class)
    }

    pub fn get(&self, name: &str) -> Option<&str> {
        self.data.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
    }
}

/// Something that takes room.
#[derive(Clone, Debug)]
pub struct Area {
    pub owner: usize,
    pub bounds: Bounds,
    /// What it says, if it is a text.
    pub text: Option<String>,
}

/// A straight piece of a line.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    pub owner: usize,
    pub from: Point,
    pub to: Point,
}

/// Everything on a sheet.
#[derive(Default)]
pub struct Flat {
    pub bounds: Bounds,
    pub owners: Vec<Owner>,
    /// The outermost element that an owner belongs to.
    pub root: Vec<usize>,
    pub boxes: Vec<Area>,
    pub texts: Vec<Area>,
    /// The lines of links and of double lines.
    pub links: Vec<Line>,
    pub frames: Vec<Area>,
    /// The transitions with a double line, and whether that joins or forks.
    pub doubled: BTreeSet<(&'static str, String)>,
    /// The ends of the lines of links.
    pub ends: Vec<(usize, Point)>,
    /// The lines of labels, where links may end.
    pub labels: Vec<Bounds>,
}

impl Flat {
    pub fn new(picture: &Picture) -> Flat {
        let mut flat = Flat { bounds: picture.bounds, ..Flat::default() };
        for group in &picture.groups {
            flat.add(group, Point::default(), None);
        }
        flat
    }

    /// Groups are few levels deep.
    fn add(&mut self, group: &Group, around: Point, outer: Option<usize>) {
        let at = Point { x: around.x + group.at.x, y: around.y + group.at.y };
        let number = self.owners.len();
        let data = group.data.iter().map(|(name, value)| (name.to_string(), value.clone())).collect();
        let owner = Owner { number, class: group.class.clone(), data };
        let is_sync = owner.is("sync");
        let is_link = owner.is("link") || is_sync;
        let (is_frame, is_label) = (owner.is("frame"), owner.is("label"));
        for class in ["join", "fork"].into_iter().filter(|class| is_sync && owner.is(class)) {
            self.doubled.insert((class, owner.get("data-transition").unwrap_or_default().to_string()));
        }
        self.owners.push(owner);
        let root = outer.unwrap_or(number);
        self.root.push(root);
        let moved = |point: Point| Point { x: at.x + point.x, y: at.y + point.y };
        for shape in &group.shapes {
            match shape {
                Shape::Rect { bounds, style } => {
                    let (a, b) = (Point { x: bounds.left, y: bounds.top }, Point { x: bounds.right, y: bounds.bottom });
                    let area = Area { owner: number, bounds: between(moved(a), moved(b)), text: None };
                    match style {
                        Style::Frame => self.frames.push(area),
                        Style::Box | Style::Bar | Style::Line | Style::Filled => self.boxes.push(area),
                    }
                }
                Shape::Text { at, anchor, size, text, .. } => {
                    let wide = font::width(text, *size);
                    let left = match anchor {
                        Anchor::Start => at.x,
                        Anchor::Middle => at.x - wide / 2,
                        Anchor::End => at.x - wide,
                    };
                    let (top, bottom) = (at.y - size * 3 / 4, at.y + size / 4);
                    // Widths are rounded up; parts of a text stand side by side.
                    let (left, right) = (left + 1, left + wide - 1);
                    let bounds = between(moved(Point { x: left, y: top }), moved(Point { x: right, y: bottom }));
                    self.texts.push(Area { owner: number, bounds, text: Some(text.clone()) });
                }
                Shape::Path { lines, closed: false, .. } if is_link => {
                    for line in lines {
                        // A double line reaches beyond what it joins.
                        let ends = if is_sync { None } else { line.first().zip(line.last()) };
                        self.ends
                            .extend(ends.into_iter().flat_map(|(a, b)| [(number, moved(*a)), (number, moved(*b))]));
                        let pieces = line.windows(2);
                        let line = |pair: &[Point]| Line { owner: number, from: moved(pair[0]), to: moved(pair[1]) };
                        self.links.extend(pieces.map(line));
                    }
                }
                Shape::Path { lines, closed: false, .. } if is_label => {
                    for pair in lines.iter().flat_map(|line| line.windows(2)) {
                        self.labels.push(between(moved(pair[0]), moved(pair[1])));
                    }
                }
                Shape::Dot { at } => {
                    let (a, b) = (Point { x: at.x - 4, y: at.y - 4 }, Point { x: at.x + 4, y: at.y + 4 });
                    self.boxes.push(Area { owner: number, bounds: between(moved(a), moved(b)), text: None });
                }
                Shape::Path { .. } => {}
            }
        }
        let inner = if is_frame { None } else { Some(root) };
        group.groups.iter().for_each(|group| self.add(group, at, inner));
    }
}

fn between(a: Point, b: Point) -> Bounds {
    Bounds { left: a.x, top: a.y, right: b.x, bottom: b.y }
}
