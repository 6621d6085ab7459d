//! The double lines that a link runs through: it would look like one more that is joined there.

use crate::graph::{Bar, Layout};
use std::collections::BTreeMap;

/// The bars among all that are double and crossed, by a sweep from the top.
pub(crate) fn bars(layout: &Layout) -> Vec<Bar> {
    // Upper and lower end of what goes down, by where it does.
    let mut lines: Vec<(i32, i32, i32)> = Vec::new();
    for route in layout.routes.iter().chain(layout.labels.iter().map(|label| &label.route)) {
        let pieces = route.points.windows(2).filter(|pair| pair[0].x == pair[1].x);
        lines.extend(pieces.map(|pair| (pair[0].y.min(pair[1].y), pair[0].y.max(pair[1].y), pair[0].x)));
    }
    // What is shorter runs through none.
    lines.retain(|(top, bottom, _)| bottom - top > 2 * Bar::HALF);
    lines.sort_unstable();
    let mut ends: Vec<(i32, i32)> = lines.iter().map(|(_, bottom, x)| (*bottom, *x)).collect();
    ends.sort_unstable();
    let mut double: Vec<Bar> = layout.bars.iter().filter(|bar| bar.is_double).copied().collect();
    double.sort_by_key(|bar| (bar.y, bar.left));
    let mut here: BTreeMap<i32, usize> = BTreeMap::new();
    let (mut begun, mut ended) = (0, 0);
    double.retain(|bar| {
        while let Some((_, _, x)) = lines.get(begun).filter(|(top, _, _)| *top < bar.y - Bar::HALF) {
            *here.entry(*x).or_default() += 1;
            begun += 1;
        }
        while let Some((_, x)) = ends.get(ended).filter(|(bottom, _)| *bottom <= bar.y + Bar::HALF) {
            if let Some(count) = here.get_mut(x) {
                *count -= 1;
                if *count == 0 {
                    here.remove(x);
                }
            }
            ended += 1;
        }
        here.range(bar.left..=bar.right).next().is_some()
    });
    double
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{Point, Route, Side};

    #[test]
    fn a_line_through_a_bar_is_found_and_one_that_ends_there_is_not() {
        let bar = |left: i32, y: i32| Bar { node: 0, side: Side::Over, is_double: true, left, right: left + 100, y };
        let line = |x: i32, top: i32, bottom: i32| Route {
            points: vec![Point { x, y: bottom }, Point { x, y: top }],
            arrows: Vec::new(),
        };
        let mut layout = Layout { bars: vec![bar(0, 50), bar(0, 200)], ..Layout::default() };
        layout.routes = vec![line(30, 0, 48), line(60, 52, 198), line(120, 0, 300)];
        assert_eq!(bars(&layout), []);
        layout.routes.push(line(70, 0, 100));
        assert_eq!(bars(&layout), [bar(0, 50)]);
        layout.routes.push(line(90, 100, 300));
        assert_eq!(bars(&layout), [bar(0, 50), bar(0, 200)]);
    }
}
