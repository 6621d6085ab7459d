//! From steps, transitions and links to places.
//!
//! A [`Graph`] is boxes of known sizes and the links between them; [`layout()`] gives each box a place and each link a way.
//! It knows nothing of charts, texts or formats, so whatever draws can use it.
//!
//! What is drawn evolves downwards. Everything stands on a grid of rows and columns: boxes within rows, links straight down
//! the axis of a column, or else horizontal in the channel between two rows and vertical in the channel between two columns.
//! So no link meets a box, and links cross at right angles only, whatever the graph.
//!
//! The stages, one a file, each near-linear and without recursion over the graph:
//!
//! | file | what |
//! | --- | --- |
//! | `search` | which links lead up, as a walk from the initial steps meets them |
//! | `rows` | each box below all that leads to it |
//! | `crowd` | links for which there is no room become labels (symbol 12) |
//! | `cells` | the boxes with the joints that some links need |
//! | `columns` | the first branch stays under what it comes from, the others take the first column that is free in all their rows |
//! | `crossings` | what a lane would cross |
//! | `lanes` | which channel a link takes that does not go straight down; links to one box share it |
//! | `order` | stems and lanes from left to right |
//! | `ports` | where links meet a double line that is short |
//! | `across` | columns and lanes to coordinates |
//! | `channels` | the horizontal pieces to tracks, and rows to coordinates |
//! | `routes` | the ways of links |
//! | `crossed` | the double lines that a link runs through |
//!
//! A double line is as wide as what it joins. Where a link would run through it, it is drawn short: it stands right at its
//! transition, as a part of that, and links cross each other on their way there. Then places are found once more.
//!
//! The first column stands at coordinate 0, and nothing depends on what is below it, so a step that is added moves
//! nothing above it.

mod across;
mod cells;
mod channels;
mod columns;
mod crossed;
mod crossings;
mod crowd;
mod graph;
mod lanes;
mod max_tree;
mod order;
mod ports;
mod routes;
mod rows;
mod search;

pub use graph::{Bar, Bounds, Graph, Kind, Label, Layout, Node, Point, Route, Side, Size, Start};

/// From a link to any other that it does not join.
pub const SPACING: i32 = 20;

/// What changes with what it changes is done so often; then all double lines are short.
const ROUNDS: usize = 4;

/// Finds a place for everything.
pub fn layout(graph: &Graph) -> Layout {
    let neighbours = graph.neighbours();
    let mut up = search::up_links(graph, &neighbours);
    let mut rows = rows::rows(graph, &neighbours, &up);
    // A link that would lead up and ends lower than it begins closes no circle after all.
    for _ in 0..ROUNDS {
        let leads_down = |link: usize| up[link] && rows[graph.links[link].0] < rows[graph.links[link].1];
        let down: Vec<usize> = (0..graph.links.len()).filter(|link| leads_down(*link)).collect();
        if down.is_empty() {
            break;
        }
        down.iter().for_each(|link| up[*link] = false);
        rows = rows::rows(graph, &neighbours, &up);
    }
    let ways = crowd::ways(graph, &rows, &up);
    let mut cells = cells::Cells::new(graph, rows, &ways);
    let columns = columns::Columns::new(&cells);
    let lanes = lanes::Lanes::new(&cells, &columns);
    let mut rounds = 0;
    loop {
        let ports = ports::Ports::new(&cells, &columns, &lanes);
        let across = across::across(&cells, &columns, &lanes, &ports);
        let down = channels::Down::new(&cells, &lanes, &across, &ports);
        let layout = routes::draw(graph, &cells, &lanes, &across, &ports, &down);
        let mut crossed = crossed::bars(&layout);
        // A short one may push a line into another that was free: this ends, but it need not end soon.
        if !crossed.is_empty() && rounds == ROUNDS {
            crossed = layout.bars.iter().filter(|bar| bar.is_double).copied().collect();
        }
        crossed.retain(|bar| !cells.is_short(bar.node, bar.side));
        if crossed.is_empty() {
            return layout;
        }
        crossed.iter().for_each(|bar| cells.shorten(bar.node, bar.side));
        rounds += 1;
    }
}
