//! Diagrams with their names and frames; enclosures and expansions stand in the frame of what they belong to.

use crate::diagram::{Diagram, Element, Elements, Part, Parts, diagram, moved, shelves, wide};
use crate::picture::Group;
use crate::symbols::frame::Frame;
use grafc_layout::{Bounds, Point};
use rustc_hash::FxHashMap;

/// A diagram with what stands within its frame.
pub(crate) struct Panel {
    /// One a part, each around its own origin and with its place.
    pub groups: Vec<Group>,
    pub bounds: Bounds,
}

/// From a diagram to what stands within its frame, and from one of these to the next.
const APART: i32 = 40;
/// The shape of several diagrams together.
const SHAPE: f64 = 1.4;

impl Panel {
    /// A part with everything within it, from the innermost out.
    pub(crate) fn whole(elements: &Elements<'_>, parts: &Parts, root: Part) -> Panel {
        let mut order = vec![root];
        let mut next = 0;
        while let Some(part) = order.get(next).copied() {
            order.extend(parts.within(part));
            next += 1;
        }
        let mut made: FxHashMap<Part, Panel> = FxHashMap::default();
        for &part in order.iter().rev() {
            let within: Vec<Panel> = parts.within(part).iter().filter_map(|inner| made.remove(inner)).collect();
            let diagram = diagram(elements, parts.own(part), &|_| None);
            made.insert(part, Panel::around(elements, part, diagram, within, None));
        }
        made.remove(&root).unwrap_or(Panel { groups: Vec::new(), bounds: Bounds::default() })
    }

    /// A part alone; if it is cut into pieces, with the number of this one and how many there are.
    pub(crate) fn alone(elements: &Elements<'_>, part: Part, diagram: Diagram, piece: Option<(usize, usize)>) -> Panel {
        Panel::around(elements, part, diagram, Vec::new(), piece)
    }

    fn around(
        elements: &Elements<'_>,
        part: Part,
        diagram: Diagram,
        within: Vec<Panel>,
        piece: Option<(usize, usize)>,
    ) -> Panel {
        let mut bounds = diagram.bounds;
        let sizes: Vec<Bounds> = within.iter().map(|panel| panel.bounds).collect();
        // Beside a diagram, or below one that is much wider than high.
        let is_beside = diagram.bounds.width() < 2 * diagram.bounds.height().max(400);
        let corner = if is_beside {
            Point { x: bounds.right + APART, y: bounds.top }
        } else {
            Point { x: bounds.left, y: bounds.bottom + APART }
        };
        let across = wide(&sizes, APART, SHAPE).max(if is_beside { 0 } else { bounds.width() });
        let mut inner = Vec::new();
        for (panel, place) in within.into_iter().zip(shelves(&sizes, APART, across)) {
            let by = Point { x: corner.x + place.x - panel.bounds.left, y: corner.y + place.y - panel.bounds.top };
            bounds.include(moved(panel.bounds, by));
            inner.extend(panel.groups.into_iter().map(|group| shifted(group, by)));
        }
        let (frame, data) = frame(elements, part, piece.is_some());
        let suffix = piece.map(|(number, of)| format!(" ({number} of {of})")).unwrap_or_default();
        let (shapes, bounds) = frame.around(bounds, &suffix);
        let mut group = Group::new("frame").of(data.0, data.1).about(data.2);
        group.shapes = shapes;
        group.groups = diagram.groups;
        if let Some((number, _)) = piece {
            group.data.push(("data-piece", number.to_string()));
        }
        // Outer frames first, so that inner ones lie over them.
        let mut groups = vec![group];
        groups.append(&mut inner);
        Panel { groups, bounds }
    }
}

pub(crate) fn shifted(group: Group, by: Point) -> Group {
    Group { at: Point { x: group.at.x + by.x, y: group.at.y + by.y }, ..group }
}

/// What a part is called.
pub(crate) fn name(elements: &Elements<'_>, part: Part) -> String {
    match part {
        Part::Grafcet(id) => elements.chart.grafcets[id].name.to_string(),
        Part::Expansion(id) => elements.name(Element::Macro(id)),
    }
}

/// A piece of a diagram has its name in any case.
fn frame<'a>(
    elements: &'a Elements<'_>,
    part: Part,
    is_piece: bool,
) -> (Frame<'a>, (&'static str, String, Option<&'a str>)) {
    let chart = elements.chart;
    match part {
        Part::Grafcet(id) => {
            let about = &chart.grafcets[id];
            let (name, comment) = (about.name.as_str(), about.comment.as_deref());
            let frame = match about.enclosing_step {
                Some(step) => Frame::Enclosure { step: &chart.steps[step].label, name, comment },
                // Only one that is written has a name that somebody gave to it.
                None if about.span.range().is_empty() && !is_piece => {
                    Frame::Grafcet { name: "", parent: None, comment: None }
                }
                None => {
                    let parent = about.parent.map(|parent| chart.grafcets[parent].name.as_str());
                    Frame::Grafcet { name, parent, comment }
                }
            };
            (frame, ("data-grafcet", name.to_string(), comment))
        }
        Part::Expansion(id) => {
            let about = &chart.macro_steps[id];
            // The comment of a macro-step stands beside the macro-step.
            let comment = about.expansion_comment.as_deref();
            (Frame::Expansion { name: &about.label, comment }, ("data-expansion", about.label.to_string(), comment))
        }
    }
}
