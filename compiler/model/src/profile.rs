//! How a chart evolves, and who chooses that: its heading, and who runs it.

use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};

/// How a chart evolves when it is called.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Evolution {
    /// Micro-steps until the situation is stable (R9).
    #[default]
    Stable,
    /// Exactly one micro-step a call, as SFC does (R14).
    Scan,
}

impl Evolution {
    /// The word for it, in headings and on command lines.
    pub fn word(self) -> &'static str {
        match self {
            Evolution::Stable => "stable",
            Evolution::Scan => "scan",
        }
    }
}

/// What outputs of continuous actions do in a call that LIVELOCK ended; those of stored actions keep their values.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum LivelockOutputs {
    /// As the situation says that was reached (R11).
    #[default]
    Computed,
    /// As after the call before.
    Hold,
    /// False.
    Off,
}

/// Asked that change what a chart means.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Profile {
    /// How it evolves.
    pub evolution: Evolution,
    /// Whether initial steps do their actions on activation at the start (R10).
    pub initial_actions: bool,
    /// The bound K on micro-steps (R9); `None` is max(200, steps + transitions + 1).
    pub bound: Option<u32>,
    /// What outputs do where that is hit.
    pub livelock_outputs: LivelockOutputs,
}

impl Default for Profile {
    fn default() -> Self {
        Profile {
            evolution: Evolution::Stable,
            initial_actions: true,
            bound: None,
            livelock_outputs: LivelockOutputs::Computed,
        }
    }
}

impl Profile {
    /// The largest bound: what 31 bits hold.
    pub const LARGEST_BOUND: u32 = i32::MAX as u32;

    /// The bound K for a chart of this size; macro-steps do not count.
    pub fn bound_for(&self, steps: usize, transitions: usize) -> u32 {
        self.bound.unwrap_or((steps + transitions + 1).max(200) as u32)
    }
}

/// What somebody who runs a chart asks for; what is none is as the chart says.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Asked {
    /// How it evolves.
    pub evolution: Option<Evolution>,
    /// Whether initial steps do their actions on activation at the start.
    pub initial_actions: Option<bool>,
    /// The bound on micro-steps.
    pub bound: Option<u32>,
    /// Whether the bound is the one that is known to be enough.
    pub bound_as_known: bool,
    /// What outputs do where it is hit.
    pub livelock_outputs: Option<LivelockOutputs>,
}

impl Asked {
    /// What is asked for, and the rest as usual.
    pub fn profile(self) -> Profile {
        let usual = Profile::default();
        Profile {
            evolution: self.evolution.unwrap_or(usual.evolution),
            initial_actions: self.initial_actions.unwrap_or(usual.initial_actions),
            bound: self.bound.or(usual.bound),
            livelock_outputs: self.livelock_outputs.unwrap_or(usual.livelock_outputs),
        }
    }
}

/// What the heading of a chart chooses, each with its place.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ChartOptions {
    /// `evolution scan`
    pub evolution: Option<(Evolution, Span)>,
    /// `initial_actions off`
    pub initial_actions: Option<(bool, Span)>,
    /// `bound 400`
    pub bound: Option<(u32, Span)>,
}

impl ChartOptions {
    /// The profile with what the heading chooses: whoever runs a chart runs it so.
    pub fn over(&self, profile: Profile) -> Profile {
        Profile {
            evolution: self.evolution.map_or(profile.evolution, |(chosen, _)| chosen),
            initial_actions: self.initial_actions.map_or(profile.initial_actions, |(chosen, _)| chosen),
            bound: self.bound.map(|(chosen, _)| chosen).or(profile.bound),
            livelock_outputs: profile.livelock_outputs,
        }
    }

    /// Whether a call is one micro-step, as the heading has it.
    pub fn is_scan(&self) -> bool {
        self.evolution.is_some_and(|(evolution, _)| evolution == Evolution::Scan)
    }

    /// What is asked for otherwise than the heading says (E0217).
    pub fn against(&self, asked: &Asked) -> Diagnostics {
        let mut found = Diagnostics::new();
        let mut differ = |span: Span, says: String, asked: String| {
            let message = format!("the heading says `{says}`, and `{asked}` is asked for");
            let fault = Diagnostic::new(Code::E0217, span, message);
            found.push(fault.help("ask for nothing: the chart means what its heading says; or change the heading"));
        };
        if let (Some((says, span)), Some(asked)) = (self.evolution, asked.evolution)
            && says != asked
        {
            differ(span, format!("evolution {}", says.word()), format!("--evolution {}", asked.word()));
        }
        if let (Some((says, span)), Some(asked)) = (self.initial_actions, asked.initial_actions)
            && says != asked
        {
            let word = |on: bool| if on { "on" } else { "off" };
            differ(span, format!("initial_actions {}", word(says)), format!("--initial-actions {}", word(asked)));
        }
        if let Some((says, span)) = self.bound {
            let asked = asked.bound.map(|bound| bound.to_string()).or(asked.bound_as_known.then(|| "auto".to_owned()));
            if let Some(asked) = asked.filter(|asked| *asked != says.to_string()) {
                differ(span, format!("bound {says}"), format!("--bound {asked}"));
            }
        }
        let scans = self.is_scan();
        let given_up = asked.bound.map(|_| "bound").or(asked.livelock_outputs.map(|_| "livelock-outputs"));
        let given_up = given_up.or(asked.bound_as_known.then_some("bound"));
        if let (Some((_, span)), Some(option)) = (self.evolution.filter(|_| scans), given_up) {
            let message = format!("no call is given up under `evolution scan`, so `--{option}` would do nothing");
            found.push(Diagnostic::new(Code::E0217, span, message).help(format!("leave `--{option}` out")));
        }
        found
    }
}
