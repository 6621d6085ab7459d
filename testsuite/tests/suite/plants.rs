//! Real charts, imported: a small form of `grafc-testsuite plants`, which the ordinary run can afford.
//!
//! The charts are not ours to keep here; where they are not available, the test says so and does nothing. Tools from
//! outside that are missing are named, and left out.

use grafc_logic::Encoding;
use grafc_testsuite::executors::{all, is_here_or_skip};
use grafc_testsuite::plants::{Compilers, PRODUCTS, Plant, TURNS, Trial, Written, plants, targets};
use grafc_testsuite::share::{share, turn_of};
use grafc_testsuite::xmi::collection_or_skip;

/// Scans of each chart.
const SCANS: usize = 60;

/// From so many steps on a chart is worth the seconds that tools from outside take.
const LARGE: usize = 50;

#[test]
fn charts_of_agrafe_run_alike_everywhere() {
    let Some(collection) = collection_or_skip() else { return };
    let plants = plants(collection).expect("charts that are imported");
    assert!(plants.len() >= 15, "only {} charts", plants.len());
    let mut executors = all();
    executors.retain(|executor| !executor.name().starts_with("net") && is_here_or_skip(executor.as_ref()));
    for executor in executors {
        let small = |plant: &&Plant| executor.is_external() && plant.chart.steps.len() < LARGE;
        let asked: Vec<_> = plants.iter().filter(|plant| !small(plant)).enumerate().collect();
        let asked = if executor.is_external() { share(turn_of(executor.name()), asked) } else { asked };
        for (place, plant) in asked {
            let turn = TURNS[place % TURNS.len()];
            let result = Trial::new(plant, SCANS).run(executor.as_ref(), &[turn]);
            assert!(result.is_ok(), "{}, {}: {result:?}", plant.name, executor.name());
        }
    }
}

/// All targets in all encodings; compilers that are here take the text as it is, of each large chart in one encoding.
#[test]
fn charts_of_agrafe_are_written_for_every_target() {
    let Some(collection) = collection_or_skip() else { return };
    let plants = plants(collection).expect("charts that are imported");
    let (compilers, none) = (Compilers::find_or_skip(), Compilers::default());
    for (place, plant) in plants.iter().enumerate() {
        let turn = Encoding::ALL[place % Encoding::ALL.len()];
        let is_asked = |encoding| plant.chart.steps.len() >= LARGE && encoding == turn;
        let written = targets(plant, |encoding| if is_asked(encoding) { &compilers } else { &none })
            .unwrap_or_else(|said| panic!("{}: {said}", plant.name));
        // All texts in all encodings, of which only the drawing may be refused.
        let Written { texts, undrawn, .. } = written;
        let encodings = Encoding::ALL.len();
        assert!(undrawn <= encodings && texts + undrawn == PRODUCTS * encodings, "{}: {written:?}", plant.name);
    }
}
