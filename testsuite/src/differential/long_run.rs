//! The long run: random charts through many executors, on all processors.
//!
//! Charts are taken in blocks of consecutive seeds, which threads share among themselves. What comes out does not
//! depend on who took which block, except the times.

use super::coverage::Coverage;
use crate::executors::{Executor, Outcome, Simulator, Task};
use crate::random::profile;
use crate::random::{ChartKind, Draw, Drawn, checked_draw, trace};
use grafc_model::reaction::{Profile, Response, Stimulus};
use std::collections::BTreeMap;
use std::num::NonZero;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc;
use std::time::{Duration, Instant};

/// Charts in a block: what tools from outside compile at once.
const BLOCK: u64 = 40;

/// What is to be run.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// So many charts,
    pub charts: u64,
    /// from this seed on,
    pub seed: u64,
    /// of this size,
    pub size: usize,
    /// all of a kind, if one is given,
    pub kind: Option<ChartKind>,
    /// and so many calls of each.
    pub scans: usize,
    /// Threads; as many as there are processors if not given.
    pub threads: Option<NonZero<usize>>,
}

/// A chart as it is drawn for the run.
pub struct Draft {
    /// The seed in the run; that of what was drawn may be another.
    pub seed: u64,
    /// The chart.
    pub drawn: Drawn,
    /// How it evolves.
    pub profile: Profile,
    /// What is done to it.
    pub stimuli: Vec<Stimulus>,
    /// Its place in the run.
    pub turn: usize,
}

impl Draft {
    /// The chart of a seed. Most are hierarchical, because nothing is missing in these.
    pub fn of(seed: u64, plan: &Plan) -> Self {
        let kind = plan.kind.unwrap_or(match seed % 8 {
            0 => ChartKind::Plain,
            1..4 => ChartKind::Flat,
            _ => ChartKind::Hierarchical,
        });
        let drawn = checked_draw(seed, Draw { kind, size: plan.size });
        let stimuli = trace(seed, &drawn.chart, plan.scans);
        Draft { seed, profile: profile(seed), stimuli, turn: (seed / 8) as usize, drawn }
    }

    /// It as a task.
    pub fn task(&self) -> Task<'_> {
        Task { chart: &self.drawn.chart, profile: self.profile, stimuli: &self.stimuli, turn: self.turn }
    }
}

/// What an executor did.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Charts that it ran.
    pub charts: u64,
    /// Calls.
    pub scans: u64,
    /// Charts that were not for it, by the reason.
    pub passed_over: BTreeMap<&'static str, u64>,
    /// Seeds of charts on which it was wrong.
    pub mismatches: Vec<u64>,
    /// How long it took; the times of threads add up.
    pub time: Duration,
}

impl Tally {
    fn add(&mut self, other: Tally) {
        self.charts += other.charts;
        self.scans += other.scans;
        for (reason, count) in other.passed_over {
            *self.passed_over.entry(reason).or_default() += count;
        }
        self.mismatches.extend(other.mismatches);
        self.time += other.time;
    }
}

/// What a run came to.
#[derive(Default)]
pub struct Summary {
    /// What the charts held and did.
    pub coverage: Coverage,
    /// Texts that had errors and were drawn again.
    pub rejected: u64,
    /// The simulator, then each executor.
    pub tallies: Vec<Tally>,
    /// How long all took.
    pub time: Duration,
}

impl Summary {
    /// All mismatches.
    pub fn mismatches(&self) -> usize {
        self.tallies.iter().map(|tally| tally.mismatches.len()).sum()
    }

    fn add(&mut self, block: Summary) {
        self.coverage.add(&block.coverage);
        self.rejected += block.rejected;
        self.tallies.resize_with(self.tallies.len().max(block.tallies.len()), Tally::default);
        for (mine, theirs) in self.tallies.iter_mut().zip(block.tallies) {
            mine.add(theirs);
        }
    }
}

