//! What targets make of a document.

use super::{Document, Form};
use grafc_backends::{Output, Source, Target};
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::{Observed, Program};
use grafc_logic::sequence::Sequence;

impl Document {
    /// What a target makes of the chart under the options.
    ///
    /// # Errors
    /// All messages of a text with errors; or what a later stage or the target itself cannot do.
    pub fn emit(&self, target: &Target) -> Result<Output, Diagnostics> {
        target.emit(&mut Stages { document: self, wants_map: false })
    }

    /// The same, and which lines of it come from which element of the chart, if the target knows.
    ///
    /// # Errors
    /// As above.
    pub fn emit_mapped(&self, target: &Target) -> Result<Output, Diagnostics> {
        target.emit(&mut Stages { document: self, wants_map: true })
    }
}

/// The stages as a target asks for them.
struct Stages<'d> {
    document: &'d Document,
    wants_map: bool,
}

impl<'d> Stages<'d> {
    fn lowered(&self, form: Form) -> Result<&'d Program, Diagnostics> {
        match self.document.lowered(form) {
            Some((program, diagnostics)) if !diagnostics.has_errors() => Ok(program),
            Some((_, diagnostics)) => Err(diagnostics.clone()),
            None => Err(self.document.diagnostics().clone()),
        }
    }
}

impl Source for Stages<'_> {
    fn program(&mut self) -> Result<&Program, Diagnostics> {
        self.lowered(Form::Plain)
    }

    fn saved_program(&mut self) -> Result<&Program, Diagnostics> {
        self.lowered(Form::Saved)
    }

    fn observed_program(&mut self, observed: Observed) -> Result<&Program, Diagnostics> {
        self.lowered(match observed {
            Observed::Nothing => Form::Saved,
            Observed::Transitions => Form::Seen,
            Observed::All => Form::SeenWhole,
        })
    }

    fn sequence(&mut self) -> Result<&Sequence, Diagnostics> {
        let document = self.document;
        match document.drawn() {
            Some(Ok(sequence)) => Ok(sequence),
            Some(Err(diagnostics)) => Err(diagnostics.clone()),
            None => Err(document.diagnostics().clone()),
        }
    }

    fn wants_map(&self) -> bool {
        self.wants_map
    }
}
