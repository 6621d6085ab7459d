//! What a scan costs: one ring of steps in several spellings, each compiled by MATIEC and `gcc -O2` and timed.
//!
//! What grafc writes for the ring ([`crate::rings`]) stands beside what an engineer would write (`texts`), and each ratio
//! is one to the spelling by hand that holds the situation in the same way.
//!
//! Two figures: a scan in which nothing happens, which is nearly every scan of a plant, and one in which the active step
//! is left. Each program times itself, less the loop around the calls (`driver`); programs take turns
//! (`crate::turns`), and a figure is the median of the repetitions.

mod driver;
pub(crate) mod texts;
mod tools;

use crate::executors::matiec::Tools;
use crate::rings::Rings;
use crate::turns::{self, Sample};
use std::path::Path;
use texts::Spelling;
pub(crate) use tools::build;

/// The steps of MATIEC's own SFC that `gcc` takes a minute and more for.
const MANY_STEPS_OF_SFC: usize = 100;

/// What to measure.
pub struct Job {
    /// The steps of the ring.
    pub steps: usize,
    /// How often each program is asked.
    pub repetitions: usize,
    /// Whether MATIEC's own SFC is measured even where its compilation takes minutes.
    pub sfc: bool,
    /// More texts, each with a name: function blocks with the inputs and outputs of the ring.
    pub others: Vec<(String, String)>,
}

/// The figures of one spelling, in ns a scan.
pub struct Figures {
    /// Its name.
    pub name: String,
    /// The spelling by hand that it is compared with.
    pub against: Option<&'static str>,
    /// Nothing happens.
    pub idle: Figure,
    /// The active step is left.
    pub clearing: Figure,
}

/// One figure of a spelling.
pub struct Figure {
    /// The median.
    pub nanoseconds: f64,
    /// The median of the ratios to the spelling by hand, repetition by repetition; none for that itself.
    pub ratio: Option<f64>,
}

/// Measures one ring in all spellings. Texts, C and programs are left in the folder; what is there already and has not
/// changed is not built again.
pub fn measure(tools: &Tools, folder: &Path, job: &Job) -> Result<Vec<Figures>, String> {
    let mut spellings: Vec<Spelling> = texts::all(job.steps)?;
    spellings.retain(|spelling| {
        let sfc = !spelling.is_sfc || job.sfc || job.steps <= MANY_STEPS_OF_SFC;
        job.steps <= spelling.most_steps && sfc
    });
    spellings.extend(job.others.iter().map(|(name, text)| Spelling::other(name, text)));

    let rings = Rings::one(job.steps);
    let mut programs = Vec::new();
    for (index, spelling) in spellings.iter().enumerate() {
        let place = folder.join(format!("{}_{index}", job.steps));
        let built = build(tools, &place, &spelling.text, rings);
        programs.push(built.map_err(|said| format!("{}, {} steps: {said}", spelling.name, job.steps))?);
    }
    let samples = turns::take(&programs, job.repetitions)?;

    let figure = |index: usize, of: fn(&Sample) -> f64| {
        let against = spellings[index].against.and_then(|name| spellings.iter().position(|s| s.name == name));
        Figure {
            nanoseconds: turns::figure(&samples[index], of),
            ratio: against.map(|other| turns::ratio(&samples[index], &samples[other], of)),
        }
    };
    Ok(spellings
        .iter()
        .enumerate()
        .map(|(index, spelling)| Figures {
            name: spelling.name.clone(),
            against: spelling.against,
            idle: figure(index, |sample| sample.idle),
            clearing: figure(index, |sample| sample.clearing),
        })
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The driver itself checks that the outputs follow the inputs once around the ring and more.
    #[test]
    fn every_spelling_goes_around_the_ring() {
        let Some(tools) = Tools::find_or_skip() else { return };
        let folder = tempfile::tempdir().expect("a folder");
        let job = Job { steps: 4, repetitions: 1, sfc: false, others: Vec::new() };
        let figures = measure(&tools, folder.path(), &job).expect("all are built and run");
        assert_eq!(figures.len(), 9);
        assert_eq!(figures[0].name, texts::CASE);
        assert!(figures[0].idle.ratio.is_none());
        for figures in &figures[1..] {
            assert_eq!(figures.idle.ratio.is_none(), figures.name == texts::EQUATIONS, "{}", figures.name);
        }
    }

    #[test]
    fn a_spelling_that_stays_behind_is_refused() {
        let Some(tools) = Tools::find_or_skip() else { return };
        let folder = tempfile::tempdir().expect("a folder");
        // Step 0 is never left.
        let text = texts::case_by_hand(4).replace("IF x_0 THEN", "IF x_0 AND FALSE THEN");
        let program = build(&tools, folder.path(), &text, Rings::one(4)).expect("it is built");
        let said = turns::take(&[program], 1).expect_err("it does not go around the ring");
        assert!(said.contains("after 1 clearings"), "{said}");
    }
}
