//! Saving what a chart retains over a restart, and starting anew with it.
//!
//! These bytes are of a few variables by their names and types, so that they outlive a change of the chart elsewhere. All
//! memory, to go on where the chart stood, is another matter: `saved`.

use super::literals::type_name;
use super::names::RustNames;
use super::places::Places;
use super::record::{Piece, Record};
use crate::writer::Writer;
use grafc_logic::scan::{Fingerprint, Program};

/// Writes `save_retained` and `restarted`, in functions of at most about `longest` lines; nothing where nothing is retained.
pub(super) fn write(out: &mut Writer, program: &Program, names: &RustNames, places: &Places, longest: usize) {
    let retained = || program.variables.iter_enumerated().filter(|(_, variable)| variable.retain);
    if retained().next().is_none() {
        return;
    }
    let mut print = Fingerprint::default();
    print.text(&program.name);
    for (id, variable) in retained() {
        print.text(&names.variables[id]);
        print.text(type_name(variable.ty));
    }
    out.blank();
    Record {
        what: "the retained variables take",
        constants: ["RETAINED_LEN", "RETAINED"],
        fingerprint: ("Which retained variables saved bytes belong to.", print.value()),
        save: ("save_retained", &["The retained variables as bytes, to be kept where power does not matter."]),
        restore: (
            "restarted",
            &[
                "The chart before its first scan, with the retained variables as they were saved; none if these",
                "are not the bytes of its retained variables, or not all as they were saved.",
            ],
            "",
        ),
        pieces: retained().map(|(id, _)| Piece::Variable(id)).collect(),
        refused: Vec::new(),
        then: None,
    }
    .write(out, program, places, longest);
}
