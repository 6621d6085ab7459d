//! A chart to pictures.

use crate::stages;
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_drawing::{Options, Picture, Refusal};

/// A text to pictures of its chart, one a sheet; none if there is an error. What only proofs can tell is not looked for.
pub fn draw(
    file: FileId,
    text: &str,
    default_name: &str,
    options: &Options,
) -> (Option<Result<Vec<Picture>, Refusal>>, Diagnostics) {
    let mut said = Diagnostics::new();
    let tree = stages::parse(file, text, &mut said);
    let chart = stages::check(&tree, default_name, &mut said);
    (chart.map(|chart| grafc_drawing::draw(&chart, options)), said)
}
