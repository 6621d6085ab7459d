//! The first lines of generated code: which chart, which version and which options made it.
//!
//! No directories and no dates: equal charts give equal code wherever and whenever they are compiled.

use crate::files::Place;
use grafc_backends::{awl, il, plcopen, rust, st};
use grafc_model::reaction::{Evolution, Profile};

/// The head of Structured Text.
pub fn of_st(chart: &Place, lowering: &grafc_logic::Options, pou: st::Pou, interval_ms: u32) -> Vec<String> {
    header(chart, "st", lowering, &around(pou, interval_ms))
}

/// The head of an instruction list.
pub fn of_il(chart: &Place, lowering: &grafc_logic::Options, pou: il::Pou, interval_ms: u32) -> Vec<String> {
    header(chart, "il", lowering, &around(pou, interval_ms))
}

/// The head of a source file in STL.
pub fn of_awl(chart: &Place, lowering: &grafc_logic::Options, options: &awl::Options) -> Vec<String> {
    let pou = if options.organization_block { "program" } else { "function-block" };
    let mnemonics = match options.mnemonics {
        awl::Mnemonics::English => "english",
        awl::Mnemonics::German => "german",
    };
    let own = format!("--pou {pou} --block-number {} --mnemonics {mnemonics}", options.number);
    header(chart, "awl", lowering, &own)
}

/// What stands around a function block.
fn around(pou: st::Pou, interval_ms: u32) -> String {
    match pou {
        st::Pou::FunctionBlock => "--pou function-block".to_string(),
        st::Pou::Program => "--pou program".to_string(),
        st::Pou::Configuration => format!("--pou configuration --task-interval {interval_ms}ms"),
    }
}

/// The head of a PLCopen XML project.
pub fn of_plcopen(chart: &Place, lowering: &grafc_logic::Options, options: &plcopen::Options) -> Vec<String> {
    let dialect = match options.dialect {
        plcopen::Dialect::Neutral => "neutral",
        plcopen::Dialect::Codesys => "codesys",
    };
    let body = match options.body {
        plcopen::Body::St => "st",
        plcopen::Body::Il => "il",
        plcopen::Body::Ld => "ld",
        plcopen::Body::Sfc => "sfc",
    };
    let interval = options.interval_ms.map_or(String::new(), |ms| format!(" --task-interval {ms}ms"));
    header(chart, "plcopen", lowering, &format!("--dialect {dialect} --body {body}{interval}"))
}

/// The head of a form that leaves no choice.
pub fn of_vendor(chart: &Place, target: &str, lowering: &grafc_logic::Options) -> Vec<String> {
    header(chart, target, lowering, "")
}

/// The head of Rust.
pub fn of_rust(chart: &Place, lowering: &grafc_logic::Options, runtime: rust::Runtime) -> Vec<String> {
    let own = match runtime {
        rust::Runtime::Inline => "--runtime inline",
        rust::Runtime::Crate => "--runtime crate",
    };
    header(chart, "rust", lowering, own)
}

fn header(chart: &Place, target: &str, lowering: &grafc_logic::Options, own: &str) -> Vec<String> {
    let source = match chart {
        Place::File(path) => path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned(),
        Place::Standard => "standard input".to_string(),
    };
    let encoding = lowering.encoding.name();
    let optimize = if lowering.simplify { "" } else { "--optimize 0 " };
    let profile = profile(lowering.profile);
    vec![
        format!("Made by grafc {} from {source}", env!("CARGO_PKG_VERSION")),
        format!("--target {target} --encoding {encoding} {optimize}{profile} {own}").trim_end().to_string(),
    ]
}

fn profile(profile: Profile) -> String {
    let evolution = match profile.evolution {
        Evolution::Stable => "stable",
        Evolution::Scan => "scan",
    };
    let initial_actions = if profile.initial_actions { "on" } else { "off" };
    let bound = profile.bound.map_or(String::new(), |bound| format!(" --bound {bound}"));
    format!("--evolution {evolution} --initial-actions {initial_actions}{bound}")
}
