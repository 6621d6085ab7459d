//! Sheets: everything on one, or on pages of a size.

use crate::claims;
use crate::diagram::{Elements, Part, Parts, moved, shelves, wide};
use crate::pages;
use crate::panel::{Panel, name, shifted};
use crate::picture::Picture;
use crate::sheet::{APART, EDGE, MARGIN, Page, Sheet, on_paper};
use crate::symbols::title_block::{HEIGHT, TitleBlock};
use grafc_layout::{Bounds, Point};
use grafc_model::chart::{StepId, Tables};
use rustc_hash::FxHashMap;

/// What is drawn, and on what.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Only the grafcet or expansion of this name, with what it holds.
    pub grafcet: Option<String>,
    /// The labels of the active steps.
    pub situation: Vec<String>,
    /// The size of pages; without one there is a single sheet as large as it must be.
    pub page: Option<Page>,
    /// What the title block says of the revision; on a single sheet there is a title block only for this.
    pub revision: Option<String>,
}

/// The shape of a single sheet.
const SHAPE: f64 = 1.5;

/// Why a chart cannot be drawn as asked.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Refusal {
    /// It has no grafcet or expansion of this name.
    NoGrafcet(String),
    /// It has no step with this label.
    NoStep(String),
}

/// Draws a chart.
pub fn draw(chart: &Tables, options: &Options) -> Result<Vec<Picture>, Refusal> {
    let elements = Elements::new(chart, &situation(chart, &options.situation)?);
    let parts = Parts::new(chart);
    let roots = match &options.grafcet {
        None => parts.roots.clone(),
        Some(asked) => vec![find(chart, asked)?],
    };
    // What is claimed is claimed of the chart as a whole.
    let with_claims = options.grafcet.is_none();
    let mut sheets = match options.page {
        None => vec![single(&elements, &parts, &roots, with_claims)],
        Some(page) => pages::pages(&elements, &parts, page, &roots, with_claims),
    };
    let pages = sheets.len();
    for (number, sheet) in sheets.iter_mut().enumerate() {
        finish(chart, options, sheet, (number + 1, pages));
    }
    Ok(sheets.into_iter().map(|sheet| sheet.picture).collect())
}

fn situation(chart: &Tables, labels: &[String]) -> Result<Vec<StepId>, Refusal> {
    if labels.is_empty() {
        return Ok(Vec::new());
    }
    let known: FxHashMap<&str, StepId> =
        chart.steps.iter_enumerated().map(|(id, step)| (step.label.as_str(), id)).collect();
    let step = |label: &String| known.get(label.as_str()).copied().ok_or_else(|| Refusal::NoStep(label.clone()));
    labels.iter().map(step).collect()
}

fn find(chart: &Tables, asked: &str) -> Result<Part, Refusal> {
    let grafcet = chart.grafcets.iter_enumerated().find(|(_, grafcet)| grafcet.name == asked);
    let expansion = chart.macro_steps.iter_enumerated().find(|(_, of)| of.label == asked);
    let found = grafcet.map(|(id, _)| Part::Grafcet(id)).or(expansion.map(|(id, _)| Part::Expansion(id)));
    found.ok_or_else(|| Refusal::NoGrafcet(asked.to_string()))
}

/// Title block, margins and texts.
fn finish(chart: &Tables, options: &Options, sheet: &mut Sheet, (page, pages): (usize, usize)) {
    let picture = &mut sheet.picture;
    picture.title = match pages {
        1 => chart.name.to_string(),
        _ => format!("{}, page {page} of {pages}", chart.name),
    };
    let about = chart.comment.as_ref().map(|comment| format!("{comment}. ")).unwrap_or_default();
    let (steps, transitions) = (chart.steps.len() + chart.macro_steps.len(), chart.transitions.len());
    let parts = sheet.parts.join(", ");
    let counted = |count: usize, one: &str| if count == 1 { format!("1 {one}") } else { format!("{count} {one}s") };
    let (steps, transitions) = (counted(steps, "step"), counted(transitions, "transition"));
    picture.description = format!("{about}GRAFCET with {steps} and {transitions}: {parts}");
    let block = TitleBlock { chart: &chart.name, parts, revision: options.revision.as_deref(), page, pages };
    match options.page {
        Some(_) => {
            let bounds = picture.bounds;
            let edge = on_paper(EDGE, sheet.times);
            let (left, top) = (bounds.left + edge, bounds.bottom - edge - on_paper(HEIGHT, sheet.times));
            let (group, _) = block.draw(left, top, bounds.width() - 2 * edge, sheet.times);
            picture.groups.push(group);
        }
        None => {
            if options.revision.is_some() {
                let wide = picture.bounds.width();
                let (group, bounds) = block.draw(picture.bounds.left, picture.bounds.bottom + MARGIN, wide, 1.0);
                picture.bounds.include(bounds);
                picture.groups.push(group);
            }
            let Bounds { left, top, right, bottom } = picture.bounds;
            picture.bounds =
                Bounds { left: left - MARGIN, top: top - MARGIN, right: right + MARGIN, bottom: bottom + MARGIN };
        }
    }
}

/// Everything on one sheet. The first grafcet keeps its origin.
fn single(elements: &Elements<'_>, parts: &Parts, roots: &[Part], with_claims: bool) -> Sheet {
    let mut panels: Vec<Panel> = roots.iter().map(|root| Panel::whole(elements, parts, *root)).collect();
    if with_claims {
        panels.extend(claims::claims(elements.chart, i32::MAX));
    }
    let sizes: Vec<Bounds> = panels.iter().map(|panel| panel.bounds).collect();
    let parts_here = roots.iter().map(|root| name(elements, *root)).collect();
    let mut sheet = Sheet { picture: Picture::default(), parts: parts_here, times: 1.0 };
    let origin = sizes.first().copied().unwrap_or_default();
    sheet.picture.bounds = origin;
    for (panel, place) in panels.into_iter().zip(shelves(&sizes, APART, wide(&sizes, APART, SHAPE))) {
        let by = Point { x: place.x + origin.left - panel.bounds.left, y: place.y + origin.top - panel.bounds.top };
        sheet.picture.bounds.include(moved(panel.bounds, by));
        sheet.picture.groups.extend(panel.groups.into_iter().map(|group| shifted(group, by)));
    }
    sheet
}
