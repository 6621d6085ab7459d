//! The rules.

use super::flat::{Area, Flat, Line, Owner};
use grafc_layout::{Bounds, Point};
use grafc_model::chart::Tables;
use std::collections::BTreeMap;

/// Each step, transition, action and order is drawn once, with its name.
pub fn each_symbol_once(chart: &Tables, sheets: &[Flat]) -> Vec<String> {
    let mut found: BTreeMap<(&str, String), i32> = BTreeMap::new();
    let steps = chart.steps.iter().map(|step| &step.label).chain(chart.macro_steps.iter().map(|of| &of.label));
    for label in steps {
        *found.entry(("step", label.to_string())).or_default() -= 1;
    }
    for (id, transition) in chart.transitions.iter_enumerated() {
        let name = transition.designation.as_ref().map_or_else(|| format!("#{}", id.index() + 1), ToString::to_string);
        *found.entry(("transition", name)).or_default() -= 1;
    }
    *found.entry(("action", String::new())).or_default() -= (chart.continuous.len() + chart.stored.len()) as i32;
    let orders = chart.orders.len() + chart.pulses.len() + chart.runs.len();
    *found.entry(("order", String::new())).or_default() -= orders as i32;
    for place in 0..chart.claims.list.len() {
        *found.entry(("claim", place.to_string())).or_default() -= 1;
    }
    for owner in sheets.iter().flat_map(|sheet| &sheet.owners) {
        let named = [("step", "data-step"), ("transition", "data-transition"), ("claim", "data-claim")];
        for (class, data) in named.into_iter().chain([("action", ""), ("order", "")]) {
            if owner.is(class) {
                let name = owner.get(data).unwrap_or_default().to_string();
                *found.entry((class, name)).or_default() += 1;
            }
        }
    }
    let wrong = found.into_iter().filter(|(_, count)| *count != 0);
    wrong.map(|((class, name), count)| format!("{class} `{name}` is there {count} times too often")).collect()
}

/// What must hold of one sheet.
pub fn geometry(flat: &Flat) -> Vec<String> {
    let mut found = Vec::new();
    let name = |owner: usize| describe(&flat.owners[owner]);
    for area in flat.boxes.iter().chain(&flat.texts).chain(&flat.frames) {
        if !contains(flat.bounds, area.bounds) {
            found.push(format!("{} lies outside of the sheet", what(area, &name)));
        }
    }
    for line in &flat.links {
        for point in [line.from, line.to] {
            if !contains(flat.bounds, Bounds { left: point.x, top: point.y, right: point.x, bottom: point.y }) {
                found.push(format!("a line of {} leaves the sheet", name(line.owner)));
            }
        }
        if line.from.x != line.to.x && line.from.y != line.to.y {
            found.push(format!("a line of {} is oblique", name(line.owner)));
        }
    }
    let areas: Vec<&Area> = flat.boxes.iter().chain(&flat.texts).collect();
    let bounds: Vec<Bounds> = areas.iter().map(|area| area.bounds).collect();
    for (a, b) in meeting(&bounds, &bounds) {
        let (one, other) = (areas[a], areas[b]);
        // What belongs together may lie within each other: a label in its step, an inner square in an outer one.
        let nested = one.owner == other.owner || flat.root[one.owner] == flat.root[other.owner];
        let both_texts = one.text.is_some() && other.text.is_some();
        let inside = contains(one.bounds, other.bounds) || contains(other.bounds, one.bounds);
        if a < b && (both_texts || !nested || !inside) {
            found.push(format!("{} overlaps {}", what(one, &name), what(other, &name)));
        }
    }
    let thin: Vec<Bounds> = flat.links.iter().map(|line| thin(*line)).collect();
    for (line, area) in meeting(&thin, &bounds) {
        let (owner, area) = (flat.links[line].owner, areas[area]);
        if flat.root[area.owner] != flat.root[owner] {
            found.push(format!("a line of {} runs through {}", name(owner), what(area, &name)));
        }
    }
    // A frame holds something whole, or nothing of it.
    let frames: Vec<Bounds> = flat.frames.iter().map(|area| area.bounds).collect();
    for (frame, area) in meeting(&frames, &bounds) {
        if !contains(frames[frame], bounds[area]) {
            found.push(format!("{} cuts {}", what(&flat.frames[frame], &name), what(areas[area], &name)));
        }
    }
    for (frame, line) in meeting(&frames, &thin) {
        if !contains(frames[frame], thin[line]) {
            let owner = flat.links[line].owner;
            found.push(format!("a line of {} crosses {}", name(owner), what(&flat.frames[frame], &name)));
        }
    }
    for (one, other) in meeting(&frames, &frames) {
        if one < other && !contains(frames[one], frames[other]) && !contains(frames[other], frames[one]) {
            found.push(format!("{} cuts {}", what(&flat.frames[one], &name), what(&flat.frames[other], &name)));
        }
    }
    found.extend(loose_ends(flat, &name));
    found.extend(through_double_lines(flat, &name));
    found.extend(crosses_that_join(flat, &name));
    found.extend(crossings(flat, &name));
    found
}

