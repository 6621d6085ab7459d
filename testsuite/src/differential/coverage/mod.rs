//! What the charts of a long run held and did: a run in which nothing happens proves nothing.

mod productions;
mod pulses;
mod rules;

use grafc_diagnostics::FileId;
use grafc_model::chart::{Arithmetic, Chart, Event, ExprKind, Mode, Node, Situation, VariableKind};
use grafc_model::reaction::{Evolution, Profile, Response, Stimulus};
use std::collections::BTreeMap;
use std::fmt;

/// What names stand for, and what is raised: neither a production nor a rule, and not to be missed either.
const NEEDED: [&str; 10] = [
    "activity of a step",
    "activity of a macro-step",
    "activity of a grafcet",
    "duration of a step",
    "continuous variable read",
    "conversion",
    "LIVELOCK",
    "ALLOC_CONFLICT",
    "FORCE_CONFLICT",
    "DIV0",
];

/// Counts of charts, by what they have or did.
#[derive(Clone, Debug, Default)]
pub struct Coverage {
    counts: BTreeMap<&'static str, u64>,
    productions: BTreeMap<&'static str, u64>,
    rules: BTreeMap<&'static str, u64>,
    /// Charts that were counted.
    pub charts: u64,
    /// Calls.
    pub reactions: u64,
}

impl Coverage {
    /// Counts one chart and its run.
    pub fn count(&mut self, chart: &Chart, profile: Profile, run: &[Response]) {
        self.charts += 1;
        self.reactions += run.len() as u64;
        let mut seen: Vec<&'static str> = Vec::new();
        for expr in &chart.exprs {
            seen.push(match &expr.kind {
                ExprKind::Rise(e) | ExprKind::Fall(e) => match &chart.exprs[*e].kind {
                    ExprKind::Variable(v) if chart.variables[*v].kind == VariableKind::Input => "edge of an input",
                    ExprKind::Variable(_) => "edge of an internal variable or output",
                    ExprKind::StepActive(_)
                    | ExprKind::MacroActive(_)
                    | ExprKind::GrafcetActive(_)
                    | ExprKind::GrafcetFrozen(_) => "edge of an activity",
                    _ => "edge of an expression",
                },
                ExprKind::Delay { on, off, .. } => match (on.ms > 0, off.ms > 0) {
                    (true, true) => "on-delay with off-delay",
                    (true, false) => "on-delay",
                    (false, true) => "off-delay",
                    (false, false) => "delay of nothing",
                },
                ExprKind::StepTime(_) => "duration of a step",
                ExprKind::Compare(..) => "comparison",
                ExprKind::Arithmetic(Arithmetic::Divide | Arithmetic::Modulo, ..) => "division",
                ExprKind::Arithmetic(..) | ExprKind::Negate(_) => "arithmetic",
                ExprKind::Widen(_) => "conversion",
                ExprKind::StepActive(_) => "activity of a step",
                ExprKind::MacroActive(_) => "activity of a macro-step",
                ExprKind::GrafcetActive(_) | ExprKind::GrafcetFrozen(_) => "activity of a grafcet",
                ExprKind::Variable(v) if chart.variables[*v].mode == Mode::Wire => "continuous variable read",
                ExprKind::Literal(_)
                | ExprKind::Variable(_)
                | ExprKind::Not(_)
                | ExprKind::And(..)
                | ExprKind::Or(..)
                | ExprKind::Xor(..) => continue,
            });
        }
        for transition in &chart.transitions {
            let (pre, post) = (&transition.pre, &transition.post);
            seen.extend(
                [
                    (pre.is_empty(), "source transition"),
                    (post.is_empty(), "sink transition"),
                    (pre.len() > 1, "synchronisation"),
                    (post.len() > 1, "parallel branches"),
                    (pre.iter().any(|n| post.contains(n)), "self-loop"),
                    (pre.iter().chain(post).any(|n| matches!(n, Node::Macro(_))), "macro-step"),
                ]
                .into_iter()
                .filter_map(|(holds, what)| holds.then_some(what)),
            );
        }
        seen.extend(chart.stored.iter().map(|action| match action.event {
            Event::Event(..) => "action on event",
            Event::Deactivation(_) => "action on deactivation",
            Event::Clearing(_) => "action on clearing",
            Event::Activation(_) => "action on activation",
            Event::EachScan(..) => "action each scan",
        }));
        seen.extend(chart.orders.iter().map(|order| match order.situation {
            Situation::Steps(_) => "forcing of steps",
            Situation::Current => "freezing",
            Situation::Initial => "forcing to the initial situation",
        }));
        seen.extend(chart.grafcets.iter().filter(|grafcet| grafcet.child).map(|_| "child"));
        seen.extend(chart.pulses.iter().map(|_| "pulse order").chain(chart.runs.iter().map(|_| "run with a step")));
        if chart.grafcets.iter().any(|g| g.enclosing_step.is_some()) {
            seen.push("enclosure");
        }
        if chart.continuous.iter().any(|c| c.condition.is_some()) {
            seen.push("assignment condition");
        }
        if chart.steps.iter().filter(|s| s.initial).count() > 1 {
            seen.push("several initial steps");
        }
        if chart.options.over(profile).evolution == Evolution::Scan {
            seen.push("(evolution by scans)");
        }
        if let Some(last) = run.last() {
            seen.extend(last.flags.names());
        }
        let changes = run.windows(2).filter(|pair| pair[0].situation != pair[1].situation).count();
        seen.push(match changes {
            0 => "ran: situation never changed",
            1..5 => "ran: situation changed 1-4 times",
            _ => "ran: situation changed 5 times or more",
        });
        if run.windows(2).any(|pair| pair[0].outputs != pair[1].outputs) {
            seen.push("ran: outputs changed");
        }
        seen.sort_unstable();
        seen.dedup();
        for what in seen {
            *self.counts.entry(what).or_default() += 1;
        }
    }

