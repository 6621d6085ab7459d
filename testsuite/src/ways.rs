//! The ways in which a chart can be lowered: encodings, with and without shorter formulas.

use grafc_logic::{Encoding, Options};
use grafc_model::reaction::Profile;

/// All ways to lower a chart that must do exactly what the simulator does, with a name each.
pub fn exact(profile: Profile) -> Vec<(String, Options)> {
    ways(profile, Encoding::ALL.into_iter().filter(|encoding| !encoding.overlaps()))
}

/// All ways to lower a chart to some encodings, with a name each.
pub fn ways(profile: Profile, encodings: impl Iterator<Item = Encoding>) -> Vec<(String, Options)> {
    let mut ways = Vec::new();
    for encoding in encodings {
        for simplify in [true, false] {
            let name = format!("{}{}", encoding.name(), if simplify { "" } else { " -O0" });
            ways.push((name, Options { profile, encoding, simplify }));
        }
    }
    ways
}
