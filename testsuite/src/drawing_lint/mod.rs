//! What must hold of every drawing, whatever the chart: each symbol is there once, nothing overlaps, no line runs through
//! a box or a text, links cross at right angles and touch only where they join, and everything lies within the sheet.
//!
//! It looks at the picture as it was made, and shares nothing with what made it.

mod flat;
mod rules;
#[cfg(test)]
mod tests;

use flat::Flat;
use grafc_drawing::Picture;
use grafc_model::chart::Tables;

/// What is wrong with the pictures of a chart, in words.
pub fn lint(chart: &Tables, pictures: &[Picture]) -> Vec<String> {
    let sheets: Vec<Flat> = pictures.iter().map(Flat::new).collect();
    let mut found = rules::each_symbol_once(chart, &sheets);
    for (number, sheet) in sheets.iter().enumerate() {
        let page = format!("sheet {}: ", number + 1);
        found.extend(rules::geometry(sheet).into_iter().map(|text| format!("{page}{text}")));
    }
    found
}
