//! What targets make of a document.

use super::Document;
use grafc_backends::{Output, Source, Target};
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::Program;
use grafc_logic::sequence::Sequence;

impl Document {
    /// What a target makes of the chart under the options.
    ///
    /// # Errors
    /// All messages of a text with errors; or what a later stage or the target itself cannot do.
    pub fn emit(&self, target: &Target) -> Result<Output, Diagnostics> {
        target.emit(&mut Stages(self))
    }
}

/// The stages as a target asks for them.
struct Stages<'d>(&'d Document);

impl Source for Stages<'_> {
    fn program(&mut self) -> Result<&Program, Diagnostics> {
        let Stages(document) = self;
        match document.lowered() {
            Some((program, said)) if !said.has_errors() => Ok(program),
            Some((_, said)) => Err(said.clone()),
            None => Err(document.diagnostics().clone()),
        }
    }

    fn sequence(&mut self) -> Result<&Sequence, Diagnostics> {
        let Stages(document) = self;
        match document.drawn() {
            Some(Ok(sequence)) => Ok(sequence),
            Some(Err(said)) => Err(said.clone()),
            None => Err(document.diagnostics().clone()),
        }
    }
}
