//! Claims, and the answers to them: what engines find, in real times, shown by the reference simulator.

use crate::beyond::Beyond;
use crate::claim::{Claim, When, always_asked, written};
use crate::cone::cone;
use crate::explicit::{Explicit, Size};
use crate::goal::{Engine, Finding, Goal, Reason, Searched, Way};
use crate::inputs::{agreeing, computed, inputs};
use crate::limit::Limit;
use crate::machine::{End, Machine};
use crate::replay::replays;
use crate::sat::Sat;
use crate::symbolic::Symbolic;
use crate::timed::{self, Wanted};
use crate::times::walk;
use crate::trace::{Row, Trace};
use grafc_formula::Value;
use grafc_logic::scan::{ClaimKind, Program, Role};
use grafc_model::chart::Chart;
use grafc_model::reaction::Profile;

/// A chart, and what was made of it.
#[derive(Clone, Copy)]
pub struct Subject<'s> {
    /// The chart.
    pub chart: &'s Chart,
    /// Its program, of which transitions are shown.
    pub program: &'s Program,
    /// How it evolves.
    pub profile: Profile,
}

/// Which engines look.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Method {
    /// One state after the other, and where there are too many, all at once and by clauses.
    #[default]
    Auto,
    /// One state after the other.
    Explicit,
    /// All at once, as decision diagrams.
    Symbolic,
    /// By a solver of clauses: a walk that it leads, induction, bounded search.
    Sat,
}

/// The answer to a claim.
#[derive(Clone, PartialEq, Debug)]
pub enum Answer {
    /// It is proved.
    Holds,
    /// It does not hold: this shows it, unless what is shown is that something never happens.
    Fails(Option<Trace>),
    /// It is not decided.
    Open(Reason),
}

/// A claim with its answer.
#[derive(Clone, PartialEq, Debug)]
pub struct Verdict {
    /// The claim.
    pub claim: Claim,
    /// The answer.
    pub answer: Answer,
}

/// What was found of a chart.
#[derive(Clone, PartialEq, Debug)]
pub struct Verified {
    /// The claims, in order of their kinds, then of the text.
    pub verdicts: Vec<Verdict>,
    /// How much was looked at.
    pub searched: Searched,
    /// Whether a reaction may not end, so that nothing is said of what comes after it.
    pub stops_at_livelock: bool,
    /// The assumptions allow no inputs after this, or at all if it has no rows: then everything would hold.
    pub barred: Option<Trace>,
}

/// How far a search has come.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Progress {
    /// States that are known.
    pub known: usize,
    /// How many of them were looked at.
    pub looked_at: usize,
}

/// So much is looked at one by one before all is looked at at once: states, and paths, the fewer the more a path evaluates.
fn few(program: &Program) -> Size {
    // One number has more paths than anybody walks.
    let paths = if computed(program).is_empty() { 3_000_000 } else { 100_000 };
    Size { states: 20_000, paths: (paths / program.pool.len().max(1)).clamp(200, 100_000) }
}

/// So much is looked at one by one where that is all that can be done.
const MANY: Size = Size { states: 2_000_000, paths: usize::MAX };

/// So much is looked at with real times.
const TIMED: Size = Size { states: 200_000, paths: usize::MAX };

