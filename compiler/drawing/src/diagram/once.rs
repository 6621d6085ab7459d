//! What links have in common is drawn once: a line that lies on another one would look thicker.

use grafc_layout::Point;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// The pieces that have been drawn, by the line that they lie on: where each begins and ends.
#[derive(Default)]
pub(crate) struct Drawn(FxHashMap<(bool, i32), BTreeMap<i32, i32>>);

impl Drawn {
    /// What of a line is not drawn yet; it is from now on.
    pub(crate) fn rest(&mut self, line: &[Point]) -> Vec<Vec<Point>> {
        let mut rest: Vec<Vec<Point>> = Vec::new();
        for pair in line.windows(2) {
            for (from, to) in self.rest_of_piece(pair[0], pair[1]) {
                match rest.last_mut() {
                    Some(line) if line.last() == Some(&from) => line.push(to),
                    Some(_) | None => rest.push(vec![from, to]),
                }
            }
        }
        rest
    }

    /// The same for one straight piece, in its direction.
    fn rest_of_piece(&mut self, from: Point, to: Point) -> Vec<(Point, Point)> {
        let is_vertical = from.x == to.x;
        let along = |point: Point| if is_vertical { point.y } else { point.x };
        let across = if is_vertical { from.x } else { from.y };
        let at = |along: i32| if is_vertical { Point { x: across, y: along } } else { Point { x: along, y: across } };
        let (first, last) = (along(from).min(along(to)), along(from).max(along(to)));
        let drawn = self.0.entry((is_vertical, across)).or_default();
        let before = drawn.range(..first).next_back().map(|(start, end)| (*start, *end));
        let mut meeting: Vec<(i32, i32)> = before.filter(|(_, end)| *end >= first).into_iter().collect();
        meeting.extend(drawn.range(first..=last).map(|(start, end)| (*start, *end)));
        let (mut free, mut reached) = (Vec::new(), first);
        let (mut start, mut end) = (first, last);
        for (other_start, other_end) in meeting {
            drawn.remove(&other_start);
            if other_start > reached {
                free.push((reached, other_start));
            }
            reached = reached.max(other_end);
            (start, end) = (start.min(other_start), end.max(other_end));
        }
        if reached < last {
            free.push((reached, last));
        }
        drawn.insert(start, end);
        let is_forward = along(from) <= along(to);
        let mut pieces: Vec<(Point, Point)> =
            free.into_iter().map(|(a, b)| if is_forward { (at(a), at(b)) } else { (at(b), at(a)) }).collect();
        if !is_forward {
            pieces.reverse();
        }
        pieces
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(line: &[(i32, i32)]) -> Vec<Point> {
        line.iter().map(|&(x, y)| Point { x, y }).collect()
    }

    #[test]
    fn what_is_common_is_drawn_once() {
        let mut drawn = Drawn::default();
        let first = points(&[(0, 0), (0, 30)]);
        assert_eq!(drawn.rest(&first), vec![first.clone()]);
        // Down the same axis, then to the side and down.
        let second = points(&[(0, 0), (0, 10), (50, 10), (50, 30)]);
        assert_eq!(drawn.rest(&second), vec![points(&[(0, 10), (50, 10), (50, 30)])]);
        let third = points(&[(80, 40), (80, 10), (20, 10), (0, 10), (0, 40)]);
        let expected = vec![points(&[(80, 40), (80, 10), (50, 10)]), points(&[(0, 30), (0, 40)])];
        assert_eq!(drawn.rest(&third), expected);
        assert_eq!(drawn.rest(&third), Vec::<Vec<Point>>::new());
    }
}
