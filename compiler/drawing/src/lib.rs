//! A chart drawn by the symbols of IEC 60848.
//!
//! [`draw()`] makes pictures of the tables of a chart, also of one with errors; [`svg()`] writes one. A [`Picture`] is
//! symbols with what they are of, and places in half-pixel-free units: a step is 40 wide. Where steps and transitions stand
//! is found by `grafc_layout`; this crate knows what they look like and how large they are.
//!
//! | file | what |
//! | --- | --- |
//! | `claims` | what is claimed of the chart, as a table in the margin |
//! | `colours` | colours of what has happened to elements |
//! | `font` | the widths of texts, by the font that PDF and PNG embed |
//! | `wording` | conditions and values as the standard writes them |
//! | `rich` | such texts broken into lines, and negation drawn over them |
//! | `symbols` | the symbols, one kind a file, each around its axis |
//! | `diagram` | the steps and transitions of a grafcet or expansion, with places |
//! | `panel` | diagrams with their frames, and in these the enclosures and expansions |
//! | `cut` | where a diagram is cut that is too large for a page |
//! | `pages` | panels on pages |
//! | `sheet` | one sheet, its paper and its margins |
//! | `sheets` | panels on one sheet or on pages, with a title block |
//! | `states` | graphs of states, for what is found of a chart |
//! | `svg` | the text |

mod claims;
mod colours;
mod cut;
mod diagram;
pub mod font;
mod pages;
mod panel;
mod picture;
mod rich;
mod sheet;
mod sheets;
mod states;
mod svg;
mod symbols;
mod wording;

pub use colours::{Colour, Colours, coloured};
pub use picture::{Anchor, Group, Picture, Shape, Style};
pub use sheet::Page;
pub use sheets::{Options, Refusal, draw};
pub use states::{Arc, State, states};
pub use svg::{svg, svg_in_html};
