//! Random charts as `.gct` text, and random traces for them.
//!
//! A seed is a chart: the same seed gives the same text for as long as this module stays as it is, and a failure that
//! is worth keeping becomes a vector of its own. Charts are correct by construction, as far as the rules of the
//! language can be kept without a model of it; `checked` tries the next seed in the rare other case.
//!
//! Structure is drawn first (`structure`), with every label known; then declarations, conditions and actions are
//! written (`expression`), so that any condition may name any step. Weights lean towards charts in which things
//! happen: rings rather than dead ends, conditions of one or two inputs, delays that the traces meet to the millisecond.

mod boolean;
mod claims;
mod commands;
mod expression;
mod ink;
mod options;
mod ordered;
mod plain;
mod structure;
mod trace;
mod write;

pub use claims::with_claims;
use clap::ValueEnum;
use grafc_diagnostics::FileId;
use grafc_model::chart::Chart;
use grafc_model::reaction::{Evolution, LivelockOutputs, Profile};
pub use trace::trace;

/// Which part of the language a chart may use.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum ChartKind {
    /// Partial grafcets and macro-steps.
    Flat,
    /// Enclosures, activation links and forcing orders as well; of some, children and pulse orders, too.
    Hierarchical,
    /// The same, all with a child at least.
    Commanded,
    /// Nothing but steps and conditions of inputs, properly nested.
    Plain,
    /// The same in several grafcets, of which some are enclosed, run, started, kept and stopped, or forced.
    Ordered,
    /// Few steps and Boolean inputs, without delays: small enough to try everything.
    Boolean,
}

/// What is drawn of a seed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Draw {
    /// Which part of the language.
    pub kind: ChartKind,
    /// How large: 1 is a chart of up to five grafcets of up to eight steps, and it grows with this in both directions.
    pub size: usize,
}

/// What the seed of children and pulse orders differs by.
const COMMANDS: u64 = 0x7075_6c73;

/// What the seed of children that do nothing but run with steps differs by.
const ALONE: u64 = 0x616c_6f6e;

/// The text of the chart of a seed; nearly always free of errors.
fn text(seed: u64, draw: Draw) -> String {
    let mut rng = fastrand::Rng::with_seed(seed);
    let name = format!("Random_{seed}");
    match draw.kind {
        ChartKind::Boolean => {
            let [mut commands, mut alone] = [COMMANDS, ALONE].map(|apart| fastrand::Rng::with_seed(seed ^ apart));
            boolean::chart(&mut rng, &mut commands, &mut alone, &name)
        }
        ChartKind::Plain => plain::chart(&mut rng, &name),
        ChartKind::Ordered => ordered::chart(&mut rng, &name),
        ChartKind::Flat | ChartKind::Hierarchical | ChartKind::Commanded => {
            let mut frames = structure::draw(&mut rng, draw.kind, draw.size);
            let mut commands = fastrand::Rng::with_seed(seed ^ COMMANDS);
            match draw.kind {
                ChartKind::Hierarchical if !commands.bool() => commands::draw(&mut commands, &mut frames),
                ChartKind::Commanded => {
                    commands::draw(&mut commands, &mut frames);
                    while !frames.iter().any(|frame| frame.parent.is_some()) {
                        frames = structure::draw(&mut rng, draw.kind, draw.size);
                        commands::draw(&mut commands, &mut frames);
                    }
                }
                _ => {}
            }
            commands::leave_alone(&mut fastrand::Rng::with_seed(seed ^ ALONE), &mut frames);
            write::chart(&mut rng, &mut ink::Ink::new(seed), &name, &frames)
        }
    }
}

/// A chart that was drawn and checked.
pub struct Drawn {
    /// What gives it again.
    pub seed: u64,
    /// Its text.
    pub text: String,
    /// The chart.
    pub chart: Chart,
    /// How many texts before it had errors.
    pub rejected: u32,
}

/// The small chart of a seed, as [`checked_draw`] gives it.
///
/// # Panics
/// As that does.
pub fn checked(seed: u64, kind: ChartKind) -> Drawn {
    checked_draw(seed, Draw { kind, size: 1 })
}

/// The chart of a seed, or of the next derived seed whose text has no errors.
///
/// # Panics
/// If a hundred texts in a row have errors: then the generator is at fault, and the first message is shown.
pub fn checked_draw(seed: u64, draw: Draw) -> Drawn {
    let mut complaint = String::new();
    for rejected in 0..100 {
        let seed = if rejected == 0 { seed } else { seed.wrapping_mul(1_000_003).wrapping_add(u64::from(rejected)) };
        let text = text(seed, draw);
        let (ast, mut diagnostics) = grafc_syntax::parse(FileId::default(), &text);
        if !diagnostics.has_errors() {
            let (chart, more) = grafc_model::check(&ast, "random");
            diagnostics.append(more);
            if let Some(chart) = chart {
                return Drawn { seed, text, chart, rejected };
            }
        }
        if complaint.is_empty() {
            complaint = format!("{diagnostics:#?}\n{text}");
        }
    }
    panic!("the generator writes charts with errors: {complaint}");
}

/// The profile of a seed: mostly the standard's, at times another.
pub fn profile(seed: u64) -> Profile {
    let mut rng = fastrand::Rng::with_seed(seed ^ 0x7072_6f66);
    Profile {
        evolution: if rng.f32() < 0.25 { Evolution::Scan } else { Evolution::Stable },
        initial_actions: rng.f32() < 0.8,
        bound: if rng.f32() < 0.1 { Some(rng.u32(1..=6)) } else { None },
        livelock_outputs: match rng.u8(0..6) {
            0 => LivelockOutputs::Hold,
            1 => LivelockOutputs::Off,
            _ => LivelockOutputs::Computed,
        },
    }
}

/// The same with a low bound: hundreds of micro-steps of a livelock show nothing that a few do not.
pub fn low_bound(profile: Profile) -> Profile {
    Profile { bound: Some(profile.bound.unwrap_or(12)), ..profile }
}
