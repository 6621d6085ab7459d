//! The first lines of generated code: which chart, which version and which options made it.
//!
//! No directories and no dates: equal charts give equal code wherever and whenever they are compiled.

use grafc_backends::Target;
use grafc_model::chart::ControlNames;
use grafc_model::reaction::{Evolution, LivelockOutputs, Profile};

/// The lines, for a chart from a source of this name.
pub fn header(
    source: &str,
    lowering: &grafc_logic::Options,
    bound_as_known: bool,
    controls: &ControlNames,
    target: &Target,
) -> Vec<String> {
    let (name, chosen) = target.spelled();
    let encoding = lowering.encoding.name();
    let optimize = if lowering.simplify { "" } else { "--optimize 0 " };
    let auto = if bound_as_known { " --bound auto" } else { "" };
    let profile = profile(lowering.profile) + auto + &spelled(controls);
    vec![
        format!("Made by grafc {} from {source}", env!("CARGO_PKG_VERSION")),
        format!("--target {name} --encoding {encoding} {optimize}{profile} {chosen}").trim_end().to_string(),
    ]
}

/// As a command line would say it.
fn spelled(controls: &ControlNames) -> String {
    let named = |option: &str, name: Option<&str>| name.map_or(String::new(), |name| format!(" {option} {name}"));
    let keeps = if controls.reset_keeps_retained { " --reset-keeps-retained" } else { "" };
    let clear_flags = named("--clear-flags-input", controls.clear_flags.as_deref());
    let checks = if controls.check_assertions { " --check-assertions" } else { "" };
    format!("{}{keeps}{clear_flags}{checks}", named("--reset-input", controls.reset.as_deref()))
}

fn profile(profile: Profile) -> String {
    let evolution = match profile.evolution {
        Evolution::Stable => "stable",
        Evolution::Scan => "scan",
    };
    let initial_actions = if profile.initial_actions { "on" } else { "off" };
    let bound = profile.bound.map_or(String::new(), |bound| format!(" --bound {bound}"));
    let livelock_outputs = match profile.livelock_outputs {
        LivelockOutputs::Computed => "",
        LivelockOutputs::Hold => " --livelock-outputs hold",
        LivelockOutputs::Off => " --livelock-outputs off",
    };
    format!("--evolution {evolution} --initial-actions {initial_actions}{bound}{livelock_outputs}")
}
