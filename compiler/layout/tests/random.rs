//! What holds of the places of every graph: nothing runs through a box or a double line, links touch only where they join,
//! and what joins does not look like a crossing.

use grafc_layout::{Bar, Graph, Kind, Layout, Node, Point, Size, Start, layout};

/// A straight piece of a link, from the smaller to the larger coordinates.
#[derive(Clone, Copy, Debug)]
struct Line {
    link: usize,
    from: Point,
    to: Point,
}

impl Line {
    fn is_upright(self) -> bool {
        self.from.x == self.to.x
    }

    fn meets(self, left: i32, top: i32, right: i32, bottom: i32) -> bool {
        self.from.x <= right && left <= self.to.x && self.from.y <= bottom && top <= self.to.y
    }
}

fn lines(made: &Layout) -> Vec<Line> {
    let labels = made.labels.iter().map(|label| (label.link, &label.route));
    let routes = made.routes.iter().enumerate().chain(labels);
    let line = |link: usize, a: Point, b: Point| Line {
        link,
        from: Point { x: a.x.min(b.x), y: a.y.min(b.y) },
        to: Point { x: a.x.max(b.x), y: a.y.max(b.y) },
    };
    routes.flat_map(|(link, route)| route.points.windows(2).map(move |pair| line(link, pair[0], pair[1]))).collect()
}

fn random(seed: u64) -> Graph {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut graph = Graph::default();
    let steps = random.usize(1..14);
    for step in 0..steps {
        let start = match step {
            0 => Start::Initial,
            _ => [Start::Plain, Start::Plain, Start::Plain, Start::Entered, Start::Initial][random.usize(0..5)],
        };
        let size = Size { left: 20, right: random.i32(20..150), above: random.i32(0..30), body: 40, below: 0 };
        graph.nodes.push(Node {
            kind: Kind::Step,
            start,
            size,
            label: Size { left: 6, right: 60, below: 19, ..Size::default() },
        });
    }
    for _ in 0..random.usize(0..16) {
        let own = graph.nodes.len();
        let size = Size { left: random.i32(12..40), right: random.i32(12..120), above: 8, body: 4, below: 8 };
        let label = Size { left: 6, right: 90, below: 19, ..Size::default() };
        graph.nodes.push(Node { kind: Kind::Transition, start: Start::Plain, size, label });
        let mut some = |most: usize| -> Vec<usize> {
            let mut found: Vec<usize> = (0..random.usize(0..=most)).map(|_| random.usize(0..steps)).collect();
            found.sort_unstable();
            found.dedup();
            found
        };
        let (before, after) = (some(3), some(3));
        graph.links.extend(before.iter().map(|step| (*step, own)).chain(after.iter().map(|step| (own, *step))));
    }
    graph
}

/// Whether two links may lie upon each other: a step joins and forks them by single lines.
fn may_join(graph: &Graph, a: usize, b: usize) -> bool {
    let ((from, to), (other_from, other_to)) = (graph.links[a], graph.links[b]);
    let is_step = |node: usize| graph.nodes[node].kind == Kind::Step;
    a == b || from == other_from && is_step(from) || to == other_to && is_step(to)
}

fn faults(graph: &Graph, made: &Layout) -> Vec<String> {
    let mut found = Vec::new();
    let lines = lines(made);
    for (node, place) in made.places.iter().enumerate() {
        let size = graph.nodes[node].size;
        let (left, right) = (place.x - size.left, place.x + size.right);
        for line in &lines {
            let (from, to) = graph.links[line.link];
            // Links end at the axis of their boxes, between the text on both sides.
            let is_own = (from == node || to == node) && line.is_upright() && line.from.x == place.x;
            let top = if is_own { place.y } else { place.y - size.above };
            let bottom = place.y + size.body + if is_own { 0 } else { size.below };
            if line.meets(left + 1, top + 1, right - 1, bottom - 1) {
                found.push(format!("{line:?} runs through box {node}"));
            }
        }
    }
    for bar in made.bars.iter().filter(|bar| bar.is_double) {
        for line in lines.iter().filter(|line| line.is_upright()) {
            let passes = line.from.y < bar.y - Bar::HALF && line.to.y > bar.y + Bar::HALF;
            if passes && line.meets(bar.left, bar.y, bar.right, bar.y) {
                found.push(format!("{line:?} runs through {bar:?}"));
            }
        }
    }
    for (number, one) in lines.iter().enumerate() {
        for other in lines[..number].iter().filter(|other| !may_join(graph, one.link, other.link)) {
            let is_near = other.meets(one.from.x - 1, one.from.y - 1, one.to.x + 1, one.to.y + 1);
            let ends_there = |a: &Line, b: &Line| {
                [a.from, a.to].iter().any(|end| b.meets(end.x - 1, end.y - 1, end.x + 1, end.y + 1))
            };
            if is_near && (one.is_upright() == other.is_upright() || ends_there(one, other) || ends_there(other, one)) {
                found.push(format!("{one:?} and {other:?} touch"));
            }
        }
    }
    for end in lines.iter().flat_map(|line| [line.from, line.to]) {
        let arm = |is_arm: &dyn Fn(&Line) -> bool| {
            lines.iter().any(|line| line.meets(end.x, end.y, end.x, end.y) && is_arm(line))
        };
        let arms = [
            arm(&|line| !line.is_upright() && line.from.x < end.x),
            arm(&|line| !line.is_upright() && line.to.x > end.x),
            arm(&|line| line.is_upright() && line.from.y < end.y),
            arm(&|line| line.is_upright() && line.to.y > end.y),
        ];
        if arms == [true; 4] {
            found.push(format!("a cross that joins at {end:?}"));
        }
    }
    found
}