/// Each line ends at a box, at a label or at another line.
fn loose_ends(flat: &Flat, name: &dyn Fn(usize) -> String) -> Vec<String> {
    let around = |at: Point| Bounds { left: at.x - 1, top: at.y - 1, right: at.x + 1, bottom: at.y + 1 };
    let ends: Vec<Bounds> = flat.ends.iter().map(|(_, at)| around(*at)).collect();
    let boxes = flat.boxes.iter().map(|area| (None, area.bounds));
    let labels = flat.labels.iter().map(|bounds| (None, *bounds));
    let lines = flat.links.iter().map(|line| (Some(line.owner), wide(*line)));
    let (owners, targets): (Vec<Option<usize>>, Vec<Bounds>) = boxes.chain(labels).chain(lines).unzip();
    let mut held = vec![false; ends.len()];
    for (end, target) in meeting(&ends, &targets) {
        held[end] |= owners[target] != Some(flat.ends[end].0);
    }
    let loose = flat.ends.iter().zip(held).filter(|(_, held)| !held);
    loose.map(|((owner, at), _)| format!("{} ends in nothing at {} {}", name(*owner), at.x, at.y)).collect()
}

/// No link runs through a double line: it would look like one that is joined there.
fn through_double_lines(flat: &Flat, name: &dyn Fn(usize) -> String) -> Vec<String> {
    let is_sync = |line: &&Line| flat.owners[line.owner].is("sync");
    let double: Vec<Line> =
        flat.links.iter().filter(is_sync).filter(|line| line.from.y == line.to.y).copied().collect();
    let downwards: Vec<Line> = flat.links.iter().filter(|line| line.from.x == line.to.x).copied().collect();
    let bounds = |lines: &[Line]| lines.iter().map(|line| wide(*line)).collect::<Vec<Bounds>>();
    let mut found = Vec::new();
    for (a, b) in meeting(&bounds(&double), &bounds(&downwards)) {
        let (line, link) = (double[a], downwards[b]);
        let (top, bottom) = (link.from.y.min(link.to.y), link.from.y.max(link.to.y));
        if top < line.from.y - 1 && bottom > line.from.y + 1 {
            found.push(format!("{} runs through the double line of {}", name(link.owner), name(line.owner)));
        }
    }
    found
}

/// Links that join do not meet from all four sides, which is how a crossing looks.
fn crosses_that_join(flat: &Flat, name: &dyn Fn(usize) -> String) -> Vec<String> {
    let links: Vec<Line> = flat.links.iter().filter(|line| !flat.owners[line.owner].is("sync")).copied().collect();
    let ends: Vec<(usize, Point)> =
        links.iter().flat_map(|line| [(line.owner, line.from), (line.owner, line.to)]).collect();
    let at = |point: Point| Bounds { left: point.x - 1, top: point.y - 1, right: point.x + 1, bottom: point.y + 1 };
    let points: Vec<Bounds> = ends.iter().map(|(_, point)| at(*point)).collect();
    let areas: Vec<Bounds> = links.iter().map(|line| wide(*line)).collect();
    let mut arms = vec![[false; 4]; ends.len()];
    for (end, line) in meeting(&points, &areas) {
        let (Point { x, y }, Line { from, to, .. }) = (ends[end].1, links[line]);
        let (left, right) = (from.x.min(to.x), from.x.max(to.x));
        let (top, bottom) = (from.y.min(to.y), from.y.max(to.y));
        let (is_on_row, is_on_column) = (top == y && bottom == y, left == x && right == x);
        arms[end][0] |= is_on_row && left < x && right >= x;
        arms[end][1] |= is_on_row && right > x && left <= x;
        arms[end][2] |= is_on_column && top < y && bottom >= y;
        arms[end][3] |= is_on_column && bottom > y && top <= y;
    }
    let crosses = ends.iter().zip(arms).filter(|(_, arms)| *arms == [true; 4]);
    crosses.map(|((owner, at), _)| format!("{} joins in a cross at {} {}", name(*owner), at.x, at.y)).collect()
}

