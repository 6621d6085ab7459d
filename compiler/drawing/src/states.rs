//! A graph of states, for what is found of a chart and not the chart itself: boxes of several lines, and bars with what
//! leads from one to another. It stands like a grafcet of one step at a time.

use crate::font::{TEXT, shown, width};
use crate::picture::{Anchor, Group, Picture, Shape, Style};
use crate::rich::{ASCENT, LINE, Token};
use crate::symbols::transition::{BAR, Transition, transition};
use crate::symbols::{STEP, Symbol, label, link};
use grafc_layout::{Bounds, Graph, Kind, Node, Point, Size, Start, layout};

/// A state.
#[derive(Clone, Debug, Default)]
pub struct State {
    /// What stands in its box, a line each.
    pub lines: Vec<String>,
    /// Whether it is one of those at the start: its box is doubled.
    pub initial: bool,
    /// What it is beyond that, as a class; said under its box.
    pub mark: Option<&'static str>,
}

/// What leads from one state to another.
#[derive(Clone, Debug)]
pub struct Arc {
    /// From here.
    pub from: usize,
    /// To there.
    pub to: usize,
    /// When, in words apart from each other by blanks.
    pub when: String,
}

/// From the outline of a box to its text, and to the outline of a doubled box.
const PAD: i32 = 10;
const DOUBLE: i32 = 4;
/// Around the drawing.
const MARGIN: i32 = 20;

/// Draws states.
pub fn states(title: &str, description: &str, states: &[State], arcs: &[Arc]) -> Picture {
    let mut graph = Graph::default();
    let mut symbols: Vec<Symbol> = Vec::new();
    for (number, state) in states.iter().enumerate() {
        let symbol = vertex(number, state);
        let start = if state.initial { Start::Initial } else { Start::Plain };
        let label = label::onwards(&name(state)).size;
        graph.nodes.push(Node { kind: Kind::Step, start, size: symbol.size, label });
        symbols.push(symbol);
    }
    for (number, arc) in arcs.iter().enumerate() {
        let symbol = condition(number, arc);
        let at = graph.nodes.len();
        graph.nodes.push(Node {
            kind: Kind::Transition,
            start: Start::Plain,
            size: symbol.size,
            label: Size::default(),
        });
        graph.links.extend([(arc.from, at), (at, arc.to)]);
        symbols.push(symbol);
    }
    let placed = layout(&graph);
    let word = |node: usize| states.get(node).map_or_else(|| format!("#{}", node - states.len() + 1), name);
    let mut groups = Vec::new();
    for (route, &(from, to)) in placed.routes.iter().zip(&graph.links) {
        if !route.points.is_empty() {
            let ends = (&*word(from), &*word(to));
            groups.push(link::link("link", ends, vec![route.points.clone()], &route.arrows));
        }
    }
    for interrupted in &placed.labels {
        let (from, to) = graph.links[interrupted.link];
        let route = &interrupted.route;
        let ends = (&*word(from), &*word(to));
        let mut group = link::link("link interrupted", ends, vec![route.points.clone()], &route.arrows);
        group.groups.push(Group { at: interrupted.place, ..label::onwards(&word(to)).group });
        groups.push(group);
    }
    groups.extend(symbols.into_iter().zip(&placed.places).map(|(symbol, at)| Group { at: *at, ..symbol.group }));
    let Bounds { left, top, right, bottom } = placed.bounds;
    Picture {
        title: title.to_string(),
        description: description.to_string(),
        bounds: Bounds { left: left - MARGIN, top: top - MARGIN, right: right + MARGIN, bottom: bottom + MARGIN },
        groups,
        look: "",
    }
}

fn name(state: &State) -> String {
    state.lines.first().map(|line| shown(line)).unwrap_or_default()
}

fn vertex(number: usize, state: &State) -> Symbol {
    let mut class = "state".to_string();
    if state.initial {
        class.push_str(" initial");
    }
    if let Some(mark) = state.mark {
        class.push(' ');
        class.push_str(mark);
    }
    let mut group = Group::new(&class).of("data-state", number.to_string());
    let lines: Vec<String> = state.lines.iter().map(|line| shown(line)).collect();
    let wide = lines.iter().map(|line| width(line, TEXT)).max().unwrap_or(0);
    let half = ((wide + 1) / 2 + PAD).max(STEP / 2);
    let high = (LINE * lines.len() as i32 + 2 * PAD - (LINE - ASCENT)).max(STEP);
    group.shapes.push(Shape::rect(-half, 0, 2 * half, high, Style::Box));
    if state.initial {
        let (half, high) = (half - DOUBLE, high - 2 * DOUBLE);
        group.shapes.push(Shape::rect(-half, DOUBLE, 2 * half, high, Style::Line));
    }
    let first = (high - LINE * (lines.len() as i32 - 1) + ASCENT) / 2 - 1;
    for (place, line) in lines.into_iter().enumerate() {
        let at = (0, first + LINE * place as i32);
        group.shapes.push(Shape::text(at, Anchor::Middle, "label", TEXT, line));
    }
    let mut size = Size { left: half, right: half, above: 0, body: high, below: 0 };
    if let Some(mark) = state.mark {
        let at = (half + PAD / 2, high / 2 + ASCENT / 2);
        group.shapes.push(Shape::text(at, Anchor::Start, "comment", TEXT, mark.to_string()));
        size.right += PAD + width(mark, TEXT);
    }
    Symbol { group, size }
}

fn condition(number: usize, arc: &Arc) -> Symbol {
    // Broken before `or` and `and`.
    let words = arc
        .when
        .split(' ')
        .map(|word| Token { may_break: matches!(word, "or" | "and"), ..Token::plain(format!("{} ", shown(word))) });
    let symbol = transition(Transition {
        name: format!("#{}", number + 1),
        number,
        designation: None,
        comment: None,
        condition: words.collect(),
        blocks: Vec::new(),
    });
    debug_assert_eq!(symbol.size.body, BAR, "nothing but the bar is between links");
    Symbol { group: Group { at: Point::default(), ..symbol.group }, ..symbol }
}