/// Runs it; `progress` hears of the charts done so far and the mismatches among them.
pub fn run(plan: &Plan, executors: &[Box<dyn Executor>], mut progress: impl FnMut(u64, usize)) -> Summary {
    let began = Instant::now();
    let threads = plan.threads.or(std::thread::available_parallelism().ok()).map_or(1, NonZero::get);
    let next = AtomicU64::new(0);
    let mut summary = Summary::default();
    std::thread::scope(|scope| {
        let (sender, receiver) = mpsc::channel();
        for _ in 0..threads {
            let (sender, next) = (sender.clone(), &next);
            scope.spawn(move || {
                loop {
                    let first = next.fetch_add(BLOCK, Ordering::Relaxed);
                    if first >= plan.charts {
                        break;
                    }
                    let seeds = plan.seed + first..plan.seed + (first + BLOCK).min(plan.charts);
                    if sender.send(block(seeds, plan, executors)).is_err() {
                        break;
                    }
                }
            });
        }
        drop(sender);
        for block in receiver {
            summary.add(block);
            progress(summary.coverage.charts, summary.mismatches());
        }
    });
    summary.tallies.iter_mut().for_each(|tally| tally.mismatches.sort_unstable());
    summary.time = began.elapsed();
    summary
}

fn block(seeds: std::ops::Range<u64>, plan: &Plan, executors: &[Box<dyn Executor>]) -> Summary {
    let drafts: Vec<Draft> = seeds.map(|seed| Draft::of(seed, plan)).collect();
    let tasks: Vec<Task> = drafts.iter().map(Draft::task).collect();
    let mut summary =
        Summary { rejected: drafts.iter().map(|d| u64::from(d.drawn.rejected)).sum(), ..Summary::default() };
    let (reference, expected) = play(&Simulator, &drafts, &tasks, |_, outcome| matches!(outcome, Outcome::Failed(_)));
    summary.tallies.push(reference);
    let runs: Vec<&[Response]> = expected
        .iter()
        .map(|outcome| match outcome {
            Outcome::Ran(responses) => &responses[..],
            Outcome::PassedOver(_) | Outcome::Failed(_) => &[],
        })
        .collect();
    for (draft, run) in drafts.iter().zip(&runs) {
        summary.coverage.count(&draft.drawn.chart, draft.profile, run);
        summary.coverage.count_closely(&draft.drawn.text, &draft.drawn.chart, draft.profile, &draft.stimuli);
    }
    for executor in executors {
        let executor = executor.as_ref();
        let (tally, _) = play(executor, &drafts, &tasks, |index, outcome| is_wrong(executor, runs[index], outcome));
        summary.tallies.push(tally);
    }
    summary
}

fn play(
    executor: &dyn Executor,
    drafts: &[Draft],
    tasks: &[Task],
    is_wrong: impl Fn(usize, &Outcome) -> bool,
) -> (Tally, Vec<Outcome>) {
    let began = Instant::now();
    let outcomes = executor.run(tasks);
    let mut tally = Tally { time: began.elapsed(), ..Tally::default() };
    for (index, (outcome, draft)) in outcomes.iter().zip(drafts).enumerate() {
        match outcome {
            Outcome::PassedOver(reason) => *tally.passed_over.entry(reason).or_default() += 1,
            Outcome::Ran(responses) => {
                tally.charts += 1;
                tally.scans += responses.len() as u64;
            }
            Outcome::Failed(_) => tally.charts += 1,
        }
        if is_wrong(index, outcome) {
            tally.mismatches.push(draft.seed);
        }
    }
    (tally, outcomes)
}

/// Whether an outcome is not what the simulator says it must be.
pub fn is_wrong(executor: &dyn Executor, expected: &[Response], outcome: &Outcome) -> bool {
    match outcome {
        Outcome::Ran(actual) => executor.difference(expected, actual).is_some(),
        Outcome::PassedOver(_) => false,
        Outcome::Failed(_) => true,
    }
}