/// Answers all claims; `stop` is asked now and then whether to end with what is known.
pub fn verify(subject: Subject, method: Method, stop: &mut dyn FnMut(Progress) -> Option<Limit>) -> Verified {
    let program = &cone(subject.program);
    let subject = Subject { program, ..subject };
    let claims = [always_asked(subject.program), written(subject.program)].concat();
    let mut goals: Vec<Goal> = claims.iter().map(|claim| claim.when.goal()).collect();
    goals.sort_unstable();
    goals.dedup();
    let mut go_on = |known, looked_at| stop(Progress { known, looked_at });
    let found = answers(subject, method, &goals, &mut go_on);
    let Answers { found: findings, searched, barred } = found.unwrap_or_else(|beyond| Answers {
        found: goals.iter().map(|_| Found::Open(Reason::Beyond(beyond.clone()))).collect(),
        searched: Searched { states: 0.0, limit: None },
        barred: None,
    });
    let of = |goal: Goal| goals.binary_search(&goal).ok().map(|place| &findings[place]);
    let stops_at_livelock = !matches!(of(Goal::Fact(crate::facts::Fact::Livelock)), Some(Found::Never));
    let verdict = |claim: Claim| {
        let answer = match (claim.when, of(claim.when.goal())) {
            (When::Never(_), Some(Found::Never)) | (When::Sometime(_), Some(Found::Met(_) | Found::Happens)) => {
                Answer::Holds
            }
            (When::Never(_), Some(Found::Met(trace))) => Answer::Fails(Some(trace.clone())),
            (When::Sometime(_), Some(Found::Never)) => Answer::Fails(None),
            (_, Some(Found::Open(reason))) => Answer::Open(reason.clone()),
            // What is never to happen is shown by a trace, or not said.
            (When::Never(_), Some(Found::Happens)) | (_, None) => Answer::Open(Reason::NotReplayed),
        };
        Verdict { claim, answer }
    };
    Verified { verdicts: claims.into_iter().map(verdict).collect(), searched, stops_at_livelock, barred }
}

/// What is known of a goal in the end.
enum Found {
    Never,
    Met(Trace),
    /// It was proved that something does, without a trace.
    Happens,
    Open(Reason),
}

/// How much may still be done.
type Stop<'s> = &'s mut dyn FnMut(usize, usize) -> Option<Limit>;

/// What the engines find.
struct Findings {
    of: Vec<Finding>,
    searched: Searched,
    barred: Option<Way>,
}

/// What becomes of that.
struct Answers {
    found: Vec<Found>,
    searched: Searched,
    barred: Option<Trace>,
}

fn by(engine: &mut dyn Engine, goals: &[Goal], stop: Stop) -> Result<Findings, Beyond> {
    let of = engine.find(goals, stop)?;
    Ok(Findings { of, searched: engine.searched(), barred: engine.barred().cloned() })
}

