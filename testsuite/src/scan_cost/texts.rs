//! The ring in all spellings: by hand, by grafc, and as MATIEC's own SFC.

use crate::charts;
use crate::rings::Rings;
use crate::runs::compile;
use grafc_backends::st;
use grafc_logic::{Encoding, Options};
use grafc_model::reaction::{Evolution, Profile};
use std::fmt::Write as _;

/// The name of the CASE by hand.
pub(super) const CASE: &str = "CASE by hand";

/// The name of the equations by hand.
pub(super) const EQUATIONS: &str = "equations by hand";

/// MATIEC takes minutes for a text of more bits than this, and `gcc` for what comes out of it.
pub(crate) const MANY_BITS: usize = 1_000;

/// One way to spell the ring.
pub(super) struct Spelling {
    pub(super) name: String,
    /// The name of the spelling by hand to compare it with.
    pub(super) against: Option<&'static str>,
    pub(super) is_sfc: bool,
    /// The longest ring that the tools take in reasonable time.
    pub(super) most_steps: usize,
    pub(super) text: String,
}

impl Spelling {
    /// A text from elsewhere.
    pub(super) fn other(name: &str, text: &str) -> Spelling {
        Spelling {
            name: name.to_owned(),
            against: Some(CASE),
            is_sfc: false,
            most_steps: usize::MAX,
            text: text.to_owned(),
        }
    }
}

/// All spellings, each by hand before those that are compared with it.
pub(super) fn all(steps: usize) -> Result<Vec<Spelling>, String> {
    let by_hand = |name: &str, most_steps: usize, text: String| Spelling {
        name: name.to_owned(),
        against: None,
        is_sfc: false,
        most_steps,
        text,
    };
    let mut all = vec![by_hand(CASE, usize::MAX, case_by_hand(steps))];
    all.extend(by_grafc(steps, Encoding::Switch, CASE, usize::MAX)?);
    all.push(by_hand(EQUATIONS, MANY_BITS, equations_by_hand(steps)));
    all.extend(by_grafc(steps, Encoding::SinglePhase, EQUATIONS, MANY_BITS)?);
    all.extend(by_grafc(steps, Encoding::Sequent, EQUATIONS, MANY_BITS)?);
    all.push(Spelling {
        name: "SFC of MATIEC".to_owned(),
        against: Some(EQUATIONS),
        is_sfc: true,
        most_steps: MANY_BITS,
        text: sfc(Rings::one(steps)),
    });
    Ok(all)
}

/// Both evolutions of an encoding.
fn by_grafc(
    steps: usize,
    encoding: Encoding,
    against: &'static str,
    most_steps: usize,
) -> Result<Vec<Spelling>, String> {
    let chart = charts::check("ring", &Rings::one(steps).chart())?;
    let mut spellings = Vec::new();
    for (evolution, remark) in [(Evolution::Stable, ""), (Evolution::Scan, ", scan")] {
        let profile = Profile { evolution, ..Profile::default() };
        let program = compile(&chart, &Options { profile, encoding, simplify: true })?;
        let text = st::emit(&program, &st::Options::default()).map_err(|diagnostics| format!("{diagnostics:#?}"))?;
        let name = format!("{}{remark}", encoding.name());
        spellings.push(Spelling { name, against: Some(against), is_sfc: false, most_steps, text });
    }
    Ok(spellings)
}

/// A number says which step is active, and a transition moves it and the outputs.
pub(super) fn case_by_hand(steps: usize) -> String {
    let mut out = interface(steps, " := TRUE");
    out.push_str("VAR\n    active : INT;\nEND_VAR\n\nCASE active OF\n");
    for i in 0..steps {
        let next = (i + 1) % steps;
        let _ = writeln!(out, "    {i}:\n        IF x_{i} THEN\n            w_{i} := FALSE;");
        let _ = writeln!(out, "            w_{next} := TRUE;\n            active := {next};\n        END_IF;");
    }
    out.push_str("END_CASE;\n\nEND_FUNCTION_BLOCK\n");
    out
}

/// A bit says whether a step is active: the equations of the textbook, one evolution a scan.
///
/// The first step is set in the first scan. With an initial value instead, `gcc` lays out the same equations such that
/// they take up to 1.8 times as long; and equations on a copy of the steps, without bits for the transitions, as long.
fn equations_by_hand(steps: usize) -> String {
    let mut out = interface(steps, "");
    out.push_str("VAR\n    started : BOOL;\n");
    for i in 0..steps {
        let _ = writeln!(out, "    s_{i} : BOOL;");
    }
    for i in 0..steps {
        let _ = writeln!(out, "    t_{i} : BOOL;");
    }
    out.push_str("END_VAR\n\nIF NOT started THEN\n    started := TRUE;\n    s_0 := TRUE;\nEND_IF;\n");
    for i in 0..steps {
        let _ = writeln!(out, "t_{i} := s_{i} AND x_{i};");
    }
    for i in 0..steps {
        let _ = writeln!(out, "s_{i} := t_{} OR (s_{i} AND NOT t_{i});", (i + steps - 1) % steps);
    }
    for i in 0..steps {
        let _ = writeln!(out, "w_{i} := s_{i};");
    }
    out.push_str("\nEND_FUNCTION_BLOCK\n");
    out
}

/// An SFC, or several side by side in one function block.
pub(crate) fn sfc(rings: Rings) -> String {
    let mut out = interface(rings.steps, "");
    for i in 0..rings.steps {
        let kind = if rings.is_initial(i) { "INITIAL_STEP" } else { "STEP" };
        let _ = writeln!(out, "{kind} s_{i}:\n    w_{i}(N);\nEND_STEP");
    }
    for i in 0..rings.steps {
        let _ = writeln!(out, "TRANSITION FROM s_{i} TO s_{} := x_{i};\nEND_TRANSITION", rings.next(i));
    }
    out.push_str("\nEND_FUNCTION_BLOCK\n");
    out
}

/// The head of a function block by hand; `first` follows the type of the initial step's output.
fn interface(steps: usize, first: &str) -> String {
    let mut out = String::from("FUNCTION_BLOCK Ring\n\nVAR_INPUT\n");
    for i in 0..steps {
        let _ = writeln!(out, "    x_{i} : BOOL;");
    }
    out.push_str("END_VAR\n\nVAR_OUTPUT\n");
    for i in 0..steps {
        let _ = writeln!(out, "    w_{i} : BOOL{};", if i == 0 { first } else { "" });
    }
    out.push_str("END_VAR\n\n");
    out
}
