//! Real charts, imported: a small form of `grafc-testsuite plants`, which the ordinary run can afford.
//!
//! The charts are not ours to keep here; where they are not at hand, the test says so and does nothing. Tools from outside
//! that are missing are named, and left out.

use grafc_logic::Encoding;
use grafc_testsuite::executors::{all, select};
use grafc_testsuite::plants::{PRODUCTS, Plant, TURNS, Tools, Trial, Written, plants, targets};
use grafc_testsuite::programs::or_skip;

/// Scans of each chart.
const SCANS: usize = 60;

/// From so many steps on a chart is worth the seconds that tools from outside take.
const LARGE: usize = 50;

#[test]
fn charts_of_agrafe_run_alike_everywhere() {
    let Some(plants) = or_skip(plants()) else { return };
    assert!(plants.len() >= 15, "only {} charts", plants.len());
    for executor in all() {
        if let Some(missing) = executor.missing() {
            or_skip::<()>(Err(format!("{}: {missing}", executor.name())));
        }
    }
    for executor in select("all").expect("executors").into_iter().filter(|executor| !executor.name().starts_with("net"))
    {
        let small = |plant: &&Plant| executor.is_external() && plant.chart.steps.len() < LARGE;
        for (place, plant) in plants.iter().filter(|plant| !small(plant)).enumerate() {
            let turn = TURNS[place % TURNS.len()];
            let result = Trial::new(plant, SCANS).run(executor.as_ref(), &[turn]);
            assert!(result.is_ok(), "{}, {}: {result:?}", plant.name, executor.name());
        }
    }
}

/// All targets in all encodings; compilers that are here take the text as it is.
#[test]
fn charts_of_agrafe_are_written_for_every_target() {
    let Some(plants) = or_skip(plants()) else { return };
    let (tools, missing) = Tools::find();
    for what in missing {
        or_skip::<()>(Err(what));
    }
    for plant in &plants {
        let tools = if plant.chart.steps.len() < LARGE { &Tools::default() } else { &tools };
        let written = targets(plant, tools).unwrap_or_else(|said| panic!("{}: {said}", plant.name));
        // All texts in all encodings, of which only the drawing may be refused.
        let Written { texts, undrawn, .. } = written;
        let encodings = Encoding::ALL.len();
        assert!(undrawn <= encodings && texts + undrawn == PRODUCTS * encodings, "{}: {written:?}", plant.name);
    }
}