    /// Counts the productions of the language in one chart's text, and the rules in its run.
    pub fn count_closely(&mut self, text: &str, chart: &Chart, profile: Profile, stimuli: &[Stimulus]) {
        let (tree, _) = grafc_syntax::parse(FileId::default(), text);
        for what in productions::of(text, &tree) {
            *self.productions.entry(what).or_default() += 1;
        }
        for what in rules::of(chart, profile, stimuli) {
            *self.rules.entry(what).or_default() += 1;
        }
    }

    /// Adds what another has counted.
    pub fn add(&mut self, other: &Coverage) {
        self.charts += other.charts;
        self.reactions += other.reactions;
        let pairs = [
            (&mut self.counts, &other.counts),
            (&mut self.productions, &other.productions),
            (&mut self.rules, &other.rules),
        ];
        for (mine, theirs) in pairs {
            for (what, count) in theirs {
                *mine.entry(what).or_default() += count;
            }
        }
    }

    /// Charts with each production of the language.
    pub fn productions(&self) -> impl Iterator<Item = (&'static str, u64)> {
        productions::ALL.iter().map(|what| (*what, self.productions.get(what).copied().unwrap_or_default()))
    }

    /// Charts whose run showed each rule.
    pub fn rules(&self) -> impl Iterator<Item = (&'static str, u64)> {
        rules::all().map(|what| (what, self.rules.get(what).copied().unwrap_or_default()))
    }

    /// Charts that had or did each of the other things.
    pub fn others(&self) -> impl Iterator<Item = (&'static str, u64)> {
        self.counts.iter().map(|(what, count)| (*what, *count))
    }

    /// Productions, rules and the like that no chart had.
    pub fn uncovered(&self) -> Vec<&'static str> {
        let needed = NEEDED.iter().map(|what| (*what, self.of(what)));
        let all = self.productions().chain(self.rules()).chain(needed);
        all.filter(|(_, count)| *count == 0).map(|(what, _)| what).collect()
    }

    /// How many charts had or did this.
    pub fn of(&self, what: &str) -> u64 {
        self.counts.get(what).copied().unwrap_or_default()
    }
}

impl fmt::Display for Coverage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (what, count) in &self.counts {
            writeln!(f, "{count:>8} {what}")?;
        }
        Ok(())
    }
}
