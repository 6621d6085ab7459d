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
//! | `lanes` | which channel a link takes that does not go straight down; links to one box share it |
//! | `across` | columns and lanes to coordinates |
//! | `channels` | the horizontal pieces to tracks, and rows to coordinates |
//! | `routes` | the ways of links |
//!
//! The first column stands at coordinate 0, and nothing depends on what is below it, so a step that is added moves
//! nothing above it.

mod across;
mod cells;
mod channels;
mod columns;
mod crowd;
mod graph;
mod lanes;
mod max_tree;
mod routes;
mod rows;
mod search;

pub use graph::{Bar, Bounds, Graph, Kind, Label, Layout, Node, Point, Route, Side, Size, Start};

/// From a link to any other that it does not join.
pub const SPACING: i32 = 20;

/// Finds a place for everything.
pub fn layout(graph: &Graph) -> Layout {
    let neighbours = graph.neighbours();
    let up = search::up_links(graph, &neighbours);
    let rows = rows::rows(graph, &neighbours, &up);
    let ways = crowd::ways(graph, &rows, &up);
    let cells = cells::Cells::new(graph, rows, &ways);
    let columns = columns::Columns::new(&cells);
    let lanes = lanes::Lanes::new(&cells, &columns);
    let across = across::across(&cells, &columns, &lanes);
    let down = channels::Down::new(&cells, &lanes, &across);
    routes::draw(graph, &cells, &lanes, &across, &down)
}
