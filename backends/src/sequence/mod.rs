//! What the forms of sequential function charts share, drawn and in text: what stands in the boxes (`texts`), and the units
//! around the chart (`units`).
//!
//! What of a chart is one, `grafc_logic::sequence` has decided.

pub(crate) mod texts;
pub(crate) mod units;

use crate::iec::names::Names;
use crate::keywords::Family;
use ecow::EcoString;
use grafc_logic::sequence::Sequence;

/// The instance whose variables hold the situation, if something is found before or after the chart.
pub(crate) fn instance(sequence: &Sequence) -> Option<EcoString> {
    let mut names = Names::new(&sequence.program, Family::Iec);
    sequence.is_held().then(|| units::instance(&mut names))
}