#[test]
fn random_graphs_have_no_faults() {
    for seed in 0..1000 {
        let graph = random(seed);
        let found = faults(&graph, &layout(&graph));
        assert!(found.is_empty(), "{seed}: {found:#?}\n{:?}", graph.links);
    }
}

#[test]
fn faults_are_noticed() {
    let count = |change: &dyn Fn(&mut Layout)| -> usize {
        let all = (0..40).map(|seed| {
            let graph = random(seed);
            let mut made = layout(&graph);
            change(&mut made);
            faults(&graph, &made).len()
        });
        all.sum()
    };
    assert_eq!(count(&|_| ()), 0);
    assert!(count(&|made| made.places.iter_mut().for_each(|place| place.x += 25)) > 0);
    assert!(count(&|made| made.bars.iter_mut().for_each(|bar| bar.y += 20)) > 0);
    let moved = |made: &mut Layout| {
        made.routes.iter_mut().step_by(2).flat_map(|route| &mut route.points).for_each(|point| point.x += 20)
    };
    assert!(count(&moved) > 0);
}

/// Steps, the first initial ones of these, then transitions from one step to another.
fn graph(starts: &[Start], transitions: &[(usize, usize)]) -> Graph {
    let mut graph = Graph::default();
    let size = Size { left: 20, right: 20, above: 0, body: 40, below: 0 };
    graph.nodes.extend(starts.iter().map(|&start| Node { kind: Kind::Step, start, size, label: Size::default() }));
    for (from, to) in transitions {
        let own = graph.nodes.len();
        let size = Size { left: 12, right: 30, above: 8, body: 4, below: 8 };
        graph.nodes.push(Node { kind: Kind::Transition, start: Start::Plain, size, label: Size::default() });
        graph.links.extend([(*from, own), (own, *to)]);
    }
    graph
}

#[test]
fn the_main_sequence_is_straight_under_the_initial_step() {
    // Nothing leads to step 0, which leads to the initial step.
    let made = layout(&graph(&[Start::Plain, Start::Initial, Start::Plain], &[(0, 1), (1, 2), (2, 1)]));
    let x = |node: usize| made.places[node].x;
    assert_eq!([x(1), x(4), x(2), x(5)], [0; 4]);
    assert!(x(0) >= 80 && x(3) == x(0));
}

#[test]
fn links_back_to_one_step_share_the_line_that_crosses_less() {
    // 0 to 5 after each other and back to 0; from each one to 6, and from there back to 0.
    let mut transitions: Vec<(usize, usize)> = (0..5).map(|step| (step, step + 1)).collect();
    transitions.push((5, 0));
    transitions.extend((0..6).map(|step| (step, 6)));
    transitions.push((6, 0));
    let mut starts = [Start::Plain; 7];
    starts[0] = Start::Initial;
    let graph = graph(&starts, &transitions);
    let made = layout(&graph);
    let back = graph.links.iter().zip(&made.routes).filter(|((_, to), _)| *to == 0);
    let lanes: Vec<i32> = back.map(|(_, route)| route.points.iter().map(|point| point.x).min().unwrap_or(0)).collect();
    assert_eq!(lanes.len(), 2);
    assert!(lanes[0] < 0 && lanes[0] == lanes[1], "{lanes:?}");
}