/// Links cross at right angles, and touch or run along each other only where they join.
fn crossings(flat: &Flat, name: &dyn Fn(usize) -> String) -> Vec<String> {
    let mut found = Vec::new();
    let grown: Vec<Bounds> = flat.links.iter().map(|line| wide(*line)).collect();
    for (a, b) in meeting(&grown, &grown) {
        let (one, other) = (flat.links[a], flat.links[b]);
        if a >= b || one.owner == other.owner || joined(flat, &flat.owners[one.owner], &flat.owners[other.owner]) {
            continue;
        }
        let (vertical, upright) = (one.from.x == one.to.x, other.from.x == other.to.x);
        if vertical == upright {
            found.push(format!("{} and {} run along each other", name(one.owner), name(other.owner)));
        } else {
            let at = if vertical { (one.from.x, other.from.y) } else { (other.from.x, one.from.y) };
            let at = Point { x: at.0, y: at.1 };
            if touches(one, at) || touches(other, at) {
                found.push(format!("{} and {} touch and do not join", name(one.owner), name(other.owner)));
            }
        }
    }
    found
}

/// Whether two lines may join: links that one step has on one side, and those that meet a double line of their own.
/// Links that a double line joins do not meet each other before it.
fn joined(flat: &Flat, one: &Owner, other: &Owner) -> bool {
    let same = |name: &str| one.get(name).is_some() && one.get(name) == other.get(name);
    let doubled =
        |class: &str, name: &str| flat.doubled.contains(&(class, one.get(name).unwrap_or_default().to_string()));
    let side = |class: &str| one.is(class) && other.is(class);
    let at_sync = |sync: &Owner, link: &Owner| {
        let own = sync.get("data-transition");
        let from_it = sync.is("fork") && link.is("after") && link.get("data-from") == own;
        let to_it = sync.is("join") && link.is("before") && link.get("data-to") == own;
        from_it || to_it
    };
    side("before") && (same("data-from") || same("data-to") && !doubled("join", "data-to"))
        || side("after") && (same("data-to") || same("data-from") && !doubled("fork", "data-from"))
        || at_sync(one, other)
        || at_sync(other, one)
}

/// Whether a piece ends or turns at a point.
fn touches(line: Line, at: Point) -> bool {
    let near = |end: Point| (end.x - at.x).abs() <= 1 && (end.y - at.y).abs() <= 1;
    near(line.from) || near(line.to)
}

fn describe(owner: &Owner) -> String {
    let data: Vec<String> = owner.data.iter().map(|(name, value)| format!("{name}={value}")).collect();
    format!("{} {}", owner.class, data.join(" "))
}

fn what(area: &Area, name: &dyn Fn(usize) -> String) -> String {
    match &area.text {
        Some(text) => format!("the text `{text}` of {}", name(area.owner)),
        None => format!("a box of {}", name(area.owner)),
    }
}

fn contains(outer: Bounds, inner: Bounds) -> bool {
    outer.left <= inner.left && outer.top <= inner.top && outer.right >= inner.right && outer.bottom >= inner.bottom
}

/// Two areas that have more than an edge in common.
fn overlap(a: Bounds, b: Bounds) -> bool {
    a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom
}

/// A line as the area in which it must meet nothing: without its ends, since it begins and ends at boxes.
fn thin(line: Line) -> Bounds {
    let (left, right) = (line.from.x.min(line.to.x), line.from.x.max(line.to.x));
    let (top, bottom) = (line.from.y.min(line.to.y), line.from.y.max(line.to.y));
    if left == right {
        Bounds { left: left - 1, top: top + 1, right: right + 1, bottom: bottom - 1 }
    } else {
        Bounds { left: left + 1, top: top - 1, right: right - 1, bottom: bottom + 1 }
    }
}

/// A line with what must be free around it.
fn wide(line: Line) -> Bounds {
    Bounds {
        left: line.from.x.min(line.to.x) - 1,
        top: line.from.y.min(line.to.y) - 1,
        right: line.from.x.max(line.to.x) + 1,
        bottom: line.from.y.max(line.to.y) + 1,
    }
}

/// Pairs that overlap, found by stripes, so that a large sheet takes no square of its size.
fn meeting(first: &[Bounds], second: &[Bounds]) -> Vec<(usize, usize)> {
    const STRIPE: i32 = 64;
    let stripes = |bounds: Bounds| bounds.top.div_euclid(STRIPE)..=bounds.bottom.div_euclid(STRIPE);
    let mut by_stripe: BTreeMap<i32, Vec<usize>> = BTreeMap::new();
    for (place, bounds) in second.iter().enumerate() {
        stripes(*bounds).for_each(|stripe| by_stripe.entry(stripe).or_default().push(place));
    }
    let mut found = Vec::new();
    for (place, bounds) in first.iter().enumerate() {
        for stripe in stripes(*bounds) {
            for other in by_stripe.get(&stripe).into_iter().flatten() {
                // A pair is told in the first stripe that both are in.
                let first_common = bounds.top.max(second[*other].top).div_euclid(STRIPE);
                if stripe == first_common && overlap(*bounds, second[*other]) {
                    found.push((place, *other));
                }
            }
        }
    }
    found
}
