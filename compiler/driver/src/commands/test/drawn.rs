//! Coverage as colours in drawings.

use super::run::Loaded;
use crate::report::Failure;
use crate::stream::Stream;
use grafc::drawing::{Colour, Colours, Options, coloured, draw, svg};
use grafc::files;
use grafc_model::chart::{Node, Tables};
use grafc_testing::coverage::{Coverage, Item, Kind};
use std::path::Path;

/// Writes the drawing of one chart into a file, those of several into a folder.
pub fn write(path: &Path, charts: &[(&Loaded, Coverage)]) -> Result<(), Failure> {
    let is_folder = Stream::is_folder(path);
    if charts.len() > 1 && !is_folder {
        return Err(Failure::WrongUse(
            format!("`{}` is one file, and there are {} charts", path.display(), charts.len()),
            "name a folder: `coverage/`".to_string(),
        ));
    }
    for (loaded, coverage) in charts {
        let text = text(coverage);
        if is_folder {
            files::make_folder(path)?;
            let stem = loaded.path.file_stem().unwrap_or_default().to_string_lossy();
            files::write(&path.join(format!("{stem}.coverage.svg")), text)?;
        } else {
            files::write(path, text)?;
        }
    }
    Ok(())
}

fn text(coverage: &Coverage) -> String {
    // All of a chart can be drawn.
    let mut pictures = draw(coverage.chart(), &Options::default()).unwrap_or_default();
    let colours = colours(coverage);
    pictures.iter_mut().for_each(|picture| coloured(picture, &colours));
    pictures.iter().map(|picture| svg(picture, None)).collect()
}

fn colours(coverage: &Coverage) -> Colours {
    let mut colours = Colours::default();
    let items = coverage.items();
    let of = |kind: Kind| {
        let mut of_kind: Vec<&Item> = items.iter().filter(|item| item.kind == kind).collect();
        of_kind.sort_by_key(|item| item.number);
        of_kind
    };
    let colour = |item: &Item| match (item.count, item.is_whole()) {
        (0, _) => Colour::Never,
        (_, false) => Colour::Partly,
        (_, true) => Colour::Wholly,
    };
    let list = |kind: Kind| of(kind).into_iter().map(colour).collect::<Vec<Colour>>();
    let chart: &Tables = coverage.chart();
    let mut steps = list(Kind::Step);
    for link in of(Kind::Link).into_iter().filter(|link| link.count == 0) {
        steps[link.number] = steps[link.number].min(Colour::Partly);
    }
    let mut macro_steps = vec![(false, false); chart.macro_steps.len()];
    for (step, colour) in chart.steps.iter().zip(&steps) {
        let mut around = step.expansion_of;
        while let Some(of) = around {
            let (any, lacks) = &mut macro_steps[of.index()];
            *any |= *colour > Colour::Never;
            *lacks |= *colour < Colour::Wholly;
            around = chart.macro_steps[of].expansion_of;
        }
    }
    for (step, colour) in chart.steps.iter().zip(&steps) {
        colours.steps.insert(step.label.to_string(), *colour);
    }
    for (step, (any, lacks)) in chart.macro_steps.iter().zip(&macro_steps) {
        let colour = match (any, lacks) {
            (false, _) => Colour::Never,
            (true, true) => Colour::Partly,
            (true, false) => Colour::Wholly,
        };
        colours.steps.insert(step.label.to_string(), colour);
    }
    colours.transitions = list(Kind::Transition);
    colours.actions = list(Kind::Action);
    colours.orders = list(Kind::Order);
    // A link is taken when its transition is cleared.
    for (place, (transition, item)) in chart.transitions.iter().zip(of(Kind::Transition)).enumerate() {
        let colour = if item.count > 0 { Colour::Wholly } else { Colour::Never };
        let name = transition.designation.as_ref().map_or_else(|| format!("#{}", place + 1), |d| d.to_string());
        let name_of = |node: &Node| match *node {
            Node::Step(id) => chart.steps[id].label.to_string(),
            Node::Macro(id) => chart.macro_steps[id].label.to_string(),
        };
        for before in &transition.pre {
            colours.before.insert((name_of(before), name.clone()), colour);
        }
        for after in &transition.post {
            colours.after.insert((name.clone(), name_of(after)), colour);
        }
    }
    colours
}
