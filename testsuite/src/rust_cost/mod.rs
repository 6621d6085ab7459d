//! What a scan of generated Rust and C costs: rings of steps as grafc writes them, beside a `match` or `switch` by hand and
//! MATIEC's C.
//!
//! The chart ([`crate::rings`]), the two figures and the way they are taken are those of [`crate::scan_cost`]. Each
//! spelling is a crate of its own, so that the time that rustc takes for it can be told (`tools`), with a program
//! around it that checks and times it (`driver`), or, in C, a unit (`in_c`). The programs of all sizes take turns (`crate::turns`): ratios hold
//! between sizes as well as between spellings.

mod by_hand;
mod driver;
mod in_c;
mod tools;

use crate::charts;
use crate::executors::rust::Tools;
use crate::executors::{c, matiec};
use crate::rings::Rings;
use crate::runs::compile_saved;
use crate::scan_cost::{self, texts};
use crate::turns::{self, Sample};
use grafc_backends::rust;
use grafc_logic::scan::Program;
use grafc_logic::{Encoding, Options};
use grafc_model::reaction::{Evolution, Profile};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tools::{Built, Call};

/// The size that others are compared with: the growth of a spelling.
pub const BASE: usize = 100;

/// What to measure.
pub struct Job {
    /// The charts.
    pub rings: Vec<Rings>,
    /// What grafc is asked to write for each.
    pub encodings: Vec<Encoding>,
    /// In which profiles.
    pub evolutions: Vec<Evolution>,
    /// How often each program is asked.
    pub repetitions: usize,
    /// How long rustc may take for one crate.
    pub limit: Duration,
}

/// One spelling of one chart.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Spelling {
    ByHand(Evolution),
    Grafc(Encoding, Evolution),
    ByHandInC(Evolution),
    GrafcInC(Encoding, Evolution),
    Sfc,
}

impl Spelling {
    fn name(self) -> String {
        let (name, evolution) = match self {
            Spelling::ByHand(evolution) => ("match by hand", evolution),
            Spelling::Grafc(encoding, evolution) => (encoding.name(), evolution),
            Spelling::ByHandInC(evolution) => ("switch by hand in C", evolution),
            Spelling::GrafcInC(encoding, evolution) => (in_c::name(encoding), evolution),
            Spelling::Sfc => return "SFC of MATIEC".to_owned(),
        };
        match evolution {
            Evolution::Stable => name.to_owned(),
            Evolution::Scan => format!("{name}, scan"),
        }
    }

    /// What it is compared with: it evolves in the same way, and the SFC of MATIEC one micro-step a scan.
    fn by_hand(self) -> Option<Spelling> {
        match self {
            Spelling::ByHand(_) | Spelling::ByHandInC(_) => None,
            Spelling::GrafcInC(_, evolution) => Some(Spelling::ByHandInC(evolution)),
            Spelling::Grafc(_, evolution) => Some(Spelling::ByHand(evolution)),
            Spelling::Sfc => Some(Spelling::ByHand(Evolution::Scan)),
        }
    }
}

/// A line of the table.
#[derive(Serialize)]
pub struct Row {
    /// The chart.
    #[serde(flatten)]
    pub rings: Rings,
    /// The spelling's name.
    pub spelling: String,
    /// The figures, or why there are none.
    pub figures: Result<Figures, String>,
}

/// The figures of one spelling.
#[derive(Serialize)]
pub struct Figures {
    /// Nothing happens.
    pub idle: Figure,
    /// Each token moves.
    pub clearing: Figure,
    /// What is kept from scan to scan, outputs included.
    pub bytes: usize,
    /// Seconds of rustc; none for what it did not compile.
    pub rustc: Option<f64>,
}

/// One figure of a spelling. A ratio is none where the other program is not there.
#[derive(Serialize)]
pub struct Figure {
    /// The median.
    pub nanoseconds: f64,
    /// The ratio to the `match` by hand for the same chart and evolution; in C, to the `switch` by hand.
    pub by_hand: Option<f64>,
    /// The ratio to the same spelling with [`BASE`] steps and as many tokens.
    pub growth: Option<f64>,
    /// How many times the SFC of MATIEC takes as long.
    pub sfc: Option<f64>,
}

/// A program that was built.
struct Timed {
    rings: Rings,
    spelling: Spelling,
    program: PathBuf,
    rustc: Option<f64>,
}

/// The compilers from outside that there are, beside rustc.
#[derive(Clone, Copy, Default)]
pub struct Others<'t> {
    /// A C compiler.
    pub c: Option<&'t c::Tools>,
    /// MATIEC.
    pub matiec: Option<&'t matiec::Tools>,
}