/// First one state after the other; where there are too many, all at once, and by clauses; and where that is too much, many.
fn findings<'s>(
    subject: Subject<'s>,
    one_by_one: &mut Explicit<'s>,
    goals: &[Goal],
    stop: Stop,
) -> Result<Findings, Beyond> {
    let mut few = by(one_by_one, goals, stop)?;
    if !matches!(few.searched.limit, Some(Limit::States | Limit::Paths)) {
        return Ok(few);
    }
    // What is decided is not looked for again.
    let open = |few: &Findings| -> Vec<usize> {
        (0..goals.len()).filter(|place| matches!(few.of[*place], Finding::Open(_))).collect()
    };
    let sought = |places: &[usize]| -> Vec<Goal> { places.iter().map(|place| goals[*place]).collect() };
    // Most of what is easy is known soon by clauses; a way that is found at once is shorter. There are other ways than those
    // that no times allow.
    let mut longer: Vec<(usize, Finding)> = Vec::new();
    let mut places = open(&few);
    places.extend(untimed(subject.program, goals, &few.of)?);
    places.sort_unstable();
    let mut in_short = Sat::in_short(subject.program);
    if let Ok(soon) = by(&mut in_short, &sought(&places), stop) {
        for (place, finding) in places.into_iter().zip(soon.of) {
            match finding {
                Finding::Never | Finding::Happens => few.of[place] = finding,
                Finding::Met(_) if matches!(few.of[place], Finding::Met(_)) => few.of[place] = finding,
                Finding::Met(_) => longer.push((place, finding)),
                Finding::Open(_) => {}
            }
        }
    }
    let places = open(&few);
    let is_assumed = subject.program.claims.iter().any(|claim| claim.kind == ClaimKind::Assume);
    if places.is_empty() && (in_short.allows_inputs || !is_assumed) {
        few.searched.limit = Some(Limit::Enough);
        return Ok(few);
    }
    let mut by_clauses = Sat::new(subject.program);
    let mut at_once = Symbolic::aided(subject.program, &mut by_clauses);
    // What it cannot follow, the other engines may.
    let is_enough = match by(&mut at_once, &sought(&places), stop) {
        Ok(all) => {
            let is_enough = !matches!(all.searched.limit, Some(Limit::Nodes | Limit::Paths));
            places.into_iter().zip(all.of).for_each(|(place, finding)| few.of[place] = finding);
            if is_enough {
                (few.searched, few.barred) = (all.searched, all.barred.or(few.barred));
            }
            is_enough
        }
        Err(_) => false,
    };
    let places = open(&few);
    if !is_enough
        && !by_clauses.was_asked
        && let Ok(more) = by(&mut by_clauses, &sought(&places), stop)
    {
        places.into_iter().zip(more.of).for_each(|(place, finding)| few.of[place] = finding);
    }
    for (place, finding) in longer {
        if matches!(few.of[place], Finding::Open(_)) {
            few.of[place] = finding;
        }
    }
    if !is_enough && open(&few).is_empty() {
        few.searched.limit = Some(Limit::Enough);
    } else if !is_enough {
        *one_by_one = Explicit::new(subject.program, MANY)?;
        let many = by(one_by_one, goals, stop)?;
        for (finding, other) in few.of.iter_mut().zip(many.of) {
            if matches!(finding, Finding::Open(_)) {
                *finding = other;
            }
        }
        (few.searched, few.barred) = (many.searched, many.barred);
    }
    Ok(few)
}

/// The facts that were met along ways which no times allow.
fn untimed(program: &Program, goals: &[Goal], found: &[Finding]) -> Result<Vec<usize>, Beyond> {
    let mut machine = Machine::by_bits(program)?;
    let mut places = Vec::new();
    for (place, finding) in found.iter().enumerate() {
        if let (Finding::Met(way), Goal::Fact(_)) = (finding, goals[place])
            && !program.timers.is_empty()
            && walk(&mut machine, way)?.times.is_none()
        {
            places.push(place);
        }
    }
    Ok(places)
}

fn answers(subject: Subject, method: Method, goals: &[Goal], stop: Stop) -> Result<Answers, Beyond> {
    let size = if method == Method::Auto { few(subject.program) } else { MANY };
    let mut engine = Explicit::new(subject.program, size)?;
    let Findings { of, searched, barred } = match method {
        Method::Auto => findings(subject, &mut engine, goals, stop)?,
        Method::Explicit => by(&mut engine, goals, stop)?,
        Method::Symbolic => by(&mut Symbolic::new(subject.program), goals, stop)?,
        Method::Sat => by(&mut Sat::new(subject.program), goals, stop)?,
    };
    let mut shown = Shown { subject, machine: Machine::by_bits(subject.program)? };
    let mut found = Vec::with_capacity(goals.len());
    // What is met only if delays end in an order that they may not have.
    let mut untimed: Vec<usize> = Vec::new();
    for (place, (goal, finding)) in goals.iter().zip(of).enumerate() {
        found.push(match finding {
            Finding::Never => Found::Never,
            Finding::Happens => Found::Happens,
            Finding::Open(reason) => Found::Open(reason),
            Finding::Met(way) => match shown.trace(*goal, &way)? {
                Found::Open(Reason::Delays) => {
                    untimed.push(place);
                    Found::Open(Reason::Delays)
                }
                found => found,
            },
        });
    }
    let mut is_shown = by_walks(subject.program, goals, &untimed, stop);
    for (place, finding) in untimed.iter().zip(&is_shown) {
        found[*place] = match finding {
            Finding::Happens => Found::Happens,
            Finding::Met(way) => shown.trace(goals[*place], way)?,
            Finding::Never | Finding::Open(_) => continue,
        };
    }
    let mut is_left = is_shown.drain(..).map(|finding| matches!(finding, Finding::Never | Finding::Open(_)));
    untimed.retain(|_| is_left.next().unwrap_or(true));
    if !untimed.is_empty() {
        let wanted = |place: &usize| Wanted { goal: goals[*place], states: engine.states_that_meet(goals[*place]) };
        let wanted: Vec<Wanted> = untimed.iter().map(wanted).collect();
        let timed = timed::search(subject.program, &wanted, TIMED, stop)?;
        for (place, finding) in untimed.into_iter().zip(timed) {
            found[place] = match finding {
                // Of states, only those were looked for that meet it whatever delays do.
                Finding::Never if matches!(goals[place], Goal::Fact(_)) => Found::Never,
                Finding::Never | Finding::Happens | Finding::Open(_) => Found::Open(Reason::Delays),
                Finding::Met(way) => shown.trace(goals[place], &way)?,
            };
        }
    }
    let barred =
        barred.map(|way| if way.is_empty() { Ok(Trace::default()) } else { shown.barred(&way) }).transpose()?;
    Ok(Answers { found, searched, barred })
}

