//! The tests of a chart, run one after the other.

use super::find::{Tested, called, shown, table_called};
use crate::report::{Failure, Report};
use crate::signals::Interrupt;
use grafc::files;
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_model::chart::{Chart, ControlNames, Scenario};
use grafc_model::reaction::{Asked, Profile};
use grafc_testing::coverage::Coverage;
use std::path::{Path, PathBuf};

/// A chart with its tests.
pub struct Loaded {
    /// Its text.
    pub file: FileId,
    /// What it is called in names of tests.
    pub name: String,
    /// Its name without folders.
    pub path: PathBuf,
    /// None if it has errors.
    pub chart: Option<Chart>,
    /// Its tests, by their names.
    pub tests: Vec<Test>,
    /// So many files of it have errors: itself, and its scenarios.
    pub faulty: usize,
}

/// A test.
pub struct Test {
    /// `chart::test`
    pub name: String,
    what: What,
}

enum What {
    /// A table, in this file.
    Table(PathBuf),
    /// A scenario.
    Scenario(Box<Scenario>),
}

/// How tests are run.
#[derive(Clone, Copy)]
pub struct How {
    /// How charts evolve.
    pub profile: Profile,
    /// Whether the bound on micro-steps is the one that is known to be enough.
    pub bound_as_known: bool,
    /// The period at which scenarios call the chart.
    pub scan: i64,
}

/// What came of a test.
pub struct Done {
    /// Its name.
    pub name: String,
    /// What is wrong, and what else is to be said.
    pub said: Diagnostics,
    /// How it ended.
    pub ending: Ending,
}

/// How a test ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ending {
    /// All is as the test says.
    Passed,
    /// Something is not.
    Failed,
    /// It has not begun, since somebody interrupted the tests.
    NotRun,
}

impl Loaded {
    /// Reads a chart, and finds its tests. What is wrong with the chart is reported.
    pub fn new(
        path: &Path,
        tested: &Tested,
        controls: &ControlNames,
        asked: &Asked,
        report: &mut Report,
    ) -> Result<Loaded, Failure> {
        let (name, shown) = (called(path), shown(path));
        let mut chart = None;
        let file = match grafc::add(&mut report.sources, shown, files::read(path)?) {
            Ok(file) => {
                let (checked, diagnostics) =
                    grafc::check(file, &report.sources.file(file).text, &grafc::chart_name(path));
                report.diagnostics.append(diagnostics);
                chart = checked;
                file
            }
            Err(diagnostic) => {
                let file = diagnostic.primary.span.file;
                report.diagnostics.push(diagnostic);
                file
            }
        };
        if let Some(Err(found)) = chart.as_mut().map(|chart| chart.control(controls)) {
            report.diagnostics.append(found);
            chart = None;
        }
        let against = chart.as_ref().map(|chart| chart.options.against(asked)).unwrap_or_default();
        if against.has_errors() {
            report.diagnostics.append(against);
            chart = None;
        }
        let tables = tested.tables.iter().map(|table| Test {
            name: format!("{name}::{}", table_called(path, table)),
            what: What::Table(table.clone()),
        });
        let mut tests: Vec<Test> = tables.collect();
        let mut faulty = usize::from(chart.is_none());
        if let Some(chart) = &chart {
            let own = if tested.with_own { chart.scenarios.clone() } else { Vec::new() };
            tests.extend(own.into_iter().map(|scenario| Test::of(&name, scenario)));
            if let Some(path) = &tested.scenarios {
                let beside = beside(path, file, report)?;
                faulty += usize::from(beside.is_none());
                tests.extend(beside.into_iter().flatten().map(|scenario| Test::of(&name, scenario)));
            }
        }
        Ok(Loaded { file, path: path.to_path_buf(), chart, tests, name, faulty })
    }
}

impl Test {
    fn of(chart: &str, scenario: Scenario) -> Test {
        Test { name: format!("{chart}::{}", scenario.name), what: What::Scenario(Box::new(scenario)) }
    }
}

/// The scenarios in a file beside a chart, which has no errors; none if the file has some, which are reported.
fn beside(path: &Path, chart: FileId, report: &mut Report) -> Result<Option<Vec<Scenario>>, Failure> {
    let file = match grafc::add(&mut report.sources, shown(path), files::read(path)?) {
        Ok(file) => file,
        Err(diagnostic) => {
            report.diagnostics.push(diagnostic);
            return Ok(None);
        }
    };
    let parse = |file| grafc::syntax::parse(file, &report.sources.file(file).text);
    let (beside, mut said) = parse(file);
    let (scenarios, more) = grafc_model::scenarios(&parse(chart).0, &beside);
    said.append(more);
    said.sort_by_place();
    let is_right = !said.has_errors();
    report.diagnostics.append(said);
    Ok(is_right.then_some(scenarios))
}

/// Runs some tests of a chart, and tells each as it ends; what they cover, if somebody measures that. When somebody
/// interrupts them, the one that runs goes on to its end, and no other begins.
pub fn run<'c>(
    loaded: &'c Loaded,
    tests: &[&Test],
    how: How,
    is_measured: bool,
    report: &mut Report,
    interrupt: &Interrupt,
    told: &mut dyn FnMut(&Done) -> Result<(), Failure>,
) -> Result<(Vec<Done>, Option<Coverage<'c>>), Failure> {
    let Some(chart) = &loaded.chart else { return Ok((Vec::new(), None)) };
    let mut profile = how.profile;
    if how.bound_as_known {
        profile = grafc::known_bound(chart, profile);
    }
    let mut coverage = is_measured.then(|| Coverage::new(chart));
    let mut all = Vec::new();
    for test in tests {
        if interrupt.has_come() {
            all.push(Done { name: test.name.clone(), said: Diagnostics::new(), ending: Ending::NotRun });
            continue;
        }
        let mut said = match &test.what {
            What::Scenario(scenario) => grafc_testing::scenario(chart, profile, scenario, how.scan, coverage.as_mut()),
            What::Table(path) => match grafc::add(&mut report.sources, shown(path), files::read(path)?) {
                Ok(file) => {
                    let text = &report.sources.file(file).text;
                    grafc_testing::table(chart, profile, (file, text), coverage.as_mut())
                }
                Err(diagnostic) => {
                    let mut said = Diagnostics::new();
                    said.push(diagnostic);
                    said
                }
            },
        };
        report.policy.apply(&mut said);
        let ending = if said.has_errors() { Ending::Failed } else { Ending::Passed };
        let done = Done { name: test.name.clone(), said, ending };
        told(&done)?;
        all.push(done);
    }
    Ok((all, coverage))
}