/// Measures all charts in all spellings; with a C compiler also those in C, and with MATIEC its SFC, up to the size that its
/// tools can take.
/// `progress` is told what is done. Texts and programs are left in the folder; what is there already and has not
/// changed is not built again.
pub fn measure(
    tools: &Tools,
    others: Others,
    folder: &Path,
    job: &Job,
    progress: &dyn Fn(&str),
) -> Result<Vec<Row>, String> {
    // In the order of the table; without a program where rustc did not come to an end.
    let mut all: Vec<(Rings, Spelling, Result<usize, String>)> = Vec::new();
    let mut timed: Vec<Timed> = Vec::new();
    for &rings in &job.rings {
        for spelling in spellings(job, rings, others) {
            let Rings { steps, tokens, walked } = rings;
            let place = folder.join(format!("{steps}_{tokens}_{walked}_{}", spelling.name().replace(", ", "_")));
            let named = |said: String| format!("{}, {rings:?}: {said}", spelling.name());
            progress(&format!("building {}, {} steps, {} tokens", spelling.name(), rings.steps, rings.tokens));
            let built = build(tools, others, &place, rings, spelling, job.limit).map_err(named)?;
            let index = match built {
                Built::Program(program, rustc) => {
                    timed.push(Timed { rings, spelling, program, rustc });
                    Ok(timed.len() - 1)
                }
                Built::Without(why) => Err(why),
            };
            all.push((rings, spelling, index));
        }
    }
    progress(&format!("timing {} programs", timed.len()));
    let programs: Vec<PathBuf> = timed.iter().map(|timed| timed.program.clone()).collect();
    let samples = turns::take(&programs, job.repetitions)?;
    let row = |(rings, spelling, index): (Rings, Spelling, Result<usize, String>)| Row {
        rings,
        spelling: spelling.name(),
        figures: index.map(|index| figures(&timed, &samples, index)),
    };
    Ok(all.into_iter().map(row).collect())
}

fn spellings(job: &Job, rings: Rings, others: Others) -> Vec<Spelling> {
    let mut spellings = Vec::new();
    for &evolution in &job.evolutions {
        spellings.push(Spelling::ByHand(evolution));
        spellings.extend(job.encodings.iter().map(|encoding| Spelling::Grafc(*encoding, evolution)));
        if others.c.is_some() {
            spellings.push(Spelling::ByHandInC(evolution));
            spellings.extend(job.encodings.iter().map(|encoding| Spelling::GrafcInC(*encoding, evolution)));
        }
    }
    let sfc = others.matiec.is_some() && rings.steps <= texts::MANY_BITS && rings.walked == rings.length();
    spellings.extend(sfc.then_some(Spelling::Sfc));
    spellings
}

fn build(
    tools: &Tools,
    others: Others,
    place: &Path,
    rings: Rings,
    spelling: Spelling,
    limit: Duration,
) -> Result<Built, String> {
    let (chart, more_stack) = match spelling {
        Spelling::ByHand(evolution) => (by_hand::write(rings, evolution), true),
        Spelling::Grafc(encoding, evolution) => (by_grafc(rings, encoding, evolution)?, false),
        Spelling::ByHandInC(_) | Spelling::GrafcInC(..) => {
            let unit = match spelling {
                Spelling::GrafcInC(encoding, evolution) => in_c::by_grafc(&program(rings, encoding, evolution)?)?,
                Spelling::ByHandInC(evolution) | Spelling::ByHand(evolution) | Spelling::Grafc(_, evolution) => {
                    in_c::by_hand(rings, evolution)
                }
                Spelling::Sfc => in_c::by_hand(rings, Evolution::Scan),
            };
            return in_c::build(others.c.ok_or("no C compiler")?, place, &unit, rings, limit);
        }
        Spelling::Sfc => {
            let matiec = others.matiec.ok_or("no MATIEC")?;
            return scan_cost::build(matiec, place, &texts::sfc(rings), rings)
                .map(|program| Built::Program(program, None));
        }
    };
    tools::build(tools, place, &chart, &driver::write(rings), Call { limit, more_stack })
}

fn by_grafc(rings: Rings, encoding: Encoding, evolution: Evolution) -> Result<String, String> {
    let program = program(rings, encoding, evolution)?;
    rust::emit(&program, &rust::Options::default()).map_err(|diagnostics| format!("{diagnostics:#?}"))
}

