//! Where a diagram is cut that is too large for a page: between steps and the transitions above them, and beside branches.

use crate::diagram::{Element, Place};
use rustc_hash::FxHashMap;

/// What labels of interrupted links take above and below.
const FOR_LABELS: i32 = 80;

/// The elements of each piece, from top to bottom, and where a page is too narrow from left to right. A piece begins with
/// steps, and what stands straight under each other stays together.
pub(crate) fn cut(places: &[Place], wide: i32, high: i32) -> Vec<Vec<Element>> {
    let mut pieces: Vec<Vec<Place>> = Vec::new();
    let mut top = 0;
    for row in rows(places) {
        let (first, bottom) = (row[0].bounds.top, row.iter().map(|place| place.bounds.bottom).max().unwrap_or(0));
        let has_step = row.iter().any(|place| !place.element.is_transition());
        // The transitions below the steps have to fit as well.
        match pieces.last_mut() {
            Some(piece) if !has_step || bottom + FOR_LABELS - top <= high => piece.extend(row),
            Some(_) | None => {
                top = first;
                pieces.push(row);
            }
        }
    }
    let order = order(places);
    let mut out = Vec::new();
    for piece in pieces {
        let mut strips: Vec<Vec<Place>> = Vec::new();
        let mut left = 0;
        for column in columns(&piece) {
            let (first, right) = sides(&column);
            match strips.last_mut() {
                Some(strip) if right - left <= wide => strip.extend(column),
                Some(_) | None => {
                    left = first;
                    strips.push(column);
                }
            }
        }
        out.extend(strips.into_iter().map(|strip| in_order(&order, strip)));
    }
    out
}

/// A piece in two, across if it is too high, else beside each other; none if it is one row or one branch.
pub(crate) fn split(places: &[Place], is_high: bool) -> Option<[Vec<Element>; 2]> {
    let lines = if is_high { rows(places) } else { columns(places) };
    let half = if is_high { height(places) / 2 } else { width(places) / 2 };
    let start = if is_high { places.iter().map(|place| place.bounds.top).min()? } else { sides(places).0 };
    let mut halves = [Vec::new(), Vec::new()];
    for line in lines {
        let end = if is_high { line[0].bounds.top } else { sides(&line).0 };
        let may_begin = !is_high || line.iter().any(|place| !place.element.is_transition());
        let is_second = !halves[1].is_empty() || !halves[0].is_empty() && may_begin && end - start >= half;
        halves[usize::from(is_second)].extend(line);
    }
    let [first, second] = halves;
    let order = order(places);
    (!second.is_empty()).then(|| [in_order(&order, first), in_order(&order, second)])
}

/// In rows from the top: all that begins before its first box ends.
fn rows(places: &[Place]) -> Vec<Vec<Place>> {
    let mut order = places.to_vec();
    order.sort_by_key(|place| place.bounds.top);
    let mut rows: Vec<Vec<Place>> = Vec::new();
    let mut end = i32::MIN;
    for place in order {
        match rows.last_mut() {
            Some(row) if place.bounds.top < end => row.push(place),
            Some(_) | None => {
                end = place.bounds.bottom;
                rows.push(vec![place]);
            }
        }
    }
    rows
}

/// What has one axis together, from the left.
fn columns(places: &[Place]) -> Vec<Vec<Place>> {
    let mut order = places.to_vec();
    order.sort_by_key(|place| place.axis);
    let same = |a: &Place, b: &Place| a.axis == b.axis;
    order.chunk_by(same).map(<[Place]>::to_vec).collect()
}

fn sides(places: &[Place]) -> (i32, i32) {
    let left = places.iter().map(|place| place.bounds.left).min().unwrap_or(0);
    (left, places.iter().map(|place| place.bounds.right).max().unwrap_or(0))
}

fn width(places: &[Place]) -> i32 {
    let (left, right) = sides(places);
    right - left
}

fn height(places: &[Place]) -> i32 {
    let top = places.iter().map(|place| place.bounds.top).min().unwrap_or(0);
    places.iter().map(|place| place.bounds.bottom).max().unwrap_or(0) - top
}

/// The place of each element in the order of the diagram.
fn order(places: &[Place]) -> FxHashMap<Element, usize> {
    places.iter().enumerate().map(|(order, place)| (place.element, order)).collect()
}

fn in_order(order: &FxHashMap<Element, usize>, mut places: Vec<Place>) -> Vec<Element> {
    places.sort_by_key(|place| order.get(&place.element).copied());
    places.iter().map(|place| place.element).collect()
}
