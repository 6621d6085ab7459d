//! Charts in which everything was tried, once for all who hold something against it.

use grafc_model::chart::Chart;
use grafc_model::reaction::{Evolution, Profile};
use grafc_testsuite::charts::{cases, charts_folder, check, vectors_folder};
use grafc_testsuite::enumeration::{Enumerated, Everywhere, enumerate, is_plain};
use grafc_testsuite::random::{ChartKind, checked};
use grafc_testsuite::share::is_thorough;
use std::sync::LazyLock;

/// Charts with more states are left out.
const STATES: usize = 300;
const INPUTS: usize = 5;

/// Charts that are known to have more: finding it out takes longer than all others together.
const TOO_MANY: [&str; 5] = ["3d", "6j", "7b", "activation_links_41", "figure_3"];

/// A chart and what was found.
pub struct Tried {
    pub name: String,
    pub text: String,
    pub chart: Chart,
    pub profile: Profile,
    pub found: Enumerated,
    pub everywhere: Everywhere,
}

impl Tried {
    fn new(name: String, text: String, chart: Chart, profile: Profile) -> Option<Tried> {
        let (found, everywhere) = enumerate(&chart, profile, STATES)?;
        Some(Tried { name, text, chart, profile, found, everywhere })
    }
}

/// The charts and vectors in which everything can be tried.
pub fn charts_and_vectors() -> &'static [Tried] {
    static ALL: LazyLock<Vec<Tried>> = LazyLock::new(|| {
        let all = [charts_folder(), vectors_folder()].into_iter().flat_map(|folder| cases(&folder));
        let tried = all.filter_map(|case| {
            let chart = check(&case.name, &case.text).expect("a chart without errors");
            let is_too_large = TOO_MANY.contains(&case.name.as_str());
            if !is_plain(&chart, INPUTS) || is_too_large && !is_thorough() {
                return None;
            }
            let tried = Tried::new(case.name, case.text, chart, case.profile);
            assert!(!is_too_large || tried.is_none(), "a chart that can be tried");
            tried
        });
        tried.collect()
    });
    &ALL
}

/// Random Boolean charts, in both evolutions.
pub fn random() -> &'static [Tried] {
    static ALL: LazyLock<Vec<Tried>> = LazyLock::new(|| {
        let tried = (0..if cfg!(debug_assertions) { 150 } else { 2_000 }).filter_map(|seed| {
            let drawn = checked(seed, ChartKind::Boolean);
            let evolution = if seed % 4 == 0 { Evolution::Scan } else { Evolution::Stable };
            let profile = Profile { evolution, initial_actions: seed % 3 != 0, ..Profile::default() };
            Tried::new(format!("seed {seed}"), drawn.text, drawn.chart, profile)
        });
        tried.collect()
    });
    &ALL
}