fn program(rings: Rings, encoding: Encoding, evolution: Evolution) -> Result<Program, String> {
    let chart = charts::check("ring", &rings.chart())?;
    let profile = Profile { evolution, ..Profile::default() };
    compile_saved(&chart, &Options { profile, encoding, simplify: true })
}

fn figures(timed: &[Timed], samples: &[Vec<Sample>], index: usize) -> Figures {
    let Timed { rings, spelling, rustc, .. } = timed[index];
    let find = |rings: Rings, spelling: Spelling| {
        let other = timed.iter().position(|other| other.rings == rings && other.spelling == spelling);
        other.filter(|other| *other != index)
    };
    let by_hand = spelling.by_hand().and_then(|spelling| find(rings, spelling));
    // With as many steps walked through, or all of them as here.
    let all = rings.walked == rings.length();
    let base = Rings::of(BASE, rings.tokens).and_then(|base| if all { Some(base) } else { base.walked(rings.walked) });
    let base = base.and_then(|base| find(base, spelling));
    let sfc = find(rings, Spelling::Sfc);
    let own = &samples[index];
    let figure = |of: fn(&Sample) -> f64| Figure {
        nanoseconds: turns::figure(own, of),
        by_hand: by_hand.map(|other| turns::ratio(own, &samples[other], of)),
        growth: base.map(|other| turns::ratio(own, &samples[other], of)),
        sfc: sfc.map(|other| turns::ratio(&samples[other], own, of)),
    };
    Figures {
        idle: figure(|sample| sample.idle),
        clearing: figure(|sample| sample.clearing),
        bytes: own.first().map_or(0, |sample| sample.bytes),
        rustc,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::share::is_thorough;

    const CALL: Call = Call { limit: Duration::from_secs(300), more_stack: false };

    /// The programs themselves compare the outputs of both machines with what they must be, some hundred scans long.
    #[test]
    fn generated_and_by_hand_go_around_the_rings() {
        let Some(tools) = Tools::find_or_skip() else { return };
        let folder = tempfile::tempdir().expect("a folder");
        let rings = [5, 3].map(|walked| Rings { steps: 10, tokens: 2, walked });
        let rings = if is_thorough() { rings.to_vec() } else { vec![rings[0]] };
        let count = rings.len();
        let job = Job {
            rings,
            encodings: vec![Encoding::Switch, Encoding::Sequent],
            evolutions: vec![Evolution::Stable, Evolution::Scan],
            repetitions: 1,
            limit: Duration::from_secs(300),
        };
        let c = c::Tools::find_or_skip();
        let others = Others { c: c.as_ref(), matiec: None };
        let rows = measure(&tools, others, folder.path(), &job, &|_| {}).expect("all are built and run");
        assert_eq!(rows.len(), count * 2 * (1 + 2) * if c.is_some() { 2 } else { 1 });
        for row in &rows {
            let figures = row.figures.as_ref().expect("rustc takes ten steps");
            let is_by_hand = row.spelling.contains(" by hand");
            assert_eq!(figures.idle.by_hand.is_none(), is_by_hand, "{}", row.spelling);
            assert!(figures.bytes > 10 && figures.bytes < 110, "ten outputs and a little more: {}", figures.bytes);
            assert_eq!(figures.rustc.is_some_and(|seconds| seconds > 0.0), !row.spelling.contains(" in C"));
        }
    }

    #[test]
    fn a_spelling_that_stays_behind_is_refused() {
        let Some(tools) = Tools::find_or_skip() else { return };
        let folder = tempfile::tempdir().expect("a folder");
        let rings = Rings::one(4);
        let text = by_hand::write(rings, Evolution::Scan).replace("if inputs.x_2 {", "if inputs.x_2 && inputs.x_0 {");
        let built = tools::build(&tools, folder.path(), &text, &driver::write(rings), CALL);
        let Ok(Built::Program(program, _)) = built else { panic!("it is built") };
        let said = turns::take(&[program], 1).expect_err("it does not go around the ring");
        assert!(said.contains("tokens at 3: output 2"), "{said}");
    }

    #[test]
    fn rustc_is_stopped_at_the_limit() {
        let Some(tools) = Tools::find_or_skip() else { return };
        let folder = tempfile::tempdir().expect("a folder");
        let rings = Rings::one(10);
        let text = by_hand::write(rings, Evolution::Scan);
        let call = Call { limit: Duration::ZERO, ..CALL };
        let built = tools::build(&tools, folder.path(), &text, &driver::write(rings), call);
        let Ok(Built::Without(why)) = built else { panic!("rustc takes some time") };
        assert_eq!(why, "rustc was stopped after 0 s");
        assert!(!folder.path().join("main").exists());
    }
}