/// What walks in real times show of goals; nothing, if they cannot be walked.
fn by_walks(program: &Program, goals: &[Goal], places: &[usize], stop: Stop) -> Vec<Finding> {
    let sought: Vec<Goal> = places.iter().map(|place| goals[*place]).collect();
    let nothing = || sought.iter().map(|_| Finding::Open(Reason::Delays)).collect();
    if !sought.iter().any(|goal| matches!(goal, Goal::Fact(_))) {
        return nothing();
    }
    Sat::that_walks(program).find(&sought, stop).unwrap_or_else(|_| nothing())
}

/// Makes traces of ways.
struct Shown<'s> {
    subject: Subject<'s>,
    machine: Machine<'s>,
}

impl Shown<'_> {
    /// The way to where no inputs are allowed; without real times, if there are none.
    fn barred(&mut self, way: &Way) -> Result<Trace, Beyond> {
        Ok(match self.trace(Goal::Stuck, way)? {
            Found::Met(trace) => trace,
            Found::Never | Found::Happens | Found::Open(_) => Trace::default(),
        })
    }

    /// The trace, if times are found for it, and it replays.
    fn trace(&mut self, goal: Goal, way: &Way) -> Result<Found, Beyond> {
        let Subject { chart, program, profile } = self.subject;
        let walked = walk(&mut self.machine, way)?;
        let Some(times) = walked.times else { return Ok(Found::Open(Reason::Delays)) };
        let mut rows = Vec::with_capacity(way.len());
        let mut before: Vec<Value> = inputs(program).map(|(_, variable)| variable.initial()).collect();
        for (answers, t_ms) in way.iter().zip(times) {
            let Some(values) = agreeing(program, answers, &before) else { return Ok(Found::Open(Reason::NotReplayed)) };
            before.clone_from(&values);
            rows.push((t_ms, values));
        }
        if !replays(chart, profile, program, &rows, &walked.ends, goal) {
            return Ok(Found::Open(Reason::NotReplayed));
        }
        let label = |s: &usize| program.steps.raw[*s].label.to_string();
        let steps = |end: &End| match end {
            End::Rest(_, situation) => Some(situation.iter().map(label).collect()),
            End::Livelock(_) | End::Barred => None,
        };
        let rows = rows.into_iter().zip(&walked.ends);
        let rows = rows.map(|((t_ms, inputs), end)| Row { t_ms, inputs, steps: steps(end) });
        let names = program.variables.iter().filter(|variable| variable.role == Role::Input);
        Ok(Found::Met(Trace { inputs: names.map(|v| v.name.to_string()).collect(), rows: rows.collect() }))
    }
}
