//! `grafc verify --emit`: the chart and its claims as a circuit, for engines of others.

use crate::report::Failure;
use clap::ValueEnum;
use grafc_logic::scan::Program;
use grafc_verify::circuit::{aiger, circuit, smv};

/// The language of a circuit.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(super) enum Language {
    /// AIGER 1.9, binary: abc, and the engines of the hardware model checking competition
    Aiger,
    /// SMV: NuSMV, nuXmv
    Smv,
}

/// The circuit of a program.
pub(super) fn text(program: &Program, language: Language) -> Result<Vec<u8>, Failure> {
    let circuit = circuit(program).map_err(|beyond| {
        let help = "compare numbers with constants in the plant, and give the chart what comes of it";
        Failure::Open(beyond.to_string(), help.to_string())
    })?;
    Ok(match language {
        Language::Aiger => aiger(&circuit),
        Language::Smv => smv(&circuit).into_bytes(),
    })
}
